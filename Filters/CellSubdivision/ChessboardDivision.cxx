// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ChessboardDivision.h"

#include "TetrahedronSource.h"

#include <cstdint>
#include <numeric>
#include <utility>

namespace nephoscope
{
namespace
{
/** Connected parts, and whether what is even in one is odd in the part that it belongs to. */
class Parts
{
public:
  std::int32_t Add()
  {
    this->Parents.push_back(static_cast<std::int32_t>(this->Parents.size()));
    this->Odd.push_back(0);
    return this->Parents.back();
  }

  /** The whole to which a part belongs, and whether it is odd there. */
  std::pair<std::int32_t, int> Find(std::int32_t part)
  {
    std::int32_t whole = part;
    int odd = 0;
    while (this->Parents[index(whole)] != whole)
    {
      odd ^= this->Odd[index(whole)];
      whole = this->Parents[index(whole)];
    }
    for (int left = odd; part != whole;)
    {
      const std::int32_t next = this->Parents[index(part)];
      const int own = this->Odd[index(part)];
      this->Parents[index(part)] = whole;
      this->Odd[index(part)] = static_cast<unsigned char>(left);
      left ^= own;
      part = next;
    }
    return { whole, odd };
  }

  /** False if the two belong together otherwise already. */
  bool Join(std::int32_t a, std::int32_t b, int odd)
  {
    const auto first = this->Find(a), second = this->Find(b);
    const int between = first.second ^ second.second ^ odd;
    if (first.first == second.first)
    {
      return between == 0;
    }
    this->Parents[index(second.first)] = first.first;
    this->Odd[index(second.first)] = static_cast<unsigned char>(between);
    return true;
  }

  std::size_t Count() const { return this->Parents.size(); }

private:
  static std::size_t index(std::int32_t part) { return static_cast<std::size_t>(part); }

  std::vector<std::int32_t> Parents;
  std::vector<unsigned char> Odd; // against the parent
};

class Colors
{
public:
  explicit Colors(vtkUnstructuredGrid* grid)
    : Grid(grid)
    , PartOf(static_cast<std::size_t>(grid->GetNumberOfPoints()), -1)
    , Odd(PartOf.size(), 0)
  {
  }

  /** False if there is no such colouring. */
  bool Find()
  {
    for (vtkIdType cell = 0; cell < this->Grid->GetNumberOfCells(); ++cell)
    {
      if (!this->Add(cell))
      {
        return false;
      }
    }
    if (this->Wholes.Count() > 1)
    {
      this->JoinCoincident();
    }
    return true;
  }

  void Store(vtkUnsignedCharArray* divisions)
  {
    std::vector<int> flips(this->Wholes.Count(), -1); // of each whole: its first point becomes even
    for (std::size_t point = 0; point < this->PartOf.size(); ++point)
    {
      if (this->PartOf[point] >= 0)
      {
        const auto color = this->ColorOf(point);
        int& flip = flips[static_cast<std::size_t>(color.first)];
        flip = flip < 0 ? color.second : flip;
      }
    }
    divisions->SetNumberOfValues(this->Grid->GetNumberOfCells());
    for (vtkIdType cell = 0; cell < this->Grid->GetNumberOfCells(); ++cell)
    {
      vtkIdType size;
      const vtkIdType* points;
      this->Grid->GetCellPoints(cell, size, points);
      if (this->Grid->GetCellType(cell) == VTK_EMPTY_CELL)
      {
        divisions->SetValue(cell, 0);
        continue;
      }
      const auto color = this->ColorOf(static_cast<std::size_t>(points[0]));
      const int odd = color.second ^ flips[static_cast<std::size_t>(color.first)];
      divisions->SetValue(cell, static_cast<unsigned char>(3 + odd));
    }
  }

private:
  std::pair<std::int32_t, int> ColorOf(std::size_t point)
  {
    const auto whole = this->Wholes.Find(this->PartOf[point]);
    return { whole.first, whole.second ^ this->Odd[point] };
  }

  bool Add(vtkIdType cell)
  {
    static constexpr unsigned char oddVoxel[8] = { 0, 1, 1, 0, 1, 0, 0, 1 };
    static constexpr unsigned char oddHexahedron[8] = { 0, 1, 0, 1, 1, 0, 1, 0 };
    const int type = this->Grid->GetCellType(cell);
    if (type == VTK_EMPTY_CELL)
    {
      return true;
    }
    if (type != VTK_HEXAHEDRON && type != VTK_VOXEL)
    {
      return false;
    }
    const unsigned char* odd = type == VTK_VOXEL ? oddVoxel : oddHexahedron;
    vtkIdType size;
    const vtkIdType* points;
    this->Grid->GetCellPoints(cell, size, points);
    const vtkIdType* known = std::find_if(points, points + 8,
      [this](vtkIdType point) { return this->PartOf[static_cast<std::size_t>(point)] >= 0; });
    const bool isNew = known == points + 8;
    const std::size_t first = static_cast<std::size_t>(isNew ? points[0] : *known);
    const std::int32_t part = isNew ? this->Wholes.Add() : this->PartOf[first];
    const int base = isNew ? 0 : this->Odd[first] ^ odd[known - points];
    for (int i = 0; i < 8; ++i)
    {
      const std::size_t point = static_cast<std::size_t>(points[i]);
      const int color = base ^ odd[i];
      if (this->PartOf[point] < 0)
      {
        this->PartOf[point] = part;
        this->Odd[point] = static_cast<unsigned char>(color);
      }
      else if (this->PartOf[point] == part
          ? this->Odd[point] != color
          : !this->Wholes.Join(part, this->PartOf[point], color ^ this->Odd[point]))
      {
        return false;
      }
    }
    return true;
  }

  // Blocks that repeat their points: equal colours at equal places.
  void JoinCoincident()
  {
    using Place = std::array<double, 3>;
    std::vector<Place> places(this->PartOf.size());
    std::vector<std::size_t> order;
    for (std::size_t point = 0; point < places.size(); ++point)
    {
      this->Grid->GetPoint(static_cast<vtkIdType>(point), places[point].data());
      const Place& p = places[point];
      if (this->PartOf[point] >= 0 && std::isfinite(p[0] + p[1] + p[2]))
      {
        order.push_back(point);
      }
    }
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return std::tie(places[a], a) < std::tie(places[b], b);
    });
    for (std::size_t i = 1; i < order.size(); ++i)
    {
      const std::size_t a = order[i - 1], b = order[i];
      if (places[a] == places[b])
      {
        this->Wholes.Join(this->PartOf[a], this->PartOf[b], this->Odd[a] ^ this->Odd[b]);
      }
    }
  }

  vtkUnstructuredGrid* Grid;
  std::vector<std::int32_t> PartOf; // of each point; -1: it belongs to no cell
  std::vector<unsigned char> Odd;   // in its part
  Parts Wholes;
};
}

vtkSmartPointer<vtkUnsignedCharArray> chessboardDivision(vtkDataSet* data)
{
  auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
  if (!grid || grid->GetNumberOfCells() == 0 || grid->GetCellData()->HasArray(divisionName))
  {
    return nullptr;
  }
  Colors colors(grid);
  if (!colors.Find())
  {
    return nullptr;
  }
  auto divisions = vtkSmartPointer<vtkUnsignedCharArray>::New();
  divisions->SetName(divisionName);
  colors.Store(divisions);
  return divisions;
}

} // namespace nephoscope
