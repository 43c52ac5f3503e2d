// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkHaze
 * @brief Haze in front of everything that a renderer draws, less dense with altitude
 *
 * Density falls exponentially with altitude h, exp(-h / ScaleHeight), on a globe or over flat
 * ground. The optical depth tau of the air between the eye and a fragment is its analytic integral
 * along the ray, and a colour F becomes exp(-tau) F + (1 - exp(-tau)) Color (Max, Crawfis and
 * Becker, New Techniques in 3D Scalar and Vector Field Visualization, Pacific Graphics 1993,
 * section 4). Translucent layers are hazed at their depth, in proportion to their opacity; together
 * they give the result of haze in front of, between and behind them.
 *
 *     vtkHaze::SetHaze(renderer, haze)      one switch for the whole renderer; nullptr removes
 *                                           the haze
 *
 * Haze covers everything that vtkOpenGLPolyDataMapper and its subclasses draw, opaque or
 * translucent, including vtkCloudTextureMapper; vtkCellCompositingMapper and
 * vtkTexturedSplatMapper; and optionally the background. It does not cover volumes of VTK's own
 * volume mappers and 2-D actors. Lengths are in units of the scene, metres for the output of
 * vtkGlobeGrid; settings that are 0 or automatic are derived from the scene. Several renderers may
 * share a haze.
 */
#ifndef vtkHaze_h
#define vtkHaze_h

#include "vtkNephoscopeRepresentationsHazeModule.h" // for export macro
#include "vtkObject.h"

#include <functional> // for what ranks have in common
#include <utility>

class vtkRenderer;

