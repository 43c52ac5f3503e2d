// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Messages that would be repeated: by a filter that has failed and is asked again, or by every
// rank.
#ifndef nephoscope_MessageSuppression_h
#define nephoscope_MessageSuppression_h

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkErrorCode.h"
#include "vtkNew.h"
#include "vtkType.h"

#include <algorithm>

namespace nephoscope
{
// A failure as the filter's error code, for scripts and for what draws the empty output.
class FailureCode : public vtkAlgorithm
{
public:
  static void Set(vtkAlgorithm* filter, bool failed)
  {
    // SetErrorCode is protected, and would have the filter execute again.
    filter->*(&FailureCode::ErrorCode) = failed ? vtkErrorCode::UserError : vtkErrorCode::NoError;
  }
};

// While it lives, the errors and warnings of an object are not reported, if `suppressed`.
class MessageSuppression
{
public:
  MessageSuppression(vtkObject* object, bool suppressed)
    : Object(object)
  {
    if (suppressed)
    {
      this->Silence->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
      this->Silence->SetAbortFlagOnExecute(1); // before all other observers
      object->AddObserver(vtkCommand::ErrorEvent, this->Silence, 1.0f);
      object->AddObserver(vtkCommand::WarningEvent, this->Silence, 1.0f);
    }
  }

  ~MessageSuppression() { this->Object->RemoveObserver(this->Silence); }

  MessageSuppression(const MessageSuppression&) = delete;
  void operator=(const MessageSuppression&) = delete;

private:
  vtkObject* Object;
  vtkNew<vtkCallbackCommand> Silence;
};

// Suppresses the messages of a filter if its last execution failed, and neither the filter nor
// those before it have changed since. (The input itself may be made anew, and be the same.)
class ReportOnce
{
public:
  // `failed` is kept by the filter, at first 0.
  ReportOnce(vtkAlgorithm* filter, vtkMTimeType& failed)
    : Filter(filter)
    , Failed(failed)
    , Now(TimeOf(filter))
    , Suppression(filter, failed == this->Now)
  {
  }

  void End(bool success)
  {
    this->Failed = success ? 0 : this->Now;
    FailureCode::Set(this->Filter, !success);
  }

private:
  static vtkMTimeType TimeOf(vtkAlgorithm* filter)
  {
    auto* pipeline = vtkDemandDrivenPipeline::SafeDownCast(filter->GetExecutive());
    return pipeline ? std::max(filter->GetMTime(), pipeline->GetPipelineMTime())
                    : filter->GetMTime();
  }

  vtkAlgorithm* Filter;
  vtkMTimeType& Failed;
  vtkMTimeType Now;
  MessageSuppression Suppression;
};
}

#endif
