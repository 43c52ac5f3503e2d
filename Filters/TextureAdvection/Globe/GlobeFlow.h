// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nephoscope_GlobeFlow_h
#define nephoscope_GlobeFlow_h

#include "GlobeShape.h"
#include "GlobeSteps.h"
#include "TextureFlow.h"

namespace nephoscope
{
// Points on a globe, or on the map of one: they move on the sphere.
class GlobeFlow : public TextureFlow
{
public:
  // `firstColumn`: where the extent of the whole grid begins. `cartesian`: write Cartesian
  // coordinates.
  GlobeFlow(GlobeShape shape, int firstColumn, const PathSettings& settings, bool cartesian);
  ~GlobeFlow() override;

  std::unique_ptr<WindField> MakeField(
    vtkDataSet* data, const WindArrays& arrays, std::string& problem) override;
  void Begin(vtkDataSet* points, const FlowStep& present) override;
  void Advance(const FlowStep& step) override;
  void Displacements(const FlowStep& present, std::vector<float>& displacements) override;
  std::vector<double> GridCoordinates(vtkDataSet* points) const override;
  TextureUnits Units() const override;
  bool IsOnGlobe() const override { return true; }
  std::size_t Count() const override { return this->Parcels.size(); }

private:
  struct Field;
  struct Between;

  // A point, after it has been held above the ground.
  struct Start
  {
    double Place[3];  // texture coordinates
    double Longitude; // as the grid counts it
    double Angle;     // the same within a turn, as the direction has it; not a number at the poles
  };

  const GlobeWinds* WindsAt(const FlowStep& step, double fraction);
  void Place(const double direction[3], double height, double longitude, double place[3]) const;
  std::vector<double> Longitudes(vtkDataSet* points) const;
  static double LongitudeTravelled(const Start& start, const GlobeParcel& parcel);
  template <typename Function>
  void ForEachParcel(const Function& function);

  GlobeShape Shape;
  int FirstColumn;
  PathSettings Settings;
  bool Cartesian;
  std::vector<GlobeParcel> Parcels;
  std::vector<Start> Starts;
  std::vector<Between> Mixed; // winds between two times that have been made for the last step
};
}

#endif
