// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** Exchange of each rank with each other one. */
#ifndef nephoscope_RankExchange_h
#define nephoscope_RankExchange_h

#include "vtkMultiProcessController.h"
#include "vtkType.h"

#include <cstddef>
#include <type_traits>
#include <vector>

namespace nephoscope
{

/**
 * Calls send(rank) and receive(rank) for each other rank. Pairs of ranks meet in one order
 * everywhere, so that nobody waits for somebody who waits. Collective.
 */
template <typename Send, typename Receive>
void MeetOtherRanks(vtkMultiProcessController* controller, const Send& send, const Receive& receive)
{
  const int mine = controller->GetLocalProcessId();
  for (int other = 0; other < controller->GetNumberOfProcesses(); ++other)
  {
    if (other > mine)
    {
      send(other);
    }
    if (other != mine)
    {
      receive(other);
    }
    if (other < mine)
    {
      send(other);
    }
  }
}

/**
 * The records, plain data, that each rank has for this one; `own`: those that this one has for each
 * rank. Collective.
 */
template <typename Record>
std::vector<std::vector<Record>> TradeRecords(
  vtkMultiProcessController* controller, const std::vector<std::vector<Record>>& own)
{
  static_assert(std::is_trivially_copyable<Record>::value, "sent as bytes");
  constexpr int tag = 26130;
  std::vector<std::vector<Record>> others(own.size());
  const auto bytes = [](const std::vector<Record>& records) {
    return static_cast<vtkIdType>(records.size() * sizeof(Record));
  };
  const auto send = [&](int rank) {
    const auto& records = own[static_cast<std::size_t>(rank)];
    const auto count = static_cast<vtkIdType>(records.size());
    controller->Send(&count, 1, rank, tag);
    controller->Send(reinterpret_cast<const char*>(records.data()), bytes(records), rank, tag + 1);
  };
  const auto receive = [&](int rank) {
    auto& records = others[static_cast<std::size_t>(rank)];
    vtkIdType count = 0;
    controller->Receive(&count, 1, rank, tag);
    records.resize(static_cast<std::size_t>(count));
    controller->Receive(reinterpret_cast<char*>(records.data()), bytes(records), rank, tag + 1);
  };
  MeetOtherRanks(controller, send, receive);
  return others;
}

} // namespace nephoscope

#endif
