// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Convex cells cut into tetrahedra: they fill the cell once, and neighbours agree about their
// common face.
#include "CellDecomposition.h"

#include "TestRandom.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numeric>
#include <string>
#include <vector>

using namespace nephoscope;
using namespace nephoscope_test;

namespace
{
using Point = std::array<double, 3>;
using Tetrahedron = std::array<int, 4>;

struct Cell
{
  std::string Name;
  std::vector<Point> Points;
  std::vector<int> Faces; ///< size, vertices, size, vertices, ...
  double Volume;
};

template <std::size_t N>
std::vector<int> List(const int (&faces)[N])
{
  return std::vector<int>(faces, faces + N);
}

double SignedVolume(const Point& a, const Point& b, const Point& c, const Point& d)
{
  const double u[3] = { b[0] - a[0], b[1] - a[1], b[2] - a[2] };
  const double v[3] = { c[0] - a[0], c[1] - a[1], c[2] - a[2] };
  const double w[3] = { d[0] - a[0], d[1] - a[1], d[2] - a[2] };
  return ((u[1] * v[2] - u[2] * v[1]) * w[0] + (u[2] * v[0] - u[0] * v[2]) * w[1] +
           (u[0] * v[1] - u[1] * v[0]) * w[2]) /
    6;
}

/** A prism over a regular polygon of circumradius 1 and height 2, in VTK's numbering. */
std::vector<Point> PrismWithSides(int sides)
{
  std::vector<Point> points;
  for (int k = 0; k < 2 * sides; ++k)
  {
    const double angle = 2 * std::acos(-1.0) * (k % sides) / sides;
    points.push_back({ { std::cos(angle), std::sin(angle), k < sides ? -1.0 : 1.0 } });
  }
  return points;
}
double PrismVolume(int sides)
{
  return sides * std::sin(2 * std::acos(-1.0) / sides); // height 2
}

std::vector<Cell> MakeCells()
{
  const std::vector<Point> cube = { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 1, 1, 0 } },
    { { 0, 1, 0 } }, { { 0, 0, 1 } }, { { 1, 0, 1 } }, { { 1, 1, 1 } }, { { 0, 1, 1 } } };
  const std::vector<Point> voxel = { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } },
    { { 1, 1, 0 } }, { { 0, 0, 1 } }, { { 1, 0, 1 } }, { { 0, 1, 1 } }, { { 1, 1, 1 } } };
  const std::vector<Point> frustum = { { { -2, -2, 0 } }, { { 2, -2, 0 } }, { { 2, 2, 0 } },
    { { -2, 2, 0 } }, { { -1, -1, 1 } }, { { 1, -1, 1 } }, { { 1, 1, 1 } }, { { -1, 1, 1 } } };
  const std::vector<Point> pyramid = { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 1, 1, 0 } },
    { { 0, 1, 0 } }, { { 0.3, 0.6, 2 } } };
  const std::vector<Point> octahedron = { { { 1, 0, 0 } }, { { -1, 0, 0 } }, { { 0, 1, 0 } },
    { { 0, -1, 0 } }, { { 0, 0, 1 } }, { { 0, 0, -1 } } };
  const std::vector<int> octahedronFaces = { 3, 0, 2, 4, 3, 2, 1, 4, 3, 1, 3, 4, 3, 3, 0, 4, 3, 2,
    0, 5, 3, 1, 2, 5, 3, 3, 1, 5, 3, 0, 3, 5 };
  return {
    { "tetrahedron", { cube[0], cube[1], cube[3], cube[4] }, List(tetrahedronFaceList), 1.0 / 6 },
    { "hexahedron", cube, List(hexahedronFaceList), 1 },
    { "frustum", frustum, List(hexahedronFaceList), 28.0 / 3 },
    { "voxel", voxel, List(voxelFaceList), 1 },
    { "wedge", PrismWithSides(3), List(wedgeFaceList), PrismVolume(3) },
    { "pyramid", pyramid, List(pyramidFaceList), 2.0 / 3 },
    { "pentagonal prism", PrismWithSides(5), List(pentagonalPrismFaceList), PrismVolume(5) },
    { "hexagonal prism", PrismWithSides(6), List(hexagonalPrismFaceList), PrismVolume(6) },
    { "octahedron", octahedron, octahedronFaces, 4.0 / 3 },
  };
}

