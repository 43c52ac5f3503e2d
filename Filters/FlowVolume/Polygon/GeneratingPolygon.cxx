// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GeneratingPolygon.h"

#include "PolygonRefinement.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolygon.h"
#include "vtkSmartPointer.h"

#include <numeric>

namespace nephoscope
{
namespace
{
constexpr std::size_t maximumNumberOfTriangles = 1000000;
constexpr double largestDistanceFromPlane = 0.05; // of the longest extent of the polygon

using Loop = std::vector<PointId>;

// The polygons by the points of the dataset.
std::vector<Loop> FindLoops(vtkPolyData* data)
{
  std::vector<Loop> loops;
  const auto visit = [&loops](vtkCellArray* cells, bool strips) {
    auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
    for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
    {
      vtkIdType count = 0;
      const vtkIdType* ids = nullptr;
      iterator->GetCurrentCell(count, ids);
      if (!strips)
      {
        loops.emplace_back(ids, ids + count);
      }
      for (vtkIdType i = 2; strips && i < count; ++i)
      {
        loops.push_back({ ids[i - 2], ids[i - 1 + i % 2], ids[i - i % 2] });
      }
    }
  };
  visit(data->GetPolys(), false);
  visit(data->GetStrips(), true);
  return loops;
}

// The points of the polygons in the order of their coordinates, each place once, and the loops
// numbered by them.
// False if one is not finite.
bool SortPoints(vtkPolyData* data, std::vector<Loop>& loops, std::vector<Vector3>& sorted)
{
  std::vector<std::pair<Vector3, PointId>> points;
  std::vector<PointId> places(static_cast<std::size_t>(data->GetNumberOfPoints()), -1);
  for (const Loop& loop : loops)
  {
    for (PointId point : loop)
    {
      if (places[static_cast<std::size_t>(point)] < 0)
      {
        places[static_cast<std::size_t>(point)] = 0;
        points.emplace_back(Vector3{}, point);
        data->GetPoint(point, points.back().first.data());
        if (!IsFinite(points.back().first))
        {
          return false;
        }
      }
    }
  }
  std::sort(points.begin(), points.end());
  for (const auto& point : points)
  {
    if (sorted.empty() || sorted.back() != point.first)
    {
      sorted.push_back(point.first);
    }
    places[static_cast<std::size_t>(point.second)] = static_cast<PointId>(sorted.size()) - 1;
  }
  for (Loop& loop : loops)
  {
    std::transform(loop.begin(), loop.end(), loop.begin(),
      [&places](PointId point) { return places[static_cast<std::size_t>(point)]; });
  }
  return true;
}

// Takes repeated points and what is no polygon out; begins each with its first point, and puts them
// in order.
void TidyLoops(std::vector<Loop>& loops)
{
  for (Loop& loop : loops)
  {
    loop.erase(std::unique(loop.begin(), loop.end()), loop.end());
    while (loop.size() > 1 && loop.front() == loop.back())
    {
      loop.pop_back();
    }
    std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
  }
  loops.erase(
    std::remove_if(loops.begin(), loops.end(), [](const Loop& loop) { return loop.size() < 3; }),
    loops.end());
  std::sort(loops.begin(), loops.end());
}

// Polygons whose orientation differs from that of most of the area are reversed.
void OrientConsistently(PolygonMesh& mesh)
{
  Vector3 sum{};
  for (const auto& triangle : mesh.Triangles)
  {
    const Vector3 area = AreaVector(mesh, triangle);
    sum = Dot(sum, area) < 0.0 ? sum - area : sum + area;
  }
  for (auto& triangle : mesh.Triangles)
  {
    if (Dot(AreaVector(mesh, triangle), sum) < 0.0)
    {
      std::swap(triangle[1], triangle[2]);
    }
  }
}

// One polygon about its first point, in units of its longest extent, so that no tolerance depends
// on place and size.
struct FlatPolygon
{
  std::vector<Vector3> Points;
  Vector3 AreaVector{};
  double DistanceFromPlane = 0.0;

  FlatPolygon(const std::vector<Vector3>& points, const Loop& loop)
  {
    const Vector3 origin = points[static_cast<std::size_t>(loop[0])];
    for (PointId point : loop)
    {
      this->Points.push_back(points[static_cast<std::size_t>(point)] - origin);
    }
    const double extent = LongestExtent(this->Points);
    Vector3 center{};
    for (std::size_t i = 0; i < this->Points.size(); ++i)
    {
      this->Points[i] = (1.0 / extent) * this->Points[i];
      center = center + (1.0 / static_cast<double>(loop.size())) * this->Points[i];
    }
    for (std::size_t i = 0; i < this->Points.size(); ++i)
    {
      const Vector3& next = this->Points[(i + 1) % this->Points.size()];
      this->AreaVector = this->AreaVector + 0.5 * Cross(this->Points[i], next);
    }
    const Vector3 normal = Normalized(this->AreaVector);
    for (const Vector3& point : this->Points)
    {
      this->DistanceFromPlane =
        std::max(this->DistanceFromPlane, std::abs(Dot(normal, point - center)));
    }
  }

