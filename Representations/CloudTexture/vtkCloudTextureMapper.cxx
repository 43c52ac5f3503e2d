// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGLFunctions.h"

#include "vtkCloudTextureMapper.h"

#include "CloudRelief.h"
#include "CloudShaderCode.h"
#include "vtkCloudTextureMapperInternals.h"

#include "vtkActor.h"
#include "vtkAlgorithm.h"
#include "vtkCamera.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShader.h"
#include "vtkShaderProgram.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkCloudTextureMapper);

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
  const std::string density =
    this->UseThickness && !this->DensityVolume ? this->DensityArrayName : std::string();
  const vtkInternals::Key key(input, input->GetMTime(), this->CoverageArrayName,
    this->CoordinatesNames[0], this->CoordinatesNames[1], this->TextureScale, this->TextureLength,
    density, this->UseThickness, this->UseAltitude, this->AltitudeRange[0], this->AltitudeRange[1]);
  if (key == own.MadeFrom)
  {
    return;
  }
  own.MadeFrom = key;
  own.Surface = nephoscope::PrepareTexturedSurface(input,
    { { this->CoordinatesNames[0], this->CoordinatesNames[1] }, this->CoverageArrayName, density,
      this->TextureScale, this->TextureLength, this->UseThickness, this->UseAltitude,
      { this->AltitudeRange[0], this->AltitudeRange[1] } });
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
  for (const std::string& name : nephoscope::AllCloudAttributeNames())
  {
    this->RemoveVertexAttributeMapping(name.c_str());
  }
  for (const nephoscope::CloudAttribute& attribute :
    nephoscope::CloudAttributesOf(this->Internals->Surface))
  {
    this->MapDataArrayToVertexAttribute(
      attribute.Name.c_str(), attribute.Array.c_str(), vtkDataObject::FIELD_ASSOCIATION_POINTS);
  }
}

int vtkCloudTextureMapper::FillInputPortInformation(int port, vtkInformation* info)
{
  const int result = this->Superclass::FillInputPortInformation(port, info);
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return result;
}

void vtkCloudTextureMapper::ComputeBounds()
{
  auto* composite = vtkCompositeDataSet::SafeDownCast(this->GetInputDataObject(0, 0));
  if (!composite)
  {
    this->Superclass::ComputeBounds();
    return;
  }
  this->Internals->Blocks.Join(composite, nephoscope::ColoredArrayOf(this))
    ->GetBounds(this->Bounds);
}

void vtkCloudTextureMapper::ShallowCopy(vtkAbstractMapper* other)
{
  this->Superclass::ShallowCopy(other);
  if (auto* mapper = vtkCloudTextureMapper::SafeDownCast(other))
  {
    this->SetCoverage(mapper->Coverage);
    this->SetCoverageArrayName(mapper->GetCoverageArrayName());
    this->SetUseThreshold(mapper->UseThreshold);
    this->SetThreshold(mapper->Threshold);
    this->SetUseAltitude(mapper->UseAltitude);
    this->SetAltitudeRange(mapper->AltitudeRange);
    this->SetThinColor(mapper->ThinColor);
    this->SetThickColor(mapper->ThickColor);
    this->SetColorRange(mapper->ColorRange);
    this->SetThicknessEffect(mapper->ThicknessEffect);
    this->SetThicknessWeight(mapper->ThicknessWeight);
    this->CopyWaves(mapper);
    this->SetSoftness(mapper->Softness);
    this->SetTextureScale(mapper->TextureScale);
    this->SetTextureLength(mapper->TextureLength);
    this->SetOpticalDepth(mapper->OpticalDepth);
    this->SetUseThickness(mapper->UseThickness);
    this->SetExtinction(mapper->Extinction);
    this->SetDensityArrayName(mapper->GetDensityArrayName());
    this->SetDensityVolume(mapper->DensityVolume);
    this->SetMaximumNumberOfLayers(mapper->MaximumNumberOfLayers);
    this->SetRelief(mapper->Relief);
    this->SetRegion(mapper->Region);
    this->SetFirstCoordinatesName(mapper->GetFirstCoordinatesName());
    this->SetSecondCoordinatesName(mapper->GetSecondCoordinatesName());
  }
}

