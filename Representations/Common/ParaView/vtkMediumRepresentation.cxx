// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumRepresentation.h"

#include "DataBlocks.h"
#include "EmptyInput.h"
#include "IdsAsNumbers.h"
#include "RankDisplays.h"
#include "SmokeData.h"
#include "UniformMedium.h"
#include "vtkMediumVolume.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkActor.h"
#include "vtkAlgorithmOutput.h"
#include "vtkBoundingBox.h"
#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkCommunicator.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiProcessController.h"
#include "vtkPVRenderView.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeProperty.h"

#include <cmath>
#include <sstream>

namespace
{
// Travels with the data as a field array, so that every time step in ParaView's cache keeps its
// own.
const char* const unitDistanceName = "NephoscopeUnitDistance";
const char* const boundsName = "NephoscopeSeenBounds";
const char* const scalarRangeName = "NephoscopeOpacityRange";

constexpr double uniformOpacity = 0.5; // under Solid Color, and where all values are the same

double StoredNumber(vtkDataSet* data, const char* name, vtkIdType index = 0)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  return array && array->GetNumberOfTuples() > index ? array->GetComponent(index, 0) : 0.0;
}

// Cells keep their ids when they are cut, points do not.
vtkSmartPointer<vtkDataSet> WithIdsAsNumbers(vtkDataSet* data)
{
  auto copy = vtkSmartPointer<vtkDataSet>::Take(data->NewInstance());
  copy->ShallowCopy(data);
  nephoscope::DropRolesOfIds(copy->GetCellData());
  nephoscope::MakeIdsNumbers(copy->GetPointData());
  return copy;
}

// ParaView makes the range of equal values wider by 2.4e-4 of the value: a ramp over it is
// transparent at the values.
// The ramp over one value that ParaView makes; what has more nodes somebody has chosen: 0 of rain
// is no rain.
bool IsOverOneValue(vtkPiecewiseFunction* function, double value)
{
  if (function->GetSize() > 2)
  {
    return false;
  }
  const double* range = function->GetRange();
  return range[1] - range[0] <= 1e-3 * std::abs(value) + 1e-30;
}

vtkDataSetAttributes* AttributesOf(vtkDataSet* data, int association)
{
  return association == vtkDataObject::FIELD_ASSOCIATION_CELLS
    ? static_cast<vtkDataSetAttributes*>(data->GetCellData())
    : data->GetPointData();
}
}

vtkMediumRepresentation::vtkMediumRepresentation()
{
  this->Actor = vtkSmartPointer<vtkMediumVolume>::New();
  this->Actor->SetProperty(this->Property);
  this->Actor->SetEnableLOD(0);

  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, uniformOpacity);
  opacity->AddPoint(2.0, uniformOpacity);
  this->UniformProperty->SetScalarOpacity(opacity);
  vtkNew<vtkPiecewiseFunction> constant;
  constant->AddPoint(0.0, uniformOpacity);
  this->ConstantProperty->SetScalarOpacity(constant);
  this->SetDiffuseColor(1.0, 1.0, 1.0);
}

vtkMediumRepresentation::~vtkMediumRepresentation() = default;

vtkAbstractVolumeMapper* vtkMediumRepresentation::GetMapper() const
{
  return this->Actor->GetMapper();
}

int vtkMediumRepresentation::GetNumberOfRanks()
{
  auto controller = vtkMultiProcessController::GetGlobalController();
  return controller ? controller->GetNumberOfProcesses() : 1;
}

bool vtkMediumRepresentation::IsFirstRank()
{
  auto controller = vtkMultiProcessController::GetGlobalController();
  return !controller || controller->GetLocalProcessId() == 0;
}

int vtkMediumRepresentation::MinimumOverRanks(int mine)
{
  int least = mine;
  if (vtkMediumRepresentation::GetNumberOfRanks() > 1)
  {
    vtkMultiProcessController::GetGlobalController()->AllReduce(
      &mine, &least, 1, vtkCommunicator::MIN_OP);
  }
  return least;
}

double vtkMediumRepresentation::SumOverRanks(double mine)
{
  double sum = mine;
  if (vtkMediumRepresentation::GetNumberOfRanks() > 1)
  {
    vtkMultiProcessController::GetGlobalController()->AllReduce(
      &mine, &sum, 1, vtkCommunicator::SUM_OP);
  }
  return sum;
}

bool vtkMediumRepresentation::HoldsAnything(vtkDataObject* input)
{
  const bool here = input &&
    (input->GetNumberOfElements(vtkDataObject::POINT) > 0 ||
      input->GetNumberOfElements(vtkDataObject::CELL) > 0);
  return MinimumOverRanks(here ? 0 : 1) == 0;
}

