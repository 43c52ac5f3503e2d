// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// 1. what the data are: an image, voxels as points, or particles;
// 2. a grid for every array that is to be written;
// 3. names and metadata;
// 4. the file.
#include "VdbWriting.h"

#include "DataSets.h"
#include "LowerCase.h"
#include "VdbLattice.h"
#include "VdbParticles.h"

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"

#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace nephoscope
{
namespace
{
/** What is written, and what there is to say about it. */
struct Volume
{
  openvdb::GridPtrVec Grids;
  std::vector<std::string> Names; // of the arrays of these
  std::vector<std::string>& Warnings;
};

bool IsWanted(const VdbWriteSettings& settings, const std::string& name)
{
  return settings.Arrays.empty() ||
    std::count(settings.Arrays.begin(), settings.Arrays.end(), name) > 0;
}

// How a vector changes when the volume is moved: Houdini turns and scales velocities with it, and
// normals as such.
openvdb::VecType VectorTypeOf(const std::string& name)
{
  const std::string text = LowerCase(name);
  if (text == "v" || text.find("vel") != std::string::npos ||
    text.find("wind") != std::string::npos)
  {
    return openvdb::VEC_CONTRAVARIANT_RELATIVE;
  }
  return text.find("normal") != std::string::npos ? openvdb::VEC_COVARIANT_NORMALIZE
                                                  : openvdb::VEC_INVARIANT;
}

void AddGrid(const VdbWriteSettings& settings, const openvdb::GridBase::Ptr& grid,
  const std::string& array, Volume& volume)
{
  const auto renamed = settings.Names.find(array);
  const std::string name = renamed == settings.Names.end() ? array : renamed->second;
  const bool isVector = grid->isType<openvdb::Vec3SGrid>() || grid->isType<openvdb::Vec3DGrid>();
  const bool isReal = grid->isType<openvdb::FloatGrid>() || grid->isType<openvdb::DoubleGrid>();
  grid->setName(name);
  grid->setCreator(settings.Creator);
  grid->setSaveFloatAsHalf(settings.Precision == VdbPrecision::Half && (isVector || isReal));
  if (isReal)
  {
    grid->setGridClass(openvdb::GRID_FOG_VOLUME);
  }
  if (isVector)
  {
    grid->setVectorType(VectorTypeOf(name));
  }
  if (grid->activeVoxelCount() == 0)
  {
    volume.Warnings.push_back(
      "The grid '" + name + "' has no active voxels: all its values are background.");
  }
  volume.Grids.push_back(grid);
  volume.Names.push_back(name);
}

void WarnOfNotFinite(const std::string& array, vtkIdType count, Volume& volume)
{
  if (count > 0)
  {
    volume.Warnings.push_back("The array '" + array + "' has " + std::to_string(count) +
      " values that are NaN or infinite; they are left out.");
  }
}

/** Calls write(array, grid) with an empty grid for every array that is wanted. */
template <typename Write>
void ForArrays(
  const VdbWriteSettings& settings, vtkDataSetAttributes* arrays, Volume& volume, Write write)
{
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = arrays->GetArray(i);
    const std::string name = array && array->GetName() ? array->GetName() : "";
    if (name.empty() || name == "vtkGhostType" || !IsWanted(settings, name))
    {
      continue;
    }
    openvdb::GridBase::Ptr grid = NewGridFor(array, settings.Precision);
    if (!grid)
    {
      volume.Warnings.push_back("The array '" + name + "' is left out: it has " +
        std::to_string(array->GetNumberOfComponents()) + " components, and grids have 1 or 3.");
      continue;
    }
    write(array, name, grid);
  }
}

void AddImage(const VdbWriteSettings& settings, vtkImageData* image, Volume& volume)
{
  for (const bool onCells : { false, true })
  {
    auto* arrays =
      onCells ? static_cast<vtkDataSetAttributes*>(image->GetCellData()) : image->GetPointData();
    ForArrays(settings, arrays, volume,
      [&](vtkDataArray* array, const std::string& name, openvdb::GridBase::Ptr& grid) {
        WarnOfNotFinite(
          name, FillFromImage(*grid, image, array, onCells, settings.Tolerance).NotFinite, volume);
        AddGrid(settings, grid, name, volume);
      });
  }
}

void AddVoxels(
  const VdbWriteSettings& settings, const LatticePoints& points, vtkDataSet* data, Volume& volume)
{
  ForArrays(settings, data->GetPointData(), volume,
    [&](vtkDataArray* array, const std::string& name, openvdb::GridBase::Ptr& grid) {
      if (name != "VoxelScale")
      {
        WarnOfNotFinite(name, FillFromPoints(*grid, points, array).NotFinite, volume);
        AddGrid(settings, grid, name, volume);
      }
    });
}

// Means of integers are not integers.
openvdb::GridBase::Ptr NewMeanGrid(const openvdb::GridBase::Ptr& grid)
{
  const bool isReal = grid->isType<openvdb::DoubleGrid>() || grid->isType<openvdb::Vec3DGrid>() ||
    grid->isType<openvdb::Vec3SGrid>();
  return isReal ? grid : NewGrid<openvdb::FloatGrid>();
}

std::string AddParticles(const VdbWriteSettings& settings, vtkDataSet* data, Volume& volume)
{
  vtkDataArray* masses = nullptr;
  if (!settings.MassArray.empty())
  {
    masses = data->GetPointData()->GetArray(settings.MassArray.c_str());
    if (!masses || masses->GetNumberOfComponents() != 1)
    {
      return "The particles have no point array '" + settings.MassArray +
        "' of one component: MassArrayName must be one, or empty for a mass of 1 each.";
    }
  }
  const VdbParticles particles(data, masses, settings.VoxelSize);
  if (!particles.GetError().empty())
  {
    return particles.GetError();
  }
  if (particles.GetNumberOfLost() > 0)
  {
    volume.Warnings.push_back(std::to_string(particles.GetNumberOfLost()) +
      " particles are left out: they have no finite position, or their mass is negative or not a number.");
  }
  openvdb::GridBase::Ptr density = NewGrid<openvdb::FloatGrid>();
  particles.FillDensity(*density);
  AddGrid(settings, density, "density", volume);
  ForArrays(settings, data->GetPointData(), volume,
    [&](vtkDataArray* array, const std::string& name, openvdb::GridBase::Ptr& grid) {
      if (name != settings.MassArray)
      {
        grid = NewMeanGrid(grid);
        WarnOfNotFinite(name, particles.FillMean(*grid, array), volume);
        AddGrid(settings, grid, name, volume);
      }
    });
  return {};
}

std::string AddAll(const VdbWriteSettings& settings, vtkDataSet* data, Volume& volume)
{
  if (auto* image = vtkImageData::SafeDownCast(data))
  {
    AddImage(settings, image, volume);
    return {};
  }
  const std::string resample =
    "; resample it to an image first (in ParaView with Resample To Image).";
  if (!data->IsA("vtkPolyData") && !data->IsA("vtkUnstructuredGrid"))
  {
    return std::string("A .vdb file holds equal voxels, and a ") + data->GetClassName() +
      " has none" + resample;
  }
  if (!HasOnlyVertices(data))
  {
    return "Points are written as particles or voxels, and this data has other cells than vertices" +
      resample;
  }
  const LatticePoints voxels = FindLatticePoints(data);
  if (!voxels.Boxes.empty())
  {
    AddVoxels(settings, voxels, data, volume);
    return {};
  }
  if (data->GetFieldData()->GetArray("IndexToWorld"))
  {
    volume.Warnings.push_back(
      "The points are not at the voxels that their field data array 'IndexToWorld' tells: they are written as particles.");
  }
  return AddParticles(settings, data, volume);
}

std::string CheckChoice(const VdbWriteSettings& settings, vtkDataSet* data)
{
  for (const std::string& wanted : settings.Arrays)
  {
    if (!data->GetPointData()->HasArray(wanted.c_str()) &&
      !data->GetCellData()->HasArray(wanted.c_str()))
    {
      return "The input has no array '" + wanted + "'.";
    }
  }
  return {};
}

std::string CheckNames(const std::vector<std::string>& names)
{
  for (const std::string& name : names)
  {
    if (std::count(names.begin(), names.end(), name) > 1)
    {
      return "Two grids would have the name '" + name +
        "': choose one of their arrays, or give another name with SetGridName.";
    }
  }
  return names.empty() ? "The input has no arrays of one or three components to write." : "";
}

std::uint32_t FlagsOf(VdbCompression compression, std::vector<std::string>& warnings)
{
  std::uint32_t flags = openvdb::io::COMPRESS_ACTIVE_MASK;
  if (compression == VdbCompression::Blosc && openvdb::io::Archive::hasBloscCompression())
  {
    return flags | openvdb::io::COMPRESS_BLOSC;
  }
  if (compression == VdbCompression::Blosc)
  {
    warnings.push_back("This OpenVDB has no Blosc compression; Zip is used.");
  }
  return compression == VdbCompression::None ? flags : flags | openvdb::io::COMPRESS_ZIP;
}

// Writes to a temporary file first, so that a full disk leaves no incomplete file under the name.
std::string WriteFile(const VdbWriteSettings& settings, const Volume& volume)
{
  const std::string part = settings.File + ".part";
  try
  {
    openvdb::io::File file(part);
    file.setCompression(FlagsOf(settings.Compression, volume.Warnings));
    file.write(volume.Grids);
    file.close();
  }
  catch (const std::exception& exception)
  {
    vtksys::SystemTools::RemoveFile(part);
    return "'" + settings.File + "' cannot be written: " + Reason(exception);
  }
  std::error_code failure;
  std::filesystem::rename(part, settings.File, failure);
  if (failure)
  {
    vtksys::SystemTools::RemoveFile(part);
    return "'" + settings.File + "' cannot be written: " + failure.message() + ".";
  }
  return {};
}
}

std::string WriteVdb(
  const VdbWriteSettings& settings, vtkDataSet* data, std::vector<std::string>& warnings)
{
  StartOpenVDB();
  if (data->GetNumberOfPoints() == 0)
  {
    return "The input has no points: there is nothing to write.";
  }
  Volume volume{ {}, {}, warnings };
  std::string error = CheckChoice(settings, data);
  try
  {
    error = error.empty() ? AddAll(settings, data, volume) : error;
  }
  catch (const std::exception& exception) // OpenVDB takes a matrix of voxels of 1e-9 for singular
  {
    return "OpenVDB rejects these voxels: " + Reason(exception) +
      ". Scale the data, so that the volume of a voxel is neither 0 nor very small.";
  }
  if (error.empty())
  {
    error = CheckNames(volume.Names);
  }
  return error.empty() ? WriteFile(settings, volume) : error;
}

} // namespace nephoscope
