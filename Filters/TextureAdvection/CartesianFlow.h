// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nephoscope_CartesianFlow_h
#define nephoscope_CartesianFlow_h

#include "Particles.h"
#include "TextureFlow.h"

namespace nephoscope
{
// Points in any dataset, moved along straight axes. Beyond the border, and in holes, the wind is
// that at the nearest position with a wind.
class CartesianFlow : public TextureFlow
{
public:
  // `length`: of a texture unit; 0: the width of the first dataset.
  CartesianFlow(vtkDataSet* first, const PathSettings& settings, double length);
  ~CartesianFlow() override;

  std::unique_ptr<WindField> MakeField(
    vtkDataSet* data, const WindArrays& arrays, std::string& problem) override;
  void Begin(vtkDataSet* points, const FlowStep& present) override;
  void Advance(const FlowStep& step) override;
  void Displacements(const FlowStep& present, std::vector<float>& displacements) override;
  std::vector<double> GridCoordinates(vtkDataSet* points) const override;
  TextureUnits Units() const override { return this->Units_; }
  bool IsOnGlobe() const override { return false; }
  std::size_t Count() const override { return this->Positions.size(); }

private:
  struct Field;

  PathSettings Settings;
  TextureUnits Units_;
  std::vector<Vector3> Starts;
  std::vector<Vector3> Positions;
  std::vector<CellHint> Hints;
  std::vector<unsigned char> Inside;
};
}

#endif
