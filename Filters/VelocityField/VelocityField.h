// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// What particles are moved by: a velocity at a position and a time. Plain C++17, no VTK object.
#ifndef nephoscope_VelocityField_h
#define nephoscope_VelocityField_h

#include "Vector3.h"

#include <cstddef>
#include <cstdint>

namespace nephoscope
{
// Where a particle was found last; the next search starts there. A hint changes the cost, never the
// result beyond rounding. A field takes any hint, also one of another field: it is checked, not
// trusted.
struct CellHint
{
  std::int64_t Cell = -1; // none yet
  std::int32_t Block = 0; // of a field in several blocks
  Vector3 Parametric{ { 0.5, 0.5, 0.5 } };
  std::int64_t SecondCell = -1; // of the later of two fields, see TemporalField.h
  std::int32_t SecondBlock = 0;
};

// Some positions, at one time or each at its own. Batches let a field that is spread over ranks
// answer with one exchange.
struct SampleBatch
{
  std::size_t Count = 0;
  const Vector3* Positions = nullptr;
  double Time = 0.0;
  Vector3* Velocities = nullptr;   // written where inside
  unsigned char* Inside = nullptr; // written: 1 inside a visible cell with finite values, else 0
  CellHint* Hints = nullptr;       // read and written
  const double* Times = nullptr;   // if set, the time of each position, in place of Time

  double TimeOf(std::size_t i) const { return this->Times ? this->Times[i] : this->Time; }
};

class VelocityField
{
public:
  virtual ~VelocityField() = default;

  virtual void Sample(const SampleBatch& batch) const = 0;

  // False if all ranks must call Sample together, with the same positions, from one thread.
  virtual bool IsLocal() const { return true; }
};
}

#endif
