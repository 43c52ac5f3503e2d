// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** The shader's integrals against the header's, on the same numbers in float. */
#include "Haze.h"

#include "ShaderRunner.h"
#include "TestRandom.h"

#include <cmath>

using namespace nephoscope;
using nephoscope_test::Float4;
using nephoscope_test::Random;
using nephoscope_test::ReadShader;
using nephoscope_test::ShaderRunner;

namespace
{
/** first: a place above (0, 0, radius) and its altitude; second: a step. */
struct Segments
{
  std::vector<Float4> First, Second;

  void Add(double radius, double altitude, double sine, double length)
  {
    const double cosine = std::sqrt(1 - sine * sine);
    this->First.push_back(
      { { 0, 0, static_cast<float>(radius + altitude), static_cast<float>(altitude) } });
    this->Second.push_back({ { static_cast<float>(0.6 * cosine * length),
      static_cast<float>(0.8 * cosine * length), static_cast<float>(sine * length), 0 } });
  }
};

HazePlace<float> PlaceOf(const Float4& first)
{
  HazePlace<float> place;
  place.FromCenter = { { first[0], first[1], first[2] } };
  place.Radius = HazeNorm(place.FromCenter);
  place.Altitude = first[3];
  return place;
}

class HazeShader : public ::testing::Test
{
protected:
  std::vector<Float4> Run(const std::string& body)
  {
    static ShaderRunner runner;
    return runner.Run(ReadShader("Haze.glsl"), body, this->Items.First, this->Items.Second,
      [](vtkShaderProgram*) {});
  }

  Segments Items;
};
}

TEST_F(HazeShader, AboutAGlobe)
{
  Random random(1);
  for (int i = 0; i < 3000; ++i)
  {
    const double radius = i % 2 ? 796.0 : random.LogUniform(20, 60000);
    const double sine = i % 3 ? random.Uniform(-1, 1) : random.Uniform(-0.05, 0.05);
    this->Items.Add(radius, i % 5 ? random.Uniform(0, 5) : random.Uniform(-1, 400), sine,
      random.LogUniform(1e-3, 400));
  }
  const auto results = this->Run(
    "result = vec4(globeHazeLength(HazePlace(first.xyz, vec2(length(first.xyz), first.w)), second.xyz));");
  for (std::size_t i = 0; i < results.size(); ++i)
  {
    const Float4& step = this->Items.Second[i];
    const float expected =
      GlobeHazeLength(PlaceOf(this->Items.First[i]), { { step[0], step[1], step[2] } });
    // Both round differently where two tails nearly cancel, whose unit is sqrt(2 R).
    EXPECT_NEAR(
      results[i][0], expected, 5e-4 * expected + 4e-6 * std::sqrt(2 * this->Items.First[i][2]))
      << i;
  }
}

TEST_F(HazeShader, OverFlatGround)
{
  Random random(2);
  for (int i = 0; i < 1000; ++i)
  {
    const double low = random.Uniform(-3, 10);
    this->Items.First.push_back({ { static_cast<float>(low),
      static_cast<float>(i % 3 ? random.Uniform(-3, 10) : low + random.Uniform(-0.05, 0.05)), 0,
      0 } });
    this->Items.Second.push_back({ { static_cast<float>(random.LogUniform(0.01, 100)), 0, 0, 0 } });
  }
  const auto results = this->Run("result = vec4(flatHazeLength(first.xy, second.x));");
  for (std::size_t i = 0; i < results.size(); ++i)
  {
    const float expected =
      FlatHazeLength(this->Items.First[i][0], this->Items.First[i][1], this->Items.Second[i][0]);
    EXPECT_NEAR(results[i][0] / expected, 1, 1e-5) << i;
  }
}

TEST_F(HazeShader, MeanPlaceOfLight)
{
  for (double alpha = 0.001; alpha < 1; alpha += 0.001)
  {
    this->Items.First.push_back({ { static_cast<float>(alpha), 0, 0, 0 } });
  }
  this->Items.Second = this->Items.First;
  const auto results = this->Run("result = vec4(hazeMeanPlace(first.x));");
  for (std::size_t i = 0; i < results.size(); ++i)
  {
    const double alpha = this->Items.First[i][0], depth = -std::log1p(-alpha);
    double sum = 0;
    for (int k = 0; k < 1000; ++k)
    {
      const double s = (k + 0.5) / 1000;
      sum += s * depth * std::exp(-depth * s) / 1000;
    }
    EXPECT_NEAR(results[i][0], sum / alpha, 2e-4) << alpha;
  }
}
