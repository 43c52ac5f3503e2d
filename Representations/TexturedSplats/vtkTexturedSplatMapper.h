// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTexturedSplatMapper
 * @brief   samples of a scalar field drawn as splats in the shape of their grid cells
 *
 * Every sample is a kernel of unit integral, stretched to its grid cell. What a ray meets of it is integrated exactly, for
 * every cell shape and for parallel and perspective views: alpha = 1 - exp(-extinction * footprint). The product of what splats
 * let through is the exact transparency of the reconstructed field in any order; colours are composited from back to front, in an
 * order that is found once per view and does not depend on the order of the input.
 *
 * Vectors are drawn on the splats as streaks along their projection, foreshortened, that move with them: a splat's streaks lie in
 * the middle of its medium, so that the two partly hide each other.
 *
 *     vtkDataSet ──► samples: place, Jacobian, value ──► colour, extinction ──► order ──► splats, blended in float
 *
 * Samples are points, or the centres of cells where the data are on cells, of any dataset. Structured grids give each its cell by
 * central differences; other points are balls. To be used with vtkVolume and vtkVolumeProperty; extinction is the
 * opacity function's value over ScalarOpacityUnitDistance, a rate per length, as in vtkCellCompositingMapper.
 *
 * References: R. Crawfis, N. Max, Texture Splats for 3D Scalar and Vector Field Visualization, IEEE Visualization 1993
 * (CrawfisMax1993); N. Max, R. Crawfis, B. Becker, New Techniques in 3D Scalar and Vector Field Visualization, Pacific
 * Graphics 1993, section 3 (MaxCrawfisBecker1993).
 */
#ifndef vtkTexturedSplatMapper_h
#define vtkTexturedSplatMapper_h

#include "vtkAbstractVolumeMapper.h"
#include "vtkNephoscopeRepresentationsTexturedSplatsModule.h" // for export macro

#include <memory> // for std::unique_ptr
#include <string> // for array names

class vtkImageData;
class vtkOpenGLRenderWindow;

