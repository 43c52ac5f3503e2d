// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TextureOutput.h"

#include "GlobeColumns.h"
#include "GridStretch.h"
#include "OwnThreads.h"

#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRectilinearGrid.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStructuredGrid.h"

#include <algorithm>

namespace nephoscope
{
namespace
{
bool ExtentOf(vtkDataSet* data, std::array<int, 6>& extent)
{
  const auto get = [&](auto* grid) {
    if (grid)
    {
      grid->GetExtent(extent.data());
    }
    return grid != nullptr;
  };
  return get(vtkImageData::SafeDownCast(data)) || get(vtkRectilinearGrid::SafeDownCast(data)) ||
    get(vtkStructuredGrid::SafeDownCast(data));
}
}

OutputPiece::OutputPiece(vtkInformation* output, vtkDataSet* data, bool needsNeighbours)
  : CutsAfterwards(needsNeighbours)
{
  using SDDP = vtkStreamingDemandDrivenPipeline;
  std::array<int, 6> whole{};
  if (!data || !ExtentOf(data, whole) || !output->Has(SDDP::UPDATE_EXTENT()))
  {
    return;
  }
  output->Get(SDDP::UPDATE_EXTENT(), this->Extent.data());
  for (std::size_t a = 0; a < 6; a += 2)
  {
    this->Extent[a] = std::max(this->Extent[a], whole[a]);
    this->Extent[a + 1] = std::min(this->Extent[a + 1], whole[a + 1]);
  }
  this->IsPart = this->Extent != whole;
}

vtkSmartPointer<vtkDataSet> OutputPiece::Of(vtkDataSet* whole) const
{
  auto part = vtkSmartPointer<vtkDataSet>::Take(whole->NewInstance());
  part->ShallowCopy(whole);
  if (!this->CutsAfterwards)
  {
    this->Crop(part);
  }
  return part;
}

void OutputPiece::Crop(vtkDataSet* output) const
{
  std::array<int, 6> present{};
  if (this->IsPart && ExtentOf(output, present) && present != this->Extent)
  {
    const bool isEmpty = this->Extent[0] > this->Extent[1] || this->Extent[2] > this->Extent[3] ||
      this->Extent[4] > this->Extent[5];
    if (isEmpty)
    {
      output->Initialize();
      return;
    }
    output->Crop(this->Extent.data());
  }
}

bool OutputPiece::Differs(std::array<int, 6>& extent) const
{
  const std::array<int, 6> mine =
    this->IsPart && !this->CutsAfterwards ? this->Extent : std::array<int, 6>{};
  const bool differs = mine != extent;
  extent = mine;
  return differs;
}

void AddCoordinates(const char* name, const std::vector<double>& places,
  const std::vector<float>& displacements, vtkDataSet* output)
{
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetName(name);
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(output->GetNumberOfPoints());
  float* values = coordinates->GetPointer(0);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    values[i] = static_cast<float>(places[i] + displacements[i]);
  }
  output->GetPointData()->AddArray(coordinates);
}

void AddFieldValues(const char* name, const double* values, int count, vtkDataSet* output)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfTuples(count);
  std::copy(values, values + count, array->GetPointer(0));
  output->GetFieldData()->AddArray(array);
}

void AddUnits(const TextureUnits& units, vtkDataSet* output)
{
  vtkNew<vtkIntArray> frame;
  frame->SetName("TextureFrame");
  frame->InsertNextValue(units.OnGlobe ? 0 : 1);
  output->GetFieldData()->AddArray(frame);
  AddFieldValues("TextureOrigin", units.Origin, 3, output);
  AddFieldValues("TextureLength", &units.Length, 1, output);
}