void vtkMediumRepresentation::StoreMeasures(
  vtkDataSet* data, double distance, const double range[2])
{
  nephoscope::StoreNumbers(data, unitDistanceName, { distance });
  nephoscope::StoreNumbers(data, scalarRangeName, { range[0], range[1] });
}

// The bounds of all ranks; also called by ranks without data.
void vtkMediumRepresentation::StoreBounds()
{
  const vtkBoundingBox mine(this->DataBounds);
  vtkBoundingBox all(mine);
  if (GetNumberOfRanks() > 1)
  {
    vtkMultiProcessController::GetGlobalController()->AllReduce(mine, all);
  }
  std::vector<double> bounds(6);
  all.GetBounds(bounds.data());
  nephoscope::StoreNumbers(this->Piece, boundsName, bounds);
}

int vtkMediumRepresentation::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkHyperTreeGrid");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1); // a client without data
  return 1;
}

void vtkMediumRepresentation::SetInputArrayToProcess(
  int index, int port, int connection, int association, const char* name)
{
  const vtkMTimeType before = this->GetMTime();
  this->Superclass::SetInputArrayToProcess(index, port, connection, association, name);
  if (this->GetMTime() != before)
  {
    this->MarkModified(); // ParaView does not prepare the data again for a new colour
  }
}

void vtkMediumRepresentation::WarnOfDisplays()
{
  const std::string error = nephoscope::WhyRanksWait();
  if (!error.empty() && IsFirstRank())
  {
    vtkErrorMacro(<< error);
  }
}

// A filter whose output is empty because it failed has told why.
void vtkMediumRepresentation::WarnOfEmptiness(vtkDataObject* input)
{
  vtkAlgorithm* producer = nephoscope::ProducerOfInput(this);
  const bool isEmpty = !HoldsAnything(input);
  if (isEmpty && !this->WasEmpty && !nephoscope::HasFailed(producer, input) && IsFirstRank())
  {
    vtkWarningMacro(<< "Nothing is drawn. " << nephoscope::whyEmpty);
  }
  this->WasEmpty = isEmpty;
}

vtkSmartPointer<vtkDataObject> vtkMediumRepresentation::NumberInput(vtkDataObject* input)
{
  return input;
}

int vtkMediumRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (inputVector[0]->GetNumberOfInformationObjects() == 1)
  {
    this->WarnOfDisplays();
    this->WarnOfEmptiness(vtkDataObject::GetData(inputVector[0], 0));
    this->PreparePiece(
      this->KeepDrawnBlocks(this->NumberInput(vtkDataObject::GetData(inputVector[0], 0))));
    this->PlacePiece();
    this->FinishPiece();
    if (GetNumberOfRanks() > 1 && this->Piece)
    {
      this->Piece = WithIdsAsNumbers(this->Piece);
    }
    this->HasPiece = HoldsAnything(this->Piece);
    this->WarnOfMissingArray();
    this->StoreBounds();
    if (!this->HasPiece)
    {
      nephoscope::FindBoundsToCome(vtkDataObject::GetData(inputVector[0], 0), this->DataBounds);
    }
  }
  else
  {
    this->Piece = vtkSmartPointer<vtkUnstructuredGrid>::New();
    vtkMath::UninitializeBounds(this->DataBounds);
  }
  return this->Superclass::RequestData(request, inputVector, outputVector);
}

int vtkMediumRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo)
{
  if (!this->Superclass::ProcessViewRequest(request, inInfo, outInfo))
  {
    return 0; // not visible
  }
  if (request == vtkPVView::REQUEST_UPDATE())
  {
    if (this->HasPiece) // ParaView cannot order ranks of which none has anything
    {
      outInfo->Set(vtkPVRenderView::NEED_ORDERED_COMPOSITING(), 1);
    }
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
    auto data = vtkDataSet::SafeDownCast(
      producer ? producer->GetProducer()->GetOutputDataObject(0) : nullptr);
    data = this->CompletePiece(data, inInfo);
    this->Actor->SetVisibility(data != nullptr && this->HoldsMedium(data));
    if (this->Actor->GetVisibility())
    {
      this->PlaceActor(data);
      this->PrepareMapper(data);
    }
  }
  return 1;
}

void vtkMediumRepresentation::DescribePiece(vtkInformation* inInfo)
{
  vtkPVRenderView::SetPiece(inInfo, this, this->Piece);
  vtkPVRenderView::SetRequiresDistributedRendering(inInfo, this, true);
  vtkNew<vtkMatrix4x4> matrix;
  this->Actor->GetMatrix(matrix);
  vtkPVRenderView::SetGeometryBounds(inInfo, this, this->DataBounds, matrix);
}

