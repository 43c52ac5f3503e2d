// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGlobeTerrain.h"

#include "MessageSuppression.h"
#include "TerrainSurface.h"

#include "vtkCellData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStructuredGrid.h"

#include <array>

vtkStandardNewMacro(vtkGlobeTerrain);

namespace
{
std::string ArraysOf(vtkDataSet* data)
{
  std::string names;
  for (vtkDataSetAttributes* attributes :
    { static_cast<vtkDataSetAttributes*>(data->GetPointData()),
      static_cast<vtkDataSetAttributes*>(data->GetCellData()) })
  {
    for (int a = 0; a < attributes->GetNumberOfArrays(); ++a)
    {
      if (attributes->GetArrayName(a) &&
        std::string(attributes->GetArrayName(a)) != vtkDataSetAttributes::GhostArrayName())
      {
        names += (names.empty() ? "'" : ", '") + std::string(attributes->GetArrayName(a)) + "'";
      }
    }
  }
  return names.empty() ? "none" : names;
}

int FlatAxes(vtkDataSet* data)
{
  double bounds[6];
  data->GetBounds(bounds);
  return (bounds[0] < bounds[1] ? 0 : 1) + (bounds[2] < bounds[3] ? 0 : 1) +
    (bounds[4] < bounds[5] ? 0 : 1);
}
}

vtkGlobeTerrain::vtkGlobeTerrain()
{
  this->SetNumberOfInputPorts(1);
  this->SetHeightArrayName("orog");
  this->SetWindArrayNames("", "", "");
  this->SetLevelUnits(HEIGHT_M);
  this->SetMaskBelowGround(false);
}

bool vtkGlobeTerrain::IsTerrain(vtkDataSet* input)
{
  const std::string name = this->GetHeightArrayName();
  if (!input->GetPointData()->HasArray(name.c_str()) &&
    !input->GetCellData()->HasArray(name.c_str()))
  {
    vtkErrorMacro("There is no array '"
      << name << "' of the height of the ground; arrays: " << ArraysOf(input)
      << ". Set HeightArrayName to one of them, or read the file on the dimensions of the terrain: (lat, lon) alone.");
    return false;
  }
  if (input->GetNumberOfPoints() == 0 || FlatAxes(input) != 1 ||
    !(input->GetBounds()[4] == input->GetBounds()[5]))
  {
    vtkErrorMacro(
      "Terrain is one level of longitudes and latitudes, and the input is not. Choose the fields of one level (Extract Subset).");
    return false;
  }
  return true;
}

int vtkGlobeTerrain::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  auto* terrain = vtkStructuredGrid::GetData(outputs, 0);
  {
    nephoscope::ReportOnce report(this, this->Failed);
    const bool isTerrain = this->IsTerrain(vtkDataSet::GetData(inputs[0], 0));
    report.End(isTerrain);
    if (!isTerrain)
    {
      terrain->Initialize();
      return 1;
    }
  }
  // Normals need neighbours: every piece makes the whole level, and gives its part of it.
  using SDDP = vtkStreamingDemandDrivenPipeline;
  vtkInformation* outInfo = outputs->GetInformationObject(0);
  const bool isPart = outInfo->Has(SDDP::UPDATE_EXTENT()) && outInfo->Has(SDDP::WHOLE_EXTENT());
  std::array<int, 6> part{};
  if (isPart)
  {
    outInfo->Get(SDDP::UPDATE_EXTENT(), part.data());
    outInfo->Set(SDDP::UPDATE_EXTENT(), outInfo->Get(SDDP::WHOLE_EXTENT()), 6);
  }
  this->Superclass::RequestData(request, inputs, outputs);
  if (isPart)
  {
    outInfo->Set(SDDP::UPDATE_EXTENT(), part.data(), 6);
  }
  if (terrain->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  const nephoscope::TerrainPlace place = { this->GetProjection() == GLOBE,
    this->GetPlanetRadius() };
  vtkDataArray* land = terrain->GetPointData()->GetArray(this->LandArrayName.c_str());
  nephoscope::FlattenSea(terrain, land, place);
  nephoscope::AddTerrainScale(terrain, land, this->SeaDepth);
  nephoscope::AddTerrainNormals(terrain, place);
  nephoscope::AddTerrainTextureCoordinates(terrain, place);
  if (isPart && part[0] <= part[1] && part[2] <= part[3] && part[4] <= part[5])
  {
    terrain->Crop(part.data());
  }
  return 1;
}

void vtkGlobeTerrain::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "LandArrayName: " << this->LandArrayName << "\n"
     << indent << "SeaDepth: " << this->SeaDepth << "\n";
}
