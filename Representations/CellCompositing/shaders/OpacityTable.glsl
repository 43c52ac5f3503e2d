// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// 1 - exp(-u) from a table over [0, alphaTableEnd], read with linear interpolation (OpacityTable.h).
uniform FloatArray alphaTable;
uniform float alphaTableEnd;
uniform int alphaTableLast; // index of the last entry; arrays that are 2-D textures do not know it

float lookUpOpacity(float u)
{
  float place = clamp(u / alphaTableEnd, 0.0, 1.0) * float(alphaTableLast);
  int i = min(int(place), alphaTableLast - 1);
  return mix(element(alphaTable, i).r, element(alphaTable, i + 1).r, place - float(i));
}
