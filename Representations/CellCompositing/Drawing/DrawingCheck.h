// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Whether this OpenGL draws cells right: a known tetrahedron and a known cell of a grid, small, compared with the closed form. Drivers
 * differ in what no error tells. Once per driver and way of drawing in a process: some milliseconds, and the compiling of shaders.
 */
#ifndef DrawingCheck_h
#define DrawingCheck_h

#include <string>

class vtkOpenGLRenderWindow;

namespace nephoscope
{

enum class DrawnBy
{
  Rays,
  Projection
};

/**
 * Empty, or what is wrong; the window's context is current. The environment variable NEPHOSCOPE_WRONG_DRAWING names a way (Rays,
 * Projection, or both) that is taken as wrong, so that the way around it can be tried.
 */
std::string checkDrawing(vtkOpenGLRenderWindow* window, DrawnBy way);

} // namespace nephoscope

#endif
