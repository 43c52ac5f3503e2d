// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The piecewise-linear transfer functions of TransferFunctionTable, and the integral of a segment over them.
// A sample has two scalars: x is read by the colour function (and by the opacity function, unless opacity comes from an
// array of its own), y by the opacity function of that array. Constants: separateOpacity, splitAtControlPoints, useLayers.
// With layers the buffers hold the tables of all layers one after the other, and selectLayer chooses the ones in force.
uniform FloatArray transferNodes;     // position, ascending; width of the interval above it, which is more exact than a difference
uniform FloatArray transferIntervals; // two texels per interval: colour and opacity at its low and high end
uniform FloatArray opacityNodes;
uniform FloatArray opacityIntervals;
// Two texels per layer: first node and number of nodes of the colour, then of the opacity table; (scalars between which nothing is seen, 0, 0)
uniform FloatArray layerTables;
uniform int numberOfTransferNodes;
uniform int numberOfOpacityNodes;

// First node, number of nodes, first interval.
ivec3 transferTable = ivec3(0, numberOfTransferNodes, 0);
ivec3 opacityTable = ivec3(0, numberOfOpacityNodes, 0);

void selectLayer(int layer)
{
  ivec4 tables = ivec4(element(layerTables, 2 * layer));
  // A table has one interval more than nodes.
  transferTable = ivec3(tables.xy, tables.x + layer);
  opacityTable = ivec3(tables.zw, tables.z + layer);
}

// Number of nodes at or below s, which is the interval that contains s.
int findInterval(FloatArray nodes, ivec3 table, float s)
{
  int low = 0;
  int high = table.y;
  while (low < high)
  {
    int middle = (low + high) / 2;
    if (element(nodes, table.x + middle).r <= s)
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

vec4 evaluateInInterval(FloatArray nodes, FloatArray intervals, ivec3 table, int interval, float s)
{
  int texel = 2 * (table.z + interval);
  vec4 atLow = element(intervals, texel);
  if (interval == 0 || interval == table.y)
  {
    return atLow;
  }
  vec2 node = element(nodes, table.x + interval - 1).rg;
  float t = node.y > 0.0 ? clamp((s - node.x) / node.y, 0.0, 1.0) : 0.0;
  return mix(atLow, element(intervals, texel + 1), t);
}

vec4 evaluateColor(int interval, float s)
{
  return evaluateInInterval(transferNodes, transferIntervals, transferTable, interval, s);
}

float evaluateOpacity(int interval, float s)
{
  return evaluateInInterval(opacityNodes, opacityIntervals, opacityTable, interval, s).a;
}

// Colour and opacity of a sample that lies in the given intervals of the two functions.
vec4 evaluate(ivec2 interval, vec2 s)
{
  vec4 value = evaluateColor(interval.x, s.x);
  if (separateOpacity)
  {
    value.a = evaluateOpacity(interval.y, s.y);
  }
  return value;
}

ivec2 findIntervals(vec2 s)
{
  return ivec2(findInterval(transferNodes, transferTable, s.x),
    separateOpacity ? findInterval(opacityNodes, opacityTable, s.y) : 0);
}

// Where along the segment the scalar leaves this interval on its way to the last one; beyond the end if it is there.
float leaveInterval(FloatArray nodes, ivec3 table, int interval, int last, float front, float back)
{
  if (interval == last)
  {
    return 2.0;
  }
  float node = element(nodes, table.x + (last > interval ? interval : interval - 1)).r;
  return clamp((node - front) / (back - front), 0.0, 1.0);
}

// Length of a segment's piece that spans a whole interval, as a fraction.
float crossingLength(FloatArray nodes, ivec3 table, int interval, float front, float back)
{
  return element(nodes, table.x + interval - 1).g / abs(back - front);
}

// Colour and opacity where a node of one function is reached: its limit from inside the interval; the other function's value.
vec4 limit(bool ofColor, ivec2 interval, bool high, vec2 s)
{
  int end = high ? 1 : 0;
  if (!separateOpacity)
  {
    return element(transferIntervals, 2 * (transferTable.z + interval.x) + end);
  }
  if (ofColor)
  {
    return vec4(element(transferIntervals, 2 * (transferTable.z + interval.x) + end).rgb, evaluateOpacity(interval.y, s.y));
  }
  return vec4(evaluateColor(interval.x, s.x).rgb, element(opacityIntervals, 2 * (opacityTable.z + interval.y) + end).a);
}

// Segment over which colour and opacity are linear; opticalScale is its length times the extinction at opacity 1.
vec4 integrateLinear(vec4 front, vec4 back, float opticalScale)
{
  vec2 weights = segmentWeights(front.a * opticalScale, back.a * opticalScale);
  return vec4(weights.x * front.rgb + weights.y * back.rgb, weights.x + weights.y);
}

// Segment over which the scalars are linear: cut wherever one of them crosses a node, and composited front to back. A spike of
// the function may be narrower than two neighbouring floats: its length is that of its interval, not a difference of places, and
// its ends have the values of the table.
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
  vec4 start = evaluate(interval, front);
  float from = 0.0;
  bool startsAtColor = false, startsAtOpacity = false; // the function whose node was crossed last
  while (result.a < 0.9999999) // with one place that integrates: lanes that are at different pieces share it
  {
    bool atEnd = interval == last;
    vec2 leave = vec2(leaveInterval(transferNodes, transferTable, interval.x, last.x, front.x, back.x),
      separateOpacity ? leaveInterval(opacityNodes, opacityTable, interval.y, last.y, front.y, back.y) : 2.0);
    bool ofColor = leave.x <= leave.y;
    bool rising = (ofColor ? direction.x : direction.y) > 0;
    float to = atEnd ? 1.0 : max(from, min(leave.x, leave.y));
    vec2 s = mix(front, back, to);
    float length = to - from;
    vec4 end;
    if (atEnd)
    {
      end = evaluate(last, back);
    }
    else
    {
      end = limit(ofColor, interval, rising, s);
      if (ofColor && startsAtColor)
      {
        length = crossingLength(transferNodes, transferTable, interval.x, front.x, back.x);
      }
      else if (!ofColor && startsAtOpacity)
      {
        length = crossingLength(opacityNodes, opacityTable, interval.y, front.y, back.y);
      }
    }
    result += (1.0 - result.a) * integrateLinear(start, end, length * opticalScale);
    if (atEnd)
    {
      break;
    }
    interval += ofColor ? ivec2(direction.x, 0) : ivec2(0, direction.y);
    start = limit(ofColor, interval, !rising, s);
    startsAtColor = ofColor;
    startsAtOpacity = !ofColor;
    from = to;
  }
  return result;
}
