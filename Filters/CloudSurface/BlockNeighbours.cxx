// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BlockNeighbours.h"

#include "DataSets.h"

#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"
#include "vtkUniformGridAMR.h"
#include "vtkUnsignedCharArray.h"
#if VTK_MODULE_ENABLE_VTK_FiltersParallelDIY2
#include "vtkGhostCellsGenerator.h"
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

namespace nephoscope
{
namespace
{
using Size = std::array<vtkIdType, 3>;

// In points.
Size SizeOf(vtkDataSet* grid)
{
  int size[3] = { 0, 0, 0 };
  if (auto* image = vtkImageData::SafeDownCast(grid))
  {
    image->GetDimensions(size);
  }
  else if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(grid))
  {
    rectilinear->GetDimensions(size);
  }
  else if (auto* structured = vtkStructuredGrid::SafeDownCast(grid))
  {
    structured->GetDimensions(size);
  }
  return { size[0], size[1], size[2] };
}

bool IsGhost(vtkUnsignedCharArray* ghosts, vtkIdType cell)
{
  return ghosts && (ghosts->GetValue(cell) & vtkDataSetAttributes::DUPLICATECELL);
}

bool HasGhosts(vtkDataSet* grid)
{
  vtkUnsignedCharArray* ghosts = grid->GetCellGhostArray();
  for (vtkIdType cell = 0; ghosts && cell < ghosts->GetNumberOfValues(); ++cell)
  {
    if (IsGhost(ghosts, cell))
    {
      return true;
    }
  }
  return false;
}

// Its indices. The cells of the grid itself are a box, so it has the least index along every axis.
Size FirstOwnCell(vtkDataSet* extended)
{
  vtkUnsignedCharArray* ghosts = extended->GetCellGhostArray();
  vtkIdType first = 0;
  while (first < extended->GetNumberOfCells() - 1 && IsGhost(ghosts, first))
  {
    ++first;
  }
  const Size size = SizeOf(extended);
  const vtkIdType cellsI = size[0] - 1;
  const vtkIdType cellsJ = size[1] - 1;
  return { first % cellsI, first / cellsI % cellsJ, first / (cellsI * cellsJ) };
}

// vtkGhostCellsGenerator of VTK 9.2 misses neighbours of rectilinear grids along their first two
// axes.
vtkSmartPointer<vtkDataSet> AsStructuredGrid(vtkRectilinearGrid* grid)
{
  auto structured = vtkSmartPointer<vtkStructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(grid->GetNumberOfPoints());
  for (vtkIdType id = 0; id < grid->GetNumberOfPoints(); ++id)
  {
    points->SetPoint(id, grid->GetPoint(id));
  }
  structured->SetExtent(grid->GetExtent());
  structured->SetPoints(points);
  return structured;
}

vtkSmartPointer<vtkDataSet> AsRectilinearGrid(vtkStructuredGrid* grid)
{
  auto rectilinear = vtkSmartPointer<vtkRectilinearGrid>::New();
  rectilinear->SetExtent(grid->GetExtent());
  const int* size = rectilinear->GetDimensions();
  const std::array<vtkIdType, 3> step = { 1, size[0], static_cast<vtkIdType>(size[0]) * size[1] };
  std::array<vtkNew<vtkDoubleArray>, 3> coordinates;
  for (int axis = 0; axis < 3; ++axis)
  {
    coordinates[axis]->SetNumberOfValues(size[axis]);
    for (int i = 0; i < size[axis]; ++i)
    {
      coordinates[axis]->SetValue(i, grid->GetPoint(i * step[axis])[axis]);
    }
  }
  rectilinear->SetXCoordinates(coordinates[0]);
  rectilinear->SetYCoordinates(coordinates[1]);
  rectilinear->SetZCoordinates(coordinates[2]);
  rectilinear->GetPointData()->ShallowCopy(grid->GetPointData());
  rectilinear->GetCellData()->ShallowCopy(grid->GetCellData());
  return rectilinear;
}

// Neighbours have the same point arrays: what is true of these words.
std::string ArraysOf(vtkDataSet* grid)
{
  std::string words;
  vtkPointData* data = grid->GetPointData();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = data->GetAbstractArray(i);
    words += std::string(array->GetName() ? array->GetName() : "") + '\n' + array->GetClassName() +
      '\n' + std::to_string(array->GetNumberOfComponents()) + '\n';
  }
  return words;
}

