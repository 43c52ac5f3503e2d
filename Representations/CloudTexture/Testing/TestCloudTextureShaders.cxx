// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// GardnerTexture.glsl against GardnerTexture.h; the density along a ray in CloudThickness.glsl
// against quadrature.
#include "ShaderRunner.h"

#include "GardnerShaderConstants.h"
#include "GardnerTexture.h"

#include "TestRandom.h"

#include <cmath>

using namespace nephoscope;
using namespace nephoscope_test;

class Waves : public testing::TestWithParam<int>
{
};
INSTANTIATE_TEST_SUITE_P(CloudTextureShaders, Waves, testing::Range(0, 4));

TEST_P(Waves, FilteredTexture)
{
  const GardnerWaves waves = PresetWaves(GetParam());
  Random random(7);
  std::vector<Float4> places, footprints;
  for (int i = 0; i < 2000; ++i)
  {
    const double size = std::pow(10.0, random.Uniform(-4, -1));
    places.push_back({ { float(random.Uniform(-3, 9)), float(random.Uniform(-2, 2)),
      float(random.Uniform(0, 3)), 0 } });
    footprints.push_back(
      { { float(size * random.Uniform(-1, 1)), float(size * random.Uniform(-1, 1)),
        float(size * random.Uniform(-1, 1)), float(size * random.Uniform(-1, 1)) } });
  }
  ShaderRunner runner;
  const auto results = runner.Run(GardnerConstants(waves) + ReadShader("GardnerTexture.glsl"),
    "result = vec4(filteredTexture(first.xyz, vec3(second.xy, 0.0), vec3(0.0, second.zw)), 0.0);",
    places, footprints, [](vtkShaderProgram*) {});
  for (std::size_t i = 0; i < results.size(); ++i)
  {
    const Float4 &p = places[i], &f = footprints[i];
    const auto expected = FilteredGardnerTexture<double>(
      { { p[0], p[1], p[2] } }, { { { f[0], f[1], 0 } }, { { 0, f[2], f[3] } } }, waves);
    // Phases of some 10^3 radians are good to 1e-4 in float; cosines to 7e-5.
    EXPECT_NEAR(results[i][0], expected.Mean, 1.5e-3) << i;
    EXPECT_NEAR(results[i][1], expected.Lost, 1e-3) << i;
    EXPECT_NEAR(results[i][2], expected.Fourth, 1e-3) << i;
  }
}

// Share and colour of what exceeds the threshold, against a sum over a Gaussian.
TEST(CloudTextureShaders, ShareAndExcess)
{
  std::vector<Float4> list;
  for (const float width : { 0.05f, 0.4f, 1.2f })
  {
    for (float excess = -0.9f; excess < 3; excess += 0.3f)
    {
      list.push_back({ { excess, width, 1.5f, 0 } });
    }
  }
  ShaderRunner runner;
  const auto results = runner.Run(
    GardnerConstants(CloudWaves()) + ReadShader("GardnerTexture.glsl"),
    "result = vec4(cloudShare(first.x, first.y), cloudExcess(first.x, first.y, first.z), 0.0, 0.0);",
    list, {}, [](vtkShaderProgram*) {});
  for (std::size_t i = 0; i < results.size(); ++i)
  {
    double share = 0, sum = 0;
    const int steps = 20000;
    for (int k = 0; k < steps; ++k)
    {
      const double t = -6 + 12 * (k + 0.5) / steps;
      const double weight = std::exp(-t * t / 2) / std::sqrt(2 * gardnerPi) * 12 / steps;
      const double x = list[i][0] + list[i][1] * t;
      share += x > 0 ? weight : 0;
      sum += x > 0 ? weight * std::min(1.0, x / list[i][2]) : 0;
    }
    EXPECT_NEAR(results[i][0], share, 2.1e-3) << i; // less than 0.002 is none
    if (share > 0.05)
    {
      EXPECT_NEAR(results[i][1], sum / share, 4e-3) << i;
    }
  }
}

TEST(CloudTextureShaders, Blend)
{
  ShaderRunner runner;
  const std::vector<Float4> weights{ { { 1, 0, 0, 0 } }, { { 0, 2, 0, 0 } },
    { { 0.3f, 0.7f, 0, 0 } } };
  const auto results =
    runner.Run(GardnerConstants(CloudWaves()) + ReadShader("GardnerTexture.glsl"),
      "result = vec4(blendTextures(vec3(0.4, 0.1, 0.2), vec3(-1.1, 0.5, 0.05), first.xy), 0.0);",
      weights, {}, [](vtkShaderProgram*) {});
  for (std::size_t i = 0; i < results.size(); ++i)
  {
    const auto expected = BlendTextures(FilteredTexture<double>{ 0.4, 0.1, 0.2 },
      FilteredTexture<double>{ -1.1, 0.5, 0.05 }, double(weights[i][0]), double(weights[i][1]));
    EXPECT_NEAR(results[i][0], expected.Mean, 1e-6);
    EXPECT_NEAR(results[i][1], expected.Lost, 1e-6);
    EXPECT_NEAR(results[i][2], expected.Fourth, 1e-6);
  }
}

// Density that is linear from the front to the back face, up to a share of the way: by midpoints.
TEST(CloudTextureShaders, MeanDensity)
{
  Random random(8);
  std::vector<Float4> list;
  for (int i = 0; i < 100; ++i)
  {
    list.push_back({ { float(random.Uniform(0, 2)), float(random.Uniform(0, 2)),
      float(random.Uniform(0.1, 1)), 0 } });
  }
  ShaderRunner runner;
  std::string functions = ReadShader("CloudThickness.glsl");
  const std::string tag = "//NEPHOSCOPE::Layers";
  functions.replace(functions.find(tag), tag.size(),
    "void considerLayers(ivec2 pixel) {}\n"
    "const bool hasDensityVolume = false;\nconst bool hasDepths = false;\n"
    "float meanDensityOfVolume(vec3 a, vec3 b, float enough) { return 1.0; }\n");
  const auto results = runner.Run(functions,
    "result = vec4(meanDensity(first.x, first.y, first.z));", list, {}, [](vtkShaderProgram*) {});
  for (std::size_t i = 0; i < results.size(); ++i)
  {
    double sum = 0;
    const int steps = 1000;
    for (int k = 0; k < steps; ++k)
    {
      const double t = list[i][2] * (k + 0.5) / steps;
      sum += ((1 - t) * list[i][0] + t * list[i][1]) / steps;
    }
    EXPECT_NEAR(results[i][0], sum, 1e-5);
  }
}
