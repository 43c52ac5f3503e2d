// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The clipping planes of a mapper, for its shaders: of every ray only the part is seen that lies in
 * front of all of them.
 */
#ifndef nephoscope_ClippingPlanes_h
#define nephoscope_ClippingPlanes_h

#include "vtkNephoscopeRepresentationsCommonModule.h" // for export macro

#include <array>
#include <string>
#include <vector>

class vtkAbstractMapper;
class vtkMatrix4x4;
class vtkRenderer;
class vtkShaderProgram;

namespace nephoscope
{

class VTKNEPHOSCOPEREPRESENTATIONSCOMMON_EXPORT ClippingPlanes
{
public:
  /** (normal, offset): a point p is seen where dot((p, 1), plane) >= 0. */
  using Plane = std::array<float, 4>;

  /** None. */
  ClippingPlanes() = default;
  /**
   * Those of the mapper as the renderer's camera sees them. VTK gives them in world coordinates.
   */
  ClippingPlanes(vtkAbstractMapper* mapper, vtkRenderer* renderer);

  /**
   * Adds the near and the far plane of the renderer's camera where they pass through the bounds,
   * which are in world coordinates. The near plane of a perspective view is left out if its
   * distance from the eye is less than 1/200 of the diagonal of the bounds.
   */
  void AddPlanesOfCamera(vtkRenderer* renderer, const double bounds[6]);

  /** The problem with the mapper's planes, or empty. */
  static std::string Check(vtkAbstractMapper* mapper);

  bool IsEmpty() const { return this->Planes.empty(); }
  /**
   * The function clippedRay of shaders/ClippingPlanes.glsl; within it CLIPPING_PLANES is defined.
   * Empty where there are none.
   */
  std::string Definition() const;
  void SetUniforms(vtkShaderProgram* program, const char* name = "clippingPlanes") const;

  /**
   * In view coordinates, normals of unit length; `worldToView` as vtkMatrix4x4 multiplies columns.
   */
  static Plane ToView(const double origin[3], const double normal[3], vtkMatrix4x4* worldToView);

private:
  std::vector<Plane> Planes;
};

} // namespace nephoscope

#endif
