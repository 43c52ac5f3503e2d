// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Back-to-front orders of projection: every face relation holds unless there are cycles, which are
// counted; nothing depends on threads or numbering.
#include "ProjectionOrder.h"

#include "FaceRelations.h"
#include "OrderMeshes.h"
#include "TestRandom.h"
#include "ThreadScope.h"

#include "vtkAppendFilter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>

using namespace nephoscope;
using namespace nephoscope_test;

namespace
{
Vector4 EyeAt(const CellGeometry& geometry, double x, double y, double z)
{
  return { { x - geometry.Center[0], y - geometry.Center[1], z - geometry.Center[2], 1 } };
}

using Kind = ProjectionOrder::Kind;

std::vector<std::int32_t> Sorted(
  Kind kind, const CellGeometry& geometry, const FaceNeighbors& neighbors, const Vector4& eye)
{
  ProjectionOrder order;
  EXPECT_TRUE(order.Sort(kind, geometry, neighbors, eye));
  EXPECT_EQ(order.NumberOfCycles, 0);
  EXPECT_EQ(order.NumberOfCyclicTetrahedra, 0);
  EXPECT_EQ(order.NumberOfBrokenRelations, 0);
  return order.Tetrahedra;
}

std::size_t CountInteriorFaces(const CellGeometry& geometry, const FaceNeighbors& neighbors)
{
  std::size_t count = 0;
  for (std::size_t i = 0; i < geometry.Tetrahedra.size(); ++i)
  {
    for (int face = 0; face < 4; ++face)
    {
      count += neighbors.Get(i, face) != FaceNeighbors::None;
    }
  }
  return count / 2;
}

bool IsPermutation(const std::vector<std::int32_t>& order, std::size_t n)
{
  std::vector<std::int32_t> sorted = order;
  std::sort(sorted.begin(), sorted.end());
  std::vector<std::int32_t> expected(n);
  std::iota(expected.begin(), expected.end(), 0);
  return sorted == expected;
}

/**
 * Sorts exactly and checks everything; returns the share of faces that centroids put in the wrong
 * order.
 */
double CheckExactOrder(const CellGeometry& geometry, const std::vector<InteriorFace>& faces,
  const FaceNeighbors& neighbors, const Vector4& eye)
{
  const std::vector<Relation> relations = FindRelations(faces, eye);
  std::vector<std::int32_t> order = Sorted(Kind::Topological, geometry, neighbors, eye);
  EXPECT_TRUE(IsPermutation(order, geometry.Tetrahedra.size()));
  EXPECT_EQ(CountViolations(relations, order), 0);
  order = Sorted(Kind::Centroid, geometry, neighbors, eye);
  EXPECT_TRUE(IsPermutation(order, geometry.Tetrahedra.size()));
  return double(CountViolations(relations, order)) / double(faces.size());
}

void CheckManyEyes(vtkDataSet* data, Random& random, double size, int eyes)
{
  const CellGeometry geometry = BuildGeometry(data);
  FaceNeighbors neighbors;
  neighbors.Connect(geometry);
  const std::vector<InteriorFace> faces = FindInteriorFaces(geometry);
  EXPECT_EQ(CountInteriorFaces(geometry, neighbors), faces.size());
  for (int i = 0; i < eyes; ++i)
  {
    const Vector3 d = random.Direction();
    const double distance = size * (i % 4 == 0 ? 0.3 : random.LogUniform(1, 50)); // inside too
    CheckExactOrder(
      geometry, faces, neighbors, { { distance * d[0], distance * d[1], distance * d[2], 1 } });
    CheckExactOrder(geometry, faces, neighbors, { { d[0], d[1], d[2], 0 } });
  }
}

vtkSmartPointer<vtkStructuredGrid> MakeWarpedLattice(Random& random, int n, double amplitude)
{
  return MakeStructuredGrid(n, n, n, [&](double i, double j, double k, double x[3]) {
    const double ijk[3] = { i, j, k };
    for (int axis = 0; axis < 3; ++axis)
    {
      const bool boundary = ijk[axis] == 0 || ijk[axis] == n; // stays convex
      x[axis] = ijk[axis] / n + (boundary ? 0 : amplitude / n * random.Uniform(-4, 4));
    }
  });
}

vtkSmartPointer<vtkUnstructuredGrid> PermuteCells(
  Random& random, const CellGeometry& geometry, std::vector<std::int32_t>& from)
{
  from.resize(geometry.Tetrahedra.size());
  std::iota(from.begin(), from.end(), 0);
  std::shuffle(from.begin(), from.end(), random.GetEngine());
  return PickTetrahedra(geometry, from, [](std::int32_t) { return true; });
}

/** Length of the ray origin + t direction, t > 0, inside a tetrahedron. */
double CrossedLength(
  const std::array<Vector3, 4>& p, const Vector3& origin, const Vector3& direction)
{
  double near = 0, far = 1e300;
  for (std::size_t i = 0; i < 4; ++i)
  {
    const Vector3 face[3] = { p[(i + 1) % 4], p[(i + 2) % 4], p[(i + 3) % 4] };
    const long double inside = Orient(face, { { p[i][0], p[i][1], p[i][2], 1 } });
    const long double start = Orient(face, { { origin[0], origin[1], origin[2], 1 } }) / inside;
    const long double speed =
      Orient(face, { { direction[0], direction[1], direction[2], 0 } }) / inside;
    if (speed > 0)
    {
      near = std::max(near, double(-start / speed));
    }
    else if (speed < 0)
    {
      far = std::min(far, double(-start / speed));
    }
    else if (start < 0)
    {
      return 0;
    }
  }
  return std::max(0.0, far - near);
}

/**
 * Colour of a ray when each tetrahedron has the random colour of its number in the unpermuted mesh.
 */
double CompositeRay(const CellGeometry& geometry, const std::vector<std::int32_t>& order,
  const std::vector<std::int32_t>& from, const std::vector<double>& colors, const Vector3& origin,
  const Vector3& direction)
{
  double color = 0;
  for (const std::int32_t i : order)
  {
    const double length = CrossedLength(geometry.Vertices(std::size_t(i)), origin, direction);
    const double alpha = -std::expm1(-3 * length);
    color = (1 - alpha) * color + alpha * colors[std::size_t(from[std::size_t(i)])];
  }
  return color;
}

/** Hexahedra of no grid, which are divided into six tetrahedra rather than five. */
vtkSmartPointer<vtkUnstructuredGrid> AsUnstructured(vtkDataSet* data)
{
  vtkNew<vtkAppendFilter> append;
  append->AddInputData(data);
  append->Update();
  return append->GetOutput();
}
}

