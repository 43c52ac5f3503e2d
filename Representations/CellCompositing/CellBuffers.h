// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What every way of drawing cells needs on the GPU: points with their scalars, scalars of cells, and the transfer functions.
 */
#ifndef CellBuffers_h
#define CellBuffers_h

#include "BufferTexture.h"
#include "TransferFunctionTable.h"

#include <array>
#include <string>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;

namespace nephoscope
{

class CellGeometry;
struct CellPieces;

class CellBuffers
{
public:
  // Each returns an empty string, or what went wrong.
  std::string UploadGeometry(vtkOpenGLRenderWindow* window, const CellGeometry& geometry, const CellPieces& pieces);
  std::string UploadTransferFunctions(vtkOpenGLRenderWindow* window, const TransferFunctionTable& colorAndOpacity,
    const TransferFunctionTable& opacity);

  /** Where the transfer function has few nodes, SMALL_TABLE stands for their number; otherwise it is not defined. */
  std::string SmallTableDefinition() const;
  void SetSmallTable(vtkShaderProgram* program) const;

  /** Constants of the shaders that tell which of the buffers count. */
  std::string ShaderConstants() const;
  /** Binds the textures and tells the program their units. */
  void Activate(vtkShaderProgram* program);
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
    NumberOfBuffers
  };
  std::string UploadTable(
    vtkOpenGLRenderWindow* window, const TransferFunctionTable& table, Name nodes, Name intervals);

  std::array<BufferTexture, NumberOfBuffers> Buffers;
  TransferFunctionTable SmallTable; // copy of the nodes and intervals; empty if there are many
  bool UseCellScalars = false;
  bool SeparateOpacity = false;
  bool OpacityOnCells = false;
  int NumberOfTransferNodes = 0;
  int NumberOfOpacityNodes = 0;
};

} // namespace nephoscope

#endif
