// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SmoothingPlan.h"

#include "GridSeams.h"
#include "PointMasses.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"

namespace nephoscope
{
namespace
{
constexpr double radiansPerDegree = 0.017453292519943295769;

std::vector<double> Values(vtkDataArray* array)
{
  std::vector<double> values(array ? static_cast<std::size_t>(array->GetNumberOfTuples()) : 0);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] = array->GetComponent(static_cast<vtkIdType>(i), 0);
  }
  return values;
}

bool WithinPoles(const std::vector<double>& latitudes)
{
  return std::all_of(latitudes.begin(), latitudes.end(),
    [](double latitude) { return std::abs(latitude) <= 90.0001; });
}

bool IsPoleLatitude(double latitude)
{
  return std::abs(std::abs(latitude) - 90.0) <= 1e-4;
}

// From the last point of a ring to the first, where the axis does not say: the mean of the steps at
// both ends.
double ClosingGap(const std::vector<double>& x)
{
  const std::size_t n = x.size();
  return n < 2 ? 0.0 : 0.5 * (std::abs(x[1] - x[0]) + std::abs(x[n - 1] - x[n - 2]));
}
}

std::string SmoothingPlan::Read(vtkDataSet* grid, const SmoothingSettings& settings)
{
  const std::string error = this->ReadShape(grid);
  if (!error.empty())
  {
    return error;
  }
  this->ReadHidden();
  this->LongitudeLatitude = this->IsLongitudeLatitude(settings);
  this->FindRings(settings);
  this->FindPoleRows();
  if (settings.Isotropic)
  {
    this->FindRowRatios();
  }
  return this->FindMasses(settings);
}

void SmoothingPlan::FindRings(const SmoothingSettings& settings)
{
  GridTopology& t = this->Topology_;
  if (this->LongitudeLatitude && !this->IsCurvilinear)
  {
    const Circle circle = JudgeCircle(this->Axes[0]);
    t.Ring[0] = circle != Circle::Part;
    t.Repeated[0] = circle == Circle::Repeated;
  }
  if (settings.FindSeam && this->IsCurvilinear)
  {
    FindRepeatedPlaces(this->Grid, t);
    this->ClosedInSpace = t.Repeated;
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    if (settings.Periodic[axis] && !t.Ring[axis] && t.Size[axis] > 1)
    {
      t.Repeated[axis] = RepeatsValues(this->Grid, t, axis);
      t.Ring[axis] = true;
      this->ClosedInSpace[axis] =
        this->IsCurvilinear && nephoscope::ClosesInSpace(this->Grid, t, axis);
    }
  }
}

void SmoothingPlan::FindPoleRows()
{
  if (this->IsCurvilinear)
  {
    FindPoles(this->Grid, this->Topology_);
  }
  else if (this->LongitudeLatitude && this->Topology_.Size[1] > 1)
  {
    for (bool atEnd : { false, true })
    {
      if (IsPoleLatitude(atEnd ? this->Axes[1].back() : this->Axes[1].front()))
      {
        this->Topology_.Poles.push_back({ 0, 1, atEnd });
      }
    }
  }
}

std::string SmoothingPlan::ReadShape(vtkDataSet* grid)
{
  if (!grid || grid->GetNumberOfPoints() == 0)
  {
    return "The input is empty: there are no points. Check the reader and its file.";
  }
  this->Grid = grid;
  int size[3] = { 0, 0, 0 };
  if (auto* structured = vtkStructuredGrid::SafeDownCast(grid))
  {
    structured->GetDimensions(size);
    this->IsCurvilinear = true;
  }
  else if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(grid))
  {
    rectilinear->GetDimensions(size);
    this->Axes = { { Values(rectilinear->GetXCoordinates()), Values(rectilinear->GetYCoordinates()),
      Values(rectilinear->GetZCoordinates()) } };
  }
  else if (auto* image = vtkImageData::SafeDownCast(grid))
  {
    image->GetDimensions(size);
    const int* extent = image->GetExtent();
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int i = extent[2 * axis]; i <= extent[2 * axis + 1]; ++i)
      {
        this->Axes[axis].push_back(image->GetOrigin()[axis] + i * image->GetSpacing()[axis]);
      }
    }
  }
  else
  {
    return std::string("The input is a ") + grid->GetClassName() +
      "; it must be image data, a rectilinear or a structured grid. Resample it to an image first.";
  }
  this->Topology_.Size = { { size[0], size[1], size[2] } };
  if (this->Topology_.Count() != grid->GetNumberOfPoints())
  {
    return "The grid has " + std::to_string(grid->GetNumberOfPoints()) +
      " points, but its dimensions ask for " + std::to_string(this->Topology_.Count()) + ".";
  }
  return this->CheckCoordinates();
}

