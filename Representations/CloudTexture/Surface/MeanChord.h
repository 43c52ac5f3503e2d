// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The mean length of rays inside a closed surface: four times its volume over its area, for rays
 * with all positions and directions (Cauchy1850). The volume is that of the tetrahedra between the
 * triangles and the origin, with their signs. It is closed where every edge is there once in each
 * direction: then the signed sum of hash values of edges is 0, and by chance in one case of 2^64.
 */
#ifndef nephoscope_MeanChord_h
#define nephoscope_MeanChord_h

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace nephoscope
{

class MeanChord
{
public:
  using Point = std::array<double, 3>;

  /** "Weight" is what the chord is multiplied by there, such as a density. */
  void AddTriangle(const Point& a, const Point& b, const Point& c, double weight = 1)
  {
    const Point u{ { b[0] - a[0], b[1] - a[1], b[2] - a[2] } };
    const Point v{ { c[0] - a[0], c[1] - a[1], c[2] - a[2] } };
    const Point n{ { (u[1] * v[2] - u[2] * v[1]) / 2, (u[2] * v[0] - u[0] * v[2]) / 2,
      (u[0] * v[1] - u[1] * v[0]) / 2 } };
    const double area = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    this->Area += area;
    this->Weighted += weight * area;
    this->Volume += (a[0] * n[0] + a[1] * n[1] + a[2] * n[2]) / 3;
    this->AddEdge(a, b);
    this->AddEdge(b, c);
    this->AddEdge(c, a);
  }

  bool IsClosed() const { return this->Edges == 0 && this->Area > 0 && this->Volume != 0; }
  /** Closed, and the triangles face inwards. */
  bool IsInsideOut() const { return this->IsClosed() && this->Volume < 0; }
  /** 0 where the surface is not closed. */
  double Length() const { return this->IsClosed() ? 4 * std::abs(this->Volume) / this->Area : 0; }
  double MeanWeight() const { return this->Area > 0 ? this->Weighted / this->Area : 1; }

private:
  static std::uint64_t Mix(std::uint64_t x) // splitmix64
  {
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
  }

  static std::uint64_t Hash(const Point& p)
  {
    std::uint64_t result = 0;
    for (const double x : p)
    {
      const double positiveZero = x + 0.0;
      std::uint64_t bits;
      std::memcpy(&bits, &positiveZero, sizeof bits);
      result = Mix(result ^ bits);
    }
    return result;
  }

  void AddEdge(const Point& from, const Point& to)
  {
    const std::uint64_t first = Hash(from), second = Hash(to);
    this->Edges += first < second ? Mix(first ^ Mix(second)) : 0;
    this->Edges -= second < first ? Mix(second ^ Mix(first)) : 0;
  }

  double Area = 0, Weighted = 0, Volume = 0;
  std::uint64_t Edges = 0;
};

} // namespace nephoscope

#endif
