// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCellCompositingRepresentation.h"

#include "CellMeasures.h"
#include "SmokeCells.h"
#include "VolumetricCells.h"
#include "vtkCellCompositingMapper.h"
#include "vtkCellCompositingVolume.h"

#include "vtkAlgorithmOutput.h"
#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPVRenderView.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeProperty.h"

#include <algorithm>

vtkStandardNewMacro(vtkCellCompositingRepresentation);

namespace
{
// Travels with the data as a field array, so that every time step in ParaView's cache keeps its own.
const char* const unitDistanceName = "NephoscopeUnitDistance";
const char* const uniformName = "NephoscopeUniform";

// What the automatic unit distance aims at with ParaView's default opacity function, a ramp from 0 to 1 over the range.
constexpr double meanOpticalDepth = 2.0;
constexpr double smokeOpticalDepth = 1.0; // the same for smoke, through the generating polygon's diameter
constexpr double uniformOpacity = 0.5;    // under Solid Color

int numberOfRanks()
{
  auto controller = vtkMultiProcessController::GetGlobalController();
  return controller ? controller->GetNumberOfProcesses() : 1;
}

void setFieldValue(vtkDataSet* data, const char* name, double value)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->InsertNextValue(value);
  vtkNew<vtkFieldData> own; // the input shares its field data with the copy
  own->ShallowCopy(data->GetFieldData());
  own->AddArray(array);
  data->SetFieldData(own);
}

double fieldValue(vtkDataSet* data, const char* name)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  return array && array->GetNumberOfTuples() > 0 ? array->GetComponent(0, 0) : 0.0;
}
}

vtkCellCompositingRepresentation::vtkCellCompositingRepresentation()
{
  this->Actor = vtkSmartPointer<vtkCellCompositingVolume>::New();
  this->Actor->SetProperty(this->Property);
  this->Actor->SetMapper(this->Mapper);
  this->Actor->SetEnableLOD(0);

  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, uniformOpacity);
  opacity->AddPoint(2.0, uniformOpacity);
  this->UniformProperty->SetScalarOpacity(opacity);
  this->SetDiffuseColor(1.0, 1.0, 1.0);
}

vtkCellCompositingRepresentation::~vtkCellCompositingRepresentation() = default;

int vtkCellCompositingRepresentation::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1); // a client without data
  return 1;
}

void vtkCellCompositingRepresentation::SetInputArrayToProcess(
  int index, int port, int connection, int association, const char* name)
{
  const vtkMTimeType before = this->GetMTime();
  this->Superclass::SetInputArrayToProcess(index, port, connection, association, name);
  if (this->GetMTime() != before)
  {
    this->MarkModified(); // ParaView does not prepare the data again for a new colour
  }
}

int vtkCellCompositingRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (inputVector[0]->GetNumberOfInformationObjects() == 1)
  {
    this->PrepareCells(vtkDataObject::GetData(inputVector[0], 0));
  }
  else
  {
    this->Cells = vtkSmartPointer<vtkUnstructuredGrid>::New();
    vtkMath::UninitializeBounds(this->DataBounds);
  }
  return this->Superclass::RequestData(request, inputVector, outputVector);
}

void vtkCellCompositingRepresentation::PrepareCells(vtkDataObject* input)
{
  this->Cells = nephoscope::withConvexCells(nephoscope::volumetricPart(input));
  int association = 0;
  vtkDataArray* scalars = this->Cells ? this->FindOpacityArray(this->Cells, association) : nullptr;
  const nephoscope::CellMeasures mine = nephoscope::measureCells(
    this->Cells, scalars, association == vtkDataObject::FIELD_ASSOCIATION_CELLS);
  const nephoscope::CellMeasures all = nephoscope::reduceOverRanks(mine);
  std::copy(mine.Bounds, mine.Bounds + 6, this->DataBounds);
  double smokeDistance = 0.0;
  if (this->OpacityArray == "None" && nephoscope::isSmoke(this->Cells) && all.Volume > 0.0)
  {
    smokeDistance =
      nephoscope::smokeThickness(this->Cells) * all.ScalarIntegral / all.Volume / smokeOpticalDepth;
  }

  auto controller = vtkMultiProcessController::GetGlobalController();
  if (all.Volume <= 0.0 && (!controller || controller->GetLocalProcessId() == 0))
  {
    vtkWarningMacro("Cell Compositing draws 3-D cells, and the input has none with a volume: nothing is drawn. "
                    "Show it as Surface, or apply a filter that makes cells (Delaunay 3D, Tetrahedralize).");
  }
  // A rank without cells can not know what the others hold; an empty unstructured grid goes with either.
  this->AxisAligned = !this->Cells || nephoscope::isAxisAligned(this->Cells);
  if (!this->Cells)
  {
    this->Cells = vtkSmartPointer<vtkUnstructuredGrid>::New();
  }
  if (numberOfRanks() > 1)
  {
    int aligned = this->AxisAligned ? 1 : 0, allAligned = 0;
    controller->AllReduce(&aligned, &allAligned, 1, vtkCommunicator::MIN_OP);
    this->AxisAligned = allAligned != 0;
    if (!this->AxisAligned)
    {
      this->Cells = nephoscope::tetrahedralize(this->Cells);
    }
  }
  setFieldValue(this->Cells, unitDistanceName, smokeDistance > 0.0 ? smokeDistance
    : nephoscope::meanChord(all) * nephoscope::meanRamp(all) / meanOpticalDepth);
}

int vtkCellCompositingRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo)
{
  if (!this->Superclass::ProcessViewRequest(request, inInfo, outInfo))
  {
    return 0; // not visible
  }
  if (request == vtkPVView::REQUEST_UPDATE())
  {
    outInfo->Set(vtkPVRenderView::NEED_ORDERED_COMPOSITING(), 1);
    this->DescribePiece(inInfo);
  }
  else if (request == vtkPVView::REQUEST_UPDATE_LOD())
  {
    vtkPVRenderView::SetPieceLOD(inInfo, this, vtkPVView::GetPiece(inInfo, this));
    vtkPVRenderView::SetRequiresDistributedRenderingLOD(inInfo, this, true);
  }
  else if (request == vtkPVView::REQUEST_RENDER())
  {
    const bool interactive = inInfo->Has(vtkPVRenderView::USE_LOD()) != 0;
    vtkAlgorithmOutput* producer = interactive ? vtkPVRenderView::GetPieceProducerLOD(inInfo, this)
                                               : vtkPVRenderView::GetPieceProducer(inInfo, this);
    vtkDataObject* data = producer ? producer->GetProducer()->GetOutputDataObject(0) : nullptr;
    this->PrepareMapper(vtkDataSet::SafeDownCast(data));
  }
  return 1;
}

void vtkCellCompositingRepresentation::DescribePiece(vtkInformation* inInfo)
{
  vtkPVRenderView::SetPiece(inInfo, this, this->Cells);
  vtkPVRenderView::SetRequiresDistributedRendering(inInfo, this, true);
  vtkNew<vtkMatrix4x4> matrix;
  this->Actor->GetMatrix(matrix);
  vtkPVRenderView::SetGeometryBounds(inInfo, this, this->DataBounds, matrix);

  if (this->AxisAligned)
  {
    vtkPVRenderView::SetOrderedCompositingConfiguration(
      inInfo, this, vtkPVRenderView::USE_BOUNDS_FOR_REDISTRIBUTION);
    return;
  }
  vtkPVRenderView::SetOrderedCompositingConfiguration(inInfo, this,
    vtkPVRenderView::DATA_IS_REDISTRIBUTABLE | vtkPVRenderView::USE_DATA_FOR_LOAD_BALANCING);
  // Cells that lie across a border between regions are cut there: given whole to one side, they would be composited
  // in front of, or behind, all of the other side's.
  vtkPVRenderView::SetRedistributionModeToSplitBoundaryCells(inInfo, this);
}

void vtkCellCompositingRepresentation::PrepareMapper(vtkDataSet* cells)
{
  this->Actor->SetVisibility(cells != nullptr && cells->GetNumberOfCells() > 0);
  if (!this->Actor->GetVisibility())
  {
    return;
  }
  int association = 0;
  const char* name = nullptr;
  if (this->FindColorArray(cells, association, name))
  {
    this->Actor->SetProperty(this->Property);
    this->Mapper->SetInputDataObject(cells);
    this->Mapper->SelectScalarArray(name);
    this->Mapper->SetScalarMode(association == vtkDataObject::FIELD_ASSOCIATION_CELLS
        ? VTK_SCALAR_MODE_USE_CELL_FIELD_DATA
        : VTK_SCALAR_MODE_USE_POINT_FIELD_DATA);
  }
  else
  {
    this->ColorUniformly(cells);
  }
  const double automatic = fieldValue(cells, unitDistanceName);
  const double distance =
    this->AutomaticUnitDistance && automatic > 0.0 ? automatic : this->UnitDistance;
  this->Property->SetScalarOpacityUnitDistance(distance);
  this->UniformProperty->SetScalarOpacityUnitDistance(distance);
  this->PrepareOpacity(cells, distance);
  this->Mapper->SetOpacityScale(this->OpacityScale * this->Opacity);
  this->Mapper->SetVisibilityOrder(this->VisibilityOrder); // while the camera moves too: rays need no sorting
  this->PrepareContours();
  this->PrepareLayers();
}

