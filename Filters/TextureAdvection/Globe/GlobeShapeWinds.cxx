// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The winds of a GlobeShape.
#include "GlobeShape.h"

#include "OwnThreads.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <atomic>

namespace nephoscope
{
namespace
{
// Globe Grid holds the cosine above this in its velocities along x.
constexpr double SMALLEST_MAP_COSINE = 0.01;

LocalFrame FrameAt(double longitude, double sine, double cosine)
{
  const double s = std::sin(longitude);
  const double c = std::cos(longitude);
  return { { -s, c, 0.0 }, { -sine * c, -sine * s, cosine }, { cosine * c, cosine * s, sine } };
}
}

// False if the wind or its level is not finite.
bool GlobeShape::ReadWind(const GlobeInput& input, vtkIdType point, const LocalFrame& frame,
  std::size_t place, GlobeWinds& winds) const
{
  double position[3];
  double direction[3];
  double height;
  double v[3];
  input.Data->GetPoint(point, position);
  this->PlaceOf(position, direction, height);
  input.Velocity->GetTuple(point, v);
  const double scale = 1.0 / (this->OnMap ? this->Radius_ : this->Radius_ + height);
  const auto dot = [&](const double a[3]) { return v[0] * a[0] + v[1] * a[1] + v[2] * a[2]; };
  const double east =
    scale * (this->OnMap ? v[0] * std::max(frame.North[2], SMALLEST_MAP_COSINE) : dot(frame.East));
  const double north = scale * (this->OnMap ? v[1] : dot(frame.North));
  double rise = this->OnMap ? v[2] : dot(frame.Up);
  double level = height;
  if (input.Vertical)
  {
    winds.Heights[place] = static_cast<float>(height);
    level = input.Sign * input.Vertical->GetComponent(point, 0);
    rise = input.Sign * input.VerticalRate->GetComponent(point, 0);
  }
  winds.Levels[place] = static_cast<float>(level);
  winds.Vectors[place] = { static_cast<float>(east * frame.East[0] + north * frame.North[0]),
    static_cast<float>(east * frame.East[1] + north * frame.North[1]),
    static_cast<float>(north * frame.North[2]), static_cast<float>(rise) };
  return std::isfinite(east + north + rise + level);
}

GlobeWinds GlobeShape::MakeWinds(const GlobeInput& input, std::int64_t& missing) const
{
  const auto layer =
    static_cast<std::int64_t>(this->Columns_.ColumnCount()) * this->Columns_.RowCount();
  const auto count = static_cast<std::size_t>(layer * this->Size[2]);
  GlobeWinds winds;
  winds.Vectors.resize(count);
  winds.Levels.resize(count);
  winds.Ground.resize(static_cast<std::size_t>(layer));
  winds.Heights.resize(input.Vertical ? count : 0);
  auto* ghosts = vtkUnsignedCharArray::SafeDownCast(
    input.Data->GetPointData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
  std::vector<unsigned char> known(count, 0);
  std::atomic<std::int64_t> unknown{ 0 };
  const auto read = [&](vtkIdType begin, vtkIdType end) {
    std::int64_t found = 0;
    for (vtkIdType r = begin; r < end; ++r)
    {
      const int j = static_cast<int>(r % this->Size[1]);
      const int k = static_cast<int>(r / this->Size[1]);
      const int row = j + this->SouthRows;
      const double sine = this->Columns_.SineOfLatitude(row);
      const double cosine = this->Columns_.CosineOfLatitude(row);
      for (int i = 0; i < this->Size[0]; ++i)
      {
        const vtkIdType point = this->IndexOfData(i, j, k);
        const auto place = static_cast<std::size_t>(this->Index(i, row, k));
        const bool finite = this->ReadWind(
          input, point, FrameAt(this->Columns_.Longitude(i), sine, cosine), place, winds);
        const bool hidden =
          ghosts && (ghosts->GetValue(point) & vtkDataSetAttributes::HIDDENPOINT) != 0;
        known[place] = !hidden && finite;
        found += hidden || finite ? 0 : 1;
      }
    }
    unknown += found;
  };
  InParallel(static_cast<vtkIdType>(this->Size[1]) * this->Size[2], read);
  missing = unknown;
  InParallel(this->Size[1], [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType j = begin; j < end; ++j)
    {
      for (int i = 0; i < this->Size[0]; ++i)
      {
        this->FillColumn(winds, known, i, static_cast<int>(j) + this->SouthRows);
      }
    }
  });
  this->FillClosingColumn(winds);
  this->FillPoleRows(winds);
  bool hasGround = false;
  for (std::size_t i = 0; i < winds.Ground.size(); ++i)
  {
    hasGround = hasGround || winds.Ground[i] != winds.Levels[i];
  }
  if (!hasGround)
  {
    winds.Ground = {};
  }
  return winds;
}

// Levels without a wind take that of the nearest one which has it; the lowest one with a wind is
// the ground.
void GlobeShape::FillColumn(
  GlobeWinds& winds, const std::vector<unsigned char>& known, int column, int row) const
{
  const auto at = [&](int k) { return static_cast<std::size_t>(this->Index(column, row, k)); };
  int lowest = 0;
  while (lowest < this->Size[2] && !known[at(lowest)])
  {
    ++lowest;
  }
  const bool calm = lowest == this->Size[2];
  const std::size_t ground = at(calm ? 0 : lowest);
  int below = -1; // the nearest known level below, or the lowest
  for (int k = 0; k < this->Size[2]; ++k)
  {
    if (known[at(k)])
    {
      below = k;
      continue;
    }
    int nearest = below;
    for (int up = k + 1; up < this->Size[2] && (below < 0 || up - k < k - below); ++up)
    {
      if (known[at(up)])
      {
        nearest = up;
        break;
      }
    }
    WindVector motion;
    if (nearest >= 0)
    {
      motion = winds.Vectors[at(nearest)];
      motion.Rise = 0.0f;
    }
    winds.Vectors[at(k)] = motion;
    if (!std::isfinite(winds.Levels[at(k)]))
    {
      winds.Levels[at(k)] = nearest >= 0 ? winds.Levels[at(nearest)] : 0.0f;
    }
  }
  winds.Ground[static_cast<std::size_t>(this->Index(column, row, 0))] = winds.Levels[ground];
}

void GlobeShape::FillClosingColumn(GlobeWinds& winds) const
{
  if (!this->ColumnAdded)
  {
    return;
  }
  const int last = this->Columns_.ColumnCount() - 1;
  for (int k = 0; k < this->Size[2]; ++k)
  {
    for (int row = 0; row < this->Columns_.RowCount(); ++row)
    {
      const auto from = static_cast<std::size_t>(this->Index(0, row, k));
      const auto to = static_cast<std::size_t>(this->Index(last, row, k));
      winds.Vectors[to] = winds.Vectors[from];
      winds.Levels[to] = winds.Levels[from];
      if (!winds.Heights.empty())
      {
        winds.Heights[to] = winds.Heights[from];
      }
      if (k == 0)
      {
        winds.Ground[to] = winds.Ground[from];
      }
    }
  }
}

// A pole is a single point. Where the data have no row there, it has the mean of the last row.
void GlobeShape::FillPoleRows(GlobeWinds& winds) const
{
  if (!this->Columns_.IsClosed())
  {
    return;
  }
  const int last = this->Columns_.RowCount() - 1;
  const auto isPole = [&](int row) { return this->Columns_.CosineOfLatitude(row) == 0.0; };
  if (isPole(0))
  {
    this->FillPole(winds, 0, this->SouthRows, this->SouthRows == 0);
  }
  if (isPole(last))
  {
    this->FillPole(winds, last, last - this->NorthRows, this->NorthRows == 0);
  }
}

void GlobeShape::FillPole(GlobeWinds& winds, int pole, int row, bool isData) const
{
  const int columns = this->Columns_.ColumnCount();
  // The mean of unit vectors along the row has this length; see GlobeColumns.h.
  const double scale = isData ? 1.0 : 1.0 / std::abs(this->Columns_.SineOfLatitude(row));
  for (int k = 0; k < this->Size[2]; ++k)
  {
    double sums[7] = { 0.0 };
    for (int i = 0; i + 1 < columns; ++i) // the last column is the first
    {
      const auto at = static_cast<std::size_t>(this->Index(i, row, k));
      const WindVector& m = winds.Vectors[at];
      const double values[7] = { m.X, m.Y, m.Z, m.Rise, winds.Levels[at],
        winds.Heights.empty() ? 0.0 : winds.Heights[at],
        winds.Ground[static_cast<std::size_t>(this->Index(i, row, 0))] };
      for (int c = 0; c < 7; ++c)
      {
        sums[c] += values[c] / (columns - 1);
      }
    }
    for (int i = 0; i < columns; ++i)
    {
      const auto at = static_cast<std::size_t>(this->Index(i, pole, k));
      winds.Vectors[at] = { static_cast<float>(scale * sums[0]),
        static_cast<float>(scale * sums[1]), isData ? static_cast<float>(sums[2]) : 0.0f,
        static_cast<float>(sums[3]) };
      winds.Levels[at] = static_cast<float>(sums[4]);
      if (!winds.Heights.empty())
      {
        winds.Heights[at] = static_cast<float>(sums[5]);
      }
      if (k == 0)
      {
        winds.Ground[at] = static_cast<float>(sums[6]);
      }
    }
  }
}
}
