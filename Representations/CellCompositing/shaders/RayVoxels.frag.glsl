//VTK::System::Dec
//VTK::Output::Dec
// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Light of the cells of an evenly spaced grid along a pixel's ray: from cell to cell by arithmetic, in leaps where nothing is seen.
//   out: premultiplied colour and alpha, front to back
//NEPHOSCOPE::Arrays
uniform mat4 MCVCMatrix;
uniform vec4 eyeVC; // (position, 1) or (direction towards the eye, 0)
uniform float extinctionScale; // extinction per world length at opacity 1
// The pixel's ray goes through this point, amid the data, in this direction; relative to the centre of the data.
noperspective in vec3 rayPointVSOutput;
noperspective in vec3 rayDirectionVSOutput;
uniform int maximumSteps;
uniform sampler2D pixelOwners; // RayOwners.frag.glsl
uniform float owner;
float unity = 0.0; // RayCells.frag.glsl says why uniforms are copied

//NEPHOSCOPE::Constants
// further: hasOwners, trilinear
//NEPHOSCOPE::OpaqueDepth
//NEPHOSCOPE::OpticalSegment
//NEPHOSCOPE::TransferFunction
//NEPHOSCOPE::RaySegments
//NEPHOSCOPE::ContourSurfaces
//NEPHOSCOPE::RayRange
//NEPHOSCOPE::CubicPieces
//NEPHOSCOPE::CameraLight
//NEPHOSCOPE::VoxelCells
//NEPHOSCOPE::ThinPieces
//NEPHOSCOPE::VoxelWalk

void main()
{
  if (hasOwners && texelFetch(pixelOwners, ivec2(gl_FragCoord.xy), 0).r != owner)
  {
    discard;
  }
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
