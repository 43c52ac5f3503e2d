// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceAssembly.h"

#include "SurfaceNormals.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"

#include <map>
#include <tuple>

namespace nephoscope
{
namespace
{
// Places at a seam or a pole: which kind, and what is left of the index.
using PlaceKey = std::tuple<int, double, double, double>;

template <typename Function>
void InThreads(vtkIdType count, const Function& function)
{
  vtkSMPTools::For(0, count, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end; ++i)
    {
      function(i);
    }
  });
}
}

SurfaceAssembly::SurfaceAssembly(vtkDataSet* grid, const SmoothingPlan& plan,
  const IndexSpaceSurface& contour, const std::vector<unsigned char>& missing)
  : Grid(grid)
  , Plan(plan)
  , Contour(contour)
  , Missing(missing)
  , AnyHidden(grid->GetCellData()->HasArray(vtkDataSetAttributes::GhostArrayName()) ||
      std::find(missing.begin(), missing.end(), 1) != missing.end())
{
}

void SurfaceAssembly::Build(vtkDataArray* scalars, const std::vector<double>& values,
  const std::vector<int>& indices, vtkPolyData* output)
{
  this->FindJoinedPoints();
  this->KeepTriangles();
  this->NumberPoints();
  auto* pointSet = vtkPointSet::SafeDownCast(this->Grid);
  vtkNew<vtkPoints> points;
  points->SetDataType(pointSet ? pointSet->GetPoints()->GetDataType() : VTK_DOUBLE);
  points->SetNumberOfPoints(static_cast<vtkIdType>(this->Sources.size()));
  InThreads(points->GetNumberOfPoints(), [&](vtkIdType i) {
    double x[3];
    this->Contour.Positions->GetTuple(this->Sources[i], x);
    points->SetPoint(i, x);
  });
  output->SetPoints(points);
  this->CarryArrays(scalars, output);
  this->CarryAtPoles(output);
  this->CarryFromNearerPoint(output);
  this->AddContourIndex(values, indices, output);
}

// The last point of a ring coincides with the first, and all points of a row at a pole coincide.
// Keys are bits of the index, which is the same on both sides, since the field is.
void SurfaceAssembly::FindJoinedPoints()
{
  const GridTopology& t = this->Plan.Topology();
  std::map<PlaceKey, vtkIdType> places;
  const vtkIdType count = this->Contour.Surface->GetNumberOfPoints();
  this->Representative.resize(static_cast<std::size_t>(count));
  for (vtkIdType p = 0; p < count; ++p)
  {
    this->Representative[p] = p;
    double at[3];
    this->Contour.Surface->GetPoint(p, at);
    int kind = 0; // bits: axes of a seam; 8 more: a pole
    for (int axis = 0; axis < 3; ++axis)
    {
      if (this->Plan.ClosesInSpace(axis) && (at[axis] == 0.0 || at[axis] == t.Distinct(axis)))
      {
        kind |= 1 << axis;
        at[axis] = 0.0;
      }
    }
    for (const PoleRow& pole : t.Poles)
    {
      if (at[pole.Across] == (pole.AtEnd ? t.Size[pole.Across] - 1 : 0))
      {
        kind |= 8;
        at[pole.Along] = 0.0;
      }
    }
    if (this->Join && kind != 0 && std::isfinite(at[0] + at[1] + at[2]))
    {
      const PlaceKey key(kind & 8 ? 8 : kind, at[0], at[1], at[2]);
      const auto place = places.emplace(key, p).first;
      const bool sameValue = this->Contour.Values->GetComponent(place->second, 0) ==
        this->Contour.Values->GetComponent(p, 0);
      this->Representative[p] = sameValue ? place->second : p;
    }
  }
}