TEST(ProjectionOrder, HexahedraAreDividedAsInAGrid)
{
  const auto sorted = [](std::vector<Tetrahedron> tetrahedra) {
    for (Tetrahedron& t : tetrahedra)
    {
      std::sort(t.begin(), t.end());
    }
    std::sort(tetrahedra.begin(), tetrahedra.end());
    return tetrahedra;
  };
  auto grid = MakeShell(24, 12, 3, 80, 1, 1.3);
  const auto ofGrid = sorted(BuildGeometry(grid).Tetrahedra.Copy());
  EXPECT_EQ(ofGrid.size(), 24u * 12 * 3 * 5);
  EXPECT_EQ(sorted(BuildGeometry(AsUnstructured(grid)).Tetrahedra.Copy()), ofGrid);
}

TEST(ProjectionOrder, Shell)
{
  const CellGeometry geometry = BuildGeometry(AsUnstructured(MakeShell(24, 12, 3, 80, 1, 1.3)));
  FaceNeighbors neighbors;
  EXPECT_FALSE(neighbors.IsConnected());
  neighbors.Connect(geometry);
  EXPECT_TRUE(neighbors.IsConnected());
  EXPECT_EQ(geometry.Tetrahedra.size(), 4320u);
  EXPECT_EQ(CountInteriorFaces(geometry, neighbors), 7920u);
  const std::vector<InteriorFace> faces = FindInteriorFaces(geometry);
  EXPECT_EQ(faces.size(), 7920u);
  const double centroids =
    CheckExactOrder(geometry, faces, neighbors, EyeAt(geometry, 3.2, 0.9, 1.1));
  std::cout << "faces in the wrong order with centroids: " << 100 * centroids << " %" << std::endl;
  EXPECT_GT(centroids, 0.05);
}

TEST(ProjectionOrder, ThinShell)
{
  const CellGeometry geometry = BuildGeometry(AsUnstructured(MakeShell(36, 18, 6, 80, 1, 1.06)));
  FaceNeighbors neighbors;
  neighbors.Connect(geometry);
  EXPECT_EQ(geometry.Tetrahedra.size(), 19440u);
  const std::vector<InteriorFace> faces = FindInteriorFaces(geometry);
  const double centroids =
    CheckExactOrder(geometry, faces, neighbors, EyeAt(geometry, 3.2, 0.9, 1.1));
  std::cout << "faces in the wrong order with centroids: " << 100 * centroids << " %" << std::endl;
  EXPECT_GT(centroids, 0.05);
}

