// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCloudSurface.h"

#include "ArrayChecks.h"
#include "BlockNeighbours.h"
#include "BlocksWithArray.h"
#include "ChosenPointArray.h"
#include "ContourValueList.h"
#include "DefaultRange.h"
#include "FieldSmoother.h"
#include "IndexSpaceContour.h"
#include "OwnThreads.h"
#include "RequiredInput.h"
#include "SeriesReading.h"
#include "SurfaceAssembly.h"

#include "vtkCommand.h"
#include "vtkErrorCode.h"
#include "vtkExtentTranslator.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <sstream>

using SDDP = vtkStreamingDemandDrivenPipeline;

vtkStandardNewMacro(vtkCloudSurface);

namespace
{
int NumberOfPieces(vtkInformation* outInfo)
{
  return outInfo->Has(SDDP::UPDATE_NUMBER_OF_PIECES())
    ? outInfo->Get(SDDP::UPDATE_NUMBER_OF_PIECES())
    : 1;
}

bool IsFirstPiece(vtkInformation* outInfo)
{
  return !outInfo->Has(SDDP::UPDATE_PIECE_NUMBER()) ||
    outInfo->Get(SDDP::UPDATE_PIECE_NUMBER()) == 0;
}

constexpr double smoothingShare = 0.5; // of the time, about

// The cells that the asked piece has a share of, first and last along each axis. False if there is
// none.
bool CellsOfPiece(
  const nephoscope::SmoothingPlan& plan, vtkInformation* outInfo, std::array<int, 6>& cells)
{
  int whole[6];
  for (int axis = 0; axis < 3; ++axis)
  {
    whole[2 * axis] = 0;
    whole[2 * axis + 1] = nephoscope::CellsAlong(plan, axis);
  }
  const int pieces = NumberOfPieces(outInfo);
  const int piece =
    outInfo->Has(SDDP::UPDATE_PIECE_NUMBER()) ? outInfo->Get(SDDP::UPDATE_PIECE_NUMBER()) : 0;
  int extent[6];
  std::copy(whole, whole + 6, extent);
  if (pieces > 1)
  {
    vtkNew<vtkExtentTranslator> translator;
    if (!translator->PieceToExtentThreadSafe(
          piece, pieces, 0, whole, extent, vtkExtentTranslator::BLOCK_MODE, 0))
    {
      return false;
    }
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    cells[2 * axis] = extent[2 * axis];
    cells[2 * axis + 1] = extent[2 * axis + 1] - 1;
    if (cells[2 * axis] > cells[2 * axis + 1])
    {
      return false;
    }
  }
  return true;
}
}

vtkCloudSurface::vtkCloudSurface()
{
  this->Neighbours = std::make_unique<nephoscope::BlockNeighbours>();
  this->Blocks = std::make_unique<nephoscope::BlocksWithArray>(
    this, [this](vtkDataSet* block) { return nephoscope::HasChosenPointArray(this, block); });
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
  this->AddObserver(vtkCommand::StartEvent, this, &vtkCloudSurface::BeginExecution);
  this->AddObserver(vtkCommand::EndEvent, this, &vtkCloudSurface::EndExecution);
}

vtkCloudSurface::~vtkCloudSurface() = default;

vtkMTimeType vtkCloudSurface::GetMTime()
{
  return std::max(
    { this->Superclass::GetMTime(), this->ContourValues->GetMTime(), this->Smoothing->GetMTime() });
}

int vtkCloudSurface::FillInputPortInformation(int, vtkInformation* info)
{
  nephoscope::TakeAnyData(info);
  return 1;
}

vtkTypeBool vtkCloudSurface::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return nephoscope::HasNoGrid(this, this->ToldOfInput, request, inputs, outputs) ||
    this->Superclass::ProcessRequest(request, inputs, outputs);
}

int vtkCloudSurface::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  outputs->GetInformationObject(0)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

int vtkCloudSurface::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  nephoscope::AskForWholeExtent(inputs[0]->GetInformationObject(0));
  return 1;
}

