// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// SplatFootprint.glsl against SplatKernelValues.h, and VectorTexture.glsl against
// VectorTextureValues.h.
#include "ShaderRunner.h"

#include "SplatKernelValues.h"
#include "SplatShaderConstants.h"
#include "VectorTextureValues.h"

#include "TestRandom.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

using namespace nephoscope;
using namespace nephoscope_test;

namespace
{
const std::vector<Float4>& None()
{
  static const std::vector<Float4> list;
  return list;
}

std::vector<Float4> EvaluateFootprint(
  SplatKernel kernel, const std::vector<Float4>& list, const std::string& body)
{
  ShaderRunner runner;
  const std::string constants = "const int kernel = " + std::to_string(static_cast<int>(kernel)) +
    ";\nconst bool cutByOpaque = false;\nconst bool peeled = false;\n" + KernelConstants();
  return runner.Run(constants + ReadShader("SplatFootprint.glsl"), body, list, None(),
    [&](vtkShaderProgram* program) {
      program->SetUniformf("kernelRadius", static_cast<float>(KernelRadius(kernel)));
    });
}

std::vector<Float4> EvaluateTexture(double spacing, const std::vector<Float4>& shapes,
  const std::vector<Float4>& places, const std::string& body)
{
  ShaderRunner runner;
  std::ostringstream shape;
  shape << std::showpoint << "StreakShape shape = StreakShape(first.x, first.y, first.z, "
        << spacing << ", first.w);\n  ";
  return runner.Run(VectorTextureConstants(1.0) + ReadShader("VectorTexture.glsl"),
    shape.str() + body, shapes, places, [](vtkShaderProgram*) {});
}

streaks::Shape ShapeOf(const Float4& list, double spacing)
{
  return { list[0], list[1], list[2], spacing, list[3] };
}

// Streaks and round dots, coarser and finer than pixels; some without pixels.
void MakeStreaks(Random& random, std::vector<Float4>& shapes, std::vector<Float4>& places)
{
  for (int i = 0; i < 20000; ++i)
  {
    const double width = random.LogUniform(0.02, 0.5);
    const double period = width * random.LogUniform(2, 60);
    shapes.push_back({ { float(period), float(std::max(random.Uniform(0.1, 0.6) * period, width)),
      float(width), float(i % 4 == 0 ? 1e-6 : width * random.LogUniform(0.02, 10)) } });
    places.push_back({ { float(random.Uniform(-2, 2) * period), float(random.Uniform(-4, 4)),
      float(random.Uniform()), float(random.Uniform()) } });
  }
}
}

TEST(SplatFootprintShader, Footprint)
{
  std::vector<Float4> list;
  for (int i = 0; i < 4000; ++i)
  {
    list.push_back({ { float(i / 4000.0), 0, 0, 0 } });
  }
  for (const SplatKernel kernel :
    { SplatKernel::Cubic, SplatKernel::Quadratic, SplatKernel::Gaussian })
  {
    const double radius = KernelRadius(kernel);
    const auto results = EvaluateFootprint(kernel, list, "result = vec4(footprint(first.x));");
    double largest = 0;
    for (std::size_t i = 0; i < list.size(); ++i)
    {
      const double q = list[i][0];
      const double exact = KernelFootprint(kernel, radius * std::sqrt(q));
      largest = std::max(largest, std::abs(results[i][0] - exact));
      const double expected =
        kernel == SplatKernel::Cubic ? cubic_kernel::FootprintPolynomial(q) : exact;
      EXPECT_NEAR(results[i][0], expected, 5e-7) << q;
    }
    std::cout << "kernel " << static_cast<int>(kernel) << ", largest error on the GPU " << largest
              << std::endl;
  }
}

