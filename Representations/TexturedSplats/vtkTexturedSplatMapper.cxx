// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTexturedSplatMapper.h"

#include "ArraySelection.h"
#include "MapperSettings.h"
#include "ReportedError.h"
#include "ResourceWindow.h"
#include "SamplesInTime.h"
#include "SplatCost.h"
#include "SplatKernel.h"
#include "SplatPass.h"
#include "SplatScene.h"
#include "ViewState.h"
#include "VolumeOrder.h"
#include "VolumePeel.h"
#include "VolumeSlices.h"

#include "vtkAbstractMapper.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkTexturedSplatMapper);

struct vtkTexturedSplatMapper::vtkInternals
{
  nephoscope::SplatScene Scene;
  nephoscope::SplatPass Pass;
  nephoscope::ReportedError LastError, LastWarning, LeftOut, Cost, NoVectors, LongVectors;
  nephoscope::SamplesInTime Samples; // while the camera moves
  nephoscope::ResourceWindow Window{ [this](vtkWindow* window) {
    this->Pass.ReleaseGraphicsResources(window);
    this->Scene.ForgetUpload();
  } };
};

namespace
{
// Among ranks all samples are cells: a vertex with a shape may be a point of the user's data.
const char* KindOfSamples(vtkDataSet* input, const nephoscope::SplatSampling& sampling)
{
  const bool shaped = !sampling.ShapeArrayName.empty() && input->GetNumberOfCells() > 0 &&
    input->GetCellType(0) == VTK_VERTEX &&
    input->GetCellData()->HasArray(sampling.ShapeArrayName.c_str());
  return !sampling.OnCells ? "point" : shaped ? "sample" : "cell";
}
}

vtkTexturedSplatMapper::vtkTexturedSplatMapper()
  : Internals(new vtkInternals)
{
  nephoscope::VolumeOrder::Enrol(this,
    { [this](vtkRenderer* renderer, vtkVolume* volume) { this->DrawInOrder(renderer, volume); },
      [](vtkRenderer*, vtkVolume*) { return std::size_t(1); }, []() { return true; },
      [this](vtkRenderer* renderer, vtkVolume* volume, nephoscope::DepthTiles& tiles) {
        return this->AddTo(renderer, volume, tiles);
      } });
}

vtkTexturedSplatMapper::~vtkTexturedSplatMapper()
{
  nephoscope::VolumeOrder::Leave(this);
}

void vtkTexturedSplatMapper::SetInputData(vtkDataSet* data)
{
  this->SetInputDataInternal(0, data);
}

int vtkTexturedSplatMapper::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(
    vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject"); // drawing tells what is no dataset
  return 1;
}

vtkIdType vtkTexturedSplatMapper::GetNumberOfDrawnSplats()
{
  return static_cast<vtkIdType>(this->Internals->Scene.GetNumberOfDrawn());
}

vtkIdType vtkTexturedSplatMapper::GetNumberOfSamples()
{
  return static_cast<vtkIdType>(this->Internals->Scene.GetNumberOfSamples());
}

double vtkTexturedSplatMapper::GetDrawnErrorTolerance()
{
  return this->Internals->Scene.GetDrawnTolerance();
}

double* vtkTexturedSplatMapper::GetBounds()
{
  this->Superclass::GetBounds();
  vtkDataSet* input = this->GetDataSetInput();
  if (input && input->GetNumberOfPoints() > 0)
  {
    int cellFlag = 0;
    vtkAbstractMapper::GetScalars(
      input, this->ScalarMode, this->ArrayAccessMode, this->ArrayId, this->ArrayName, cellFlag);
    nephoscope::SplatSampling sampling = this->GetSampling(cellFlag == 1);
    // A rank may draw nothing in its region but splats of others.
    sampling.Frame.WithNeighbors = sampling.Frame.Origin.has_value();
    const double growth = this->VectorUnit > 0
      ? 1.0
      : std::cbrt(1.0 / std::max(this->VectorFraction, 1e-6)); // see GetStreakUnit
    const nephoscope::VectorLook look{ this->VectorStyle == SEGMENTS, this->VectorUnit,
      growth * this->StreakPeriod, growth * this->SegmentLength };
    std::copy_n(this->Internals->Scene.UpdateBounds(
                  input, sampling, this->Kernel, this->VectorArrayName, look),
      6, this->Bounds);
  }
  return this->Bounds;
}

nephoscope::SplatVectorScene& vtkTexturedSplatMapper::GetVectorScene()
{
  return this->Internals->Scene.GetVectorScene();
}

