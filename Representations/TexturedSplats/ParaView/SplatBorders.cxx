// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SplatBorders.h"

#include "DataSets.h"
#include "RankExchange.h"
#include "SplatOwners.h"

#include "vtkCellType.h"
#include "vtkCommunicator.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace nephoscope
{
namespace
{
using Flags = std::vector<unsigned char>;

vtkMultiProcessController* AllRanks()
{
  return vtkMultiProcessController::GetGlobalController();
}

// Particles, each in a cell of its own, are none.
bool IsMesh(vtkDataSet* piece)
{
  int extent[6];
  return !HasOnlyVertices(piece) && !ExtentOf(piece, extent);
}

bool IsMeshOnAnyRank(vtkDataSet* piece)
{
  const int mine = IsMesh(piece) ? 1 : 0;
  int any = 0;
  AllRanks()->AllReduce(&mine, &any, 1, vtkCommunicator::MAX_OP);
  return any != 0;
}

// Its points or, for a polyhedron, its faces: what vtkUnstructuredGrid::InsertNextCell takes.
void DescribeCell(vtkDataSet* data, vtkIdType cell, vtkIdList* ids)
{
  auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
  if (grid && data->GetCellType(cell) == VTK_POLYHEDRON)
  {
    grid->GetFaceStream(cell, ids);
  }
  else
  {
    data->GetCellPoints(cell, ids);
  }
}

// Calls visit(id) for the points in the description of a cell, which may change them.
template <typename Visit>
void ForEachPoint(int type, vtkIdType* ids, vtkIdType count, const Visit& visit)
{
  if (type != VTK_POLYHEDRON)
  {
    std::for_each(ids, ids + count, visit);
    return;
  }
  for (vtkIdType at = 1; at < count; at += ids[at] + 1)
  {
    std::for_each(ids + at + 1, ids + at + 1 + ids[at], visit);
  }
}

// Cells on their way between ranks, by rank: type, length and description of each, and the places
// of their points.
struct Parcels
{
  std::vector<std::vector<vtkIdType>> Cells;
  std::vector<std::vector<double>> Places;
};

class BorderMesh
{
public:
  explicit BorderMesh(vtkDataSet* piece)
    : Piece(piece)
    , Grid(vtkSmartPointer<vtkUnstructuredGrid>::New())
  {
    this->Points->SetDataTypeToDouble();
    this->Points->SetNumberOfPoints(piece->GetNumberOfPoints());
    for (vtkIdType id = 0; id < piece->GetNumberOfPoints(); ++id)
    {
      this->Points->SetPoint(id, piece->GetPoint(id));
    }
    this->Grid->Allocate(piece->GetNumberOfCells());
    this->Grid->SetPoints(this->Points);
    this->AddOwnCells();
  }

  // For each rank the cells near the points that it has too.
  Parcels PackForRanks()
  {
    std::vector<vtkIdType> ids;
    std::vector<Vector3> places;
    for (vtkIdType id = 0; id < this->Piece->GetNumberOfPoints(); ++id)
    {
      const double* x = this->Points->GetPoint(id);
      if (this->HasOwnCell[static_cast<std::size_t>(id)] && std::isfinite(x[0] + x[1] + x[2]))
      {
        ids.push_back(id);
        places.push_back({ { x[0], x[1], x[2] } });
      }
    }
    std::vector<Flags> near(static_cast<std::size_t>(AllRanks()->GetNumberOfProcesses()));
    for (const SharedPlace& shared : PlacesOfSeveralRanks(places))
    {
      Flags& flags = near[static_cast<std::size_t>(shared.Rank)];
      flags.resize(this->HasOwnCell.size(), 0);
      flags[static_cast<std::size_t>(ids[shared.Index])] = 1;
    }
    Parcels parcels;
    parcels.Cells.resize(near.size());
    parcels.Places.resize(near.size());
    for (std::size_t rank = 0; rank < near.size(); ++rank)
    {
      if (!near[rank].empty())
      {
        this->Pack(near[rank], parcels.Cells[rank], parcels.Places[rank]);
      }
    }
    return parcels;
  }

  void Add(std::vector<vtkIdType>& cells, const std::vector<double>& places)
  {
    const vtkIdType first = this->Points->GetNumberOfPoints();
    for (std::size_t i = 0; i < places.size(); i += 3)
    {
      this->Points->InsertNextPoint(&places[i]);
    }
    for (std::size_t at = 0; at < cells.size();)
    {
      const auto type = static_cast<int>(cells[at]);
      const vtkIdType count = cells[at + 1];
      vtkIdType* ids = &cells[at + 2];
      ForEachPoint(type, ids, count, [&](vtkIdType& id) { id += first; });
      this->Insert(type, ids, count);
      at += 2 + static_cast<std::size_t>(count);
    }
  }

  vtkSmartPointer<vtkDataSet> GetGrid() const { return this->Grid; }

private:
  // Shown, and not of a layer from other ranks.
  bool IsOwn(vtkIdType cell) const
  {
    vtkUnsignedCharArray* ghosts = this->Piece->GetCellGhostArray();
    constexpr int others = vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::REFINEDCELL |
      vtkDataSetAttributes::DUPLICATECELL;
    return !ghosts || (ghosts->GetValue(cell) & others) == 0;
  }

  void AddOwnCells()
  {
    this->HasOwnCell.assign(static_cast<std::size_t>(this->Piece->GetNumberOfPoints()), 0);
    vtkNew<vtkIdList> ids;
    for (vtkIdType cell = 0; cell < this->Piece->GetNumberOfCells(); ++cell)
    {
      if (this->IsOwn(cell))
      {
        const int type = this->Piece->GetCellType(cell);
        DescribeCell(this->Piece, cell, ids);
        ForEachPoint(type, ids->GetPointer(0), ids->GetNumberOfIds(),
          [&](vtkIdType id) { this->HasOwnCell[static_cast<std::size_t>(id)] = 1; });
        this->Insert(type, ids->GetPointer(0), ids->GetNumberOfIds());
      }
    }
    this->NumberOfOwnCells = this->Grid->GetNumberOfCells();
  }

  void Insert(int type, vtkIdType* ids, vtkIdType count)
  {
    if (type == VTK_POLYHEDRON)
    {
      vtkNew<vtkIdList> faces;
      faces->SetNumberOfIds(count);
      std::copy_n(ids, count, faces->GetPointer(0));
      this->Grid->InsertNextCell(type, faces);
    }
    else
    {
      this->Grid->InsertNextCell(type, count, ids);
    }
  }

  // `near`: flags of points, to which those of their cells are added, layer by layer.
  void Pack(Flags& near, std::vector<vtkIdType>& cells, std::vector<double>& places) const
  {
    constexpr int layers = 3;
    Flags taken(static_cast<std::size_t>(this->NumberOfOwnCells), 0);
    vtkNew<vtkIdList> ids;
    for (int layer = 0; layer < layers; ++layer)
    {
      Flags next = near;
      for (vtkIdType cell = 0; cell < this->NumberOfOwnCells; ++cell)
      {
        this->Grid->GetCellPoints(cell, ids);
        const bool touches = std::any_of(ids->begin(), ids->end(),
          [&](vtkIdType id) { return near[static_cast<std::size_t>(id)] != 0; });
        taken[static_cast<std::size_t>(cell)] |= static_cast<unsigned char>(touches);
        for (vtkIdType i = 0; i < ids->GetNumberOfIds() && touches; ++i)
        {
          next[static_cast<std::size_t>(ids->GetId(i))] = 1;
        }
      }
      near.swap(next);
    }
    this->PackCells(taken, cells, places);
  }

  void PackCells(
    const Flags& taken, std::vector<vtkIdType>& cells, std::vector<double>& places) const
  {
    std::map<vtkIdType, vtkIdType> numbers; // of the points, in the parcel
    vtkNew<vtkIdList> ids;
    for (vtkIdType cell = 0; cell < this->NumberOfOwnCells; ++cell)
    {
      if (!taken[static_cast<std::size_t>(cell)])
      {
        continue;
      }
      const int type = this->Grid->GetCellType(cell);
      DescribeCell(this->Grid, cell, ids);
      ForEachPoint(type, ids->GetPointer(0), ids->GetNumberOfIds(), [&](vtkIdType& id) {
        const auto found = numbers.emplace(id, static_cast<vtkIdType>(numbers.size()));
        if (found.second)
        {
          const double* x = this->Points->GetPoint(id);
          places.insert(places.end(), x, x + 3);
        }
        id = found.first->second;
      });
      cells.push_back(type);
      cells.push_back(ids->GetNumberOfIds());
      cells.insert(cells.end(), ids->begin(), ids->end());
    }
  }

  vtkDataSet* Piece;
  vtkSmartPointer<vtkUnstructuredGrid> Grid;
  vtkNew<vtkPoints> Points;
  Flags HasOwnCell; // points
  vtkIdType NumberOfOwnCells = 0;
};
} // namespace

vtkSmartPointer<vtkDataSet> WithCellsOfOtherRanks(vtkDataSet* piece)
{
  if (!IsMeshOnAnyRank(piece))
  {
    return nullptr;
  }
  BorderMesh mesh(piece);
  const Parcels parcels = mesh.PackForRanks();
  auto cells = TradeRecords(AllRanks(), parcels.Cells);
  const auto places = TradeRecords(AllRanks(), parcels.Places);
  for (std::size_t rank = 0; rank < cells.size(); ++rank)
  {
    mesh.Add(cells[rank], places[rank]);
  }
  return mesh.GetGrid();
}

} // namespace nephoscope