std::string SmoothingPlan::CheckCoordinates() const
{
  for (int axis = 0; axis < 3 && !this->IsCurvilinear; ++axis)
  {
    if (!std::all_of(this->Axes[axis].begin(), this->Axes[axis].end(),
          [](double x) { return std::isfinite(x); }))
    {
      return "Axis " + std::to_string(axis) +
        " of the grid has coordinates that are not finite numbers. Check the reader and its file.";
    }
  }
  for (vtkIdType id = 0; id < this->Grid->GetNumberOfPoints() && this->IsCurvilinear; ++id)
  {
    double x[3];
    this->Grid->GetPoint(id, x);
    if (!std::isfinite(x[0] + x[1] + x[2]))
    {
      return "Point " + std::to_string(id) +
        " of the grid has a coordinate that is not a finite number. Check the reader and its file.";
    }
  }
  return std::string();
}

void SmoothingPlan::ReadHidden()
{
  auto* ghosts = vtkUnsignedCharArray::SafeDownCast(
    this->Grid->GetPointData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
  if (!ghosts)
  {
    return;
  }
  this->Hidden.assign(static_cast<std::size_t>(this->Grid->GetNumberOfPoints()), 0);
  for (vtkIdType id = 0; id < ghosts->GetNumberOfTuples(); ++id)
  {
    this->Hidden[id] = ghosts->GetValue(id) & vtkDataSetAttributes::HIDDENPOINT ? 1 : 0;
  }
}

bool SmoothingPlan::IsLongitudeLatitude(const SmoothingSettings& settings) const
{
  if (settings.Coordinates != GridCoordinates::Automatic)
  {
    return settings.Coordinates == GridCoordinates::LongitudeLatitude;
  }
  return !this->IsCurvilinear && settings.Periodic[0] &&
    JudgeCircle(this->Axes[0]) != Circle::Part && WithinPoles(this->Axes[1]);
}

Vector3 SmoothingPlan::Position(const GridIndex& at) const
{
  Vector3 x;
  this->Grid->GetPoint(static_cast<vtkIdType>(this->Topology_.Id(at)), x.data());
  return x;
}

Vector3 SmoothingPlan::PositionBeyond(const GridIndex& at) const
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (at[axis] < this->Topology_.Size[axis])
    {
      continue;
    }
    GridIndex other = at;
    if (this->ClosedInSpace[axis])
    {
      other[axis] = 0;
      return this->PositionBeyond(other);
    }
    other[axis] = this->Topology_.Size[axis] - 1;
    const Vector3 last = this->PositionBeyond(other);
    --other[axis];
    const Vector3 before = this->PositionBeyond(other);
    return { { 2.0 * last[0] - before[0], 2.0 * last[1] - before[1], 2.0 * last[2] - before[2] } };
  }
  return this->Position(at);
}

Vector3 SmoothingPlan::Displacement(int axis, const GridIndex& at, int step) const
{
  const int next = this->Topology_.Step(axis, at[axis], step);
  if (next == at[axis])
  {
    return { { 0.0, 0.0, 0.0 } };
  }
  GridIndex upper = at;
  GridIndex lower = at;
  if (step > 0)
  {
    ++upper[axis];
  }
  else
  {
    lower[axis] = next;
    upper[axis] = next + 1;
  }
  const Vector3 up = this->PositionBeyond(upper) - this->PositionBeyond(lower);
  return step > 0 ? up : Vector3{ { -up[0], -up[1], -up[2] } };
}

double SmoothingPlan::StepLength(int axis, const GridIndex& at, int step) const
{
  Vector3 d = this->Displacement(axis, at, step);
  if (this->LongitudeLatitude)
  {
    d[0] = std::remainder(d[0], 360.0) * std::cos(this->Position(at)[1] * radiansPerDegree);
  }
  return Norm(d);
}

