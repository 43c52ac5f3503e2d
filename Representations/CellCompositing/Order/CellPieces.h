// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Parts of tetrahedra, made for a view in which no order of whole tetrahedra is correct.
 *
 * They follow the geometry's own: piece k is tetrahedron number Tetrahedra.size() + k, and its corners are numbered from
 * Points.size() on.
 */
#ifndef CellPieces_h
#define CellPieces_h

#include "CellGeometry.h"

namespace nephoscope
{

struct CellPieces
{
  std::vector<CellGeometry::Point> Points;
  std::vector<Tetrahedron> Tetrahedra;
  std::vector<std::int32_t> Owners;  ///< per piece: the tetrahedron that it is a part of
  std::vector<float> OpacityScalars; ///< per point, where those of the geometry are per point

  void Clear() { *this = CellPieces(); }

  /** Values of the pieces, from those of the tetrahedra. */
  std::vector<float> OfOwners(const std::vector<float>& values) const
  {
    std::vector<float> result;
    for (std::size_t i = 0; i < this->Owners.size() && !values.empty(); ++i)
    {
      result.push_back(values[static_cast<std::size_t>(this->Owners[i])]);
    }
    return result;
  }

  /** A corner by its barycentric coordinates in the owner; returns its number, counted from 0. */
  std::int32_t AddPoint(const CellGeometry& geometry, std::int32_t owner, const Vector3& position,
    const Vector4& weights)
  {
    const Tetrahedron& t = geometry.Tetrahedra[static_cast<std::size_t>(owner)];
    const bool opacity = geometry.HasOpacityScalars && !geometry.OpacityOnCells;
    double scalar = 0, opacityScalar = 0;
    for (std::size_t k = 0; k < 4; ++k)
    {
      const std::size_t point = static_cast<std::size_t>(t[k]);
      scalar += weights[k] * geometry.Points[point].Scalar;
      opacityScalar += opacity ? weights[k] * geometry.OpacityScalars[point] : 0.0;
    }
    this->Points.push_back({ static_cast<float>(position[0]), static_cast<float>(position[1]),
      static_cast<float>(position[2]), static_cast<float>(scalar) });
    if (opacity)
    {
      this->OpacityScalars.push_back(static_cast<float>(opacityScalar));
    }
    return static_cast<std::int32_t>(this->Points.size() - 1);
  }
};

/** The geometry's values, and after them those of the pieces. */
template <typename T>
std::vector<T> joined(std::vector<T> values, const std::vector<T>& ofPieces)
{
  values.insert(values.end(), ofPieces.begin(), ofPieces.end());
  return values;
}

} // namespace nephoscope

#endif
