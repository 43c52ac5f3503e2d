// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SteadyVolume.h"

#include "FirstFront.h"
#include "FrontMerging.h"
#include "LayerIntegrator.h"
#include "ObstacleLoss.h"
#include "ObstacleSearch.h"
#include "StepControl.h"

#include <numeric>

namespace nephoscope
{
namespace
{
double LongestEdge(const SmokeFront& front)
{
  double longest = 0.0;
  for (const auto& edge : front.Edges.Points)
  {
    longest = std::max(longest,
      Distance(front.Positions[static_cast<std::size_t>(edge[0])],
        front.Positions[static_cast<std::size_t>(edge[1])]));
  }
  return longest;
}

class SteadyVolumeBuilder
{
public:
  SteadyVolumeBuilder(const VelocityField& field, const FlowVolumeSettings& settings, double time)
    : Field(field)
    , Settings(settings)
    , Time(time)
    , Integrator(field, settings, time)
  {
  }

  SmokeMesh Build(const PolygonMesh& polygon, const ProgressFunction& progress)
  {
    const FlowVolumeSettings& s = this->Settings;
    if (!(s.Duration > 0.0) || !(s.TimeStep > 0.0))
    {
      return SmokeMesh();
    }
    this->Begin(polygon);
    const double count = std::ceil(s.Duration / s.TimeStep - 1e-9);
    for (int k = 0; k < count && !this->Front.Triangles.empty() && !this->Report().LimitReached;
         ++k)
    {
      if (!progress(k / count))
      {
        this->Report().Stopped = true;
        break;
      }
      const double start = k * s.TimeStep;
      this->EmitStep(k, start, std::min(s.TimeStep, s.Duration - start));
    }
    this->Finish();
    return std::move(this->Mesh);
  }

private:
  enum class Outcome
  {
    Done,
    TooLong,
    OverLimit
  };

  SmokeReport& Report() { return this->Mesh.Report; }

  void Begin(const PolygonMesh& polygon)
  {
    const FlowVolumeSettings& s = this->Settings;
    this->Front = MakeFirstFront(polygon);
    this->Front.BuildEdges();
    const double longest = LongestEdge(this->Front);
    this->Rest = 1e-12 * longest;
    this->Edges.Longest = std::max(s.MaximumEdgeLength, 0.0);
    this->Edges.Shortest = std::ldexp(this->Edges.Longest, -s.EdgeLevels);
    this->Edges.Obstacle = s.ObstacleLevels > 0
      ? std::ldexp(this->Edges.Longest > 0.0 ? this->Edges.Longest : longest, -s.ObstacleLevels)
      : 0.0;
    this->Integrator.SetLength(longest);
    const Emission emission =
      EmitFrom(this->Front, this->Field, this->Time, this->Edges, s.MaximumNumberOfTetrahedra / 3);
    this->Report().Flux = emission.Flux;
    this->Report().StartedOutside = emission.Outside;
    this->Report().LimitReached = emission.LimitReached;
    this->Report().ParallelTriangles = emission.Parallel;
    this->Front.Ids.resize(this->Front.Positions.size());
    std::iota(this->Front.Ids.begin(), this->Front.Ids.end(), PointId{ 0 });
    this->Reserve(std::ceil(s.Duration / s.TimeStep));
    this->AppendPoints(this->Front, 0, 0.0);
  }

  // For a front that stays as it is.
  void Reserve(double steps)
  {
    const double most =
      std::min(1e6, static_cast<double>(this->Settings.MaximumNumberOfTetrahedra));
    const auto points = static_cast<std::size_t>(
      std::min(most, (steps + 1.0) * static_cast<double>(this->Front.Positions.size())));
    const auto tetrahedra = static_cast<std::size_t>(
      std::min(most, 3.0 * steps * static_cast<double>(this->Front.Triangles.size())));
    this->Mesh.Points.reserve(points);
    this->Mesh.PointAges.reserve(points);
    this->Mesh.Hints.reserve(points);
    this->Mesh.Tetrahedra.reserve(tetrahedra);
    this->Mesh.EmissionSteps.reserve(tetrahedra);
    this->Mesh.Ages.reserve(tetrahedra);
    this->Mesh.Densities.reserve(tetrahedra);
  }

