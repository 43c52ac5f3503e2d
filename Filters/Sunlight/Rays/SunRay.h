// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A ray to the sun on its way from tetrahedron to tetrahedron. In the frame of the sun it goes
 * along z: where it passes a face follows from x and y alone, and each tetrahedron adds one vertex
 * to those of the face where the ray enters. Fields are linear in tetrahedra, so that their
 * integrals are exact.
 * Plain C++17.
 */
#ifndef nephoscope_SunRay_h
#define nephoscope_SunRay_h

#include "SunFrame.h"

#include <algorithm>
#include <utility>

namespace nephoscope
{
class SunRay
{
public:
  SunRay() = default;
  /** A little beside the point, since columns of grids often lie in the direction of the sun. */
  SunRay(const SunPoint& point, double besideX, double besideY)
    : X(point.X + besideX)
    , Y(point.Y + besideY)
    , Z(point.Z)
    , Here{ point.Values[0], point.Values[1] }
  {
  }

  double Height() const { return this->Z; }
  /** The fields where the ray is. */
  std::array<double, 2> Values() const { return { { this->Here[0], this->Here[1] } }; }
  double Across(int axis) const { return axis == 0 ? this->X : this->Y; }
  bool IsDark() const { return this->Sums[1] > darkDepth; }
  std::array<double, 2> Depths() const
  {
    return { { std::max(this->Sums[0], 0.0), std::max(this->Sums[1], 0.0) } };
  }

  /**
   * Goes to this face across from the point: 1, or -1 if it has put the last two vertices in the
   * place of one another; 0: the face is below or beside.
   */
  int Start(const SunPoint& a, const SunPoint& b, const SunPoint& c, bool isThere = true)
  {
    const int turn = this->Face(a, b, c);
    if (turn == 0 ||
      this->SumOf(this->FaceZ) <= this->Z * (this->Area[0] + this->Area[1] + this->Area[2]))
    {
      return 0;
    }
    this->Go(isThere);
    return turn;
  }

  /** Goes to this face through nothing. Returns the same as Start; 0: the face is beside. */
  int Enter(const SunPoint& a, const SunPoint& b, const SunPoint& c)
  {
    const int turn = this->Face(a, b, c);
    if (turn != 0)
    {
      const double scale = 1 / (this->Area[0] + this->Area[1] + this->Area[2]);
      this->Here[0] = scale * this->SumOf(this->First);
      this->Here[1] = scale * this->SumOf(this->Second);
      this->Z = scale * this->SumOf(this->FaceZ);
    }
    return turn;
  }

  /** Moves the ray to where a grid that repeats is stored. */
  void Move(double x, double y, double z)
  {
    this->X += x;
    this->Y += y;
    this->Z += z;
    for (double& height : this->FaceZ)
    {
      height += z;
    }
  }

  /**
   * Through a tetrahedron with this vertex above the last face; `isThere` tells whether it counts.
   * Returns which vertex of the face (0 to 2) the new one replaces.
   */
  int Step(const SunPoint& vertex, bool isThere = true)
  {
    const double x = vertex.X - this->X, y = vertex.Y - this->Y;
    double s[3];
    for (int k = 0; k < 3; ++k)
    {
      s[k] = x * this->FaceY[k] - y * this->FaceX[k];
    }
    static constexpr signed char replaced[8] = { -1, 1, 2, 1, 0, 0, 2, -1 };
    int out = replaced[int(s[0] < 0) | int(s[1] < 0) << 1 | int(s[2] < 0) << 2];
    if (out < 0)
    {
      out = throughEdge(s);
    }
    constexpr int after[4] = { 1, 2, 0, 1 };
    const int i = after[out], j = after[out + 1];
    this->Area[i] = -s[j];
    this->Area[j] = s[i];
    this->Set(out, vertex);
    this->Go(isThere);
    return out;
  }

private:
  // The face that is looked at, turned so that areas are positive: 1, turned -1; 0: the ray passes
  // it by.
  int Face(const SunPoint& a, const SunPoint& b, const SunPoint& c)
  {
    this->Set(0, a);
    this->Set(1, b);
    this->Set(2, c);
    for (int k = 0; k < 3; ++k)
    {
      const int i = (k + 1) % 3, j = (k + 2) % 3;
      this->Area[k] = this->FaceX[i] * this->FaceY[j] - this->FaceY[i] * this->FaceX[j];
    }
    const bool turned = this->Area[0] + this->Area[1] + this->Area[2] < 0;
    if (turned)
    {
      this->Set(1, c);
      this->Set(2, b);
      const double second = this->Area[1];
      this->Area[0] = -this->Area[0];
      this->Area[1] = -this->Area[2];
      this->Area[2] = -second;
    }
    const bool within = this->Area[0] + this->Area[1] + this->Area[2] > 0 && this->Area[0] >= 0 &&
      this->Area[1] >= 0 && this->Area[2] >= 0;
    return !within ? 0 : turned ? -1 : 1;
  }

  // Rounding: through an edge, or a little past the tetrahedron.
  static int throughEdge(double* s)
  {
    const bool isPositive = s[0] >= 0;
    double* nearest = isPositive ? std::min_element(s, s + 3) : std::max_element(s, s + 3);
    *nearest = 0;
    return static_cast<int>(nearest - s + (isPositive ? 1 : 2)) % 3;
  }

  void Set(int k, const SunPoint& p)
  {
    this->FaceX[k] = p.X - this->X;
    this->FaceY[k] = p.Y - this->Y;
    this->FaceZ[k] = p.Z;
    this->First[k] = p.Values[0];
    this->Second[k] = p.Values[1];
  }

  double SumOf(const double* values) const
  {
    return this->Area[0] * values[0] + this->Area[1] * values[1] + this->Area[2] * values[2];
  }

  // To the place on the face that the areas tell.
  void Go(bool isThere)
  {
    const double sum = this->Area[0] + this->Area[1] + this->Area[2];
    if (sum > 0)
    {
      const double scale = 1 / sum, height = scale * this->SumOf(this->FaceZ),
                   half = isThere ? 0.5 * (height - this->Z) : 0,
                   first = scale * this->SumOf(this->First),
                   second = scale * this->SumOf(this->Second);
      this->Sums[0] += half * (this->Here[0] + first);
      this->Sums[1] += half * (this->Here[1] + second);
      this->Here[0] = first;
      this->Here[1] = second;
      this->Z = height;
    }
  }

  double X = 0, Y = 0, Z = 0;
  double Here[2] = { 0, 0 };
  double Sums[2] = { 0, 0 };
  double FaceX[3] = {}, FaceY[3] = {}, FaceZ[3] = {}, First[3] = {}, Second[3] = {};
  double Area[3] = {}; // across from each vertex of the face, as seen from the ray; not negative
};

/** Sides to which a ray may pass the point: the next ones at the boundary of a mesh. */
constexpr double sidesOfRay[4][2] = { { 0.85, 0.53 }, { -0.53, 0.85 }, { -0.85, -0.53 },
  { 0.53, -0.85 } };

}

#endif
