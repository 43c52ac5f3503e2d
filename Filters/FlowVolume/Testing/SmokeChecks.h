// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Flows given by formulas, and what must be true of every flow volume.
#ifndef nephoscope_SmokeChecks_h
#define nephoscope_SmokeChecks_h

#include "SteadyVolume.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <utility>

namespace nephoscope_test
{
using namespace nephoscope;

constexpr double pi = 3.14159265358979323846;

// The velocity at a position, or false outside.
using Formula = std::function<bool(const Vector3&, Vector3&)>;

class FormulaField : public VelocityField
{
public:
  explicit FormulaField(Formula formula)
    : Velocity(std::move(formula))
  {
  }

  void Sample(const SampleBatch& batch) const override
  {
    for (std::size_t i = 0; i < batch.Count; ++i)
    {
      batch.Inside[i] = this->Velocity(batch.Positions[i], batch.Velocities[i]);
    }
  }

private:
  Formula Velocity;
};

inline FormulaField Everywhere(const std::function<Vector3(double, double, double)>& velocity)
{
  return FormulaField([velocity](const Vector3& p, Vector3& v) {
    v = velocity(p[0], p[1], p[2]);
    return true;
  });
}

inline FormulaField Uniform()
{
  return Everywhere([](double, double, double) { return Vector3{ { 0.0, 0.0, 1.0 } }; });
}
inline FormulaField Saddle()
{
  return Everywhere([](double x, double y, double) { return Vector3{ { x, -y, 1.0 } }; });
}
inline FormulaField Helix()
{
  return Everywhere([](double x, double y, double) {
    return Vector3{ { -2.0 * pi * y, 2.0 * pi * x, 1.0 } };
  });
}
inline FormulaField Spreading()
{
  return Everywhere([](double x, double y, double) { return Vector3{ { x, y, 1.0 } }; });
}
inline FormulaField Converging()
{
  return Everywhere([](double x, double y, double) { return Vector3{ { -x, -y, 1.0 } }; });
}
// Arnold, Beltrami and Childress, with the square roots of 3, 2 and 1.
inline FormulaField ABC()
{
  const double a = std::sqrt(3.0), b = std::sqrt(2.0), c = 1.0;
  return Everywhere([a, b, c](double x, double y, double z) {
    return Vector3{ { a * std::sin(z) + c * std::cos(y), b * std::sin(x) + a * std::cos(z),
      c * std::sin(y) + b * std::cos(x) } };
  });
}

// A right-angled triangle with legs along two directions, of n x n small ones.
inline PolygonMesh Triangle(
  const Vector3& corner, const Vector3& first, const Vector3& second, int n)
{
  PolygonMesh mesh;
  const auto number = [n](int i, int j) { return PointId(j * (n + 1) - j * (j - 1) / 2 + i); };
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i + j <= n; ++i)
    {
      Vector3 p = corner;
      for (std::size_t c = 0; c < 3; ++c)
      {
        p[c] += first[c] * i / n + second[c] * j / n;
      }
      mesh.Points.push_back(p);
      if (i + j < n)
      {
        mesh.Triangles.push_back({ { number(i, j), number(i + 1, j), number(i, j + 1) } });
      }
      if (i + j < n - 1)
      {
        mesh.Triangles.push_back({ { number(i + 1, j), number(i + 1, j + 1), number(i, j + 1) } });
      }
    }
  }
  return mesh;
}

// The triangle (.3, .3, 0), (.5, .3, 0), (.3, .5, 0): flux .02 through it for a flow with w = 1.
inline PolygonMesh SmallTriangle(int n)
{
  return Triangle({ { 0.3, 0.3, 0.0 } }, { { 0.2, 0.0, 0.0 } }, { { 0.0, 0.2, 0.0 } }, n);
}
// A square around (0, 0, z), of n x n squares of two triangles.
inline PolygonMesh Square(double half, int n, double z = 0.0)
{
  PolygonMesh mesh;
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      mesh.Points.push_back({ { half * (2.0 * i / n - 1.0), half * (2.0 * j / n - 1.0), z } });
      if (i < n && j < n)
      {
        const PointId p = j * (n + 1) + i;
        mesh.Triangles.push_back({ { p, p + 1, p + n + 2 } });
        mesh.Triangles.push_back({ { p, p + n + 2, p + n + 1 } });
      }
    }
  }
  return mesh;
}

inline FlowVolumeSettings Steps(double duration, int steps)
{
  FlowVolumeSettings settings;
  settings.Duration = duration;
  settings.TimeStep = duration / steps;
  settings.MaximumTurnAngle = 0.0;
  settings.MaximumHalvings = 0;
  return settings;
}

inline SmokeMesh Build(
  const VelocityField& field, const PolygonMesh& polygon, const FlowVolumeSettings& settings)
{
  return BuildSteadyVolume(field, polygon, settings, 0.0, [](double) { return true; });
}

