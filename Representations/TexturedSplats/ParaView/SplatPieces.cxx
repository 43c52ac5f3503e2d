// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SplatPieces.h"

#include "DataBlocks.h"
#include "RankMeasures.h"
#include "SplatBorders.h"
#include "SplatGridSeam.h"
#include "SplatOwners.h"
#include "SplatSamples.h"

#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCommunicator.h"
#include "vtkDataSet.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiProcessController.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <vector>

namespace nephoscope
{
namespace
{
// Points of the pole of a globe are in one place, and yet are several samples: their indices tell.
std::vector<bool> OwnedByExtent(
  vtkDataSet* data, const std::vector<vtkIdType>& ids, const std::vector<int>& extents)
{
  const int rank = vtkMultiProcessController::GetGlobalController()->GetLocalProcessId();
  std::vector<bool> owned(ids.size());
  int mine[6];
  if (ids.empty() || !ExtentOf(data, mine))
  {
    return owned;
  }
  const vtkIdType size[2] = { mine[1] - mine[0] + 1, mine[3] - mine[2] + 1 };
  for (std::size_t n = 0; n < ids.size(); ++n)
  {
    const int i = mine[0] + static_cast<int>(ids[n] % size[0]);
    const int j = mine[2] + static_cast<int>(ids[n] / size[0] % size[1]);
    const int k = mine[4] + static_cast<int>(ids[n] / size[0] / size[1]);
    owned[n] = OwnerOfPoint(extents, i, j, k) == rank;
  }
  return owned;
}

// Then cells that several ranks have are marked. Some sources give cells of neighbours to a rank
// that asks for them, and do not mark them (trees of hyper tree grids). Collective.
bool AnyRankHasGhosts(vtkDataSet* data)
{
  const int mine = data->GetCellGhostArray() ? 1 : 0;
  int any = 0;
  vtkMultiProcessController::GetGlobalController()->AllReduce(
    &mine, &any, 1, vtkCommunicator::MAX_OP);
  return any != 0;
}

// Visible samples, each on one rank only.
vtkSmartPointer<vtkIdList> OwnIds(
  vtkDataSet* data, const SplatShapes& shapes, bool onCells, std::vector<SplatGridSeam>& seams)
{
  std::vector<vtkIdType> ids;
  std::vector<Vector3> places;
  for (vtkIdType id = 0; id < shapes.GetNumberOfIds(); ++id)
  {
    const Vector3 place = shapes.Place(id);
    if (shapes.IsVisible(id) && std::isfinite(place[0] + place[1] + place[2]))
    {
      ids.push_back(id);
      places.push_back(place);
    }
  }
  std::vector<int> extents;
  const bool structured = FindExtentsOfRanks(data, extents);
  for (int axis = 0; axis < 3 && structured && !onCells; ++axis)
  {
    seams.emplace_back(data, extents, axis);
  }
  const bool apart = onCells && (structured || AnyRankHasGhosts(data));
  const std::vector<bool> owned = apart ? std::vector<bool>(ids.size(), true)
    : structured                        ? OwnedByExtent(data, ids, extents)
                                        : OwnedByThisRank(places);
  auto own = vtkSmartPointer<vtkIdList>::New();
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    const bool repeated = std::any_of(seams.begin(), seams.end(),
      [&](const SplatGridSeam& seam) { return seam.IsRepeated(ids[i]); });
    if (owned[i] && !repeated)
    {
      own->InsertNextId(ids[i]);
    }
  }
  return own;
}

double MeanSpacingOverRanks(const SplatShapes& shapes, vtkIdList* ids)
{
  const auto placeOf = [&](vtkIdType i, double* x) {
    const Vector3 place = shapes.Place(ids->GetId(i));
    std::copy(place.begin(), place.end(), x);
    return true; // all are finite
  };
  const MediumReduction over = ReductionOverRanks();
  const MediumBounds bounds = RobustBoundsOfPlaces(ids->GetNumberOfIds(), placeOf, over);
  double count = 0;
  for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
  {
    count += HoldsPlace(bounds, shapes.Place(ids->GetId(i)).data()) ? 1 : 0;
  }
  over.Sum(&count, 1);
  return count > 0 ? MeanSpacing(bounds.data(), static_cast<std::size_t>(count)) : 1.0;
}

// Without marks of ghosts. The arrays are those of cells: the view merges points in one place, not
// cells.
vtkSmartPointer<vtkDataSet> VerticesOf(
  const SplatShapes& shapes, vtkIdList* ids, vtkDataSetAttributes* arrays)
{
  const vtkIdType count = ids->GetNumberOfIds();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(count);
  auto vertices = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vertices->Allocate(count);
  vtkDataSetAttributes* copies = vertices->GetCellData();
  copies->CopyAllOn();
  copies->CopyAllocate(arrays, count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    points->SetPoint(i, shapes.Place(ids->GetId(i)).data());
    vertices->InsertNextCell(VTK_VERTEX, 1, &i);
    copies->CopyData(arrays, ids->GetId(i), i);
  }
  vertices->SetPoints(points);
  copies->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  return vertices;
}

// For a point of a grid on several ranks: not this rank's piece has the ends that count, but the
// whole grid.
double ShareOf(const SplatShapes& shapes, vtkIdType id, const std::vector<SplatGridSeam>& seams)
{
  if (seams.empty())
  {
    return shapes.Share(id);
  }
  double share = shapes.ShareInShown(id);
  for (const SplatGridSeam& seam : seams)
  {
    share *= seam.ShareInGrid(id);
  }
  return share;
}

vtkSmartPointer<vtkDataArray> ShapesOf(
  const SplatShapes& shapes, vtkIdList* ids, const std::vector<SplatGridSeam>& seams)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(splatShapeName);
  array->SetNumberOfComponents(10);
  array->SetNumberOfTuples(ids->GetNumberOfIds());
  for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
  {
    SplatMatrix jacobian = shapes.Jacobian(ids->GetId(i));
    for (const SplatGridSeam& seam : seams)
    {
      seam.MendEdge(ids->GetId(i), jacobian);
    }
    for (int c = 0; c < 9; ++c)
    {
      const auto at = static_cast<std::size_t>(c);
      array->SetTypedComponent(i, c, static_cast<float>(jacobian[at / 3][at % 3]));
    }
    array->SetTypedComponent(i, 9, static_cast<float>(ShareOf(shapes, ids->GetId(i), seams)));
  }
  return array;
}

