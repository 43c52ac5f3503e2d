// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PolyhedronDivider.h"

#include "KernelPoint.h"
#include "MeanValueWeights.h"

namespace nephoscope
{
namespace
{
// A fraction of the cell's size: a vertex is taken as apex if it lies so far behind every triangle.
// Where none does, the middle of the kernel makes better tetrahedra.
constexpr double goodHeight = 0.01;

// Height of the apex below the plane of an outward triangle.
double HeightBelow(const Vector3& apex, const Vector3& a, const Vector3& b, const Vector3& c)
{
  const Vector3 normal = Cross(Difference(b, a), Difference(c, a));
  return Dot(normal, Difference(a, apex)) / std::sqrt(Dot(normal, normal));
}

Vector3 RoundedToFloat(const Vector3& x)
{
  return { { static_cast<float>(x[0]), static_cast<float>(x[1]), static_cast<float>(x[2]) } };
}
}

DivisionOutcome PolyhedronDivider::OutcomeOf(PolyhedronSurface::State state)
{
  switch (state)
  {
    case PolyhedronSurface::State::NotFinite:
      return DivisionOutcome::NotFinite;
    case PolyhedronSurface::State::NotOriented:
      return DivisionOutcome::NotOriented;
    default:
      return DivisionOutcome::NotClosed;
  }
}

DivisionOutcome PolyhedronDivider::DivideSurface()
{
  const double slack = SlackOf(this->Surface, this->Options.IsFloat);
  const bool cut = this->CutFaces();
  if (!this->Options.DivideConvex &&
    IsConvexButForWarp(this->Surface, slack, this->Options.WarpTolerance) &&
    ConeFillsCell(this->Surface, slack) && this->WarpedFacesAreFans(slack))
  {
    return DivisionOutcome::Whole;
  }
  if (!cut)
  {
    return DivisionOutcome::BadFace;
  }
  this->Division = CellDivision();
  for (int v = 0; v < this->Surface.NumberOfVertices(); ++v)
  {
    this->Division.PointIds.push_back(this->Surface.PointId(v));
  }
  // Ten times the slack, so that rounding new points to the format of the old ones inverts nothing.
  const double thin = 10 * slack;
  const bool divided = this->ConeFromVertex(std::max(thin, goodHeight * this->Surface.Size())) ||
    this->ConeFromKernel(thin) || this->ConeFromVertex(thin);
  if (divided)
  {
    this->FinishDivision();
  }
  return divided ? DivisionOutcome::Divided : DivisionOutcome::NotStar;
}

DivisionOutcome PolyhedronDivider::Judge(const TetGenTask& task, std::string& reason)
{
  reason = task.Failure;
  for (Vector3& x : this->Division.NewPoints)
  {
    x = this->Options.IsFloat ? RoundedToFloat(x) : x;
  }
  if (reason.empty() && !FillsSurface(this->Division, this->Cut))
  {
    reason = "its tetrahedra do not fill the cell";
  }
  if (!reason.empty())
  {
    return DivisionOutcome::Failed;
  }
  this->FinishDivision();
  return DivisionOutcome::Divided;
}

bool PolyhedronDivider::CutFaces()
{
  this->Cut.Surface = &this->Surface;
  this->Cut.Triangles.clear();
  this->Cut.FaceOf.clear();
  const FaceList<int> faces = this->Surface.Faces();
  int number = 0;
  for (const int* face = faces.Begin; face != faces.End; face += *face + 1, ++number)
  {
    if (!this->Triangulation.Cut(
          face + 1, *face, [this](int v) -> const Vector3& { return this->Surface.Position(v); }))
    {
      return false;
    }
    const std::vector<Triangle>& triangles = this->Triangulation.GetTriangles();
    this->Cut.Triangles.insert(this->Cut.Triangles.end(), triangles.begin(), triangles.end());
    this->Cut.FaceOf.resize(this->Cut.Triangles.size(), number);
  }
  return true;
}

// A neighbour that is divided uses the triangles of FaceTriangulation.h. On a plane face it does
// not matter which they are; on a warped one the cell that stays whole must mean the same.
bool PolyhedronDivider::WarpedFacesAreFans(double slack)
{
  const FaceList<int> faces = this->Surface.Faces();
  for (const int* face = faces.Begin; face != faces.End; face += *face + 1)
  {
    const bool fan =
      *face == 3 || (this->Triangulation.Cut(face + 1, *face, [this](int v) -> const Vector3& {
        return this->Surface.Position(v);
      }) && this->Triangulation.IsFan());
    if (!fan && WarpOf(this->Surface, face) > slack)
    {
      return false;
    }
  }
  return true;
}

// The lowest height of a vertex behind the triangles that do not have it.
double PolyhedronDivider::LowestHeight(int apex) const
{
  double lowest = this->Surface.Size();
  for (const Triangle& t : this->Cut.Triangles)
  {
    if (t[0] != apex && t[1] != apex && t[2] != apex)
    {
      lowest = std::min(lowest,
        HeightBelow(this->Surface.Position(apex), this->Surface.Position(t[0]),
          this->Surface.Position(t[1]), this->Surface.Position(t[2])));
    }
  }
  return lowest;
}

// The first vertex that will do: the least one, where possible, is what CellDecomposition.h takes.
bool PolyhedronDivider::ConeFromVertex(double smallestHeight)
{
  for (int apex = 0; apex < this->Surface.NumberOfVertices(); ++apex)
  {
    if (this->LowestHeight(apex) >= smallestHeight)
    {
      this->AddCone(apex);
      return true;
    }
  }
  return false;
}

bool PolyhedronDivider::ConeFromKernel(double smallestHeight)
{
  const double size = this->Surface.Size();
  const Vector3 low = this->Surface.Position(0);
  std::vector<HalfSpace> halfSpaces;
  for (const Triangle& t : this->Cut.Triangles)
  {
    const Vector3 a = Difference(this->Surface.Position(t[0]), low);
    Vector3 n = Cross(Difference(this->Surface.Position(t[1]), this->Surface.Position(t[0])),
      Difference(this->Surface.Position(t[2]), this->Surface.Position(t[0])));
    const double length = std::sqrt(Dot(n, n));
    n = { { n[0] / length, n[1] / length, n[2] / length } };
    halfSpaces.push_back({ n, Dot(n, a) / size });
  }
  const Ball ball = KernelPoint::Find(halfSpaces);
  if (!(ball.Radius * size >= smallestHeight))
  {
    return false;
  }
  Vector3 center{ { low[0] + ball.Center[0] * size, low[1] + ball.Center[1] * size,
    low[2] + ball.Center[2] * size } };
  this->Division.NewPoints.push_back(this->Options.IsFloat ? RoundedToFloat(center) : center);
  this->AddCone(this->Surface.NumberOfVertices());
  return true;
}

void PolyhedronDivider::AddCone(int apex)
{
  for (const Triangle& t : this->Cut.Triangles)
  {
    if (t[0] != apex && t[1] != apex && t[2] != apex)
    {
      this->Division.Tetrahedra.push_back({ { apex, t[0], t[1], t[2] } });
    }
  }
}

void PolyhedronDivider::FinishDivision()
{
  if (this->Division.NewPoints.empty())
  {
    return;
  }
  std::vector<Vector3> positions;
  for (int v = 0; v < this->Surface.NumberOfVertices(); ++v)
  {
    positions.push_back(this->Surface.Position(v));
  }
  positions.insert(
    positions.end(), this->Division.NewPoints.begin(), this->Division.NewPoints.end());
  this->Division.Weights =
    NewPointWeights(positions, this->Surface.NumberOfVertices(), this->Division.Tetrahedra);
}

} // namespace nephoscope
