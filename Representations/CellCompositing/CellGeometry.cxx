// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellGeometry.h"

#include "CellDecomposition.h"

#include "vtkCell.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkSMPThreadLocalObject.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>
#include <numeric>
#include <tuple>

namespace nephoscope
{
namespace
{
constexpr unsigned char skippedCells = vtkDataSetAttributes::DUPLICATECELL |
  vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::REFINEDCELL;

FaceList<int> linearCellFaces(int cellType)
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
    case VTK_PENTAGONAL_PRISM:
      return makeFaceList(pentagonalPrismFaceList);
    case VTK_HEXAGONAL_PRISM:
      return makeFaceList(hexagonalPrismFaceList);
    default:
      return { nullptr, nullptr };
  }
}

double scalarValue(const ScalarSelection& scalars, vtkIdType tuple)
{
  const int components = scalars.Array->GetNumberOfComponents();
  if (components == 1 || scalars.Component >= 0)
  {
    return scalars.Array->GetComponent(tuple, std::min(std::max(scalars.Component, 0), components - 1));
  }
  double sum = 0;
  for (int c = 0; c < components; ++c)
  {
    const double value = scalars.Array->GetComponent(tuple, c);
    sum += value * value;
  }
  return std::sqrt(sum);
}

/**
 * Finite minimum and maximum, never equal: the range that becomes [0, 1]. Hidden values do not count: a fill value there
 * would take the precision of all that is drawn.
 */
