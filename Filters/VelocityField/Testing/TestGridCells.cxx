// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Finding positions in grids: the inverse of a cell's map, seams, poles, walks and boxes.
#include "CurvilinearCells.h"
#include "RectilinearCells.h"
#include "UniformCells.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

using namespace nephoscope;

namespace
{
constexpr double PI = 3.14159265358979323846;

template <typename Function>
std::vector<double> MakePoints(const GridSize& size, const Function& position)
{
  std::vector<double> points;
  for (int k = 0; k < size.Points[2]; ++k)
  {
    for (int j = 0; j < size.Points[1]; ++j)
    {
      for (int i = 0; i < size.Points[0]; ++i)
      {
        const Vector3 p = position(i, j, k);
        points.insert(points.end(), p.begin(), p.end());
      }
    }
  }
  return points;
}

// Longitudes that close, latitudes from pole to pole, radii.
struct Globe
{
  GridSize Size{ { 25, 13, 4 } };
  std::vector<double> Points = MakePoints(Size, [](int i, int j, int k) -> Vector3 {
    const double longitude = 2 * PI * (i % 24) / 24;
    const double latitude = PI * j / 12 - PI / 2;
    const double across = j == 0 || j == 12 ? 0.0 : std::cos(latitude);
    const double r = 1.0 + 0.1 * k;
    return { r * across * std::cos(longitude), r * across * std::sin(longitude),
      r * std::sin(latitude) };
  });
  CurvilinearCells<double> Cells{ Size, Points.data() };
};

Vector3 Evaluate(const std::vector<double>& points, const GridSize& size, const GridCell& cell)
{
  return InterpolateTrilinear(
    points.data() + 3 * size.PointId(cell.Index), size.CornerOffsets(), cell.Parametric);
}

}

TEST(TrilinearMap, InverseOfDistortedCells)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const GridSize size{ { 2, 2, 2 } };
  for (int trial = 0; trial < 2000; ++trial)
  {
    const double shift = trial % 2 ? 1e6 : 0.0;
    const auto points = MakePoints(size, [&](int i, int j, int k) -> Vector3 {
      const auto jitter = [&]() { return 0.35 * (unit(random) - 0.5); };
      return { shift + i + jitter(), j + jitter(), 0.01 * (k + jitter()) };
    });
    GridCell cell;
    const Vector3 r = { unit(random), unit(random), unit(random) };
    cell.Parametric = r;
    const Vector3 x = Evaluate(points, size, cell);
    Vector3 found = { unit(random), unit(random), unit(random) };
    const TrilinearMap map(points.data(), size.CornerOffsets(), x);
    ASSERT_EQ(map.Invert(found), InverseResult::Inside);
    EXPECT_LT(Distance(found, r), shift > 0.0 ? 1e-8 : 1e-11);
  }
}

TEST(GridLinks, AGlobeIsClosedAndHasTwoPoles)
{
  const Globe globe;
  const GridLinks& links = globe.Cells.Links();
  EXPECT_TRUE(links.IsClosed(0));
  EXPECT_FALSE(links.IsClosed(1));
  EXPECT_FALSE(links.IsClosed(2));
  EXPECT_EQ(links.PoleAround(1, 0), 0);
  EXPECT_EQ(links.PoleAround(1, 1), 0);
  EXPECT_EQ(links.PoleAround(2, 0), -1);
  GridCell cell;
  cell.Index = { 0, 5, 1 };
  EXPECT_TRUE(links.Move(cell, 0, -1));
  EXPECT_EQ(cell.Index, (std::array<int, 3>{ 23, 5, 1 }));
  cell.Index = { 3, 11, 1 };
  EXPECT_TRUE(links.Move(cell, 1, 1));
  EXPECT_EQ(cell.Index, (std::array<int, 3>{ 15, 11, 1 }));
  cell.Index = { 3, 4, 2 };
  EXPECT_FALSE(links.Move(cell, 2, 1));
}

TEST(GridLinks, ABoxIsOpen)
{
  const GridSize size{ { 5, 5, 5 } };
  const auto points = MakePoints(size, [](int i, int j, int k) {
    return Vector3{ 1.0 * i, 1.0 * j, 1.0 * k };
  });
  const CurvilinearCells<double> cells(size, points.data());
  for (std::size_t a = 0; a < 3; ++a)
  {
    EXPECT_FALSE(cells.Links().IsClosed(a));
    EXPECT_EQ(cells.Links().PoleAround(a, 0), -1);
  }
}

