// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CloudShaderCode.h"

#include "CloudDepthsFragment.h"
#include "CloudOpacityFunction.h"
#include "CloudThicknessFunction.h"
#include "GardnerShaderConstants.h"
#include "GardnerTextureFunctions.h"
#include "SurfaceLists.h"
#include "SurfaceListsLookup.h"

#include "vtkShaderProgram.h"

#include <sstream>

namespace nephoscope
{
namespace
{
const char* Word(bool value)
{
  return value ? "true" : "false";
}

std::string ConstantsOf(const TexturedSurface& surface, bool hasColors, const GardnerWaves& waves)
{
  return GardnerConstants(waves) + "const bool hasSecondSet = " + Word(surface.HasSecondSet) +
    ";\n" + "const bool hasNormals = " + Word(!surface.Normals.empty()) + ";\n" +
    "const bool hasColors = " + Word(hasColors) + ";\n";
}

std::string ListsLookup()
{
  std::string lists = SurfaceListsLookup;
  vtkShaderProgram::Substitute(
    lists, "//NEPHOSCOPE::Columns", std::to_string(SurfaceLists::Columns));
  return lists;
}

/** Looks at the list of the pixel, or at as many layers as were found. */
std::string LayerLookups(bool hasDensity, int drawings)
{
  if (drawings == 0)
  {
    return "uniform usampler2D cloudHeads;\nuniform sampler2D cloudNodes;\n"
           "#define headOfPixel(pixel) texelFetch(cloudHeads, pixel, 0).r\n"
           "#define nodeAt(place) texelFetch(cloudNodes, place, 0)\n" +
      ListsLookup();
  }
  std::ostringstream uniforms, code;
  for (int i = 0; i < drawings; ++i)
  {
    uniforms << "uniform sampler2D " << DepthsUniform(i) << ";\n";
    code << "  if (cloudDrawings > " << i << ")\n  {\n    considerLayer(texelFetch("
         << DepthsUniform(i) << ", pixel, 0), ";
    if (hasDensity)
    {
      uniforms << "uniform sampler2D " << DensitiesUniform(i) << ";\n";
      code << "texelFetch(" << DensitiesUniform(i) << ", pixel, 0)";
    }
    else
    {
      code << "vec4(1.0)";
    }
    code << ");\n  }\n";
  }
  return uniforms.str() + "void considerLayers(ivec2 pixel)\n{\n" + code.str() + "}\n";
}

/** `volume`: code of meanDensityOfVolume, empty: there is none. */
std::string ThicknessCode(const std::string& layers, const std::string& volume, bool hasDepths)
{
  std::string code = CloudThicknessFunction;
  vtkShaderProgram::Substitute(code, "//NEPHOSCOPE::Layers", layers);
  vtkShaderProgram::Substitute(code, "//NEPHOSCOPE::DensityVolume",
    volume.empty() ? "float meanDensityOfVolume(vec3 a, vec3 b, float enough) { return 1.0; }\n"
                   : volume);
  return std::string("const bool hasDensityVolume = ") + Word(!volume.empty()) +
    ";\nconst bool hasDepths = " + Word(hasDepths) + ";\n" + code;
}

std::string Input(const std::vector<CloudAttribute>& attributes, const std::string& name,
  const std::string& otherwise)
{
  for (const CloudAttribute& a : attributes)
  {
    if (a.Name == name)
    {
      return name + "VSOutput";
    }
  }
  return otherwise;
}

void AddBefore(vtkShader* shader, const std::string& tag, const std::string& code)
{
  std::string source = shader->GetSource();
  vtkShaderProgram::Substitute(source, tag, code + "\n" + tag, false);
  shader->SetSource(source);
}

void AddVertexCode(std::map<vtkShader::Type, vtkShader*>& shaders,
  const std::vector<CloudAttribute>& attributes, bool view, bool world)
{
  std::string vertexDec, vertexImpl, geometryDec, geometryImpl;
  for (const CloudAttribute& a : attributes)
  {
    if (view && a.Name == "cloudPlace")
    {
      continue; // needed for the view only
    }
    vertexDec += "in " + a.Type + " " + a.Name + ";\nout " + a.Type + " " + a.Name + "VSOutput;\n";
    vertexImpl += "  " + a.Name + "VSOutput = " + a.Name + ";\n";
    geometryDec +=
      "in " + a.Type + " " + a.Name + "VSOutput[];\nout " + a.Type + " " + a.Name + "GSOutput;\n";
    geometryImpl += "  " + a.Name + "GSOutput = " + a.Name + "VSOutput[i];\n";
  }
  if (view)
  {
    vertexDec += "in vec3 cloudPlace;\nuniform mat4 placeToView;\nout vec3 cloudViewVSOutput;\n";
    vertexImpl += "  cloudViewVSOutput = (placeToView * vec4(cloudPlace, 1.0)).xyz;\n";
    geometryDec += "in vec3 cloudViewVSOutput[];\nout vec3 cloudViewGSOutput;\n";
    geometryImpl += "  cloudViewGSOutput = cloudViewVSOutput[i];\n";
  }
  if (world)
  {
    vertexDec += "uniform mat3 placeToWorld;\nout vec3 cloudWorldVSOutput;\n";
    vertexImpl += "  cloudWorldVSOutput = placeToWorld * cloudPlace;\n";
    geometryDec += "in vec3 cloudWorldVSOutput[];\nout vec3 cloudWorldGSOutput;\n";
    geometryImpl += "  cloudWorldGSOutput = cloudWorldVSOutput[i];\n";
  }
  AddBefore(shaders[vtkShader::Vertex], "//VTK::Color::Dec", vertexDec);
  AddBefore(shaders[vtkShader::Vertex], "//VTK::Color::Impl", vertexImpl);
  AddBefore(shaders[vtkShader::Geometry], "//VTK::Color::Dec", geometryDec);
  AddBefore(shaders[vtkShader::Geometry], "//VTK::Color::Impl", geometryImpl);
}
}

std::vector<std::string> AllCloudAttributeNames()
{
  return { "cloudPlace", "cloudTexture1", "cloudTexture2", "cloudCover", "cloudNormal",
    "cloudDensity", "cloudWeights" };
}

std::vector<CloudAttribute> CloudAttributesOf(const TexturedSurface& surface)
{
  std::vector<CloudAttribute> result{ { "cloudPlace", "vec3", placeArrayName },
    { "cloudTexture1", "vec3", textureArrayNames[0] } };
  const auto add = [&](bool isThere, const char* name, const char* type, const std::string& array) {
    if (isThere)
    {
      result.push_back({ name, type, array });
    }
  };
  add(surface.HasSecondSet, "cloudTexture2", "vec3", textureArrayNames[1]);
  add(surface.HasCover, "cloudCover", "float", coverArrayName);
  add(!surface.Normals.empty(), "cloudNormal", "vec3", surface.Normals);
  add(surface.HasDensity, "cloudDensity", "float", densityArrayName);
  add(surface.HasWeights, "cloudWeights", "vec2", weightsArrayName);
  return result;
}

std::string DepthsUniform(int i)
{
  return "cloudDepths" + std::to_string(i);
}

std::string DensitiesUniform(int i)
{
  return "cloudDensities" + std::to_string(i);
}

std::string LayerConstants(const TexturedSurface& surface)
{
  return std::string("const bool hasDensity = ") + Word(surface.HasDensity) + ";\n";
}

std::string CloudDepthsCode(const std::string& volume)
{
  std::string code = CloudDepthsFragment;
  vtkShaderProgram::Substitute(code, "//NEPHOSCOPE::Constants", "const bool hasDensity = false;");
  vtkShaderProgram::Substitute(
    code, "//NEPHOSCOPE::Thickness", ThicknessCode(ListsLookup(), volume, false));
  return code;
}

void AddCloudCode(std::map<vtkShader::Type, vtkShader*>& shaders, const TexturedSurface& surface,
  const CloudShaderChoice& choice)
{
  const std::vector<CloudAttribute> attributes = CloudAttributesOf(surface);
  AddVertexCode(shaders, attributes, choice.UseThickness, choice.HasRegion);
  std::string dec, early;
  // By thickness places are those in the view.
  const std::string place = choice.UseThickness ? "cloudViewVSOutput" : "cloudPlaceVSOutput";
  for (const CloudAttribute& a : attributes)
  {
    dec += choice.UseThickness && a.Name == "cloudPlace"
      ? ""
      : "in " + a.Type + " " + a.Name + "VSOutput;\n";
  }
  dec += "uniform float coverage;\nuniform vec2 textureWeights;\n" +
    ConstantsOf(surface, choice.HasColors, choice.Waves) + GardnerTextureFunctions +
    CloudOpacityFunction;
  if (choice.HasRegion)
  {
    dec += "in vec3 cloudWorldVSOutput;\nuniform vec3 regionLow;\nuniform vec3 regionHigh;\n";
    early =
      "  if (any(lessThan(cloudWorldVSOutput, regionLow)) || any(greaterThanEqual(cloudWorldVSOutput, regionHigh)))\n"
      "  {\n    discard;\n  }\n";
  }
  const std::string normal = Input(attributes, "cloudNormal", "vec3(0.0)");
  std::string depth = "opticalDepthOfLayer(" + place + ", " + normal + ")";
  if (choice.UseThickness)
  {
    const bool hasDepths = choice.Drawings == 0 && !choice.DensityVolume.empty();
    dec += "in vec3 cloudViewVSOutput;\n" +
      ThicknessCode(LayerLookups(surface.HasDensity, choice.Drawings),
        hasDepths ? std::string() : choice.DensityVolume, hasDepths);
    dec += choice.ThicknessIsAdded ? "uniform float thicknessWeight;\n" : "";
    const std::string fragment = "cloudViewVSOutput, " + Input(attributes, "cloudDensity", "1.0") +
      ", gl_FrontFacing == (cloudFrontIsFront != 0)";
    early += "  cloudEnds = vec2(noThickness);\n  if (cloudDrawings >= 0 && !findCloud(" +
      fragment + "))\n  {\n    discard;\n  }\n";
    depth = "cloudDepth(" + fragment + ", " +
      (choice.ThicknessIsAdded ? "true" : "cloudLooks.a > 0.0") + ", " + depth + ")";
  }
  const std::string second = Input(attributes, "cloudTexture2", "vec3(0.0)");
  vtkShader* fragment = shaders[vtkShader::Fragment];
  AddBefore(fragment, "//VTK::Color::Dec", dec);
  AddBefore(fragment, "//VTK::UniformFlow::Impl",
    "  takeFootprints(" + place + ", cloudTexture1VSOutput, " + second + ");\n");
  // What starts no cloud is no layer for depth peeling either.
  AddBefore(fragment, "//VTK::DepthPeeling::PreColor", early);
  std::string source = fragment->GetSource();
  const std::string added = choice.ThicknessIsAdded ? "thicknessWeight * " + depth : "0.0";
  const std::string opacity = "  vec4 cloudLooks = cloudLook(cloudTexture1VSOutput, " + second +
    ", " + Input(attributes, "cloudWeights", "textureWeights") + ", " +
    Input(attributes, "cloudCover", "coverage") + ", " + added + ");\n" +
    "  opacity *= cloudLooks.a * (1.0 - exp(-" +
    (choice.ThicknessIsAdded ? "opticalDepth" : depth) + "));\n" +
    "  ambientColor *= cloudLooks.rgb;\n  diffuseColor *= cloudLooks.rgb;\n";
  vtkShaderProgram::Substitute(
    source, "//VTK::Color::Impl", "//VTK::Color::Impl\n" + opacity, false);
  fragment->SetSource(source);
}

} // namespace nephoscope
