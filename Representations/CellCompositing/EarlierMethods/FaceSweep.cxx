// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FaceSweep.h"

#include "FaceSegment.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace nephoscope
{
namespace
{
constexpr int tileSize = 32;

/**
 * Colour with a fourth channel of 1, whose composited value is alpha; and extinction per world
 * length.
 */
struct Medium
{
  std::array<double, 4> Color = { { 0, 0, 0, 1 } };
  double Extinction = 0;
};

Medium Mix(const Medium& a, const Medium& b, double t)
{
  Medium m;
  for (std::size_t c = 0; c < 4; ++c)
  {
    m.Color[c] = a.Color[c] + t * (b.Color[c] - a.Color[c]);
  }
  m.Extinction = a.Extinction + t * (b.Extinction - a.Extinction);
  return m;
}

/** The buffers of one pixel. */
struct Pixel
{
  double Z = 0; // of the face drawn last
  Medium Last;  // on its side towards the eye
  int Crossings =
    0; // 0: outside the volume, so that there is nothing between the last face and the next
  double Stretch = 1;
  double Opaque = std::numeric_limits<double>::infinity(); // z where the ray ends
  std::array<double, 4> Light = { { 0, 0, 0, 0 } };
};

/** What a face's points say at a pixel. */
struct Scalars
{
  float Color, Opacity;
};

/** A triangle set up for a walk over pixels. */
class Raster
{
public:
  Raster(const FaceProjection& projection, const ScreenFace& face, bool perspective)
    : Perspective(perspective)
    , Jumps(face.Points != face.OtherPoints)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      this->Corners[k] = &projection.GetPoints()[static_cast<std::size_t>(face.Points[k])];
      this->Others[k] = &projection.GetPoints()[static_cast<std::size_t>(face.OtherPoints[k])];
      this->Snapped[k] = SnappedPlace(this->Corners[k]->Place);
    }
    for (std::size_t k = 0; k < 3; ++k)
    {
      const auto &from = this->Snapped[(k + 1) % 3], &to = this->Snapped[(k + 2) % 3];
      this->Along[k] = { { to[0] - from[0], to[1] - from[1] } };
      // A pixel on an edge belongs to the triangle on one of its sides.
      const bool owned = this->Along[k][1] > 0 || (this->Along[k][1] == 0 && this->Along[k][0] > 0);
      this->Bias[k] = owned ? 0 : -1;
    }
  }

  /** First and last pixel, whose centre lies in the bounding box, along an axis; not clamped. */
  std::array<std::int64_t, 2> Range(std::size_t axis) const
  {
    const auto [low, high] =
      std::minmax({ this->Snapped[0][axis], this->Snapped[1][axis], this->Snapped[2][axis] });
    const auto pixel = [](std::int64_t s) {
      return static_cast<std::int64_t>(std::floor(double(s) / stepsPerPixel));
    };
    return { { pixel(low - stepsPerPixel / 2), pixel(high - stepsPerPixel / 2) + 1 } };
  }

  bool Covers(int x, int y) const
  {
    const std::int64_t px = std::int64_t(x) * stepsPerPixel + stepsPerPixel / 2;
    const std::int64_t py = std::int64_t(y) * stepsPerPixel + stepsPerPixel / 2;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const auto& from = this->Snapped[(k + 1) % 3];
      const std::int64_t side =
        this->Along[k][0] * (py - from[1]) - this->Along[k][1] * (px - from[0]);
      if (side + this->Bias[k] < 0)
      {
        return false;
      }
    }
    return true;
  }

  /**
   * Returns z, and sets the scalars of either side, where the ray through the pixel's centre meets
   * the face's plane, but never outside the face.
   */
  double Interpolate(int x, int y, Scalars& scalars, Scalars& ofOthers) const
  {
    std::array<double, 3> weights = this->Weights(x + 0.5, y + 0.5);
    double sumOfWeights = 0, depth = 0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      // 1 / z is linear on the screen, and so are attributes divided by z.
      weights[k] = this->Perspective ? weights[k] / this->Corners[k]->Place.Z : weights[k];
      sumOfWeights += weights[k];
      depth += weights[k] * this->Corners[k]->Place.Z;
    }
    scalars = mean(this->Corners, weights, sumOfWeights);
    ofOthers = this->Jumps ? mean(this->Others, weights, sumOfWeights) : scalars;
    return depth / sumOfWeights;
  }

private:
  using Points = std::array<const ScreenPoint*, 3>;

  static Scalars mean(
    const Points& points, const std::array<double, 3>& weights, double sumOfWeights)
  {
    double s = 0, o = 0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      s += weights[k] * points[k]->Scalar;
      o += weights[k] * points[k]->Opacity;
    }
    return { static_cast<float>(s / sumOfWeights), static_cast<float>(o / sumOfWeights) };
  }

  std::array<double, 3> Weights(double x, double y) const
  {
    std::array<double, 3> weights;
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const FaceView::Place &a = this->Corners[(k + 1) % 3]->Place,
                            &b = this->Corners[(k + 2) % 3]->Place;
      weights[k] = std::max(0.0, (b.X - a.X) * (y - a.Y) - (b.Y - a.Y) * (x - a.X));
      sum += weights[k];
    }
    for (double& w : weights)
    {
      w = sum > 0 ? w / sum : 1.0 / 3;
    }
    return weights;
  }

  bool Perspective, Jumps;
  Points Corners, Others;
  std::array<std::array<std::int64_t, 2>, 3> Snapped, Along;
  std::array<std::int64_t, 3> Bias;
};

