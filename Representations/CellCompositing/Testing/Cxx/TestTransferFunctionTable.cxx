// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The table against the VTK functions that it stands for, at random places.
#include "TransferFunctionTable.h"

#include "TestRandom.h"

#include "vtkColorTransferFunction.h"
#include "vtkDiscretizableColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVariant.h"
#include "vtkVolumeProperty.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace nephoscope;
using namespace nephoscope_test;

namespace
{
constexpr double curved =
  1.0 / 2000; // documented tolerance between control points of curved functions
constexpr double manyNodes = 1.0 / 510 + 1e-6; // of colours where there are more than 16 nodes
constexpr double linear = 2e-6;

class Functions
{
public:
  Functions()
  {
    this->Property->SetScalarOpacity(this->Opacity);
    this->Property->SetColor(this->Color);
  }
  TransferFunctionTable Build(double low, double high) const
  {
    const double range[2] = { low, high };
    TransferFunctionTable table;
    table.Build(this->Property, range);
    EXPECT_FALSE(table.Nodes.empty());
    EXPECT_EQ(table.Intervals.size(), table.Nodes.size() + 1);
    EXPECT_TRUE(std::is_sorted(table.Nodes.begin(), table.Nodes.end()));
    return table;
  }

  vtkNew<vtkVolumeProperty> Property;
  vtkNew<vtkPiecewiseFunction> Opacity;
  vtkNew<vtkColorTransferFunction> Color;
};

void AddRandomPoints(Random& random, Functions& f, double low, double high)
{
  for (int i = 0; i < 8; ++i) // not closer than a sixteenth: in float, error grows with the slope
  {
    const auto place = [&]() { return low + (high - low) * (i + random.Uniform(0.25, 0.75)) / 8; };
    f.Opacity->AddPoint(place(), random.Uniform());
    f.Color->AddRGBPoint(place(), random.Uniform(), random.Uniform(), random.Uniform());
  }
}

/**
 * Largest difference at random places, those next to a step of the function (as `skip` says) left
 * out.
 */
double LargestError(Random& random, const TransferFunctionTable& table, const Functions& f,
  double low, double high, const std::function<bool(double)>& skip = nullptr)
{
  double largest = 0;
  for (int i = 0; i < 20000; ++i)
  {
    const double margin = 0.2 * (high - low);
    const float s = float((random.Uniform(low - margin, high + margin) - low) / (high - low));
    const double x = low + double(s) * (high - low);
    if (skip && skip(x))
    {
      continue;
    }
    double rgb[3];
    f.Color->GetColor(x, rgb);
    const TransferFunctionTable::Value value = table.Evaluate(s);
    largest = std::max({ largest, std::fabs(value[0] - rgb[0]), std::fabs(value[1] - rgb[1]),
      std::fabs(value[2] - rgb[2]), std::fabs(value[3] - f.Opacity->GetValue(x)) });
  }
  return largest;
}

std::function<bool(double)> Near(const std::vector<double>& places, double distance)
{
  return [=](double x) {
    return std::any_of(
      places.begin(), places.end(), [&](double p) { return std::fabs(x - p) < distance; });
  };
}
}

TEST(TransferFunctionTable, PiecewiseLinear)
{
  Random random(61);
  for (int i = 0; i < 20; ++i)
  {
    Functions f;
    AddRandomPoints(random, f, 200, 300);
    EXPECT_LE(LargestError(random, f.Build(210, 290), f, 210, 290), linear);
  }
  Functions f;
  f.Opacity->AddPoint(0, 0);
  f.Opacity->AddPoint(0.3, 0.8);
  f.Opacity->AddPoint(1, 0.1);
  f.Color->AddRGBPoint(0, 0, 0, 1);
  f.Color->AddRGBPoint(0.6, 1, 0, 0);
  const TransferFunctionTable table = f.Build(0, 1);
  EXPECT_EQ(table.Nodes, (std::vector<float>{ 0.0f, 0.3f, 0.6f, 1.0f }));
  EXPECT_LE(LargestError(random, table, f, 0, 1), linear);
}

