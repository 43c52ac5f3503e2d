// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GridSamples.h"

#include "CellMoments.h"
#include "CellTaper.h"
#include "SplatSeam.h"

#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nephoscope
{
namespace
{
Vector3 Scaled(const Vector3& v, double factor)
{
  return { { v[0] * factor, v[1] * factor, v[2] * factor } };
}

// At right angles to v, of length 1.
Vector3 AcrossOf(const Vector3& v)
{
  std::size_t least = 0;
  for (std::size_t c = 1; c < 3; ++c)
  {
    least = std::abs(v[c]) < std::abs(v[least]) ? c : least;
  }
  Vector3 axis{};
  axis[least] = 1;
  const Vector3 across = Cross(v, axis);
  return Scaled(across, 1 / Norm(across));
}

// Gives the axes along which there is one sample alone the geometric mean of the other edges, at
// right angles to them.
void Thicken(SplatMatrix& columns, const std::array<bool, 3>& missing)
{
  double logarithms = 0;
  int known = 0;
  std::size_t last = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if (!missing[axis])
    {
      logarithms +=
        std::log(Norm(columns[axis])); // -infinity at a pole: WithoutFlatColumns does it
      last = axis;
      ++known;
    }
  }
  const double edge = known > 0 ? std::exp(logarithms / known) : 1;
  if (known == 3 || !(edge > 0) || !std::isfinite(edge))
  {
    return;
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const Vector3 &a = columns[(axis + 1) % 3], &b = columns[(axis + 2) % 3];
    const Vector3 normal = Cross(a, b);
    if (!missing[axis])
    {
      continue;
    }
    columns[axis] = {};
    if (known == 0)
    {
      columns[axis][axis] = edge;
    }
    else
    {
      columns[axis] = Norm(normal) > 0 ? Scaled(normal, edge / Norm(normal))
                                       : Scaled(AcrossOf(columns[last]), edge);
    }
  }
}
}

GridSamples::GridSamples(vtkDataSet* data, bool onCells)
  : Data(data)
  , OnCells(onCells)
{
  if (auto* image = vtkImageData::SafeDownCast(data))
  {
    image->GetDimensions(this->PointDimensions);
    this->Uniform = true;
  }
  else if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(data))
  {
    rectilinear->GetDimensions(this->PointDimensions);
  }
  else if (auto* structured = vtkStructuredGrid::SafeDownCast(data))
  {
    structured->GetDimensions(this->PointDimensions);
    this->Curved = true;
  }
  else
  {
    return;
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Dimensions[axis] =
      onCells ? std::max(1, this->PointDimensions[axis] - 1) : this->PointDimensions[axis];
  }
  for (int axis = 0; axis < 3 && !onCells && vtkStructuredGrid::SafeDownCast(data); ++axis)
  {
    this->Closed[axis] = this->ComesBack(axis);
  }
}

bool GridSamples::ComesBack(int axis) const
{
  const int columns = this->Dimensions[axis], a = (axis + 1) % 3, b = (axis + 2) % 3;
  SplatSeam seam;
  for (int k = 0; k < this->Dimensions[b] && columns >= SplatSeam::FewestColumns; ++k)
  {
    for (int j = 0; j < this->Dimensions[a]; ++j)
    {
      int first[3], second[3], last[3];
      first[a] = second[a] = last[a] = j;
      first[b] = second[b] = last[b] = k;
      first[axis] = 0;
      second[axis] = 1;
      last[axis] = columns - 1;
      seam.Compare(this->At(first), this->At(second), this->At(last));
    }
  }
  return seam.IsClosed();
}

bool GridSamples::IsRepeated(vtkIdType id) const
{
  if (!this->Closed[0] && !this->Closed[1] && !this->Closed[2])
  {
    return false;
  }
  int index[3];
  this->IndexOf(id, index);
  bool repeated = false;
  for (int axis = 0; axis < 3; ++axis)
  {
    repeated = repeated || (this->Closed[axis] && index[axis] == this->Dimensions[axis] - 1);
  }
  return repeated;
}

