// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The faces method without OpenGL: every face once, closed volumes at every pixel, one medium in
// any order and on any number of threads.
#include "CellGeometry.h"
#include "FaceProjection.h"
#include "FaceSweep.h"
#include "OpticalSegment.h"
#include "TetrahedronRay.h"
#include "TransferFunctionTable.h"

#include "TestGrids.h"
#include "TestRandom.h"
#include "ThreadScope.h"

#include "vtkMatrix4x4.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

using namespace nephoscope;
using namespace nephoscope_test;

namespace
{
constexpr int size = 48;

/**
 * A view along -z from a distance, as a camera's matrices have it; `angle` 0: parallel, half a
 * height of 1.
 */
struct TestView
{
  vtkNew<vtkMatrix4x4> ModelToView, ViewToDevice;
  double Eye[4] = { 0, 0, 0, 1 };

  TestView(double distance, double near, double far, bool parallel)
  {
    // Turned a little about x and y, so that no face is seen edge-on.
    const double a = 0.3, b = 0.4;
    const double turn[3][3] = { { std::cos(b), 0, std::sin(b) },
      { std::sin(a) * std::sin(b), std::cos(a), -std::sin(a) * std::cos(b) },
      { -std::cos(a) * std::sin(b), std::sin(a), std::cos(a) * std::cos(b) } };
    for (int r = 0; r < 3; ++r)
    {
      for (int c = 0; c < 3; ++c)
      {
        this->ModelToView->SetElement(r, c, turn[r][c]);
      }
    }
    this->ModelToView->SetElement(2, 3, -distance);
    const double depth = far - near;
    this->ViewToDevice->SetElement(2, 2, parallel ? -2 / depth : -(far + near) / depth);
    this->ViewToDevice->SetElement(
      2, 3, parallel ? -(far + near) / depth : -2 * far * near / depth);
    this->ViewToDevice->SetElement(3, 2, parallel ? 0 : -1);
    this->ViewToDevice->SetElement(3, 3, parallel ? 1 : 0);
    if (parallel)
    {
      this->Eye[2] = 1;
      this->Eye[3] = 0;
    }
  }
  FaceView View() const
  {
    return FaceView(this->ModelToView, this->ViewToDevice, this->Eye, size, size);
  }
};

/** A lattice of n^3 hexahedra over [-.5, .5]^3 with wobbly inner points, and a scalar. */
struct TestMesh
{
  CellGeometry Geometry;
  FaceMesh Faces;
  std::vector<std::uint8_t> Visible;

