// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Integrates the cells that most rays cross: few pieces of a cubic field (CubicPieces.glsl), thin, between two nodes of the transfer function.

// A piece along which colour and opacity are linear, and which is thin.
void addLinear(vec4 front, vec4 back, vec2 ways)
{
  vec2 tau = vec2(front.a, back.a) * ((ways.y - ways.x) * opticalLength);
  vec2 weights = averageIntegration ? averageSegmentWeights(tau.x, tau.y) : thinSegmentWeights(tau.x, tau.y);
  vec4 added = (1.0 - light.a) * vec4(weights.x * front.rgb + weights.y * back.rgb, weights.x + weights.y);
  light += hazedThin(added, ways, 0.5 * (tau.x + tau.y));
}

// The opacity from a scalar of its own upwards: as far as it is linear, its value, and its slope.
vec3 opacityFrom(float s)
{
#ifdef SMALL_OPACITY_TABLE
  OpacityInterval interval = opacityIntervalFrom(s, true);
  float slope = (interval.values.y - interval.values.x) / (interval.high - interval.low);
  return vec3(interval.high, interval.values.x + (s - interval.low) * slope, slope);
#else
  int number = findInterval(opacityNodes, opacityTable, s);
  float value = evaluateOpacity(number, s);
  if (number == opacityTable.y)
  {
    return vec3(3.0e38, value, 0.0);
  }
  float high = element(opacityNodes, opacityTable.x + number).r;
  float atHigh = element(opacityIntervals, 2 * (opacityTable.z + number) + 1).a;
  return vec3(high, value, number == 0 ? 0.0 : (atHigh - value) / (high - s));
#endif
}

// Adds the pieces if that is simple: no node of the transfer function lies between their scalars, and they are thin. Software computes
// both sides of every test, so that what is seldom needed is done apart. False: nothing was added.
bool addThinPieces(bool mustWait)
{
  float lowest = lowestOf(scalars);
  float highest = -lowestOf(-scalars);
#ifdef SMALL_TABLE
  int number = 0;
#else
  int number = findInterval(transferNodes, transferTable, lowest);
#endif
  Interval interval = intervalFrom(lowest, true, number);
  vec4 slope = (interval.valueHigh - interval.valueLow) / interval.width;
  vec4 values[4];
  for (int i = 0; i < 4; ++i)
  {
    values[i] = interval.valueLow + (scalars[i] - interval.low) * slope;
  }
  bool opacityIsLinear = true;
  if (separateOpacity)
  {
    float lowestOpacity = lowestOf(opacityScalarsHere);
    vec3 from = opacityFrom(lowestOpacity);
    opacityIsLinear = -lowestOf(-opacityScalarsHere) <= from.x;
    for (int i = 0; i < 4; ++i)
    {
      values[i].a = from.y + (opacityScalarsHere[i] - lowestOpacity) * from.z;
    }
  }
  float opacity = max(max(values[0].a, values[1].a), max(values[2].a, values[3].a));
  bool isThin = averageIntegration || opacity * opticalLength * (places.w - places.x) <= 1.0;
  closeSlices(light, places.x);
  bool fits = !mustWait && endsInSlice(places.w) && numberOfPieces <= 3.0 && splitAtControlPoints && highest <= interval.high && opacityIsLinear && isThin;
  if (fits)
  {
    addLinear(values[0], values[1], places.xy);
    addLinear(values[1], values[2], places.yz);
    addLinear(values[2], values[3], places.zw);
  }
  return fits;
}
