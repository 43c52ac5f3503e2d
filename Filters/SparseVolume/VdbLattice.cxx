// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VdbLattice.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"

#include <openvdb/tools/Prune.h>

#include <atomic>
#include <cmath>

namespace nephoscope
{
namespace
{
/** Where the values of an image are: indices and hidden ones. */
struct ImageSamples
{
  ImageSamples(vtkImageData* image, bool onCells)
    : Ghosts(onCells ? image->GetCellGhostArray() : image->GetPointGhostArray())
    , Hidden(
        onCells ? int(vtkDataSetAttributes::HIDDENCELL) : int(vtkDataSetAttributes::HIDDENPOINT))
  {
    image->GetExtent(this->Extent);
    for (int axis = 0; axis < 3 && onCells; ++axis)
    {
      // An image that is flat along an axis has cells there nevertheless.
      this->Extent[2 * axis + 1] = std::max(this->Extent[2 * axis], this->Extent[2 * axis + 1] - 1);
    }
  }

  bool IsHidden(vtkIdType id) const
  {
    return this->Ghosts && this->Ghosts->GetValue(id) & this->Hidden;
  }
  vtkIdType IdOf(int i, int j, int k) const
  {
    const int* e = this->Extent;
    return (vtkIdType(k - e[4]) * (e[3] - e[2] + 1) + (j - e[2])) * (e[1] - e[0] + 1) + (i - e[0]);
  }

  int Extent[6];
  vtkUnsignedCharArray* Ghosts;
  int Hidden;
};

// Lowest index of the leaf that a voxel is in; leaves are at multiples of their edge, below 0 too.
int LeafOf(int index)
{
  return index & ~7;
}

/** All places of leaves over an extent. */
std::vector<openvdb::Coord> LeavesOver(const int e[6])
{
  std::vector<openvdb::Coord> leaves;
  for (int i = LeafOf(e[0]); i <= e[1]; i += 8)
  {
    for (int j = LeafOf(e[2]); j <= e[3]; j += 8)
    {
      for (int k = LeafOf(e[4]); k <= e[5]; k += 8)
      {
        leaves.emplace_back(i, j, k);
      }
    }
  }
  return leaves;
}

template <typename GridT>
class LeafFiller
{
public:
  using Leaf = typename GridT::TreeType::LeafNodeType;
  using Value = typename GridT::ValueType;

  LeafFiller(const ImageSamples& samples, vtkDataArray* array, double tolerance)
    : Samples(samples)
    , Values(array)
    , Tolerance(tolerance)
  {
  }

  // A new leaf with what is not background, or null.
  Leaf* operator()(const openvdb::Coord& origin, vtkIdType& notFinite) const
  {
    Leaf* leaf = nullptr;
    const int* e = this->Samples.Extent;
    for (int k = std::max(origin.z(), e[4]); k <= std::min(origin.z() + 7, e[5]); ++k)
    {
      for (int j = std::max(origin.y(), e[2]); j <= std::min(origin.y() + 7, e[3]); ++j)
      {
        for (int i = std::max(origin.x(), e[0]); i <= std::min(origin.x() + 7, e[1]); ++i)
        {
          const vtkIdType id = this->Samples.IdOf(i, j, k);
          const Value value = this->Values(id);
          if (!IsFiniteValue(value) && !this->Samples.IsHidden(id))
          {
            ++notFinite;
          }
          else if (Magnitude(value) > this->Tolerance && !this->Samples.IsHidden(id))
          {
            leaf = leaf ? leaf : new Leaf(origin, openvdb::zeroVal<Value>(), false);
            leaf->setValueOn(openvdb::Coord(i, j, k), value);
          }
        }
      }
    }
    return leaf;
  }

private:
  const ImageSamples& Samples;
  ArrayValues<Value> Values;
  double Tolerance;
};

template <typename GridT>
vtkIdType FillGrid(GridT& grid, const ImageSamples& samples, vtkDataArray* array, double tolerance)
{
  const LeafFiller<GridT> fill(samples, array, tolerance);
  const std::vector<openvdb::Coord> places = LeavesOver(samples.Extent);
  std::vector<typename LeafFiller<GridT>::Leaf*> leaves(places.size(), nullptr);
  std::atomic<vtkIdType> notFinite{ 0 };
  vtkSMPTools::For(0, static_cast<vtkIdType>(places.size()), [&](vtkIdType begin, vtkIdType end) {
    vtkIdType count = 0;
    for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
    {
      leaves[i] = fill(places[i], count);
    }
    notFinite += count;
  });
  for (auto* leaf : leaves)
  {
    if (leaf)
    {
      grid.tree().addLeaf(leaf);
    }
  }
  openvdb::tools::prune(grid.tree()); // leaves of one value become tiles
  return notFinite;
}

AffineMatrix LatticeOf(vtkImageData* image, bool onCells)
{
  AffineMatrix matrix{};
  const double shift = onCells ? 0.5 : 0.0;
  double origin[3], step[3];
  const auto place = [&](double i, double j, double k, double* x) {
    const double index[3] = { i, j, k };
    image->TransformContinuousIndexToPhysicalPoint(index, x);
  };
  place(shift, shift, shift, origin);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    place(shift + (axis == 0), shift + (axis == 1), shift + (axis == 2), step);
    for (std::size_t row = 0; row < 3; ++row)
    {
      matrix[4 * row + axis] = step[row] - origin[row];
      matrix[4 * row + 3] = origin[row];
    }
  }
  matrix[15] = 1;
  return matrix;
}
}

