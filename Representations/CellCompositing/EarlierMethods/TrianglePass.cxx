// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TrianglePass.h"

#include "CellGeometry.h"
#include "ShaderParts.h"

#include "CellTrianglesFragment.h"
#include "CellTrianglesGeometry.h"
#include "OpacityTableShader.h"
#include "ProjectedTrianglesShader.h"

#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"

#include <atomic>

namespace nephoscope
{

const char* TriangleGeometryShader()
{
  return CellTrianglesGeometry;
}

const char* TriangleFragmentShader()
{
  return CellTrianglesFragment;
}

std::string WithTriangleShaders(const char* shader)
{
  return WithShaderParts(shader,
    { { "ProjectedTriangles", ProjectedTrianglesShader }, { "OpacityTable", OpacityTableShader } });
}

double SmallestEyeDepth(const double eyeView[4], vtkMatrix4x4* viewToDevice)
{
  vtkNew<vtkMatrix4x4> deviceToView;
  vtkMatrix4x4::Invert(viewToDevice, deviceToView);
  const double onNearPlane[4] = { 0, 0, -1, 1 };
  double near[4];
  deviceToView->MultiplyPoint(onNearPlane, near);
  return 0.1 * (eyeView[3] * eyeView[2] - near[2] / near[3]);
}

std::int64_t CountUnprojected(const CellGeometry& geometry, const std::vector<std::int32_t>& drawn,
  vtkMatrix4x4* modelToView, const double eyeView[4], vtkMatrix4x4* viewToDevice)
{
  if (eyeView[3] == 0)
  {
    return 0; // a parallel projection projects everything
  }
  const double smallest = SmallestEyeDepth(eyeView, viewToDevice);
  const double* row = modelToView->GetData() + 8;
  const auto projects = [&](std::int32_t point) {
    const Vector3 p = geometry.Position(point);
    return eyeView[2] - (row[0] * p[0] + row[1] * p[1] + row[2] * p[2] + row[3]) > smallest;
  };
  std::atomic<std::int64_t> count(0);
  vtkSMPTools::For(0, static_cast<vtkIdType>(drawn.size()), [&](vtkIdType begin, vtkIdType end) {
    std::int64_t own = 0;
    for (vtkIdType i = begin; i < end; ++i)
    {
      const std::size_t number = static_cast<std::size_t>(drawn[static_cast<std::size_t>(i)]);
      const Tetrahedron& t = geometry.Tetrahedra[number];
      own += !(projects(t[0]) && projects(t[1]) && projects(t[2]) && projects(t[3]));
    }
    count += own;
  });
  return count;
}

} // namespace nephoscope
