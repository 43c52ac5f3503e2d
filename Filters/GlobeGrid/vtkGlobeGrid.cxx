// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGlobeGrid.h"

#include "EmptyInput.h"
#include "FillValues.h"
#include "GlobeGridBuilder.h"
#include "InputBlocks.h"
#include "MessageSuppression.h"
#include "PoleRows.h"
#include "RequiredInput.h"
#include "SeriesReading.h"

#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkRectilinearGrid.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStructuredGrid.h"

#include <algorithm>

using SDDP = vtkStreamingDemandDrivenPipeline;

vtkStandardNewMacro(vtkGlobeGrid);

namespace
{
// "None" is how ParaView's menus say it.
std::string ArrayName(const std::string& chosen)
{
  return chosen == "None" ? std::string() : chosen;
}

nephoscope::GlobeGridSettings SettingsOf(vtkGlobeGrid* self)
{
  nephoscope::GlobeGridSettings settings;
  settings.OnMap = self->GetProjection() == vtkGlobeGrid::MAP;
  settings.Planet = { self->GetPlanetRadius(), self->GetVerticalExaggeration() };
  settings.UseCentralMeridian = self->GetUseCentralMeridian();
  settings.CentralMeridian = self->GetCentralMeridian();
  settings.Units = static_cast<nephoscope::LevelUnits>(self->GetLevelUnits());
  settings.Height = ArrayName(self->GetHeightArrayName());
  settings.Eastward = ArrayName(self->GetEastwardWindArrayName());
  settings.Northward = ArrayName(self->GetNorthwardWindArrayName());
  settings.Vertical = ArrayName(self->GetVerticalWindArrayName());
  settings.VerticalIsOmega = self->GetVerticalWindIsOmega();
  settings.Temperature = ArrayName(self->GetTemperatureArrayName());
  settings.HeightsIn = static_cast<nephoscope::HeightUnits>(self->GetHeightUnits());
  settings.Components = static_cast<nephoscope::WindComponents>(self->GetWindComponents());
  settings.CloseSeam = self->GetCloseSeam();
  settings.ClosePoles = self->GetClosePoles();
  settings.MaskBelowGround = self->GetMaskBelowGround();
  settings.SurfacePressure = ArrayName(self->GetSurfacePressureArrayName());
  settings.TerrainHeight = ArrayName(self->GetTerrainHeightArrayName());
  return settings;
}

bool Holds(vtkDataSet* data, const std::string& name)
{
  return data->GetPointData()->HasArray(name.c_str()) ||
    data->GetCellData()->HasArray(name.c_str());
}

struct UsualWinds
{
  const char* Eastward;
  const char* Northward;
  const char* Omega;
  const char* Upward;
};

// Names in CMIP and other models that replace default names missing in the data.
void TakeUsualNames(vtkDataSet* data, nephoscope::GlobeGridSettings& settings)
{
  const auto replace = [&](std::string& name, const char* ours,
                         std::initializer_list<const char*> others) {
    for (const char* other : others)
    {
      name = name == ours && !Holds(data, name) && Holds(data, other) ? other : name;
    }
  };
  replace(settings.Height, "gh", { "zg" });
  replace(settings.Temperature, "t", { "ta" });
  const bool asked = settings.Eastward == "u" && settings.Northward == "v";
  for (const UsualWinds& winds :
    { UsualWinds{ "ua", "va", "wap", "wa" }, UsualWinds{ "U", "V", "OMEGA", "W" } })
  {
    if (!asked || Holds(data, "u") || !Holds(data, winds.Eastward) || !Holds(data, winds.Northward))
    {
      continue;
    }
    settings.Eastward = winds.Eastward;
    settings.Northward = winds.Northward;
    if (settings.Vertical == "w" && !Holds(data, "w"))
    {
      settings.VerticalIsOmega = Holds(data, winds.Omega);
      settings.Vertical = Holds(data, winds.Omega) ? winds.Omega
        : Holds(data, winds.Upward)                ? winds.Upward
                                                   : "";
    }
    return;
  }
}

bool ReadGrid(vtkDataSet* data, const std::vector<std::string>& names,
  nephoscope::LonLatLevelGrid& grid, std::string& error)
{
  const bool onCells = data && nephoscope::DataAreOnCells(data, names);
  error = grid.Read(data, onCells);
  return error.empty();
}

std::vector<std::string> FieldNames(const nephoscope::GlobeGridSettings& settings)
{
  return { settings.Height, settings.Eastward, settings.Northward };
}

// Some rows of two levels, all columns: whether seam and poles must be closed shows in longitudes
// and latitudes, and no reader tells them before it reads.
vtkDataSet* PeekAtRows(
  vtkAlgorithm* producer, int port, vtkInformation* inInfo, const int whole[6], int first, int last)
{
  auto* block = vtkDataSet::SafeDownCast(vtkDataObject::GetData(inInfo));
  if (nephoscope::IsOfBlocks(producer, port) && block && block->GetNumberOfPoints() > 0)
  {
    return block; // it is there already
  }
  int rows[6];
  std::copy(whole, whole + 6, rows);
  rows[2] = std::max(first, whole[2]);
  rows[3] = std::min(last, whole[3]);
  rows[5] = std::min(whole[4] + 1, whole[5]);
  vtkNew<vtkInformationVector> requests;
  requests->SetNumberOfInformationObjects(port + 1);
  requests->GetInformationObject(port)->Set(SDDP::UPDATE_EXTENT(), rows, 6);
  if (!producer->Update(port, requests))
  {
    return nullptr;
  }
  return vtkDataSet::SafeDownCast(producer->GetOutputDataObject(port));
}

// The rows that PeekAtRows reads; false if the input is not a grid (RequestData reports the
// problem).
bool PeekAtGrid(vtkAlgorithm* producer, int port, vtkInformation* inInfo, const int whole[6],
  int first, int last, nephoscope::GlobeGridSettings settings, nephoscope::LonLatLevelGrid& grid,
  bool& onCells)
{
  std::string error;
  vtkDataSet* rows = PeekAtRows(producer, port, inInfo, whole, first, last);
  if (!rows || rows->GetNumberOfPoints() == 0)
  {
    return false;
  }
  TakeUsualNames(rows, settings);
  onCells = nephoscope::DataAreOnCells(rows, FieldNames(settings));
  return ReadGrid(rows, FieldNames(settings), grid, error);
}

// The rows that will be added at the poles; three rows at each end make two rows of cells.
int CountPoles(vtkAlgorithm* producer, int port, vtkInformation* inInfo, const int whole[6],
  const nephoscope::GlobeGridSettings& settings)
{
  std::array<bool, 2> missing = { false, false };
  for (const int first : { whole[2], whole[3] - 2 })
  {
    nephoscope::LonLatLevelGrid grid;
    bool onCells = false;
    if (PeekAtGrid(producer, port, inInfo, whole, first, first + 2, settings, grid, onCells))
    {
      const std::array<bool, 2> here = nephoscope::MissingPoles(grid);
      missing = { missing[0] || here[0], missing[1] || here[1] };
    }
  }
  return (missing[0] ? 1 : 0) + (missing[1] ? 1 : 0);
}
}