std::map<std::string, std::vector<vtkDataSet*>> GridsOf(vtkCompositeDataSet* group)
{
  std::map<std::string, std::vector<vtkDataSet*>> grids;
  for (vtkDataSet* grid : DataSetsOf(group))
  {
    if (IsStructured(grid))
    {
      grids[ArraysOf(grid)].push_back(grid);
    }
  }
  return grids;
}

void AddNumbers(vtkDataSetAttributes* data, const char* name, vtkIdType first, vtkIdType count)
{
  vtkNew<vtkIdTypeArray> numbers;
  numbers->SetName(name);
  numbers->SetNumberOfValues(count);
  std::iota(numbers->Begin(), numbers->End(), first);
  data->AddArray(numbers);
}

constexpr const char* sourceName = "Sources"; // of points and cells, counted through all grids

// vtkGhostCellsGenerator loses flags of hidden cells, and arrays that are not numbers. It gets only
// the geometry.
vtkSmartPointer<vtkPartitionedDataSet> ExtendGeometry(
  const std::vector<vtkDataSet*>& grids, int layers)
{
  vtkNew<vtkPartitionedDataSet> partitions;
  vtkIdType points = 0;
  vtkIdType cells = 0;
  for (std::size_t i = 0; i < grids.size(); ++i)
  {
    auto* rectilinear = vtkRectilinearGrid::SafeDownCast(grids[i]);
    auto grid = rectilinear ? AsStructuredGrid(rectilinear)
                            : vtkSmartPointer<vtkDataSet>::Take(grids[i]->NewInstance());
    if (!rectilinear)
    {
      grid->CopyStructure(grids[i]);
    }
    AddNumbers(grid->GetPointData(), sourceName, points, grid->GetNumberOfPoints());
    AddNumbers(grid->GetCellData(), sourceName, cells, grid->GetNumberOfCells());
    points += grid->GetNumberOfPoints();
    cells += grid->GetNumberOfCells();
    partitions->SetPartition(static_cast<unsigned int>(i), grid);
  }
#if VTK_MODULE_ENABLE_VTK_FiltersParallelDIY2
  vtkNew<vtkGhostCellsGenerator> generator;
  generator->SetController(nullptr); // the blocks of other ranks are theirs
  generator->SetInputData(partitions);
  generator->BuildIfRequiredOff();
  generator->SetNumberOfGhostLayers(layers);
  generator->Update();
  return vtkPartitionedDataSet::SafeDownCast(generator->GetOutputDataObject(0));
#else
  (void)layers;
  return partitions; // a VTK without that module: every grid stays alone
#endif
}

// vtkGhostCellsGenerator of VTK 9.2 ends the program if a grid is thinner than the requested
// layers.
int FewestCells(const std::vector<vtkDataSet*>& grids)
{
  vtkIdType fewest = std::numeric_limits<int>::max();
  for (vtkDataSet* grid : grids)
  {
    for (const vtkIdType points : SizeOf(grid))
    {
      fewest = std::min(fewest, points - 1);
    }
  }
  return static_cast<int>(fewest);
}

// first[i]: the number of the first point, or cell, of grid i, and last of all the count.
std::size_t GridOf(const std::vector<vtkIdType>& first, vtkIdType source)
{
  return static_cast<std::size_t>(
           std::upper_bound(first.begin(), first.end(), source) - first.begin()) -
    1;
}

bool AreWithin(vtkIdTypeArray* numbers, vtkIdType count)
{
  return numbers && std::all_of(numbers->Begin(), numbers->End(), [count](vtkIdType i) {
    return i >= 0 && i < count;
  });
}

