// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Prisms into tetrahedra, triangles into triangles, and the volume of a prism with bilinear sides.
#include "SmokeGeometry.h"
#include "TriangleDivision.h"

#include <gtest/gtest.h>

#include <functional>
#include <numeric>
#include <set>

using namespace nephoscope;

namespace
{
const std::array<Vector3, 6> corners = { { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } },
  { { 0, 0, 1 } }, { { 1, 0, 1 } }, { { 0, 1, 1 } } } };

// The sum over N layers of the volume of bilinear prisms, of an exact flow map; triangle (.3, .3),
// (.5, .3), (.3, .5).
double SumOfPrisms(int layers, const std::function<Vector3(double, double, double)>& map)
{
  double sum = 0.0;
  for (int k = 0; k < layers; ++k)
  {
    const double s = static_cast<double>(k) / layers, t = (k + 1.0) / layers;
    sum += PrismVolume(map(0.3, 0.3, s), map(0.5, 0.3, s), map(0.3, 0.5, s), map(0.3, 0.3, t),
      map(0.5, 0.3, t), map(0.3, 0.5, t));
  }
  return sum;
}
}

TEST(PrismTetrahedra, All720OrdersOfIdsFillThePrismAndCutSidesFromTheSmallestRank)
{
  PrismPoints ids = { { 10, 11, 12, 13, 14, 15 } };
  int orders = 0;
  do
  {
    ++orders;
    std::set<std::pair<PointId, PointId>> edges;
    for (const auto& tetrahedron : PrismTetrahedra(ids))
    {
      std::array<Vector3, 4> p;
      for (std::size_t i = 0; i < 4; ++i)
      {
        const auto place = std::find(ids.begin(), ids.end(), tetrahedron[i]) - ids.begin();
        p[i] = corners[static_cast<std::size_t>(place)];
        for (std::size_t j = 0; j < i; ++j)
        {
          edges.insert(std::minmax(tetrahedron[i], tetrahedron[j]));
        }
      }
      EXPECT_NEAR(SignedVolume(p[0], p[1], p[2], p[3]), 1.0 / 6.0, 1e-15);
    }
    static constexpr std::size_t sides[3][4] = { { 0, 1, 4, 3 }, { 1, 2, 5, 4 }, { 2, 0, 3, 5 } };
    for (const auto& side : sides)
    {
      std::size_t smallest = 0;
      for (std::size_t i = 1; i < 4; ++i)
      {
        smallest = Rank(ids[side[i]]) < Rank(ids[side[smallest]]) ? i : smallest;
      }
      EXPECT_EQ(edges.count(std::minmax(ids[side[smallest]], ids[side[(smallest + 2) % 4]])), 1u);
      EXPECT_EQ(
        edges.count(std::minmax(ids[side[(smallest + 1) % 4]], ids[side[(smallest + 3) % 4]])), 0u);
    }
  } while (std::next_permutation(ids.begin(), ids.end()));
  EXPECT_EQ(orders, 720);
}

TEST(TriangleDivision, FillsTheTriangleTheSameFromEverySide)
{
  const TrianglePoints all = { { 1, 2, 3 } };
  for (int marks = 0; marks < 8; ++marks)
  {
    const auto middle = [&](
                          int edge) { return marks >> edge & 1 ? PointId{ 10 } + edge : noPoint; };
    std::set<std::set<PointId>> first;
    for (int turn = 0; turn < 6; ++turn)
    {
      // Vertex i of the turned triangle, and the edge after it.
      const auto vertex = [turn](int i) { return turn < 3 ? (i + turn) % 3 : (turn - i + 3) % 3; };
      TrianglePoints points, middles;
      for (int i = 0; i < 3; ++i)
      {
        const int a = vertex(i), b = vertex((i + 1) % 3);
        points[static_cast<std::size_t>(i)] = all[static_cast<std::size_t>(a)];
        middles[static_cast<std::size_t>(i)] = middle((a + 1) % 3 == b ? a : b);
      }
      const DividedTriangle divided = DivideTriangle(points, middles);
      std::set<std::set<PointId>> pieces;
      double share = 0.0;
      for (std::size_t i = 0; i < static_cast<std::size_t>(divided.Count); ++i)
      {
        pieces.insert({ divided.Triangles[i].begin(), divided.Triangles[i].end() });
        share += divided.Shares[i];
      }
      EXPECT_EQ(divided.Count, 1 + (marks & 1) + (marks >> 1 & 1) + (marks >> 2));
      EXPECT_EQ(share, 1.0);
      EXPECT_EQ(turn == 0 ? pieces : first, pieces) << marks << " " << turn;
      first = pieces;
    }
  }
}

TEST(PrismVolume, IsExactForStraightPrismsAndPyramids)
{
  const auto& p = corners;
  EXPECT_NEAR(PrismVolume(p[0], p[1], p[2], p[3], p[4], p[5]), 0.5, 1e-15);
  // The edge 3 4 merged at 3: the skew side 1 2 5 3 cut at 2 3 leaves one tetrahedron, at 1 5 two.
  const double one = SignedVolume(p[0], p[1], p[2], p[3]);
  const double other = SignedVolume(p[1], p[2], p[3], p[5]);
  EXPECT_NEAR(PrismVolume(p[0], p[1], p[2], p[3], p[3], p[5]), one + 0.5 * other, 1e-15);
}

TEST(PrismVolume, ConvergesWithSecondOrderForLinearFlows)
{
  const double pi = std::acos(-1.0);
  const auto saddle = [](double x, double y, double t) {
    return Vector3{ { x * std::exp(t), y * std::exp(-t), t } };
  };
  const auto helix = [pi](double x, double y, double t) {
    const double c = std::cos(2 * pi * t), s = std::sin(2 * pi * t);
    return Vector3{ { c * x - s * y, s * x + c * y, t } };
  };
  const auto spreading = [](double x, double y, double t) {
    return Vector3{ { x * std::exp(t), y * std::exp(t), t } };
  };
  // Relative errors for 8, 16, 32 and 64 layers: integrals of det((1 - s) I + s exp(M h)) over s.
  const int layers[4] = { 8, 16, 32, 64 };
  const double saddles[4] = { 2.608e-3, 6.51253621889e-4, 1.628e-4, 4.07e-5 };
  const double helices[4] = { -9.763e-2, -2.5373489162904e-2, -6.405e-3, -1.605e-3 };
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_NEAR(SumOfPrisms(layers[i], saddle) / 0.02 - 1.0, saddles[i], 1e-3 * saddles[i]);
    EXPECT_NEAR(SumOfPrisms(layers[i], helix) / 0.02 - 1.0, helices[i], -1e-3 * helices[i]);
  }
  EXPECT_NEAR(SumOfPrisms(16, saddle) / 0.02 - 1.0, saddles[1], 1e-13);
  EXPECT_NEAR(SumOfPrisms(16, helix) / 0.02 - 1.0, helices[1], 1e-13);
  const double spread[4] = { 1.04e-2 / 4, 2.60e-3 / 4, 6.5e-4 / 4, 1.63e-4 / 4 };
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_NEAR(
      SumOfPrisms(layers[i], spreading) / 0.0638905609893065 - 1.0, spread[i], 5e-3 * spread[i]);
  }
}
