// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** The bump map of clouds for the lights: the shader code for a textured surface. */
#ifndef nephoscope_CloudRelief_h
#define nephoscope_CloudRelief_h

#include "GardnerWaves.h"

class vtkPolyData;
class vtkShader;

namespace nephoscope
{

/**
 * Raises the normal that the fragment shader lights, if it lights one. To be called when normals
 * have been written into it and lights have not. "weights" is what the shader calls the weights of
 * the two sets.
 */
void AddReliefCode(vtkShader* fragment, bool hasSecondSet, const char* weights);

/**
 * Length of the largest waves on the surface. The length of one texture unit is that of its field
 * data, otherwise "given", otherwise that of the surface.
 */
double LargestWaveLength(
  vtkPolyData* surface, double given, double scale, const GardnerWaves& waves);

} // namespace nephoscope

#endif
