// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The cells of vtkCellCompositingMapper: from which arrays they are built, and in which form.
#include "vtkCellCompositingMapper.h"

#include "ArraySelection.h"
#include "CellCompositingInternals.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

using nephoscope::CellGeometry;
using nephoscope::CellScene;
using nephoscope::ScalarSelection;
using nephoscope::WithThreads;

namespace
{
// `hasParts`: polygons or layers, which need tetrahedra.
CellGeometry::Form FormOfCells(bool byRays, bool hasParts, int interpolation)
{
  using Form = CellGeometry::Form;
  if (!byRays)
  {
    return Form::Tetrahedra;
  }
  if (hasParts)
  {
    return Form::Grid;
  }
  if (interpolation == vtkCellCompositingMapper::TETRAHEDRA_INTERPOLATION)
  {
    return Form::WholeCells;
  }
  return interpolation == vtkCellCompositingMapper::TRILINEAR_INTERPOLATION ? Form::Hexahedra
                                                                            : Form::Automatic;
}
}

// Nothing that is asked for needs tetrahedra.
bool vtkCellCompositingMapper::MayCrossWholeCells() const
{
  return this->UsesRays() && !this->HasPolygonsOrLayers();
}

// The field of cells that rays cross as a whole.
bool vtkCellCompositingMapper::IsTrilinear() const
{
  return this->CellInterpolation != TETRAHEDRA_INTERPOLATION &&
    !this->Internals->Scene.GetGeometry().DividesHexahedra;
}

std::string vtkCellCompositingMapper::UpdateGeometry(
  vtkDataSet* input, vtkVolume* volume, const nephoscope::Progress& progress)
{
  CellScene& scene = this->Internals->Scene;
  ScalarSelection scalars, opacity;
  constexpr double longest = 1e16; // of data that rays and projection draw
  std::string error = nephoscope::CheckLengths(input, longest);
  if (error.empty())
  {
    error = nephoscope::SelectScalars(this, input, volume->GetProperty(), scalars);
  }
  if (error.empty())
  {
    error = nephoscope::SelectOpacity(this->OpacityArrayName, input, scalars, opacity);
  }
  vtkDataArray* layers = nullptr;
  if (error.empty())
  {
    this->WarnAboutContours(this->SelectContours(input, scalars, this->Internals->Contoured));
    error = this->SelectLayers(input, layers);
  }
  if (!error.empty())
  {
    scene.Clear();
    return error;
  }
  this->Internals->Light = nephoscope::CameraLight(input, scalars.Array);
  this->Internals->HasCameraLight = this->Internals->Light.IsUsed();
  if (!this->UsesRays() || !opacity.Array)
  {
    this->Internals->Light = nephoscope::CameraLight();
  }
  scalars.Headroom = this->Internals->Light.IsUsed() ? this->Internals->Light.Headroom() : 0;
  bool built = false;
  const CellGeometry::Form form =
    FormOfCells(this->UsesRays(), this->HasPolygonsOrLayers(), this->CellInterpolation);
  WithThreads([&]() {
    built = scene.UpdateGeometry(input, scalars, opacity, form, error, layers, progress);
  });
  this->Internals->Scalars = scalars;
  this->Internals->Opacity = opacity;
  this->Internals->Arrays[0] = scalars.Array;
  this->Internals->Arrays[1] = opacity.Array;
  if (built && error.empty())
  {
    this->WarnAboutGeometry(input, scene.GetGeometry(), scalars, opacity);
  }
  return error;
}
