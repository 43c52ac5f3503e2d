// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSparseVolumeWriter.h"

#include "OwnThreads.h"
#include "VdbWriting.h"

#include "vtkDataSet.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"

#include <algorithm>

vtkStandardNewMacro(vtkSparseVolumeWriter);

void vtkSparseVolumeWriter::AddArrayName(const char* name)
{
  const std::string text = name ? name : "";
  if (!text.empty() &&
    std::find(this->ArrayNames.begin(), this->ArrayNames.end(), text) == this->ArrayNames.end())
  {
    this->ArrayNames.push_back(text);
    this->Modified();
  }
}

void vtkSparseVolumeWriter::ClearArrayNames()
{
  this->ArrayNames.clear();
  this->Modified();
}

void vtkSparseVolumeWriter::SetGridName(const char* array, const char* grid)
{
  if (!array || !grid || !*array || !*grid)
  {
    vtkErrorMacro("SetGridName needs the name of an array and that of the grid; one is empty.");
    return;
  }
  this->GridNames[array] = grid;
  this->Modified();
}

void vtkSparseVolumeWriter::ClearGridNames()
{
  this->GridNames.clear();
  this->Modified();
}

int vtkSparseVolumeWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  return 1;
}

void vtkSparseVolumeWriter::WriteData()
{
  nephoscope::VdbWriteSettings settings;
  settings.File = this->FileName;
  settings.Creator = "Nephoscope " NEPHOSCOPE_VERSION;
  settings.Arrays = this->ArrayNames;
  settings.Names = this->GridNames;
  settings.Tolerance = this->Tolerance;
  settings.Precision = static_cast<nephoscope::VdbPrecision>(this->Precision);
  settings.Compression = static_cast<nephoscope::VdbCompression>(this->Compression);
  settings.VoxelSize = this->VoxelSize;
  settings.MassArray = this->MassArrayName;

  this->SetErrorCode(vtkErrorCode::NoError);
  auto* data = vtkDataSet::SafeDownCast(this->GetInput());
  std::vector<std::string> warnings;
  std::string error;
  if (!data)
  {
    error = "The input is not a dataset.";
  }
  else if (this->FileName.empty())
  {
    error = "No file: SetFileName gives the .vdb file to write.";
  }
  else
  {
    nephoscope::WithThreads([&]() { error = nephoscope::WriteVdb(settings, data, warnings); });
  }
  for (const std::string& warning : warnings)
  {
    vtkWarningMacro(<< warning);
  }
  if (!error.empty())
  {
    this->SetErrorCode(vtkErrorCode::CannotOpenFileError);
    vtkErrorMacro(<< error);
  }
}

void vtkSparseVolumeWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n";
  for (const std::string& name : this->ArrayNames)
  {
    os << indent << "Array: " << name << "\n";
  }
  for (const auto& pair : this->GridNames)
  {
    os << indent << "Array " << pair.first << " to grid " << pair.second << "\n";
  }
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "Precision: " << this->Precision << "\n";
  os << indent << "Compression: " << this->Compression << "\n";
  os << indent << "VoxelSize: " << this->VoxelSize << "\n";
  os << indent << "MassArrayName: " << this->MassArrayName << "\n";
}
