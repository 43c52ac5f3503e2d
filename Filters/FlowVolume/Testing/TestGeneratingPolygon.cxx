// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The generating polygon: area kept, conforming, well shaped, of the wanted size, and refused with
// a reason.
#include "GeneratingPolygon.h"
#include "TestRandom.h"
#include "TriangleEdges.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

using namespace nephoscope;

namespace
{
constexpr double pi = 3.14159265358979323846;

using Outline = std::vector<Vector3>;

vtkSmartPointer<vtkPolyData> MakeData(const std::vector<Outline>& polygons)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (const Outline& polygon : polygons)
  {
    cells->InsertNextCell(static_cast<int>(polygon.size()));
    for (const Vector3& point : polygon)
    {
      cells->InsertCellPoint(points->InsertNextPoint(point.data()));
    }
  }
  data->SetPoints(points);
  data->SetPolys(cells);
  return data;
}

PolygonMesh Triangulated(const std::vector<Outline>& polygons, double length)
{
  PolygonMesh mesh;
  std::string problem;
  EXPECT_TRUE(TriangulatePolygons(MakeData(polygons), length, mesh, problem)) << problem;
  return mesh;
}

std::string Problem(const std::vector<Outline>& polygons, double length = 0.1)
{
  PolygonMesh mesh;
  std::string problem;
  EXPECT_FALSE(TriangulatePolygons(MakeData(polygons), length, mesh, problem));
  EXPECT_TRUE(mesh.Triangles.empty());
  return problem;
}

double SmallestAngle(const PolygonMesh& mesh)
{
  double smallest = 180.0;
  for (const auto& t : mesh.Triangles)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      const Vector3& p = mesh.Points[static_cast<std::size_t>(t[i])];
      const Vector3 a = mesh.Points[static_cast<std::size_t>(t[(i + 1) % 3])] - p;
      const Vector3 b = mesh.Points[static_cast<std::size_t>(t[(i + 2) % 3])] - p;
      smallest = std::min(smallest, 180.0 / pi * std::acos(Dot(a, b) / (Norm(a) * Norm(b))));
    }
  }
  return smallest;
}

double OutlineLength(const PolygonMesh& mesh)
{
  TriangleEdges edges;
  edges.Build(mesh.Triangles.size(),
    [&mesh](std::size_t t) -> const TrianglePoints& { return mesh.Triangles[t]; });
  double sum = 0.0;
  for (std::size_t e = 0; e < edges.Size(); ++e)
  {
    EXPECT_LE(edges.Uses[e], 2);
    sum += edges.Uses[e] == 1 ? Distance(mesh.Points[static_cast<std::size_t>(edges.Points[e][0])],
                                  mesh.Points[static_cast<std::size_t>(edges.Points[e][1])])
                              : 0.0;
  }
  return sum;
}

const Outline square = { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 1, 1, 0 } }, { { 0, 1, 0 } } };
// The letter L, with points in a row on a side.
const Outline angle = { { { 0, 0, 2 } }, { { 1, 0, 2 } }, { { 2, 0, 2 } }, { { 3, 0, 2 } },
  { { 3, 1, 2 } }, { { 1, 1, 2 } }, { { 1, 2, 2 } }, { { 1, 3, 2 } }, { { 0, 3, 2 } } };
}

TEST(GeneratingPolygon, RegularPolygonsAreWellShapedAndOfTheWantedSize)
{
  for (int sides : { 3, 4, 5, 6, 7, 12, 40 })
  {
    for (double length : { 0.7, 0.3, 0.1, 0.03 })
    {
      const Vector3 center = { { 5, -3, 2 } };
      const auto mesh = TriangulateRegularPolygon({ center, 2.0, sides, { { 1, 2, -2 } } }, length);
      const double side = 4.0 * std::sin(pi / sides);
      // Rounding of a sum over up to 30000 triangles.
      EXPECT_NEAR(Area(mesh), 0.5 * sides * 4.0 * std::sin(2.0 * pi / sides), 1e-11);
      EXPECT_NEAR(OutlineLength(mesh), sides * side, 1e-11);
      EXPECT_LE(LongestEdge(mesh), length * (1.0 + 1e-9));
      EXPECT_GT(SmallestAngle(mesh), 20.0) << sides << " sides, " << length;
      EXPECT_LT(Distance(Normal(mesh), { { 1.0 / 3, 2.0 / 3, -2.0 / 3 } }), 1e-12);
      EXPECT_LT(Distance(Center(mesh), center), 1e-12);
      // Not many more triangles than equilateral ones of that size.
      const double fewest = Area(mesh) / (0.433 * length * length);
      EXPECT_LT(static_cast<double>(mesh.Triangles.size()), 4.0 * fewest + 2.0 * sides);
    }
  }
}

TEST(GeneratingPolygon, MeaninglessRegularPolygonsAreEmpty)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Vector3 up = { { 0, 0, 1 } };
  EXPECT_TRUE(TriangulateRegularPolygon({ {}, 0.0, 6, up }, 0.1).Triangles.empty());
  EXPECT_TRUE(TriangulateRegularPolygon({ {}, nan, 6, up }, 0.1).Triangles.empty());
  EXPECT_TRUE(TriangulateRegularPolygon({ {}, 1.0, 6, {} }, 0.1).Triangles.empty());
  EXPECT_TRUE(TriangulateRegularPolygon({ { { nan, 0, 0 } }, 1.0, 6, up }, 0.1).Triangles.empty());
  EXPECT_TRUE(TriangulateRegularPolygon({ {}, 1.0, 6, up }, 1e-9).Triangles.empty());
}

