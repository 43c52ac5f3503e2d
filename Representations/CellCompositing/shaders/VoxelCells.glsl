// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The cells of an evenly spaced grid along a ray, in numbers of points along each axis.
//
// A cell consists of the tetrahedron of its four even vertices and of one at each odd vertex (ChessboardGrid.h). In the unit cube with an
// even vertex at 0, the height h of a point over the face of the odd vertex (1, 0, 0) is x - y - z: 1 at the vertex, 0 in the face. With
// the three others, the heights are (x - y - z, y - x - z, z - x - y, x + y + z - 2). Over no more than one face is a point above 0.
// The scalar of the tetrahedra is linear between the even vertices, -1/2 * sum(height * even vertex opposite), and has a bend at each face:
// + max(height, 0) * (scalar of the odd vertex - that of the linear function there).
// With the constant `trilinear` it is the trilinear field of the cell instead.
// A line that is in two of the corners is so at its ends, and between them in the middle: it has at most three pieces.
uniform FloatArray squares;        // scalars of each point and of the next ones along the second, the third, and both axes
uniform FloatArray opacitySquares; // the same of a separate opacity
uniform FloatArray cellScalars;
uniform FloatArray opacityScalars; // of cells
uniform FloatArray clearDistances; // ClearDistances.h
uniform mat4 toNumbers;    // from model coordinates to numbers of points along each axis
uniform int gridStride[3]; // from a point to the next along each axis
uniform int oddOffset;     // 1 if the first point is odd
uniform vec3 boxLow;       // of the cells that can be seen: first and
uniform vec3 boxHigh;      // last cell, inclusive
ivec3 stride = ivec3(0);
vec3 firstCell = vec3(0.0), lastCell = vec3(0.0);
int parityOffset = 0;

vec3 rayStart = vec3(0.0), raySlope = vec3(0.0); // position and change along the ray
vec3 wayPerNumber = vec3(0.0);                   // 1 / change
vec3 forward = vec3(0.0);                        // 1 along the axes along which the ray goes up
vec3 cell = vec3(0.0), cellAdded = vec3(0.0); // where the ray is; the cell that waits to be added
vec3 axesAhead = vec3(0.0), axesBehind = vec3(0.0); // 1 for those across which the ray leaves the cell, and entered it; otherwise 0
vec2 mirror = vec2(0.0);                         // x in the cell = mirror.x + mirror.y * x
vec4 evenScalars = vec4(0.0), bends = vec4(0.0); // in the order of the heights

void keepGrid()
{
  stride = ivec3(gridStride[0], gridStride[1], gridStride[2]) * int(unity);
  firstCell = boxLow * unity;
  lastCell = boxHigh * unity;
  parityOffset = oddOffset * int(unity);
}

int cellNumber()
{
  ivec3 c = ivec3(cell);
  ivec2 rows = ivec2(stride.y - 1, stride.z / stride.y - 1);
  return c.x + rows.x * (c.y + rows.y * c.z);
}

bool isInBox()
{
  return all(greaterThanEqual(cell, firstCell)) && all(lessThanEqual(cell, lastCell));
}

// Cells whose first vertex is odd are those of the others as a mirror shows them, along the first axis.
void readScalars()
{
  ivec3 c = ivec3(cell);
  int first = c.x + c.y * stride.y + c.z * stride.z;
  int odd = (c.x + c.y + c.z + parityOffset) & 1;
  vec4 a = element(squares, first + odd), b = element(squares, first + 1 - odd);
  evenScalars = vec4(a.w, b.z, b.y, a.x);
  bends = vec4(b.x, a.y, a.z, b.w) + evenScalars - 0.5 * (evenScalars.x + evenScalars.y + evenScalars.z + evenScalars.w);
  mirror = odd == 0 ? vec2(-cell.x, 1.0) : vec2(cell.x + 1.0, -1.0);
}

vec4 heightsAt(float way)
{
  vec3 p = rayStart + way * raySlope;
  p = vec3(mirror.x + mirror.y * p.x, p.yz - cell.yz);
  float sum = p.x + p.y + p.z;
  return vec4(2.0 * p - sum, sum - 2.0);
}

