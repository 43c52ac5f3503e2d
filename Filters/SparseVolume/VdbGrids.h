// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** OpenVDB grids from a file, and their descriptions. */
#ifndef nephoscope_VdbGrids_h
#define nephoscope_VdbGrids_h

#include "VdbFile.h"

#include <openvdb/openvdb.h>

namespace nephoscope
{

/** The grids that can be read and written. */
using VdbGridTypes = openvdb::TypeList<openvdb::FloatGrid, openvdb::DoubleGrid, openvdb::Int32Grid,
  openvdb::Int64Grid, openvdb::BoolGrid, openvdb::MaskGrid, openvdb::Vec3SGrid, openvdb::Vec3DGrid,
  openvdb::Vec3IGrid>;

/** Makes OpenVDB ready, once in a process. */
void StartOpenVDB();

/**
 * An empty grid, made by the library: Grid::create() would compile all of the tree's code once
 * more, for half a minute each.
 */
template <typename Grid>
typename Grid::Ptr NewGrid()
{
  StartOpenVDB();
  return openvdb::gridPtrCast<Grid>(openvdb::GridBase::createGrid(Grid::gridType()));
}

/** What an exception of OpenVDB or of the standard library says, as the end of a sentence. */
std::string Reason(const std::exception& exception);

AffineMatrix AffineOf(const openvdb::math::Transform& transform);
openvdb::math::Transform::Ptr TransformOf(const AffineMatrix& matrix);

/** The description of a grid from its metadata, without its voxels. */
VdbGridInfo Describe(const openvdb::GridBase& grid, const std::string& name);

/** A file that is open for reading; throws where OpenVDB does. */
class VdbArchive
{
public:
  explicit VdbArchive(const std::string& file);

  std::vector<VdbGridInfo> List();
  /** With all voxels. */
  openvdb::GridBase::Ptr Read(const std::string& name);

private:
  std::string KeyOf(const std::string& name) const;
  VdbGridInfo ListOne(const std::string& key);

  openvdb::io::File File;
};

} // namespace nephoscope

#endif
