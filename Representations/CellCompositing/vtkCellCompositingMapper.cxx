// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCellCompositingMapper.h"

#include "ArraySelection.h"
#include "CellCompositingInternals.h"
#include "CellsInOrder.h"
#include "ContourSettings.h"
#include "SceneLights.h"
#include "TrianglePass.h"
#include "ViewState.h"

#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"
#include "vtkUnstructuredGridBase.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>

using nephoscope::CellMethod;
using nephoscope::CellScene;
using nephoscope::WithThreads;

vtkStandardNewMacro(vtkCellCompositingMapper);

namespace
{
/** Mesa's software OpenGL ends the loops of a shader after 65,535 rounds in all. */
std::string LongRays(const nephoscope::CellGeometry& geometry, bool trilinear)
{
  const int* size = geometry.Grid.Size;
  const int longest = std::max({ size[0], size[1], size[2] }) - 1;
  const int most = geometry.Lattice.Found ? 20000 : trilinear ? 10000 : 6000;
  return longest <= most || geometry.Grid.IsEmpty() || !nephoscope::IsSoftwareOpenGL()
    ? std::string()
    : "Rays along the " + std::to_string(longest) +
      " cells of the grid's longest axis may lose what lies behind some " + std::to_string(most) +
      " cells: software OpenGL ends long loops. Do not look along this axis, take a part of the grid or every "
      "other point, or use a graphics card.";
}

/** What neither projection nor triangles and faces draw, and these alone. */
std::string LeftOut(
  const nephoscope::CellDrawingOptions& options, const CellScene& scene, bool projected)
{
  std::string list;
  const auto add = [&list](bool ignored, const char* what) {
    list += ignored ? (list.empty() ? "" : " and ") + std::string(what) : std::string();
  };
  add(!projected && options.Haze.IsOn(), "the haze of the renderer");
  add(!projected && !options.Planes.IsEmpty(), "the clipping planes");
  add(scene.GetContours().DrawsAny(), "the contour surfaces");
  add(scene.GetPolygons().IsUsed(), "the polygons");
  add(options.CameraLight, "light that depends on the direction of view");
  add(scene.ContoursMakeLayers(), "the layers between contour values");
  return list.empty() ? list
    : projected       ? "Projected cells are drawn without " + list + ": use another OpenGL driver."
                : "Triangles and faces are drawn without " + list + ": choose another method.";
}
}

vtkCellCompositingMapper::vtkCellCompositingMapper()
  : Internals(new vtkInternals)
{
  nephoscope::VolumeOrder::Enrol(this, nephoscope::CellsInOrder::PartOf([this]() { return this; }));
}

vtkCellCompositingMapper::~vtkCellCompositingMapper()
{
  nephoscope::VolumeOrder::Leave(this);
}

void vtkCellCompositingMapper::SetInputData(vtkDataSet* data)
{
  this->SetInputDataInternal(0, data);
}

void vtkCellCompositingMapper::SetInputData(vtkUnstructuredGridBase* data)
{
  this->SetInputDataInternal(0, data);
}

int vtkCellCompositingMapper::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(
    vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject"); // drawing tells what is no dataset
  return 1;
}

vtkIdType vtkCellCompositingMapper::GetNumberOfTetrahedra()
{
  return static_cast<vtkIdType>(this->Internals->Scene.GetGeometry().NumberOfTetrahedra());
}

int vtkCellCompositingMapper::GetNumberOfRayLayers()
{
  return this->Internals->Pass.GetNumberOfRayLayers();
}

vtkIdType vtkCellCompositingMapper::GetNumberOfDrawnTetrahedra()
{
  return static_cast<vtkIdType>(this->Internals->Scene.GetNumberOfVisible());
}

// Each step below leaves a message instead of a picture where it cannot go on.

void vtkCellCompositingMapper::Render(vtkRenderer* renderer, vtkVolume* volume)
{
  if (renderer->GetSelector())
  {
    this->DrawSelection(renderer, volume);
    return;
  }
  nephoscope::VolumeOrder::Draw(this, renderer, volume);
}

