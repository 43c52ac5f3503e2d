// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The piecewise-linear transfer function of TransferFunctionTable, and the integral of a segment over it.
uniform samplerBuffer transferNodes;     // node positions, ascending
uniform samplerBuffer transferIntervals; // two texels per interval: colour and opacity at its low and high end
uniform int numberOfTransferNodes;
uniform bool splitAtControlPoints;

// Number of nodes at or below s, which is the interval that contains s.
int findInterval(float s)
{
  int low = 0;
  int high = numberOfTransferNodes;
  while (low < high)
  {
    int middle = (low + high) / 2;
    if (texelFetch(transferNodes, middle).r <= s)
    {
      low = middle + 1;
    }
    else
    {
      high = middle;
    }
  }
  return low;
}

vec4 evaluateInInterval(int interval, float s)
{
  vec4 atLow = texelFetch(transferIntervals, 2 * interval);
  if (interval == 0 || interval == numberOfTransferNodes)
  {
    return atLow;
  }
  float low = texelFetch(transferNodes, interval - 1).r;
  float high = texelFetch(transferNodes, interval).r;
  float t = high > low ? clamp((s - low) / (high - low), 0.0, 1.0) : 0.0;
  return mix(atLow, texelFetch(transferIntervals, 2 * interval + 1), t);
}

// Segment over which colour and opacity are linear; opticalScale is its length times the extinction at opacity 1.
vec4 integrateLinear(vec4 front, vec4 back, float opticalScale)
{
  vec2 weights = segmentWeights(front.a * opticalScale, back.a * opticalScale);
  return vec4(weights.x * front.rgb + weights.y * back.rgb, weights.x + weights.y);
}

// Segment over which the scalar is linear: cut wherever the scalar crosses a node, and composited front to back.
vec4 integrateSegment(float scalarFront, float scalarBack, float opticalScale)
{
  int interval = findInterval(scalarFront);
  int last = findInterval(scalarBack);
  if (!splitAtControlPoints || interval == last)
  {
    return integrateLinear(evaluateInInterval(interval, scalarFront), evaluateInInterval(last, scalarBack), opticalScale);
  }
  int direction = last > interval ? 1 : -1;
  float scale = opticalScale / (scalarBack - scalarFront); // optical scale per unit of scalar; its sign cancels
  float from = scalarFront;
  vec4 result = vec4(0.0);
  while (result.a < 0.9999999)
  {
    float to = interval == last ? scalarBack : texelFetch(transferNodes, direction > 0 ? interval : interval - 1).r;
    vec4 piece = integrateLinear(
      evaluateInInterval(interval, from), evaluateInInterval(interval, to), max(0.0, (to - from) * scale));
    result += (1.0 - result.a) * piece;
    if (interval == last)
    {
      break;
    }
    interval += direction;
    from = to;
  }
  return result;
}
