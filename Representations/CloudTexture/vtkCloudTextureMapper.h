// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkCloudTextureMapper
 * @brief Draws the surface of clouds with a texture of broken cloud that has a given cover
 *
 * The texture is a sum of modulated cosines (Gardner 1985; Max, Crawfis and Becker, New Techniques
 * in 3D Scalar and Vector Field Visualization, Pacific Graphics 1993, section 4). There is cloud
 * where it exceeds a threshold. The threshold is computed from the cover and the distribution of
 * the texture, so that the drawn cover is the requested one at every distance and while two sets of
 * coordinates fade into each other. Colours and lights are those of vtkPolyDataMapper; the texture
 * multiplies the colours. The surface is translucent: use depth peeling to draw it in the correct
 * order with itself and with other translucent objects.
 *
 * Optional point arrays: TextureCoordinates1 and TextureCoordinates2 (3 components), and the field
 * data TextureWeights and TextureFrame (0: longitude, latitude, height; 1: Cartesian). Without such
 * coordinates, positions.
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
  /**
   * Fraction of the surface that is cloud, 0 ... 1. Default: 0.5. Ignored with UseThreshold and if
   * CoverageArrayName is set.
   */
  vtkSetClampMacro(Coverage, double, 0.0, 1.0);
  vtkGetMacro(Coverage, double);
  ///@}

  ///@{
  /**
   * Point array of the cover, 0 ... 1 at every point, such as a model's cloud fraction. Default:
   * empty, Coverage applies everywhere.
   */
  void SetCoverageArrayName(const char* name);
  const char* GetCoverageArrayName() const { return this->CoverageArrayName.c_str(); }
  ///@}

  ///@{
  /**
   * On: you set the threshold above which there is cloud, in standard deviations of the texture,
   * whose mean is 0. The cover then follows from the distribution of the texture. Defaults: off, 0.
   */
  vtkSetMacro(UseThreshold, bool);
  vtkGetMacro(UseThreshold, bool);
  vtkBooleanMacro(UseThreshold, bool);
  vtkSetClampMacro(Threshold, double, -1e30, 1e30);
  vtkGetMacro(Threshold, double);
  ///@}

  ///@{
  /**
   * Cover and threshold for one set of coordinates without thickness: you set one of them, and the
   * other follows from it.
   */
  double GetCoverageUsed();
  double GetThresholdUsed();
  ///@}

  ///@{
  /**
   * Width of the edges of clouds: standard deviation, in units of the texture, whose own standard
   * deviation is 1. 0 ... 2, default: 0.4.
   * 0 is sharp, except for the filter of the pixel. Half-transparent edges count in proportion to
   * their opacity, so the cover does not change.
   */
  vtkSetClampMacro(Softness, double, 0.0, 2.0);
  vtkGetMacro(Softness, double);
  ///@}

  ///@{
  /**
   * Number of texture periods in one unit of the coordinates: around the equator, or along the
   * longest side of a surface that is not a globe. 0 ... 1e6. 0 (default): chosen from the shape of
   * the surface, more for flat layers than for bodies. With longitudes as coordinates it is rounded
   * to a whole number. GetTextureScaleUsed() is that of the last picture.
   */
  vtkSetClampMacro(TextureScale, double, 0.0, 1e6);
  vtkGetMacro(TextureScale, double);
  double GetTextureScaleUsed() const;
  ///@}

  ///@{
  /**
   * Length of one texture unit if coordinates come from positions; 0 (default): the equator or the
   * longest side of the surface.
   */
  vtkSetClampMacro(TextureLength, double, 0.0, 1e300);
  vtkGetMacro(TextureLength, double);
  ///@}

  ///@{
  /**
   * The third coordinate of the texture is the altitude: 0 at the low end of AltitudeRange and 1 at
   * the high end, for any scale. Without arrays of coordinates the first two are longitude and
   * latitude on a globe (in turns, times TextureScale), and the altitude is the distance from its
   * centre; elsewhere x, y and z. If its ends are not in order (default: 0, 0), the range of the
   * data is used. Default: off.
   */
  vtkSetMacro(UseAltitude, bool);
  vtkGetMacro(UseAltitude, bool);
  vtkBooleanMacro(UseAltitude, bool);
  vtkSetVector2Macro(AltitudeRange, double);
  vtkGetVector2Macro(AltitudeRange, double);
  ///@}

  ///@{
  /**
   * Colour from the texture: ThinColor where it just exceeds the threshold, ThickColor where it
   * exceeds it by ColorRange or more, and a mixture in between. They multiply the colour of the
   * surface; ColorRange is in units of the texture, > 0. Defaults: a bluish grey, white, 1.5.
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
   * The waves that add up to the texture. Clouds (default): 12 waves in all directions. Paper: 7
   * waves with a phase shift across each wave, as the text of the paper describes. Printed: the
   * formula as printed. Gardner: waves along the axes, each with twice the frequency of the last.
   * Custom: those of SetCustomWave.
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
   * Custom waves, 16 at most. Until they are set, they are the waves of Clouds. Wave i is
   *   amplitude cos(2 pi (b u + c v + d w + phase) + shift sin(2 pi (e u + g v + h w))).
   * Their sum is divided by its standard deviation. On longitudes b and e are rounded to whole
   * numbers. No two waves may have the same frequencies, because the cover would then differ from
   * the requested one.
   */
  void SetNumberOfCustomWaves(int count);
  int GetNumberOfCustomWaves() const;
  void SetCustomWave(int i, double amplitude, double b, double c, double d, double shift, double e,
    double g, double h, double phase);
  /** The nine numbers of wave i, in the order of SetCustomWave; zeros where there is none. */
  void GetCustomWave(int i, double values[9]) const;
  /** Like GetCustomWave, for the waves in use, whose sum has a standard deviation of 1. */
  int GetNumberOfWavesUsed() const;
  void GetWaveUsed(int i, double values[9]) const;
  ///@}

  ///@{
  /**
   * Optical depth of the clouds at normal incidence; along a ray it is divided by the cosine of the
   * angle between ray and normal. >= 0, default: 3, which hides 95 % of the background, seen from
   * straight above.
   */
  vtkSetClampMacro(OpticalDepth, double, 0.0, 1e30);
  vtkGetMacro(OpticalDepth, double);
  ///@}

  ///@{
  /**
   * Opacity follows the thickness of the clouds: the optical depth is integrated along the ray from
   * each front face to the next back face, or to an opaque object. Use it with closed surfaces
   * whose triangles face outwards, such as those of vtkCloudSurface. Without a face behind,
   * OpticalDepth applies. Default: off, OpticalDepth applies everywhere.
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
   * With UseThickness: opacity is that of the optical depth along the ray (default), or
   * ThicknessWeight times the optical depth is added to the texture before the threshold, so that
   * thin edges break up. Coverage is then the cover at thickness 0, and OpticalDepth gives the
   * opacity. ThicknessWeight is >= 0, default: 1.
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
   * With UseThickness: extinction coefficient of cloud, per unit of length of the scene. >= 0. 0
   * (default): rays through the surface have OpticalDepth on average. Set it for a surface that
   * changes with time.
   */
  vtkSetClampMacro(Extinction, double, 0.0, 1e300);
  vtkGetMacro(Extinction, double);
  ///@}

  ///@{
  /**
   * With UseThickness: point array of the cloud density, >= 0, which multiplies Extinction; along
   * the ray the density is linear between the front and the back face. Default: empty, the density
   * is 1. With DensityVolume it names an array of that volume.
   */
  void SetDensityArrayName(const char* name);
  const char* GetDensityArrayName() const { return this->DensityArrayName.c_str(); }
  ///@}

  ///@{
  /**
   * Cloud density in space, >= 0, in the coordinates of the surface: the array DensityArrayName, or
   * the active scalars without a name, of any grid or composite dataset; on points, otherwise on
   * cells. With UseThickness it is integrated along the ray inside the surface, instead of the
   * density at the two faces. The integral is exact for trilinear voxels of images with a point
   * array, and for linear density in the tetrahedra into which other cells are divided. A cell
   * array gives a constant density in each cell. Outside the cells, and in hidden and ghost cells,
   * the density is 0. Default: none. Costs on the GPU 4 bytes per point of an image, up to 100
   * bytes per tetrahedron elsewhere (cells without density cost nothing), and per pixel the
   * traversal of voxels or tetrahedra.
   */
  void SetDensityVolume(vtkDataObject* volume);
  vtkDataObject* GetDensityVolume() const;
  ///@}

  ///@{
  /**
   * For OpenGL without images in shaders (before 4.2, and without GL_ARB_shader_image_load_store):
   * maximum number of clouds behind one another that UseThickness finds in a pixel, nearest and
   * farthest first; a warning reports if there are more. Every two clouds cost one pass over the
   * depths. Later OpenGL finds all clouds. 2 ... 16, default: 8. OpenGL's number of textures may
   * allow less.
   */
  vtkSetClampMacro(MaximumNumberOfLayers, int, 2, 16);
  vtkGetMacro(MaximumNumberOfLayers, int);
  ///@}

  ///@{
  /**
   * Height of the bump map that shades the clouds, as a fraction of the longest wavelength: clouds
   * get a sunny and a shady side. The surface itself does not move. 0 ... 1, default: 0.03; 0:
   * none.
   */
  vtkSetClampMacro(Relief, double, 0.0, 1.0);
  vtkGetMacro(Relief, double);
  ///@}

  ///@{
  /**
   * Names of the arrays of texture coordinates. Defaults: TextureCoordinates1, TextureCoordinates2.
   */
  void SetFirstCoordinatesName(const char* name);
  const char* GetFirstCoordinatesName() const { return this->CoordinatesNames[0].c_str(); }
  void SetSecondCoordinatesName(const char* name);
  const char* GetSecondCoordinatesName() const { return this->CoordinatesNames[1].c_str(); }
  ///@}

  ///@{
  /**
   * The part of space, in world coordinates, that this process draws of a picture which several
   * draw together. Each has the whole surface and the whole DensityVolume: thickness is that of the
   * whole. A fragment on the border belongs to one of two regions. If regions fill space and their
   * pictures are laid over each other in the order of the regions, that is the picture of one
   * process. Bounds may be infinite; equal ones: nothing is drawn. Invalid ones, the default: all
   * of space.
   */
  vtkSetVector6Macro(Region, double);
  vtkGetVector6Macro(Region, double);
  ///@}

  /**
   * Also draws composite data sets: all their polygonal blocks as one surface. Blocks that lack the
   * coloured array (by the scalar modes for field data) have the colour of the actor.
   */
  void RenderPiece(vtkRenderer* renderer, vtkActor* actor) override;
  using Superclass::MapScalars;
  vtkUnsignedCharArray* MapScalars(vtkDataSet* input, double alpha, int& cellFlag) override;
  int CanUseTextureMapForColoring(vtkDataObject* input) override;
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
  void WarnOfPlace();
  void LeaveOtherWindow(vtkWindow* window);
  void DrawTriangles(vtkOpenGLHelper& helper, vtkRenderer* renderer, vtkActor* actor);
  double GetExtinctionInUse(vtkActor* actor) const;
  double GetEnoughOpticalDepth() const;
  void SetEye(vtkShaderProgram* program, vtkRenderer* renderer, vtkActor* actor);
  bool HasColors() const;
  void ChooseWaves();
  void CopyWaves(vtkCloudTextureMapper* other);
  bool HasRegion() const;
  void SetRegionUniforms(vtkShaderProgram* program, vtkActor* actor);
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
  double Region[6] = { 1, -1, 1, -1, 1, -1 };
  std::string CoverageArrayName;
  std::string DensityArrayName;
  vtkSmartPointer<vtkDataObject> DensityVolume;
  std::string CoordinatesNames[2] = { "TextureCoordinates1", "TextureCoordinates2" };

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
