// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTexturedSplatMapper
 * @brief   samples of a scalar field drawn as splats in the shape of their grid cells
 *
 * Every sample is a kernel of unit integral, stretched to its grid cell. Its integral along a ray
 * is exact, for every cell shape and for parallel and perspective views: alpha = 1 -
 * exp(-extinction * footprint). The product of the splats' transmittances is the exact
 * transmittance of the reconstructed field, in any order. Colours are composited from back to
 * front, in an order that is computed once per view and does not depend on the order of the input.
 *
 * Vectors are drawn on the splats as line segments, or as streaks that lie along their projection,
 * foreshortened, and move with them. They are in the middle of a splat's medium, so that the two
 * partly hide each other, or are drawn layer by layer. vtkSplatVectorMapper has their settings.
 *
 *     vtkDataSet ──► samples: position, Jacobian, value ──► colour, extinction
 *         ──► order ──► splats, blended in float
 *
 * Samples are the points of any dataset, or the centres of its cells for cell arrays. On structured
 * grids each sample gets the shape of its cell by central differences; other points are balls. To
 * be used with vtkVolume and vtkVolumeProperty; extinction is the opacity function's value over
 * ScalarOpacityUnitDistance, a rate per length, as in vtkCellCompositingMapper.
 *
 * References: R. Crawfis, N. Max, Texture Splats for 3D Scalar and Vector Field Visualization, IEEE
 * Visualization 1993 (CrawfisMax1993); N. Max, R. Crawfis, B. Becker, New Techniques in 3D Scalar
 * and Vector Field Visualization, Pacific Graphics 1993, section 3 (MaxCrawfisBecker1993).
 */
#ifndef vtkTexturedSplatMapper_h
#define vtkTexturedSplatMapper_h

#include "vtkNephoscopeRepresentationsTexturedSplatsModule.h" // for export macro
#include "vtkSplatVectorMapper.h"
#include "vtkWeakPointer.h" // for other mappers

#include <memory> // for std::unique_ptr
#include <string> // for array names
#include <vector> // for other mappers

class vtkDataArray;
class vtkImageData;
class vtkOpenGLRenderWindow;
class vtkVolumeProperty;
namespace nephoscope
{
class SplatVectorScene;
class DepthTiles;
struct SplatDrawingOptions;
struct SplatSampling;
struct SplatVectorSettings;
struct ViewState;
}