// The superclass draws polygonal data only: another mapper of this kind does, with the blocks as
// one.
void vtkCloudTextureMapper::RenderPiece(vtkRenderer* renderer, vtkActor* actor)
{
  vtkInternals& own = *this->Internals;
  this->LeaveOtherWindow(vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()));
  if (!vtkCompositeDataSet::SafeDownCast(this->GetInputDataObject(0, 0)))
  {
    this->Superclass::RenderPiece(renderer, actor);
    return;
  }
  if (!this->Static)
  {
    this->GetInputAlgorithm()->Update();
  }
  vtkCompositeDataSet* blocks = vtkCompositeDataSet::SafeDownCast(this->GetInputDataObject(0, 0));
  if (!blocks) // updated, it is no longer one
  {
    this->Superclass::RenderPiece(renderer, actor);
    return;
  }
  vtkPolyData* joined = own.Blocks.Join(blocks, nephoscope::ColoredArrayOf(this));
  if (!own.ForBlocks)
  {
    own.ForBlocks = vtkSmartPointer<vtkCloudTextureMapper>::New();
  }
  if (own.ForBlocksTime < this->GetMTime())
  {
    own.ForBlocks->ShallowCopy(this);
    own.ForBlocks->SetInputData(joined);
    own.ForBlocksTime = this->GetMTime();
  }
  if (own.ForBlocks->GetInput() != joined)
  {
    own.ForBlocks->SetInputData(joined);
  }
  if (joined->GetNumberOfPoints() > 0)
  {
    own.ForBlocks->RenderPiece(renderer, actor);
  }
}

// The superclass has set CurrentInput to the input, updated; what follows draws the prepared
// surface in its place.
void vtkCloudTextureMapper::RenderPieceStart(vtkRenderer* renderer, vtkActor* actor)
{
  this->PrepareSurface(this->CurrentInput);
  this->PrepareVolume();
  this->WarnOfPlace();
  this->ChooseWaves();
  this->CurrentInput = this->Internals->Surface.Surface;
  actor->GetProperty()->GetDiffuseColor(this->Internals->SolidColor);
  if (this->CurrentInput)
  {
    this->Superclass::RenderPieceStart(renderer, actor);
  }
}

// Blocks without the array have the colour of the actor, as other surfaces do.
vtkUnsignedCharArray* vtkCloudTextureMapper::MapScalars(
  vtkDataSet* input, double alpha, int& cellFlag)
{
  vtkUnsignedCharArray* colors = this->Superclass::MapScalars(input, alpha, cellFlag);
  vtkDataArray* without = input && colors
    ? input->GetAttributes(cellFlag ? vtkDataObject::CELL : vtkDataObject::POINT)
        ->GetArray(nephoscope::withoutColorName)
    : nullptr;
  double color[4] = { 0, 0, 0, 255 * alpha };
  std::transform(this->Internals->SolidColor, this->Internals->SolidColor + 3, color,
    [](double c) { return std::round(255 * c); });
  for (vtkIdType i = 0; without && i < colors->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; without->GetComponent(i, 0) > 0 && c < colors->GetNumberOfComponents(); ++c)
    {
      colors->SetComponent(i, c, color[c]);
    }
  }
  return colors;
}

int vtkCloudTextureMapper::CanUseTextureMapForColoring(vtkDataObject* input)
{
  auto* surface = vtkDataSet::SafeDownCast(input);
  return surface && surface->GetPointData()->HasArray(nephoscope::withoutColorName)
    ? 0
    : this->Superclass::CanUseTextureMapForColoring(input);
}

void vtkCloudTextureMapper::RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor)
{
  if (!this->CurrentInput)
  {
    return;
  }
  vtkInternals& own = *this->Internals;
  own.Enter(vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()));
  if (this->UseThickness)
  {
    this->UploadVolume(renderer);
    this->FindThickness(renderer, actor);
  }
  own.Thresholds->Activate();
  own.Thickness.Activate();
  const std::shared_ptr<nephoscope::DensityVolume> volume = own.Volume;
  volume ? volume->Activate() : void();
  vtkOpenGLState* state =
    static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow())->GetState();
  const vtkOpenGLState::ScopedglEnableDisable culling(state, GL_CULL_FACE);
  if (this->UseThickness && own.Thickness.OnlyFrontFaces())
  {
    state->vtkglEnable(GL_CULL_FACE);
    state->vtkglCullFace(own.Thickness.FrontFacesAreFront() ? GL_BACK : GL_FRONT);
  }
  own.Peels.BeforeDrawing(static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow()), actor);
  this->Superclass::RenderPieceDraw(renderer, actor);
  volume ? volume->Deactivate() : void();
  own.Thickness.Deactivate();
  own.Thresholds->Deactivate();
}