void GridSamples::IndexOf(vtkIdType id, int index[3]) const
{
  index[0] = static_cast<int>(id % this->Dimensions[0]);
  index[1] = static_cast<int>(id / this->Dimensions[0] % this->Dimensions[1]);
  index[2] = static_cast<int>(id / this->Dimensions[0] / this->Dimensions[1]);
}

// A corner of a cell; the last point where there are no more.
vtkIdType GridSamples::CornerOf(const int index[3], int corner) const
{
  vtkIdType point = 0;
  for (int axis = 2; axis >= 0; --axis)
  {
    const int last = this->PointDimensions[axis] - 1;
    point =
      point * this->PointDimensions[axis] + std::min(index[axis] + (corner >> axis & 1), last);
  }
  return point;
}

// A point, or the mean of a cell's corners.
Vector3 GridSamples::At(const int index[3]) const
{
  Vector3 sum{};
  const int corners = this->OnCells ? 8 : 1;
  for (int corner = 0; corner < corners; ++corner)
  {
    double x[3];
    this->Data->GetPoint(this->CornerOf(index, corner), x);
    for (std::size_t c = 0; c < 3; ++c)
    {
      sum[c] += x[c] / corners;
    }
  }
  return sum;
}

Vector3 GridSamples::Position(vtkIdType id) const
{
  int index[3];
  this->IndexOf(id, index);
  Vector3 corners[8];
  if (this->Curved && this->OnCells && this->FindCell(index, corners))
  {
    CellMoments moments(corners[0]);
    moments.AddHexahedron(corners);
    if (moments.GetSize() > 0 && std::isfinite(moments.GetSize()))
    {
      return moments.GetCenter();
    }
  }
  return this->At(index);
}

// In the order of VTK_HEXAHEDRON; false for cells of fewer dimensions.
bool GridSamples::FindCell(const int index[3], Vector3 (&corners)[8]) const
{
  constexpr int order[8] = { 0, 1, 3, 2, 4, 5, 7, 6 };
  for (int i = 0; i < 8; ++i)
  {
    this->Data->GetPoint(this->CornerOf(index, order[i]), corners[i].data());
  }
  return *std::min_element(this->PointDimensions, this->PointDimensions + 3) > 1;
}

// Gives columns the lengths that the covariance of the cell asks for; `share`: the cell's volume
// over theirs.
void GridSamples::FitToCell(const Vector3 (&corners)[8], SplatMatrix& columns, double& share) const
{
  CellMoments moments(corners[0]);
  moments.AddHexahedron(corners);
  const double spanned = std::abs(Determinant(columns));
  if (!(moments.GetSize() > 0) || !(spanned > 0) || !std::isfinite(moments.GetSize() / spanned))
  {
    return;
  }
  SplatMatrix square{};
  for (const Vector3& column : columns)
  {
    AddOuterProduct(square, column);
  }
  CellTaper(corners).AtMiddle().Widen(square, 1);
  const SplatMatrix covariance = moments.GetCovariance(), inverse = Inverse(columns);
  share = moments.GetSize() / spanned;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const Vector3 row = { { inverse[0][axis], inverse[1][axis], inverse[2][axis] } };
    const double factor = std::sqrt(blurOfSquare * Dot(row, Times(square, row)) +
      Dot(row, Times(covariance, row)) / varianceOfKernel);
    columns[axis] = Scaled(columns[axis], factor);
    share /= factor;
  }
  constexpr double rounding = 1e-5;
  share = std::abs(share - 1) < rounding ? 1 : share;
}

// From the middle of one face of a cell to that of the face on the other side.
Vector3 GridSamples::EdgeOfCell(const int index[3], int axis) const
{
  Vector3 edge{};
  for (int corner = 0; corner < 8; ++corner)
  {
    double x[3];
    this->Data->GetPoint(this->CornerOf(index, corner), x);
    for (std::size_t c = 0; c < 3; ++c)
    {
      edge[c] += (corner >> axis & 1 ? x[c] : -x[c]) / 4;
    }
  }
  return edge;
}