vtkGlobeGrid::vtkGlobeGrid()
{
  this->SetNumberOfInputPorts(2);
}

void vtkGlobeGrid::SetWindArrayNames(
  const std::string& eastward, const std::string& northward, const std::string& vertical)
{
  this->SetEastwardWindArrayName(eastward);
  this->SetNorthwardWindArrayName(northward);
  this->SetVerticalWindArrayName(vertical);
}

int vtkGlobeGrid::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkRectilinearGrid");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkStructuredGrid");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port == 1 ? 1 : 0);
  if (port == 0)
  {
    nephoscope::TakeAnyData(info);
  }
  return 1;
}

vtkTypeBool vtkGlobeGrid::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return nephoscope::HasOtherInput(this, this->ToldOfInput, request, inputs, outputs,
           { "vtkImageData", "vtkRectilinearGrid", "vtkStructuredGrid" },
           "It must be a grid of longitudes, latitudes and levels: an image, a rectilinear or a structured grid.") ||
    this->Superclass::ProcessRequest(request, inputs, outputs);
}

int vtkGlobeGrid::RequestInformation(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkInformation* inInfo = inputs[0]->GetInformationObject(0);
  if (!inInfo->Has(SDDP::WHOLE_EXTENT()))
  {
    return 1; // a group of grids; each is asked by itself
  }
  int whole[6];
  inInfo->Get(SDDP::WHOLE_EXTENT(), whole);
  int port = 0;
  vtkAlgorithm* producer = this->GetInputAlgorithm(0, 0, port);
  const auto settings = SettingsOf(this);
  nephoscope::LonLatLevelGrid grid;
  bool onCells = false;
  const int middle = (whole[2] + whole[3]) / 2;
  if (producer && whole[0] <= whole[1] && whole[2] <= whole[3] && whole[4] <= whole[5] &&
    PeekAtGrid(producer, port, inInfo, whole, middle, middle + 1, settings, grid, onCells))
  {
    const bool closed = settings.ClosePoles && nephoscope::SpansAllLongitudes(grid);
    const int columns = nephoscope::PlanColumns(grid, settings).OutputDimensions[0];
    const int poles = closed ? CountPoles(producer, port, inInfo, whole, settings) : 0;
    whole[1] = whole[0] + columns - 1;
    whole[3] += poles - (onCells && whole[3] > whole[2] ? 1 : 0);
    whole[5] -= onCells && whole[5] > whole[4] ? 1 : 0;
  }
  vtkInformation* outInfo = outputs->GetInformationObject(0);
  outInfo->Set(SDDP::WHOLE_EXTENT(), whole, 6);
  outInfo->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  return 1;
}

