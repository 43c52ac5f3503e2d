// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The fragment shaders of rays, put together from their parts; constants are still to be defined
 * (SpecializedShader).
 */
#ifndef nephoscope_RayShaders_h
#define nephoscope_RayShaders_h

#include <string>

namespace nephoscope
{

/** How a walk finds the next tetrahedron. */
enum class TetrahedronTopology
{
  List,     ///< neighbours of each
  Grid,     ///< indices; no lists
  Hexahedra ///< neighbours of each hexahedron, which is divided as a cell of a grid
};

/** From tetrahedron to tetrahedron. */
std::string TetrahedraShader(TetrahedronTopology topology);
/** From hexahedron to hexahedron, in trilinear fields. */
std::string HexahedraShader(bool structured);
/** From cell to cell of a grid with evenly spaced points. */
std::string VoxelsShader();
///@{
/** The walks above, each for one of several media in a shader, without the common code. */
std::string TetrahedraMediumShader(TetrahedronTopology topology);
std::string HexahedraMediumShader(bool structured);
std::string VoxelsMediumShader();
///@}

} // namespace nephoscope

#endif