// Between the samples on both sides along an axis; false where there are none.
bool GridSamples::FindColumn(const int index[3], int axis, Vector3& column) const
{
  int before[3] = { index[0], index[1], index[2] };
  int after[3] = { index[0], index[1], index[2] };
  before[axis] = std::max(index[axis] - 1, 0);
  after[axis] = std::min(index[axis] + 1, this->Dimensions[axis] - 1);
  int steps = after[axis] - before[axis];
  if (this->Closed[axis] && steps == 1) // across the seam
  {
    before[axis] = index[axis] == 0 ? this->Dimensions[axis] - 2 : index[axis] - 1;
    after[axis] = 1;
    steps = 2;
  }
  if (steps > 0)
  {
    const Vector3 step = this->At(after) - this->At(before);
    column = { { step[0] / steps, step[1] / steps, step[2] / steps } };
  }
  else if (this->OnCells && this->PointDimensions[axis] > 1)
  {
    column = this->EdgeOfCell(index, axis);
  }
  else
  {
    return false;
  }
  return true;
}

SplatMatrix GridSamples::Jacobian(vtkIdType id) const
{
  int index[3];
  this->IndexOf(id, index);
  double share;
  return this->WideColumns(index, share);
}

Vector3 GridSamples::Direction(vtkIdType id, int axis) const
{
  int index[3];
  this->IndexOf(id, index);
  Vector3 column{};
  const bool found = this->FindColumn(index, axis, column) && Norm(column) > 0;
  return found ? column : this->Jacobian(id)[static_cast<std::size_t>(axis)];
}

// Those of the cell, but wider where it is a needle; `share`: by how much the cell is less.
SplatMatrix GridSamples::WideColumns(const int index[3], double& share) const
{
  SplatMatrix columns{};
  std::array<bool, 3> missing{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    missing[axis] = !this->FindColumn(index, static_cast<int>(axis), columns[axis]);
  }
  share = 1;
  Vector3 corners[8];
  if (this->Curved && this->OnCells && this->FindCell(index, corners))
  {
    this->FitToCell(corners, columns, share);
    return columns;
  }
  Vector3 widths{};
  if (this->Curved)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      widths[axis] = missing[axis] ? 0.0 : this->WidthBeside(index, axis, columns, share);
    }
  }
  Thicken(columns, missing);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double length = Norm(columns[axis]);
    if (widths[axis] > length && length > 0)
    {
      share *= length / widths[axis];
      columns[axis] = Scaled(columns[axis], widths[axis] / length);
    }
  }
  return columns;
}

// How long a column becomes at the next samples along another axis; where the grid ends it goes on
// as before. There half of the sample's cell is on one side, and as long in the mean as a quarter
// of the way to the next.
struct GridSamples::LengthsOfColumn
{
  double Least, Greatest, Mean;
};

GridSamples::LengthsOfColumn GridSamples::LengthsBeside(
  const int index[3], int axis, int along, double own) const
{
  double lengths[2];
  bool found[2];
  for (int side = 0; side < 2; ++side)
  {
    int next[3] = { index[0], index[1], index[2] };
    next[along] += 2 * side - 1;
    const int period = this->Dimensions[along] - 1;
    next[along] = this->Closed[along] ? (next[along] + period) % period : next[along];
    Vector3 column{};
    found[side] = next[along] >= 0 && next[along] <= period && this->FindColumn(next, axis, column);
    lengths[side] = Norm(column);
  }
  const double mean = found[0] == found[1] ? own : 0.75 * own + 0.25 * lengths[found[0] ? 0 : 1];
  for (int side = 0; side < 2; ++side)
  {
    lengths[side] = found[side] ? lengths[side]
      : found[1 - side]         ? 2 * own - lengths[1 - side]
                                : own;
  }
  return { std::min(lengths[0], lengths[1]), std::max(lengths[0], lengths[1]), mean };
}

/*
 * The width that a column needs where cells meet at an axis or a centre, which they are directed to
 * by another column: the length of that. 0 elsewhere. `share`: of the column's length in its
 * middle, the mean over the sample's cell. A column of no length gets that of the cell's middle,
 * across the others: half of the cell is as wide on the mean as a quarter of the next.
 */
