// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The cells of a structured grid, of which a walk is in one.
// Constants: closedGrid (along the first axis).
uniform int gridStride[3]; // from a point to the next along each axis
uniform vec3 boxLow;       // of the cells that can be seen: first and
uniform vec3 boxHigh;      // last cell, inclusive
uniform int wrapCells;     // around the closed axis

// Copies (see keepUniforms).
ivec2 rowStride; // to the next point along the second and third axis
ivec2 cellRows;  // cells along the first and second axis
vec3 lowest, highest;
int wrap;

vec3 cellOf = vec3(0.0); // where the walk is

void keepTopology()
{
  rowStride = ivec2(gridStride[1], gridStride[2]) * int(unity);
  cellRows = ivec2(gridStride[1] - 1, gridStride[2] / gridStride[1] - 1) * int(unity);
  lowest = boxLow * unity;
  highest = boxHigh * unity;
  wrap = wrapCells * int(unity);
}

int cellNumber()
{
  ivec3 c = ivec3(cellOf);
  return c.x + cellRows.x * (c.y + cellRows.y * c.z);
}

vec3 pointIndex(int point)
{
  int row = point / gridStride[1];
  int rows = gridStride[2] / gridStride[1];
  return vec3(point - row * gridStride[1], row % rows, row / rows);
}

// Goes to the next cell along the axis in which a point number changes by `step`.
void stepCell(int step)
{
  int distance = abs(step);
  cellOf += (step > 0 ? 1.0 : -1.0) * vec3(distance == 1, distance == rowStride.x, distance == rowStride.y);
}

// At an end of a closed grid, goes to the same place as it is numbered at the other end; returns by how much point numbers change.
int jumpAround()
{
  int jump = cellOf.x < 0.0 ? wrap : cellOf.x == float(wrap) ? -wrap : 0;
  cellOf.x += float(jump);
  return jump;
}

bool mayBeSeen()
{
  return all(greaterThanEqual(cellOf, lowest)) && all(lessThanEqual(cellOf, highest));
}
