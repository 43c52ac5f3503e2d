// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// What CellGeometry makes of every kind of dataset and cell.
#include "BuiltGeometry.h"

#include "TestRandom.h"
#include "ThreadScope.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkCellTypeSource.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

using namespace nephoscope;
using namespace nephoscope_test;

namespace
{
void ExpectSame(const CellGeometry& a, const CellGeometry& b)
{
  ASSERT_EQ(a.Points.size(), b.Points.size());
  for (std::size_t i = 0; i < a.Points.size(); ++i)
  {
    ASSERT_EQ(std::memcmp(&a.Points[i], &b.Points[i], sizeof(CellGeometry::Point)), 0);
  }
  EXPECT_EQ(a.Tetrahedra.Copy(), b.Tetrahedra.Copy());
  EXPECT_EQ(a.CellScalars, b.CellScalars);
  EXPECT_EQ(a.NumberOfFlatTetrahedra, b.NumberOfFlatTetrahedra);
  EXPECT_EQ(a.NumberOfInvalidCells, b.NumberOfInvalidCells);
  EXPECT_EQ(a.NumberOfUnsupportedCells, b.NumberOfUnsupportedCells);
}

/** Regular prism of circumradius 1 and height 1. */
vtkSmartPointer<vtkUnstructuredGrid> PrismOf(int type, int sides)
{
  std::vector<std::array<double, 3>> p;
  std::vector<vtkIdType> ids;
  for (int k = 0; k < 2 * sides; ++k)
  {
    const double angle = 2 * std::acos(-1.0) * (k % sides) / sides;
    p.push_back({ { std::cos(angle), std::sin(angle), double(k / sides) } });
    ids.push_back(k);
  }
  return MakeGrid(p, { { type, ids } });
}
}

TEST(CellGeometry, LinearCells)
{
  for (const int type : { VTK_TETRA, VTK_HEXAHEDRON, VTK_VOXEL, VTK_WEDGE, VTK_PYRAMID })
  {
    const CellGeometry geometry = BuildNumbered(UnitCubeOf(type));
    EXPECT_NEAR(VolumeOf(geometry), 1, 1e-6) << "cell type " << type;
    EXPECT_EQ(geometry.NumberOfUnsupportedCells + geometry.NumberOfInvalidCells, 0);
  }
  const double turn = 2 * std::acos(-1.0);
  EXPECT_NEAR(
    VolumeOf(BuildNumbered(PrismOf(VTK_PENTAGONAL_PRISM, 5))), 2.5 * std::sin(turn / 5), 1e-6);
  EXPECT_NEAR(
    VolumeOf(BuildNumbered(PrismOf(VTK_HEXAGONAL_PRISM, 6))), 3 * std::sin(turn / 6), 1e-6);
}

TEST(CellGeometry, Polyhedra)
{
  auto grid = UnitCubeOf(VTK_HEXAHEDRON);
  const vtkIdType corner = 0;
  grid->InsertNextCell(VTK_VERTEX, 1, &corner); // not hexahedra alone: divided by coordinates
  vtkNew<vtkUnstructuredGrid> polyhedra;
  polyhedra->SetPoints(grid->GetPoints());
  const vtkIdType faces[] = { 6, 4, 0, 4, 7, 3, 4, 1, 2, 6, 5, 4, 0, 1, 5, 4, 4, 3, 7, 6, 2, 4, 0,
    3, 2, 1, 4, 4, 5, 6, 7 };
  vtkNew<vtkIdList> stream;
  for (const vtkIdType value : faces)
  {
    stream->InsertNextId(value);
  }
  polyhedra->InsertNextCell(VTK_POLYHEDRON, stream);
  const CellGeometry geometry = BuildNumbered(polyhedra);
  EXPECT_NEAR(VolumeOf(geometry), 1, 1e-6);
  EXPECT_EQ(geometry.Tetrahedra.Copy(), BuildNumbered(grid).Tetrahedra.Copy())
    << "a cube is cut the same whatever its cell type";
}

TEST(CellGeometry, QuadraticTetrahedronAsVTKTriangulatesIt)
{
  vtkNew<vtkCellTypeSource> source;
  source->SetCellType(VTK_QUADRATIC_TETRA);
  source->SetBlocksDimensions(2, 2, 2);
  source->Update();
  const CellGeometry geometry = BuildNumbered(source->GetOutput());
  double bounds[6];
  source->GetOutput()->GetBounds(bounds);
  const double box = (bounds[1] - bounds[0]) * (bounds[3] - bounds[2]) * (bounds[5] - bounds[4]);
  EXPECT_NEAR(VolumeOf(geometry), box, 1e-5 * box);
  EXPECT_EQ(geometry.NumberOfUnsupportedCells, 0);
}