void SurfaceAssembly::KeepTriangles()
{
  auto cells = vtk::TakeSmartPointer(this->Contour.Surface->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType size;
    const vtkIdType* ids;
    cells->GetCurrentCell(size, ids);
    const vtkIdType a = this->Representative[ids[0]];
    const vtkIdType b = this->Representative[ids[1]];
    const vtkIdType c = this->Representative[ids[2]];
    if (a != b && b != c && c != a && this->IsVisible(ids))
    {
      this->Triangles.insert(this->Triangles.end(), { a, b, c });
    }
  }
}

// The cell that a triangle was made in, by the indices of its points. Where it lies in a face of
// two cells, one that is seen is enough.
bool SurfaceAssembly::IsVisible(const vtkIdType* triangle) const
{
  if (!this->AnyHidden)
  {
    return true;
  }
  double corners[3][3];
  for (int corner = 0; corner < 3; ++corner)
  {
    this->Contour.Surface->GetPoint(triangle[corner], corners[corner]);
    if (!std::isfinite(corners[corner][0] + corners[corner][1] + corners[corner][2]))
    {
      return false; // on an edge to a point without a value
    }
  }
  GridIndex low;
  GridIndex high;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double least = std::min({ corners[0][axis], corners[1][axis], corners[2][axis] });
    const double most = std::max({ corners[0][axis], corners[1][axis], corners[2][axis] });
    const int last = CellsAlong(this->Plan, axis) - 1;
    const bool onFace = least == most && least == std::floor(least);
    high[axis] = std::min(last, static_cast<int>(std::floor(least)));
    low[axis] =
      onFace ? std::max(0, high[axis] - (static_cast<int>(least) > last ? 0 : 1)) : high[axis];
  }
  GridIndex cell;
  for (cell[2] = low[2]; cell[2] <= high[2]; ++cell[2])
  {
    for (cell[1] = low[1]; cell[1] <= high[1]; ++cell[1])
    {
      for (cell[0] = low[0]; cell[0] <= high[0]; ++cell[0])
      {
        if (this->IsCellVisible(cell))
        {
          return true;
        }
      }
    }
  }
  return false;
}

