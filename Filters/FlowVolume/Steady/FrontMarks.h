// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Which edges of a front are to be halved before it moves on. Plain C++17.
#ifndef nephoscope_FrontMarks_h
#define nephoscope_FrontMarks_h

#include "SmokeFront.h"
#include "SmokeGeometry.h"

namespace nephoscope
{
struct EdgeLimits
{
  double Longest = 0.0;  // before the step and after it; 0: any
  double Shortest = 0.0; // shorter edges stay whole, however long the flow makes them
  double Obstacle = 0.0; // longest edge of a triangle that is partly outside the field; 0: any
};

// Only the two ends of an edge decide whether it is too long, so both adjacent triangles agree.
inline void MarkLongEdges(const SmokeFront& front, const std::vector<Vector3>& above,
  const std::vector<unsigned char>& inside, const EdgeLimits& limits,
  std::vector<unsigned char>& marks)
{
  for (std::size_t e = 0; limits.Longest > 0.0 && e < front.Edges.Size(); ++e)
  {
    const auto a = static_cast<std::size_t>(front.Edges.Points[e][0]);
    const auto b = static_cast<std::size_t>(front.Edges.Points[e][1]);
    const double below = Distance(front.Positions[a], front.Positions[b]);
    const double later = inside[a] && inside[b] ? Distance(above[a], above[b]) : 0.0;
    marks[e] = below > limits.Shortest && std::max(below, later) > limits.Longest;
  }
}

// Halves all edges of a triangle that are longer than the limit. Returns whether there are any.
inline bool MarkTriangle(
  const SmokeFront& front, std::size_t t, double longest, std::vector<unsigned char>& marks)
{
  bool any = false;
  for (std::size_t e : front.Edges.Of[t])
  {
    const auto a = static_cast<std::size_t>(front.Edges.Points[e][0]);
    const auto b = static_cast<std::size_t>(front.Edges.Points[e][1]);
    const bool mark = longest > 0.0 && Distance(front.Positions[a], front.Positions[b]) > longest;
    marks[e] |= mark;
    any |= mark;
  }
  return any;
}

// Triangles that meet an obstacle, with a corner or between (`blocked`), are
// divided on all sides, so that what ends fits it closely.
inline void MarkObstacleEdges(const SmokeFront& front, const std::vector<unsigned char>& inside,
  const std::vector<unsigned char>& blocked, const EdgeLimits& limits,
  std::vector<unsigned char>& marks)
{
  for (std::size_t t = 0; t < front.Triangles.size(); ++t)
  {
    int corners = 0;
    for (PointId point : front.Triangles[t].Points)
    {
      corners += inside[static_cast<std::size_t>(point)];
    }
    if (corners % 3 != 0 || (corners == 3 && blocked[t]))
    {
      MarkTriangle(front, t, limits.Obstacle, marks);
    }
  }
}

// Returns the number of marks, one for each edge.
inline std::size_t MarkEdges(const SmokeFront& front, const std::vector<Vector3>& above,
  const std::vector<unsigned char>& inside, const std::vector<unsigned char>& blocked,
  const EdgeLimits& limits, std::vector<unsigned char>& marks)
{
  marks.assign(front.Edges.Size(), 0);
  MarkLongEdges(front, above, inside, limits, marks);
  MarkObstacleEdges(front, inside, blocked, limits, marks);
  return static_cast<std::size_t>(std::count(marks.begin(), marks.end(), 1));
}
}

#endif
