// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumetricCells.h"

#include "CellDecomposition.h"

#include "vtkAppendFilter.h"
#include "vtkBoundingBox.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkCommunicator.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRectilinearGrid.h"
#include "vtkTetra.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <tuple>
#include <vector>

namespace nephoscope
{
namespace
{
constexpr unsigned char skippedCells = vtkDataSetAttributes::DUPLICATECELL |
  vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::REFINEDCELL;

FaceList<int> facesOf(int cellType)
{
  switch (cellType)
  {
    case VTK_TETRA:
      return makeFaceList(tetrahedronFaceList);
    case VTK_HEXAHEDRON:
      return makeFaceList(hexahedronFaceList);
    case VTK_VOXEL:
      return makeFaceList(voxelFaceList);
    case VTK_WEDGE:
      return makeFaceList(wedgeFaceList);
    case VTK_PYRAMID:
      return makeFaceList(pyramidFaceList);
    default:
      return { nullptr, nullptr };
  }
}

/** Gives the tetrahedra of one cell after another. */
class TetrahedronSource
{
public:
  explicit TetrahedronSource(vtkDataSet* data)
    : Data(data)
    , CellGhosts(data->GetCellGhostArray())
    , PointGhosts(data->GetPointGhostArray())
  {
  }

  bool IsHidden(vtkIdType cell)
  {
    if (this->CellGhosts && (this->CellGhosts->GetValue(cell) & skippedCells))
    {
      return true;
    }
    if (!this->PointGhosts)
    {
      return false;
    }
    this->Data->GetCellPoints(cell, this->Ids);
    for (vtkIdType id : *this->Ids)
    {
      if (this->PointGhosts->GetValue(id) & vtkDataSetAttributes::HIDDENPOINT)
      {
        return true;
      }
    }
    return false;
  }

  template <typename Function>
  void Emit(vtkIdType cell, Function emit)
  {
    const int type = this->Data->GetCellType(cell);
    const FaceList<int> faces = facesOf(type);
    if (faces.Begin)
    {
      this->Data->GetCellPoints(cell, this->Ids);
      this->Cone(faces, this->Ids->GetPointer(0), emit);
    }
    else if (type == VTK_POLYHEDRON)
    {
      this->EmitPolyhedron(cell, emit);
    }
    else
    {
      this->EmitTriangulated(cell, emit);
    }
  }

private:
  template <typename Emit>
  void Cone(FaceList<int> faces, const vtkIdType* ids, Emit emit)
  {
    decomposeCell(
      faces, [&](int a, int b) { return this->Less(ids[a], ids[b]); },
      [&](const std::array<int, 4>& t) {
        emit(std::array<vtkIdType, 4>{ { ids[t[0]], ids[t[1]], ids[t[2]], ids[t[3]] } });
      });
  }

  template <typename Emit>
  void EmitPolyhedron(vtkIdType cell, Emit emit)
  {
    auto grid = vtkUnstructuredGrid::SafeDownCast(this->Data);
    if (!grid)
    {
      return;
    }
    grid->GetFaceStream(cell, this->Ids); // number of faces, then the face list
    const vtkIdType* stream = this->Ids->GetPointer(0);
    decomposeCell(
      FaceList<vtkIdType>{ stream + 1, stream + this->Ids->GetNumberOfIds() },
      [&](vtkIdType a, vtkIdType b) { return this->Less(a, b); }, emit);
  }

  template <typename Emit>
  void EmitTriangulated(vtkIdType cell, Emit emit)
  {
    this->Data->GetCell(cell, this->Cell);
    if (this->Cell->GetCellDimension() != 3 || !this->Cell->Triangulate(0, this->Ids, this->CellPoints))
    {
      return;
    }
    for (vtkIdType i = 0; i + 3 < this->Ids->GetNumberOfIds(); i += 4)
    {
      const vtkIdType* t = this->Ids->GetPointer(i);
      emit(std::array<vtkIdType, 4>{ { t[0], t[1], t[2], t[3] } });
    }
  }

  // The mapper's order of vertices: by coordinates, so that it does not depend on numbering, blocks or ranks.
  bool Less(vtkIdType a, vtkIdType b)
  {
    double p[3], q[3];
    this->Data->GetPoint(a, p);
    this->Data->GetPoint(b, q);
    return std::tie(p[0], p[1], p[2], a) < std::tie(q[0], q[1], q[2], b);
  }

