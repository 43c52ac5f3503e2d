// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * From the surface to the layers that the fragment shader takes the thickness of clouds from, once
 * for each picture.
 */
#ifndef nephoscope_CloudThicknessPass_h
#define nephoscope_CloudThicknessPass_h

#include "SceneDepth.h"
#include "SurfaceLayers.h"
#include "SurfaceLists.h"

#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOpenGLHelper.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

class vtkActor;
class vtkCamera;
class vtkOpenGLQuadHelper;
class vtkRenderer;
class vtkShaderProgram;

namespace nephoscope
{

class DensityVolume;

class CloudThicknessPass
{
public:
  CloudThicknessPass();
  ~CloudThicknessPass();
  CloudThicknessPass(const CloudThicknessPass&) = delete;
  CloudThicknessPass& operator=(const CloudThicknessPass&) = delete;

  struct Request
  {
    SceneDepth::Request Scene;
    vtkRenderer* Renderer = nullptr;
    vtkActor* Actor = nullptr;
    double Center[3] = { 0, 0, 0 };             ///< of the places
    double Bounds[6] = { 0, 0, 0, 0, 0, 0 };    ///< of the places
    bool IsClosed = false, IsInsideOut = false; ///< the surface
    bool WithDensities = false;
    int Clouds = 2;                                      ///< behind one another, at most
    std::string Constants;                               ///< of the shaders
    std::function<void(vtkOpenGLHelper&)> DrawTriangles; ///< with the program of the helper
    DensityVolume* Volume = nullptr;                     ///< uploaded
    double Extinction = 0, EnoughOpticalDepth = 0;       ///< for the way through the volume
  };

  /**
   * How many times the surface may be drawn to find so many clouds; less where this OpenGL has few
   * texture units. 0: it is drawn once, into lists.
   */
  static int LimitDrawings(int clouds, bool withDensities);

  /** Draws the layers if this is the time: empty, or what went wrong. */
  std::string Draw(const Request& request);
  /** Thickness is not known in this view: the cloud is a layer. */
  void Forget(const Request& request);
  /**
   * Whether back faces start no cloud: the near plane is before all of the surface, and the surface
   * is closed.
   */
  bool OnlyFrontFaces() const { return this->IsKnown && !this->EyeMayBeInside && this->IsClosed; }
  /** Which of them OpenGL takes for front faces. */
  bool FrontFacesAreFront() const { return this->FrontIsFront; }
  /** Whether OpenGL ended loops early even with the most parts: rays miss some of the cells. */
  bool CutsWays() const { return this->IsKnown && !this->WaysAreWhole; }
  bool HasMore() const { return this->IsKnown && !this->HasLists && this->Layers.HasMore(); }

  void Activate();
  void Deactivate();
  /** `enough`: optical depth beyond which the picture does not change. */
  void SetUniforms(vtkShaderProgram* program, double extinction, double enough, int drawings);

  /** From view coordinates to those of the surface's data. */
  vtkMatrix4x4* GetViewToData() const { return this->ViewToData; }

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  void FindView(const Request& request);
  void Paint(const Request& request, const char* shader,
    const std::function<void(vtkShaderProgram*)>& prepare);
  void FindDepths(const Request& request, const SurfaceLayers::Request& layers);
  void PaintLayer(const Request& request, const SurfaceLayers::Drawing& drawing);
  std::vector<vtkTextureObject*> Textures();

  SceneDepth Scene;
  SurfaceLayers Layers;
  SurfaceLists Lists;
  vtkOpenGLHelper Helper;
  std::unique_ptr<vtkOpenGLQuadHelper> Depths;
  std::string DepthsCode; // of its program
  int Parts = 1;          // of ways through the density volume
  bool WaysAreWhole = true;
  vtkTextureObject* Opaque = nullptr;
  vtkProp* KnownProp = nullptr; // not to be looked into
  bool IsKnown = false, HasLists = false, EyeMayBeInside = true, IsClosed = false,
       WithDensities = false, IsParallel = false, FrontIsFront = true;
  vtkNew<vtkMatrix4x4> ViewToData, DeviceToView;
  float PlaceToView[16] = {}, DepthToView[4] = {}, Origin[2] = {}, Near = 0;
};

} // namespace nephoscope

#endif
