// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCloudTextureRepresentation.h"

#include "DataSets.h"
#include "EmptyInput.h"
#include "ForwardedMessages.h"
#include "NeighborCells.h"
#include "RankPieces.h"
#include "RankRegions.h"
#include "Ranks.h"
#include "SurfaceLength.h"
#include "vtkCloudTextureMapper.h"

#include "vtkAlgorithm.h"
#include "vtkAlgorithmOutput.h"
#include "vtkBoundingBox.h"
#include "vtkCommunicator.h"
#include "vtkCompositeDataSet.h"
#include "vtkFieldData.h"
#include "vtkHyperTreeGrid.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPVLODActor.h"
#include "vtkPVRenderView.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTrivialProducer.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkCloudTextureRepresentation);

namespace
{
constexpr nephoscope::RankRegion allOfSpace{ { 1, -1, 1, -1, 1, -1 } }; // as the mapper has it

// "None" is what the menu says.
const char* ArrayName(const char* chosen)
{
  return chosen && std::string(chosen) != "None" ? chosen : "";
}

std::vector<vtkPolyData*> SurfacesOf(vtkDataObject* data)
{
  std::vector<vtkPolyData*> surfaces;
  for (vtkDataSet* set : nephoscope::DataSetsOf(data))
  {
    if (auto* surface = vtkPolyData::SafeDownCast(set))
    {
      surfaces.push_back(surface);
    }
  }
  return surfaces;
}

bool HasTreesInSpace(vtkDataObject* data)
{
  const auto trees = vtkCompositeDataSet::GetDataSets<vtkHyperTreeGrid>(data);
  return std::any_of(
    trees.begin(), trees.end(), [](vtkHyperTreeGrid* tree) { return tree->GetDimension() == 3; });
}

int NumberOfRanks()
{
  auto* controller = vtkMultiProcessController::GetGlobalController();
  return controller ? controller->GetNumberOfProcesses() : 1;
}

bool IsEmpty(vtkCompositeDataSet* data)
{
  if (!data)
  {
    return true;
  }
  auto blocks = vtk::TakeSmartPointer(data->NewIterator());
  blocks->InitTraversal();
  return blocks->IsDoneWithTraversal();
}

// Collective.
nephoscope::SurfaceLength LengthOverRanks(vtkDataObject* data)
{
  nephoscope::SurfaceLength length;
  for (vtkPolyData* surface : SurfacesOf(data))
  {
    length.Add(surface);
  }
  auto* controller = vtkMultiProcessController::GetGlobalController();
  if (NumberOfRanks() > 1)
  {
    const double least[4] = { length.Low[0], length.Low[1], length.Low[2], length.SmallestRadius };
    const double most[4] = { length.High[0], length.High[1], length.High[2], length.LargestRadius };
    double low[4];
    double high[4];
    controller->AllReduce(least, low, 4, vtkCommunicator::MIN_OP);
    controller->AllReduce(most, high, 4, vtkCommunicator::MAX_OP);
    for (int c = 0; c < 3; ++c)
    {
      length.Low[c] = low[c];
      length.High[c] = high[c];
    }
    length.SmallestRadius = low[3];
    length.LargestRadius = high[3];
  }
  return length;
}

// Collective: points of the input, and polygons with strips of its surfaces, of all ranks.
std::array<vtkIdType, 2> SizeOverRanks(vtkDataObject* input, vtkDataObject* data)
{
  std::array<vtkIdType, 2> size = { { input->GetNumberOfElements(vtkDataObject::POINT), 0 } };
  for (vtkPolyData* surface : SurfacesOf(data))
  {
    size[1] += surface->GetNumberOfPolys() + surface->GetNumberOfStrips();
  }
  auto* controller = vtkMultiProcessController::GetGlobalController();
  if (NumberOfRanks() > 1)
  {
    const std::array<vtkIdType, 2> mine = size;
    controller->AllReduce(mine.data(), size.data(), 2, vtkCommunicator::SUM_OP);
  }
  return size;
}

// Travels with the data as a field array, so that every time step in ParaView's cache keeps its
// own.
void StoreLength(vtkPolyData* surface, const nephoscope::SurfaceLength& length)
{
  vtkNew<vtkFieldData> own; // the input shares its field data with the copy
  own->ShallowCopy(surface->GetFieldData());
  length.Tell(own);
  surface->SetFieldData(own);
}

// A client gets them as pieces of the ranks; those in partitions stay apart on their way.
// Collective.
void PlaceSurfaces(vtkDataObject* surfaces)
{
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(surfaces);
  if (NumberOfRanks() > 1 && blocks)
  {
    nephoscope::PlacePieces(blocks, blocks);
  }
  else if (NumberOfRanks() > 1)
  {
    const std::vector<vtkPolyData*> pieces = SurfacesOf(surfaces);
    std::for_each(pieces.begin(), pieces.end(), nephoscope::MarkPiece);
  }
}
}