void vtkMediumRepresentation::PrepareMapper(vtkDataSet* data)
{
  int association = 0;
  const char* name = nullptr;
  if (this->FindColorArray(data, association, name))
  {
    this->Actor->SetProperty(this->ChooseProperty(data, name));
    this->GetMapper()->SetInputDataObject(data);
    this->GetMapper()->SelectScalarArray(name);
    this->GetMapper()->SetScalarMode(association == vtkDataObject::FIELD_ASSOCIATION_CELLS
        ? VTK_SCALAR_MODE_USE_CELL_FIELD_DATA
        : VTK_SCALAR_MODE_USE_POINT_FIELD_DATA);
  }
  else
  {
    this->ColorUniformly(data);
  }
  const double automatic = StoredNumber(data, unitDistanceName);
  double bounds[6];
  for (vtkIdType i = 0; i < 6; ++i)
  {
    bounds[i] = StoredNumber(data, boundsName, i);
  }
  static_cast<vtkMediumVolume*>(this->Actor.Get())->SetSeenBounds(bounds);
  const vtkBoundingBox all(bounds);
  const double side = all.IsValid() ? all.GetMaxLength() : 0.0;
  const double given = this->UnitDistance > 0.0 ? this->UnitDistance
    : side > 0.0                                ? 0.1 * side
                                                : 1.0;
  this->ActualUnitDistance = this->AutomaticUnitDistance && automatic > 0.0 ? automatic : given;
  this->Property->SetScalarOpacityUnitDistance(this->ActualUnitDistance);
  this->UniformProperty->SetScalarOpacityUnitDistance(this->ActualUnitDistance);
  this->ConstantProperty->SetScalarOpacityUnitDistance(this->ActualUnitDistance);
}

// Equal values are a uniform medium, unless the user has made an opacity function for them: then a
// warning tells why nothing is drawn.
vtkVolumeProperty* vtkMediumRepresentation::ChooseProperty(vtkDataSet* data, const char* name)
{
  vtkPiecewiseFunction* opacity = this->Property->GetScalarOpacity();
  const double value = StoredNumber(data, scalarRangeName);
  const bool constant = data->GetFieldData()->HasArray(scalarRangeName) &&
    value == StoredNumber(data, scalarRangeName, 1);
  vtkDataArray* lit =
    this->FindExtinctionOfLight(data); // which decides then how opaque the medium is
  const bool invisible =
    !lit && constant && opacity->GetSize() > 0 && !(opacity->GetValue(value) > 0.0);
  const bool uniform = invisible && IsOverOneValue(opacity, value);
  const std::string read = this->GetOpacityArrayName().empty() ? name : this->GetOpacityArrayName();
  std::ostringstream warning;
  if (invisible && !uniform)
  {
    warning
      << "Nothing is drawn: all values of '" << read << "' are " << value
      << ", where the opacity function is 0. Raise it there in the Color Map Editor, or choose Solid Color.";
  }
  if (!lit && !constant)
  {
    warning << this->WhyTransparent(data, opacity);
  }
  double extinctions[2] = { 0, 1 };
  if (lit && GetNumberOfRanks() == 1)
  {
    lit->GetFiniteRange(extinctions);
  }
  if (!(extinctions[1] > 0.0))
  {
    warning << "Nothing is drawn: all values of '" << lit->GetName()
            << "' are 0, so there are no clouds. "
            << "Check the water of the clouds, its units and its time.";
  }
  if (warning.str() != this->LastWarning && !warning.str().empty() && IsFirstRank())
  {
    vtkWarningMacro(<< warning.str());
  }
  this->LastWarning = warning.str();
  if (!uniform)
  {
    return this->Property;
  }
  if (this->Property->GetColorChannels() == 3)
  {
    this->ConstantProperty->SetColor(this->Property->GetRGBTransferFunction());
  }
  else
  {
    this->ConstantProperty->SetColor(this->Property->GetGrayTransferFunction());
  }
  return this->ConstantProperty;
}

// An array chosen for the opacity is read by the function of the coloured one unless it gets its
// own.
std::string vtkMediumRepresentation::WhyTransparent(
  vtkDataSet* data, vtkPiecewiseFunction* opacity) const
{
  const double low = StoredNumber(data, scalarRangeName);
  const double high = StoredNumber(data, scalarRangeName, 1);
  const double* range = opacity->GetRange();
  const bool outside = low < high && (high <= range[0] || low >= range[1]);
  if (this->GetOpacityArrayName().empty() || opacity->GetSize() == 0 || !outside ||
    opacity->GetValue(low) > 0.0)
  {
    return std::string();
  }
  std::ostringstream text;
  text
    << "The medium is invisible: the values of the opacity array '" << this->GetOpacityArrayName()
    << "' (" << low << " to " << high << ") lie outside the opacity function (" << range[0]
    << " to " << range[1]
    << "), which is that of the coloured array. Give it a function of its own in the Python Shell: "
       "GetDisplayProperties().ScalarOpacityFunction = GetOpacityTransferFunction('"
    << this->GetOpacityArrayName() << "').";
  return text.str();
}

