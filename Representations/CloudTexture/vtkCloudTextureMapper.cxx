// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCloudTextureMapper.h"

#include "CloudOpacityFunction.h"
#include "CloudRelief.h"
#include "CoverageThreshold.h"
#include "GardnerTexture.h"
#include "GardnerTextureFunctions.h"
#include "TexturedSurface.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkDataObject.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkShader.h"
#include "vtkShaderProgram.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"

#include <cmath>
#include <iomanip>
#include <sstream>
#include <tuple>
#include <vector>

vtkStandardNewMacro(vtkCloudTextureMapper);

namespace
{
/** What is read at every point: attribute of the vertex shader, its type, and the array of the surface it comes from. */
struct Attribute
{
  std::string Name;
  std::string Type;
  std::string Array;
};

std::vector<Attribute> attributesOf(const nephoscope::TexturedSurface& surface)
{
  std::vector<Attribute> result{ { "cloudPlace", "vec3", nephoscope::placeArrayName },
    { "cloudTexture1", "vec3", nephoscope::textureArrayNames[0] } };
  if (surface.HasSecondSet)
  {
    result.push_back({ "cloudTexture2", "vec3", nephoscope::textureArrayNames[1] });
  }
  if (surface.HasCover)
  {
    result.push_back({ "cloudCover", "float", nephoscope::coverArrayName });
  }
  if (!surface.Normals.empty())
  {
    result.push_back({ "cloudNormal", "vec3", surface.Normals });
  }
  return result;
}

void substitute(vtkShader* shader, const std::string& tag, const std::string& code)
{
  std::string source = shader->GetSource();
  vtkShaderProgram::Substitute(source, tag, code);
  shader->SetSource(source);
}
}

struct vtkCloudTextureMapper::vtkInternals
{
  using Key = std::tuple<vtkPolyData*, vtkMTimeType, std::string, std::string, std::string, double, double>;

  nephoscope::TexturedSurface Surface;
  Key MadeFrom{ nullptr, 0, "", "", "", 0.0, 0.0 };
  std::string LastError, LastWarning;
  vtkSmartPointer<vtkTextureObject> Thresholds;

  void UploadThresholds(vtkOpenGLRenderWindow* window)
  {
    if (this->Thresholds && this->Thresholds->GetContext() == window)
    {
      return;
    }
    static const nephoscope::CoverageThresholds table;
    std::vector<float> values = table.GetValues();
    this->Thresholds = vtkSmartPointer<vtkTextureObject>::New();
    this->Thresholds->SetContext(window);
    this->Thresholds->Create2DFromRaw(static_cast<unsigned int>(table.columns), static_cast<unsigned int>(table.rows), 1,
      VTK_FLOAT, values.data());
    this->Thresholds->SetMinificationFilter(vtkTextureObject::Linear);
    this->Thresholds->SetMagnificationFilter(vtkTextureObject::Linear);
    this->Thresholds->SetWrapS(vtkTextureObject::ClampToEdge);
    this->Thresholds->SetWrapT(vtkTextureObject::ClampToEdge);
  }
};

vtkCloudTextureMapper::vtkCloudTextureMapper()
  : Internals(new vtkInternals)
{
}

vtkCloudTextureMapper::~vtkCloudTextureMapper() = default;

void vtkCloudTextureMapper::SetName(std::string& member, const char* name)
{
  const std::string given = name ? name : "";
  if (given != member)
  {
    member = given;
    this->Modified();
  }
}

void vtkCloudTextureMapper::SetCoverageArrayName(const char* name)
{
  this->SetName(this->CoverageArrayName, name);
}

void vtkCloudTextureMapper::SetDensityArrayName(const char* name)
{
  this->SetName(this->DensityArrayName, name);
}

void vtkCloudTextureMapper::SetFirstCoordinatesName(const char* name)
{
  this->SetName(this->CoordinatesNames[0], name);
}

void vtkCloudTextureMapper::SetSecondCoordinatesName(const char* name)
{
  this->SetName(this->CoordinatesNames[1], name);
}

void vtkCloudTextureMapper::PrepareSurface(vtkPolyData* input)
{
  vtkInternals& own = *this->Internals;
  const vtkInternals::Key key(input, input->GetMTime(), this->CoverageArrayName, this->CoordinatesNames[0],
    this->CoordinatesNames[1], this->TextureScale, this->TextureLength);
  if (key == own.MadeFrom)
  {
    return;
  }
  own.MadeFrom = key;
  own.Surface = nephoscope::prepareTexturedSurface(input,
    { { this->CoordinatesNames[0], this->CoordinatesNames[1] }, this->CoverageArrayName, this->TextureScale, this->TextureLength });
  this->MapArrays();
  if (!own.Surface.Error.empty() && own.Surface.Error != own.LastError)
  {
    vtkErrorMacro(<< own.Surface.Error);
  }
  if (!own.Surface.Warning.empty() && own.Surface.Warning != own.LastWarning)
  {
    vtkWarningMacro(<< own.Surface.Warning);
  }
  own.LastError = own.Surface.Error;
  own.LastWarning = own.Surface.Warning;
}