int vtkCloudSurface::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkDataSet* block = vtkDataSet::GetData(inputs[0], 0);
  if (this->Blocks->IsLackedBy(block))
  {
    return 1; // is left out
  }
  vtkDataSet* input = this->Neighbours->Extended(block);
  vtkPolyData* output = vtkPolyData::GetData(outputs, 0);
  nephoscope::SmoothingPlan plan;
  std::string error;
  nephoscope::WithThreads([&]() { error = plan.Read(input, this->Smoothing->GetSettings()); });
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
    this->ErrorCode = vtkErrorCode::UserError;
    return 1; // other blocks go on
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    if (plan.Topology().Size[axis] < 2)
    {
      vtkErrorMacro("The grid has one point along axis "
        << axis
        << "; a surface needs cells, two points or more along every axis. "
           "Use a contour filter for lines.");
      this->ErrorCode = vtkErrorCode::UserError;
      return 1;
    }
  }
  vtkDataArray* scalars = this->FindScalars(block, inputs);
  scalars = scalars ? input->GetPointData()->GetArray(nephoscope::IndexOfPointArray(block, scalars))
                    : nullptr;
  if (!scalars)
  {
    this->ErrorCode = vtkErrorCode::UserError;
    return 1;
  }
  bool finished = false;
  nephoscope::WithThreads([&]() {
    finished = this->BuildSurface(input, plan, scalars, outputs->GetInformationObject(0), output);
  });
  if (!finished)
  {
    output->Initialize(); // nothing rather than a part
  }
  return 1;
}

bool vtkCloudSurface::BuildSurface(vtkDataSet* input, const nephoscope::SmoothingPlan& plan,
  vtkDataArray* scalars, vtkInformation* outInfo, vtkPolyData* output)
{
  std::vector<double> values;
  std::vector<int> indices;
  std::array<int, 6> cells;
  if (!this->FindValues(values, indices))
  {
    return false;
  }
  if (this->TakesDefaultValue())
  {
    values = { this->DefaultValue };
    indices = { 0 };
  }
  if (values.empty() && IsFirstPiece(outInfo))
  {
    this->Reason = "there are no contour values. Add one.";
  }
  if (values.empty() || !CellsOfPiece(plan, outInfo, cells))
  {
    return false;
  }
  std::vector<double> field(static_cast<std::size_t>(scalars->GetNumberOfTuples()));
  for (std::size_t id = 0; id < field.size(); ++id)
  {
    field[id] = scalars->GetComponent(static_cast<vtkIdType>(id), 0);
  }
  const nephoscope::FieldSmoother smoother(plan);
  const std::vector<unsigned char> missing = smoother.MissingPoints(field);
  const bool smoothed =
    smoother.Smooth(field, this->GetNumberOfSmoothingIterations(), [this](double share) {
      this->UpdateProgress(smoothingShare * share);
      return !this->CheckAbort();
    });
  if (!smoothed || this->CheckAbort())
  {
    return false;
  }
  vtkIdType gaps = 0;
  for (std::size_t id = 0; id < field.size(); ++id)
  {
    gaps += missing[id] && !plan.IsHidden(static_cast<vtkIdType>(id)) ? 1 : 0;
    // Whatever is contoured there has no place, and is known by that.
    field[id] = missing[id] ? std::numeric_limits<double>::quiet_NaN() : field[id];
  }
  if (gaps > 0)
  {
    vtkWarningMacro(<< nephoscope::ValuesMissing(scalars, gaps)
                    << " The cells that they are corners of have no surface.");
  }
  const auto contour = nephoscope::ContourInIndexSpace(
    input, plan, field, cells, values, nephoscope::IndexOfPointArray(input, scalars));
  this->UpdateProgress(0.7);
  if (this->CheckAbort())
  {
    return false;
  }
  if (contour.Surface->GetNumberOfPoints() == 0)
  {
    const bool told = gaps == scalars->GetNumberOfTuples(); // that all are missing
    this->Reason = told ? std::string() : this->ReasonOfEmptiness(scalars, field, values, outInfo);
    return false;
  }
  this->HasSurface = true;
  nephoscope::SurfaceAssembly assembly(input, plan, contour, missing);
  assembly.JoinSeams(this->JoinSeams);
  assembly.Build(scalars, values, indices, output);
  this->UpdateProgress(0.85);
  assembly.AddTriangles(field, this->ComputeNormals, output);
  this->UpdateProgress(1.0);
  return !this->CheckAbort();
}

// `field`: smoothed, not a number where nothing is contoured. All pieces have the whole result, so
// only the first one reports it.
std::string vtkCloudSurface::ReasonOfEmptiness(vtkDataArray* scalars,
  const std::vector<double>& field, const std::vector<double>& values, vtkInformation* outInfo)
{
  std::ostringstream reason;
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const double value : field)
  {
    low = value < low ? value : low; // both false for what is not a number
    high = value > high ? value : high;
  }
  const std::string array = nephoscope::QuotedName(scalars) +
    (this->GetNumberOfSmoothingIterations() > 0 ? " after smoothing" : "");
  if (!IsFirstPiece(outInfo))
  {
    return std::string();
  }
  if (low > high)
  {
    reason << "no visible point has a number in the array " << array
           << ". Choose another array, or check what hides the points.";
  }
  else if (values.back() < low || values.front() > high)
  {
    reason << "the values of the array " << array << " are " << low << " to " << high
           << ", and the contour value" << (values.size() == 1 ? " is " : "s are ")
           << values.front();
    if (values.size() > 1)
    {
      reason << " to " << values.back();
    }
    reason << ". Choose contour values within that range, or another array.";
  }
  else if (NumberOfPieces(outInfo) == 1)
  {
    reason << "in the visible cells the array " << array
           << " does not cross a contour value. Its values are " << low << " to " << high
           << ". Choose other contour values.";
  }
  return reason.str();
}

