// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// ProjectedTriangles.glsl and OpacityTable.glsl against ProjectedTriangles.h.
#include "ShaderRunner.h"

#include "ProjectedTriangles.h"

#include "TestRandom.h"

#include <cmath>

using namespace nephoscope;
using namespace nephoscope_test;

namespace
{
/** All signs, zeros included, with random magnitudes. */
std::vector<Float4> EyeCoordinateGrid(Random& random)
{
  std::vector<Float4> list;
  for (int code = 0; code < 81 * 50; ++code)
  {
    Float4 q;
    for (int i = 0, rest = code % 81; i < 4; ++i, rest /= 3)
    {
      q[std::size_t(i)] = float((rest % 3 - 1) * random.LogUniform(1e-6, 1e3));
    }
    list.push_back(q);
  }
  return list;
}

TetrahedronProjection ProjectInDouble(const Float4& q)
{
  return ProjectTetrahedron({ { q[0], q[1], q[2], q[3] } });
}

std::vector<Float4> Evaluate(const std::vector<Float4>& q, const std::string& body)
{
  ShaderRunner runner;
  return runner.Run(ReadShader("ProjectedTriangles.glsl"),
    "TetrahedronProjection p = projectTetrahedron(first);\n  " + body, q, q,
    [](vtkShaderProgram*) {});
}
}

TEST(ProjectedTrianglesShader, ThickVertex)
{
  Random random(61);
  const auto list = EyeCoordinateGrid(random);
  const auto front = Evaluate(list, "result = p.front;"), back = Evaluate(list, "result = p.back;");
  const auto parameter = Evaluate(list, "result = vec4(p.parameter, 0.0, 0.0, 1.0);");
  for (std::size_t i = 0; i < list.size(); ++i)
  {
    const TetrahedronProjection p = ProjectInDouble(list[i]);
    if (p.Parameter == 0)
    {
      EXPECT_EQ(parameter[i][0], 0.0f);
      continue;
    }
    EXPECT_NEAR(parameter[i][0], p.Parameter, 1e-6 * p.Parameter);
    for (std::size_t k = 0; k < 4; ++k)
    {
      EXPECT_NEAR(front[i][k], p.Front[k], 1e-6);
      EXPECT_NEAR(back[i][k], p.Back[k], 1e-6);
    }
  }
}

TEST(ProjectedTrianglesShader, FanEdges)
{
  Random random(62);
  const auto list = EyeCoordinateGrid(random);
  const auto first = Evaluate(
    list, "result = vec4(isFanEdge(p, 0, 1), isFanEdge(p, 0, 2), isFanEdge(p, 0, 3), 1.0);");
  const auto second = Evaluate(
    list, "result = vec4(isFanEdge(p, 1, 2), isFanEdge(p, 1, 3), isFanEdge(p, 2, 3), 1.0);");
  for (std::size_t i = 0; i < list.size(); ++i)
  {
    const TetrahedronProjection p = ProjectInDouble(list[i]);
    for (std::size_t e = 0; e < 6; ++e)
    {
      const float got = e < 3 ? first[i][e] : second[i][e - 3];
      EXPECT_EQ(got, IsFanEdge(p, tetrahedronEdges[e][0], tetrahedronEdges[e][1]) ? 1.0f : 0.0f)
        << "edge " << e;
    }
  }
}

TEST(OpacityTableShader, LookUp)
{
  Random random(63);
  ShaderRunner runner;
  const std::vector<float> table = MakeOpacityTable();
  runner.AddBuffer("alphaTable", table, 1);
  std::vector<Float4> depths = { { { 0, 0, 0, 0 } }, { { 16, 0, 0, 0 } }, { { 1e30f, 0, 0, 0 } } };
  for (int i = 0; i < 4000; ++i)
  {
    depths.push_back({ { float(random.LogUniform(1e-6, 40)), 0, 0, 0 } });
  }
  const auto results = runner.Run(ReadShader("OpacityTable.glsl"),
    "result = vec4(lookUpOpacity(first.x));", depths, depths, [](vtkShaderProgram* program) {
      program->SetUniformf("alphaTableEnd", float(opacityTableEnd));
      program->SetUniformi("alphaTableLast", opacityTableEntries - 1);
    });
  double largest = 0;
  for (std::size_t i = 0; i < depths.size(); ++i)
  {
    const double u = depths[i][0];
    EXPECT_NEAR(results[i][0], LookUpOpacity(table, opacityTableEnd, u), 1e-6) << u;
    largest = std::max(largest, std::fabs(results[i][0] + std::expm1(-u)));
  }
  std::cout << "largest error of the table on the GPU " << largest << std::endl;
  EXPECT_LT(largest, 3.2e-5);
}
