// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The vectors of splats and how far their patterns have moved.
 *
 * The pattern of a splat moves along its vector by speed * time: its phase, in periods, is added to
 * in steps, so that it does not jump when the wind changes. Every splat starts at a phase of its
 * own, which hides the lattice of the samples.
 */
#ifndef nephoscope_SplatVectors_h
#define nephoscope_SplatVectors_h

#include "SampleIds.h"
#include "SplatSeed.h"
#include "SplatSpeeds.h"

#include "vtkType.h"

#include <array>
#include <cstdint>
#include <vector>

class vtkDataArray;
class vtkDataSet;

namespace nephoscope
{

struct SplatClasses;
struct SplatSamples;

/**
 * Where in a loop of pictures the patterns are, or how far they are at the speed of their vectors.
 */
struct SplatLoop
{
  double Share = 0;          ///< 0 to 1
  int Cycles = 4;            ///< periods that the fastest pattern moves in a loop
  int Steps = 0;             ///< stored patterns in a period; 0: any phase
  double MaximumSpeed = 0;   ///< that counts as the fastest; 0: that of the data
  double VectorFraction = 1; ///< of the samples whose vectors are drawn
  double Period = 0;         ///< true speed: length of the pattern, in units of the data; 0: a loop
  double Time = 0; ///< true speed: since the start of the film, in the unit of the vectors
  bool operator==(const SplatLoop& other) const
  {
    return this->Share == other.Share && this->Cycles == other.Cycles &&
      this->Steps == other.Steps && this->MaximumSpeed == other.MaximumSpeed &&
      this->VectorFraction == other.VectorFraction && this->Period == other.Period &&
      this->Time == other.Time;
  }
};

class SplatVectors
{
public:
  /**
   * The vectors of all samples; values that are not finite become 0. Where the input has as many
   * points or cells as before, each of them goes on from where its pattern was.
   */
  void Read(vtkDataSet* data, bool onCells, vtkDataArray* vectors, const SplatSamples& samples);

  /**
   * Moves all patterns on by a time, in the units of the vectors' speed; `period`: length of the
   * pattern.
   */
  void Advance(double time, double period);

  /**
   * At true speed, to be called before other vectors are read: patterns go on from where they are
   * in the picture of `last`.
   * Where `next` is the start of the film, they start anew.
   */
  void KeepMotion(const SplatLoop& last, const SplatLoop& next);

  /** Points or cells of the same number go on from where the patterns of `other` are. */
  void GoOnFrom(const SplatVectors& other)
  {
    this->Moved = other.Moved;
    this->KeptTime = other.KeptTime;
  }

  /** At which vectors are fully drawn. */
  float MaximumSpeed() const { return this->Full; }
  const SpeedCounts& GetSpeeds() const { return this->Speeds; }
  /** Samples whose vector is not finite. */
  std::size_t GetNumberNotFinite() const { return this->NotFinite; }

  /** Mean length of a sample's cell along its vector; 1 without vectors. */
  double MeanCell() const { return this->Cell; }

  ///@{
  /** The same of the first vectors of as many points or cells, which do not change with time. */
  float FirstMaximumSpeed() const { return this->FirstFull; }
  double FirstMeanCell() const { return this->FirstCell; }
  ///@}

  /** At true speed: how many periods a pattern of speed 1 has moved since the vectors were read. */
  double PeriodsPerSpeed(const SplatLoop& loop) const
  {
    return loop.Period > 0 ? (loop.Time - this->KeptTime) / loop.Period : 0.0;
  }

  /** (x, y, z, phase) of the samples that are drawn; phases in [0, 1). */
  std::vector<std::array<float, 4>> Pack(const SplatClasses& classes, const SplatLoop& loop) const;

  /** A number in [0, 1) that is a sample's own. */
  float SeedOf(std::size_t sample) const { return this->Seeds[sample].Rest; }

private:
  bool IsShown(std::size_t sample, double share) const;
  double PhaseOf(std::size_t sample, double speed, double greatest, const SplatLoop& loop) const;

  std::vector<std::array<float, 3>> Vectors;
  std::vector<SplatSeed> Seeds;
  SampleIds Ids;
  std::vector<double> Moved; // by each point or cell, in periods, in [0, 1)
  double KeptTime = 0;       // until which `Moved` holds the motion at true speed
  SpeedCounts Speeds;
  std::size_t NotFinite = 0;
  float Full = 0, FirstFull = 0;
  double Cell = 1, FirstCell = 1;
};

} // namespace nephoscope

#endif
