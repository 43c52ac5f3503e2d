// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Fans of triangles around the thick vertex, against rays clipped by the planes of the faces, and
// the error laws of the opacities interpolated over them.
#include "ProjectedTriangles.h"

#include "ClippedTetrahedron.h"
#include "TestRandom.h"

#include <gtest/gtest.h>

#include <map>

using namespace nephoscope;
using namespace nephoscope_test;

namespace
{
struct View
{
  Vector4 Eye; // the eye, or the direction towards it
  bool IsPerspective() const { return this->Eye[3] > 0; }
  /** Along the view axis, which is z here. */
  double Depth(const Vector3& x) const { return this->Eye[3] * this->Eye[2] - x[2]; }
  std::array<double, 2> Screen(const Vector3& x) const
  {
    const double w = this->IsPerspective() ? this->Depth(x) : 1;
    return { { (x[0] - this->Eye[3] * this->Eye[0]) / w,
      (x[1] - this->Eye[3] * this->Eye[1]) / w } };
  }
};

/** Half of the views are perspective; then all vertices lie in front of the eye. */
View RandomView(Random& random, const TetrahedronPoints& p, bool perspective)
{
  double nearest = p[0][2];
  for (const Vector3& x : p)
  {
    nearest = std::max(nearest, x[2]);
  }
  return perspective
    ? View{ { random.Normal(), random.Normal(), nearest + random.LogUniform(0.1, 10), 1 } }
    : View{ { 0, 0, 1, 0 } };
}

double ScreenArea(const View& view, const Vector3& a, const Vector3& b, const Vector3& c)
{
  const auto p = view.Screen(a), q = view.Screen(b), r = view.Screen(c);
  return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
}

int NumberOfTriangles(const TetrahedronProjection& p)
{
  int n = 0;
  for (const auto& edge : tetrahedronEdges)
  {
    n += IsFanEdge(p, edge[0], edge[1]);
  }
  return n;
}

Vector3 PlaceAt(const TetrahedronPoints& p, const Vector4& weights)
{
  Vector3 x = { { 0, 0, 0 } };
  for (std::size_t i = 0; i < 4; ++i)
  {
    x = Along(x, weights[i], p[i]);
  }
  return x;
}

/** Thickness as the header has it: the parameter times the way from the back to the eye. */
double Thickness(const View& view, const TetrahedronProjection& projection, const Vector3& back)
{
  const Vector3 towards = { { view.Eye[0] - view.Eye[3] * back[0],
    view.Eye[1] - view.Eye[3] * back[1], view.Eye[2] - view.Eye[3] * back[2] } };
  return projection.Parameter * Length(towards);
}
}

TEST(ProjectedTriangles, ThickVertexAgreesWithClippedRays)
{
  Random random(31);
  double worstThickness = 0, worstScalar = 0, worstRay = 0;
  std::map<int, int> classes;
  for (int i = 0; i < 20000; ++i)
  {
    const TetrahedronPoints p = RandomTetrahedron(random);
    const View view = RandomView(random, p, i % 2 == 0);
    const Vector4 scalars = { { random.Normal(), random.Normal(), random.Normal(),
      random.Normal() } };
    const TetrahedronProjection projection = ProjectTetrahedron(EyeCoordinates(p, view.Eye));
    ++classes[ProjectionClass(projection)];
    const Vector3 front = PlaceAt(p, projection.Front), back = PlaceAt(p, projection.Back);

    const auto a = view.Screen(front), b = view.Screen(back);
    worstRay = std::max({ worstRay, std::fabs(a[0] - b[0]), std::fabs(a[1] - b[1]) });

    const Vector3 middle = Along(front, 0.5, Difference(back, front));
    const Vector3 eye = { { view.Eye[0], view.Eye[1], view.Eye[2] } };
    Vector3 direction = view.IsPerspective() ? Difference(middle, eye) : Vector3{ { 0, 0, -1 } };
    direction = Along({ { 0, 0, 0 } }, 1 / Length(direction), direction);
    const ClippedRay ray = Clip(p, middle, direction);
    worstThickness =
      std::max(worstThickness, std::fabs(Thickness(view, projection, back) - (ray.Far - ray.Near)));
    for (const bool atFront : { true, false })
    {
      const Vector4 exact = Barycentric(p, Along(middle, atFront ? ray.Near : ray.Far, direction));
      const double error =
        std::fabs(Interpolate(atFront ? projection.Front : projection.Back, scalars) -
          Interpolate(exact, scalars));
      worstScalar = std::max(worstScalar, error);
    }
  }
  std::cout << "thickness " << worstThickness << ", scalars " << worstScalar << ", one ray "
            << worstRay << std::endl;
  EXPECT_LT(worstThickness, 1e-9);
  EXPECT_LT(worstScalar, 1e-9);
  EXPECT_LT(worstRay, 1e-9);
  EXPECT_EQ(classes[1] + classes[2], 20000);
  EXPECT_NEAR(classes[2] / 20000.0, 0.65, 0.15) << "random tetrahedra in general position";
}