float scalarAt(vec4 heights)
{
  return dot(heights, -0.5 * evenScalars) + dot(max(heights, 0.0), bends);
}

// `front` is the scalar at the first way, if that is known from the cell before.
void findPieces(vec2 ways, bool isKnown, float front)
{
  vec4 first = heightsAt(ways.x), last = heightsAt(ways.y);
  vec4 crossing = clamp(first / (first - last), 0.0, 1.0);
  // Where the ray leaves the first corner, and enters the last.
  vec4 leaves = mix(vec4(0.0), crossing, bvec4(greaterThan(first, max(last, 0.0))));
  vec4 enters = mix(vec4(1.0), crossing, bvec4(greaterThan(last, max(first, 0.0))));
  bvec4 stays = bvec4(greaterThan(min(first, last), vec4(0.0)));
  leaves = mix(leaves, vec4(0.0), stays);
  enters = mix(enters, vec4(1.0), stays);
  vec2 bend = vec2(-lesserOf(vec3(-leaves.x, -leaves.y, min(-leaves.z, -leaves.w))), lesserOf(vec3(enters.x, enters.y, min(enters.z, enters.w))));
  bend.y = max(bend.x, bend.y);
  scalars = vec4(isKnown ? front : scalarAt(first), scalarAt(mix(first, last, bend.x)), scalarAt(mix(first, last, bend.y)), scalarAt(last));
  places = vec4(ways.x, mix(ways.xx, ways.yy, bend), ways.y);
}

// The least and the greatest of the scalars of two squares.
vec2 rangeOf(vec4 a, vec4 b)
{
  vec4 least = min(a, b), most = -max(a, b);
  return vec2(lowestOf(least), -lowestOf(most));
}

vec4 cellSquares[2]; // of the field that was made last

void readSquares(FloatArray fieldSquares, int first)
{
  cellSquares[0] = element(fieldSquares, first);
  cellSquares[1] = element(fieldSquares, first + 1);
}

int firstPoint()
{
  ivec3 c = ivec3(cell);
  return c.x + c.y * stride.y + c.z * stride.z;
}

// The squares of the colour, as the camera sees them.
void readLitSquares(int first)
{
  readSquares(squares, first);
  for (int i = 0; i < 2 && cameraLight; ++i)
  {
    int point = first + i;
    vec4 s = cellSquares[i];
    cellSquares[i] = vec4(withCameraLight(s.x, point), withCameraLight(s.y, point + stride.y), withCameraLight(s.z, point + stride.z),
      withCameraLight(s.w, point + stride.y + stride.z));
  }
}

CubicField fieldOfSquares(vec2 ways)
{
  vec4 a = cellSquares[0], b = cellSquares[1];
  vec4 values;
  for (int i = 0; i < 4; ++i)
  {
    vec3 p = clamp(rayStart + mix(ways.x, ways.y, float(i) / 3.0) * raySlope - cell, 0.0, 1.0);
    vec4 s = mix(a, b, p.x);
    vec2 line = mix(s.xz, s.yw, p.y);
    values[i] = mix(line.x, line.y, p.z);
  }
  vec4 cubic = cubicThrough(values);
  float beside = bendOfCubic(cubic) / 9.0; // of the chords between the values
  return CubicField(cubic, rangeOf(a, b), vec2(lowestOf(values) - beside, beside - lowestOf(-values)));
}

CubicField fieldInCell(FloatArray fieldSquares, vec2 ways)
{
  readSquares(fieldSquares, firstPoint());
  return fieldOfSquares(ways);
}

// In pieces as RayHexahedra.frag.glsl has them.
CubicField colorField = noField, opacityField = noField;
vec2 waysInCell = vec2(0.0);

// Way, scalar of the colour, scalar of the opacity.
vec3 cubicPlace(float t)
{
  return vec3(mix(waysInCell.x, waysInCell.y, t), fieldAt(colorField, t), separateOpacity ? fieldAt(opacityField, t) : 0.0);
}

