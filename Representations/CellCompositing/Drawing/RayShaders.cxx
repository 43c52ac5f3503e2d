// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RayShaders.h"

#include "CameraLight.h"
#include "ShaderParts.h"

#include "ChessboardTopologyShader.h"
#include "CubicContoursShader.h"
#include "CubicPiecesShader.h"
#include "DividedHexahedraShader.h"
#include "GridCellsShader.h"
#include "GridHexahedraShader.h"
#include "HexahedronContoursShader.h"
#include "HexahedronWalkShader.h"
#include "ListedHexahedraShader.h"
#include "MediumPiecesShader.h"
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
#include "VoxelCellsShader.h"
#include "VoxelContoursShader.h"
#include "VoxelMediumShader.h"
#include "VoxelWalkShader.h"

namespace nephoscope
{
namespace
{
std::string WithTetrahedra(const std::string& shader, TetrahedronTopology topology)
{
  const char* text = topology == TetrahedronTopology::Grid ? ChessboardTopologyShader
    : topology == TetrahedronTopology::Hexahedra           ? DividedHexahedraShader
                                                           : NeighborTopologyShader;
  return WithShaderParts(shader,
    { { "RayTetrahedron", RayTetrahedronShader }, { "RayStart", RayStartShader },
      { "RaySurfaces", RaySurfacesShader }, { "Topology", text }, { "GridCells", GridCellsShader },
      { "TetrahedronWalk", TetrahedronWalkShader }, { "RaySegments", RaySegmentsShader },
      { "RayRange", RayRangeShader }, { "VisibleDepths", VisibleDepthsShader },
      { "PixelRay", PixelRayShader }, { "RayContours", RayContoursShader },
      { "CameraLight", CameraLight::ShaderText() } });
}

std::string WithVoxels(const std::string& shader)
{
  return WithShaderParts(shader,
    { { "VoxelWalk", VoxelWalkShader }, { "VoxelCells", VoxelCellsShader },
      { "VoxelContours", VoxelContoursShader }, { "CubicContours", CubicContoursShader },
      { "CubicPieces", CubicPiecesShader }, { "RayRange", RayRangeShader },
      { "VisibleDepths", VisibleDepthsShader }, { "RaySegments", RaySegmentsShader },
      { "CameraLight", CameraLight::ShaderText() } });
}

// What all media have once.
std::string WithoutCommonParts(const std::string& shader)
{
  return WithShaderParts(
    shader, { { "Arrays", "" }, { "OpaqueDepth", "" }, { "OpticalSegment", "" } });
}
}

std::string TetrahedraShader(TetrahedronTopology topology)
{
  return WithTetrahedra(
    WithShaderParts(RayCellsFragment, { { "RayEntry", RayEntryShader } }), topology);
}

std::string HexahedraShader(bool structured)
{
  return WithShaderParts(RayHexahedraFragment,
    { { "Topology", structured ? GridHexahedraShader : ListedHexahedraShader },
      { "GridCells", GridCellsShader }, { "HexahedronWalk", HexahedronWalkShader },
      { "HexahedronContours", HexahedronContoursShader }, { "CubicContours", CubicContoursShader },
      { "CubicPieces", CubicPiecesShader }, { "RaySegments", RaySegmentsShader },
      { "RayRange", RayRangeShader }, { "VisibleDepths", VisibleDepthsShader },
      { "PixelRay", PixelRayShader }, { "RayEntry", RayEntryShader },
      { "CameraLight", CameraLight::ShaderText() } });
}

std::string VoxelsShader()
{
  return WithVoxels(RayVoxelsFragment);
}

std::string ShaderOfMedium(TetrahedronTopology topology)
{
  const std::string walk = RayCellsFragment;
  const std::string text = walk.substr(0, walk.find("void main()")) + RayMediumShader;
  return WithoutCommonParts(WithShaderParts(WithTetrahedra(text, topology),
    { { "RayEntry", "" }, { "MediumPieces", MediumPiecesShader } }));
}

std::string ShaderOfVoxelMedium()
{
  return WithoutCommonParts(
    WithVoxels(WithShaderParts(VoxelMediumShader, { { "MediumPieces", MediumPiecesShader } })));
}

} // namespace nephoscope
