// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** Meshes that are hard to order: with holes, in parts, in cycles. */
#ifndef nephoscope_OrderMeshes_h
#define nephoscope_OrderMeshes_h

#include "CellGeometry.h"

#include "TestGrids.h"
#include "TestRandom.h"

#include "vtkCellType.h"
#include "vtkDelaunay3D.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <cmath>

namespace nephoscope_test
{

using namespace nephoscope;

inline CellGeometry BuildGeometry(vtkDataSet* data)
{
  CellGeometry geometry;
  EXPECT_EQ(geometry.Build(data, { AddPointNumbers(data), false, -1 }), "");
  return geometry;
}

/** Points and cells that grow block by block; points are not shared between blocks. */
class BlockMesh
{
public:
  /**
   * A box of n0 x n1 x n2 hexahedra, those left out for which skip(i, j, k), with corners moved by
   * `place`.
   */
  template <typename Skip, typename Move>
  void AddBox(const int n[3], Skip skip, Move place)
  {
    const vtkIdType first = vtkIdType(this->Points.size());
    for (int k = 0; k <= n[2]; ++k)
    {
      for (int j = 0; j <= n[1]; ++j)
      {
        for (int i = 0; i <= n[0]; ++i)
        {
          this->Points.push_back(place(double(i) / n[0], double(j) / n[1], double(k) / n[2]));
        }
      }
    }
    const auto id = [&](int i, int j, int k) {
      return first + i + (n[0] + 1) * (j + vtkIdType(n[1] + 1) * k);
    };
    for (int k = 0; k < n[2]; ++k)
    {
      for (int j = 0; j < n[1]; ++j)
      {
        for (int i = 0; i < n[0]; ++i)
        {
          if (!skip(i, j, k))
          {
            this->Cells.push_back({ VTK_HEXAHEDRON,
              { id(i, j, k), id(i + 1, j, k), id(i + 1, j + 1, k), id(i, j + 1, k), id(i, j, k + 1),
                id(i + 1, j, k + 1), id(i + 1, j + 1, k + 1), id(i, j + 1, k + 1) } });
          }
        }
      }
    }
  }
  void AddBox(
    int n0, int n1, int n2, const std::array<double, 3>& low, const std::array<double, 3>& high)
  {
    const int n[3] = { n0, n1, n2 };
    this->AddBox(
      n, [](int, int, int) { return false; },
      [&](double x, double y, double z) {
        return std::array<double, 3>{ { low[0] + x * (high[0] - low[0]),
          low[1] + y * (high[1] - low[1]), low[2] + z * (high[2] - low[2]) } };
      });
  }
  vtkSmartPointer<vtkUnstructuredGrid> Get() const { return MakeGrid(this->Points, this->Cells); }

private:
  std::vector<std::array<double, 3>> Points;
  std::vector<std::pair<int, std::vector<vtkIdType>>> Cells;
};

inline std::array<double, 3> Centered(double x, double y, double z)
{
  return { { x - 0.5, y - 0.5, z - 0.5 } };
}

/** The cube [-0.5, 0.5]^3 of n^3 hexahedra with some left out. */
template <typename Skip>
vtkSmartPointer<vtkUnstructuredGrid> MakeCubeWithout(int n, Skip skip)
{
  BlockMesh mesh;
  const int size[3] = { n, n, n };
  mesh.AddBox(size, skip, Centered);
  return mesh.Get();
}

inline vtkSmartPointer<vtkUnstructuredGrid> MakeDelaunay(Random& random, int n)
{
  vtkNew<vtkPoints> points;
  for (int i = 0; i < n; ++i)
  {
    points->InsertNextPoint(random.Uniform(), random.Uniform(), random.Uniform());
  }
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(points);
  vtkNew<vtkDelaunay3D> delaunay;
  delaunay->SetInputData(cloud);
  delaunay->Update();
  vtkNew<vtkUnstructuredGrid> grid;
  grid->DeepCopy(delaunay->GetOutput());
  return grid;
}

/** The tetrahedra of a geometry for which keep(number), in the order of the numbers given. */
template <typename Keep>
vtkSmartPointer<vtkUnstructuredGrid> PickTetrahedra(
  const CellGeometry& geometry, const std::vector<std::int32_t>& numbers, Keep keep)
{
  std::vector<std::array<double, 3>> points;
  for (std::size_t i = 0; i < geometry.Points.size(); ++i)
  {
    points.push_back(geometry.Position(std::int32_t(i)));
  }
  std::vector<std::pair<int, std::vector<vtkIdType>>> cells;
  for (const std::int32_t i : numbers)
  {
    const Tetrahedron& t = geometry.Tetrahedra[std::size_t(i)];
    if (keep(i))
    {
      cells.push_back({ VTK_TETRA, { t[0], t[1], t[2], t[3] } });
    }
  }
  return MakeGrid(points, cells);
}

/**
 * A ring of n prisms around the z axis between triangles that all lean forward: seen from above,
 * each prism lies over the next one, all the way round.
 */
inline vtkSmartPointer<vtkUnstructuredGrid> MakeLeaningRing(int n)
{
  const double turn = 2 * std::acos(-1.0) / n;
  const double lean = 0.6;
  std::vector<std::array<double, 3>> points;
  for (int i = 0; i < n; ++i)
  {
    const double c = std::cos(i * turn), s = std::sin(i * turn);
    const double corners[3][3] = { { 1, lean, 0.5 }, { 0.8, -lean, -0.5 },
      { 1.2, -lean, -0.5 } }; // radius, forward, z
    for (const auto& corner : corners)
    {
      points.push_back(
        { { corner[0] * c - corner[1] * s, corner[0] * s + corner[1] * c, corner[2] } });
    }
  }
  std::vector<std::pair<int, std::vector<vtkIdType>>> cells;
  for (int i = 0; i < n; ++i)
  {
    const vtkIdType a = 3 * i, next = 3 * ((i + 1) % n);
    cells.push_back({ VTK_TETRA, { a, a + 1, a + 2, next } });
    cells.push_back({ VTK_TETRA, { a + 1, a + 2, next, next + 1 } });
    cells.push_back({ VTK_TETRA, { a + 2, next, next + 1, next + 2 } });
  }
  return MakeGrid(points, cells);
}

/**
 * A tube around the z axis in n sectors, m layers and m levels, twisted: each sector leans over the
 * next.
 */
inline vtkSmartPointer<vtkStructuredGrid> MakeTwistedTube(int n, int m, double twist)
{
  const double pi = std::acos(-1.0);
  return MakeStructuredGrid(n, m, m, [=](double i, double j, double k, double x[3]) {
    const double angle = 2 * pi * std::fmod(i, n) / n + twist * (k / m - 0.5),
                 r = 0.6 + 0.4 * j / m;
    x[0] = r * std::cos(angle);
    x[1] = r * std::sin(angle);
    x[2] = k / m - 0.5;
  });
}

} // namespace nephoscope_test

#endif
