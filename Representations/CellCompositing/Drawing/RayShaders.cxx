// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RayShaders.h"

#include "ShaderParts.h"

#include "CameraLightShader.h"
#include "ChessboardTopologyShader.h"
#include "CubicContoursShader.h"
#include "CubicPiecesShader.h"
#include "DividedHexahedraShader.h"
#include "GridCellsShader.h"
#include "GridHexahedraShader.h"
#include "HexahedronContoursShader.h"
#include "HexahedronWalkShader.h"
#include "ListedHexahedraShader.h"
#include "NeighborTopologyShader.h"
#include "PixelRayShader.h"
#include "RayCellsFragment.h"
#include "RayContoursShader.h"
#include "RayEntryShader.h"
#include "RayHexahedraFragment.h"
#include "RayMediumShader.h"
#include "RayRangeShader.h"
#include "RaySegmentsShader.h"
#include "RayStartShader.h"
#include "RaySurfacesShader.h"
#include "RayTetrahedronShader.h"
#include "RayVoxelsFragment.h"
#include "TetrahedronWalkShader.h"
#include "VisibleDepthsShader.h"
#include "VoxelContoursShader.h"
#include "VoxelWalkShader.h"

namespace nephoscope
{
namespace
{
std::string withTetrahedra(const std::string& shader, TetrahedronTopology topology)
{
  const char* text = topology == TetrahedronTopology::Grid ? ChessboardTopologyShader
    : topology == TetrahedronTopology::Hexahedra           ? DividedHexahedraShader
                                                           : NeighborTopologyShader;
  return withShaderParts(shader,
    { { "RayTetrahedron", RayTetrahedronShader }, { "RayStart", RayStartShader },
      { "RaySurfaces", RaySurfacesShader }, { "Topology", text }, { "GridCells", GridCellsShader },
      { "TetrahedronWalk", TetrahedronWalkShader }, { "RaySegments", RaySegmentsShader },
      { "RayRange", RayRangeShader }, { "VisibleDepths", VisibleDepthsShader },
      { "PixelRay", PixelRayShader }, { "RayContours", RayContoursShader },
      { "CameraLight", CameraLightShader } });
}
}

std::string tetrahedraShader(TetrahedronTopology topology)
{
  return withTetrahedra(
    withShaderParts(RayCellsFragment, { { "RayEntry", RayEntryShader } }), topology);
}

std::string hexahedraShader(bool structured)
{
  return withShaderParts(RayHexahedraFragment,
    { { "Topology", structured ? GridHexahedraShader : ListedHexahedraShader },
      { "GridCells", GridCellsShader }, { "HexahedronWalk", HexahedronWalkShader },
      { "HexahedronContours", HexahedronContoursShader }, { "CubicContours", CubicContoursShader },
      { "CubicPieces", CubicPiecesShader }, { "RaySegments", RaySegmentsShader },
      { "RayRange", RayRangeShader }, { "VisibleDepths", VisibleDepthsShader },
      { "PixelRay", PixelRayShader }, { "RayEntry", RayEntryShader },
      { "CameraLight", CameraLightShader } });
}

std::string voxelsShader()
{
  return withShaderParts(RayVoxelsFragment,
    { { "VoxelWalk", VoxelWalkShader }, { "VoxelContours", VoxelContoursShader },
      { "CubicContours", CubicContoursShader }, { "CubicPieces", CubicPiecesShader },
      { "RayRange", RayRangeShader }, { "VisibleDepths", VisibleDepthsShader },
      { "RaySegments", RaySegmentsShader }, { "CameraLight", CameraLightShader } });
}

std::string mediumShader(TetrahedronTopology topology)
{
  const std::string walk = RayCellsFragment;
  const std::string text = walk.substr(0, walk.find("void main()")) + RayMediumShader;
  return withShaderParts(withTetrahedra(text, topology),
    { { "RayEntry", "" }, { "Arrays", "" }, { "OpaqueDepth", "" }, { "OpticalSegment", "" } });
}

} // namespace nephoscope