// VTK 9.2 divides four of these kinds into nothing, or into wedges.
TEST(CellGeometry, HigherOrderCellsFillTheirVolume)
{
  const std::pair<int, double> kinds[] = { { VTK_QUADRATIC_TETRA, 1.0 / 6 },
    { VTK_QUADRATIC_HEXAHEDRON, 1 }, { VTK_TRIQUADRATIC_HEXAHEDRON, 1 },
    { VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON, 1 }, { VTK_QUADRATIC_WEDGE, 0.5 },
    { VTK_QUADRATIC_LINEAR_WEDGE, 0.5 }, { VTK_BIQUADRATIC_QUADRATIC_WEDGE, 0.5 } };
  for (const auto& kind : kinds)
  {
    vtkNew<vtkGenericCell> cell;
    cell->SetCellType(kind.first);
    const double* places = cell->GetParametricCoords();
    vtkNew<vtkPoints> points;
    std::vector<vtkIdType> ids(static_cast<std::size_t>(cell->GetNumberOfPoints()));
    std::iota(ids.begin(), ids.end(), 0);
    for (std::size_t i = 0; i < ids.size(); ++i)
    {
      points->InsertNextPoint(places + 3 * i);
    }
    vtkNew<vtkUnstructuredGrid> grid;
    grid->SetPoints(points);
    grid->InsertNextCell(kind.first, static_cast<vtkIdType>(ids.size()), ids.data());
    EXPECT_NEAR(VolumeOf(BuildNumbered(grid)), kind.second, 1e-6) << "cell type " << kind.first;
  }
}

TEST(CellGeometry, ImageData)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(5, 4, 3);
  image->SetSpacing(0.5, 1, 2);
  image->SetOrigin(10, 20, 30);
  const CellGeometry geometry = BuildNumbered(image);
  EXPECT_NEAR(VolumeOf(geometry), 2 * 3 * 4, 1e-4);
  EXPECT_EQ(geometry.Tetrahedra.size(), 5u * 4 * 3 * 2);
  EXPECT_EQ(geometry.Center[0], 11);
  EXPECT_EQ(geometry.Center[1], 21.5);
  EXPECT_EQ(geometry.Center[2], 32);
}

TEST(CellGeometry, RectilinearGrid)
{
  vtkNew<vtkRectilinearGrid> grid;
  grid->SetDimensions(4, 3, 2);
  vtkNew<vtkDoubleArray> x, y, z;
  for (const double value : { 0.0, 0.1, 2.0, 3.0 })
  {
    x->InsertNextValue(value);
  }
  for (const double value : { -1.0, 0.0, 5.0 })
  {
    y->InsertNextValue(value);
  }
  z->InsertNextValue(0);
  z->InsertNextValue(0.5);
  grid->SetXCoordinates(x);
  grid->SetYCoordinates(y);
  grid->SetZCoordinates(z);
  EXPECT_NEAR(VolumeOf(BuildNumbered(grid)), 3 * 6 * 0.5, 1e-5);
}

TEST(CellGeometry, PoleOfAShell)
{
  // Up to the poles: the ends of the meridians coincide, and cells there lose an edge, but no
  // volume.
  const CellGeometry geometry = BuildNumbered(MakeShell(48, 24, 2, 90, 1, 1.2));
  EXPECT_EQ(geometry.NumberOfInvalidCells + geometry.NumberOfUnsupportedCells, 0);
  EXPECT_GT(geometry.Tetrahedra.size(), 48u * 22 * 2 * 5);
  // Inscribed polyhedra: smaller than the shell between spheres by about (pi/48)^2.
  const double exact = 4.0 / 3 * std::acos(-1.0) * (1.2 * 1.2 * 1.2 - 1);
  EXPECT_NEAR(VolumeOf(geometry), exact, 0.01 * exact);
  for (const Tetrahedron& t : geometry.Tetrahedra.Copy())
  {
    for (const std::int32_t p : t)
    {
      ASSERT_LT(std::size_t(p), geometry.Points.size());
    }
  }
}

