// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FlowVolumeExchange.h"

#include "BlankedCells.h"
#include "DataSets.h"
#include "DistributedField.h"
#include "MeshSlice.h"
#include "PolygonUnion.h"
#include "VelocityChoice.h"
#include "VelocityProblem.h"

#include "vtkBoundingBox.h"
#include "vtkCommunicator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkMultiProcessStream.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <numeric>
#include <vector>

namespace nephoscope
{
FlowVolumeExchange::FlowVolumeExchange(vtkMultiProcessController* controller)
  : Controller(controller)
  , Rank(controller ? controller->GetLocalProcessId() : 0)
  , Ranks(controller ? controller->GetNumberOfProcesses() : 1)
{
}

void FlowVolumeExchange::RequestParts(vtkInformationVector** inputs) const
{
  const auto ghosts = vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS();
  for (int port = 0; port < 2 && !this->IsAlone(); ++port)
  {
    if (vtkInformation* info = inputs[port]->GetInformationObject(0))
    {
      info->Set(ghosts, port == 0 ? 1 : 0);
    }
  }
}

int FlowVolumeExchange::FirstTrue(bool here) const
{
  const int mine = here ? this->Rank : this->Ranks;
  int first = mine;
  if (!this->IsAlone())
  {
    this->Controller->AllReduce(&mine, &first, 1, vtkCommunicator::MIN_OP);
  }
  return first;
}

bool FlowVolumeExchange::AnyTrue(bool here) const
{
  return this->FirstTrue(here) < this->Ranks;
}

bool FlowVolumeExchange::AllTrue(bool here) const
{
  return !this->AnyTrue(!here);
}

std::string FlowVolumeExchange::AgreeOnProblem(const std::string& problem) const
{
  const int speaker = this->FirstTrue(!problem.empty());
  if (this->IsAlone() || speaker == this->Ranks)
  {
    return problem;
  }
  vtkMultiProcessStream stream;
  stream << problem;
  this->Controller->Broadcast(stream, speaker);
  std::string agreed = problem;
  if (speaker != this->Rank)
  {
    stream >> agreed;
  }
  return agreed;
}

void FlowVolumeExchange::Unite(vtkBoundingBox& box) const
{
  if (this->IsAlone())
  {
    return;
  }
  double bounds[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  if (box.IsValid())
  {
    box.GetBounds(bounds);
  }
  std::vector<double> all(6 * static_cast<std::size_t>(this->Ranks));
  this->Controller->AllGather(bounds, all.data(), 6);
  box.Reset();
  for (std::size_t r = 0; r < static_cast<std::size_t>(this->Ranks); ++r)
  {
    if (all[6 * r] <= all[6 * r + 1])
    {
      box.AddBounds(&all[6 * r]);
    }
  }
}

std::vector<double> FlowVolumeExchange::Gather(const std::vector<double>& mine) const
{
  if (this->IsAlone())
  {
    return mine;
  }
  const auto ranks = static_cast<std::size_t>(this->Ranks);
  const auto count = static_cast<vtkIdType>(mine.size());
  std::vector<vtkIdType> counts(ranks), offsets(ranks, 0);
  this->Controller->AllGather(&count, counts.data(), 1);
  std::partial_sum(counts.begin(), counts.end() - 1, offsets.begin() + 1);
  std::vector<double> all(static_cast<std::size_t>(offsets.back() + counts.back()));
  this->Controller->AllGatherV(mine.data(), all.data(), count, counts.data(), offsets.data());
  return all;
}

vtkBoundingBox FlowVolumeExchange::BoundsOf(const std::vector<vtkDataSet*>& sets) const
{
  vtkBoundingBox box = nephoscope::BoundsOf(sets);
  this->Unite(box);
  return box;
}

double FlowVolumeExchange::DiagonalOf(const std::vector<vtkDataSet*>& sets) const
{
  const vtkBoundingBox box = this->BoundsOf(sets);
  return box.IsValid() ? box.GetDiagonalLength() : 0.0;
}

double FlowVolumeExchange::SmallestBlanked(const std::vector<vtkDataSet*>& sets) const
{
  return SmallestSize(this->Gather({ SmallestBlankedCell(sets) }));
}

bool FlowVolumeExchange::ChooseVelocity(
  vtkDataObject* data, vtkInformation* wanted, VelocityArray& choice, std::string& problem) const
{
  std::string mine;
  const bool chosen = nephoscope::ChooseVelocity(data, wanted, choice, mine);
  const int first = this->FirstTrue(chosen);
  if (first == this->Ranks)
  {
    const bool hasCells = !DataSetsOf(data).empty();
    problem = this->AgreeOnProblem(hasCells || !this->AnyTrue(hasCells) ? mine : std::string());
    return false;
  }
  if (this->IsAlone())
  {
    return true;
  }
  vtkMultiProcessStream stream;
  stream << choice.Name << static_cast<int>(choice.OnCells);
  this->Controller->Broadcast(stream, first);
  if (first != this->Rank)
  {
    int onCells = 0;
    stream >> choice.Name >> onCells;
    choice.OnCells = onCells != 0;
  }
  return true;
}

std::unique_ptr<DataSetField> FlowVolumeExchange::MakeVelocityField(
  vtkDataObject* data, const VelocityArray& array, std::string& problem) const
{
  std::string mine;
  std::unique_ptr<DataSetField> local;
  if (this->IsAlone() || !DataSetsOf(data).empty())
  {
    local = nephoscope::MakeVelocityField(data, array, mine);
  }
  if (this->IsAlone())
  {
    problem = mine;
    return local;
  }
  // Blocks may be without velocity, as they may on one rank; a part of a dataset may not.
  const bool anyField = this->AnyTrue(local != nullptr);
  const bool mayBeMissing = anyField && vtkCompositeDataSet::SafeDownCast(data);
  problem = this->AgreeOnProblem(mayBeMissing ? std::string() : mine);
  return anyField && problem.empty()
    ? std::make_unique<DistributedField>(std::move(local), this->Controller)
    : nullptr;
}

std::string FlowVolumeExchange::WhyNoVelocity(
  const std::vector<vtkDataSet*>& sets, const Vector3& position) const
{
  const std::string inside = this->AgreeOnProblem(WhyNoVelocityInside(sets, position));
  return inside.empty()
    ? WhyOutside(this->BoundsOf(sets), this->NearestTo(sets, position), position)
    : inside;
}

Vector3 FlowVolumeExchange::NearestTo(
  const std::vector<vtkDataSet*>& sets, const Vector3& position) const
{
  const NearestCell mine = FindNearestCell(sets, position);
  const std::vector<double> all =
    this->Gather({ mine.Distance, mine.Middle[0], mine.Middle[1], mine.Middle[2] });
  std::size_t best = 0;
  for (std::size_t k = 4; k < all.size(); k += 4)
  {
    best = all[k] < all[best] ? k : best;
  }
  return { all[best + 1], all[best + 2], all[best + 3] };
}

vtkSmartPointer<vtkPolyData> FlowVolumeExchange::GatherPolygon(vtkPolyData* polygon) const
{
  if (this->IsAlone() || !this->AnyTrue(polygon != nullptr))
  {
    return polygon;
  }
  std::vector<vtkSmartPointer<vtkDataObject>> all;
  this->Controller->AllGather(BarePolygons(polygon), all);
  return UnitePolygons(all);
}

const SmokeMesh& FlowVolumeExchange::ShareOf(const SmokeMesh& mesh, SmokeMesh& share) const
{
  if (this->IsAlone())
  {
    return mesh;
  }
  share = SliceOfMesh(mesh, this->Rank, this->Ranks);
  return share;
}
}
