// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** Bumps of cloud for the lights: what the shaders of a textured surface need for them. */
#ifndef CloudRelief_h
#define CloudRelief_h

#include "GardnerWaves.h"

class vtkPolyData;
class vtkShader;

namespace nephoscope
{

/**
 * Raises the normal that the fragment shader lights, if it lights one. To be called when normals have been written into it and lights
 * have not. "weights" is what the shader calls the weights of the two sets.
 */
void addReliefCode(vtkShader* fragment, bool hasSecondSet, const char* weights);

/** Length of the largest waves on the surface. The length of one unit of texture is that of its field data, else "given", else that of the surface. */
double largestWaveLength(
  vtkPolyData* surface, double given, double scale, const GardnerWaves& waves);

} // namespace nephoscope

#endif
