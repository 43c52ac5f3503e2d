// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** The density of clouds in an image, on the GPU, where the fragment shader integrates it voxel by voxel (CloudVolume.glsl). */
#ifndef DensityVolume_h
#define DensityVolume_h

#include "vtkNew.h"
#include "vtkType.h"

#include <string>
#include <tuple>
#include <vector>

class vtkDataArray;
class vtkImageData;
class vtkMatrix4x4;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

namespace nephoscope
{

class DensityVolume
{
public:
  DensityVolume();
  ~DensityVolume();
  DensityVolume(const DensityVolume&) = delete;
  DensityVolume& operator=(const DensityVolume&) = delete;

  /** Takes the image, or none, and a point array, or without a name the active scalars. False: it is that of the last time. */
  bool Prepare(vtkImageData* image, const std::string& name);
  bool IsUsed() const { return !this->Values.empty(); }
  /** Why there is none, and what is wrong with its values; empty if nothing is. */
  const std::string& GetError() const { return this->Error; }
  const std::string& GetWarning() const { return this->Warning; }
  /** Over the points where there is some. */
  double GetMeanDensity() const { return this->MeanDensity; }

  /** Empty, or what went wrong. */
  std::string Upload(vtkOpenGLRenderWindow* window);
  void Activate();
  void Deactivate();
  /** `viewToData`: from view coordinates to those of the image. */
  void SetUniforms(vtkShaderProgram* program, vtkMatrix4x4* viewToData);
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  void Read(vtkImageData* image, vtkDataArray* array);

  std::vector<float> Values;
  int Size[3] = { 0, 0, 0 };
  double MeanDensity = 1;
  std::string Error, Warning;
  std::tuple<vtkImageData*, vtkMTimeType, std::string> MadeFrom{ nullptr, 0, "" };
  vtkNew<vtkMatrix4x4> ToIndex;
  vtkNew<vtkTextureObject> Texture;
  bool IsUploaded = false;
};

} // namespace nephoscope

#endif
