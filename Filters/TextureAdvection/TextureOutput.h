// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// What vtkTextureCoordinateAdvection writes, and onto which part of the grid.
#ifndef nephoscope_TextureOutput_h
#define nephoscope_TextureOutput_h

#include "TextureFlow.h"

#include "vtkSmartPointer.h"

#include <array>

class vtkDataSet;
class vtkInformation;

namespace nephoscope
{
// The requested piece of a structured grid. Where neighbours are needed, the whole grid is followed
// and cut afterwards, so that a piece does not depend on how the grid is divided.
class OutputPiece
{
public:
  // `data` may be null: points, of which all are followed.
  OutputPiece(vtkInformation* output, vtkDataSet* data, bool needsNeighbours);

  vtkSmartPointer<vtkDataSet> Of(vtkDataSet* whole) const;
  void Crop(vtkDataSet* output) const;

  // Whether the points to be followed are others than those of an extent, which becomes this one.
  bool Differs(std::array<int, 6>& extent) const;

private:
  bool IsPart = false;
  bool CutsAfterwards = false;
  std::array<int, 6> Extent{};
};

void AddCoordinates(const char* name, const std::vector<double>& places,
  const std::vector<float>& displacements, vtkDataSet* output);
void AddFieldValues(const char* name, const double* values, int count, vtkDataSet* output);
void AddUnits(const TextureUnits& units, vtkDataSet* output);

// Deformation by the displacements of a set.
class StretchWriter
{
public:
  StretchWriter(const TextureFlow& flow, vtkDataSet* output);

  bool IsGrid() const { return this->Points[0] > 0; }
  std::vector<double> Stretches(const std::vector<float>& displacements) const;
  void AddExponents(const std::vector<double>& stretches, double age) const;
  void AddWeights(const std::vector<double>& first, const std::vector<double>& second,
    const double weights[2], double limit) const;

private:
  std::array<double, 3> PositionOf(const double place[3]) const;

  vtkDataSet* Output;
  std::array<int, 3> Points{ { 0, 0, 0 } };
  bool Horizontal;
  bool Closed = false;
  bool Angles; // places are longitudes and latitudes
  std::vector<double> Places;
};
}

#endif
