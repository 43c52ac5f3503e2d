// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StreakVolume.h"

#include "AdvanceParticles.h"
#include "EdgeBisection.h"
#include "SmokeGeometry.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace nephoscope
{
namespace
{
struct DividedPrism
{
  std::array<TetrahedronPoints, 3> Tetrahedra;
  std::array<double, 3> Volumes;
  double Volume = 0.0;

  DividedPrism(const PrismPoints& corners, const std::vector<Vector3>& points)
    : Tetrahedra(PrismTetrahedra(corners))
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      this->Volumes[i] = std::abs(VolumeOf(this->Tetrahedra[i], points));
      this->Volume += this->Volumes[i];
    }
  }
};

// Leaves out the tetrahedra that the flow has made flat, which have no density, and returns their
// mass.
double DropFlatTetrahedra(StreakMesh& smoke)
{
  double lost = 0.0;
  smoke.Filter([&](std::size_t t) {
    const double volume = std::abs(VolumeOf(smoke.Tetrahedra[t], smoke.Positions));
    const bool keep = volume > 0.0 && std::isfinite(smoke.Masses[t] / volume);
    lost += keep ? 0.0 : smoke.Masses[t];
    return keep;
  });
  return lost;
}

// Tetrahedra that the flow has turned over are written the right way round.
void AddCells(const StreakMesh& smoke, SmokeMesh& mesh)
{
  mesh.Tetrahedra = smoke.Tetrahedra;
  mesh.EmissionSteps = smoke.EmissionSteps;
  mesh.Densities.reserve(smoke.Masses.size());
  for (std::size_t t = 0; t < smoke.Tetrahedra.size(); ++t)
  {
    const double volume = VolumeOf(smoke.Tetrahedra[t], smoke.Positions);
    if (volume < 0.0)
    {
      std::swap(mesh.Tetrahedra[t][2], mesh.Tetrahedra[t][3]);
    }
    mesh.Densities.push_back(smoke.Masses[t] / std::abs(volume));
    mesh.Report.KeptMass += smoke.Masses[t];
  }
}
}

StreakVolume::StreakVolume(const PolygonMesh& polygon, const StreakSettings& settings)
  : Polygon(polygon)
  , PolygonInside(polygon.Points.size(), 1)
  , Settings(settings)
  , Now(settings.StartTime)
  , Emitting(polygon.Triangles.size(), 0.0)
{
  this->FirstOfLayer = this->AddLayer(this->Smoke);
}

double StreakVolume::ReleaseTime(int layer) const
{
  return this->Settings.StartTime + layer * this->Settings.TimeStep;
}

bool StreakVolume::AdvanceToLastRelease(
  const VelocityField& field, double time, const ProgressFunction& progress)
{
  for (double next = this->ReleaseTime(this->Layer + 1); next <= time + this->Rounding();
       next = this->ReleaseTime(this->Layer + 1))
  {
    this->Step(field, std::min(next, time));
    this->ReleaseLayer();
    if (!progress(this->Now))
    {
      return false;
    }
  }
  return true;
}

bool StreakVolume::AdvanceTo(
  const VelocityField& field, double time, const ProgressFunction& progress)
{
  if (!this->AdvanceToLastRelease(field, time, progress))
  {
    return false;
  }
  this->Step(field, time);
  return progress(this->Now);
}

void StreakVolume::Step(const VelocityField& field, double time)
{
  if (time <= this->Now + this->Rounding())
  {
    return;
  }
  this->Emit(field, time);
  IntegrationSettings integration;
  integration.Tolerance = this->Settings.Tolerance;
  integration.Method =
    this->Settings.Adaptive ? IntegrationMethod::DormandPrince : IntegrationMethod::RungeKutta4;
  AdvanceParticles(field,
    { this->Smoke.Positions.data(), this->Smoke.Hints.data(), this->Smoke.Inside.data(),
      this->Smoke.Positions.size() },
    this->Now, time - this->Now, integration);
  this->Now = time;
  this->EndSmoke();
}

// Simpson's rule: exact where the velocity is linear in time.
void StreakVolume::Emit(const VelocityField& field, double time)
{
  if (this->Full)
  {
    return;
  }
  const double step = time - this->Now;
  constexpr double weights[3] = { 1.0 / 6.0, 4.0 / 6.0, 1.0 / 6.0 };
  for (int i = 0; i < 3; ++i)
  {
    PolygonVelocities velocities;
    velocities.Sample(field, this->Polygon, this->Now + 0.5 * i * step);
    for (std::size_t p = 0; p < this->PolygonInside.size(); ++p)
    {
      this->PolygonInside[p] = this->PolygonInside[p] && velocities.Inside[p];
    }
    for (std::size_t t = 0; t < this->Emitting.size(); ++t)
    {
      this->Emitting[t] += weights[i] * step * std::abs(velocities.Flux(this->Polygon, t));
    }
  }
}

void StreakVolume::ReleaseLayer()
{
  const std::size_t most = this->Smoke.Tetrahedra.size() + 3 * this->Polygon.Triangles.size();
  this->Full = this->Full || most > this->Settings.MaximumNumberOfTetrahedra;
  if (!this->Full)
  {
    const PointId newer = this->AddLayer(this->Smoke);
    this->Lost += this->JoinLayers(this->Smoke, newer);
    this->FirstOfLayer = newer;
    this->Emitted = std::accumulate(this->Emitting.begin(), this->Emitting.end(), this->Emitted);
  }
  std::fill(this->Emitting.begin(), this->Emitting.end(), 0.0);
  std::fill(this->PolygonInside.begin(), this->PolygonInside.end(), 1);
  ++this->Layer;
  this->EndSmoke();
  this->BisectTetrahedra();
}

