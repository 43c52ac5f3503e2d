// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkCloudTextureMapper
 * @brief Draws the surface of clouds with a texture of broken cloud, with the cover that is asked for
 *
 * The texture is a sum of modulated cosines (Gardner 1985; Max, Crawfis and Becker, New Techniques in 3D Scalar and Vector Field
 * Visualization, Pacific Graphics 1993, section 4). Where it exceeds a threshold there is cloud; the threshold follows from the
 * cover, with the distribution of what is compared with it, so that the drawn cover is the one asked for at every distance and
 * while two sets of coordinates fade into each other. Colours and lights are those of vtkPolyDataMapper. It is translucent: use depth
 * peeling where it is to be in the right order with other translucent things and with itself.
 *
 * Point arrays that it reads where they are there: TextureCoordinates1 and TextureCoordinates2 (3 components), and the field data
 * TextureWeights and TextureFrame (0: longitude, latitude, height; 1: Cartesian). Without such coordinates, positions.
 */
#ifndef vtkCloudTextureMapper_h
#define vtkCloudTextureMapper_h

#include "vtkNephoscopeRepresentationsCloudTextureModule.h" // for export macro
#include "vtkOpenGLPolyDataMapper.h"

#include <memory> // for vtkInternals
#include <string> // for array names

class vtkShaderProgram;

class VTKNEPHOSCOPEREPRESENTATIONSCLOUDTEXTURE_EXPORT vtkCloudTextureMapper
  : public vtkOpenGLPolyDataMapper
{
public:
  static vtkCloudTextureMapper* New();
  vtkTypeMacro(vtkCloudTextureMapper, vtkOpenGLPolyDataMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Share of the surface that is cloud, 0 ... 1. Default: 0.5. Ignored where CoverageArrayName is set. */
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
   * Width of the edges of clouds: standard deviation, in units of the texture, whose own is 1. 0 ... 2, default: 0.15. 0 is sharp, but for
   * the pixel's filter. Cover counts half-transparent edges by their transparency, so it does not change.
   */
  vtkSetClampMacro(Softness, double, 0.0, 2.0);
  vtkGetMacro(Softness, double);
  ///@}

  ///@{
  /**
   * How often the texture repeats itself in one unit of the coordinates: around the equator, or along the longest side of a surface that is not a
   * globe. > 0, default: 3. With longitudes as coordinates it is rounded to a whole number.
   */
  vtkSetClampMacro(TextureScale, double, 1e-6, 1e6);
  vtkGetMacro(TextureScale, double);
  ///@}

  ///@{
  /** Length of one unit of texture where coordinates come from positions; 0 (default): equator or longest side of the surface. */
  vtkSetClampMacro(TextureLength, double, 0.0, 1e300);
  vtkGetMacro(TextureLength, double);
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
   * and the back face. With UseThickness. Default: empty, the density is 1.
   */
  void SetDensityArrayName(const char* name);
  const char* GetDensityArrayName() const { return this->DensityArrayName.c_str(); }
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
   * stays where it is. 0 ... 1, default: 0, none; 0.02 to 0.05 look like clouds.
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
  void SetMapperShaderParameters(vtkOpenGLHelper& helper, vtkRenderer* renderer, vtkActor* actor) override;

private:
  vtkCloudTextureMapper(const vtkCloudTextureMapper&) = delete;
  void operator=(const vtkCloudTextureMapper&) = delete;

  void SetName(std::string& member, const char* name);
  void PrepareSurface(vtkPolyData* input);
  void MapArrays();
  void FindThickness(vtkRenderer* renderer, vtkActor* actor);
  void TellThickness(const std::string& error);
  void DrawTriangles(vtkOpenGLHelper& helper, vtkRenderer* renderer, vtkActor* actor);
  double GetExtinctionInUse(vtkActor* actor) const;
  void SetEye(vtkShaderProgram* program, vtkRenderer* renderer, vtkActor* actor);
  void SetReliefHeight(vtkShaderProgram* program, vtkActor* actor);

  double Coverage = 0.5;
  double Softness = 0.15;
  double TextureScale = 3;
  double TextureLength = 0;
  double OpticalDepth = 3;
  bool UseThickness = false;
  double Extinction = 0;
  int MaximumNumberOfLayers = 8;
  double Relief = 0;
  std::string CoverageArrayName;
  std::string DensityArrayName;
  std::string CoordinatesNames[2] = { "TextureCoordinates1", "TextureCoordinates2" };

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
