// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SplatScene.h"

#include "OwnThreads.h"
#include "SplatKernel.h"
#include "SplatLayers.h"
#include "SplatPass.h"
#include "SplatVectorBounds.h"
#include "ViewState.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkVolumeProperty.h"

#include <utility>

namespace nephoscope
{
namespace
{
auto KeyOf(vtkDataSet* input, const SplatSampling& sampling)
{
  return std::make_tuple(input, input->GetMTime(), sampling.OnCells, sampling.CellSize,
    sampling.ShapeArrayName, sampling.RadiusFactor, sampling.Frame, sampling.SizeArrayName,
    sampling.SizesAreVolumes, sampling.FromCells, sampling.FromNeighbors);
}
}

const double* SplatScene::UpdateBounds(vtkDataSet* input, const SplatSampling& sampling, int kernel,
  const std::string& vectorArrayName, const VectorLook& look)
{
  const BoundsKey key(KeyOf(input, sampling), kernel, vectorArrayName, look.Segments, look.Unit,
    look.StreakPeriod, look.SegmentLength);
  if (key != this->BoundsOf)
  {
    this->BoundsOf = key;
    WithThreads([&]() {
      const SplatShapes shapes(input, sampling);
      const double radius = KernelRadius(static_cast<SplatKernel>(kernel));
      FindSplatBounds(shapes, radius, this->Bounds);
      vtkDataArray* vectors = vectorArrayName.empty()
        ? nullptr
        : input->GetAttributes(sampling.OnCells ? vtkDataObject::CELL : vtkDataObject::POINT)
            ->GetArray(vectorArrayName.c_str());
      VectorLook found = look;
      found.Unit =
        look.Unit > 0 ? look.Unit : SumVectors(shapes, vectors).MeanCell() / sampling.RadiusFactor;
      AddVectorBounds(shapes, vectors, found, radius, this->Bounds);
    });
  }
  return this->Bounds;
}

std::string SplatScene::Update(vtkDataSet* input, const SplatSampling& sampling,
  const SplatFields& fields, const SplatVectorSettings& vectors)
{
  const bool haveVectors = !vectors.ArrayName.empty();
  const SampleKey samples = KeyOf(input, sampling);
  const ClassKey classes(fields.Scalars.Array, fields.Opacity.Array, fields.Scalars.Component,
    fields.Property->GetMTime(), input->GetMTime(), haveVectors, fields.Interpolate);
  this->From = { input, sampling, fields, haveVectors };
  const std::string error =
    this->FindSamples(samples != this->SampledFrom, classes != this->ClassifiedBy);
  this->SampledFrom = error.empty() ? samples : SampleKey(); // what is wrong is told again
  this->ClassifiedBy = classes;
  if (error.empty() && haveVectors)
  {
    this->RestoreJacobians();
    this->VectorScene.Update(input, sampling.OnCells, this->Samples, vectors);
  }
  return error;
}

std::string SplatScene::FindSamples(bool changed, bool reclassified)
{
  std::string error;
  WithThreads([&]() {
    if (changed)
    {
      this->Samples = FindSplatSamples(this->From.Input, this->From.Sampling, error);
      this->VectorScene.ForgetSamples();
    }
    if (!error.empty() || (!changed && !reclassified))
    {
      return;
    }
    const std::vector<std::int32_t> before = std::move(this->Classes.Samples);
    this->Classify();
    // Colours alone change, unless other samples are drawn or nodes of the hierarchy are in the
    // same arrays.
    if (changed || before != this->Classes.Samples || !this->Hierarchy.Tree().IsEmpty())
    {
      this->ForgetOrder();
      this->CellsUploaded = false;
    }
    this->Hierarchy.Invalidate();
    this->ColorsUploaded = false;
    this->VectorScene.ForgetUpload();
  });
  return error;
}

void SplatScene::Classify()
{
  const SplatFields& fields = this->From.Fields;
  this->FindLight();
  this->Classes = ClassifySplats(this->From.Input, this->Samples, fields.Scalars, fields.Opacity,
    fields.Property, this->From.KeepTransparent, fields.Interpolate, this->Light.Light.IsUsed());
}

// Colours of light that depends on the direction of view are found for each picture.
void SplatScene::FindLight()
{
  const SplatFields& fields = this->From.Fields;
  this->Light = SplatLightSource();
  if (fields.Opacity.Array) // the opacity does not change with the light
  {
    this->Light.Light = CameraLight(this->From.Input, fields.Scalars.Array, fields.Scalars.OnCells);
  }
  if (this->Light.Light.IsUsed())
  {
    double range[2];
    FindRange(this->From.Input, fields.Scalars, range);
    this->Light.Width = range[1] - range[0];
    this->Light.Colors.Build(fields.Property, range, TransferFunctionTable::Channels::Color);
  }
}

void SplatScene::RestoreJacobians()
{
  if (this->Samples.Jacobians.empty())
  {
    WithThreads(
      [&]() { FindJacobians(SplatShapes(this->From.Input, this->From.Sampling), this->Samples); });
  }
}

void SplatScene::RestoreColors()
{
  if (this->Classes.Colors.empty() && !this->Classes.Samples.empty())
  {
    WithThreads([&]() { this->Classify(); });
  }
}

// What the graphics card has, of 52 bytes for each sample with a shape of its own, is not kept
// twice. Not before the camera moves: as long as it does not, transfer functions may be edited, and
// other samples drawn. Vectors and the hierarchy need it in every picture.
void SplatScene::FreeUploaded(const SplatVectorSettings& vectors)
{
  const bool shapesOfGrid = // Direction() of the grid is not that of the shapes
    this->Samples.Dimensions[0] > 0 && !this->From.Sampling.ShapeArrayName.empty();
  if (!this->CameraMoved || !vectors.ArrayName.empty() || !this->Hierarchy.Tree().IsEmpty() ||
    shapesOfGrid)
  {
    return;
  }
  this->Classes.FreeColors();
  if (!this->Samples.HaveOneShape)
  {
    this->Samples.FreeJacobians();
  }
}

std::string SplatScene::DescribeLeftOut(const SplatFields& fields, const std::string& kind,
  const std::string& sizeArrayName, const std::string& vectorArrayName) const
{
  const auto quoted = [](vtkDataArray* array) {
    return std::string("'") + (array->GetName() ? array->GetName() : "(unnamed)") + "'";
  };
  const std::size_t notFinite = this->Samples.NumberNowhere + this->Classes.NumberWithoutValue;
  const bool none = notFinite + this->Samples.NumberOfWrongSizes >=
    static_cast<std::size_t>(fields.Scalars.Array->GetNumberOfTuples());
  const auto counted = [&](std::size_t count) {
    return std::to_string(count) + " " + kind + (count == 1 ? " is" : "s are") +
      (none ? " left out because array " : " not drawn because array ");
  };
  const std::string remedy = "Blank such " + kind + "s, or replace the values.";
  std::string text;
  if (notFinite > 0)
  {
    text = (none ? "Nothing is drawn: " : "") + counted(notFinite) + quoted(fields.Scalars.Array) +
      (fields.Opacity.Array && fields.Opacity.Array != fields.Scalars.Array
          ? ", " + quoted(fields.Opacity.Array)
          : "") +
      " or a coordinate is not finite there. " + remedy;
  }
  if (this->Samples.NumberOfWrongSizes > 0)
  {
    text += (text.empty() ? "" : " ") + counted(this->Samples.NumberOfWrongSizes) + "'" +
      sizeArrayName + "' is not positive or not finite there. Sizes must be positive.";
  }
  const std::size_t vectors =
    vectorArrayName.empty() ? 0 : this->VectorScene.GetVectors().GetNumberNotFinite();
  if (vectors > 0)
  {
    text += (text.empty() ? "The vectors of " : " The vectors of ") + std::to_string(vectors) +
      " " + kind + (vectors == 1 ? "" : "s") + " are not drawn because array '" + vectorArrayName +
      "' is not finite there. " + remedy;
  }
  return text;
}

void SplatScene::ForgetOrder()
{
  this->Order.clear();
  this->Eye[3] = -1;
}

void SplatScene::SetDrawsHierarchy(bool hierarchy)
{
  if (hierarchy != this->DrawsHierarchy)
  {
    this->ForgetOrder();
  }
  this->DrawsHierarchy = hierarchy;
}

void SplatScene::DrawNodes(const SplatErrorRule& errors, const SplatCutRule& rule,
  const SplatCutView& view, const std::string& vectorArrayName)
{
  this->SetDrawsHierarchy(true);
  this->RestoreJacobians();
  this->RestoreColors();
  WithThreads([&]() {
    if (this->Hierarchy.Update(this->Samples, this->Classes, this->VectorScene, vectorArrayName))
    {
      this->CellsUploaded = this->ColorsUploaded = false;
    }
    if (this->Hierarchy.Select(this->Samples, this->Classes, errors, rule, view))
    {
      this->ForgetOrder();
    }
  });
}

void SplatScene::UpdateOrder(const ViewState& state)
{
  const SplatMetric metric = MetricOf(ToViewMatrix(state.View));
  const SplatEye& eye = state.EyeModel;
  if (eye == this->Eye && metric == this->Metric && this->Order.size() == this->Drawn().size())
  {
    return;
  }
  this->CameraMoved = !this->Order.empty();
  WithThreads([&]() { this->Order = OrderSplats(this->Places(), this->Drawn(), eye, metric); });
  this->Eye = eye;
  this->Metric = metric;
  this->OrderUploaded = false;
  this->LayeredBy.reset();
}

void SplatScene::UpdateLayers(
  bool apart, bool ordered, vtkDataSet* input, int axis, std::size_t near)
{
  const LayerKey key(apart, ordered, axis, near);
  if (key == this->LayeredBy)
  {
    return;
  }
  this->LayeredBy = key;
  this->OrderUploaded = false;
  this->Items.clear();
  const bool flat = !apart && ordered && this->Samples.Dimensions[0] > 0 && !this->DrawsHierarchy;
  const int along = flat ? SplatLayers::FlatAxis(this->Samples, this->Eye, this->Metric) : axis;
  if (!apart && (!flat || along < 0))
  {
    return;
  }
  const bool onCells = std::get<2>(this->SampledFrom);
  SplatLayers layers;
  layers.Find(input, onCells, this->Samples, this->Eye, this->Metric, along);
  this->Items = apart ? layers.Alternate(this->Classes, this->Order, near)
                      : layers.Sort(this->Classes, this->Order, near);
}

double SplatScene::GetLayerThickness() const
{
  const bool grid = this->Samples.Dimensions[0] > 0;
  return grid ? 0.0 : SplatLayers::Thickness(this->Samples, this->Metric);
}

// By the numbers of splats that the pass knows.
void SplatScene::UploadOrder(SplatPass& pass) const
{
  if (!this->DrawsHierarchy)
  {
    pass.UploadOrder(this->Items.empty() ? this->Order : this->Items, {});
    return;
  }
  const std::vector<float>& all = this->Hierarchy.Weights();
  std::vector<std::int32_t> splats;
  std::vector<float> weights;
  splats.reserve(this->Order.size());
  weights.reserve(all.empty() ? 0 : this->Order.size());
  for (const std::int32_t item : this->Order)
  {
    splats.push_back(this->Hierarchy.Cut()[static_cast<std::size_t>(item)]);
    if (!all.empty())
    {
      weights.push_back(all[static_cast<std::size_t>(item)]);
    }
  }
  pass.UploadOrder(splats, weights);
}

std::string SplatScene::Upload(
  vtkOpenGLRenderWindow* window, SplatPass& pass, const SplatVectorSettings& vectors)
{
  std::string error;
  if (!this->CellsUploaded)
  {
    this->RestoreJacobians();
    error = pass.UploadCells(window, this->Samples, this->Classes, this->Hierarchy.Tree());
    this->VectorScene.ForgetUpload();
    this->CameraMoved = false;
  }
  if (error.empty() && !this->ColorsUploaded)
  {
    this->RestoreColors();
    error = pass.UploadColors(window, this->Classes, this->Hierarchy.Tree());
    error = error.empty()
      ? pass.UploadLight(window, this->Light, this->Samples, this->Classes, this->Hierarchy.Tree())
      : error;
  }
  if (error.empty() && !vectors.ArrayName.empty())
  {
    error = this->VectorScene.Upload(window, pass, this->Classes, this->Hierarchy.Tree(), vectors);
  }
  if (error.empty() && !this->OrderUploaded)
  {
    this->UploadOrder(pass);
  }
  this->CellsUploaded = this->ColorsUploaded = this->OrderUploaded = error.empty();
  if (error.empty())
  {
    this->FreeUploaded(vectors);
  }
  return error;
}

void SplatScene::ForgetUpload()
{
  this->CellsUploaded = this->ColorsUploaded = this->OrderUploaded = false;
  this->VectorScene.ForgetUpload();
}

} // namespace nephoscope