// Every position inside, from any hint, is found, and the map of the cell gives it back.
TEST(CurvilinearCells, EveryPositionFromEveryHint)
{
  const Globe globe;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int trial = 0; trial < 20000; ++trial)
  {
    GridCell truth;
    for (std::size_t a = 0; a < 3; ++a)
    {
      truth.Index[a] = static_cast<int>(unit(random) * globe.Size.Cells(a));
      truth.Parametric[a] = trial % 5 == 0 ? std::round(unit(random)) : unit(random);
    }
    const Vector3 x = Evaluate(globe.Points, globe.Size, truth);
    GridCell cell;
    for (std::size_t a = 0; a < 3; ++a)
    {
      cell.Index[a] = static_cast<int>(unit(random) * globe.Size.Cells(a));
    }
    ASSERT_TRUE(globe.Cells.Find(x, trial % 3 != 0, cell)) << trial;
    EXPECT_LT(Distance(Evaluate(globe.Points, globe.Size, cell), x), 1e-9);
    for (const double r : cell.Parametric)
    {
      EXPECT_TRUE(r >= 0.0 && r <= 1.0);
    }
  }
}

TEST(CurvilinearCells, OutsideIsOutsideFromEveryHint)
{
  const Globe globe;
  std::mt19937 random(4);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 2000; ++trial)
  {
    Vector3 x = { normal(random), normal(random), normal(random) };
    const double length = std::hypot(x[0], x[1], x[2]);
    const double radius =
      trial % 2 ? 0.97 : 1.31; // the chords of cells are within 1 % of the sphere
    for (double& c : x)
    {
      c *= radius * (trial % 2 ? 0.98 : 1.0) / length;
    }
    GridCell cell;
    cell.Index = { trial % 24, trial % 12, trial % 3 };
    EXPECT_FALSE(globe.Cells.Find(x, trial % 3 != 0, cell));
  }
  GridCell cell;
  EXPECT_FALSE(globe.Cells.Find({ std::nan(""), 0, 1 }, true, cell));
}

TEST(RectilinearCells, FallingCoordinatesEndsAndHints)
{
  const std::vector<double> falling = { 5.0, 3.0, 2.5, -1.0 };
  const RectilinearCells cells({ RectilinearAxis(falling), RectilinearAxis({ 0.0, 1.0, 10.0 }),
    RectilinearAxis({ 1e6, 1e6 + 1.0 }) });
  for (int hint = -2; hint < 6; ++hint)
  {
    GridCell cell;
    cell.Index = { hint, hint, hint };
    ASSERT_TRUE(cells.Find({ 2.75, 1.0, 1e6 + 1.0 }, true, cell));
    EXPECT_EQ(cell.Index, (std::array<int, 3>{ 1, 1, 0 }));
    EXPECT_NEAR(cell.Parametric[0], 0.5, 1e-15);
    EXPECT_EQ(cell.Parametric[1], 0.0);
    EXPECT_EQ(cell.Parametric[2], 1.0);
    ASSERT_TRUE(cells.Find({ -1.0, 10.0, 1e6 }, true, cell));
    EXPECT_EQ(cell.Index, (std::array<int, 3>{ 2, 1, 0 }));
    EXPECT_FALSE(cells.Find({ 5.1, 1.0, 1e6 }, true, cell));
    EXPECT_FALSE(cells.Find({ std::nan(""), 1.0, 1e6 }, true, cell));
  }
}

TEST(UniformCells, TurnedGrid)
{
  // Index 0 along y, 1 along -x, 2 along z; spacing 2, 1, 0.5.
  const UniformCells cells(
    { { 3, 4, 5 } }, { 10, 20, 30 }, { { { 0, 0.5, 0 }, { -1, 0, 0 }, { 0, 0, 2 } } });
  GridCell cell;
  ASSERT_TRUE(cells.Find({ 8.75, 23.0, 31.25 }, false, cell));
  EXPECT_EQ(cell.Index, (std::array<int, 3>{ 1, 1, 2 }));
  EXPECT_EQ(cell.Parametric, (Vector3{ 0.5, 0.25, 0.5 }));
  EXPECT_FALSE(cells.Find({ 10.1, 23.0, 31.25 }, false, cell));
}
