// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** What vtkCellCompositingMapper keeps, for the files that it is written in. */
#ifndef nephoscope_CellCompositingInternals_h
#define nephoscope_CellCompositingInternals_h

#include "vtkCellCompositingMapper.h"

#include "CameraLight.h"
#include "CellCompositingPass.h"
#include "CellScene.h"
#include "FacePass.h"
#include "OwnThreads.h"
#include "PickDrawing.h"
#include "ReportedError.h"
#include "ResourceWindow.h"
#include "SamplesInTime.h"
#include "ScalarSelection.h"
#include "ViewState.h"

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"
#include "vtkVolume.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

/** One of the volumes of a renderer that are drawn together. */
struct vtkCellCompositingMapper::vtkMedium
{
  vtkCellCompositingMapper* Mapper;
  vtkVolume* Volume;
};

namespace nephoscope
{
/**
 * What a selector finds, pixel by pixel; in a large area square by square, each at one of its
 * pixels.
 */
struct SelectedPixels
{
  static constexpr double MostRays = 256 * 256;
  struct Pixel
  {
    std::int64_t Cell = -1, Point = -1; // of the input
    double Depth = -1;                  // in the window
  };
  std::array<int, 2> First = { { 0, 0 } }, Size = { { 0, 0 } }; // in pixels
  int Width = 1;                                                // of a square, in pixels
  std::vector<Pixel> Pixels;                                    // of the squares, row by row

  bool IsEmpty() const { return this->Size[0] <= 0 || this->Size[1] <= 0; }
  void ChooseWidth()
  {
    this->Width = std::max(
      static_cast<int>(std::ceil(std::sqrt(double(this->Size[0]) * this->Size[1] / MostRays))), 1);
  }
  std::array<int, 2> Squares() const
  {
    return { { (this->Size[0] + this->Width - 1) / this->Width,
      (this->Size[1] + this->Width - 1) / this->Width } };
  }
  /** The centre of a square's pixel, in pixels of the window along an axis. */
  double Center(std::size_t axis, int number) const
  {
    return this->First[axis] +
      std::min(number * this->Width + this->Width / 2, this->Size[axis] - 1) + 0.5;
  }
};
}

struct vtkCellCompositingMapper::vtkInternals
{
  nephoscope::CellScene Scene;
  nephoscope::CellCompositingPass Pass;
  nephoscope::FacePass Faces;
  nephoscope::PickDrawing Selection;
  nephoscope::SelectedPixels Selected;   // of the selector's last first pass
  std::int64_t Uploaded = -1;            // version of the scene
  nephoscope::ScalarSelection Contoured; // array of the contours, if not the coloured one
  bool HasContours = true;               // there is an array for them
  bool WarnedOfUnprojected = false;
  nephoscope::ReportedError LastError, LastWarning, LeftOut, FoldWarning, RayWarning,
    ContourWarning, ContourValuesWarning, MediaWarnings[2], PolygonWarnings[2];
  bool OneColor = false;     // of the medium in the last render
  bool Peeled = false;       // the last render drew between translucent surfaces, or slices
  bool RaysAreWrong = false; // on the window's OpenGL
  bool MediaRefused = false; // by the compiler of shaders
  vtkWeakPointer<vtkCellCompositingMapper>
    Picture; // drew the last one with other media, if not this mapper
  std::unique_ptr<nephoscope::ViewState> View; // of what has been prepared to be drawn
  nephoscope::CellDrawingOptions Options;
  nephoscope::SamplesInTime Samples;            // while the camera moves
  bool Busy = false;                            // who hears of progress may call in between
  nephoscope::ScalarSelection Scalars, Opacity; // of the geometry, and what keeps them
  vtkSmartPointer<vtkDataArray> Arrays[2];
  nephoscope::CameraLight Light, UploadedLight;
  bool HasCameraLight = false; // the data have it, whether or not this can draw it

  nephoscope::ResourceWindow Window{ [this](vtkWindow* window) {
    this->Pass.ReleaseGraphicsResources(window);
    this->Faces.ReleaseGraphicsResources(window);
    this->Selection.ReleaseGraphicsResources(window);
    this->Uploaded = -1;
  } };
};

#endif