// Bounds of the samples of all ranks. Collective.
vtkBoundingBox BoundsOverRanks(const SplatShapes& shapes, vtkIdList* ids)
{
  vtkBoundingBox mine, all;
  for (const vtkIdType id : *ids)
  {
    mine.AddPoint(shapes.Place(id).data());
  }
  vtkMultiProcessController::GetGlobalController()->AllReduce(mine, all);
  return all;
}

// Samples may lie in a plane. ParaView ends if it has to divide that along the axis across it: two
// points without cells give it an extent, not the same on both sides, so that no border between
// ranks lies in the plane. Collective.
void PadFlatBounds(vtkUnstructuredGrid* vertices, const SplatShapes& shapes, vtkIdList* ids)
{
  constexpr double flat = 1e-6, before = 1.0, after = 1.7;
  const vtkBoundingBox bounds = BoundsOverRanks(shapes, ids);
  if (ids->GetNumberOfIds() == 0)
  {
    return;
  }
  const double edge = LargestStretch(shapes.Jacobian(ids->GetId(0)));
  double low[3], high[3];
  bool padded = false;
  const Vector3 place = shapes.Place(ids->GetId(0));
  for (int axis = 0; axis < 3; ++axis)
  {
    const bool isFlat = bounds.GetLength(axis) <= flat * bounds.GetMaxLength();
    low[axis] = place[static_cast<std::size_t>(axis)] - (isFlat ? before * edge : 0.0);
    high[axis] = place[static_cast<std::size_t>(axis)] + (isFlat ? after * edge : 0.0);
    padded = padded || isFlat;
  }
  if (padded)
  {
    vertices->GetPoints()->InsertNextPoint(low);
    vertices->GetPoints()->InsertNextPoint(high);
  }
}
} // namespace

const char* const splatShapeName = "NephoscopeSplatShape";

