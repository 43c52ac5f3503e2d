// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Meshes that rays leave and enter again: convexity is found out, and no pixel's ray finds two cells in the wrong order.
#include "VisibilityOrder.h"

#include "OrderMeshes.h"
#include "RayOrder.h"
#include "ThreadScope.h"

#include "vtkAppendFilter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

using namespace nephoscope;
using namespace nephoscope_test;

namespace
{
bool isConvex(const CellGeometry& geometry)
{
  FaceNeighbors faces;
  EXPECT_TRUE(faces.Connect(geometry));
  return faces.IsConvex();
}

bool isConvex(vtkDataSet* data)
{
  return isConvex(buildGeometry(data));
}

std::vector<PixelCamera> camerasAround(Random& random, double distance, int count, int pixels = 48)
{
  std::vector<PixelCamera> cameras;
  for (int i = 0; i < count; ++i)
  {
    const Vector3 d = random.Direction();
    const Vector3 focus = { { random.Uniform(-0.1, 0.1), random.Uniform(-0.1, 0.1),
      random.Uniform(-0.1, 0.1) } };
    const Vector3 eye = { { distance * d[0], distance * d[1], distance * d[2] } };
    const bool parallel = i % 2 == 1;
    cameras.emplace_back(eye, focus, parallel ? 0.5 * distance : 0.5, parallel, pixels, pixels);
  }
  return cameras;
}

/** Checks every view; returns how many crossings are inverted, over all of them, when gaps are not related. */
std::int64_t checkShape(
  const CellGeometry& geometry, const std::vector<PixelCamera>& cameras, const std::string& name)
{
  VisibilityOrder visibility;
  EXPECT_TRUE(visibility.Connect(geometry));
  RayCheck total, blind;
  for (const PixelCamera& camera : cameras)
  {
    VisibilityOrder::Sorted sorted;
    EXPECT_TRUE(visibility.SortExact(geometry, camera.GetView(), sorted));
    const RayCheck check = checkRays(geometry, sorted, camera);
    EXPECT_EQ(check.Inversions, 0) << name << ": " << check;
    EXPECT_EQ(sorted.NumberOfBrokenRelations, 0) << name;
    total.Crossings += check.Crossings;

    OrderView withoutPixels = camera.GetView();
    withoutPixels.Width = withoutPixels.Height = 0;
    EXPECT_TRUE(visibility.SortExact(geometry, withoutPixels, sorted));
    blind.Inversions += checkRays(geometry, sorted, camera).Inversions;
  }
  std::cout << name << ": " << geometry.Tetrahedra.size() << " tetrahedra, " << total.Crossings
            << " crossings in order; " << blind.Inversions
            << " inverted without relations across gaps" << std::endl;
  EXPECT_GT(total.Crossings, 1000) << name << ": nothing to see";
  return blind.Inversions;
}

/** A fan of tetrahedra around the centre of a convex body that is almost round. */
vtkSmartPointer<vtkUnstructuredGrid> makeBall(Random& random, int satellite = -1)
{
  std::vector<std::array<double, 3>> points = { { { 0.1, 0, 0.2 } } };
  const double pi = std::acos(-1.0), turn = random.Uniform();
  const int rings = 9, sectors = 14;
  std::vector<std::pair<int, std::vector<vtkIdType>>> cells;
  for (int j = 0; j <= rings; ++j)
  {
    for (int i = 0; i < sectors; ++i)
    {
      const double theta = pi * j / rings, lambda = turn + 2 * pi * i / sectors;
      points.push_back({ { std::sin(theta) * std::cos(lambda),
        0.7 * std::sin(theta) * std::sin(lambda), std::cos(theta) } });
      const auto id = [&](int a, int b) { // one point at each pole
        return vtkIdType(1 + b * sectors + (b == 0 || b == rings ? 0 : (i + a) % sectors));
      };
      if (j < rings)
      {
        cells.push_back({ VTK_TETRA, { 0, id(0, j), id(1, j), id(0, j + 1) } });
        cells.push_back({ VTK_TETRA, { 0, id(1, j), id(1, j + 1), id(0, j + 1) } });
      }
    }
  }
  if (satellite >=
    0) // a small tetrahedron above the outer face of another one, which few other faces see
  {
    const vtkIdType first = vtkIdType(points.size());
    const std::vector<vtkIdType> below = cells[std::size_t(satellite)].second;
    for (int corner = 0; corner < 4; ++corner)
    {
      std::array<double, 3> x;
      for (std::size_t k = 0; k < 3; ++k)
      {
        x[k] = 0;
        for (int i = 1; i < 4; ++i)
        {
          x[k] += (corner == i      ? 0.4
                      : corner == 0 ? 1 / 3.
                                    : 0.3) *
            points[std::size_t(below[std::size_t(i)])][k];
        }
        x[k] *= corner == 0 ? 1.01 : 1.001;
      }
      points.push_back(x);
    }
    cells.insert(cells.begin() + 50, { VTK_TETRA, { first, first + 1, first + 2, first + 3 } });
  }
  return makeGrid(points, cells);
}

/** How far a corner of the mesh lies outside the plane of one of its boundary faces; 0 for a convex mesh in one piece. */
double dent(const CellGeometry& geometry, const FaceNeighbors& faces)
{
  double deepest = 0;
  for (const FaceNeighbors::Face& face : faces.GetBoundary())
  {
    const auto p = geometry.Vertices(std::size_t(face.Tetrahedron));
    const auto& f = tetrahedronFaces[face.Opposite];
    const Vector3 normal = cross(difference(p[f[1]], p[f[0]]), difference(p[f[2]], p[f[0]]));
    const double scale = -1 / std::sqrt(dot(normal, normal));
    const double inside =
      dot(normal, difference(p[std::size_t(face.Opposite)], p[f[0]])) > 0 ? 1 : -1;
    for (const FaceNeighbors::Face& other : faces.GetBoundary())
    {
      for (const int k : tetrahedronFaces[other.Opposite])
      {
        const Vector3 corner = geometry.Vertices(std::size_t(other.Tetrahedron))[std::size_t(k)];
        deepest = std::max(deepest, inside * scale * dot(normal, difference(corner, p[f[0]])));
      }
    }
  }
  return deepest;
}

vtkSmartPointer<vtkUnstructuredGrid> makeNestedShells()
{
  BlockMesh mesh;
  const double pi = std::acos(-1.0);
  for (const double inner : { 0.5, 0.8, 1.1 })
  {
    const int n[3] = { 12, 6, 1 };
    mesh.AddBox(
      n, [](int, int, int) { return false; },
      [&](double u, double v, double w) {
        const double lambda = 2 * pi * (u == 1 ? 0 : u), phi = pi / 180 * 80 * (2 * v - 1),
                     r = inner + 0.2 * w;
        return std::array<double, 3>{ { r * std::cos(phi) * std::cos(lambda),
          r * std::cos(phi) * std::sin(lambda), r * std::sin(phi) } };
      });
  }
  return mesh.Get();
}
}

