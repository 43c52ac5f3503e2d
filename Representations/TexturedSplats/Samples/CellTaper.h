// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Hexahedra that get narrower along one of their directions, as those of a fan do: those of all
// fans around an axis overlap where they meet. Plain C++17.
#ifndef nephoscope_CellTaper_h
#define nephoscope_CellTaper_h

#include "CellShape.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace nephoscope
{
// By how much squares of widths are less than they need to be.
struct TaperNeed
{
  SplatMatrix More{};
  double Squares = 0; // of the lengths that widths may reach, weighted by More

  double Trace() const { return this->More[0][0] + this->More[1][1] + this->More[2][2]; }

  void Add(const TaperNeed& other, double weight)
  {
    AddWeighted(this->More, other.More, weight);
    this->Squares += weight * other.Squares;
  }

  // To the square of a shape, of which some may be as wide as that already. `share`: the sum of the
  // weights.
  void Widen(SplatMatrix& square, double share) const
  {
    double wide = 0, more = 0;
    for (std::size_t c = 0; c < 3; ++c)
    {
      for (std::size_t r = 0; r < 3; ++r)
      {
        wide += square[c][r] * this->More[c][r];
        more += this->More[c][r] * this->More[c][r] / share;
      }
    }
    if (more > 0)
    {
      const double part = std::min(std::max((this->Squares - wide) / more, 0.0), 1.0);
      AddWeighted(square, this->More, part / share);
    }
  }
};

/*
 * A splat is as wide at both ends as in its middle, and reaches farther than its cell. Where a fan
 * of cells converges to an apex within its reach, splats of the whole fan lie over one another
 * there: too many of them, unless they are as wide as they are long. How near the apex is a cell
 * knows by its own edges, whether other cells meet it there or leave a hole.
 */
class CellTaper
{
public:
  // Corners in the order of VTK_HEXAHEDRON.
  explicit CellTaper(const Vector3* corners)
  {
    // Per direction, the edges between the corners at the low and at the high end of each other
    // direction.
    for (std::size_t n = 0; n < 3; ++n)
    {
      for (int corner = 0; corner < 8; ++corner)
      {
        if (At(corner, n) == 0)
        {
          const Vector3 edge = corners[Across(corner, n)] - corners[corner];
          const double length = Norm(edge);
          for (std::size_t c = 0; c < 3; ++c)
          {
            this->Edges[n][c] += edge[c] / 4;
          }
          for (std::size_t a = 0; a < 3; ++a)
          {
            this->Widths[n][a][At(corner, a)] += length / 2;
          }
        }
      }
    }
  }

  bool ReachesApex() const
  {
    return this->Needed([](std::size_t, double) { return -0.5; }).Trace() > 0;
  }

  // What the middle, or a corner, needs.
  TaperNeed AtMiddle() const
  {
    return this->Needed([](std::size_t, double) { return 0.0; });
  }
  TaperNeed AtCorner(int corner) const
  {
    return this->Needed([corner](std::size_t a, double taper) {
      return (At(corner, a) != 0) == (taper > 0) ? 0.5 : -0.5; // of a cell, away from the apex
    });
  }

private:
  static int At(int corner, std::size_t direction)
  {
    const int around = corner % 4;
    return direction == 2 ? corner / 4
      : direction == 1    ? around / 2
                          : int(around == 1 || around == 2);
  }
  static int Across(int corner, std::size_t direction)
  {
    constexpr int pairs[2][4] = { { 1, 0, 3, 2 }, { 3, 2, 1, 0 } };
    return direction == 2 ? (corner + 4) % 8 : corner - corner % 4 + pairs[direction][corner % 4];
  }

  // How much of the length a splat needs as its width that is so many cells from the apex: all of
  // it at the apex, nothing where it does not reach it.
  static double Weight(double cells)
  {
    constexpr double reach = 1.8;
    return std::exp(-std::pow(std::max(cells, 0.0) / reach, 4));
  }

  template <typename Shift>
  TaperNeed Needed(const Shift& shift) const
  {
    TaperNeed need;
    for (std::size_t n = 0; n < 3; ++n)
    {
      const double width = Norm(this->Edges[n]);
      double more = 0, square = 0;
      for (std::size_t turn = 1; turn < 3; ++turn)
      {
        const std::size_t a = (n + turn) % 3;
        const double low = this->Widths[n][a][0], high = this->Widths[n][a][1];
        const double taper = low + high > 0 ? 2 * (high - low) / (high + low) : 0;
        const double length = Norm(this->Edges[a]);
        if (std::abs(taper) > least && length > width)
        {
          const double weight = Weight(1 / std::abs(taper) + shift(a, taper));
          const double here = weight * (length * length - width * width);
          square = here > more ? length * length : square;
          more = std::max(more, here);
        }
      }
      if (more > 0 && width > 0)
      {
        SplatMatrix along{};
        AddOuterProduct(along, this->Edges[n]);
        AddWeighted(need.More, along, more / (width * width));
        need.Squares += more * square;
      }
    }
    return need;
  }

  static constexpr double least = 0.25; // the apex is farther than any splat reaches

  SplatMatrix Edges{};         // the means of four
  double Widths[3][3][2] = {}; // of the edges in a direction, at both ends of another
};
}

#endif
