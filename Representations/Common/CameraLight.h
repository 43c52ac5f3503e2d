// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Light towards the camera, from what vtkSunlight with FollowCamera writes: for light that goes in the direction d, at an angle to sunlight that makes its factors P and Q,
 *
 *     Sunlight + d . DiffuseFlux + (P - 1) SingleScattering[0] + (Q - 1) SingleScattering[1]
 */
#ifndef CameraLight_h
#define CameraLight_h

#include "vtkNephoscopeRepresentationsCommonModule.h" // for export macro

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
  /** Used if the coloured array is Sunlight, and the data have the others. */
  CameraLight(vtkDataSet* data, vtkDataArray* colors);

  bool IsUsed() const { return this->Phase != nullptr; }
  /** Light towards the camera is cut off there, for the precision of what is drawn; 1 is the light of a white surface. */
  static constexpr double Brightest = 64;
  /** By how much, at most, light towards the camera exceeds Sunlight; not more than Brightest. */
  double Headroom() const;
  /** For each point, as fractions of `width`: DiffuseFlux, SingleScattering[0]; SingleScattering[1], 0, 0, 0. */
  std::vector<std::array<float, 4>> Parts(double width) const;
  /** P - 1 and Q - 1, evenly spaced from 0 to 180 degrees. */
  std::vector<std::array<float, 2>> Factors() const;
  /** Towards the sun, unit length. */
  std::array<float, 3> TowardsSun() const { return this->Sun; }

  bool operator==(const CameraLight& other) const;

private:
  vtkSmartPointer<vtkDataArray> Single, Flux, Phase;
  std::array<vtkMTimeType, 3> Times = { { 0, 0, 0 } };
  std::array<float, 3> Sun = { { 0, 0, 1 } };
};

} // namespace nephoscope

#endif
