// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** What the user sets about contour surfaces and layers; see vtkCellCompositingMapper for the meaning. */
#ifndef ContourSettings_h
#define ContourSettings_h

#include "vtkSmartPointer.h"
#include "vtkVolumeProperty.h"

#include <array>
#include <map>
#include <string>
#include <vector>

namespace nephoscope
{

struct ContourSettings
{
  struct Surface
  {
    double Value = 0.0;
    double Opacity = 0.3;
    std::array<double, 3> Color = { { -1.0, -1.0, -1.0 } }; ///< negative: of the colour function
  };
  std::vector<Surface> Surfaces; ///< as numbered by the user, not sorted
  std::string ArrayName;         ///< empty: the colour array
  bool SmoothNormals = true;
  bool Lighting = true;

  std::map<int, vtkSmartPointer<vtkVolumeProperty>> LayerProperties;
  std::string LayerArrayName;
  bool LayersFromContours = false;

  bool LayersAreUsed() const
  {
    return !this->LayerProperties.empty() && (!this->LayerArrayName.empty() || this->ContoursMakeLayers());
  }
  /** Cells that say their layer themselves come first. */
  bool ContoursMakeLayers() const
  {
    return this->LayersFromContours && this->LayerArrayName.empty() && !this->Surfaces.empty() &&
      !this->LayerProperties.empty();
  }
};

} // namespace nephoscope

#endif