vtkDataArray* vtkCellCompositingRepresentation::FindColorArray(
  vtkDataSet* cells, int& association, const char*& name)
{
  vtkInformation* info = this->GetInputArrayInformation(0);
  if (!info || !info->Has(vtkDataObject::FIELD_NAME()) || !info->Has(vtkDataObject::FIELD_ASSOCIATION()))
  {
    return nullptr;
  }
  name = info->Get(vtkDataObject::FIELD_NAME());
  association = info->Get(vtkDataObject::FIELD_ASSOCIATION());
  if (!name || !name[0])
  {
    return nullptr;
  }
  vtkFieldData* arrays = association == vtkDataObject::FIELD_ASSOCIATION_CELLS
    ? static_cast<vtkFieldData*>(cells->GetCellData())
    : static_cast<vtkFieldData*>(cells->GetPointData());
  return arrays->GetArray(name);
}

// The array that decides how opaque the cells are: the one chosen for it, else the density of smoke, else the coloured one.
vtkDataArray* vtkCellCompositingRepresentation::FindOpacityArray(vtkDataSet* cells, int& association)
{
  if (this->DrawsSmoke(cells))
  {
    association = vtkDataObject::FIELD_ASSOCIATION_CELLS;
    return nephoscope::smokeDensity(cells);
  }
  const std::string chosen = this->OpacityArray == "None" ? std::string() : this->OpacityArray;
  association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  vtkDataArray* array = cells->GetPointData()->GetArray(chosen.c_str());
  if (!array)
  {
    association = vtkDataObject::FIELD_ASSOCIATION_CELLS;
    array = cells->GetCellData()->GetArray(chosen.c_str());
  }
  const char* name = nullptr;
  return array && !chosen.empty() ? array : this->FindColorArray(cells, association, name);
}

void vtkCellCompositingRepresentation::SetOpacityArray(const char* name)
{
  const std::string chosen = name && *name ? name : "None";
  if (chosen != this->OpacityArray)
  {
    this->OpacityArray = chosen;
    this->MarkModified(); // the automatic unit distance depends on it
  }
}

void vtkCellCompositingRepresentation::ColorUniformly(vtkDataSet* cells)
{
  if (!this->UniformCells || this->UniformCellsSource != cells ||
    this->UniformCellsTime != cells->GetMTime())
  {
    vtkNew<vtkUnsignedCharArray> ones;
    ones->SetName(uniformName);
    ones->SetNumberOfValues(cells->GetNumberOfCells());
    ones->FillValue(1);
    this->UniformCells.TakeReference(cells->NewInstance());
    this->UniformCells->ShallowCopy(cells);
    this->UniformCells->GetCellData()->AddArray(ones);
    this->UniformCellsSource = cells;
    this->UniformCellsTime = cells->GetMTime();
  }
  this->Actor->SetProperty(this->UniformProperty);
  this->Mapper->SetInputDataObject(this->UniformCells);
  this->Mapper->SelectScalarArray(uniformName);
  this->Mapper->SetScalarMode(VTK_SCALAR_MODE_USE_CELL_FIELD_DATA);
}

bool vtkCellCompositingRepresentation::AddToView(vtkView* view)
{
  auto renderView = vtkPVRenderView::SafeDownCast(view);
  if (!renderView)
  {
    return false;
  }
  renderView->GetRenderer()->AddActor(this->Actor);
  return this->Superclass::AddToView(view);
}

bool vtkCellCompositingRepresentation::RemoveFromView(vtkView* view)
{
  auto renderView = vtkPVRenderView::SafeDownCast(view);
  if (!renderView)
  {
    return false;
  }
  renderView->GetRenderer()->RemoveActor(this->Actor);
  return this->Superclass::RemoveFromView(view);
}

void vtkCellCompositingRepresentation::SetMethod(int method)
{
  this->Mapper->SetMethod(method);
}

void vtkCellCompositingRepresentation::SetIntegration(int integration)
{
  this->Mapper->SetIntegration(integration);
}

void vtkCellCompositingRepresentation::SetVisibilityOrder(int order)
{
  this->VisibilityOrder = order; // the mapper gets it before each render
}

void vtkCellCompositingRepresentation::SetOpacityScale(double scale)
{
  this->OpacityScale = scale;
}

void vtkCellCompositingRepresentation::SetSplitAtControlPoints(bool split)
{
  this->Mapper->SetSplitAtControlPoints(split);
}

void vtkCellCompositingRepresentation::SetDiffuseColor(double red, double green, double blue)
{
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.0, red, green, blue);
  color->AddRGBPoint(2.0, red, green, blue);
  this->UniformProperty->SetColor(color);
}

void vtkCellCompositingRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "AutomaticUnitDistance: " << this->AutomaticUnitDistance << "\n";
  os << indent << "UnitDistance: " << this->UnitDistance << "\n";
  os << indent << "Opacity: " << this->Opacity << "\n";
  os << indent << "OpacityScale: " << this->OpacityScale << "\n";
  os << indent << "VisibilityOrder: " << this->VisibilityOrder << "\n";
  this->Mapper->PrintSelf(os, indent.GetNextIndent());
}