/**
 * The faces that touch each tile, in the order of drawing: tile t has Faces[First[t]] to
 * Faces[First[t + 1] - 1].
 */
struct TileLists
{
  int Columns, Rows;
  std::vector<std::size_t> First;
  std::vector<std::int32_t> Faces;

  TileLists(const FaceProjection& projection, const FaceView& view)
    : Columns((view.Width + tileSize - 1) / tileSize)
    , Rows((view.Height + tileSize - 1) / tileSize)
    , First(static_cast<std::size_t>(Columns) * Rows + 1, 0)
  {
    this->ForEachTile(
      projection, view, [this](std::size_t tile, std::int32_t) { ++this->First[tile + 1]; });
    std::partial_sum(this->First.begin(), this->First.end(), this->First.begin());
    this->Faces.resize(this->First.back());
    std::vector<std::size_t> next(this->First.begin(), this->First.end() - 1);
    this->ForEachTile(projection, view,
      [&](std::size_t tile, std::int32_t face) { this->Faces[next[tile]++] = face; });
  }

private:
  template <typename Visit>
  void ForEachTile(const FaceProjection& projection, const FaceView& view, Visit visit) const
  {
    const auto tiles = [](std::array<std::int64_t, 2> range, int size) {
      const std::int64_t low = std::max<std::int64_t>(range[0], 0),
                         high = std::min<std::int64_t>(range[1], size - 1);
      return std::array<std::int64_t, 2>{ { low / tileSize, high < low ? -1 : high / tileSize } };
    };
    for (std::size_t i = 0; i < projection.GetFaces().size(); ++i)
    {
      const Raster raster(projection, projection.GetFaces()[i], view.IsPerspective());
      const auto columns = tiles(raster.Range(0), view.Width),
                 rows = tiles(raster.Range(1), view.Height);
      for (std::int64_t row = rows[0]; row <= rows[1]; ++row)
      {
        for (std::int64_t column = columns[0]; column <= columns[1]; ++column)
        {
          visit(
            static_cast<std::size_t>(row * this->Columns + column), static_cast<std::int32_t>(i));
        }
      }
    }
  }
};

/** Draws one tile. */
class Tile
{
public:
  Tile(const FaceSweep::Scene& scene, const FaceProjection& projection, const FaceView& view,
    int column, int row)
    : Scene(scene)
    , Projection(projection)
    , View(view)
    , Low{ { column * tileSize, row * tileSize } }
    , High{ { std::min((column + 1) * tileSize, view.Width),
        std::min((row + 1) * tileSize, view.Height) } }
  {
    this->ForEachPixel([this](int x, int y, Pixel& pixel) {
      pixel.Stretch = this->View.Stretch(x, y);
      if (this->Scene.OpaqueDepth)
      {
        pixel.Opaque = this->View.DepthOfBuffer(
          x, y, this->Scene.OpaqueDepth[static_cast<std::size_t>(y) * this->View.Width + x]);
      }
    });
  }

  void DrawFace(const ScreenFace& face)
  {
    const Raster raster(this->Projection, face, this->View.IsPerspective());
    const auto clamped = [&](std::size_t axis) {
      const auto range = raster.Range(axis);
      return std::array<int, 2>{ { static_cast<int>(
                                     std::max<std::int64_t>(range[0], this->Low[axis])),
        static_cast<int>(std::min<std::int64_t>(range[1], this->High[axis] - 1)) } };
    };
    const auto columns = clamped(0), rows = clamped(1);
    for (int y = rows[0]; y <= rows[1]; ++y)
    {
      for (int x = columns[0]; x <= columns[1]; ++x)
      {
        if (raster.Covers(x, y))
        {
          Scalars scalars, ofOthers;
          const double z = raster.Interpolate(x, y, scalars, ofOthers);
          const bool other = face.OtherIsInFront;
          this->Advance(
            this->At(x, y), face, z, other ? scalars : ofOthers, other ? ofOthers : scalars);
        }
      }
    }
  }

