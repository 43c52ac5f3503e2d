// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The velocity field of several blocks.
#ifndef nephoscope_CompositeVelocity_h
#define nephoscope_CompositeVelocity_h

#include "GridBoxes.h"
#include "VelocityFields.h"

#include <vector>

namespace nephoscope
{
// A position belongs to the finest level that has it in a visible cell; within a level, to the
// block that already has the particle, otherwise to the first. Blocks that overlap at one level are
// expected to agree.
class CompositeVelocity : public DataSetField
{
public:
  struct Leaf
  {
    std::unique_ptr<DataSetField> Field;
    vtkPointData* Arrays = nullptr; // of the leaf's data
    Box Bounds;
    int Level = 0; // greater is finer
  };

  // Sorts the leaves, the finest first.
  explicit CompositeVelocity(std::vector<Leaf> leaves);

  void Sample(const SampleBatch& batch) const override;
  void SampleArrays(std::size_t count, const Vector3* positions, const CellHint* hints,
    vtkPointData* output) const override;
  bool IsInGhostCell(const CellHint& found) const override;

private:
  // A position that is looked for, and how far the search is.
  struct Candidate
  {
    std::size_t Position; // in the batch
    std::int32_t Home;    // the leaf of the hint
    bool HomeTried;
    std::int32_t Next; // leaf in order
    std::int32_t Leaf; // to be tried
  };

  bool Advance(Candidate& candidate, const Vector3& position) const;
  void SampleGroup(const SampleBatch& batch, const Candidate* begin, const Candidate* end) const;
  void MakeArrays(std::size_t count, vtkPointData* output) const;

  std::vector<Leaf> Leaves;
};
}

#endif