void vtkTexturedSplatMapper::Render(vtkRenderer* renderer, vtkVolume* volume)
{
  nephoscope::VolumeOrder::Draw(this, renderer, volume);
}

void vtkTexturedSplatMapper::DrawInOrder(vtkRenderer* renderer, vtkVolume* volume)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!window || renderer->GetSelector() || !this->GetInputAlgorithm())
  {
    return;
  }
  this->GetInputAlgorithm()->Update();
  vtkDataSet* input = this->GetDataSetInput();
  if (!input || input->GetNumberOfPoints() == 0)
  {
    const std::string error = nephoscope::CheckIsDataSet(this->GetInputDataObject(0, 0));
    this->ReportOnce(error.empty() ? "The input has no points: there is nothing to draw." : error);
    return;
  }
  this->WithNeighbors = this->DrawsRegion(renderer);
  this->FindFilmCompanions(renderer);
  std::string error = this->UpdateSplats(input, volume);
  if (error.empty())
  {
    error = this->DrawInTime(window, renderer, volume);
  }
  this->ReportOnce(error);
}

// False if nothing can be drawn, which DrawInOrder reports.
bool vtkTexturedSplatMapper::AddTo(
  vtkRenderer* renderer, vtkVolume* volume, nephoscope::DepthTiles& tiles)
{
  if (this->GetInputAlgorithm())
  {
    this->GetInputAlgorithm()->Update();
  }
  vtkDataSet* input = this->GetDataSetInput();
  this->WithNeighbors = input && this->DrawsRegion(renderer);
  if (!input || input->GetNumberOfPoints() == 0 || !this->UpdateSplats(input, volume).empty())
  {
    return false;
  }
  nephoscope::SplatScene& scene = this->Internals->Scene;
  const nephoscope::ViewState state(renderer, volume, scene.GetSamples().Center);
  this->SelectSplats(renderer, volume, state);
  nephoscope::SplatDrawingOptions options;
  options.Kernel = static_cast<nephoscope::SplatKernel>(this->Kernel);
  this->SetVectorOptions(options);
  nephoscope::AddSplats(scene.GetSorted(), state.View, options, tiles);
  return true;
}

void vtkTexturedSplatMapper::ReportOnce(const std::string& error)
{
  if (this->Internals->LastError.IsNew(error))
  {
    vtkErrorMacro(<< error);
  }
}

std::string vtkTexturedSplatMapper::UpdateSplats(vtkDataSet* input, vtkVolume* volume)
{
  nephoscope::SplatFields fields{ {}, {}, volume->GetProperty(),
    this->InterpolateScalarsBeforeMapping };
  constexpr double longest = 1e12; // whose volume is a number in single precision
  std::string error = nephoscope::CheckLengths(input, longest);
  if (error.empty())
  {
    error = nephoscope::CheckUnitDistance(fields.Property);
  }
  if (error.empty())
  {
    error = nephoscope::ClippingPlanes::Check(this);
  }
  if (error.empty())
  {
    error = nephoscope::SelectScalars(this, input, fields.Property, fields.Scalars);
  }
  if (error.empty())
  {
    error =
      nephoscope::SelectOpacity(this->OpacityArrayName, input, fields.Scalars, fields.Opacity);
  }
  if (error.empty() && fields.Opacity.Array && fields.Opacity.OnCells != fields.Scalars.OnCells)
  {
    error = "Colour and opacity are read at the same samples: array '" + this->OpacityArrayName +
      "' must be on " + (fields.Scalars.OnCells ? "cells, as the" : "points, as the") +
      " coloured array is.";
  }
  if (!error.empty())
  {
    return error;
  }
  const std::string cost = this->ErrorTolerance > 0
    ? std::string()
    : nephoscope::TellSplatCost(static_cast<long long>(fields.Scalars.Array->GetNumberOfTuples()));
  if (this->Internals->Cost.IsNew(cost))
  {
    vtkWarningMacro(<< cost);
  }
  const nephoscope::SplatSampling sampling = this->GetSampling(fields.Scalars.OnCells);
  this->ChooseVectors(input, fields.Scalars.OnCells);
  error = this->Internals->Scene.Update(input, sampling, fields, this->GetVectorSettings());
  const std::string leftOut = error.empty()
    ? this->Internals->Scene.DescribeLeftOut(
        fields, KindOfSamples(input, sampling), sampling.SizeArrayName, this->DrawnVectors)
    : std::string();
  if (this->Internals->LeftOut.IsNew(leftOut))
  {
    vtkWarningMacro(<< leftOut);
  }
  const bool automatic = error.empty() && !this->DrawnVectors.empty() && this->MaximumSpeed == 0;
  const std::string longVectors = automatic
    ? this->GetVectorScene().GetVectors().GetSpeeds().DescribeLong(this->DrawnVectors)
    : std::string();
  if (this->Internals->LongVectors.IsNew(longVectors))
  {
    vtkWarningMacro(<< longVectors);
  }
  return error;
}