void findRange(vtkDataSet* data, const ScalarSelection& scalars, double range[2])
{
  vtkUnsignedCharArray* ghosts = scalars.OnCells ? data->GetCellGhostArray() : data->GetPointGhostArray();
  const int hidden = scalars.OnCells ? int(vtkDataSetAttributes::HIDDENCELL) : int(vtkDataSetAttributes::HIDDENPOINT);
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  const vtkIdType n = scalars.Array->GetNumberOfTuples();
  for (vtkIdType i = 0; i < n; ++i)
  {
    const double value = scalarValue(scalars, i);
    if (std::isfinite(value) && !(ghosts && (ghosts->GetValue(i) & hidden)))
    {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  range[0] = low <= high ? low : 0.0;
  range[1] = low < high ? high : range[0] + 1.0;
}

float normalized(const ScalarSelection& scalars, vtkIdType tuple, const double range[2])
{
  return static_cast<float>((scalarValue(scalars, tuple) - range[0]) / (range[1] - range[0]));
}

/** Walks the cells of a range, deciding which are drawn and into which tetrahedra they fall. */
class CellWalker
{
public:
  CellWalker(vtkDataSet* data, const CellGeometry& geometry, const ScalarSelection& scalars,
    const ScalarSelection& opacity)
    : Data(data)
    , Grid(vtkUnstructuredGrid::SafeDownCast(data))
    , CellGhosts(data->GetCellGhostArray())
    , PointGhosts(data->GetPointGhostArray())
    , Geometry(geometry)
    , Points(geometry.Points)
    , Scalars(scalars)
    , Opacity(opacity)
  {
  }

  enum class Outcome
  {
    Decomposed,
    Skipped,
    Unsupported,
    Invalid
  };

  template <typename Emit>
  Outcome Walk(vtkIdType cell, Emit emit)
  {
    const int type = this->Data->GetCellType(cell);
    if (type == VTK_EMPTY_CELL || (this->CellGhosts && (this->CellGhosts->GetValue(cell) & skippedCells)))
    {
      return Outcome::Skipped;
    }
    this->Data->GetCellPoints(cell, this->Ids);
    if (this->TouchesHiddenPoint())
    {
      return Outcome::Skipped;
    }
    if (!this->IsFinite(cell))
    {
      return Outcome::Invalid;
    }
    return this->DecomposeByType(cell, type, emit) ? Outcome::Decomposed : Outcome::Unsupported;
  }

private:
  bool TouchesHiddenPoint() const
  {
    if (!this->PointGhosts)
    {
      return false;
    }
    const vtkIdType* ids = this->Ids->GetPointer(0);
    return std::any_of(ids, ids + this->Ids->GetNumberOfIds(), [this](vtkIdType id) {
      return (this->PointGhosts->GetValue(id) & vtkDataSetAttributes::HIDDENPOINT) != 0;
    });
  }

  bool IsFinite(vtkIdType cell) const
  {
    if ((this->Scalars.OnCells && !std::isfinite(scalarValue(this->Scalars, cell))) ||
      (this->Opacity.OnCells && !std::isfinite(scalarValue(this->Opacity, cell))))
    {
      return false;
    }
    const bool opacityOnPoints = this->Geometry.HasOpacityScalars && !this->Opacity.OnCells;
    const vtkIdType* ids = this->Ids->GetPointer(0);
    return std::all_of(ids, ids + this->Ids->GetNumberOfIds(), [&](vtkIdType id) {
      const std::size_t i = static_cast<std::size_t>(id);
      const CellGeometry::Point& p = this->Points[i];
      return std::isfinite(p.X) && std::isfinite(p.Y) && std::isfinite(p.Z) && std::isfinite(p.Scalar) &&
        (!opacityOnPoints || std::isfinite(this->Geometry.OpacityScalars[i]));
    });
  }

  template <typename Emit>
  bool DecomposeByType(vtkIdType cell, int type, Emit emit)
  {
    const FaceList<int> faces = linearCellFaces(type);
    if (faces.Begin)
    {
      this->DecomposeLinear(faces, emit);
      return true;
    }
    if (type == VTK_POLYHEDRON && this->Grid)
    {
      this->DecomposePolyhedron(cell, emit);
      return true;
    }
    return this->TriangulateGeneric(cell, emit);
  }

  // Vertices in the order of their coordinates; coincident ones by number.
  bool Less(vtkIdType a, vtkIdType b) const
  {
    const CellGeometry::Point& p = this->Points[static_cast<std::size_t>(a)];
    const CellGeometry::Point& q = this->Points[static_cast<std::size_t>(b)];
    return std::tie(p.X, p.Y, p.Z, a) < std::tie(q.X, q.Y, q.Z, b);
  }

  template <typename Emit>
  void DecomposeLinear(FaceList<int> faces, Emit emit)
  {
    const vtkIdType* ids = this->Ids->GetPointer(0);
    decomposeCell(
      faces, [&](int a, int b) { return this->Less(ids[a], ids[b]); },
      [&](const std::array<int, 4>& t) { emit(ids[t[0]], ids[t[1]], ids[t[2]], ids[t[3]]); });
  }

  template <typename Emit>
  void DecomposePolyhedron(vtkIdType cell, Emit emit)
  {
    this->Grid->GetFaceStream(cell, this->Faces); // number of faces, then the face list
    const vtkIdType* stream = this->Faces->GetPointer(0);
    decomposeCell(
      FaceList<vtkIdType>{ stream + 1, stream + this->Faces->GetNumberOfIds() },
      [&](vtkIdType a, vtkIdType b) { return this->Less(a, b); },
      [&](const std::array<vtkIdType, 4>& t) { emit(t[0], t[1], t[2], t[3]); });
  }

  // Higher-order and other 3-D cells: as VTK triangulates them.
  template <typename Emit>
  bool TriangulateGeneric(vtkIdType cell, Emit emit)
  {
    this->Data->GetCell(cell, this->Cell);
    if (this->Cell->GetCellDimension() != 3 || !this->Cell->Triangulate(0, this->Faces, this->CellPoints))
    {
      return false;
    }
    for (vtkIdType i = 0; i + 3 < this->Faces->GetNumberOfIds(); i += 4)
    {
      const vtkIdType* t = this->Faces->GetPointer(i);
      emit(t[0], t[1], t[2], t[3]);
    }
    return true;
  }

  vtkDataSet* Data;
  vtkUnstructuredGrid* Grid;
  vtkUnsignedCharArray* CellGhosts;
  vtkUnsignedCharArray* PointGhosts;
  const CellGeometry& Geometry;
  const std::vector<CellGeometry::Point>& Points;
  const ScalarSelection& Scalars;
  const ScalarSelection& Opacity;
  vtkNew<vtkIdList> Ids;
  vtkNew<vtkIdList> Faces;
  vtkNew<vtkPoints> CellPoints;
  vtkNew<vtkGenericCell> Cell;
};

// No volume but for rounding: coincident or coplanar vertices.
bool isFlat(const CellGeometry& geometry, const Tetrahedron& t)
{
  const Vector3 a = geometry.Position(t[0]);
  const Vector3 ab = difference(geometry.Position(t[1]), a);
  const Vector3 ac = difference(geometry.Position(t[2]), a);
  const Vector3 ad = difference(geometry.Position(t[3]), a);
  const double box = std::sqrt(dot(ab, ab) * dot(ac, ac) * dot(ad, ad));
  return std::abs(dot(cross(ab, ac), ad)) <= 1e-12 * box;
}
}

void CellGeometry::Clear()
{
  *this = CellGeometry();
}

std::array<Vector3, 4> CellGeometry::Vertices(std::size_t tetrahedron) const
{
  const Tetrahedron& t = this->Tetrahedra[tetrahedron];
  return { { this->Position(t[0]), this->Position(t[1]), this->Position(t[2]), this->Position(t[3]) } };
}

std::string CellGeometry::Build(
  vtkDataSet* data, const ScalarSelection& scalars, const ScalarSelection& opacity)
{
  this->Clear();
  constexpr vtkIdType limit = std::numeric_limits<std::int32_t>::max() / 8;
  if (data->GetNumberOfPoints() > limit || data->GetNumberOfCells() > limit)
  {
    return "The input has more than " + std::to_string(limit) +
      " points or cells in one piece; distribute it over more ranks.";
  }
  if (data->GetNumberOfCells() > 0)
  {
    data->GetCellType(0);
    vtkNew<vtkIdList> ids;
    data->GetCellPoints(0, ids); // builds what datasets build on first use, before threads ask for it
  }
  this->CopyPoints(data);
  this->CopyScalars(data, scalars);
  this->CopyOpacityScalars(data, opacity);
  this->Decompose(data, scalars, opacity);
  return std::string();
}

void CellGeometry::CopyPoints(vtkDataSet* data)
{
  double bounds[6];
  data->GetBounds(bounds);
  for (int axis = 0; axis < 3; ++axis)
  {
    const double middle = 0.5 * (bounds[2 * axis] + bounds[2 * axis + 1]);
    this->Center[axis] = std::isfinite(middle) ? middle : 0.0;
  }
  this->Points.resize(static_cast<std::size_t>(data->GetNumberOfPoints()));
  vtkSMPTools::For(0, data->GetNumberOfPoints(), [&](vtkIdType begin, vtkIdType end) {
    double x[3];
    for (vtkIdType i = begin; i < end; ++i)
    {
      data->GetPoint(i, x);
      this->Points[static_cast<std::size_t>(i)] = { static_cast<float>(x[0] - this->Center[0]),
        static_cast<float>(x[1] - this->Center[1]), static_cast<float>(x[2] - this->Center[2]), 0.0f };
    }
  });
}

void CellGeometry::CopyScalars(vtkDataSet* data, const ScalarSelection& scalars)
{
  findRange(data, scalars, this->ScalarRange);
  if (scalars.OnCells)
  {
    return;
  }
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Points.size()), [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end; ++i)
    {
      this->Points[static_cast<std::size_t>(i)].Scalar = normalized(scalars, i, this->ScalarRange);
    }
  });
}

