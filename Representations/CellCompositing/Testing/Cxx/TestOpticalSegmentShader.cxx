// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The shaders' integrals against those of C++: OpticalSegment.glsl against OpticalSegment.h, and
// TransferFunction.glsl against segments cut at every node of random functions and integrated in
// long double.
#include "ShaderRunner.h"

#include "OpticalSegment.h"
#include "TransferFunctionTable.h"

#include "SegmentReference.h"
#include "TestRandom.h"

#include <algorithm>

using namespace nephoscope;
using namespace nephoscope_test;

namespace
{
std::string Constant(const char* name, bool value)
{
  return std::string("const bool ") + name + (value ? " = true;\n" : " = false;\n");
}

void SetQuadratureNodes(vtkShaderProgram* program)
{
  float nodes[numberOfQuadratureNodes][2];
  for (int i = 0; i < numberOfQuadratureNodes; ++i)
  {
    nodes[i][0] = float(quadratureNodes[i][0]);
    nodes[i][1] = float(quadratureNodes[i][1]);
  }
  if (program->IsUniformUsed("quadratureNodes")) // the average rule does without
  {
    EXPECT_TRUE(program->SetUniform2fv("quadratureNodes", numberOfQuadratureNodes, nodes));
  }
}

/**
 * Pairs of optical depths: 0 and 10^-6 to 10^3 in equal steps of the logarithm, and the ends of the
 * rules.
 */
std::vector<Float4> OpticalDepthGrid()
{
  std::vector<float> depths = { 0, 0.05f, 0.25f, 1, 10, 0.0399f, 0.04f };
  for (int i = 0; i <= 72; ++i)
  {
    depths.push_back(float(std::pow(10.0, -6 + i / 8.0)));
  }
  std::vector<Float4> pairs;
  for (const float tf : depths)
  {
    for (const float tb : depths)
    {
      pairs.push_back({ { tf, tb, 0, 0 } });
    }
  }
  return pairs;
}

double LargestDifference(ShaderRunner& runner, bool average)
{
  const std::vector<Float4> pairs = OpticalDepthGrid();
  const std::vector<Float4> results = runner.Run(
    Constant("averageIntegration", average) + ReadShader("OpticalSegment.glsl"),
    "result = vec4(segmentWeights(first.x, first.y), 0.0, 1.0);", pairs, pairs, SetQuadratureNodes);
  double largest = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    EXPECT_EQ(results[i][3], 1.0f) << "not drawn";
    const SegmentWeights<float> weights = average ? AverageSegmentWeights(pairs[i][0], pairs[i][1])
                                                  : ExactSegmentWeights(pairs[i][0], pairs[i][1]);
    const double difference =
      std::max(std::fabs(results[i][0] - weights.Front), std::fabs(results[i][1] - weights.Back));
    EXPECT_LE(difference, 2e-6) << pairs[i][0] << " " << pairs[i][1];
    largest = std::max(largest, difference);
  }
  return largest;
}

// ---- transfer functions -------------------------------------------------------------------------

TransferFunctionTable RandomTable(Random& random, int nodes)
{
  TransferFunctionTable table;
  for (int i = 0; i < nodes; ++i)
  {
    table.Nodes.push_back(float((i + random.Uniform(0.2, 0.8)) / nodes));
  }
  for (int i = 0; i < nodes; ++i)
  {
    table.Widths.push_back(i + 1 < nodes ? table.Nodes[i + 1] - table.Nodes[i] : 0.0f);
  }
  TransferFunctionTable::Value last = {};
  for (int i = 0; i <= nodes; ++i)
  {
    TransferFunctionTable::Interval interval;
    for (std::size_t c = 0; c < 4; ++c)
    {
      const bool jump = i == 0 || random.Integer(0, 1);
      interval.Low[c] = jump ? float(random.Uniform()) : last[c];
      interval.High[c] = i == 0 || i == nodes ? interval.Low[c] : float(random.Uniform());
    }
    last = interval.High;
    table.Intervals.push_back(interval);
  }
  return table;
}

void AddTable(ShaderRunner& runner, const std::string& prefix, const TransferFunctionTable& table)
{
  std::vector<float> nodes; // (position, width above)
  for (std::size_t i = 0; i < table.Nodes.size(); ++i)
  {
    nodes.push_back(table.Nodes[i]);
    nodes.push_back(table.Widths[i]);
  }
  runner.AddBuffer(prefix + "Nodes", nodes, 2);
  std::vector<float> values;
  for (const auto& interval : table.Intervals)
  {
    values.insert(values.end(), interval.Low.begin(), interval.Low.end());
    values.insert(values.end(), interval.High.begin(), interval.High.end());
  }
  runner.AddBuffer(prefix + "Intervals", values, 4);
}

using Double4 = std::array<long double, 4>;

/** The line of the interval that holds `inside`, at s. */
Double4 EvaluateLine(const TransferFunctionTable& table, long double inside, long double s)
{
  std::size_t k = 0;
  while (k < table.Nodes.size() && table.Nodes[k] <= inside)
  {
    ++k;
  }
  const auto& interval = table.Intervals[k];
  const bool outside = k == 0 || k == table.Nodes.size();
  const long double t =
    outside ? 0 : (s - table.Nodes[k - 1]) / ((long double)(table.Nodes[k]) - table.Nodes[k - 1]);
  Double4 value;
  for (std::size_t c = 0; c < 4; ++c)
  {
    value[c] = interval.Low[c] + t * ((long double)(interval.High[c]) - interval.Low[c]);
  }
  return value;
}