  void CopyTo(std::vector<float>& rgba)
  {
    this->ForEachPixel([&](int x, int y, const Pixel& pixel) {
      float* out = rgba.data() + 4 * (static_cast<std::size_t>(y) * this->View.Width + x);
      // Nothing is cut off on the way, but taking back what was not there may leave less than
      // nothing.
      for (std::size_t c = 0; c < 4; ++c)
      {
        out[c] = static_cast<float>(std::max(pixel.Light[c], 0.0));
      }
      out[3] = std::min(out[3], 1.0f);
    });
  }

private:
  Pixel& At(int x, int y)
  {
    return this->Pixels[static_cast<std::size_t>((y - this->Low[1]) * tileSize + x - this->Low[0])];
  }
  template <typename Visit>
  void ForEachPixel(Visit visit)
  {
    for (int y = this->Low[1]; y < this->High[1]; ++y)
    {
      for (int x = this->Low[0]; x < this->High[0]; ++x)
      {
        visit(x, y, this->At(x, y));
      }
    }
  }

  /** Colour and extinction on the side of a face where this tetrahedron lies. */
  Medium Classify(std::int32_t tetrahedron, const Scalars& scalars) const
  {
    const CellGeometry& geometry = *this->Scene.Geometry;
    const std::size_t cell = static_cast<std::size_t>(tetrahedron);
    const float s = geometry.CellScalars.empty() ? scalars.Color : geometry.CellScalars[cell];
    const std::vector<std::int32_t>* tables = this->Scene.TablesOfTetrahedra;
    const std::size_t table =
      tables && !tables->empty() ? static_cast<std::size_t>((*tables)[cell]) : 0;
    const TransferFunctionTable::Value value = this->Scene.Color[table].Evaluate(s);
    Medium medium;
    std::copy_n(value.begin(), 3, medium.Color.begin());
    double opacity = value[3];
    if (geometry.HasOpacityScalars)
    {
      opacity = this->Scene.Opacity[table].Evaluate(
        geometry.OpacityOnCells ? geometry.OpacityScalars[cell] : scalars.Opacity)[3];
    }
    medium.Extinction = opacity * this->Scene.ExtinctionScale;
    return medium;
  }

  // The heart of the method. Where the medium jumps at a face, the segment behind ends with the one
  // value and the next begins with the other.
  void Advance(Pixel& pixel, const ScreenFace& face, double z, const Scalars& behind,
    const Scalars& inFront) const
  {
    if (pixel.Crossings != 0)
    {
      this->Composite(pixel, z,
        face.Behind >= 0 ? this->Classify(face.Behind, behind)
                         : this->Classify(face.InFront, inFront));
    }
    pixel.Z = z;
    pixel.Last = face.InFront >= 0 ? this->Classify(face.InFront, inFront)
                                   : this->Classify(face.Behind, behind);
    pixel.Crossings += face.Mark();
  }

  void Composite(Pixel& pixel, double z, const Medium& now) const
  {
    // Only what lies in front of the opaque geometry; where a segment is cut, its end there is
    // interpolated.
    const double zNow = std::min(z, pixel.Opaque), zLast = std::min(pixel.Z, pixel.Opaque);
    if (zNow == zLast)
    {
      return;
    }
    const auto at = [&](double place) {
      return place == z    ? now
        : place == pixel.Z ? pixel.Last
                           : Mix(now, pixel.Last, (place - z) / (pixel.Z - z));
    };
    const Medium near = at(std::min(zNow, zLast)), far = at(std::max(zNow, zLast));
    const double length = pixel.Crossings * (zLast - zNow) * pixel.Stretch; // signed
    const auto step = FaceSegmentStep(std::abs(length) * near.Extinction,
      std::abs(length) * far.Extinction, length < 0, this->Scene.AverageIntegration);
    for (std::size_t c = 0; c < 4; ++c)
    {
      pixel.Light[c] =
        step.Transparency * pixel.Light[c] + step.Near * near.Color[c] + step.Far * far.Color[c];
      if (!std::isfinite(pixel.Light[c]))
      {
        pixel.Light[c] = near.Color[c]; // so thick a medium hides what is behind in either order
      }
    }
  }

  const FaceSweep::Scene& Scene;
  const FaceProjection& Projection;
  const FaceView& View;
  std::array<int, 2> Low, High;
  std::array<Pixel, static_cast<std::size_t>(tileSize) * tileSize> Pixels;
};
}

std::vector<float> FaceSweep::Draw(
  const Scene& scene, const FaceProjection& projection, const FaceView& view)
{
  std::vector<float> rgba(4 * static_cast<std::size_t>(view.Width) * view.Height, 0.0f);
  const TileLists lists(projection, view);
  vtkSMPTools::For(0, lists.Columns * lists.Rows, 1, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType t = begin; t < end; ++t)
    {
      const std::size_t first = lists.First[static_cast<std::size_t>(t)];
      const std::size_t last = lists.First[static_cast<std::size_t>(t) + 1];
      if (first == last)
      {
        continue;
      }
      Tile tile(scene, projection, view, static_cast<int>(t % lists.Columns),
        static_cast<int>(t / lists.Columns));
      for (std::size_t i = first; i < last; ++i)
      {
        tile.DrawFace(projection.GetFaces()[static_cast<std::size_t>(lists.Faces[i])]);
      }
      tile.CopyTo(rgba);
    }
  });
  return rgba;
}

} // namespace nephoscope
