// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The piecewise-linear transfer functions of TransferFunctionTable, and the integral of a segment over them.
// A sample has two scalars: x is read by the colour function (and by the opacity function, unless opacity comes from an
// array of its own), y by the opacity function of that array. Constants: separateOpacity, splitAtControlPoints.
uniform samplerBuffer transferNodes;     // node positions, ascending
uniform samplerBuffer transferIntervals; // two texels per interval: colour and opacity at its low and high end
uniform samplerBuffer opacityNodes;
uniform samplerBuffer opacityIntervals;
uniform int numberOfTransferNodes;
uniform int numberOfOpacityNodes;

// Number of nodes at or below s, which is the interval that contains s.
int findInterval(samplerBuffer nodes, int count, float s)
{
  int low = 0;
  int high = count;
  while (low < high)
  {
    int middle = (low + high) / 2;
    if (texelFetch(nodes, middle).r <= s)
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

vec4 evaluateInInterval(samplerBuffer nodes, samplerBuffer intervals, int count, int interval, float s)
{
  vec4 atLow = texelFetch(intervals, 2 * interval);
  if (interval == 0 || interval == count)
  {
    return atLow;
  }
  float low = texelFetch(nodes, interval - 1).r;
  float high = texelFetch(nodes, interval).r;
  float t = high > low ? clamp((s - low) / (high - low), 0.0, 1.0) : 0.0;
  return mix(atLow, texelFetch(intervals, 2 * interval + 1), t);
}

// Colour and opacity of a sample that lies in the given intervals of the two functions.
vec4 evaluate(ivec2 interval, vec2 s)
{
  vec4 value =
    evaluateInInterval(transferNodes, transferIntervals, numberOfTransferNodes, interval.x, s.x);
  if (separateOpacity)
  {
    value.a =
      evaluateInInterval(opacityNodes, opacityIntervals, numberOfOpacityNodes, interval.y, s.y).a;
  }
  return value;
}

ivec2 findIntervals(vec2 s)
{
  return ivec2(findInterval(transferNodes, numberOfTransferNodes, s.x),
    separateOpacity ? findInterval(opacityNodes, numberOfOpacityNodes, s.y) : 0);
}

// Where along the segment, in [0, 1], the scalar leaves this interval on its way to the last one.
float leaveInterval(samplerBuffer nodes, int interval, int last, float front, float back)
{
  if (interval == last)
  {
    return 1.0;
  }
  float node = texelFetch(nodes, last > interval ? interval : interval - 1).r;
  return clamp((node - front) / (back - front), 0.0, 1.0);
}

// Segment over which colour and opacity are linear; opticalScale is its length times the extinction at opacity 1.
vec4 integrateLinear(vec4 front, vec4 back, float opticalScale)
{
  vec2 weights = segmentWeights(front.a * opticalScale, back.a * opticalScale);
  return vec4(weights.x * front.rgb + weights.y * back.rgb, weights.x + weights.y);
}

// Segment over which the scalars are linear: cut wherever one of them crosses a node, and composited front to back.
vec4 integrateSegment(vec2 front, vec2 back, float opticalScale)
{
  ivec2 interval = findIntervals(front);
  ivec2 last = findIntervals(back);
  if (!splitAtControlPoints || interval == last)
  {
    return integrateLinear(evaluate(interval, front), evaluate(last, back), opticalScale);
  }
  ivec2 direction = ivec2(sign(last - interval));
  vec4 result = vec4(0.0);
  float from = 0.0;
  while (result.a < 0.9999999)
  {
    vec2 leave = vec2(leaveInterval(transferNodes, interval.x, last.x, front.x, back.x),
      separateOpacity ? leaveInterval(opacityNodes, interval.y, last.y, front.y, back.y) : 1.0);
    bool atEnd = interval == last;
    float to = atEnd ? 1.0 : max(from, min(leave.x, leave.y));
    vec4 piece = integrateLinear(evaluate(interval, mix(front, back, from)),
      evaluate(interval, mix(front, back, to)), (to - from) * opticalScale);
    result += (1.0 - result.a) * piece;
    if (atEnd)
    {
      break;
    }
    // One step at a time; a function that has arrived no longer steps.
    bool stepColor = interval.x != last.x && (leave.x <= leave.y || interval.y == last.y);
    interval += stepColor ? ivec2(direction.x, 0) : ivec2(0, direction.y);
    from = to;
  }
  return result;
}
