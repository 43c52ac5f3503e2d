// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ChessboardDivision.h"

#include "HexahedronForm.h"

#include "vtkCellData.h"
#include "vtkImageData.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace nephoscope
{
namespace
{
std::size_t Index(vtkIdType number)
{
  return static_cast<std::size_t>(number);
}

// Odd vertices of a hexahedron or voxel whose first vertex is even.
std::array<int, 8> OddVertices(int cellType)
{
  const std::array<int, 8> vertices = HexahedronFormOf(cellType).Vertices;
  std::array<int, 8> odd{};
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    odd[Index(vertices[corner])] = static_cast<int>((corner ^ corner >> 1 ^ corner >> 2) & 1);
  }
  return odd;
}
}

ChessboardGrid FindChessboardGrid(vtkDataSet* data)
{
  int extent[6];
  if (auto* image = vtkImageData::SafeDownCast(data))
  {
    image->GetExtent(extent);
  }
  else if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(data))
  {
    rectilinear->GetExtent(extent);
  }
  else if (auto* structured = vtkStructuredGrid::SafeDownCast(data))
  {
    structured->GetExtent(extent);
  }
  else
  {
    return ChessboardGrid();
  }
  ChessboardGrid grid;
  for (int axis = 0; axis < 3; ++axis)
  {
    grid.Size[axis] = extent[2 * axis + 1] - extent[2 * axis] + 1;
  }
  grid.OddOffset = (extent[0] + extent[2] + extent[4]) & 1;
  return grid.IsEmpty() ? ChessboardGrid() : grid;
}

std::int32_t ColoredParts::Add()
{
  this->Parents.push_back(static_cast<std::int32_t>(this->Parents.size()));
  this->Odd.push_back(0);
  return this->Parents.back();
}

std::pair<std::int32_t, int> ColoredParts::Find(std::int32_t part)
{
  std::int32_t whole = part;
  int odd = 0;
  while (this->Parents[Index(whole)] != whole)
  {
    odd ^= this->Odd[Index(whole)];
    whole = this->Parents[Index(whole)];
  }
  for (int left = odd; part != whole;) // the next time the way is short
  {
    const std::int32_t next = this->Parents[Index(part)];
    const int own = this->Odd[Index(part)];
    this->Parents[Index(part)] = whole;
    this->Odd[Index(part)] = static_cast<unsigned char>(left);
    left ^= own;
    part = next;
  }
  return { whole, odd };
}

bool ColoredParts::Join(std::int32_t a, std::int32_t b, int odd)
{
  const auto first = this->Find(a), second = this->Find(b);
  const int between = first.second ^ second.second ^ odd;
  if (first.first == second.first)
  {
    return between == 0;
  }
  this->Parents[Index(second.first)] = first.first;
  this->Odd[Index(second.first)] = static_cast<unsigned char>(between);
  return true;
}

ChessboardColors::ChessboardColors(vtkUnstructuredGrid* grid)
  : Grid(grid)
  , PartOf(Index(grid->GetNumberOfPoints()), -1)
  , Odd(PartOf.size(), 0)
{
}

bool ChessboardColors::Find()
{
  for (vtkIdType cell = 0; cell < this->Grid->GetNumberOfCells(); ++cell)
  {
    if (!this->Add(cell))
    {
      return false;
    }
  }
  if (this->Parts.Count() > 1)
  {
    this->JoinCoincident();
  }
  this->NumberWholes();
  return true;
}

bool ChessboardColors::Add(vtkIdType cell)
{
  const int type = this->Grid->GetCellType(cell);
  if (type == VTK_EMPTY_CELL)
  {
    return true;
  }
  if (type != VTK_HEXAHEDRON && type != VTK_VOXEL)
  {
    return false;
  }
  const std::array<int, 8> odd = OddVertices(type);
  vtkIdType size;
  const vtkIdType* points;
  this->Grid->GetCellPoints(cell, size, points);
  const vtkIdType* known = std::find_if(
    points, points + 8, [this](vtkIdType point) { return this->PartOf[Index(point)] >= 0; });
  const bool isNew = known == points + 8;
  const std::int32_t part = isNew ? this->Parts.Add() : this->PartOf[Index(*known)];
  const int base = isNew ? 0 : this->Odd[Index(*known)] ^ odd[Index(known - points)];
  for (std::size_t i = 0; i < 8; ++i)
  {
    const std::size_t point = Index(points[i]);
    const int color = base ^ odd[i];
    if (this->PartOf[point] < 0)
    {
      this->PartOf[point] = part;
      this->Odd[point] = static_cast<unsigned char>(color);
    }
    const bool isSame = this->PartOf[point] == part && this->Odd[point] == color;
    if (!isSame && !this->Parts.Join(part, this->PartOf[point], color ^ this->Odd[point]))
    {
      return false;
    }
  }
  return true;
}

