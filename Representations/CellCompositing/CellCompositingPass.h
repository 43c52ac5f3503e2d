// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Draws tetrahedra in a given order into a float image and lays it over the scene.
 *
 * Everything the shaders read is in buffer textures: points, tetrahedra, cell scalars and the transfer function are
 * uploaded when they change, the drawing order whenever the view does.
 */
#ifndef CellCompositingPass_h
#define CellCompositingPass_h

#include "FloatAccumulation.h"
#include "OpaqueDepth.h"
#include "SceneLights.h"
#include "TransferFunctionTable.h"

#include "vtkNew.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

class vtkImageData;
class vtkMatrix4x4;
class vtkOpenGLRenderWindow;
class vtkOpenGLVertexArrayObject;
class vtkShaderProgram;
class vtkWindow;

namespace nephoscope
{

class CellGeometry;
class ContourScene;

class CellCompositingPass
{
public:
  /** What one drawing needs to know of the view; matrices as vtkMatrix4x4 multiplies columns. */
  struct View
  {
    vtkMatrix4x4* ModelToView = nullptr; ///< of coordinates relative to the geometry's centre
    vtkMatrix4x4* ViewToDevice = nullptr;
    double EyeModel[4] = { 0, 0, 0, 1 }; ///< relative to the geometry's centre
    double EyeView[4] = { 0, 0, 0, 1 };
  };
  struct Options
  {
    bool AverageIntegration = false;
    bool SplitAtControlPoints = true;
    double ExtinctionScale = 1.0;
    bool ContourLayers = false;   ///< layers lie between contours; otherwise tetrahedra have them
    bool ContourLighting = false;
    std::array<float, 4> ContourShading = { { 0, 1, 0, 1 } }; ///< ambient, diffuse, specular, specular power
    std::vector<SceneLight> Lights; ///< of contour surfaces
  };

  CellCompositingPass();
  ~CellCompositingPass();

  // Each returns an empty string, or what went wrong.
  std::string UploadGeometry(vtkOpenGLRenderWindow* window, const CellGeometry& geometry);
  /** One table of either kind, or one per layer; `tables` has the number of its tables for each tetrahedron, or is empty. */
  std::string UploadTransferFunctions(vtkOpenGLRenderWindow* window,
    const std::vector<TransferFunctionTable>& colorAndOpacity, const std::vector<TransferFunctionTable>& opacity,
    const std::vector<std::int32_t>& tables);
  std::string UploadContours(vtkOpenGLRenderWindow* window, const ContourScene& contours);
  std::string UploadOrder(vtkOpenGLRenderWindow* window, const std::vector<std::int32_t>& order);
  std::string Draw(vtkOpenGLRenderWindow* window, const View& view, const Options& options);

  bool CopyFloatImage(vtkOpenGLRenderWindow* window, vtkImageData* image);
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  class BufferTexture;
  enum BufferName
  {
    Points,
    Tetrahedra,
    CellScalars,
    OpacityScalars,
    DrawingOrder,
    TransferNodes,
    TransferIntervals,
    OpacityNodes,
    OpacityIntervals,
    TetrahedronLayers,
    LayerTables,
    ContourScalars,
    Contours,
    ContourGradients,
    NumberOfBuffers
  };

  std::string UploadTables(vtkOpenGLRenderWindow* window, const std::vector<TransferFunctionTable>& tables,
    BufferName nodes, BufferName intervals);
  bool ReadyProgram(vtkOpenGLRenderWindow* window, const Options& options);
  void ActivateTextures();
  void SetUniforms(const View& view, const Options& options);
  void SetContourUniforms(const View& view, const Options& options);
  std::string DrawTetrahedra(vtkOpenGLRenderWindow* window, const View& view, const Options& options);

  std::array<std::unique_ptr<BufferTexture>, NumberOfBuffers> Buffers;
  bool UseCellScalars = false;
  bool SeparateOpacity = false;
  bool OpacityOnCells = false;
  int NumberOfTransferNodes = 0;
  int NumberOfOpacityNodes = 0;
  bool UseLayers = false;
  int NumberOfContours = 0;
  bool ContourOfColor = true;
  bool SmoothContourNormals = false;
  bool NarrowIntervals = false; // of a transfer function: scalars at faces must be the same for both neighbours
  int ImageSize[2] = { 1, 1 };
  std::size_t OrderSize = 0;

  OpaqueDepth Depth;
  FloatAccumulation Accumulation;
  vtkNew<vtkOpenGLVertexArrayObject> VertexArray;
  vtkShaderProgram* Program = nullptr; // owned by the window's shader cache
};

} // namespace nephoscope

#endif
