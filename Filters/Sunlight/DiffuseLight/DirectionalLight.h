// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The parts of the source function that depend on the direction of view, as arrays for mappers.
#ifndef nephoscope_DirectionalLight_h
#define nephoscope_DirectionalLight_h

#include "LightGrid.h"
#include "PhaseTable.h"

#include <vector>

class vtkDataSet;

namespace nephoscope
{
/** Light at the points; albedo and asymmetry are scaled. Shadow may be empty. */
struct DirectionalSource
{
  const std::vector<float>& Extinction;
  const std::vector<float>& Albedo;
  const std::vector<float>& Asymmetry;
  const std::vector<float>& Transmittance;
  const std::vector<float>& ScaledDepth;
  const std::vector<float>& Shadow;
  const std::vector<Vector>& Flux;
  const std::vector<float>& SecondMoment; ///< empty: 0, as the flux
  bool Scales;
};

/**
 * Adds point arrays to data that have Sunlight, the mean over all directions: SingleScattering
 * (light straight from the sun; light that has been scattered straight on before), DiffuseFlux and
 * DiffuseSecondMoment; and the field array PhaseFunction, factors of the two from 0 to 180 degrees.
 */
void AddDirectionalLight(vtkDataSet* data, const DirectionalSource& source, PhaseKind kind);
}

#endif