PointId StreakVolume::AddLayer(StreakMesh& smoke) const
{
  const auto first = static_cast<PointId>(smoke.Positions.size());
  for (std::size_t p = 0; p < this->Polygon.Points.size(); ++p)
  {
    smoke.AddPoint(this->Polygon.Points[p], CellHint(), this->PolygonInside[p], this->Now);
  }
  return first;
}

// The last layer is downstream of the polygon, where the newer one is. Returns the mass for which
// there is no prism, since a corner has left the data.
double StreakVolume::JoinLayers(StreakMesh& smoke, PointId newer) const
{
  double lost = 0.0;
  for (std::size_t t = 0; t < this->Polygon.Triangles.size(); ++t)
  {
    const auto& corners = this->Polygon.Triangles[t];
    const PointId older = this->FirstOfLayer;
    const PrismPoints points = { newer + corners[0], newer + corners[1], newer + corners[2],
      older + corners[0], older + corners[1], older + corners[2] };
    const bool inside = std::all_of(points.begin(), points.end(),
      [&](PointId id) { return smoke.Inside[static_cast<std::size_t>(id)]; });
    const DividedPrism prism(points, smoke.Positions);
    if (!inside || prism.Volume == 0.0)
    {
      lost += this->Emitting[t];
      continue;
    }
    for (std::size_t i = 0; i < 3; ++i)
    {
      smoke.AddTetrahedron(
        prism.Tetrahedra[i], this->Emitting[t] * (prism.Volumes[i] / prism.Volume), this->Layer);
    }
  }
  return lost;
}

void StreakVolume::EndSmoke()
{
  const double oldest = this->Now - this->Settings.Duration + this->Rounding();
  const std::size_t before = this->Smoke.Tetrahedra.size();
  this->Smoke.Filter([&](std::size_t t) {
    const auto& points = this->Smoke.Tetrahedra[t];
    const bool inside = std::all_of(points.begin(), points.end(),
      [&](PointId id) { return this->Smoke.Inside[static_cast<std::size_t>(id)]; });
    const bool expired = this->Settings.Duration > 0.0 &&
      this->ReleaseTime(this->Smoke.EmissionSteps[t] + 1) <= oldest;
    this->Lost += inside ? 0.0 : this->Smoke.Masses[t];
    this->Expired += inside && expired ? this->Smoke.Masses[t] : 0.0;
    return inside && !expired;
  });
  if (this->Smoke.Tetrahedra.size() < before)
  {
    this->FirstOfLayer =
      this->Smoke.DropUnusedPoints(this->FirstOfLayer, this->Polygon.Points.size());
  }
}

void StreakVolume::BisectTetrahedra()
{
  const BisectionLimits limits = { this->Settings.MaximumEdgeLength, this->Allowed(),
    this->FirstOfLayer, this->Polygon.Points.size() };
  this->Coarser = !BisectLongEdges(this->Smoke, limits) || this->Coarser;
}

// Every release may have as many tetrahedra as the others, and what the early ones do not need is
// left to the later ones.
std::size_t StreakVolume::Allowed() const
{
  const std::size_t all = this->Settings.MaximumNumberOfTetrahedra;
  if (this->Layer >= this->Settings.Releases)
  {
    return all;
  }
  const double share = static_cast<double>(this->Layer) / this->Settings.Releases;
  return static_cast<std::size_t>(share * static_cast<double>(all));
}

void StreakVolume::TurnHints()
{
  for (CellHint& hint : this->Smoke.Hints)
  {
    hint.Cell = hint.SecondCell;
    hint.Block = hint.SecondBlock;
  }
}

double StreakVolume::EmittedMass() const
{
  return std::accumulate(this->Emitting.begin(), this->Emitting.end(), this->Emitted);
}

SmokeMesh StreakVolume::Mesh() const
{
  StreakMesh smoke = this->Smoke;
  double lost = this->Lost;
  if (!this->Full && !this->IsAt(this->ReleaseTime(this->Layer)))
  {
    lost += this->JoinLayers(smoke, this->AddLayer(smoke));
  }
  lost += DropFlatTetrahedra(smoke);
  smoke.DropUnusedPoints(0, 0);
  SmokeMesh mesh;
  AddCells(smoke, mesh);
  for (const int step : smoke.EmissionSteps)
  {
    const double end = std::min(this->ReleaseTime(step + 1), this->Now);
    mesh.Ages.push_back(this->Now - 0.5 * (this->ReleaseTime(step) + end));
  }
  for (const double released : smoke.ReleaseTimes)
  {
    mesh.PointAges.push_back(this->Now - released);
  }
  mesh.Points = std::move(smoke.Positions);
  mesh.Hints = std::move(smoke.Hints);
  mesh.Report.EmittedMass = this->EmittedMass();
  mesh.Report.LostMass = lost;
  mesh.Report.ExpiredMass = this->Expired;
  mesh.Report.FollowedTime = this->Now - this->Settings.StartTime;
  mesh.Report.LimitReached = this->Full;
  return mesh;
}
}