TEST(CellGeometry, FlatAndUnsupportedCells)
{
  auto grid = MakeGrid(
    { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 1, 1, 0 } }, { { 0, 0, 1 } } },
    { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 0, 1, 2, 4 } }, { VTK_TRIANGLE, { 0, 1, 2 } },
      { VTK_LINE, { 0, 1 } }, { VTK_EMPTY_CELL, {} } });
  const CellGeometry geometry = BuildNumbered(grid);
  EXPECT_EQ(geometry.Tetrahedra.size(), 1u);
  EXPECT_EQ(geometry.NumberOfFlatTetrahedra, 1);
  EXPECT_EQ(geometry.NumberOfUnsupportedCells, 2);
  EXPECT_TRUE(
    geometry.UnsupportedCellType == VTK_TRIANGLE || geometry.UnsupportedCellType == VTK_LINE);
}

TEST(CellGeometry, HugeCoordinates)
{
  auto grid = MakeStructuredGrid(4, 4, 4, [](double i, double j, double k, double x[3]) {
    x[0] = 1e7 + 0.1 * i;
    x[1] = -1e7 + 0.1 * j;
    x[2] = 1e7 + 0.1 * k;
  });
  const CellGeometry geometry = BuildNumbered(grid);
  EXPECT_NEAR(VolumeOf(geometry), 0.064, 1e-6);
  for (std::size_t i = 0; i < geometry.Points.size(); ++i)
  {
    double x[3];
    grid->GetPoint(vtkIdType(i), x);
    ASSERT_NEAR(geometry.Points[i].X + geometry.Center[0], x[0], 1e-7);
  }
}

TEST(CellGeometry, Empty)
{
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkPoints> points;
  grid->SetPoints(points);
  vtkNew<vtkDoubleArray> scalars;
  CellGeometry geometry;
  EXPECT_EQ(geometry.Build(grid, { scalars, false, -1 }), "");
  EXPECT_TRUE(geometry.Tetrahedra.empty());
  EXPECT_LT(geometry.ScalarRange[0], geometry.ScalarRange[1]);

  auto flat = MakeStructuredGrid(3, 3, 0, [](double i, double j, double, double x[3]) {
    x[0] = i;
    x[1] = j;
    x[2] = 0;
  });
  geometry = BuildNumbered(flat);
  EXPECT_TRUE(geometry.Tetrahedra.empty());
  EXPECT_EQ(geometry.NumberOfUnsupportedCells, 9);
}

// Tetrahedra of the input are read from there, and nothing else is.
TEST(CellGeometry, TetrahedraOfTheInput)
{
  auto grid = UnitCubeOf(VTK_TETRA);
  const CellGeometry whole = BuildNumbered(grid);
  EXPECT_TRUE(whole.Tetrahedra.ReadsInput());
  EXPECT_TRUE(whole.Cells.empty());
  EXPECT_NEAR(VolumeOf(whole), 1, 1e-6);
  const std::vector<Tetrahedron> all = whole.Tetrahedra.Copy();
  grid->GetCells()->ConvertTo32BitStorage();
  const CellGeometry narrow = BuildNumbered(grid);
  EXPECT_TRUE(narrow.Tetrahedra.ReadsInput());
  EXPECT_EQ(narrow.Tetrahedra.Copy(), all);
  HideCell(grid, 2);
  const CellGeometry hidden = BuildNumbered(grid);
  EXPECT_FALSE(hidden.Tetrahedra.ReadsInput()) << "they have other numbers than the cells";
  EXPECT_EQ(hidden.Tetrahedra.size(), 4u);
  EXPECT_FALSE(BuildNumbered(UnitCubeOf(VTK_WEDGE)).Tetrahedra.ReadsInput());
  EXPECT_FALSE(BuildNumbered(MakeLattice(2)).Tetrahedra.ReadsInput());
}