vtkCloudTextureRepresentation::vtkCloudTextureRepresentation()
{
  // The superclass sets what colours on its own mapper, which is never drawn: the cloud mapper
  // takes one surface, not blocks.
  this->Actor->SetMapper(this->CloudMapper);
  nephoscope::ForwardMessages(this->CloudMapper, this);
  this->SuppressLOD = true;
  this->SetNumberOfInputPorts(2);
  this->Volume = vtkSmartPointer<vtkMultiBlockDataSet>::New();
}

vtkCloudTextureRepresentation::~vtkCloudTextureRepresentation() = default;

void vtkCloudTextureRepresentation::SetDensityVolumeConnection(vtkAlgorithmOutput* volume)
{
  this->SetInputConnection(1, volume);
}

void vtkCloudTextureRepresentation::RemoveDensityVolume()
{
  this->SetInputConnection(1, nullptr);
}

int vtkCloudTextureRepresentation::FillInputPortInformation(int port, vtkInformation* info)
{
  const int filled = this->Superclass::FillInputPortInformation(port, info);
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return filled;
}

int vtkCloudTextureRepresentation::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const int asked = this->Superclass::RequestUpdateExtent(request, inputs, outputs);
  this->RequestNeighborCells(inputs[0]);
  auto* controller = vtkMultiProcessController::GetGlobalController();
  for (int i = 0; i < inputs[1]->GetNumberOfInformationObjects(); ++i)
  {
    vtkInformation* input = inputs[1]->GetInformationObject(i);
    input->Set(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER(),
      controller ? controller->GetLocalProcessId() : 0);
    input->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES(),
      controller ? controller->GetNumberOfProcesses() : 1);
    input->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  }
  return asked;
}

// Surfaces and grids one point thick need none. Where a source has none, RequestData adds them.
void vtkCloudTextureRepresentation::RequestNeighborCells(vtkInformationVector* inputs)
{
  for (int i = 0; NumberOfRanks() > 1 && i < inputs->GetNumberOfInformationObjects(); ++i)
  {
    vtkInformation* input = inputs->GetInformationObject(i);
    vtkDataObject* data = vtkDataObject::GetData(input);
    if (vtkUnstructuredGrid::SafeDownCast(data) || vtkCompositeDataSet::SafeDownCast(data))
    {
      const int levels =
        input->Get(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS());
      input->Set(
        vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), std::max(levels, 1));
    }
  }
}

// What is delivered is the same object while the data are: what the mapper makes of it takes time.
// It is of one type with all data, and where there are none: a client that has none yet must know
// what it gets. Collective.
void vtkCloudTextureRepresentation::ReadVolume(vtkInformationVector* inputs)
{
  vtkDataObject* given =
    inputs->GetNumberOfInformationObjects() > 0 ? vtkDataObject::GetData(inputs, 0) : nullptr;
  const vtkMTimeType time = given ? given->GetMTime() : 0;
  const bool isOther = given != this->ReadFrom || time != this->ReadTime;
  if (nephoscope::MaximumOverRanks(isOther ? 1 : 0) == 0)
  {
    return;
  }
  this->ReadFrom = given;
  this->ReadTime = time;
  this->Volume = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  if (NumberOfRanks() > 1)
  {
    nephoscope::PlacePieces(given, this->Volume);
  }
  else if (given)
  {
    auto copy = vtk::TakeSmartPointer(given->NewInstance());
    copy->ShallowCopy(given);
    this->Volume->SetBlock(0, copy);
  }
}

int vtkCloudTextureRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  this->CompleteInput(inputs[0]);
  const int made = this->Superclass::RequestData(request, inputs, outputs);
  this->ReadVolume(inputs[1]);
  vtkDataObject* surfaces = this->MultiBlockMaker->GetOutputDataObject(0);
  if (inputs[0]->GetNumberOfInformationObjects() > 0)
  {
    this->WarnOfNothing(vtkDataObject::GetData(inputs[0], 0), surfaces);
    this->WarnOfVolume(vtkDataObject::GetData(inputs[0], 0));
  }
  const nephoscope::SurfaceLength length = LengthOverRanks(surfaces);
  for (vtkPolyData* surface : SurfacesOf(surfaces))
  {
    StoreLength(surface, length);
  }
  PlaceSurfaces(surfaces);
  return made;
}

// Called by all ranks.
void vtkCloudTextureRepresentation::CompleteInput(vtkInformationVector* inputs)
{
  vtkDataObject* input =
    inputs->GetNumberOfInformationObjects() > 0 ? vtkDataObject::GetData(inputs, 0) : nullptr;
  const vtkSmartPointer<vtkDataObject> completed = nephoscope::WithNeighborCells(input);
  this->CompletedInput = nullptr;
  if (completed != input)
  {
    this->CompletedInput = vtkSmartPointer<vtkTrivialProducer>::New();
    this->CompletedInput->SetOutput(completed);
  }
}

vtkAlgorithmOutput* vtkCloudTextureRepresentation::GetInternalOutputPort(int port, int connection)
{
  return port == 0 && this->CompletedInput
    ? this->CompletedInput->GetOutputPort()
    : this->Superclass::GetInternalOutputPort(port, connection);
}

int vtkCloudTextureRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo)
{
  if (!this->Superclass::ProcessViewRequest(request, inInfo, outInfo))
  {
    return 0;
  }
  if (request == vtkPVView::REQUEST_UPDATE())
  {
    vtkPVView::SetPiece(inInfo, this, this->Volume, 0, 1);
    // Where ranks draw is chosen by their surfaces, which stay where they are: each rank gets all
    // of them.
    vtkPVRenderView::SetOrderedCompositingConfiguration(
      inInfo, this, vtkPVRenderView::USE_DATA_FOR_LOAD_BALANCING);
  }
  if (request == vtkPVView::REQUEST_RENDER())
  {
    this->TakeDelivered(vtkPVView::GetDeliveredPiece(inInfo, this),
      vtkCompositeDataSet::SafeDownCast(vtkPVView::GetDeliveredPiece(inInfo, this, 1)));
  }
  return 1;
}

// Told here once, of all ranks; without a surface the mapper has nothing to add.
void vtkCloudTextureRepresentation::WarnOfNothing(vtkDataObject* input, vtkDataObject* surfaces)
{
  const auto [points, polygons] = SizeOverRanks(input, surfaces);
  std::string nothing;
  if (polygons == 0)
  {
    nothing = points == 0 ? "Nothing is drawn. " + std::string(nephoscope::whyEmpty)
                          : "Nothing is drawn: the input has " + std::to_string(points) +
        " points but no polygons for the texture. Make a surface of them (Cloud Surface, Contour, Delaunay 2D), or choose the representation "
        "Textured Splats.";
    for (vtkPolyData* surface : SurfacesOf(surfaces))
    {
      surface->Initialize();
    }
  }
  auto* controller = vtkMultiProcessController::GetGlobalController();
  vtkAlgorithm* producer = nephoscope::ProducerOfInput(this);
  if (nothing != this->Nothing && !nothing.empty() &&
    !nephoscope::HasFailed(producer, this->GetInputDataObject(0, 0)) &&
    (!controller || controller->GetLocalProcessId() == 0))
  {
    vtkWarningMacro(<< nothing);
  }
  this->Nothing = nothing;
}

// Their outer surface is seldom that of a cloud.
void vtkCloudTextureRepresentation::WarnOfVolume(vtkDataObject* input)
{
  const bool hasTrees = input && HasTreesInSpace(input);
  const std::vector<vtkDataSet*> sets =
    input ? nephoscope::DataSetsOf(input) : std::vector<vtkDataSet*>();
  const bool hasVolumes = hasTrees || std::any_of(sets.begin(), sets.end(), nephoscope::HasVolumes);
  if (hasVolumes && !this->HasToldOfVolume)
  {
    const char* first = hasTrees
      ? "HyperTreeGrid To UnstructuredGrid, Cell Data to Point Data and Contour"
      : "Cloud Surface (to a grid) or Contour";
    vtkWarningMacro("The input " << (hasTrees ? "is a hyper tree grid" : "has 3-D cells")
                                 << ", and " << (hasTrees ? "its" : "their")
                                 << " outer surface is drawn. For the surface of clouds inside "
                                 << (hasTrees ? "it" : "them") << " apply " << first << " first.");
  }
  this->HasToldOfVolume = hasVolumes;
}