  // By VTK's ear cut; false if the triangles do not fill the polygon once.
  bool Triangulate(std::vector<std::array<PointId, 3>>& triangles) const
  {
    vtkNew<vtkPolygon> polygon;
    polygon->GetPoints()->SetDataTypeToDouble();
    for (const Vector3& point : this->Points)
    {
      polygon->GetPointIds()->InsertNextId(polygon->GetPoints()->InsertNextPoint(point.data()));
    }
    vtkNew<vtkIdList> ids;
    return (polygon->EarCutTriangulation(ids) && this->IsFilled(ids, triangles)) ||
      (polygon->UnbiasedEarCutTriangulation(0, ids) && this->IsFilled(ids, triangles));
  }

private:
  bool IsFilled(vtkIdList* ids, std::vector<std::array<PointId, 3>>& triangles) const
  {
    triangles.clear();
    double area = 0.0;
    for (vtkIdType i = 0; i + 2 < ids->GetNumberOfIds(); i += 3)
    {
      triangles.push_back({ { ids->GetId(i), ids->GetId(i + 1), ids->GetId(i + 2) } });
      const auto corner = [&](std::size_t c) {
        return this->Points[static_cast<std::size_t>(triangles.back()[c])];
      };
      const Vector3 one = nephoscope::AreaVector(corner(0), corner(1), corner(2));
      area += std::abs(Dot(one, Normalized(this->AreaVector)));
    }
    return triangles.size() + 2 == this->Points.size() &&
      std::abs(area - Norm(this->AreaVector)) < 1e-9;
  }
};

std::string Number(double value)
{
  std::string text = std::to_string(std::round(1000.0 * value) / 10.0);
  text.resize(text.find('.') + 2);
  return text;
}

bool AddPolygon(const Loop& loop, PolygonMesh& mesh, std::string& problem)
{
  const FlatPolygon flat(mesh.Points, loop);
  if (!(Norm(flat.AreaVector) > 1e-9))
  {
    problem =
      "A generating polygon has no area, or crosses itself: give it three corners that are not in line, "
      "and sides that do not meet elsewhere.";
    return false;
  }
  if (flat.DistanceFromPlane > largestDistanceFromPlane)
  {
    problem = "The generating polygon is not flat: a point is " + Number(flat.DistanceFromPlane) +
      " % of its longest extent off its plane, and 5 % are allowed. Flatten it, or give it as several "
      "polygons (Triangulate).";
    return false;
  }
  std::vector<std::array<PointId, 3>> triangles;
  if (!flat.Triangulate(triangles))
  {
    problem =
      "The generating polygon could not be triangulated: it crosses itself. Draw its outline "
      "without crossings.";
    return false;
  }
  for (auto& triangle : triangles)
  {
    for (PointId& point : triangle)
    {
      point = loop[static_cast<std::size_t>(point)];
    }
    mesh.Triangles.push_back(triangle);
  }
  return true;
}
}

bool TriangulatePolygons(
  vtkPolyData* polygons, double maximumEdgeLength, PolygonMesh& mesh, std::string& problem)
{
  mesh = PolygonMesh();
  std::vector<Loop> loops = FindLoops(polygons);
  if (!SortPoints(polygons, loops, mesh.Points))
  {
    problem = "The generating polygon has a point whose coordinates are not finite: correct it.";
    mesh = PolygonMesh();
    return false;
  }
  TidyLoops(loops);
  if (loops.empty())
  {
    problem =
      "The generating polygon is empty: it needs a polygon, triangle or quadrilateral; lines and points alone "
      "do not enclose an area.";
    return false;
  }
  for (const Loop& loop : loops)
  {
    if (!AddPolygon(loop, mesh, problem))
    {
      mesh = PolygonMesh();
      return false;
    }
  }
  OrientConsistently(mesh);
  SwapToDelaunay(mesh, 0.0);
  const double length =
    maximumEdgeLength > 0.0 ? maximumEdgeLength : 0.25 * LongestExtent(mesh.Points);
  if (!HalveLongEdges(mesh, length, maximumNumberOfTriangles))
  {
    problem =
      "The edge length of the generating polygon is too small: there would be more than a million "
      "triangles. Make PolygonEdgeLength larger.";
    mesh = PolygonMesh();
    return false;
  }
  return true;
}
}
