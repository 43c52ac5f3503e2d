// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The beginning of a medium whose rays enter through faces, and may be lost in one: then they pass beside the centre of the pixel.
// Uses farthestBeside(triangle): the greatest distance from the centre, in pixels, at which a ray that enters through this triangle may pass.
//NEPHOSCOPE::FaceNumber
void prepareMedium()
{
  keepSteps();
  keepUniforms();
}

// By how many pixels the next attempt passes the centre of the pixel, in the medium that was lost: where one is found, another may be lost.
int mediumAttempt = 0;
vec2 beside = vec2(0.0);

void placeBeside()
{
  if (lostMedium != mediumNumber && !isLastAttempt)
  {
    return;
  }
  ivec3 triangle = element(boundaryFaces, max(faceOfFloat(entered[mediumNumber]), 0)).xyz;
  float farthest = farthestBeside(triangle);
  bool isNear = false;
  for (int i = 0; i < lastAttempt && !isNear; ++i)
  {
    mediumAttempt = isLastAttempt ? lastAttempt : min(mediumAttempt + 1, lastAttempt - 1);
    beside = besideCentre(mediumAttempt, triangle);
    isNear = dot(beside, beside) <= farthest * farthest;
  }
  beside = isNear ? beside : vec2(0.0);
}
