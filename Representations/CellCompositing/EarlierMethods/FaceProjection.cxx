// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FaceProjection.h"

#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace nephoscope
{

//------------------------------------------------------------------------------------------------
namespace
{
Vector4 Transformed(const std::array<double, 16>& m, const Vector3& p)
{
  Vector4 result;
  for (std::size_t r = 0; r < 4; ++r)
  {
    result[r] = m[4 * r] * p[0] + m[4 * r + 1] * p[1] + m[4 * r + 2] * p[2] + m[4 * r + 3];
  }
  return result;
}
}

FaceView::FaceView(vtkMatrix4x4* modelToView, vtkMatrix4x4* viewToDevice, const double eyeView[4],
  int width, int height)
  : Width(width)
  , Height(height)
  , Eye{ { eyeView[3] * eyeView[0], eyeView[3] * eyeView[1], eyeView[3] * eyeView[2] } }
  , EyeZ(Eye[2])
  , Perspective(eyeView[3] != 0)
  , Mirrored(modelToView->Determinant() < 0)
{
  vtkNew<vtkMatrix4x4> matrix;
  std::copy_n(modelToView->GetData(), 16, this->ModelToView.begin());
  vtkMatrix4x4::Multiply4x4(viewToDevice, modelToView, matrix);
  std::copy_n(matrix->GetData(), 16, this->ModelToDevice.begin());
  vtkMatrix4x4::Invert(viewToDevice, matrix);
  std::copy_n(matrix->GetData(), 16, this->DeviceToView.begin());
  this->Near = this->DepthOfBuffer(width / 2, height / 2, 0.0);
}

Vector3 FaceView::ViewPosition(const Vector3& p) const
{
  const Vector4 view = Transformed(this->ModelToView, p);
  return { { view[0], view[1], view[2] } };
}

double FaceView::Distance(const Vector3& p) const
{
  const Vector3 d = Difference(this->ViewPosition(p), this->Eye);
  return this->Perspective ? std::sqrt(Dot(d, d)) : -d[2];
}

FaceView::Place FaceView::Project(const Vector3& p) const
{
  const Vector4 clip = Transformed(this->ModelToDevice, p);
  return { 0.5 * (clip[0] / clip[3] + 1) * this->Width,
    0.5 * (clip[1] / clip[3] + 1) * this->Height, this->Depth(p) };
}

Vector3 FaceView::ViewPointOfPixel(int x, int y, double deviceZ) const
{
  const Vector4 view = Transformed(this->DeviceToView,
    { { 2 * (x + 0.5) / this->Width - 1, 2 * (y + 0.5) / this->Height - 1, deviceZ } });
  return { { view[0] / view[3], view[1] / view[3], view[2] / view[3] } };
}

double FaceView::DepthOfBuffer(int x, int y, double depth) const
{
  return this->EyeZ - this->ViewPointOfPixel(x, y, 2 * depth - 1)[2];
}

double FaceView::Stretch(int x, int y) const
{
  const Vector3 along =
    Difference(this->ViewPointOfPixel(x, y, 1), this->ViewPointOfPixel(x, y, -1));
  return std::sqrt(Dot(along, along)) / std::abs(along[2]);
}

//------------------------------------------------------------------------------------------------
std::array<std::int64_t, 2> SnappedPlace(const FaceView::Place& place)
{
  const double limit = 1 << 20; // pixels; the products of the coordinates then fit in 64 bits
  const auto snap = [limit](double x) {
    return static_cast<std::int64_t>(
      std::llround(stepsPerPixel * std::min(std::max(x, -limit), limit)));
  };
  return { { snap(place.X), snap(place.Y) } };
}

namespace
{
/** Twice the area on the screen, positive where the points go round counterclockwise. */
std::int64_t ScreenArea(
  const FaceView::Place& a, const FaceView::Place& b, const FaceView::Place& c)
{
  const auto p = SnappedPlace(a), q = SnappedPlace(b), r = SnappedPlace(c);
  return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
}
}

/** Fills a FaceProjection; sort keys are kept until the end. */
class FaceProjection::Builder
{
public:
  Builder(FaceProjection& self, const CellGeometry& geometry,
    const std::vector<std::uint8_t>& visible, const FaceView& view)
    : Self(self)
    , Geometry(geometry)
    , Visible(visible)
    , View(view)
  {
  }

  void ProjectPoints()
  {
    const std::size_t n = this->Geometry.Points.size();
    this->Self.Points.resize(n);
    const bool opacityOnPoints = this->Geometry.HasOpacityScalars && !this->Geometry.OpacityOnCells;
    vtkSMPTools::For(0, static_cast<vtkIdType>(n), [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const std::size_t k = static_cast<std::size_t>(i);
        this->Self.Points[k] = {
          this->View.Project(this->Geometry.Position(static_cast<std::int32_t>(i))),
          this->Geometry.Points[k].Scalar, opacityOnPoints ? this->Geometry.OpacityScalars[k] : 0.0f
        };
      }
    });
  }

  void AddFace(const MeshFace& face)
  {
    const std::int32_t first = this->IsVisible(face.First) ? face.First : -1;
    const std::int32_t second = this->IsVisible(face.Second) ? face.Second : -1;
    if (first < 0 && second < 0)
    {
      return;
    }
    std::array<std::int32_t, 4> polygon, other;
    const int corners = this->Clip(face, polygon, other);
    for (int k = 2; k < corners; ++k)
    {
      this->AddTriangle({ { polygon[0], polygon[k - 1], polygon[k] } },
        { { other[0], other[k - 1], other[k] } }, first, second, this->Distance(face.Points));
    }
  }

  /**
   * The cross-section of a tetrahedron with the near plane, which is where rays enter what is left
   * of it.
   */
  void AddCap(std::int32_t tetrahedron)
  {
    const Tetrahedron& t = this->Geometry.Tetrahedra[static_cast<std::size_t>(tetrahedron)];
    std::array<std::int32_t, 4> nearer, farther, polygon;
    int near = 0, far = 0, corners = 0;
    for (const std::int32_t point : t)
    {
      (this->IsNearer(point) ? nearer[near++] : farther[far++]) = point;
    }
    // Around the cross-section: the edges of one nearer point, then those of the other backwards.
    for (int i = 0; i < near; ++i)
    {
      for (int j = 0; j < far; ++j)
      {
        polygon[corners++] = this->Cut(nearer[i], farther[near == 2 && i == 1 ? far - 1 - j : j]);
      }
    }
    for (int k = 2; k < corners; ++k)
    {
      std::array<std::int32_t, 3> triangle = { { polygon[0], polygon[k - 1], polygon[k] } };
      if (this->Area(triangle) < 0)
      {
        std::swap(triangle[1], triangle[2]);
      }
      this->Append({ triangle, tetrahedron, -1, triangle, false },
        std::numeric_limits<float>::lowest()); // in front of everything
    }
  }

  bool ReachesThroughNearPlane(std::int32_t tetrahedron) const
  {
    const Tetrahedron& t = this->Geometry.Tetrahedra[static_cast<std::size_t>(tetrahedron)];
    const auto nearer =
      std::count_if(t.begin(), t.end(), [&](std::int32_t p) { return this->IsNearer(p); });
    return nearer > 0 && nearer < 4;
  }

  void Sort()
  {
    std::vector<std::int32_t> order(this->Distances.size());
    std::iota(order.begin(), order.end(), 0);
    vtkSMPTools::Sort(order.begin(), order.end(), [this](std::int32_t a, std::int32_t b) {
      const float da = this->Distances[static_cast<std::size_t>(a)];
      const float db = this->Distances[static_cast<std::size_t>(b)];
      return da > db || (da == db && a < b);
    });
    std::vector<ScreenFace> sorted;
    sorted.reserve(order.size());
    for (const std::int32_t i : order)
    {
      sorted.push_back(this->Self.Faces[static_cast<std::size_t>(i)]);
    }
    this->Self.Faces.swap(sorted);
  }

private:
  bool IsVisible(std::int32_t tetrahedron) const
  {
    return tetrahedron >= 0 && this->Visible[static_cast<std::size_t>(tetrahedron)];
  }
  const ScreenPoint& Point(std::int32_t i) const
  {
    return this->Self.Points[static_cast<std::size_t>(i)];
  }
  bool IsNearer(std::int32_t point) const
  {
    return this->Point(point).Place.Z < this->View.GetNear();
  }
  std::int64_t Area(const std::array<std::int32_t, 3>& p) const
  {
    return ScreenArea(this->Point(p[0]).Place, this->Point(p[1]).Place, this->Point(p[2]).Place);
  }

  /** The distance of the centroid, as the rule of the method has it. */
  float Distance(const std::array<std::int32_t, 3>& face) const
  {
    Vector3 sum = { { 0, 0, 0 } };
    for (const std::int32_t point : face)
    {
      const Vector3 p = this->Geometry.Position(point);
      sum = { { sum[0] + p[0], sum[1] + p[1], sum[2] + p[2] } };
    }
    const Vector3 centroid = { { sum[0] / 3, sum[1] / 3, sum[2] / 3 } };
    return static_cast<float>(this->View.Distance(centroid));
  }

  /** Where the edge crosses the near plane; from either face the same numbers. */
  std::int32_t Cut(std::int32_t a, std::int32_t b)
  {
    const std::int32_t low = std::min(a, b), high = std::max(a, b);
    const double z0 = this->Point(low).Place.Z, z1 = this->Point(high).Place.Z;
    const double t = (this->View.GetNear() - z0) / (z1 - z0);
    const Vector3 p = this->Geometry.Position(low),
                  d = Difference(this->Geometry.Position(high), p);
    ScreenPoint cut;
    cut.Place = this->View.Project({ { p[0] + t * d[0], p[1] + t * d[1], p[2] + t * d[2] } });
    cut.Place.Z = this->View.GetNear();
    const auto mix = [t](
                       float from, float to) { return static_cast<float>(from + t * (to - from)); };
    cut.Scalar = mix(this->Point(low).Scalar, this->Point(high).Scalar);
    cut.Opacity = mix(this->Point(low).Opacity, this->Point(high).Opacity);
    this->Self.Points.push_back(cut);
    return static_cast<std::int32_t>(this->Self.Points.size() - 1);
  }

  /**
   * The part of a face beyond the near plane: 0, 3 or 4 corners, with the points of its first and
   * of its second tetrahedron.
   */
  int Clip(
    const MeshFace& face, std::array<std::int32_t, 4>& polygon, std::array<std::int32_t, 4>& other)
  {
    const bool same = face.Points == face.SecondPoints;
    int corners = 0;
    for (int k = 0; k < 3; ++k)
    {
      const int l = (k + 1) % 3;
      const std::int32_t from = face.Points[k], to = face.Points[l];
      if (!this->IsNearer(from))
      {
        polygon[corners] = from;
        other[corners++] = face.SecondPoints[k];
      }
      if (this->IsNearer(from) != this->IsNearer(to))
      {
        polygon[corners] = this->Cut(from, to);
        other[corners] =
          same ? polygon[corners] : this->Cut(face.SecondPoints[k], face.SecondPoints[l]);
        ++corners;
      }
    }
    return corners;
  }

  // A face that turns its outside to the eye is a front face of its first tetrahedron. The sign
  // comes from the numbers that the pixels are found with, so that at each of them the marks of a
  // tetrahedron's faces cancel.
  void AddTriangle(std::array<std::int32_t, 3> points, std::array<std::int32_t, 3> ofSecond,
    std::int32_t first, std::int32_t second, float distance)
  {
    const std::int64_t area = this->View.IsMirrored() ? -this->Area(points) : this->Area(points);
    const bool frontFace = area > 0;
    if (area == 0)
    {
      return;
    }
    if (this->Area(points) < 0)
    {
      std::swap(points[1], points[2]);
      std::swap(ofSecond[1], ofSecond[2]);
    }
    this->Append(
      { points, frontFace ? first : second, frontFace ? second : first, ofSecond, frontFace },
      distance);
  }

  void Append(const ScreenFace& face, float distance)
  {
    this->Self.Faces.push_back(face);
    this->Distances.push_back(distance);
  }

  FaceProjection& Self;
  const CellGeometry& Geometry;
  const std::vector<std::uint8_t>& Visible;
  const FaceView& View;
  std::vector<float> Distances;
};

void FaceProjection::Build(const CellGeometry& geometry, const FaceMesh& mesh,
  const std::vector<std::uint8_t>& visible, const FaceView& view, bool sorted)
{
  this->Points.clear();
  this->Faces.clear();
  Builder builder(*this, geometry, visible, view);
  builder.ProjectPoints();
  for (const MeshFace& face : mesh.GetFaces())
  {
    builder.AddFace(face);
  }
  for (std::size_t i = 0; i < visible.size(); ++i)
  {
    if (visible[i] && builder.ReachesThroughNearPlane(static_cast<std::int32_t>(i)))
    {
      builder.AddCap(static_cast<std::int32_t>(i));
    }
  }
  if (sorted)
  {
    builder.Sort();
  }
}

} // namespace nephoscope
