// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The optical properties of every point or cell as arrays.
#ifndef nephoscope_OpticalArrays_h
#define nephoscope_OpticalArrays_h

#include "UprightOrder.h"
#include "WaterFields.h"

#include "vtkFloatArray.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <string>
#include <vector>

namespace nephoscope
{
struct OpticalSettings
{
  bool ConstantLiquidRadius = false;
  bool ConstantIceRadius = false;
  double LiquidRadius = 10e-6; // m
  double IceRadius = 30e-6;    // m
  double DropletsLand = 300e6; // 1/m3
  double DropletsSea = 100e6;
  double Exaggeration = 1; // of heights, in the coordinates of the data
};

struct OpticalArrays
{
  vtkSmartPointer<vtkFloatArray> Extinction, Albedo, Asymmetry, LiquidRadius, IceRadius;
  vtkIdType Negative = 0, Missing = 0; // values of water that were taken as 0
};

/**
 * Structured data in columns, along the third index of the order; of other data it has one level at
 * most.
 */
UprightOrder ColumnsOf(vtkDataSet* data, bool onCells);

/**
 * Pressures in pascals, of the pressure array in hydrostatic balance, or without columns of the
 * standard atmosphere; empty where none are needed.
 */
std::vector<double> PressuresOf(vtkDataSet* data, const WaterFields& fields);

/** `progress` takes the fraction that is done; false: stop, and the arrays are not complete. */
OpticalArrays ComputeOptics(vtkDataSet* data, const WaterFields& fields,
  const std::vector<double>& pressures, const OpticalSettings& settings,
  const std::function<bool(double)>& progress);

/** Optical depth from each point up to the top of its column, and of the whole column. */
void ComputeColumns(vtkDataSet* data, const UprightOrder& order, vtkFloatArray* extinction,
  vtkFloatArray* above, vtkFloatArray* whole);
}

#endif
