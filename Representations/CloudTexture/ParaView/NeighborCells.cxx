// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "NeighborCells.h"

#include "DataSets.h"

#include "vtkCellType.h"
#include "vtkCommunicator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkGenericCell.h"
#include "vtkGhostCellsGenerator.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

namespace nephoscope
{
namespace
{
// By their place in a composite dataset, which is the same on all ranks; 0 for data that are not
// composite.
using Grids = std::map<int, vtkSmartPointer<vtkUnstructuredGrid>>;

Grids GridsOf(vtkDataObject* input)
{
  Grids grids;
  auto* composite = vtkCompositeDataSet::SafeDownCast(input);
  if (!composite)
  {
    if (auto* grid = vtkUnstructuredGrid::SafeDownCast(input))
    {
      grids[0] = grid;
    }
    return grids;
  }
  auto leaves = vtk::TakeSmartPointer(composite->NewIterator());
  for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
  {
    if (auto* grid = vtkUnstructuredGrid::SafeDownCast(leaves->GetCurrentDataObject()))
    {
      grids[static_cast<int>(leaves->GetCurrentFlatIndex())] = grid;
    }
  }
  return grids;
}

bool HasDuplicates(vtkDataSet* data)
{
  vtkUnsignedCharArray* flags = data->GetCellGhostArray();
  const unsigned char* begin = flags ? flags->GetPointer(0) : nullptr;
  return flags && std::any_of(begin, begin + flags->GetNumberOfValues(), [](unsigned char flag) {
    return (flag & vtkDataSetAttributes::DUPLICATECELL) != 0;
  });
}

// Those that lack the cells of other ranks. Collective.
std::vector<int> PlacesWithoutNeighbors(vtkMultiProcessController* controller, const Grids& grids)
{
  const int mine = grids.empty() ? 0 : grids.rbegin()->first + 1;
  int places = 0;
  controller->AllReduce(&mine, &places, 1, vtkCommunicator::MAX_OP);
  // For each place: ranks with 3-D cells, and ranks with those of others.
  std::vector<int> here(2 * static_cast<std::size_t>(places) + 1, 0), all(here);
  for (const auto& [place, grid] : grids)
  {
    here[2 * static_cast<std::size_t>(place)] = HasVolumes(grid) ? 1 : 0;
    here[2 * static_cast<std::size_t>(place) + 1] = HasDuplicates(grid) ? 1 : 0;
  }
  controller->AllReduce(
    here.data(), all.data(), static_cast<vtkIdType>(here.size()), vtkCommunicator::SUM_OP);
  std::vector<int> lacking;
  for (int place = 0; place < places; ++place)
  {
    const auto at = 2 * static_cast<std::size_t>(place);
    if (all[at] > 1 && all[at + 1] == 0)
    {
      lacking.push_back(place);
    }
  }
  return lacking;
}

// Collective.
vtkSmartPointer<vtkUnstructuredGrid> Completed(vtkUnstructuredGrid* grid)
{
  vtkNew<vtkUnstructuredGrid> nothing;
  vtkNew<vtkGhostCellsGenerator> generator;
  generator->SetInputData(grid ? grid : nothing.Get());
  generator->BuildIfRequiredOff();
  generator->SetNumberOfGhostLayers(1);
  generator->Update();
  return vtkUnstructuredGrid::SafeDownCast(generator->GetOutputDataObject(0));
}

void ReplaceGrids(vtkCompositeDataSet* composite, const Grids& replacements)
{
  auto leaves = vtk::TakeSmartPointer(composite->NewIterator());
  for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
  {
    const auto found = replacements.find(static_cast<int>(leaves->GetCurrentFlatIndex()));
    if (found != replacements.end())
    {
      composite->SetDataSet(leaves, found->second);
    }
  }
}
} // namespace

bool HasVolumes(vtkDataSet* data)
{
  std::array<bool, VTK_NUMBER_OF_CELL_TYPES> seen{};
  vtkNew<vtkGenericCell> cell;
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
  {
    const int type = data->GetCellType(i);
    if (type >= 0 && type < VTK_NUMBER_OF_CELL_TYPES &&
      !std::exchange(seen[static_cast<std::size_t>(type)], true))
    {
      cell->SetCellType(type);
      if (cell->GetCellDimension() == 3)
      {
        return true;
      }
    }
  }
  return false;
}

vtkSmartPointer<vtkDataObject> WithNeighborCells(vtkDataObject* input)
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  if (!controller || controller->GetNumberOfProcesses() < 2)
  {
    return input;
  }
  const Grids grids = GridsOf(input);
  Grids replacements;
  for (const int place : PlacesWithoutNeighbors(controller, grids))
  {
    const auto found = grids.find(place);
    auto grid = Completed(found == grids.end() ? nullptr : found->second.Get());
    if (found != grids.end() && grid)
    {
      replacements[place] = grid;
    }
  }
  if (replacements.empty())
  {
    return input;
  }
  if (!vtkCompositeDataSet::SafeDownCast(input))
  {
    return replacements.begin()->second;
  }
  vtkSmartPointer<vtkDataObject> copy = SharedCopy(input);
  ReplaceGrids(vtkCompositeDataSet::SafeDownCast(copy), replacements);
  return copy;
}

} // namespace nephoscope
