// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// ContourSurfaces.glsl: segments through surfaces and layers against the same cut by hand and integrated in long double.
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
using Double4 = std::array<long double, 4>;
constexpr int numberOfContours = 4;

/** A medium with one ramp per layer: constant colour, extinction a + b s. */
struct Layer
{
  std::array<float, 3> Color;
  float Low, High; // at scalar 0 and 1
};

struct Scene
{
  std::vector<Layer> Layers;                  // one more than contours
  std::vector<std::array<float, 5>> Contours; // value, colour, opacity
};

Scene randomScene(Random& random)
{
  Scene scene;
  for (int i = 0; i <= numberOfContours; ++i)
  {
    scene.Layers.push_back(
      { { { float(random.Uniform()), float(random.Uniform()), float(random.Uniform()) } },
        float(random.Uniform()), float(random.Uniform()) });
    scene.Contours.push_back({ { float((i + random.Uniform(0.2, 0.8)) / numberOfContours),
      float(random.Uniform()), float(random.Uniform()), float(random.Uniform()),
      i % 3 ? float(random.Uniform()) : 0.0f } });
  }
  scene.Contours.pop_back();
  return scene;
}

void addBuffers(ShaderRunner& runner, const Scene& scene)
{
  std::vector<float> nodes, intervals, tables, contours;
  for (const Layer& layer : scene.Layers)
  {
    const float n = float(nodes.size() / 2);
    tables.insert(tables.end(), { n, 2, n, 2, 0, 0, 0, 0 });
    nodes.insert(nodes.end(), { 0, 1, 1, 0 });
    for (const float a : { layer.Low, layer.Low, layer.Low, layer.High, layer.High, layer.High })
    {
      intervals.insert(intervals.end(), layer.Color.begin(), layer.Color.end());
      intervals.push_back(a);
    }
  }
  for (std::size_t i = 0; i < scene.Contours.size(); ++i)
  {
    contours.insert(contours.end(), { scene.Contours[i][0], float(i), float(i + 1), 0 });
    contours.insert(contours.end(), scene.Contours[i].begin() + 1, scene.Contours[i].end());
  }
  runner.AddBuffer("transferNodes", nodes, 2);
  runner.AddBuffer("transferIntervals", intervals, 4);
  runner.AddBuffer("layerTables", tables, 4);
  runner.AddBuffer("contours", contours, 4);
}

void compositeMedium(
  const Layer& layer, long double front, long double back, long double length, Double4& result)
{
  const auto extinction = [&](long double s) {
    return layer.Low + s * ((long double)(layer.High) - layer.Low);
  };
  const ReferenceWeights weights =
    referenceWeights(extinction(front) * length, extinction(back) * length);
  const long double clear = 1 - result[3], alpha = weights.Front + weights.Back;
  for (std::size_t c = 0; c < 3; ++c)
  {
    result[c] += clear * alpha * layer.Color[c];
  }
  result[3] += clear * alpha;
}

Double4 referenceSegment(const Scene& scene, long double front, long double back, long double scale)
{
  std::vector<std::pair<long double, std::size_t>> cuts;
  for (std::size_t i = 0; i < scene.Contours.size(); ++i)
  {
    const long double value = scene.Contours[i][0];
    if ((front >= value) != (back >= value))
    {
      cuts.emplace_back((value - front) / (back - front), i);
    }
  }
  std::sort(cuts.begin(), cuts.end());
  Double4 result = {};
  long double from = 0;
  const auto at = [&](long double t) { return front + t * (back - front); };
  const auto medium = [&](long double to) {
    std::size_t layer = 0;
    const long double middle = front == back ? front : at(0.5L * (from + to));
    while (layer < scene.Contours.size() && scene.Contours[layer][0] <= middle)
    {
      ++layer;
    }
    compositeMedium(scene.Layers[layer], at(from), at(to), (to - from) * scale, result);
  };
  for (const auto& [t, i] : cuts)
  {
    medium(t);
    const long double visible = (1 - result[3]) * scene.Contours[i][4];
    for (std::size_t c = 0; c < 3; ++c)
    {
      result[c] += visible * scene.Contours[i][1 + c];
    }
    result[3] += visible;
    from = t;
  }
  medium(1);
  return result;
}

