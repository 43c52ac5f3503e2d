// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// What vtkCloudTextureMapper keeps from frame to frame: its waves and their thresholds, the
// prepared surface, the passes.
#ifndef vtkCloudTextureMapperInternals_h
#define vtkCloudTextureMapperInternals_h

#include "vtkCloudTextureMapper.h"

#include "CloudThicknessPass.h"
#include "CoverageThreshold.h"
#include "DensityVolume.h"
#include "JoinedSurfaces.h"
#include "KeepPeeling.h"
#include "ResourceWindow.h"
#include "TexturedSurface.h"

#include "vtkBoundingBox.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"

#include <memory>
#include <string>
#include <tuple>
#include <vector>

struct vtkCloudTextureMapper::vtkInternals
{
  using Key = std::tuple<vtkPolyData*, vtkMTimeType, std::string, std::string, std::string, double,
    double, std::string, bool, bool, double, double>;

  nephoscope::GardnerWaves Custom = nephoscope::CloudWaves();
  nephoscope::GardnerWaves InUse = nephoscope::CloudWaves();
  std::vector<double> TableAmplitudes;
  std::unique_ptr<nephoscope::CoverageThresholds> Table;
  nephoscope::JoinedSurfaces Blocks;
  vtkSmartPointer<vtkCloudTextureMapper> ForBlocks;
  vtkMTimeType ForBlocksTime = 0;
  nephoscope::TexturedSurface Surface;
  double SolidColor[3] = { 1, 1, 1 }; // of the actor
  Key MadeFrom{ nullptr, 0, "", "", "", 0.0, 0.0, "", false, false, 0.0, 0.0 };
  std::string LastError, LastWarning, LastThickness, LastWavesError, LastVolume;
  nephoscope::CloudThicknessPass Thickness;
  std::shared_ptr<nephoscope::DensityVolume> Volume; // null: none is used
  vtkBoundingBox VolumeBounds;
  bool IsElsewhere = false; // the volume; a warning has said it
  std::tuple<vtkDataObject*, vtkMTimeType, std::string> VolumeMadeFrom{ nullptr, 0, "" };
  nephoscope::KeepPeeling Peels;
  int Drawings = 0; // number of layers for which the shader was generated
  vtkSmartPointer<vtkTextureObject> Thresholds;

  nephoscope::ResourceWindow Window{ [this](vtkWindow* window) {
    this->Thresholds = nullptr;
    this->Thickness.ReleaseGraphicsResources(window);
    if (this->Volume)
    {
      this->Volume->ReleaseGraphicsResources(window);
    }
  } };

  /** Only amplitudes count. */
  const nephoscope::CoverageThresholds& ThresholdTable()
  {
    std::vector<double> amplitudes;
    for (const nephoscope::GardnerWave& wave : this->InUse)
    {
      amplitudes.push_back(wave.Amplitude);
    }
    if (!this->Table || amplitudes != this->TableAmplitudes)
    {
      this->Table.reset(new nephoscope::CoverageThresholds(this->InUse));
      this->TableAmplitudes = amplitudes;
      this->Thresholds = nullptr;
    }
    return *this->Table;
  }

  void Enter(vtkOpenGLRenderWindow* window)
  {
    this->Window.Enter(window);
    this->ThresholdTable();
    if (this->Thresholds)
    {
      return;
    }
    const nephoscope::CoverageThresholds& table = this->ThresholdTable();
    std::vector<float> values = table.GetValues();
    this->Thresholds = vtkSmartPointer<vtkTextureObject>::New();
    this->Thresholds->SetContext(window);
    this->Thresholds->Create2DFromRaw(
      static_cast<unsigned int>(nephoscope::CoverageThresholds::columns),
      static_cast<unsigned int>(nephoscope::CoverageThresholds::rows), 1, VTK_FLOAT, values.data());
    this->Thresholds->SetMinificationFilter(vtkTextureObject::Linear);
    this->Thresholds->SetMagnificationFilter(vtkTextureObject::Linear);
    this->Thresholds->SetWrapS(vtkTextureObject::ClampToEdge);
    this->Thresholds->SetWrapT(vtkTextureObject::ClampToEdge);
  }
};

#endif
