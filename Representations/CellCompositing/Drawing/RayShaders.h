// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** The fragment shaders of rays, put together from their parts; constants are still to be defined (specializedShader). */
#ifndef RayShaders_h
#define RayShaders_h

#include <string>

namespace nephoscope
{

/** From tetrahedron to tetrahedron. `structured`: of a grid, which needs no lists. */
std::string tetrahedraShader(bool structured);
/** From hexahedron to hexahedron, in trilinear fields. */
std::string hexahedraShader(bool structured);
/** From cell to cell of a grid with evenly spaced points. */
std::string voxelsShader();
/** The first as one of several media in a shader, without what all media have in common. */
std::string mediumShader(bool structured);

} // namespace nephoscope

#endif
