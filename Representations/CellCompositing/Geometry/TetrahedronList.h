// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Tetrahedra by the numbers of their points: a list, or the cells of an unstructured grid that are the same ones, which takes no memory.
 *
 * Cells of the input may change in place before anybody hears of it. Numbers that are none of a point are therefore read as 0.
 */
#ifndef TetrahedronList_h
#define TetrahedronList_h

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

  /** Reads the cells of `data` from now on, if number i of the list is cell i for all of them, in any order of its points. */
  void ReadFrom(vtkDataSet* data);
  bool ReadsInput() const { return this->Ids != nullptr; }
  /** The same cells, in a dataset that may be another one. False if they are not there any more; the list is empty then. */
  bool Follow(vtkDataSet* data);
  /** To be called before the cells are read after others have run: false, and empty, if the input has fewer of them now. */
  bool Refresh();

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
  std::uint64_t NumberOfPoints = 0;
};

} // namespace nephoscope

#endif
