// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTexturedSplatMapper.h"

#include "ArraySelection.h"
#include "OwnThreads.h"
#include "SplatClasses.h"
#include "SplatHierarchy.h"
#include "SplatKernel.h"
#include "SplatLayers.h"
#include "SplatOrder.h"
#include "SplatPass.h"
#include "SplatRanges.h"
#include "SplatSamples.h"
#include "SplatVectorScene.h"
#include "ViewState.h"
#include "VolumePeel.h"

#include "vtkAbstractMapper.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <tuple>

using nephoscope::ScalarSelection;
using nephoscope::withThreads;

vtkStandardNewMacro(vtkTexturedSplatMapper);

/** Each stage is made again only when what it was made from has changed. */
struct vtkTexturedSplatMapper::vtkInternals
{
  using SampleKey = std::tuple<vtkDataSet*, vtkMTimeType, bool, double, std::string, double>;
  using ClassKey = std::tuple<vtkDataArray*, vtkDataArray*, int, vtkMTimeType, vtkMTimeType, bool>;

  using BoundsKey = std::tuple<SampleKey, int>;

  SampleKey SampledFrom{ nullptr, 0, false, 0.0, {}, 0.0 };
  ClassKey ClassifiedBy{ nullptr, nullptr, 0, 0, 0, false };
  BoundsKey BoundsOf{ SampleKey{ nullptr, 0, false, 0.0, {}, 0.0 }, 0 };
  double Bounds[6] = { 1, -1, 1, -1, 1, -1 };
  nephoscope::SplatSamples Samples;
  nephoscope::SplatClasses Classes;
  nephoscope::SplatVectorScene VectorScene;
  nephoscope::SplatEye Eye{ { 0, 0, 0, -1 } }; // none
  nephoscope::SplatMetric Metric = nephoscope::UnitMetric;
  std::vector<std::int32_t> Order;
  using LayerKey = std::tuple<bool, int, std::size_t>;
  LayerKey LayeredBy{ false, 0, 0 };
  std::vector<std::int32_t> Items; // of the order, where vectors are in layers
  nephoscope::SplatHierarchy Hierarchy;
  std::string VectorsOfHierarchy;
  bool DrawsHierarchy = false; // in the last render
  nephoscope::SplatPass Pass;
  bool SplatsUploaded = false, OrderUploaded = false;
  vtkOpenGLRenderWindow* Window = nullptr;
  std::string LastError;

  static SampleKey KeyOf(vtkDataSet* input, const nephoscope::SplatSampling& sampling)
  {
    return SampleKey(input, input->GetMTime(), sampling.OnCells, sampling.CellSize,
      sampling.ShapeArrayName, sampling.RadiusFactor);
  }

  void UpdateBounds(vtkDataSet* input, const nephoscope::SplatSampling& sampling, int kernel)
  {
    const BoundsKey key(KeyOf(input, sampling), kernel);
    if (key == this->BoundsOf)
    {
      return;
    }
    this->BoundsOf = key;
    withThreads([&]() {
      nephoscope::FindSplatBounds(nephoscope::SplatShapes(input, sampling),
        nephoscope::KernelRadius(static_cast<nephoscope::SplatKernel>(kernel)), this->Bounds);
    });
  }

  // What is drawn: places, and the numbers of those among them.
  const std::vector<std::array<float, 3>>& Places() const
  {
    return this->DrawsHierarchy ? this->Hierarchy.Positions() : this->Samples.Positions;
  }
  const std::vector<std::int32_t>& Drawn() const
  {
    return this->DrawsHierarchy ? this->Hierarchy.Cut() : this->Classes.Samples;
  }

  void ForgetOrder()
  {
    this->Order.clear();
    this->Eye[3] = -1;
  }

  // True if it was made anew.
  bool BuildHierarchy(const std::string& vectorArrayName)
  {
    if (vectorArrayName != this->VectorsOfHierarchy)
    {
      this->Hierarchy.Invalidate();
      this->VectorsOfHierarchy = vectorArrayName;
    }
    if (!this->Hierarchy.Tree().IsEmpty())
    {
      return false;
    }
    std::vector<std::array<float, 4>> vectors;
    if (!vectorArrayName.empty())
    {
      vectors = this->VectorScene.GetVectors().Pack(this->Classes, {});
    }
    this->Hierarchy.Build(this->Samples, this->Classes, vectors);
    return true;
  }

