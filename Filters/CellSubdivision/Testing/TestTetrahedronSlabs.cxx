// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Contour levels, and tetrahedra divided at them: every arrangement of five vertices among three
// values.
#include "CutTable.h"
#include "TetrahedronSlabs.h"

#include "TestRandom.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <vector>

using namespace nephoscope;
using namespace nephoscope_test;

namespace
{
using Point = std::array<double, 3>;
using Face = std::vector<int>;
using Layered = std::pair<Piece<int>, int>;

const std::vector<double> values = { 1, 2, 3 };

double SignedVolume(const Point& a, const Point& b, const Point& c, const Point& d)
{
  const double u[3] = { b[0] - a[0], b[1] - a[1], b[2] - a[2] };
  const double v[3] = { c[0] - a[0], c[1] - a[1], c[2] - a[2] };
  const double w[3] = { d[0] - a[0], d[1] - a[1], d[2] - a[2] };
  return (w[0] * (u[1] * v[2] - u[2] * v[1]) + w[1] * (u[2] * v[0] - u[0] * v[2]) +
           w[2] * (u[0] * v[1] - u[1] * v[0])) /
    6;
}

// As VTK documents them, seen from outside counter-clockwise.
std::vector<Face> FacesOf(const Piece<int>& piece)
{
  std::vector<Face> faces;
  switch (piece.Shape)
  {
    case PieceShape::Tetrahedron:
      faces = { { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 }, { 0, 2, 1 } };
      break;
    case PieceShape::Pyramid:
      faces = { { 0, 3, 2, 1 }, { 0, 1, 4 }, { 1, 2, 4 }, { 2, 3, 4 }, { 3, 0, 4 } };
      break;
    case PieceShape::Wedge:
      faces = { { 0, 1, 2 }, { 3, 5, 4 }, { 0, 3, 4, 1 }, { 1, 4, 5, 2 }, { 2, 5, 3, 0 } };
      break;
    case PieceShape::Hexahedron:
      faces = { { 0, 4, 7, 3 }, { 1, 2, 6, 5 }, { 0, 1, 5, 4 }, { 3, 7, 6, 2 }, { 0, 3, 2, 1 },
        { 4, 5, 6, 7 } };
      break;
    default:
      ADD_FAILURE() << "not a 3-D piece";
  }
  for (Face& face : faces)
  {
    for (int& corner : face)
    {
      corner = piece.Corners[corner];
    }
  }
  return faces;
}

// Vertices of one mesh, with what is cut out of it.
struct Mesh
{
  std::vector<Point> Points;
  std::vector<double> Scalars;
  CutTable<int> Cuts;
  std::vector<Layered> Pieces;
  std::vector<Layered> Surfaces;
  ContourLevels Levels{ values };

  int makeCut(int a, int b, int level)
  {
    const int first = 100;
    const std::size_t number = this->Cuts.Number({ std::min(a, b), std::max(a, b), level });
    if (first + number >= this->Points.size())
    {
      this->Points.resize(first + number + 1);
      this->Scalars.resize(first + number + 1);
      const double t =
        (this->Levels.Value(level) - this->Scalars[a]) / (this->Scalars[b] - this->Scalars[a]);
      EXPECT_TRUE(t > 0 && t < 1) << "no cut on this edge";
      for (int i = 0; i < 3; ++i)
      {
        this->Points.back()[i] = (1 - t) * this->Points[a][i] + t * this->Points[b][i];
      }
      this->Scalars.back() = this->Levels.Value(level);
    }
    return first + static_cast<int>(number);
  }

  void split(std::array<int, 4> v)
  {
    std::sort(
      v.begin(), v.end(), [this](int a, int b) { return this->Scalars[a] < this->Scalars[b]; });
    std::array<int, 4> codes;
    std::transform(v.begin(), v.end(), codes.begin(),
      [this](int a) { return this->Levels.Code(this->Scalars[a]); });
    const bool mirrored = SignedVolume(this->Points[v[0]], this->Points[v[1]], this->Points[v[2]],
                            this->Points[v[3]]) < 0;
    const auto cut = [&](int i, int j, int level) { return this->makeCut(v[i], v[j], level); };
    TetrahedronSplitter<int, decltype(cut)> splitter(v, codes, mirrored, cut);
    splitter.Split([this](const Piece<int>& p, int layer) { this->Pieces.emplace_back(p, layer); },
      [this](const Piece<int>& p, int level) { this->Surfaces.emplace_back(p, level); });
  }

