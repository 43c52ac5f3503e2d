// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SplatMeasures.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"

#include <algorithm>
#include <cmath>

namespace nephoscope
{
namespace
{
constexpr double readableLayers = 7.0;     // of streaks of the greatest speed, one behind the other
constexpr double readableStreaks = 6000.0; // of a sheet: 8 pixels apart where they fill 600 by 600
constexpr double samplesOfSheet = 4.0;     // that a ray meets in a flat sheet, at most
constexpr double readableOpacity = 0.6;    // of streaks of the mean speed
constexpr double leastOpacity = 0.8, greatestOpacity = 2.0;

bool IsPlace(const Vector3& place)
{
  return std::isfinite(place[0] + place[1] + place[2]);
}

// Half of the sample's cell along each axis.
Vector3 HalfExtent(const SplatMatrix& jacobian)
{
  Vector3 half{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    half[axis] = 0.5 *
      (std::abs(jacobian[0][axis]) + std::abs(jacobian[1][axis]) + std::abs(jacobian[2][axis]));
  }
  return half;
}

double WeightOf(const SplatMatrix& jacobian)
{
  return WeightOfCell(std::abs(Determinant(jacobian)),
    std::max({ Norm(jacobian[0]), Norm(jacobian[1]), Norm(jacobian[2]) }));
}

// A point on the boundary of a mesh has no cell beyond it. The splat of a whole cell may be wider
// than the cell.
Vector3 HalfWithin(const SplatMatrix& jacobian, double share, bool wholeCells)
{
  constexpr double inside = 0.99;
  const double part = share > inside ? 1.0 : wholeCells ? std::cbrt(share) : 0.0;
  return part * HalfExtent(jacobian);
}

struct SampleBox
{
  double Low[3], High[3];

  SampleBox(const Vector3& place, const Vector3& half)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      this->Low[axis] = place[axis] - half[axis];
      this->High[axis] = place[axis] + half[axis];
    }
  }
  bool LiesIn(const MediumBounds& bounds) const
  {
    return HoldsPlace(bounds, this->Low) && HoldsPlace(bounds, this->High);
  }
  MediumBounds GetBounds() const
  {
    return { { this->Low[0], this->High[0], this->Low[1], this->High[1], this->Low[2],
      this->High[2] } };
  }
};

// The cell of a sample that is more than twice as long as the medium: it reaches to a stray point.
bool ReachesOut(const Vector3& half, const MediumBounds& bounds)
{
  bool out = false;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    out = out || half[axis] > bounds[2 * axis + 1] - bounds[2 * axis];
  }
  return out;
}

// Calls visit(id, place, jacobian, share) for all visible samples.
template <typename Visit>
void ForEachSample(const SplatShapes& shapes, const Visit& visit)
{
  SplatMatrix jacobian{};
  bool found = false;
  for (vtkIdType id = 0; id < shapes.GetNumberOfIds(); ++id)
  {
    const Vector3 place = shapes.Place(id);
    if (shapes.IsVisible(id) && IsPlace(place))
    {
      jacobian = found && shapes.HaveOneShape() ? jacobian : shapes.Jacobian(id);
      found = true;
      visit(id, place, jacobian, shapes.Share(id));
    }
  }
}

// Bounds of the samples' cells that lie in a box. All points of a flat mesh may be on its boundary:
// across it their cells count.
MediumBounds BoundsWithin(const SplatShapes& shapes, const MediumBounds& box, bool wholeCells)
{
  MediumBounds bounds = NoMediumBounds, whole = NoMediumBounds;
  const auto add = [&](MediumBounds& to, const SampleBox& cell) {
    ExtendBounds(to, cell.Low);
    ExtendBounds(to, cell.High);
  };
  ForEachSample(
    shapes, [&](vtkIdType, const Vector3& place, const SplatMatrix& jacobian, double share) {
      const SampleBox cell(place, HalfWithin(jacobian, share, wholeCells));
      if (cell.LiesIn(box))
      {
        add(bounds, cell);
        add(whole, SampleBox(place, HalfExtent(jacobian)));
      }
    });
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if (bounds[2 * axis] == bounds[2 * axis + 1])
    {
      std::copy_n(&whole[2 * axis], 2, &bounds[2 * axis]);
    }
  }
  return bounds;
}

