// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "IndexSpaceContour.h"

#include "vtkBitArray.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFlyingEdges3D.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkStructuredGrid.h"

namespace nephoscope
{
namespace
{
const char* const fieldName = "field";
const char* const positionsName = "positions";

// The points of the image, as ids of the grid; empty if they are all of them, in the same order.
std::vector<vtkIdType> SourcesOf(const SmoothingPlan& plan, const std::array<int, 6>& cells)
{
  const GridTopology& t = plan.Topology();
  bool whole = true;
  for (int axis = 0; axis < 3; ++axis)
  {
    whole = whole && cells[2 * axis] == 0 && cells[2 * axis + 1] + 2 == t.Size[axis];
  }
  std::vector<vtkIdType> sources;
  for (int k = cells[4]; !whole && k <= cells[5] + 1; ++k)
  {
    for (int j = cells[2]; j <= cells[3] + 1; ++j)
    {
      for (int i = cells[0]; i <= cells[1] + 1; ++i)
      {
        const GridIndex at = { { i, j, k } };
        GridIndex stored = at;
        for (int axis = 0; axis < 3; ++axis)
        {
          stored[axis] = at[axis] < t.Size[axis] ? at[axis] : 0;
        }
        sources.push_back(static_cast<vtkIdType>(t.Id(stored)));
      }
    }
  }
  return sources;
}

// The array at the points of the image; shared with the grid where it can be.
vtkSmartPointer<vtkDataArray> AtSources(
  vtkDataArray* array, const std::vector<vtkIdType>& sources, const std::string& name)
{
  auto copy = vtkSmartPointer<vtkDataArray>::Take(array->NewInstance());
  if (sources.empty())
  {
    copy->ShallowCopy(array);
  }
  else
  {
    copy->SetNumberOfComponents(array->GetNumberOfComponents());
    copy->SetNumberOfTuples(static_cast<vtkIdType>(sources.size()));
    vtkSMPTools::For(0, copy->GetNumberOfTuples(), [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType i = begin; i < end; ++i)
      {
        copy->SetTuple(i, sources[i], array);
      }
    });
  }
  copy->SetName(name.c_str()); // names of the user may be missing, or the same
  return copy;
}

vtkSmartPointer<vtkDataArray> PositionsOf(vtkDataSet* grid, const std::vector<vtkIdType>& sources)
{
  if (auto* structured = vtkStructuredGrid::SafeDownCast(grid))
  {
    return AtSources(structured->GetPoints()->GetData(), sources, positionsName);
  }
  auto positions = vtkSmartPointer<vtkDoubleArray>::New();
  positions->SetName(positionsName);
  positions->SetNumberOfComponents(3);
  positions->SetNumberOfTuples(
    sources.empty() ? grid->GetNumberOfPoints() : static_cast<vtkIdType>(sources.size()));
  double* to = positions->GetPointer(0);
  vtkSMPTools::For(0, positions->GetNumberOfTuples(), [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end; ++i)
    {
      grid->GetPoint(sources.empty() ? i : sources[i], to + 3 * i);
    }
  });
  return positions;
}

vtkSmartPointer<vtkDataArray> FieldOf(
  const std::vector<double>& field, const std::vector<vtkIdType>& sources)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(fieldName);
  array->SetNumberOfTuples(static_cast<vtkIdType>(sources.empty() ? field.size() : sources.size()));
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    array->SetValue(i, field[sources.empty() ? i : sources[i]]);
  }
  return array;
}

// Numbers that may be blended. Ids and ghost flags are not, and bits have no value between.
bool CanInterpolate(vtkDataSetAttributes* data, int index)
{
  vtkDataArray* array = data->GetArray(index);
  const int attribute = data->IsArrayAnAttribute(index);
  const std::string name = array && array->GetName() ? array->GetName() : "";
  return array && !vtkBitArray::SafeDownCast(array) &&
    attribute != vtkDataSetAttributes::GLOBALIDS &&
    attribute != vtkDataSetAttributes::PEDIGREEIDS &&
    name != vtkDataSetAttributes::GhostArrayName();
}
}

int CellsAlong(const SmoothingPlan& plan, int axis)
{
  const GridTopology& t = plan.Topology();
  return t.Size[axis] - 1 + (plan.ClosesInSpace(axis) && !t.Repeated[axis] ? 1 : 0);
}

IndexSpaceSurface ContourInIndexSpace(vtkDataSet* grid, const SmoothingPlan& plan,
  const std::vector<double>& field, const std::array<int, 6>& cells,
  const std::vector<double>& values, int skip)
{
  const std::vector<vtkIdType> sources = SourcesOf(plan, cells);
  vtkNew<vtkImageData> image;
  image->SetExtent(cells[0], cells[1] + 1, cells[2], cells[3] + 1, cells[4], cells[5] + 1);
  image->GetPointData()->AddArray(FieldOf(field, sources));
  image->GetPointData()->SetActiveScalars(fieldName);
  image->GetPointData()->AddArray(PositionsOf(grid, sources));
  std::vector<int> carried;
  for (int a = 0; a < grid->GetPointData()->GetNumberOfArrays(); ++a)
  {
    if (a != skip && CanInterpolate(grid->GetPointData(), a) &&
      grid->GetPointData()->GetArray(a)->GetNumberOfTuples() == grid->GetNumberOfPoints())
    {
      image->GetPointData()->AddArray(
        AtSources(grid->GetPointData()->GetArray(a), sources, "array " + std::to_string(a)));
      carried.push_back(a);
    }
  }
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(image);
  contour->SetNumberOfContours(static_cast<int>(values.size()));
  for (std::size_t v = 0; v < values.size(); ++v)
  {
    contour->SetValue(static_cast<int>(v), values[v]);
  }
  contour->ComputeNormalsOff();
  contour->ComputeGradientsOff();
  contour->ComputeScalarsOn();
  contour->InterpolateAttributesOn();
  contour->Update();
  IndexSpaceSurface result;
  result.Surface = contour->GetOutput();
  vtkPointData* made = result.Surface->GetPointData();
  result.Positions = made->GetArray(positionsName);
  result.Values = made->GetArray(fieldName);
  for (int a : carried)
  {
    result.Arrays.push_back({ a, made->GetArray(("array " + std::to_string(a)).c_str()) });
  }
  return result;
}
}
