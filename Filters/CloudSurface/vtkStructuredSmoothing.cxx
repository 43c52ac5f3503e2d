// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkStructuredSmoothing.h"

#include "ArrayChecks.h"
#include "BlockNeighbours.h"
#include "BlocksWithArray.h"
#include "ChosenPointArray.h"
#include "FieldSmoother.h"
#include "MessageSuppression.h"
#include "OwnThreads.h"
#include "RequiredInput.h"
#include "SeriesReading.h"

#include "vtkCommand.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkRectilinearGrid.h"
#include "vtkSmartPointer.h"
#include "vtkStructuredGrid.h"

#include <algorithm>

using SDDP = vtkStreamingDemandDrivenPipeline;

vtkStandardNewMacro(vtkStructuredSmoothing);

namespace
{
// Crops the data to the requested extent. An extent that is not there is none.
template <typename Grid>
void CropTo(Grid* grid, vtkInformation* outInfo)
{
  if (!outInfo->Has(SDDP::UPDATE_EXTENT()))
  {
    return;
  }
  int wanted[6];
  int there[6];
  outInfo->Get(SDDP::UPDATE_EXTENT(), wanted);
  grid->GetExtent(there);
  bool same = true;
  for (int axis = 0; axis < 3; ++axis)
  {
    wanted[2 * axis] = std::max(wanted[2 * axis], there[2 * axis]);
    wanted[2 * axis + 1] = std::min(wanted[2 * axis + 1], there[2 * axis + 1]);
    if (wanted[2 * axis] > wanted[2 * axis + 1])
    {
      grid->Initialize(); // a piece with nothing in it
      return;
    }
    same =
      same && wanted[2 * axis] == there[2 * axis] && wanted[2 * axis + 1] == there[2 * axis + 1];
  }
  if (!same)
  {
    grid->Crop(wanted);
  }
}

void Crop(vtkDataSet* data, vtkInformation* outInfo)
{
  if (auto* image = vtkImageData::SafeDownCast(data))
  {
    CropTo(image, outInfo);
  }
  else if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(data))
  {
    CropTo(rectilinear, outInfo);
  }
  else if (auto* structured = vtkStructuredGrid::SafeDownCast(data))
  {
    CropTo(structured, outInfo);
  }
}

// The smoothed array replaces the other, including its role (active scalars, vectors).
void Replace(vtkDataSet* output, vtkDataArray* from, vtkDataArray* to)
{
  vtkPointData* data = output->GetPointData();
  const int place = nephoscope::IndexOfPointArray(output, from);
  const int attribute = data->IsArrayAnAttribute(place);
  if (!from->GetName())
  {
    data->RemoveArray(place); // one with a name is replaced by its name
  }
  const int now = data->AddArray(to);
  if (attribute >= 0)
  {
    data->SetActiveAttribute(now, attribute);
  }
}
}

vtkStructuredSmoothing::vtkStructuredSmoothing()
{
  this->Neighbours = std::make_unique<nephoscope::BlockNeighbours>();
  this->Blocks = std::make_unique<nephoscope::BlocksWithArray>(
    this, [this](vtkDataSet* block) { return this->HasArrays(block); });
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
  this->AddObserver(vtkCommand::StartEvent, this, &vtkStructuredSmoothing::BeginExecution);
  this->AddObserver(vtkCommand::EndEvent, this, &vtkStructuredSmoothing::EndExecution);
}

vtkStructuredSmoothing::~vtkStructuredSmoothing() = default;

void vtkStructuredSmoothing::BeginExecution()
{
  if (this->ExecutionDepth++ == 0) // blocks begin and end within the whole
  {
    // A layer for every pass, and one for masses, which are less at the end of a grid.
    this->Neighbours->Find(this->GetInputDataObject(0, 0), this->NumberOfIterations + 1);
  }
}

void vtkStructuredSmoothing::EndExecution()
{
  if (--this->ExecutionDepth == 0)
  {
    this->Neighbours->Find(nullptr, 0);
  }
}

void vtkStructuredSmoothing::SetPeriodic(int axis, bool periodic)
{
  if (axis < 0 || axis > 2)
  {
    vtkErrorMacro("SetPeriodic: the axis is " << axis << "; it must be 0, 1 or 2.");
    return;
  }
  if (this->Periodic[axis] != periodic)
  {
    this->Periodic[axis] = periodic;
    this->Modified();
  }
}

bool vtkStructuredSmoothing::GetPeriodic(int axis)
{
  return axis >= 0 && axis <= 2 && this->Periodic[axis];
}

void vtkStructuredSmoothing::AddArrayName(const std::string& name)
{
  this->ArrayNames.push_back(name);
  this->Modified();
}

void vtkStructuredSmoothing::ClearArrayNames()
{
  if (!this->ArrayNames.empty())
  {
    this->ArrayNames.clear();
    this->Modified();
  }
}