LatticeCounts FillFromImage(
  openvdb::GridBase& grid, vtkImageData* image, vtkDataArray* array, bool onCells, double tolerance)
{
  LatticeCounts counts;
  const ImageSamples samples(image, onCells);
  grid.setTransform(TransformOf(LatticeOf(image, onCells)));
  grid.apply<VdbGridTypes>([&](auto& typed) {
    if constexpr (!std::is_same<std::decay_t<decltype(typed)>, openvdb::MaskGrid>::value)
    {
      counts.NotFinite = FillGrid(typed, samples, array, tolerance);
    }
  });
  return counts;
}

LatticePoints FindLatticePoints(vtkDataSet* data)
{
  LatticePoints found;
  vtkDataArray* matrix = data->GetFieldData()->GetArray("IndexToWorld");
  if (!matrix || matrix->GetNumberOfComponents() != 16 || matrix->GetNumberOfTuples() != 1)
  {
    return found;
  }
  matrix->GetTuple(0, found.IndexToWorld.data());
  const double volume = VoxelVolume(found.IndexToWorld);
  if (!(volume > 0) || !std::isfinite(volume))
  {
    return found;
  }
  const AffineMatrix toIndex = InverseOf(found.IndexToWorld);
  vtkDataArray* scale = data->GetPointData()->GetArray("VoxelScale");
  std::vector<openvdb::CoordBBox> boxes;
  for (vtkIdType id = 0; id < data->GetNumberOfPoints(); ++id)
  {
    Vector3 place;
    data->GetPoint(id, place.data());
    const double edge = scale ? scale->GetComponent(id, 0) : 1;
    const Vector3 index = Apply(toIndex, place);
    openvdb::Coord first;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const double lowest = index[axis] - 0.5 * (edge - 1);
      if (!(std::abs(lowest) < 1e9) || !(edge >= 1 && edge <= 4096) ||
        std::abs(lowest - std::round(lowest)) > 0.01)
      {
        return found;
      }
      first[static_cast<int>(axis)] = static_cast<int>(std::round(lowest));
    }
    boxes.push_back(openvdb::CoordBBox::createCube(first, static_cast<int>(edge)));
  }
  found.Boxes.swap(boxes);
  return found;
}

LatticeCounts FillFromPoints(
  openvdb::GridBase& grid, const LatticePoints& points, vtkDataArray* array)
{
  LatticeCounts counts;
  grid.setTransform(TransformOf(points.IndexToWorld));
  grid.apply<VdbGridTypes>([&](auto& typed) {
    using GridT = std::decay_t<decltype(typed)>;
    if constexpr (!std::is_same<GridT, openvdb::MaskGrid>::value)
    {
      const ArrayValues<typename GridT::ValueType> values(array);
      auto accessor = typed.getAccessor();
      for (std::size_t i = 0; i < points.Boxes.size(); ++i)
      {
        const auto value = values(static_cast<vtkIdType>(i));
        if (!IsFiniteValue(value))
        {
          ++counts.NotFinite;
        }
        else if (points.Boxes[i].volume() == 1)
        {
          accessor.setValueOn(points.Boxes[i].min(), value);
        }
        else
        {
          typed.fill(points.Boxes[i], value, true);
          accessor.clear();
        }
      }
      openvdb::tools::prune(typed.tree());
    }
  });
  return counts;
}

} // namespace nephoscope