TEST(TransferFunctionTable, JumpsAreKept)
{
  Random random(62);
  for (const double offset : { 0.0, 1e5, -1e9 })
  {
    Functions f;
    f.Opacity->AllowDuplicateScalarsOn();
    f.Opacity->AddPoint(offset, 0.2);
    f.Opacity->AddPoint(offset + 0.5, 0.4);
    f.Opacity->AddPoint(offset + 0.5, 0.9);
    f.Opacity->AddPoint(offset + 1, 0.1);
    f.Color->AddRGBPoint(offset, 1, 1, 1);
    ASSERT_EQ(f.Opacity->GetSize(), 4);
    const TransferFunctionTable table = f.Build(offset, offset + 1);
    const std::size_t k = table.FindInterval(0.5f);
    ASSERT_EQ(table.Nodes[k - 1], 0.5f) << "a node belongs to the interval above it";
    EXPECT_NEAR(table.Intervals[k - 1].High[3], 0.4, linear) << "offset " << offset;
    EXPECT_NEAR(table.Intervals[k].Low[3], 0.9, linear) << "offset " << offset;
    EXPECT_LE(
      LargestError(random, table, f, offset, offset + 1, Near({ offset + 0.5 }, 1e-6)), 1e-5)
      << "offset " << offset;
  }
}

TEST(TransferFunctionTable, SharpStepsAreKept)
{
  Random random(63);
  Functions f;
  f.Opacity->AddPoint(0, 0.1, 0.3, 1.0); // a step 0.3 of the way to the next point
  f.Opacity->AddPoint(2, 0.9);
  f.Color->AddRGBPoint(0, 0, 0.2, 0.4, 0.7, 1.0);
  f.Color->AddRGBPoint(2, 1, 0.8, 0.6);
  const TransferFunctionTable table = f.Build(0, 2);
  if (f.Opacity->GetValue(0.59) != 0.1) // VTK 9.6 draws sharpness 1 as a steep curve, not as a step
  {
    EXPECT_LE(LargestError(random, table, f, 0, 2, Near({ 1.4 }, 1e-6)), curved);
    return;
  }
  EXPECT_LE(LargestError(random, table, f, 0, 2, Near({ 0.6, 1.4 }, 1e-6)), linear);
  EXPECT_NEAR(table.Evaluate(0.2999f)[3], 0.1, linear);
  EXPECT_NEAR(table.Evaluate(0.3001f)[3], 0.9, linear);
}

TEST(TransferFunctionTable, MidpointAndSharpness)
{
  Random random(64);
  for (const double sharpness : { 0.0, 0.3, 0.6, 0.9 })
  {
    for (const double midpoint : { 0.1, 0.5, 0.8 })
    {
      Functions f, opacityOnly;
      for (const Functions* functions : { &f, &opacityOnly })
      {
        functions->Opacity->AddPoint(0, 0.1, midpoint, sharpness);
        functions->Opacity->AddPoint(1, 0.9);
      }
      f.Color->AddRGBPoint(0, 0, 0.2, 1, midpoint, sharpness);
      f.Color->AddRGBPoint(1, 1, 0.5, 0);
      opacityOnly.Color->AddRGBPoint(0, 1, 1, 1);
      EXPECT_LE(LargestError(random, f.Build(0, 1), f, 0, 1), manyNodes)
        << "midpoint " << midpoint << ", sharpness " << sharpness;
      EXPECT_LE(LargestError(random, opacityOnly.Build(0, 1), opacityOnly, 0, 1), curved)
        << "midpoint " << midpoint << ", sharpness " << sharpness;
    }
  }
}

// Without LabCIEDE2000: VTK needs 80 ms for each of its colours.
TEST(TransferFunctionTable, ColorSpaces)
{
  Random random(65);
  const std::pair<const char*, void (vtkColorTransferFunction::*)()> spaces[] = {
    { "HSV", &vtkColorTransferFunction::SetColorSpaceToHSV },
    { "Lab", &vtkColorTransferFunction::SetColorSpaceToLab },
    { "Diverging", &vtkColorTransferFunction::SetColorSpaceToDiverging },
  };
  for (const auto& [name, set] : spaces)
  {
    double largest = 0;
    for (int i = 0; i < 10; ++i)
    {
      Functions f;
      f.Color->HSVWrapOff();
      (f.Color->*set)();
      f.Opacity->AddPoint(0, 1);
      for (const double x : { 0.0, 1.0, 3.0 })
      {
        f.Color->AddRGBPoint(x, random.Uniform(), random.Uniform(), random.Uniform());
      }
      largest = std::max(largest, LargestError(random, f.Build(0, 3), f, 0, 3));
    }
    std::cout << name << ": largest error " << largest << std::endl;
    EXPECT_LE(largest, manyNodes) << name;
  }
}

