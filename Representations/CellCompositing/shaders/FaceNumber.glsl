// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Numbers of boundary faces as floats, for textures. Floats hold every integer up to 2^24. Larger numbers are cut in two: the lower 23 bits
// below a leading one, and the rest as a power of two. The floats are in the order of the numbers.
const int faceUnit = 8388608; // 2^23

float floatOfFace(int face)
{
  int above = face / faceUnit;
  return above == 0 ? float(face) : float(faceUnit + face % faceUnit) * float(1 << (above - 1));
}

// Negative ones stay as they are.
int faceOfFloat(float number)
{
  int above = 0;
  while (number >= float(2 * faceUnit))
  {
    number *= 0.5;
    ++above;
  }
  return above * faceUnit + int(number);
}
