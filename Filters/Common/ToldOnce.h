// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// A pipeline asks a filter that has made nothing again and again: what is wrong is told once, until something has changed.
#ifndef nephoscope_ToldOnce_h
#define nephoscope_ToldOnce_h

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkNew.h"
#include "vtkType.h"

#include <algorithm>

namespace nephoscope
{
// While it lives, errors and warnings of a filter are told to nobody, if the last execution failed and nothing has changed since in the filter and
// those before it. (The input itself may be made anew, and be the same.)
class ToldOnce
{
public:
  // `failed` is kept by the filter, at first 0.
  ToldOnce(vtkAlgorithm* filter, vtkMTimeType& failed)
    : Filter(filter)
    , Failed(failed)
    , Now(filter->GetMTime())
  {
    if (auto* pipeline = vtkDemandDrivenPipeline::SafeDownCast(filter->GetExecutive()))
    {
      this->Now = std::max(this->Now, pipeline->GetPipelineMTime());
    }
    if (this->Failed == this->Now)
    {
      this->Silence->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
      this->Silence->SetAbortFlagOnExecute(1); // before all others that listen
      filter->AddObserver(vtkCommand::ErrorEvent, this->Silence, 1.0f);
      filter->AddObserver(vtkCommand::WarningEvent, this->Silence, 1.0f);
    }
  }

  ~ToldOnce() { this->Filter->RemoveObserver(this->Silence); }

  ToldOnce(const ToldOnce&) = delete;
  void operator=(const ToldOnce&) = delete;

  void End(bool success) { this->Failed = success ? 0 : this->Now; }

private:
  vtkAlgorithm* Filter;
  vtkMTimeType& Failed;
  vtkMTimeType Now;
  vtkNew<vtkCallbackCommand> Silence;
};
}

#endif
