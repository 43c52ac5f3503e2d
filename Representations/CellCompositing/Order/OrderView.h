// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** From where, and with which pixels, a mesh is seen: all that its visibility order depends on. */
#ifndef OrderView_h
#define OrderView_h

#include "TetrahedronRay.h"
#include "ViewState.h"

#include <array>

namespace nephoscope
{

struct OrderView
{
  /** Relative to the centre of the geometry: (x, y, z, 1), or (direction towards the eye, 0). */
  Vector4 Eye = { { 0, 0, 1, 0 } };
  /** From coordinates relative to that centre to homogeneous device coordinates, row by row; nearer is smaller z. */
  std::array<double, 16> ModelToDevice = {};
  /** Pixels of the picture. 0: there is no picture, and parts of the mesh that share no face are not related. */
  int Width = 0, Height = 0;

  bool operator==(const OrderView& other) const
  {
    return this->Eye == other.Eye && this->ModelToDevice == other.ModelToDevice &&
      this->Width == other.Width && this->Height == other.Height;
  }
  bool operator!=(const OrderView& other) const { return !(*this == other); }
};

/** The view of a picture of so many pixels. */
inline OrderView orderView(const ViewState& state, int width, int height)
{
  OrderView view;
  view.Eye = state.EyeModel;
  vtkMatrix4x4::Multiply4x4(
    state.ViewToDevice->GetData(), state.ModelToView->GetData(), view.ModelToDevice.data());
  view.Width = width;
  view.Height = height;
  return view;
}

} // namespace nephoscope

#endif