TEST(VisibilityShapes, ConvexMeshesAreKnown)
{
  Random random(71);
  EXPECT_TRUE(isConvex(makeLattice(3)));
  EXPECT_TRUE(isConvex(makeCubeWithout(3, [](int, int, int) { return false; })));
  EXPECT_TRUE(isConvex(makeBall(random)));
  // Rounding of the coordinates bends the sides by so little that it does not count.
  EXPECT_TRUE(isConvex(makeStructuredGrid(7, 5, 6, [](double i, double j, double k, double x[3]) {
    x[0] = 0.1 + 0.7 * i + 0.3 * j;
    x[1] = -0.3 + 0.9 * j - 0.2 * k;
    x[2] = 0.7 + 1.1 * k + 0.1 * i;
  })));
  EXPECT_TRUE(isConvex(CellGeometry())) << "there is no way to leave and enter nothing";
}

TEST(VisibilityShapes, OthersAreFoundOut)
{
  EXPECT_FALSE(isConvex(makeCubeWithout(2, [](int i, int j, int) { return i == 1 && j == 1; })))
    << "L";
  EXPECT_FALSE(
    isConvex(makeCubeWithout(3, [](int i, int j, int k) { return i == 1 && j == 1 && k == 1; })))
    << "cavity";
  EXPECT_FALSE(isConvex(makeShell(12, 6, 2, 80, 1, 1.3))) << "shell";
  BlockMesh blocks;
  blocks.AddBox(1, 1, 1, { { 0, 0, 0 } }, { { 1, 1, 1 } });
  blocks.AddBox(1, 1, 1, { { 2, 0, 0 } }, { { 3, 1, 1 } });
  EXPECT_FALSE(isConvex(blocks.Get())) << "two convex blocks";
  Random random(78);
  for (int face = 40; face < 200; face += 7)
  {
    EXPECT_FALSE(isConvex(makeBall(random, face))) << "a ball and its satellite";
  }
  // One corner pushed in, by little and by nothing.
  for (const double depth : { 1e-3, 0.0 })
  {
    EXPECT_EQ(depth == 0,
      isConvex(makeStructuredGrid(2, 2, 2, [depth](double i, double j, double k, double x[3]) {
        x[0] = i;
        x[1] = j;
        x[2] = k + (k == 2 && i == 1 && j == 1 ? -depth : 0);
      })));
  }
}

