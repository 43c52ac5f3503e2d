// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Points in one place, at a seam, a pole, or where every cell has points of its own, are one
 * sample.
 */
#ifndef nephoscope_PointPlaces_h
#define nephoscope_PointPlaces_h

#include "vtkType.h"

#include <cstddef>
#include <vector>

class vtkDataSet;

namespace nephoscope
{

/**
 * How far apart points in one place may be, to the rounding of float: a part of the diagonal of the
 * points' bulk.
 */
double RoundingOfPlaces(vtkDataSet* data);

/**
 * For every point the first that lies in its place; empty if all lie apart, or are particles: of
 * those each is a sample.
 */
std::vector<vtkIdType> FindPlaces(vtkDataSet* data);

inline vtkIdType PlaceOfPoint(const std::vector<vtkIdType>& places, vtkIdType point)
{
  return places.empty() ? point : places[static_cast<std::size_t>(point)];
}

} // namespace nephoscope

#endif
