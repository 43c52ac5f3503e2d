// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// An input in which nothing is: a filter before it has left nothing.
#ifndef nephoscope_EmptyInput_h
#define nephoscope_EmptyInput_h

#include "MessageSuppression.h"

#include "vtkAlgorithm.h"
#include "vtkAlgorithmOutput.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkType.h"

namespace nephoscope
{
constexpr const char* whyEmpty =
  "The input is empty: it has no points and no cells. Check the filters before it, such as the limits of a Threshold, and the time.";

// Whether a filter runs for one block after the other: the block stands in the place of the
// producer's output then. ParaView inserts its own filter, which must not be updated meanwhile.
inline bool IsOfBlocks(vtkAlgorithm* producer, int port)
{
  const bool hasInput =
    producer->GetNumberOfInputPorts() > 0 && producer->GetNumberOfInputConnections(0) > 0;
  return vtkCompositeDataSet::SafeDownCast(producer->GetOutputDataObject(port)) ||
    (hasInput && vtkCompositeDataSet::SafeDownCast(producer->GetInputDataObject(0, 0)));
}

// The filter that made the input of a port; ParaView puts its own in between.
inline vtkAlgorithm* ProducerOfInput(vtkAlgorithm* filter, int port = 0)
{
  vtkAlgorithm* producer = filter->GetInputAlgorithm(port, 0);
  while (
    producer && producer->IsA("vtkPVPostFilter") && producer->GetNumberOfInputConnections(0) > 0)
  {
    producer = producer->GetInputAlgorithm(0, 0);
  }
  return producer;
}

// Whether who made the data has told why they are empty: by an error code or, where a filter in
// Python can set none, by a field array.
constexpr const char* failedName = "NephoscopeFailed";
inline bool HasFailed(vtkAlgorithm* producer, vtkDataObject* data)
{
  return (producer && producer->GetErrorCode() != vtkErrorCode::NoError) ||
    (data && data->GetFieldData() && data->GetFieldData()->HasArray(failedName));
}

// For RequestData: true where there is nothing in the input. A warning says so, once while nothing
// changes; `told` is kept by the filter, at first 0.
// Blocks, and pieces of several, may be empty. Where the filter before has failed, it has told why;
// this one fails with it.
inline bool IsEmptyInput(vtkAlgorithm* filter, vtkMTimeType& told, vtkInformationVector** inputs,
  vtkInformationVector* outputs)
{
  vtkDataObject* input = vtkDataObject::GetData(inputs[0], 0);
  if (!input || input->GetNumberOfElements(vtkDataObject::POINT) > 0 ||
    input->GetNumberOfElements(vtkDataObject::CELL) > 0)
  {
    FailureCode::Set(filter, false);
    return false;
  }
  using SDDP = vtkStreamingDemandDrivenPipeline;
  vtkInformation* outInfo = outputs->GetInformationObject(0);
  const bool isPiece = outInfo->Has(SDDP::UPDATE_NUMBER_OF_PIECES()) &&
    outInfo->Get(SDDP::UPDATE_NUMBER_OF_PIECES()) > 1;
  vtkAlgorithm* producer = ProducerOfInput(filter);
  if (HasFailed(producer, input))
  {
    FailureCode::Set(filter, true);
    return true;
  }
  vtkAlgorithmOutput* connection = filter->GetInputConnection(0, 0);
  if (!isPiece && connection && !IsOfBlocks(connection->GetProducer(), connection->GetIndex()))
  {
    ReportOnce report(filter, told);
    vtkWarningWithObjectMacro(filter, << whyEmpty);
    report.End(false);
  }
  return true;
}
}

#endif