class VTKNEPHOSCOPEREPRESENTATIONSTEXTUREDSPLATS_EXPORT vtkTexturedSplatMapper
  : public vtkSplatVectorMapper
{
public:
  static vtkTexturedSplatMapper* New();
  vtkTypeMacro(vtkTexturedSplatMapper, vtkSplatVectorMapper);
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
   * - Cubic: for samples in space. Constant data on a lattice are drawn flat to within 0.6 % from
   *   any direction.
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
   * For samples without a grid: edge length of the cube that each represents, in units of length of
   * the data; the splat's own radius is 1.56 times as long. 0 (default): found from the data, see
   * CellSizeFromCells and CellSizeFromNeighbors, otherwise the mean spacing of all samples without
   * a few distant outliers. Ignored on structured grids.
   */
  vtkSetClampMacro(CellSize, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(CellSize, double);
  ///@}

  ///@{
  /**
   * Name of an array (one component, on points or cells like the coloured array) with the CellSize
   * of every sample, in units of length of the data, or with its volume if
   * CellSizeArrayHoldsVolumes is on (default: off). Samples whose size is not a positive number are
   * not drawn. Empty (default): none. Ignored on structured grids.
   */
  vtkSetMacro(CellSizeArrayName, std::string);
  vtkGetMacro(CellSizeArrayName, std::string);
  vtkSetMacro(CellSizeArrayHoldsVolumes, bool);
  vtkGetMacro(CellSizeArrayHoldsVolumes, bool);
  vtkBooleanMacro(CellSizeArrayHoldsVolumes, bool);
  ///@}

  ///@{
  /**
   * For unstructured cells without sizes. On (default): each point becomes an ellipsoid with its
   * fraction of the surrounding cells, and each cell one with its volume and proportions (for
   * surfaces: a ball with that area); constant data look constant on cells of any size. Off: all
   * samples have the mean spacing.
   */
  vtkSetMacro(CellSizeFromCells, bool);
  vtkGetMacro(CellSizeFromCells, bool);
  vtkBooleanMacro(CellSizeFromCells, bool);
  ///@}

  ///@{
  /**
   * For points without cells and sizes. On: each point has the mean spacing of its twelve nearest
   * neighbours, so that a field is drawn evenly where it is sampled densely and where it is sampled
   * sparsely. Off (default): all points have the mean spacing, so that more particles look denser.
   */
  vtkSetMacro(CellSizeFromNeighbors, bool);
  vtkGetMacro(CellSizeFromNeighbors, bool);
  vtkBooleanMacro(CellSizeFromNeighbors, bool);
  ///@}

  ///@{
  /**
   * Multiplies the width of splats, on any data; the extinction is divided by its cube, so that the
   * mass is conserved. 1 (default): constant data look constant. Larger values blur the field, fill
   * gaps between particles and cost more; smaller values show individual splats. The optical depth
   * of vectors stays that of each splat. 0.01 to 100.
   */
  vtkSetClampMacro(RadiusFactor, double, 0.01, 100.0);
  vtkGetMacro(RadiusFactor, double);
  ///@}

  ///@{
  /**
   * Name of an array (nine or ten components, on points or cells like the coloured array) with the
   * shape of every sample: the three edge vectors of the cell that it represents, in units of
   * length of the data. A tenth component is the fraction of that cell that lies within the data,
   * by which the extinction is multiplied, 0 to 1. Empty (default), or if the array does not exist:
   * the cells of the grid, or CellSize.
   */
  vtkSetMacro(ShapeArrayName, std::string);
  vtkGetMacro(ShapeArrayName, std::string);
  ///@}

  ///@{
  /** Multiplies the extinction coefficient, >= 0. Default: 1. Changes take effect without delay. */
  vtkSetClampMacro(OpacityScale, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(OpacityScale, double);
  ///@}

  /**
   * The ScalarOpacityUnitDistance that gives rays through the input a mean optical depth of 2 with
   * the property's opacity function, scaled to reach 1: the mean length of a ray inside the data
   * times the mean opacity over their volume, divided by 2. It depends on the size and thickness of
   * the data, but hardly on the number of samples. A few distant outliers are ignored. 0 if nothing
   * is opaque, or there is nothing to draw.
   * Hosts use it if the user has not set a length. Cost: one pass over the samples.
   */
  double FindUnitDistance(vtkVolumeProperty* property);

  ///@{
  /** Name of the array for opacity, if it differs from the array for colour. Default: empty. */
  vtkSetMacro(OpacityArrayName, std::string);
  vtkGetMacro(OpacityArrayName, std::string);
  ///@}

  ///@{
  /**
   * Whether the scalars of points are interpolated in the cells between them before the opacity
   * function is applied, as in vtkCellCompositingMapper, so that splats have the same opacity. Off:
   * the function is applied to each sample. Default: on. Data on cells have nothing to interpolate.
   */
  vtkSetMacro(InterpolateScalarsBeforeMapping, bool);
  vtkGetMacro(InterpolateScalarsBeforeMapping, bool);
  vtkBooleanMacro(InterpolateScalarsBeforeMapping, bool);

  /**
   * Draws flat cells of a structured grid layer by layer, from the farthest to the nearest, where
   * the eye looks across their layers. In the order of their distances, which other samples have,
   * the lower cells of the next column would hide the upper ones behind them, so that an optically
   * thick medium has ribs. Default: on. Blocks of samples (ErrorTolerance, and moving cameras) are
   * always ordered by distance.
   */
  vtkSetMacro(OrderByLayers, bool);
  vtkGetMacro(OrderByLayers, bool);
  vtkBooleanMacro(OrderByLayers, bool);
  ///@}

  /**
   * Sets VectorOpacity or VectorFraction, or both, so that both streaks and the medium are visible.
   * Streaks of the mean speed get an optical depth of 0.6, the fastest at least 0.8 and at most 2.
   * A ray meets at most as many streaks as 7 samples with the maximum speed would give. There are
   * at most 6000 streaks in a sheet (up to 7 times as many in deep data), a mean distance of 8
   * pixels if they fill a picture of 600 by 600. Hosts use the fraction without a medium too. It
   * does nothing without an array of vectors.
   */
  void SuitVectorsToMedium(bool opacity = true, bool share = true);

  /**
   * Sets VectorColor, and UseVectorColor on, so that vectors stand out from the background and from
   * all colours that the property gives the medium: in black, white or orange or, if the medium has
   * all of these, in green, magenta, cyan or yellow.
   */
  void SuitVectorColor(vtkVolumeProperty* property, const double background[3]);
  /** The same on a gradient of two background colours, each of three numbers from 0 to 1. */
  void SuitVectorColor(vtkVolumeProperty* property, const double bottom[3], const double top[3]);

  /**
   * VectorUnit, or the value that would be used for the present input if it is 0; 0 without an
   * array of vectors. To keep the pictures of a film comparable, call SetVectorUnit with it.
   */
  double FindVectorUnit();

  /** TimeScale, or the value that is used if it is 0: that of the last render, 0 before it. */
  double GetDrawnTimeScale();

  /** MaximumSpeed, or the value that is used if it is 0: that of the data of the last render. */
  double GetDrawnMaximumSpeed();

  /**
   * Moves every pattern by a time, in the time unit of the vectors, at the speed of its own vector,
   * without a jump when the vectors change. The vectors are those of the last render.
   */
  void AdvancePhases(double time);

  ///@{
  /**
   * Level of detail: a block of samples is drawn as one splat if its error is at most this value;
   * blocks smaller than a pixel always are. The cost falls with the number of splats. 0 (default):
   * every sample is drawn. Blocks have the mean of their vectors. Ignored, with a warning, where
   * vectors are in layers.
   *
   * The splat of a block has the mass, the emission, the centre of mass and the covariance of its
   * samples. Unit of the error:
   * - Image (default): optical depth along the ray, depending on the view. It applies to each
   *   block: errors of blocks along a ray add up.
   * - Data: value of the opacity function, or fraction of MaximumSpeed; the same in every view.
   */
  vtkSetClampMacro(ErrorTolerance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(ErrorTolerance, double);
  enum ErrorToleranceUnitType
  {
    UNIT_OF_IMAGE = 0,
    UNIT_OF_DATA = 1
  };
  vtkSetClampMacro(ErrorToleranceUnit, int, UNIT_OF_IMAGE, UNIT_OF_DATA);
  vtkGetMacro(ErrorToleranceUnit, int);
  void SetErrorToleranceUnitToImage() { this->SetErrorToleranceUnit(UNIT_OF_IMAGE); }
  void SetErrorToleranceUnitToData() { this->SetErrorToleranceUnit(UNIT_OF_DATA); }
  ///@}

  ///@{
  /**
   * The error of a block that is compared with ErrorTolerance, in units of optical depth:
   * - Picture (default): root of the sum, over the pixels, of the squares of the error. Small
   *   blocks may be less exact than large ones: the fewest splats for clouds that change from
   *   sample to sample. 0.3 is hard to see, 3 clearly visible. With the error of the data: the root
   *   of the mean square.
   * - Root mean square: of the error over the block.
   * - Greatest: deviation of a sample from the block's mean (Laur and Hanrahan 1991), along the ray
   *   through the block; or the root mean square if it is more. Better than the others if the field
   *   is smooth and the tolerance is small.
   */
  enum ErrorMeasureType
  {
    GREATEST = 0,
    ROOT_MEAN_SQUARE = 1,
    PICTURE = 2
  };
  vtkSetClampMacro(ErrorMeasure, int, GREATEST, PICTURE);
  vtkGetMacro(ErrorMeasure, int);
  void SetErrorMeasureToGreatest() { this->SetErrorMeasure(GREATEST); }
  void SetErrorMeasureToRootMeanSquare() { this->SetErrorMeasure(ROOT_MEAN_SQUARE); }
  void SetErrorMeasureToPicture() { this->SetErrorMeasure(PICTURE); }
  ///@}

  ///@{
  /**
   * Fraction of the tolerance, 0 to 0.9, over which a block fades in while its samples fade out, so
   * that levels of detail do not pop as the camera or the tolerance changes. 0: levels switch at
   * once. Both are drawn in the meantime, so larger values cost more. Default: 0.1.
   */
  vtkSetClampMacro(LevelBlending, double, 0.0, 0.9);
  vtkGetMacro(LevelBlending, double);
  ///@}

  ///@{
  /**
   * Maximum number of splats while the camera moves: the tolerance grows until the number fits, and
   * returns to ErrorTolerance in the next still picture. 0: no limit. Default: 100000. Ignored
   * where vectors are in layers.
   */
  vtkSetClampMacro(InteractiveMaximumNumberOfSplats, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(InteractiveMaximumNumberOfSplats, vtkIdType);
  ///@}

  ///@{
  /**
   * The camera moves when the render window's DesiredUpdateRate, in frames a second, is this or
   * more; interactors and ParaView set that.
   * Default: 1, as in vtkSmartVolumeMapper.
   */
  vtkSetClampMacro(InteractiveUpdateRate, double, 1.0e-10, 1.0e10);
  vtkGetMacro(InteractiveUpdateRate, double);
  ///@}

  ///@{
  /**
   * Draws only as many pixels while the camera moves as the DesiredUpdateRate of the render window
   * allows, and interpolates between them; a picture at rest has all. Default: on, at most 8 pixels
   * between samples (1 to 16, clamped). Not when volumes are peeled. Names and meaning are those of
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
   * Pixels between samples of the image when AutoAdjustSampleDistances is off, 1 to 16 (clamped).
   * Default: 1.
   */
  vtkSetClampMacro(ImageSampleDistance, double, 1.0, 16.0);
  vtkGetMacro(ImageSampleDistance, double);
  ///@}
  /** The distance in the last render. */
  double GetLastImageSampleDistance();

  ///@{
  /**
   * The part of space, in coordinates of the data, that this process draws of a picture which
   * several draw together: of each splat those pixels whose ray is in the region at the splat's
   * distance from the eye. If regions fill space and their pictures are laid over each other in the
   * order of the regions, that is the picture of one process. Each needs the splats of others that
   * reach into its region, as ghosts (duplicate points or cells), and all need one frame. Bounds
   * may be infinite. Invalid ones, the default: all of space, without duplicates. Nodes of the
   * hierarchy are drawn whole, by the process that has their samples.
   */
  vtkSetVector6Macro(Region, double);
  vtkGetVector6Macro(Region, double);
  ///@}

  /**
   * For a picture drawn by several processes: the values on which they agree, so that they compute
   * the same. `origin`: a position within the data of all processes;
   * `longestEdge`: of the cells of all, in units of the data; `numberOfSamples`: the maximum over
   * the processes, which is compared with InteractiveMaximumNumberOfSplats. Used where Region is
   * set.
   */
  void SetCommonFrame(const double origin[3], double longestEdge, vtkIdType numberOfSamples);

  /** Splats drawn in the last render. */
  vtkIdType GetNumberOfDrawnSplats();

  /** Samples that could be seen in the last render: splats drawn without a hierarchy. */
  vtkIdType GetNumberOfSamples();

  /**
   * The tolerance of the last render; greater than ErrorTolerance if
   * InteractiveMaximumNumberOfSplats increased it.
   */
  double GetDrawnErrorTolerance();

  /** Bounds of the splats, which reach beyond the samples. */
  double* GetBounds() VTK_SIZEHINT(6) override;

  /**
   * The float image of the last render, as the point array "RGBA", colour premultiplied; false, and
   * an error, if there is none.
   */
  bool CopyFloatImage(vtkImageData* image);

  void Render(vtkRenderer* renderer, vtkVolume* volume) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  /**
   * Copies the input, all settings, and how far patterns have moved. The clipping planes and
   * VectorColorFunction are shared.
   */
  void ShallowCopy(vtkAbstractMapper* other) override;

protected:
  vtkTexturedSplatMapper();
  ~vtkTexturedSplatMapper() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;

  int Kernel = CUBIC_KERNEL;
  double CellSize = 0.0;
  double RadiusFactor = 1.0;
  double ErrorTolerance = 0.0;
  int ErrorToleranceUnit = UNIT_OF_IMAGE;
  int ErrorMeasure = PICTURE;
  double LevelBlending = 0.1;
  vtkIdType InteractiveMaximumNumberOfSplats = 100000;
  double InteractiveUpdateRate = 1.0;
  bool AutoAdjustSampleDistances = true;
  double ImageSampleDistance = 1.0, MaximumImageSampleDistance = 8.0;
  std::string ShapeArrayName;
  std::string CellSizeArrayName;
  bool CellSizeArrayHoldsVolumes = false;
  bool CellSizeFromCells = true;
  bool CellSizeFromNeighbors = false;
  double OpacityScale = 1.0;
  std::string OpacityArrayName;
  bool InterpolateScalarsBeforeMapping = true;
  bool OrderByLayers = true;
  double Region[6] = { 1, -1, 1, -1, 1, -1 };
  double CommonOrigin[3] = { 0, 0, 0 };
  double CommonLongestEdge = 0;
  vtkIdType CommonNumberOfSamples = 0;
  bool WithNeighbors = false; // in the last render: duplicates are drawn, too

private:
  void CopySettings(vtkTexturedSplatMapper* mapper);
  nephoscope::SplatVectorSettings GetVectorSettings();
  void SetVectorOptions(nephoscope::SplatDrawingOptions& options);
  double GetStreakUnit();
  double GetStreakUnit(double meanCell) const;
  vtkDataArray* FindVectors(bool& onCells);
  nephoscope::SplatVectorScene& GetVectorScene();
  double GetExtinctionFactor();
  bool DrawsRegion(vtkRenderer* renderer) const;
  bool AddTo(vtkRenderer* renderer, vtkVolume* volume, nephoscope::DepthTiles& tiles);
  void SetRegionOptions(nephoscope::SplatDrawingOptions& options) const;
  nephoscope::SplatSampling GetSampling(bool onCells) const;
  std::string UpdateSplats(vtkDataSet* input, vtkVolume* volume);
  void ChooseVectors(vtkDataSet* input, bool onCells);
  void DrawInOrder(vtkRenderer* renderer, vtkVolume* volume);
  std::string DrawScene(
    vtkOpenGLRenderWindow* window, vtkRenderer* renderer, vtkVolume* volume, double sampleDistance);
  std::string DrawInTime(vtkOpenGLRenderWindow* window, vtkRenderer* renderer, vtkVolume* volume);
  bool UsesHierarchy(vtkRenderer* renderer, vtkIdType samples, vtkIdType& most) const;
  void SelectSplats(vtkRenderer* renderer, vtkVolume* volume, const nephoscope::ViewState& state);
  void ReportOnce(const std::string& error);

  vtkTexturedSplatMapper(const vtkTexturedSplatMapper&) = delete;
  void operator=(const vtkTexturedSplatMapper&) = delete;

  double GetOwnTimeScale();
  void FindFilmCompanions(vtkRenderer* renderer);
  void MeasureTimeScale(vtkRenderer* renderer, vtkVolume* volume);
  std::vector<vtkWeakPointer<vtkTexturedSplatMapper>>
    FilmCompanions; // with which it shares a time scale

  std::string DrawnVectors; // VectorArrayName, or empty where that array is wrong

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