void vtkCloudTextureMapper::RenderPieceFinish(vtkRenderer* renderer, vtkActor* actor)
{
  if (this->CurrentInput)
  {
    this->Superclass::RenderPieceFinish(renderer, actor);
  }
}

void vtkCloudTextureMapper::ReplaceShaderColor(
  std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor)
{
  const bool isAdded = this->UseThickness && this->ThicknessEffect == THICKNESS_IS_ADDED_TO_TEXTURE;
  nephoscope::AddCloudCode(shaders, this->Internals->Surface,
    { this->UseThickness, this->Internals->Drawings, isAdded, this->HasColors(),
      this->Internals->Volume ? this->Internals->Volume->GetShaderCode() : std::string(),
      this->Internals->InUse, this->HasRegion() });
  this->Superclass::ReplaceShaderColor(shaders, renderer, actor);
}

void vtkCloudTextureMapper::SetEye(
  vtkShaderProgram* program, vtkRenderer* renderer, vtkActor* actor)
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
  if (this->UseThickness) // in the view
  {
    place[0] = place[1] = 0;
    place[2] = isParallel ? 1.0f : 0.0f;
  }
  program->SetUniform4f("eyePlace", place);
}

void vtkCloudTextureMapper::SetMapperShaderParameters(
  vtkOpenGLHelper& helper, vtkRenderer* renderer, vtkActor* actor)
{
  this->Superclass::SetMapperShaderParameters(helper, renderer, actor);
  vtkShaderProgram* program = helper.Program;
  const double* given = this->Internals->Surface.Weights;
  const float weights[2] = { static_cast<float>(given[0]), static_cast<float>(given[1]) };
  this->SetReliefHeight(program, actor);
  program->SetUniformi("coverageThresholds", this->Internals->Thresholds->GetTextureUnit());
  program->SetUniform2f("textureWeights", weights);
  this->SetTextureUniforms(program);
  this->SetRegionUniforms(program, actor);
  program->SetUniformf("opticalDepth", static_cast<float>(this->OpticalDepth));
  this->SetEye(program, renderer, actor);
  if (this->UseThickness)
  {
    this->Internals->Thickness.SetUniforms(program, this->GetExtinctionInUse(actor),
      this->GetEnoughOpticalDepth(), this->Internals->Drawings);
    if (this->Internals->Volume)
    {
      this->Internals->Volume->SetUniforms(program, this->Internals->Thickness.GetViewToData());
    }
  }
}

// Before the superclass makes objects in this window: it would release those in the other one then,
// and some windows (EGL's) leave the context current in which they released something.
void vtkCloudTextureMapper::LeaveOtherWindow(vtkWindow* window)
{
  vtkOpenGLRenderWindow* other = this->Internals->Window.Get();
  if (other && other != window)
  {
    this->ReleaseGraphicsResources(other);
    window->MakeCurrent();
  }
}

void vtkCloudTextureMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->Internals->ForBlocks)
  {
    this->Internals->ForBlocks->ReleaseGraphicsResources(window);
  }
  vtkOpenGLRenderWindow* own = this->Internals->Window.Get();
  // The superclass would release its own all the same, and leave that window current.
  if (own && own != window)
  {
    return;
  }
  this->Internals->Window.Leave(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

void vtkCloudTextureMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Coverage: " << this->Coverage << "\n"
     << indent << "CoverageArrayName: " << this->CoverageArrayName << "\n"
     << indent << "UseThreshold: " << this->UseThreshold << "\n"
     << indent << "Threshold: " << this->Threshold << "\n"
     << indent << "UseAltitude: " << this->UseAltitude << "\n"
     << indent << "AltitudeRange: " << this->AltitudeRange[0] << " " << this->AltitudeRange[1]
     << "\n"
     << indent << "ThinColor: " << this->ThinColor[0] << " " << this->ThinColor[1] << " "
     << this->ThinColor[2] << "\n"
     << indent << "ThickColor: " << this->ThickColor[0] << " " << this->ThickColor[1] << " "
     << this->ThickColor[2] << "\n"
     << indent << "ColorRange: " << this->ColorRange << "\n"
     << indent << "Waves: " << this->Waves << "\n"
     << indent << "NumberOfCustomWaves: " << this->GetNumberOfCustomWaves() << "\n"
     << indent << "ThicknessEffect: " << this->ThicknessEffect << "\n"
     << indent << "ThicknessWeight: " << this->ThicknessWeight << "\n"
     << indent << "Softness: " << this->Softness << "\n"
     << indent << "TextureScale: " << this->TextureScale << "\n"
     << indent << "TextureLength: " << this->TextureLength << "\n"
     << indent << "OpticalDepth: " << this->OpticalDepth << "\n"
     << indent << "Relief: " << this->Relief << "\n"
     << indent << "Region: " << this->Region[0] << " " << this->Region[1] << " " << this->Region[2]
     << " " << this->Region[3] << " " << this->Region[4] << " " << this->Region[5] << "\n"
     << indent << "UseThickness: " << this->UseThickness << "\n"
     << indent << "Extinction: " << this->Extinction << "\n"
     << indent << "DensityArrayName: " << this->DensityArrayName << "\n"
     << indent << "DensityVolume: " << this->DensityVolume.Get() << "\n"
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
    nephoscope::AddReliefCode(shaders[vtkShader::Fragment], this->Internals->Surface.HasSecondSet,
      this->Internals->Surface.HasWeights ? "cloudWeightsVSOutput" : "textureWeights");
  }
}