std::string vtkStructuredSmoothing::GetArrayName(int i)
{
  return i >= 0 && i < this->GetNumberOfArrayNames() ? this->ArrayNames[i] : std::string();
}

nephoscope::SmoothingSettings vtkStructuredSmoothing::GetSettings() const
{
  nephoscope::SmoothingSettings settings;
  std::copy(this->Periodic, this->Periodic + 3, settings.Periodic.begin());
  settings.FindSeam = this->FindSeam;
  settings.Conservative = this->Conservative;
  settings.Isotropic = this->Isotropic;
  settings.Coordinates = static_cast<nephoscope::GridCoordinates>(this->Coordinates);
  settings.MassArrayName =
    this->MassArrayName == "None" ? "" : this->MassArrayName; // as ParaView's menus say it
  return settings;
}

int vtkStructuredSmoothing::FillInputPortInformation(int, vtkInformation* info)
{
  nephoscope::TakeAnyData(info);
  return 1;
}

vtkTypeBool vtkStructuredSmoothing::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return nephoscope::HasNoGrid(this, this->ToldOfInput, request, inputs, outputs) ||
    this->Superclass::ProcessRequest(request, inputs, outputs);
}

int vtkStructuredSmoothing::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  outputs->GetInformationObject(0)->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  return 1;
}

int vtkStructuredSmoothing::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  nephoscope::AskForWholeExtent(inputs[0]->GetInformationObject(0));
  return 1;
}

int vtkStructuredSmoothing::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkDataSet* block = vtkDataSet::GetData(inputs[0], 0);
  vtkDataSet* input = this->Neighbours->Extended(block);
  vtkDataSet* output = vtkDataSet::GetData(outputs, 0);
  if (this->Blocks->IsLackedBy(block))
  {
    if (this->Blocks->HasAny())
    {
      output->ShallowCopy(block);
      Crop(output, outputs->GetInformationObject(0));
    }
    return 1;
  }
  nephoscope::ReportOnce report(this, this->Failed);
  nephoscope::SmoothingPlan plan;
  std::string error;
  nephoscope::WithThreads([&]() { error = plan.Read(input, this->GetSettings()); });
  std::vector<int> arrays;
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
    report.End(false);
    return 1; // other blocks go on
  }
  if (!this->FindArrays(block, inputs, arrays))
  {
    report.End(false);
    return 1;
  }
  if (plan.PointsWithoutMass() > 0)
  {
    vtkWarningMacro(
      << plan.PointsWithoutMass()
      << " points have no mass (cells without volume or turned inside out, or masses that are not positive). They "
         "keep their values. Repair the grid, or switch Conservative off.");
  }
  report.End(true);
  output->ShallowCopy(block);
  bool finished = false;
  nephoscope::WithThreads(
    [&]() { finished = this->SmoothArrays(block, input, plan, arrays, output); });
  if (!finished)
  {
    output->Initialize(); // nothing rather than a part
    return 1;
  }
  if (this->GenerateMassArray)
  {
    this->AddMasses(block, input, plan, output);
  }
  Crop(output, outputs->GetInformationObject(0));
  return 1;
}

// Whether there is anything to smooth.
bool vtkStructuredSmoothing::HasArrays(vtkDataSet* block)
{
  const auto has = [block](const std::string& name) {
    return block->GetPointData()->HasArray(name.c_str()) ||
      block->GetCellData()->HasArray(name.c_str());
  };
  return this->AllFloatArrays ||
    (this->ArrayNames.empty() ? nephoscope::HasChosenPointArray(this, block)
                              : std::any_of(this->ArrayNames.begin(), this->ArrayNames.end(), has));
}

bool vtkStructuredSmoothing::FindArrays(
  vtkDataSet* input, vtkInformationVector** inputs, std::vector<int>& arrays)
{
  std::vector<vtkAbstractArray*> wanted;
  vtkPointData* data = input->GetPointData();
  if (this->AllFloatArrays)
  {
    for (int a = 0; a < data->GetNumberOfArrays(); ++a)
    {
      vtkDataArray* array = data->GetArray(a);
      if (array && (array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE))
      {
        wanted.push_back(array);
      }
    }
  }
  else if (!this->ArrayNames.empty())
  {
    for (const std::string& name : this->ArrayNames)
    {
      vtkAbstractArray* array = data->GetAbstractArray(name.c_str());
      if (!array)
      {
        vtkErrorMacro(<< nephoscope::NoPointArray(input, name.c_str())
                      << this->Blocks->NorInOthers());
        return false;
      }
      wanted.push_back(array);
    }
  }
  else
  {
    int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
    vtkAbstractArray* array = nephoscope::IsNoArrayChosen(this)
      ? nephoscope::DefaultPointArray(input->GetPointData())
      : this->GetInputAbstractArrayToProcess(0, inputs, association);
    if (!array || association != vtkDataObject::FIELD_ASSOCIATION_POINTS)
    {
      vtkErrorMacro(<< nephoscope::NoPointArray(
                         input, this->GetInputArrayInformation(0)->Get(vtkDataObject::FIELD_NAME()))
                    << this->Blocks->NorInOthers());
      return false;
    }
    wanted.push_back(array);
  }
  for (vtkAbstractArray* array : wanted)
  {
    const std::string fault = nephoscope::ArrayFault(input, array);
    if (!fault.empty())
    {
      vtkErrorMacro(<< fault);
      return false;
    }
    const int index = nephoscope::IndexOfPointArray(input, array);
    if (index >= 0 && std::find(arrays.begin(), arrays.end(), index) == arrays.end())
    {
      arrays.push_back(index);
    }
  }
  return true;
}