TEST(TransferFunctionTable, LogarithmicScale)
{
  Random random(66);
  Functions f;
  f.Color->SetScaleToLog10();
  f.Color->AddRGBPoint(0.01, 0, 0, 1);
  f.Color->AddRGBPoint(1, 0, 1, 0);
  f.Color->AddRGBPoint(100, 1, 0, 0);
  f.Opacity->AddPoint(0.01, 0.5);
  f.Opacity->AddPoint(100, 0.5);
  double largest = 0;
  const TransferFunctionTable table = f.Build(0.01, 100);
  for (int i = 0; i < 20000; ++i)
  {
    const double x = random.LogUniform(0.011, 99);
    const float s = float((x - 0.01) / 99.99);
    double rgb[3];
    f.Color->GetColor(0.01 + double(s) * 99.99, rgb);
    const auto value = table.Evaluate(s);
    for (std::size_t c = 0; c < 3; ++c)
    {
      largest = std::max(largest, std::fabs(value[c] - rgb[c]));
    }
  }
  std::cout << "four decades: largest error " << largest << std::endl;
  EXPECT_LE(largest, manyNodes);
}

// Colours as PyVista's: 256 nodes, rounded to 8 bits.
TEST(TransferFunctionTable, ManyNodesAreJoined)
{
  Random random(70);
  const auto build = [](int count, Functions& f) {
    for (int i = 0; i < count; ++i)
    {
      const double x = double(i) / (count - 1);
      const auto rounded = [](double c) { return std::round(255 * (0.5 + 0.5 * c)) / 255; };
      f.Color->AddRGBPoint(
        x, rounded(std::sin(4 * x)), rounded(std::cos(3 * x)), rounded(std::sin(1 + 2 * x)));
      f.Opacity->AddPoint(x, x);
    }
    return f.Build(0, 1);
  };
  Functions many, few;
  const TransferFunctionTable joined = build(256, many);
  EXPECT_LE(joined.Nodes.size(), 32u);
  EXPECT_LE(LargestError(random, joined, many, 0, 1), manyNodes);
  for (const float s : { 0.001f, 0.1f, 0.5f, 0.9f })
  {
    EXPECT_NEAR(joined.Evaluate(s)[3] / s, 1, curved);
  }
  const TransferFunctionTable kept = build(16, few);
  EXPECT_EQ(kept.Nodes.size(), 16u);
  EXPECT_LE(LargestError(random, kept, few, 0, 1), linear);
}

class DiscretisedColors : public ::testing::TestWithParam<bool>
{
};

TEST_P(DiscretisedColors, FewValuesAreSteps)
{
  const bool logarithmic = this->GetParam();
  Random random(67);
  vtkNew<vtkDiscretizableColorTransferFunction> color;
  color->AddRGBPoint(1, 0, 0, 1);
  color->AddRGBPoint(100, 1, 0.5, 0);
  color->DiscretizeOn();
  color->SetNumberOfValues(5);
  if (logarithmic)
  {
    color->SetUseLogScale(1);
    color->SetScaleToLog10();
  }
  color->Build();
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(1, 1);
  vtkNew<vtkVolumeProperty> property;
  property->SetColor(color);
  property->SetScalarOpacity(opacity);
  TransferFunctionTable table;
  const double range[2] = { 1, 100 };
  table.Build(property, range);
  double largest = 0;
  for (int i = 0; i < 20000; ++i)
  {
    const double u = random.Uniform();
    if (std::fabs(5 * u - std::round(5 * u)) < 1e-3) // next to a step
    {
      continue;
    }
    const double x = logarithmic ? std::pow(100.0, u) : 1 + 99 * u;
    double rgb[3];
    color->GetColor(x, rgb);
    const auto value = table.Evaluate(float((x - 1) / 99));
    for (std::size_t c = 0; c < 3; ++c)
    {
      largest = std::max(largest, std::fabs(value[c] - rgb[c]));
    }
  }
  EXPECT_LE(largest, linear);
}
INSTANTIATE_TEST_SUITE_P(TransferFunctionTable, DiscretisedColors, ::testing::Bool());

TEST(TransferFunctionTable, ManyDiscretisedValuesAreNotQuantised)
{
  vtkNew<vtkDiscretizableColorTransferFunction> color;
  color->AddRGBPoint(0, 0, 0, 0);
  color->AddRGBPoint(1, 1, 1, 1);
  color->DiscretizeOn();
  color->SetNumberOfValues(256);
  color->Build();
  vtkNew<vtkVolumeProperty> property;
  property->SetColor(color);
  TransferFunctionTable table;
  const double range[2] = { 0, 1 };
  table.Build(property, range);
  EXPECT_NEAR(table.Evaluate(0.12345f)[0], 0.12345, linear);
}

