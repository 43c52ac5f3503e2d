// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ClippingPlanes.h"

#include "ClippingPlanesShader.h"

#include "vtkAbstractMapper.h"
#include "vtkBoundingBox.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOpenGLCamera.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nephoscope
{
namespace
{
constexpr int mostPlanes = 64; // for which every OpenGL has uniforms

int NumberOfPlanes(vtkAbstractMapper* mapper)
{
  return mapper->GetClippingPlanes() ? mapper->GetClippingPlanes()->GetNumberOfItems() : 0;
}
}

std::string ClippingPlanes::Check(vtkAbstractMapper* mapper)
{
  const int count = NumberOfPlanes(mapper);
  if (count > mostPlanes)
  {
    return "There are " + std::to_string(count) + " clipping planes, but at most " +
      std::to_string(mostPlanes) + " are supported: remove some with RemoveClippingPlane.";
  }
  for (int i = 0; i < count; ++i)
  {
    double values[6];
    mapper->GetClippingPlanes()->GetItem(i)->GetNormal(values);
    mapper->GetClippingPlanes()->GetItem(i)->GetOrigin(values + 3);
    const double square = values[0] * values[0] + values[1] * values[1] + values[2] * values[2];
    if (!(square > 0) || !std::isfinite(square + values[3] + values[4] + values[5]))
    {
      return "Clipping plane " + std::to_string(i) +
        " needs a finite origin, and a finite normal that is not 0: call SetOrigin and SetNormal of the vtkPlane.";
    }
  }
  return std::string();
}

// A plane is a row that points are multiplied by, and goes with the inverse matrix.
ClippingPlanes::Plane ClippingPlanes::ToView(
  const double origin[3], const double normal[3], vtkMatrix4x4* worldToView)
{
  const double length =
    std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
  const double place[4] = { origin[0], origin[1], origin[2], 1 };
  double placeView[4];
  worldToView->MultiplyPoint(place, placeView);
  vtkNew<vtkMatrix4x4> viewToWorld;
  vtkMatrix4x4::Invert(worldToView, viewToWorld);
  double normalView[3], square = 0;
  for (int column = 0; column < 3; ++column)
  {
    normalView[column] = 0;
    for (int row = 0; row < 3; ++row)
    {
      normalView[column] += normal[row] / length * viewToWorld->GetElement(row, column);
    }
    square += normalView[column] * normalView[column];
  }
  Plane plane;
  double offset = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double n = normalView[axis] / std::sqrt(square);
    plane[axis] = static_cast<float>(n);
    offset -= n * placeView[axis];
  }
  plane[3] = static_cast<float>(offset);
  return plane;
}

ClippingPlanes::ClippingPlanes(vtkAbstractMapper* mapper, vtkRenderer* renderer)
{
  const int count = NumberOfPlanes(mapper);
  auto* camera = vtkOpenGLCamera::SafeDownCast(renderer->GetActiveCamera());
  if (count == 0 || !camera)
  {
    return;
  }
  vtkMatrix4x4 *worldToView, *viewToDevice, *worldToDevice; // transposed, as OpenGL wants them
  vtkMatrix3x3* normals;
  camera->GetKeyMatrices(renderer, worldToView, normals, viewToDevice, worldToDevice);
  vtkNew<vtkMatrix4x4> toView;
  vtkMatrix4x4::Transpose(worldToView, toView);
  for (int i = 0; i < count; ++i)
  {
    double origin[3], normal[3];
    mapper->GetClippingPlanes()->GetItem(i)->GetOrigin(origin);
    mapper->GetClippingPlanes()->GetItem(i)->GetNormal(normal);
    this->Planes.push_back(ToView(origin, normal, toView));
  }
}

void ClippingPlanes::AddPlanesOfCamera(vtkRenderer* renderer, const double bounds[6])
{
  constexpr double negligible = 5e-3; // of the diagonal
  vtkCamera* camera = renderer->GetActiveCamera();
  const vtkBoundingBox box(bounds);
  if (!box.IsValid() || this->Planes.size() + 2 > mostPlanes)
  {
    return;
  }
  double least = std::numeric_limits<double>::infinity(),
         greatest = -least; // distances from the plane of the eye
  for (int corner = 0; corner < 8; ++corner)
  {
    double place[4] = { 0, 0, 0, 1 };
    box.GetCorner(corner, place);
    camera->GetViewTransformMatrix()->MultiplyPoint(place, place);
    least = std::min(least, -place[2]);
    greatest = std::max(greatest, -place[2]);
  }
  const double* range = camera->GetClippingRange();
  const bool isAtEye =
    !camera->GetParallelProjection() && range[0] < negligible * box.GetDiagonalLength();
  if (least < range[0] && !isAtEye)
  {
    this->Planes.push_back({ { 0, 0, -1, static_cast<float>(-range[0]) } });
  }
  if (greatest > range[1])
  {
    this->Planes.push_back({ { 0, 0, 1, static_cast<float>(range[1]) } });
  }
}

std::string ClippingPlanes::Definition() const
{
  return this->Planes.empty() ? std::string()
                              : "#define CLIPPING_PLANES " + std::to_string(this->Planes.size()) +
      "\n" + ClippingPlanesShader;
}

void ClippingPlanes::SetUniforms(vtkShaderProgram* program, const char* name) const
{
  if (!this->Planes.empty() && program->IsUniformUsed(name))
  {
    // The declaration of SetUniform4fv wants an array of arrays.
    program->SetUniform4fv(name, static_cast<int>(this->Planes.size()),
      reinterpret_cast<const float(*)[4]>(this->Planes.data()));
  }
}

} // namespace nephoscope
