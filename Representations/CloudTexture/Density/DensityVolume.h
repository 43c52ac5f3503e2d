// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The density of clouds in space on the GPU, where the fragment shader integrates it along rays: of
 * an image voxel by voxel (DensityImage), of all other grids tetrahedron by tetrahedron
 * (DensityCells).
 */
#ifndef nephoscope_DensityVolume_h
#define nephoscope_DensityVolume_h

#include "vtkType.h"

#include <memory>
#include <string>

class vtkDataObject;
class vtkMatrix4x4;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;

namespace nephoscope
{

class DensityVolume
{
public:
  virtual ~DensityVolume() = default;

  /**
   * Declares meanDensityOfVolume(start, end, enough), places in view coordinates: the mean, or any
   * number from `enough` to the mean where that is larger. Needs the context.
   */
  virtual std::string GetShaderCode() const = 0;

  /** Empty, or what went wrong. Does nothing where it has been done. */
  virtual std::string Upload(vtkOpenGLRenderWindow* window) = 0;
  virtual void Activate() = 0;
  virtual void Deactivate() = 0;
  /** `viewToData`: from view coordinates to those of the data. */
  virtual void SetUniforms(vtkShaderProgram* program, vtkMatrix4x4* viewToData) = 0;
  virtual void ReleaseGraphicsResources(vtkWindow* window) = 0;

  /** Where there is some. */
  double MeanDensity = 1;
  /** The problem with the values; empty if there is none. */
  std::string Warning;
};

/** Values that are a density. */
inline bool IsDensity(double value)
{
  return value >= 0 && value < 1e30;
}

/**
 * `name`: of a point or cell array; empty: active scalars. Null if there are no data, or for the
 * reason given in `error`.
 */
std::unique_ptr<DensityVolume> MakeDensityVolume(
  vtkDataObject* data, const std::string& name, std::string& error);

} // namespace nephoscope

#endif
