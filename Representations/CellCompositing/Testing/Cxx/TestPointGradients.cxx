// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Least-squares gradients: exact for linear fields, continuous over seams, the same for any number
// of threads.
#include "PointGradients.h"

#include "CellGeometry.h"

#include "TestGrids.h"
#include "TestRandom.h"
#include "ThreadScope.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace nephoscope;
using namespace nephoscope_test;

namespace
{
using Gradients = std::vector<std::array<float, 4>>;

CellGeometry BuildGeometry(vtkDataSet* data, const std::function<double(const double[3])>& field)
{
  vtkDataArray* array = AddScalars(data, false, [&](vtkIdType i) {
    double x[3];
    data->GetPoint(i, x);
    return field(x);
  });
  CellGeometry geometry;
  EXPECT_EQ(geometry.Build(data, { array, false, -1 }), "");
  return geometry;
}

std::vector<float> ScalarsOf(const CellGeometry& geometry)
{
  std::vector<float> scalars;
  for (const auto& p : geometry.Points)
  {
    scalars.push_back(p.Scalar);
  }
  return scalars;
}
}

TEST(PointGradients, LinearFieldsAreReproduced)
{
  for (const double flatness : { 1.0, 1e-3 })
  {
    auto data = MakeStructuredGrid(6, 5, 4, [=](double i, double j, double k, double x[3]) {
      x[0] = i + 0.2 * std::sin(3 * j + k);
      x[1] = j + 0.2 * std::sin(2 * i + 5 * k);
      x[2] = flatness * (k + 0.2 * std::sin(4 * i + 7 * j));
    });
    const double g[3] = { 0.7, -1.3, 0.4 / flatness };
    const CellGeometry geometry = BuildGeometry(
      data, [&](const double x[3]) { return g[0] * x[0] + g[1] * x[1] + g[2] * x[2] + 5; });
    const double width = geometry.ScalarRange[1] - geometry.ScalarRange[0];
    for (const auto& gradient : PointGradients(data, geometry, ScalarsOf(geometry)))
    {
      for (std::size_t c = 0; c < 3; ++c)
      {
        EXPECT_NEAR(gradient[c] * width, g[c], 1e-4 * std::fabs(g[2])) << "flatness " << flatness;
      }
    }
  }
}

// The first and last meridian of a shell are the same places.
TEST(PointGradients, ContinuousOverASeam)
{
  const auto data = MakeShell(12, 6, 3, 60, 1, 1.3);
  const CellGeometry geometry =
    BuildGeometry(data, [](const double x[3]) { return x[0] * x[0] + x[1] * x[2]; });
  const Gradients gradients = PointGradients(data, geometry, ScalarsOf(geometry));
  int pairs = 0;
  for (std::size_t i = 0; i < geometry.Points.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      const auto &a = geometry.Points[i], &b = geometry.Points[j];
      if (a.X == b.X && a.Y == b.Y && a.Z == b.Z)
      {
        ++pairs;
        EXPECT_EQ(gradients[i], gradients[j]);
      }
    }
  }
  EXPECT_EQ(pairs, 7 * 4);
}

TEST(PointGradients, ThreadsDoNotChangeTheResult)
{
  const auto data = MakeShell(40, 20, 10, 80, 1, 1.3);
  const CellGeometry geometry =
    BuildGeometry(data, [](const double x[3]) { return std::sin(3 * x[0]) + x[1] * x[2]; });
  const std::vector<float> scalars = ScalarsOf(geometry);
  Gradients first;
  WithThreads(1, [&]() { first = PointGradients(data, geometry, scalars); });
  for (const int threads : { 2, 3, 8 })
  {
    Gradients again;
    WithThreads(threads, [&]() { again = PointGradients(data, geometry, scalars); });
    EXPECT_EQ(first, again) << threads << " threads";
  }
}

TEST(PointGradients, NoNeighbourhood)
{
  auto data = MakeGrid({ { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } },
                         { { std::nan(""), 5, 5 } } },
    { { VTK_TETRA, { 0, 1, 2, 3 } } });
  CellGeometry geometry =
    BuildGeometry(data, [](const double x[3]) { return std::isfinite(x[0]) ? x[0] : 0; });
  Gradients gradients = PointGradients(data, geometry, ScalarsOf(geometry));
  ASSERT_EQ(gradients.size(), 5u);
  EXPECT_NEAR(gradients[0][0], 1, 1e-6);
  EXPECT_NEAR(gradients[0][1], 0, 1e-6);
  std::vector<float> missing = ScalarsOf(geometry);
  missing[1] = missing[2] = std::nanf("");
  for (const auto& g : PointGradients(data, geometry, missing))
  {
    EXPECT_TRUE(std::isfinite(g[0]) && std::isfinite(g[1]) && std::isfinite(g[2]));
  }
}
