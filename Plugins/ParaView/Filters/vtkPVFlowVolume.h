// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPVFlowVolume
 * @brief vtkFlowVolume with an initial position for ParaView's panel
 *
 * The smoke is that of vtkFlowVolume. The polygon stays in fast flow until the user moves it: an
 * update places it again if the bounds of the input have changed for a reason other than time. If
 * nothing flows, every update tries again. On several ranks FindPlace must be called on all of
 * them, as ParaView does.
 */
#ifndef vtkPVFlowVolume_h
#define vtkPVFlowVolume_h

#include "vtkFlowVolume.h"
#include "vtkNephoscopeParaViewFiltersModule.h" // for export macro

#include <memory> // for the preview

namespace nephoscope
{
class FlowPreview;
}

class VTKNEPHOSCOPEPARAVIEWFILTERS_EXPORT vtkPVFlowVolume : public vtkFlowVolume
{
public:
  static vtkPVFlowVolume* New();
  vtkTypeMacro(vtkPVFlowVolume, vtkFlowVolume);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Finds a position for the polygon in the current input, see vtkFlowVolumePlacement. The
   * properties stay as they are.
   */
  void FindPlace();

  ///@{
  /**
   * Places the polygon again when the bounds of the input change otherwise than with the time, as
   * long as Center, Radius and Normal are those found automatically. Default: on.
   */
  void SetFollowData(bool follow) { this->FollowData = follow; }
  bool GetFollowData() const { return this->FollowData; }
  ///@}

  ///@{
  /**
   * The position that FindPlace found. Radius 0: none, because there are no data yet or nothing
   * flows.
   */
  vtkGetVector3Macro(PlaceCenter, double);
  vtkGetVector3Macro(PlaceNormal, double);
  vtkGetMacro(PlaceRadius, double);
  ///@}

  ///@{
  /**
   * The direction of the flow at a position to which the polygon is dragged; 0 0 0 where nothing
   * flows. The filter is not modified.
   */
  void SetPreviewCenter(double x, double y, double z);
  vtkGetVector3Macro(PreviewNormal, double);
  ///@}

protected:
  vtkPVFlowVolume();
  ~vtkPVFlowVolume() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkPVFlowVolume(const vtkPVFlowVolume&) = delete;
  void operator=(const vtkPVFlowVolume&) = delete;

  void FindPlaceIn(vtkDataObject* input);
  bool IsOtherInput();
  bool IsWhereItWasPlaced();

  bool FollowData = true;
  double Diagonal = 0.0;   // of the data in which it was placed; 0: not yet
  vtkMTimeType Change = 0; // of the input, at the last update
  double PlaceCenter[3] = { 0.0, 0.0, 0.0 };
  double PlaceNormal[3] = { 0.0, 0.0, 1.0 };
  double PlaceRadius = 0.0;
  double PreviewNormal[3] = { 0.0, 0.0, 0.0 };
  std::unique_ptr<nephoscope::FlowPreview> Preview;
};

#endif
