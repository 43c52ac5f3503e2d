// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkCellCompositingMapper
 * @brief Direct volume rendering of polyhedral cells with the exact ray integral
 *
 * Every pixel's ray walks through the mesh from cell to cell, front to back. In every cell the
 * transfer functions are looked up in float, and emission and extinction are integrated between the
 * two ends to float accuracy. 3-D cells must be convex. Hexahedra, voxels, wedges and pyramids have
 * their trilinear field; others are divided into tetrahedra with a linear scalar
 * (SetCellInterpolation). The sum is a 32-bit float image that is laid over the scene. Nothing is
 * sorted, and contour surfaces, layers and polygons (vtkCellContourMapper) are found along the
 * rays.
 *
 * - Extinction per unit world length = opacity function value * OpacityScale /
 *   ScalarOpacityUnitDistance (a rate, as in VTK's other unstructured volume mappers, not -log(1 -
 *   opacity)).
 * - The colour function is the source colour (emission coefficient divided by extinction).
 * - Point and cell scalars; tetrahedra, hexahedra, voxels, wedges, pyramids, convex polyhedra.
 *   Polyhedra that are not convex get a warning: vtkPolyhedronToTetrahedra divides them.
 * - Any vtkDataSet with 3-D cells is accepted; image data need not be converted.
 * - Cells that a ghost array marks as duplicate, refined or hidden are not drawn.
 * - Opaque geometry that cuts a cell ends its integral at the opaque depth, per pixel.
 * - Translucent surfaces in front of, inside and behind the cells are composited with them in the
 *   right order when the renderer peels volumes: UseDepthPeelingOn(),
 *   UseDepthPeelingForVolumesOn(), SetOcclusionRatio(0). Otherwise all surfaces are drawn first,
 *   and the cells on top of them.
 * - Overlapping volumes of a renderer are composited as one medium, whatever the order in which
 *   they were added, if all have the default method, order and integration and neither contour
 *   values nor polygons. Extinctions add, and each volume emits in proportion to its own
 *   extinction. Other volumes, and splats, are drawn from back to front, in slices of depth where
 *   they overlap.
 *
 * References: N. Max, R. Crawfis, B. Becker, New Techniques in 3D Scalar and Vector Field
 * Visualization, Pacific Graphics 1993, section 2 (MaxCrawfisBecker1993); P. Shirley, A. Tuchman, A
 * Polygonal Approximation to Direct Scalar Volume Rendering, 1990 (ShirleyTuchman1990); P.
 * Williams, N. Max, A Volume Density Optical Model, 1992 (WilliamsMax1992).
 */
#ifndef vtkCellCompositingMapper_h
#define vtkCellCompositingMapper_h

#include "vtkCellContourMapper.h"
#include "vtkNephoscopeRepresentationsCellCompositingModule.h" // for export macro

#include <array>  // for points
#include <memory> // for std::unique_ptr
#include <string> // for messages

class vtkDataArray;
class vtkImageData;
class vtkOpenGLRenderWindow;
class vtkVolumeProperty;

namespace nephoscope
{
struct CellsInOrder;
class CellGeometry;
class Progress;
struct ScalarSelection;
}

