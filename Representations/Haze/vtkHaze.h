// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkHaze
 * @brief Haze between the eye and everything that a renderer draws, thinner with altitude
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
 * draw, and what is drawn in two dimensions. Lengths are those of the scene, metres behind vtkGlobeGrid. Several renderers may share a haze.
 */
#ifndef vtkHaze_h
#define vtkHaze_h

#include "vtkNephoscopeRepresentationsHazeModule.h" // for export macro
#include "vtkObject.h"

class vtkRenderer;

class VTKNEPHOSCOPEREPRESENTATIONSHAZE_EXPORT vtkHaze : public vtkObject
{
public:
  static vtkHaze* New();
  vtkTypeMacro(vtkHaze, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The haze of a renderer, in place of the one it had. nullptr: none. The renderer keeps the haze. */
  static void SetHaze(vtkRenderer* renderer, vtkHaze* haze);
  static vtkHaze* GetHaze(vtkRenderer* renderer);
  ///@}

  ///@{
  /** Switches it off without forgetting it. Default: on. Off, the picture is what it is without haze, bit for bit. */
  vtkSetMacro(Enabled, bool);
  vtkGetMacro(Enabled, bool);
  vtkBooleanMacro(Enabled, bool);
  ///@}

  enum ProjectionType
  {
    GLOBE = 0,
    MAP = 1
  };

  ///@{
  /** What altitude is: height over the sphere of PlanetRadius about Center (globe, default), or over BaseLevel along UpDirection (map). */
  vtkSetClampMacro(Projection, int, GLOBE, MAP);
  vtkGetMacro(Projection, int);
  void SetProjectionToGlobe() { this->SetProjection(GLOBE); }
  void SetProjectionToMap() { this->SetProjection(MAP); }
  ///@}

  ///@{
  /**
   * Meteorological visibility at altitude 0: the length of level air that lets 2 % of the contrast through (Koschmieder1924), so that the
   * extinction there is 3.912 / Visibility. > 0 and finite, default: 1e6. Real air has 1e4 to 3e5 m; views of weather span thousands of
   * kilometres.
   */
  void SetVisibility(double visibility);
  vtkGetMacro(Visibility, double);
  ///@}

  ///@{
  /** The same, as extinction per length at altitude 0. >= 0 and finite; 0: no haze. */
  void SetExtinction(double extinction);
  vtkGetMacro(Extinction, double);
  ///@}

  ///@{
  /** Height over which density falls to 1/e, not exaggerated. > 0 and finite, default: 8000, that of air; smoke and dust have 1000 to 2000. */
  void SetScaleHeight(double height);
  vtkGetMacro(ScaleHeight, double);
  ///@}

  ///@{
  /** Of the heights in the scene, such as that of vtkGlobeGrid: the scale height is as much larger. > 0 and finite, default: 1. */
  void SetVerticalExaggeration(double factor);
  vtkGetMacro(VerticalExaggeration, double);
  ///@}
  /** ScaleHeight times VerticalExaggeration. */
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
  /** Globe: its centre. Default: the origin. Finite. */
  void SetCenter(double x, double y, double z);
  void SetCenter(const double center[3]) VTK_SIZEHINT(3)
  {
    this->SetCenter(center[0], center[1], center[2]);
  }
  vtkGetVector3Macro(Center, double);
  ///@}

  ///@{
  /** Globe: radius where altitude is 0. > 0 and finite, default: 6371000, as vtkGlobeGrid. */
  void SetPlanetRadius(double radius);
  vtkGetMacro(PlanetRadius, double);
  ///@}

  ///@{
  /** Map: upwards. Of any length > 0, default: (0, 0, 1). */
  void SetUpDirection(double x, double y, double z);
  void SetUpDirection(const double up[3]) VTK_SIZEHINT(3)
  {
    this->SetUpDirection(up[0], up[1], up[2]);
  }
  vtkGetVector3Macro(UpDirection, double);
  ///@}

  ///@{
  /** Map: coordinate along UpDirection where altitude is 0. Finite, default: 0. */
  void SetBaseLevel(double level);
  vtkGetMacro(BaseLevel, double);
  ///@}

  ///@{
  /** Whether the background is hazed too, along rays that end in the sky or at altitude 0. Default: on. */
  vtkSetMacro(Background, bool);
  vtkGetMacro(Background, bool);
  vtkBooleanMacro(Background, bool);
  ///@}

  /** Switched on, and with an extinction. */
  bool IsSeen() const { return this->Enabled && this->Extinction > 0; }

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
  int Projection = GLOBE;
  double Visibility = 1e6;
  double Extinction = 3.912e-6;
  double ScaleHeight = 8000;
  double VerticalExaggeration = 1;
  double Color[3] = { 0.72, 0.8, 0.9 };
  double Center[3] = { 0, 0, 0 };
  double PlanetRadius = 6371000;
  double UpDirection[3] = { 0, 0, 1 };
  double BaseLevel = 0;
};

#endif
