// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The density of clouds in an image, on the GPU, where the fragment shader integrates it voxel by
 * voxel (CloudVolume.glsl).
 */
#ifndef nephoscope_DensityImage_h
#define nephoscope_DensityImage_h

#include "DensityVolume.h"

#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkTextureObject.h"

#include <vector>

class vtkDataArray;
class vtkImageData;

namespace nephoscope
{

class DensityImage : public DensityVolume
{
public:
  /** Two points or more along each axis; `array`: of one component, on the points. */
  DensityImage(vtkImageData* image, vtkDataArray* array);

  std::string GetShaderCode() const override;
  std::string Upload(vtkOpenGLRenderWindow* window) override;
  void Activate() override;
  void Deactivate() override;
  void SetUniforms(vtkShaderProgram* program, vtkMatrix4x4* viewToData) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

private:
  void Read(vtkDataArray* array);
  /** Whether texels have the corners of voxels: fewer fetches, for four times the memory. */
  bool HasCorners() const;
  std::vector<float> Corners() const;

  std::vector<float> Values;
  int Size[3] = { 0, 0, 0 };
  vtkNew<vtkMatrix4x4> ToIndex;
  vtkNew<vtkTextureObject> Texture;
  bool IsUploaded = false;
};

} // namespace nephoscope

#endif
