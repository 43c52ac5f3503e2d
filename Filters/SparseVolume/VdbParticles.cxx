// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VdbParticles.h"

#include "CloudInCell.h"

#include "vtkDataSet.h"

#include <algorithm>
#include <limits>

namespace nephoscope
{
namespace
{
constexpr double largestIndex = 1 << 30;

// Edge of the cube that each would have if they filled their bounds, along the axes along which
// they spread.
double MeanSpacing(const double low[3], const double high[3], std::size_t count)
{
  const double longest = std::max({ high[0] - low[0], high[1] - low[1], high[2] - low[2] });
  double volume = 1;
  int axes = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    if (high[axis] - low[axis] > 1e-6 * longest)
    {
      volume *= high[axis] - low[axis];
      ++axes;
    }
  }
  return axes ? std::pow(volume / static_cast<double>(count), 1.0 / axes) : 1.0;
}
}

VdbParticles::VdbParticles(vtkDataSet* data, vtkDataArray* masses, double voxelSize)
  : Data(data)
  , VoxelSize(voxelSize)
  , Mass(NewGrid<openvdb::DoubleGrid>())
{
  double low[3], high[3], x[3];
  std::fill_n(low, 3, std::numeric_limits<double>::max());
  std::fill_n(high, 3, std::numeric_limits<double>::lowest());
  for (vtkIdType id = 0; id < data->GetNumberOfPoints(); ++id)
  {
    data->GetPoint(id, x);
    const double mass = masses ? masses->GetComponent(id, 0) : 1.0;
    if (!std::isfinite(x[0] + x[1] + x[2]) || !(mass >= 0) || !std::isfinite(mass))
    {
      ++this->Lost;
      continue;
    }
    this->Ids.push_back(id);
    this->Masses.push_back(mass);
    for (int axis = 0; axis < 3; ++axis)
    {
      low[axis] = std::min(low[axis], x[axis]);
      high[axis] = std::max(high[axis], x[axis]);
    }
  }
  if (this->Ids.empty())
  {
    this->Error = "There are no particles with a finite position and a mass of 0 or more.";
    return;
  }
  if (!(this->VoxelSize > 0))
  {
    this->VoxelSize = MeanSpacing(low, high, this->Ids.size());
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    if (std::max(std::abs(low[axis]), std::abs(high[axis])) >= largestIndex * this->VoxelSize)
    {
      this->Error = "Voxels of " + std::to_string(this->VoxelSize) +
        " are too small for coordinates as large as these: set a VoxelSize of at least 1e-9 of the largest coordinate.";
      return;
    }
  }
  auto accessor = this->Mass->getAccessor();
  this->ForAllShares([&](vtkIdType, const openvdb::Coord& voxel, double mass) {
    accessor.modifyValue(voxel, [mass](double& sum) { sum += mass; });
  });
}

template <typename Add>
void VdbParticles::ForAllShares(Add add) const
{
  for (std::size_t i = 0; i < this->Ids.size(); ++i)
  {
    std::array<double, 3> index;
    this->Data->GetPoint(this->Ids[i], index.data());
    for (double& x : index)
    {
      x /= this->VoxelSize;
    }
    const CloudInCell share = CloudInCellAt(index);
    for (int corner = 0; corner < 8; ++corner)
    {
      const double weight = share.Weight(corner);
      if (weight > 0)
      {
        const std::array<int, 3> voxel = share.Voxel(corner);
        add(this->Ids[i], openvdb::Coord(voxel[0], voxel[1], voxel[2]), weight * this->Masses[i]);
      }
    }
  }
}

void VdbParticles::FillDensity(openvdb::GridBase& grid) const
{
  grid.setTransform(openvdb::math::Transform::createLinearTransform(this->VoxelSize));
  const double volume = this->VoxelSize * this->VoxelSize * this->VoxelSize;
  grid.apply<openvdb::RealGridTypes>([&](auto& typed) {
    auto accessor = typed.getAccessor();
    for (auto mass = this->Mass->cbeginValueOn(); mass; ++mass)
    {
      using Value = typename std::decay_t<decltype(typed)>::ValueType;
      accessor.setValueOn(mass.getCoord(), static_cast<Value>(*mass / volume));
    }
  });
}

vtkIdType VdbParticles::FillMean(openvdb::GridBase& grid, vtkDataArray* array) const
{
  grid.setTransform(openvdb::math::Transform::createLinearTransform(this->VoxelSize));
  vtkIdType notFinite = 0;
  using Types = openvdb::TypeList<openvdb::FloatGrid, openvdb::DoubleGrid, openvdb::Vec3SGrid,
    openvdb::Vec3DGrid>;
  grid.apply<Types>([&](auto& typed) {
    using Value = typename std::decay_t<decltype(typed)>::ValueType;
    using Sum = std::conditional_t<openvdb::VecTraits<Value>::IsVec, openvdb::Vec3d, double>;
    using SumGrid =
      std::conditional_t<openvdb::VecTraits<Value>::IsVec, openvdb::Vec3DGrid, openvdb::DoubleGrid>;
    const ArrayValues<Sum> values(array);
    auto sums = NewGrid<SumGrid>();
    auto masses = NewGrid<openvdb::DoubleGrid>(); // of those with a value
    auto sum = sums->getAccessor();
    auto massSum = masses->getAccessor();
    this->ForAllShares([&](vtkIdType id, const openvdb::Coord& voxel, double mass) {
      const Sum value = values(id);
      if (IsFiniteValue(value))
      {
        sum.modifyValue(voxel, [&](Sum& s) { s += mass * value; });
        massSum.modifyValue(voxel, [&](double& s) { s += mass; });
      }
    });
    for (const vtkIdType id : this->Ids)
    {
      notFinite += !IsFiniteValue(values(id));
    }
    auto accessor = typed.getAccessor();
    for (auto mass = masses->cbeginValueOn(); mass; ++mass)
    {
      if (*mass > 0)
      {
        accessor.setValueOn(mass.getCoord(), Value(sum.getValue(mass.getCoord()) / *mass));
      }
    }
  });
  return notFinite;
}

} // namespace nephoscope