/** Tetrahedra of a cell whose vertices have these ranks in the order. */
std::vector<Tetrahedron> Decompose(const std::vector<int>& faces, const std::vector<int>& rank)
{
  std::vector<Tetrahedron> result;
  DecomposeCell(
    FaceList<int>{ faces.data(), faces.data() + faces.size() },
    [&](int a, int b) { return rank[std::size_t(a)] < rank[std::size_t(b)]; },
    [&](const Tetrahedron& t) { result.push_back(t); });
  return result;
}

double TotalVolume(const std::vector<Point>& p, const std::vector<Tetrahedron>& tetrahedra)
{
  double sum = 0;
  for (const Tetrahedron& t : tetrahedra)
  {
    sum += std::fabs(SignedVolume(
      p[std::size_t(t[0])], p[std::size_t(t[1])], p[std::size_t(t[2])], p[std::size_t(t[3])]));
  }
  return sum;
}

bool Contains(const std::vector<Point>& p, const Tetrahedron& t, const Point& x)
{
  std::array<Point, 4> v;
  std::transform(t.begin(), t.end(), v.begin(), [&](int i) { return p[std::size_t(i)]; });
  const double volume = SignedVolume(v[0], v[1], v[2], v[3]);
  for (std::size_t i = 0; i < 4; ++i)
  {
    std::array<Point, 4> w = v;
    w[i] = x;
    if (SignedVolume(w[0], w[1], w[2], w[3]) / volume <= 0)
    {
      return false;
    }
  }
  return true;
}

class DecomposedCell : public ::testing::TestWithParam<int>
{
protected:
  const Cell Subject = MakeCells()[std::size_t(this->GetParam())];
};

// ---- meshes of several cells --------------------------------------------------------------------

struct Mesh
{
  int NumberOfPoints = 0;
  std::vector<std::vector<int>> Cells; ///< face lists with the mesh's own vertices

  template <std::size_t N>
  void Add(const int (&faces)[N], const std::vector<int>& vertices)
  {
    std::vector<int> cell;
    for (std::size_t i = 0; i < N;)
    {
      const int size = faces[i++];
      cell.push_back(size);
      for (int k = 0; k < size; ++k)
      {
        cell.push_back(vertices[std::size_t(faces[i++])]);
      }
    }
    this->Cells.push_back(cell);
  }
};

template <typename Visit>
void ForEachFace(const std::vector<int>& faces, Visit visit)
{
  for (std::size_t i = 0; i < faces.size(); i += std::size_t(faces[i]) + 1)
  {
    visit(std::vector<int>(faces.begin() + long(i) + 1, faces.begin() + long(i) + 1 + faces[i]));
  }
}

/**
 * Counts of how often each triangle of the tetrahedra occurs, against what the polygons of the
 * cells promise.
 */
void ExpectMatchingFaces(const Mesh& mesh, const std::vector<int>& rank)
{
  std::map<std::vector<int>, int> polygons, triangles;
  for (const auto& cell : mesh.Cells)
  {
    ForEachFace(cell, [&](std::vector<int> face) {
      std::sort(face.begin(), face.end());
      ++polygons[face];
    });
    for (const Tetrahedron& t : Decompose(cell, rank))
    {
      for (int omitted = 0; omitted < 4; ++omitted)
      {
        std::vector<int> triangle;
        std::copy_if(t.begin(), t.end(), std::back_inserter(triangle),
          [&](int v) { return v != t[std::size_t(omitted)]; });
        std::sort(triangle.begin(), triangle.end());
        ++triangles[triangle];
      }
    }
  }
  int expectedBoundary = 0, boundary = 0;
  for (const auto& [face, uses] : polygons)
  {
    ASSERT_LE(uses, 2);
    expectedBoundary += uses == 1 ? int(face.size()) - 2 : 0;
  }
  for (const auto& [triangle, uses] : triangles)
  {
    ASSERT_LE(uses, 2);
    boundary += uses == 1;
  }
  EXPECT_EQ(boundary, expectedBoundary);
}

