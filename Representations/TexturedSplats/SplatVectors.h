// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The vectors of splats and how far their patterns have moved.
 *
 * The pattern of a splat moves along its vector by speed * time: its phase, in periods, is added to in steps, so that it does not
 * jump when the wind changes. Every splat starts at a phase of its own, which hides the lattice of the samples.
 */
#ifndef SplatVectors_h
#define SplatVectors_h

#include "vtkType.h"

#include <array>
#include <cstdint>
#include <vector>

class vtkDataArray;

namespace nephoscope
{

struct SplatClasses;
struct SplatSamples;

class SplatVectors
{
public:
  /** The vectors of all samples; values that are not finite become 0. Phases stay where the number of samples does. */
  void Read(vtkDataArray* vectors, const SplatSamples& samples);

  /** Moves all patterns on by a time, in the units of the vectors' speed; `period`: length of the pattern in cells. */
  void Advance(double time, double period, const SplatSamples& samples);

  /** Patterns at a share of a loop, in which each moves a whole number of periods: at most `cycles`, in proportion to its speed. */
  void SetLoop(double share, int cycles);

  float GreatestSpeed() const { return this->Greatest; }

  /** (x, y, z, phase) of the samples that are drawn. */
  std::vector<std::array<float, 4>> Pack(const SplatClasses& classes) const;

private:
  std::vector<std::array<float, 3>> Vectors;
  std::vector<float> Starts; // of the phases
  std::vector<float> Moved;  // periods, in [0, 1)
  double LoopShare = 0;
  int LoopCycles = 0;
  float Greatest = 0;
};

} // namespace nephoscope

#endif