// Scalars are drawn without vectors that are wrong.
void vtkTexturedSplatMapper::ChooseVectors(vtkDataSet* input, bool onCells)
{
  this->DrawnVectors = this->VectorArrayName;
  const std::string problem = this->DrawnVectors.empty()
    ? std::string()
    : nephoscope::CheckVectors(input, onCells, this->GetVectorSettings());
  if (!problem.empty())
  {
    this->DrawnVectors.clear();
  }
  if (this->Internals->NoVectors.IsNew(problem))
  {
    vtkErrorMacro(<< problem << " No vectors are drawn.");
  }
}

// Wider splats overlap more: in the mean the medium stays.
double vtkTexturedSplatMapper::GetExtinctionFactor()
{
  return this->OpacityScale / (this->RadiusFactor * this->RadiusFactor * this->RadiusFactor);
}

// Whether nodes of the hierarchy are drawn; `most`: how many at the most, 0: any number.
bool vtkTexturedSplatMapper::UsesHierarchy(
  vtkRenderer* renderer, vtkIdType samples, vtkIdType& most) const
{
  const bool moving =
    renderer->GetRenderWindow()->GetDesiredUpdateRate() >= this->InteractiveUpdateRate;
  most = moving ? this->InteractiveMaximumNumberOfSplats : 0;
  const bool tooMany = most > 0 && samples > most;
  const bool layers = !this->DrawnVectors.empty() && this->VectorPlacement == PLACEMENT_LAYERS;
  const bool axisIgnored =
    layers && this->LayerAxis >= 0 && this->Internals->Scene.GetSamples().Dimensions[0] == 0;
  std::string warning = layers && this->ErrorTolerance > 0
    ? "ErrorTolerance is ignored: layers are made of all samples. Call SetVectorPlacementToMiddle() to "
      "draw blocks of samples as one splat each, with their vectors."
    : "";
  warning += axisIgnored ? std::string(warning.empty() ? "" : " ") +
      "LayerAxis (in ParaView, Layer Axis) is ignored: these samples are not on a structured grid. "
      "Layers at right angles to the line of sight are drawn instead; set it to -1 (Towards the Eye) to ask for these."
                         : "";
  if (this->Internals->LastWarning.IsNew(warning))
  {
    vtkWarningMacro(<< warning);
  }
  return !layers && (this->ErrorTolerance > 0 || tooMany);
}

void vtkTexturedSplatMapper::SelectSplats(
  vtkRenderer* renderer, vtkVolume* volume, const nephoscope::ViewState& state)
{
  vtkIdType most = 0;
  if (this->WithNeighbors || !this->UsesHierarchy(renderer, this->GetNumberOfSamples(), most))
  {
    this->Internals->Scene.DrawSamples();
    return;
  }
  nephoscope::SplatErrorRule errors;
  errors.As = static_cast<nephoscope::SplatErrorRule::Measure>(this->ErrorMeasure);
  errors.OfImage = this->ErrorToleranceUnit == UNIT_OF_IMAGE;
  errors.Extinction = errors.OfImage
    ? this->GetExtinctionFactor()
    : this->OpacityScale * volume->GetProperty()->GetScalarOpacityUnitDistance();
  errors.KernelRadius =
    nephoscope::KernelRadius(static_cast<nephoscope::SplatKernel>(this->Kernel));
  if (!this->DrawnVectors.empty())
  {
    nephoscope::SplatDrawingOptions options;
    this->SetVectorOptions(options);
    errors.Vector = (errors.OfImage ? options.VectorScale : 1.0) / options.MaximumSpeed;
  }
  nephoscope::SplatCutRule rule;
  rule.Tolerance = this->ErrorTolerance;
  rule.Blend = this->LevelBlending;
  rule.MostSplats = static_cast<std::size_t>(most);
  this->Internals->Scene.DrawNodes(errors, rule,
    nephoscope::FindCutView(state, volume->GetMatrix(), renderer->GetSize()[1]),
    this->DrawnVectors);
}

