// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Points that are moved by the winds of a series: on a globe (GlobeFlow), or in a box
// (CartesianFlow).
#ifndef nephoscope_TextureFlow_h
#define nephoscope_TextureFlow_h

#include "PathSettings.h"
#include "VelocityFields.h"

#include <memory>
#include <string>
#include <vector>

class vtkDataSet;

namespace nephoscope
{
// The winds of one time. Only the flow that has made it looks inside.
struct WindField
{
  virtual ~WindField() = default;
  std::int64_t Missing = 0; // points without a wind
};

// A step through winds that are linear in time between two fields. At the fraction 0 they are the
// earlier field, at 1 the later.
struct FlowStep
{
  const WindField* Earlier;
  const WindField* Later;
  double FromFraction;
  double ToFraction;
  double Seconds; // negative: back in time
};

// Where one texture unit is how long, see README.md.
struct TextureUnits
{
  bool OnGlobe = false; // longitude, latitude, height; else Cartesian
  double Origin[3] = { 0.0, 0.0, 0.0 };
  double Length = 1.0;
};

// What a wind is made from.
struct WindArrays
{
  VelocityArray Velocity;
  std::string Pressure; // optional: the vertical coordinate of a globe, with
  std::string Omega;    // its rate
};

class TextureFlow
{
public:
  virtual ~TextureFlow() = default;

  // Null, and a sentence in `problem`, if the data have no winds or are not of the same grid as the
  // first.
  virtual std::unique_ptr<WindField> MakeField(
    vtkDataSet* data, const WindArrays& arrays, std::string& problem) = 0;

  // Puts the parcels on the points of a dataset. `present`: the winds at that time.
  virtual void Begin(vtkDataSet* points, const FlowStep& present) = 0;

  virtual void Advance(const FlowStep& step) = 0;

  // From the points to where the parcels are, in texture units, three for each point. `present`:
  // the winds by now.
  virtual void Displacements(const FlowStep& present, std::vector<float>& displacements) = 0;

  // Three texture coordinates of each point of a dataset itself.
  virtual std::vector<double> GridCoordinates(vtkDataSet* points) const = 0;

  virtual TextureUnits Units() const = 0;
  virtual bool IsOnGlobe() const = 0; // whatever the units
  virtual std::size_t Count() const = 0;
};
}

#endif
