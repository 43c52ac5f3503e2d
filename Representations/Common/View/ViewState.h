// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** From a renderer and a prop to the matrices and the eye that sorting and drawing need. */
#ifndef nephoscope_ViewState_h
#define nephoscope_ViewState_h

#include "Vector3.h"

#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOpenGLCamera.h"
#include "vtkProp3D.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nephoscope
{

/** The view for one drawing; matrices multiply columns, as in vtkMatrix4x4. */
struct SceneView
{
  vtkMatrix4x4* ModelToView = nullptr; ///< of coordinates relative to the geometry's centre
  vtkMatrix4x4* ViewToDevice = nullptr;
  double EyeModel[4] = { 0, 0, 0, 1 }; ///< relative to the geometry's centre
  double EyeView[4] = { 0, 0, 0, 1 };
};

// The point where all rays meet, (x, y, z, 1), or the direction towards the eye with the length of
// a unit in view coordinates, (x, y, z, 0). `clip` maps coordinates to homogeneous device
// coordinates.
inline Vector4 FindEye(vtkMatrix4x4* clip)
{
  vtkNew<vtkMatrix4x4> inverse;
  vtkMatrix4x4::Invert(clip, inverse);
  const double towardsEye[4] = { 0, 0, -1, 0 };
  double e[4];
  inverse->MultiplyPoint(towardsEye, e);
  return { { e[0], e[1], e[2], e[3] } };
}

inline bool IsParallelProjection(vtkMatrix4x4* viewToDevice)
{
  return viewToDevice->GetElement(3, 0) == 0 && viewToDevice->GetElement(3, 1) == 0 &&
    viewToDevice->GetElement(3, 2) == 0;
}

/**
 * For shaders: a depth in [0, 1] is at z = (x + y e) / (z + w e) in view coordinates, where e = 1 -
 * depth: counted from the far plane, where most depths lie in a perspective projection, nothing
 * cancels in float.
 */
inline std::array<float, 4> DepthToViewOf(vtkMatrix4x4* viewToDevice)
{
  const double m22 = viewToDevice->GetElement(2, 2);
  const double m23 = viewToDevice->GetElement(2, 3);
  const double m32 = viewToDevice->GetElement(3, 2);
  const double m33 = viewToDevice->GetElement(3, 3);
  // (m22 z + m23) / (m32 z + m33) = 1 - 2 e
  return { { static_cast<float>(m33 - m23), static_cast<float>(-2 * m33),
    static_cast<float>(m22 - m32), static_cast<float>(2 * m32) } };
}

/** The matrices and the eye of one render, relative to the centre of the geometry. */
struct ViewState
{
  vtkNew<vtkMatrix4x4> ModelToView;
  vtkNew<vtkMatrix4x4> ViewToDevice;
  SceneView View;
  Vector4 EyeModel;

  ViewState(vtkRenderer* renderer, vtkProp3D* prop, const double center[3])
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
    vtkMatrix4x4::Multiply4x4(prop->GetMatrix(), shift, this->ModelToView);
    vtkMatrix4x4::Multiply4x4(toView, this->ModelToView, this->ModelToView);

    this->View.ModelToView = this->ModelToView;
    this->View.ViewToDevice = this->ViewToDevice;
    this->FindEyes();
  }

private:
  void FindEyes()
  {
    Vector4 eyeView = FindEye(this->ViewToDevice);
    const bool parallel = IsParallelProjection(this->ViewToDevice);
    const double scale = parallel
      ? 1.0 / std::sqrt(eyeView[0] * eyeView[0] + eyeView[1] * eyeView[1] + eyeView[2] * eyeView[2])
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
