// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The arrays that all ranks with cells have, and their values as bytes to exchange. Bytes, so that values of every
// type arrive unchanged.
#ifndef nephoscope_SharedArrays_h
#define nephoscope_SharedArrays_h

#include <cstddef>
#include <string>
#include <vector>

class vtkMultiProcessController;
class vtkPointData;

namespace nephoscope
{
class DataSetField;

class SharedArrays
{
public:
  // Together on all ranks. `local` is null on a rank without cells, and not null on at least one.
  SharedArrays(const DataSetField* local, vtkMultiProcessController* controller);

  // The lowest rank that has cells.
  int FirstRank() const { return this->First; }

  // Bytes that the values of all arrays at a position take.
  std::size_t TupleSize() const { return this->Size; }

  // The arrays, without values.
  void Allocate(std::size_t count, vtkPointData* output) const;

  // Tuple i of every array of `sampled` to the bytes of position `places[i]`.
  void Pack(vtkPointData* sampled, const std::vector<std::size_t>& places, unsigned char* bytes) const;

  // The bytes of `count` positions to the tuples from `first` on.
  void Unpack(const unsigned char* bytes, std::size_t count, std::size_t first, vtkPointData* output) const;

private:
  struct Entry
  {
    std::string Name;
    int Type = 0;       // VTK_DOUBLE and so on
    int Components = 1;
    int Attribute = -1; // vtkDataSetAttributes::SCALARS and so on; -1: none
    std::vector<std::string> ComponentNames;
    std::size_t Size = 0; // bytes of a tuple
  };

  static std::vector<Entry> Describe(const DataSetField& field);
  static bool Has(const std::vector<Entry>& entries, const Entry& wanted);
  static void Broadcast(std::vector<Entry>& entries, vtkMultiProcessController* controller, int root);

  int First = 0;
  std::vector<Entry> Entries;
  std::size_t Size = 0;
};
}

#endif