  explicit TestMesh(int n)
  {
    Random random(51);
    auto grid = MakeStructuredGrid(n, n, n, [&](double i, double j, double k, double x[3]) {
      const double at[3] = { i, j, k };
      for (int axis = 0; axis < 3; ++axis)
      {
        const bool inner = at[0] * at[1] * at[2] * (n - at[0]) * (n - at[1]) * (n - at[2]) > 0;
        x[axis] = (at[axis] + (inner ? random.Uniform(-0.2, 0.2) : 0)) / n - 0.5;
      }
    });
    ScalarSelection scalars;
    scalars.Array = AddPointNumbers(grid);
    EXPECT_EQ(this->Geometry.Build(grid, scalars), "");
    this->Faces.Build(this->Geometry);
    this->Visible.assign(this->Geometry.Tetrahedra.size(), 1);
  }
};

TransferFunctionTable ConstantMedium()
{
  TransferFunctionTable table;
  table.Nodes = { 0.5f };
  table.Widths = { 0.0f };
  const TransferFunctionTable::Value value = { { 0.8f, 0.5f, 0.2f, 1.0f } };
  table.Intervals = { { value, value }, { value, value } };
  return table;
}

std::vector<float> Draw(
  const TestMesh& mesh, const FaceView& view, const TransferFunctionTable& table, bool sorted)
{
  FaceProjection projection;
  projection.Build(mesh.Geometry, mesh.Faces, mesh.Visible, view, sorted);
  FaceSweep::Scene scene;
  scene.Geometry = &mesh.Geometry;
  scene.Color = &table;
  scene.Opacity = &table;
  scene.ExtinctionScale = 1.5;
  return FaceSweep::Draw(scene, projection, view);
}

/** Extinction and colour vary, linearly in the scalar. */
TransferFunctionTable VaryingMedium()
{
  TransferFunctionTable table;
  table.Nodes = { 0.0f, 1.0f };
  table.Widths = { 1.0f, 0.0f };
  const TransferFunctionTable::Value low = { { 1, 0, 0, 0.2f } }, high = { { 0, 0, 1, 5 } };
  table.Intervals = { { low, low }, { low, high }, { high, high } };
  return table;
}

/** The eye, or the direction towards it, in model coordinates. */
Vector4 EyeInModel(const TestView& view)
{
  vtkNew<vtkMatrix4x4> toModel;
  vtkMatrix4x4::Invert(view.ModelToView, toModel);
  Vector4 eye;
  toModel->MultiplyPoint(view.Eye, eye.data());
  return eye;
}

/** Tetrahedra from back to front: again and again, all that have nothing behind them. */
std::vector<std::size_t> BackToFront(const TestMesh& mesh, const Vector4& eye)
{
  std::vector<std::set<std::int32_t>> behind(mesh.Geometry.Tetrahedra.size());
  for (const MeshFace& face : mesh.Faces.GetFaces())
  {
    const auto at = [&](int k) { return mesh.Geometry.Position(face.Points[std::size_t(k)]); };
    const bool firstBehind = PlaneSide(at(0), at(1), at(2), eye) > 0; // the eye sees its outside
    if (face.Second >= 0)
    {
      behind[std::size_t(firstBehind ? face.Second : face.First)].insert(
        firstBehind ? face.First : face.Second);
    }
  }
  std::vector<std::size_t> order;
  std::set<std::int32_t> drawn;
  for (std::size_t before = 1; before != order.size();)
  {
    before = order.size();
    for (std::size_t i = 0; i < behind.size(); ++i)
    {
      if (!drawn.count(std::int32_t(i)) &&
        std::includes(drawn.begin(), drawn.end(), behind[i].begin(), behind[i].end()))
      {
        drawn.insert(std::int32_t(i));
        order.push_back(i);
      }
    }
  }
  EXPECT_EQ(order.size(), behind.size()) << "a cycle";
  return order;
}

/**
 * Lists the tetrahedra from back to front, and in each first the vertices whose opposite faces are
 * back faces: the faces of the mesh are then listed in an exact order.
 */
void SortExactly(TestMesh& mesh, const Vector4& eye)
{
  std::vector<Tetrahedron> sorted;
  for (const std::size_t i : BackToFront(mesh, eye))
  {
    const Vector4 q = EyeCoordinates(mesh.Geometry.Vertices(i), eye);
    const Tetrahedron& t = mesh.Geometry.Tetrahedra[i];
    Tetrahedron renumbered;
    int next = 0;
    for (const bool back : { true, false })
    {
      for (int k = 0; k < 4; ++k)
      {
        if ((q[k] > 0) == back)
        {
          renumbered[next++] = t[k];
        }
      }
    }
    sorted.push_back(renumbered);
  }
  mesh.Geometry.Tetrahedra = TetrahedronList(sorted);
  mesh.Faces.Build(mesh.Geometry);
}

Vector4 Barycentric(const std::array<Vector3, 4>& p, const Vector3& x)
{
  Vector4 result;
  for (int i = 0; i < 4; ++i)
  {
    const auto& f = tetrahedronFaces[i];
    result[i] = PlaneSide(p[f[0]], p[f[1]], p[f[2]], { { x[0], x[1], x[2], 1 } }) /
      PlaneSide(p[f[0]], p[f[1]], p[f[2]], { { p[i][0], p[i][1], p[i][2], 1 } });
  }
  return result;
}

struct Ray
{
  Vector3 Origin, Direction; ///< in model coordinates; z in view coordinates falls by 1 per unit
};

Ray RayOfPixel(const TestView& view, int x, int y)
{
  vtkNew<vtkMatrix4x4> toModel;
  vtkMatrix4x4::Invert(view.ModelToView, toModel);
  const bool parallel = view.Eye[3] == 0;
  const double u = 2 * (x + 0.5) / size - 1, v = 2 * (y + 0.5) / size - 1;
  const double origin[4] = { parallel ? u : 0, parallel ? v : 0, 0, 1 };
  const double direction[4] = { parallel ? 0 : u, parallel ? 0 : v, -1, 0 };
  double o[4], d[4];
  toModel->MultiplyPoint(origin, o);
  toModel->MultiplyPoint(direction, d);
  return { { { o[0], o[1], o[2] } }, { { d[0], d[1], d[2] } } };
}

/**
 * Blue and alpha of a pixel: tetrahedra, sorted from back to front, one by one, by clipping in
 * barycentric coordinates.
 */
std::array<double, 2> CompositeCells(const TestMesh& mesh, const Ray& ray)
{
  const auto& t = mesh.Geometry.Tetrahedra;
  std::array<double, 2> light = { { 0, 0 } };
  for (std::size_t i = 0; i < t.size(); ++i)
  {
    const auto vertices = mesh.Geometry.Vertices(i);
    const Vector3& o = ray.Origin;
    const Vector3 ahead = { { o[0] + ray.Direction[0], o[1] + ray.Direction[1],
      o[2] + ray.Direction[2] } };
    const Vector4 at = Barycentric(vertices, o), next = Barycentric(vertices, ahead);
    double low = 0, high = 1e9;
    for (int k = 0; k < 4; ++k)
    {
      const double slope = next[k] - at[k];
      (slope > 0 ? low : high) =
        slope > 0 ? std::max(low, -at[k] / slope) : std::min(high, -at[k] / slope);
    }
    if (high > low)
    {
      const auto scalar = [&](double place) {
        double s = 0;
        for (int k = 0; k < 4; ++k)
        {
          s +=
            (at[k] + place * (next[k] - at[k])) * mesh.Geometry.Points[std::size_t(t[i][k])].Scalar;
        }
        return s;
      };
      const double length = (high - low) * std::sqrt(Dot(ray.Direction, ray.Direction));
      const double front = scalar(low), back = scalar(high);
      const auto depth = [&](double s) { return 1.5 * length * (0.2 + 4.8 * s); };
      const auto weights = ExactSegmentWeights(depth(front), depth(back));
      light[0] = (1 - weights.Alpha()) * light[0] + weights.Front * front + weights.Back * back;
      light[1] = (1 - weights.Alpha()) * light[1] + weights.Alpha();
    }
  }
  return light;
}

/** Length of the pixel's ray in the cube [-.5, .5]^3 beyond the near plane, by clipping. */
double LengthInCube(const TestView& view, double near, int x, int y)
{
  const Ray ray = RayOfPixel(view, x, y);
  double low = near, high = 1e9;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double a = (-0.5 - ray.Origin[axis]) / ray.Direction[axis],
                 b = (0.5 - ray.Origin[axis]) / ray.Direction[axis];
    low = std::max(low, std::min(a, b));
    high = std::min(high, std::max(a, b));
  }
  return std::max(0.0, high - low) * std::sqrt(Dot(ray.Direction, ray.Direction));
}

