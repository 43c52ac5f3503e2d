//VTK::System::Dec
//VTK::Output::Dec
// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Light of the cells of an evenly spaced grid along a pixel's ray: from cell to cell by arithmetic, in leaps where nothing is seen.
//   out: premultiplied colour and alpha, front to back
//NEPHOSCOPE::Arrays
uniform FloatArray squares; // scalars of each point and of the next ones along the second, the third, and both axes
uniform FloatArray opacitySquares; // the same of a separate opacity
uniform FloatArray cellScalars;
uniform FloatArray opacityScalars; // of cells
uniform FloatArray clearDistances; // ClearDistances.h
uniform mat4 MCVCMatrix;
uniform vec4 eyeVC; // (position, 1) or (direction towards the eye, 0)
uniform float extinctionScale; // extinction per world length at opacity 1
// The pixel's ray goes through this point, amid the data, in this direction; relative to the centre of the data.
noperspective in vec3 rayPointVSOutput;
noperspective in vec3 rayDirectionVSOutput;
uniform mat4 toNumbers;    // from there to numbers of points along each axis
uniform int gridStride[3]; // from a point to the next along each axis
uniform int oddOffset;     // 1 if the first point is odd
uniform vec3 boxLow;       // of the cells that can be seen: first and
uniform vec3 boxHigh;      // last cell, inclusive
uniform int maximumSteps;
float unity = 0.0; // RayCells.frag.glsl says why uniforms are copied

//NEPHOSCOPE::Constants
//NEPHOSCOPE::OpaqueDepth
//NEPHOSCOPE::OpticalSegment
//NEPHOSCOPE::TransferFunction
//NEPHOSCOPE::RaySegments
//NEPHOSCOPE::ContourSurfaces
//NEPHOSCOPE::RayRange
//NEPHOSCOPE::CubicPieces
//NEPHOSCOPE::CameraLight
//NEPHOSCOPE::VoxelWalk

void main()
{
  unity = softwareOpenGL ? gl_FragCoord.w : 1.0;
  keepTable();
  keepGrid();
  origin = rayPointVSOutput;
  along = normalize(rayDirectionVSOutput);
  keepCameraLight(along);
  startSegments(length(mat3(MCVCMatrix) * along) * extinctionScale);
  startHaze();
  walkVoxels(visibleRange());
  PUT_LIGHT(light)
}
