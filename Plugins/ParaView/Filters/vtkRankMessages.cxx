// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRankMessages.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"
#include "vtkPVSession.h"
#include "vtkSMProxy.h"
#include "vtkSMSession.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cctype>
#include <regex>
#include <set>
#include <vector>

vtkStandardNewMacro(vtkRankMessages);

namespace
{
constexpr char isError = 'e', isWarning = 'w';

struct Messages
{
  std::string Kept;           // letter, text and a zero byte of each
  std::set<std::string> Told; // by the first rank since it last heard of the others
};

Messages& AllMessages()
{
  static Messages own;
  return own;
}

// Behind the file, the class and the address.
std::size_t BeginOfSentence(const std::string& text)
{
  const auto head = text.find("): ");
  return head == std::string::npos ? 0 : head + 3;
}

// Whether it has a number of points or cells, of which every rank has its own.
bool Counts(const std::string& text)
{
  static const std::regex count(
    "[0-9] (blanked |hidden )?(points?|cells?|samples?|values?|polygons?|tetrahedra)\\b");
  return std::regex_search(
    text.begin() + static_cast<std::ptrdiff_t>(BeginOfSentence(text)), text.end(), count);
}

std::string WithoutNumbers(const std::string& text)
{
  std::string words = text.substr(BeginOfSentence(text));
  words.erase(std::remove_if(
                words.begin(), words.end(), [](unsigned char c) { return std::isdigit(c) != 0; }),
    words.end());
  return words;
}

void Show(char kind, const std::string& text)
{
  kind == isError ? vtkOutputWindow::GetInstance()->DisplayErrorText(text.c_str())
                  : vtkOutputWindow::GetInstance()->DisplayWarningText(text.c_str());
}

void ShowOfRank(std::string text, int rank)
{
  const char kind = text.front();
  text.erase(0, 1);
  if (AllMessages().Told.insert(WithoutNumbers(text)).second)
  {
    Show(kind, text.insert(BeginOfSentence(text), "Rank " + std::to_string(rank) + ": "));
  }
}

std::vector<char> Gather(vtkMultiProcessController* ranks, const std::string& mine,
  std::vector<vtkIdType>& lengths, std::vector<vtkIdType>& offsets)
{
  const auto length = static_cast<vtkIdType>(mine.size());
  lengths.assign(static_cast<std::size_t>(ranks->GetNumberOfProcesses()), 0);
  ranks->AllGather(&length, lengths.data(), 1);
  offsets.assign(1, 0);
  for (const vtkIdType its : lengths)
  {
    offsets.push_back(offsets.back() + its);
  }
  std::vector<char> all(static_cast<std::size_t>(offsets.back()));
  if (!all.empty())
  {
    ranks->GatherV(mine.data(), all.data(), length, lengths.data(), offsets.data(), 0);
  }
  return all;
}

void OnUpdated(vtkObject* caller, unsigned long, void*, void*)
{
  auto* manager = vtkSMProxy::SafeDownCast(caller)->GetSessionProxyManager();
  vtkSmartPointer<vtkSMProxy> ranks;
  ranks.TakeReference(manager->NewProxy("nephoscope", "RankMessages"));
  if (ranks)
  {
    ranks->UpdateVTKObjects();
    ranks->InvokeCommand("Flush");
  }
}
}

void vtkRankMessages::Tell(unsigned long event, const std::string& text)
{
  const char kind = event == vtkCommand::ErrorEvent ? isError : isWarning;
  auto* ranks = vtkMultiProcessController::GetGlobalController();
  if (ranks && ranks->GetLocalProcessId() > 0)
  {
    AllMessages().Kept += kind + text + '\0';
    return;
  }
  std::string told = text;
  if (ranks && ranks->GetNumberOfProcesses() > 1)
  {
    AllMessages().Told.insert(WithoutNumbers(text));
    told.insert(BeginOfSentence(text), Counts(text) ? "Rank 0: " : "");
  }
  Show(kind, told);
}

void vtkRankMessages::Flush()
{
  auto* ranks = vtkMultiProcessController::GetGlobalController();
  if (!ranks || ranks->GetNumberOfProcesses() < 2)
  {
    return;
  }
  std::vector<vtkIdType> lengths, offsets;
  const std::vector<char> all = Gather(ranks, AllMessages().Kept, lengths, offsets);
  AllMessages().Kept.clear();
  for (int rank = 1; ranks->GetLocalProcessId() == 0 && rank < ranks->GetNumberOfProcesses();
       ++rank)
  {
    const auto end = all.begin() + offsets[static_cast<std::size_t>(rank) + 1];
    for (auto at = all.begin() + offsets[static_cast<std::size_t>(rank)]; at != end;)
    {
      const auto stop = std::find(at, end, '\0');
      ShowOfRank(std::string(at, stop), rank);
      at = stop + 1;
    }
  }
  AllMessages().Told.clear();
}

void vtkRankMessages::Follow(vtkSMProxy* proxy)
{
  if (proxy->GetSession()->GetNumberOfProcesses(vtkPVSession::SERVERS) > 1)
  {
    vtkNew<vtkCallbackCommand> command;
    command->SetCallback(OnUpdated);
    proxy->AddObserver(vtkCommand::UpdateDataEvent, command);
    proxy->AddObserver(vtkCommand::EndEvent, command);
  }
}
