// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSparseVolumeReader.h"

#include "OwnThreads.h"
#include "VdbFile.h"

#include "vtkDataArraySelection.h"
#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMatrix3x3.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <vtksys/FStream.hxx>
#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <climits>
#include <cstring>
#include <new>
#include <sstream>

using nephoscope::AffineMatrix;
using nephoscope::VdbGridInfo;
using SDDP = vtkStreamingDemandDrivenPipeline;

vtkStandardNewMacro(vtkSparseVolumeReader);

struct vtkSparseVolumeReader::vtkInternals
{
  std::vector<VdbGridInfo> Grids;
  std::string ListedFile; // of which these are the grids
  long int ListedTime = 0;

  const VdbGridInfo& Grid(int i) const
  {
    static const VdbGridInfo none;
    return i >= 0 && i < static_cast<int>(this->Grids.size())
      ? this->Grids[static_cast<std::size_t>(i)]
      : none;
  }
  std::string Names() const;
  std::string CheckChoice(vtkDataArraySelection* selection, const std::vector<VdbGridInfo>& chosen,
    bool asImage, std::vector<std::string>& warnings) const;
};

namespace
{
constexpr double gibibyte = 1024.0 * 1024.0 * 1024.0;

// The extent of the union of all grids on the lattice of the first.
void JoinExtents(const std::vector<VdbGridInfo>& grids, int extent[6])
{
  std::copy_n(VdbGridInfo().Extent, 6, extent);
  for (const VdbGridInfo& grid : grids)
  {
    if (grid.IsEmpty() || !nephoscope::IsSameLattice(grid.IndexToWorld, grids[0].IndexToWorld))
    {
      continue;
    }
    const bool isFirst = extent[1] < extent[0];
    for (int i = 0; i < 6; ++i)
    {
      extent[i] = isFirst ? grid.Extent[i]
        : i % 2           ? std::max(extent[i], grid.Extent[i])
                          : std::min(extent[i], grid.Extent[i]);
    }
  }
}

// An image's direction times its spacing are the columns of the matrix; handedness goes into the
// direction.
void Decompose(const AffineMatrix& matrix, double origin[3], double spacing[3], double direction[9])
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    origin[axis] = matrix[4 * axis + 3];
    const nephoscope::Vector3 edge = nephoscope::Column(matrix, axis);
    spacing[axis] = nephoscope::Norm(edge);
    for (std::size_t row = 0; row < 3; ++row)
    {
      direction[3 * row + axis] = edge[row] / spacing[axis];
    }
  }
}

// Dimensions beyond an int are not an extent that VTK can take.
bool Fits(const int extent[6])
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (vtkTypeInt64(extent[2 * axis + 1]) - extent[2 * axis] >= INT_MAX)
    {
      return false;
    }
  }
  return true;
}

std::string ReadImage(
  const nephoscope::VdbRequest& request, vtkImageData* image, std::vector<std::string>& warnings)
{
  int extent[6];
  double origin[3], spacing[3], direction[9];
  JoinExtents(request.Grids, extent);
  Decompose(request.Grids[0].IndexToWorld, origin, spacing, direction);
  if (!Fits(extent))
  {
    return "The active voxels of the grid '" + request.Grids[0].Name +
      "' span more indices than an image can have: read them as points.";
  }
  image->SetExtent(extent);
  image->SetOrigin(origin);
  image->SetSpacing(spacing);
  image->SetDirectionMatrix(direction);
  return nephoscope::ReadVdbImage(request, image, warnings);
}

std::string Read(
  const nephoscope::VdbRequest& request, vtkDataObject* output, std::vector<std::string>& warnings)
{
  try
  {
    vtkImageData* image = vtkImageData::SafeDownCast(output);
    return image ? ReadImage(request, image, warnings)
                 : nephoscope::ReadVdbPoints(request, vtkPolyData::SafeDownCast(output), warnings);
  }
  catch (const std::bad_alloc&)
  {
    return "There is not enough memory for the grids of '" + request.File +
      "': choose fewer of them.";
  }
}

// The problem with a file name, or an empty string.
std::string CheckFile(const std::string& name)
{
  if (name.empty())
  {
    return "No file: SetFileName gives the .vdb file to read.";
  }
  if (!vtksys::SystemTools::FileExists(name, true))
  {
    return "There is no file '" + name + "'.";
  }
  if (!vtkSparseVolumeReader::CanReadFile(name.c_str()))
  {
    return "'" + name + "' is not a .vdb file: it does not begin like one.";
  }
  return {};
}
}

std::string vtkSparseVolumeReader::vtkInternals::Names() const
{
  std::string names;
  for (const VdbGridInfo& grid : this->Grids)
  {
    names += (names.empty() ? "'" : ", '") + grid.Name + "'";
  }
  return names.empty() ? "none" : names;
}