std::vector<WeightedPlace> WeightedPlaces(const SplatShapes& shapes)
{
  std::vector<WeightedPlace> places;
  const SampleChoice choice(shapes.GetNumberOfIds(), enoughPlaces);
  vtkIdType shown = 0;
  ForEachSample(shapes, [&](vtkIdType, const Vector3& place, const SplatMatrix& jacobian, double) {
    if (choice.Takes(shown++))
    {
      const auto standing =
        static_cast<double>(choice.Standing()); // processes choose from different numbers
      places.push_back(
        { { place[0], place[1], place[2] }, standing * WeightOf(jacobian), standing });
    }
  });
  return places;
}
} // namespace

MediumBounds BoundsOfSamples(
  vtkDataSet* data, const SplatSampling& sampling, const MediumReduction& over)
{
  if (!data || data->GetNumberOfPoints() == 0)
  {
    return RobustBounds(
      {}, [](const MediumBounds&) { return NoMediumBounds; }, over);
  }
  const SplatShapes shapes(data, sampling);
  return RobustBounds(
    WeightedPlaces(shapes),
    [&](const MediumBounds& box) { return BoundsWithin(shapes, box, sampling.WholeCells); }, over);
}

MediumMeasures MeasureSplats(vtkDataSet* data, const SplatSampling& sampling, vtkDataArray* scalars,
  const std::function<double(double)>& opacity, const MediumBounds& common, double clamp)
{
  MediumMeasures measures;
  if (!data || data->GetNumberOfPoints() == 0)
  {
    return measures;
  }
  const SplatShapes shapes(data, sampling);
  const SampleChoice choice(shapes.GetNumberOfIds());
  vtkIdType shown = 0, sampled = 0;
  ForEachSample(
    shapes, [&](vtkIdType id, const Vector3& place, const SplatMatrix& jacobian, double share) {
      ExtendBounds(measures.Bounds, place.data());
      const Vector3 half = HalfWithin(jacobian, share, sampling.WholeCells);
      if (!SampleBox(place, half).LiesIn(common) || ReachesOut(HalfExtent(jacobian), common))
      {
        return;
      }
      const SampleBox cell(place, HalfExtent(jacobian));
      measures.AddPlace(common, place.data(), half.data());
      if (!choice.Takes(shown++))
      {
        return;
      }
      ++sampled;
      const double value = scalars ? ScalarOf(scalars, id) : 0.0;
      const double scalar = clamp > 0.0 && value > clamp ? clamp : value;
      const double a = Norm(jacobian[0]), b = Norm(jacobian[1]), c = Norm(jacobian[2]);
      measures.Silhouettes += 0.5 * (a * b + b * c + c * a);
      measures.AddPart(common,
        { cell.GetBounds(), share * std::abs(Determinant(jacobian)), scalar,
          opacity && std::isfinite(scalar) ? opacity(scalar) : 0.0 });
    });
  const double scale =
    sampled > 0 ? static_cast<double>(shown) / static_cast<double>(sampled) : 0.0;
  measures.Scale(scale);
  if (scalars && shown > 0)
  {
    FindFiniteRange(scalars, measures.ScalarRange);
  }
  return measures;
}

SuitedVectors SuitVectorsTo(
  const MediumMeasures& vectors, const MediumBounds& common, double greatestSpeed, double count)
{
  const double greatest = greatestSpeed > 0.0 ? greatestSpeed : vectors.ScalarRange[1];
  const double mean = greatest > 0.0 && vectors.Volume > 0.0
    ? std::min(vectors.ScalarIntegral / vectors.Volume / greatest, 1.0)
    : 1.0;
  const double samples = MeanSamples(vectors, common); // along a ray
  const double layers = mean * samples;
  const double sheets = std::min(std::max(samples / samplesOfSheet, 1.0), readableLayers);
  SuitedVectors suited;
  suited.Share = layers > readableLayers ? std::pow(readableLayers / layers, 3.0) : 1.0;
  suited.Share =
    std::min(suited.Share, sheets * readableStreaks / std::max(count, sheets * readableStreaks));
  suited.Opacity = mean > 0.0
    ? std::min(std::max(readableOpacity / mean, leastOpacity), greatestOpacity)
    : greatestOpacity;
  return suited;
}

} // namespace nephoscope