class VTKNEPHOSCOPEREPRESENTATIONSHAZE_EXPORT vtkHaze : public vtkObject
{
public:
  static vtkHaze* New();
  vtkTypeMacro(vtkHaze, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Sets the haze of a renderer and replaces earlier haze. nullptr: no haze. The renderer holds a
   * reference to the haze.
   */
  static void SetHaze(vtkRenderer* renderer, vtkHaze* haze);
  static vtkHaze* GetHaze(vtkRenderer* renderer);
  ///@}

  ///@{
  /**
   * Turns the haze on and off. Default: on. If it is off, the picture is bit-identical to the
   * picture without haze.
   */
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
   * Meaning of altitude: the height above the sphere of PlanetRadius about Center (globe), or above
   * BaseLevel along UpDirection (map).
   * Automatic (default): a globe if PlanetRadius is given; otherwise the projection in the field
   * data that vtkGlobeGrid wrote; without these, a globe if the scene lies around the origin and is
   * as large as the Earth in m or km, otherwise a map with the ground under the scene, to which
   * BaseLevel is added.
   */
  vtkSetClampMacro(Projection, int, GLOBE, AUTOMATIC);
  vtkGetMacro(Projection, int);
  void SetProjectionToGlobe() { this->SetProjection(GLOBE); }
  void SetProjectionToMap() { this->SetProjection(MAP); }
  void SetProjectionToAutomatic() { this->SetProjection(AUTOMATIC); }
  ///@}

  ///@{
  /**
   * Meteorological visibility: the distance along the ground at altitude 0 at which 2 % of the
   * contrast is left (Koschmieder1924). The extinction coefficient there is 3.912 / Visibility. >=
   * 0 and finite; 0 (default): 24.5 displayed scale heights; without a globe or map, at least 5.7
   * widths of the scene. Real air has 1e4 to 3e5 m; views of weather span thousands of kilometres.
   */
  void SetVisibility(double visibility);
  vtkGetMacro(Visibility, double);
  ///@}

  ///@{
  /**
   * Extinction coefficient at altitude 0, an alternative to Visibility. >= 0 and finite; 0: no
   * haze. -1 if Visibility is chosen from the scene.
   */
  void SetExtinction(double extinction);
  vtkGetMacro(Extinction, double);
  ///@}

  ///@{
  /**
   * Height over which the density falls to 1/e, before exaggeration. >= 0 and finite; 0 (default):
   * 8000, the value of air, with vtkGlobeGrid; 0.5 % of the radius on any other globe; otherwise a
   * third of the height of the scene. Smoke and dust have 1000 to 2000 m.
   */
  void SetScaleHeight(double height);
  vtkGetMacro(ScaleHeight, double);
  ///@}

  ///@{
  /**
   * Vertical exaggeration of the scene; it multiplies the scale height. >= 0 and finite; 0
   * (default): the value in the field data that vtkGlobeGrid wrote, otherwise 1.
   */
  void SetVerticalExaggeration(double factor);
  vtkGetMacro(VerticalExaggeration, double);
  ///@}
  /** ScaleHeight times VerticalExaggeration; 0 if either is chosen from the scene. */
  double GetDisplayedScaleHeight() const { return this->ScaleHeight * this->VerticalExaggeration; }

  ///@{
  /** Colour of opaque haze, 0 ... 1. Default: (0.72, 0.8, 0.9). */
  void SetColor(double red, double green, double blue);
  void SetColor(const double color[3]) VTK_SIZEHINT(3)
  {
    this->SetColor(color[0], color[1], color[2]);
  }
  vtkGetVector3Macro(Color, double);
  ///@}

  ///@{
  /**
   * Direction towards the sun, in the coordinates of the scene, finite. (0, 0, 0), the default: the
   * sun of the renderer, if ParaView's Sun lights it; otherwise haze has the same colour
   * everywhere. With a sun, haze scatters its light towards the eye with the phase function of
   * Henyey and Greenstein (mean over all directions 1), and the haze in between attenuates it: haze
   * is brightest around the sun, and dark at night. Costs several times as much.
   */
  void SetSunDirection(double x, double y, double z);
  void SetSunDirection(const double sun[3]) VTK_SIZEHINT(3)
  {
    this->SetSunDirection(sun[0], sun[1], sun[2]);
  }
  vtkGetVector3Macro(SunDirection, double);
  ///@}

  ///@{
  /**
   * With a sun: asymmetry parameter of the haze, -0.95 to 0.95. Default: 0.5, between air (0) and
   * particles (0.7).
   */
  vtkSetClampMacro(Asymmetry, double, -0.95, 0.95);
  vtkGetMacro(Asymmetry, double);
  ///@}

  ///@{
  /**
   * With a sun: clouds that are lit by vtkSunlight with the same sun, and drawn as volumes, cast
   * shadows in the haze, with shafts of light between them. Default: on.
   */
  vtkSetMacro(CloudShadows, bool);
  vtkGetMacro(CloudShadows, bool);
  vtkBooleanMacro(CloudShadows, bool);
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
  /**
   * Globe: radius at altitude 0. >= 0 and finite; 0 (default): the value in the field data that
   * vtkGlobeGrid wrote, otherwise 6371000 m.
   */
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
  /**
   * Draws haze over the background too, along rays that end in the sky or at altitude 0. Default:
   * on.
   */
  vtkSetMacro(Background, bool);
  vtkGetMacro(Background, bool);
  vtkBooleanMacro(Background, bool);
  ///@}

  /** Whether the haze is on and has an extinction. */
  bool IsSeen() const { return this->Enabled && this->Extinction != 0; }

  /** Whether a setting is to be derived from the scene. */
  bool NeedsScene() const
  {
    return this->Projection == AUTOMATIC ||
      !(this->Visibility > 0 && this->ScaleHeight > 0 && this->VerticalExaggeration > 0);
  }

#ifndef __VTK_WRAP__
  /** Called while the renderer draws, to replace each number by the maximum over all ranks. */
  void SetMaximumOfRanks(std::function<void(double* numbers, int count)> maximum)
  {
    this->MaximumOfRanks = std::move(maximum);
  }
  const std::function<void(double* numbers, int count)>& GetMaximumOfRanks() const
  {
    return this->MaximumOfRanks;
  }

  /**
   * How this process draws haze in front of the background of a picture that several ranks may draw
   * together.
   */
  enum class SkyOfRank
  {
    ALONE,    ///< no other rank draws
    LAST,     ///< pictures are blended in the order of the ranks, and this rank is the farthest
    BY_DEPTH, ///< the nearest fragment of all ranks is seen, so the haze needs a depth
    NONE      ///< another rank draws it
  };

  /**
   * Called when the renderer starts to draw, on every rank. One of them must draw the haze.
   * Default: ALONE.
   */
  void SetFindSkyOfRank(std::function<SkyOfRank()> find)
  {
    this->FindSkyOfRank = std::move(find);
  }
  SkyOfRank GetSkyOfRank() const
  {
    return this->FindSkyOfRank();
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
  bool CloudShadows = true;
  int Projection = AUTOMATIC;
  double Visibility = 0;
  double Extinction = -1;
  double ScaleHeight = 0;
  double VerticalExaggeration = 0;
  double Color[3] = { 0.72, 0.8, 0.9 };
  double SunDirection[3] = { 0, 0, 0 };
  double Asymmetry = 0.5;
  double Center[3] = { 0, 0, 0 };
  double PlanetRadius = 0;
  double UpDirection[3] = { 0, 0, 1 };
  double BaseLevel = 0;
#ifndef __VTK_WRAP__
  std::function<void(double*, int)> MaximumOfRanks = [](double*, int) {};
  std::function<SkyOfRank()> FindSkyOfRank = [] { return SkyOfRank::ALONE; };
#endif
};

#endif
