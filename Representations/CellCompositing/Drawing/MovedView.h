// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** The view from where the rays start instead of from the eye. */
#ifndef nephoscope_MovedView_h
#define nephoscope_MovedView_h

#include "CellDrawing.h"
#include "EyeTetrahedron.h"

#include "vtkMatrix4x4.h"
#include "vtkNew.h"

namespace nephoscope
{

struct MovedView
{
  vtkNew<vtkMatrix4x4> ModelToView;
  CellView View;

  MovedView(const CellView& view, const EyeTetrahedron& eye)
    : View(view)
  {
    vtkNew<vtkMatrix4x4> shift;
    for (int axis = 0; eye.Found && axis < 3; ++axis)
    {
      shift->SetElement(axis, 3, view.EyeModel[axis] - eye.Start[axis]);
      this->View.EyeModel[axis] = eye.Start[axis];
    }
    vtkMatrix4x4::Multiply4x4(view.ModelToView, shift, this->ModelToView);
    this->View.ModelToView = this->ModelToView;
  }
};

} // namespace nephoscope

#endif
