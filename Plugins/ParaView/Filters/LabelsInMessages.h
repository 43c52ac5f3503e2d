// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Errors and warnings of a VTK class with the labels that its properties have in ParaView's panel.
#ifndef nephoscope_LabelsInMessages_h
#define nephoscope_LabelsInMessages_h

#include "vtkCallbackCommand.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObject.h"
#include "vtkOutputWindow.h"

#include <string>
#include <utility>
#include <vector>

namespace nephoscope
{
// Observes an object for as long as both live, and prints what it reports, once for all ranks, with every name replaced by its label.
class LabelsInMessages
{
public:
  using Labels = std::vector<std::pair<std::string, std::string>>; // name, label

  LabelsInMessages(vtkObject* object, Labels labels)
    : NameLabels(std::move(labels))
  {
    this->Printer->SetClientData(this);
    this->Printer->SetCallback([](vtkObject*, unsigned long event, void* self, void* text) {
      static_cast<LabelsInMessages*>(self)->Print(event, static_cast<const char*>(text));
    });
    object->AddObserver(vtkCommand::ErrorEvent, this->Printer);
    object->AddObserver(vtkCommand::WarningEvent, this->Printer);
  }

  LabelsInMessages(const LabelsInMessages&) = delete;
  void operator=(const LabelsInMessages&) = delete;

private:
  std::string Labelled(std::string text) const
  {
    for (const auto& [name, label] : this->NameLabels)
    {
      for (auto at = text.find(name); at != std::string::npos; at = text.find(name, at))
      {
        text.replace(at, name.size(), label);
        at += label.size();
      }
    }
    return text;
  }

  void Print(unsigned long event, const char* text) const
  {
    auto controller = vtkMultiProcessController::GetGlobalController();
    if (!text || (controller && controller->GetLocalProcessId() > 0))
    {
      return;
    }
    const std::string labelled = this->Labelled(text);
    if (event == vtkCommand::ErrorEvent)
    {
      vtkOutputWindow::GetInstance()->DisplayErrorText(labelled.c_str());
    }
    else
    {
      vtkOutputWindow::GetInstance()->DisplayWarningText(labelled.c_str());
    }
  }

  Labels NameLabels;
  vtkNew<vtkCallbackCommand> Printer;
};
}

#endif