  void SetDrawsHierarchy(bool hierarchy)
  {
    if (hierarchy != this->DrawsHierarchy)
    {
      this->ForgetOrder();
    }
    this->DrawsHierarchy = hierarchy;
  }

  void UpdateOrder(const nephoscope::SplatEye& eye, const nephoscope::SplatMetric& metric)
  {
    if (eye == this->Eye && metric == this->Metric && this->Order.size() == this->Drawn().size())
    {
      return;
    }
    withThreads([&]() {
      this->Order = nephoscope::OrderSplats(this->Places(), this->Drawn(), eye, metric);
    });
    this->Eye = eye;
    this->Metric = metric;
    this->OrderUploaded = false;
    this->LayeredBy = LayerKey();
  }

  // Scalars and vectors apart, layer by layer; or without `layers` both in the order of the splats.
  void UpdateLayers(bool layers, vtkDataSet* input, int axis, std::size_t near)
  {
    const LayerKey key(layers, axis, near);
    if (key == this->LayeredBy)
    {
      return;
    }
    this->Items.clear();
    if (layers)
    {
      const bool onCells = std::get<2>(this->SampledFrom);
      nephoscope::SplatLayers found;
      found.Find(input, onCells, this->Samples, this->Eye, axis);
      this->Items = found.Alternate(this->Classes, this->Order, near);
    }
    this->LayeredBy = key;
    this->OrderUploaded = false;
  }

  // The order by the numbers of splats that the pass knows.
  std::vector<std::int32_t> OrderOfSplats() const
  {
    std::vector<std::int32_t> order = this->Order;
    if (this->DrawsHierarchy)
    {
      for (std::int32_t& item : order)
      {
        item = this->Hierarchy.Cut()[static_cast<std::size_t>(item)];
      }
    }
    return order;
  }
};

vtkTexturedSplatMapper::vtkTexturedSplatMapper()
  : Internals(new vtkInternals)
{
}

vtkTexturedSplatMapper::~vtkTexturedSplatMapper() = default;

void vtkTexturedSplatMapper::SetInputData(vtkDataSet* data)
{
  this->SetInputDataInternal(0, data);
}

int vtkTexturedSplatMapper::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  return 1;
}

vtkIdType vtkTexturedSplatMapper::GetNumberOfDrawnSplats()
{
  return static_cast<vtkIdType>(this->Internals->Drawn().size());
}

vtkIdType vtkTexturedSplatMapper::GetNumberOfSamples()
{
  return static_cast<vtkIdType>(this->Internals->Classes.Samples.size());
}

double vtkTexturedSplatMapper::GetDrawnErrorTolerance()
{
  return this->Internals->DrawsHierarchy ? this->Internals->Hierarchy.DrawnTolerance() : 0.0;
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
    const nephoscope::SplatSampling sampling{ cellFlag == 1, this->CellSize, this->ShapeArrayName,
      this->RadiusFactor };
    this->Internals->UpdateBounds(input, sampling, this->Kernel);
    std::copy_n(this->Internals->Bounds, 6, this->Bounds);
  }
  return this->Bounds;
}

void vtkTexturedSplatMapper::Render(vtkRenderer* renderer, vtkVolume* volume)
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
    this->ReportOnce("The input has no points: there is nothing to draw.");
    return;
  }
  if (nephoscope::VolumePeel::IsRequested(volume))
  {
    this->ReportOnce(
      "Splats cannot be drawn between peeled surfaces: call UseDepthPeelingForVolumesOff() of the renderer.");
    return;
  }
  std::string error = this->UpdateSplats(input, volume);
  if (error.empty())
  {
    error = this->DrawScene(window, renderer, volume);
  }
  this->ReportOnce(error);
}

void vtkTexturedSplatMapper::ReportOnce(const std::string& error)
{
  if (!error.empty() && error != this->Internals->LastError)
  {
    vtkErrorMacro(<< error);
  }
  this->Internals->LastError = error;
}

