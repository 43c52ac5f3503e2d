// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// How vtkCellCompositingMapper draws: ray by ray or cell by cell, and in which order, if any.
#include "vtkCellCompositingMapper.h"

#include "ArraySelection.h"
#include "CellCompositingInternals.h"
#include "ContourSettings.h"
#include "DrawingCheck.h"
#include "OrderIndependence.h"

#include "vtkDataSet.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

using nephoscope::CellGeometry;
using nephoscope::CellScene;
using nephoscope::checkLength;
using nephoscope::withThreads;

namespace
{
constexpr std::int64_t fewTetrahedra = 1 << 15;

nephoscope::TransferFunctionTable tableOf(vtkVolumeProperty* property, const CellGeometry& geometry)
{
  nephoscope::TransferFunctionTable table;
  table.Build(
    property, geometry.ScalarRange, nephoscope::TransferFunctionTable::Channels::ColorAndOpacity);
  return table;
}
}

void vtkCellCompositingMapper::SetMethod(int method)
{
  if (method < PROJECTION_METHOD || method > AUTOMATIC_METHOD)
  {
    vtkErrorMacro("There is no method " << method << ": use one of the values of MethodType, 0 to "
                                        << AUTOMATIC_METHOD << ".");
    return;
  }
  if (this->Method != method)
  {
    this->Method = method;
    this->Modified();
  }
}

CellScene::Cycles vtkCellCompositingMapper::vtkInternals::CountCycles(
  vtkCellCompositingMapper* self)
{
  CellScene::Cycles cycles;
  if (self->VisibilityOrder == EXACT_ORDER && !this->Busy &&
    this->Scene.GetGeometry().NumberOfTetrahedra() > 0)
  {
    withThreads([&]() {
      cycles = this->Scene.CountCycles([&]() {
        CellGeometry geometry;
        vtkDataSet* input = self->GetDataSetInput();
        if (input && this->Scalars.Array && checkLength(input, this->Scalars).empty() &&
          (!this->Opacity.Array || checkLength(input, this->Opacity).empty()))
        {
          geometry.Build(input, this->Scalars, this->Opacity);
        }
        return geometry;
      });
    });
  }
  return cycles;
}

vtkIdType vtkCellCompositingMapper::GetNumberOfVisibilityCycles()
{
  return static_cast<vtkIdType>(this->Internals->CountCycles(this).Number);
}

vtkIdType vtkCellCompositingMapper::GetNumberOfCyclicTetrahedra()
{
  return static_cast<vtkIdType>(this->Internals->CountCycles(this).Tetrahedra);
}

vtkIdType vtkCellCompositingMapper::GetNumberOfBrokenRelations()
{
  return this->UsesRays() || this->NeedsNoOrder()
    ? 0
    : static_cast<vtkIdType>(this->Internals->CountCycles(this).BrokenRelations);
}

bool vtkCellCompositingMapper::HasSurfacesOrLayers() const
{
  return this->GetNumberOfContourValues() > 0 || this->Contours->LayersAreUsed() ||
    this->Internals->Scene.GetPolygons().IsUsed();
}

bool vtkCellCompositingMapper::MayUseRays() const
{
  return !this->Internals->RaysAreWrong &&
    (this->Method == RAY_METHOD ||
      (this->Method == AUTOMATIC_METHOD && this->VisibilityOrder == EXACT_ORDER));
}

// Where this OpenGL does not draw right ray by ray, cells are projected; an error where that is not right either.
std::string vtkCellCompositingMapper::ChooseWayOfDrawing(vtkOpenGLRenderWindow* window)
{
  using nephoscope::DrawnBy;
  if (this->Method == FACES_METHOD)
  {
    return std::string(); // drawn by the processor
  }
  this->Internals->RaysAreWrong = false;
  if (this->MayUseRays())
  {
    const std::string wrong = nephoscope::checkDrawing(window, DrawnBy::Rays);
    if (this->Internals->RayWarning.IsNew(wrong))
    {
      vtkWarningMacro("This OpenGL driver does not draw rays correctly: "
        << wrong << ". Cells are projected instead, more slowly.");
    }
    this->Internals->RaysAreWrong = !wrong.empty();
  }
  const std::string wrong =
    this->MayUseRays() ? std::string() : nephoscope::checkDrawing(window, DrawnBy::Projection);
  return wrong.empty() ? wrong
                       : "This OpenGL driver does not draw cells correctly: " + wrong +
      ". Use another driver; the environment variable LIBGL_ALWAYS_SOFTWARE=1 selects Mesa's software driver.";
}

// Where no order is needed, a few cells are projected in less time.
bool vtkCellCompositingMapper::UsesRays() const
{
  const CellGeometry& geometry = this->Internals->Scene.GetGeometry();
  const bool many = !geometry.Grid.IsEmpty() || !geometry.Hexahedra.empty() ||
    geometry.NumberOfTetrahedra() > fewTetrahedra;
  return this->MayUseRays() &&
    (this->Method == RAY_METHOD || many || this->Internals->Mixed || !this->NeedsNoOrder());
}

// As hexahedra where rays can do all that is asked for, unless a few cells of one colour are projected.
bool vtkCellCompositingMapper::MayUseHexahedra() const
{
  return this->MayUseRays() && this->CellInterpolation == TRILINEAR_INTERPOLATION &&
    !this->Internals->Mixed && !this->Internals->ProjectsFew && !this->HasSurfacesOrLayers();
}

bool vtkCellCompositingMapper::WouldProjectFew(vtkVolume* volume) const
{
  const CellScene& scene = this->Internals->Scene;
  const CellGeometry& geometry = scene.GetGeometry();
  return this->CellInterpolation == TRILINEAR_INTERPOLATION && this->Method == AUTOMATIC_METHOD &&
    geometry.Grid.IsEmpty() && geometry.NumberOfTetrahedra() <= fewTetrahedra &&
    !this->HasSurfacesOrLayers() && volume->GetProperty()->GetScalarOpacity()->GetSize() > 0 &&
    nephoscope::hasOneColor(
      tableOf(volume->GetProperty(), geometry), 0.0f, geometry.SingleScalar ? 0.0f : 1.0f);
}

bool vtkCellCompositingMapper::NeedsNoOrder() const
{
  return this->Internals->OneColor && !this->HasSurfacesOrLayers() && this->Method != FACES_METHOD;
}

bool vtkCellCompositingMapper::GetOrderIndependent()
{
  return this->NeedsNoOrder() && !this->Internals->Peeled;
}

// What a way of drawing needs to know of who is in front of whom. False when stopped.
bool vtkCellCompositingMapper::UpdateOrder(
  const double eye[4], const nephoscope::Progress& progress)
{
  CellScene& scene = this->Internals->Scene;
  if (this->UsesRays())
  {
    const bool done = scene.UpdateMethod(CellScene::Method::Rays, progress);
    if (done)
    {
      scene.UpdateEye({ { eye[0], eye[1], eye[2], eye[3] } });
    }
    return done;
  }
  const bool none =
    this->NeedsNoOrder() || this->Method == FACES_METHOD; // faces have an order of their own
  const int order = none ? NO_ORDER : this->VisibilityOrder;
  return scene.UpdateMethod(CellScene::Method::Projection) &&
    scene.UpdateOrder(static_cast<CellScene::OrderMethod>(order), progress);
}
