// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCellCompositingMapper.h"

#include "ArraySelection.h"
#include "CellCompositingInternals.h"
#include "CellsInOrder.h"
#include "ContourSettings.h"
#include "MapperSettings.h"
#include "OrderView.h"
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

using nephoscope::CellGeometry;
using nephoscope::CellMethod;
using nephoscope::CellScene;
using nephoscope::ScalarSelection;
using nephoscope::withThreads;

vtkStandardNewMacro(vtkCellCompositingMapper);

namespace
{
std::string ignoredByEarlierMethods(
  const nephoscope::CellDrawingOptions& options, const CellScene& scene)
{
  std::string list;
  const auto add = [&list](bool ignored, const char* what) {
    list += ignored ? (list.empty() ? "" : " and ") + std::string(what) : std::string();
  };
  add(options.Haze.IsOn(), "the haze of the renderer");
  add(!options.Planes.IsEmpty(), "the clipping planes");
  add(scene.GetContours().DrawsAny(), "the contour surfaces");
  add(scene.GetPolygons().IsUsed(), "the polygons");
  add(scene.ContoursMakeLayers(), "the layers between contour values");
  return list;
}
}

vtkCellCompositingMapper::vtkCellCompositingMapper()
  : Internals(new vtkInternals)
  , Contours(new nephoscope::ContourSettings)
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
  nephoscope::VolumeOrder::Draw(this, renderer, volume);
}

void vtkCellCompositingMapper::DrawInOrder(vtkRenderer* renderer, vtkVolume* volume)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!window || renderer->GetSelector() || !this->GetInputAlgorithm() || this->Internals->Busy)
  {
    return; // Pick() finds cells, no colours do; and without input there is nothing to draw
  }
  std::vector<vtkMedium> media = this->FindMedia(window, renderer, volume);
  if (media.front().Mapper != this)
  {
    return; // the first draws all
  }
  const bool several = media.size() > 1;
  const auto isMissing = [&](const vtkMedium& medium) {
    medium.Mapper->Internals->Mixed = several;
    return !medium.Mapper->Prepare(window, renderer, medium.Volume);
  };
  media.erase(std::remove_if(media.begin(), media.end(), isMissing), media.end());
  this->DrawMedia(window, media);
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
    const std::string error = nephoscope::checkIsDataSet(this->GetInputDataObject(0, 0));
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
  const bool few = error.empty() && this->WouldProjectFew(volume);
  if (error.empty() && few != this->Internals->ProjectsFew)
  {
    this->Internals->ProjectsFew = few;
    error = this->UpdateGeometry(input, volume, progress.Part(0, 0.5));
  }
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

