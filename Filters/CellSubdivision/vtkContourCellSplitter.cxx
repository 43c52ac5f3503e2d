// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkContourCellSplitter.h"

#include "ArrayNames.h"
#include "BlocksWithArray.h"
#include "ChosenPointArray.h"
#include "ContourScalars.h"
#include "ContourValueList.h"
#include "CutNumbering.h"
#include "DefaultRange.h"
#include "EmptyInput.h"
#include "OwnThreads.h"
#include "RequiredInput.h"
#include "SplitAssembly.h"
#include "SplitBatch.h"
#include "SplitPoints.h"
#include "TransitionCells.h"

#include "vtkBitArray.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

using nephoscope::CellCount;

vtkStandardNewMacro(vtkContourCellSplitter);

namespace
{
// Whatever the number of threads, so that the output is the same.
constexpr vtkIdType cellsPerBatch = 2048;
constexpr vtkIdType progressSteps = 24;
constexpr double splitShare = 0.7; // of the time, about; the rest is putting the output together

bool WantsDouble(vtkDataSet* input, int precision)
{
  auto* pointSet = vtkPointSet::SafeDownCast(input);
  const bool isFloat =
    pointSet && pointSet->GetPoints() && pointSet->GetPoints()->GetDataType() == VTK_FLOAT;
  return precision == vtkAlgorithm::DOUBLE_PRECISION ||
    (precision == vtkAlgorithm::DEFAULT_PRECISION && !isFloat);
}

std::string Cells(const CellCount& count)
{
  return std::to_string(count.Count) + (count.Count == 1 ? " cell" : " cells") +
    " (the first one is cell " + std::to_string(count.First) + ")";
}
}

vtkContourCellSplitter::vtkContourCellSplitter()
{
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
  this->Blocks = std::make_unique<nephoscope::BlocksWithArray>(
    this, [this](vtkDataSet* block) { return nephoscope::HasChosenPointArray(this, block); });
  this->AddObserver(vtkCommand::StartEvent, this, &vtkContourCellSplitter::BeginExecution);
  this->AddObserver(vtkCommand::EndEvent, this, &vtkContourCellSplitter::EndExecution);
}

vtkContourCellSplitter::~vtkContourCellSplitter() = default;

vtkMTimeType vtkContourCellSplitter::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->ContourValues->GetMTime());
}

int vtkContourCellSplitter::FillInputPortInformation(int, vtkInformation* info)
{
  nephoscope::TakeAnyData(info);
  return 1;
}

vtkTypeBool vtkContourCellSplitter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return nephoscope::HasOtherInput(this, this->ToldOfInput, request, inputs, outputs,
           { "vtkDataSet" }, "It must be a dataset with cells.") ||
    this->Superclass::ProcessRequest(request, inputs, outputs);
}

int vtkContourCellSplitter::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkDataSet* input = vtkDataSet::GetData(inputs[0], 0);
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputs, 0);
  if (nephoscope::IsEmptyInput(this, this->ToldOfEmptiness, inputs, outputs) ||
    input->GetNumberOfCells() == 0 || input->GetNumberOfPoints() == 0 ||
    this->Blocks->IsLackedBy(input))
  {
    return 1; // an empty block or piece, or one without the array, which is left out
  }
  vtkDataArray* array = this->FindScalars(input, inputs);
  nephoscope::ContourLevels levels;
  if (!array || !this->FindLevels(array, levels))
  {
    this->ErrorCode = vtkErrorCode::UserError;
    return 1; // an error has been reported; other blocks go on
  }
  bool finished = false;
  std::vector<nephoscope::SplitBatch> batches;
  nephoscope::WithThreads([&]() {
    const nephoscope::ContourScalars scalars(input, array, levels);
    finished = this->SplitCells(input, scalars, batches);
    if (finished)
    {
      this->Assemble(input, array, scalars, batches, output);
    }
  });
  if (!finished || this->CheckAbort())
  {
    output->Initialize(); // nothing rather than a part
    return 1;
  }
  this->Warn(input, array, batches);
  using SDDP = vtkStreamingDemandDrivenPipeline;
  vtkInformation* outInfo = outputs->GetInformationObject(0);
  const bool isPiece = outInfo->Has(SDDP::UPDATE_NUMBER_OF_PIECES()) &&
    outInfo->Get(SDDP::UPDATE_NUMBER_OF_PIECES()) > 1;
  const bool silent = isPiece ||
    output->GetNumberOfCells() == 0; // other pieces may be divided; what has no cells has been told
  this->Reason = silent ? std::string() : this->ReasonForNoDivision(array);
  this->HasDivided = this->HasDivided || this->Reason.empty();
  this->UpdateProgress(1.0);
  return 1;
}