void SmoothingPlan::FindRowRatios()
{
  const GridTopology& t = this->Topology_;
  this->RowRatios.assign(static_cast<std::size_t>(t.Size[1]) * t.Size[2], 1.0);
  for (int k = 0; k < t.Distinct(2); ++k)
  {
    for (int j = 0; j < t.Distinct(1); ++j)
    {
      double sums[2] = { 0.0, 0.0 };
      int counts[2] = { 0, 0 };
      for (int i = 0; i < t.Distinct(0); ++i)
      {
        for (int axis = 0; axis < 2; ++axis)
        {
          for (int step : { -1, 1 })
          {
            const GridIndex at = { { i, j, k } };
            if (t.Step(axis, at[axis], step) != at[axis])
            {
              sums[axis] += this->StepLength(axis, at, step);
              ++counts[axis];
            }
          }
        }
      }
      const double along = counts[0] ? sums[0] / counts[0] : 0.0;
      const double across = counts[1] ? sums[1] / counts[1] : along;
      const bool isPole = t.PoleAt({ { 0, j, k } }) != nullptr || !(along > 0.0);
      this->RowRatios[j + static_cast<std::size_t>(t.Size[1]) * k] =
        isPole ? 0.0 : (across / along) * (across / along);
    }
  }
}

std::string SmoothingPlan::FindMasses(const SmoothingSettings& settings)
{
  const GridTopology& t = this->Topology_;
  if (!settings.Conservative)
  {
    std::array<std::vector<double>, 3> ones;
    for (int axis = 0; axis < 3; ++axis)
    {
      ones[axis].assign(static_cast<std::size_t>(t.Size[axis]), 1.0);
    }
    this->Masses_ = ProductMasses(t, ones);
    return std::string();
  }
  if (!settings.MassArrayName.empty())
  {
    vtkDataArray* given = this->Grid->GetPointData()->GetArray(settings.MassArrayName.c_str());
    if (!given || given->GetNumberOfComponents() != 1 ||
      given->GetNumberOfTuples() != this->Grid->GetNumberOfPoints())
    {
      return "There is no point array '" + settings.MassArrayName +
        "' of one component to take masses from. Clear MassArrayName to use volumes.";
    }
    this->Masses_ = Values(given);
  }
  else
  {
    this->Masses_ = this->IsCurvilinear ? this->CurvilinearMasses() : this->RectilinearMasses();
  }
  this->CountMasses();
  return std::string();
}

std::vector<double> SmoothingPlan::CurvilinearMasses() const
{
  const bool degrees = this->LongitudeLatitude;
  return OctantMasses(this->Topology_, [this, degrees](const GridIndex& at) {
    const Vector3 x = this->PositionBeyond(at);
    return degrees ? Vector3{ { x[0] * radiansPerDegree, std::sin(x[1] * radiansPerDegree), x[2] } }
                   : x;
  });
}

std::vector<double> SmoothingPlan::RectilinearMasses() const
{
  const GridTopology& t = this->Topology_;
  std::array<std::vector<double>, 3> widths;
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::vector<double>& x = this->Axes[axis];
    const bool open = t.Ring[axis] && !t.Repeated[axis];
    const bool circle = this->LongitudeLatitude && axis == 0;
    const double gap = !open ? 0.0
      : circle               ? 360.0 - std::abs(x.back() - x.front())
                             : ClosingGap(x);
    widths[axis] = this->LongitudeLatitude && axis == 1 ? LatitudeWidths(x) : AxisWidths(x, gap);
    if (t.Repeated[axis])
    {
      widths[axis].front() += widths[axis].back();
    }
    const double unit = circle && x.size() > 1 ? radiansPerDegree : 1.0;
    std::for_each(widths[axis].begin(), widths[axis].end(), [unit](double& w) { w *= unit; });
  }
  return ProductMasses(t, widths);
}

void SmoothingPlan::CountMasses()
{
  for (vtkIdType id = 0; id < this->Grid->GetNumberOfPoints(); ++id)
  {
    const GridIndex at = this->Topology_.Index(id);
    const bool repeats = this->Topology_.Canonical(at) != at;
    double& mass = this->Masses_[id];
    if (repeats || !std::isfinite(mass) || mass <= 0.0)
    {
      this->WithoutMass += repeats || this->IsHidden(id) ? 0 : 1;
      mass = 0.0;
    }
  }
}
}
