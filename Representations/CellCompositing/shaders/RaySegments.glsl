// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Segments of one ray, front to back.
// Constants: splitAtControlPoints, separateOpacity. SMALL_TABLE, where it is defined, is the number of nodes of the transfer function,
// SMALL_OPACITY_TABLE of that of a separate opacity; few nodes are uniforms: a fetch per pixel and segment costs more than looking at all of
// them: SMALL_TABLES is defined if all are. EACH_NODE and EACH_OPACITY_NODE write that out: compilers leave loops as they are and fetch from what they index.
#ifdef SMALL_TABLE
uniform float smallNodes[SMALL_TABLE];
uniform vec4 smallLow[SMALL_TABLE + 1];  // colour and opacity at the ends of each interval
uniform vec4 smallHigh[SMALL_TABLE + 1];
float nodes[SMALL_TABLE + 1]; // copies
vec4 low[SMALL_TABLE + 1];
vec4 high[SMALL_TABLE + 1];

#define KEEP_INTERVAL(k) low[k] = smallLow[k] * unity; high[k] = smallHigh[k] * unity;
#define KEEP_NODE(k) nodes[k] = smallNodes[k] * unity; nodes[k + 1] = 3.0e38; KEEP_INTERVAL(k + 1)
#define PASS_NODE(k) if (up ? s >= nodes[k] : s > nodes[k]) { result = Interval(nodes[k], nodes[k + 1], nodes[k + 1] - nodes[k], low[k + 1], high[k + 1]); }
#endif
#ifdef SMALL_OPACITY_TABLE
uniform float smallOpacityNodes[SMALL_OPACITY_TABLE];
uniform vec2 smallOpacities[SMALL_OPACITY_TABLE + 1]; // at the low and high end of each interval
float opacityNodesKept[SMALL_OPACITY_TABLE + 1];
vec2 opacities[SMALL_OPACITY_TABLE + 1];

#define KEEP_OPACITY_NODE(k) opacityNodesKept[k] = smallOpacityNodes[k] * unity; opacityNodesKept[k + 1] = 3.0e38; opacities[k + 1] = smallOpacities[k + 1] * unity;
#define PASS_OPACITY_NODE(k) if (up ? s >= opacityNodesKept[k] : s > opacityNodesKept[k]) { result = OpacityInterval(opacityNodesKept[k], opacityNodesKept[k + 1], opacities[k + 1]); }
#endif

void keepTable()
{
#ifdef SMALL_TABLE
  KEEP_INTERVAL(0)
  EACH_NODE(KEEP_NODE)
#endif
#ifdef SMALL_OPACITY_TABLE
  opacities[0] = smallOpacities[0] * unity;
  EACH_OPACITY_NODE(KEEP_OPACITY_NODE)
#endif
}

// min and max without their care for NaN, which software pays for.
float lesser(float a, float b)
{
  return a < b ? a : b;
}
float greater(float a, float b)
{
  return a > b ? a : b;
}

vec4 light;
float opticalLength; // extinction at opacity 1, per length of the ray

struct Interval
{
  float low, high; // scalars between which it reaches
  float width;     // more exact than their difference
  vec4 valueLow, valueHigh;
};

// The interval into which the scalar goes on, up or down, from s; `number` is kept by those who fetch. A node belongs to the interval
// above it.
Interval intervalFrom(float s, bool up, int number)
{
#ifdef SMALL_TABLE
  Interval result = Interval(-3.0e38, nodes[0], 3.0e38, low[0], high[0]);
  EACH_NODE(PASS_NODE)
  return result;
#else
  bool below = number == 0;
  bool above = number == transferTable.y;
  int node = transferTable.x + number; // the one above
  int texel = 2 * (transferTable.z + number);
  return Interval(below ? -3.0e38 : element(transferNodes, node - 1).r, above ? 3.0e38 : element(transferNodes, node).r,
    below || above ? 3.0e38 : element(transferNodes, node - 1).g, element(transferIntervals, texel),
    element(transferIntervals, texel + 1));
#endif
}

vec4 valueAt(Interval interval, float s)
{
  float t = (s - interval.low) / interval.width;
  return mix(interval.valueLow, interval.valueHigh, clamp(t, 0.0, 1.0));
}

void startSegments(float opticalScale)
{
  light = vec4(0.0);
  opticalLength = opticalScale;
  startSlices();
}

// Fraction of the segment after which a scalar leaves its interval at this end; 2 if it does not.
float leaveAt(float end, bool up, float front, float back)
{
  bool leaves = up ? end < back : end > back;
  return leaves ? clamp((end - front) / (back - front), 0.0, 1.0) : 2.0;
}

// What is behind adds less than 0.003/255.
bool isOpaque()
{
  return transparencyOf(light) < 1.0e-5;
}

vec4 accumulatedLight()
{
  return light;
}

