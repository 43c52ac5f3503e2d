// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The optics of smoke, as vtkFlowVolume and vtkSmokePuffs write it, where nobody has given it any.
 */
#ifndef nephoscope_SmokeOptics_h
#define nephoscope_SmokeOptics_h

#include <string>

class vtkDataSet;
class vtkMultiProcessController;

namespace nephoscope
{
/**
 * The array that tells lit smoke from smoke that was made in lit clouds, whose arrays it carries.
 */
constexpr const char* smokeExtinctionName = "SmokeExtinction";

/**
 * Mean density of smoke times the width of its generating polygon; 0 if the data are no smoke.
 * `ranks`: all of them call this, each with its piece of the smoke, or without smoke; or null.
 */
double SmokeColumn(vtkDataSet* data, vtkMultiProcessController* ranks);

/**
 * Adds an extinction in proportion to the visible density of smoke, such that a path as long as the
 * generating polygon is wide, through smoke of the mean density, has an optical depth of 1
 * (`column`: SmokeColumn); and the
 * albedo and asymmetry of fresh smoke of vegetation fires in green light (ReidEtAl2005), unless
 * their names are empty. Arrays of these names are replaced: they are those of the clouds that the
 * smoke was made in. False if the data are no smoke.
 */
bool AddSmokeOptics(
  vtkDataSet* data, const std::string& albedoName, const std::string& asymmetryName, double column);
}

#endif