std::string shaderSource()
{
  std::string constants;
  for (const char* on :
    { "splitAtControlPoints", "useLayers", "useContours", "contourLayers", "contourOfColor" })
  {
    constants += std::string("const bool ") + on + " = true;\n";
  }
  for (const char* off :
    { "averageIntegration", "separateOpacity", "contourLighting", "smoothContourNormals" })
  {
    constants += std::string("const bool ") + off + " = false;\n";
  }
  return constants +
    "uniform vec4 eyeVC;\nuniform IntegerArray tetrahedra;\nuniform FloatArray points;\n" +
    readShader("OpticalSegment.glsl") + readShader("TransferFunction.glsl") +
    readShader("ContourSurfaces.glsl") + readShader("ProjectedContours.glsl");
}

void setUniforms(vtkShaderProgram* program)
{
  float nodes[numberOfQuadratureNodes][2];
  for (int i = 0; i < numberOfQuadratureNodes; ++i)
  {
    nodes[i][0] = float(quadratureNodes[i][0]);
    nodes[i][1] = float(quadratureNodes[i][1]);
  }
  program->SetUniform2fv("quadratureNodes", numberOfQuadratureNodes, nodes);
  program->SetUniformi("numberOfContours", numberOfContours);
  // Not read here, but two kinds of sampler must not share a texture unit.
  const char* const unused[] = { "tetrahedra", "points", "contourGradients", "opacityNodes",
    "opacityIntervals" };
  for (int i = 0; i < 5; ++i)
  {
    if (program->IsUniformUsed(unused[i]))
    {
      program->SetUniformi(unused[i], i == 0 ? 14 : 15);
    }
  }
}
}

TEST(ContourShader, SurfacesAndLayers)
{
  Random random(81);
  const Scene scene = randomScene(random);
  ShaderRunner runner;
  addBuffers(runner, scene);
  std::vector<Float4> segments, scales;
  while (segments.size() < 3000)
  {
    float front = float(random.Uniform()), back = float(random.Uniform());
    const std::size_t kind = segments.size() % 5;
    if (kind == 1) // ends that lie on a contour
    {
      front = scene.Contours[std::size_t(random.Integer(0, numberOfContours - 1))][0];
    }
    if (kind == 2)
    {
      back = scene.Contours[std::size_t(random.Integer(0, numberOfContours - 1))][0];
    }
    if (kind == 3)
    {
      back = front = scene.Contours[std::size_t(random.Integer(0, numberOfContours - 1))][0];
    }
    if (front == back || std::fabs(front - back) > 0.05f)
    {
      segments.push_back({ { front, back, 0, 0 } });
      scales.push_back({ { float(random.LogUniform(1e-3, 20)), 0, 0, 0 } });
    }
  }
  const auto results = runner.Run(shaderSource(),
    "ContourSegment segment = ContourSegment(0, first.xxxy, first.xy, vec4(1, 0, 0, 0), vec4(0, 0, 0, 1), vec3(0), vec3(0));"
    "result = integrateSegmentWithContours(first.xx, first.yy, second.x, segment, 0);",
    segments, scales, setUniforms);
  double largest = 0;
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    const Double4 expected = referenceSegment(scene, segments[i][0], segments[i][1], scales[i][0]);
    for (std::size_t c = 0; c < 4; ++c)
    {
      const double difference = std::fabs(double(results[i][c] - expected[c]));
      EXPECT_LE(difference, 3e-6) << "from " << segments[i][0] << " to " << segments[i][1]
                                  << ", optical scale " << scales[i][0] << ", component " << c;
      largest = std::max(largest, difference);
    }
  }
  std::cout << "largest error: " << largest << std::endl;
}
