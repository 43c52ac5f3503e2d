// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The GPU data that every method of drawing cells needs: points with their scalars, scalars of
 * cells, and the transfer functions.
 */
#ifndef nephoscope_CellBuffers_h
#define nephoscope_CellBuffers_h

#include "BufferTexture.h"
#include "TransferFunctionTable.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;

namespace nephoscope
{

class CameraLight;
class CellGeometry;

class CellBuffers
{
public:
  // Each returns an empty string, or what went wrong.
  std::string UploadGeometry(vtkOpenGLRenderWindow* window, const CellGeometry& geometry);
  /** Only the values of colour, of opacity or of both, of a geometry that was uploaded before. */
  std::string UploadValues(
    vtkOpenGLRenderWindow* window, const CellGeometry& geometry, bool ofColor, bool ofOpacity);
  /**
   * Light that depends on the direction of view (CameraLight.h), or none; `width` is that of the
   * range of scalars.
   */
  std::string UploadCameraLight(
    vtkOpenGLRenderWindow* window, const CameraLight& light, double width);
  /**
   * One table of either kind, or one per layer; `tables` has the number of its tables for each
   * tetrahedron, or is empty.
   */
  std::string UploadTransferFunctions(vtkOpenGLRenderWindow* window,
    const std::vector<TransferFunctionTable>& colorAndOpacity,
    const std::vector<TransferFunctionTable>& opacity, const std::vector<std::int32_t>& tables);

  /**
   * Where the transfer functions have few nodes, SMALL_TABLE and SMALL_OPACITY_TABLE of
   * RaySegments.glsl; otherwise they are not defined.
   */
  std::string SmallTableDefinition() const;
  /** Whether all of the transfer function is in uniforms, and has at most `most` nodes. */
  bool HasSmallTables(std::size_t most) const;
  void SetSmallTable(vtkShaderProgram* program, int instance = -1) const;

  bool HasPointOpacity() const { return this->SeparateOpacity && !this->OpacityOnCells; }
  bool HasOpacityScalars() const { return this->SeparateOpacity; }
  bool HasLayers() const { return this->UseLayers; }
  /** Shader constants that say which of the buffers are used. */
  std::string ShaderConstants() const;
  /**
   * Binds the textures that the program reads and sets their units; `instance` as in InstanceName.
   */
  void Activate(vtkShaderProgram* program, int instance = -1);
  /** At most so many of them are read. */
  int CountTextures() const;
  void Deactivate();
  void Release(vtkWindow* window);

private:
  enum Name
  {
    Points,
    CellScalars,
    OpacityScalars,
    TransferNodes,
    TransferIntervals,
    OpacityNodes,
    OpacityIntervals,
    LayerTables,
    TetrahedronLayers,
    LightParts,
    PhaseFunction,
    NumberOfBuffers
  };
  bool UsesSmallOpacityTable() const;
  std::string UploadPoints(vtkOpenGLRenderWindow* window, const CellGeometry& geometry);
  std::string UploadTables(vtkOpenGLRenderWindow* window,
    const std::vector<TransferFunctionTable>& tables, Name nodes, Name intervals);

  std::array<BufferTexture, NumberOfBuffers> Buffers;
  TransferFunctionTable SmallTable,
    SmallOpacityTable; // copies of nodes and intervals; empty if there are many
  bool UseCellScalars = false;
  bool SeparateOpacity = false;
  bool OpacityOnCells = false;
  bool UseLayers = false;
  bool UseCameraLight = false;
  int NumberOfPhases = 0;
  std::array<float, 3> TowardsSun = { { 0, 0, 1 } };
  int NumberOfTransferNodes = 0;
  int NumberOfOpacityNodes = 0;
};

} // namespace nephoscope

#endif
