// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DistributedField.h"

#include "SharedArrays.h"

#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <numeric>

namespace nephoscope
{
namespace
{
// Positions whose arrays are exchanged at once: bounds the memory, whatever the size of the volume.
constexpr std::size_t ExchangeSize = 65536;

using VelocityBytes = std::array<unsigned char, sizeof(Vector3)>;
}

DistributedField::DistributedField(
  std::unique_ptr<DataSetField> local, vtkMultiProcessController* controller)
  : Local(std::move(local))
  , Controller(controller)
{
}

DistributedField::~DistributedField() = default;

// Some positions of a batch. Threads as VTK is set up for: the ranks are there for the cores
// already.
void DistributedField::SampleLocally(
  const SampleBatch& batch, const std::vector<std::size_t>& some) const
{
  const auto sample = [&](vtkIdType begin, vtkIdType end) {
    const auto count = static_cast<std::size_t>(end - begin);
    const std::size_t* indices = some.data() + begin;
    std::vector<Vector3> positions(count);
    std::vector<Vector3> velocities(count);
    std::vector<unsigned char> inside(count);
    std::vector<CellHint> hints(count);
    for (std::size_t i = 0; i < count; ++i)
    {
      positions[i] = batch.Positions[indices[i]];
      hints[i] = batch.Hints[indices[i]];
    }
    this->Local->Sample(
      { count, positions.data(), batch.Time, velocities.data(), inside.data(), hints.data() });
    for (std::size_t i = 0; i < count; ++i)
    {
      batch.Velocities[indices[i]] = velocities[i];
      batch.Inside[indices[i]] = inside[i];
      batch.Hints[indices[i]] = hints[i];
    }
  };
  if (this->Local)
  {
    vtkSMPTools::For(0, static_cast<vtkIdType>(some.size()), 256, sample);
  }
}

// The bid of a rank for a position: its number for a cell of its own; more than any rank's number
// for a ghost cell.
int DistributedField::Bid(const SampleBatch& batch, std::size_t i) const
{
  const int ranks = this->Controller->GetNumberOfProcesses();
  if (!batch.Inside[i])
  {
    return 2 * ranks;
  }
  const bool isCopy = this->Local->IsInGhostCell(batch.Hints[i]);
  return this->Controller->GetLocalProcessId() + (isCopy ? ranks : 0);
}

// Ranks elected for some positions of a batch that have been sampled locally; `accepted` is the
// highest bid that wins.
void DistributedField::Elect(const SampleBatch& batch, const std::vector<std::size_t>& some,
  int accepted, std::vector<int>& elected) const
{
  const int ranks = this->Controller->GetNumberOfProcesses();
  std::vector<int> bids(some.size());
  std::vector<int> lowest(some.size());
  std::transform(
    some.begin(), some.end(), bids.begin(), [&](std::size_t i) { return this->Bid(batch, i); });
  this->Controller->AllReduce(
    bids.data(), lowest.data(), static_cast<vtkIdType>(bids.size()), vtkCommunicator::MIN_OP);
  for (std::size_t i = 0; i < some.size(); ++i)
  {
    elected[some[i]] = lowest[i] <= accepted ? lowest[i] % ranks : ranks;
  }
}

// The rank that answers each position; one that does not exist where no rank has found it. First
// the rank is asked that has answered before, which its hint tells: searching in vain takes
// longest.
std::vector<int> DistributedField::SampleAndElect(const SampleBatch& batch) const
{
  const int ranks = this->Controller->GetNumberOfProcesses();
  std::fill_n(batch.Inside, batch.Count, static_cast<unsigned char>(0));
  std::vector<std::size_t> all(batch.Count);
  std::iota(all.begin(), all.end(), std::size_t(0));
  std::vector<std::size_t> mine;
  std::copy_if(all.begin(), all.end(), std::back_inserter(mine),
    [&](std::size_t i) { return batch.Hints[i].Cell >= 0; });
  this->SampleLocally(batch, mine);
  std::vector<int> elected(batch.Count);
  this->Elect(batch, all, ranks - 1, elected);

  std::vector<std::size_t> open; // the same on all ranks
  std::copy_if(all.begin(), all.end(), std::back_inserter(open),
    [&](std::size_t i) { return elected[i] == ranks; });
  if (!open.empty())
  {
    std::vector<std::size_t> others;
    std::set_difference(
      open.begin(), open.end(), mine.begin(), mine.end(), std::back_inserter(others));
    this->SampleLocally(batch, others);
    this->Elect(batch, open, 2 * ranks - 1, elected);
  }
  for (std::size_t i = 0; i < batch.Count; ++i)
  {
    if (elected[i] != this->Controller->GetLocalProcessId())
    {
      batch.Hints[i].Cell = -1;
    }
  }
  return elected;
}

void DistributedField::Sample(const SampleBatch& batch) const
{
  if (batch.Count == 0)
  {
    return;
  }
  const std::vector<int> elected = this->SampleAndElect(batch);
  const int rank = this->Controller->GetLocalProcessId();
  std::vector<VelocityBytes> mine(batch.Count, VelocityBytes{});
  for (std::size_t i = 0; i < batch.Count; ++i)
  {
    if (elected[i] == rank)
    {
      std::memcpy(mine[i].data(), batch.Velocities[i].data(), sizeof(Vector3));
    }
  }
  std::vector<VelocityBytes> all(batch.Count);
  this->Controller->AllReduce(mine.data()->data(), all.data()->data(),
    static_cast<vtkIdType>(batch.Count * sizeof(Vector3)), vtkCommunicator::BITWISE_OR_OP);
  for (std::size_t i = 0; i < batch.Count; ++i)
  {
    batch.Inside[i] = elected[i] < this->Controller->GetNumberOfProcesses();
    if (batch.Inside[i])
    {
      std::memcpy(batch.Velocities[i].data(), all[i].data(), sizeof(Vector3));
    }
  }
}

void DistributedField::SampleArrays(
  std::size_t count, const Vector3* positions, const CellHint*, vtkPointData* output) const
{
  const SharedArrays arrays(this->Local.get(), this->Controller);
  arrays.Allocate(count, output);
  for (int receiver = 0; receiver < this->Controller->GetNumberOfProcesses(); ++receiver)
  {
    auto total = static_cast<vtkIdType>(arrays.TupleSize() > 0 ? count : 0);
    this->Controller->Broadcast(&total, 1, receiver);
    for (std::size_t first = 0; first < static_cast<std::size_t>(total); first += ExchangeSize)
    {
      std::vector<Vector3> part(std::min(ExchangeSize, static_cast<std::size_t>(total) - first));
      if (receiver == this->Controller->GetLocalProcessId())
      {
        std::copy_n(positions + first, part.size(), part.begin());
      }
      this->Controller->Broadcast(
        part.data()->data(), static_cast<vtkIdType>(3 * part.size()), receiver);
      const std::vector<unsigned char> mine = this->AnswerArrays(part, arrays);
      std::vector<unsigned char> all(mine.size());
      this->Controller->Reduce(mine.data(), all.data(), static_cast<vtkIdType>(mine.size()),
        vtkCommunicator::BITWISE_OR_OP, receiver);
      if (receiver == this->Controller->GetLocalProcessId())
      {
        arrays.Unpack(all.data(), part.size(), first, output);
      }
    }
  }
}

// The bytes of the positions that are this rank's to answer; zeros for the others.
std::vector<unsigned char> DistributedField::AnswerArrays(
  const std::vector<Vector3>& positions, const SharedArrays& arrays) const
{
  std::vector<Vector3> velocities(positions.size());
  std::vector<unsigned char> inside(positions.size());
  std::vector<CellHint> hints(positions.size());
  const SampleBatch batch{ positions.size(), positions.data(), 0.0, velocities.data(),
    inside.data(), hints.data() };
  const std::vector<int> elected = this->SampleAndElect(batch);

  std::vector<std::size_t> places;
  std::vector<Vector3> myPositions;
  std::vector<CellHint> myHints;
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    const bool nobody =
      elected[i] == this->Controller->GetNumberOfProcesses(); // then somebody says so
    if ((nobody ? arrays.FirstRank() : elected[i]) == this->Controller->GetLocalProcessId())
    {
      places.push_back(i);
      myPositions.push_back(positions[i]);
      myHints.push_back(hints[i]);
    }
  }
  std::vector<unsigned char> bytes(positions.size() * arrays.TupleSize(), 0);
  if (!places.empty())
  {
    vtkNew<vtkPointData> sampled;
    this->Local->SampleArrays(places.size(), myPositions.data(), myHints.data(), sampled);
    arrays.Pack(sampled, places, bytes.data());
  }
  return bytes;
}
}