TEST(VisibilityShapes, ConvexityOfRandomMeshes)
{
  Random random(77);
  int dented = 0, whole = 0;
  for (int i = 0; i < 60; ++i)
  {
    const CellGeometry full = buildGeometry(makeDelaunay(random, random.Integer(5, 25)));
    std::vector<std::int32_t> all(full.Tetrahedra.size());
    std::iota(all.begin(), all.end(), 0);
    const std::int32_t missing = random.Integer(-int(all.size()), int(all.size()) - 1);
    const CellGeometry geometry =
      buildGeometry(pickTetrahedra(full, all, [&](std::int32_t n) { return n != missing; }));
    FaceNeighbors faces;
    ASSERT_TRUE(faces.Connect(geometry));
    const double depth = dent(geometry, faces);
    if (depth > 1e-5)
    {
      ++dented;
      EXPECT_FALSE(faces.IsConvex()) << depth;
    }
    else if (depth < 1e-9)
    {
      ++whole;
      EXPECT_TRUE(faces.IsConvex()) << depth;
    }
  }
  EXPECT_GT(dented, 10);
  EXPECT_GT(whole, 2);
}

TEST(VisibilityShapes, MeshesWithHoles)
{
  Random random(72);
  const auto cameras = camerasAround(random, 2, 6);
  checkShape(buildGeometry(makeCubeWithout(4, [](int i, int j, int) { return i >= 2 && j >= 2; })),
    cameras, "L");
  EXPECT_GT(checkShape(buildGeometry(makeCubeWithout(3,
                         [](int i, int j, int k) { return (i == 1) + (j == 1) + (k == 1) > 1; })),
              cameras, "cube with three tunnels"),
    0);
  EXPECT_GT(checkShape(buildGeometry(makeCubeWithout(5,
                         [](int i, int j, int k) {
                           return std::min({ i, j, k }) > 0 && std::max({ i, j, k }) < 4;
                         })),
              cameras, "hollow cube"),
    0);
}

TEST(VisibilityShapes, SeparateParts)
{
  Random random(73);
  const auto cameras = camerasAround(random, 2.5, 6);
  BlockMesh blocks; // a long one and a small one: centroids say nothing about them
  blocks.AddBox(8, 1, 1, { { -1, -0.1, -0.1 } }, { { 1, 0.1, 0.1 } });
  blocks.AddBox(2, 2, 2, { { 0.6, 0.15, -0.2 } }, { { 0.9, 0.5, 0.2 } });
  blocks.AddBox(1, 1, 1, { { -0.9, -0.6, -0.3 } }, { { 0.9, -0.15, 0.4 } });
  EXPECT_GT(checkShape(buildGeometry(blocks.Get()), cameras, "three blocks"), 0);
  EXPECT_GT(checkShape(buildGeometry(makeNestedShells()), cameras, "nested shells"), 0);
  // Sides that touch but are divided differently share no face.
  BlockMesh halves;
  halves.AddBox(2, 3, 3, { { -0.5, -0.5, -0.5 } }, { { 0, 0.5, 0.5 } });
  halves.AddBox(2, 4, 5, { { 0, -0.5, -0.5 } }, { { 0.5, 0.5, 0.5 } });
  EXPECT_GT(checkShape(buildGeometry(halves.Get()), cameras, "halves that do not match"), 0);
}

TEST(VisibilityShapes, TetrahedraMissingAtRandom)
{
  Random random(74);
  for (const double share : { 0.2, 0.6, 0.9 })
  {
    const CellGeometry full = buildGeometry(makeDelaunay(random, 250));
    std::vector<std::int32_t> all(full.Tetrahedra.size());
    std::iota(all.begin(), all.end(), 0);
    const CellGeometry geometry = buildGeometry(
      pickTetrahedra(full, all, [&](std::int32_t) { return random.Uniform() > share; }));
    EXPECT_GT(
      checkShape(geometry, camerasAround(random, 1.5, 6), std::to_string(share) + " missing"), 0);
  }
}

