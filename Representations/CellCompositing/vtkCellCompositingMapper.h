// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkCellCompositingMapper
 * @brief Direct volume rendering of polyhedral cells with the exact ray integral
 *
 * Every 3-D cell of the input is taken as convex and is divided, while drawing, into tetrahedra over
 * which the scalar is linear. For each pixel that a tetrahedron covers, the fragment shader finds where
 * the ray enters and leaves it, looks the transfer functions up in float, and integrates emission
 * and extinction between the two ends to float accuracy. The tetrahedra are composited back to front, in an
 * exact visibility order, into a 32-bit float image that is laid over the scene.
 *
 * - Extinction per unit world length = opacity function value * OpacityScale / ScalarOpacityUnitDistance
 *   (a rate, as VTK's other unstructured volume mappers have it, not -log(1 - opacity)).
 * - The colour function is the source colour (emission coefficient divided by extinction).
 * - Point and cell scalars; tetrahedra, hexahedra, voxels, wedges, pyramids, convex polyhedra.
 * - Any vtkDataSet with 3-D cells is accepted; image data need not be converted.
 * - Cells that a ghost array marks as duplicate, refined or hidden are not drawn.
 * - Opaque geometry that cuts a cell ends its integral at the opaque depth, per pixel.
 *
 * References: N. Max, R. Crawfis, B. Becker, New Techniques in 3D Scalar and Vector Field Visualization,
 * Pacific Graphics 1993, section 2 (MaxCrawfisBecker1993); P. Shirley, A. Tuchman, A Polygonal Approximation to
 * Direct Scalar Volume Rendering, 1990 (ShirleyTuchman1990); P. Williams, N. Max, A Volume Density Optical
 * Model, 1992 (WilliamsMax1992).
 */
#ifndef vtkCellCompositingMapper_h
#define vtkCellCompositingMapper_h

#include "vtkNephoscopeRepresentationsCellCompositingModule.h" // for export macro
#include "vtkUnstructuredGridVolumeMapper.h"

#include <memory> // for std::unique_ptr
#include <string> // for messages

class vtkImageData;
class vtkOpenGLRenderWindow;
class vtkVolumeProperty;

namespace nephoscope
{
class Progress;
struct ScalarSelection;
}

class VTKNEPHOSCOPEREPRESENTATIONSCELLCOMPOSITING_EXPORT vtkCellCompositingMapper
  : public vtkUnstructuredGridVolumeMapper
{
public:
  static vtkCellCompositingMapper* New();
  vtkTypeMacro(vtkCellCompositingMapper, vtkUnstructuredGridVolumeMapper);
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
    RAY_METHOD = 1,
    AUTOMATIC_METHOD = 5
  };
  ///@{
  /**
   * How cells are drawn. Default: automatic.
   * - Rays: every pixel walks through the mesh from cell to cell, front to back. The order is exact for every mesh, with cycles, holes
   *   and separate parts, whatever VisibilityOrder says.
   * - Projection: cell after cell in the order that VisibilityOrder tells, each over the pixels that it covers.
   * - Automatic: rays where VisibilityOrder is exact, projection otherwise.
   */
  vtkSetClampMacro(Method, int, PROJECTION_METHOD, AUTOMATIC_METHOD);
  vtkGetMacro(Method, int);
  void SetMethodToProjection() { this->SetMethod(PROJECTION_METHOD); }
  void SetMethodToRays() { this->SetMethod(RAY_METHOD); }
  void SetMethodToAutomatic() { this->SetMethod(AUTOMATIC_METHOD); }
  ///@}

  enum IntegrationType
  {
    EXACT_INTEGRATION = 0,
    AVERAGE_INTEGRATION = 1
  };
  ///@{
  /**
   * How a ray segment inside a tetrahedron is integrated. Default: exact.
   * - Exact: extinction and colour vary linearly along the segment (Williams and Max); the error is that of
   *   float arithmetic, about 1e-6.
   * - Average: the paper's rule, colour = mean of the two ends. Its transparency is exact too; its colour is
   *   wrong by up to half the colour difference when the optical depth of a cell is large.
   */
  vtkSetClampMacro(Integration, int, EXACT_INTEGRATION, AVERAGE_INTEGRATION);
  vtkGetMacro(Integration, int);
  void SetIntegrationToExact() { this->SetIntegration(EXACT_INTEGRATION); }
  void SetIntegrationToAverage() { this->SetIntegration(AVERAGE_INTEGRATION); }
  ///@}

  enum VisibilityOrderType
  {
    EXACT_ORDER = 0,
    CENTROID_ORDER = 1,
    NO_ORDER = 2
  };
  ///@{
  /**
   * The order in which tetrahedra are composited. Default: exact.
   * - Exact: topological sort over shared faces, and over the gaps where a ray leaves the mesh and enters it again;
   *   right for every mesh, convex or not. Tetrahedra that hide one another in a cycle are cut, for this view,
   *   until their pieces have an order; GetNumberOfVisibilityCycles() tells that it happened.
   * - Centroid: by distance of the centroid; cheaper, with local mistakes.
   * - None: input order. Right when the colour is constant, because transparency does not depend on order.
   */
  vtkSetClampMacro(VisibilityOrder, int, EXACT_ORDER, NO_ORDER);
  vtkGetMacro(VisibilityOrder, int);
  void SetVisibilityOrderToExact() { this->SetVisibilityOrder(EXACT_ORDER); }
  void SetVisibilityOrderToCentroid() { this->SetVisibilityOrder(CENTROID_ORDER); }
  void SetVisibilityOrderToNone() { this->SetVisibilityOrder(NO_ORDER); }
  ///@}

  ///@{
  /**
   * Factor on the extinction, >= 0, dimensionless. Default: 1. Costs nothing to change.
   */
  vtkSetClampMacro(OpacityScale, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(OpacityScale, double);
  ///@}

  ///@{
  /**
   * Name of the array that the opacity function reads, where it is not the one that gives the colour: clouds coloured by
   * altitude, say. Point data or cell data, one component (the magnitude of a vector). Empty (default): the colour array.
   */
  vtkSetMacro(OpacityArrayName, std::string);
  vtkGetMacro(OpacityArrayName, std::string);
  ///@}

  ///@{
  /**
   * Split each ray segment where the scalar crosses a control point of the transfer functions, so that a
   * piecewise-linear transfer function is integrated exactly. Default: on. Off: the transfer function is taken as
   * linear between its values at the two ends of the segment, which is faster when it has many points.
   */
  vtkSetMacro(SplitAtControlPoints, bool);
  vtkGetMacro(SplitAtControlPoints, bool);
  vtkBooleanMacro(SplitAtControlPoints, bool);
  ///@}

  /** Tetrahedra of the current input, visible or not. Valid after a render. */
  vtkIdType GetNumberOfTetrahedra();
  /** Tetrahedra drawn in the last render: those that the transfer function does not make fully transparent. */
  vtkIdType GetNumberOfDrawnTetrahedra();
  ///@{
  /**
   * Cycles of visibility in the last view, whether or not they were drawn right: groups of tetrahedra in which each hides
   * another and is itself hidden, so that no order of whole tetrahedra is right. 0: there is such an order.
   * GetNumberOfCyclicTetrahedra() counts the members of all groups. Always 0 for the orders centroid and none.
   * Computed when asked for, where drawing did not need it.
   */
  vtkIdType GetNumberOfVisibilityCycles();
  vtkIdType GetNumberOfCyclicTetrahedra();
  ///@}
  /**
   * Relations between tetrahedra that the last picture shows in the wrong order, because cutting all cycles would have
   * taken more than 2^20 pieces. Otherwise 0. Always 0 for the orders centroid and none.
   */
  vtkIdType GetNumberOfBrokenRelations();

  /**
   * Copies the float image of the last render into `image`: one layer of the viewport's size with the point array
   * "RGBA", four float components, colour premultiplied by alpha, before it was laid over the scene.
   * Returns false (and reports an error) when nothing was rendered yet.
   */
  bool CopyFloatImage(vtkImageData* image);

  /**
   * Draws. While geometry and order are made, invokes ProgressEvent several times a second and stops when AbortExecute is set or
   * the window aborts; what is missing then is made in the next render.
   */
  void Render(vtkRenderer* renderer, vtkVolume* volume) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkCellCompositingMapper();
  ~vtkCellCompositingMapper() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;

  int Method = AUTOMATIC_METHOD;
  int Integration = EXACT_INTEGRATION;
  int VisibilityOrder = EXACT_ORDER;
  double OpacityScale = 1.0;
  std::string OpacityArrayName;
  bool SplitAtControlPoints = true;

private:
  bool UsesRays() const;
  std::string FindObstacle(vtkDataSet* input, vtkVolume* volume);
  std::string UpdateGeometry(vtkDataSet* input, vtkVolume* volume, const nephoscope::Progress& progress);
  std::string SelectScalars(
    vtkDataSet* input, vtkVolumeProperty* property, nephoscope::ScalarSelection& scalars);
  std::string SelectOpacity(vtkDataSet* input, const nephoscope::ScalarSelection& scalars,
    nephoscope::ScalarSelection& opacity);
  void WarnAboutGeometry(const char* arrayName);
  std::string DrawScene(vtkOpenGLRenderWindow* window, vtkRenderer* renderer, vtkVolume* volume,
    const nephoscope::Progress& progress);
  std::string Upload(vtkOpenGLRenderWindow* window);
  void ReportOnce(const std::string& error);

  vtkCellCompositingMapper(const vtkCellCompositingMapper&) = delete;
  void operator=(const vtkCellCompositingMapper&) = delete;

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
