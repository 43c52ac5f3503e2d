// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "WholeVolume.h"

#include "PolygonShape.h"
#include "SteadyVolume.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace nephoscope
{
namespace
{
constexpr int mostTries = 60, manyTries = 12;
constexpr double least = 1.4142135623730951; // factor from one try to the next
constexpr std::size_t fewTriangles = 16;     // a polygon of so many is coarse enough
constexpr double fewSteps = 128.0; // more of them are lengthened before the polygon is coarsened
constexpr double leastKept = 0.9;  // of the smoke of the last try, by a coarser one

// Twice the distance of the farthest point from the first one: longer edges than that there cannot
// be.
double DiameterOf(const PolygonMesh& polygon)
{
  double farthest = 0.0;
  for (const Vector3& point : polygon.Points)
  {
    farthest = std::max(farthest, Distance(point, polygon.Points.front()));
  }
  return 2.0 * farthest;
}

class Coarsening
{
public:
  Coarsening(
    const PolygonMesh& polygon, const FlowVolumeSettings& settings, const PolygonMaker& remake)
    : Polygon(polygon)
    , Settings(settings)
    , Remake(remake)
    , Edge(LongestEdge(polygon))
    , Diameter(DiameterOf(polygon))
  {
  }

  // After a try that has met the limit. False if nothing is left to coarsen.
  bool Coarsen(const SmokeMesh& tried)
  {
    const SmokeReport& report = tried.Report;
    const double followed = report.FollowedTime / this->Settings.Duration;
    const double excess = followed > 0.0 ? 1.0 / followed : 16.0;
    const double layers = static_cast<double>(report.Layers);
    const double first = 3.0 * layers * static_cast<double>(this->Polygon.Triangles.size());
    const bool stretched = static_cast<double>(tried.Tetrahedra.size()) > 1.5 * first;
    const bool halved = layers > 1.5 * report.FollowedTime / this->Settings.TimeStep + 1.0;
    if (report.Layers == 0)
    {
      const bool fewer = this->CoarsenPolygon(2.0);
      return this->LengthenEdges(2.0) || fewer;
    }
    const int leastHalvings = ++this->Tries < manyTries ? 1 : 0; // turns and folds need some
    const bool halvesLess = halved && this->Settings.MaximumHalvings > leastHalvings;
    this->Settings.MaximumHalvings -= halvesLess;
    if (stretched)
    {
      return this->LengthenEdges(std::clamp(std::sqrt(excess), least, 2.0)) || halvesLess;
    }
    // Long steps fold a flow that turns: as many as a picture needs go first, then the polygon.
    const double steps = this->Settings.Duration / this->Settings.TimeStep;
    if (halvesLess ||
      (steps > fewSteps &&
        this->LengthenSteps(std::min(std::clamp(excess, least, 16.0), steps / fewSteps))))
    {
      return true;
    }
    return (this->Polygon.Triangles.size() > fewTriangles &&
             this->CoarsenPolygon(std::clamp(std::sqrt(excess), least, 2.0))) ||
      this->LengthenSteps(std::clamp(excess, least, 2.0));
  }

  PolygonMesh Polygon;
  FlowVolumeSettings Settings;

private:
  bool CoarsenPolygon(double factor)
  {
    this->Edge *= factor;
    if (!(this->Edge < this->Diameter))
    {
      return false;
    }
    PolygonMesh fewer = this->Remake(this->Edge);
    if (fewer.Triangles.empty() || fewer.Triangles.size() >= this->Polygon.Triangles.size())
    {
      return false;
    }
    this->Polygon = std::move(fewer);
    double& longest = this->Settings.MaximumEdgeLength;
    longest = longest > 0.0 ? std::max(longest, LongestEdge(this->Polygon)) : 0.0;
    return true;
  }

  bool LengthenEdges(double factor)
  {
    if (!(this->Settings.MaximumEdgeLength > 0.0))
    {
      return this->Settings.ObstacleLevels-- > 0; // nothing else divides edges then
    }
    this->Settings.MaximumEdgeLength *= factor;
    return std::isfinite(this->Settings.MaximumEdgeLength);
  }

  bool LengthenSteps(double factor)
  {
    const bool can = this->Settings.TimeStep < this->Settings.Duration;
    this->Settings.TimeStep = std::min(this->Settings.Duration, factor * this->Settings.TimeStep);
    return can;
  }

  const PolygonMaker& Remake;
  double Edge;
  double Diameter;
  int Tries = 0;
};

// Whether a coarser volume has less smoke of the time that the finer one has followed: its long
// triangles cut corners that the finer ones follow, and end at the border of the data.
bool LosesSmoke(const WholeVolume& coarser, const WholeVolume& finer)
{
  const SmokeReport &few = coarser.Mesh.Report, &many = finer.Mesh.Report;
  const double step = finer.Settings.TimeStep;
  const auto steps = static_cast<std::size_t>(many.FollowedTime / step);
  const auto mass = [steps](const std::vector<double>& perStep) {
    const auto count = static_cast<std::ptrdiff_t>(std::min(steps, perStep.size()));
    return std::accumulate(perStep.begin(), perStep.begin() + count, 0.0);
  };
  return coarser.Settings.TimeStep == step &&
    mass(few.MassPerStep) < leastKept * mass(many.MassPerStep);
}

// As if the duration had been asked for after which the limit was met.
void EndWhereItIs(WholeVolume& whole)
{
  whole.Settings.Duration = whole.Mesh.Report.FollowedTime;
  whole.Mesh.Report.LimitReached = false;
}
}

WholeVolume BuildWholeVolume(const VelocityField& field, const PolygonMesh& polygon,
  const FlowVolumeSettings& settings, double time, bool canBeShorter, const PolygonMaker& remake,
  const ProgressFunction& progress)
{
  double shown = 0.0; // never goes back
  const auto report = [&](double share) {
    shown = std::max(shown, share);
    return progress(shown);
  };
  Coarsening coarsening(polygon, settings, remake);
  WholeVolume whole, fullest;
  for (int tries = 0;; ++tries)
  {
    WholeVolume next = { BuildSteadyVolume(
                           field, coarsening.Polygon, coarsening.Settings, time, report),
      coarsening.Settings, LongestEdge(coarsening.Polygon), tries > 0 };
    if (canBeShorter && LosesSmoke(next, whole))
    {
      EndWhereItIs(whole);
      return whole;
    }
    whole = std::move(next);
    if (whole.Mesh.Report.KeptMass < 0.5 * fullest.Mesh.Report.KeptMass)
    {
      return fullest; // better the beginning of the smoke than hardly any
    }
    if (whole.Mesh.Report.KeptMass > fullest.Mesh.Report.KeptMass)
    {
      fullest = whole;
    }
    if (!whole.Mesh.Report.LimitReached || tries == mostTries || !coarsening.Coarsen(whole.Mesh))
    {
      return whole;
    }
  }
}

bool FitReleases(
  PolygonMesh& polygon, StreakSettings& settings, double followed, const PolygonMaker& remake)
{
  const double lasting = settings.Duration > 0.0 ? std::min(settings.Duration, followed) : followed;
  const double diameter = DiameterOf(polygon);
  bool coarser = false;
  for (double edge = LongestEdge(polygon);;)
  {
    settings.Releases = static_cast<int>(lasting / settings.TimeStep) + 2;
    const double tetrahedra =
      3.0 * settings.Releases * static_cast<double>(polygon.Triangles.size());
    if (tetrahedra <= 0.5 * static_cast<double>(settings.MaximumNumberOfTetrahedra))
    {
      return coarser;
    }
    edge *= 2.0;
    PolygonMesh fewer =
      polygon.Triangles.size() > fewTriangles && edge < diameter ? remake(edge) : PolygonMesh();
    if (!fewer.Triangles.empty() && fewer.Triangles.size() < polygon.Triangles.size())
    {
      polygon = std::move(fewer);
    }
    else if (settings.TimeStep < lasting)
    {
      settings.TimeStep = std::min(lasting, least * settings.TimeStep);
    }
    else
    {
      return coarser;
    }
    coarser = true;
  }
}
}