std::string vtkTexturedSplatMapper::UpdateSplats(vtkDataSet* input, vtkVolume* volume)
{
  vtkInternals& self = *this->Internals;
  vtkVolumeProperty* property = volume->GetProperty();
  if (!(property->GetScalarOpacityUnitDistance() > 0))
  {
    return "ScalarOpacityUnitDistance must be positive: it is the length over which an opacity function of 1 "
           "gives an optical depth of 1.";
  }
  ScalarSelection scalars, opacity;
  std::string error = nephoscope::selectScalars(this, input, property, scalars);
  if (error.empty())
  {
    error = nephoscope::selectOpacity(this->OpacityArrayName, input, scalars, opacity);
  }
  if (error.empty() && opacity.Array && opacity.OnCells != scalars.OnCells)
  {
    error = "Colour and opacity are read at the same samples: array '" + this->OpacityArrayName +
      "' must be on " + (scalars.OnCells ? "cells, as the" : "points, as the") +
      " coloured array is.";
  }
  if (!error.empty())
  {
    return error;
  }
  const nephoscope::SplatSampling sampling{ scalars.OnCells, this->CellSize, this->ShapeArrayName,
    this->RadiusFactor };
  const vtkInternals::SampleKey samples = vtkInternals::KeyOf(input, sampling);
  const vtkInternals::ClassKey classes(scalars.Array, opacity.Array, scalars.Component,
    property->GetMTime(), input->GetMTime(), !this->VectorArrayName.empty());
  withThreads([&]() {
    if (samples != self.SampledFrom)
    {
      self.Samples =
        nephoscope::FindSplatSamples(input, sampling, error);
      self.VectorScene.ForgetSamples();
    }
    if (error.empty() && (samples != self.SampledFrom || classes != self.ClassifiedBy))
    {
      self.Classes = nephoscope::ClassifySplats(
        input, self.Samples, scalars, opacity, property, !this->VectorArrayName.empty());
      self.ForgetOrder();
      self.Hierarchy.Invalidate();
      self.SplatsUploaded = false;
      self.VectorScene.ForgetUpload();
    }
  });
  self.SampledFrom = samples;
  self.ClassifiedBy = classes;
  if (!error.empty() || this->VectorArrayName.empty())
  {
    return error;
  }
  return self.VectorScene.Update(input, scalars.OnCells, self.Samples, this->GetVectorSettings());
}

nephoscope::SplatVectorSettings vtkTexturedSplatMapper::GetVectorSettings()
{
  nephoscope::SplatVectorSettings settings;
  settings.ArrayName = this->VectorArrayName;
  settings.ColorArrayName = this->VectorColorArrayName;
  settings.ColorFunction = this->VectorColorFunction;
  settings.OneColor = this->UseVectorColor;
  std::copy_n(this->VectorColor, 3, settings.Color.begin());
  settings.Loop = { this->Phase, this->PhaseCycles, this->PhaseSteps };
  return settings;
}

void vtkTexturedSplatMapper::SetVectorColorFunction(vtkScalarsToColors* function)
{
  if (this->VectorColorFunction != function)
  {
    this->VectorColorFunction = function;
    this->Modified();
  }
}

vtkScalarsToColors* vtkTexturedSplatMapper::GetVectorColorFunction()
{
  return this->VectorColorFunction;
}

double vtkTexturedSplatMapper::GetStreakUnit()
{
  return this->VectorUnit > 0
    ? this->VectorUnit
    : this->Internals->VectorScene.GetVectors().MeanCell() / this->RadiusFactor;
}

// Wider splats overlap more: in the mean the medium stays.
double vtkTexturedSplatMapper::GetExtinctionFactor()
{
  return this->OpacityScale / (this->RadiusFactor * this->RadiusFactor * this->RadiusFactor);
}

void vtkTexturedSplatMapper::AdvancePhases(double time)
{
  nephoscope::SplatVectorScene& scene = this->Internals->VectorScene;
  if (!scene.HasVectors())
  {
    vtkErrorMacro("There are no vectors to move with: set VectorArrayName and render first.");
    return;
  }
  if (!std::isfinite(time))
  {
    vtkErrorMacro("Phases cannot be advanced by a time of " << time << ": it must be finite.");
    return;
  }
  scene.GetVectors().Advance(time, this->StreakPeriod * this->GetStreakUnit());
  scene.ForgetUpload();
  this->Modified();
}

