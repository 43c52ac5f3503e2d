// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The active voxels of grids as points.
// 1. which voxels: the union of the grids on the first one's lattice;
// 2. their places;
// 3. for every grid an array of its values there.
#include "VdbReading.h"
#include "VdbValues.h"

#include "OwnThreads.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <openvdb/tree/LeafManager.h>

#include <numeric>

namespace nephoscope
{
namespace
{
using Mask = openvdb::MaskTree;

struct Tile
{
  openvdb::Coord First;
  int Edge; // voxels
};

/** The voxels to make points of, in the order of the tree: those of leaves, then tiles. */
struct Voxels
{
  Mask::Ptr Active;
  std::vector<const Mask::LeafNodeType*> Leaves;
  std::vector<vtkIdType> FirstPoint; // of each leaf
  std::vector<Tile> Tiles;
  vtkIdType InLeaves = 0;

  vtkIdType Size() const { return this->InLeaves + static_cast<vtkIdType>(this->Tiles.size()); }
};

Mask::Ptr UnionOf(const VdbRequest& request, const VdbRead& read)
{
  Mask::Ptr active = NewGrid<openvdb::MaskGrid>()->treePtr();
  for (std::size_t i = 0; i < read.Grids.size(); ++i)
  {
    if (IsSameLattice(request.Grids[0].IndexToWorld, request.Grids[i].IndexToWorld))
    {
      read.Grids[i]->apply<VdbGridTypes>(
        [&](const auto& grid) { active->topologyUnion(grid.tree()); });
    }
  }
  return active;
}

// The active tiles; their voxels stay uncounted where the tree is one of leaves.
std::vector<Tile> TilesOf(const Mask& active)
{
  std::vector<Tile> tiles;
  auto value = active.cbeginValueOn();
  value.setMaxDepth(Mask::ValueOnCIter::LEAF_DEPTH - 1);
  for (; value; ++value)
  {
    openvdb::CoordBBox box;
    value.getBoundingBox(box);
    tiles.push_back({ box.min(), box.dim().x() });
  }
  return tiles;
}

Voxels VoxelsOf(const Mask::Ptr& active, bool splitTiles)
{
  Voxels voxels;
  voxels.Active = active;
  if (splitTiles)
  {
    active->voxelizeActiveTiles();
  }
  voxels.Tiles = TilesOf(*active);
  for (auto leaf = active->cbeginLeaf(); leaf; ++leaf)
  {
    voxels.Leaves.push_back(&*leaf);
    voxels.FirstPoint.push_back(voxels.InLeaves);
    voxels.InLeaves += static_cast<vtkIdType>(leaf->onVoxelCount());
  }
  return voxels;
}

/**
 * Calls body(point, coordinates of its first voxel, edge in voxels, what prepare() gave this
 * thread) for all points.
 */
template <typename Prepare, typename Body>
void ForAll(const Voxels& voxels, Prepare prepare, Body body)
{
  vtkSMPTools::For(
    0, static_cast<vtkIdType>(voxels.Leaves.size()), [&](vtkIdType begin, vtkIdType end) {
      auto prepared = prepare();
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        vtkIdType point = voxels.FirstPoint[i];
        for (auto voxel = voxels.Leaves[i]->cbeginValueOn(); voxel; ++voxel)
        {
          body(point++, voxel.getCoord(), 1, prepared);
        }
      }
    });
  auto prepared = prepare();
  for (std::size_t i = 0; i < voxels.Tiles.size(); ++i)
  {
    body(voxels.InLeaves + static_cast<vtkIdType>(i), voxels.Tiles[i].First, voxels.Tiles[i].Edge,
      prepared);
  }
}

// Float where it tells places apart to a thousandth of a voxel.
bool FloatIsEnough(const VdbRequest& request, const Mask& active)
{
  const AffineMatrix& m = request.Grids[0].IndexToWorld;
  openvdb::CoordBBox box;
  active.evalActiveVoxelBoundingBox(box);
  const Vector3 edges = Spacing(m);
  double farthest = 0;
  for (int corner = 0; corner < 8; ++corner)
  {
    Vector3 index;
    for (int axis = 0; axis < 3; ++axis)
    {
      index[static_cast<std::size_t>(axis)] =
        corner >> axis & 1 ? box.max()[axis] : box.min()[axis];
    }
    const Vector3 place = Apply(m, index);
    farthest = std::max({ farthest, std::abs(place[0]), std::abs(place[1]), std::abs(place[2]) });
  }
  return farthest * 6e-8 < 1e-3 * std::min({ edges[0], edges[1], edges[2] });
}

vtkSmartPointer<vtkPoints> PlacesOf(const Voxels& voxels, const AffineMatrix& lattice, bool inFloat)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataType(inFloat ? VTK_FLOAT : VTK_DOUBLE);
  points->SetNumberOfPoints(voxels.Size());
  ForAll(
    voxels, []() { return 0; },
    [&](vtkIdType point, const openvdb::Coord& first, int edge, int) {
      const double half = 0.5 * (edge - 1);
      const Vector3 place =
        Apply(lattice, { { first.x() + half, first.y() + half, first.z() + half } });
      points->SetPoint(point, place.data());
    });
  points->Modified();
  return points;
}

