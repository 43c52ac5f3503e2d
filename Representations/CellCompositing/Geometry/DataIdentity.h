// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Whether a dataset still has the mesh, and an array the values, of the last time.
 *
 * Modification times answer first. But a filter that runs again passes on a new dataset even if
 * only one of its arrays has changed, and code that writes into an array may modify only the
 * dataset's time. Where a time has moved, a fingerprint of the contents decides, which takes a
 * hundredth of the time in which the mesh would be made again.
 */
#ifndef nephoscope_DataIdentity_h
#define nephoscope_DataIdentity_h

#include "ScalarSelection.h"

#include "vtkType.h"

#include <array>
#include <cstdint>
#include <tuple>
#include <vector>

class vtkDataSet;

namespace nephoscope
{

/**
 * Points, cells and ghost flags of an unstructured grid. Faces of polyhedra are not compared: every
 * change of their dataset counts as a change of the mesh, and so does every change of other data.
 */
class MeshIdentity
{
public:
  /** True unless this is the mesh of the last time. */
  bool Changes(vtkDataSet* data);
  void Forget() { *this = MeshIdentity(); }

private:
  using Stamp = std::tuple<const void*, vtkMTimeType>;
  bool Replace(std::vector<Stamp> stamps);

  std::vector<Stamp>
    Stamps; // of the dataset and of what the mesh consists of; pointers are compared only
  std::uint64_t Fingerprint = 0;
  bool Comparable = false; // the fingerprint is that of the last time, and tells all
};

/** The values that a selection reads. */
class ValueIdentity
{
public:
  /** True unless these are the values of the last time. `data` is what holds the array. */
  bool Changes(vtkDataSet* data, const ScalarSelection& selection);
  void Forget() { *this = ValueIdentity(); }

private:
  using Place = std::tuple<bool, bool, int, vtkIdType,
    double>; // there is one, on cells, component, number of values, headroom
  std::tuple<const void*, vtkMTimeType, const void*, vtkMTimeType> Stamp;
  Place Last;
  std::uint64_t Fingerprint = 0;
  bool Known = false;
};

/**
 * Fingerprint of an array's values, without its name; 0 for none. The same for any number of
 * threads.
 */
std::uint64_t FingerprintOf(vtkDataArray* array);

} // namespace nephoscope

#endif
