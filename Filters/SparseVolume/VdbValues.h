// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The values of a grid at the voxels of a lattice, its own or another, as VTK's arrays hold them.
 */
#ifndef nephoscope_VdbValues_h
#define nephoscope_VdbValues_h

#include "VdbGrids.h"

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

#include <openvdb/tools/Interpolation.h>

#include <cstdint>
#include <type_traits>

namespace nephoscope
{

inline int VtkTypeOf(float)
{
  return VTK_FLOAT;
}
inline int VtkTypeOf(double)
{
  return VTK_DOUBLE;
}
inline int VtkTypeOf(std::int32_t)
{
  return VTK_TYPE_INT32;
}
inline int VtkTypeOf(std::int64_t)
{
  return VTK_TYPE_INT64;
}
inline int VtkTypeOf(unsigned char)
{
  return VTK_UNSIGNED_CHAR;
}

/** How the values of a grid are stored in an array of VTK. */
template <typename GridT>
struct VdbArrayTraits
{
  using Value = typename GridT::ValueType;
  using Element = typename openvdb::VecTraits<Value>::ElementType;
  using Scalar = std::conditional_t<std::is_same<Element, float>::value ||
      std::is_same<Element, double>::value || std::is_same<Element, std::int32_t>::value ||
      std::is_same<Element, std::int64_t>::value,
    Element, unsigned char>; // bool and mask
  static constexpr int Components = openvdb::VecTraits<Value>::Size;

  static vtkSmartPointer<vtkDataArray> NewArray(const std::string& name, vtkIdType count)
  {
    auto array = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(VtkTypeOf(Scalar())));
    array->SetName(name.c_str());
    array->SetNumberOfComponents(Components);
    array->SetNumberOfTuples(count);
    return array;
  }

  static void Store(const Value& value, Scalar* place)
  {
    if constexpr (openvdb::VecTraits<Value>::IsVec)
    {
      for (int c = 0; c < Components; ++c)
      {
        place[c] = value[c];
      }
    }
    else
    {
      *place = static_cast<Scalar>(value);
    }
  }
};

/**
 * Values at the voxels of a lattice: those of the grid, their means at centres if it is staggered,
 * or interpolated.
 */
template <typename GridT>
class VdbValues
{
public:
  using Value = typename GridT::ValueType;

  VdbValues(const GridT& grid, const VdbGridInfo& info, const AffineMatrix& lattice)
    : Grid(grid)
    , Staggered(info.Staggered)
    , Interpolated(!IsSameLattice(info.IndexToWorld, lattice))
    , Lattice(lattice)
  {
  }

  bool IsStored() const { return !this->Staggered && !this->Interpolated; }

  /** For one thread. */
  typename GridT::ConstAccessor Accessor() const { return this->Grid.getConstAccessor(); }

  Value At(const typename GridT::ConstAccessor& accessor, const openvdb::Coord& voxel) const
  {
    if constexpr (openvdb::VecTraits<Value>::IsVec)
    {
      if (this->Staggered)
      {
        return openvdb::tools::StaggeredBoxSampler::sample(accessor, this->Place(voxel));
      }
    }
    if (!this->Interpolated)
    {
      return accessor.getValue(voxel);
    }
    if constexpr (std::is_floating_point<typename openvdb::VecTraits<Value>::ElementType>::value)
    {
      return openvdb::tools::BoxSampler::sample(accessor, this->Place(voxel));
    }
    else
    {
      return openvdb::tools::PointSampler::sample(accessor, this->Place(voxel));
    }
  }

private:
  /** In the indices of the grid. */
  openvdb::Vec3R Place(const openvdb::Coord& voxel) const
  {
    const Vector3 index{ { double(voxel.x()), double(voxel.y()), double(voxel.z()) } };
    if (!this->Interpolated)
    {
      return openvdb::Vec3R(index.data());
    }
    const Vector3 world = Apply(this->Lattice, index);
    return this->Grid.worldToIndex(openvdb::Vec3d(world.data()));
  }

  const GridT& Grid;
  bool Staggered;
  bool Interpolated;
  AffineMatrix Lattice;
};

} // namespace nephoscope

#endif