// Where ranks draw in regions of their own, each gets the surface and the density of all: a cloud
// may begin in the region of one rank and end in that of another. A client that draws the data of
// several ranks has them in pieces. Collective.
void vtkCloudTextureRepresentation::TakeDelivered(
  vtkDataObject* surface, vtkCompositeDataSet* volume)
{
  const std::vector<vtkBoundingBox>* boxes =
    NumberOfRanks() > 1 ? nephoscope::BoxesOfRanks(this->GetView()) : nullptr;
  const bool hasPieces = boxes || (NumberOfRanks() == 1 && nephoscope::HasMarkedPieces(surface));
  if (hasPieces)
  {
    surface = this->Surfaces.Of(surface, "",
      [](vtkDataObject* own, const std::string&) { return nephoscope::SurfacesOfRanks(own); });
  }
  if (hasPieces && this->CloudMapper->GetUseThickness())
  {
    vtkMultiBlockDataSet* whole = this->Densities.Of(
      volume, this->CloudMapper->GetDensityArrayName(), nephoscope::DensitiesOfRanks);
    volume = IsEmpty(whole) ? volume : whole; // what is no grid has its message
  }
  this->CloudMapper->SetDensityVolume(IsEmpty(volume) ? nullptr : volume);
  this->TakeSurface(surface);
  nephoscope::RankRegion region = allOfSpace;
  if (boxes)
  {
    region = nephoscope::HasRegion(this->GetView()) ? nephoscope::RegionOfRank(this->GetView())
                                                    : nephoscope::RankRegion{};
  }
  this->CloudMapper->SetRegion(region.data());
}

// One surface of all blocks, made anew only for new data or another coloured array.
void vtkCloudTextureRepresentation::TakeSurface(vtkDataObject* delivered)
{
  vtkNew<vtkMultiBlockDataSet> one;
  auto* blocks = vtkCompositeDataSet::SafeDownCast(delivered);
  vtkPolyData* joined =
    this->Blocks.Join(blocks ? blocks : one.Get(), nephoscope::ColoredArrayOf(this->CloudMapper));
  if (joined != this->CloudMapper->GetInput())
  {
    this->CloudMapper->SetInputData(joined);
  }
}

void vtkCloudTextureRepresentation::UpdateColoringParameters()
{
  this->Superclass::UpdateColoringParameters();
  this->CloudMapper->SetScalarVisibility(this->Mapper->GetScalarVisibility());
  this->CloudMapper->SetScalarMode(this->Mapper->GetScalarMode());
  this->CloudMapper->SetColorMode(this->Mapper->GetColorMode());
  this->CloudMapper->SetLookupTable(this->Mapper->GetLookupTable());
  this->CloudMapper->SetUseLookupTableScalarRange(this->Mapper->GetUseLookupTableScalarRange());
  this->CloudMapper->SetInterpolateScalarsBeforeMapping(
    this->Mapper->GetInterpolateScalarsBeforeMapping());
  this->CloudMapper->SelectColorArray(this->Mapper->GetArrayName());
}

void vtkCloudTextureRepresentation::SetCoverageArrayName(const char* name)
{
  this->CloudMapper->SetCoverageArrayName(ArrayName(name));
}

void vtkCloudTextureRepresentation::SetCustomWave(int i, double amplitude, double b, double c,
  double d, double shift, double e, double g, double h, double phase)
{
  this->CloudMapper->SetCustomWave(i, amplitude, b, c, d, shift, e, g, h, phase);
}

void vtkCloudTextureRepresentation::SetDensityArrayName(const char* name)
{
  this->CloudMapper->SetDensityArrayName(ArrayName(name));
}

void vtkCloudTextureRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CloudMapper:\n";
  this->CloudMapper->PrintSelf(os, indent.GetNextIndent());
}