vtkDataArray* vtkContourCellSplitter::FindScalars(vtkDataSet* input, vtkInformationVector** inputs)
{
  int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  vtkAbstractArray* found = nephoscope::IsNoArrayChosen(this)
    ? nephoscope::DefaultPointArray(input->GetPointData())
    : this->GetInputAbstractArrayToProcess(0, inputs, association);
  vtkInformation* wanted = this->GetInputArrayInformation(0);
  const char* name = wanted->Get(vtkDataObject::FIELD_NAME());
  const std::string called =
    name && *name ? "'" + std::string(name) + "'" : std::string("of the active scalars");
  if (!found)
  {
    const bool onCells = input->GetCellData()->HasArray(name ? name : "") ||
      (input->GetPointData()->GetNumberOfArrays() == 0 &&
        input->GetCellData()->GetNumberOfArrays() > 0);
    vtkErrorMacro("There is no point array "
      << called << " to split cells at. "
      << (onCells ? "It is on cells: apply Cell Data to Point Data first. "
                  : "Choose one with SetInputArrayToProcess. ")
      << "Point arrays: " << nephoscope::QuotedNames(input->GetPointData()) << "."
      << this->Blocks->NorInOthers());
    return nullptr;
  }
  auto* array = vtkDataArray::SafeDownCast(found);
  if (association != vtkDataObject::FIELD_ASSOCIATION_POINTS)
  {
    vtkErrorMacro("The array " << nephoscope::QuotedName(found)
                               << " is not on points, so it is not continuous and has no contours. "
                                  "Apply Cell Data to Point Data first.");
    return nullptr;
  }
  if (!array || vtkBitArray::SafeDownCast(found) || array->GetNumberOfComponents() != 1)
  {
    vtkErrorMacro("The array " << nephoscope::QuotedName(found) << " of type "
                               << found->GetDataTypeAsString() << " has "
                               << found->GetNumberOfComponents()
                               << " components; one number at each point is needed. Make an array "
                                  "of a component or of the magnitude first (Calculator).");
    return nullptr;
  }
  if (array->GetNumberOfTuples() != input->GetNumberOfPoints())
  {
    vtkErrorMacro("The array " << nephoscope::QuotedName(array) << " has "
                               << array->GetNumberOfTuples() << " values for "
                               << input->GetNumberOfPoints() << " points.");
    return nullptr;
  }
  return array;
}

// Where neither array nor value is given: one value, from the data.
bool vtkContourCellSplitter::TakesDefaultValue()
{
  return !this->AreValuesGiven && nephoscope::IsNoArrayChosen(this);
}

bool vtkContourCellSplitter::FindLevels(vtkDataArray* scalars, nephoscope::ContourLevels& levels)
{
  std::vector<double> values;
  for (int i = 0; i < this->GetNumberOfContours(); ++i)
  {
    values.push_back(this->GetValue(i));
    if (!std::isfinite(values.back()))
    {
      vtkErrorMacro(
        "Contour value " << i << " is " << values.back() << "; it must be a finite number.");
      return false;
    }
  }
  if (this->TakesDefaultValue())
  {
    values = { nephoscope::DefaultContourValue(this->DefaultRange) };
  }
  for (double& value : values)
  {
    // The value rounded to float for a float array, so that the scalar on the cuts equals the value
    // that divides the cells.
    value =
      scalars->GetDataType() == VTK_FLOAT ? static_cast<double>(static_cast<float>(value)) : value;
  }
  levels = nephoscope::ContourLevels(values);
  return true;
}

// Empty if the array passes a value, or there is none.
std::string vtkContourCellSplitter::ReasonForNoDivision(vtkDataArray* array)
{
  std::ostringstream reason;
  if (this->TakesDefaultValue())
  {
    const std::array<double, 2>& all =
      this->DefaultRange; // of all blocks; the value is in the middle
    reason << "the values of the array " << nephoscope::QuotedName(array) << " are all " << all[0]
           << ", so that no value is between them. Choose another array.";
    return all[0] == all[1] ? reason.str() : std::string();
  }
  double range[2];
  array->GetFiniteRange(range, 0);
  for (int i = 0; i < this->GetNumberOfContours(); ++i)
  {
    if (this->GetValue(i) >= range[0] && this->GetValue(i) <= range[1])
    {
      return std::string();
    }
  }
  reason
    << "the values of the array " << nephoscope::QuotedName(array) << " are " << range[0] << " to "
    << range[1]
    << ", but no contour value is within that range. Choose other contour values, or another array.";
  return this->GetNumberOfContours() > 0 ? reason.str() : std::string();
}

// Around the execution for all blocks of composite data: one of them with a divided cell is enough.
void vtkContourCellSplitter::BeginExecution()
{
  if (this->ExecutionDepth++ == 0) // blocks begin and end within the whole
  {
    this->Reason.clear();
    this->HasDivided = false;
    if (this->TakesDefaultValue())
    {
      this->DefaultRange = nephoscope::RangeOfAllPieces(this);
    }
  }
}

void vtkContourCellSplitter::EndExecution()
{
  if (--this->ExecutionDepth == 0 && !this->HasDivided && !this->Reason.empty())
  {
    vtkWarningMacro("No cell is divided: " << this->Reason);
  }
}

