// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// How vtkCellCompositingMapper draws: ray by ray or cell by cell, and in which order, if any.
#include "vtkCellCompositingMapper.h"

#include "CellCompositingInternals.h"
#include "ContourSettings.h"
#include "DrawingCheck.h"

using nephoscope::CellScene;

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

vtkIdType vtkCellCompositingMapper::GetNumberOfVisibilityCycles()
{
  return static_cast<vtkIdType>(this->Internals->Scene.GetOrder().NumberOfCycles);
}

vtkIdType vtkCellCompositingMapper::GetNumberOfCyclicTetrahedra()
{
  return static_cast<vtkIdType>(this->Internals->Scene.GetOrder().NumberOfCyclicTetrahedra);
}

vtkIdType vtkCellCompositingMapper::GetNumberOfBrokenRelations()
{
  return static_cast<vtkIdType>(this->Internals->Scene.GetOrder().NumberOfBrokenRelations);
}

bool vtkCellCompositingMapper::HasSurfacesOrLayers() const
{
  return this->GetNumberOfContourValues() > 0 || this->HasPolygonsOrLayers();
}

bool vtkCellCompositingMapper::HasPolygonsOrLayers() const
{
  return this->Contours->LayersAreUsed() || this->Internals->Scene.GetPolygons().IsUsed();
}

bool vtkCellCompositingMapper::DrawsTrianglesOrFaces() const
{
  return this->Method == TRIANGLES_LINEAR_METHOD || this->Method == TRIANGLES_TABLE_METHOD ||
    this->Method == FACES_METHOD;
}

// Where they are chosen, or cells are to be projected with what projection cannot draw: surfaces
// among them.
bool vtkCellCompositingMapper::UsesRays() const
{
  const bool chosen = this->Method == RAY_METHOD ||
    (this->Method == AUTOMATIC_METHOD && this->VisibilityOrder == EXACT_ORDER);
  const bool surfaces = this->Internals->Peeled || this->GetNumberOfContourValues() > 0 ||
    this->Internals->Scene.GetPolygons().IsUsed();
  return !this->Internals->RaysAreWrong && (chosen || (surfaces && !this->DrawsTrianglesOrFaces()));
}

// Where this OpenGL does not draw right ray by ray, cells are projected; an error where that is not
// right either.
std::string vtkCellCompositingMapper::ChooseWayOfDrawing(vtkOpenGLRenderWindow* window)
{
  using nephoscope::DrawnBy;
  if (this->Method == FACES_METHOD)
  {
    return std::string(); // drawn by the processor
  }
  this->Internals->RaysAreWrong = false;
  if (this->UsesRays())
  {
    const std::string wrong = nephoscope::CheckDrawing(window, DrawnBy::Rays);
    if (this->Internals->RayWarning.IsNew(wrong))
    {
      vtkWarningMacro("This OpenGL driver does not draw rays correctly: "
        << wrong << ". Cells are projected instead, more slowly.");
    }
    this->Internals->RaysAreWrong = !wrong.empty();
  }
  const std::string wrong =
    this->UsesRays() ? std::string() : nephoscope::CheckDrawing(window, DrawnBy::Projection);
  return wrong.empty() ? wrong
                       : "This OpenGL driver does not draw cells correctly: " + wrong +
      ". Use another driver; the environment variable LIBGL_ALWAYS_SOFTWARE=1 selects Mesa's software driver.";
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
  const nephoscope::Vector4& eye, const nephoscope::Progress& progress)
{
  CellScene& scene = this->Internals->Scene;
  if (this->UsesRays())
  {
    const bool done = scene.UpdateMethod(CellScene::Method::Rays, progress);
    if (done)
    {
      scene.UpdateEye(eye);
    }
    return done;
  }
  const bool none =
    this->NeedsNoOrder() || this->Method == FACES_METHOD; // faces have an order of their own
  const int order = none ? NO_ORDER : this->VisibilityOrder;
  return scene.UpdateMethod(CellScene::Method::Projection) &&
    scene.UpdateOrder(static_cast<nephoscope::ProjectionOrder::Kind>(order), eye, progress);
}
