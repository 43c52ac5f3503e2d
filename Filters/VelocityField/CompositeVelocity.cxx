// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CompositeVelocity.h"

#include "ArrayInterpolation.h"
#include "DataSets.h"

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

#include <algorithm>

namespace nephoscope
{
namespace
{
// Calls `use(begin, end)` for every run of candidates of one leaf, after sorting them by leaf.
template <typename Candidates, typename Use>
void ForEachLeaf(Candidates& candidates, const Use& use)
{
  std::stable_sort(candidates.begin(), candidates.end(),
    [](const auto& a, const auto& b) { return a.Leaf < b.Leaf; });
  for (std::size_t begin = 0; begin < candidates.size();)
  {
    std::size_t end = begin;
    while (end < candidates.size() && candidates[end].Leaf == candidates[begin].Leaf)
    {
      ++end;
    }
    use(candidates.data() + begin, candidates.data() + end);
    begin = end;
  }
}
}

CompositeVelocity::CompositeVelocity(std::vector<Leaf> leaves)
  : Leaves(std::move(leaves))
{
  std::stable_sort(this->Leaves.begin(), this->Leaves.end(),
    [](const Leaf& a, const Leaf& b) { return a.Level > b.Level; });
}

// Goes on to the next leaf that may hold the position; false if there is none.
bool CompositeVelocity::Advance(Candidate& candidate, const Vector3& position) const
{
  const auto count = static_cast<std::int32_t>(this->Leaves.size());
  const auto leaf = [this](std::int32_t i) -> const Leaf& {
    return this->Leaves[static_cast<std::size_t>(i)];
  };
  while (candidate.Next < count)
  {
    const bool atHome = candidate.Home >= 0 && candidate.Home < count &&
      leaf(candidate.Home).Level == leaf(candidate.Next).Level;
    if (atHome && !candidate.HomeTried)
    {
      candidate.HomeTried = true;
      candidate.Leaf = candidate.Home;
      return true;
    }
    candidate.Leaf = candidate.Next++;
    if (!(atHome && candidate.Leaf == candidate.Home) &&
      leaf(candidate.Leaf).Bounds.Holds(position))
    {
      return true;
    }
  }
  return false;
}

void CompositeVelocity::SampleGroup(
  const SampleBatch& batch, const Candidate* begin, const Candidate* end) const
{
  const auto count = static_cast<std::size_t>(end - begin);
  std::vector<Vector3> positions(count);
  std::vector<Vector3> velocities(count);
  std::vector<CellHint> hints(count);
  std::vector<unsigned char> inside(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    positions[i] = batch.Positions[begin[i].Position];
    if (begin[i].Leaf == begin[i].Home)
    {
      hints[i] = batch.Hints[begin[i].Position];
    }
  }
  const Leaf& leaf = this->Leaves[static_cast<std::size_t>(begin->Leaf)];
  leaf.Field->Sample(
    { count, positions.data(), batch.Time, velocities.data(), inside.data(), hints.data() });
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::size_t position = begin[i].Position;
    batch.Inside[position] = inside[i];
    if (inside[i])
    {
      batch.Velocities[position] = velocities[i];
      CellHint& hint = batch.Hints[position];
      hint.Cell = hints[i].Cell;
      hint.Parametric = hints[i].Parametric;
      hint.Block = begin->Leaf;
    }
  }
}

void CompositeVelocity::Sample(const SampleBatch& batch) const
{
  std::vector<Candidate> candidates(batch.Count);
  for (std::size_t i = 0; i < batch.Count; ++i)
  {
    const CellHint& hint = batch.Hints[i];
    batch.Inside[i] = 0;
    candidates[i] = { i, hint.Cell >= 0 ? hint.Block : -1, false, 0, 0 };
  }
  while (!candidates.empty())
  {
    const auto exhausted =
      std::remove_if(candidates.begin(), candidates.end(), [&](Candidate& candidate) {
        return batch.Inside[candidate.Position] ||
          !this->Advance(candidate, batch.Positions[candidate.Position]);
      });
    candidates.erase(exhausted, candidates.end());
    ForEachLeaf(candidates,
      [&](const Candidate* begin, const Candidate* end) { this->SampleGroup(batch, begin, end); });
  }
}

// Every array of any leaf, as outside; the first leaf that has a name decides on the type.
void CompositeVelocity::MakeArrays(std::size_t count, vtkPointData* output) const
{
  for (const Leaf& leaf : this->Leaves)
  {
    for (int a = 0; a < leaf.Arrays->GetNumberOfArrays(); ++a)
    {
      vtkDataArray* source = leaf.Arrays->GetArray(a);
      if (!IsInterpolated(leaf.Arrays, a) || !source->GetName() ||
        output->HasArray(source->GetName()))
      {
        continue;
      }
      auto array = vtk::TakeSmartPointer(source->NewInstance());
      array->SetName(source->GetName());
      array->SetNumberOfComponents(source->GetNumberOfComponents());
      array->SetNumberOfTuples(static_cast<vtkIdType>(count));
      for (std::size_t i = 0; i < count; ++i)
      {
        SetOutside(array, static_cast<vtkIdType>(i));
      }
      output->AddArray(array);
    }
  }
}

void CompositeVelocity::SampleArrays(
  std::size_t count, const Vector3* positions, const CellHint* hints, vtkPointData* output) const
{
  this->MakeArrays(count, output);
  std::vector<CellHint> found(hints, hints + count);
  std::vector<Vector3> velocities(count);
  std::vector<unsigned char> inside(count);
  this->Sample({ count, positions, 0.0, velocities.data(), inside.data(), found.data() });
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < count; ++i)
  {
    if (inside[i])
    {
      candidates.push_back({ i, found[i].Block, true, 0, found[i].Block });
    }
  }
  ForEachLeaf(candidates, [&](const Candidate* begin, const Candidate* end) {
    std::vector<Vector3> part;
    std::vector<CellHint> partHints;
    for (const Candidate* c = begin; c != end; ++c)
    {
      part.push_back(positions[c->Position]);
      partHints.push_back(found[c->Position]);
    }
    vtkNew<vtkPointData> values;
    this->Leaves[static_cast<std::size_t>(begin->Leaf)].Field->SampleArrays(
      part.size(), part.data(), partHints.data(), values);
    for (int a = 0; a < values->GetNumberOfArrays(); ++a)
    {
      vtkDataArray* source = values->GetArray(a);
      vtkDataArray* target = source->GetName() ? output->GetArray(source->GetName()) : nullptr;
      if (!target || target->GetNumberOfComponents() != source->GetNumberOfComponents())
      {
        continue;
      }
      for (const Candidate* c = begin; c != end; ++c)
      {
        target->SetTuple(static_cast<vtkIdType>(c->Position), c - begin, source);
      }
    }
  });
}

bool CompositeVelocity::IsInGhostCell(const CellHint& found) const
{
  return this->Leaves[static_cast<std::size_t>(found.Block)].Field->IsInGhostCell(found);
}
}