class VTKNEPHOSCOPEREPRESENTATIONSTEXTUREDSPLATS_EXPORT vtkTexturedSplatMapper
  : public vtkAbstractVolumeMapper
{
public:
  static vtkTexturedSplatMapper* New();
  vtkTypeMacro(vtkTexturedSplatMapper, vtkAbstractVolumeMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** The data to draw. */
  void SetInputData(vtkDataSet* data);

  enum KernelType
  {
    CUBIC_KERNEL = 0,
    QUADRATIC_KERNEL = 1,
    GAUSSIAN_KERNEL = 2
  };
  ///@{
  /**
   * The reconstruction kernel. Default: cubic.
   * - Cubic: for samples in space. Constant data on a lattice are drawn flat to within 0.6 % from any direction.
   * - Quadratic: for the samples of one flat sheet, seen from the front; flat to within 0.5 %.
   * - Gaussian: of the cubic kernel's variance, for comparison.
   */
  vtkSetClampMacro(Kernel, int, CUBIC_KERNEL, GAUSSIAN_KERNEL);
  vtkGetMacro(Kernel, int);
  void SetKernelToCubic() { this->SetKernel(CUBIC_KERNEL); }
  void SetKernelToQuadratic() { this->SetKernel(QUADRATIC_KERNEL); }
  void SetKernelToGaussian() { this->SetKernel(GAUSSIAN_KERNEL); }
  ///@}

  ///@{
  /**
   * For samples without a grid: edge of the cube that each stands for, in units of length of the data; the splat's own radius is 1.56
   * times as long. 0 (default): the mean spacing of the samples. Ignored on structured grids.
   */
  vtkSetClampMacro(CellSize, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(CellSize, double);
  ///@}

  ///@{
  /** Factor on the extinction, >= 0. Default: 1. Costs nothing to change. */
  vtkSetClampMacro(OpacityScale, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(OpacityScale, double);
  ///@}

  ///@{
  /** Name of the array that the opacity function reads, where it is not the one that gives the colour. Default: empty. */
  vtkSetMacro(OpacityArrayName, std::string);
  vtkGetMacro(OpacityArrayName, std::string);
  ///@}

  ///@{
  /**
   * Name of the array of vectors (three components, on points or cells as the coloured array) that are drawn on the splats, as
   * streaks along their projection. Empty (default): no vectors. Give an opacity function of 0 to draw the vectors alone.
   */
  vtkSetMacro(VectorArrayName, std::string);
  vtkGetMacro(VectorArrayName, std::string);
  ///@}

  ///@{
  /** Optical depth of the streaks on the fastest splat; in proportion to the speed on others. Default: 2. */
  vtkSetClampMacro(VectorOpacity, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(VectorOpacity, double);
  ///@}

  ///@{
  /**
   * Speed, in the units of the vectors, at and above which streaks are fully drawn. 0 (default): the greatest of the data.
   */
  vtkSetClampMacro(GreatestSpeed, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(GreatestSpeed, double);
  ///@}

  ///@{
  /** Length of the pattern along the vector, in cells (the cube root of a cell's volume). Default: 1.5. */
  vtkSetClampMacro(StreakPeriod, double, 0.01, 1000.0);
  vtkGetMacro(StreakPeriod, double);
  ///@}

  ///@{
  /** Colour of the streaks where UseVectorColor is on, 0 to 1 each. Default: white. Off (default): the splat's colour. */
  vtkSetVector3Macro(VectorColor, double);
  vtkGetVector3Macro(VectorColor, double);
  vtkSetMacro(UseVectorColor, bool);
  vtkGetMacro(UseVectorColor, bool);
  vtkBooleanMacro(UseVectorColor, bool);
  ///@}

  ///@{
  /**
   * Where in a loop the patterns are, 0 to 1; 1 is 0 again. Over a loop each pattern moves a whole number of periods, nearest to
   * PhaseCycles (default 4) times its share of the greatest speed: for pictures that repeat. For motion at exactly the speed of the data
   * use AdvancePhases.
   */
  vtkSetMacro(Phase, double);
  vtkGetMacro(Phase, double);
  vtkSetClampMacro(PhaseCycles, int, 1, 1000);
  vtkGetMacro(PhaseCycles, int);
  ///@}

  /**
   * Moves every pattern on by a time, in the time unit of the vectors: at the speed of its own vector, without a jump when the
   * vectors change. The vectors are those of the last render.
   */
  void AdvancePhases(double time);

  /** Splats drawn in the last render. */
  vtkIdType GetNumberOfDrawnSplats();

  /** Bounds of the splats, which reach beyond the samples. */
  double* GetBounds() VTK_SIZEHINT(6) override;

  /** The float image of the last render, as the point array "RGBA", colour premultiplied; false, and an error, if there is none. */
  bool CopyFloatImage(vtkImageData* image);

  void Render(vtkRenderer* renderer, vtkVolume* volume) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkTexturedSplatMapper();
  ~vtkTexturedSplatMapper() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;

  int Kernel = CUBIC_KERNEL;
  double CellSize = 0.0;
  double OpacityScale = 1.0;
  std::string OpacityArrayName;
  std::string VectorArrayName;
  double VectorOpacity = 2.0;
  double GreatestSpeed = 0.0;
  double StreakPeriod = 1.5;
  double VectorColor[3] = { 1.0, 1.0, 1.0 };
  bool UseVectorColor = false;
  double Phase = 0.0;
  int PhaseCycles = 4;

private:
  std::string UpdateVectors(vtkDataSet* input, bool onCells);
  std::string UpdateSplats(vtkDataSet* input, vtkVolume* volume);
  std::string DrawScene(vtkOpenGLRenderWindow* window, vtkRenderer* renderer, vtkVolume* volume);
  std::string Upload(vtkOpenGLRenderWindow* window);
  void ReportOnce(const std::string& error);

  vtkTexturedSplatMapper(const vtkTexturedSplatMapper&) = delete;
  void operator=(const vtkTexturedSplatMapper&) = delete;

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
