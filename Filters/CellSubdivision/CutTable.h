// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** Points where edges cross values: what names them, and a hash table that numbers them. */
#ifndef nephoscope_CutTable_h
#define nephoscope_CutTable_h

#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

namespace nephoscope
{

/** The point where the edge between two points crosses a value; First < Second. */
template <typename Id>
struct Cut
{
  Id First;
  Id Second;
  int Level;

  bool operator==(const Cut& other) const
  {
    return this->First == other.First && this->Second == other.Second && this->Level == other.Level;
  }
  bool operator<(const Cut& other) const
  {
    return std::tie(this->First, this->Second, this->Level) <
      std::tie(other.First, other.Second, other.Level);
  }
};

/** Numbers cuts in the order in which they are first requested. Open addressing, linear probing. */
template <typename Id>
class CutTable
{
public:
  std::size_t Number(const Cut<Id>& cut)
  {
    if (2 * this->Cuts.size() >= this->Slots.size())
    {
      this->Grow();
    }
    const std::size_t mask = this->Slots.size() - 1;
    std::size_t slot = Hash(cut) & mask;
    while (this->Slots[slot] != 0)
    {
      if (this->Cuts[this->Slots[slot] - 1] == cut)
      {
        return this->Slots[slot] - 1;
      }
      slot = (slot + 1) & mask;
    }
    this->Cuts.push_back(cut);
    this->Slots[slot] = this->Cuts.size();
    return this->Cuts.size() - 1;
  }

  /** By number; leaves the table empty. */
  std::vector<Cut<Id>> TakeCuts()
  {
    std::vector<Cut<Id>> cuts;
    cuts.swap(this->Cuts);
    this->Slots.assign(this->Slots.size(), 0);
    return cuts;
  }

private:
  static std::size_t Hash(const Cut<Id>& cut)
  {
    std::uint64_t h = static_cast<std::uint64_t>(cut.First) * 0x9E3779B97F4A7C15u;
    h = (h ^ (h >> 29)) + static_cast<std::uint64_t>(cut.Second) * 0xBF58476D1CE4E5B9u;
    h = (h ^ (h >> 31)) + static_cast<std::uint64_t>(cut.Level) * 0x94D049BB133111EBu;
    return static_cast<std::size_t>(h ^ (h >> 32));
  }

  void Grow()
  {
    std::vector<std::size_t> slots(this->Slots.empty() ? 256 : 2 * this->Slots.size(), 0);
    const std::size_t mask = slots.size() - 1;
    for (std::size_t i = 0; i < this->Cuts.size(); ++i)
    {
      std::size_t slot = Hash(this->Cuts[i]) & mask;
      while (slots[slot] != 0)
      {
        slot = (slot + 1) & mask;
      }
      slots[slot] = i + 1;
    }
    this->Slots.swap(slots);
  }

  std::vector<Cut<Id>> Cuts;
  std::vector<std::size_t> Slots; // number + 1, 0: free
};

} // namespace nephoscope

#endif
