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
#include "HexahedronMediumShader.h"
#include "HexahedronWalkShader.h"
#include "ListedHexahedraShader.h"
#include "MediumBesideShader.h"
#include "MediumPiecesShader.h"
#include "NeighborTopologyShader.h"
#include "PixelRayShader.h"
#include "RayCellsFragment.h"
#include "RayContoursShader.h"
#include "RayEntryShader.h"
#include "RayHexahedraFragment.h"
#include "RayRangeShader.h"
#include "RaySegmentsShader.h"
#include "RayStartShader.h"
#include "RaySurfacesShader.h"
#include "RayTetrahedronShader.h"
#include "RayVoxelsFragment.h"
#include "TetrahedronMediumShader.h"
#include "TetrahedronWalkShader.h"
#include "ThinPiecesShader.h"
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

std::string WithHexahedra(const std::string& shader, bool structured)
{
  return WithShaderParts(shader,
    { { "Topology", structured ? GridHexahedraShader : ListedHexahedraShader },
      { "GridCells", GridCellsShader }, { "HexahedronWalk", HexahedronWalkShader },
      { "HexahedronContours", HexahedronContoursShader }, { "CubicContours", CubicContoursShader },
      { "CubicPieces", CubicPiecesShader }, { "ThinPieces", ThinPiecesShader },
      { "RaySegments", RaySegmentsShader }, { "RayRange", RayRangeShader },
      { "VisibleDepths", VisibleDepthsShader }, { "PixelRay", PixelRayShader },
      { "CameraLight", CameraLight::ShaderText() } });
}

std::string WithVoxels(const std::string& shader)
{
  return WithShaderParts(shader,
    { { "VoxelWalk", VoxelWalkShader }, { "ThinPieces", ThinPiecesShader },
      { "VoxelCells", VoxelCellsShader }, { "VoxelContours", VoxelContoursShader },
      { "CubicContours", CubicContoursShader }, { "CubicPieces", CubicPiecesShader },
      { "RayRange", RayRangeShader }, { "VisibleDepths", VisibleDepthsShader },
      { "RaySegments", RaySegmentsShader }, { "CameraLight", CameraLight::ShaderText() } });
}

// The functions of a walk, and the medium's, without what all media have once.
std::string AsMedium(const std::string& walk, const char* medium)
{
  return WithShaderParts(walk.substr(0, walk.find("void main()")) + medium,
    { { "RayEntry", "" }, { "MediumPieces", MediumPiecesShader },
      { "MediumBeside", MediumBesideShader }, { "Arrays", "" }, { "OpaqueDepth", "" },
      { "OpticalSegment", "" } });
}
}

std::string TetrahedraShader(TetrahedronTopology topology)
{
  return WithTetrahedra(
    WithShaderParts(RayCellsFragment, { { "RayEntry", RayEntryShader } }), topology);
}

std::string HexahedraShader(bool structured)
{
  return WithHexahedra(
    WithShaderParts(RayHexahedraFragment, { { "RayEntry", RayEntryShader } }), structured);
}

std::string VoxelsShader()
{
  return WithVoxels(RayVoxelsFragment);
}

std::string TetrahedraMediumShader(TetrahedronTopology topology)
{
  return WithTetrahedra(AsMedium(RayCellsFragment, TetrahedronMediumShader), topology);
}

std::string HexahedraMediumShader(bool structured)
{
  return WithHexahedra(AsMedium(RayHexahedraFragment, HexahedronMediumShader), structured);
}

std::string VoxelsMediumShader()
{
  return WithVoxels(AsMedium("", VoxelMediumShader));
}

} // namespace nephoscope