// Where neither array nor value is given: one value, from the data.
bool vtkCloudSurface::TakesDefaultValue()
{
  return !this->AreValuesGiven && nephoscope::IsNoArrayChosen(this);
}

// Around the execution for all blocks of composite data: one of them with a surface is enough.
void vtkCloudSurface::BeginExecution()
{
  if (this->ExecutionDepth++ == 0) // blocks begin and end within the whole
  {
    this->Reason.clear();
    this->HasSurface = false;
    if (this->TakesDefaultValue())
    {
      this->DefaultValue = nephoscope::DefaultContourValue(nephoscope::RangeOfAllPieces(this));
    }
    // A layer for every pass, one for the gradients, and one for masses, which are less at the end
    // of a grid.
    this->Neighbours->Find(
      this->GetInputDataObject(0, 0), this->GetNumberOfSmoothingIterations() + 2);
  }
}

void vtkCloudSurface::EndExecution()
{
  if (--this->ExecutionDepth > 0)
  {
    return;
  }
  this->Neighbours->Find(nullptr, 0);
  if (!this->HasSurface && !this->Reason.empty())
  {
    vtkWarningMacro("There is no surface: " << this->Reason);
  }
}

vtkDataArray* vtkCloudSurface::FindScalars(vtkDataSet* input, vtkInformationVector** inputs)
{
  int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  vtkAbstractArray* found = nephoscope::IsNoArrayChosen(this)
    ? nephoscope::DefaultPointArray(input->GetPointData())
    : this->GetInputAbstractArrayToProcess(0, inputs, association);
  if (!found || association != vtkDataObject::FIELD_ASSOCIATION_POINTS)
  {
    vtkErrorMacro(<< nephoscope::NoPointArray(
                       input, this->GetInputArrayInformation(0)->Get(vtkDataObject::FIELD_NAME()))
                  << this->Blocks->NorInOthers());
    return nullptr;
  }
  const std::string fault = nephoscope::ArrayFault(input, found);
  if (!fault.empty())
  {
    vtkErrorMacro(<< fault);
    return nullptr;
  }
  if (found->GetNumberOfComponents() != 1)
  {
    vtkErrorMacro("The array "
      << nephoscope::QuotedName(found) << " has " << found->GetNumberOfComponents()
      << " components; one number at each point is needed. Make an array of a component or of the "
         "magnitude first (Calculator).");
    return nullptr;
  }
  return vtkDataArray::SafeDownCast(found);
}

// Sorted, each once, with the index that the user gave it.
bool vtkCloudSurface::FindValues(std::vector<double>& values, std::vector<int>& indices)
{
  const int count = static_cast<int>(this->GetNumberOfContours());
  std::vector<int> order(static_cast<std::size_t>(count));
  std::iota(order.begin(), order.end(), 0);
  for (int i : order)
  {
    if (!std::isfinite(this->GetValue(i)))
    {
      vtkErrorMacro(
        "Contour value " << i << " is " << this->GetValue(i) << "; it must be a finite number.");
      return false;
    }
  }
  std::stable_sort(order.begin(), order.end(),
    [this](int a, int b) { return this->GetValue(a) < this->GetValue(b); });
  for (int i : order)
  {
    if (values.empty() || values.back() != this->GetValue(i))
    {
      values.push_back(this->GetValue(i));
      indices.push_back(i);
    }
  }
  return true;
}

void vtkCloudSurface::SetValue(int i, double value)
{
  nephoscope::SetContourValue(this->GivenValues(), i, value);
}

void vtkCloudSurface::SetNumberOfContours(int number)
{
  nephoscope::SetNumberOfContours(this->GivenValues(), number);
}

void vtkCloudSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ComputeNormals: " << this->ComputeNormals << "\n"
     << indent << "JoinSeams: " << this->JoinSeams << "\n"
     << indent << "Smoothing:\n";
  this->Smoothing->PrintSelf(os, indent.GetNextIndent());
  os << indent << "ContourValues:\n";
  this->ContourValues->PrintSelf(os, indent.GetNextIndent());
}
