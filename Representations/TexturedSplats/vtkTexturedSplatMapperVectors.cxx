// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The vectors of vtkTexturedSplatMapper: what the drawing needs of their settings, and how they
// move.
#include "vtkTexturedSplatMapper.h"

#include "ContrastingColor.h"
#include "RoundTime.h"
#include "SplatPass.h"
#include "SplatVectorScene.h"

#include "vtkColorTransferFunction.h"
#include "vtkDataSet.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>

namespace
{
// Even samples of the colours from one end of the transfer function to the other.
std::vector<nephoscope::StreakColor> ColorsOf(vtkVolumeProperty* property)
{
  constexpr int samples = 256;
  const bool hasColors = property->GetColorChannels() == 3;
  double range[2];
  std::copy_n(hasColors ? property->GetRGBTransferFunction()->GetRange()
                        : property->GetGrayTransferFunction()->GetRange(),
    2, range);
  std::vector<nephoscope::StreakColor> colors(samples);
  for (int i = 0; i < samples; ++i)
  {
    const double x = range[0] + (range[1] - range[0]) * i / (samples - 1);
    if (hasColors)
    {
      property->GetRGBTransferFunction()->GetColor(x, colors[i].data());
    }
    else
    {
      colors[i].fill(property->GetGrayTransferFunction()->GetValue(x));
    }
  }
  return colors;
}
}

void vtkTexturedSplatMapper::SuitVectorColor(
  vtkVolumeProperty* property, const double background[3])
{
  this->SuitVectorColor(property, background, background);
}

void vtkTexturedSplatMapper::SuitVectorColor(
  vtkVolumeProperty* property, const double bottom[3], const double top[3])
{
  const nephoscope::StreakColor ends[2] = { { { bottom[0], bottom[1], bottom[2] } },
    { { top[0], top[1], top[2] } } };
  const nephoscope::StreakColor color =
    nephoscope::ContrastingColor({ ends[0], ends[1] }, ColorsOf(property));
  this->SetVectorColor(color[0], color[1], color[2]);
  this->SetUseVectorColor(true);
}

nephoscope::SplatVectorSettings vtkTexturedSplatMapper::GetVectorSettings()
{
  nephoscope::SplatVectorSettings settings;
  settings.ArrayName = this->DrawnVectors;
  settings.ColorArrayName = this->VectorColorArrayName;
  settings.ColorFunction = this->VectorColorFunction;
  settings.OneColor = this->UseVectorColor;
  std::copy_n(this->VectorColor, 3, settings.Color.begin());
  settings.Loop = { this->Phase, this->PhaseCycles, this->PhaseSteps, this->MaximumSpeed,
    this->VectorFraction };
  if (this->TrueSpeed)
  {
    settings.Loop.Share = 0;
    settings.Loop.Period = this->GetPatternPeriod() * this->GetStreakUnit();
    settings.Loop.Time = this->FilmTime * this->GetDrawnTimeScale();
  }
  return settings;
}

double vtkTexturedSplatMapper::GetStreakUnit()
{
  return this->GetStreakUnit(this->GetVectorScene().GetVectors().MeanCell());
}

double vtkTexturedSplatMapper::GetStreakUnit(double meanCell) const
{
  return this->VectorUnit > 0
    ? this->VectorUnit
    : meanCell / (this->RadiusFactor * std::cbrt(std::max(this->VectorFraction, 1e-6)));
}

double vtkTexturedSplatMapper::GetDrawnMaximumSpeed()
{
  return this->MaximumSpeed > 0 ? this->MaximumSpeed
                                : this->GetVectorScene().GetVectors().MaximumSpeed();
}

// Chosen by the vectors of the first time step, so that it does not change during a film.
double vtkTexturedSplatMapper::GetOwnTimeScale()
{
  const nephoscope::SplatVectors& vectors = this->GetVectorScene().GetVectors();
  const double speed = this->MaximumSpeed > 0 ? this->MaximumSpeed : vectors.FirstMaximumSpeed();
  if (this->TimeScale > 0 || !(speed > 0))
  {
    return this->TimeScale;
  }
  return nephoscope::RoundDownTime(
    this->GetPatternPeriod() * this->GetStreakUnit(vectors.FirstMeanCell()) / speed);
}

double vtkTexturedSplatMapper::GetDrawnTimeScale()
{
  double scale = this->GetOwnTimeScale();
  for (vtkTexturedSplatMapper* other : this->FilmCompanions)
  {
    const bool shares = this->TimeScale == 0 && other && other->TrueSpeed && other->TimeScale == 0;
    const double theirs = shares ? other->GetOwnTimeScale() : 0.0; // 0 without a speed
    scale = theirs > 0 && scale > 0 ? std::min(scale, theirs) : scale;
  }
  return scale;
}

void vtkTexturedSplatMapper::FindFilmCompanions(vtkRenderer* renderer)
{
  this->FilmCompanions.clear();
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator at;
  props->InitTraversal(at);
  while (vtkProp* prop = this->TrueSpeed ? props->GetNextProp(at) : nullptr)
  {
    auto* volume = vtkVolume::SafeDownCast(prop);
    auto* mapper = volume && volume->GetVisibility()
      ? vtkTexturedSplatMapper::SafeDownCast(volume->GetMapper())
      : nullptr;
    if (mapper && mapper != this && !mapper->VectorArrayName.empty())
    {
      this->FilmCompanions.emplace_back(mapper);
      mapper->MeasureTimeScale(renderer, volume);
    }
  }
}

// Where the first frame has another time than 0, its first volume needs the speeds of the last one.
void vtkTexturedSplatMapper::MeasureTimeScale(vtkRenderer* renderer, vtkVolume* volume)
{
  if (!this->TrueSpeed || this->GetOwnTimeScale() > 0 || !this->GetInputAlgorithm())
  {
    return;
  }
  this->GetInputAlgorithm()->Update();
  vtkDataSet* input = this->GetDataSetInput();
  if (input && input->GetNumberOfPoints() > 0)
  {
    this->WithNeighbors = this->DrawsRegion(renderer);
    this->UpdateSplats(input, volume); // which reports its errors when it is drawn
  }
}

void vtkTexturedSplatMapper::AdvancePhases(double time)
{
  nephoscope::SplatVectorScene& scene = this->GetVectorScene();
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
  scene.GetVectors().Advance(time, this->GetPatternPeriod() * this->GetStreakUnit());
  scene.ForgetUpload();
  this->Modified();
}

void vtkTexturedSplatMapper::SetVectorOptions(nephoscope::SplatDrawingOptions& options)
{
  options.Vectors = !this->DrawnVectors.empty();
  options.Segments = this->VectorStyle == SEGMENTS;
  options.MediaApart = options.Vectors && this->VectorPlacement == PLACEMENT_LAYERS;
  // Lengthened splats share the opacity among more of them, of which only some are drawn.
  options.VectorScale = this->VectorOpacity / std::cbrt(std::max(this->VectorFraction, 1e-6));
  const double greatest = this->GetDrawnMaximumSpeed();
  options.MaximumSpeed = greatest > 0 ? greatest : 1.0;
  options.VectorUnit = this->GetStreakUnit();
  options.StreakPeriod = this->StreakPeriod;
  options.StreakWidth = this->StreakWidth;
  options.SegmentLength = this->SegmentLength;
  options.SegmentWidth = this->SegmentWidth;
}