bool vtkContourCellSplitter::SplitCells(vtkDataSet* input,
  const nephoscope::ContourScalars& scalars, std::vector<nephoscope::SplitBatch>& batches)
{
  const vtkIdType cells = input->GetNumberOfCells();
  const vtkIdType count = (cells + cellsPerBatch - 1) / cellsPerBatch;
  const vtkIdType step = (count + progressSteps - 1) / progressSteps;
  batches.resize(static_cast<std::size_t>(count));
  for (vtkIdType first = 0; first < count; first += step)
  {
    vtkSMPTools::For(first, std::min(first + step, count), 1, [&](vtkIdType begin, vtkIdType end) {
      nephoscope::CellSplitter splitter(
        input, scalars, { this->GenerateSurfaces, this->PolyhedralTransitions });
      for (vtkIdType b = begin; b < end; ++b)
      {
        batches[static_cast<std::size_t>(b)] =
          splitter.Split(b * cellsPerBatch, std::min((b + 1) * cellsPerBatch, cells));
      }
    });
    this->UpdateProgress(
      splitShare * static_cast<double>(std::min(first + step, count)) / static_cast<double>(count));
    if (this->CheckAbort())
    {
      return false;
    }
  }
  return true;
}

void vtkContourCellSplitter::Assemble(vtkDataSet* input, vtkDataArray* array,
  const nephoscope::ContourScalars& scalars, std::vector<nephoscope::SplitBatch>& batches,
  vtkUnstructuredGrid* output)
{
  if (this->PolyhedralTransitions)
  {
    nephoscope::TransitionCells(input, batches).Convert(batches);
  }
  const nephoscope::CutNumbering cuts(batches, input->GetNumberOfPoints());
  const nephoscope::SplitPoints splitPoints(input, array, scalars, batches, cuts.Cuts);
  vtkNew<vtkPoints> points;
  points->SetDataType(WantsDouble(input, this->OutputPointsPrecision) ? VTK_DOUBLE : VTK_FLOAT);
  splitPoints.Place(points);
  output->SetPoints(points);
  splitPoints.CarryArrays(output->GetPointData());
  this->UpdateProgress(0.85);
  const nephoscope::SplitAssembly assembly(input, scalars.Levels(), batches, cuts, splitPoints);
  assembly.AddCells(output);
  assembly.CarryCellArrays(output);
  assembly.AddLayers(output);
}

void vtkContourCellSplitter::Warn(
  vtkDataSet* input, vtkDataArray* array, const std::vector<nephoscope::SplitBatch>& batches)
{
  CellCount missing;
  CellCount flat;
  CellCount undivided;
  CellCount notConvex;
  CellCount notLinear;
  for (const nephoscope::SplitBatch& batch : batches)
  {
    missing.Add(batch.Missing);
    flat.Add(batch.Flat);
    undivided.Add(batch.Undivided);
    notConvex.Add(batch.NotConvex);
    notLinear.Add(batch.NotLinear);
  }
  if (missing.Count > 0)
  {
    vtkWarningMacro("The array "
      << nephoscope::QuotedName(array) << " is not a finite number at vertices of "
      << Cells(missing)
      << ". They stay undivided, with Layer -1. Threshold the array Layer to remove them.");
  }
  if (flat.Count > 0)
  {
    vtkWarningMacro(
      << Cells(flat) << " of the input " << (flat.Count == 1 ? "is" : "are")
      << " not three-dimensional, and left out. Extract surfaces and lines separately to keep them.");
  }
  if (undivided.Count > 0)
  {
    vtkWarningMacro(<< Cells(undivided) << " crossed by a value "
                    << (undivided.Count == 1 ? "has" : "have")
                    << " no volume to divide. They are left whole, with Layer -1.");
  }
  if (notConvex.Count > 0)
  {
    vtkWarningMacro(
      << Cells(notConvex) << " crossed by a value " << (notConvex.Count == 1 ? "is" : "are")
      << " not convex. The pieces overlap or leave gaps there. Divide such cells into tetrahedra first.");
  }
  if (notLinear.Count > 0)
  {
    vtkWarningMacro(
      << Cells(notLinear) << " crossed by a value " << (notLinear.Count == 1 ? "is" : "are")
      << " not linear, and divided as VTK triangulates them; neighbours may not fit. Divide such cells into "
         "tetrahedra first (Tetrahedralize).");
  }
  for (const char* name : { "Layer", "ContourIndex" })
  {
    if (input->GetCellData()->HasArray(name))
    {
      vtkWarningMacro(
        "The cell array '" << name << "' of the input has been replaced. Rename it to keep it.");
    }
  }
}

void vtkContourCellSplitter::SetValue(int i, double value)
{
  nephoscope::SetContourValue(this->GivenValues(), i, value);
}

void vtkContourCellSplitter::SetNumberOfContours(int number)
{
  nephoscope::SetNumberOfContours(this->GivenValues(), number);
}

void vtkContourCellSplitter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "GenerateSurfaces: " << this->GenerateSurfaces << "\n"
     << indent << "PolyhedralTransitions: " << this->PolyhedralTransitions << "\n"
     << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n"
     << indent << "ContourValues:\n";
  this->ContourValues->PrintSelf(os, indent.GetNextIndent());
}