// Hexahedra whose faces are not planar; structured cells have alternating diagonals, unstructured
// ones parallel ones.
TEST(ProjectionOrder, WarpedLattice)
{
  Random random(51);
  const auto structured = MakeWarpedLattice(random, 8, 0.06);
  CheckManyEyes(structured, random, 1, 6);
  vtkNew<vtkAppendFilter> unstructured;
  unstructured->AddInputData(structured);
  unstructured->Update();
  CheckManyEyes(unstructured->GetOutput(), random, 1, 6);
}

TEST(ProjectionOrder, Delaunay)
{
  Random random(52);
  for (int i = 0; i < 3; ++i)
  {
    CheckManyEyes(MakeDelaunay(random, 300), random, 1, 6);
  }
}

TEST(ProjectionOrder, RepeatedPointsOfBlocksAreJoined)
{
  vtkNew<vtkAppendFilter> append;
  append->MergePointsOff();
  for (int block = 0; block < 2; ++block)
  {
    append->AddInputData(
      MakeStructuredGrid(2, 4, 4, [&](double i, double j, double k, double x[3]) {
        x[0] = i + 2 * block;
        x[1] = j;
        x[2] = k;
      }));
  }
  append->Update();
  const CellGeometry geometry = BuildGeometry(append->GetOutput());
  const CellGeometry whole = BuildGeometry(AsUnstructured(MakeLattice(4)));
  ASSERT_GT(geometry.Points.size(), whole.Points.size());
  FaceNeighbors joined, single;
  joined.Connect(geometry);
  single.Connect(whole);
  EXPECT_EQ(CountInteriorFaces(geometry, joined), CountInteriorFaces(whole, single));
  CheckExactOrder(geometry, FindInteriorFaces(geometry), joined, EyeAt(geometry, 10, 3, 1));
}

TEST(ProjectionOrder, ThreadsDoNotChangeTheOrder)
{
  const CellGeometry geometry = BuildGeometry(MakeShell(24, 12, 3, 90, 1, 1.3));
  const Vector4 eye = EyeAt(geometry, 3.2, 0.9, 1.1);
  std::vector<std::int32_t> exact, centroids;
  for (const int threads : { 1, 2, 4 })
  {
    WithThreads(threads, [&]() {
      FaceNeighbors neighbors;
      neighbors.Connect(geometry);
      std::vector<std::int32_t> order = Sorted(Kind::Topological, geometry, neighbors, eye);
      exact = exact.empty() ? order : exact;
      EXPECT_EQ(order, exact);
      order = Sorted(Kind::Centroid, geometry, neighbors, eye);
      centroids = centroids.empty() ? order : centroids;
      EXPECT_EQ(order, centroids);
    });
  }
}

TEST(ProjectionOrder, PermutedCellsGiveTheSamePicture)
{
  Random random(53);
  const CellGeometry geometry = BuildGeometry(MakeWarpedLattice(random, 4, 0.06));
  std::vector<std::int32_t> identity(geometry.Tetrahedra.size()), from;
  std::iota(identity.begin(), identity.end(), 0);
  const CellGeometry permuted = BuildGeometry(PermuteCells(random, geometry, from));
  std::vector<double> colors;
  std::generate_n(std::back_inserter(colors), identity.size(), [&]() { return random.Uniform(); });

  const Vector3 eye = { { 2, 1.5, 1.2 } };
  FaceNeighbors first, second;
  first.Connect(geometry);
  second.Connect(permuted);
  const std::vector<std::int32_t> order =
    Sorted(Kind::Topological, geometry, first, { { eye[0], eye[1], eye[2], 1 } });
  const std::vector<std::int32_t> permutedOrder =
    Sorted(Kind::Topological, permuted, second, { { eye[0], eye[1], eye[2], 1 } });
  double greatest = 0;
  for (int i = 0; i < 500; ++i)
  {
    const Vector3 target = { { random.Uniform(-0.5, 0.5), random.Uniform(-0.5, 0.5),
      random.Uniform(-0.5, 0.5) } };
    const Vector3 direction = Difference(target, eye);
    const double color = CompositeRay(geometry, order, identity, colors, eye, direction);
    ASSERT_NEAR(CompositeRay(permuted, permutedOrder, from, colors, eye, direction), color, 1e-12);
    greatest = std::max(greatest, color);
  }
  EXPECT_GT(greatest, 0.3);
}