int vtkGlobeGrid::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  for (int port = 0; port < this->GetNumberOfInputPorts(); ++port)
  {
    if (inputs[port]->GetNumberOfInformationObjects() == 0)
    {
      continue;
    }
    nephoscope::AskForWholeExtent(inputs[port]->GetInformationObject(0));
  }
  return 1;
}

int vtkGlobeGrid::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  nephoscope::ReportOnce report(this, this->Failed);
  const bool made = this->MakeGrid(inputs, outputs);
  report.End(made);
  if (!made)
  {
    vtkStructuredGrid::GetData(outputs, 0)
      ->Initialize(); // without the executive's own errors, and those of all filters behind
  }
  return 1;
}

bool vtkGlobeGrid::MakeGrid(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkDataSet* input = vtkDataSet::GetData(inputs[0], 0);
  vtkStructuredGrid* output = vtkStructuredGrid::GetData(outputs, 0);
  if (!(this->PlanetRadius > 0.0) || !(this->VerticalExaggeration >= 0.0))
  {
    vtkErrorMacro(
      "PlanetRadius must be greater than 0 and VerticalExaggeration 0 or more; they are "
      << this->PlanetRadius << " and " << this->VerticalExaggeration << ".");
    return false;
  }
  auto settings = SettingsOf(this);
  std::string error;
  nephoscope::LonLatLevelGrid grid;
  if (input)
  {
    TakeUsualNames(input, settings);
  }
  if (!ReadGrid(input, FieldNames(settings), grid, error))
  {
    vtkErrorMacro(<< nephoscope::InBlock(this, input) << error);
    return false;
  }
  vtkDataSet* surfaceData =
    this->GetNumberOfInputPorts() > 1 ? vtkDataSet::GetData(inputs[1], 0) : nullptr;
  nephoscope::LonLatLevelGrid surface;
  const bool hasSurface = surfaceData &&
    ReadGrid(surfaceData, { settings.SurfacePressure, settings.TerrainHeight }, surface, error);
  if (surfaceData && !hasSurface)
  {
    vtkWarningMacro("The surface input is not used. " << error);
  }
  nephoscope::GlobeGridBuilder builder(grid, settings);
  error = builder.Plan(input->GetFieldData(), hasSurface ? &surface : nullptr);
  if (!error.empty())
  {
    vtkErrorMacro(<< nephoscope::InBlock(this, input) << error);
    return false;
  }
  if (this->BuildPiece(
        &builder, grid.FirstIndex().data(), outputs->GetInformationObject(0), output))
  {
    for (const std::string& warning : builder.Warnings())
    {
      vtkWarningMacro(<< nephoscope::InBlock(this, input) << warning);
    }
    const std::string fillValues = nephoscope::DescribeFillValues(input);
    if (!fillValues.empty())
    {
      vtkWarningMacro(<< nephoscope::InBlock(this, input) << fillValues);
    }
  }
  return true;
}

