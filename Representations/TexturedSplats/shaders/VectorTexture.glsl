// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// What is drawn on a vector splat (VectorTexture.h); Testing/VectorTextureValues.h explains each function.

// Lengths as they are seen, in one unit.
struct StreakShape
{
  float period;
  float tail;
  float width;
  float spacing;
  float pixel;
};

float blurred(float width, StreakShape shape)
{
  return length(vec2(width, 0.4 * shape.pixel));
}

float comet(StreakShape shape, float behind, float across)
{
  float t = clamp(behind / shape.tail, 0.0, 1.0);
  float width = shape.width * (1.0 - (1.0 - STREAK_TAIL_END) * t);
  float wide = blurred(width, shape);
  float ahead = min(behind, 0.0);
  return (1.0 - t) * width / wide * exp(-0.5 * (across * across + ahead * ahead) / (wide * wide));
}

float meanStreak(StreakShape shape)
{
  float tail = 2.5066282746 * shape.width * shape.tail * (0.5 - (1.0 - STREAK_TAIL_END) / 6.0);
  float head = 3.1415926536 * shape.width * shape.width;
  return min(1.0, (tail + head) / (shape.period * shape.spacing));
}

float streakRow(StreakShape shape, float place, float row, float x, float phase)
{
  float lead = min(0.5, STREAK_NOSE * blurred(shape.width, shape) / shape.period);
  float behind = fract(phase + STREAK_GOLDEN * row - x / shape.period + lead) - lead;
  return comet(shape, behind * shape.period, (place - row) * shape.spacing);
}

float streakRows(StreakShape shape, vec2 at, float phase, float firstRow)
{
  float place = at.y / shape.spacing + firstRow;
  float nearest = floor(place + 0.5);
  float next = nearest + (place < nearest ? -1.0 : 1.0);
  return min(1.0, streakRow(shape, place, nearest, at.x, phase) + streakRow(shape, place, next, at.x, phase));
}

float roundDot(StreakShape shape, vec2 at)
{
  float width = STREAK_ROUND_DOT * shape.width;
  float wide = blurred(width, shape);
  return width * width / (wide * wide) * exp(-0.5 * dot(at, at) / (wide * wide));
}

float streakTexture(StreakShape shape, vec2 at, float phase, float firstRow)
{
  float streaked = smoothstep(STREAK_STEEP, STREAK_FLAT, shape.period / shape.width);
  float pattern = mix(roundDot(shape, at), streakRows(shape, at, phase, firstRow), streaked);
  float resolved = smoothstep(STREAK_COARSE, STREAK_FINE, min(max(shape.period, shape.width), shape.spacing) / shape.pixel);
  return mix(meanStreak(shape), pattern, resolved);
}

// AbramowitzStegun1964, 7.1.26.
vec4 errorFunction(vec4 x)
{
  vec4 t = 1.0 / (1.0 + 0.3275911 * abs(x));
  vec4 sum = t * (0.254829592 + t * (-0.284496736 + t * (1.421413741 + t * (-1.453152027 + t * 1.061405429))));
  return sign(x) * (1.0 - sum * exp(-x * x));
}

// Share of a pixel that a segment along x covers; all in pixels.
float segmentCoverage(vec2 at, float segmentLength, float width)
{
  vec4 e = errorFunction((at.xxyy + 0.5 * vec4(segmentLength, -segmentLength, width, -width)) * (0.70710678 / SEGMENT_FILTER));
  return 0.25 * (e.x - e.y) * (e.z - e.w);
}