class VTKNEPHOSCOPEREPRESENTATIONSCELLCOMPOSITING_EXPORT vtkCellCompositingMapper
  : public vtkCellContourMapper
{
public:
  static vtkCellCompositingMapper* New();
  vtkTypeMacro(vtkCellCompositingMapper, vtkCellContourMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The data to draw: any vtkDataSet with 3-D cells. */
  using vtkUnstructuredGridVolumeMapper::SetInputData;
  void SetInputData(vtkDataSet* data) override;
  void SetInputData(vtkUnstructuredGridBase* data) override;
  ///@}

  enum MethodType
  {
    PROJECTION_METHOD = 0,
    CELLS_METHOD = PROJECTION_METHOD, // its name as a method, besides triangles and faces
    RAY_METHOD = 1,
    TRIANGLES_LINEAR_METHOD = 2,
    TRIANGLES_TABLE_METHOD = 3,
    FACES_METHOD = 4,
    AUTOMATIC_METHOD = 5
  };
  ///@{
  /**
   * Rendering method. Default: automatic. Any other value is rejected with an error.
   * - Rays: every pixel walks through the mesh from cell to cell, front to back. The order is exact
   *   for every mesh, with cycles, holes and separate parts. Where cells overlap in space, each
   *   part of a ray between entering and leaving the mesh is composited whole, in the order of
   *   entering; if the eye is inside several overlapping parts, in any order. Contour surfaces,
   *   layers and polygons are found along the ray.
   * - Automatic: rays. Projection if VisibilityOrder is not exact, or if the OpenGL driver does not
   *   draw rays correctly, with a warning.
   *
   * The other methods show the results of earlier techniques for the same scene
   * (Documentation/cell-compositing-methods.md):
   * - Projection, or Cells: cell by cell, back to front in the order given by VisibilityOrder, each
   *   with the exact integral over the pixels that it covers. Contour surfaces, polygons, layers
   *   between contour values, and cells between peeled surfaces are drawn by rays.
   * - TrianglesLinear: tetrahedra projected to triangles around their thickest point (Shirley and
   *   Tuchman), opacity and mean colour at the corners interpolated on the screen. The opacity is
   *   too low by up to .08 per tetrahedron at optical depth 1. Integration is taken as average,
   *   SplitAtControlPoints as off.
   * - TrianglesTable: the same triangles; optical depth per pixel and 1 - exp(-u) from a table of
   *   1024 values, mean colour.
   *   Integration is taken as average, SplitAtControlPoints as off.
   * - Faces: faces in the order of their centroids, on the processor, each compositing the segment
   *   to the one drawn before it at a pixel, of negative length where the order is wrong (Lucas
   *   1992; MaxCrawfisBecker1993 section 2). Exact in any order for one colour and extinction.
   *   VisibilityOrder None: input order, else centroids. SplitAtControlPoints is taken as off.
   * With triangles, tetrahedra that reach the plane of the eye are left out, with a warning. These
   * three draw layers of cells, but neither contour surfaces nor the layers between contour values,
   * and say so in a warning.
   */
  virtual void SetMethod(int method);
  vtkGetMacro(Method, int);
  void SetMethodToProjection() { this->SetMethod(PROJECTION_METHOD); }
  void SetMethodToCells() { this->SetMethod(CELLS_METHOD); }
  void SetMethodToRays() { this->SetMethod(RAY_METHOD); }
  void SetMethodToAutomatic() { this->SetMethod(AUTOMATIC_METHOD); }
  void SetMethodToTrianglesLinear() { this->SetMethod(TRIANGLES_LINEAR_METHOD); }
  void SetMethodToTrianglesTable() { this->SetMethod(TRIANGLES_TABLE_METHOD); }
  void SetMethodToFaces() { this->SetMethod(FACES_METHOD); }
  ///@}

  enum IntegrationType
  {
    EXACT_INTEGRATION = 0,
    AVERAGE_INTEGRATION = 1
  };
  ///@{
  /**
   * Integration of a ray segment inside a tetrahedron. Default: exact.
   * - Exact: extinction and colour vary linearly along the segment (Williams and Max); the error is
   *   that of float arithmetic, about 1e-6.
   * - Average: the paper's rule, colour = mean of the two ends. Its transparency is exact too; its
   *   colour is wrong by up to half the colour difference when the optical depth of a cell is
   *   large.
   */
  vtkSetClampMacro(Integration, int, EXACT_INTEGRATION, AVERAGE_INTEGRATION);
  vtkGetMacro(Integration, int);
  void SetIntegrationToExact() { this->SetIntegration(EXACT_INTEGRATION); }
  void SetIntegrationToAverage() { this->SetIntegration(AVERAGE_INTEGRATION); }
  ///@}

  enum CellInterpolationType
  {
    TETRAHEDRA_INTERPOLATION = 0,
    TRILINEAR_INTERPOLATION = 1,
    AUTOMATIC_INTERPOLATION = 2
  };
  ///@{
  /**
   * The scalar inside hexahedra, voxels, wedges and pyramids, where it belongs to points. Default:
   * automatic.
   * - Automatic: trilinear, except in unstructured meshes of which more than half of the cells are
   *   tetrahedra, and in pieces of vtkContourCellSplitter. Those are trilinear too if the
   *   tetrahedra of some cells would overlap.
   * - Tetrahedra: linear in the tetrahedra into which cells are divided: hexahedra with alternating
   *   diagonals, the same in structured and unstructured data; by coordinates in meshes with other
   *   cells among them or with rings of an odd number of cells.
   * - Trilinear: the field of VTK's cells, which favours no diagonal, however the cells are stored.
   *   Along a ray it is cut into pieces that are linear to within 1/512 of the scalar's range.
   *   Unstructured cells then need no list of tetrahedra. It requires rays, and excludes layers,
   *   polygons and cells of other kinds; otherwise cells are drawn as tetrahedra.
   */
  vtkSetClampMacro(CellInterpolation, int, TETRAHEDRA_INTERPOLATION, AUTOMATIC_INTERPOLATION);
  vtkGetMacro(CellInterpolation, int);
  void SetCellInterpolationToTetrahedra() { this->SetCellInterpolation(TETRAHEDRA_INTERPOLATION); }
  void SetCellInterpolationToTrilinear() { this->SetCellInterpolation(TRILINEAR_INTERPOLATION); }
  void SetCellInterpolationToAutomatic() { this->SetCellInterpolation(AUTOMATIC_INTERPOLATION); }
  ///@}

  enum VisibilityOrderType
  {
    EXACT_ORDER = 0,
    CENTROID_ORDER = 1,
    NO_ORDER = 2
  };
  ///@{
  /**
   * The order in which the method Projection composites tetrahedra; rays always use the exact
   * order. Default: exact.
   * - Exact: rays, if the method is Automatic. Projection sorts topologically: across each shared
   *   face, the tetrahedron on the eye's side is in front. This order is exact for convex meshes
   *   without cycles of tetrahedra that hide one another; GetNumberOfVisibilityCycles() counts
   *   these. Tetrahedra on both sides of a gap in the mesh have no defined order.
   * - Centroid: by distance of the centroid; local errors.
   * - None: input order. Correct if the colour is constant, because transparency does not depend on
   *   order. The mapper detects this case and then sorts nothing, whatever is set here; see
   *   GetOrderIndependent().
   * With Centroid and None, Automatic projects.
   */
  vtkSetClampMacro(VisibilityOrder, int, EXACT_ORDER, NO_ORDER);
  vtkGetMacro(VisibilityOrder, int);
  void SetVisibilityOrderToExact() { this->SetVisibilityOrder(EXACT_ORDER); }
  void SetVisibilityOrderToCentroid() { this->SetVisibilityOrder(CENTROID_ORDER); }
  void SetVisibilityOrderToNone() { this->SetVisibilityOrder(NO_ORDER); }
  ///@}

  /**
   * Whether the last picture would be the same with the cells in any order: the colour function is
   * constant to within 1/4096 over the visible range of the coloured array; there are no contour
   * surfaces and no layers, no translucent surfaces were interleaved by peeling, and the method is
   * not Faces. Extinction may vary and cells may overlap in space: transmittances multiply. Nothing
   * is then sorted. (Cells of one colour between peeled surfaces are not sorted either; the
   * surfaces keep their order.) False before the first render.
   */
  bool GetOrderIndependent();

  ///@{
  /**
   * Multiplies the extinction coefficient, >= 0. Default: 1. Changes take effect without delay.
   */
  vtkSetClampMacro(OpacityScale, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(OpacityScale, double);
  ///@}

  /**
   * The ScalarOpacityUnitDistance that gives rays through the input a mean optical depth of 2 with
   * the property's opacity function, scaled to reach 1: the mean length of a ray inside the data
   * times the mean opacity over their volume, divided by 2. It depends on the size and thickness of
   * the data, but hardly on the number of cells. A few distant outliers are ignored. 0 if nothing
   * is opaque, or there is nothing to draw.
   * Hosts use it if the user has not set a length. Cost: one pass over the cells.
   */
  double FindUnitDistance(vtkVolumeProperty* property);

  ///@{
  /**
   * Name of the array for opacity, if it differs from the array for colour: for example clouds
   * coloured by altitude. Point data or cell data, one component (the magnitude of a vector). Empty
   * (default): the colour array.
   */
  vtkSetMacro(OpacityArrayName, std::string);
  vtkGetMacro(OpacityArrayName, std::string);
  ///@}

  ///@{
  /**
   * Splits each ray segment where the scalar crosses a control point of the transfer functions, so
   * that a piecewise-linear transfer function is integrated exactly. Default: on. Off: the transfer
   * function is assumed linear between its values at the two ends of the segment, which is faster
   * if it has many points.
   */
  vtkSetMacro(SplitAtControlPoints, bool);
  vtkGetMacro(SplitAtControlPoints, bool);
  vtkBooleanMacro(SplitAtControlPoints, bool);
  ///@}

  ///@{
  /**
   * Draws only as many rays while the camera moves as the DesiredUpdateRate of the render window
   * allows. Interactors, widgets and ParaView raise this rate while the user drags, and lower it
   * afterwards, so that a picture at rest has a ray for each pixel. The image between the rays is
   * interpolated. Default: on, at most 8 pixels from ray to ray (1 to 16, clamped).
   * This applies to rays only, and not when volumes are peeled. Names and meaning are those of
   * vtkFixedPointVolumeRayCastMapper.
   */
  vtkSetMacro(AutoAdjustSampleDistances, bool);
  vtkGetMacro(AutoAdjustSampleDistances, bool);
  vtkBooleanMacro(AutoAdjustSampleDistances, bool);
  vtkSetClampMacro(MaximumImageSampleDistance, double, 1.0, 16.0);
  vtkGetMacro(MaximumImageSampleDistance, double);
  ///@}
  ///@{
  /**
   * Pixels from ray to ray when AutoAdjustSampleDistances is off, 1 to 16 (clamped). Default: 1.
   */
  vtkSetClampMacro(ImageSampleDistance, double, 1.0, 16.0);
  vtkGetMacro(ImageSampleDistance, double);
  ///@}
  /** The distance in the last render; 1 if rays were not used. */
  double GetLastImageSampleDistance();

  ///@{
  /**
   * What is visible of the cells at a pixel of the window, counted from its lower left, as the last
   * render drew them: the position along the pixel's ray at which the accumulated opacity of medium
   * and contour surfaces reaches PickOpacity. More transparent veils in front are ignored. The ray
   * ends at opaque geometry and clipping planes, as when drawing; polygons and other volumes are
   * not counted. False, and -1 for cell and point, if the ray never becomes so opaque.
   * Position in world coordinates; numbers of the cell and of its nearest point, in the input; the
   * coloured scalar there.
   * Reads the depth buffer. Cost: as of one pass over the cells.
   */
  bool Pick(vtkRenderer* renderer, double x, double y);
  vtkGetVector3Macro(PickPosition, double);
  vtkGetMacro(PickedCell, vtkIdType);
  vtkGetMacro(PickedPoint, vtkIdType);
  vtkGetMacro(PickedScalar, double);
  ///@}

  /**
   * Light that follows the camera (vtkSunlight) is clamped to this value: 64 times that of a white
   * surface.
   */
  static double GetBrightestCameraLight();

  ///@{
  /**
   * Opacity, from the eye on, at which the medium is picked, 0.001 to 0.999 (clamped). Default:
   * 0.1.
   */
  void SetPickOpacity(double opacity);
  vtkGetMacro(PickOpacity, double);
  ///@}

  ///@{
  /**
   * Names of integer arrays of the input with what vtkHardwareSelector reports instead of the
   * numbers of cells and points: numbers in other data, the composite index (cell data) and the
   * process (cell data, for selectors that read it from the data). Empty (default): the numbers in
   * the input, 0 and this process. If a named array is missing, or its value negative, nothing is
   * found. The names are those of vtkOpenGLPolyDataMapper.
   */
  vtkSetMacro(CellIdArrayName, std::string);
  vtkGetMacro(CellIdArrayName, std::string);
  vtkSetMacro(PointIdArrayName, std::string);
  vtkGetMacro(PointIdArrayName, std::string);
  vtkSetMacro(CompositeIdArrayName, std::string);
  vtkGetMacro(CompositeIdArrayName, std::string);
  vtkSetMacro(ProcessIdArrayName, std::string);
  vtkGetMacro(ProcessIdArrayName, std::string);
  ///@}

  /** Tetrahedra of the current input, visible or not. Valid after a render. */
  vtkIdType GetNumberOfTetrahedra();
  /**
   * Tetrahedra drawn in the last render: those that the transfer function does not make fully
   * transparent.
   */
  vtkIdType GetNumberOfDrawnTetrahedra();
  /**
   * Number of passes over the picture in the last render: at least the maximum number of times that
   * a ray entered the mesh. Meshes with many gaps behind one another take long. 0: rays were not
   * used, or none entered.
   */
  int GetNumberOfRayLayers();
  ///@{
  /**
   * Defects of the last order of the method Projection, if VisibilityOrder is Exact: the number of
   * groups of tetrahedra that occlude one another in a cycle, so that no order is correct; their
   * members; and the relations across faces that are drawn in the wrong order for this reason. 0
   * with all other methods and orders: rays are exact without an order.
   */
  vtkIdType GetNumberOfVisibilityCycles();
  vtkIdType GetNumberOfCyclicTetrahedra();
  vtkIdType GetNumberOfBrokenRelations();
  ///@}

  /**
   * Copies the float image of the last render into `image`: one layer of the viewport's size
   * (smaller by the distance between rays) with the point array "RGBA" (four float components,
   * colour premultiplied by alpha), before it was composited over the scene.
   * Returns false (and reports an error) if nothing has been rendered yet, or if the last render
   * peeled volumes, whose light is added to the picture in parts between the surfaces.
   */
  bool CopyFloatImage(vtkImageData* image);

  /**
   * Draws the volume. For a selector of the renderer (vtkHardwareSelector) it draws the numbers of
   * what Pick() finds at each pixel of the selector's area instead. While building geometry,
   * neighbours or order, it invokes ProgressEvent several times a second and stops when
   * AbortExecute is set or the window aborts; the next render completes the work.
   */
  void Render(vtkRenderer* renderer, vtkVolume* volume) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  /**
   * Copies the input and all settings. Clipping planes and layer properties are shared; their lists
   * are copied.
   */
  void ShallowCopy(vtkAbstractMapper* other) override;

protected:
  vtkCellCompositingMapper();
  ~vtkCellCompositingMapper() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;

  int Method = AUTOMATIC_METHOD;
  int Integration = EXACT_INTEGRATION;
  int CellInterpolation = AUTOMATIC_INTERPOLATION;
  int VisibilityOrder = EXACT_ORDER;
  double OpacityScale = 1.0;
  std::string OpacityArrayName;
  bool SplitAtControlPoints = true;
  bool AutoAdjustSampleDistances = true;
  double ImageSampleDistance = 1.0, MaximumImageSampleDistance = 8.0;

  double PickOpacity = 0.1, PickedScalar = 0, PickPosition[3] = { 0, 0, 0 };
  vtkIdType PickedCell = -1, PickedPoint = -1;
  std::string CellIdArrayName, PointIdArrayName, CompositeIdArrayName, ProcessIdArrayName;

private:
  bool HasSurfacesOrLayers() const;
  bool HasPolygonsOrLayers() const;
  bool DrawsTrianglesOrFaces() const;
  std::string ChooseWayOfDrawing(vtkOpenGLRenderWindow* window);
  bool MayCrossWholeCells() const;
  bool IsTrilinear() const;
  bool UsesRays() const;
  bool NeedsNoOrder() const;
  std::string UpdateGeometry(
    vtkDataSet* input, vtkVolume* volume, const nephoscope::Progress& progress);
  std::string SelectContours(vtkDataSet* input, const nephoscope::ScalarSelection& scalars,
    nephoscope::ScalarSelection& contoured);
  std::string SelectLayers(vtkDataSet* input, vtkDataArray*& layers);
  void WarnAboutInterpolation(vtkDataSet* input, const nephoscope::CellGeometry& geometry);
  void WarnAboutGeometry(vtkDataSet* input, const nephoscope::CellGeometry& geometry,
    const nephoscope::ScalarSelection& scalars, const nephoscope::ScalarSelection& opacity);
  void WarnAboutFolds(vtkDataSet* input, const nephoscope::CellGeometry& geometry);
  void WarnAboutContours(const std::string& reason);
  void WarnAboutContourValues();
  void WarnAboutPolygons();
  std::string CheckSettings(vtkVolumeProperty* property);
  void SetDrawingOptions(vtkRenderer* renderer, vtkVolumeProperty* property);
  bool Prepare(vtkOpenGLRenderWindow* window, vtkRenderer* renderer, vtkVolume* volume);
  std::string PrepareScene(vtkOpenGLRenderWindow* window, vtkRenderer* renderer, vtkVolume* volume,
    const nephoscope::Progress& progress);
  std::string DrawScene(vtkOpenGLRenderWindow* window, vtkVolume* volume);
  struct vtkMedium;
  friend struct nephoscope::CellsInOrder;
  void DrawInOrder(vtkRenderer* renderer, vtkVolume* volume);
  void DrawSelection(vtkRenderer* renderer, vtkVolume* volume);
  void PickArea(vtkRenderer* renderer, vtkVolume* volume, const unsigned int corners[4]);
  vtkDataSet* GetPickedField();
  double GetPickedExtinctionScale(vtkVolume* volume) const;
  std::vector<vtkMedium> FindMedia(
    vtkOpenGLRenderWindow* window, vtkRenderer* renderer, vtkVolume* volume);
  void DrawMedia(vtkOpenGLRenderWindow* window, const std::vector<vtkMedium>& media);
  void DrawInTime(vtkOpenGLRenderWindow* window, const std::vector<vtkMedium>& media);
  std::string ReasonToBeAlone(vtkOpenGLRenderWindow* window);
  void WarnAboutMedia(int kind, const std::string& warning);
  bool UpdateOrder(const std::array<double, 4>& eye, const nephoscope::Progress& progress);
  std::string Upload(vtkOpenGLRenderWindow* window);
  void WarnAboutUnprojected(vtkIdType count);
  void ReportOnce(const std::string& error);

  vtkCellCompositingMapper(const vtkCellCompositingMapper&) = delete;
  void operator=(const vtkCellCompositingMapper&) = delete;

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
