// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// 1 - exp(-u) from a table over [0, alphaTableEnd], read with linear interpolation (ProjectedTriangles.h).
uniform FloatArray alphaTable;
uniform float alphaTableEnd;

float lookUpOpacity(float u)
{
  int last = textureSize(alphaTable) - 1;
  float place = clamp(u / alphaTableEnd, 0.0, 1.0) * float(last);
  int i = min(int(place), last - 1);
  return mix(element(alphaTable, i).r, element(alphaTable, i + 1).r, place - float(i));
}
