// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// When the input of a filter was last changed otherwise than by its time: what is found from the
// data once, for all times, is found anew only then.
#ifndef nephoscope_ChangeOfInput_h
#define nephoscope_ChangeOfInput_h

#include "vtkAlgorithm.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkExecutive.h"
#include "vtkType.h"

namespace nephoscope
{
// The newest change of `filter` and of all filters before it. Another time step of the same series
// does not change it.
inline vtkMTimeType ChangeOfPipeline(vtkAlgorithm* filter)
{
  auto* pipeline = vtkDemandDrivenPipeline::SafeDownCast(filter->GetExecutive());
  return pipeline ? pipeline->GetPipelineMTime() : filter->GetMTime();
}

// The same, of the filters before `filter`; 0 without an input.
inline vtkMTimeType ChangeOfInput(vtkAlgorithm* filter)
{
  vtkAlgorithm* producer =
    filter->GetNumberOfInputConnections(0) > 0 ? filter->GetInputAlgorithm(0, 0) : nullptr;
  return producer ? ChangeOfPipeline(producer) : 0;
}
}

#endif
