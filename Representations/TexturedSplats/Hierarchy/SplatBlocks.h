// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * In which blocks samples are put together.
 *
 * Samples of a structured grid have its indices, voxels of a sparse volume theirs, counted from a
 * multiple of 4096: blocks are then parts, or unions, of the leaves and nodes of the volume's own
 * tree (8, 128 and 4096 voxels to a side, Museth2013). Others have the indices of small cubes of
 * space, of which 2^21 are along the longest edge of their bounds.
 */
#ifndef nephoscope_SplatBlocks_h
#define nephoscope_SplatBlocks_h

#include "BlockOrder.h"
#include "SplatMatrix.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace nephoscope
{

struct SplatClasses;
struct SplatSamples;

class SplatBlocks
{
public:
  /** Blocks of the samples that are in the classes. */
  SplatBlocks(const SplatSamples& samples, const SplatClasses& classes);

  const BlockOrder& GetOrder() const { return this->Order; }
  BlockOrder::Index IndexOf(std::size_t sample) const;

private:
  enum class Kind
  {
    Grid,
    Voxels,
    Space
  };

  bool UseVoxels();
  void UseSpace();
  std::array<double, 3> VoxelIndex(std::size_t sample) const;
  template <typename Place>
  void FindRange(Place placeOf, Vector3& low, Vector3& high) const;

  const SplatSamples& Samples;
  const SplatClasses& Classes;
  Kind As = Kind::Space;
  BlockOrder Order{ { { 1, 1, 1 } }, { { 1.0, 1.0, 1.0 } } };
  SplatMatrix ToVoxels{};
  Vector3 Corner{}; // index of a voxel, or a place, that is block 0
  double BlocksPerLength = 0.0;
};

} // namespace nephoscope

#endif
