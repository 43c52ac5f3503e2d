// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// What one object reports, told as by another one: whoever observes that one, as a host does, hears
// of its parts too.
#ifndef nephoscope_ForwardedMessages_h
#define nephoscope_ForwardedMessages_h

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkOutputWindow.h"
#include "vtkWeakPointer.h"

namespace nephoscope
{
inline void ForwardMessages(vtkObject* from, vtkObject* to)
{
  using Target = vtkWeakPointer<vtkObject>; // `from` may outlive it
  vtkNew<vtkCallbackCommand> forward;
  forward->SetClientData(new Target(to));
  forward->SetClientDataDeleteCallback([](void* target) { delete static_cast<Target*>(target); });
  forward->SetCallback([](vtkObject*, unsigned long event, void* target, void* text) {
    vtkObject* other = *static_cast<Target*>(target);
    if (other && other->HasObserver(event))
    {
      other->InvokeEvent(event, text);
    }
    else if (event == vtkCommand::ErrorEvent)
    {
      vtkOutputWindow::GetInstance()->DisplayErrorText(static_cast<const char*>(text));
    }
    else
    {
      vtkOutputWindow::GetInstance()->DisplayWarningText(static_cast<const char*>(text));
    }
  });
  from->AddObserver(vtkCommand::ErrorEvent, forward);
  from->AddObserver(vtkCommand::WarningEvent, forward);
}
}

#endif
