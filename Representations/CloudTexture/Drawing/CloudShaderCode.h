// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The code inserted into the shaders of the superclass, and the constants for this class' shaders.
 */
#ifndef nephoscope_CloudShaderCode_h
#define nephoscope_CloudShaderCode_h

#include "GardnerWaves.h"
#include "TexturedSurface.h"

#include "vtkShader.h"

#include <map>
#include <string>
#include <vector>

namespace nephoscope
{

/**
 * A point attribute: its name in the vertex shader, its type, and its source array on the surface.
 */
struct CloudAttribute
{
  std::string Name;
  std::string Type;
  std::string Array;
};

/** All that the mapper may map to attributes. */
std::vector<std::string> AllCloudAttributeNames();
std::vector<CloudAttribute> CloudAttributesOf(const TexturedSurface& surface);

/** The properties on which the program depends, apart from the surface. */
struct CloudShaderChoice
{
  bool UseThickness = false;
  int Drawings = 0;              ///< of layers, at most; 0: lists
  bool ThicknessIsAdded = false; ///< to the texture, instead of multiplying the opacity
  bool HasColors = false;
  std::string DensityVolume; ///< code of meanDensityOfVolume, empty: there is none
  GardnerWaves Waves;
  bool HasRegion = false; ///< fragments outside of it are left out
};

/** Names of the uniforms of layer i. */
std::string DepthsUniform(int i);
std::string DensitiesUniform(int i);

/** Constant hasDensity of the shaders of layers. */
std::string LayerConstants(const TexturedSurface& surface);

/** The fragment shader CloudDepths. `volume`: code of meanDensityOfVolume. */
std::string CloudDepthsCode(const std::string& volume);

/**
 * Multiplies the opacity of the fragment by that of the cloud, and its colours by those of the
 * texture.
 */
void AddCloudCode(std::map<vtkShader::Type, vtkShader*>& shaders, const TexturedSurface& surface,
  const CloudShaderChoice& choice);

} // namespace nephoscope

#endif
