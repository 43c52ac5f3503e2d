// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkHazeRepresentation
 * @brief the haze of a render view: one switch for everything in it
 *
 * While it is visible its vtkHaze is that of the view's renderer; of several the one shown last.
 * Each rank hazes its own fragments before they are composited. One rank draws the haze in front of
 * the background, as the farthest layer.
 */
#ifndef vtkHazeRepresentation_h
#define vtkHazeRepresentation_h

#include "vtkNephoscopeParaViewHazeModule.h" // for export macro
#include "vtkNew.h"
#include "vtkPVDataRepresentation.h"
#include "vtkWeakPointer.h" // for the view

class vtkHaze;
class vtkPVRenderView;

class VTKNEPHOSCOPEPARAVIEWHAZE_EXPORT vtkHazeRepresentation : public vtkPVDataRepresentation
{
public:
  static vtkHazeRepresentation* New();
  vtkTypeMacro(vtkHazeRepresentation, vtkPVDataRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void SetVisibility(bool visible) override;

  ///@{
  /** As in vtkHaze. VisualRange is its Visibility. */
  void SetVisualRange(double length);
  void SetScaleHeight(double height);
  void SetVerticalExaggeration(double factor);
  void SetHazeColor(double red, double green, double blue);
  void SetSunDirection(double x, double y, double z);
  void SetAsymmetry(double asymmetry);
  void SetCloudShadows(bool cast);
  void SetProjection(int projection);
  void SetCenter(double x, double y, double z);
  void SetPlanetRadius(double radius);
  void SetUpDirection(double x, double y, double z);
  void SetBaseLevel(double level);
  void SetHazeBackground(bool hazed);
  ///@}

protected:
  vtkHazeRepresentation();
  ~vtkHazeRepresentation() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;

private:
  vtkHazeRepresentation(const vtkHazeRepresentation&) = delete;
  void operator=(const vtkHazeRepresentation&) = delete;

  void Switch(bool on);

  vtkNew<vtkHaze> Haze;
  vtkWeakPointer<vtkPVRenderView> View;
};

#endif
