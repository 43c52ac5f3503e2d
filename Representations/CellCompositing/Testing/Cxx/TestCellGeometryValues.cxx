// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// What CellGeometry makes of values: of points, cells and components, hidden and missing ones.
#include "BuiltGeometry.h"

#include "TestRandom.h"

#include "vtkDataArray.h"
#include "vtkUniformGrid.h"

#include <gtest/gtest.h>

#include <limits>

using namespace nephoscope;
using namespace nephoscope_test;

TEST(CellGeometryValues, StructuredGridAndPointScalars)
{
  auto grid = MakeLattice(4);
  vtkDataArray* scalars =
    AddScalars(grid, false, [](vtkIdType i) { return 200 + 0.25 * double(i * i); });
  const CellGeometry geometry = Build(grid, scalars);
  EXPECT_NEAR(VolumeOf(geometry), 64, 1e-4);
  EXPECT_EQ(geometry.ScalarRange[0], 200);
  EXPECT_EQ(geometry.ScalarRange[1], 200 + 0.25 * 124 * 124);
  EXPECT_TRUE(geometry.CellScalars.empty());
  for (std::size_t i = 0; i < geometry.Points.size(); ++i)
  {
    double x[3];
    grid->GetPoint(vtkIdType(i), x);
    EXPECT_NEAR(
      ScalarOf(geometry, geometry.Points[i].Scalar), scalars->GetComponent(vtkIdType(i), 0), 1e-3);
    EXPECT_NEAR(geometry.Points[i].X + geometry.Center[0], x[0], 1e-6);
    EXPECT_NEAR(geometry.Points[i].Y + geometry.Center[1], x[1], 1e-6);
    EXPECT_NEAR(geometry.Points[i].Z + geometry.Center[2], x[2], 1e-6);
  }
}

TEST(CellGeometryValues, CellScalars)
{
  auto grid = MakeLattice(3);
  vtkDataArray* scalars = AddScalars(grid, true, [](vtkIdType i) { return 10.0 - double(i); });
  const CellGeometry geometry = Build(grid, scalars, true);
  ASSERT_EQ(geometry.CellScalars.size(), geometry.Tetrahedra.size());
  for (std::size_t i = 0; i < geometry.Tetrahedra.size(); ++i)
  {
    double center[3] = { 0, 0, 0 };
    for (const Vector3& p : geometry.Vertices(i))
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        center[axis] += 0.25 * p[axis];
      }
    }
    const double cell = std::floor(center[0] + 1.5) + 3 * std::floor(center[1] + 1.5) +
      9 * std::floor(center[2] + 1.5);
    ASSERT_NEAR(ScalarOf(geometry, geometry.CellScalars[i]), 10 - cell, 1e-5);
  }
}

TEST(CellGeometryValues, VectorComponentAndMagnitude)
{
  auto grid = MakeLattice(2);
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetNumberOfComponents(3);
  Random random(41);
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    vectors->InsertNextTuple3(random.Normal(), random.Normal(), random.Normal());
  }
  const CellGeometry magnitude = Build(grid, vectors, false, -1);
  const CellGeometry second = Build(grid, vectors, false, 1);
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    const double* v = vectors->GetTuple3(i);
    const std::size_t p = std::size_t(i);
    EXPECT_NEAR(
      ScalarOf(magnitude, magnitude.Points[p].Scalar), std::hypot(v[0], v[1], v[2]), 1e-6);
    EXPECT_NEAR(ScalarOf(second, second.Points[p].Scalar), v[1], 1e-6);
  }
}

