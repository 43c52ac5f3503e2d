// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Vectors in space, with the names of GLSL where a variable may not be called the same. Plain
 * C++17.
 */
#ifndef nephoscope_Vector3_h
#define nephoscope_Vector3_h

#include <array>
#include <cmath>

namespace nephoscope
{

using Vector3 = std::array<double, 3>;
/** A point (x, y, z, 1), or a direction (x, y, z, 0); also four weights. */
using Vector4 = std::array<double, 4>;

inline Vector3 operator+(const Vector3& a, const Vector3& b)
{
  return { a[0] + b[0], a[1] + b[1], a[2] + b[2] };
}
inline Vector3 operator-(const Vector3& a, const Vector3& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}
inline Vector3 operator*(double s, const Vector3& a)
{
  return { s * a[0], s * a[1], s * a[2] };
}
inline Vector3 Difference(const Vector3& a, const Vector3& b)
{
  return a - b;
}
inline double Dot(const Vector3& a, const Vector3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Vector3 Cross(const Vector3& a, const Vector3& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}
/** The determinant of the columns a, b, c. */
inline double TripleProduct(const Vector3& a, const Vector3& b, const Vector3& c)
{
  return Dot(Cross(a, b), c);
}
inline double Norm(const Vector3& a)
{
  return std::sqrt(Dot(a, a));
}
inline double Distance(const Vector3& a, const Vector3& b)
{
  return Norm(a - b);
}
/** A vector of unit length; zero stays zero. */
inline Vector3 Normalized(const Vector3& a)
{
  const double length = Norm(a);
  return length > 0.0 ? (1.0 / length) * a : Vector3{};
}
inline bool IsFinite(const Vector3& a)
{
  return std::isfinite(a[0]) && std::isfinite(a[1]) && std::isfinite(a[2]);
}

} // namespace nephoscope

#endif