// The scalar goes linearly from `front` to `back` over an optical length: cut wherever it crosses a node. A spike of the function may
// be narrower than two neighbouring floats: intervals that are fetched are counted, and have their widths from the table.
void addAlongOneScalar(float front, float back, float depth)
{
  bool up = back >= front;
  float perScalar = depth / abs(back - front);
  float from = front;
  int number = 0, last = 0;
  int numberOfNodes = numberOfTransferNodes;
#ifndef SMALL_TABLE
  numberOfNodes = transferTable.y;
  number = findInterval(transferNodes, transferTable, front);
  last = findInterval(transferNodes, transferTable, back);
#endif
  for (int i = 0; i <= numberOfNodes; ++i)
  {
    Interval interval = intervalFrom(from, up, number);
    float to = up ? min(back, interval.high) : max(back, interval.low);
#ifdef SMALL_TABLE
    bool atEnd = to == back;
#else
    bool atEnd = number == last;
    to = atEnd ? back : up ? interval.high : interval.low;
#endif
    bool whole = i > 0 && !atEnd;
    float part = i == 0 && atEnd ? depth : (whole ? interval.width : abs(to - from)) * perScalar;
    vec4 start = i == 0 ? valueAt(interval, from) : up ? interval.valueLow : interval.valueHigh;
    vec4 end = atEnd ? valueAt(interval, to) : up ? interval.valueHigh : interval.valueLow;
    light += (1.0 - light.a) * integrateLinear(start, end, part);
    if (atEnd)
    {
      break;
    }
    from = to;
    number += up ? 1 : -1;
  }
}

#ifdef SMALL_OPACITY_TABLE
struct OpacityInterval
{
  float low, high;
  vec2 values;
};

OpacityInterval opacityIntervalFrom(float s, bool up)
{
  OpacityInterval result = OpacityInterval(-3.0e38, opacityNodesKept[0], opacities[0]);
  EACH_OPACITY_NODE(PASS_OPACITY_NODE)
  return result;
}

float opacityAt(OpacityInterval interval, float s)
{
  float t = (s - interval.low) / (interval.high - interval.low);
  return mix(interval.values.x, interval.values.y, clamp(t, 0.0, 1.0));
}

#endif

// The scalars of colour and opacity go linearly from `front` to `back`. A part begins where they are `s`, and ends at the next node.
#ifdef SMALL_TABLES
struct LinearPart
{
  float to;        // fraction of the way from `front` to `back`
  bool atEnd;      // there
  vec2 scalars;    // there
  vec4 start, end; // colour and opacity at the ends
};

LinearPart partFrom(vec2 s, vec2 front, vec2 back)
{
  bool upX = back.x >= front.x;
  Interval color = intervalFrom(s.x, upX, 0);
  vec2 ends = vec2(upX ? color.high : color.low);
  vec2 leave = vec2(leaveAt(ends.x, upX, front.x, back.x), 2.0);
#ifdef SMALL_OPACITY_TABLE
  bool upY = back.y >= front.y;
  OpacityInterval opacity = opacityIntervalFrom(s.y, upY);
  ends.y = upY ? opacity.high : opacity.low;
  leave.y = leaveAt(ends.y, upY, front.y, back.y);
#endif
  float to = lesser(leave.x, leave.y);
  bool atEnd = to > 1.0;
  to = lesser(to, 1.0);
  vec2 next = atEnd ? back : mix(front, back, to);
  next = atEnd ? next : leave.x <= leave.y ? vec2(ends.x, next.y) : vec2(next.x, ends.y);
  // Rounding must not lead back across a node: two nodes at one place would be crossed by turns.
  next.x = upX ? greater(next.x, s.x) : lesser(next.x, s.x);
#ifdef SMALL_OPACITY_TABLE
  next.y = upY ? greater(next.y, s.y) : lesser(next.y, s.y);
#endif
  vec4 start = valueAt(color, s.x), end = valueAt(color, next.x);
#ifdef SMALL_OPACITY_TABLE
  start.a = opacityAt(opacity, s.y);
  end.a = opacityAt(opacity, next.y);
#endif
  return LinearPart(to, atEnd, next, start, end);
}
#endif

#ifdef SMALL_OPACITY_TABLE
// Over an optical length: cut wherever either scalar crosses a node.
void addAlongTwoScalars(vec2 front, vec2 back, float depth)
{
  vec2 s = front;
  float from = 0.0;
  for (int i = 0; i <= numberOfTransferNodes + numberOfOpacityNodes; ++i)
  {
    LinearPart part = partFrom(s, front, back);
    float to = greater(from, part.to);
    light += (1.0 - light.a) * integrateLinear(part.start, part.end, (to - from) * depth);
    if (part.atEnd)
    {
      break;
    }
    s = part.scalars;
    from = to;
  }
}
#endif

void addSegment(vec2 front, vec2 back, float distance)
{
  float depth = distance * opticalLength;
#ifdef SMALL_OPACITY_TABLE
  if (splitAtControlPoints)
  {
    addAlongTwoScalars(front, back, depth);
    return;
  }
#endif
  if (splitAtControlPoints && !separateOpacity)
  {
    addAlongOneScalar(front.x, back.x, depth);
  }
  else
  {
    light += (1.0 - light.a) * integrateSegment(front, back, depth);
  }
}
