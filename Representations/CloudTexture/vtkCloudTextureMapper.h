// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkCloudTextureMapper
 * @brief Draws the surface of clouds with a texture of broken cloud, with the cover that is asked for
 *
 * The texture is a sum of modulated cosines (Gardner 1985; Max, Crawfis and Becker, New Techniques in 3D Scalar and Vector Field
 * Visualization, Pacific Graphics 1993, section 4). Where it exceeds a threshold there is cloud; the threshold follows from the
 * cover, with the distribution of what is compared with it, so that the drawn cover is the one asked for at every distance and
 * while two sets of coordinates fade into each other. Colours are those of vtkPolyDataMapper, times those of the texture; so are lights. It is translucent: use depth
 * peeling where it is to be in the right order with other translucent things and with itself.
 *
 * Point arrays that it reads where they are there: TextureCoordinates1 and TextureCoordinates2 (3 components), and the field data
 * TextureWeights and TextureFrame (0: longitude, latitude, height; 1: Cartesian). Without such coordinates, positions.
 */
#ifndef vtkCloudTextureMapper_h
#define vtkCloudTextureMapper_h

#include "vtkNephoscopeRepresentationsCloudTextureModule.h" // for export macro
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkSmartPointer.h" // for the density volume

#include <memory> // for vtkInternals
#include <string> // for array names

class vtkDataObject;
class vtkShaderProgram;