std::string vtkCellCompositingMapper::UpdateGeometry(
  vtkDataSet* input, vtkVolume* volume, const nephoscope::Progress& progress)
{
  CellScene& scene = this->Internals->Scene;
  ScalarSelection scalars, opacity;
  constexpr double longest = 1e16; // of data that rays and projection draw
  std::string error = nephoscope::checkLengths(input, longest);
  if (error.empty())
  {
    error = nephoscope::selectScalars(this, input, volume->GetProperty(), scalars);
  }
  if (error.empty())
  {
    error = nephoscope::selectOpacity(this->OpacityArrayName, input, scalars, opacity);
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
  bool built = false;
  const auto form = this->MayUseHexahedra() ? CellGeometry::Form::Hexahedra
    : this->MayUseRays()                    ? CellGeometry::Form::Grid
                                            : CellGeometry::Form::Tetrahedra;
  withThreads([&]() {
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

// Leaves the view where there is something to draw.
std::string vtkCellCompositingMapper::PrepareScene(vtkOpenGLRenderWindow* window,
  vtkRenderer* renderer, vtkVolume* volume, const nephoscope::Progress& progress)
{
  CellScene& scene = this->Internals->Scene;
  vtkVolumeProperty* property = volume->GetProperty();
  const double unitDistance = property->GetScalarOpacityUnitDistance();
  const std::string wrongUnit = nephoscope::checkUnitDistance(property);
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
  const std::string wrongPlanes = nephoscope::ClippingPlanes::Check(this);
  if (!wrongPlanes.empty())
  {
    return wrongPlanes;
  }
  auto view = std::make_unique<nephoscope::ViewState>(renderer, volume, scene.GetGeometry().Center);
  const nephoscope::ViewState& state = *view;
  int width, height, lowerLeft[2];
  renderer->GetTiledSizeAndOrigin(&width, &height, &lowerLeft[0], &lowerLeft[1]);
  scene.UpdateView(nephoscope::orderView(state, width, height));
  bool ready = true;
  withThreads([&]() {
    scene.UpdatePolygons(this->Internals->Scalars, *this->Contours, property);
    scene.UpdateTransferFunction(property,
      this->Internals->HasContours ? *this->Contours : this->Contours->WithoutSurfaces(),
      this->GetDataSetInput(), this->Internals->Contoured);
    this->Internals->OneColor = scene.HasOneColor();
    ready = this->UpdateOrder(state.EyeModel.data(), progress.Part(0, 0.9));
    if (ready)
    {
      scene.UpdateDrawn();
    }
  });
  this->WarnAboutPolygons();
  const bool upload = this->Internals->IsUploadNeeded();
  if (!ready || window->CheckAbortStatus() || (upload && !progress.Report(0.92)))
  {
    return std::string();
  }
  const std::string error = this->Upload(window);
  if (!error.empty())
  {
    return error;
  }
  if (upload && !progress.Report(1))
  {
    return std::string();
  }
  nephoscope::CellDrawingOptions& options = this->Internals->Options;
  options = nephoscope::CellDrawingOptions();
  options.Method = static_cast<CellMethod>(this->Method);
  options.AverageIntegration = this->Integration == AVERAGE_INTEGRATION;
  options.SplitAtControlPoints = this->SplitAtControlPoints;
  options.Trilinear = this->CellInterpolation == TRILINEAR_INTERPOLATION;
  options.Eye = &scene.GetEyeTetrahedron();
  options.ExtinctionScale = this->OpacityScale / unitDistance;
  options.Haze = nephoscope::HazeView(renderer);
  options.Planes = nephoscope::ClippingPlanes(this, renderer);
  options.ContourLayers = scene.ContoursMakeLayers();
  options.ContourLighting = this->Contours->Lighting;
  if (scene.GetContours().IsUsed() || scene.GetPolygons().IsUsed())
  {
    options.ContourShading = { { static_cast<float>(property->GetAmbient()),
      static_cast<float>(property->GetDiffuse()), static_cast<float>(property->GetSpecular()),
      static_cast<float>(property->GetSpecularPower()) } };
    options.Lights = nephoscope::describeLights(renderer);
  }
  this->Internals->View = std::move(view);
  return std::string();
}

// What was prepared, alone.
std::string vtkCellCompositingMapper::DrawScene(vtkOpenGLRenderWindow* window, vtkVolume* volume)
{
  CellScene& scene = this->Internals->Scene;
  const nephoscope::ViewState& state = *this->Internals->View;
  const nephoscope::CellDrawingOptions& options = this->Internals->Options;
  this->Internals->Picture = nullptr;
  this->Internals->Peeled = nephoscope::VolumePeel::IsRequested(volume);
  if (this->Internals->Peeled)
  {
    return options.Method != CellMethod::Faces && !nephoscope::drawsTriangles(options.Method)
      ? this->Internals->Pass.DrawPeel(window, state.View, options, { this, volume })
      : std::string(
          "Projected triangles and faces cannot be drawn between peeled surfaces: choose another method, or call "
          "UseDepthPeelingForVolumesOff() of the renderer.");
  }
  const bool earlier =
    options.Method == CellMethod::Faces || nephoscope::drawsTriangles(options.Method);
  const std::string ignored = earlier ? ignoredByEarlierMethods(options, scene) : std::string();
  const std::string warning = ignored.empty()
    ? ""
    : "Triangles and faces are drawn without " + ignored + ": choose another method.";
  if (this->Internals->LastWarning.IsNew(warning)) // once, not once per frame
  {
    vtkWarningMacro(<< warning);
  }
  if (options.Method == CellMethod::Faces)
  {
    return this->Internals->Pass.DrawLayer(
      window, [&](const int*, nephoscope::OpaqueDepth& opaqueDepth) {
        std::string failure;
        withThreads([&]() {
          failure = this->Internals->Faces.Draw(window, scene, state.View, options,
            this->VisibilityOrder != NO_ORDER, opaqueDepth.GetTexture());
        });
        return failure;
      });
  }
  if (nephoscope::drawsTriangles(options.Method))
  {
    this->WarnAboutUnprojected(nephoscope::countUnprojected(scene.GetGeometry(), scene.GetDrawn(),
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
  self.Window.Enter(window);
  const CellScene::Versions& now = self.Scene.GetVersions();
  std::string error;
  const CellScene::Versions& before = self.Uploaded;
  if (before.Geometry != now.Geometry || before.Pieces != now.Pieces ||
    before.Topology != now.Topology)
  {
    error = self.Pass.UploadGeometry(
      window, self.Scene.GetGeometry(), self.Scene.GetPieces(), self.Scene.GetNeighbors());
  }
  else
  {
    error = self.Pass.UploadValues(window, self.Scene.GetGeometry(), self.Scene.GetPieces(),
      before.Colors != now.Colors, before.Opacities != now.Opacities);
  }
  if (error.empty() &&
    (self.Uploaded.Transfer != now.Transfer || self.Uploaded.Pieces != now.Pieces))
  {
    std::vector<std::int32_t> tables = self.Scene.GetTablesOfTetrahedra();
    if (!tables.empty())
    {
      for (const std::int32_t owner : self.Scene.GetPieces().Owners)
      {
        tables.push_back(tables[static_cast<std::size_t>(owner)]);
      }
    }
    error = self.Pass.UploadTransferFunctions(
      window, self.Scene.GetTransferFunctions(), self.Scene.GetOpacityFunctions(), tables);
  }
  if (error.empty() && self.UploadedContours != self.Scene.GetContours().Version)
  {
    error = self.Pass.UploadContours(window, self.Scene.GetContours());
    self.UploadedContours = self.Scene.GetContours().Version;
  }
  const std::int64_t polygons = self.Scene.GetPolygons().Version;
  if (error.empty() &&
    (self.UploadedPolygons != polygons || before.Pieces != now.Pieces ||
      before.Topology != now.Topology))
  {
    error = self.Pass.UploadPolygons(window, self.Scene.GetPolygons(), self.Scene.GetGeometry(),
      self.Scene.GetPieces(), self.Scene.GetNeighbors());
    self.UploadedPolygons = polygons;
  }
  if (error.empty() && self.Uploaded.Drawn != now.Drawn)
  {
    error = self.Pass.UploadDrawn(window, self.Scene);
  }
  self.Uploaded = error.empty() ? now : CellScene::Versions();
  self.UploadedContours = error.empty() ? self.UploadedContours : -1;
  self.UploadedPolygons = error.empty() ? self.UploadedPolygons : -1;
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

void vtkCellCompositingMapper::ShallowCopy(vtkAbstractMapper* other)
{
  auto* mapper = vtkCellCompositingMapper::SafeDownCast(other);
  if (mapper == this)
  {
    return;
  }
  this->Superclass::ShallowCopy(other);
  if (mapper)
  {
    nephoscope::copyVolumeSettings(mapper, this);
    this->SetBlendMode(mapper->BlendMode);
    this->SetMethod(mapper->Method);
    this->SetIntegration(mapper->Integration);
    this->SetCellInterpolation(mapper->CellInterpolation);
    this->SetVisibilityOrder(mapper->VisibilityOrder);
    this->SetOpacityScale(mapper->OpacityScale);
    this->SetOpacityArrayName(mapper->OpacityArrayName);
    this->SetSplitAtControlPoints(mapper->SplitAtControlPoints);
    this->SetPickOpacity(mapper->PickOpacity);
    *this->Contours = *mapper->Contours;
    this->Modified();
  }
}

void vtkCellCompositingMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const char* methods[] = { "Projection", "Rays", "TrianglesLinear", "TrianglesTable", "Faces",
    "Automatic" };
  os << indent << "Method: " << methods[this->Method] << "\n";
  os << indent << "Integration: " << (this->Integration == EXACT_INTEGRATION ? "Exact" : "Average")
     << "\n";
  os << indent << "CellInterpolation: "
     << (this->CellInterpolation == TRILINEAR_INTERPOLATION ? "Trilinear" : "Tetrahedra") << "\n";
  const char* orders[] = { "Exact", "Centroid", "None" };
  os << indent << "VisibilityOrder: " << orders[this->VisibilityOrder] << "\n";
  os << indent << "OpacityScale: " << this->OpacityScale << "\n";
  os << indent << "OpacityArrayName: " << this->OpacityArrayName << "\n";
  os << indent << "SplitAtControlPoints: " << this->SplitAtControlPoints << "\n";
  os << indent << "PickOpacity: " << this->PickOpacity << "\n";
  this->PrintContours(os, indent);
  os << indent << "NumberOfTetrahedra: " << this->GetNumberOfTetrahedra() << "\n";
  os << indent << "NumberOfDrawnTetrahedra: " << this->GetNumberOfDrawnTetrahedra() << "\n";
  os << indent << "NumberOfRayLayers: " << this->GetNumberOfRayLayers() << "\n";
  os << indent << "OrderIndependent: " << this->GetOrderIndependent() << "\n";
  if (!this->UsesRays() && !this->NeedsNoOrder()) // which would have to make an order for it
  {
    os << indent << "NumberOfVisibilityCycles: " << this->GetNumberOfVisibilityCycles() << "\n";
    os << indent << "NumberOfCyclicTetrahedra: " << this->GetNumberOfCyclicTetrahedra() << "\n";
    os << indent << "NumberOfBrokenRelations: " << this->GetNumberOfBrokenRelations() << "\n";
  }
}
