// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SplatSamples.h"

#include "OwnThreads.h"

#include "vtkBoundingBox.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>
#include <utility>

namespace nephoscope
{
namespace
{
std::vector<vtkIdType> VisibleIds(const SplatShapes& shapes)
{
  std::vector<vtkIdType> ids;
  ids.reserve(static_cast<std::size_t>(shapes.GetNumberOfIds()));
  for (vtkIdType id = 0; id < shapes.GetNumberOfIds(); ++id)
  {
    if (shapes.IsVisible(id))
    {
      ids.push_back(id);
    }
  }
  return ids;
}

SplatSamples::Jacobian ToFloat(const SplatMatrix& matrix)
{
  SplatSamples::Jacobian result;
  for (std::size_t column = 0; column < 3; ++column)
  {
    for (std::size_t row = 0; row < 3; ++row)
    {
      result[column][row] = static_cast<float>(matrix[column][row]);
    }
  }
  return result;
}

// Less than 0, 0, or more: the values of two samples, array by array. Values that are not numbers
// come last.
int CompareValues(vtkFieldData* arrays, vtkIdType a, vtkIdType b)
{
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = arrays->GetArray(i); // null: of something else than numbers
    for (int c = 0; array && c < array->GetNumberOfComponents(); ++c)
    {
      const double x = array->GetComponent(a, c), y = array->GetComponent(b, c);
      if (std::isnan(x) != std::isnan(y))
      {
        return std::isnan(y) ? -1 : 1;
      }
      if (x < y || x > y)
      {
        return x < y ? -1 : 1;
      }
    }
  }
  return 0;
}

// Drops what is nowhere, and brings the rest into the order of places; in one place, of values, so
// that the input's order is without effect.
void SortByPlace(vtkFieldData* arrays, std::vector<vtkIdType>& ids, std::vector<Vector3>& places)
{
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    if (std::isfinite(places[i][0] + places[i][1] + places[i][2]))
    {
      order.push_back(i);
    }
  }
  vtkSMPTools::Sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    if (places[a] != places[b])
    {
      return places[a] < places[b];
    }
    const int values = CompareValues(arrays, ids[a], ids[b]);
    return values != 0 ? values < 0 : ids[a] < ids[b];
  });
  std::vector<vtkIdType> sortedIds(order.size());
  std::vector<Vector3> sortedPlaces(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    sortedIds[i] = ids[order[i]];
    sortedPlaces[i] = places[order[i]];
  }
  ids.swap(sortedIds);
  places.swap(sortedPlaces);
}

// Shaders divide by the volume of a cell.
std::string CheckWidth(double widest)
{
  constexpr double smallest = 5e-13; // whose volume is a normal number in single precision
  if (widest >= smallest)
  {
    return std::string();
  }
  std::ostringstream message;
  message
    << "The splats are at most " << widest
    << " wide, too small for the single precision of graphics cards. Choose a smaller unit, so that they are at least 1e-12 wide.";
  return message.str();
}
}

void FindPlaceBounds(vtkDataSet* data, double bounds[6])
{
  data->GetBounds(bounds);
  if (std::all_of(bounds, bounds + 6, [](double b) { return std::isfinite(b); }))
  {
    return;
  }
  vtkBoundingBox box;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double x[3];
    data->GetPoint(i, x);
    if (std::isfinite(x[0] + x[1] + x[2]))
    {
      box.AddPoint(x);
    }
  }
  box.GetBounds(bounds);
}

namespace
{
bool HasExtent(const double bounds[6], int axis)
{
  const double longest =
    std::max({ bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] });
  return bounds[2 * axis + 1] - bounds[2 * axis] > 1e-6 * longest;
}
}

int NumberOfAxes(const double bounds[6])
{
  return int(HasExtent(bounds, 0)) + int(HasExtent(bounds, 1)) + int(HasExtent(bounds, 2));
}

double MeanSpacing(const double bounds[6], std::size_t count)
{
  double volume = 1;
  for (int axis = 0; axis < 3; ++axis)
  {
    volume *= HasExtent(bounds, axis) ? bounds[2 * axis + 1] - bounds[2 * axis] : 1.0;
  }
  const int axes = NumberOfAxes(bounds);
  return axes > 0 ? std::pow(volume / static_cast<double>(count), 1.0 / axes) : 1.0;
}

void SplatSamples::FreeJacobians()
{
  std::vector<Jacobian>().swap(this->Jacobians);
}

