// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGLFunctions.h"

#include "DrawingCheck.h"

#include "CellCompositingPass.h"
#include "CellDrawing.h"
#include "CellScene.h"
#include "SavedState.h"

#include "vtkCellType.h"
#include "vtkColorTransferFunction.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace nephoscope
{
namespace
{
constexpr int pictureSize = 16;       // pixels
constexpr double largestError = 2e-3; // of light and opacity: wrong pictures err by far more
constexpr double distance = 7;        // of the eye from the centre
constexpr double slope = 0.25;        // of the ray through the edge of the picture

using Plane = std::array<double, 4>; // inside where x a + y b + z c + d >= 0

vtkSmartPointer<vtkDoubleArray> AddScalars(vtkDataSet* data)
{
  auto values = vtkSmartPointer<vtkDoubleArray>::New();
  values->SetName("s");
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    values->InsertNextValue(static_cast<double>(i));
  }
  data->GetPointData()->SetScalars(values);
  return values;
}

vtkSmartPointer<vtkDataSet> MakeTetrahedron(std::vector<Plane>& planes)
{
  auto data = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  const double corners[4][3] = { { 0, 0, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, { 0, 0, 2 } };
  for (const auto& corner : corners)
  {
    points->InsertNextPoint(corner);
  }
  data->SetPoints(points);
  const vtkIdType ids[4] = { 0, 1, 2, 3 };
  data->InsertNextCell(VTK_TETRA, 4, ids);
  planes = { { { 1, 0, 0, 0 } }, { { 0, 1, 0, 0 } }, { { 0, 0, 1, 0 } }, { { -1, -1, -1, 2 } } };
  return data;
}

vtkSmartPointer<vtkDataSet> MakeCell(std::vector<Plane>& planes)
{
  auto data = vtkSmartPointer<vtkImageData>::New();
  data->SetDimensions(2, 2, 2);
  planes = { { { 1, 0, 0, 0 } }, { { 0, 1, 0, 0 } }, { { 0, 0, 1, 0 } }, { { -1, 0, 0, 1 } },
    { { 0, -1, 0, 1 } }, { { 0, 0, -1, 1 } } };
  return data;
}

// The eye looks along -z at the centre, from a little beside, so that no ray runs in a face.
struct CheckView
{
  vtkNew<vtkMatrix4x4> ModelToView;
  vtkNew<vtkMatrix4x4> ViewToDevice;
  SceneView View;
  Vector4 Eye;

  explicit CheckView(const double eye[3])
  {
    const double near = 1, far = 20;
    for (int axis = 0; axis < 3; ++axis)
    {
      this->ModelToView->SetElement(axis, 3, -eye[axis]);
      this->View.EyeModel[axis] = this->Eye[static_cast<std::size_t>(axis)] = eye[axis];
    }
    this->Eye[3] = 1;
    this->ViewToDevice->SetElement(0, 0, 1 / slope);
    this->ViewToDevice->SetElement(1, 1, 1 / slope);
    this->ViewToDevice->SetElement(2, 2, -(far + near) / (far - near));
    this->ViewToDevice->SetElement(2, 3, -2 * far * near / (far - near));
    this->ViewToDevice->SetElement(3, 2, -1);
    this->ViewToDevice->SetElement(3, 3, 0);
    this->View.ModelToView = this->ModelToView;
    this->View.ViewToDevice = this->ViewToDevice;
  }
};

// Opacity of extinction 1 along the ray of a pixel; `eye` in model coordinates.
double ExactOpacity(const std::vector<Plane>& planes, const double eye[3], int x, int y)
{
  const double ray[3] = { slope * (2 * (x + 0.5) / pictureSize - 1),
    slope * (2 * (y + 0.5) / pictureSize - 1), -1 };
  double enter = 0, leave = std::numeric_limits<double>::infinity();
  for (const Plane& p : planes)
  {
    const double at = p[0] * eye[0] + p[1] * eye[1] + p[2] * eye[2] + p[3];
    const double change = p[0] * ray[0] + p[1] * ray[1] + p[2] * ray[2];
    double& end = change > 0 ? enter : leave;
    end = change > 0 ? std::max(enter, -at / change) : std::min(leave, -at / change);
  }
  const double length = std::sqrt(ray[0] * ray[0] + ray[1] * ray[1] + 1);
  return leave > enter ? -std::expm1(-(leave - enter) * length) : 0;
}

std::string Upload(vtkOpenGLRenderWindow* window, CellCompositingPass& pass, const CellScene& scene)
{
  std::string error = pass.UploadGeometry(window, scene.GetGeometry(), scene.GetNeighbors());
  error = error.empty() ? pass.UploadTransferFunctions(
                            window, scene.GetTransferFunctions(), scene.GetOpacityFunctions(), {})
                        : error;
  error = error.empty() ? pass.UploadContours(window, scene) : error;
  error = error.empty()
    ? pass.UploadPolygons(window, scene.GetPolygons(), scene.GetGeometry(), scene.GetNeighbors())
    : error;
  return error.empty() ? pass.UploadDrawn(window, scene) : error;
}

// Into a framebuffer of its own without anything opaque.
std::string Draw(vtkOpenGLRenderWindow* window, CellCompositingPass& pass, const SceneView& view,
  const CellScene& scene)
{
  vtkOpenGLState* state = window->GetState();
  const SavedState saved(state);
  vtkNew<vtkTextureObject> color, depth;
  color->SetContext(window);
  color->Allocate2D(pictureSize, pictureSize, 4, VTK_UNSIGNED_CHAR);
  depth->SetContext(window);
  depth->AllocateDepth(pictureSize, pictureSize, vtkTextureObject::Float32);
  vtkNew<vtkOpenGLFramebufferObject> framebuffer;
  framebuffer->SetContext(window);
  state->PushFramebufferBindings();
  framebuffer->Bind();
  framebuffer->AddColorAttachment(0, color);
  framebuffer->AddDepthAttachment(depth);
  framebuffer->ActivateDrawBuffer(0);
  state->vtkglViewport(0, 0, pictureSize, pictureSize);
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglDepthMask(GL_TRUE);
  const float clear[4] = { 0, 0, 0, 0 }, far = 1.0f;
  glClearBufferfv(GL_COLOR, 0, clear);
  glClearBufferfv(GL_DEPTH, 0, &far);
  CellDrawingOptions options;
  options.Eye = &scene.GetEyeTetrahedron();
  const std::string error = pass.Draw(window, view, options);
  state->PopFramebufferBindings();
  framebuffer->ReleaseGraphicsResources(window);
  color->ReleaseGraphicsResources(window);
  depth->ReleaseGraphicsResources(window);
  return error;
}

std::string Compare(vtkImageData* image, const std::vector<Plane>& planes, const double eye[3])
{
  vtkDataArray* drawn = image->GetPointData()->GetScalars();
  for (int y = 0; y < pictureSize; ++y)
  {
    for (int x = 0; x < pictureSize; ++x)
    {
      const double exact = ExactOpacity(planes, eye, x, y);
      const double beside =
        std::min(std::min(ExactOpacity(planes, eye, x - 1, y), ExactOpacity(planes, eye, x + 1, y)),
          std::min(ExactOpacity(planes, eye, x, y - 1), ExactOpacity(planes, eye, x, y + 1)));
      const double expected[4] = { exact, 0.5 * exact, 0.25 * exact, exact };
      double value[4];
      drawn->GetTuple(y * pictureSize + x, value);
      for (int c = 0; c < 4; ++c)
      {
        if (beside > 0 &&
          !(std::abs(value[c] - expected[c]) <= largestError)) // the silhouette is not looked at
        {
          return "a test cell has the value " + std::to_string(value[c]) + " instead of " +
            std::to_string(expected[c]);
        }
      }
    }
  }
  return std::string();
}

std::string DrawAndCompare(vtkOpenGLRenderWindow* window, CellScene::Method method,
  vtkDataSet* data, const std::vector<Plane>& planes)
{
  const ScalarSelection scalars = { AddScalars(data), false, -1 };
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0, 1, 0.5, 0.25);
  color->AddRGBPoint(8, 1, 0.5, 0.25);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0, 1);
  opacity->AddPoint(8, 1);
  vtkNew<vtkVolumeProperty> property;
  property->SetColor(color);
  property->SetScalarOpacity(opacity);
  CellScene scene;
  std::string error;
  const bool rays = method == CellScene::Method::Rays;
  scene.UpdateGeometry(
    data, scalars, {}, rays ? CellGeometry::Form::Grid : CellGeometry::Form::Tetrahedra, error);
  const double* center = scene.GetGeometry().Center;
  const double eye[3] = { 0.13, 0.21, distance }; // relative to the centre
  const double eyeOfPlanes[3] = { eye[0] + center[0], eye[1] + center[1], eye[2] + center[2] };
  const CheckView view(eye);
  scene.UpdateTransferFunction(property);
  scene.UpdateMethod(method);
  if (rays)
  {
    scene.UpdateEye(view.Eye);
  }
  else
  {
    scene.UpdateOrder(ProjectionOrder::Kind::None, view.Eye);
  }
  scene.UpdateDrawn();
  CellCompositingPass pass;
  error = error.empty() ? Upload(window, pass, scene) : error;
  error = error.empty() ? Draw(window, pass, view.View, scene) : error;
  vtkNew<vtkImageData> image;
  if (error.empty())
  {
    error = pass.CopyFloatImage(window, image) ? Compare(image, planes, eyeOfPlanes)
                                               : "nothing was drawn";
  }
  pass.ReleaseGraphicsResources(window);
  return error;
}

