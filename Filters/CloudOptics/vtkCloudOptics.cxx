// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCloudOptics.h"

#include "BlocksWithArray.h"
#include "EmptyInput.h"
#include "InputBlocks.h"
#include "OpticalArrays.h"
#include "RequiredInput.h"

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkRectilinearGrid.h"

vtkStandardNewMacro(vtkCloudOptics);

using nephoscope::OpticalArrays;
using nephoscope::WaterFields;

namespace
{
// As vtkGlobeGrid writes it; 0, a flat grid, has no vertical optical depth to keep.
double ExaggerationOf(vtkDataSet* data)
{
  vtkDataArray* array = data->GetFieldData()->GetArray("VerticalExaggeration");
  const double value = array && array->GetNumberOfTuples() > 0 ? array->GetComponent(0, 0) : 1.0;
  return value > 0 ? value : 1.0;
}

void AddColumns(vtkDataSet* data, const nephoscope::UprightOrder& order, vtkFloatArray* extinction)
{
  for (const char* name : { "OpticalDepthAbove", "ColumnOpticalDepth" })
  {
    vtkNew<vtkFloatArray> array;
    array->SetName(name);
    array->SetNumberOfTuples(data->GetNumberOfPoints());
    data->GetPointData()->AddArray(array);
  }
  const auto named = [&](const char* name) {
    return vtkFloatArray::SafeDownCast(data->GetPointData()->GetArray(name));
  };
  nephoscope::ComputeColumns(
    data, order, extinction, named("OpticalDepthAbove"), named("ColumnOpticalDepth"));
}

void AddArrays(vtkDataSet* data, const OpticalArrays& arrays, bool onCells)
{
  vtkDataSetAttributes* attributes =
    onCells ? static_cast<vtkDataSetAttributes*>(data->GetCellData()) : data->GetPointData();
  for (const auto& array :
    { arrays.Extinction, arrays.Albedo, arrays.Asymmetry, arrays.LiquidRadius, arrays.IceRadius })
  {
    attributes->AddArray(array);
  }
  attributes->SetActiveScalars("Extinction");
  const nephoscope::UprightOrder order = nephoscope::ColumnsOf(data, false);
  if (!onCells && order.GetSizes()[2] > 1)
  {
    AddColumns(data, order, arrays.Extinction);
  }
}

// As a reader of forecasts leaves them: the extinction is per metre, whatever the coordinates are.
bool IsInDegrees(vtkDataSet* data, const WaterFields& fields)
{
  double b[6];
  data->GetBounds(b);
  const bool axes = vtkRectilinearGrid::SafeDownCast(data) || vtkImageData::SafeDownCast(data);
  return axes && fields.Has(WaterFields::Height) &&
    !data->GetFieldData()->HasArray("GlobeGridProjection") && b[0] >= -360 && b[1] <= 360 &&
    b[2] >= -90 && b[3] <= 90;
}

std::string CountOf(vtkIdType count)
{
  return std::to_string(count) + (count == 1 ? " value" : " values");
}
}

vtkCloudOptics::vtkCloudOptics()
  : Blocks(std::make_unique<nephoscope::BlocksWithArray>(
      this, [this](vtkDataSet* block) { return nephoscope::HasCloudWater(block, this->Names()); }))
{
}

vtkCloudOptics::~vtkCloudOptics() = default;

nephoscope::FieldNames vtkCloudOptics::Names() const
{
  nephoscope::FieldNames names = { this->TotalWaterArrayName, this->LiquidArrayName,
    this->IceArrayName, this->RainArrayName, this->SnowArrayName, this->TemperatureArrayName,
    this->PressureArrayName, this->CloudFractionArrayName, this->LandArrayName,
    this->HeightArrayName };
  std::replace(names.begin(), names.end(), std::string("Automatic"), std::string());
  return names;
}

bool vtkCloudOptics::AddOptics(vtkDataSet* data)
{
  WaterFields fields;
  const std::string problem = nephoscope::FindWaterFields(
    data, this->Names(), static_cast<nephoscope::WaterUnits>(this->WaterUnits), fields);
  if (!problem.empty())
  {
    vtkErrorMacro(<< nephoscope::InBlock(this, data) << problem << this->Blocks->NorInOthers());
    return false;
  }
  const std::vector<double> pressures = nephoscope::PressuresOf(data, fields);
  const nephoscope::OpticalSettings settings = { this->LiquidRadiusType == CONSTANT,
    this->IceRadiusType == CONSTANT, 1e-6 * this->LiquidRadius, 1e-6 * this->IceRadius,
    1e6 * this->DropletsOverLand, 1e6 * this->DropletsOverSea, ExaggerationOf(data) };
  const OpticalArrays arrays =
    nephoscope::ComputeOptics(data, fields, pressures, settings, [this](double fraction) {
      this->UpdateProgress(fraction);
      return !this->GetAbortExecute();
    });
  if (this->GetAbortExecute())
  {
    return false;
  }
  AddArrays(data, arrays, fields.OnCells);
  if (arrays.Negative > 0)
  {
    vtkWarningMacro(<< CountOf(arrays.Negative) << " of water below 0, used as 0.");
  }
  if (IsInDegrees(data, fields))
  {
    vtkWarningMacro(
      << "The coordinates seem to be longitudes and latitudes in degrees, but Extinction is per metre: for light and pictures, put the fields "
         "through Globe Grid first.");
  }
  if (arrays.Missing > 0)
  {
    vtkWarningMacro(
      << CountOf(arrays.Missing)
      << " of water, or its pressure, missing (NaN or a fill value); there is no cloud there.");
  }
  return true;
}

int vtkCloudOptics::FillInputPortInformation(int, vtkInformation* info)
{
  nephoscope::TakeAnyData(info);
  return 1;
}

vtkTypeBool vtkCloudOptics::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return nephoscope::HasOtherInput(this, this->ToldOfInput, request, inputs, outputs,
           { "vtkDataSet" }, "It must be a dataset.") ||
    this->Superclass::ProcessRequest(request, inputs, outputs);
}

int vtkCloudOptics::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkDataSet* output = vtkDataSet::GetData(outputs, 0);
  output->ShallowCopy(vtkDataSet::GetData(inputs[0], 0));
  if (nephoscope::IsEmptyInput(this, this->ToldOfEmptiness, inputs, outputs))
  {
    return 1;
  }
  if (this->Blocks->IsLackedBy(output))
  {
    if (!this->Blocks->HasAny())
    {
      output->Initialize();
    }
    return 1;
  }
  nephoscope::ReportOnce report(this, this->Failed);
  const bool success = this->AddOptics(output);
  report.End(success);
  if (!success)
  {
    output->Initialize();
  }
  return 1;
}

void vtkCloudOptics::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "WaterUnits: " << this->WaterUnits << "\n";
  os << indent << "LiquidRadiusType: " << this->LiquidRadiusType << "\n"
     << indent << "LiquidRadius: " << this->LiquidRadius << "\n";
  os << indent << "IceRadiusType: " << this->IceRadiusType << "\n"
     << indent << "IceRadius: " << this->IceRadius << "\n";
  os << indent << "DropletsOverLand: " << this->DropletsOverLand << "\n"
     << indent << "DropletsOverSea: " << this->DropletsOverSea << "\n";
}
