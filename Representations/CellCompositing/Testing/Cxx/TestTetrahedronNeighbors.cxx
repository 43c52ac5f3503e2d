// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Where rays enter meshes whose points coincide to within rounding, and where they go on when
// values jump.
#include "TetrahedronNeighbors.h"

#include "BoundaryFaces.h"
#include "FaceNeighbors.h"
#include "OrderMeshes.h"

#include "vtkAppendFilter.h"
#include "vtkDataSetTriangleFilter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <set>
#include <utility>

using namespace nephoscope;
using namespace nephoscope_test;

namespace
{
constexpr int longitudes = 24, latitudes = 12, levels = 3;

/**
 * A globe from pole to pole and around, its first and last longitude at one place but for the
 * rounding of `Real`.
 */
template <typename Real>
vtkSmartPointer<vtkUnstructuredGrid> MakeGlobe(bool asTetrahedra)
{
  auto grid = MakeStructuredGrid(
    longitudes, latitudes, levels, [](double i, double j, double k, double x[3]) {
      const Real pi = static_cast<Real>(std::acos(-1.0));
      const Real longitude = 2 * pi * Real(i) / longitudes,
                 latitude = pi * (Real(j) / latitudes - Real(0.5));
      const Real radius = Real(6371000) * (1 + Real(0.04) * Real(k));
      x[0] = radius * std::cos(latitude) * std::cos(longitude);
      x[1] = radius * std::cos(latitude) * std::sin(longitude);
      x[2] = radius * std::sin(latitude);
    });
  if (asTetrahedra)
  {
    vtkNew<vtkDataSetTriangleFilter> filter;
    filter->SetInputData(grid);
    filter->Update();
    return filter->GetOutput();
  }
  vtkNew<vtkAppendFilter> filter;
  filter->AddInputData(grid);
  filter->Update();
  return vtkUnstructuredGrid::SafeDownCast(filter->GetOutput());
}

/** Geometry with values that depend on the place only, or those given. */
CellGeometry GeometryOf(
  vtkDataSet* data, const std::function<double(vtkIdType, const double*)>& value)
{
  vtkNew<vtkDoubleArray> values;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double x[3];
    data->GetPoint(i, x);
    values->InsertNextValue(value(i, x));
  }
  CellGeometry geometry;
  EXPECT_EQ(geometry.Build(data, { values, false, -1 }), "");
  return geometry;
}

TetrahedronNeighbors NeighborsOf(const CellGeometry& geometry)
{
  FaceNeighbors connected;
  EXPECT_TRUE(connected.Connect(geometry));
  TetrahedronNeighbors neighbors;
  neighbors.Build(geometry, connected);
  return neighbors;
}

std::size_t CountMerged(const TetrahedronNeighbors& neighbors, std::int64_t points)
{
  std::set<std::int32_t> merged;
  for (std::int64_t i = 0; i < points; ++i)
  {
    merged.insert(neighbors.Merged(i));
  }
  return merged.size();
}

std::size_t NumberOfEntries(const TetrahedronNeighbors& neighbors)
{
  return neighbors.BoundaryFaces.size() - neighbors.NumberOfJumps;
}

double Same(vtkIdType, const double*)
{
  return 1;
}

/**
 * Two boxes of 2 x 2 x 2 cells with points of their own, the second one beyond the plane x = 1 by
 * `gap`.
 */
vtkSmartPointer<vtkUnstructuredGrid> TwoBoxes(double gap, double scale = 1)
{
  BlockMesh mesh;
  const int n[3] = { 2, 2, 2 };
  for (int part = 0; part < 2; ++part)
  {
    mesh.AddBox(
      n, [](int, int, int) { return false; },
      [&](double x, double y, double z) {
        return std::array<double, 3>{ { scale * (x + part * (1 + gap)), scale * y, scale * z } };
      });
  }
  return mesh.Get();
}

constexpr std::size_t outerFaces = 10 * 4 * 2, innerFaces = 2 * 4 * 2; // of two boxes
}