// False where nothing is left.
bool vtkGlobeGrid::BuildPiece(nephoscope::GlobeGridBuilder* builder, const int first[3],
  vtkInformation* outInfo, vtkStructuredGrid* output)
{
  const std::array<int, 3>& size = builder->Order().OutputDimensions;
  int extent[6];  // of the output
  int indices[6]; // the same, from 0
  const bool asked = outInfo->Has(SDDP::UPDATE_EXTENT()) != 0;
  outInfo->Get(SDDP::UPDATE_EXTENT(), extent);
  for (int axis = 0; axis < 3; ++axis)
  {
    const int lowest = first[axis];
    const int highest = first[axis] + size[axis] - 1;
    extent[2 * axis] = asked ? std::max(extent[2 * axis], lowest) : lowest;
    extent[2 * axis + 1] = asked ? std::min(extent[2 * axis + 1], highest) : highest;
    if (extent[2 * axis] > extent[2 * axis + 1])
    {
      output->Initialize(); // a piece with nothing in it
      return false;
    }
    indices[2 * axis] = extent[2 * axis] - first[axis];
    indices[2 * axis + 1] = extent[2 * axis + 1] - first[axis];
  }
  const bool finished = builder->Build(indices, output, [this](double progress) {
    this->UpdateProgress(progress);
    return !this->CheckAbort();
  });
  if (!finished)
  {
    output->Initialize(); // aborted: nothing rather than a part
    return false;
  }
  output->SetExtent(extent);
  this->AddProjection(output);
  return true;
}

// So that other filters can tell longitudes, latitudes and heights from positions.
void vtkGlobeGrid::AddProjection(vtkStructuredGrid* output)
{
  const auto add = [&](const char* name, double value) {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->InsertNextValue(value);
    output->GetFieldData()->AddArray(array);
  };
  add("GlobeGridProjection", this->Projection);
  add("PlanetRadius", this->PlanetRadius);
  add("VerticalExaggeration", this->VerticalExaggeration);
}

void vtkGlobeGrid::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Projection: " << (this->Projection == MAP ? "Map" : "Globe") << "\n"
     << indent << "PlanetRadius: " << this->PlanetRadius << "\n"
     << indent << "VerticalExaggeration: " << this->VerticalExaggeration << "\n"
     << indent << "UseCentralMeridian: " << this->UseCentralMeridian << "\n"
     << indent << "CentralMeridian: " << this->CentralMeridian << "\n"
     << indent << "LevelUnits: " << this->LevelUnits << "\n"
     << indent << "HeightArrayName: " << this->HeightArrayName << "\n"
     << indent << "EastwardWindArrayName: " << this->EastwardWindArrayName << "\n"
     << indent << "NorthwardWindArrayName: " << this->NorthwardWindArrayName << "\n"
     << indent << "VerticalWindArrayName: " << this->VerticalWindArrayName << "\n"
     << indent << "VerticalWindIsOmega: " << this->VerticalWindIsOmega << "\n"
     << indent << "TemperatureArrayName: " << this->TemperatureArrayName << "\n"
     << indent << "HeightUnits: " << this->HeightUnits << "\n"
     << indent << "WindComponents: " << this->WindComponents << "\n"
     << indent << "ClosePoles: " << this->ClosePoles << "\n"
     << indent << "CloseSeam: " << this->CloseSeam << "\n"
     << indent << "MaskBelowGround: " << this->MaskBelowGround << "\n"
     << indent << "SurfacePressureArrayName: " << this->SurfacePressureArrayName << "\n"
     << indent << "TerrainHeightArrayName: " << this->TerrainHeightArrayName << "\n";
}
