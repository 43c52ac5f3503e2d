// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FlowVolumeExchange.h"

#include "DistributedField.h"
#include "MeshSlice.h"
#include "PolygonUnion.h"

#include "vtkBoundingBox.h"
#include "vtkCommunicator.h"
#include "vtkDataObject.h"
#include "vtkMultiProcessController.h"
#include "vtkMultiProcessStream.h"
#include "vtkPolyData.h"

#include <vector>

namespace nephoscope
{
FlowVolumeExchange::FlowVolumeExchange(vtkMultiProcessController* controller)
  : Controller(controller)
  , Rank(controller ? controller->GetLocalProcessId() : 0)
  , Ranks(controller ? controller->GetNumberOfProcesses() : 1)
{
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

std::string FlowVolumeExchange::AgreeOnProblem(const std::string& problem, int importance) const
{
  if (this->IsAlone())
  {
    return problem;
  }
  const int mine = problem.empty() ? -1 : importance;
  int greatest = -1;
  this->Controller->AllReduce(&mine, &greatest, 1, vtkCommunicator::MAX_OP);
  if (greatest < 0)
  {
    return {};
  }
  vtkMultiProcessStream stream;
  const int speaker = this->FirstTrue(mine == greatest);
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

void FlowVolumeExchange::AgreeOnVelocity(VelocityArray& array, bool hasCells) const
{
  const int first = this->FirstTrue(hasCells);
  if (this->IsAlone() || first == this->Ranks)
  {
    return;
  }
  vtkMultiProcessStream stream;
  stream << array.Name << static_cast<int>(array.OnCells);
  this->Controller->Broadcast(stream, first);
  if (first != this->Rank)
  {
    int onCells = 0;
    stream >> array.Name >> onCells;
    array.OnCells = onCells != 0;
  }
}

std::unique_ptr<DataSetField> FlowVolumeExchange::MakeField(
  vtkDataObject* data, const VelocityArray& array, std::string& problem) const
{
  const bool hasCells = data && data->GetNumberOfElements(vtkDataObject::CELL) > 0;
  if (this->IsAlone() || !this->AnyTrue(hasCells))
  {
    return MakeVelocityField(data, array, problem);
  }
  VelocityArray agreed = array;
  this->AgreeOnVelocity(agreed, hasCells);
  std::string mine;
  std::unique_ptr<DataSetField> local = hasCells ? MakeVelocityField(data, agreed, mine) : nullptr;
  problem = this->AgreeOnProblem(mine);
  return problem.empty() ? std::make_unique<DistributedField>(std::move(local), this->Controller) : nullptr;
}

vtkSmartPointer<vtkPolyData> FlowVolumeExchange::GatherPolygon(vtkPolyData* polygon) const
{
  if (this->IsAlone())
  {
    return polygon;
  }
  std::vector<vtkSmartPointer<vtkDataObject>> all;
  this->Controller->AllGather(BarePolygons(polygon), all);
  return UnitePolygons(all);
}

ProgressFunction FlowVolumeExchange::StopTogether(const ProgressFunction& progress) const
{
  if (this->IsAlone())
  {
    return progress;
  }
  return [this, progress](double done) { return this->AllTrue(progress(done)); };
}

SmokeMesh FlowVolumeExchange::ShareOf(const SmokeMesh& mesh) const
{
  return this->IsAlone() ? mesh : SliceOfMesh(mesh, this->Rank, this->Ranks);
}
}