struct Functions
{
  TransferFunctionTable Transfer, Opacity;
  bool Separate;
};

void AddCuts(const TransferFunctionTable& table, long double front, long double back,
  std::vector<long double>& cuts)
{
  for (const float node : table.Nodes)
  {
    const long double t = front == back ? -1 : (node - front) / (back - front);
    if (t > 0 && t < 1)
    {
      cuts.push_back(t);
    }
  }
}

/**
 * Colour and alpha of a segment; x of its ends is read by the first function, y by the opacity
 * function.
 */
Double4 ReferenceSegment(const Functions& f, const Float4& ends, long double scale)
{
  std::vector<long double> cuts = { 0, 1 };
  AddCuts(f.Transfer, ends[0], ends[2], cuts);
  if (f.Separate)
  {
    AddCuts(f.Opacity, ends[1], ends[3], cuts);
  }
  std::sort(cuts.begin(), cuts.end());
  Double4 result = {};
  for (std::size_t i = 1; i < cuts.size(); ++i)
  {
    const auto mix = [](long double a, long double b, long double t) { return a + t * (b - a); };
    const long double from = cuts[i - 1], to = cuts[i], middle = 0.5L * (from + to);
    const auto at = [&](long double t) {
      Double4 value =
        EvaluateLine(f.Transfer, mix(ends[0], ends[2], middle), mix(ends[0], ends[2], t));
      value[3] = f.Separate
        ? EvaluateLine(f.Opacity, mix(ends[1], ends[3], middle), mix(ends[1], ends[3], t))[3]
        : value[3];
      return value;
    };
    const Double4 front = at(from), back = at(to);
    const long double length = scale * (to - from);
    const ReferenceWeights weights = FindReferenceWeights(front[3] * length, back[3] * length);
    const long double clear = 1 - result[3];
    for (std::size_t c = 0; c < 3; ++c)
    {
      result[c] += clear * (weights.Front * front[c] + weights.Back * back[c]);
    }
    result[3] += clear * (weights.Front + weights.Back);
  }
  return result;
}

/**
 * Ends of segments: wide ones, level ones, and both outside. Narrow ones would make the place of a
 * jump uncertain in float.
 */
std::vector<Float4> RandomSegments(Random& random, int n)
{
  const auto end = [&]() { return float(random.Uniform(-0.2, 1.2)); };
  std::vector<Float4> segments;
  while (int(segments.size()) < n)
  {
    Float4 s = { { end(), end(), end(), end() } };
    if (random.Integer(0, 4) == 0)
    {
      s[2] = s[0];
    }
    if (random.Integer(0, 4) == 0)
    {
      s[3] = s[1];
    }
    const auto acceptable = [](float a, float b) { return a == b || std::fabs(a - b) > 0.05f; };
    if (acceptable(s[0], s[2]) && acceptable(s[1], s[3]))
    {
      segments.push_back(s);
    }
  }
  return segments;
}

double LargestSegmentError(Random& random, bool separate)
{
  ShaderRunner runner;
  const Functions f = { RandomTable(random, 9), RandomTable(random, 7), separate };
  AddTable(runner, "transfer", f.Transfer);
  AddTable(runner, "opacity", f.Opacity);
  const std::vector<Float4> segments = RandomSegments(random, 2000);
  std::vector<Float4> scales;
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    scales.push_back({ { float(random.LogUniform(1e-3, 20)), 0, 0, 0 } });
  }
  const std::string functions = Constant("averageIntegration", false) +
    Constant("separateOpacity", separate) + Constant("splitAtControlPoints", true) +
    Constant("useLayers", false) + ReadShader("OpticalSegment.glsl") +
    ReadShader("TransferFunction.glsl");
  const auto results =
    runner.Run(functions, "result = integrateSegment(first.xy, first.zw, second.x);", segments,
      scales, [&](vtkShaderProgram* program) {
        SetQuadratureNodes(program);
        program->SetUniformi("numberOfTransferNodes", int(f.Transfer.Nodes.size()));
        program->SetUniformi("numberOfOpacityNodes", int(f.Opacity.Nodes.size()));
      });
  double largest = 0;
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    const Double4 expected = ReferenceSegment(f, segments[i], scales[i][0]);
    for (std::size_t c = 0; c < 4; ++c)
    {
      const double difference = std::fabs(double(results[i][c] - expected[c]));
      EXPECT_LE(difference, 2e-6) << "from " << segments[i][0] << ", " << segments[i][1] << " to "
                                  << segments[i][2] << ", " << segments[i][3] << ", optical scale "
                                  << scales[i][0] << ", component " << c;
      largest = std::max(largest, difference);
    }
  }
  return largest;
}
}

TEST(OpticalSegmentShader, ExactWeights)
{
  ShaderRunner runner;
  std::cout << "largest difference to C++ in float: " << LargestDifference(runner, false)
            << std::endl;
}

TEST(OpticalSegmentShader, AverageWeights)
{
  ShaderRunner runner;
  std::cout << "largest difference to C++ in float: " << LargestDifference(runner, true)
            << std::endl;
}

TEST(TransferFunctionShader, SegmentsThroughJumps)
{
  Random random(71);
  std::cout << "largest error: " << LargestSegmentError(random, false) << std::endl;
}

TEST(TransferFunctionShader, OpacityFromAnotherArray)
{
  Random random(72);
  std::cout << "largest error: " << LargestSegmentError(random, true) << std::endl;
}
