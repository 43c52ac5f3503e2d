// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkCellContourMapper
 * @brief contour surfaces, polygons and layers that vtkCellCompositingMapper composites with its
 *        cells
 *
 * An abstract class: these are settings of vtkCellCompositingMapper, which draws.
 */
#ifndef vtkCellContourMapper_h
#define vtkCellContourMapper_h

#include "vtkNephoscopeRepresentationsCellCompositingModule.h" // for export macro
#include "vtkUnstructuredGridVolumeMapper.h"

#include <memory> // for std::unique_ptr
#include <string> // for array names

class vtkVolumeProperty;

namespace nephoscope
{
struct ContourSettings;
}

class VTKNEPHOSCOPEREPRESENTATIONSCELLCOMPOSITING_EXPORT vtkCellContourMapper
  : public vtkUnstructuredGridVolumeMapper
{
public:
  vtkTypeMacro(vtkCellContourMapper, vtkUnstructuredGridVolumeMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Contour surfaces inside the volume, without geometry: wherever a ray crosses a contour value, a
   * lit surface is composited between the media in front of it and behind it, so that all surfaces
   * and cells are in exact order. Values may come in any order. Default: none. A surface is the
   * boundary of the region where the scalar is at least the value, so a surface in a face between
   * cells is drawn once. Surfaces are drawn in fully transparent cells too. Values that are not
   * finite are rejected.
   * Within tetrahedra the surfaces are flat; hexahedra and other cells are divided into tetrahedra.
   */
  void SetContourValue(int i, double value);
  double GetContourValue(int i);
  void SetNumberOfContourValues(int number);
  int GetNumberOfContourValues() const;
  /** Sets `number` values at equal steps from low to high, both included. */
  void GenerateContourValues(int number, double low, double high);
  ///@}

  ///@{
  /**
   * Opacity of a contour surface, 0 to 1 (clamped). Default: 0.3. 0: not drawn, but still the
   * boundary of layers. Without a number: for all surfaces.
   */
  void SetContourOpacity(int i, double opacity);
  void SetContourOpacity(double opacity);
  double GetContourOpacity(int i);
  ///@}

  ///@{
  /**
   * Colour of a contour surface, 0 to 1 each. Default, or after SetContourColorToFunction: the
   * colour of the volume property's colour function at the surface.
   */
  void SetContourColor(int i, double red, double green, double blue);
  void SetContourColorToFunction(int i);
  /** -1, -1, -1 if the colour function gives the colour. */
  void GetContourColor(int i, double rgb[3]);
  ///@}

  ///@{
  /**
   * Name of the point array to contour, for example for isotherms in clouds. Empty (default): the
   * coloured array; for a vector, the component or the magnitude by which it is coloured. A cell
   * array has no surfaces inside its cells. With a coloured cell array and no name here, or if the
   * named array does not exist, no surface is drawn, with a warning.
   */
  void SetContourArrayName(const std::string& name);
  std::string GetContourArrayName();
  ///@}

  ///@{
  /**
   * Lights the contour surfaces with the renderer's lights, as VTK lights surfaces (Phong), with
   * ambient, diffuse, specular and specular power of the volume property, whatever its Shade is;
   * the medium is not lit. Default: on. At most 16 lights are used.
   */
  void SetContourLighting(bool lighting);
  bool GetContourLighting();
  void ContourLightingOn() { this->SetContourLighting(true); }
  void ContourLightingOff() { this->SetContourLighting(false); }
  ///@}

  ///@{
  /**
   * Normals of the contour surfaces: interpolated between gradients at the points (smooth, default;
   * 16 bytes per point), or the gradient in each tetrahedron, which shows the facets.
   */
  void SetSmoothContourNormals(bool smooth);
  bool GetSmoothContourNormals();
  void SmoothContourNormalsOn() { this->SetSmoothContourNormals(true); }
  void SmoothContourNormalsOff() { this->SetSmoothContourNormals(false); }
  ///@}

  enum PolygonsType
  {
    NO_POLYGONS = 0,
    CONTOUR_POLYGONS = 1,
    ALL_POLYGONS = 2
  };
  ///@{
  /**
   * Polygons of an unstructured grid that are composited with its cells, as lit, translucent
   * surfaces in the correct order. They must lie in faces of cells, like those of
   * vtkContourCellSplitter; others are left out, with a warning. Default: contours.
   * - Contours: polygons whose cell array ContourIndex (from vtkContourCellSplitter or
   *   vtkCloudSurface) is 0 or more.
   * - All: other polygons too, such as the boundary patches of a mesh file.
   * Lighting and normals are those of the contour surfaces. Costs 16 bytes per tetrahedron on
   * the GPU, and 64 per triangle.
   */
  virtual void SetPolygons(int polygons);
  int GetPolygons();
  void SetPolygonsToNone() { this->SetPolygons(NO_POLYGONS); }
  void SetPolygonsToContours() { this->SetPolygons(CONTOUR_POLYGONS); }
  void SetPolygonsToAll() { this->SetPolygons(ALL_POLYGONS); }
  ///@}

  ///@{
  /**
   * Opacity of the polygons with a ContourIndex (0 without such an array), 0 to 1 (clamped).
   * Default: 0.3. 0: not drawn. A negative number: for the contours without their own setting.
   * Without a number: for all polygons.
   */
  void SetPolygonOpacity(int contour, double opacity);
  void SetPolygonOpacity(double opacity);
  double GetPolygonOpacity(int contour);
  ///@}

  ///@{
  /**
   * Colour of those polygons, 0 to 1 each. Default, or after SetPolygonColorToFunction: the colour
   * of the colour function there.
   */
  void SetPolygonColor(int contour, double red, double green, double blue);
  void SetPolygonColorToFunction(int contour);
  /** -1, -1, -1 if the colour function gives the colour. */
  void GetPolygonColor(int contour, double rgb[3]);
  ///@}

  ///@{
  /**
   * Colour function, opacity function and unit distance of one layer; layers without a property
   * have the volume's. LayerArrayName or LayersFromContours defines the layers. Null removes a
   * property.
   * A property whose ScalarOpacityUnitDistance is exactly 1, VTK's default, has the volume's unit
   * distance. Any other value is the layer's own; for a unit distance of 1 that differs from the
   * volume's, set 1.0000001.
   */
  void SetLayerProperty(int layer, vtkVolumeProperty* property);
  vtkVolumeProperty* GetLayerProperty(int layer);
  void RemoveAllLayerProperties();
  /**
   * How many layers have a property, and which ones: `i` counts from 0, in ascending order of
   * layers. 0 if `i` is out of range.
   */
  int GetNumberOfLayerProperties() const;
  int GetLayerWithProperty(int i) const;
  ///@}

  ///@{
  /**
   * Name of the cell array with the layer number of each cell, as written by
   * vtkContourCellSplitter. Default: empty, none.
   */
  void SetLayerArrayName(const std::string& name);
  std::string GetLayerArrayName();
  ///@}

  ///@{
  /**
   * The contour values divide the volume into layers, drawn or not: the layer of a point is the
   * number of values at or below its scalar. Colour and opacity may be discontinuous across a
   * surface, also inside a cell, without loss of accuracy. Default: off.
   * Ignored if LayerArrayName is set.
   */
  void SetLayersFromContours(bool layers);
  bool GetLayersFromContours();
  void LayersFromContoursOn() { this->SetLayersFromContours(true); }
  void LayersFromContoursOff() { this->SetLayersFromContours(false); }
  ///@}

  /**
   * Copies the contour surfaces, polygons and layers. The list of layer properties is copied, the
   * properties are shared.
   */
  void ShallowCopy(vtkAbstractMapper* other) override;

protected:
  vtkCellContourMapper();
  ~vtkCellContourMapper() override;

  std::unique_ptr<nephoscope::ContourSettings> Contours;

private:
  bool CheckContour(int i);

  vtkCellContourMapper(const vtkCellContourMapper&) = delete;
  void operator=(const vtkCellContourMapper&) = delete;
};

#endif