TEST(GeneratingPolygon, ConcavePolygonsWithPointsInARowKeepAreaAndOutline)
{
  for (double length : { 0.0, 2.0, 0.5, 0.1 })
  {
    const auto mesh = Triangulated({ angle }, length);
    EXPECT_NEAR(Area(mesh), 5.0, 1e-12);
    EXPECT_NEAR(OutlineLength(mesh), 12.0, 1e-12);
    EXPECT_LE(LongestEdge(mesh), (length > 0.0 ? length : 0.75) * (1.0 + 1e-9));
    EXPECT_GT(SmallestAngle(mesh), 18.4); // undivided, an arm of the letter makes it atan(1/3)
    EXPECT_LT(Distance(Normal(mesh), { { 0, 0, 1 } }), 1e-12);
  }
}

TEST(GeneratingPolygon, SpikesAndStarsAreFilledOnce)
{
  Outline star;
  for (int i = 0; i < 14; ++i)
  {
    const double r = i % 2 ? 0.3 : 1.0;
    star.push_back({ { 1e7 + r * std::cos(pi * i / 7), r * std::sin(pi * i / 7), 3.0 } });
  }
  const auto mesh = Triangulated({ star }, 0.2);
  EXPECT_NEAR(Area(mesh), 7.0 * 0.3 * std::sin(pi / 7), 1e-7);
}

TEST(GeneratingPolygon, NeighboursConformAndTurnAlike)
{
  Outline other = { { { 1, 1, 0 } }, { { 2, 1, 0 } }, { { 2, 0, 0 } },
    { { 1, 0, 0 } } }; // clockwise
  const auto mesh = Triangulated({ square, other }, 0.3);
  EXPECT_NEAR(Area(mesh), 2.0, 1e-12);
  EXPECT_NEAR(OutlineLength(mesh), 6.0, 1e-12);
  EXPECT_NEAR(Norm(Normal(mesh)), 1.0, 1e-12);
  EXPECT_NEAR(std::abs(Normal(mesh)[2]), 1.0, 1e-12);
}

TEST(GeneratingPolygon, EitherWayRoundAndAnyFirstPointGiveTheSame)
{
  const auto mesh = Triangulated({ angle }, 0.4);
  Outline turned = angle;
  std::rotate(turned.begin(), turned.begin() + 4, turned.end());
  EXPECT_EQ(Triangulated({ turned }, 0.4).Points, mesh.Points);
  EXPECT_EQ(Triangulated({ turned }, 0.4).Triangles, mesh.Triangles);
  std::reverse(turned.begin(), turned.end());
  EXPECT_NEAR(Normal(Triangulated({ turned }, 0.4))[2], -1.0, 1e-12);
}

TEST(GeneratingPolygon, AlmostFlatIsAcceptedAndBentIsRefused)
{
  Outline bent = square;
  bent[2][2] = 0.1; // 2.5 % off the mean plane
  EXPECT_NEAR(Area(Triangulated({ bent }, 0.2)), 1.0, 0.02);
  bent[2][2] = 0.5;
  EXPECT_NE(Problem({ bent }).find("not flat"), std::string::npos);
}

TEST(GeneratingPolygon, WhatIsNoPolygonIsRefusedWithAReason)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(Problem({}).find("empty"), std::string::npos);
  EXPECT_NE(Problem({ { { { 0, 0, 0 } }, { { 1, 0, 0 } } } }).find("empty"), std::string::npos);
  EXPECT_NE(Problem({ { { { 1, 0, 0 } }, { { 1, 0, 0 } }, { { 1, 0, 0 } } } }).find("empty"),
    std::string::npos);
  EXPECT_NE(Problem({ { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 2, 0, 0 } } } }).find("no area"),
    std::string::npos);
  EXPECT_NE(Problem({ { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 1, nan, 0 } } } }).find("finite"),
    std::string::npos);
  const Outline crossing = { { { 0, 0, 0 } }, { { 2, 2, 0 } }, { { 2, 0, 0 } }, { { 0, 1, 0 } } };
  EXPECT_NE(Problem({ crossing }).find("crosses itself"), std::string::npos);
  EXPECT_NE(Problem({ square }, 1e-5).find("PolygonEdgeLength"), std::string::npos);
}

TEST(GeneratingPolygon, TurnsByTheSmallestAngle)
{
  nephoscope_test::Random random(20);
  for (int trial = 0; trial < 50; ++trial)
  {
    const Vector3 center = random.NormalVector(), to = random.NormalVector(),
                  from = random.NormalVector();
    auto mesh = TriangulateRegularPolygon({ center, 0.5, 5, from }, 0.2);
    const auto before = mesh.Points;
    TurnNormalTo(mesh, center, to);
    EXPECT_LT(Distance(Normal(mesh), Normalized(to)), 1e-12);
    // The line both planes share does not move.
    const Vector3 axis = Cross(from, to);
    for (std::size_t i = 0; i < before.size(); ++i)
    {
      EXPECT_NEAR(Dot(before[i], axis), Dot(mesh.Points[i], axis), 1e-12);
      EXPECT_NEAR(Distance(before[i], center), Distance(mesh.Points[i], center), 1e-12);
    }
  }
  auto mesh = TriangulateRegularPolygon({ {}, 1.0, 6, { { 0, 0, 1 } } }, 0.5);
  TurnNormalTo(mesh, {}, { { 0, 0, -3 } });
  EXPECT_NEAR(Normal(mesh)[2], -1.0, 1e-12);
  const auto still = mesh.Points;
  TurnNormalTo(mesh, {}, {});
  EXPECT_EQ(mesh.Points, still);
}