void CellGeometry::CopyOpacityScalars(vtkDataSet* data, const ScalarSelection& opacity)
{
  this->HasOpacityScalars = opacity.Array != nullptr;
  this->OpacityOnCells = opacity.OnCells;
  if (!opacity.Array)
  {
    return;
  }
  findRange(data, opacity, this->OpacityRange);
  if (opacity.OnCells)
  {
    return;
  }
  this->OpacityScalars.resize(this->Points.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Points.size()), [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end; ++i)
    {
      this->OpacityScalars[static_cast<std::size_t>(i)] = normalized(opacity, i, this->OpacityRange);
    }
  });
}

void CellGeometry::Decompose(
  vtkDataSet* data, const ScalarSelection& scalars, const ScalarSelection& opacity)
{
  using Outcome = CellWalker::Outcome;
  const vtkIdType numberOfCells = data->GetNumberOfCells();
  std::vector<std::int64_t> first(static_cast<std::size_t>(numberOfCells) + 1, 0);
  std::atomic<std::int64_t> unsupported(0), invalid(0), flat(0);
  std::atomic<int> unsupportedType(0);

  // PASS 1: how many tetrahedra each cell gives.
  vtkSMPTools::For(0, numberOfCells, [&](vtkIdType begin, vtkIdType end) {
    CellWalker walker(data, *this, scalars, opacity);
    for (vtkIdType cell = begin; cell < end; ++cell)
    {
      std::int64_t count = 0;
      const Outcome outcome = walker.Walk(cell, [&](vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType d) {
        const Tetrahedron t = { { std::int32_t(a), std::int32_t(b), std::int32_t(c), std::int32_t(d) } };
        isFlat(*this, t) ? ++flat : ++count;
      });
      invalid += outcome == Outcome::Invalid;
      if (outcome == Outcome::Unsupported)
      {
        ++unsupported;
        int type = data->GetCellType(cell);
        int known = unsupportedType;
        while (type > known && !unsupportedType.compare_exchange_weak(known, type))
        {
        }
      }
      first[static_cast<std::size_t>(cell) + 1] = count;
    }
  });
  this->NumberOfUnsupportedCells = unsupported;
  this->UnsupportedCellType = unsupportedType;
  this->NumberOfInvalidCells = invalid;
  this->NumberOfFlatTetrahedra = flat;

  // PASS 2: where each cell's tetrahedra begin.
  std::partial_sum(first.begin(), first.end(), first.begin());
  this->Tetrahedra.resize(static_cast<std::size_t>(first.back()));
  this->CellScalars.resize(scalars.OnCells ? this->Tetrahedra.size() : 0);
  if (opacity.OnCells)
  {
    this->OpacityScalars.resize(this->Tetrahedra.size());
  }

  // PASS 3: fill.
  vtkSMPTools::For(0, numberOfCells, [&](vtkIdType begin, vtkIdType end) {
    CellWalker walker(data, *this, scalars, opacity);
    for (vtkIdType cell = begin; cell < end; ++cell)
    {
      std::size_t next = static_cast<std::size_t>(first[static_cast<std::size_t>(cell)]);
      walker.Walk(cell, [&](vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType d) {
        const Tetrahedron t = { { std::int32_t(a), std::int32_t(b), std::int32_t(c), std::int32_t(d) } };
        if (isFlat(*this, t))
        {
          return;
        }
        if (scalars.OnCells)
        {
          this->CellScalars[next] = normalized(scalars, cell, this->ScalarRange);
        }
        if (opacity.OnCells)
        {
          this->OpacityScalars[next] = normalized(opacity, cell, this->OpacityRange);
        }
        this->Tetrahedra[next++] = t;
      });
    }
  });
}

} // namespace nephoscope
