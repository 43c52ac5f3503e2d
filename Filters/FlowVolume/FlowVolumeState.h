// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// What vtkFlowVolume keeps between updates.
#ifndef nephoscope_FlowVolumeState_h
#define nephoscope_FlowVolumeState_h

#include "SeriesReading.h"
#include "StreakVolume.h"
#include "VelocityFields.h"

#include "vtkDataObject.h"
#include "vtkSmartPointer.h"

#include <memory>
#include <vector>

namespace nephoscope
{
constexpr double buildingShare = 0.9; // of the time, about; the rest is interpolating arrays

// The velocity of a dataset, and what its polygon and automatic settings are made from.
struct FlowField
{
  std::unique_ptr<const DataSetField> Field;
  vtkSmartPointer<vtkDataObject> Data; // a shared copy, which the field refers to
  VelocityArray Velocity;
  double Diagonal = 0.0;    // of the bounds
  double BlankedSize = 0.0; // of the smallest blanked cell; 0: none
  vtkMTimeType MTime = 0;   // of the data when the field was made

  bool IsOf(vtkMTimeType newest, const VelocityArray& velocity) const
  {
    return this->MTime == newest && this->Velocity.Name == velocity.Name &&
      this->Velocity.OnCells == velocity.OnCells;
  }
};

// Velocities that are not finite numbers.
struct MissingVelocities
{
  vtkIdType Missing = 0;
  vtkIdType All = 0;
};

// The part of a time series that has been read, and the smoke at that time.
struct StreakState
{
  std::shared_ptr<const FlowField>
    First; // of the step before the last one read; null before two have been read
  std::shared_ptr<const FlowField> Second; // of the last step read
  int LastRead = -1;
  std::unique_ptr<StreakVolume> Volume; // null before the start time
  Vector3 Normal{};
  double PolygonEdgeLength = 0.0;
  double TimeUnit = 1.0;     // of the pipeline, in s, if the data tell it
  bool WasStill = false;     // nothing has flowed at the last steps read,
  double StillUntil = 0.0;   // up to this time, in s
  MissingVelocities Missing; // of the time step read that has most of them
  double MissingTime = 0.0;  // of that, in the unit of the pipeline
  bool IsCoarser = false;    // polygon or time step, than asked for
  vtkMTimeType MTime = 0;    // of the pipeline when it was begun
};

// What the automatic duration and time step of steady smoke follow from; found once for all times
// of a series.
struct CrossingTime
{
  double Seconds = 0.0;    // in which the flow at the polygon crosses the data; 0: not yet found
  vtkMTimeType Change = 0; // of the pipeline, when it was found
};

struct FlowVolumeState : SeriesReading
{
  CrossingTime Crossing;
  std::shared_ptr<const FlowField> Field; // of the last input
  StreakState Streak;
  vtkMTimeType ToldOfNoSmoke = 0; // of the pipeline, when it was told; also below
  vtkMTimeType ToldOfNoData = 0;
  vtkMTimeType ToldOfMissing = 0;
  vtkMTimeType ToldOfObstacles = 0;
  vtkMTimeType ToldOfTimeScale = 0;
};
}

#endif