std::vector<int> RandomRanks(Random& random, int n)
{
  std::vector<int> rank(static_cast<std::size_t>(n));
  std::iota(rank.begin(), rank.end(), 0);
  std::shuffle(rank.begin(), rank.end(), random.GetEngine());
  return rank;
}

/**
 * n^3 hexahedra; some whole columns are cut into wedges, some single cells into six pyramids or
 * made polyhedra.
 */
Mesh MixedLattice(Random& random, int n, bool mixed)
{
  Mesh mesh;
  mesh.NumberOfPoints = (n + 1) * (n + 1) * (n + 1);
  const auto id = [n](int i, int j, int k) { return i + (n + 1) * (j + (n + 1) * k); };
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i < n; ++i)
    {
      const bool wedges = mixed && random.Integer(0, 2) == 0;
      for (int k = 0; k < n; ++k)
      {
        const std::vector<int> v = { id(i, j, k), id(i + 1, j, k), id(i + 1, j + 1, k),
          id(i, j + 1, k), id(i, j, k + 1), id(i + 1, j, k + 1), id(i + 1, j + 1, k + 1),
          id(i, j + 1, k + 1) };
        if (wedges)
        {
          mesh.Add(wedgeFaceList, { v[0], v[1], v[2], v[4], v[5], v[6] });
          mesh.Add(wedgeFaceList, { v[0], v[2], v[3], v[4], v[6], v[7] });
        }
        else if (mixed && random.Integer(0, 1) == 0)
        {
          const int center = mesh.NumberOfPoints++;
          ForEachFace(List(hexahedronFaceList), [&](const std::vector<int>& f) {
            mesh.Add(pyramidFaceList,
              { v[std::size_t(f[0])], v[std::size_t(f[1])], v[std::size_t(f[2])],
                v[std::size_t(f[3])], center });
          });
        }
        else if (mixed && random.Integer(0, 1) == 0)
        {
          mesh.Add(voxelFaceList, { v[0], v[1], v[3], v[2], v[4], v[5], v[7], v[6] });
        }
        else
        {
          mesh.Add(hexahedronFaceList, v);
        }
      }
    }
  }
  return mesh;
}

/**
 * Layers of a prism over a polygon with a ring around it: hexahedra, every second one cut into
 * wedges.
 */
template <std::size_t N>
Mesh PrismStack(const int (&prismFaces)[N], int sides, int layers)
{
  Mesh mesh;
  mesh.NumberOfPoints = 2 * sides * (layers + 1);
  const auto id = [sides](int ring, int k, int layer) {
    return 2 * sides * layer + sides * ring + k % sides;
  };
  for (int layer = 0; layer < layers; ++layer)
  {
    std::vector<int> core;
    for (int k = 0; k < 2 * sides; ++k)
    {
      core.push_back(id(0, k, layer + k / sides));
    }
    mesh.Add(prismFaces, core);
    for (int k = 0; k < sides; ++k)
    {
      const std::vector<int> v = { id(0, k, layer), id(1, k, layer), id(1, k + 1, layer),
        id(0, k + 1, layer), id(0, k, layer + 1), id(1, k, layer + 1), id(1, k + 1, layer + 1),
        id(0, k + 1, layer + 1) };
      if (k % 2)
      {
        mesh.Add(wedgeFaceList, { v[0], v[1], v[2], v[4], v[5], v[6] });
        mesh.Add(wedgeFaceList, { v[0], v[2], v[3], v[4], v[6], v[7] });
      }
      else
      {
        mesh.Add(hexahedronFaceList, v);
      }
    }
  }
  return mesh;
}
}

TEST_P(DecomposedCell, EveryOrderFillsTheCell)
{
  Random random(31);
  const int n = int(this->Subject.Points.size());
  std::vector<int> rank(static_cast<std::size_t>(n));
  std::iota(rank.begin(), rank.end(), 0);
  const bool all = n <= 6; // 720 orders; random ones of more vertices
  for (int i = 0; i < 2000; ++i)
  {
    ASSERT_NEAR(TotalVolume(this->Subject.Points, Decompose(this->Subject.Faces, rank)),
      this->Subject.Volume, 1e-12)
      << this->Subject.Name;
    if (!all)
    {
      rank = RandomRanks(random, n);
    }
    else if (!std::next_permutation(rank.begin(), rank.end()))
    {
      break;
    }
  }
}

