// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkHaze
 * @brief Haze in front of everything that a renderer draws, thinner with altitude
 *
 * Density falls exponentially with altitude h, exp(-h / ScaleHeight), on a globe or over flat ground. The optical depth tau of the air between the
 * eye and a fragment is its analytic integral along the ray, and a colour F becomes exp(-tau) F + (1 - exp(-tau)) Color (Max, Crawfis and
 * Becker, New Techniques in 3D Scalar and Vector Field Visualization, Pacific Graphics 1993, section 4). Translucent layers are hazed where they
 * are, each in its share: over each other they give what haze in front of, between and behind them gives.
 *
 *     vtkHaze::SetHaze(renderer, haze)      one switch for the whole renderer; nullptr takes it away
 *
 * Hazed are: all that vtkOpenGLPolyDataMapper and its subclasses draw, opaque or translucent, vtkCloudTextureMapper among them;
 * vtkCellCompositingMapper and vtkTexturedSplatMapper; and, if wanted, the background. Not hazed: volumes that VTK's own volume mappers
 * draw, and what is drawn in two dimensions. Lengths are those of the scene, metres behind vtkGlobeGrid; settings that are 0 or
 * automatic are found from what is drawn. Several renderers may share a haze.
 */
#ifndef vtkHaze_h
#define vtkHaze_h

#include "vtkNephoscopeRepresentationsHazeModule.h" // for export macro
#include "vtkObject.h"

#include <functional> // for the completion of scenes
#include <utility>

class vtkRenderer;

namespace nephoscope
{
struct HazeScene;
}