bool SurfaceAssembly::IsCellVisible(const GridIndex& cell) const
{
  const GridTopology& t = this->Plan.Topology();
  for (int corner = 0; corner < 8; ++corner)
  {
    const GridIndex at = { { cell[0] + (corner & 1), cell[1] + (corner >> 1 & 1),
      cell[2] + (corner >> 2 & 1) } };
    if (this->Missing[t.Id(t.Canonical(at))])
    {
      return false;
    }
  }
  auto* ghosts = vtkUnsignedCharArray::SafeDownCast(
    this->Grid->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
  if (!ghosts || cell[0] >= t.Size[0] - 1 || cell[1] >= t.Size[1] - 1 || cell[2] >= t.Size[2] - 1)
  {
    return true;
  }
  const vtkIdType id = cell[0] +
    static_cast<vtkIdType>(t.Size[0] - 1) *
      (cell[1] + static_cast<vtkIdType>(t.Size[1] - 1) * cell[2]);
  return (ghosts->GetValue(id) &
           (vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::DUPLICATECELL)) == 0;
}

void SurfaceAssembly::NumberPoints()
{
  std::vector<vtkIdType> numbers(
    static_cast<std::size_t>(this->Contour.Surface->GetNumberOfPoints()), -1);
  for (vtkIdType point : this->Triangles)
  {
    numbers[point] = 0;
  }
  for (std::size_t p = 0; p < numbers.size(); ++p)
  {
    if (numbers[p] == 0)
    {
      numbers[p] = static_cast<vtkIdType>(this->Sources.size());
      this->Sources.push_back(static_cast<vtkIdType>(p));
    }
  }
  for (vtkIdType& point : this->Triangles)
  {
    point = numbers[point];
  }
}

void SurfaceAssembly::CarryArrays(vtkDataArray* scalars, vtkPolyData* output) const
{
  const auto count = static_cast<vtkIdType>(this->Sources.size());
  const auto add = [&](vtkDataArray* from, const char* name, int type, vtkDataArray* names) {
    auto to = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
    to->SetName(name);
    to->SetNumberOfComponents(from->GetNumberOfComponents());
    to->CopyComponentNames(names);
    to->SetNumberOfTuples(count);
    InThreads(count, [&](vtkIdType i) {
      for (int c = 0; c < from->GetNumberOfComponents(); ++c)
      {
        to->SetComponent(i, c, from->GetComponent(this->Sources[i], c));
      }
    });
    output->GetPointData()->AddArray(to);
  };
  vtkPointData* data = this->Grid->GetPointData();
  add(this->Contour.Values, scalars->GetName(),
    scalars->GetDataType() == VTK_FLOAT ? VTK_FLOAT : VTK_DOUBLE, scalars);
  output->GetPointData()->SetScalars(output->GetPointData()->GetArray(0));
  for (const auto& carried : this->Contour.Arrays)
  {
    vtkDataArray* from = data->GetArray(carried.Source);
    add(carried.Result, from->GetName(), carried.Result->GetDataType(), from);
    const int attribute = data->IsArrayAnAttribute(carried.Source);
    if (attribute >= 0 && attribute != vtkDataSetAttributes::SCALARS &&
      attribute != vtkDataSetAttributes::NORMALS)
    {
      output->GetPointData()->SetActiveAttribute(
        output->GetPointData()->GetNumberOfArrays() - 1, attribute);
    }
  }
}

// Arrays that jump along the row of a pole, such as longitudes, have the value of its first column,
// whichever columns a piece has.
void SurfaceAssembly::CarryAtPoles(vtkPolyData* output) const
{
  const GridTopology& t = this->Plan.Topology();
  for (std::size_t i = 0; this->Join && !t.Poles.empty() && i < this->Sources.size(); ++i)
  {
    GridIndex one;
    GridIndex two;
    double share;
    this->NearestEdge(this->Sources[i], one, two, share);
    const PoleRow* pole = t.PoleAt(one);
    if (!pole || pole != t.PoleAt(two))
    {
      continue;
    }
    one[pole->Along] = two[pole->Along] = 0;
    for (std::size_t a = 0; a < this->Contour.Arrays.size(); ++a)
    {
      vtkDataArray* from = this->Grid->GetPointData()->GetArray(this->Contour.Arrays[a].Source);
      vtkDataArray* to = output->GetPointData()->GetArray(static_cast<int>(a) + 1);
      for (int c = 0; c < from->GetNumberOfComponents(); ++c)
      {
        to->SetComponent(static_cast<vtkIdType>(i), c,
          (1 - share) * from->GetComponent(static_cast<vtkIdType>(t.Id(one)), c) +
            share * from->GetComponent(static_cast<vtkIdType>(t.Id(two)), c));
      }
    }
  }
}

// Text, bits and ids.
void SurfaceAssembly::CarryFromNearerPoint(vtkPolyData* output) const
{
  vtkPointData* data = this->Grid->GetPointData();
  const auto count = static_cast<vtkIdType>(this->Sources.size());
  for (int a = 0; a < data->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* from = data->GetAbstractArray(a);
    const bool carried = from->GetName() && output->GetPointData()->HasArray(from->GetName());
    const bool ghosts =
      from->GetName() && std::string(vtkDataSetAttributes::GhostArrayName()) == from->GetName();
    if (carried || ghosts || from->GetNumberOfTuples() != this->Grid->GetNumberOfPoints() ||
      (vtkDataArray::SafeDownCast(from) && !from->GetName()))
    {
      continue;
    }
    auto to = vtkSmartPointer<vtkAbstractArray>::Take(from->NewInstance());
    to->SetName(from->GetName());
    to->SetNumberOfComponents(from->GetNumberOfComponents());
    to->SetNumberOfTuples(count);
    for (vtkIdType i = 0; i < count; ++i) // bits share bytes: not in threads
    {
      GridIndex one;
      GridIndex two;
      double share;
      this->NearestEdge(this->Sources[i], one, two, share);
      to->SetTuple(
        i, static_cast<vtkIdType>(this->Plan.Topology().Id(share < 0.5 ? one : two)), from);
    }
    output->GetPointData()->AddArray(to);
  }
}

void SurfaceAssembly::AddContourIndex(
  const std::vector<double>& values, const std::vector<int>& indices, vtkPolyData* output) const
{
  vtkNew<vtkIntArray> index;
  index->SetName("ContourIndex");
  index->SetNumberOfTuples(static_cast<vtkIdType>(this->Triangles.size() / 3));
  for (vtkIdType t = 0; t < index->GetNumberOfTuples(); ++t)
  {
    const double value =
      this->Contour.Values->GetComponent(this->Sources[this->Triangles[3 * t]], 0);
    const auto found = std::lower_bound(values.begin(), values.end(), value);
    index->SetValue(t, indices[found - values.begin()]);
  }
  output->GetCellData()->AddArray(index);
}

// The two ends of the grid's edge that a contoured point lies on, as distinct indices; twice the
// same at a grid point.
void SurfaceAssembly::NearestEdge(vtkIdType point, GridIndex& a, GridIndex& b, double& share) const
{
  double at[3];
  this->Contour.Surface->GetPoint(point, at);
  share = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double below = std::floor(at[axis]);
    a[axis] = static_cast<int>(below);
    b[axis] = a[axis] + (at[axis] > below ? 1 : 0);
    share = std::max(share, at[axis] - below);
  }
  a = this->Plan.Topology().Canonical(a);
  b = this->Plan.Topology().Canonical(b);
}

