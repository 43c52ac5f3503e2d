// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The waves of the texture, and the cover and the threshold that follow from each other by them.
#include "vtkCloudTextureMapperInternals.h"

#include <algorithm>

double vtkCloudTextureMapper::GetCoverageUsed()
{
  this->ChooseWaves();
  return this->UseThreshold
    ? nephoscope::CoverOfThreshold(this->Internals->InUse, this->Threshold, this->Softness)
    : this->Coverage;
}

double vtkCloudTextureMapper::GetThresholdUsed()
{
  this->ChooseWaves();
  return this->UseThreshold ? this->Threshold
                            : nephoscope::ThresholdOfCover(
                                this->Internals->ThresholdTable(), this->Coverage, this->Softness);
}

void vtkCloudTextureMapper::CopyWaves(vtkCloudTextureMapper* other)
{
  this->SetWaves(other->Waves);
  this->Internals->Custom = other->Internals->Custom;
}

void vtkCloudTextureMapper::SetNumberOfCustomWaves(int count)
{
  const std::size_t size =
    static_cast<std::size_t>(std::max(0, std::min(count, nephoscope::mostGardnerWaves)));
  if (size != this->Internals->Custom.size())
  {
    this->Internals->Custom.resize(size);
    this->Modified();
  }
}

int vtkCloudTextureMapper::GetNumberOfCustomWaves() const
{
  return static_cast<int>(this->Internals->Custom.size());
}

void vtkCloudTextureMapper::SetCustomWave(int i, double amplitude, double b, double c, double d,
  double shift, double e, double g, double h, double phase)
{
  if (i < 0 || i >= nephoscope::mostGardnerWaves)
  {
    vtkErrorMacro("There is no wave " << i << ": count them from 0, and set "
                                      << nephoscope::mostGardnerWaves << " at most.");
    return;
  }
  this->SetNumberOfCustomWaves(std::max(i + 1, this->GetNumberOfCustomWaves()));
  this->Internals->Custom[static_cast<std::size_t>(i)] = { amplitude, { { b, c, d } }, shift,
    { { e, g, h } }, phase };
  this->Modified();
}

void vtkCloudTextureMapper::GetCustomWave(int i, double values[9]) const
{
  nephoscope::ListWave(this->Internals->Custom, i, values);
}

int vtkCloudTextureMapper::GetNumberOfWavesUsed() const
{
  return static_cast<int>(this->Internals->InUse.size());
}

void vtkCloudTextureMapper::GetWaveUsed(int i, double values[9]) const
{
  nephoscope::ListWave(this->Internals->InUse, i, values);
}

void vtkCloudTextureMapper::ChooseWaves()
{
  vtkInternals& own = *this->Internals;
  own.InUse = nephoscope::Normalized(
    this->Waves == WAVES_CUSTOM ? own.Custom : nephoscope::PresetWaves(this->Waves));
  const std::string error =
    this->Waves == WAVES_CUSTOM ? nephoscope::DescribeUnusable(own.Custom) : std::string();
  if (!error.empty())
  {
    own.InUse = nephoscope::CloudWaves();
  }
  if (own.Surface.WrapsAround)
  {
    nephoscope::CloseOnLongitudes(own.InUse);
  }
  if (!error.empty() && error != own.LastWavesError)
  {
    vtkWarningMacro(<< error);
  }
  own.LastWavesError = error;
}
