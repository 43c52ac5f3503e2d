// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCloudsOverGlobe.h"

#include "ForwardedMessages.h"
#include "GroundLight.h"

#include "vtkCellArray.h"
#include "vtkCloudOptics.h"
#include "vtkExecutive.h"
#include "vtkGlobeGrid.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkJPEGReader.h"
#include "vtkMath.h"
#include "vtkNetCDFCFReader.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkResourceFileLocator.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStructuredGrid.h"
#include "vtkSunlight.h"
#include "vtkUnsignedCharArray.h"

#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <vector>

using nephoscope::GroundLight;
using SDDP = vtkStreamingDemandDrivenPipeline;

vtkStandardNewMacro(vtkCloudsOverGlobe);

// A name to find this library by.
extern "C" VTKNEPHOSCOPEPARAVIEWFILTERS_EXPORT const char* NephoscopeDataFolder()
{
  return "share/nephoscope";
}

namespace
{
constexpr const char* forecastFile = "gfs_2p5deg_2011101100.nc";
constexpr const char* earthFile = "blue_marble_2048.jpg";
constexpr int columns = 720; // of the Earth's points, half a degree apart
constexpr int rows = 360;
constexpr int sunPort = 2;    // of vtkSunlight
constexpr double white = 0.6; // the light that the preset Nephoscope Sunlight shows as white
constexpr double night = 0.01;
constexpr double gamma = 2.2; // of a display

// The colour of a point of the Earth in the irradiance there. The bytes of the picture are those of
// a display.
void AddColour(
  vtkUnsignedCharArray* colours, vtkImageData* image, int column, int row, double irradiance)
{
  const int* size = image->GetDimensions();
  const int x = std::min((column % columns) * size[0] / columns, size[0] - 1);
  const int y = std::min(row * size[1] / rows, size[1] - 1);
  const double factor = std::pow(std::max(irradiance / white, night), 1 / gamma);
  for (int c = 0; c < 3; ++c)
  {
    const double value = factor * image->GetScalarComponentAsDouble(x, y, 0, c);
    colours->InsertNextValue(static_cast<unsigned char>(std::min(value, 255.0)));
  }
}

// ParaView cuts cells at the borders between ranks. A cut triangle keeps its colours; a cut
// quadrilateral is divided along another diagonal.
vtkSmartPointer<vtkCellArray> TrianglesOfEarth()
{
  auto triangles = vtkSmartPointer<vtkCellArray>::New();
  for (vtkIdType j = 0; j < rows; ++j)
  {
    for (vtkIdType i = 0; i < columns; ++i)
    {
      const vtkIdType first = j * (columns + 1) + i, above = first + columns + 1;
      triangles->InsertNextCell({ first, first + 1, above + 1 });
      triangles->InsertNextCell({ first, above + 1, above });
    }
  }
  return triangles;
}
}

vtkCloudsOverGlobe::vtkCloudsOverGlobe()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
  for (vtkAlgorithm* part :
    std::initializer_list<vtkAlgorithm*>{ this->Reader, this->Globe, this->Optics, this->Light })
  {
    nephoscope::ForwardMessages(part, this);
  }
  this->Reader->SphericalCoordinatesOff();
  this->Globe->SetInputConnection(this->Reader->GetOutputPort());
  this->Optics->SetInputConnection(this->Globe->GetOutputPort());
  this->Light->SetInputConnection(this->Optics->GetOutputPort());
}

vtkCloudsOverGlobe::~vtkCloudsOverGlobe() = default;

int vtkCloudsOverGlobe::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

int vtkCloudsOverGlobe::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkStructuredGrid" : "vtkPolyData");
  return 1;
}

vtkTypeBool vtkCloudsOverGlobe::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  if (request->Has(SDDP::REQUEST_INFORMATION()))
  {
    return this->Inform(outputs);
  }
  if (request->Has(SDDP::REQUEST_DATA()))
  {
    return this->MakeOutputs(outputs);
  }
  return this->Superclass::ProcessRequest(request, inputs, outputs);
}

std::string vtkCloudsOverGlobe::FindFile(const char* name)
{
  std::string folder = this->Folder;
  if (folder.empty())
  {
    const std::string library =
      vtksys::SystemTools::GetRealPath(vtkGetLibraryPathForSymbol(NephoscopeDataFolder));
    vtkNew<vtkResourceFileLocator> locator;
    folder = locator->Locate(vtksys::SystemTools::GetFilenamePath(library),
      std::vector<std::string>{ NephoscopeDataFolder() }, name);
  }
  if (folder.empty())
  {
    vtksys::SystemTools::GetEnv("NEPHOSCOPE_DATA", folder);
  }
  const std::string file = folder + "/" + name;
  if (vtksys::SystemTools::FileExists(file, true))
  {
    return file;
  }
  vtkErrorMacro("There is no file "
    << name << " in "
    << (folder.empty() ? std::string(NephoscopeDataFolder()) + " next to the plugin" : folder)
    << ". Set Folder to the folder Data of Nephoscope's sources.");
  return std::string();
}

