// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** The OpenGL entry points: glad from VTK 9.4 on, glew before. */
#ifndef nephoscope_OpenGLFunctions_h
#define nephoscope_OpenGLFunctions_h

#if __has_include("vtk_glad.h")
#include "vtk_glad.h"
#else
#include "vtk_glew.h"
#endif

#endif