  vtkDataSet* Data;
  vtkUnsignedCharArray* CellGhosts;
  vtkUnsignedCharArray* PointGhosts;
  vtkNew<vtkIdList> Ids;
  vtkNew<vtkPoints> CellPoints;
  vtkNew<vtkGenericCell> Cell;
};

bool mayHoldVolumes(vtkDataSet* data)
{
  return data && data->GetNumberOfCells() > 0 && !vtkPolyData::SafeDownCast(data);
}

double volumeOf(vtkDataSet* data, const std::array<vtkIdType, 4>& tetrahedron)
{
  double x[4][3];
  for (std::size_t i = 0; i < 4; ++i)
  {
    data->GetPoint(tetrahedron[i], x[i]);
  }
  const double volume = std::abs(vtkTetra::ComputeVolume(x[0], x[1], x[2], x[3]));
  return std::isfinite(volume) ? volume : 0.0;
}

double scalarAt(vtkDataArray* scalars, vtkIdType tuple)
{
  double sum = 0.0;
  const int components = scalars->GetNumberOfComponents();
  if (components == 1)
  {
    return scalars->GetComponent(tuple, 0);
  }
  for (int c = 0; c < components; ++c)
  {
    sum += scalars->GetComponent(tuple, c) * scalars->GetComponent(tuple, c);
  }
  return std::sqrt(sum);
}

/** Over one tetrahedron; 0 where a value is not finite, as such cells are not drawn. */
double meanScalar(
  vtkDataArray* scalars, bool onCells, vtkIdType cell, const std::array<vtkIdType, 4>& tetrahedron)
{
  if (!scalars)
  {
    return 0.0;
  }
  double mean = 0.0;
  for (vtkIdType point : tetrahedron)
  {
    mean += 0.25 * scalarAt(scalars, onCells ? cell : point);
  }
  return std::isfinite(mean) ? mean : 0.0;
}

void copyPoints(vtkDataSet* data, vtkUnstructuredGrid* grid)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(data->GetNumberOfPoints());
  double x[3];
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    data->GetPoint(i, x);
    points->SetPoint(i, x);
  }
  grid->SetPoints(points);
}
void copyCellData(vtkDataSet* data, vtkIdList* parents, vtkUnstructuredGrid* grid)
{
  vtkCellData* out = grid->GetCellData();
  out->CopyGlobalIdsOff(); // several tetrahedra have one parent
  out->CopyAllocate(data->GetCellData(), parents->GetNumberOfIds());
  for (vtkIdType i = 0; i < parents->GetNumberOfIds(); ++i)
  {
    out->CopyData(data->GetCellData(), parents->GetId(i), i);
  }
  out->RemoveArray(vtkDataSetAttributes::GhostArrayName());
}
} // namespace

bool isAxisAligned(vtkDataSet* data)
{
  return vtkRectilinearGrid::SafeDownCast(data) || vtkImageData::SafeDownCast(data);
}

vtkSmartPointer<vtkDataSet> volumetricPart(vtkDataObject* input)
{
  if (auto data = vtkDataSet::SafeDownCast(input))
  {
    if (!mayHoldVolumes(data))
    {
      return nullptr;
    }
    auto copy = vtkSmartPointer<vtkDataSet>::Take(data->NewInstance());
    copy->ShallowCopy(data);
    return copy;
  }
  auto composite = vtkCompositeDataSet::SafeDownCast(input);
  if (!composite)
  {
    return nullptr;
  }
  std::vector<vtkDataSet*> blocks;
  auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    auto block = vtkDataSet::SafeDownCast(iterator->GetCurrentDataObject());
    if (mayHoldVolumes(block))
    {
      blocks.push_back(block);
    }
  }
  if (blocks.size() < 2)
  {
    return blocks.empty() ? nullptr : volumetricPart(blocks.front());
  }
  vtkNew<vtkAppendFilter> append;
  for (vtkDataSet* block : blocks)
  {
    append->AddInputData(block);
  }
  append->Update();
  return vtkSmartPointer<vtkDataSet>(append->GetOutput());
}