void vtkCloudTextureMapper::MapArrays()
{
  for (const char* name : { "cloudPlace", "cloudTexture1", "cloudTexture2", "cloudCover", "cloudNormal" })
  {
    this->RemoveVertexAttributeMapping(name);
  }
  for (const Attribute& attribute : attributesOf(this->Internals->Surface))
  {
    this->MapDataArrayToVertexAttribute(
      attribute.Name.c_str(), attribute.Array.c_str(), vtkDataObject::FIELD_ASSOCIATION_POINTS);
  }
}

// The superclass has set CurrentInput to the input, updated; what follows draws the prepared surface in its place.
void vtkCloudTextureMapper::RenderPieceStart(vtkRenderer* renderer, vtkActor* actor)
{
  this->PrepareSurface(this->CurrentInput);
  this->CurrentInput = this->Internals->Surface.Surface;
  if (this->CurrentInput)
  {
    this->Superclass::RenderPieceStart(renderer, actor);
  }
}

void vtkCloudTextureMapper::RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor)
{
  if (!this->CurrentInput)
  {
    return;
  }
  this->Internals->UploadThresholds(vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()));
  this->Internals->Thresholds->Activate();
  this->Superclass::RenderPieceDraw(renderer, actor);
  this->Internals->Thresholds->Deactivate();
}

void vtkCloudTextureMapper::RenderPieceFinish(vtkRenderer* renderer, vtkActor* actor)
{
  if (this->CurrentInput)
  {
    this->Superclass::RenderPieceFinish(renderer, actor);
  }
}

std::string vtkCloudTextureMapper::GetShaderConstants() const
{
  std::ostringstream waves, amplitudes, result;
  waves << std::scientific << std::setprecision(9);
  amplitudes << std::scientific << std::setprecision(9);
  result << std::scientific << std::setprecision(9);
  double amplitude = nephoscope::gardnerAmplitude;
  for (int i = 0; i < nephoscope::numberOfGardnerTerms; ++i, amplitude *= nephoscope::gardnerRatio)
  {
    const auto wave = nephoscope::gardnerWave<double>(i);
    waves << (i ? ", " : "") << "vec3(" << wave[0] << ", " << wave[1] << ", " << wave[2] << ")";
    amplitudes << (i ? ", " : "") << amplitude;
  }
  const nephoscope::TexturedSurface& surface = this->Internals->Surface;
  result << "const vec3 gardnerWaves[7] = vec3[7](" << waves.str() << ");\n"
         << "const float gardnerAmplitudes[7] = float[7](" << amplitudes.str() << ");\n"
         << "const float gardnerFourth = " << nephoscope::gardnerFourth() << ";\n"
         << "const float thresholdColumns = " << double(nephoscope::CoverageThresholds::columns) << ";\n"
         << "const float thresholdRows = " << double(nephoscope::CoverageThresholds::rows) << ";\n"
         << "const bool hasSecondSet = " << (surface.HasSecondSet ? "true" : "false") << ";\n"
         << "const bool hasNormals = " << (surface.Normals.empty() ? "false" : "true") << ";\n";
  return result.str();
}

void vtkCloudTextureMapper::ReplaceShaderColor(
  std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor)
{
  const nephoscope::TexturedSurface& surface = this->Internals->Surface;
  std::string vertexDec, vertexImpl, geometryDec, geometryImpl, fragmentDec;
  for (const Attribute& a : attributesOf(surface))
  {
    vertexDec += "in " + a.Type + " " + a.Name + ";\nout " + a.Type + " " + a.Name + "VSOutput;\n";
    vertexImpl += "  " + a.Name + "VSOutput = " + a.Name + ";\n";
    geometryDec += "in " + a.Type + " " + a.Name + "VSOutput[];\nout " + a.Type + " " + a.Name + "GSOutput;\n";
    geometryImpl += "  " + a.Name + "GSOutput = " + a.Name + "VSOutput[i];\n";
    fragmentDec += "in " + a.Type + " " + a.Name + "VSOutput;\n";
  }
  fragmentDec += "uniform float coverage;\n" + this->GetShaderConstants() + GardnerTextureFunctions + CloudOpacityFunction;
  const std::string opacity = std::string("  float cloudOpacityHere = cloudOpacity(cloudPlaceVSOutput, ") +
    (surface.Normals.empty() ? "vec3(0.0)" : "cloudNormalVSOutput") + ", cloudTexture1VSOutput, " +
    (surface.HasSecondSet ? "cloudTexture2VSOutput" : "vec3(0.0)") + ", " +
    (surface.HasCover ? "cloudCoverVSOutput" : "coverage") + ");\n";
  const std::string dec = "//VTK::Color::Dec", impl = "//VTK::Color::Impl", uniformFlow = "//VTK::UniformFlow::Impl";
  substitute(shaders[vtkShader::Vertex], dec, dec + "\n" + vertexDec);
  substitute(shaders[vtkShader::Vertex], impl, impl + "\n" + vertexImpl);
  substitute(shaders[vtkShader::Geometry], dec, dec + "\n" + geometryDec);
  substitute(shaders[vtkShader::Geometry], impl, impl + "\n" + geometryImpl);
  substitute(shaders[vtkShader::Fragment], dec, dec + "\n" + fragmentDec);
  substitute(shaders[vtkShader::Fragment], uniformFlow, opacity + uniformFlow);
  substitute(shaders[vtkShader::Fragment], impl, impl + "\n  opacity *= cloudOpacityHere;\n");
  this->Superclass::ReplaceShaderColor(shaders, renderer, actor);
}