inline double Volume(const SmokeMesh& mesh, std::size_t t)
{
  std::array<Vector3, 4> p;
  for (std::size_t i = 0; i < 4; ++i)
  {
    p[i] = mesh.Points[static_cast<std::size_t>(mesh.Tetrahedra[t][i])];
  }
  double e[3][3];
  for (std::size_t i = 0; i < 3; ++i)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      e[i][c] = p[i + 1][c] - p[0][c];
    }
  }
  return (e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
           e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
           e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0])) /
    6.0;
}

inline double TotalVolume(const SmokeMesh& mesh)
{
  double sum = 0.0;
  for (std::size_t t = 0; t < mesh.Tetrahedra.size(); ++t)
  {
    sum += Volume(mesh, t);
  }
  return sum;
}

inline double TotalMass(const SmokeMesh& mesh)
{
  double sum = 0.0;
  for (std::size_t t = 0; t < mesh.Tetrahedra.size(); ++t)
  {
    sum += mesh.Densities[t] * Volume(mesh, t);
  }
  return sum;
}

// The faces that belong to one tetrahedron, as directed triangles.
inline std::vector<std::array<PointId, 3>> BoundaryFaces(const SmokeMesh& mesh)
{
  static constexpr std::size_t faces[4][3] = { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 0, 3, 2 } };
  std::map<std::array<PointId, 3>, std::pair<int, std::array<PointId, 3>>> uses;
  for (const auto& t : mesh.Tetrahedra)
  {
    for (const auto& face : faces)
    {
      const std::array<PointId, 3> directed = { { t[face[0]], t[face[1]], t[face[2]] } };
      auto key = directed;
      std::sort(key.begin(), key.end());
      ++uses[key].first;
      uses[key].second = directed;
    }
  }
  std::vector<std::array<PointId, 3>> boundary;
  for (const auto& use : uses)
  {
    EXPECT_LE(use.second.first, 2) << "a face of three tetrahedra";
    if (use.second.first == 1)
    {
      boundary.push_back(use.second.second);
    }
  }
  return boundary;
}

// No cracks: the boundary is closed (every directed edge has its opposite). No point of the mesh
// lies inside an edge of the boundary (a hanging point), no tetrahedron has a volume of zero or
// less, all points are used.
inline std::size_t ExpectConforming(const SmokeMesh& mesh)
{
  std::set<PointId> used;
  for (std::size_t t = 0; t < mesh.Tetrahedra.size(); ++t)
  {
    EXPECT_GT(Volume(mesh, t), 0.0) << "tetrahedron " << t;
    used.insert(mesh.Tetrahedra[t].begin(), mesh.Tetrahedra[t].end());
  }
  EXPECT_EQ(used.size(), mesh.Points.size());
  const auto boundary = BoundaryFaces(mesh);
  std::map<std::pair<PointId, PointId>, int> balance;
  for (const auto& face : boundary)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      const PointId a = face[i], b = face[(i + 1) % 3];
      balance[std::minmax(a, b)] += a < b ? 1 : -1;
    }
  }
  // A hanging point would be the middle of a halved edge, to the bit.
  const std::set<Vector3> points(mesh.Points.begin(), mesh.Points.end());
  std::size_t open = 0, hanging = 0;
  for (const auto& edge : balance)
  {
    const auto& p = mesh.Points[static_cast<std::size_t>(edge.first.first)];
    const auto& q = mesh.Points[static_cast<std::size_t>(edge.first.second)];
    open += edge.second != 0;
    hanging += points.count({ { 0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1]), 0.5 * (p[2] + q[2]) } });
  }
  EXPECT_EQ(open, 0u) << "open edges of the boundary";
  EXPECT_EQ(hanging, 0u) << "hanging points";
  return boundary.size();
}

// The sum of density times volume is the kept mass, for every emission step and for all.
inline void ExpectTrueMass(const SmokeMesh& mesh)
{
  std::vector<double> steps(mesh.Report.MassPerStep.size(), 0.0);
  for (std::size_t t = 0; t < mesh.Tetrahedra.size(); ++t)
  {
    steps.at(static_cast<std::size_t>(mesh.EmissionSteps[t])) +=
      mesh.Densities[t] * Volume(mesh, t);
  }
  for (std::size_t k = 0; k < steps.size(); ++k)
  {
    EXPECT_NEAR(steps[k], mesh.Report.MassPerStep[k], 1e-12 * mesh.Report.MassPerStep[k]) << k;
  }
  EXPECT_NEAR(TotalMass(mesh), mesh.Report.KeptMass, 1e-12 * mesh.Report.KeptMass);
  EXPECT_NEAR(mesh.Report.KeptMass + mesh.Report.LostMass, mesh.Report.EmittedMass,
    1e-12 * mesh.Report.EmittedMass);
}
}

#endif