void FindJacobians(const SplatShapes& shapes, SplatSamples& samples)
{
  samples.HaveOneShape = shapes.HaveOneShape() || samples.Size() == 1;
  samples.Jacobians.resize(samples.HaveOneShape ? 1 : samples.Size());
  ForAll(samples.Jacobians.size(),
    [&](std::size_t i) { samples.Jacobians[i] = ToFloat(shapes.Jacobian(samples.Ids[i])); });
  samples.SomeJacobians.clear();
  for (std::size_t i = 0; i < samples.Jacobians.size(); i += samples.StrideOfSome())
  {
    samples.SomeJacobians.push_back(samples.Jacobians[i]);
  }
}

namespace
{
void FindCenter(vtkDataSet* data, const SplatSampling& sampling, double center[3])
{
  double bounds[6];
  FindPlaceBounds(data, bounds);
  for (int axis = 0; axis < 3; ++axis)
  {
    center[axis] = sampling.Frame.Origin ? (*sampling.Frame.Origin)[static_cast<std::size_t>(axis)]
                                         : 0.5 * (bounds[2 * axis] + bounds[2 * axis + 1]);
  }
}

void TakePlaces(const std::vector<Vector3>& places, SplatSamples& samples)
{
  samples.Positions.resize(places.size());
  ForAll(places.size(), [&](std::size_t i) {
    for (std::size_t c = 0; c < 3; ++c)
    {
      samples.Positions[i][c] = static_cast<float>(places[i][c] - samples.Center[c]);
    }
  });
}

// None if all are whole.
void TakeShares(const SplatShapes& shapes, SplatSamples& samples)
{
  samples.Shares.resize(samples.Size());
  ForAll(samples.Shares.size(),
    [&](std::size_t i) { samples.Shares[i] = static_cast<float>(shapes.Share(samples.Ids[i])); });
  const auto whole = [](float share) { return share == 1.0f; };
  if (std::all_of(samples.Shares.begin(), samples.Shares.end(), whole))
  {
    samples.Shares.clear();
  }
}

double FindLongestEdge(const SplatSamples& samples)
{
  double longest = 0.0;
  for (const SplatSamples::Jacobian& jacobian : samples.Jacobians)
  {
    SplatMatrix matrix;
    for (std::size_t c = 0; c < 3; ++c)
    {
      matrix[c] = { { jacobian[c][0], jacobian[c][1], jacobian[c][2] } };
    }
    longest = std::max(longest, LargestStretch(matrix));
  }
  return longest;
}
}

SplatSamples FindSplatSamples(vtkDataSet* data, const SplatSampling& sampling, std::string& error)
{
  SplatSamples samples;
  error = SplatShapes::Check(data, sampling);
  if (!error.empty())
  {
    return samples;
  }
  const SplatShapes shapes(data, sampling);
  std::copy_n(shapes.GetGrid().GetDimensions(), 3, samples.Dimensions);
  std::vector<vtkIdType> ids = VisibleIds(shapes);
  const std::size_t visible = ids.size();
  for (vtkIdType id = 0; id < shapes.GetNumberOfIds(); ++id)
  {
    samples.NumberOfWrongSizes += shapes.HasWrongSize(id) ? 1 : 0;
  }
  std::vector<Vector3> places(visible);
  ForAll(places.size(), [&](std::size_t i) { places[i] = shapes.Place(ids[i]); });
  const int kind = sampling.OnCells ? vtkDataObject::CELL : vtkDataObject::POINT;
  SortByPlace(data->GetAttributesAsFieldData(kind), ids, places);
  samples.NumberNowhere = visible - places.size();
  if (ids.empty())
  {
    error = "The input has no visible points to draw.";
    return samples;
  }
  samples.Ids = SampleIds(std::move(ids));
  FindCenter(data, sampling, samples.Center);
  samples.AreVoxels = shapes.AreVoxels();
  samples.Voxel = shapes.GetVoxel();
  samples.FirstVoxel =
    shapes.GetFirstVoxel() - Vector3{ samples.Center[0], samples.Center[1], samples.Center[2] };
  TakePlaces(places, samples);
  FindJacobians(shapes, samples);
  TakeShares(shapes, samples);
  samples.LongestEdge = std::max(sampling.Frame.LongestEdge, FindLongestEdge(samples));
  error = CheckWidth(samples.LongestEdge);
  return samples;
}

} // namespace nephoscope
