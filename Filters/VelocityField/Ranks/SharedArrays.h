// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The arrays of the fields of all ranks, and their values as bytes to exchange. Bytes, so that
// values of every type arrive unchanged.
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
  // Together on all ranks. `local` is null on a rank without a field, and not null on at least one.
  SharedArrays(const DataSetField* local, vtkMultiProcessController* controller);

  // The lowest rank that has a field.
  int FirstRank() const { return this->First; }

  // Bytes that the values of all arrays at a position take.
  std::size_t TupleSize() const { return this->Size; }

  // The arrays, without values.
  void Allocate(std::size_t count, vtkPointData* output) const;

  // Tuple i of every array of `sampled` to the bytes of position `places[i]`. An array that it is
  // without is NaN there, or 0, as it is where a block is without.
  void Pack(
    vtkPointData* sampled, const std::vector<std::size_t>& places, unsigned char* bytes) const;

  // The bytes of `count` positions to the tuples from `first` on.
  void Unpack(
    const unsigned char* bytes, std::size_t count, std::size_t first, vtkPointData* output) const;

private:
  struct Entry
  {
    std::string Name;
    int Type = 0; // VTK_DOUBLE and so on
    int Components = 1;
    int Attribute = -1; // vtkDataSetAttributes::SCALARS and so on; -1: none
    std::vector<std::string> ComponentNames;
    std::size_t Size = 0; // bytes of a tuple
  };

  static std::vector<Entry> Describe(const DataSetField& field);
  static const Entry* Find(const std::vector<Entry>& entries, const std::string& name);
  static bool AreSame(const std::vector<Entry>& a, const std::vector<Entry>& b);
  static std::vector<Entry> Broadcast(
    const std::vector<Entry>& own, vtkMultiProcessController* controller, int root);
  void Add(const std::vector<Entry>& entries);

  int First = 0;
  std::vector<Entry> Entries;
  std::size_t Size = 0;
};
}

#endif