struct Case
{
  double Distance, Near;
  bool Parallel;
};
// Outside, inside (the near plane cuts the volume), far away.
const Case cases[] = { { 1.5, 0.2, false }, { 0.1, 0.02, false }, { 0.6, 0.3, false },
  { 2, 0.5, true }, { 0.1, 0.03, true } };
}

TEST(FaceMesh, EveryFaceOnce)
{
  const TestMesh mesh(3);
  std::set<std::set<std::int32_t>> seen;
  std::map<std::int32_t, int> facesOf;
  std::size_t outer = 0;
  for (const MeshFace& face : mesh.Faces.GetFaces())
  {
    EXPECT_TRUE(seen.insert({ face.Points.begin(), face.Points.end() }).second);
    ++facesOf[face.First];
    face.Second < 0 ? ++outer : std::size_t(++facesOf[face.Second]);
  }
  EXPECT_EQ(outer, std::size_t(2 * 6 * 3 * 3));
  EXPECT_EQ(facesOf.size(), mesh.Geometry.Tetrahedra.size());
  for (const auto& [tetrahedron, count] : facesOf)
  {
    EXPECT_EQ(count, 4);
  }
}

TEST(FaceProjection, SortedByCentroids)
{
  const TestMesh mesh(3);
  const TestView view(4, 0.2, 10, false);
  FaceProjection projection;
  projection.Build(mesh.Geometry, mesh.Faces, mesh.Visible, view.View(), true);
  double last = 1e9;
  int leaving = 0, entering = 0;
  for (const ScreenFace& face : projection.GetFaces())
  {
    Vector3 centroid = { { 0, 0, 0 } };
    for (const std::int32_t point : face.Points)
    {
      const Vector3 p = mesh.Geometry.Position(point);
      centroid = { { centroid[0] + p[0] / 3, centroid[1] + p[1] / 3, centroid[2] + p[2] / 3 } };
    }
    const double distance = view.View().Distance(centroid);
    EXPECT_LE(distance, last + 1e-6);
    last = distance;
    leaving += face.Mark() == 1;
    entering += face.Mark() == -1;
  }
  EXPECT_EQ(leaving + entering, 2 * 6 * 3 * 3);
  EXPECT_EQ(entering, 3 * 2 * 3 * 3) << "three sides of the cube are seen";
}

