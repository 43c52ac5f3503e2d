// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// An order of the points of a structured grid in which the third index counts upwards, and the
// first one closes on itself if another horizontal one does: what is computed along columns does
// not depend on how a grid is stored.
#ifndef nephoscope_UprightOrder_h
#define nephoscope_UprightOrder_h

#include "Vector3.h"

#include "vtkNephoscopeFiltersCommonModule.h" // for export macro

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace nephoscope
{
class VTKNEPHOSCOPEFILTERSCOMMON_EXPORT UprightOrder
{
public:
  using Sizes = std::array<int, 3>;
  using PlaceOf = std::function<Vector3(std::size_t)>;
  using UpAt = std::function<Vector3(const Vector3&)>;

  UprightOrder() = default;
  // `placeOf` gives the place of a point by its number in the data, `upAt` the unit vector upwards
  // there.
  UprightOrder(const Sizes& sizes, const PlaceOf& placeOf, const UpAt& upAt);

  // The same for cells.
  UprightOrder OfCells() const;

  const Sizes& GetSizes() const { return this->Ordered; }

  // The number in the data of a point in this order.
  std::size_t NumberOf(std::size_t point) const
  {
    return this->Numbers.empty() ? point : this->Numbers[point];
  }

  // Values in this order; no values remain none.
  template <typename T>
  std::vector<T> Of(const std::vector<T>& values) const
  {
    if (this->Numbers.empty() || values.empty())
    {
      return values;
    }
    std::vector<T> ordered(values.size());
    for (std::size_t p = 0; p < values.size(); ++p)
    {
      ordered[p] = values[this->Numbers[p]];
    }
    return ordered;
  }

private:
  std::size_t Stride(int axis) const;
  double Climb(int axis, const PlaceOf& placeOf, const UpAt& upAt) const;
  bool IsClosed(int axis, const PlaceOf& placeOf) const;
  void Number();

  Sizes Stored{ { 0, 0, 0 } }, Ordered{ { 0, 0, 0 } };
  std::array<int, 3> Axes{ { 0, 1, 2 } };
  bool Downwards = false;            // the third axis, as it is stored
  std::vector<std::int32_t> Numbers; // empty: as they are stored
};
}

#endif