TEST(VisibilityShapes, TheEyeAmongTheCells)
{
  Random random(75);
  const CellGeometry geometry = buildGeometry(makeNestedShells());
  std::vector<PixelCamera> cameras;
  for (int i = 0; i < 6; ++i)
  {
    const Vector3 d = random.Direction();
    const double r = random.Uniform(0, 1.25);
    const Vector3 focus = { { d[1], d[2], d[0] } };
    cameras.emplace_back(Vector3{ { r * d[0], r * d[1], r * d[2] } }, focus, 0.7, false, 48, 40);
  }
  EXPECT_GT(checkShape(geometry, cameras, "inside nested shells"), 0);
}

// Only pixel centres matter: a finer picture needs more relations.
TEST(VisibilityShapes, RelationsFollowThePixels)
{
  const CellGeometry geometry = buildGeometry(makeNestedShells());
  VisibilityOrder visibility;
  visibility.Connect(geometry);
  std::size_t before = 0;
  for (const int pixels : { 8, 32, 128 })
  {
    const PixelCamera camera({ { 3, 1, 0.5 } }, { { 0, 0, 0 } }, 0.5, false, pixels, pixels);
    std::vector<ReentryRelation> relations;
    ASSERT_TRUE(findReentryRelations(
      geometry, visibility.GetFaces().GetBoundary(), camera.GetView(), relations));
    EXPECT_TRUE(std::is_sorted(relations.begin(), relations.end()));
    EXPECT_EQ(std::adjacent_find(relations.begin(), relations.end()), relations.end());
    EXPECT_GT(relations.size(), before);
    before = relations.size();
  }
}

TEST(VisibilityShapes, ThreadsDoNotChangeTheOrder)
{
  const CellGeometry geometry = buildGeometry(makeNestedShells());
  const PixelCamera camera({ { 3, 1, 0.5 } }, { { 0, 0, 0 } }, 0.5, false, 100, 80);
  std::vector<std::int32_t> first;
  for (const int threads : { 1, 2, 4 })
  {
    withThreads(threads, [&]() {
      VisibilityOrder visibility;
      visibility.Connect(geometry);
      VisibilityOrder::Sorted sorted;
      visibility.SortExact(geometry, camera.GetView(), sorted);
      first = first.empty() ? sorted.Order : first;
      EXPECT_EQ(sorted.Order, first);
    });
  }
}

// On a Delaunay mesh the power of the circumspheres is an order too, found without any relation.
TEST(VisibilityShapes, DelaunayPowerAgrees)
{
  Random random(76);
  const CellGeometry geometry = buildGeometry(makeDelaunay(random, 400));
  VisibilityOrder visibility;
  visibility.Connect(geometry);
  for (const PixelCamera& camera : camerasAround(random, 2, 4))
  {
    const Vector4 eye = camera.GetView().Eye;
    std::vector<std::pair<double, std::int32_t>> power;
    for (std::size_t i = 0; i < geometry.Tetrahedra.size(); ++i)
    {
      const auto p = geometry.Vertices(i);
      const Vector3 a = difference(p[1], p[0]), b = difference(p[2], p[0]),
                    c = difference(p[3], p[0]);
      const Vector3 bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
      Vector3 center; // relative to p[0]
      double radius2 = 0, distance2 = 0, along = 0;
      for (std::size_t k = 0; k < 3; ++k)
      {
        center[k] = (dot(a, a) * bc[k] + dot(b, b) * ca[k] + dot(c, c) * ab[k]) / (2 * dot(a, bc));
        radius2 += center[k] * center[k];
        distance2 += std::pow(eye[k] - p[0][k] - center[k], 2);
        along += eye[k] * (p[0][k] + center[k]);
      }
      power.emplace_back(eye[3] == 0 ? along : radius2 - distance2, std::int32_t(i));
    }
    std::sort(power.begin(), power.end());
    VisibilityOrder::Sorted byPower, exact;
    for (const auto& p : power)
    {
      byPower.Order.push_back(p.second);
    }
    EXPECT_EQ(checkRays(geometry, byPower, camera).Inversions, 0)
      << "the independent order is none";
    ASSERT_TRUE(visibility.SortExact(geometry, camera.GetView(), exact));
    EXPECT_EQ(checkRays(geometry, exact, camera).Inversions, 0);
    VisibilityOrder::SortCentroids(geometry, eye, byPower.Order);
    EXPECT_GT(checkRays(geometry, byPower, camera).Inversions, 0) << "centroids are no order here";
  }
}