// An error if nothing can be read, and a warning for each chosen grid that does not exist.
std::string vtkSparseVolumeReader::vtkInternals::CheckChoice(vtkDataArraySelection* selection,
  const std::vector<VdbGridInfo>& chosen, bool asImage, std::vector<std::string>& warnings) const
{
  for (int i = 0; i < selection->GetNumberOfArrays(); ++i)
  {
    const std::string name = selection->GetArrayName(i);
    const bool known = std::any_of(
      this->Grids.begin(), this->Grids.end(), [&](const VdbGridInfo& g) { return g.Name == name; });
    if (!known && selection->ArrayIsEnabled(name.c_str()))
    {
      warnings.push_back(
        "'" + this->ListedFile + "' has no grid '" + name + "'. There are: " + this->Names() + ".");
    }
  }
  for (const VdbGridInfo& grid : this->Grids)
  {
    if (!grid.Refusal.empty())
    {
      warnings.push_back("The grid '" + grid.Name + "' is left out: " + grid.Refusal + ".");
    }
  }
  if (chosen.empty())
  {
    return "No grid of '" + this->ListedFile +
      "' is chosen that can be read. There are: " + this->Names() + ".";
  }
  if (chosen[0].IsEmpty())
  {
    warnings.push_back(
      "The grid '" + chosen[0].Name + "' has no active voxels: the output is empty.");
  }
  if (asImage && !nephoscope::IsRectangular(chosen[0].IndexToWorld))
  {
    return "The voxels of the grid '" + chosen[0].Name +
      "' are sheared, which an image cannot be: read them as points.";
  }
  return {};
}

vtkSparseVolumeReader::vtkSparseVolumeReader()
  : Internals(new vtkInternals)
{
  this->SetNumberOfInputPorts(0);
}

vtkSparseVolumeReader::~vtkSparseVolumeReader() = default;

bool vtkSparseVolumeReader::HasOpenVDB()
{
  return nephoscope::HasOpenVDB();
}

// The format begins with the number 0x56444220 in eight bytes, lowest first.
int vtkSparseVolumeReader::CanReadFile(const char* name)
{
  const char magic[8] = { 0x20, 0x42, 0x44, 0x56, 0, 0, 0, 0 };
  char begin[8] = {};
  if (!name)
  {
    return 0;
  }
  vtksys::ifstream file(name, std::ios::binary);
  file.read(begin, 8);
  return file && std::memcmp(begin, magic, 8) == 0;
}

vtkDataArraySelection* vtkSparseVolumeReader::GetGridSelection()
{
  return this->GridSelection;
}

vtkMTimeType vtkSparseVolumeReader::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->GridSelection->GetMTime());
}

int vtkSparseVolumeReader::GetNumberOfGrids()
{
  return static_cast<int>(this->Internals->Grids.size());
}

std::string vtkSparseVolumeReader::GetGridName(int grid)
{
  return this->Internals->Grid(grid).Name;
}

std::string vtkSparseVolumeReader::GetGridType(int grid)
{
  return this->Internals->Grid(grid).Type;
}

std::string vtkSparseVolumeReader::GetGridClass(int grid)
{
  return this->Internals->Grid(grid).Class;
}

vtkTypeInt64 vtkSparseVolumeReader::GetGridNumberOfActiveVoxels(int grid)
{
  return this->Internals->Grid(grid).ActiveVoxels;
}

void vtkSparseVolumeReader::GetGridExtent(int grid, int extent[6])
{
  std::copy_n(this->Internals->Grid(grid).Extent, 6, extent);
}

void vtkSparseVolumeReader::GetGridSpacing(int grid, double spacing[3])
{
  const nephoscope::Vector3 edges = nephoscope::Spacing(this->Internals->Grid(grid).IndexToWorld);
  std::copy(edges.begin(), edges.end(), spacing);
}

std::string vtkSparseVolumeReader::GetGridRefusal(int grid)
{
  return this->Internals->Grid(grid).Refusal;
}

std::string vtkSparseVolumeReader::GetGridDescription(int grid)
{
  const VdbGridInfo& info = this->Internals->Grid(grid);
  std::ostringstream text;
  text << info.Name << ": ";
  if (!info.Refusal.empty())
  {
    text << "cannot be read, " << info.Refusal;
    return text.str();
  }
  const nephoscope::Vector3 edges = nephoscope::Spacing(info.IndexToWorld);
  text << info.Type << (info.Half ? " saved as half" : "") << ", " << info.Class << ", "
       << info.ActiveVoxels << " active voxels of " << edges[0] << " x " << edges[1] << " x "
       << edges[2];
  if (!info.IsEmpty())
  {
    const int* e = info.Extent;
    text << ", indices " << e[0] << " to " << e[1] << ", " << e[2] << " to " << e[3] << ", " << e[4]
         << " to " << e[5];
  }
  return text.str();
}

int vtkSparseVolumeReader::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkDataSet");
  return 1;
}

