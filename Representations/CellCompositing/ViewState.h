// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** From a renderer and a prop to the matrices and the eye that sorting and drawing need. */
#ifndef ViewState_h
#define ViewState_h

#include "CellDrawing.h"
#include "OrderView.h"
#include "TetrahedronRay.h"

#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOpenGLCamera.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <algorithm>
#include <cmath>

namespace nephoscope
{

// The point where all rays meet, (x, y, z, 1), or the direction towards the eye with the length of a unit in view
// coordinates, (x, y, z, 0). `clip` maps coordinates to homogeneous device coordinates.
inline Vector4 findEye(vtkMatrix4x4* clip)
{
  vtkNew<vtkMatrix4x4> inverse;
  vtkMatrix4x4::Invert(clip, inverse);
  const double towardsEye[4] = { 0, 0, -1, 0 };
  double e[4];
  inverse->MultiplyPoint(towardsEye, e);
  return { { e[0], e[1], e[2], e[3] } };
}

inline bool isParallel(vtkMatrix4x4* viewToDevice)
{
  return viewToDevice->GetElement(3, 0) == 0 && viewToDevice->GetElement(3, 1) == 0 &&
    viewToDevice->GetElement(3, 2) == 0;
}

/** The matrices and the eye of one render, relative to the centre of the geometry. */
struct ViewState
{
  vtkNew<vtkMatrix4x4> ModelToView;
  vtkNew<vtkMatrix4x4> ViewToDevice;
  CellView View;
  Vector4 EyeModel;

  ViewState(vtkRenderer* renderer, vtkVolume* volume, const double center[3])
  {
    auto* camera = vtkOpenGLCamera::SafeDownCast(renderer->GetActiveCamera());
    vtkMatrix4x4 *worldToView, *viewToDevice, *worldToDevice; // transposed, as OpenGL wants them
    vtkMatrix3x3* normals;
    camera->GetKeyMatrices(renderer, worldToView, normals, viewToDevice, worldToDevice);
    vtkMatrix4x4::Transpose(viewToDevice, this->ViewToDevice);
    vtkNew<vtkMatrix4x4> toView;
    vtkMatrix4x4::Transpose(worldToView, toView);
    vtkNew<vtkMatrix4x4> shift;
    for (int axis = 0; axis < 3; ++axis)
    {
      shift->SetElement(axis, 3, center[axis]);
    }
    vtkMatrix4x4::Multiply4x4(volume->GetMatrix(), shift, this->ModelToView);
    vtkMatrix4x4::Multiply4x4(toView, this->ModelToView, this->ModelToView);

    this->View.ModelToView = this->ModelToView;
    this->View.ViewToDevice = this->ViewToDevice;
    this->FindEyes();
  }

  /** What the visibility order needs, for a picture of so many pixels. */
  OrderView GetOrderView(int width, int height) const
  {
    OrderView view;
    view.Eye = this->EyeModel;
    vtkMatrix4x4::Multiply4x4(
      this->ViewToDevice->GetData(), this->ModelToView->GetData(), view.ModelToDevice.data());
    view.Width = width;
    view.Height = height;
    return view;
  }

private:
  void FindEyes()
  {
    Vector4 eyeView = findEye(this->ViewToDevice);
    const bool parallel = isParallel(this->ViewToDevice);
    const double scale =
      parallel ? 1.0 / std::sqrt(eyeView[0] * eyeView[0] + eyeView[1] * eyeView[1] + eyeView[2] * eyeView[2])
               : 1.0 / eyeView[3];
    for (double& e : eyeView)
    {
      e *= scale;
    }
    eyeView[3] = parallel ? 0.0 : 1.0;
    vtkNew<vtkMatrix4x4> viewToModel;
    vtkMatrix4x4::Invert(this->ModelToView, viewToModel);
    viewToModel->MultiplyPoint(eyeView.data(), this->EyeModel.data());
    std::copy(eyeView.begin(), eyeView.end(), this->View.EyeView);
    std::copy(this->EyeModel.begin(), this->EyeModel.end(), this->View.EyeModel);
  }
};

} // namespace nephoscope

#endif
