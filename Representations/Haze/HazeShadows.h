// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** Shadows of the lit clouds in a renderer, as a texture while it draws haze. */
#ifndef nephoscope_HazeShadows_h
#define nephoscope_HazeShadows_h

#include "ResourceWindow.h"
#include "SunlightMap.h"

#include "vtkNew.h"

#include <array>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkTextureObject;

namespace nephoscope
{

class HazeShadows
{
public:
  HazeShadows();
  ~HazeShadows();

  /**
   * Finds the clouds: volumes whose data have the point array SunTransmittance, for a sun in this
   * direction (length 1; null: no sun, no shadows). The map is made anew where anything has
   * changed. All ranks call this together.
   */
  void Find(vtkRenderer* renderer, const double* towardsSun, const MaximumOfRanks& maximum);
  void Forget();

  /** Empty, or why clouds cast no shadows. */
  const std::string& GetProblem() const { return this->Problem; }
  bool Exist() const { return this->Map && this->Map->GetImage(); }
  vtkMatrix4x4* GetFromWorld() const { return this->Map->GetFromWorld(); }

  /** Binds the texture, from the start of a frame to its end. */
  void Bind(vtkOpenGLRenderWindow* window);
  void Unbind();
  /** Texture unit; -1: none is bound. */
  int GetUnit() const { return this->Unit; }

private:
  using Version = std::tuple<const void*, unsigned long long,
    std::array<double, 16>>; // clouds, their time and position

  std::vector<LitClouds> FindClouds(vtkRenderer* renderer, const double towardsSun[3]);
  void Upload(vtkOpenGLRenderWindow* window);

  std::vector<Version> Versions; // of the clouds in the map
  double Sun[3] = { 0, 0, 0 };
  std::unique_ptr<SunlightMap> Map;
  std::string Problem;
  int Unit = -1;
  bool Uploaded = false;
  vtkNew<vtkTextureObject> Texture;
  ResourceWindow Window;
};

} // namespace nephoscope

#endif