TEST(SplatFootprintShader, ShareBeforeACut)
{
  Random random(71);
  std::vector<Float4> list;
  for (int i = 0; i < 8000; ++i)
  {
    const double q = i % 5 == 0 ? 1 - random.LogUniform(1e-7, 1)
      : i % 5 == 1              ? random.LogUniform(1e-14, 1)
                                : random.Uniform();
    list.push_back({ { float(random.Uniform(-2.2, 2.2)), float(q), 0, 0 } });
  }
  for (const float q : { 0.0f, 0.5f, 0.99999994f })
  {
    for (const float z : { -1e37f, -0.0f, 0.0f, 1e37f, 1e-30f })
    {
      list.push_back({ { z, q, 0, 0 } });
    }
  }
  for (const SplatKernel kernel :
    { SplatKernel::Cubic, SplatKernel::Quadratic, SplatKernel::Gaussian })
  {
    const auto results = EvaluateFootprint(kernel, list,
      "float share = exactShareBefore(first.x, first.y); result = vec4(share, share * footprint(first.y), "
      "quickShareBefore(first.x, first.y), 0.0);");
    double largest = 0;
    for (std::size_t i = 0; i < list.size(); ++i)
    {
      const double rho = KernelRadius(kernel) * std::sqrt(double(list[i][1]));
      const double share = KernelShareBefore(kernel, rho, list[i][0]);
      const double part = share * KernelFootprint(kernel, rho);
      largest = std::max(largest, std::abs(results[i][1] - part));
      EXPECT_NEAR(results[i][1], part, 2e-5)
        << list[i][0] << " " << list[i][1]; // the footprint's polynomial is 1.5e-5 off
      EXPECT_GE(results[i][0], 0.0f) << list[i][0] << " " << list[i][1];
      EXPECT_LE(results[i][0], 1.0f) << list[i][0] << " " << list[i][1];
      const double cut = list[i][0] / (KernelRadius(kernel) * std::sqrt(1.0 - list[i][1]));
      EXPECT_NEAR(results[i][2], cubic_kernel::ShareBefore(cut, list[i][1]), 2e-6)
        << list[i][0] << " " << list[i][1];
    }
    std::cout << "kernel " << static_cast<int>(kernel) << ", largest error of a part on the GPU "
              << largest << std::endl;
  }
}

TEST(VectorTextureShader, Streaks)
{
  Random random(72);
  std::vector<Float4> shapes, places;
  MakeStreaks(random, shapes, places);
  for (const double spacing : { 0.4, 1.0 })
  {
    const auto results = EvaluateTexture(spacing, shapes, places,
      "result = vec4(streakTexture(shape, second.xy, second.z, second.w));");
    double largest = 0;
    for (std::size_t i = 0; i < shapes.size(); ++i)
    {
      const streaks::Shape shape = ShapeOf(shapes[i], spacing);
      const auto& p = places[i];
      // Where one streak follows the next the texture steps: a rounded place may lie on the other
      // side.
      const double step = 1e-6 * shape.Period;
      double low = 1, high = 0;
      for (const double x : { p[0] - step, double(p[0]), p[0] + step })
      {
        const double value = streaks::Value(shape, x, p[1], p[2], p[3]);
        low = std::min(low, value);
        high = std::max(high, value);
      }
      largest = std::max({ largest, low - results[i][0], results[i][0] - high });
      EXPECT_GE(results[i][0], low - 1e-5) << i;
      EXPECT_LE(results[i][0], high + 1e-5) << i;
    }
    std::cout << "spacing " << spacing << ", largest difference " << largest << std::endl;
  }
}

TEST(VectorTextureShader, MeanOfStreaks)
{
  Random random(73);
  std::vector<Float4> shapes, places;
  MakeStreaks(random, shapes, places);
  const auto results = EvaluateTexture(0.7, shapes, places, "result = vec4(meanStreak(shape));");
  for (std::size_t i = 0; i < shapes.size(); ++i)
  {
    EXPECT_NEAR(results[i][0], streaks::Mean(ShapeOf(shapes[i], 0.7)), 1e-6);
  }
}

TEST(VectorTextureShader, Segments)
{
  Random random(74);
  std::vector<Float4> sizes, places;
  for (int i = 0; i < 20000; ++i)
  {
    sizes.push_back(
      { { float(random.LogUniform(0.01, 60)), float(random.LogUniform(0.05, 8)), 0, 0 } });
    places.push_back({ { float(random.Uniform(-0.7, 0.7) * (sizes.back()[0] + 3)),
      float(random.Uniform(-6, 6)), 0, 0 } });
  }
  places[0] = Float4{};
  sizes[0] = { { 3.0f, 0.7f, 0, 0 } };
  ShaderRunner runner;
  const auto results = runner.Run(VectorTextureConstants(1.0) + ReadShader("VectorTexture.glsl"),
    "result = vec4(segmentCoverage(second.xy, first.x, first.y));", sizes, places,
    [](vtkShaderProgram*) {});
  EXPECT_NEAR(results[0][0], 0.514679405, 1e-6);
  for (std::size_t i = 0; i < sizes.size(); ++i)
  {
    const LineSegment segment{ sizes[i][0], sizes[i][1], LineSegment().FilterWidth };
    EXPECT_NEAR(results[i][0], SegmentCoverage(segment, places[i][0], places[i][1]), 1e-6)
      << i; // 2e-7 for each error function
  }
}
