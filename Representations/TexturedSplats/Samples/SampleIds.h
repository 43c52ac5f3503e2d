// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** Numbers of points or cells: 4 bytes each where all of them fit, else 8. */
#ifndef nephoscope_SampleIds_h
#define nephoscope_SampleIds_h

#include "vtkType.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace nephoscope
{

class SampleIds
{
public:
  SampleIds() = default;
  /** None of them is negative. */
  explicit SampleIds(std::vector<vtkIdType>&& ids)
  {
    constexpr std::uint64_t most = std::numeric_limits<std::uint32_t>::max();
    const auto fits = [](vtkIdType id) { return static_cast<std::uint64_t>(id) <= most; };
    if (std::all_of(ids.begin(), ids.end(), fits))
    {
      this->Short.assign(ids.begin(), ids.end());
      std::vector<vtkIdType>().swap(ids);
    }
    else
    {
      this->Long.swap(ids);
    }
  }

  vtkIdType operator[](std::size_t i) const
  {
    return this->Long.empty() ? static_cast<vtkIdType>(this->Short[i]) : this->Long[i];
  }
  std::size_t size() const { return std::max(this->Short.size(), this->Long.size()); }

private:
  std::vector<std::uint32_t> Short;
  std::vector<vtkIdType> Long;
};

} // namespace nephoscope

#endif