template <typename GridT>
vtkSmartPointer<vtkDataArray> ValuesAt(
  const Voxels& voxels, const VdbValues<GridT>& values, const std::string& name)
{
  using Traits = VdbArrayTraits<GridT>;
  auto array = Traits::NewArray(name, voxels.Size());
  auto* data = static_cast<typename Traits::Scalar*>(array->GetVoidPointer(0));
  ForAll(
    voxels, [&]() { return values.Accessor(); },
    [&](vtkIdType point, const openvdb::Coord& first, int,
      const typename GridT::ConstAccessor& accessor) {
      Traits::Store(values.At(accessor, first), data + point * Traits::Components);
    });
  return array;
}

void AddLattice(const Voxels& voxels, const AffineMatrix& lattice, vtkPolyData* points)
{
  vtkNew<vtkDoubleArray> matrix;
  matrix->SetName("IndexToWorld");
  matrix->SetNumberOfComponents(16);
  matrix->InsertNextTuple(lattice.data());
  points->GetFieldData()->AddArray(matrix);
  if (voxels.Tiles.empty())
  {
    return;
  }
  vtkNew<vtkFloatArray> edges;
  edges->SetName("VoxelScale");
  edges->SetNumberOfTuples(voxels.Size());
  edges->Fill(1);
  for (std::size_t i = 0; i < voxels.Tiles.size(); ++i)
  {
    edges->SetValue(
      voxels.InLeaves + static_cast<vtkIdType>(i), static_cast<float>(voxels.Tiles[i].Edge));
  }
  points->GetPointData()->AddArray(edges);
}

// One cell for all points, so that they are drawn: 8 bytes a point.
void AddVertices(vtkPolyData* points)
{
  const vtkIdType count = points->GetNumberOfPoints();
  vtkNew<vtkIdTypeArray> offsets, ids;
  offsets->SetNumberOfTuples(2);
  offsets->SetValue(0, 0);
  offsets->SetValue(1, count);
  ids->SetNumberOfTuples(count);
  std::iota(ids->GetPointer(0), ids->GetPointer(0) + count, vtkIdType(0));
  vtkNew<vtkCellArray> vertices;
  vertices->SetData(offsets, ids);
  points->SetVerts(vertices);
}

// Active voxels of grids on another lattice that lie outside the first one's are not seen: say so.
void WarnOfLost(const VdbRequest& request, const Mask& active, std::vector<std::string>& warnings)
{
  openvdb::CoordBBox box;
  active.evalActiveVoxelBoundingBox(box);
  const AffineMatrix toIndex = InverseOf(request.Grids[0].IndexToWorld);
  for (const VdbGridInfo& info : request.Grids)
  {
    bool outside = false;
    for (int corner = 0; corner < 8 && !info.IsEmpty(); ++corner)
    {
      Vector3 index;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        index[axis] = info.Extent[2 * axis + (corner >> axis & 1)];
      }
      const Vector3 there = Apply(toIndex, Apply(info.IndexToWorld, index));
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        // A coarser grid's voxels reach half their edge beyond their centres.
        const double reach =
          Spacing(info.IndexToWorld)[axis] / Spacing(request.Grids[0].IndexToWorld)[axis];
        outside = outside || there[axis] < box.min()[static_cast<int>(axis)] - reach ||
          there[axis] > box.max()[static_cast<int>(axis)] + reach;
      }
    }
    if (outside && !IsSameLattice(info.IndexToWorld, request.Grids[0].IndexToWorld))
    {
      warnings.push_back("The grid '" + info.Name + "' has voxels of another size than '" +
        request.Grids[0].Name +
        "' and active ones beyond it; those are left out. Read the grids one by one to see all.");
    }
  }
}

void CopyGrids(const VdbRequest& request, VdbRead& read, const Voxels& voxels, vtkPointData* arrays)
{
  for (std::size_t i = 0; i < read.Grids.size(); ++i)
  {
    const VdbGridInfo& info = request.Grids[i];
    read.Grids[i]->apply<VdbGridTypes>([&](const auto& grid) {
      using GridT = std::decay_t<decltype(grid)>;
      arrays->AddArray(
        ValuesAt(voxels, VdbValues<GridT>(grid, info, request.Grids[0].IndexToWorld), info.Name));
    });
    read.Grids[i].reset(); // no longer needed
  }
  ChooseActiveArrays(arrays);
}
}

std::string ReadVdbPoints(
  const VdbRequest& request, vtkPolyData* points, std::vector<std::string>& warnings)
{
  VdbRead read = ReadGrids(request);
  if (!read.Error.empty())
  {
    return read.Error;
  }
  Mask::Ptr active = UnionOf(request, read);
  // A tile of one grid may be finer divided in another: only those of a single grid stay whole.
  const bool split = request.SplitTiles || request.Grids.size() > 1;
  const bool inFloat = FloatIsEnough(request, *active);
  const auto count =
    static_cast<double>(split ? active->activeVoxelCount()
                              : active->activeLeafVoxelCount() + active->activeTileCount());
  const std::string error = CheckMemory(count * (BytesOfValues(request) + (inFloat ? 12 : 24) + 8),
    request.MemoryLimit, std::to_string(static_cast<vtkTypeInt64>(count)) + " points",
    "keep the tiles of a single grid whole (SplitTiles off), choose fewer grids, or raise MemoryLimit.");
  if (!error.empty())
  {
    return error;
  }
  WarnOfLost(request, *active, warnings);
  const Voxels voxels = VoxelsOf(active, split);
  points->SetPoints(PlacesOf(voxels, request.Grids[0].IndexToWorld, inFloat));
  AddVertices(points);
  AddLattice(voxels, request.Grids[0].IndexToWorld, points);
  CopyGrids(request, read, voxels, points->GetPointData());
  return {};
}

} // namespace nephoscope
