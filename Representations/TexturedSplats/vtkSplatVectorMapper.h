// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSplatVectorMapper
 * @brief   the vectors that vtkTexturedSplatMapper draws on its splats: how they look, and how they
 *          move
 *
 * An abstract class: these are settings of vtkTexturedSplatMapper, which draws.
 */
#ifndef vtkSplatVectorMapper_h
#define vtkSplatVectorMapper_h

#include "vtkAbstractVolumeMapper.h"
#include "vtkNephoscopeRepresentationsTexturedSplatsModule.h" // for export macro
#include "vtkSmartPointer.h"                                  // for the colour function

#include <string> // for array names

class vtkScalarsToColors;

class VTKNEPHOSCOPEREPRESENTATIONSTEXTUREDSPLATS_EXPORT vtkSplatVectorMapper
  : public vtkAbstractVolumeMapper
{
public:
  vtkTypeMacro(vtkSplatVectorMapper, vtkAbstractVolumeMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Name of the array of vectors (three components, on points or cells like the coloured array)
   * that are drawn on the splats, as streaks along their projection. Empty (default): no vectors.
   * If the array is missing or wrong, an error says so, and the scalars are drawn alone. An opacity
   * function of 0 draws only the vectors.
   */
  vtkSetMacro(VectorArrayName, std::string);
  vtkGetMacro(VectorArrayName, std::string);
  ///@}

  ///@{
  /**
   * How vectors are drawn. Default: streaks.
   * - Streaks: like comets, with a sharp head in front and a fading tail that is longer for faster
   *   vectors; they move with Phase and AdvancePhases. A vector that points at the eye is a round
   *   dot; patterns finer than a pixel are their mean.
   * - Segments: one anti-aliased line per sample (Crawfis and Max 1993), longer and more opaque for
   *   faster vectors, at a random position in its cell that does not depend on the order of the
   *   input. They move with Phase and AdvancePhases, by SegmentLength in a period.
   *   In the first quarter of the next period a segment fades in behind while the previous one
   *   fades out ahead, so that their opacities add up to that of one segment.
   */
  enum VectorStyleType
  {
    STREAKS = 0,
    SEGMENTS = 1
  };
  vtkSetClampMacro(VectorStyle, int, STREAKS, SEGMENTS);
  vtkGetMacro(VectorStyle, int);
  void SetVectorStyleToStreaks() { this->SetVectorStyle(STREAKS); }
  void SetVectorStyleToSegments() { this->SetVectorStyle(SEGMENTS); }
  ///@}

  ///@{
  /**
   * Depth of vectors among the scalars. Default: in the middle.
   * - Middle: in the middle of its splat's medium. Half of the medium hides the vector, and the
   *   vector hides the other half.
   * - Layers: the splats are drawn in layers, in each of them first the scalars and then the
   *   vectors (Max, Crawfis and Becker 1993).
   */
  enum VectorPlacementType
  {
    PLACEMENT_MIDDLE = 0,
    PLACEMENT_LAYERS = 1,
    IN_THE_MIDDLE = PLACEMENT_MIDDLE, ///< deprecated
    IN_LAYERS = PLACEMENT_LAYERS      ///< deprecated
  };
  vtkSetClampMacro(VectorPlacement, int, PLACEMENT_MIDDLE, PLACEMENT_LAYERS);
  vtkGetMacro(VectorPlacement, int);
  void SetVectorPlacementToMiddle() { this->SetVectorPlacement(PLACEMENT_MIDDLE); }
  void SetVectorPlacementToLayers() { this->SetVectorPlacement(PLACEMENT_LAYERS); }
  ///@}

  ///@{
  /**
   * For placement in layers: the axis of a structured grid whose index numbers the layers, 0 to 2.
   * -1 (default): the axis that points most towards the eye, or the last one if they hardly differ.
   * Ignored for samples without a grid, whose layers are at right angles to the line of sight.
   */
  vtkSetClampMacro(LayerAxis, int, -1, 2);
  vtkGetMacro(LayerAxis, int);
  ///@}

  ///@{
  /**
   * Optical depth of the streaks of the longest vectors, 0 or more; other streaks are proportional
   * to their vectors. Default: 2.
   */
  vtkSetClampMacro(VectorOpacity, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(VectorOpacity, double);
  ///@}

  ///@{
  /**
   * Speed, in the units of the vectors, at and above which streaks have full opacity. 0 (default):
   * the maximum speed in the data, but at most 1.25 times the 99th percentile. A warning says if
   * the maximum is more than twice that.
   */
  vtkSetClampMacro(MaximumSpeed, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumSpeed, double);
  void SetGreatestSpeed(double speed) { this->SetMaximumSpeed(speed); } ///< deprecated
  double GetGreatestSpeed() { return this->MaximumSpeed; }              ///< deprecated
  ///@}

  ///@{
  /**
   * The unit of StreakPeriod, StreakWidth and SegmentLength, in units of length of the data. 0
   * (default): the mean length of a cell along its vector. To make parts of the data or time steps
   * comparable, set it and MaximumSpeed.
   */
  vtkSetClampMacro(VectorUnit, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(VectorUnit, double);
  ///@}

  ///@{
  /**
   * Fraction of the samples whose vectors are drawn, 0 to 1, chosen uniformly at random, but always
   * the same. If VectorUnit is automatic, it grows by the cube root of the number of samples per
   * vector, so that streaks look as on a coarser grid.
   * Default: 1, all.
   */
  vtkSetClampMacro(VectorFraction, double, 0.0, 1.0);
  vtkGetMacro(VectorFraction, double);
  void SetVectorShare(double fraction) { this->SetVectorFraction(fraction); } ///< deprecated
  double GetVectorShare() { return this->VectorFraction; }                    ///< deprecated
  ///@}

  ///@{
  /**
   * Streaks, in VectorUnits: distance from head to head along the vector, and standard deviation of
   * the brightness across. The longest tail is 0.6 periods. Splats are lengthened along the vector
   * to half a period, so that streaks are not cut short: cost grows with the period. Defaults: 4
   * and 0.1.
   */
  vtkSetClampMacro(StreakPeriod, double, 0.01, 1000.0);
  vtkGetMacro(StreakPeriod, double);
  vtkSetClampMacro(StreakWidth, double, 0.001, 10.0);
  vtkGetMacro(StreakWidth, double);
  ///@}

  ///@{
  /**
   * Segments: length at MaximumSpeed in VectorUnits, default 2 (more than the distance of samples),
   * and width in pixels, default 1.5.
   */
  vtkSetClampMacro(SegmentLength, double, 0.0, 1000.0);
  vtkGetMacro(SegmentLength, double);
  vtkSetClampMacro(SegmentWidth, double, 0.1, 100.0);
  vtkGetMacro(SegmentWidth, double);
  ///@}

  ///@{
  /**
   * Name of an array, on points or cells like the vectors, that colours the vectors independently
   * of the medium through VectorColorFunction; the magnitude is used if it has several components.
   * Empty (default): VectorColor or the splat's colour.
   */
  vtkSetMacro(VectorColorArrayName, std::string);
  vtkGetMacro(VectorColorArrayName, std::string);
  virtual void SetVectorColorFunction(vtkScalarsToColors* function);
  vtkScalarsToColors* GetVectorColorFunction();
  ///@}

  ///@{
  /**
   * Colour of the vectors if UseVectorColor is on, 0 to 1 each. Default: white. Off (default): the
   * splat's colour.
   */
  vtkSetVector3Macro(VectorColor, double);
  vtkGetVector3Macro(VectorColor, double);
  vtkSetMacro(UseVectorColor, bool);
  vtkGetMacro(UseVectorColor, bool);
  vtkBooleanMacro(UseVectorColor, bool);
  ///@}

  ///@{
  /**
   * Position of the patterns in their loop, 0 to 1; 1 is the same as 0. Over a loop each pattern
   * moves a whole number of periods, nearest to PhaseCycles (default 4) times its fraction of
   * MaximumSpeed, for looping animations. For motion at exactly the speed of the data use TrueSpeed
   * or AdvancePhases.
   */
  vtkSetMacro(Phase, double);
  vtkGetMacro(Phase, double);
  vtkSetClampMacro(PhaseCycles, int, 1, 1000);
  vtkGetMacro(PhaseCycles, int);
  ///@}

  ///@{
  /**
   * Number of patterns in a period between which streaks and segments step, 0 to 1000: 16 is the
   * number that Crawfis and Max stored. 0 (default): they move continuously.
   */
  vtkSetClampMacro(PhaseSteps, int, 0, 1000);
  vtkGetMacro(PhaseSteps, int);
  ///@}

  ///@{
  /**
   * On: patterns move at the speed of their vectors, by the distance |vector| * TimeScale *
   * FilmTime, instead of through a loop; Phase and PhaseCycles have no effect. When the vectors
   * change, patterns continue from their current positions; FilmTime 0 starts again. Default: off.
   */
  vtkSetMacro(TrueSpeed, bool);
  vtkGetMacro(TrueSpeed, bool);
  vtkBooleanMacro(TrueSpeed, bool);
  ///@}

  ///@{
  /**
   * With TrueSpeed: time in the data per second of the film, in the unit of the vectors, such as
   * 3600 for an hour if they are in metres per second and the data in metres. If the data are in
   * another unit of length than the vectors, multiply by the factor. 0 (default): a round number
   * for which the fastest patterns move by at most one period in a second; if several mappers in a
   * renderer have TrueSpeed and no own scale, the smallest of these numbers for all, so that their
   * speeds are comparable.
   */
  vtkSetClampMacro(TimeScale, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(TimeScale, double);
  ///@}

  ///@{
  /** With TrueSpeed: seconds since the start of the film. Must be finite. Default: 0. */
  void SetFilmTime(double time);
  vtkGetMacro(FilmTime, double);
  ///@}

  /** Copies the settings of the vectors. VectorColorFunction is shared. */
  void ShallowCopy(vtkAbstractMapper* other) override;

protected:
  vtkSplatVectorMapper();
  ~vtkSplatVectorMapper() override;

  /** The distance from pattern to pattern, in VectorUnits. */
  double GetPatternPeriod() const;

  std::string VectorArrayName;
  double VectorOpacity = 2.0;
  double MaximumSpeed = 0.0;
  int VectorStyle = STREAKS;
  int VectorPlacement = PLACEMENT_MIDDLE;
  int LayerAxis = -1;
  double VectorFraction = 1.0;
  double VectorUnit = 0.0;
  double StreakPeriod = 4.0;
  double StreakWidth = 0.1;
  double SegmentLength = 2.0;
  double SegmentWidth = 1.5;
  std::string VectorColorArrayName;
  vtkSmartPointer<vtkScalarsToColors> VectorColorFunction;
  double VectorColor[3] = { 1.0, 1.0, 1.0 };
  bool UseVectorColor = false;
  double Phase = 0.0;
  int PhaseCycles = 4;
  int PhaseSteps = 0;
  bool TrueSpeed = false;
  double TimeScale = 0.0;
  double FilmTime = 0.0;

private:
  vtkSplatVectorMapper(const vtkSplatVectorMapper&) = delete;
  void operator=(const vtkSplatVectorMapper&) = delete;
};

#endif