vtkSmartPointer<vtkDataSet> SampledPart(vtkDataObject* input)
{
  return AppendedBlocks(
    input, [](vtkDataSet* data) { return data->GetNumberOfPoints() > 0; }, BorderPoints::Merged);
}

vtkSmartPointer<vtkDataSet> SplatVertices(vtkDataSet* piece, const SplatSampling& sampling)
{
  vtkNew<vtkPolyData> nothing; // a rank without data takes part all the same
  const vtkSmartPointer<vtkDataSet> flagged = WithPointFlagsOfCells(piece ? piece : nothing.Get());
  vtkDataSet* data = flagged;
  const vtkSmartPointer<vtkDataSet> mesh = sampling.OnCells ? nullptr : WithCellsOfOtherRanks(data);
  SplatSampling ofAll = sampling;
  ofAll.Mesh = mesh;
  const SplatShapes own(data, ofAll);
  std::vector<SplatGridSeam> seams;
  vtkSmartPointer<vtkIdList> ids = OwnIds(data, own, sampling.OnCells, seams);
  const double spacing = MeanSpacingOverRanks(own, ids); // of all ranks, not of this one
  ofAll.CellSize = spacing;
  const SplatShapes shapes = own.HaveMeanSpacing() ? SplatShapes(data, ofAll) : own;
  vtkSmartPointer<vtkDataSet> vertices = VerticesOf(shapes, ids,
    data->GetAttributes(sampling.OnCells ? vtkDataObject::CELL : vtkDataObject::POINT));
  vertices->GetCellData()->AddArray(ShapesOf(shapes, ids, seams));
  vertices->GetFieldData()->ShallowCopy(data->GetFieldData());
  PadFlatBounds(vtkUnstructuredGrid::SafeDownCast(vertices), shapes, ids);
  return vertices;
}

vtkSmartPointer<vtkDataSet> WithShapesOfCells(vtkDataSet* piece, const SplatSampling& sampling)
{
  if (!piece)
  {
    return nullptr;
  }
  const SplatShapes shapes(piece, sampling);
  if (!shapes.AreOfCells())
  {
    return piece;
  }
  vtkNew<vtkIdList> ids;
  ids->SetNumberOfIds(shapes.GetNumberOfIds());
  std::iota(ids->begin(), ids->end(), 0);
  const vtkSmartPointer<vtkDataArray> array = ShapesOf(shapes, ids, {});
  for (const vtkIdType id : *ids)
  {
    if (!shapes.IsVisible(id))
    {
      array->SetComponent(id, 9, 0.0);
    }
  }
  auto copy = vtk::TakeSmartPointer(piece->NewInstance());
  copy->ShallowCopy(piece);
  copy->GetAttributes(sampling.OnCells ? vtkDataObject::CELL : vtkDataObject::POINT)
    ->AddArray(array);
  return copy;
}

void MoveShapes(vtkDataSet* vertices, vtkMatrix4x4* matrix)
{
  auto* old = vtkFloatArray::SafeDownCast(vertices->GetCellData()->GetArray(splatShapeName));
  if (!old)
  {
    return;
  }
  vtkNew<vtkFloatArray> shapes;
  shapes->DeepCopy(old);
  for (vtkIdType i = 0; i < shapes->GetNumberOfTuples(); ++i)
  {
    for (int column = 0; column < 3; ++column)
    {
      for (int row = 0; row < 3; ++row)
      {
        double sum = 0;
        for (int k = 0; k < 3; ++k)
        {
          sum += matrix->GetElement(row, k) * old->GetTypedComponent(i, 3 * column + k);
        }
        shapes->SetTypedComponent(i, 3 * column + row, static_cast<float>(sum));
      }
    }
  }
  vertices->GetCellData()->AddArray(shapes);
}

vtkSmartPointer<vtkDataSet> ChosenVertices(vtkDataSet* vertices, vtkIdList* ids)
{
  auto chosen = VerticesOf(SplatShapes(vertices, { true, 1.0 }), ids, vertices->GetCellData());
  chosen->GetFieldData()->ShallowCopy(vertices->GetFieldData());
  return chosen;
}

} // namespace nephoscope