// `input`: the block, or the block with ghost cells from its neighbours.
bool vtkStructuredSmoothing::SmoothArrays(vtkDataSet* block, vtkDataSet* input,
  const nephoscope::SmoothingPlan& plan, const std::vector<int>& arrays, vtkDataSet* output)
{
  if (this->NumberOfIterations == 0)
  {
    return true;
  }
  const nephoscope::FieldSmoother smoother(plan);
  const vtkIdType count = input->GetNumberOfPoints();
  std::vector<double> field(static_cast<std::size_t>(count));
  for (std::size_t a = 0; a < arrays.size(); ++a)
  {
    vtkDataArray* from = input->GetPointData()->GetArray(arrays[a]);
    const bool keepsType = from->GetDataType() == VTK_FLOAT || from->GetDataType() == VTK_DOUBLE;
    auto to = vtkSmartPointer<vtkDataArray>::Take(
      vtkDataArray::CreateDataArray(keepsType ? from->GetDataType() : VTK_DOUBLE));
    to->SetName(from->GetName());
    to->SetNumberOfComponents(from->GetNumberOfComponents());
    to->CopyComponentNames(from);
    to->SetNumberOfTuples(count);
    vtkIdType missing = 0;
    for (int c = 0; c < from->GetNumberOfComponents(); ++c)
    {
      for (vtkIdType id = 0; id < count; ++id)
      {
        field[id] = from->GetComponent(id, c);
        missing += nephoscope::IsMissingValue(field[id]) && !plan.IsHidden(id) ? 1 : 0;
      }
      const bool finished = smoother.Smooth(field, this->NumberOfIterations, [&](double share) {
        this->UpdateProgress((a + (c + share) / from->GetNumberOfComponents()) / arrays.size());
        return !this->CheckAbort();
      });
      if (!finished)
      {
        return false;
      }
      for (vtkIdType id = 0; id < count; ++id)
      {
        to->SetComponent(id, c, field[id]);
      }
    }
    if (missing > 0)
    {
      vtkWarningMacro(<< nephoscope::ValuesMissing(from, missing)
                      << " They stay as they are, and the others are smoothed without them.");
    }
    Replace(output, block->GetPointData()->GetArray(arrays[a]),
      nephoscope::WithoutGhosts(block, input, to));
  }
  return true;
}

void vtkStructuredSmoothing::AddMasses(
  vtkDataSet* block, vtkDataSet* input, const nephoscope::SmoothingPlan& plan, vtkDataSet* output)
{
  vtkNew<vtkDoubleArray> masses;
  masses->SetName("Mass");
  masses->SetNumberOfTuples(static_cast<vtkIdType>(plan.Masses().size()));
  std::copy(plan.Masses().begin(), plan.Masses().end(), masses->GetPointer(0));
  if (output->GetPointData()->HasArray("Mass"))
  {
    vtkWarningMacro("The point array 'Mass' of the input has been replaced. Rename it to keep it.");
  }
  output->GetPointData()->AddArray(nephoscope::WithoutGhosts(block, input, masses));
}

void vtkStructuredSmoothing::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfIterations: " << this->NumberOfIterations << "\n"
     << indent << "Periodic: " << this->Periodic[0] << " " << this->Periodic[1] << " "
     << this->Periodic[2] << "\n"
     << indent << "FindSeam: " << this->FindSeam << "\n"
     << indent << "Conservative: " << this->Conservative << "\n"
     << indent << "MassArrayName: " << this->MassArrayName << "\n"
     << indent << "GenerateMassArray: " << this->GenerateMassArray << "\n"
     << indent << "Isotropic: " << this->Isotropic << "\n"
     << indent << "Coordinates: " << this->Coordinates << "\n"
     << indent << "AllFloatArrays: " << this->AllFloatArrays << "\n"
     << indent << "ArrayNames:";
  for (const std::string& name : this->ArrayNames)
  {
    os << " '" << name << "'";
  }
  os << "\n";
}
