// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The chessboard's tetrahedra fill their grid and fit; a walk through them meets what a straight
// line meets.
#include "ChessboardGrid.h"
#include "TestRandom.h"
#include "TetrahedronRay.h"
#include "TetrahedronWalk.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <vector>

using namespace nephoscope;
using nephoscope_test::Random;

namespace
{
using Ids = std::array<std::int64_t, 4>;
using Face = std::array<std::int64_t, 3>;

ChessboardGrid MakeGrid(int nx, int ny, int nz, int offset)
{
  ChessboardGrid grid;
  grid.Size[0] = nx;
  grid.Size[1] = ny;
  grid.Size[2] = nz;
  grid.OddOffset = offset;
  return grid;
}

Vector3 PlaceAt(const ChessboardGrid& grid, std::int64_t point)
{
  const std::int64_t row = point / grid.Size[0];
  return { double(point % grid.Size[0]), double(row % grid.Size[1]), double(row / grid.Size[1]) };
}

double Volume(const ChessboardGrid& grid, const Ids& t)
{
  const Vector3 a = PlaceAt(grid, t[0]);
  return std::abs(Dot(Cross(Difference(PlaceAt(grid, t[1]), a), Difference(PlaceAt(grid, t[2]), a)),
           Difference(PlaceAt(grid, t[3]), a))) /
    6;
}

std::map<Face, std::vector<std::int64_t>> FacesOf(const std::vector<Ids>& tetrahedra)
{
  std::map<Face, std::vector<std::int64_t>> faces;
  for (std::size_t i = 0; i < tetrahedra.size(); ++i)
  {
    for (const auto& f : tetrahedronFaces)
    {
      Face face = { { tetrahedra[i][f[0]], tetrahedra[i][f[1]], tetrahedra[i][f[2]] } };
      std::sort(face.begin(), face.end());
      faces[face].push_back(std::int64_t(i));
    }
  }
  return faces;
}

std::vector<Ids> AllTetrahedra(const ChessboardGrid& grid)
{
  std::vector<Ids> all;
  for (std::int64_t cell = 0; cell < grid.NumberOfCells(); ++cell)
  {
    for (const Ids& t : grid.Tetrahedra(cell))
    {
      all.push_back(t);
    }
  }
  return all;
}

double Field(const Vector3& p)
{
  return 0.3 * p[0] - 0.7 * p[1] + 0.11 * p[2] + 2;
}

/** A ray along +z through (x, y), by which vertices are seen. */
WalkVertex<float> Seen(const Vector3& p, double x, double y)
{
  return { float(p[0] - x), float(p[1] - y), float(p[2]), float(Field(p)) };
}
}

TEST(ChessboardGrid, TetrahedraFillTheGridAndFit)
{
  for (const int offset : { 0, 1 })
  {
    const ChessboardGrid grid = MakeGrid(5, 4, 3, offset);
    const std::vector<Ids> all = AllTetrahedra(grid);
    EXPECT_EQ(all.size(), 5u * 24);
    double sum = 0;
    for (const Ids& t : all)
    {
      EXPECT_GT(Volume(grid, t), 0.1);
      sum += Volume(grid, t);
    }
    EXPECT_NEAR(sum, 24, 1e-12);
    std::size_t boundary = 0;
    for (const auto& face : FacesOf(all))
    {
      EXPECT_LE(face.second.size(), 2u);
      boundary += face.second.size() == 1;
    }
    EXPECT_EQ(
      boundary, 2u * 2 * (4 * 3 + 3 * 2 + 4 * 2)); // two triangles per quadrangle of the six sides
  }
}

// Neighbouring pieces of one grid, whose extents differ, must agree on the diagonals between them.
TEST(ChessboardGrid, PiecesAgree)
{
  const ChessboardGrid left = MakeGrid(4, 3, 3, 0),
                       right = MakeGrid(4, 3, 3, 3 & 1); // right begins at index 3
  std::set<std::array<std::array<double, 3>, 3>> sides[2];
  const ChessboardGrid* grids[2] = { &left, &right };
  for (int k = 0; k < 2; ++k)
  {
    for (const auto& face : FacesOf(AllTetrahedra(*grids[k])))
    {
      std::array<std::array<double, 3>, 3> places;
      for (std::size_t i = 0; i < 3; ++i)
      {
        places[i] = PlaceAt(*grids[k], face.first[i]);
        places[i][0] += 3 * k;
      }
      if (face.second.size() == 1 && places[0][0] == 3 && places[1][0] == 3 && places[2][0] == 3)
      {
        std::sort(places.begin(), places.end());
        sides[k].insert(places);
      }
    }
  }
  EXPECT_EQ(sides[0].size(), 8u);
  EXPECT_EQ(sides[0], sides[1]);
}

