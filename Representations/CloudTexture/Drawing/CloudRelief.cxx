// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CloudRelief.h"

#include "CloudReliefFunction.h"
#include "SurfaceLength.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPolyData.h"
#include "vtkShader.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace nephoscope
{

void AddReliefCode(vtkShader* fragment, bool hasSecondSet, const char* weights)
{
  std::string source = fragment->GetSource();
  if (source.find("vec3 normalVCVSOutput =") == std::string::npos)
  {
    return; // nothing is lit
  }
  const auto addBefore = [&source](const std::string& tag, const std::string& code) {
    vtkShaderProgram::Substitute(source, tag, code + tag, false);
  };
  const std::string coordinates =
    std::string("cloudTexture1VSOutput, ") + (hasSecondSet ? "cloudTexture2VSOutput" : "vec3(0.0)");
  addBefore("//VTK::TCoord::Dec", CloudReliefFunction);
  addBefore("//VTK::UniformFlow::Impl", "  takeRelief(vertexVC.xyz);\n");
  addBefore("//VTK::Light::Impl",
    "  normalVCVSOutput = raisedNormal(normalVCVSOutput, " + coordinates + ", " + weights + ");\n");
  fragment->SetSource(source);
}

double LargestWaveLength(
  vtkPolyData* surface, double given, double scale, const GardnerWaves& waves)
{
  vtkDataArray* told = surface->GetFieldData()->GetArray("TextureLength");
  double length = told && told->GetNumberOfTuples() > 0 ? told->GetComponent(0, 0) : given;
  if (!(length > 0))
  {
    length = SurfaceLength::Of(surface).Get();
  }
  const auto largest =
    std::max_element(waves.begin(), waves.end(), [](const GardnerWave& a, const GardnerWave& b) {
      return std::abs(a.Amplitude) < std::abs(b.Amplitude);
    });
  double frequency = 0;
  for (int c = 0; largest != waves.end() && c < 3; ++c)
  {
    frequency = std::max(frequency, std::abs(largest->Frequency[c]));
  }
  return frequency > 0 ? length / (scale * frequency) : 0;
}

} // namespace nephoscope