TEST(ProjectionOrder, CentroidsFarthestFirst)
{
  const CellGeometry geometry = BuildGeometry(MakeLattice(3));
  const auto centroid = [&](std::int32_t i) {
    const auto p = geometry.Vertices(std::size_t(i));
    return Vector3{ { (p[0][0] + p[1][0] + p[2][0] + p[3][0]) / 4,
      (p[0][1] + p[1][1] + p[2][1] + p[3][1]) / 4, (p[0][2] + p[1][2] + p[2][2] + p[3][2]) / 4 } };
  };
  std::vector<std::int32_t> order = Sorted(Kind::Centroid, geometry, {}, { { 5, 4, 3, 1 } });
  for (std::size_t i = 1; i < order.size(); ++i)
  {
    const Vector3 far = Difference(centroid(order[i - 1]), { { 5, 4, 3 } });
    const Vector3 near = Difference(centroid(order[i]), { { 5, 4, 3 } });
    ASSERT_GE(Dot(far, far), Dot(near, near) - 1e-5);
  }
  order = Sorted(Kind::Centroid, geometry, {}, { { 5, 4, 3, 0 } });
  for (std::size_t i = 1; i < order.size(); ++i)
  {
    ASSERT_LE(Dot(centroid(order[i - 1]), { { 5, 4, 3 } }),
      Dot(centroid(order[i]), { { 5, 4, 3 } }) + 1e-5);
  }
  order = Sorted(Kind::None, geometry, {}, { { 5, 4, 3, 0 } });
  EXPECT_TRUE(IsPermutation(order, geometry.Tetrahedra.size()));
  EXPECT_TRUE(std::is_sorted(order.begin(), order.end()));
}

TEST(ProjectionOrder, NothingAndOneTetrahedron)
{
  CellGeometry geometry;
  FaceNeighbors neighbors;
  neighbors.Connect(geometry);
  EXPECT_TRUE(Sorted(Kind::Topological, geometry, neighbors, { { 0, 0, 1, 0 } }).empty());
  geometry =
    BuildGeometry(MakeGrid({ { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } } },
      { { VTK_TETRA, { 0, 1, 2, 3 } } }));
  neighbors.Connect(geometry);
  EXPECT_EQ(Sorted(Kind::Topological, geometry, neighbors, { { 0, 0, 1, 0 } }),
    std::vector<std::int32_t>{ 0 });
}

// Three and more tetrahedra at one face, and points that are not numbers, must do no harm.
TEST(ProjectionOrder, OverlappingCellsAndInvalidPoints)
{
  auto grid = MakeGrid({ { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } },
                         { { 0, 0, -1 } }, { { 0.1, 0.1, 2 } }, { { std::nan(""), 0, 0 } } },
    { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 0, 1, 2, 4 } }, { VTK_TETRA, { 0, 1, 2, 5 } },
      { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 0, 1, 2, 6 } } });
  const CellGeometry geometry = BuildGeometry(grid);
  ASSERT_EQ(geometry.Tetrahedra.size(), 4u);
  FaceNeighbors neighbors;
  neighbors.Connect(geometry);
  EXPECT_TRUE(IsPermutation(Sorted(Kind::Topological, geometry, neighbors, { { 0, 0, 5, 1 } }), 4));
}

// All members of a cycle are drawn, and as many relations are wrong as it is said.
TEST(ProjectionOrder, CyclesAreCounted)
{
  const CellGeometry geometry = BuildGeometry(MakeLeaningRing(12));
  FaceNeighbors neighbors;
  neighbors.Connect(geometry);
  const Vector4 above = EyeAt(geometry, 0.1, 0.05, 9), aside = EyeAt(geometry, 9, 1, 0.5);
  const std::vector<Relation> relations = FindRelations(FindInteriorFaces(geometry), above);
  ProjectionOrder order;
  EXPECT_TRUE(order.Sort(Kind::Topological, geometry, neighbors, above));
  EXPECT_EQ(order.NumberOfCycles, 1);
  EXPECT_GE(order.NumberOfCyclicTetrahedra, 12);
  EXPECT_LE(order.NumberOfCyclicTetrahedra,
    std::int64_t(CountUnsortable(relations, geometry.Tetrahedra.size())));
  EXPECT_GT(order.NumberOfBrokenRelations, 0);
  EXPECT_EQ(order.NumberOfBrokenRelations, CountViolations(relations, order.Tetrahedra));
  EXPECT_TRUE(IsPermutation(order.Tetrahedra, geometry.Tetrahedra.size()));
  Sorted(Kind::Topological, geometry, neighbors, aside);
}