class VTKNEPHOSCOPEREPRESENTATIONSHAZE_EXPORT vtkHaze : public vtkObject
{
public:
  static vtkHaze* New();
  vtkTypeMacro(vtkHaze, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Sets the haze of a renderer and replaces earlier haze. nullptr: no haze. The renderer holds a reference to the haze. */
  static void SetHaze(vtkRenderer* renderer, vtkHaze* haze);
  static vtkHaze* GetHaze(vtkRenderer* renderer);
  ///@}

  ///@{
  /** Turns the haze on and off. Default: on. If it is off, the picture is bit-identical to the picture without haze. */
  vtkSetMacro(Enabled, bool);
  vtkGetMacro(Enabled, bool);
  vtkBooleanMacro(Enabled, bool);
  ///@}

  enum ProjectionType
  {
    GLOBE = 0,
    MAP = 1,
    AUTOMATIC = 2
  };

  ///@{
  /**
   * What altitude is: height over the sphere of PlanetRadius about Center (globe), or over BaseLevel along UpDirection (map). Automatic
   * (default): a globe if PlanetRadius is given, as vtkGlobeGrid says in field data of what is drawn, or if the scene has the size of the Earth
   * about the origin in m or km; else a map, on the ground under the scene, which BaseLevel is added to.
   */
  vtkSetClampMacro(Projection, int, GLOBE, AUTOMATIC);
  vtkGetMacro(Projection, int);
  void SetProjectionToGlobe() { this->SetProjection(GLOBE); }
  void SetProjectionToMap() { this->SetProjection(MAP); }
  void SetProjectionToAutomatic() { this->SetProjection(AUTOMATIC); }
  ///@}

  ///@{
  /**
   * Meteorological visibility: the distance along the ground at altitude 0 at which 2 % of the contrast is left
   * (Koschmieder1924). The extinction coefficient there is 3.912 / Visibility. >= 0 and finite; 0 (default): 24.5 displayed scale
   * heights. Real air has 1e4 to 3e5 m; views of weather span thousands of kilometres.
   */
  void SetVisibility(double visibility);
  vtkGetMacro(Visibility, double);
  ///@}

  ///@{
  /** Extinction coefficient at altitude 0, an alternative to Visibility. >= 0 and finite; 0: no haze. -1 if Visibility is chosen from the scene. */
  void SetExtinction(double extinction);
  vtkGetMacro(Extinction, double);
  ///@}

  ///@{
  /**
   * Height over which the density falls to 1/e, before exaggeration. >= 0 and finite; 0 (default): 8000, the value of air, with
   * vtkGlobeGrid; 0.5 % of the radius on any other globe; otherwise a third of the height of the scene. Smoke and dust have 1000
   * to 2000 m.
   */
  void SetScaleHeight(double height);
  vtkGetMacro(ScaleHeight, double);
  ///@}

  ///@{
  /**
   * Vertical exaggeration of the scene; it multiplies the scale height. >= 0 and finite; 0 (default): as vtkGlobeGrid says in field data of what is
   * drawn, else 1.
   */
  void SetVerticalExaggeration(double factor);
  vtkGetMacro(VerticalExaggeration, double);
  ///@}
  /** ScaleHeight times VerticalExaggeration; 0 if either is chosen from the scene. */
  double GetDisplayedScaleHeight() const { return this->ScaleHeight * this->VerticalExaggeration; }

  ///@{
  /** Colour of thick haze, 0 ... 1. Default: (0.72, 0.8, 0.9). */
  void SetColor(double red, double green, double blue);
  void SetColor(const double color[3]) VTK_SIZEHINT(3)
  {
    this->SetColor(color[0], color[1], color[2]);
  }
  vtkGetVector3Macro(Color, double);
  ///@}

  ///@{
  /** Globe: centre of the globe, finite. Default: the origin. */
  void SetCenter(double x, double y, double z);
  void SetCenter(const double center[3]) VTK_SIZEHINT(3)
  {
    this->SetCenter(center[0], center[1], center[2]);
  }
  vtkGetVector3Macro(Center, double);
  ///@}

  ///@{
  /** Globe: radius at altitude 0. >= 0 and finite; 0 (default): as vtkGlobeGrid says in field data of what is drawn, else 6371000 m. */
  void SetPlanetRadius(double radius);
  vtkGetMacro(PlanetRadius, double);
  ///@}

  ///@{
  /** Map: the direction upwards, with any length > 0. Default: (0, 0, 1). */
  void SetUpDirection(double x, double y, double z);
  void SetUpDirection(const double up[3]) VTK_SIZEHINT(3)
  {
    this->SetUpDirection(up[0], up[1], up[2]);
  }
  vtkGetVector3Macro(UpDirection, double);
  ///@}

  ///@{
  /** Map: coordinate along UpDirection at altitude 0, finite. Default: 0. */
  void SetBaseLevel(double level);
  vtkGetMacro(BaseLevel, double);
  ///@}

  ///@{
  /** Draws haze over the background too, along rays that end in the sky or at altitude 0. Default: on. */
  vtkSetMacro(Background, bool);
  vtkGetMacro(Background, bool);
  vtkBooleanMacro(Background, bool);
  ///@}

  /** Switched on, and with an extinction. */
  bool IsSeen() const { return this->Enabled && this->Extinction != 0; }

  /** Some setting is left to the scene. */
  bool NeedsScene() const
  {
    return this->Projection == AUTOMATIC ||
      !(this->Visibility > 0 && this->ScaleHeight > 0 && this->VerticalExaggeration > 0);
  }

#ifndef __VTK_WRAP__
  /** Called before each drawing, to add what a renderer does not have: the scenes of other ranks. */
  void SetSceneCompletion(std::function<void(nephoscope::HazeScene&)> completion)
  {
    this->Completion = std::move(completion);
  }
  void CompleteScene(nephoscope::HazeScene& scene) const
  {
    if (this->Completion)
    {
      this->Completion(scene);
    }
  }
#endif

protected:
  vtkHaze() = default;
  ~vtkHaze() override = default;

private:
  vtkHaze(const vtkHaze&) = delete;
  void operator=(const vtkHaze&) = delete;

  void SetPositive(double& member, const char* name, double value);
  void SetVector(
    double member[3], const char* name, const char* need, const double value[3], bool valid);

  bool Enabled = true;
  bool Background = true;
  int Projection = AUTOMATIC;
  double Visibility = 0;
  double Extinction = -1;
  double ScaleHeight = 0;
  double VerticalExaggeration = 0;
  double Color[3] = { 0.72, 0.8, 0.9 };
  double Center[3] = { 0, 0, 0 };
  double PlanetRadius = 0;
  double UpDirection[3] = { 0, 0, 1 };
  double BaseLevel = 0;
#ifndef __VTK_WRAP__
  std::function<void(nephoscope::HazeScene&)> Completion;
#endif
};

#endif