int vtkSparseVolumeReader::RequestDataObject(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkInformation* info = outputs->GetInformationObject(0);
  vtkDataObject* output = vtkDataObject::GetData(info);
  if (this->OutputType == IMAGE && !vtkImageData::SafeDownCast(output))
  {
    info->Set(vtkDataObject::DATA_OBJECT(), vtkNew<vtkImageData>());
  }
  if (this->OutputType == POINTS && !vtkPolyData::SafeDownCast(output))
  {
    info->Set(vtkDataObject::DATA_OBJECT(), vtkNew<vtkPolyData>());
  }
  return 1;
}

// The grids that are chosen, with that of the smallest voxels, which gives the lattice, first.
static std::vector<VdbGridInfo> ChosenGrids(
  const std::vector<VdbGridInfo>& grids, vtkDataArraySelection* selection)
{
  std::vector<VdbGridInfo> chosen;
  for (const VdbGridInfo& grid : grids)
  {
    if (grid.Refusal.empty() && selection->ArrayIsEnabled(grid.Name.c_str()))
    {
      chosen.push_back(grid);
    }
  }
  // Those without voxels come last; voxels a millionth smaller are not smaller.
  auto best =
    std::min_element(chosen.begin(), chosen.end(), [](const VdbGridInfo& a, const VdbGridInfo& b) {
      return a.IsEmpty() != b.IsEmpty() ? b.IsEmpty()
                                        : nephoscope::VoxelVolume(a.IndexToWorld) <
          (1 - 1e-6) * nephoscope::VoxelVolume(b.IndexToWorld);
    });
  if (best != chosen.end())
  {
    std::rotate(chosen.begin(), best, best + 1);
  }
  return chosen;
}

int vtkSparseVolumeReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkInternals& self = *this->Internals;
  std::string error = CheckFile(this->FileName);
  const long int changed = error.empty() ? vtksys::SystemTools::ModifiedTime(this->FileName) : 0;
  if (error.empty() && (self.ListedFile != this->FileName || self.ListedTime != changed))
  {
    self.Grids = nephoscope::ListVdbGrids(this->FileName, error);
    if (error.empty() && self.Grids.empty())
    {
      error = "'" + this->FileName + "' has no grids.";
    }
  }
  self.ListedFile = error.empty() ? this->FileName : "";
  self.ListedTime = changed;
  if (!error.empty())
  {
    self.Grids.clear();
    vtkErrorMacro(<< error);
    return 0;
  }
  for (const VdbGridInfo& grid : self.Grids)
  {
    if (grid.Refusal.empty())
    {
      this->GridSelection->AddArray(grid.Name.c_str()); // those that are known keep their state
    }
  }
  vtkInformation* info = outputs->GetInformationObject(0);
  const std::vector<VdbGridInfo> chosen = ChosenGrids(self.Grids, this->GridSelection);
  if (this->OutputType == IMAGE && !chosen.empty())
  {
    int extent[6];
    double origin[3], spacing[3], direction[9];
    JoinExtents(chosen, extent);
    Decompose(chosen[0].IndexToWorld, origin, spacing, direction);
    if (Fits(extent))
    {
      info->Set(SDDP::WHOLE_EXTENT(), extent, 6);
    }
    info->Set(vtkDataObject::ORIGIN(), origin, 3);
    info->Set(vtkDataObject::SPACING(), spacing, 3);
    info->Set(vtkDataObject::DIRECTION(), direction, 9);
  }
  return 1;
}

int vtkSparseVolumeReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkInternals& self = *this->Internals;
  nephoscope::VdbRequest request;
  request.File = this->FileName;
  request.Grids = ChosenGrids(self.Grids, this->GridSelection);
  request.SplitTiles = this->SplitTiles;
  request.MemoryLimit = this->MemoryLimit * gibibyte;
  request.Aborted = [this]() { return this->GetAbortExecute() != 0; };
  std::vector<std::string> warnings;
  std::string error =
    self.CheckChoice(this->GridSelection, request.Grids, this->OutputType == IMAGE, warnings);
  if (error.empty() && !request.Grids[0].IsEmpty())
  {
    vtkDataObject* output = vtkDataObject::GetData(outputs);
    nephoscope::WithThreads([&]() { error = Read(request, output, warnings); });
  }
  for (const std::string& warning : warnings)
  {
    vtkWarningMacro(<< warning);
  }
  if (!error.empty())
  {
    vtkDataObject::GetData(outputs)->Initialize();
    vtkErrorMacro(<< error);
    return 0;
  }
  return 1;
}

void vtkSparseVolumeReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n";
  os << indent << "OutputType: " << (this->OutputType == IMAGE ? "image" : "points") << "\n";
  os << indent << "SplitTiles: " << (this->SplitTiles ? "on" : "off") << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << " GiB\n";
  os << indent << "GridSelection:\n";
  this->GridSelection->PrintSelf(os, indent.GetNextIndent());
}
