// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSunRepresentation
 * @brief the light of a render view comes from its sun
 *
 * While it is visible, a light from the sun of a vtkSunSource replaces the lights that move with
 * the camera, including ParaView's light kit; lights fixed in the scene are kept. A faint light
 * from the eye keeps the night from being black. Haze without its own sun uses this one. Several
 * visible suns all shine.
 *
 * With a date and time, the scene is a globe if visible data say so in the field data of
 * vtkGlobeGrid, as for vtkSunlight.
 */
#ifndef vtkSunRepresentation_h
#define vtkSunRepresentation_h

#include "vtkNephoscopeParaViewFiltersModule.h" // for export macro
#include "vtkNew.h"
#include "vtkPVDataRepresentation.h"
#include "vtkSmartPointer.h" // for the data
#include "vtkWeakPointer.h"  // for the renderer

#include <vector> // for the lights

class vtkLight;
class vtkPolyData;
class vtkRenderer;

class VTKNEPHOSCOPEPARAVIEWFILTERS_EXPORT vtkSunRepresentation : public vtkPVDataRepresentation
{
public:
  static vtkSunRepresentation* New();
  vtkTypeMacro(vtkSunRepresentation, vtkPVDataRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void SetVisibility(bool visible) override;

  ///@{
  /** Intensities of the sun, default 1, and of the faint light from the eye, default 0.1. */
  void SetIntensity(double intensity);
  void SetFillLight(double intensity);
  ///@}

  int ProcessViewRequest(
    vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo) override;

protected:
  vtkSunRepresentation();
  ~vtkSunRepresentation() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;

private:
  vtkSunRepresentation(const vtkSunRepresentation&) = delete;
  void operator=(const vtkSunRepresentation&) = delete;

  void Switch(bool on);
  void WarnOfVolumes();
  void OnStart();
  void OnEnd();
  bool FindDirection(double direction[3]);

  vtkNew<vtkPolyData> Piece;          // two points: the directions
  vtkSmartPointer<vtkPolyData> Shown; // the same, as delivered to this process
  bool HasToldOfVolumes = false;      // that have no light
  vtkNew<vtkLight> Sun;
  vtkNew<vtkLight> Fill;
  std::vector<vtkSmartPointer<vtkLight>> Hidden; // during a render
  vtkWeakPointer<vtkRenderer> Renderer;          // of the view, while the sun is in it
  vtkWeakPointer<vtkRenderer> OfView;
  unsigned long Observers[2] = { 0, 0 };
};

#endif