TEST(TetrahedronNeighbors, AGlobeIsEnteredFromAboveAndBelowAlone)
{
  // Triangles of one sphere; cells at a pole have one there and not two.
  const std::size_t sphere = 2 * longitudes * (latitudes - 2) + 2 * longitudes;
  for (const bool asTetrahedra : { false, true })
  {
    for (const bool inFloat : { false, true })
    {
      SCOPED_TRACE(testing::Message()
        << (asTetrahedra ? "tetrahedra" : "hexahedra") << (inFloat ? " in float" : " in double"));
      const auto data = inFloat ? MakeGlobe<float>(asTetrahedra) : MakeGlobe<double>(asTetrahedra);
      const TetrahedronNeighbors neighbors = NeighborsOf(GeometryOf(data, Same));
      EXPECT_EQ(NumberOfEntries(neighbors), 2 * sphere);
      EXPECT_EQ(neighbors.NumberOfJumps, 0u);
    }
  }
}

TEST(TetrahedronNeighbors, PointsWithinRoundingAreOnePlace)
{
  const double unit = std::numeric_limits<float>::epsilon();
  for (const double scale : { 1e-3, 1.0, 6.4e6 })
  {
    EXPECT_EQ(NumberOfEntries(NeighborsOf(GeometryOf(TwoBoxes(0, scale), Same))), outerFaces);
    EXPECT_EQ(NumberOfEntries(NeighborsOf(GeometryOf(TwoBoxes(unit, scale), Same))), outerFaces);
    EXPECT_EQ(NumberOfEntries(NeighborsOf(GeometryOf(TwoBoxes(64 * unit, scale), Same))),
      outerFaces + innerFaces);
  }
}

TEST(TetrahedronNeighbors, RoundingOfRotatedBlocksIsWelded)
{
  Random random(5);
  for (int trial = 0; trial < 20; ++trial)
  {
    const auto data = TwoBoxes(0);
    const auto axis = random.Direction();
    const double angle = random.Uniform(0, 6), c = std::cos(angle), s = std::sin(angle);
    for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
    {
      double x[3], turned[3];
      data->GetPoint(i, x);
      const double along = (1 - c) * (axis[0] * x[0] + axis[1] * x[1] + axis[2] * x[2]);
      for (int k = 0; k < 3; ++k)
      {
        const int l = (k + 1) % 3, m = (k + 2) % 3;
        const double rounding = 1 + 5e-8 * random.Uniform(-1, 1);
        turned[k] = rounding * (c * x[k] + s * (axis[l] * x[m] - axis[m] * x[l]) + along * axis[k]);
      }
      data->GetPoints()->SetPoint(i, turned);
    }
    const TetrahedronNeighbors neighbors = NeighborsOf(GeometryOf(data, Same));
    EXPECT_EQ(CountMerged(neighbors, data->GetNumberOfPoints()), 2 * 27u - 9u) << trial;
  }
}

TEST(TetrahedronNeighbors, ThinLayersKeepTheirExtent)
{
  // Layers thinner than the rounding of the largest coordinate, in the plane where float resolves
  // them.
  const double thickness = 0.2 * std::numeric_limits<float>::epsilon();
  BlockMesh mesh;
  mesh.AddBox(2, 2, 5, { { -1, -1, 0 } }, { { 1, 1, 5 * thickness } });
  const CellGeometry geometry = GeometryOf(mesh.Get(), Same);
  const TetrahedronNeighbors neighbors = NeighborsOf(geometry);
  EXPECT_EQ(CountMerged(neighbors, mesh.Get()->GetNumberOfPoints()), geometry.Points.size());
  const auto facing = [&](const BoundaryFace& f) {
    const Vector3 a = geometry.Position(f[0]);
    return Cross(Difference(geometry.Position(f[1]), a),
             Difference(geometry.Position(f[2]), a))[2] != 0;
  };
  EXPECT_EQ(std::count_if(neighbors.BoundaryFaces.begin(), neighbors.BoundaryFaces.end(), facing),
    2 * 4 * 2);
}

