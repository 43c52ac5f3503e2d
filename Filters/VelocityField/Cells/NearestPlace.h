// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The point on a triangle or a quadrilateral nearest to the origin. Plain C++17.
#ifndef nephoscope_NearestPlace_h
#define nephoscope_NearestPlace_h

#include "TrilinearMap.h"

#include <limits>

namespace nephoscope
{
// A quadrilateral is the bilinear patch of its corners, as the face of a hexahedron is.
class NearestPlace
{
public:
  double Distance2() const { return this->Nearest2; }
  double Weight(std::size_t corner) const { return this->Weights[corner]; }

  void OnTriangle(const Vector3 (&p)[4])
  {
    const Vector3 k[4] = { p[0], From(p[0], p[1]), From(p[0], p[2]), Vector3{} };
    double u = 1.0 / 3.0;
    double v = u;
    if (FootOn(k, u, v) && u >= 0.0 && v >= 0.0 && u + v <= 1.0)
    {
      this->Consider(p, { 1.0 - u - v, u, v, 0.0 });
      return;
    }
    this->OnEdges(p, 3);
  }

  // Corners around the quadrilateral.
  void OnQuadrilateral(const Vector3 (&p)[4])
  {
    const Vector3 k[4] = { p[0], From(p[0], p[1]), From(p[0], p[3]),
      From(From(p[0], p[1]), From(p[3], p[2])) };
    double u = 0.5;
    double v = 0.5;
    if (FootOn(k, u, v) && u >= 0.0 && u <= 1.0 && v >= 0.0 && v <= 1.0)
    {
      this->Consider(p, { (1.0 - u) * (1.0 - v), u * (1.0 - v), u * v, (1.0 - u) * v });
    }
    this->OnEdges(p, 4);
  }

private:
  static Vector3 From(const Vector3& a, const Vector3& b)
  {
    return { b[0] - a[0], b[1] - a[1], b[2] - a[2] };
  }

  // Newton's method for the least square of k0 + u k1 + v k2 + u v k3; that of Gauss where the
  // surface curves too much.
  static bool FootOn(const Vector3 (&k)[4], double& u, double& v)
  {
    for (int iteration = 0; iteration < 30; ++iteration)
    {
      Vector3 place;
      Vector3 alongU;
      Vector3 alongV;
      for (std::size_t c = 0; c < 3; ++c)
      {
        alongU[c] = k[1][c] + v * k[3][c];
        alongV[c] = k[2][c] + u * k[3][c];
        place[c] = k[0][c] + u * alongU[c] + v * k[2][c];
      }
      const double uu = Dot(alongU, alongU);
      const double vv = Dot(alongV, alongV);
      const double slopes = Dot(alongU, alongV);
      const double curved = slopes + Dot(place, k[3]);
      const double uv = curved * curved < uu * vv ? curved : slopes;
      const double determinant = uu * vv - uv * uv;
      const double du = (vv * Dot(place, alongU) - uv * Dot(place, alongV)) / determinant;
      const double dv = (uu * Dot(place, alongV) - uv * Dot(place, alongU)) / determinant;
      const double size = std::abs(du) + std::abs(dv);
      if (!(size < 1e30))
      {
        return false; // without an area
      }
      u = std::clamp(u - du, -1.0, 2.0);
      v = std::clamp(v - dv, -1.0, 2.0);
      if (size < 1e-10)
      {
        return true;
      }
    }
    return false;
  }

  void OnEdges(const Vector3 (&p)[4], std::size_t count)
  {
    for (std::size_t a = 0; a < count; ++a)
    {
      const std::size_t b = (a + 1) % count;
      const Vector3 edge = From(p[a], p[b]);
      const double length2 = Dot(edge, edge);
      const double share = length2 > 0.0 ? std::clamp(-Dot(p[a], edge) / length2, 0.0, 1.0) : 0.0;
      std::array<double, 4> weights{};
      weights[a] = 1.0 - share;
      weights[b] = share;
      this->Consider(p, weights);
    }
  }

  void Consider(const Vector3 (&p)[4], const std::array<double, 4>& weights)
  {
    Vector3 place{};
    for (std::size_t i = 0; i < 4; ++i)
    {
      for (std::size_t c = 0; c < 3; ++c)
      {
        place[c] += weights[i] * p[i][c];
      }
    }
    const double distance2 = Dot(place, place);
    if (distance2 < this->Nearest2)
    {
      this->Nearest2 = distance2;
      this->Weights = weights;
    }
  }

  double Nearest2 = std::numeric_limits<double>::max();
  std::array<double, 4> Weights{};
};
}

#endif
