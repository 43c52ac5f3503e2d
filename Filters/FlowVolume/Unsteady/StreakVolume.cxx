// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StreakVolume.h"

#include "EdgeBisection.h"
#include "EdgeMerging.h"
#include "LayerTimes.h"
#include "ObstacleSearch.h"
#include "SmokeGeometry.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace nephoscope
{
namespace
{
// Two layers that have been released one after the other, joined.
struct DividedPrism
{
  std::vector<TetrahedronPoints> Tetrahedra;
  std::vector<double> Volumes;
  double Volume = 0.0;

  DividedPrism(
    const PrismPoints& corners, const FrontDivision& front, const std::vector<Vector3>& points)
  {
    for (const TetrahedronPoints& whole : PrismTetrahedra(corners))
    {
      for (const TetrahedronPoints& part : front.Divide(whole))
      {
        this->Tetrahedra.push_back(part);
        this->Volumes.push_back(std::abs(VolumeOf(part, points)));
        this->Volume += this->Volumes.back();
      }
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
  , Released(settings.StartTime)
  , Emitting(polygon.Triangles.size(), 0.0)
{
  this->Smoke.Front = this->AddLayer(this->Smoke);
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
    this->ReleaseRegularLayer(field);
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
  while (time > this->Now + this->Rounding())
  {
    const double next = this->TimeOfNextLayer(field, time);
    this->Move(field, next);
    if (next < time)
    {
      this->ReleaseLayer(field);
    }
    if (!this->IsAt(this->ReleaseTime(this->Layer + 1)))
    {
      this->BisectTetrahedra(this->AllowedBeforeRelease());
    }
  }
}

double StreakVolume::TimeOfNextLayer(const VelocityField& field, double end)
{
  if (this->Full)
  {
    return end;
  }
  const double regular = this->ReleaseTime(this->Layer);
  const double part = std::ldexp(this->Settings.TimeStep, -this->Settings.MaximumHalvings);
  const double next = nephoscope::TimeOfNextLayer(field, this->Polygon, this->Smoke,
    this->Integration(), { regular, part, this->Released, this->Now, end, this->Rounding() },
    this->Settings.MaximumTurnAngle);
  const std::size_t most = this->Smoke.Tetrahedra.size() + 3 * this->Polygon.Triangles.size();
  if (next < end && most > this->AllowedBeforeRelease())
  {
    this->Coarser = true;
    return end;
  }
  return next;
}

IntegrationSettings StreakVolume::Integration() const
{
  IntegrationSettings integration;
  integration.Tolerance = this->Settings.Tolerance;
  integration.Method =
    this->Settings.Adaptive ? IntegrationMethod::DormandPrince : IntegrationMethod::RungeKutta4;
  return integration;
}

void StreakVolume::Move(const VelocityField& field, double time)
{
  if (time <= this->Now)
  {
    return;
  }
  this->Emit(field, time);
  // The adaptive method chooses its steps itself.
  const double angle = this->Settings.Adaptive ? 0.0 : this->Settings.MaximumTurnAngle;
  AdvanceSmoke(field, this->Smoke, this->Now, time - this->Now, this->Integration(),
    { angle, this->Settings.MaximumHalvings });
  this->Now = time;
  this->EndSmoke(field);
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
    if (i == 0 && this->Released == this->Now)
    {
      this->TakeVelocities(velocities);
    }
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

// The paths of a layer that has just been released start in these directions.
void StreakVolume::TakeVelocities(const PolygonVelocities& velocities)
{
  for (std::size_t p = 0; p < velocities.Values.size(); ++p)
  {
    const auto point = static_cast<std::size_t>(this->Smoke.Front.First) + p;
    this->Smoke.Ways[point] = velocities.Inside[p] ? velocities.Values[p] : Vector3{};
  }
}

void StreakVolume::ReleaseRegularLayer(const VelocityField& field)
{
  const std::size_t most = this->Smoke.Tetrahedra.size() + 3 * this->Polygon.Triangles.size();
  this->Full = this->Full || most > this->Settings.MaximumNumberOfTetrahedra;
  this->ReleaseLayer(field);
  ++this->Layer;
  this->EndSmoke(field);
  this->MergeTetrahedra();
  this->BisectTetrahedra(this->Allowed(this->Layer));
}

void StreakVolume::ReleaseLayer(const VelocityField& field)
{
  if (!this->Full)
  {
    this->Lose(field, this->JoinLayer(this->Smoke));
    this->Emitted = std::accumulate(this->Emitting.begin(), this->Emitting.end(), this->Emitted);
    this->Released = this->Now;
  }
  std::fill(this->Emitting.begin(), this->Emitting.end(), 0.0);
  std::fill(this->PolygonInside.begin(), this->PolygonInside.end(), 1);
}

StreakFront StreakVolume::AddLayer(StreakMesh& smoke) const
{
  StreakFront layer = { static_cast<PointId>(smoke.Positions.size()), this->Polygon.Points.size(),
    {} };
  for (std::size_t p = 0; p < layer.Count; ++p)
  {
    smoke.AddPoint(this->Polygon.Points[p], CellHint(), this->PolygonInside[p], this->Now);
  }
  return layer;
}

// Releases a layer and joins it to the front, which is downstream of it; it
// becomes the front. Returns the smoke for which there is no prism, since a
// corner has left the data.
StreakLoss StreakVolume::JoinLayer(StreakMesh& smoke) const
{
  const FrontDivision front(smoke.Front);
  const StreakFront layer = this->AddLayer(smoke);
  StreakLoss lost;
  for (std::size_t t = 0; t < this->Polygon.Triangles.size(); ++t)
  {
    const auto& corners = this->Polygon.Triangles[t];
    const PointId newer = layer.First, older = smoke.Front.First;
    const PrismPoints points = { newer + corners[0], newer + corners[1], newer + corners[2],
      older + corners[0], older + corners[1], older + corners[2] };
    const bool inside = std::all_of(points.begin(), points.end(),
      [&](PointId id) { return smoke.Inside[static_cast<std::size_t>(id)]; });
    const DividedPrism prism(points, front, smoke.Positions);
    if (!inside || prism.Volume == 0.0)
    {
      lost.Add(smoke, points, this->Emitting[t]);
      continue;
    }
    for (std::size_t i = 0; i < prism.Tetrahedra.size(); ++i)
    {
      const double mass = this->Emitting[t] * (prism.Volumes[i] / prism.Volume);
      if (smoke.IsInside(prism.Tetrahedra[i]))
      {
        smoke.AddTetrahedron(prism.Tetrahedra[i], mass, this->Layer);
      }
      else
      {
        lost.Add(smoke, prism.Tetrahedra[i], mass);
      }
    }
  }
  smoke.Front = layer;
  return lost;
}

void StreakVolume::Lose(const VelocityField& field, const StreakLoss& loss)
{
  this->Lost += loss.Total();
  this->Obstacle +=
    loss.AtObstacles(this->Smoke, field, this->Settings.TimeStep, this->Settings.FarthestObstacle);
}

void StreakVolume::EndSmoke(const VelocityField& field)
{
  const double oldest = this->Now - this->Settings.Duration + this->Rounding();
  const std::size_t before = this->Smoke.Tetrahedra.size();
  StreakLoss loss;
  this->Smoke.Filter([&](std::size_t t) {
    const bool inside = this->Smoke.IsInside(this->Smoke.Tetrahedra[t]);
    const bool expired = this->Settings.Duration > 0.0 &&
      this->ReleaseTime(this->Smoke.EmissionSteps[t] + 1) <= oldest;
    if (!inside)
    {
      loss.Add(this->Smoke, this->Smoke.Tetrahedra[t], this->Smoke.Masses[t]);
    }
    this->Expired += inside && expired ? this->Smoke.Masses[t] : 0.0;
    return inside && !expired;
  });
  this->Lose(field, loss);
  this->EndAtObstacles(field);
  if (this->Smoke.Tetrahedra.size() < before)
  {
    this->Smoke.DropUnusedPoints();
  }
}

// Tetrahedra with an obstacle between their corners end too, but are divided before, so that what
// ends fits it closely.
void StreakVolume::EndAtObstacles(const VelocityField& field)
{
  std::vector<unsigned char> blocked = this->FindBlocked(field);
  const BisectionLimits limits = { this->Settings.ObstacleEdge, this->AllowedBeforeRelease() };
  while (BisectMarked(this->Smoke, limits, blocked) > 0)
  {
    blocked = this->FindBlocked(field);
  }
  this->Smoke.Filter([&](std::size_t t) {
    const double mass = blocked[t] ? this->Smoke.Masses[t] : 0.0;
    this->Lost += mass;
    this->Obstacle += mass;
    return !blocked[t];
  });
}

std::vector<unsigned char> StreakVolume::FindBlocked(const VelocityField& field) const
{
  const StreakMesh& smoke = this->Smoke;
  ObstacleSearch search(field, this->Now, this->Settings.ObstacleSize, smoke.Tetrahedra.size());
  for (std::size_t t = 0; t < smoke.Tetrahedra.size(); ++t)
  {
    std::array<Vector3, 4> corners;
    for (std::size_t c = 0; c < 4; ++c)
    {
      corners[c] = smoke.Positions[static_cast<std::size_t>(smoke.Tetrahedra[t][c])];
    }
    search.AddTetrahedron(
      t, corners, smoke.Hints[static_cast<std::size_t>(smoke.Tetrahedra[t][0])]);
  }
  return search.Find();
}

void StreakVolume::MergeTetrahedra()
{
  const double longest = this->Settings.MaximumEdgeLength;
  const double shortest = longest > 0.0 ? std::min(this->Settings.MinimumEdgeLength, longest / 3.0)
                                        : this->Settings.MinimumEdgeLength;
  if (MergeShortEdges(this->Smoke, { shortest, longest }) > 0)
  {
    this->Smoke.DropUnusedPoints();
  }
}

void StreakVolume::BisectTetrahedra(std::size_t allowed)
{
  this->Coarser =
    !BisectLongEdges(this->Smoke, { this->Settings.MaximumEdgeLength, allowed }) || this->Coarser;
}

// Every release may have as many tetrahedra as the others, and what the early
// ones do not need is left to the later ones.
std::size_t StreakVolume::Allowed(int layer) const
{
  const std::size_t all = this->Settings.MaximumNumberOfTetrahedra;
  if (layer >= this->Settings.Releases)
  {
    return all;
  }
  const double share = static_cast<double>(layer) / this->Settings.Releases;
  return static_cast<std::size_t>(share * static_cast<double>(all));
}

// Leaves room for the next regular layer.
std::size_t StreakVolume::AllowedBeforeRelease() const
{
  const std::size_t layer = 3 * this->Polygon.Triangles.size();
  const std::size_t allowed = this->Allowed(this->Layer + 1);
  return allowed > layer ? allowed - layer : 0;
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
  if (!this->Full && this->Now > this->Released + this->Rounding())
  {
    lost += this->JoinLayer(smoke).Total();
  }
  smoke.Front = {}; // nothing will be joined to it any more
  const bool divided = BisectLongEdges(
    smoke, { this->Settings.MaximumEdgeLength, this->Settings.MaximumNumberOfTetrahedra });
  lost += DropFlatTetrahedra(smoke);
  smoke.DropUnusedPoints();
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
  mesh.Report.ObstacleMass = this->Obstacle;
  mesh.Report.ExpiredMass = this->Expired;
  mesh.Report.FollowedTime = this->Now - this->Settings.StartTime;
  mesh.Report.LimitReached = this->Full;
  mesh.Report.Coarser = this->Coarser || !divided;
  return mesh;
}
}