TEST(TetrahedronNeighbors, RaysGoOnWhereValuesJump)
{
  const auto data = TwoBoxes(0);
  const vtkIdType half = data->GetNumberOfPoints() / 2;
  const CellGeometry geometry =
    GeometryOf(data, [half](vtkIdType i, const double* x) { return x[1] + (i < half ? 0 : 5); });
  const TetrahedronNeighbors neighbors = NeighborsOf(geometry);
  ASSERT_EQ(neighbors.NumberOfJumps, innerFaces);
  EXPECT_EQ(NumberOfEntries(neighbors), outerFaces);
  std::set<std::size_t> reached;
  for (std::size_t i = 0; i < geometry.Tetrahedra.size(); ++i)
  {
    for (std::size_t k = 0; k < 4; ++k)
    {
      const std::int32_t stored = neighbors.Neighbors[4 * i + k];
      if (stored > TetrahedronNeighbors::Jump)
      {
        continue;
      }
      const std::size_t first = static_cast<std::size_t>(TetrahedronNeighbors::Jump - stored);
      ASSERT_GE(first, NumberOfEntries(neighbors));
      ASSERT_LT(first + 1, neighbors.BoundaryFaces.size());
      const BoundaryFace& across = neighbors.FaceAcross(stored, static_cast<std::int32_t>(i));
      const std::size_t number = static_cast<std::size_t>(&across - neighbors.BoundaryFaces.data());
      reached.insert(number);
      // The face of the other side: the three vertices of this tetrahedron but the k-th, at their
      // places.
      Tetrahedron t = geometry.Tetrahedra[i];
      std::transform(
        t.begin(), t.end(), t.begin(), [&](std::int32_t p) { return neighbors.Merged(p); });
      std::sort(t.begin(), t.end());
      std::set<Vector3> own, other;
      for (std::size_t v = 0; v < 3; ++v)
      {
        own.insert(geometry.Position(t[(k + 1 + v) % 4]));
        other.insert(geometry.Position(across[v]));
      }
      EXPECT_EQ(own, other);
      EXPECT_NE(across[3] < static_cast<std::int32_t>(geometry.Tetrahedra.size() / 2),
        i < geometry.Tetrahedra.size() / 2);
    }
  }
  EXPECT_EQ(reached.size(), innerFaces);
}

TEST(TetrahedronNeighbors, OneNeighborAndTheLinksGiveAll)
{
  const auto jumping = TwoBoxes(0);
  const vtkIdType half = jumping->GetNumberOfPoints() / 2;
  BlockMesh folded; // the second box lies within the first, and shares a face with it
  folded.AddBox(1, 1, 1, { { 0, 0, 0 } }, { { 1, 1, 1 } });
  folded.AddBox(1, 1, 1, { { 0, 0, 0 } }, { { 1, 1, 0.5 } });
  BlockMesh copies; // three and four tetrahedra at one face
  for (int copy = 0; copy < 4; ++copy)
  {
    copies.AddBox(1, 1, 1, { { 0, 0, 0 } }, { { 1, 1, 1 } });
  }
  const auto jumps = [half](vtkIdType i, const double* x) { return x[1] + (i < half ? 0 : 5); };
  for (const CellGeometry& geometry :
    { GeometryOf(MakeGlobe<float>(true), Same), GeometryOf(MakeGlobe<double>(false), Same),
      GeometryOf(jumping, Same), GeometryOf(jumping, jumps), GeometryOf(folded.Get(), Same),
      GeometryOf(copies.Get(), Same) })
  {
    const TetrahedronNeighbors neighbors = NeighborsOf(geometry);
    const auto links = neighbors.Links(geometry);
    TetrahedronNeighbors released = neighbors;
    released.ReleaseNeighbors();
    EXPECT_TRUE(released.Neighbors.empty() && released.VertexSums.empty());
    std::vector<std::size_t> all(links.size());
    std::iota(all.begin(), all.end(), 0);
    const auto found = released.FindOneNeighbor(geometry, all);
    for (std::size_t i = 0; i < links.size(); ++i)
    {
      const std::int32_t* n = &neighbors.Neighbors[4 * i];
      const std::array<std::int32_t, 2>& known = found[i];
      ASSERT_EQ(known, released.FindOneNeighbor(geometry, { i })[0]);
      ASSERT_EQ(known[0] >> 2, n[known[1]]) << "of tetrahedron " << i;
      const auto linkOf = [&](int rank) { return rank < 3 ? links[i][std::size_t(rank) + 1] : 0; };
      const std::int32_t last = known[0] ^ linkOf(known[1]);
      for (int rank = 0; rank < 4; ++rank)
      {
        const std::int32_t link = last ^ linkOf(rank);
        ASSERT_EQ(link >> 2, n[rank]) << "of tetrahedron " << i;
        // The rank of the vertex behind the face is where the neighbour has this tetrahedron.
        ASSERT_TRUE(
          n[rank] < 0 || neighbors.Neighbors[4 * std::size_t(n[rank]) + (link & 3)] == int(i));
      }
    }
  }
}