std::string Check(vtkOpenGLRenderWindow* window, DrawnBy way)
{
  const char* wrong = std::getenv("NEPHOSCOPE_WRONG_DRAWING");
  if (wrong &&
    std::string(wrong).find(way == DrawnBy::Rays ? "Rays" : "Projection") != std::string::npos)
  {
    return "NEPHOSCOPE_WRONG_DRAWING says so";
  }
  std::vector<Plane> planes;
  vtkSmartPointer<vtkDataSet> data = MakeTetrahedron(planes);
  if (way == DrawnBy::Projection)
  {
    return DrawAndCompare(window, CellScene::Method::Projection, data, planes);
  }
  const std::string error = DrawAndCompare(window, CellScene::Method::Rays, data, planes);
  data = MakeCell(planes);
  return error.empty() ? DrawAndCompare(window, CellScene::Method::Rays, data, planes) : error;
}

std::string Text(GLenum name)
{
  const GLubyte* value = glGetString(name);
  return value ? reinterpret_cast<const char*>(value) : "unknown";
}
}

std::string CheckDrawing(vtkOpenGLRenderWindow* window, DrawnBy way)
{
  static std::mutex mutex;
  static std::map<std::pair<std::string, DrawnBy>, std::string> known;
  const std::string driver = Text(GL_RENDERER) + ", OpenGL " + Text(GL_VERSION);
  const std::lock_guard<std::mutex> lock(mutex);
  const auto key = std::make_pair(driver, way);
  auto found = known.find(key);
  if (found == known.end())
  {
    const std::string error = Check(window, way);
    found = known.emplace(key, error.empty() ? error : error + " (" + driver + ")").first;
  }
  return found->second;
}

} // namespace nephoscope