double GridSamples::WidthBeside(
  const int index[3], std::size_t axis, SplatMatrix& columns, double& share) const
{
  constexpr double vanishing = 1e-3, narrow = 0.25;
  const double own = Norm(columns[axis]);
  double width = 0;
  for (std::size_t turn = 1; turn < 3; ++turn)
  {
    const std::size_t along = (axis + turn) % 3;
    const double length = Norm(columns[along]);
    if (this->Dimensions[along] < 2 || !(length > 0))
    {
      continue;
    }
    const auto beside =
      this->LengthsBeside(index, static_cast<int>(axis), static_cast<int>(along), own);
    if (beside.Greatest > 0 && own <= vanishing * beside.Greatest)
    {
      const Vector3 normal = Cross(columns[(axis + 1) % 3], columns[(axis + 2) % 3]);
      const Vector3 direction = Norm(normal) > 0 ? normal : AcrossOf(columns[along]);
      columns[axis] = Scaled(direction, 0.25 * beside.Greatest / Norm(direction));
      return length;
    }
    share *= own > 0 ? beside.Mean / own : 1;
    width = beside.Least < narrow * own ? std::max(width, length) : width;
  }
  return width;
}

double GridSamples::ShareInGrid(vtkIdType id) const
{
  int index[3];
  this->IndexOf(id, index);
  double share = 1;
  for (int axis = 0; axis < 3 && !this->OnCells; ++axis)
  {
    const int last = this->Dimensions[axis] - 1;
    const bool atEnd = index[axis] == 0 || index[axis] == last;
    share *= last > 0 && atEnd && !this->Closed[axis] ? 0.5 : 1.0;
  }
  return share;
}

// The cell on one side of a point along each axis, and the edges there; -1 if there is none.
vtkIdType GridSamples::CellAround(const int index[3], int octant, SplatMatrix& steps) const
{
  vtkIdType cell = 0;
  for (int axis = 2; axis >= 0; --axis)
  {
    const int cells = this->Dimensions[axis] - 1;
    const bool after = (octant >> axis & 1) != 0;
    steps[static_cast<std::size_t>(axis)] = {};
    steps[static_cast<std::size_t>(axis)][static_cast<std::size_t>(axis)] = 1;
    if (cells == 0)
    {
      if (after)
      {
        return -1;
      }
      continue;
    }
    int at = after ? index[axis] : index[axis] - 1;
    at = this->Closed[axis] ? (at + cells) % cells : at;
    if (at < 0 || at >= cells)
    {
      return -1;
    }
    int begin[3] = { index[0], index[1], index[2] }, end[3] = { index[0], index[1], index[2] };
    begin[axis] = at;
    end[axis] = at + 1;
    steps[static_cast<std::size_t>(axis)] = this->At(end) - this->At(begin);
    cell = cell * cells + at;
  }
  return cell;
}

double GridSamples::ShareInShown(vtkIdType id) const
{
  if (this->Hidden.empty() || this->OnCells)
  {
    return 1;
  }
  int index[3];
  this->IndexOf(id, index);
  double volumes[2] = { 0, 0 }, counts[2] = { 0, 0 }; // shown, all
  for (int octant = 0; octant < 8; ++octant)
  {
    SplatMatrix steps{};
    const vtkIdType cell = this->CellAround(index, octant, steps);
    if (cell < 0)
    {
      continue;
    }
    const double volume = std::abs(Determinant(steps));
    const double shown = this->Hidden[static_cast<std::size_t>(cell)] ? 0 : 1;
    volumes[0] += shown * volume;
    volumes[1] += volume;
    counts[0] += shown;
    counts[1] += 1;
  }
  return volumes[1] > 0 ? volumes[0] / volumes[1] : counts[1] > 0 ? counts[0] / counts[1] : 1;
}

double GridSamples::ShareInShape(vtkIdType id) const
{
  int index[3];
  this->IndexOf(id, index);
  double share = 1;
  if (this->Curved)
  {
    this->WideColumns(index, share);
  }
  return share;
}

} // namespace nephoscope
