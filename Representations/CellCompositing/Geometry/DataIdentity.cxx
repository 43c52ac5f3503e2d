// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DataIdentity.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <utility>

namespace nephoscope
{
namespace
{
// One round of mixing: multiplication carries low bits up, the shift brings high bits down.
std::uint64_t Mixed(std::uint64_t hash, std::uint64_t word)
{
  hash = (hash ^ word) * 0x9E3779B97F4A7C15u;
  return hash ^ (hash >> 29);
}

constexpr std::size_t pieceSize = std::size_t(1)
  << 13; // words or values that are mixed one after another

/** word(i) for i in [0, n), in pieces that threads share. */
template <typename Word>
std::uint64_t MixedWords(std::size_t n, Word word)
{
  std::vector<std::uint64_t> pieces((n + pieceSize - 1) / pieceSize);
  vtkSMPTools::For(0, static_cast<vtkIdType>(pieces.size()), [&](vtkIdType begin, vtkIdType end) {
    for (std::size_t piece = static_cast<std::size_t>(begin); piece < static_cast<std::size_t>(end);
         ++piece)
    {
      std::uint64_t hash = piece;
      for (std::size_t i = piece * pieceSize; i < std::min(n, (piece + 1) * pieceSize); ++i)
      {
        hash = Mixed(hash, word(i));
      }
      pieces[piece] = hash;
    }
  });
  std::uint64_t hash = n;
  for (const std::uint64_t piece : pieces)
  {
    hash = Mixed(hash, piece);
  }
  return hash;
}

std::uint64_t MixedBytes(const unsigned char* bytes, std::size_t size)
{
  constexpr std::size_t width = sizeof(std::uint64_t);
  return MixedWords((size + width - 1) / width, [=](std::size_t i) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes + i * width, std::min(width, size - i * width));
    return word;
  });
}

std::uint64_t BitsOf(double value)
{
  std::uint64_t bits;
  std::memcpy(&bits, &value, sizeof(bits));
  return bits;
}

/** What a mesh consists of; null members do not exist. */
struct MeshParts
{
  explicit MeshParts(vtkUnstructuredGrid* grid)
    : Grid(grid)
    , Cells(grid->GetCells())
    , Arrays({ { grid->GetPoints() ? grid->GetPoints()->GetData() : nullptr,
        this->Cells ? this->Cells->GetOffsetsArray() : nullptr,
        this->Cells ? this->Cells->GetConnectivityArray() : nullptr, grid->GetCellGhostArray(),
        grid->GetPointGhostArray() } })
  {
  }

  vtkUnstructuredGrid* Grid;
  vtkCellArray* Cells;
  std::array<vtkDataArray*, 5> Arrays;

  /** False where there are polyhedra, whose faces are not looked at. */
  bool FindFingerprint(std::uint64_t& result) const
  {
    std::uint64_t hash = 0;
    for (vtkDataArray* array : this->Arrays)
    {
      hash = Mixed(hash, FingerprintOf(array));
    }
    std::atomic<bool> polyhedra(false);
    const std::size_t n = static_cast<std::size_t>(this->Grid->GetNumberOfCells());
    result = Mixed(hash, MixedWords(n, [&](std::size_t i) {
      const int type = this->Grid->GetCellType(static_cast<vtkIdType>(i));
      if (type == VTK_POLYHEDRON)
      {
        polyhedra = true;
      }
      return static_cast<std::uint64_t>(type);
    }));
    return !polyhedra;
  }
};
}

std::uint64_t FingerprintOf(vtkDataArray* array)
{
  if (!array || array->GetNumberOfValues() == 0)
  {
    return 0;
  }
  const std::size_t n = static_cast<std::size_t>(array->GetNumberOfValues());
  const std::uint64_t kind = static_cast<std::uint64_t>(array->GetDataType());
  if (array->HasStandardMemoryLayout())
  {
    const auto* bytes = static_cast<const unsigned char*>(array->GetVoidPointer(0));
    return Mixed(kind, MixedBytes(bytes, n * static_cast<std::size_t>(array->GetDataTypeSize())));
  }
  const std::size_t components = static_cast<std::size_t>(array->GetNumberOfComponents());
  return Mixed(kind, MixedWords(n, [=](std::size_t i) {
    return BitsOf(array->GetComponent(
      static_cast<vtkIdType>(i / components), static_cast<int>(i % components)));
  }));
}

bool MeshIdentity::Changes(vtkDataSet* data)
{
  auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
  std::vector<Stamp> stamps = { Stamp(
    data, grid ? data->vtkObject::GetMTime() : data->GetMTime()) };
  if (!grid)
  {
    return this->Replace(std::move(stamps));
  }
  const MeshParts parts(grid);
  stamps.emplace_back(
    parts.Cells, parts.Cells ? parts.Cells->GetMTime() : 0); // the dataset's time does not tell
  stamps.emplace_back(grid->GetPoints(), grid->GetPoints() ? grid->GetPoints()->GetMTime() : 0);
  for (vtkDataArray* array : parts.Arrays)
  {
    stamps.emplace_back(array, array ? array->GetMTime() : 0);
  }
  if (!this->Replace(std::move(stamps)))
  {
    return false;
  }
  const bool comparable = this->Comparable;
  const std::uint64_t last = this->Fingerprint;
  this->Comparable = parts.FindFingerprint(this->Fingerprint);
  return !comparable || !this->Comparable || this->Fingerprint != last;
}

// True where the times are not those of the last time. Without parts there is no fingerprint to
// compare with.
bool MeshIdentity::Replace(std::vector<Stamp> stamps)
{
  if (stamps == this->Stamps)
  {
    return false;
  }
  this->Comparable = this->Comparable && stamps.size() > 1;
  this->Stamps.swap(stamps);
  return true;
}

bool ValueIdentity::Changes(vtkDataSet* data, const ScalarSelection& selection)
{
  vtkDataArray* array = selection.Array;
  const Place place(array != nullptr, array && selection.OnCells, array ? selection.Component : 0,
    array ? array->GetNumberOfValues() : 0, selection.Headroom);
  const decltype(this->Stamp) stamp(
    array, array ? array->GetMTime() : 0, data, data->vtkObject::GetMTime());
  if (this->Known && place == this->Last && stamp == this->Stamp)
  {
    return false;
  }
  const std::uint64_t now = FingerprintOf(array);
  const bool same = this->Known && place == this->Last && now == this->Fingerprint;
  this->Known = true;
  this->Last = place;
  this->Stamp = stamp;
  this->Fingerprint = now;
  return !same;
}

} // namespace nephoscope
