// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VdbGrids.h"

#include "VdbLength.h"

#include <openvdb/math/Maps.h>

namespace nephoscope
{
namespace
{
constexpr const char* unnamed = "unnamed"; // VTK's arrays need a name
constexpr std::size_t longestName = 1000;  // bytes; OpenVDB reads up to 4 GiB from a damaged file
constexpr std::size_t longestReason = 500;

std::string Abbreviated(const std::string& text, std::size_t length)
{
  return text.size() <= length ? text : text.substr(0, length) + "...";
}

std::string ClassName(const openvdb::GridBase& grid)
{
  switch (grid.getGridClass())
  {
    case openvdb::GRID_FOG_VOLUME:
      return "fog volume";
    case openvdb::GRID_LEVEL_SET:
      return "level set";
    case openvdb::GRID_STAGGERED:
      return "staggered";
    default:
      return "unknown";
  }
}

std::string RefusalOf(const openvdb::GridBase& grid)
{
  if (grid.type() == "Tree_ptdataidx32_5_4_3" || grid.type() == "Tree_ptdataidx64_5_4_3")
  {
    return "it holds points, not voxels";
  }
  if (!grid.apply<VdbGridTypes>([](const auto&) {}))
  {
    return "its values are of the type '" + grid.valueType() + "' in a tree '" + grid.type() +
      "'; float, double, int32, int64, bool, mask and vectors of three are read";
  }
  if (!grid.transform().isLinear())
  {
    return "its voxels lie in a frustum; resample it to a box of equal voxels first (in Houdini with VDB Resample)";
  }
  const AffineMatrix matrix = AffineOf(grid.transform());
  if (!(VoxelVolume(matrix) > 0) || !std::isfinite(VoxelVolume(matrix)))
  {
    return "its transform gives voxels without volume";
  }
  return {};
}
}

void StartOpenVDB()
{
  static const bool started = (openvdb::initialize(), true);
  static_cast<void>(started);
}

std::string Reason(const std::exception& exception)
{
  const std::string what = exception.what();
  return what.empty() ? "OpenVDB gives no reason" : Abbreviated(what, longestReason);
}

// OpenVDB multiplies row vectors from the left: its matrices are transposed.
AffineMatrix AffineOf(const openvdb::math::Transform& transform)
{
  const openvdb::math::Mat4d rows = transform.baseMap()->getAffineMap()->getMat4();
  AffineMatrix matrix;
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      matrix[static_cast<std::size_t>(4 * row + column)] = rows(column, row);
    }
  }
  return matrix;
}

openvdb::math::Transform::Ptr TransformOf(const AffineMatrix& matrix)
{
  openvdb::math::Mat4d rows;
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      rows(column, row) = matrix[static_cast<std::size_t>(4 * row + column)];
    }
  }
  return openvdb::math::Transform::createLinearTransform(rows);
}

VdbGridInfo Describe(const openvdb::GridBase& grid, const std::string& name)
{
  VdbGridInfo info;
  info.Name = name;
  info.Type = grid.valueType();
  info.Class = ClassName(grid);
  info.Half = grid.saveFloatAsHalf();
  info.Refusal = RefusalOf(grid);
  if (!info.Refusal.empty())
  {
    return info;
  }
  info.Staggered = grid.getGridClass() == openvdb::GRID_STAGGERED &&
    (grid.isType<openvdb::Vec3SGrid>() || grid.isType<openvdb::Vec3DGrid>());
  info.IndexToWorld = AffineOf(grid.transform());
  openvdb::CoordBBox box;
  auto first = grid.getMetadata<openvdb::Vec3IMetadata>(openvdb::GridBase::META_FILE_BBOX_MIN);
  auto last = grid.getMetadata<openvdb::Vec3IMetadata>(openvdb::GridBase::META_FILE_BBOX_MAX);
  auto count = grid.getMetadata<openvdb::Int64Metadata>(openvdb::GridBase::META_FILE_VOXEL_COUNT);
  if (first && last && count)
  {
    box = openvdb::CoordBBox(openvdb::Coord(first->value()), openvdb::Coord(last->value()));
    info.ActiveVoxels = count->value();
  }
  else
  {
    box = grid.evalActiveVoxelBoundingBox();
    info.ActiveVoxels = static_cast<vtkTypeInt64>(grid.activeVoxelCount());
  }
  if (info.ActiveVoxels > 0 && !box.empty())
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      info.Extent[2 * axis] = box.min()[axis];
      info.Extent[2 * axis + 1] = box.max()[axis];
    }
  }
  return info;
}

VdbArchive::VdbArchive(const std::string& file)
  : File(file)
{
  StartOpenVDB();
  this->File.open(
    /*delayLoad=*/false); // a truncated file that is mapped into memory would end the process
}

std::string VdbArchive::KeyOf(const std::string& name) const
{
  return name == unnamed && !this->File.hasGrid(name) ? std::string() : name;
}

VdbGridInfo VdbArchive::ListOne(const std::string& key)
{
  VdbGridInfo info;
  if (key.size() > longestName)
  {
    info.Name = Abbreviated(key, longestReason);
    info.Refusal = "its name has " + std::to_string(key.size()) + " bytes, more than " +
      std::to_string(longestName) + "; the file may be damaged";
    return info;
  }
  const std::string name = key.empty() ? unnamed : key;
  try
  {
    const openvdb::GridBase::Ptr grid = this->File.readGridMetadata(key);
    const bool told = grid->getMetadata<openvdb::Int64Metadata>(
                        openvdb::GridBase::META_FILE_VOXEL_COUNT) != nullptr;
    info = Describe(*grid, name);
    if (!told && info.Refusal.empty()) // written without statistics
    {
      info = Describe(*this->File.readGrid(key), name);
    }
  }
  catch (const std::exception& exception)
  {
    info.Name = name;
    info.Refusal = Reason(exception);
  }
  return info;
}

std::vector<VdbGridInfo> VdbArchive::List()
{
  std::vector<VdbGridInfo> infos;
  for (auto name = this->File.beginName(); name != this->File.endName(); ++name)
  {
    infos.push_back(this->ListOne(name.gridName()));
  }
  return infos;
}

openvdb::GridBase::Ptr VdbArchive::Read(const std::string& name)
{
  return this->File.readGrid(this->KeyOf(name));
}

bool HasOpenVDB()
{
  return true;
}

std::vector<VdbGridInfo> ListVdbGrids(const std::string& file, std::string& error)
{
  try
  {
    if (IsVdbTruncated(file))
    {
      error = "'" + file + "' is truncated: it ends before its grids do.";
      return {};
    }
    return VdbArchive(file).List();
  }
  catch (const std::exception& exception)
  {
    error = "'" + file + "' is not a readable .vdb file: " + Reason(exception);
    return {};
  }
}

} // namespace nephoscope