TEST(FaceSweep, OneMediumInAnyOrder)
{
  const TestMesh mesh(4);
  const TransferFunctionTable table = ConstantMedium();
  for (const Case& c : cases)
  {
    const TestView view(c.Distance, c.Near, 10, c.Parallel);
    for (const bool sorted : { true, false })
    {
      const std::vector<float> rgba = Draw(mesh, view.View(), table, sorted);
      double worst = 0;
      for (int y = 0; y < size; ++y)
      {
        for (int x = 0; x < size; ++x)
        {
          const float* pixel = rgba.data() + 4 * (y * size + x);
          const double alpha = -std::expm1(-1.5 * LengthInCube(view, c.Near, x, y));
          worst =
            std::max({ worst, std::fabs(pixel[3] - alpha), std::fabs(pixel[0] - 0.8 * alpha) });
        }
      }
      EXPECT_LT(worst, 1e-5) << "from " << c.Distance << ", near " << c.Near << ", parallel "
                             << c.Parallel << ", sorted " << sorted; // points are kept in float
    }
  }
}

/**
 * The same as cell by cell, whatever the medium, where the faces come in the right order; by their
 * centroids they do not.
 */
TEST(FaceSweep, VaryingMediumInTheRightOrder)
{
  double worstByCentroids = 0;
  for (const bool parallel : { false, true })
  {
    TestMesh mesh(3);
    Random random(53);
    for (auto& point : mesh.Geometry.Points)
    {
      point.Scalar = float(random.Uniform());
    }
    const TestView view(2, 0.2, 10, parallel);
    SortExactly(mesh, EyeInModel(view));
    const auto largestError = [&](bool sorted) {
      const std::vector<float> rgba = Draw(mesh, view.View(), VaryingMedium(), sorted);
      double largest = 0;
      for (int i = 0; i < size * size; ++i)
      {
        const auto light = CompositeCells(mesh, RayOfPixel(view, i % size, i / size));
        largest = std::max({ largest, std::fabs(rgba[4 * i + 2] - light[0]),
          std::fabs(rgba[4 * i + 3] - light[1]) });
      }
      return largest;
    };
    EXPECT_LT(largestError(false), 2e-6) << "parallel " << parallel;
    worstByCentroids = std::max(worstByCentroids, largestError(true));
  }
  EXPECT_GT(worstByCentroids, 1e-4) << "the centroids must be seen to be wrong";
}

/** Where some cells are left out, rays leave and enter the volume several times. */
TEST(FaceSweep, HolesInAnyOrder)
{
  TestMesh mesh(4);
  const TestView view(1.5, 0.2, 10, false);
  Random random(52);
  for (auto& visible : mesh.Visible)
  {
    visible = random.Integer(0, 2) > 0;
  }
  const TransferFunctionTable table = ConstantMedium();
  const std::vector<float> sorted = Draw(mesh, view.View(), table, true);
  const std::vector<float> unsorted = Draw(mesh, view.View(), table, false);
  float largest = 0, difference = 0;
  for (std::size_t i = 0; i < sorted.size(); ++i)
  {
    largest = std::max(largest, sorted[i]);
    difference = std::max(difference, std::fabs(sorted[i] - unsorted[i]));
  }
  EXPECT_GT(largest, 0.3f);
  EXPECT_LT(difference, 1e-6f);
}

TEST(FaceSweep, SameOnAnyNumberOfThreads)
{
  const TestMesh mesh(4);
  const TestView view(1.5, 0.2, 10, false);
  const TransferFunctionTable table = VaryingMedium();
  std::vector<float> first;
  for (const int threads : { 1, 2, 4 })
  {
    std::vector<float> rgba;
    WithThreads(threads, [&]() { rgba = Draw(mesh, view.View(), table, true); });
    first = first.empty() ? rgba : first;
    EXPECT_EQ(rgba, first) << threads << " threads";
  }
}

TEST(FaceSweep, NothingVisible)
{
  TestMesh mesh(2);
  mesh.Visible.assign(mesh.Visible.size(), 0);
  const TestView view(1.5, 0.2, 10, false);
  const std::vector<float> rgba = Draw(mesh, view.View(), ConstantMedium(), true);
  EXPECT_EQ(*std::max_element(rgba.begin(), rgba.end()), 0.0f);
}
