// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// FaceNumber.glsl: every number comes back, and floats are in the order of the
// numbers.
#include "ShaderRunner.h"

#include <algorithm>
#include <cstdint>

using namespace nephoscope_test;

namespace
{
constexpr std::int32_t half = 1 << 14; // of a number, which a float of the runner holds

std::vector<Float4> Halves(const std::vector<std::int32_t>& numbers)
{
  std::vector<Float4> list;
  for (const std::int32_t number : numbers)
  {
    list.push_back({ { float(number / half), float(number % half), 0, 0 } });
  }
  return list;
}

/** Float; halves of the number that it stands for. */
std::vector<Float4> Evaluate(const std::vector<std::int32_t>& numbers)
{
  ShaderRunner runner;
  const auto list = Halves(numbers);
  return runner.Run(ReadShader("FaceNumber.glsl"),
    "float number = floatOfFace(int(first.x) * 16384 + int(first.y));\n"
    "  int face = faceOfFloat(number);\n"
    "  result = vec4(number, face / 16384, face % 16384, faceOfFloat(-2.0));",
    list, list, [](vtkShaderProgram*) {});
}
}

TEST(FaceNumberShader, NumbersComeBackInOrder)
{
  std::vector<std::int32_t> numbers;
  for (int power = 0; power <= 28; ++power)
  {
    for (std::int32_t offset = -5; offset <= 5; ++offset)
    {
      numbers.push_back((1 << power) + offset);
    }
  }
  for (std::int32_t number = 1; number < (1 << 28) - 100000; number += 99991) // a prime
  {
    numbers.push_back(number);
    numbers.push_back(number + 1);
  }
  numbers.erase(std::remove_if(numbers.begin(), numbers.end(),
                  [](std::int32_t n) { return n < 0 || n >= 1 << 28; }),
    numbers.end());
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  const auto results = Evaluate(numbers);
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    EXPECT_EQ(std::int32_t(results[i][1]) * half + std::int32_t(results[i][2]), numbers[i]);
    EXPECT_EQ(results[i][3], -2.0f);
    if (i > 0)
    {
      EXPECT_GT(results[i][0], results[i - 1][0]) << numbers[i];
    }
    if (numbers[i] <= 1 << 24)
    {
      EXPECT_EQ(results[i][0], float(numbers[i]));
    }
  }
}