/**
 * The triangles tile the silhouette: their areas add up to that of the two triangles of either
 * side.
 */
TEST(ProjectedTriangles, FanTilesTheSilhouette)
{
  Random random(32);
  double worst = 0;
  for (int i = 0; i < 5000; ++i)
  {
    const TetrahedronPoints p = RandomTetrahedron(random);
    const View view = RandomView(random, p, i % 2 == 0);
    const TetrahedronProjection projection = ProjectTetrahedron(EyeCoordinates(p, view.Eye));
    const Vector3 thick = PlaceAt(p, projection.Front);
    double fan = 0, faces = 0;
    for (const auto& edge : tetrahedronEdges)
    {
      if (IsFanEdge(projection, edge[0], edge[1]))
      {
        fan += std::fabs(ScreenArea(view, thick, p[edge[0]], p[edge[1]]));
      }
    }
    for (const auto& face : tetrahedronFaces)
    {
      faces += std::fabs(ScreenArea(view, p[face[0]], p[face[1]], p[face[2]]));
    }
    worst = std::max(worst, std::fabs(fan - 0.5 * faces) / faces);
  }
  std::cout << "largest relative difference of areas " << worst << std::endl;
  EXPECT_LT(worst, 1e-9);
}

TEST(ProjectedTriangles, Classes)
{
  const auto classOf = [](const Vector4& q) { return ProjectionClass(ProjectTetrahedron(q)); };
  EXPECT_EQ(classOf({ { 1, -1, -1, -1 } }), 1);
  EXPECT_EQ(classOf({ { 1, 1, -1, 1 } }), 1);
  EXPECT_EQ(classOf({ { 1, -1, 1, -1 } }), 2);
  EXPECT_EQ(classOf({ { 1, -1, 0, -1 } }), 3);
  EXPECT_EQ(classOf({ { 0, 1, 1, -1 } }), 3);
  EXPECT_EQ(classOf({ { 0, 1, 0, -1 } }), 4);
  EXPECT_EQ(classOf({ { 0, 0, 0, 0 } }), 0);
  EXPECT_EQ(classOf({ { 1, 1, 0, 1 } }), 0) << "the eye inside";
  EXPECT_EQ(NumberOfTriangles(ProjectTetrahedron({ { 1, -1, -1, -1 } })), 3);
  EXPECT_EQ(NumberOfTriangles(ProjectTetrahedron({ { 1, -1, 1, -1 } })), 4);
  EXPECT_EQ(NumberOfTriangles(ProjectTetrahedron({ { 0, 1, 1, -1 } })), 2);
  EXPECT_EQ(NumberOfTriangles(ProjectTetrahedron({ { 0, 1, 0, -1 } })), 1);
}

TEST(ProjectedTriangles, KnownTetrahedra)
{
  const View view = { { { 0, 0, 1, 0 } } };
  const Vector4 scalars = { { 0, 1, 2, 3 } };
  const TetrahedronPoints regular = { { { { 1, 1, 1 } }, { { 1, -1, -1 } }, { { -1, 1, -1 } },
    { { -1, -1, 1 } } } };
  TetrahedronProjection p = ProjectTetrahedron(EyeCoordinates(regular, view.Eye));
  EXPECT_EQ(ProjectionClass(p), 2);
  EXPECT_NEAR(Thickness(view, p, PlaceAt(regular, p.Back)), 2.0, 1e-14);
  EXPECT_NEAR(Interpolate(p.Front, scalars), 1.5, 1e-14);
  EXPECT_NEAR(Interpolate(p.Back, scalars), 1.5, 1e-14);
  EXPECT_NEAR(
    -std::expm1(-Thickness(view, p, PlaceAt(regular, p.Back))), 0.8646647167633873, 1e-14);

  const TetrahedronPoints corner = { { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } },
    { { 0, 0, 1 } } } };
  p = ProjectTetrahedron(EyeCoordinates(corner, view.Eye));
  EXPECT_EQ(ProjectionClass(p), 4);
  EXPECT_NEAR(Thickness(view, p, PlaceAt(corner, p.Back)), 1.0, 1e-14);
  EXPECT_EQ(Interpolate(p.Front, scalars), 3.0);
  EXPECT_EQ(Interpolate(p.Back, scalars), 0.0);
}

/**
 * Continuous across classes: an almost hidden vertex changes the thickness by as little as it is
 * off.
 */
TEST(ProjectedTriangles, ContinuousAcrossClasses)
{
  const View view = { { { 0, 0, 1, 0 } } };
  for (const double off : { 0.0, 1e-12, -1e-12, 1e-6, -1e-6 })
  {
    const TetrahedronPoints p = { { { { off, 0.3, 1 } }, { { 0, 0, 0 } }, { { 0, 1, 0 } },
      { { 1, 0, -1 } } } };
    const TetrahedronProjection projection = ProjectTetrahedron(EyeCoordinates(p, view.Eye));
    EXPECT_NEAR(
      Thickness(view, projection, PlaceAt(p, projection.Back)), 1.0, 3 * std::fabs(off) + 1e-12)
      << off;
  }
}

