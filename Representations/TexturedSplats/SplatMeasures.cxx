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
constexpr double readableLayers = 7.0;  // of streaks of the greatest speed, one behind the other
constexpr double readableOpacity = 0.6; // of streaks of the mean speed
constexpr double leastOpacity = 0.8, greatestOpacity = 2.0;

bool isPlace(const SplatVector& place)
{
  return std::isfinite(place[0] + place[1] + place[2]);
}

// Half of the sample's cell along each axis.
SplatVector halfExtent(const SplatMatrix& jacobian)
{
  SplatVector half{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    half[axis] =
      0.5 * (std::abs(jacobian[0][axis]) + std::abs(jacobian[1][axis]) + std::abs(jacobian[2][axis]));
  }
  return half;
}

// Calls visit(id, place, jacobian) for all visible samples.
template <typename Visit>
void forEachSample(vtkDataSet* data, const SplatSampling& sampling, const Visit& visit)
{
  if (!data || data->GetNumberOfPoints() == 0)
  {
    return;
  }
  const SplatShapes shapes(data, sampling);
  SplatMatrix jacobian{};
  bool found = false;
  for (vtkIdType id = 0; id < shapes.GetNumberOfIds(); ++id)
  {
    const SplatVector place = shapes.Place(id);
    if (shapes.IsVisible(id) && isPlace(place))
    {
      jacobian = found && shapes.HaveOneShape() ? jacobian : shapes.Jacobian(id);
      found = true;
      visit(id, place, jacobian);
    }
  }
}
} // namespace

MediumBounds boundsOfSamples(vtkDataSet* data, const SplatSampling& sampling)
{
  MediumBounds bounds = NoMediumBounds;
  forEachSample(data, sampling, [&](vtkIdType, const SplatVector& place, const SplatMatrix& jacobian) {
    const SplatVector half = halfExtent(jacobian);
    const double low[3] = { place[0] - half[0], place[1] - half[1], place[2] - half[2] };
    const double high[3] = { place[0] + half[0], place[1] + half[1], place[2] + half[2] };
    addPlace(bounds, low);
    addPlace(bounds, high);
  });
  return bounds;
}

MediumMeasures measureSplats(vtkDataSet* data, const SplatSampling& sampling, vtkDataArray* scalars,
  const std::function<double(double)>& opacity, const MediumBounds& common)
{
  MediumMeasures measures;
  const SampleChoice choice(
    data ? sampling.OnCells ? data->GetNumberOfCells() : data->GetNumberOfPoints() : 0);
  vtkIdType shown = 0, sampled = 0;
  forEachSample(data, sampling, [&](vtkIdType id, const SplatVector& place, const SplatMatrix& jacobian) {
    addPlace(measures.Bounds, place.data());
    measures.AddPlace(common, place.data(), halfExtent(jacobian).data());
    if (!choice.Takes(shown++))
    {
      return;
    }
    ++sampled;
    const double volume = std::abs(Determinant(jacobian));
    const double scalar = scalars ? scalarOf(scalars, id) : 0.0;
    const double a = Length(jacobian[0]), b = Length(jacobian[1]), c = Length(jacobian[2]);
    measures.Silhouettes += 0.5 * (a * b + b * c + c * a);
    measures.Volume += volume;
    if (std::isfinite(scalar))
    {
      measures.ScalarIntegral += volume * scalar;
      measures.OpacityIntegral += opacity ? volume * opacity(scalar) : 0.0;
    }
  });
  const double scale = sampled > 0 ? static_cast<double>(shown) / static_cast<double>(sampled) : 0.0;
  measures.Volume *= scale;
  measures.Silhouettes *= scale;
  measures.ScalarIntegral *= scale;
  measures.OpacityIntegral *= scale;
  if (scalars && shown > 0)
  {
    scalars->GetFiniteRange(measures.ScalarRange, scalars->GetNumberOfComponents() > 1 ? -1 : 0);
  }
  return measures;
}

SuitedVectors suitVectors(const MediumMeasures& vectors, const MediumBounds& common, double greatestSpeed)
{
  const double greatest = greatestSpeed > 0.0 ? greatestSpeed : vectors.ScalarRange[1];
  const double mean = greatest > 0.0 && vectors.Volume > 0.0 ? std::min(vectors.ScalarIntegral / vectors.Volume / greatest, 1.0) : 1.0;
  const double layers = mean * meanSamples(vectors, common);
  SuitedVectors suited;
  suited.Share = layers > readableLayers ? std::pow(readableLayers / layers, 3.0) : 1.0;
  suited.Opacity = mean > 0.0 ? std::min(std::max(readableOpacity / mean, leastOpacity), greatestOpacity) : greatestOpacity;
  return suited;
}

} // namespace nephoscope