TEST_P(DecomposedCell, NothingOverlaps)
{
  Random random(32);
  const auto& p = this->Subject.Points;
  for (int i = 0; i < 2000; ++i)
  {
    const std::vector<Tetrahedron> tetrahedra =
      Decompose(this->Subject.Faces, RandomRanks(random, int(p.size())));
    Point x = { { 0, 0, 0 } }; // random convex combination of the vertices
    double sum = 0;
    for (const Point& v : p)
    {
      const double w = random.Uniform();
      sum += w;
      x = { { x[0] + w * v[0], x[1] + w * v[1], x[2] + w * v[2] } };
    }
    x = { { x[0] / sum, x[1] / sum, x[2] / sum } };
    const auto holding = std::count_if(tetrahedra.begin(), tetrahedra.end(),
      [&](const Tetrahedron& t) { return Contains(p, t, x); });
    ASSERT_EQ(holding, 1) << this->Subject.Name;
  }
}
INSTANTIATE_TEST_SUITE_P(CellDecomposition, DecomposedCell, ::testing::Range(0, 9));

// Coned from a vertex, a cell gives as many tetrahedra as there are triangles on the faces without
// it, whichever vertex.
TEST(CellDecomposition, NumbersOfTetrahedra)
{
  Random random(33);
  const std::size_t expected[] = { 1, 6, 6, 6, 3, 2, 9, 12, 4 };
  const std::vector<Cell> cells = MakeCells();
  for (std::size_t c = 0; c < cells.size(); ++c)
  {
    for (int i = 0; i < 200; ++i)
    {
      const std::vector<int> rank = RandomRanks(random, int(cells[c].Points.size()));
      ASSERT_EQ(Decompose(cells[c].Faces, rank).size(), expected[c]) << cells[c].Name;
    }
  }
}

TEST(CellDecomposition, EmptyFaceList)
{
  EXPECT_TRUE(Decompose({}, {}).empty());
}

TEST(CellDecomposition, VerticesMayBeAnyNumbers)
{
  // As a polyhedron's face stream names them.
  const long long faces[] = { 4, 900, 7, 33, 12, 3, 900, 7, 5, 3, 7, 33, 5, 3, 33, 12, 5, 3, 12,
    900, 5 };
  std::vector<std::array<long long, 4>> tetrahedra;
  DecomposeCell(FaceList<long long>{ faces, faces + sizeof(faces) / sizeof(faces[0]) },
    std::less<long long>(), [&](const std::array<long long, 4>& t) { tetrahedra.push_back(t); });
  ASSERT_EQ(tetrahedra.size(), 2u);
  EXPECT_EQ(tetrahedra[0][0], 5); // the apex is the least vertex
  EXPECT_EQ(tetrahedra[0][1], 7); // the base is a fan from its own least one
  EXPECT_EQ(tetrahedra[1][1], 7);
}

TEST(CellDecomposition, HexahedraAgreeAboutTheirFaces)
{
  Random random(34);
  for (int i = 0; i < 20; ++i)
  {
    const Mesh mesh = MixedLattice(random, 4, false);
    ExpectMatchingFaces(mesh, RandomRanks(random, mesh.NumberOfPoints));
  }
}

TEST(CellDecomposition, MixedCellsAgreeAboutTheirFaces)
{
  Random random(35);
  for (int i = 0; i < 20; ++i)
  {
    const Mesh mesh = MixedLattice(random, 4, true);
    ExpectMatchingFaces(mesh, RandomRanks(random, mesh.NumberOfPoints));
  }
}

TEST(CellDecomposition, PrismsAgreeAboutTheirFaces)
{
  Random random(36);
  for (int i = 0; i < 20; ++i)
  {
    const Mesh five = PrismStack(pentagonalPrismFaceList, 5, 3);
    ExpectMatchingFaces(five, RandomRanks(random, five.NumberOfPoints));
    const Mesh six = PrismStack(hexagonalPrismFaceList, 6, 3);
    ExpectMatchingFaces(six, RandomRanks(random, six.NumberOfPoints));
  }
}
