// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** The user's settings for contour surfaces and layers; vtkCellCompositingMapper describes them. */
#ifndef nephoscope_ContourSettings_h
#define nephoscope_ContourSettings_h

#include "CellPolygons.h"

#include "vtkSmartPointer.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
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

  /**
   * The unit distance of a new vtkVolumeProperty; a layer with this value uses the volume's unit
   * distance.
   */
  static constexpr double DefaultUnitDistance = 1.0;
  std::map<int, vtkSmartPointer<vtkVolumeProperty>> LayerProperties;
  std::string LayerArrayName;
  bool LayersFromContours = false;

  CellPolygons::Which Polygons = CellPolygons::Which::Contours;
  Surface Polygon;                          ///< how those are drawn that have no entry below
  std::map<int, Surface> PolygonsOfContour; ///< by ContourIndex

  const Surface& FindPolygon(int contour) const
  {
    const auto found = this->PolygonsOfContour.find(contour);
    return found == this->PolygonsOfContour.end() ? this->Polygon : found->second;
  }

  /** A negative number: for all that have not been changed. */
  Surface& ChangePolygon(int contour)
  {
    return contour < 0 ? this->Polygon
                       : this->PolygonsOfContour.emplace(contour, this->Polygon).first->second;
  }

  bool DrawsSurfaces() const
  {
    return std::any_of(this->Surfaces.begin(), this->Surfaces.end(),
      [](const Surface& s) { return s.Opacity > 0.0; });
  }

  ContourSettings WithoutSurfaces() const
  {
    ContourSettings settings(*this);
    settings.Surfaces.clear();
    return settings;
  }

  bool LayersAreUsed() const
  {
    return !this->LayerProperties.empty() &&
      (!this->LayerArrayName.empty() || this->ContoursMakeLayers());
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
