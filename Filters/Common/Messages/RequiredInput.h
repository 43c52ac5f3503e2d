// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// An input of a kind that a filter cannot use. The pipeline reports it at every request, in several
// lines of its own; this reports it once.
#ifndef nephoscope_RequiredInput_h
#define nephoscope_RequiredInput_h

#include "MessageSuppression.h"

#include "vtkAlgorithm.h"
#include "vtkCell.h"
#include "vtkDataObject.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <initializer_list>
#include <map>
#include <string>

namespace nephoscope
{
inline std::string KindOf(vtkDataObject* data)
{
  static const std::map<std::string, std::string> kinds = { { "vtkImageData", "an image" },
    { "vtkUniformGrid", "an image" }, { "vtkRectilinearGrid", "a rectilinear grid" },
    { "vtkStructuredGrid", "a structured grid" }, { "vtkUnstructuredGrid", "an unstructured grid" },
    { "vtkPolyData", "a surface or points" }, { "vtkTable", "a table" },
    { "vtkHyperTreeGrid", "a hyper tree grid" } };
  const auto kind = kinds.find(data->GetClassName());
  return kind == kinds.end() ? std::string("a ") + data->GetClassName() : kind->second;
}

// What makes a dataset with cells, or one with rows, of the input; empty where nothing does.
inline std::string RemedyFor(vtkDataObject* data, bool withRows = false)
{
  auto* cells = vtkUnstructuredGrid::SafeDownCast(data);
  if (withRows && cells && cells->GetNumberOfCells() > 0 &&
    cells->GetCell(0)->GetCellDimension() == 3)
  {
    return " Apply vtkResampleToImage first.";
  }
  return !data || !data->IsA("vtkHyperTreeGrid")
    ? ""
    : std::string(" Apply vtkHyperTreeGridToUnstructuredGrid first") +
      (withRows ? ", then vtkResampleToImage." : ".");
}

// For FillInputPortInformation: the pipeline rejects only composite data, because it iterates over
// their blocks.
inline void TakeAnyData(vtkInformation* port)
{
  port->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  for (const char* kind :
    { "vtkDataSet", "vtkTable", "vtkHyperTreeGrid", "vtkGraph", "vtkMolecule" })
  {
    port->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), kind);
  }
}

// For ProcessRequest: true where the input is of none of these kinds, and the request is done with:
// the output is empty. `needed`, the sentence with the remedy, is reported once while nothing
// changes; `told` is kept by the filter, at first 0.
inline bool HasOtherInput(vtkAlgorithm* filter, vtkMTimeType& told, vtkInformation* request,
  vtkInformationVector** inputs, vtkInformationVector* outputs,
  std::initializer_list<const char*> kinds, const char* needed)
{
  vtkDataObject* input =
    inputs[0]->GetNumberOfInformationObjects() > 0 ? vtkDataObject::GetData(inputs[0], 0) : nullptr;
  const auto isOfKind = [input](const char* kind) { return input->IsA(kind) != 0; };
  if (!input || input->IsA("vtkCompositeDataSet") ||
    std::any_of(kinds.begin(), kinds.end(), isOfKind))
  {
    if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA()))
    {
      FailureCode::Set(filter, false);
    }
    return false;
  }
  const auto takes = [&kinds](const char* kind) {
    return std::any_of(
      kinds.begin(), kinds.end(), [kind](const char* other) { return std::string(kind) == other; });
  };
  const std::string remedy = takes("vtkDataSet") || takes("vtkImageData")
    ? RemedyFor(input, takes("vtkImageData"))
    : std::string();
  vtkInformation* outInfo = outputs->GetInformationObject(0);
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()))
  {
    const bool likeInput = std::string(filter->GetOutputPortInformation(0)->Get(
                             vtkDataObject::DATA_TYPE_NAME())) == "vtkDataSet";
    if (likeInput && !input->IsA("vtkDataSet"))
    {
      outInfo->Set(vtkDataObject::DATA_OBJECT(), vtkNew<vtkPolyData>());
      return true;
    }
    return false;
  }
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_INFORMATION()))
  {
    const int nothing[6] = { 0, -1, 0, -1, 0, -1 };
    outInfo->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), nothing, 6);
  }
  // On several ranks the pipeline divides the empty extent, and would ask the filters before this
  // one for parts without end.
  if (request->Has(vtkStreamingDemandDrivenPipeline::REQUEST_UPDATE_EXTENT()))
  {
    vtkInformation* inInfo = inputs[0]->GetInformationObject(0);
    inInfo->Remove(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT());
    if (inInfo->Has(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()))
    {
      inInfo->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(),
        inInfo->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()), 6);
    }
  }
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA()))
  {
    auto* pipeline = vtkDemandDrivenPipeline::SafeDownCast(filter->GetExecutive());
    const vtkMTimeType now =
      std::max(filter->GetMTime(), pipeline ? pipeline->GetPipelineMTime() : 0);
    if (now != told)
    {
      vtkErrorWithObjectMacro(
        filter, << "The input is " << KindOf(input) << ". " << needed << remedy);
    }
    told = now;
    FailureCode::Set(filter, true);
    vtkDataObject::GetData(outInfo)->Initialize();
  }
  return true;
}
}

#endif