  // One emission step, in as many layers as it needs.
  void EmitStep(int step, double start, double duration)
  {
    const int halvings = std::min(std::max(this->Settings.MaximumHalvings, 0), 20);
    const unsigned parts = 1u << halvings;
    double mass = 0.0;
    for (unsigned done = 0; done < parts && !this->Front.Triangles.empty();)
    {
      const unsigned width = parts >> this->Depth;
      this->Between = Slab();
      this->Between.EmissionStep = step;
      this->Between.Step = duration * width / parts;
      this->LayerStart = start + duration * done / parts;
      this->Between.Age = this->LayerStart + 0.5 * this->Between.Step;
      const Outcome outcome = this->AddLayer(this->Depth == halvings, mass);
      if (outcome == Outcome::OverLimit)
      {
        this->Report().LimitReached = true;
        break;
      }
      if (outcome == Outcome::TooLong)
      {
        ++this->Depth;
        continue;
      }
      done += width;
      this->Report().FollowedTime = start + duration * done / parts;
      this->Depth -= this->Calm && this->Depth > 0 && done % (2 * width) == 0;
    }
    this->Report().MassPerStep.push_back(mass);
  }

  Outcome AddLayer(bool last, double& mass)
  {
    const double step = this->Between.Step;
    this->Integrator.Advance(this->Front, step, this->Top);
    const StepLimits limits = { this->Settings.MaximumTurnAngle, this->Settings.MaximumAreaRatio,
      this->Settings.MaximumDivergence };
    const StepVerdict verdict =
      CheckStep(this->Front, this->Top.Positions, this->Top.Inside, limits, this->LastStep, step);
    this->Calm = verdict == StepVerdict::Calm;
    if (verdict == StepVerdict::TooLong && !last)
    {
      return Outcome::TooLong;
    }
    for (;;)
    {
      if (!this->DivideFront())
      {
        return Outcome::OverLimit;
      }
      SmokeFront above = this->MakeFrontAbove();
      if (this->Mesh.Tetrahedra.size() + 3 * above.Triangles.size() >
        this->Settings.MaximumNumberOfTetrahedra)
      {
        return Outcome::OverLimit;
      }
      const std::size_t merged = this->MergeFront(above);
      const std::size_t first = this->Mesh.Tetrahedra.size();
      const SlabSums slab = AppendSlab(this->Between, above.Triangles, this->Mesh);
      if (slab.Folded.empty())
      {
        this->FirstTetrahedron = first;
        mass += slab.Mass;
        this->Report().MergedEdges += merged;
        this->MoveUp(above);
        return Outcome::Done;
      }
      this->RemoveTetrahedra(first);
      if (!last)
      {
        return Outcome::TooLong;
      }
      this->Unfold(slab.Folded);
    }
  }

  // Divides triangles that would fold, or ends them if they are small.
  void Unfold(const std::vector<std::size_t>& folded)
  {
    this->Marks.assign(this->Front.Edges.Size(), 0);
    std::vector<unsigned char> ends(this->Front.Triangles.size(), 0);
    bool any = false;
    for (std::size_t t : folded)
    {
      ends[t] = !MarkTriangle(this->Front, t, this->Edges.Obstacle, this->Marks);
      any |= !ends[t];
    }
    if (any)
    {
      this->HalveMarked();
      return;
    }
    auto& triangles = this->Front.Triangles;
    std::size_t left = 0;
    for (std::size_t t = 0; t < triangles.size(); ++t)
    {
      this->Report().FoldedMass += ends[t] ? this->MassToCome(triangles[t]) : 0.0;
      triangles[left] = triangles[t];
      left += !ends[t];
    }
    this->Report().FoldedTriangles += triangles.size() - left;
    this->Report().EndedTriangles += triangles.size() - left;
    triangles.resize(left);
    this->Front.BuildEdges();
  }

  // Halves edges of the front until none is too long; false if the mesh would get too large.
  bool DivideFront()
  {
    for (;;)
    {
      this->FindObstacles();
      if (MarkEdges(this->Front, this->Top.Positions, this->Top.Inside, this->Blocked, this->Edges,
            this->Marks) == 0)
      {
        return true;
      }
      const auto marks = static_cast<std::size_t>(
        std::count(this->Marks.begin(), this->Marks.end(), static_cast<unsigned char>(1)));
      // An edge on the front belongs to some six tetrahedra, and divides two triangles.
      if (this->Mesh.Tetrahedra.size() + 12 * marks + 3 * this->Front.Triangles.size() >
        this->Settings.MaximumNumberOfTetrahedra)
      {
        return false;
      }
      this->HalveMarked();
    }
  }

  // Which triangles of the front would sweep over an obstacle that none of
  // their corners meets.
  void FindObstacles()
  {
    ObstacleSearch search(
      this->Field, this->Time, this->Settings.ObstacleSize, this->Front.Triangles.size());
    for (std::size_t t = 0; t < this->Front.Triangles.size(); ++t)
    {
      const FrontTriangle& triangle = this->Front.Triangles[t];
      std::array<Vector3, 3> below, above;
      for (std::size_t c = 0; c < 3; ++c)
      {
        const auto point = static_cast<std::size_t>(triangle.Points[c]);
        below[c] = this->Front.Positions[point];
        above[c] = this->Top.Positions[point];
      }
      if (this->Arrives(triangle))
      {
        search.AddPrism(t, below, above, this->LayerStart == 0.0,
          this->Front.Hints[static_cast<std::size_t>(triangle.Points[0])]);
      }
    }
    this->Blocked = search.Find();
  }

