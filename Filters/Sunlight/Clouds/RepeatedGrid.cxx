// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RepeatedGrid.h"

#include "ChessboardDivision.h"
#include "Vector3.h"

#include "vtkNew.h"
#include "vtkPoints.h"

#include <algorithm>

namespace nephoscope
{
namespace
{
template <typename Body>
void ForPoints(const std::array<int, 3>& sizes, Body body)
{
  for (std::array<int, 3> at{ { 0, 0, 0 } }; at[2] < sizes[2]; ++at[2])
  {
    for (at[1] = 0; at[1] < sizes[1]; ++at[1])
    {
      for (at[0] = 0; at[0] < sizes[0]; ++at[0])
      {
        body(at);
      }
    }
  }
}
}

RepeatedGrid::RepeatedGrid(vtkDataSet* data, const Planet& planet, const std::vector<Place>& places,
  const std::vector<float>& values, bool sidesMeet)
{
  const ChessboardGrid chessboard = FindChessboardGrid(data);
  if (chessboard.IsEmpty() || planet.Radius > 0)
  {
    return;
  }
  this->Order = UprightOrder(
    { { int(chessboard.Size[0]), int(chessboard.Size[1]), int(chessboard.Size[2]) } },
    [&places](std::size_t p) { return places[p]; },
    [&planet](const Place& place) { return planet.UpAt(place); });
  this->Sizes = this->Order.GetSizes();
  this->Up = planet.Up;
  const std::vector<float> ordered = this->Order.Of(values);
  for (int axis = 0; axis < 2; ++axis)
  {
    this->Meet[axis] = sidesMeet || this->AreEqual(axis, ordered);
    const int cells = this->Sizes[axis] - (this->Meet[axis] ? 1 : 0);
    this->Copies[axis] = cells % 2 == 0 ? 1 : 2;
  }
  this->Make(this->Order.Of(places));
}

std::size_t RepeatedGrid::Number(const Index& at) const
{
  return at[0] + std::size_t(this->Sizes[0]) * (at[1] + std::size_t(this->Sizes[1]) * at[2]);
}

// Calls body(first, last) for the numbers of points on opposite sides.
template <typename Body>
void RepeatedGrid::ForSides(int axis, Body body) const
{
  const int other = 1 - axis;
  Index at{ { 0, 0, 0 } };
  for (at[2] = 0; at[2] < this->Sizes[2]; ++at[2])
  {
    for (at[other] = 0; at[other] < this->Sizes[other]; ++at[other])
    {
      Index last = at;
      last[axis] = this->Sizes[axis] - 1;
      body(this->Number(at), this->Number(last));
    }
  }
}

bool RepeatedGrid::AreEqual(int axis, const std::vector<float>& values) const
{
  bool equal = true;
  this->ForSides(axis,
    [&](std::size_t first, std::size_t last) { equal = equal && values[first] == values[last]; });
  return equal;
}

// Points along each axis, with those that close it.
RepeatedGrid::Index RepeatedGrid::Extent() const
{
  Index extent = this->Sizes;
  for (int axis = 0; axis < 2; ++axis)
  {
    extent[axis] = this->Copies[axis] * (this->Sizes[axis] - (this->Meet[axis] ? 1 : 0)) + 1;
  }
  return extent;
}

// The way to the next copy: horizontal, whatever the slope of the levels.
Place RepeatedGrid::Period(int axis, const std::vector<Place>& places) const
{
  Index last{ { 0, 0, 0 } };
  last[axis] = this->Sizes[axis] - 1;
  Index before = last;
  --before[axis];
  const Place& end = places[this->Number(last)];
  Place period = end - places[0];
  if (!this->Meet[axis])
  {
    period = period + (end - places[this->Number(before)]);
  }
  return period - Dot(period, this->Up) * this->Up;
}

void RepeatedGrid::Make(const std::vector<Place>& places)
{
  const Place periods[2] = { this->Period(0, places), this->Period(1, places) };
  const Index extent = this->Extent();
  const int widths[2] = { (extent[0] - 1) / this->Copies[0], (extent[1] - 1) / this->Copies[1] };
  const auto sourceOf = [&](const Index& at) {
    return this->Number({ { at[0] % widths[0], at[1] % widths[1], at[2] } });
  };
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  std::vector<std::size_t> firstCopy(places.size());
  ForPoints(extent, [&](const Index& at) {
    const std::size_t source = sourceOf(at);
    const int turns[2] = { at[0] / widths[0], at[1] / widths[1] };
    Place place = places[source];
    for (int c = 0; c < 3; ++c)
    {
      place[c] += turns[0] * periods[0][c] + turns[1] * periods[1][c];
    }
    firstCopy[source] = turns[0] + turns[1] == 0 ? this->Sources.size() : firstCopy[source];
    this->Sources.push_back(source);
    points->InsertNextPoint(place.data());
  });
  this->Numbers.resize(places.size());
  ForPoints(this->Sizes, [&](const Index& at) {
    this->Numbers[this->Order.NumberOf(this->Number(at))] =
      static_cast<std::int32_t>(firstCopy[sourceOf(at)]);
  });
  this->Grid = vtkSmartPointer<vtkStructuredGrid>::New();
  this->Grid->SetDimensions(extent.data());
  this->Grid->SetPoints(points);
}

std::vector<float> RepeatedGrid::Of(std::vector<float> values) const
{
  values = this->Order.Of(values);
  for (int axis = 0; axis < 2; ++axis)
  {
    if (this->Meet[axis])
    {
      this->ForSides(axis, [&values](std::size_t first, std::size_t last) {
        values[first] = values[last] = 0.5f * (values[first] + values[last]);
      });
    }
  }
  std::vector<float> repeated(this->Sources.size());
  std::transform(this->Sources.begin(), this->Sources.end(), repeated.begin(),
    [&values](std::size_t source) { return values[source]; });
  return repeated;
}
}