/**
 * Inside a triangle of the fan, thickness from 1 / z as the header has it, at points of the screen,
 * against clipped rays.
 */
TEST(ProjectedTriangles, InverseDepthIsLinearOnTheScreen)
{
  Random random(33);
  double worst = 0, worstLinear = 0;
  for (int i = 0; i < 5000; ++i)
  {
    const TetrahedronPoints p = RandomTetrahedron(random);
    const View view = RandomView(random, p, true);
    const TetrahedronProjection projection = ProjectTetrahedron(EyeCoordinates(p, view.Eye));
    const Vector3 front = PlaceAt(p, projection.Front), back = PlaceAt(p, projection.Back);
    const double zf = view.Depth(front), zb = view.Depth(back),
                 peak = Thickness(view, projection, back);
    const int pick = random.Integer(0, 5);
    const int a = tetrahedronEdges[pick][0], b = tetrahedronEdges[pick][1];
    if (!IsFanEdge(projection, a, b))
    {
      continue;
    }
    const double t = random.Uniform(0.05, 1), u = (1 - t) * random.Uniform(),
                 v = 1 - t - u; // thick, a, b
    const double inverseFront = t / zf + u / view.Depth(p[a]) + v / view.Depth(p[b]);
    const double inverseBack = inverseFront - t * (1 / zf - 1 / zb);
    const auto screen = [&](std::size_t axis) {
      return t * view.Screen(front)[axis] + u * view.Screen(p[a])[axis] +
        v * view.Screen(p[b])[axis];
    };
    Vector3 direction = { { screen(0), screen(1), -1 } };
    const double stretch = Length(direction);
    direction = Along({ { 0, 0, 0 } }, 1 / stretch, direction);
    const ClippedRay ray = Clip(p, { { view.Eye[0], view.Eye[1], view.Eye[2] } }, direction);
    const double exact = ray.Far - ray.Near;
    worst =
      std::max(worst, std::fabs((1 / inverseBack - 1 / inverseFront) * stretch - exact) / peak);
    worstLinear = std::max(worstLinear, std::fabs(t * peak - exact) / peak);
  }
  std::cout << "largest error over the peak: " << worst
            << " from 1 / z; thickness interpolated itself " << worstLinear << std::endl;
  EXPECT_LT(worst, 1e-7); // the clipped rays of grazed slivers lose digits
  EXPECT_GT(worstLinear, 0.1);
}

/**
 * From the silhouette (0) to the thick vertex (1) of optical depth U, opacity interpolated linearly
 * errs most at lambda*.
 */
TEST(OpacityLaws, LinearOpacity)
{
  const double table[][2] = { { .1, .00119 }, { .25, .00691 }, { .5, .02451 }, { 1, .07794 },
    { 2, .20513 }, { 4, .40982 }, { 8, .61516 } };
  const auto error = [](double depth, double lambda) {
    return -std::expm1(-lambda * depth) + lambda * std::expm1(-depth);
  };
  for (const auto& row : table)
  {
    double largest = 0;
    for (int i = 0; i <= 10000; ++i)
    {
      largest = std::max(largest, error(row[0], i / 10000.0));
    }
    EXPECT_NEAR(largest, row[1], 6e-6) << "optical depth " << row[0];
    const double lambda = -std::log(-std::expm1(-row[0]) / row[0]) / row[0];
    EXPECT_NEAR(error(row[0], lambda), largest, 1e-8);
  }
  EXPECT_NEAR(error(1, 0.45868), 0.07794145194859015, 1e-9);
}

TEST(OpacityLaws, Table)
{
  const double sizes[][2] = { { 256, 8 }, { 1024, 8 }, { 256, 16 }, { 1024, 16 } };
  for (const auto& size : sizes)
  {
    const auto table = MakeOpacityTable(int(size[0]), size[1]);
    const double law = std::pow(size[1] / (size[0] - 1), 2) / 8;
    double largest = 0;
    for (int i = 0; i <= 100000; ++i)
    {
      const double u = size[1] * i / 100000;
      largest = std::max(largest, std::fabs(LookUpOpacity(table, size[1], u) + std::expm1(-u)));
    }
    std::cout << size[0] << " entries to " << size[1] << ": " << largest << ", law " << law
              << std::endl;
    EXPECT_LT(largest, law + 6e-8);
    EXPECT_GT(largest, 0.9 * law);
    EXPECT_NEAR(LookUpOpacity(table, size[1], 1e6), 1 - std::exp(-size[1]), 6e-8)
      << "beyond the end";
  }
  const auto used = MakeOpacityTable();
  EXPECT_LT(std::fabs(LookUpOpacity(used, opacityTableEnd, 1.0) - 0.6321205588285577), 3.2e-5);
  const auto small = MakeOpacityTable(256, 8);
  EXPECT_LT(std::fabs(LookUpOpacity(small, 8.0, 0.45868) + std::expm1(-0.45868)), 1.3e-4);
}
