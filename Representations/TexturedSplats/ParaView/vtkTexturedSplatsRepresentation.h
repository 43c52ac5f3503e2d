// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTexturedSplatsRepresentation
 * @brief Textured Splats in ParaView's list of representations
 *
 * A thin layer over vtkTexturedSplatMapper. It hands points or cells of any dataset to the mapper,
 * and moves the streaks of the vectors on with the animation time. On several ranks samples become
 * single vertices that carry the shapes of their cells, and the view gives each to the rank in
 * whose region it lies.
 */
#ifndef vtkTexturedSplatsRepresentation_h
#define vtkTexturedSplatsRepresentation_h

#include "vtkMediumRepresentation.h"
#include "vtkNephoscopeParaViewTexturedSplatsModule.h" // for export macro

#include "vtkSmartPointer.h" // for the colour function
#include "vtkSplatSpeedKey.h"
#include "vtkTexturedSplatMapper.h"

#include <memory> // for std::unique_ptr
#include <string> // for messages

#include <array>  // for regions
#include <memory> // for std::unique_ptr
#include <vector> // for regions

class vtkScalarsToColors;
namespace nephoscope
{
struct SplatSampling;
struct SplatReaches;
}
namespace nephoscope
{
class DefaultVectorColors;
}

class VTKNEPHOSCOPEPARAVIEWTEXTUREDSPLATS_EXPORT vtkTexturedSplatsRepresentation
  : public vtkMediumRepresentation
{
public:
  static vtkTexturedSplatsRepresentation* New();
  vtkTypeMacro(vtkTexturedSplatsRepresentation, vtkMediumRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Forwarded to the mapper; see there. */
  void SetKernel(int kernel);
  void SetCellSize(double size);
  void SetCellSizeArrayHoldsVolumes(bool volumes);
  void SetRadiusFactor(double factor);
  void SetErrorTolerance(double tolerance) { this->Mapper->SetErrorTolerance(tolerance); }
  void SetErrorToleranceUnit(int unit) { this->Mapper->SetErrorToleranceUnit(unit); }
  void SetErrorMeasure(int measure) { this->Mapper->SetErrorMeasure(measure); }
  void SetLevelBlending(double share) { this->Mapper->SetLevelBlending(share); }
  void SetInteractiveMaximumNumberOfSplats(vtkIdType count)
  {
    this->Mapper->SetInteractiveMaximumNumberOfSplats(count);
  }
  void SetAutoAdjustSampleDistances(bool adjust)
  {
    this->Mapper->SetAutoAdjustSampleDistances(adjust);
  }
  void SetMaximumImageSampleDistance(double distance)
  {
    this->Mapper->SetMaximumImageSampleDistance(distance);
  }
  void SetGreatestSpeed(double speed);
  void SetStreakPeriod(double units) { this->Mapper->SetStreakPeriod(units); }
  void SetPhaseCycles(int cycles) { this->Mapper->SetPhaseCycles(cycles); }
  void SetVectorStyle(int style) { this->Mapper->SetVectorStyle(style); }
  void SetVectorPlacement(int placement) { this->Mapper->SetVectorPlacement(placement); }
  void SetLayerAxis(int axis) { this->Mapper->SetLayerAxis(axis); }
  void SetVectorUnit(double length);
  void SetStreakWidth(double width) { this->Mapper->SetStreakWidth(width); }
  void SetSegmentLength(double length) { this->Mapper->SetSegmentLength(length); }
  void SetSegmentWidth(double pixels) { this->Mapper->SetSegmentWidth(pixels); }
  void SetPhaseSteps(int steps) { this->Mapper->SetPhaseSteps(steps); }
  ///@}

  /**
   * Colours for the array that colours the vectors. None (default): ParaView's default colours,
   * over the range of the array.
   */
  void SetVectorColorFunction(vtkScalarsToColors* function);

  /**
   * Array with the cell size of each sample without a grid; empty or "None" (default): CellSize for
   * all.
   */
  void SetCellSizeArray(const char* name);

  /**
   * Array that colours the vectors independently; empty or "None" (default): as the splats, or
   * VectorColor.
   */
  void SetVectorColorArray(const char* name);

  ///@{
  /**
   * Optical depth of the streaks of the longest vectors, and fraction of the samples whose vectors
   * are drawn. 0 (default): in a medium such that both are visible, see
   * vtkTexturedSplatMapper::SuitVectorsToMedium; for vectors alone 2, and all.
   */
  void SetVectorOpacity(double opacity);
  void SetVectorShare(double share);
  ///@}

  ///@{
  /**
   * Draw all vectors in VectorColor. Automatic (default): in a medium, a colour that stands out,
   * see vtkTexturedSplatMapper::SuitVectorColor.
   */
  enum VectorColorChoice
  {
    COLOR_OF_SPLATS = 0,
    ONE_COLOR = 1,
    AUTOMATIC_COLOR = 2
  };
  void SetUseVectorColor(int use);
  void SetVectorColor(double red, double green, double blue);
  ///@}

  /** Array of vectors that are drawn as streaks; empty or "None" (default): no streaks. */
  void SetVectorArray(const char* name);

  ///@{
  /**
   * Move the streaks with the animation time: once through their loop in LoopDuration, in its unit.
   * 0 (default): the time range of the data, longer if it has so few steps that a period of the
   * fastest streaks would take less than four; 1 for data without times. Phase, 0 to 1, is added.
   * Default: on, phase 0.
   */
  void SetMoveWithTime(bool move) { this->MoveWithTime = move; }
  bool GetMoveWithTime() const { return this->MoveWithTime; }
  void SetLoopDuration(double duration) { this->LoopDuration = duration; }
  double GetLoopDuration() const { return this->LoopDuration; }
  void SetPhase(double phase) { this->Phase = phase; }
  double GetPhase() const { return this->Phase; }
  ///@}

  ///@{
  /**
   * With MoveWithTime: at the speed of the vectors instead of through a loop. TimeScale: time, in
   * the unit of the vectors, per unit of the animation time. 0 (default): such that the fastest
   * patterns move by at most PhaseCycles periods in LoopDuration. Default: off.
   */
  void SetTrueSpeed(bool speed) { this->TrueSpeed = speed; }
  void SetTimeScale(double scale) { this->TimeScale = scale; }
  ///@}

  ///@{
  /**
   * The legend of the motion, vtkSplatSpeedKey, the unit of the vectors in it, and the metres in a
   * unit of length of the data. Default: off, none, 1.
   */
  void SetShowSpeedKey(bool show) { this->SpeedKey->SetVisibility(show); }
  void SetSpeedUnit(const char* unit) { this->SpeedKey->SetSpeedUnit(unit ? unit : ""); }
  void SetLengthUnit(double metres);
  ///@}

protected:
  vtkTexturedSplatsRepresentation();
  ~vtkTexturedSplatsRepresentation() override;

  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  void PreparePiece(vtkDataObject* input) override;
  void MovePiece(vtkMatrix4x4* matrix) override;
  void DescribePiece(vtkInformation* inInfo) override;
  vtkDataSet* CompletePiece(vtkDataSet* data, vtkInformation* inInfo) override;
  void PrepareMapper(vtkDataSet* data) override;
  bool DrawsBlock(vtkDataObject* block) const override;
  bool HoldsMedium(vtkDataSet* data) const override;
  int GetUniformAssociation() const override;
  int GetAssociationInPiece(int association) const override;

private:
  vtkTexturedSplatsRepresentation(const vtkTexturedSplatsRepresentation&) = delete;
  void operator=(const vtkTexturedSplatsRepresentation&) = delete;

  bool DrawsCells(); // else points
  nephoscope::SplatSampling GetSampling(bool onCells) const;
  double GetPhaseNow();
  double GetLoopTime() const;
  void MoveVectors();
  bool DrawsMedium();
  void WarnOfLongVectors(const std::string& text);
  void StoreSuited(const nephoscope::SplatSampling& sampling, const std::array<double, 6>& common);
  double GetShareOf(vtkDataSet* data);
  void SuitVectors(vtkDataSet* data);
  void UseCommons(const std::vector<std::array<double, 6>>& regions);
  nephoscope::SplatReaches GetReaches();

  vtkNew<vtkTexturedSplatMapper> Mapper;
  vtkNew<vtkSplatSpeedKey> SpeedKey;
  vtkSmartPointer<vtkScalarsToColors> VectorColorFunction;
  std::unique_ptr<nephoscope::DefaultVectorColors> DefaultColors;
  double CellSize = 0.0;
  double VectorOpacity = 0.0; // 0: suited to the medium
  double VectorShare = 0.0;   // likewise
  int UseVectorColor = AUTOMATIC_COLOR;
  std::array<double, 3> VectorColor = { { 1.0, 1.0, 1.0 } };
  double GreatestSpeed = 0.0; // 0: of the data of all ranks
  double VectorUnit = 0.0;    // likewise

  // What several ranks have agreed on for the last delivered piece.
  struct vtkMeeting;
  std::unique_ptr<vtkMeeting> Meeting;
  bool MoveWithTime = true;
  double LoopDuration = 0.0;
  double Phase = 0.0;
  bool TrueSpeed = false;
  double TimeScale = 0.0, LengthUnit = 1.0;
  double InputTimes[2] = { 0.0, 0.0 }; // first and last
  int NumberOfInputTimes = 0;
};

#endif