TEST(CellGeometryValues, SkipsHiddenAndGhostCells)
{
  for (const unsigned char flag : { vtkDataSetAttributes::HIDDENCELL,
         vtkDataSetAttributes::DUPLICATECELL, vtkDataSetAttributes::REFINEDCELL })
  {
    auto structured = MakeLattice(3);
    HideCell(structured, 13, flag);
    const CellGeometry geometry = BuildNumbered(structured);
    EXPECT_EQ(geometry.Tetrahedra.size(), 26u * 5) << "flag " << int(flag);
    EXPECT_EQ(geometry.NumberOfInvalidCells + geometry.NumberOfUnsupportedCells, 0);
  }
  vtkNew<vtkUniformGrid> image;
  image->SetDimensions(4, 4, 4);
  image->BlankCell(13);
  EXPECT_EQ(BuildNumbered(image).Tetrahedra.size(), 26u * 5);
  auto unstructured = UnitCubeOf(VTK_PYRAMID);
  HideCell(unstructured, 2);
  EXPECT_NEAR(VolumeOf(BuildNumbered(unstructured)), 5.0 / 6, 1e-6);
}

TEST(CellGeometryValues, SkipsCellsAtHiddenPoints)
{
  auto grid = MakeLattice(3);
  grid->AllocatePointGhostArray()->SetValue(1 + 4 * (1 + 4 * 1), vtkDataSetAttributes::HIDDENPOINT);
  EXPECT_EQ(BuildNumbered(grid).Tetrahedra.size(), 19u * 5); // eight cells share the point
  vtkNew<vtkUniformGrid> image;
  image->SetDimensions(4, 4, 4);
  image->BlankPoint(0);
  EXPECT_EQ(BuildNumbered(image).Tetrahedra.size(), 26u * 5);
}

// A fill value where nothing is drawn must not take the range, and with it the precision, of what
// is.
TEST(CellGeometryValues, HiddenFillValuesDoNotSpoilTheScalars)
{
  for (const double fill : { 1e20, -1e20 })
  {
    auto points = MakeLattice(3);
    points->AllocatePointGhostArray()->SetValue(0, vtkDataSetAttributes::HIDDENPOINT);
    const CellGeometry onPoints = Build(
      points, AddScalars(points, false, [&](vtkIdType i) { return i == 0 ? fill : double(i); }));
    EXPECT_NEAR(ScalarOf(onPoints, onPoints.Points[30].Scalar), 30, 1e-4)
      << "hidden point of " << fill;
    auto cells = MakeLattice(3);
    HideCell(cells, 0);
    const CellGeometry onCells = Build(
      cells, AddScalars(cells, true, [&](vtkIdType i) { return i == 0 ? fill : double(i); }), true);
    EXPECT_NEAR(ScalarOf(onCells, onCells.CellScalars[0]), 1, 1e-4) << "hidden cell of " << fill;
  }
}

TEST(CellGeometryValues, CountsInvalidCells)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  auto grid = MakeLattice(3);
  grid->GetPoints()->SetPoint(0, nan, 0, 0);
  CellGeometry geometry = BuildNumbered(grid);
  EXPECT_EQ(geometry.NumberOfInvalidCells, 1);
  EXPECT_NEAR(VolumeOf(geometry), 26, 1e-4);

  for (const double bad : { nan, std::numeric_limits<double>::infinity() })
  {
    auto scalars = MakeLattice(3);
    geometry = Build(
      scalars, AddScalars(scalars, false, [&](vtkIdType i) { return i == 0 ? bad : double(i); }));
    EXPECT_EQ(geometry.NumberOfInvalidCells, 1);
    EXPECT_EQ(geometry.ScalarRange[0], 1);
    EXPECT_EQ(geometry.ScalarRange[1], 63);
    geometry = Build(scalars,
      AddScalars(scalars, true, [&](vtkIdType i) { return i < 5 ? bad : double(i); }), true);
    EXPECT_EQ(geometry.NumberOfInvalidCells, 5);
    EXPECT_EQ(geometry.Tetrahedra.size(), 22u * 5);
  }
}

TEST(CellGeometryValues, ConstantScalars)
{
  auto grid = MakeLattice(2);
  const CellGeometry geometry = Build(grid, AddScalars(grid, false, [](vtkIdType) { return 7.0; }));
  EXPECT_EQ(geometry.ScalarRange[0], 7);
  EXPECT_LT(geometry.ScalarRange[0], geometry.ScalarRange[1]);
  EXPECT_EQ(ScalarOf(geometry, geometry.Points[5].Scalar), 7);
}