TEST(TransferFunctionTable, GrayChannel)
{
  vtkNew<vtkPiecewiseFunction> gray, opacity;
  gray->AddPoint(0, 0.2);
  gray->AddPoint(2, 0.8);
  opacity->AddPoint(1, 0.5);
  vtkNew<vtkVolumeProperty> property;
  property->SetColor(gray);
  property->SetScalarOpacity(opacity);
  ASSERT_EQ(property->GetColorChannels(), 1);
  TransferFunctionTable table;
  const double range[2] = { 0, 2 };
  table.Build(property, range);
  for (const float s : { 0.0f, 0.2f, 0.5f, 0.9f })
  {
    const auto value = table.Evaluate(s);
    EXPECT_NEAR(value[0], 0.2 + 0.6 * s, linear);
    EXPECT_EQ(value[0], value[1]);
    EXPECT_EQ(value[0], value[2]);
    EXPECT_NEAR(value[3], 0.5, linear);
  }
}

TEST(TransferFunctionTable, EmptyFunctions)
{
  Functions f;
  const TransferFunctionTable table = f.Build(0, 1);
  EXPECT_EQ(table.Evaluate(0.5f)[3], f.Opacity->GetValue(0.5));
  EXPECT_TRUE(table.IsTransparent(0, 1));
}

TEST(TransferFunctionTable, ClampingOff)
{
  Random random(68);
  Functions f;
  f.Opacity->ClampingOff();
  f.Opacity->AddPoint(0.2, 0.5);
  f.Opacity->AddPoint(0.8, 0.7);
  f.Color->ClampingOff();
  f.Color->AddRGBPoint(0.3, 1, 0.5, 0.2);
  f.Color->AddRGBPoint(0.7, 0.9, 0.4, 0.1);
  const TransferFunctionTable table = f.Build(0, 1);
  EXPECT_LE(LargestError(random, table, f, 0, 1, Near({ 0.2, 0.3, 0.7, 0.8 }, 1e-6)), linear);
  EXPECT_EQ(table.Evaluate(0.1f)[3], 0.0f);
  EXPECT_EQ(table.Evaluate(0.9f)[3], 0.0f);
  EXPECT_TRUE(table.IsTransparent(0.0f, 0.1f));
  EXPECT_TRUE(table.IsTransparent(0.9f, 2.0f));
  EXPECT_FALSE(table.IsTransparent(0.1f, 0.3f));
}

TEST(TransferFunctionTable, TransparentIntervals)
{
  Random random(69);
  int transparent = 0;
  for (int i = 0; i < 300; ++i)
  {
    Functions f;
    f.Opacity->AllowDuplicateScalarsOn();
    double x = 0;
    for (int k = 0; k < 8; ++k)
    {
      f.Opacity->AddPoint(x, random.Integer(0, 3) ? 0 : random.Uniform());
      x += random.Integer(0, 3) ? random.Uniform(0, 0.3) : 0; // or a jump
    }
    const TransferFunctionTable table = f.Build(0, 1);
    for (int k = 0; k < 30; ++k)
    {
      const float a = float(random.Uniform(-0.2, 1.2)),
                  b = float(a + (k % 3 ? random.Uniform(0, 0.3) : 0));
      double greatest = 0;
      for (int n = 0; n <= 1000; ++n)
      {
        greatest = std::max(greatest, f.Opacity->GetValue(a + (b - a) * n / 1000.0));
      }
      if (table.IsTransparent(a, b))
      {
        ++transparent;
        ASSERT_LE(greatest, 0) << "[" << a << ", " << b << "]";
      }
      else
      {
        // Nothing but a node inside may have been opaque between the samples.
        const bool nodeInside = table.FindInterval(a) != table.FindInterval(b);
        ASSERT_TRUE(greatest > 0 || nodeInside) << "[" << a << ", " << b << "]";
      }
    }
  }
  EXPECT_GT(transparent, 1000) << "the test must meet both cases";
  Functions f;
  f.Opacity->AddPoint(0, 0);
  f.Opacity->AddPoint(0.5, 0);
  f.Opacity->AddPoint(1, 0);
  const TransferFunctionTable table = f.Build(0, 1);
  EXPECT_TRUE(table.IsTransparent(-1, 2));
  EXPECT_TRUE(table.IsTransparent(0.2f, 0.2f));
}