  double volume(const Piece<int>& piece) const
  {
    const Point& origin = this->Points[piece.Corners[0]];
    double sum = 0;
    for (const Face& f : FacesOf(piece))
    {
      for (std::size_t k = 1; k + 1 < f.size(); ++k)
      {
        sum += SignedVolume(origin, this->Points[f[0]], this->Points[f[k]], this->Points[f[k + 1]]);
      }
    }
    return sum;
  }
};

// Two tetrahedra on the two sides of the triangle 0 1 2.
Mesh MakePair(Random& random, const std::vector<double>& scalars)
{
  Mesh mesh;
  mesh.Points.resize(100);
  mesh.Scalars.resize(100);
  const Point corners[5] = { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0.2, 0.3, 1 } },
    { { 0.3, 0.2, -1 } } };
  for (int i = 0; i < 5; ++i)
  {
    mesh.Points[i] = corners[i];
    for (double& x : mesh.Points[i])
    {
      x += random.Uniform(-0.1, 0.1);
    }
    mesh.Scalars[i] = scalars[i];
  }
  return mesh;
}

void CheckFaces(const Mesh& mesh)
{
  std::map<std::set<int>, int> count;
  for (const Layered& piece : mesh.Pieces)
  {
    for (const Face& face : FacesOf(piece.first))
    {
      std::set<int> key(face.begin(), face.end());
      ASSERT_EQ(key.size(), face.size()) << "a face with a corner twice";
      ASSERT_LE(++count[key], 2) << "a face of three pieces";
    }
  }
  // What belongs to one piece only is on the outside: not in the plane of 0 1 2.
  const Point* p = mesh.Points.data();
  for (const auto& [key, times] : count)
  {
    double farthest = 0;
    for (int corner : key)
    {
      farthest = std::max(farthest, std::abs(SignedVolume(p[0], p[1], p[2], p[corner])));
    }
    if (farthest < 1e-12)
    {
      ASSERT_EQ(times, 2) << "the two tetrahedra divide their common face differently";
    }
  }
}

void CheckPieces(const Mesh& mesh, double expected)
{
  double sum = 0;
  for (const auto& [piece, layer] : mesh.Pieces)
  {
    const double size = mesh.volume(piece);
    ASSERT_GT(size, 0) << "inverted or flat";
    sum += size;
    for (int i = 0; i < NumberOfCorners(piece.Shape); ++i)
    {
      const double s = mesh.Scalars[piece.Corners[i]];
      ASSERT_TRUE(layer == 0 || s >= values[layer - 1]);
      ASSERT_TRUE(layer == static_cast<int>(values.size()) || s <= values[layer]);
    }
  }
  ASSERT_NEAR(sum, expected, 1e-14);
}

void CheckSurfaces(const Mesh& mesh)
{
  std::map<std::set<int>, std::set<int>> layersOfFace;
  for (const auto& [piece, layer] : mesh.Pieces)
  {
    for (const Face& face : FacesOf(piece))
    {
      layersOfFace[std::set<int>(face.begin(), face.end())].insert(layer);
    }
  }
  for (const auto& [polygon, level] : mesh.Surfaces)
  {
    const std::set<int> key(
      polygon.Corners.begin(), polygon.Corners.begin() + NumberOfCorners(polygon.Shape));
    ASSERT_EQ(layersOfFace[key], std::set<int>({ level, level + 1 }))
      << "a polygon that parts no layers";
  }
}
}

