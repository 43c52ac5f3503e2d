// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Tetrahedra by the numbers of their points: a list; or, without a copy, the cells of an
 * unstructured grid if they are the same tetrahedra.
 *
 * Cells of the input may change in place without notice. Numbers that no point has are therefore
 * read as 0.
 */
#ifndef nephoscope_TetrahedronList_h
#define nephoscope_TetrahedronList_h

#include "vtkSmartPointer.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

class vtkDataArray;
class vtkDataSet;

namespace nephoscope
{

using Tetrahedron = std::array<std::int32_t, 4>;

class TetrahedronList
{
public:
  TetrahedronList() = default;
  explicit TetrahedronList(std::vector<Tetrahedron> list)
    : List(std::move(list))
    , Size(this->List.size())
  {
  }

  std::size_t size() const { return this->Size; }
  bool empty() const { return this->Size == 0; }
  Tetrahedron operator[](std::size_t i) const
  {
    return !this->Ids                        ? this->List[i]
      : this->IdSize == sizeof(std::int32_t) ? this->Read<std::int32_t>(i)
                                             : this->Read<std::int64_t>(i);
  }
  std::vector<Tetrahedron> Copy() const;

  void Resize(std::size_t size);
  void Set(std::size_t i, const Tetrahedron& tetrahedron) { this->List[i] = tetrahedron; }

  /**
   * Reads the cells of `data` from now on, if every tetrahedron i is cell i of `data`; the order of
   * its points may differ.
   */
  void ReadFrom(vtkDataSet* data);
  bool ReadsInput() const { return this->Ids != nullptr; }
  /**
   * Reads the same cells from `data`, which may be another dataset. False, with an empty list, if
   * they are no longer there.
   */
  bool Follow(vtkDataSet* data);
  /** False, with an empty list from then on, if the input now has fewer cells. */
  bool Refresh();
  /**
   * Call this before reading the cells after other code has run. Also false if `data` now has
   * another array: the memory of the old one may have been freed.
   */
  bool Refresh(vtkDataSet* data);

private:
  template <typename Id>
  Tetrahedron Read(std::size_t i) const
  {
    const Id* ids = static_cast<const Id*>(this->Ids) + 4 * i;
    Tetrahedron t;
    for (std::size_t k = 0; k < 4; ++k)
    {
      const bool known = static_cast<std::uint64_t>(ids[k]) < this->NumberOfPoints;
      t[k] = known ? static_cast<std::int32_t>(ids[k]) : 0;
    }
    return t;
  }
  bool Attach(vtkDataSet* data);

  std::vector<Tetrahedron> List;
  std::size_t Size = 0;
  vtkSmartPointer<vtkDataArray> Input; // four numbers for each cell
  const void* Ids = nullptr;           // its values
  int IdSize = 0;
  std::uint64_t NumberOfPoints = 0; // in ReadFrom
  bool Lost = false;                // the input had too few cells
};

} // namespace nephoscope

#endif
