// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The density of clouds in cells of all kinds, on the GPU, where the fragment shader integrates it
 * in their tetrahedra (CloudCells.glsl).
 */
#ifndef nephoscope_DensityCells_h
#define nephoscope_DensityCells_h

#include "BufferTexture.h"
#include "DensityBins.h"
#include "DensityTetrahedra.h"
#include "DensityVolume.h"

#include <vector>

namespace nephoscope
{

class DensityCells : public DensityVolume
{
public:
  /** Empty, or why there is nothing to integrate. */
  std::string Take(const std::vector<DensityBlock>& blocks);

  std::string GetShaderCode() const override;
  std::string Upload(vtkOpenGLRenderWindow* window) override;
  void Activate() override;
  void Deactivate() override;
  void SetUniforms(vtkShaderProgram* program, vtkMatrix4x4* viewToData) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

private:
  DensityTetrahedra Cells;
  DensityBins Bins;
  BufferTexture Points, Tetrahedra, Lists;
  int Units[3] = { 0, 0, 0 };
  int FirstCellDensity = -1; // element of Points, -1: densities are of points
  float Radius = 0;          // of all points about the centre
  bool IsUploaded = false;
};

} // namespace nephoscope

#endif