double vtkTexturedSplatMapper::GetLastImageSampleDistance()
{
  return this->Internals->Samples.GetDistance();
}

std::string vtkTexturedSplatMapper::DrawInTime(
  vtkOpenGLRenderWindow* window, vtkRenderer* renderer, vtkVolume* volume)
{
  std::string error;
  nephoscope::SampleSettings settings = { this->AutoAdjustSampleDistances,
    this->ImageSampleDistance, this->MaximumImageSampleDistance };
  if (nephoscope::VolumePeel::IsRequested(volume))
  {
    settings = { false, 1, 1 };
  }
  this->TimeToDraw = this->Internals->Samples.Draw(window, settings,
    [&](double distance) { error = this->DrawScene(window, renderer, volume, distance); });
  return error;
}

std::string vtkTexturedSplatMapper::DrawScene(
  vtkOpenGLRenderWindow* window, vtkRenderer* renderer, vtkVolume* volume, double sampleDistance)
{
  nephoscope::SplatScene& scene = this->Internals->Scene;
  const nephoscope::ViewState state(renderer, volume, scene.GetSamples().Center);
  this->SelectSplats(renderer, volume, state);
  scene.UpdateOrder(state);
  nephoscope::SplatDrawingOptions options;
  options.Haze = nephoscope::HazeView(renderer);
  options.Planes = nephoscope::ClippingPlanes(this, renderer);
  options.Planes.AddPlanesOfCamera(renderer, volume->GetBounds());
  options.Kernel = static_cast<nephoscope::SplatKernel>(this->Kernel);
  options.ExtinctionScale = this->GetExtinctionFactor();
  this->SetVectorOptions(options);
  options.ImageSampleDistance = sampleDistance;
  options.SegmentWidth /= sampleDistance;
  // A point has one colour. Light towards the sun changes within a few degrees.
  options.LeastPointDistance = scene.FollowsCamera() ? 20.0 : 0.0;
  const int* size = renderer->GetSize();
  const int pixels[2] = { static_cast<int>(std::ceil(size[0] / sampleDistance)),
    static_cast<int>(std::ceil(size[1] / sampleDistance)) };
  nephoscope::FindSplatRanges(scene.GetSorted(), scene.GetSamples(), state.View, pixels, options);
  scene.UpdateLayers(options.MediaApart, this->OrderByLayers, this->GetDataSetInput(),
    this->LayerAxis, options.NearSplats);
  if (const auto* slices = nephoscope::VolumeSlices::GetCurrent(); slices && !scene.IsInLayers())
  {
    nephoscope::FindSplatsBetween(scene.GetSorted(), state.View, slices->GetDistances(), options);
  }
  this->SetRegionOptions(options);
  options.LayerThickness = options.MediaApart ? scene.GetLayerThickness() : 0.0;
  this->Internals->Window.Enter(window);
  const std::string error = scene.Upload(window, this->Internals->Pass, this->GetVectorSettings());
  if (!error.empty() || scene.GetNumberOfDrawn() == 0)
  {
    return error;
  }
  return nephoscope::VolumePeel::IsRequested(volume)
    ? this->Internals->Pass.DrawPeel(window, state.View, options, { this, volume })
    : this->Internals->Pass.Draw(window, state.View, options);
}

bool vtkTexturedSplatMapper::CopyFloatImage(vtkImageData* image)
{
  vtkOpenGLRenderWindow* window = this->Internals->Window.Get();
  if (!window || !this->Internals->Pass.CopyFloatImage(window, image))
  {
    vtkErrorMacro("There is no float image: render first, without peeling volumes.");
    return false;
  }
  return true;
}

void vtkTexturedSplatMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internals->Window.Leave(window);
  nephoscope::VolumeOrder::ReleaseGraphicsResources(this, window);
  this->Superclass::ReleaseGraphicsResources(window);
}

void vtkTexturedSplatMapper::ShallowCopy(vtkAbstractMapper* other)
{
  auto* mapper = vtkTexturedSplatMapper::SafeDownCast(other);
  if (mapper == this)
  {
    return;
  }
  this->Superclass::ShallowCopy(other);
  if (!mapper)
  {
    return;
  }
  nephoscope::CopyVolumeSettings(mapper, this);
  this->CopySettings(mapper);
  nephoscope::SplatVectorScene& scene = this->Internals->Scene.GetVectorScene();
  scene.GetVectors().GoOnFrom(mapper->Internals->Scene.GetVectorScene().GetVectors());
  scene.ForgetSamples();
  this->Modified();
}
