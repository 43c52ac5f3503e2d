// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The points that hexahedra join to a point: where they are as in a grid, they tell its axes. Plain
// C++17.
#ifndef nephoscope_CornerRing_h
#define nephoscope_CornerRing_h

#include "SplatMatrix.h"

#include <cstddef>

namespace nephoscope
{
/*
 * In a grid a point has at most six neighbours, two opposite ones along each axis. Each cell around
 * the point has one neighbour per axis, so that opposite ones are those that have no cell in
 * common. Their central difference has the direction and the length of the axis, however much the
 * grid is bent: squares of the edges alone would count its bend as width.
 */
class CornerRing
{
public:
  // The neighbours of a corner of a hexahedron.
  void Add(const int (&neighbors)[3])
  {
    int at[3];
    for (int i = 0; i < 3; ++i)
    {
      at[i] = this->Find(neighbors[i]);
      if (at[i] < 0)
      {
        this->Break();
        return;
      }
    }
    for (int i = 0; i < 3; ++i)
    {
      const int j = (i + 1) % 3;
      this->Together[at[i]] |= static_cast<unsigned char>(1 << at[j]);
      this->Together[at[j]] |= static_cast<unsigned char>(1 << at[i]);
    }
  }

  // A cell of another kind.
  void Break() { this->Broken = true; }

  // The edges of the point's cell, by `place(neighbour)`. False where the cells are not as in a
  // grid.
  template <typename Place>
  bool FindAxes(const Vector3& here, const Place& place, SplatMatrix& axes) const
  {
    std::size_t found = 0;
    for (int i = 0; i < this->Count && !this->Broken; ++i)
    {
      const unsigned apart = ~this->Together[i] & ((1U << this->Count) - 1) & ~(1U << i);
      const bool known = apart != 0 && apart < 1U << i; // by the opposite point
      if ((apart & (apart - 1)) != 0 || (found == 3 && !known))
      {
        return false;
      }
      if (!known)
      {
        const Vector3 end = place(this->Neighbors[i]);
        const Vector3 begin = apart == 0 ? here : place(this->Neighbors[NumberOf(apart)]);
        for (std::size_t c = 0; c < 3; ++c)
        {
          axes[found][c] = (apart == 0 ? 1.0 : 0.5) * (end[c] - begin[c]);
        }
        ++found;
      }
    }
    return found == 3;
  }

private:
  static constexpr int most = 6;

  static int NumberOf(unsigned bit)
  {
    int number = 0;
    while ((bit >>= 1) != 0)
    {
      ++number;
    }
    return number;
  }

  int Find(int neighbor)
  {
    for (int i = 0; i < this->Count; ++i)
    {
      if (this->Neighbors[i] == neighbor)
      {
        return i;
      }
    }
    if (this->Count == most)
    {
      return -1;
    }
    this->Neighbors[this->Count] = neighbor;
    return this->Count++;
  }

  int Neighbors[most];
  unsigned char Together[most] = {}; // a bit for each other neighbour
  unsigned char Count = 0;
  bool Broken = false;
};
}

#endif