void vtkTexturedSplatMapper::SetVectorOptions(nephoscope::SplatDrawingOptions& options)
{
  options.Vectors = !this->VectorArrayName.empty();
  options.Segments = this->VectorStyle == SEGMENTS;
  options.MediaApart = options.Vectors && this->VectorPlacement == IN_LAYERS;
  options.VectorScale = this->VectorOpacity;
  const double greatest = this->GreatestSpeed > 0
    ? this->GreatestSpeed
    : this->Internals->VectorScene.GetVectors().GreatestSpeed();
  options.GreatestSpeed = greatest > 0 ? greatest : 1.0;
  options.VectorUnit = this->GetStreakUnit();
  options.StreakPeriod = this->StreakPeriod;
  options.StreakWidth = this->StreakWidth;
  options.SegmentLength = this->SegmentLength;
  options.SegmentWidth = this->SegmentWidth;
}

// Whether nodes of the hierarchy are drawn; finds which.
bool vtkTexturedSplatMapper::SelectSplats(
  vtkRenderer* renderer, vtkVolume* volume, const nephoscope::ViewState& state)
{
  vtkInternals& self = *this->Internals;
  const bool moving =
    renderer->GetRenderWindow()->GetDesiredUpdateRate() >= this->InteractiveUpdateRate;
  const vtkIdType most = moving ? this->InteractiveMaximumNumberOfSplats : 0;
  const bool tooMany = most > 0 && this->GetNumberOfSamples() > most;
  const bool vectors = !this->VectorArrayName.empty();
  if ((vectors && this->VectorPlacement == IN_LAYERS) || !(this->ErrorTolerance > 0 || tooMany))
  {
    return false;
  }
  nephoscope::SplatCutRule rule;
  rule.Tolerance = this->ErrorTolerance;
  rule.OfImage = this->ErrorToleranceUnit == UNIT_OF_IMAGE;
  rule.RootMeanSquare = this->ErrorMeasure == ROOT_MEAN_SQUARE;
  rule.Extinction = rule.OfImage
    ? this->GetExtinctionFactor() * nephoscope::WorldPerModel(state)
    : this->OpacityScale * volume->GetProperty()->GetScalarOpacityUnitDistance();
  rule.KernelRadius = nephoscope::KernelRadius(static_cast<nephoscope::SplatKernel>(this->Kernel));
  rule.MostSplats = static_cast<std::size_t>(most);
  nephoscope::SplatDrawingOptions options;
  this->SetVectorOptions(options);
  rule.Vector = vectors ? (rule.OfImage ? options.VectorScale : 1.0) / options.GreatestSpeed : 0.0;
  withThreads([&]() {
    self.SplatsUploaded &= !self.BuildHierarchy(this->VectorArrayName);
    if (self.Hierarchy.Select(rule, nephoscope::FindCutView(state, renderer->GetSize()[1])))
    {
      self.ForgetOrder();
    }
  });
  return true;
}

std::string vtkTexturedSplatMapper::DrawScene(
  vtkOpenGLRenderWindow* window, vtkRenderer* renderer, vtkVolume* volume)
{
  vtkInternals& self = *this->Internals;
  const nephoscope::ViewState state(renderer, volume, self.Samples.Center);
  self.SetDrawsHierarchy(this->SelectSplats(renderer, volume, state));
  self.UpdateOrder(state.EyeModel, nephoscope::MetricOf(nephoscope::ToViewMatrix(state.View)));
  nephoscope::SplatDrawingOptions options;
  options.Kernel = static_cast<nephoscope::SplatKernel>(this->Kernel);
  options.ExtinctionScale = this->GetExtinctionFactor();
  this->SetVectorOptions(options);
  const double longest =
    self.DrawsHierarchy ? self.Hierarchy.LongestDrawn(self.Samples) : self.Samples.LongestEdge;
  nephoscope::FindSplatRanges({ self.Places(), self.Drawn(), self.Order, longest }, self.Samples,
    state.View, renderer->GetSize(), options);
  self.UpdateLayers(
    options.MediaApart, this->GetDataSetInput(), this->LayerAxis, options.NearSplats);
  const std::string error = this->Upload(window);
  return error.empty() && !self.Order.empty() ? self.Pass.Draw(window, state.View, options) : error;
}