void vtkCellCompositingMapper::DrawInOrder(vtkRenderer* renderer, vtkVolume* volume)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!window || !this->GetInputAlgorithm() || this->Internals->Busy)
  {
    return; // without input there is nothing to draw
  }
  std::vector<vtkMedium> media = this->FindMedia(window, renderer, volume);
  if (media.front().Mapper != this)
  {
    return; // the first draws all
  }
  const auto isMissing = [&](const vtkMedium& medium) {
    medium.Mapper->Internals->Peeled = nephoscope::VolumePeel::IsRequested(medium.Volume);
    return !medium.Mapper->Prepare(window, renderer, medium.Volume);
  };
  media.erase(std::remove_if(media.begin(), media.end(), isMissing), media.end());
  this->DrawInTime(window, media);
}

// False where there is nothing to draw.
bool vtkCellCompositingMapper::Prepare(
  vtkOpenGLRenderWindow* window, vtkRenderer* renderer, vtkVolume* volume)
{
  this->GetInputAlgorithm()->Update();
  if (window->CheckAbortStatus())
  {
    return false;
  }
  vtkDataSet* input = this->GetDataSetInput();
  if (!input || input->GetNumberOfCells() == 0)
  {
    this->Internals->Scene.Clear();
    const std::string error = nephoscope::CheckIsDataSet(this->GetInputDataObject(0, 0));
    this->ReportOnce(error.empty() ? "The input has no cells: there is nothing to draw." : error);
    return false;
  }
  this->SetAbortExecute(0); // as filters do when they start
  const nephoscope::Progress progress([this, window](double fraction) {
    this->UpdateProgress(fraction);
    return !this->GetAbortExecute() && !window->CheckAbortStatus();
  });
  this->Internals->Busy = true;
  this->Internals->View.reset();
  this->Internals->Scene.ReadPolygons(input, *this->Contours);
  std::string error = this->ChooseWayOfDrawing(window);
  error = error.empty() ? this->UpdateGeometry(input, volume, progress.Part(0, 0.5)) : error;
  if (error.empty() && this->GetNumberOfTetrahedra() > 0)
  {
    error = this->PrepareScene(window, renderer, volume, progress.Part(0.5, 1));
  }
  this->Internals->Busy = false;
  this->ReportOnce(error);
  return error.empty() && this->Internals->View;
}

void vtkCellCompositingMapper::ReportOnce(const std::string& error)
{
  if (this->Internals->LastError.IsNew(error))
  {
    vtkErrorMacro(<< error);
  }
}

// Empty, or why the settings of the volume draw nothing.
std::string vtkCellCompositingMapper::CheckSettings(vtkVolumeProperty* property)
{
  const std::string wrongUnit = nephoscope::CheckUnitDistance(property);
  if (!wrongUnit.empty())
  {
    return wrongUnit;
  }
  if (property->GetScalarOpacity()->GetSize() == 0)
  {
    return "The scalar opacity function has no points, so that everything is transparent: add some with AddPoint.";
  }
  if (property->GetColorChannels() == 3 && property->GetRGBTransferFunction()->GetSize() == 0)
  {
    return "The colour function has no points: add some with AddRGBPoint.";
  }
  for (const auto& layer : this->Contours->LayerProperties)
  {
    if (!(layer.second->GetScalarOpacityUnitDistance() > 0))
    {
      return "ScalarOpacityUnitDistance of the property of layer " + std::to_string(layer.first) +
        " must be positive.";
    }
  }
  return nephoscope::ClippingPlanes::Check(this);
}

