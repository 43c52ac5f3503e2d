// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPVFlowVolume
 * @brief vtkFlowVolume, with a place to start from for ParaView's panel
 *
 * The smoke is that of vtkFlowVolume. On several ranks FindPlace must be called on all of them, as ParaView does.
 */
#ifndef vtkPVFlowVolume_h
#define vtkPVFlowVolume_h

#include "vtkFlowVolume.h"
#include "vtkNephoscopeParaViewFiltersModule.h" // for export macro

class VTKNEPHOSCOPEPARAVIEWFILTERS_EXPORT vtkPVFlowVolume : public vtkFlowVolume
{
public:
  static vtkPVFlowVolume* New();
  vtkTypeMacro(vtkPVFlowVolume, vtkFlowVolume);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Looks at the input as it is now for a place for the polygon, see vtkFlowVolumePlacement. The properties stay as they are. */
  void FindPlace();

  ///@{
  /** The place that FindPlace found. Radius 0: none, because there are no data yet or nothing flows. */
  vtkGetVector3Macro(PlaceCenter, double);
  vtkGetVector3Macro(PlaceNormal, double);
  vtkGetMacro(PlaceRadius, double);
  ///@}

protected:
  vtkPVFlowVolume() = default;
  ~vtkPVFlowVolume() override = default;

private:
  vtkPVFlowVolume(const vtkPVFlowVolume&) = delete;
  void operator=(const vtkPVFlowVolume&) = delete;

  double PlaceCenter[3] = { 0.0, 0.0, 0.0 };
  double PlaceNormal[3] = { 0.0, 0.0, 1.0 };
  double PlaceRadius = 0.0;
};

#endif
