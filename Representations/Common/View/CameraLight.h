// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Light towards the camera, from what vtkSunlight with FollowCamera writes: for light that goes in
 * the direction d, at an angle to sunlight that makes its factors P and Q,
 *
 *     Sunlight + d . DiffuseFlux + P2(d . up) DiffuseSecondMoment + (P - 1) SingleScattering[0] +
 *     (Q - 1) SingleScattering[1]
 *
 * P2 is the Legendre polynomial.
 */
#ifndef nephoscope_CameraLight_h
#define nephoscope_CameraLight_h

#include "vtkNephoscopeRepresentationsCommonModule.h" // for export macro

#include "Planet.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <array>
#include <utility>
#include <vector>

class vtkDataArray;
class vtkDataSet;

namespace nephoscope
{

class VTKNEPHOSCOPEREPRESENTATIONSCOMMON_EXPORT CameraLight
{
public:
  CameraLight() = default;
  /**
   * Used if the coloured array is Sunlight, and the data have the others, on points or `onCells`.
   */
  CameraLight(vtkDataSet* data, vtkDataArray* colors, bool onCells = false);

  bool IsUsed() const { return this->Phase != nullptr; }
  /**
   * Light towards the camera is cut off there, for the precision of what is drawn; 1 is the light
   * of a white surface.
   */
  static constexpr double Brightest = 64;
  /** By how much, at most, light towards the camera exceeds Sunlight; not more than Brightest. */
  double Headroom() const;
  /**
   * For each point or cell, as fractions of `width`: DiffuseFlux, SingleScattering[0];
   * SingleScattering[1], up times the root of the absolute DiffuseSecondMoment, whose sign is that
   * of the fifth number.
   */
  std::vector<std::array<float, 4>> Parts(double width) const;
  /** P - 1 and Q - 1, evenly spaced from 0 to 180 degrees. */
  std::vector<std::array<float, 2>> Factors() const;
  /** Towards the sun, unit length. */
  std::array<float, 3> TowardsSun() const { return this->Sun; }

  /** shaders/CameraLight.glsl */
  static const char* ShaderText();

  bool operator==(const CameraLight& other) const;

private:
  Vector3 UpAt(vtkIdType point) const;
  std::array<float, 4> SecondPart(vtkIdType point, double scale) const;

  vtkSmartPointer<vtkDataArray> Single, Flux, Phase, Moment; // the last is null in data without it
  std::array<vtkMTimeType, 4> Times = { { 0, 0, 0, 0 } };
  Planet Ground;
  vtkSmartPointer<vtkDataSet> Places; // where up depends on the place
  bool OnCells = false;
  std::array<float, 3> Sun = { { 0, 0, 1 } };
};

} // namespace nephoscope

#endif