// Leaves the view where there is something to draw.
std::string vtkCellCompositingMapper::PrepareScene(vtkOpenGLRenderWindow* window,
  vtkRenderer* renderer, vtkVolume* volume, const nephoscope::Progress& progress)
{
  CellScene& scene = this->Internals->Scene;
  vtkVolumeProperty* property = volume->GetProperty();
  std::string error = this->CheckSettings(property);
  if (!error.empty())
  {
    return error;
  }
  this->Internals->Window.Enter(window);
  if (this->Internals->Uploaded < 0)
  {
    scene.RenewUploaded();
  }
  auto view = std::make_unique<nephoscope::ViewState>(renderer, volume, scene.GetGeometry().Center);
  bool ready = true;
  WithThreads([&]() {
    scene.UpdatePolygons(this->Internals->Scalars, *this->Contours, property);
    scene.UpdateTransferFunction(property,
      this->Internals->HasContours ? *this->Contours : this->Contours->WithoutSurfaces(),
      this->GetDataSetInput(), this->Internals->Contoured);
    this->Internals->OneColor = scene.HasOneColor();
    ready = this->UpdateOrder(view->EyeModel, progress.Part(0, 0.9));
    if (ready)
    {
      scene.UpdateDrawn();
    }
  });
  this->WarnAboutPolygons();
  this->WarnAboutContourValues();
  const bool upload = this->Internals->Uploaded < scene.GetVersions().Latest();
  if (!ready || window->CheckAbortStatus() || (upload && !progress.Report(0.92)))
  {
    return std::string();
  }
  error = this->Upload(window);
  if (error.empty() && (!upload || progress.Report(1)))
  {
    this->SetDrawingOptions(renderer, property);
    this->Internals->View = std::move(view);
  }
  return error;
}

double vtkCellCompositingMapper::GetBrightestCameraLight()
{
  return nephoscope::CameraLight::Brightest;
}

void vtkCellCompositingMapper::SetDrawingOptions(vtkRenderer* renderer, vtkVolumeProperty* property)
{
  const CellScene& scene = this->Internals->Scene;
  nephoscope::CellDrawingOptions& options = this->Internals->Options;
  options = nephoscope::CellDrawingOptions();
  options.CameraLight = this->Internals->HasCameraLight;
  options.Method = static_cast<CellMethod>(this->Method);
  options.AverageIntegration = this->Integration == AVERAGE_INTEGRATION;
  options.SplitAtControlPoints = this->SplitAtControlPoints;
  options.Trilinear = this->IsTrilinear();
  options.Eye = &scene.GetEyeTetrahedron();
  options.ExtinctionScale = std::min(this->OpacityScale / property->GetScalarOpacityUnitDistance(),
    scene.GetOpaqueExtinctionScale());
  options.Haze = nephoscope::HazeView(renderer);
  options.Planes = nephoscope::ClippingPlanes(this, renderer);
  options.ContourLayers = scene.ContoursMakeLayers();
  options.ContourLighting = this->Contours->Lighting;
  if (scene.GetContours().IsUsed() || scene.GetPolygons().IsUsed())
  {
    options.ContourShading = { { static_cast<float>(property->GetAmbient()),
      static_cast<float>(property->GetDiffuse()), static_cast<float>(property->GetSpecular()),
      static_cast<float>(property->GetSpecularPower()) } };
    options.Lights = nephoscope::DescribeLights(renderer);
  }
}

// What was prepared, alone.
std::string vtkCellCompositingMapper::DrawScene(vtkOpenGLRenderWindow* window, vtkVolume* volume)
{
  CellScene& scene = this->Internals->Scene;
  const nephoscope::ViewState& state = *this->Internals->View;
  const nephoscope::CellDrawingOptions& options = this->Internals->Options;
  this->Internals->Picture = nullptr;
  if (this->Internals->Peeled)
  {
    return this->UsesRays()
      ? this->Internals->Pass.DrawPeel(window, state.View, options, { this, volume })
      : std::string(
          "Projected cells, triangles and faces cannot be drawn between peeled surfaces: choose "
          "another method, or call UseDepthPeelingForVolumesOff() of the renderer.");
  }
  const std::string warning = this->UsesRays()
    ? LongRays(scene.GetGeometry(), options.Trilinear)
    : LeftOut(options, scene, !this->DrawsTrianglesOrFaces());
  if (this->Internals->LastWarning.IsNew(warning)) // once, not once per frame
  {
    vtkWarningMacro(<< warning);
  }
  if (options.Method == CellMethod::Faces)
  {
    return this->Internals->Pass.DrawLayer(
      window, [&](const int*, nephoscope::OpaqueDepth& opaqueDepth) {
        std::string failure;
        WithThreads([&]() {
          failure = this->Internals->Faces.Draw(window, scene, state.View, options,
            this->VisibilityOrder != NO_ORDER, opaqueDepth.GetTexture());
        });
        return failure;
      });
  }
  if (nephoscope::DrawsTriangles(options.Method))
  {
    this->WarnAboutUnprojected(nephoscope::CountUnprojected(scene.GetGeometry(), scene.GetDrawn(),
      state.View.ModelToView, state.View.EyeView, state.View.ViewToDevice));
  }
  return this->Internals->Pass.Draw(window, state.View, options);
}