std::string vtkTexturedSplatMapper::Upload(vtkOpenGLRenderWindow* window)
{
  vtkInternals& self = *this->Internals;
  if (self.Window && self.Window != window)
  {
    vtkOpenGLRenderWindow* other = self.Window;
    other->PushContext();
    this->ReleaseGraphicsResources(other);
    other->PopContext();
    window->MakeCurrent();
  }
  self.Window = window;
  std::string error;
  if (!self.SplatsUploaded)
  {
    error = self.Pass.UploadSplats(window, self.Samples, self.Classes, self.Hierarchy.Tree());
    self.VectorScene.ForgetUpload();
  }
  if (error.empty() && !this->VectorArrayName.empty())
  {
    error = self.VectorScene.Upload(
      window, self.Pass, self.Classes, self.Hierarchy.Tree(), this->GetVectorSettings());
  }
  if (error.empty() && !self.OrderUploaded)
  {
    error = self.Pass.UploadOrder(window, self.Items.empty() ? self.OrderOfSplats() : self.Items);
  }
  self.SplatsUploaded = self.OrderUploaded = error.empty();
  return error;
}

bool vtkTexturedSplatMapper::CopyFloatImage(vtkImageData* image)
{
  if (!this->Internals->Window ||
    !this->Internals->Pass.CopyFloatImage(this->Internals->Window, image))
  {
    vtkErrorMacro("There is no float image: render first.");
    return false;
  }
  return true;
}

void vtkTexturedSplatMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  if (window && window == this->Internals->Window) // another window's release is none of ours
  {
    this->Internals->Pass.ReleaseGraphicsResources(window);
    this->Internals->Window = nullptr;
    this->Internals->SplatsUploaded = this->Internals->OrderUploaded = false;
    this->Internals->VectorScene.ForgetUpload();
  }
  this->Superclass::ReleaseGraphicsResources(window);
}

void vtkTexturedSplatMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const char* kernels[] = { "Cubic", "Quadratic", "Gaussian" };
  os << indent << "Kernel: " << kernels[this->Kernel] << "\n";
  os << indent << "CellSize: " << this->CellSize << "\n";
  os << indent << "RadiusFactor: " << this->RadiusFactor << "\n";
  os << indent << "ShapeArrayName: " << this->ShapeArrayName << "\n";
  os << indent << "OpacityScale: " << this->OpacityScale << "\n";
  os << indent << "OpacityArrayName: " << this->OpacityArrayName << "\n";
  os << indent << "VectorArrayName: " << this->VectorArrayName << "\n";
  os << indent << "VectorOpacity: " << this->VectorOpacity << "\n";
  os << indent << "GreatestSpeed: " << this->GreatestSpeed << "\n";
  os << indent << "StreakPeriod: " << this->StreakPeriod << "\n";
  os << indent << "VectorStyle: " << (this->VectorStyle == SEGMENTS ? "Segments" : "Streaks") << "\n";
  os << indent << "VectorPlacement: " << (this->VectorPlacement == IN_LAYERS ? "Layers" : "Middle") << "\n";
  os << indent << "LayerAxis: " << this->LayerAxis << "\n";
  os << indent << "VectorUnit: " << this->VectorUnit << "\n";
  os << indent << "StreakWidth: " << this->StreakWidth << "\n";
  os << indent << "SegmentLength: " << this->SegmentLength << "\n";
  os << indent << "SegmentWidth: " << this->SegmentWidth << "\n";
  os << indent << "VectorColorArrayName: " << this->VectorColorArrayName << "\n";
  os << indent << "VectorColorFunction: " << this->VectorColorFunction.Get() << "\n";
  os << indent << "PhaseSteps: " << this->PhaseSteps << "\n";
  os << indent << "VectorColor: " << this->VectorColor[0] << " " << this->VectorColor[1] << " "
     << this->VectorColor[2] << "\n";
  os << indent << "UseVectorColor: " << this->UseVectorColor << "\n";
  os << indent << "Phase: " << this->Phase << "\n";
  os << indent << "PhaseCycles: " << this->PhaseCycles << "\n";
  os << indent << "ErrorTolerance: " << this->ErrorTolerance
     << (this->ErrorToleranceUnit == UNIT_OF_IMAGE ? " of the image\n" : " of the data\n");
  os << indent << "ErrorMeasure: "
     << (this->ErrorMeasure == GREATEST ? "Greatest" : "Root mean square") << "\n";
  os << indent << "InteractiveMaximumNumberOfSplats: " << this->InteractiveMaximumNumberOfSplats << "\n";
  os << indent << "InteractiveUpdateRate: " << this->InteractiveUpdateRate << "\n";
  os << indent << "NumberOfDrawnSplats: " << this->GetNumberOfDrawnSplats() << "\n";
}