  // With all corners.
  bool Arrives(const FrontTriangle& triangle) const
  {
    return std::all_of(triangle.Points.begin(), triangle.Points.end(),
      [this](PointId p) { return this->Top.Inside[static_cast<std::size_t>(p)] != 0; });
  }

  void HalveMarked()
  {
    const std::size_t first = this->Front.Positions.size();
    const auto id = static_cast<PointId>(this->Mesh.Points.size());
    const auto halved = this->Front.HalveEdges(this->Marks, id);
    this->AppendPoints(this->Front, first, this->LayerStart);
    HalveTetrahedra(halved, id, this->FirstTetrahedron, this->Mesh);
    this->Integrator.Advance(this->Front, this->Between.Step, this->Top, first);
    this->Report().HalvedEdges += halved.size();
  }

  // The points and triangles that have arrived.
  SmokeFront MakeFrontAbove()
  {
    SmokeFront above;
    above.Positions = this->Top.Positions;
    above.Hints = this->Top.Hints;
    above.Ids = this->Front.Ids;
    above.Directions = this->Front.Directions;
    auto next = static_cast<PointId>(this->Mesh.Points.size());
    double furthest = 0.0, longest = 0.0;
    for (std::size_t i = 0; i < above.Positions.size(); ++i)
    {
      const Vector3 chord = above.Positions[i] - this->Front.Positions[i];
      const double length = Norm(chord);
      // A point that does not move stays the same point: two in one place would leave flat
      // tetrahedra, and a crack where they are left out.
      if (length > this->Rest)
      {
        above.Ids[i] = next++;
        above.Directions[i] = (1.0 / length) * chord;
      }
      else
      {
        above.Positions[i] = this->Front.Positions[i];
      }
      if (this->Top.Inside[i])
      {
        const Vector3& p = above.Positions[i];
        furthest = std::max({ furthest, std::abs(p[0]), std::abs(p[1]), std::abs(p[2]), length });
        longest = std::max(longest, length);
      }
    }
    longest = std::max(longest, LongestEdge(this->Front));
    this->Between.SmallestVolume = 1e-16 * furthest * longest * longest;
    above.Triangles.reserve(this->Front.Triangles.size());
    this->Between.Origins.clear();
    this->Ending.clear();
    for (std::size_t t = 0; t < this->Front.Triangles.size(); ++t)
    {
      const FrontTriangle& triangle = this->Front.Triangles[t];
      if (this->Arrives(triangle) && !this->Blocked[t])
      {
        above.Triangles.push_back(triangle);
        this->Between.Origins.push_back(t);
      }
      else
      {
        this->Ending.push_back(this->EndedOf(triangle));
        this->MarkEnd(triangle);
      }
    }
    this->Between.Below = &this->Front;
    return above;
  }

  // The smoke of a triangle that came from the polygon ends here.
  void MarkEnd(const FrontTriangle& triangle)
  {
    for (const PointId corner : triangle.Points)
    {
      const auto id = static_cast<std::size_t>(this->Front.Ids[static_cast<std::size_t>(corner)]);
      if (this->LayerStart > 0.0)
      {
        this->Mesh.Ends[id] = 1;
      }
    }
  }

  EndedSmoke EndedOf(const FrontTriangle& triangle) const
  {
    EndedSmoke smoke;
    for (std::size_t c = 0; c < 3; ++c)
    {
      smoke.Corners[c] = this->Front.Corner(triangle, c);
      smoke.Leaves[c] = !this->Top.Inside[static_cast<std::size_t>(triangle.Points[c])];
    }
    smoke.AtObstacle = this->Arrives(triangle); // which lies between the corners
    smoke.Step = this->Between.Step;
    smoke.Mass = this->MassToCome(triangle);
    return smoke;
  }

  // What a triangle would carry from the present layer to the end.
  double MassToCome(const FrontTriangle& triangle) const
  {
    return triangle.Mass * std::max(this->Settings.Duration - this->LayerStart, 0.0);
  }