TEST(CellGeometry, TetrahedraOfAnInputThatChanges)
{
  auto grid = UnitCubeOf(VTK_TETRA);
  CellGeometry geometry = BuildNumbered(grid);
  const std::vector<Tetrahedron> all = geometry.Tetrahedra.Copy();
  const auto other = vtkSmartPointer<vtkUnstructuredGrid>::New();
  other->DeepCopy(grid);
  EXPECT_TRUE(geometry.Tetrahedra.Follow(other));
  grid = nullptr;
  EXPECT_EQ(geometry.Tetrahedra.Copy(), all) << "read from the copy";
  vtkDataArray* ids = other->GetCells()->GetConnectivityArray();
  ids->SetComponent(3, 0, 1e6);
  EXPECT_EQ(geometry.Tetrahedra[0][3], 0) << "there is no such point";
  ids->SetComponent(3, 0, all[0][3]);
  ids->Resize(1000);
  EXPECT_TRUE(geometry.Tetrahedra.Refresh());
  EXPECT_EQ(geometry.Tetrahedra.Copy(), all);
  EXPECT_TRUE(geometry.Tetrahedra.Refresh(other));
  EXPECT_FALSE(geometry.Tetrahedra.Refresh(UnitCubeOf(VTK_TETRA))) << "another dataset";
  other->GetPoints()->InsertNextPoint(0, 0, 0);
  ids->SetComponent(3, 0, double(other->GetNumberOfPoints() - 1));
  EXPECT_TRUE(geometry.Tetrahedra.Follow(other));
  EXPECT_EQ(geometry.Tetrahedra[0][3], 0) << "the geometry has no such point";
  ids->Resize(4);
  EXPECT_FALSE(geometry.Tetrahedra.Refresh());
  EXPECT_TRUE(geometry.Tetrahedra.empty());
  EXPECT_FALSE(geometry.Tetrahedra.Follow(other)) << "to be made again";
}

// Cells are cut by places, not by numbers: blocks and ranks that number their points differently
// fit together.
TEST(CellGeometry, NumberingDoesNotChangeTheCuts)
{
  Random random(42);
  vtkNew<vtkUnstructuredGrid> original, renumbered;
  auto lattice = MakeLattice(3);
  const int n = int(lattice->GetNumberOfPoints());
  std::vector<vtkIdType> number(static_cast<std::size_t>(n));
  std::iota(number.begin(), number.end(), 0);
  std::shuffle(number.begin(), number.end(), random.GetEngine());
  original->SetPoints(lattice->GetPoints());
  vtkNew<vtkPoints> moved;
  moved->SetNumberOfPoints(n);
  for (vtkIdType i = 0; i < n; ++i)
  {
    moved->SetPoint(number[std::size_t(i)], lattice->GetPoint(i));
  }
  renumbered->SetPoints(moved);
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < lattice->GetNumberOfCells(); ++cell)
  {
    lattice->GetCellPoints(cell, ids);
    original->InsertNextCell(VTK_HEXAHEDRON, ids);
    for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
    {
      ids->SetId(k, number[std::size_t(ids->GetId(k))]);
    }
    renumbered->InsertNextCell(VTK_HEXAHEDRON, ids);
  }
  CellGeometry expected = BuildNumbered(original), actual = BuildNumbered(renumbered);
  ASSERT_EQ(expected.Tetrahedra.size(), actual.Tetrahedra.size());
  for (std::size_t i = 0; i < expected.Tetrahedra.size(); ++i)
  {
    ASSERT_EQ(expected.Vertices(i), actual.Vertices(i));
  }
}

TEST(CellGeometry, BuildForgetsTheLastInput)
{
  auto grid = MakeLattice(2);
  CellGeometry geometry =
    Build(grid, AddScalars(grid, true, [](vtkIdType i) { return double(i); }), true);
  auto shell = MakeShell(8, 4, 1, 80, 1, 2);
  ASSERT_EQ(geometry.Build(shell, { AddPointNumbers(shell), false, -1 }), "");
  ExpectSame(geometry, BuildNumbered(shell));
}

TEST(CellGeometry, ThreadsDoNotChangeTheResult)
{
  auto shell = MakeShell(48, 24, 6, 90, 1, 1.3);
  HideCell(shell, 100);
  shell->GetPoints()->SetPoint(5000, 0, std::numeric_limits<double>::quiet_NaN(), 0);
  vtkDataArray* points = AddPointNumbers(shell);
  vtkDataArray* cells = AddScalars(shell, true, [](vtkIdType i) { return std::sin(double(i)); });
  vtkNew<vtkCellTypeSource> quadratic;
  quadratic->SetCellType(VTK_QUADRATIC_TETRA);
  quadratic->SetBlocksDimensions(6, 6, 6);
  quadratic->Update();
  vtkDataArray* quadraticPoints = AddPointNumbers(quadratic->GetOutput());
  CellGeometry reference[3];
  for (const int threads : { 1, 2, 4 })
  {
    WithThreads(threads, [&]() {
      const CellGeometry results[3] = { Build(shell, points), Build(shell, cells, true),
        Build(quadratic->GetOutput(), quadraticPoints) };
      for (int i = 0; i < 3; ++i)
      {
        if (threads == 1)
        {
          reference[i] = results[i];
        }
        ExpectSame(results[i], reference[i]);
      }
    });
  }
}