TEST(TetrahedronSlabs, EveryArrangementOfTwoTetrahedra)
{
  Random random(7);
  const double choices[7] = { 0.4, 1, 1.5, 2, 2.6, 3, 3.7 };
  for (int number = 0; number < 7 * 7 * 7 * 7 * 7; ++number)
  {
    std::vector<double> scalars;
    for (int i = 0, rest = number; i < 5; ++i, rest /= 7)
    {
      const double s = choices[rest % 7];
      scalars.push_back(s == std::floor(s) ? s : s + random.Uniform(-0.3, 0.3));
    }
    SCOPED_TRACE("arrangement " + std::to_string(number));
    Mesh mesh = MakePair(random, scalars);
    mesh.split({ { 0, 1, 2, 3 } });
    mesh.split({ { 2, 1, 0, 4 } });
    const Point* p = mesh.Points.data();
    CheckPieces(mesh, SignedVolume(p[0], p[1], p[2], p[3]) - SignedVolume(p[0], p[1], p[2], p[4]));
    CheckFaces(mesh);
    CheckSurfaces(mesh);
    if (HasFatalFailure())
    {
      return;
    }
  }
}

TEST(TetrahedronSlabs, FewPieces)
{
  Random random(8);
  const auto count = [&](std::vector<double> scalars) {
    scalars.push_back(0);
    Mesh mesh = MakePair(random, scalars);
    mesh.split({ { 0, 1, 2, 3 } });
    return mesh.Pieces.size();
  };
  EXPECT_EQ(count({ 0, 0.1, 0.2, 0.3 }), 1u);
  EXPECT_EQ(count({ 0, 1.1, 1.2, 1.3 }), 2u); // a tetrahedron and a wedge
  EXPECT_EQ(count({ 0, 0.1, 1.2, 1.3 }), 2u); // two wedges
  EXPECT_EQ(count({ 0, 0.1, 3.2, 3.3 }), 4u); // two hexahedra between two wedges
  EXPECT_EQ(count({ 0, 1.5, 2.5, 3.5 }), 1u + 3u + 3u + 1u);
  EXPECT_EQ(count({ 1, 1, 1, 1 }), 1u); // all of it on a value
}

TEST(ContourLevels, CodesAndLayers)
{
  const ContourLevels levels({ 3, 1, 2, 1, 2 * (1 + 1e-14) });
  ASSERT_EQ(levels.Size(), 3);
  const int indices[] = { levels.Index(0), levels.Index(1), levels.Index(2) };
  EXPECT_EQ(indices[0], 1);
  EXPECT_EQ(indices[1], 2);
  EXPECT_EQ(indices[2], 0);
  const double scalars[] = { -5, 1, 1.5, 2, 2.5, 3, 9 };
  for (int i = 0; i < 7; ++i)
  {
    EXPECT_EQ(levels.Code(scalars[i]), i);
  }
  EXPECT_EQ(levels.Code(std::nan("")), ContourLevels::MissingCode);
  EXPECT_EQ(levels.Code(-INFINITY), ContourLevels::MissingCode);
  EXPECT_TRUE(IsCrossed(0, 2));
  EXPECT_FALSE(IsCrossed(1, 2));
  EXPECT_FALSE(IsCrossed(0, 1));
  EXPECT_FALSE(IsCrossed(1, 1));
  EXPECT_TRUE(IsCrossed(1, 4));
  EXPECT_EQ(levels.Nearest(-7), 0);
  EXPECT_EQ(levels.Nearest(1.6), 1);
  EXPECT_EQ(levels.Nearest(99), 2);
  EXPECT_EQ(ContourLevels().Nearest(0), -1);
  EXPECT_EQ(ContourLevels().Code(0), 0);
}

TEST(CutTable, NumbersAndForgets)
{
  CutTable<long long> table;
  std::map<std::array<long long, 3>, std::size_t> expected;
  Random random(9);
  for (int round = 0; round < 2; ++round)
  {
    expected.clear();
    for (int i = 0; i < 20000; ++i)
    {
      const Cut<long long> cut{ random.Integer(0, 60), random.Integer(61, 140),
        random.Integer(0, 3) };
      const auto inserted = expected.emplace(
        std::array<long long, 3>{ { cut.First, cut.Second, cut.Level } }, expected.size());
      ASSERT_EQ(table.Number(cut), inserted.first->second);
    }
    ASSERT_EQ(table.TakeCuts().size(), expected.size());
  }
}
