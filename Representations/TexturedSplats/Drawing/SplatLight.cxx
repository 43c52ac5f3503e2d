// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SplatLight.h"

#include "SplatClasses.h"
#include "SplatMatrix.h"
#include "SplatSamples.h"
#include "SplatTree.h"

#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace nephoscope
{
namespace
{
using Float4 = std::array<float, 4>;
constexpr std::size_t numberOfColors = 4096;

double MassOf(const Float4& color, const SplatSamples::Jacobian& shape)
{
  const SplatMatrix j = { { ToDouble(shape[0]), ToDouble(shape[1]), ToDouble(shape[2]) } };
  return color[3] * std::abs(Determinant(j));
}

// Means of parts of the light, weighted by mass. The second moment belongs to an axis: what is
// added is the moment, and the axis times the root of its size.
struct MeanParts
{
  void Add(const Float4* parts, double mass)
  {
    this->Mass += mass;
    this->Moment += (parts[1][0] < 0 ? -mass : mass) *
      (double(parts[1][1]) * parts[1][1] + double(parts[1][2]) * parts[1][2] +
        double(parts[1][3]) * parts[1][3]);
    this->Single += mass * std::abs(parts[1][0]);
    for (std::size_t c = 0; c < 4; ++c)
    {
      this->First[c] += mass * parts[0][c];
      this->Axis[c] += c > 0 ? mass * parts[1][c] : 0;
    }
  }

  void AppendTo(std::vector<Float4>& parts) const
  {
    const double scale = 1 / std::max(this->Mass, 1e-300);
    const double length = std::sqrt(this->Axis[1] * this->Axis[1] + this->Axis[2] * this->Axis[2] +
      this->Axis[3] * this->Axis[3]);
    const double root = std::sqrt(std::abs(this->Moment) * scale) / std::max(length, 1e-300);
    Float4 first, second;
    for (std::size_t c = 0; c < 4; ++c)
    {
      first[c] = static_cast<float>(scale * this->First[c]);
      second[c] = static_cast<float>(root * this->Axis[c]);
    }
    second[0] = static_cast<float>((this->Moment < 0 ? -scale : scale) * this->Single);
    parts.push_back(first);
    parts.push_back(second);
  }

  double Mass = 0, Moment = 0, Single = 0;
  std::array<double, 4> First{}, Axis{};
};

// Two for each splat of the classes and each node, whose children come before it.
std::vector<Float4> PartsOf(const SplatLightSource& source, const SplatSamples& samples,
  const SplatClasses& classes, const SplatTree& tree)
{
  const std::vector<Float4> ofData = source.Light.Parts(source.Width);
  std::vector<Float4> parts;
  parts.reserve(2 * (classes.Samples.size() + tree.Nodes().size()));
  for (const std::int32_t sample : classes.Samples)
  {
    const auto id = static_cast<std::size_t>(samples.Ids[static_cast<std::size_t>(sample)]);
    parts.insert(parts.end(), { ofData[2 * id], ofData[2 * id + 1] });
  }
  for (const SplatTreeNode& node : tree.Nodes())
  {
    MeanParts mean;
    for (const std::int32_t* child = tree.BeginChildren(node); child != tree.EndChildren(node);
         ++child)
    {
      const auto splat = static_cast<std::size_t>(*child);
      const double mass = tree.IsLeaf(*child)
        ? MassOf(classes.Colors[splat],
            samples.JacobianOf(static_cast<std::size_t>(classes.Samples[splat])))
        : MassOf(tree.Node(*child).Color, tree.Node(*child).Jacobian);
      mean.Add(&parts[2 * splat], mass);
    }
    mean.AppendTo(parts);
  }
  return parts;
}
}

std::string SplatLight::Upload(vtkOpenGLRenderWindow* window, const SplatLightSource& source,
  const SplatSamples& samples, const SplatClasses& classes, const SplatTree& tree)
{
  this->NumberOfPhases = 0;
  if (!source.Light.IsUsed())
  {
    this->Parts.Release(window);
    return std::string();
  }
  const std::vector<Float4> parts = PartsOf(source, samples, classes, tree);
  const std::vector<std::array<float, 2>> phases = source.Light.Factors();
  const float first = source.Colors.Nodes.front();
  this->Range = { { first, std::max(source.Colors.Nodes.back() - first, 1e-6f) } };
  std::vector<Float4> colors;
  for (std::size_t i = 0; i < numberOfColors; ++i)
  {
    const float at = static_cast<float>(i) / static_cast<float>(numberOfColors - 1);
    colors.push_back(source.Colors.Evaluate(first + at * this->Range[1]));
  }
  this->TowardsSun = source.Light.TowardsSun();
  std::string error = this->Parts.Upload(window, parts.data(), parts.size(), 4, VTK_FLOAT);
  error =
    error.empty() ? this->Phases.Upload(window, phases.data(), phases.size(), 2, VTK_FLOAT) : error;
  error =
    error.empty() ? this->Colors.Upload(window, colors.data(), colors.size(), 4, VTK_FLOAT) : error;
  this->NumberOfPhases = error.empty() ? static_cast<int>(phases.size()) : 0;
  return error;
}

void SplatLight::Activate(vtkShaderProgram* program, vtkMatrix4x4* modelToView)
{
  if (!this->IsUsed())
  {
    return;
  }
  program->SetUniformi("lightParts", this->Parts.Activate());
  program->SetUniformi("phaseFunction", this->Phases.Activate());
  program->SetUniformi("lightColors", this->Colors.Activate());
  program->SetUniformi("numberOfPhases", this->NumberOfPhases);
  program->SetUniformi("numberOfLightColors", static_cast<int>(numberOfColors));
  program->SetUniform3f("towardsSun", this->TowardsSun.data());
  program->SetUniform2f("lightRange", this->Range.data());
  vtkNew<vtkMatrix4x4> viewToModel;
  vtkMatrix4x4::Invert(modelToView, viewToModel);
  float columns[9];
  for (int i = 0; i < 9; ++i)
  {
    columns[i] = static_cast<float>(viewToModel->GetElement(i % 3, i / 3));
  }
  program->SetUniformMatrix3x3("VCToData", columns);
}

void SplatLight::Deactivate()
{
  if (this->IsUsed())
  {
    this->Parts.Deactivate();
    this->Phases.Deactivate();
    this->Colors.Deactivate();
  }
}

void SplatLight::Release(vtkWindow* window)
{
  this->Parts.Release(window);
  this->Phases.Release(window);
  this->Colors.Release(window);
  this->NumberOfPhases = 0;
}

} // namespace nephoscope