StretchWriter::StretchWriter(const TextureFlow& flow, vtkDataSet* output)
  : Output(output)
  , Horizontal(flow.IsOnGlobe())
  , Angles(flow.Units().OnGlobe)
  , Places(flow.GridCoordinates(output))
{
  std::array<int, 6> extent{};
  if (!ExtentOf(output, extent))
  {
    return;
  }
  for (std::size_t a = 0; a < 3; ++a)
  {
    this->Points[a] = extent[2 * a + 1] - extent[2 * a] + 1;
  }
  const auto& dimensions = this->Points;
  if (this->Horizontal)
  {
    const auto first = this->PositionOf(&this->Places[0]);
    const auto last =
      this->PositionOf(&this->Places[3 * static_cast<std::size_t>(dimensions[0] - 1)]);
    const std::size_t middle =
      static_cast<std::size_t>(dimensions[0]) * static_cast<std::size_t>(dimensions[1] / 2);
    const auto a = this->PositionOf(&this->Places[3 * middle]);
    const auto b =
      this->PositionOf(&this->Places[3 * (middle + static_cast<std::size_t>(dimensions[0] - 1))]);
    const auto distance = [](const auto& p, const auto& q) {
      return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
    };
    this->Closed = dimensions[0] > 3 && distance(first, last) < 1e-6 && distance(a, b) < 1e-6;
  }
}

// On a globe as a unit vector.
std::array<double, 3> StretchWriter::PositionOf(const double place[3]) const
{
  if (this->Angles)
  {
    const double longitude = TURN * place[0];
    const double latitude = TURN * place[1];
    return { std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
      std::sin(latitude) };
  }
  const double length =
    this->Horizontal ? std::max(std::hypot(place[0], place[1], place[2]), 1e-300) : 1.0;
  return { place[0] / length, place[1] / length, place[2] / length };
}

std::vector<double> StretchWriter::Stretches(const std::vector<float>& displacements) const
{
  const std::size_t count = this->Places.size() / 3;
  std::vector<std::array<double, 3>> from(count);
  std::vector<std::array<double, 3>> to(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    double place[3];
    for (std::size_t c = 0; c < 3; ++c)
    {
      place[c] = this->Places[3 * i + c] + displacements[3 * i + c];
    }
    from[i] = this->PositionOf(&this->Places[3 * i]);
    to[i] = this->PositionOf(place);
  }
  const GridStretch stretch({ this->Points, this->Horizontal ? 2 : 3, this->Closed }, from, to);
  std::vector<double> stretches(count);
  InParallel(
    static_cast<vtkIdType>(count),
    [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType p = begin; p < end; ++p)
      {
        const vtkIdType row = p / this->Points[0];
        stretches[static_cast<std::size_t>(p)] = stretch.At({ static_cast<int>(p % this->Points[0]),
          static_cast<int>(row % this->Points[1]), static_cast<int>(row / this->Points[1]) });
      }
    },
    2048);
  return stretches;
}

void StretchWriter::AddExponents(const std::vector<double>& stretches, double age) const
{
  vtkNew<vtkFloatArray> exponents;
  exponents->SetName("FiniteTimeLyapunovExponent");
  exponents->SetNumberOfTuples(static_cast<vtkIdType>(stretches.size()));
  for (std::size_t i = 0; i < stretches.size(); ++i)
  {
    exponents->SetValue(
      static_cast<vtkIdType>(i), static_cast<float>(LyapunovExponent(stretches[i], age)));
  }
  this->Output->GetPointData()->AddArray(exponents);
}

void StretchWriter::AddWeights(const std::vector<double>& first, const std::vector<double>& second,
  const double weights[2], double limit) const
{
  vtkNew<vtkFloatArray> array;
  array->SetName("TextureWeights");
  array->SetNumberOfComponents(2);
  array->SetNumberOfTuples(static_cast<vtkIdType>(first.size()));
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    const double a = weights[0] * WeightLeft(first[i], limit);
    const double b = weights[1] * WeightLeft(second[i], limit);
    const auto fraction = static_cast<float>(a / (a + b));
    array->SetTypedComponent(static_cast<vtkIdType>(i), 0, fraction);
    array->SetTypedComponent(static_cast<vtkIdType>(i), 1, 1.0f - fraction);
  }
  this->Output->GetPointData()->AddArray(array);
}
}
