// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTexturedSplatMapper.h"

#include "ArraySelection.h"
#include "OwnThreads.h"
#include "SplatClasses.h"
#include "SplatKernel.h"
#include "SplatOrder.h"
#include "SplatPass.h"
#include "SplatSamples.h"
#include "SplatVectors.h"
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
  using SampleKey = std::tuple<vtkDataSet*, vtkMTimeType, bool, double>;
  using ClassKey = std::tuple<vtkDataArray*, vtkDataArray*, int, vtkMTimeType, vtkMTimeType, bool>;

  using BoundsKey = std::tuple<vtkDataSet*, vtkMTimeType, bool, double, int>;

  SampleKey SampledFrom{ nullptr, 0, false, 0.0 };
  ClassKey ClassifiedBy{ nullptr, nullptr, 0, 0, 0, false };
  BoundsKey BoundsOf{ nullptr, 0, false, 0.0, 0 };
  double Bounds[6] = { 1, -1, 1, -1, 1, -1 };
  nephoscope::SplatSamples Samples;
  nephoscope::SplatClasses Classes;
  nephoscope::SplatVectors Vectors;
  std::tuple<vtkDataArray*, vtkMTimeType, const void*> VectorsFrom{ nullptr, 0, nullptr };
  bool VectorsUploaded = false;
  double LoopedTo = 0;
  int LoopCycles = 0;
  nephoscope::SplatEye Eye{ { 0, 0, 0, -1 } }; // none
  std::vector<std::int32_t> Order;
  nephoscope::SplatPass Pass;
  bool SplatsUploaded = false, OrderUploaded = false;
  vtkOpenGLRenderWindow* Window = nullptr;
  std::string LastError;

  void UpdateBounds(vtkDataSet* input, const nephoscope::SplatSampling& sampling, int kernel)
  {
    const BoundsKey key(input, input->GetMTime(), sampling.OnCells, sampling.CellSize, kernel);
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

  void UpdateOrder(const nephoscope::SplatEye& eye)
  {
    if (eye == this->Eye && this->Order.size() == this->Classes.Samples.size())
    {
      return;
    }
    withThreads([&]() {
      this->Order = nephoscope::OrderSplats(this->Samples.Positions, this->Classes.Samples, eye);
    });
    this->Eye = eye;
    this->OrderUploaded = false;
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
  return static_cast<vtkIdType>(this->Internals->Classes.Samples.size());
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
    const nephoscope::SplatSampling sampling{ cellFlag == 1, this->CellSize };
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
  const vtkInternals::SampleKey samples(input, input->GetMTime(), scalars.OnCells, this->CellSize);
  const vtkInternals::ClassKey classes(scalars.Array, opacity.Array, scalars.Component,
    property->GetMTime(), input->GetMTime(), !this->VectorArrayName.empty());
  withThreads([&]() {
    if (samples != self.SampledFrom)
    {
      self.Samples =
        nephoscope::FindSplatSamples(input, { scalars.OnCells, this->CellSize }, error);
    }
    if (error.empty() && (samples != self.SampledFrom || classes != self.ClassifiedBy))
    {
      self.Classes = nephoscope::ClassifySplats(
        input, self.Samples, scalars, opacity, property, !this->VectorArrayName.empty());
      self.Order.clear();
      self.Eye[3] = -1;
      self.SplatsUploaded = self.VectorsUploaded = false;
    }
  });
  self.SampledFrom = samples;
  self.ClassifiedBy = classes;
  return error.empty() ? this->UpdateVectors(input, scalars.OnCells) : error;
}

std::string vtkTexturedSplatMapper::UpdateVectors(vtkDataSet* input, bool onCells)
{
  vtkInternals& self = *this->Internals;
  if (this->VectorArrayName.empty())
  {
    return std::string();
  }
  vtkFieldData* attributes =
    onCells ? static_cast<vtkFieldData*>(input->GetCellData()) : input->GetPointData();
  vtkDataArray* array = attributes->GetArray(this->VectorArrayName.c_str());
  if (!array || array->GetNumberOfComponents() != 3)
  {
    return std::string(onCells ? "No cell array" : "No point array") +
      " of three components named '" + this->VectorArrayName +
      "' for the vectors, which must be where the coloured array is. Choose one with SetVectorArrayName; arrays there: " +
      nephoscope::arrayNames(attributes) + ".";
  }
  const std::string length = nephoscope::checkLength(input, { array, onCells, 0 });
  if (!length.empty())
  {
    return length;
  }
  const std::tuple<vtkDataArray*, vtkMTimeType, const void*> key(
    array, array->GetMTime(), self.Samples.Positions.data());
  if (key != self.VectorsFrom)
  {
    self.Vectors.Read(array, self.Samples);
    self.VectorsFrom = key;
    self.VectorsUploaded = false;
  }
  return std::string();
}

void vtkTexturedSplatMapper::AdvancePhases(double time)
{
  vtkInternals& self = *this->Internals;
  if (!std::get<0>(self.VectorsFrom))
  {
    vtkErrorMacro("There are no vectors to move with: set VectorArrayName and render first.");
    return;
  }
  self.Vectors.Advance(time, this->StreakPeriod, self.Samples);
  self.VectorsUploaded = false;
  this->Modified();
}

std::string vtkTexturedSplatMapper::DrawScene(
  vtkOpenGLRenderWindow* window, vtkRenderer* renderer, vtkVolume* volume)
{
  vtkInternals& self = *this->Internals;
  const nephoscope::ViewState state(renderer, volume, self.Samples.Center);
  self.UpdateOrder(state.EyeModel);
  const std::string error = this->Upload(window);
  if (!error.empty() || self.Order.empty())
  {
    return error;
  }
  nephoscope::SplatDrawingOptions options;
  options.Kernel = static_cast<nephoscope::SplatKernel>(this->Kernel);
  options.ExtinctionScale = this->OpacityScale;
  // Seen along its longest edge a cell holds the eye up to the kernel's radius; a little farther it still fills the view.
  const double near = 1.3 * nephoscope::KernelRadius(options.Kernel) * self.Samples.LongestEdge;
  options.NearSplats = nephoscope::CountNear(
    self.Samples.Positions, self.Classes.Samples, self.Order, state.EyeModel, near);
  options.Vectors = !this->VectorArrayName.empty();
  options.VectorScale = this->VectorOpacity;
  options.StreakPeriod = this->StreakPeriod;
  const double greatest =
    this->GreatestSpeed > 0 ? this->GreatestSpeed : self.Vectors.GreatestSpeed();
  options.GreatestSpeed = greatest > 0 ? greatest : 1.0;
  options.OneVectorColor = this->UseVectorColor;
  std::copy_n(this->VectorColor, 3, options.VectorColor);
  return self.Pass.Draw(window, state.View, options);
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
    error = self.Pass.UploadSplats(window, self.Samples, self.Classes);
    self.VectorsUploaded = false;
  }
  const bool vectors = !this->VectorArrayName.empty();
  if (self.LoopedTo != this->Phase || self.LoopCycles != this->PhaseCycles)
  {
    self.Vectors.SetLoop(this->Phase, this->PhaseCycles);
    self.LoopedTo = this->Phase;
    self.LoopCycles = this->PhaseCycles;
    self.VectorsUploaded = false;
  }
  if (error.empty() && vectors && !self.VectorsUploaded)
  {
    error = self.Pass.UploadVectors(window, self.Vectors.Pack(self.Classes));
    self.VectorsUploaded = error.empty();
  }
  if (error.empty() && !self.OrderUploaded)
  {
    error = self.Pass.UploadOrder(window, self.Order);
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
    this->Internals->SplatsUploaded = this->Internals->OrderUploaded =
      this->Internals->VectorsUploaded = false;
  }
  this->Superclass::ReleaseGraphicsResources(window);
}

void vtkTexturedSplatMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const char* kernels[] = { "Cubic", "Quadratic", "Gaussian" };
  os << indent << "Kernel: " << kernels[this->Kernel] << "\n";
  os << indent << "CellSize: " << this->CellSize << "\n";
  os << indent << "OpacityScale: " << this->OpacityScale << "\n";
  os << indent << "OpacityArrayName: " << this->OpacityArrayName << "\n";
  os << indent << "VectorArrayName: " << this->VectorArrayName << "\n";
  os << indent << "VectorOpacity: " << this->VectorOpacity << "\n";
  os << indent << "GreatestSpeed: " << this->GreatestSpeed << "\n";
  os << indent << "StreakPeriod: " << this->StreakPeriod << "\n";
  os << indent << "VectorColor: " << this->VectorColor[0] << " " << this->VectorColor[1] << " "
     << this->VectorColor[2] << "\n";
  os << indent << "UseVectorColor: " << this->UseVectorColor << "\n";
  os << indent << "Phase: " << this->Phase << "\n";
  os << indent << "PhaseCycles: " << this->PhaseCycles << "\n";
  os << indent << "NumberOfDrawnSplats: " << this->GetNumberOfDrawnSplats() << "\n";
}
