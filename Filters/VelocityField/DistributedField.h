// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// One velocity field of data that are spread over the ranks of a parallel program (MPI by vtkMultiProcessController).
#ifndef nephoscope_DistributedField_h
#define nephoscope_DistributedField_h

#include "VelocityFields.h"

#include <vector>

class vtkMultiProcessController;

namespace nephoscope
{
class SharedArrays;

// Every rank asks its own cells for all positions. Then the ranks elect one that answers each position, and its answer,
// bit for bit, is the answer on every rank. Elected is the lowest rank that finds the position in a cell of its own; if
// there is none, the lowest that finds it in a ghost cell, a copy of another rank's. So ghost cells close gaps of
// rounding between the ranks, and change nothing else.
//
// Two small exchanges a call (who answers; the answers) and not one: a minimum finds the lowest rank and a bitwise or
// copies the answer, so neither depends on the order in which the ranks are combined.
class VTKNEPHOSCOPEFILTERSVELOCITYFIELD_EXPORT DistributedField : public DataSetField
{
public:
  // `local` is null on a rank without cells, and not null on at least one rank.
  DistributedField(std::unique_ptr<DataSetField> local, vtkMultiProcessController* controller);
  ~DistributedField() override;

  // Together on all ranks, with the same positions; hints are of this rank.
  void Sample(const SampleBatch& batch) const override;

  // Together on all ranks; every rank with positions of its own. Arrays that are missing on a rank with cells, or
  // are of another type there, are left out. Hints are not used.
  void SampleArrays(std::size_t count, const Vector3* positions, const CellHint* hints,
    vtkPointData* output) const override;

  bool IsInGhostCell(const CellHint&) const override { return false; } // of no rank but the elected one
  bool IsLocal() const override { return false; }

private:
  void SampleLocally(const SampleBatch& batch) const;
  std::vector<int> ElectRanks(const SampleBatch& sampled) const;
  std::vector<unsigned char> AnswerArrays(
    const std::vector<Vector3>& positions, const SharedArrays& arrays) const;

  std::unique_ptr<DataSetField> Local;
  vtkMultiProcessController* Controller;
};
}

#endif
