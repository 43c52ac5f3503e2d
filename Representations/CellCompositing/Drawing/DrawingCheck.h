// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Whether this OpenGL draws cells correctly: it compares a small known tetrahedron and a small
 * known cell of a grid with the closed form. Drivers have differences that no error reports. It
 * runs once per driver and method in a process, and takes some milliseconds and the compilation of
 * shaders.
 */
#ifndef nephoscope_DrawingCheck_h
#define nephoscope_DrawingCheck_h

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
 * Returns the problem, or an empty string; the window's context must be current. The environment
 * variable NEPHOSCOPE_WRONG_DRAWING names a method (Rays, Projection, or both) that counts as
 * wrong, so that the fallback can be tested.
 */
std::string CheckDrawing(vtkOpenGLRenderWindow* window, DrawnBy way);

} // namespace nephoscope

#endif