class VTKNEPHOSCOPEREPRESENTATIONSCLOUDTEXTURE_EXPORT vtkCloudTextureMapper
  : public vtkOpenGLPolyDataMapper
{
public:
  static vtkCloudTextureMapper* New();
  vtkTypeMacro(vtkCloudTextureMapper, vtkOpenGLPolyDataMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Share of the surface that is cloud, 0 ... 1. Default: 0.5. Ignored with UseThreshold and where CoverageArrayName is set. */
  vtkSetClampMacro(Coverage, double, 0.0, 1.0);
  vtkGetMacro(Coverage, double);
  ///@}

  ///@{
  /** Point array of the cover, 0 ... 1 at every point, such as a model's cloud fraction. Default: empty, Coverage holds everywhere. */
  void SetCoverageArrayName(const char* name);
  const char* GetCoverageArrayName() const { return this->CoverageArrayName.c_str(); }
  ///@}

  ///@{
  /**
   * Cloud is where the texture exceeds Threshold, instead of where the cover demands. In standard deviations of the texture, whose mean is 0. The
   * cover then follows from the distribution of the texture. Defaults: off, 0.
   */
  vtkSetMacro(UseThreshold, bool);
  vtkGetMacro(UseThreshold, bool);
  vtkBooleanMacro(UseThreshold, bool);
  vtkSetClampMacro(Threshold, double, -1e30, 1e30);
  vtkGetMacro(Threshold, double);
  ///@}

  ///@{
  /** Cover and threshold of one set of coordinates and no thickness: one is that which is set, the other follows from it. */
  double GetCoverageUsed();
  double GetThresholdUsed();
  ///@}

  ///@{
  /**
   * Width of the edges of clouds: standard deviation, in units of the texture, whose own is 1. 0 ... 2, default: 0.4. 0 is sharp, but for
   * the pixel's filter. Cover counts half-transparent edges by their transparency, so it does not change.
   */
  vtkSetClampMacro(Softness, double, 0.0, 2.0);
  vtkGetMacro(Softness, double);
  ///@}

  ///@{
  /**
   * How often the texture repeats itself in one unit of the coordinates: around the equator, or along the longest side of a surface that is not a
   * globe. 0 ... 1e6. 0 (default): by the shape of the surface, more for flat layers than for bodies. With longitudes as coordinates it is rounded to a whole
   * number. GetTextureScaleUsed() is that of the last picture.
   */
  vtkSetClampMacro(TextureScale, double, 0.0, 1e6);
  vtkGetMacro(TextureScale, double);
  double GetTextureScaleUsed() const;
  ///@}

  ///@{
  /** Length of one unit of texture where coordinates come from positions; 0 (default): equator or longest side of the surface. */
  vtkSetClampMacro(TextureLength, double, 0.0, 1e300);
  vtkGetMacro(TextureLength, double);
  ///@}

  ///@{
  /**
   * The third coordinate of the texture is the altitude, 0 at the low end of AltitudeRange and 1 at the high end, whatever the scale. Without
   * arrays of coordinates the first two are longitude and latitude on a globe (in turns, times TextureScale), and the altitude is the distance from its
   * centre; elsewhere x, y and z. A range whose ends are not in order (default: 0, 0) is that of the data. Default: off.
   */
  vtkSetMacro(UseAltitude, bool);
  vtkGetMacro(UseAltitude, bool);
  vtkBooleanMacro(UseAltitude, bool);
  vtkSetVector2Macro(AltitudeRange, double);
  vtkGetVector2Macro(AltitudeRange, double);
  ///@}

  ///@{
  /**
   * Colour from the texture: ThinColor where it just exceeds the threshold, ThickColor where it exceeds it by ColorRange or more, mixed in between. They
   * multiply the colour of the surface; ColorRange is in units of the texture, > 0. Defaults: a bluish grey, white, 1.5.
   */
  vtkSetVector3Macro(ThinColor, double);
  vtkGetVector3Macro(ThinColor, double);
  vtkSetVector3Macro(ThickColor, double);
  vtkGetVector3Macro(ThickColor, double);
  vtkSetClampMacro(ColorRange, double, 1e-6, 1e6);
  vtkGetMacro(ColorRange, double);
  ///@}

  enum WavesType
  {
    WAVES_CLOUDS = 0,
    WAVES_PAPER = 1,
    WAVES_PRINTED = 2,
    WAVES_GARDNER = 3,
    WAVES_CUSTOM = 4
  };

  ///@{
  /**
   * The waves that the texture is the sum of. Clouds (default): 12 in all directions. Paper: 7 waves whose phases shift across them, as
   * the text of the paper asks. Printed: by its printed formula. Gardner: along the axes, with frequencies doubled. Custom: those that are set.
   */
  vtkSetClampMacro(Waves, int, WAVES_CLOUDS, WAVES_CUSTOM);
  vtkGetMacro(Waves, int);
  void SetWavesToClouds() { this->SetWaves(WAVES_CLOUDS); }
  void SetWavesToPaper() { this->SetWaves(WAVES_PAPER); }
  void SetWavesToPrinted() { this->SetWaves(WAVES_PRINTED); }
  void SetWavesToGardner() { this->SetWaves(WAVES_GARDNER); }
  void SetWavesToCustom() { this->SetWaves(WAVES_CUSTOM); }
  ///@}

  ///@{
  /**
   * Custom waves, 16 at most; as many as those of Clouds, and the same, until they are set. Wave i is
   *   amplitude cos(2 pi (b u + c v + d w + phase) + shift sin(2 pi (e u + g v + h w))).
   * Their sum is divided by its standard deviation. On longitudes b and e are rounded to whole numbers. No two waves may have the same
   * frequencies: the cover would not be the one asked for.
   */
  void SetNumberOfCustomWaves(int count);
  int GetNumberOfCustomWaves() const;
  void SetCustomWave(int i, double amplitude, double b, double c, double d, double shift, double e,
    double g, double h, double phase);
  /** The nine numbers of wave i, in the order of SetCustomWave; zeros where there is none. */
  void GetCustomWave(int i, double values[9]) const;
  /** As GetCustomWave, of the waves in use, whose sum has the standard deviation 1. */
  int GetNumberOfWavesUsed() const;
  void GetWaveUsed(int i, double values[9]) const;
  ///@}

  ///@{
  /**
   * Optical depth of cloud across the surface, the same everywhere; along a ray it is this over the cosine of the angle between ray and
   * normal. >= 0, default: 3, which hides 95 % of what is behind, seen from straight above.
   */
  vtkSetClampMacro(OpticalDepth, double, 0.0, 1e30);
  vtkGetMacro(OpticalDepth, double);
  ///@}

  ///@{
  /**
   * Clouds are as opaque as they are thick: optical depth along the ray from each front face to the next back face, or to what is opaque.
   * For closed surfaces whose triangles face outwards, as vtkCloudSurface makes them. Where nothing is behind, OpticalDepth holds.
   * Default: off, OpticalDepth everywhere.
   */
  vtkSetMacro(UseThickness, bool);
  vtkGetMacro(UseThickness, bool);
  vtkBooleanMacro(UseThickness, bool);
  ///@}

  enum ThicknessEffectType
  {
    THICKNESS_MULTIPLIES_OPACITY = 0,
    THICKNESS_IS_ADDED_TO_TEXTURE = 1
  };

  ///@{
  /**
   * With UseThickness: opacity is that of the optical depth along the ray (default), or ThicknessWeight times the optical depth is added to the texture before the
   * threshold, so that thin edges break up and the cover is that of no thickness; opacity is then that of OpticalDepth. ThicknessWeight is >= 0, default: 1.
   */
  vtkSetClampMacro(
    ThicknessEffect, int, THICKNESS_MULTIPLIES_OPACITY, THICKNESS_IS_ADDED_TO_TEXTURE);
  vtkGetMacro(ThicknessEffect, int);
  void SetThicknessEffectToMultiplyOpacity()
  {
    this->SetThicknessEffect(THICKNESS_MULTIPLIES_OPACITY);
  }
  void SetThicknessEffectToAddToTexture()
  {
    this->SetThicknessEffect(THICKNESS_IS_ADDED_TO_TEXTURE);
  }
  vtkSetClampMacro(ThicknessWeight, double, 0.0, 1e30);
  vtkGetMacro(ThicknessWeight, double);
  ///@}

  ///@{
  /**
   * Optical depth of cloud per length, in the unit of the scene; with UseThickness. >= 0. 0 (default): such that rays through the surface
   * have OpticalDepth on average. Set it where the surface changes with time.
   */
  vtkSetClampMacro(Extinction, double, 0.0, 1e300);
  vtkGetMacro(Extinction, double);
  ///@}

  ///@{
  /**
   * Point array of the density of cloud, >= 0, by which Extinction is multiplied; along the ray density is linear between the front
   * and the back face. With UseThickness. Default: empty, the density is 1. With DensityVolume it is an array of that.
   */
  void SetDensityArrayName(const char* name);
  const char* GetDensityArrayName() const { return this->DensityArrayName.c_str(); }
  ///@}

  ///@{
  /**
   * Density of cloud in space, >= 0, in the coordinates of the surface: array DensityArrayName of any grid, or of composite data, or without a name
   * its active scalars; of the points, or else of the cells. With UseThickness it is integrated along the ray inside of the surface in place of what is known at the
   * two faces: exactly for trilinear voxels of images with a point array, and for the linear density in the tetrahedra that other cells are divided into. Density of cells
   * is constant in each. Outside of the cells, and in hidden and ghost cells, it is 0. Default: none. Costs on the GPU 4 bytes per point of
   * an image, up to 100 bytes per tetrahedron elsewhere (cells without density cost nothing), and per pixel the way through voxels or tetrahedra.
   */
  void SetDensityVolume(vtkDataObject* volume);
  vtkDataObject* GetDensityVolume() const;
  ///@}

  ///@{
  /**
   * Where OpenGL is older than 4.2: how many clouds behind one another UseThickness finds in a pixel, nearest and farthest first; a warning
   * says where there are more. Every two cost one drawing of depths, where they are there. Later OpenGL finds all. 2 ... 16, default: 8. OpenGL's number of textures may allow less.
   */
  vtkSetClampMacro(MaximumNumberOfLayers, int, 2, 16);
  vtkGetMacro(MaximumNumberOfLayers, int);
  ///@}

  ///@{
  /**
   * Height of the bumps that lights see, as a share of the length of the largest waves: clouds get a sunny and a shady side. The surface itself
   * stays where it is. 0 ... 1, default: 0.03; 0: none.
   */
  vtkSetClampMacro(Relief, double, 0.0, 1.0);
  vtkGetMacro(Relief, double);
  ///@}

  ///@{
  /** Names of the arrays of texture coordinates. Defaults: TextureCoordinates1, TextureCoordinates2. */
  void SetFirstCoordinatesName(const char* name);
  const char* GetFirstCoordinatesName() const { return this->CoordinatesNames[0].c_str(); }
  void SetSecondCoordinatesName(const char* name);
  const char* GetSecondCoordinatesName() const { return this->CoordinatesNames[1].c_str(); }
  ///@}

  /** Also draws composite data sets: all their polygonal blocks as one surface. */
  void RenderPiece(vtkRenderer* renderer, vtkActor* actor) override;
  void ShallowCopy(vtkAbstractMapper* other) override;
  bool HasOpaqueGeometry() override { return false; }
  bool HasTranslucentPolygonalGeometry() override { return true; }
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkCloudTextureMapper();
  ~vtkCloudTextureMapper() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void ComputeBounds() override;
  void RenderPieceStart(vtkRenderer* renderer, vtkActor* actor) override;
  void RenderPieceFinish(vtkRenderer* renderer, vtkActor* actor) override;
  void RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) override;
  void ReplaceShaderColor(
    std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor) override;
  void ReplaceShaderNormal(
    std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor) override;
  void SetMapperShaderParameters(
    vtkOpenGLHelper& helper, vtkRenderer* renderer, vtkActor* actor) override;

private:
  vtkCloudTextureMapper(const vtkCloudTextureMapper&) = delete;
  void operator=(const vtkCloudTextureMapper&) = delete;

  void SetName(std::string& member, const char* name);
  void PrepareSurface(vtkPolyData* input);
  void MapArrays();
  void FindThickness(vtkRenderer* renderer, vtkActor* actor);
  void ReportThicknessErrors(const std::string& error);
  void PrepareVolume();
  void UploadVolume(vtkRenderer* renderer);
  void TellVolume(const std::string& error, const std::string& warning);
  void DrawTriangles(vtkOpenGLHelper& helper, vtkRenderer* renderer, vtkActor* actor);
  double GetExtinctionInUse(vtkActor* actor) const;
  void SetEye(vtkShaderProgram* program, vtkRenderer* renderer, vtkActor* actor);
  bool HasColors() const;
  void ChooseWaves();
  void CopyWaves(vtkCloudTextureMapper* other);
  void SetTextureUniforms(vtkShaderProgram* program);
  void SetReliefHeight(vtkShaderProgram* program, vtkActor* actor);

  double Coverage = 0.5;
  bool UseThreshold = false;
  double Threshold = 0;
  double Softness = 0.4;
  double TextureScale = 0;
  double TextureLength = 0;
  double OpticalDepth = 3;
  bool UseThickness = false;
  double Extinction = 0;
  int MaximumNumberOfLayers = 8;
  double Relief = 0.03;
  bool UseAltitude = false;
  double AltitudeRange[2] = { 0, 0 };
  double ThinColor[3] = { 0.8, 0.83, 0.88 };
  double ThickColor[3] = { 1, 1, 1 };
  double ColorRange = 1.5;
  int Waves = WAVES_CLOUDS;
  int ThicknessEffect = THICKNESS_MULTIPLIES_OPACITY;
  double ThicknessWeight = 1;
  std::string CoverageArrayName;
  std::string DensityArrayName;
  vtkSmartPointer<vtkDataObject> DensityVolume;
  std::string CoordinatesNames[2] = { "TextureCoordinates1", "TextureCoordinates2" };

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