vtkSmartPointer<vtkUnstructuredGrid> tetrahedralize(vtkDataSet* data)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  copyPoints(data, grid);
  grid->GetPointData()->ShallowCopy(data->GetPointData());
  grid->GetPointData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  grid->GetFieldData()->ShallowCopy(data->GetFieldData());

  const vtkIdType numberOfCells = data->GetNumberOfCells();
  TetrahedronSource source(data);
  vtkNew<vtkIdList> parents;
  parents->Allocate(6 * numberOfCells);
  grid->Allocate(6 * numberOfCells);
  for (vtkIdType cell = 0; cell < numberOfCells; ++cell)
  {
    if (!source.IsHidden(cell))
    {
      source.Emit(cell, [&](const std::array<vtkIdType, 4>& t) {
        grid->InsertNextCell(VTK_TETRA, 4, t.data());
        parents->InsertNextId(cell);
      });
    }
  }
  copyCellData(data, parents, grid);
  return grid;
}

CellMeasures measureCells(vtkDataSet* data, vtkDataArray* scalars, bool onCells)
{
  CellMeasures measures;
  const vtkIdType numberOfCells = data ? data->GetNumberOfCells() : 0;
  const vtkIdType stride = 1 + numberOfCells / 100000;
  vtkIdType shown = 0, sampled = 0;
  vtkBoundingBox box;
  double bounds[6];
  std::unique_ptr<TetrahedronSource> source(numberOfCells > 0 ? new TetrahedronSource(data) : nullptr);
  for (vtkIdType cell = 0; cell < numberOfCells; ++cell)
  {
    if (source->IsHidden(cell))
    {
      continue;
    }
    data->GetCellBounds(cell, bounds);
    box.AddBounds(bounds);
    if (shown++ % stride == 0)
    {
      ++sampled;
      source->Emit(cell, [&](const std::array<vtkIdType, 4>& t) {
        const double volume = volumeOf(data, t);
        measures.Volume += volume;
        measures.ScalarIntegral += volume * meanScalar(scalars, onCells, cell, t);
      });
    }
  }
  const double scale = sampled > 0 ? static_cast<double>(shown) / static_cast<double>(sampled) : 0.0;
  measures.Volume *= scale;
  measures.ScalarIntegral *= scale;
  if (box.IsValid())
  {
    box.GetBounds(measures.Bounds);
  }
  if (scalars && shown > 0)
  {
    scalars->GetFiniteRange(measures.ScalarRange, scalars->GetNumberOfComponents() > 1 ? -1 : 0);
  }
  return measures;
}

CellMeasures reduceOverRanks(const CellMeasures& mine)
{
  auto controller = vtkMultiProcessController::GetGlobalController();
  if (!controller || controller->GetNumberOfProcesses() == 1)
  {
    return mine;
  }
  CellMeasures all;
  const double sums[2] = { mine.Volume, mine.ScalarIntegral };
  double allSums[2];
  controller->AllReduce(sums, allSums, 2, vtkCommunicator::SUM_OP);
  all.Volume = allSums[0];
  all.ScalarIntegral = allSums[1];

  // Four intervals: three axes and the scalar. An empty one must not count.
  double low[4], high[4], lowest[4], highest[4];
  for (int i = 0; i < 4; ++i)
  {
    const double* interval = i < 3 ? mine.Bounds + 2 * i : mine.ScalarRange;
    const bool empty = interval[0] > interval[1];
    low[i] = empty ? VTK_DOUBLE_MAX : interval[0];
    high[i] = empty ? -VTK_DOUBLE_MAX : interval[1];
  }
  controller->AllReduce(low, lowest, 4, vtkCommunicator::MIN_OP);
  controller->AllReduce(high, highest, 4, vtkCommunicator::MAX_OP);
  for (int i = 0; i < 4; ++i)
  {
    double* interval = i < 3 ? all.Bounds + 2 * i : all.ScalarRange;
    interval[0] = lowest[i];
    interval[1] = highest[i];
  }
  return all;
}

double meanChord(const CellMeasures& measures)
{
  const double* b = measures.Bounds;
  const double size[3] = { b[1] - b[0], b[3] - b[2], b[5] - b[4] };
  const double surface = 2.0 * (size[0] * size[1] + size[1] * size[2] + size[2] * size[0]);
  return measures.Volume > 0.0 && surface > 0.0 ? measures.Volume / (0.25 * surface) : 0.0;
}

double meanRamp(const CellMeasures& measures)
{
  const double low = measures.ScalarRange[0];
  const double high = measures.ScalarRange[1];
  if (!(high > low) || measures.Volume <= 0.0)
  {
    return 0.5;
  }
  return std::min(std::max((measures.ScalarIntegral / measures.Volume - low) / (high - low), 0.0), 1.0);
}

} // namespace nephoscope
