// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSmokePuffs
 * @brief   puffs that move along a flow volume with the flow, as an opacity array for the mapper
 *
 *     vtkFlowVolume -> vtkSmokePuffs -> vtkCellCompositingMapper (opacity array SmokeDensity)
 *
 * This follows section 6 of MaxCrawfisBecker1993 (N. Max, R. Crawfis, B. Becker, "New Techniques in
 * 3D Scalar and Vector Field Visualization", Pacific Graphics 1993): the smoke is released not
 * evenly but in puffs, which the flow carries along.
 * The output has the points, cells and arrays of the input, not copied, and one more array:
 *
 * - SmokeDensity, double, on cells (or on points, see Association), unit of Density:
 *   min(Density, MaximumDensity) * pulse, where with the phase x = (Age - time) / Period, taken to
 *   [-1/2, 1/2), pulse = scale * (Floor + (1 - Floor) * cos^2(pi x / Width)) for |x| < Width / 2,
 *   and scale * Floor elsewhere.
 *
 * The pulse has a continuous derivative. Its mean over a period is scale * (Floor + (1 - Floor) *
 * Width / 2).
 *
 * A crest is where Age = time + n Period. In a steady volume it moves along the volume at the speed
 * of the flow as time grows. In an unsteady volume, time - Age is when the smoke was released: a
 * puff is the smoke of some emission steps and moves with it. Nothing depends on the steps between
 * frames: any frame rate shows the same motion, and times that differ by a period give the same
 * array.
 *
 * The time is that of the pipeline, as set by ParaView's animation, times TimeScale; if no time is
 * requested, it is Time. The filter runs again when the pipeline's time changes, even if its input
 * has no time. For an input without time, or with one time step, it reports a time range of one
 * period from 0 or from that step, and requests only that step from the input. The input therefore
 * does not run again, and a frame costs one array. Two or more time steps of the input are passed
 * on unchanged.
 *
 * Input: cell arrays Age (s) and Density, as written by vtkFlowVolume; for an array on points also
 * the point array Age.
 * If one is missing, an error is reported, and the input is passed on without SmokeDensity. Cells
 * whose Age or Density is not a finite number get 0, with a warning. A puff shorter than two time
 * steps of the flow volume falls between its cells: its brightness and mass then change with time,
 * and a warning says so once for each period and step.
 */
#ifndef vtkSmokePuffs_h
#define vtkSmokePuffs_h

#include "vtkNephoscopeFiltersFlowVolumeModule.h" // for export macro
#include "vtkUnstructuredGridAlgorithm.h"

#include <memory> // for what is kept between frames

namespace nephoscope
{
class BlocksWithArray;
class PointDensity;
struct PuffPulse;
}
class vtkUnstructuredGrid;

class VTKNEPHOSCOPEFILTERSFLOWVOLUME_EXPORT vtkSmokePuffs : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkSmokePuffs* New();
  vtkTypeMacro(vtkSmokePuffs, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  vtkTypeBool ProcessRequest(
    vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  enum NormalizationType
  {
    PEAK = 0,
    MEAN = 1
  };

  enum AssociationType
  {
    CELLS = 0,
    POINTS = 1
  };

  ///@{
  /**
   * Time from one puff to the next, in seconds of the flow. 0 (default): a quarter of the maximum
   * Age of the input, so that about four puffs are visible. It is found at the first requested time
   * of a series, and kept at other times until the input changes in another way. In unsteady smoke
   * it is a quarter of the time range of the series, or of the maximum Age if that is larger.
   */
  vtkSetClampMacro(Period, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Period, double);
  ///@}

  /**
   * The period in use, in seconds: Period, or the automatic one, known after an update (0 before).
   */
  double GetActualPeriod() const { return this->ActualPeriod; }

  ///@{
  /**
   * Length of a puff from end to end, as a fraction of the period: 1e-6 to 1. Default 0.5. At half
   * its peak a puff is half as long.
   */
  vtkSetClampMacro(Width, double, 1e-6, 1.0);
  vtkGetMacro(Width, double);
  ///@}

  ///@{
  /**
   * Smoke between puffs, as a fraction of the peak: 0 (no smoke) to 1 (no puffs). Default 0.1,
   * which keeps the path visible.
   */
  vtkSetClampMacro(Floor, double, 0.0, 1.0);
  vtkGetMacro(Floor, double);
  ///@}

  ///@{
  /**
   * Peak (default): the peak of a pulse is 1, so that puffs have less smoke in total. Mean: the
   * mean of a pulse is 1, so that a period releases as much smoke as without puffs, and peaks are
   * denser.
   */
  vtkSetClampMacro(Normalization, int, PEAK, MEAN);
  vtkGetMacro(Normalization, int);
  void SetNormalizationToPeak() { this->SetNormalization(PEAK); }
  void SetNormalizationToMean() { this->SetNormalization(MEAN); }
  ///@}

  ///@{
  /**
   * Higher densities are clamped to this value before the pulse, so that smoke does not become
   * opaque where the flow converges; the mass is then not conserved. 0 (default): no clamping. Unit
   * of Density: 1 is the density at the polygon.
   */
  vtkSetClampMacro(MaximumDensity, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumDensity, double);
  ///@}

  ///@{
  /**
   * Cells (default): one value per cell, which conserves the mass. Points: Density is averaged over
   * the cells at a point (once, not in every frame) and the pulse is evaluated at the Age of the
   * point, so that smoke varies smoothly within the cells. There are fewer values than on cells;
   * the mass agrees except for interpolation.
   */
  vtkSetClampMacro(Association, int, CELLS, POINTS);
  vtkGetMacro(Association, int);
  void SetAssociationToCells() { this->SetAssociation(CELLS); }
  void SetAssociationToPoints() { this->SetAssociation(POINTS); }
  ///@}

  ///@{
  /** Time in seconds, used when the pipeline requests no time. Default 0. */
  vtkSetMacro(Time, double);
  vtkGetMacro(Time, double);
  ///@}

  ///@{
  /**
   * Seconds of the flow per unit of the pipeline's time: 3600 if the animation time is in hours.
   * Default 1. Time is not scaled.
   */
  vtkSetClampMacro(TimeScale, double, 1e-12, 1e12);
  vtkGetMacro(TimeScale, double);
  ///@}

protected:
  vtkSmokePuffs();
  ~vtkSmokePuffs() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSmokePuffs(const vtkSmokePuffs&) = delete;
  void operator=(const vtkSmokePuffs&) = delete;

  double Period = 0.0;
  double Width = 0.5;
  double Floor = 0.1;
  int Normalization = PEAK;
  double MaximumDensity = 0.0;
  int Association = CELLS;
  double Time = 0.0;
  double TimeScale = 1.0;
  double ActualPeriod = 0.0;

  double FindPeriod(vtkUnstructuredGrid* smoke, vtkInformation* inInfo);
  void AnnounceTime(vtkInformation* inInfo, vtkInformation* outInfo) const;
  void AskForTime(vtkInformation* inInfo, vtkInformation* outInfo) const;
  void AddSmokeDensity(
    vtkUnstructuredGrid* output, const nephoscope::PuffPulse& pulse, double time);

  std::unique_ptr<nephoscope::BlocksWithArray> Blocks; // some may lack the array
  std::unique_ptr<nephoscope::PointDensity> Averages;
  void WarnOfShortPuffs(vtkUnstructuredGrid* smoke, const nephoscope::PuffPulse& pulse);
  vtkMTimeType Change = 0;                    // of the input, for which the next two were found
  double FoundAge = 0.0;                      // the greatest, s
  double FoundStep = 0.0;                     // time between two layers of smoke, s
  double ToldPeriodAndStep[2] = { 0.0, 0.0 }; // for WarnOfShortPuffs

  vtkMTimeType ToldOfInput = 0; // for HasOtherInput
  vtkMTimeType ToldOfEmptiness = 0;
};

#endif