void vtkCloudTextureMapper::SetEye(vtkShaderProgram* program, vtkRenderer* renderer, vtkActor* actor)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const bool isParallel = camera->GetParallelProjection() != 0;
  double eye[4] = { 0, 0, 0, isParallel ? 0.0 : 1.0 };
  isParallel ? camera->GetDirectionOfProjection(eye) : camera->GetPosition(eye);
  vtkNew<vtkMatrix4x4> toSurface;
  vtkMatrix4x4::Invert(actor->GetMatrix(), toSurface);
  toSurface->MultiplyPoint(eye, eye);
  float place[4] = { 0, 0, 0, static_cast<float>(eye[3]) };
  for (int c = 0; c < 3; ++c)
  {
    place[c] = static_cast<float>(eye[c] - eye[3] * this->Internals->Surface.Center[c]);
  }
  program->SetUniform4f("eyePlace", place);
}

void vtkCloudTextureMapper::SetMapperShaderParameters(vtkOpenGLHelper& helper, vtkRenderer* renderer, vtkActor* actor)
{
  this->Superclass::SetMapperShaderParameters(helper, renderer, actor);
  vtkShaderProgram* program = helper.Program;
  if (!program->IsUniformUsed("coverageThresholds"))
  {
    return;
  }
  const double* given = this->Internals->Surface.Weights;
  const float weights[2] = { static_cast<float>(given[0]), static_cast<float>(given[1]) };
  this->SetReliefHeight(program, actor);
  program->SetUniformi("coverageThresholds", this->Internals->Thresholds->GetTextureUnit());
  program->SetUniform2f("textureWeights", weights);
  program->SetUniformf("coverage", static_cast<float>(this->Coverage));
  program->SetUniformf("softness", static_cast<float>(this->Softness));
  program->SetUniformf("opticalDepth", static_cast<float>(this->OpticalDepth));
  this->SetEye(program, renderer, actor);
}

void vtkCloudTextureMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->Internals->Thresholds)
  {
    this->Internals->Thresholds->ReleaseGraphicsResources(window);
    this->Internals->Thresholds = nullptr;
  }
  this->Superclass::ReleaseGraphicsResources(window);
}

void vtkCloudTextureMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Coverage: " << this->Coverage << "\n"
     << indent << "CoverageArrayName: " << this->CoverageArrayName << "\n"
     << indent << "Softness: " << this->Softness << "\n"
     << indent << "TextureScale: " << this->TextureScale << "\n"
     << indent << "TextureLength: " << this->TextureLength << "\n"
     << indent << "OpticalDepth: " << this->OpticalDepth << "\n"
     << indent << "Relief: " << this->Relief << "\n"
     << indent << "UseThickness: " << this->UseThickness << "\n"
     << indent << "Extinction: " << this->Extinction << "\n"
     << indent << "DensityArrayName: " << this->DensityArrayName << "\n"
     << indent << "MaximumNumberOfLayers: " << this->MaximumNumberOfLayers << "\n"
     << indent << "FirstCoordinatesName: " << this->CoordinatesNames[0] << "\n"
     << indent << "SecondCoordinatesName: " << this->CoordinatesNames[1] << "\n";
}

void vtkCloudTextureMapper::ReplaceShaderNormal(
  std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor)
{
  this->Superclass::ReplaceShaderNormal(shaders, renderer, actor);
  if (this->Relief > 0)
  {
    nephoscope::addReliefCode(shaders[vtkShader::Fragment], this->Internals->Surface.HasSecondSet, "textureWeights");
  }
}

void vtkCloudTextureMapper::SetReliefHeight(vtkShaderProgram* program, vtkActor* actor)
{
  if (!program->IsUniformUsed("reliefHeight"))
  {
    return;
  }
  constexpr double largestWaves = 3; // in one repetition
  const double repetition =
    nephoscope::textureRepetition(this->Internals->Surface.Surface, this->TextureLength, this->TextureScale);
  const double scale = std::cbrt(std::abs(actor->GetMatrix()->Determinant()));
  program->SetUniformf("reliefHeight", static_cast<float>(this->Relief * scale * repetition / largestWaves));
}
