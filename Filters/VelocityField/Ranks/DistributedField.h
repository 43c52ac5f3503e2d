// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// One velocity field of data that are spread over the ranks of a parallel program (MPI by
// vtkMultiProcessController).
#ifndef nephoscope_DistributedField_h
#define nephoscope_DistributedField_h

#include "VelocityFields.h"

#include <vector>

class vtkMultiProcessController;

namespace nephoscope
{
class SharedArrays;

// The rank that has answered a position before asks its cells first; positions that have left it,
// or are new, are asked of all ranks. Elected is the lowest rank that finds the position in a cell
// of its own; if there is none, the lowest that finds it in a ghost cell, a copy of another rank's:
// ghost cells close gaps of rounding between the ranks, and change nothing else.
// The answer of the elected rank, bit for bit, is the answer on every rank.
//
// Two or three small exchanges a call (who answers; who answers what is left; the answers) and not
// one: a minimum finds the lowest rank and a bitwise or copies the answer, so neither depends on
// the order in which ranks are combined.
class VTKNEPHOSCOPEFILTERSVELOCITYFIELD_EXPORT DistributedField : public DataSetField
{
public:
  // `local` is null on a rank without a field, and not null on at least one rank.
  DistributedField(std::unique_ptr<DataSetField> local, vtkMultiProcessController* controller);
  ~DistributedField() override;

  // Together on all ranks, with the same positions. Hints refer to cells of this rank; if another
  // rank has answered, the hint names no cell.
  void Sample(const SampleBatch& batch) const override;

  // Together on all ranks; every rank with positions of its own. Arrays that some ranks are without
  // are NaN there, or 0. Hints are not used.
  void SampleArrays(std::size_t count, const Vector3* positions, const CellHint* hints,
    vtkPointData* output) const override;

  bool IsInGhostCell(const CellHint&) const override
  {
    return false;
  } // of no rank but the elected one
  bool IsLocal() const override { return false; }

private:
  void SampleLocally(const SampleBatch& batch, const std::vector<std::size_t>& some) const;
  int Bid(const SampleBatch& batch, std::size_t i) const;
  void Elect(const SampleBatch& batch, const std::vector<std::size_t>& some, int accepted,
    std::vector<int>& elected) const;
  std::vector<int> SampleAndElect(const SampleBatch& batch) const;
  std::vector<unsigned char> AnswerArrays(
    const std::vector<Vector3>& positions, const SharedArrays& arrays) const;

  std::unique_ptr<DataSetField> Local;
  vtkMultiProcessController* Controller;
};
}

#endif
