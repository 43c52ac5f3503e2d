// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// What vtkTextureCoordinateAdvection keeps between updates.
#ifndef nephoscope_TextureState_h
#define nephoscope_TextureState_h

#include "BackwardPaths.h"
#include "SeriesReading.h"
#include "TextureFlow.h"
#include "TextureSets.h"

#include "vtkDataSet.h"
#include "vtkSmartPointer.h"

#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <tuple>
#include <vector>

namespace nephoscope
{
// A time step that has been read.
struct ReadStep
{
  std::unique_ptr<WindField> Wind;
  vtkSmartPointer<vtkDataSet> Data; // a shared copy; null where only the wind is needed
};

// The time steps that a request needs: winds from the first to the last, all arrays from `Whole`
// on.
struct NeededSteps
{
  int First = 0;
  int Last = 0;
  int Whole = 0;
};

// Where a set's coordinates come from: displacements at two ages, computed at these times.
struct SetPlan
{
  double Birth = 0.0;
  double Times[2] = { 0.0, 0.0 };
  double Weight = 0.0; // of the second
};

using Displacements = std::vector<float>; // three for each point, in texture units; empty: none
using DisplacementKey =
  std::tuple<int, double, double>; // set, birth, time: at a birth there are an old and a new one

inline bool IsPositive(double value)
{
  return value > 0.0 && std::isfinite(value);
}

struct TextureState : SeriesReading
{
  std::unique_ptr<TextureFlow> Flow;
  WindArrays Arrays;
  std::map<int, ReadStep> Steps;
  std::map<DisplacementKey, Displacements>
    Keys; // of the present frame; of the grid at key times, kept for the next
  std::array<int, 6> KeyExtent{}; // of the grid's points that they belong to
  vtkMTimeType MTime = 0;         // of the pipeline when these were begun

  NeededSteps Needed;
  bool SharesSource = false; // the points come of the same source as the winds
  bool ReadsPoints = false;  // this pass is for the points only
  bool HasToldOfMissing = false;
  vtkMTimeType Failed = 0; // for ReportOnce

  double UsualPeriod = 0.0;       // of the first time step
  vtkMTimeType UsualPeriodOf = 0; // MTime of the pipeline when it was found

  void Forget()
  {
    this->Flow.reset();
    this->Steps.clear();
    this->Keys.clear();
    this->HasToldOfMissing = false;
  }
};
}

#endif
