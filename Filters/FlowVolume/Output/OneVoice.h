// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Lets one of several ranks that find the same errors print them.
#ifndef nephoscope_OneVoice_h
#define nephoscope_OneVoice_h

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkObject.h"

namespace nephoscope
{
// While it lives, errors and warnings of an object are told only if it `speaks`.
class OneVoice
{
public:
  OneVoice(vtkObject* object, bool speaks)
    : Object(object)
  {
    if (!speaks)
    {
      this->Silence->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
      this->Silence->SetAbortFlagOnExecute(1); // before all others that listen
      object->AddObserver(vtkCommand::ErrorEvent, this->Silence, 1.0f);
      object->AddObserver(vtkCommand::WarningEvent, this->Silence, 1.0f);
    }
  }

  ~OneVoice() { this->Object->RemoveObserver(this->Silence); }

  OneVoice(const OneVoice&) = delete;
  void operator=(const OneVoice&) = delete;

private:
  vtkObject* Object;
  vtkNew<vtkCallbackCommand> Silence;
};
}

#endif
