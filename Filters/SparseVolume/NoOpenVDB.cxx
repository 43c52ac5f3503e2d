// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// What VdbFile.h and VdbWriting.h promise, in a build without OpenVDB.
#include "VdbFile.h"
#include "VdbWriting.h"

namespace nephoscope
{
namespace
{
constexpr const char* remedy =
  "This build has no OpenVDB, so .vdb files can be neither read nor written: install it (in Debian libopenvdb-dev) and build again "
  "with NEPHOSCOPE_USE_OPENVDB=ON.";
}

bool HasOpenVDB()
{
  return false;
}

std::vector<VdbGridInfo> ListVdbGrids(const std::string&, std::string& error)
{
  error = remedy;
  return {};
}

std::string ReadVdbPoints(const VdbRequest&, vtkPolyData*, std::vector<std::string>&)
{
  return remedy;
}

std::string ReadVdbImage(const VdbRequest&, vtkImageData*, std::vector<std::string>&)
{
  return remedy;
}

std::string WriteVdb(const VdbWriteSettings&, vtkDataSet*, std::vector<std::string>&)
{
  return remedy;
}

} // namespace nephoscope
