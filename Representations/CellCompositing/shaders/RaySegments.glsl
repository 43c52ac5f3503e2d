// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Segments of one ray, front to back.
// Constants: splitAtControlPoints, separateOpacity. SMALL_TABLE, where it is defined, is the number of nodes of the transfer function, at
// most 8, which are then uniforms: a fetch per pixel and segment costs more than looking at all of them. Written out rather than as
// loops, which compilers leave as they are and fetch from.
#ifdef SMALL_TABLE
uniform float smallNodes[SMALL_TABLE];
uniform vec4 smallLow[SMALL_TABLE + 1];  // colour and opacity at the ends of each interval
uniform vec4 smallHigh[SMALL_TABLE + 1];
float nodes[9]; // copies
vec4 low[9];
vec4 high[9];

#define KEEP_INTERVAL(k) low[k] = smallLow[k] * unity; high[k] = smallHigh[k] * unity;
#define KEEP_NODE(k) nodes[k] = smallNodes[k] * unity; nodes[k + 1] = 3.0e38; KEEP_INTERVAL(k + 1)
#define PASS_NODE(k) if (up ? s >= nodes[k] : s > nodes[k]) { result = Interval(nodes[k], nodes[k + 1], nodes[k + 1] - nodes[k], low[k + 1], high[k + 1]); }

#if SMALL_TABLE > 1
#define NODE_1(DO) DO(1)
#else
#define NODE_1(DO)
#endif
#if SMALL_TABLE > 2
#define NODE_2(DO) DO(2)
#else
#define NODE_2(DO)
#endif
#if SMALL_TABLE > 3
#define NODE_3(DO) DO(3)
#else
#define NODE_3(DO)
#endif
#if SMALL_TABLE > 4
#define NODE_4(DO) DO(4)
#else
#define NODE_4(DO)
#endif
#if SMALL_TABLE > 5
#define NODE_5(DO) DO(5)
#else
#define NODE_5(DO)
#endif
#if SMALL_TABLE > 6
#define NODE_6(DO) DO(6)
#else
#define NODE_6(DO)
#endif
#if SMALL_TABLE > 7
#define NODE_7(DO) DO(7)
#else
#define NODE_7(DO)
#endif
#define EACH_NODE(DO) DO(0) NODE_1(DO) NODE_2(DO) NODE_3(DO) NODE_4(DO) NODE_5(DO) NODE_6(DO) NODE_7(DO)
#endif

void keepTable()
{
#ifdef SMALL_TABLE
  KEEP_INTERVAL(0)
  EACH_NODE(KEEP_NODE)
#endif
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
}

bool isOpaque()
{
  return light.a > 0.9999999;
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

void addSegment(vec2 front, vec2 back, float distance)
{
  float depth = distance * opticalLength;
  if (splitAtControlPoints && !separateOpacity)
  {
    addAlongOneScalar(front.x, back.x, depth);
  }
  else
  {
    light += (1.0 - light.a) * integrateSegment(front, back, depth);
  }
}