vtkDataArray* vtkMediumRepresentation::FindColorArray(
  vtkDataSet* data, int& association, const char*& name)
{
  vtkInformation* info = this->GetInputArrayInformation(0);
  if (!info || !info->Has(vtkDataObject::FIELD_NAME()) ||
    !info->Has(vtkDataObject::FIELD_ASSOCIATION()))
  {
    return nullptr;
  }
  name = info->Get(vtkDataObject::FIELD_NAME());
  association = this->GetAssociationInPiece(info->Get(vtkDataObject::FIELD_ASSOCIATION()));
  return name && name[0] ? AttributesOf(data, association)->GetArray(name) : nullptr;
}

std::string vtkMediumRepresentation::GetOpacityArrayName() const
{
  return this->OpacityArray == "None" ? std::string() : this->OpacityArray;
}

vtkDataArray* vtkMediumRepresentation::FindOpacityArray(vtkDataSet* data, int& association)
{
  const std::string chosen = this->GetOpacityArrayName();
  for (const int at :
    { vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataObject::FIELD_ASSOCIATION_CELLS })
  {
    vtkDataArray* array = AttributesOf(data, at)->GetArray(chosen.c_str());
    if (array && !chosen.empty())
    {
      association = at;
      return array;
    }
  }
  const char* name = nullptr;
  return this->FindColorArray(data, association, name);
}

void vtkMediumRepresentation::SetOpacityArray(const char* name)
{
  const std::string chosen = name && *name ? name : "None";
  if (chosen != this->OpacityArray)
  {
    this->OpacityArray = chosen;
    this->MarkModified(); // the automatic unit distance depends on it
  }
}

void vtkMediumRepresentation::ColorUniformly(vtkDataSet* data)
{
  const int association = this->GetUniformAssociation();
  if (!this->UniformData || this->UniformDataSource != data ||
    this->UniformDataTime != data->GetMTime())
  {
    vtkNew<vtkUnsignedCharArray> ones;
    ones->SetName(nephoscope::uniformMediumName);
    ones->SetNumberOfValues(data->GetNumberOfElements(association));
    ones->FillValue(1);
    this->UniformData.TakeReference(data->NewInstance());
    this->UniformData->ShallowCopy(data);
    AttributesOf(this->UniformData, association)->AddArray(ones);
    this->UniformDataSource = data;
    this->UniformDataTime = data->GetMTime();
  }
  this->Actor->SetProperty(this->UniformProperty);
  this->GetMapper()->SetInputDataObject(this->UniformData);
  this->GetMapper()->SelectScalarArray(nephoscope::uniformMediumName);
  this->GetMapper()->SetScalarMode(association == vtkDataObject::CELL
      ? VTK_SCALAR_MODE_USE_CELL_FIELD_DATA
      : VTK_SCALAR_MODE_USE_POINT_FIELD_DATA);
}

bool vtkMediumRepresentation::AddToView(vtkView* view)
{
  auto renderView = vtkPVRenderView::SafeDownCast(view);
  if (!renderView)
  {
    return false;
  }
  renderView->GetRenderer()->AddActor(this->Actor);
  return this->Superclass::AddToView(view);
}

bool vtkMediumRepresentation::RemoveFromView(vtkView* view)
{
  auto renderView = vtkPVRenderView::SafeDownCast(view);
  if (!renderView)
  {
    return false;
  }
  renderView->GetRenderer()->RemoveActor(this->Actor);
  return this->Superclass::RemoveFromView(view);
}

void vtkMediumRepresentation::SetDiffuseColor(double red, double green, double blue)
{
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.0, red, green, blue);
  color->AddRGBPoint(2.0, red, green, blue);
  this->UniformProperty->SetColor(color);
}

void vtkMediumRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "AutomaticUnitDistance: " << this->AutomaticUnitDistance << "\n";
  os << indent << "UnitDistance: " << this->UnitDistance << "\n";
  os << indent << "Opacity: " << this->Opacity << "\n";
  os << indent << "OpacityScale: " << this->OpacityScale << "\n";
  os << indent << "OpacityArray: " << this->OpacityArray << "\n";
}