void vtkCellCompositingMapper::WarnAboutUnprojected(vtkIdType count)
{
  if (count > 0 && !this->Internals->WarnedOfUnprojected) // once, not once per frame
  {
    vtkWarningMacro(
      << count
      << " tetrahedra are not drawn: they reach the plane of the eye, where they cannot be projected to "
         "triangles. Move the camera out of the data, or call SetMethodToCells().");
  }
  this->Internals->WarnedOfUnprojected = count > 0;
}

std::string vtkCellCompositingMapper::Upload(vtkOpenGLRenderWindow* window)
{
  vtkInternals& self = *this->Internals;
  CellScene& scene = self.Scene;
  const CellScene::Versions& now = scene.GetVersions();
  const auto isNew = [before = self.Uploaded](std::int64_t version) { return version > before; };
  std::string error;
  if (isNew(now.Geometry) || isNew(now.Topology))
  {
    error = self.Pass.UploadGeometry(window, scene.GetGeometry(), scene.GetNeighbors());
  }
  else
  {
    error =
      self.Pass.UploadValues(window, scene.GetGeometry(), isNew(now.Colors), isNew(now.Opacities));
  }
  if (error.empty() &&
    (isNew(now.Geometry) || isNew(now.Colors) || !(self.Light == self.UploadedLight)))
  {
    const double* range = scene.GetGeometry().ScalarRange;
    error = self.Pass.UploadCameraLight(window, self.Light, range[1] - range[0]);
    self.UploadedLight = self.Light;
  }
  if (error.empty() && isNew(now.Transfer))
  {
    error = self.Pass.UploadTransferFunctions(window, scene.GetTransferFunctions(),
      scene.GetOpacityFunctions(), scene.GetTablesOfTetrahedra());
  }
  if (error.empty() && isNew(now.Contours))
  {
    error = self.Pass.UploadContours(window, scene);
  }
  if (error.empty() && (isNew(now.Polygons) || isNew(now.Topology)))
  {
    error = self.Pass.UploadPolygons(
      window, scene.GetPolygons(), scene.GetGeometry(), scene.GetNeighbors());
  }
  if (error.empty() && isNew(now.Drawn))
  {
    error = self.Pass.UploadDrawn(window, scene);
  }
  self.Uploaded = error.empty() ? now.Latest() : -1;
  if (error.empty())
  {
    scene.ReleaseUploaded();
  }
  return error;
}

bool vtkCellCompositingMapper::CopyFloatImage(vtkImageData* image)
{
  if (this->Internals->Picture) // of several media
  {
    return this->Internals->Picture->CopyFloatImage(image);
  }
  vtkOpenGLRenderWindow* window = this->Internals->Window.Get();
  if (!window || !this->Internals->Pass.CopyFloatImage(window, image))
  {
    vtkErrorMacro("There is no float image: render first, without peeling volumes.");
    return false;
  }
  return true;
}

void vtkCellCompositingMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internals->Window.Leave(window);
  nephoscope::VolumeOrder::ReleaseGraphicsResources(this, window);
  this->Superclass::ReleaseGraphicsResources(window);
}