void findCubicPieces(vec2 ways)
{
  waysInCell = ways;
  numberOfPieces = 1.0;
  if (separateOpacity)
  {
    opacityField = fieldInCell(opacitySquares, ways);
    numberOfPieces = countPieces(opacityField.cubic);
  }
  readLitSquares(firstPoint());
  colorField = fieldOfSquares(ways);
  numberOfPieces = max(numberOfPieces, countPieces(colorField.cubic));
  for (int i = 0; i < 4; ++i)
  {
    vec3 place = cubicPlace(min(float(i) / numberOfPieces, 1.0));
    places[i] = place.x;
    scalars[i] = place.y;
    opacityScalarsHere[i] = place.z;
  }
}

// The pieces of the ray in the present cell.
void readCell(vec2 ways, bool isKnown)
{
  if (useCellScalars)
  {
    scalars = vec4(element(cellScalars, cellNumber()).r);
    opacityScalarsHere = vec4(separateOpacity ? element(opacityScalars, cellNumber()).r : 0.0);
    places = ways.xyyy;
    waysInCell = ways;
    numberOfPieces = 1.0;
    colorField = CubicField(vec4(scalars.x, 0.0, 0.0, 0.0), scalars.xx, scalars.xx);
    opacityField = CubicField(vec4(opacityScalarsHere.x, 0.0, 0.0, 0.0), opacityScalarsHere.xx, opacityScalarsHere.xx);
  }
  else if (trilinear)
  {
    findCubicPieces(ways);
  }
  else
  {
    readScalars();
    findPieces(ways, isKnown, scalars.w);
  }
}

// The first piece gives way to the next ones.
void passPiece(float piece)
{
  vec3 next = trilinear ? cubicPlace(min((piece + 4.0) / numberOfPieces, 1.0)) : vec3(places.w, scalars.w, opacityScalarsHere.w);
  scalars = vec4(scalars.yzw, next.y);
  opacityScalarsHere = vec4(opacityScalarsHere.yzw, next.z);
  places = vec4(places.yzw, next.x);
}

// Where the ray is in the box of cells: from, to.
vec2 wayInBox(vec2 range)
{
  rayStart = (toNumbers * vec4(origin, 1.0)).xyz;
  raySlope = mat3(toNumbers) * along;
  bvec3 level = lessThan(abs(raySlope), vec3(1.0e-20));
  raySlope = mix(raySlope, vec3(1.0e-20), level);
  wayPerNumber = 1.0 / raySlope;
  forward = vec3(greaterThan(raySlope, vec3(0.0)));
  vec3 toLow = (firstCell - rayStart) * wayPerNumber;
  vec3 toHigh = (lastCell + 1.0 - rayStart) * wayPerNumber;
  bvec3 between = lessThan(abs(rayStart - 0.5 * (firstCell + lastCell + 1.0)), 0.5 * (lastCell + 1.0 - firstCell));
  vec3 outside = mix(vec3(3.0e38), vec3(-3.0e38), between);
  vec3 from = mix(min(toLow, toHigh), outside, level);
  vec3 to = mix(max(toLow, toHigh), -outside, level);
  vec2 result = vec2(max(range.x, max(from.x, max(from.y, from.z))), min(range.y, lesserOf(to)));
  axesBehind = vec3(equal(from, vec3(result.x)));
  return result;
}

// Leaps to the far side of the cube of cells around the present one in which nothing is seen; returns the way there.
float leap(float way, float distance)
{
  vec3 far = cell + mix(vec3(1.0 - distance), vec3(distance), forward);
  vec3 ways = (far - rayStart) * wayPerNumber;
  float least = lesserOf(ways);
  vec3 place = floor(rayStart + least * raySlope);
  vec3 inCube = mix(clamp(place, min(far, cell), cell), clamp(place, cell, max(far - 1.0, cell)), forward);
  axesAhead = vec3(equal(ways, vec3(least)));
  cell = mix(inCube, far - 1.0 + forward, axesAhead);
  return max(way, least);
}