int vtkCloudsOverGlobe::Inform(vtkInformationVector* outputs)
{
  const std::string file = this->FindFile(forecastFile);
  if (file.empty())
  {
    return 0;
  }
  if (!this->Reader->GetFileName() || file != this->Reader->GetFileName())
  {
    this->Reader->SetFileName(file.c_str());
    this->Reader->UpdateMetaData();
    this->Reader->SetDimensions("(lev, lat, lon)"); // without the fields at the ground
  }
  this->Globe->SetVerticalExaggeration(this->VerticalExaggeration);
  this->Globe->UpdateInformation();
  vtkInformation* globe = this->Globe->GetOutputInformation(0);
  if (!globe->Has(SDDP::WHOLE_EXTENT()))
  {
    vtkErrorMacro(
      "The file '" << file << "' contains no grid of longitudes, latitudes and levels.");
    return 0;
  }
  int whole[6];
  globe->Get(SDDP::WHOLE_EXTENT(), whole);
  outputs->GetInformationObject(0)->Set(SDDP::WHOLE_EXTENT(), whole, 6);
  outputs->GetInformationObject(0)->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  outputs->GetInformationObject(1)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

int vtkCloudsOverGlobe::MakeOutputs(vtkInformationVector* outputs)
{
  this->Light->SetInputDataObject(sunPort, this->GetInputDataObject(1, 0));
  this->Light->SetDateTime(this->DateTime);
  this->Light->UpdateWholeExtent();
  auto* lit = vtkStructuredGrid::SafeDownCast(this->Light->GetOutputDataObject(0));
  if (!lit || lit->GetNumberOfPoints() == 0) // Sunlight has said why
  {
    return 0;
  }
  vtkInformation* ofClouds = outputs->GetInformationObject(0);
  vtkStructuredGrid* clouds = vtkStructuredGrid::GetData(outputs, 0);
  clouds->ShallowCopy(lit);
  if (ofClouds->Has(SDDP::UPDATE_EXTENT()))
  {
    clouds->Crop(ofClouds->Get(SDDP::UPDATE_EXTENT()));
  }
  vtkInformation* ofEarth = outputs->GetInformationObject(1);
  if (!ofEarth->Has(SDDP::UPDATE_PIECE_NUMBER()) || ofEarth->Get(SDDP::UPDATE_PIECE_NUMBER()) == 0)
  {
    return this->MakeEarth(lit, vtkPolyData::GetData(outputs, 1)) ? 1 : 0;
  }
  return 1;
}

// The picture runs from 180 degrees west to 180 degrees east, its first row is the south.
bool vtkCloudsOverGlobe::MakeEarth(vtkStructuredGrid* lit, vtkPolyData* earth)
{
  const std::string file = this->FindFile(earthFile);
  if (file.empty())
  {
    return false;
  }
  vtkNew<vtkJPEGReader> picture;
  picture->SetFileName(file.c_str());
  picture->Update();
  const GroundLight light(lit);
  vtkNew<vtkPoints> points;
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetName("Earth");
  colours->SetNumberOfComponents(3);
  const double radius = this->Globe->GetPlanetRadius();
  for (int j = 0; j <= rows; ++j)
  {
    const double latitude = vtkMath::Pi() * (static_cast<double>(j) / rows - 0.5);
    for (int i = 0; i <= columns; ++i)
    {
      const double longitude = vtkMath::Pi() * (2.0 * (i % columns) / columns - 1.0);
      const double across = j % rows == 0 ? 0.0 : radius * std::cos(latitude);
      points->InsertNextPoint(
        across * std::cos(longitude), across * std::sin(longitude), radius * std::sin(latitude));
      AddColour(colours, picture->GetOutput(), i, j, light.At(longitude, latitude));
    }
  }
  earth->SetPoints(points);
  earth->SetPolys(TrianglesOfEarth());
  // No active scalars, which ParaView would colour by, with a scalar bar.
  earth->GetPointData()->AddArray(colours);
  return true;
}

void vtkCloudsOverGlobe::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "VerticalExaggeration: " << this->VerticalExaggeration << "\n"
     << indent << "DateTime: " << this->DateTime << "\n"
     << indent << "Folder: " << this->Folder << "\n";
}