// vtkGhostCellsGenerator leaves numbers unset where blocks overlap rather than abut: every point
// must be where its source is.
bool HasItsSources(const std::vector<vtkDataSet*>& grids, const std::vector<vtkIdType>& firstPoint,
  const std::vector<vtkIdType>& firstCell, vtkDataSet* extended)
{
  auto* points =
    vtkIdTypeArray::SafeDownCast(extended->GetPointData()->GetAbstractArray(sourceName));
  auto* cells = vtkIdTypeArray::SafeDownCast(extended->GetCellData()->GetAbstractArray(sourceName));
  if (!AreWithin(points, firstPoint.back()) || !AreWithin(cells, firstCell.back()))
  {
    return false;
  }
  const double tolerance = 1e-6 * extended->GetLength();
  for (vtkIdType id = 0; id < extended->GetNumberOfPoints(); ++id)
  {
    const std::size_t grid = GridOf(firstPoint, points->GetValue(id));
    std::array<double, 3> place = {};
    std::array<double, 3> source = {};
    extended->GetPoint(id, place.data());
    grids[grid]->GetPoint(points->GetValue(id) - firstPoint[grid], source.data());
    if (std::sqrt(vtkMath::Distance2BetweenPoints(place.data(), source.data())) > tolerance)
    {
      return false;
    }
  }
  return true;
}

// The volume spanned by the edges of a cell at its first corner, with its sign.
double SignedVolume(vtkDataSet* grid, const Size& size, const Size& cell)
{
  const vtkIdType corner = cell[0] + size[0] * (cell[1] + size[1] * cell[2]);
  const std::array<vtkIdType, 3> steps = { 1, size[0], size[0] * size[1] };
  std::array<double, 3> origin = {};
  grid->GetPoint(corner, origin.data());
  double edges[3][3];
  for (int axis = 0; axis < 3; ++axis)
  {
    grid->GetPoint(corner + steps[axis], edges[axis]);
    vtkMath::Subtract(edges[axis], origin.data(), edges[axis]);
  }
  return vtkMath::Determinant3x3(edges[0], edges[1], edges[2]);
}

// Where a grid overlaps its neighbour, the layers taken from that one turn back into the grid:
// cells of both orientations.
bool IsFolded(vtkDataSet* extended)
{
  const Size size = SizeOf(extended);
  double least = 0.0;
  double most = 0.0;
  for (vtkIdType k = 0; k < size[2] - 1; ++k)
  {
    for (vtkIdType j = 0; j < size[1] - 1; ++j)
    {
      for (vtkIdType i = 0; i < size[0] - 1; ++i)
      {
        const double volume = SignedVolume(extended, size, { i, j, k });
        least = std::min(least, volume);
        most = std::max(most, volume);
      }
    }
  }
  return std::min(-least, most) > 1e-9 * std::max(-least, most);
}

void CopyPointArrays(const std::vector<vtkDataSet*>& grids, const std::vector<vtkIdType>& first,
  std::size_t own, vtkDataSet* extended)
{
  auto* from = vtkIdTypeArray::SafeDownCast(extended->GetPointData()->GetAbstractArray(sourceName));
  vtkPointData* ownData = grids[own]->GetPointData();
  vtkNew<vtkPointData> data;
  data->CopyAllOn();
  data->CopyAllocate(
    ownData, from->GetNumberOfValues()); // arrays in their order, and what is active
  for (int a = 0; a < ownData->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* to = data->GetAbstractArray(a);
    to->SetNumberOfTuples(from->GetNumberOfValues());
    for (vtkIdType id = 0; id < from->GetNumberOfValues(); ++id)
    {
      const std::size_t grid = GridOf(first, from->GetValue(id));
      to->SetTuple(
        id, from->GetValue(id) - first[grid], grids[grid]->GetPointData()->GetAbstractArray(a));
    }
  }
  extended->GetPointData()->ShallowCopy(data);
}