  std::size_t MergeFront(SmokeFront& above)
  {
    this->Between.Above = &above;
    this->Between.NumberOfPatches = 0;
    this->Between.TopOf.resize(above.Positions.size());
    std::iota(this->Between.TopOf.begin(), this->Between.TopOf.end(), PointId{ 0 });
    const double shortest = this->Edges.Longest > 0.0
      ? std::min(this->Settings.MinimumEdgeLength, this->Edges.Longest / 3.0)
      : this->Settings.MinimumEdgeLength;
    if (!(shortest > 0.0))
    {
      return 0;
    }
    if (above.Triangles.size() == this->Front.Triangles.size())
    {
      above.Edges = this->Front.Edges;
    }
    else
    {
      above.BuildEdges();
    }
    return MergeShortEdges(this->Front, above, { shortest, this->Edges.Longest }, this->Between);
  }

  void MoveUp(SmokeFront& above)
  {
    const std::size_t ended = this->Front.Triangles.size() - above.Triangles.size();
    this->Report().EndedTriangles += ended;
    this->Ended.insert(this->Ended.end(), this->Ending.begin(), this->Ending.end());
    ++this->Report().Layers;
    this->AppendNewPoints(above);
    const bool merged = this->Between.NumberOfPatches > 0;
    if (merged)
    {
      std::vector<Vector3> chords = this->Top.Positions;
      std::transform(chords.begin(), chords.end(), this->Front.Positions.begin(), chords.begin(),
        [](const Vector3& a, const Vector3& b) { return a - b; });
      RemoveMergedTriangles(above, chords, this->Between);
    }
    if (merged || ended > 0)
    {
      above.Compact();
      above.BuildEdges();
    }
    else
    {
      above.Edges = std::move(this->Front.Edges);
    }
    this->Front = std::move(above);
    this->LastStep = this->Between.Step;
  }

  void AppendPoints(const SmokeFront& front, std::size_t first, double age)
  {
    for (std::size_t i = first; i < front.Positions.size(); ++i)
    {
      this->AppendPoint(front, i, age);
    }
  }

  // Those that have moved; the others are there.
  void AppendNewPoints(const SmokeFront& above)
  {
    const auto first = static_cast<PointId>(this->Mesh.Points.size());
    for (std::size_t i = 0; i < above.Positions.size(); ++i)
    {
      if (above.Ids[i] >= first)
      {
        this->AppendPoint(above, i, this->LayerStart + this->Between.Step);
      }
    }
  }

  void AppendPoint(const SmokeFront& front, std::size_t i, double age)
  {
    this->Mesh.Points.push_back(front.Positions[i]);
    this->Mesh.Hints.push_back(front.Hints[i]);
    this->Mesh.PointAges.push_back(age);
    this->Mesh.Ends.push_back(0);
  }

  void RemoveTetrahedra(std::size_t first)
  {
    this->Mesh.Tetrahedra.resize(first);
    this->Mesh.EmissionSteps.resize(first);
    this->Mesh.Ages.resize(first);
    this->Mesh.Densities.resize(first);
  }

  // Scales the densities and forgets the points that are not used.
  void Finish()
  {
    SmokeMesh& mesh = this->Mesh;
    ScaleDensities(mesh);
    SmokeReport& report = mesh.Report;
    const bool cut = report.LimitReached || report.Stopped;
    report.EmittedMass = report.Flux * (cut ? report.FollowedTime : this->Settings.Duration);
    report.KeptMass = std::accumulate(report.MassPerStep.begin(), report.MassPerStep.end(), 0.0);
    report.LostMass = std::max(report.EmittedMass - report.KeptMass, 0.0);
    if (!cut)
    {
      report.ObstacleMass =
        MassAtObstacles(this->Field, this->Time, this->Settings.FarthestObstacle, this->Ended);
    }
    CompactPoints(mesh);
  }

  const VelocityField& Field;
  FlowVolumeSettings Settings;
  double Time;
  LayerIntegrator Integrator;
  EdgeLimits Edges;
  double Rest = 0.0; // a point that moves less in a step is at rest
  SmokeMesh Mesh;
  SmokeFront Front;
  ArrivedPoints Top;
  Slab Between;
  std::vector<EndedSmoke> Ending, Ended; // of the present layer, of all layers
  std::vector<unsigned char> Marks;      // of edges
  std::vector<unsigned char> Blocked;    // triangles with an obstacle between their corners
  std::size_t FirstTetrahedron = 0;      // of the last slab
  int Depth = 0;                         // halvings of the step
  bool Calm = false;
  double LayerStart = 0.0; // s
  double LastStep = 0.0;   // s; 0 at the polygon
};
}

SmokeMesh BuildSteadyVolume(const VelocityField& field, const PolygonMesh& polygon,
  const FlowVolumeSettings& settings, double time, const ProgressFunction& progress)
{
  return SteadyVolumeBuilder(field, settings, time).Build(polygon, progress);
}
}
