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

// Threads as VTK is set up for: the ranks are there for the cores already.
void DistributedField::SampleLocally(const SampleBatch& batch) const
{
  std::fill_n(batch.Inside, batch.Count, static_cast<unsigned char>(0));
  if (!this->Local)
  {
    return;
  }
  vtkSMPTools::For(0, static_cast<vtkIdType>(batch.Count), 256, [&](vtkIdType begin, vtkIdType end) {
    this->Local->Sample({ static_cast<std::size_t>(end - begin), batch.Positions + begin, batch.Time,
      batch.Velocities + begin, batch.Inside + begin, batch.Hints + begin });
  });
}

// The rank that answers each position of a batch that has been sampled locally; one that does not exist where no rank
// has found it.
std::vector<int> DistributedField::ElectRanks(const SampleBatch& sampled) const
{
  const int ranks = this->Controller->GetNumberOfProcesses();
  const int rank = this->Controller->GetLocalProcessId();
  std::vector<int> bids(sampled.Count, 2 * ranks); // a ghost's bid loses against any owner's
  for (std::size_t i = 0; i < sampled.Count; ++i)
  {
    if (sampled.Inside[i])
    {
      bids[i] = rank + (this->Local->IsInGhostCell(sampled.Hints[i]) ? ranks : 0);
    }
  }
  std::vector<int> elected(sampled.Count);
  this->Controller->AllReduce(bids.data(), elected.data(), static_cast<vtkIdType>(bids.size()), vtkCommunicator::MIN_OP);
  for (int& bid : elected)
  {
    bid = bid < 2 * ranks ? bid % ranks : ranks;
  }
  return elected;
}

void DistributedField::Sample(const SampleBatch& batch) const
{
  if (batch.Count == 0)
  {
    return;
  }
  this->SampleLocally(batch);
  const std::vector<int> elected = this->ElectRanks(batch);
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
      this->Controller->Broadcast(part.data()->data(), static_cast<vtkIdType>(3 * part.size()), receiver);
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
  const SampleBatch batch{ positions.size(), positions.data(), 0.0, velocities.data(), inside.data(), hints.data() };
  this->SampleLocally(batch);
  const std::vector<int> elected = this->ElectRanks(batch);

  std::vector<std::size_t> places;
  std::vector<Vector3> myPositions;
  std::vector<CellHint> myHints;
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    const bool nobody = elected[i] == this->Controller->GetNumberOfProcesses(); // then somebody says so
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