void CopyCellFlags(
  const std::vector<vtkDataSet*>& grids, const std::vector<vtkIdType>& first, vtkDataSet* extended)
{
  auto* from = vtkIdTypeArray::SafeDownCast(extended->GetCellData()->GetAbstractArray(sourceName));
  vtkUnsignedCharArray* flags = extended->GetCellGhostArray();
  for (vtkIdType id = 0; id < from->GetNumberOfValues(); ++id)
  {
    const std::size_t grid = GridOf(first, from->GetValue(id));
    if (vtkUnsignedCharArray* its = grids[grid]->GetCellGhostArray())
    {
      flags->SetValue(id, flags->GetValue(id) | its->GetValue(from->GetValue(id) - first[grid]));
    }
  }
  extended->GetCellData()->RemoveArray(sourceName);
}
}

void BlockNeighbours::Find(vtkDataObject* group, int layers)
{
  this->Found.clear();
  auto* composite = vtkCompositeDataSet::SafeDownCast(group);
  if (!composite || layers <= 0 || vtkUniformGridAMR::SafeDownCast(group))
  {
    return;
  }
  for (const auto& grids : GridsOf(composite))
  {
    const bool extendedAlready = std::any_of(grids.second.begin(), grids.second.end(), HasGhosts);
    if (grids.second.size() > 1 && !extendedAlready)
    {
      this->FindAmong(grids.second, layers);
    }
  }
}

void BlockNeighbours::FindAmong(const std::vector<vtkDataSet*>& grids, int layers)
{
  std::vector<vtkIdType> firstPoint = { 0 };
  std::vector<vtkIdType> firstCell = { 0 };
  for (vtkDataSet* grid : grids)
  {
    firstPoint.push_back(firstPoint.back() + grid->GetNumberOfPoints());
    firstCell.push_back(firstCell.back() + grid->GetNumberOfCells());
  }
  const auto partitions = ExtendGeometry(grids, std::min(layers, FewestCells(grids)));
  for (std::size_t i = 0; i < grids.size(); ++i)
  {
    vtkSmartPointer<vtkDataSet> extended = partitions->GetPartition(static_cast<unsigned int>(i));
    if (!extended || extended->GetNumberOfPoints() == grids[i]->GetNumberOfPoints() ||
      !HasItsSources(grids, firstPoint, firstCell, extended) || IsFolded(extended))
    {
      continue;
    }
    CopyPointArrays(grids, firstPoint, i, extended);
    CopyCellFlags(grids, firstCell, extended);
    this->Found[grids[i]] = vtkRectilinearGrid::SafeDownCast(grids[i])
      ? AsRectilinearGrid(vtkStructuredGrid::SafeDownCast(extended))
      : extended;
  }
}

vtkDataSet* BlockNeighbours::Extended(vtkDataSet* grid) const
{
  const auto found = this->Found.find(grid);
  return found == this->Found.end() ? grid : found->second.Get();
}

vtkSmartPointer<vtkDataArray> WithoutGhosts(
  vtkDataSet* grid, vtkDataSet* extended, vtkDataArray* array)
{
  if (grid == extended)
  {
    return array;
  }
  const Size own = SizeOf(grid);
  const Size whole = SizeOf(extended);
  const Size first = FirstOwnCell(extended);
  auto part = vtkSmartPointer<vtkDataArray>::Take(array->NewInstance());
  part->SetName(array->GetName());
  part->SetNumberOfComponents(array->GetNumberOfComponents());
  part->CopyComponentNames(array);
  part->SetNumberOfTuples(grid->GetNumberOfPoints());
  vtkIdType to = 0;
  for (vtkIdType k = 0; k < own[2]; ++k)
  {
    for (vtkIdType j = 0; j < own[1]; ++j)
    {
      for (vtkIdType i = 0; i < own[0]; ++i)
      {
        part->SetTuple(
          to++, first[0] + i + whole[0] * (first[1] + j + whole[1] * (first[2] + k)), array);
      }
    }
  }
  return part;
}
}
