// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CartesianFlow.h"

#include "AdvanceParticles.h"
#include "TemporalField.h"
#include "VelocityFields.h"

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

namespace nephoscope
{
namespace
{
// The grid with its velocity and its blanking alone.
vtkSmartPointer<vtkDataSet> SlimCopy(vtkDataSet* data, const VelocityArray& velocity)
{
  auto copy = vtkSmartPointer<vtkDataSet>::Take(data->NewInstance());
  copy->CopyStructure(data);
  const auto keep = [&](vtkDataSetAttributes* from, vtkDataSetAttributes* to, bool holdsVelocity) {
    for (const char* name :
      { holdsVelocity ? velocity.Name.c_str() : "", vtkDataSetAttributes::GhostArrayName() })
    {
      if (vtkAbstractArray* array = from->GetAbstractArray(name))
      {
        to->AddArray(array);
      }
    }
  };
  keep(data->GetPointData(), copy->GetPointData(), !velocity.OnCells);
  keep(data->GetCellData(), copy->GetCellData(), velocity.OnCells);
  return copy;
}

IntegrationSettings SettingsOf(const PathSettings& settings)
{
  IntegrationSettings integration;
  integration.Method = settings.Method == PathMethod::Euler ? IntegrationMethod::Euler
    : settings.Method == PathMethod::RungeKutta4            ? IntegrationMethod::RungeKutta4
                                                            : IntegrationMethod::DormandPrince;
  integration.Tolerance = settings.Tolerance;
  return integration;
}
}

struct CartesianFlow::Field : public WindField
{
  vtkSmartPointer<vtkDataSet> Data;
  std::unique_ptr<VelocityField> Velocity;
};

CartesianFlow::CartesianFlow(vtkDataSet* first, const PathSettings& settings, double length)
  : Settings(settings)
{
  double bounds[6];
  first->GetBounds(bounds);
  for (int c = 0; c < 3; ++c)
  {
    this->Units_.Origin[c] = bounds[2 * c];
  }
  const double width = bounds[1] - bounds[0];
  this->Units_.Length = length > 0.0 ? length : width > 0.0 ? width : 1.0;
}

CartesianFlow::~CartesianFlow() = default;

std::unique_ptr<WindField> CartesianFlow::MakeField(
  vtkDataSet* data, const WindArrays& arrays, std::string& problem)
{
  auto field = std::make_unique<Field>();
  field->Data = SlimCopy(data, arrays.Velocity);
  field->Velocity = MakeUnboundedField(field->Data, arrays.Velocity, problem);
  if (!field->Velocity)
  {
    return nullptr;
  }
  return field;
}

void CartesianFlow::Begin(vtkDataSet* points, const FlowStep&)
{
  const auto count = static_cast<std::size_t>(points->GetNumberOfPoints());
  this->Starts.resize(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    points->GetPoint(static_cast<vtkIdType>(i), this->Starts[i].data());
  }
  this->Positions = this->Starts;
  this->Hints.assign(count, CellHint{});
  this->Inside.assign(count, 1);
}

void CartesianFlow::Advance(const FlowStep& step)
{
  const auto velocityOf = [](const WindField* field) -> const VelocityField& {
    return *static_cast<const Field*>(field)->Velocity;
  };
  const Particles particles{ this->Positions.data(), this->Hints.data(), this->Inside.data(),
    this->Positions.size(), nullptr };
  // The time is the fraction of the way between the two fields, counted in seconds.
  const bool steady = step.Earlier == step.Later;
  const double span = steady ? 1.0 : step.Seconds / (step.ToFraction - step.FromFraction);
  const TemporalField velocity(
    velocityOf(step.Earlier), 0.0, velocityOf(step.Later), steady ? 0.0 : span);
  AdvanceParticles(
    velocity, particles, span * step.FromFraction, step.Seconds, SettingsOf(this->Settings));
}

void CartesianFlow::Displacements(const FlowStep&, std::vector<float>& displacements)
{
  displacements.resize(3 * this->Positions.size());
  for (std::size_t i = 0; i < this->Positions.size(); ++i)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      displacements[3 * i + c] =
        static_cast<float>((this->Positions[i][c] - this->Starts[i][c]) / this->Units_.Length);
    }
  }
}

std::vector<double> CartesianFlow::GridCoordinates(vtkDataSet* points) const
{
  const auto count = static_cast<std::size_t>(points->GetNumberOfPoints());
  std::vector<double> places(3 * count);
  for (std::size_t i = 0; i < count; ++i)
  {
    double position[3];
    points->GetPoint(static_cast<vtkIdType>(i), position);
    for (std::size_t c = 0; c < 3; ++c)
    {
      places[3 * i + c] = (position[c] - this->Units_.Origin[c]) / this->Units_.Length;
    }
  }
  return places;
}
}