void SurfaceAssembly::AddTriangles(
  const std::vector<double>& field, bool withNormals, vtkPolyData* output)
{
  const FieldGradient gradient(this->Plan, field, this->Missing);
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(static_cast<vtkIdType>(this->Sources.size()));
  InThreads(normals->GetNumberOfTuples(), [&](vtkIdType i) {
    GridIndex a;
    GridIndex b;
    double share;
    this->NearestEdge(this->Sources[i], a, b, share);
    const Vector3 normal = gradient.Outward(a, b, share);
    normals->SetTuple(i, normal.data());
  });
  const bool turn = this->FacesInwards(normals, output->GetPoints());
  vtkNew<vtkCellArray> triangles;
  triangles->AllocateExact(static_cast<vtkIdType>(this->Triangles.size() / 3),
    static_cast<vtkIdType>(this->Triangles.size()));
  for (std::size_t t = 0; t < this->Triangles.size(); t += 3)
  {
    const vtkIdType ids[3] = { this->Triangles[t], this->Triangles[t + (turn ? 2 : 1)],
      this->Triangles[t + (turn ? 1 : 2)] };
    triangles->InsertNextCell(3, ids);
  }
  output->SetPolys(triangles);
  if (withNormals)
  {
    output->GetPointData()->SetNormals(normals);
  }
}

// All triangles turn the same way in index space; whether that is outwards depends on the hand of
// the grid's axes. Most of them decide.
bool SurfaceAssembly::FacesInwards(vtkDataArray* normals, vtkPoints* points) const
{
  std::int64_t votes = 0;
  for (std::size_t t = 0; t < this->Triangles.size(); t += 3)
  {
    Vector3 corners[3];
    Vector3 normal;
    for (int c = 0; c < 3; ++c)
    {
      points->GetPoint(this->Triangles[t + c], corners[c].data());
    }
    normals->GetTuple(this->Triangles[t], normal.data());
    const double facing = Dot(normal, Cross(corners[1] - corners[0], corners[2] - corners[0]));
    votes += facing > 0.0 ? 1 : facing < 0.0 ? -1 : 0;
  }
  return votes < 0;
}
}