TEST(TetrahedronNeighbors, NeighborsKnowEachOther)
{
  // Any tetrahedra between points of which some differ by rounding: slivers, folds and copies.
  Random random(8);
  for (int trial = 0; trial < 50; ++trial)
  {
    std::vector<std::array<double, 3>> points;
    for (int i = 0; i < 6; ++i)
    {
      const auto p = random.Direction();
      const double rounding = std::numeric_limits<float>::epsilon();
      points.push_back({ { p[0], p[1], p[2] } });
      points.push_back({ { p[0] + rounding, p[1] - rounding, p[2] } });
    }
    std::vector<std::pair<int, std::vector<vtkIdType>>> cells;
    for (int i = 0; i < 60; ++i)
    {
      std::set<vtkIdType> ids;
      while (ids.size() < 4)
      {
        ids.insert(static_cast<vtkIdType>(random.Uniform(0, double(points.size()))));
      }
      cells.push_back({ VTK_TETRA, { ids.begin(), ids.end() } });
    }
    const auto value = [trial](vtkIdType i, const double*) { return double(i % (1 + trial % 2)); };
    const CellGeometry geometry = GeometryOf(MakeGrid(points, cells), value);
    const TetrahedronNeighbors neighbors = NeighborsOf(geometry);
    const auto& n = neighbors.Neighbors;
    const auto links = neighbors.Links(geometry);
    std::vector<std::size_t> all(links.size());
    std::iota(all.begin(), all.end(), 0);
    const auto known = neighbors.FindOneNeighbor(geometry, all);
    for (std::size_t i = 0; i < all.size(); ++i)
    {
      const auto linkOf = [&](int rank) { return rank < 3 ? links[i][std::size_t(rank) + 1] : 0; };
      for (int rank = 0; rank < 4; ++rank)
      {
        const std::int32_t link = known[i][0] ^ linkOf(known[i][1]) ^ linkOf(rank);
        ASSERT_EQ(link >> 2, n[4 * i + std::size_t(rank)]);
        ASSERT_TRUE(link < 0 || n[std::size_t(link)] == std::int32_t(i));
      }
    }
  }
}

TEST(TetrahedronNeighbors, EqualValuesMeetWhereTheFirstDiffers)
{
  // Three tetrahedra around an edge, each with points of its own: the first has other values than
  // the two that share theirs.
  BlockMesh mesh;
  for (int part = 0; part < 3; ++part)
  {
    mesh.AddBox(1, 1, 1, { { double(part), 0, 0 } }, { { part + 1.0, 1, 1 } });
  }
  const auto value = [](vtkIdType i, const double*) { return i < 8 ? 0.0 : 1.0; };
  const TetrahedronNeighbors neighbors = NeighborsOf(GeometryOf(mesh.Get(), value));
  EXPECT_EQ(NumberOfEntries(neighbors), 14u * 2);
  EXPECT_EQ(neighbors.NumberOfJumps, 2u * 2);
}
