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
#include "ReportedError.h"
#include "ResourceWindow.h"
#include "SamplesInTime.h"
#include "ScalarSelection.h"
#include "ViewState.h"

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"
#include "vtkVolume.h"
#include "vtkWeakPointer.h"

#include <cstdint>
#include <memory>
#include <string>

/** One of the volumes of a renderer that are drawn together. */
struct vtkCellCompositingMapper::vtkMedium
{
  vtkCellCompositingMapper* Mapper;
  vtkVolume* Volume;
};

struct vtkCellCompositingMapper::vtkInternals
{
  nephoscope::CellScene Scene;
  nephoscope::CellCompositingPass Pass;
  nephoscope::FacePass Faces;
  std::int64_t Uploaded = -1;            // version of the scene
  nephoscope::ScalarSelection Contoured; // array of the contours, if not the coloured one
  bool HasContours = true;               // there is an array for them
  bool WarnedOfUnprojected = false;
  nephoscope::ReportedError LastError, LastWarning, LeftOut, FoldWarning, RayWarning,
    ContourWarning, ContourValuesWarning, MediaWarnings[2], PolygonWarnings[2];
  bool OneColor = false;     // of the medium in the last render
  bool Peeled = false;       // the last render drew between translucent surfaces, or slices
  bool RaysAreWrong = false; // on the window's OpenGL
  bool Mixed = false;        // with other media, ray by ray
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
    this->Uploaded = -1;
  } };
};

#endif