// One tetrahedron: the walk leaves it where its planes say, in double, through barycentric
// coordinates.
TEST(TetrahedronWalk, LeavesARandomTetrahedron)
{
  Random random(31);
  int crossed = 0;
  for (int i = 0; i < 20000; ++i)
  {
    std::array<Vector3, 4> p;
    for (Vector3& v : p)
    {
      v = { random.Uniform(-1, 1), random.Uniform(-1, 1), random.Uniform(-1, 1) };
    }
    const double x = random.Uniform(-0.5, 0.5), y = random.Uniform(-0.5, 0.5);
    // Where the line (x, y, z) meets the planes of the faces, the eye far below: coordinates are
    // linear in z.
    Vector4 at0, slope;
    for (int k = 0; k < 4; ++k)
    {
      const auto& f = tetrahedronFaces[k];
      const double whole = PlaneSide(p[f[0]], p[f[1]], p[f[2]], { p[k][0], p[k][1], p[k][2], 1 });
      at0[k] = PlaneSide(p[f[0]], p[f[1]], p[f[2]], { x, y, 0, 1 }) / whole;
      slope[k] = PlaneSide(p[f[0]], p[f[1]], p[f[2]], { x, y, 1, 1 }) / whole - at0[k];
    }
    double enter = -1e30, leave = 1e30;
    int entered = -1;
    for (int k = 0; k < 4; ++k)
    {
      const double z = -at0[k] / slope[k];
      entered = slope[k] > 0 && z > enter ? k : entered;
      (slope[k] > 0 ? enter : leave) = slope[k] > 0 ? std::max(enter, z) : std::min(leave, z);
    }
    if (leave - enter < 0.05)
    {
      continue;
    }
    ++crossed;
    const auto& f = tetrahedronFaces[entered];
    TetrahedronWalk<float> walk;
    walk.Start(Seen(p[f[0]], x, y), Seen(p[f[1]], x, y), Seen(p[f[2]], x, y));
    float z, s;
    ASSERT_TRUE(walk.Pass(z, s));
    EXPECT_NEAR(z, enter, 1e-4);
    walk.Step(Seen(p[entered], x, y));
    ASSERT_TRUE(walk.Pass(z, s));
    EXPECT_NEAR(z, leave, 1e-4);
    EXPECT_NEAR(s, Field({ x, y, leave }), 1e-4);
    EXPECT_FALSE(walk.IsLost);
  }
  EXPECT_GT(crossed, 1000);
}

// Through a whole grid, neighbours found by their faces: in depth order, from one side to the
// other, with the field's values.
TEST(TetrahedronWalk, CrossesAGrid)
{
  const ChessboardGrid grid = MakeGrid(6, 6, 8, 1);
  const std::vector<Ids> all = AllTetrahedra(grid);
  const auto faces = FacesOf(all);
  Random random(32);
  for (int i = 0; i < 200; ++i)
  {
    const double x = random.Uniform(0.01, 4.99), y = random.Uniform(0.01, 4.99);
    const auto entry = std::find_if(faces.begin(), faces.end(), [&](const auto& face) {
      TetrahedronWalk<double> test;
      const auto at = [&](std::size_t k) {
        const Vector3 p = PlaceAt(grid, face.first[k]);
        return WalkVertex<double>{ p[0] - x, p[1] - y, p[2], 0 };
      };
      test.Start(at(0), at(1), at(2));
      const bool inside = EdgeFunction(test.A, test.B) > 0 && EdgeFunction(test.B, test.C) > 0 &&
        EdgeFunction(test.C, test.A) > 0;
      return face.second.size() == 1 && inside && test.A.Z == 0 && test.B.Z == 0 && test.C.Z == 0;
    });
    ASSERT_NE(entry, faces.end());
    TetrahedronWalk<float> walk;
    Face ids = entry->first;
    if (walk.Start(Seen(PlaceAt(grid, ids[0]), x, y), Seen(PlaceAt(grid, ids[1]), x, y),
          Seen(PlaceAt(grid, ids[2]), x, y)))
    {
      std::swap(ids[1], ids[2]);
    }
    std::int64_t tetrahedron = entry->second[0];
    float last = 0, z = 0, s = 0;
    int steps = 0;
    for (; tetrahedron >= 0 && steps < 100; ++steps)
    {
      const Ids& t = all[std::size_t(tetrahedron)];
      const auto ahead = std::find_if(t.begin(), t.end(),
        [&](std::int64_t v) { return std::find(ids.begin(), ids.end(), v) == ids.end(); });
      ids[std::size_t(walk.Step(Seen(PlaceAt(grid, *ahead), x, y)))] = *ahead;
      ASSERT_TRUE(walk.Pass(z, s));
      EXPECT_GE(z, last - 1e-5f);
      EXPECT_NEAR(s, Field({ x, y, z }), 1e-5);
      last = z;
      Face key = ids;
      std::sort(key.begin(), key.end());
      const auto& pair = faces.at(key);
      tetrahedron = pair.size() == 1 ? -1 : pair[0] == tetrahedron ? pair[1] : pair[0];
    }
    EXPECT_NEAR(z, 7, 1e-5);
    EXPECT_GE(steps, 7);
  }
}

// Within a face there is no side to pass on: the walk must say so.
TEST(TetrahedronWalk, IsLostWithinAFace)
{
  TetrahedronWalk<float> walk;
  walk.Start({ 0, -1, 0, 0 }, { 0, 1, 0, 0 }, { 0, 0, 3, 0 }); // the plane u = 0 holds the ray
  walk.Step({ 1, 0, 1, 0 });
  EXPECT_TRUE(walk.IsLost);
}

// A start at a face that the ray passes by is a wrong start, which must be said.
TEST(TetrahedronWalk, IsLostBesideTheFirstFace)
{
  TetrahedronWalk<float> walk;
  walk.Start({ -1, 0.001f, 0, 0 }, { 1, 0.001f, 0, 0 }, { 0, 1, 0, 0 });
  EXPECT_TRUE(walk.IsLost);
  walk.Start({ -1, -0.001f, 0, 0 }, { 1, -0.001f, 0, 0 }, { 0, 1, 0, 0 });
  EXPECT_FALSE(walk.IsLost);
}