// The only opacity inside is a ramp that starts at zero and falls back to zero in a jump, or the
// other way round.
TEST(TransferFunctionTable, RampsBetweenZerosAreNotTransparent)
{
  for (const bool rising : { true, false })
  {
    Functions f;
    f.Opacity->AllowDuplicateScalarsOn();
    f.Opacity->AddPoint(0.4, 0);
    f.Opacity->AddPoint(rising ? 0.6 : 0.4, 1);
    f.Opacity->AddPoint(0.6, 0);
    const TransferFunctionTable table = f.Build(0, 1);
    EXPECT_FALSE(table.IsTransparent(0.1f, 0.9f));
    EXPECT_FALSE(table.IsTransparent(0.5f, 0.9f));
    EXPECT_TRUE(table.IsTransparent(0.1f, 0.3f));
    EXPECT_TRUE(table.IsTransparent(0.7f, 0.9f));
  }
}

TEST(TransferFunctionTable, IndexedColorsAreThoseOfTheNearestCategory)
{
  Functions f;
  f.Opacity->AddPoint(0, 1);
  f.Color->AddRGBPoint(0, 1, 0, 0);
  f.Color->AddRGBPoint(1, 0, 1, 0);
  f.Color->AddRGBPoint(2, 0, 0, 1);
  f.Color->IndexedLookupOn();
  f.Color->SetAnnotation(vtkVariant(10), "first");
  f.Color->SetAnnotation(vtkVariant(30), "second");
  f.Color->SetAnnotation(vtkVariant("a word"), "not a number");
  const TransferFunctionTable table = f.Build(0, 40);
  for (const double x : { 0.0, 10.0, 19.0 })
  {
    EXPECT_EQ(table.Evaluate(float(x / 40)), (TransferFunctionTable::Value{ { 1, 0, 0, 1 } })) << x;
  }
  for (const double x : { 21.0, 30.0, 40.0 })
  {
    EXPECT_EQ(table.Evaluate(float(x / 40)), (TransferFunctionTable::Value{ { 0, 1, 0, 1 } })) << x;
  }
}

// The error is a part of the opacity itself: with a large opacity scale, small opacities count.
TEST(TransferFunctionTable, SmallOpacitiesOfCurvesAreFollowed)
{
  for (const double sharpness : { 0.3, 0.7 })
  {
    Functions f;
    f.Opacity->AddPoint(0, 0, 0.5, sharpness);
    f.Opacity->AddPoint(1, 1);
    const TransferFunctionTable table = f.Build(0, 1);
    for (int i = 1; i < 1000; ++i)
    {
      const float s = i / 1000.0f;
      const double exact = f.Opacity->GetValue(s);
      EXPECT_LE(std::fabs(table.Evaluate(s)[3] - exact), curved * exact + 1e-6) << "at " << s;
    }
    EXPECT_LT(table.Nodes.size(), 500u);
  }
}

// Narrower than two neighbouring floats of the normalised scalar; far from zero; the largest
// doubles.
TEST(TransferFunctionTable, NarrowIntervals)
{
  Functions f;
  f.Opacity->AddPoint(0.5, 0);
  f.Opacity->AddPoint(0.5 + 1e-9, 1);
  f.Opacity->AddPoint(0.5 + 3e-9, 0);
  const TransferFunctionTable table = f.Build(0, 1);
  ASSERT_EQ(table.Nodes.size(), 3u);
  EXPECT_NEAR(table.Widths[0], 1e-9, 1e-15);
  EXPECT_NEAR(table.Widths[1], 2e-9, 1e-15);
  EXPECT_NEAR(table.Intervals[1].High[3], 1, 1e-5);
  EXPECT_NEAR(table.Intervals[2].Low[3], 1, 1e-5);
  EXPECT_FALSE(table.IsTransparent(0.4f, 0.6f));
}

TEST(TransferFunctionTable, RangesFarFromZeroAndHuge)
{
  for (const auto& [low, high] : { std::pair<double, double>(-1e12, -1e12 + 1), { 1e15, 1e15 + 64 },
         { -8e307, 8e307 }, { 0, 1e-300 } })
  {
    Functions f;
    const double middle = 0.5 * low + 0.5 * high;
    f.Opacity->AddPoint(low, 0.25);
    f.Opacity->AddPoint(middle, 0.75);
    f.Opacity->AddPoint(high, 0.5);
    const TransferFunctionTable table = f.Build(low, high);
    EXPECT_LE(table.Nodes.size(), 8u) << low;
    EXPECT_NEAR(table.Evaluate(0.0f)[3], 0.25, 1e-5) << low;
    EXPECT_NEAR(table.Evaluate(0.25f)[3], 0.5, 2e-3) << low;
    EXPECT_NEAR(table.Evaluate(0.5f)[3], 0.75, 1e-5) << low;
    EXPECT_NEAR(table.Evaluate(1.0f)[3], 0.5, 1e-5) << low;
  }
}