bool vtkCloudTextureMapper::HasColors() const
{
  const auto isWhite = [](const double color[3]) {
    return color[0] == 1 && color[1] == 1 && color[2] == 1;
  };
  return !isWhite(this->ThinColor) || !isWhite(this->ThickColor);
}

bool vtkCloudTextureMapper::HasRegion() const
{
  return this->Region[0] <= this->Region[1];
}

// Relative to the centre of the surface in the world: places on a globe are exact in float then.
void vtkCloudTextureMapper::SetRegionUniforms(vtkShaderProgram* program, vtkActor* actor)
{
  if (!this->HasRegion())
  {
    return;
  }
  constexpr double farAway = 1e37; // finite, as shaders need it
  vtkMatrix4x4* toWorld = actor->GetMatrix();
  const double* c = this->Internals->Surface.Center;
  double center[4] = { c[0], c[1], c[2], 1 };
  toWorld->MultiplyPoint(center, center);
  float turn[9]; // OpenGL counts matrices by columns
  float bounds[6];
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      turn[3 * j + i] = static_cast<float>(toWorld->GetElement(i, j));
    }
    for (int side = 0; side < 2; ++side)
    {
      const double bound = this->Region[2 * i + side] - center[i];
      bounds[3 * side + i] = static_cast<float>(std::min(std::max(bound, -farAway), farAway));
    }
  }
  program->SetUniformMatrix3x3("placeToWorld", turn);
  program->SetUniform3f("regionLow", bounds);
  program->SetUniform3f("regionHigh", bounds + 3);
}

void vtkCloudTextureMapper::SetTextureUniforms(vtkShaderProgram* program)
{
  program->SetUniformf("coverage", static_cast<float>(this->Coverage));
  program->SetUniformi("hasThreshold", this->UseThreshold);
  program->SetUniformf("givenThreshold", static_cast<float>(this->Threshold));
  program->SetUniformf("softness", static_cast<float>(this->Softness));
  program->SetUniformf("thicknessWeight", static_cast<float>(this->ThicknessWeight));
  program->SetUniform3f("thinColor", this->ThinColor);
  program->SetUniform3f("thickColor", this->ThickColor);
  program->SetUniformf("colorRange", static_cast<float>(this->ColorRange));
}

double vtkCloudTextureMapper::GetTextureScaleUsed() const
{
  const bool hasBlocks =
    vtkCompositeDataSet::SafeDownCast(
      const_cast<vtkCloudTextureMapper*>(this)->GetInputDataObject(0, 0)) != nullptr;
  return hasBlocks && this->Internals->ForBlocks ? this->Internals->ForBlocks->GetTextureScaleUsed()
                                                 : this->Internals->Surface.Scale;
}

void vtkCloudTextureMapper::SetReliefHeight(vtkShaderProgram* program, vtkActor* actor)
{
  if (!program->IsUniformUsed("reliefHeight"))
  {
    return;
  }
  const vtkInternals& own = *this->Internals;
  const double length = nephoscope::LargestWaveLength(
    own.Surface.Surface, this->TextureLength, own.Surface.Scale, own.InUse);
  const double scale = std::cbrt(std::abs(actor->GetMatrix()->Determinant()));
  program->SetUniformf("reliefHeight", static_cast<float>(this->Relief * scale * length));
}