// Blocks that repeat their points: equal colours at equal places.
void ChessboardColors::JoinCoincident()
{
  using Place = std::array<double, 3>;
  std::vector<Place> places(this->PartOf.size());
  std::vector<std::size_t> order;
  for (std::size_t point = 0; point < places.size(); ++point)
  {
    Place& p = places[point];
    this->Grid->GetPoint(static_cast<vtkIdType>(point), p.data());
    if (this->PartOf[point] >= 0 && std::isfinite(p[0] + p[1] + p[2]))
    {
      order.push_back(point);
    }
  }
  std::sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b) { return std::tie(places[a], a) < std::tie(places[b], b); });
  for (std::size_t i = 1; i < order.size(); ++i)
  {
    const std::size_t a = order[i - 1], b = order[i];
    if (places[a] == places[b])
    {
      this->Parts.Join(this->PartOf[a], this->PartOf[b], this->Odd[a] ^ this->Odd[b]);
    }
  }
}

void ChessboardColors::NumberWholes()
{
  this->Wholes.assign(this->Parts.Count(), -1);
  for (std::size_t point = 0; point < this->PartOf.size(); ++point)
  {
    if (this->PartOf[point] >= 0)
    {
      const auto whole = this->Parts.Find(this->PartOf[point]);
      std::int32_t& number = this->Wholes[Index(whole.first)];
      if (number < 0)
      {
        number = static_cast<std::int32_t>(this->FirstIsOdd.size());
        this->FirstIsOdd.push_back(static_cast<unsigned char>(whole.second ^ this->Odd[point]));
      }
    }
  }
}

std::pair<std::int32_t, int> ChessboardColors::ColorOf(vtkIdType point)
{
  const std::int32_t part = this->PartOf[Index(point)];
  if (part < 0)
  {
    return { -1, 0 };
  }
  const auto whole = this->Parts.Find(part);
  const std::int32_t number = this->Wholes[Index(whole.first)];
  return { number, whole.second ^ this->Odd[Index(point)] ^ this->FirstIsOdd[Index(number)] };
}

vtkSmartPointer<vtkUnsignedCharArray> ChessboardColors::MakeDivisions(
  const std::vector<unsigned char>& odd)
{
  auto divisions = vtkSmartPointer<vtkUnsignedCharArray>::New();
  divisions->SetName(divisionName);
  divisions->SetNumberOfValues(this->Grid->GetNumberOfCells());
  for (vtkIdType cell = 0; cell < this->Grid->GetNumberOfCells(); ++cell)
  {
    unsigned char division = 0;
    if (this->Grid->GetCellType(cell) != VTK_EMPTY_CELL)
    {
      vtkIdType size;
      const vtkIdType* points;
      this->Grid->GetCellPoints(cell, size, points);
      const auto color = this->ColorOf(points[0]);
      division = static_cast<unsigned char>(3 + (color.second ^ odd[Index(color.first)]));
    }
    divisions->SetValue(cell, division);
  }
  return divisions;
}

vtkSmartPointer<vtkUnsignedCharArray> ChessboardDivision(vtkDataSet* data)
{
  auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
  if (!grid || grid->GetNumberOfCells() == 0 || grid->GetCellData()->HasArray(divisionName))
  {
    return nullptr;
  }
  ChessboardColors colors(grid);
  return colors.Find() ? colors.MakeDivisions(std::vector<unsigned char>(colors.CountWholes(), 0))
                       : vtkSmartPointer<vtkUnsignedCharArray>();
}

} // namespace nephoscope
