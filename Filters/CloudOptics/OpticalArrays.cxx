// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpticalArrays.h"

#include "CloudColumn.h"
#include "ParticleOptics.h"
#include "Planet.h"
#include "StandardAtmosphere.h"

#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkRectilinearGrid.h"
#include "vtkSMPTools.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace nephoscope
{
namespace
{
constexpr double fillValue = 1e20; // and more: no value
constexpr double leastCover = 0.01;

vtkSmartPointer<vtkFloatArray> MakeArray(const char* name, vtkIdType count)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name);
  array->SetNumberOfTuples(count);
  return array;
}

bool IsValue(double value)
{
  return std::isfinite(value) && std::abs(value) < fillValue;
}

class PointOptics
{
public:
  PointOptics(vtkDataSet* data, const WaterFields& fields, const std::vector<double>& pressures,
    const OpticalSettings& settings)
    : Fields(fields)
    , Pressures(pressures)
    , Settings(settings)
    , Ghosts(fields.OnCells ? data->GetCellGhostArray() : data->GetPointGhostArray())
    , Hidden(fields.OnCells ? int(vtkDataSetAttributes::HIDDENCELL)
                            : int(vtkDataSetAttributes::HIDDENPOINT))
  {
  }

  std::atomic<vtkIdType> Negative{ 0 }, Missing{ 0 };

  bool IsHidden(vtkIdType i) const
  {
    return this->Ghosts && (this->Ghosts->GetValue(i) & this->Hidden);
  }

  particles::Optics At(vtkIdType i, double& liquidRadius, double& iceRadius)
  {
    double content[WaterFields::NumberOfWaters];
    for (int k = 0; k < WaterFields::NumberOfWaters; ++k)
    {
      content[k] = this->Content(static_cast<WaterFields::Kind>(k), i);
    }
    const double share = this->ShareOfIce(i, content[WaterFields::Total]);
    const double ice = content[WaterFields::Ice] + share * content[WaterFields::Total];
    const double liquid = content[WaterFields::Liquid] + (1 - share) * content[WaterFields::Total];
    const double cover = this->Cover(i);
    liquidRadius = this->LiquidRadius(i, liquid / cover);
    iceRadius = this->IceRadius(i, ice / cover);
    particles::Optics optics;
    particles::AddDroplets(optics, liquid, liquidRadius);
    particles::AddCrystals(optics, ice, iceRadius);
    particles::AddRain(optics, content[WaterFields::Rain]);
    particles::AddSnow(optics, content[WaterFields::Snow]);
    return optics;
  }

private:
  double TemperatureAt(vtkIdType i) const
  {
    const double t = this->Fields.Has(WaterFields::Temperature) ? this->Fields.Kelvin(i) : 273.15;
    return IsValue(t) && t > 0 ? t : 273.15;
  }

  // kg/m3; what cannot be is counted and 0.
  double Content(WaterFields::Kind kind, vtkIdType i)
  {
    if (!this->Fields.Has(kind))
    {
      return 0;
    }
    const double value = this->Fields.Value(kind, i) * KilogramsPer(this->Fields.Units[kind]);
    const double density = IsMixingRatio(this->Fields.Units[kind])
      ? atmosphere::Density(this->Pressures[i], this->TemperatureAt(i))
      : 1.0;
    const bool valid = IsValue(value) && IsValue(density);
    this->Missing += valid ? 0 : 1;
    this->Negative += valid && value < 0 ? 1 : 0;
    return valid && value > 0 ? value * density : 0.0;
  }

  double ShareOfIce(vtkIdType i, double total) const
  {
    return total > 0 ? particles::IceFraction(this->TemperatureAt(i)) : 0.0;
  }

  double Cover(vtkIdType i) const
  {
    const double cover = this->Fields.Has(WaterFields::CloudFraction)
      ? this->Fields.ToCover * this->Fields.Value(WaterFields::CloudFraction, i)
      : 1.0;
    return IsValue(cover) ? std::min(std::max(cover, leastCover), 1.0) : 1.0;
  }

  double LiquidRadius(vtkIdType i, double inCloud) const
  {
    if (this->Settings.ConstantLiquidRadius)
    {
      return this->Settings.LiquidRadius;
    }
    const bool land = this->Fields.Has(WaterFields::Land) &&
      this->Fields.ToLand * this->Fields.Value(WaterFields::Land, i) >= 0.5;
    return land ? particles::DropletRadius(inCloud, this->Settings.DropletsLand, 0.67)
                : particles::DropletRadius(inCloud, this->Settings.DropletsSea, 0.80);
  }

  double IceRadius(vtkIdType i, double inCloud) const
  {
    return this->Settings.ConstantIceRadius
      ? this->Settings.IceRadius
      : particles::CrystalRadius(inCloud, this->TemperatureAt(i));
  }

  const WaterFields& Fields;
  const std::vector<double>& Pressures;
  const OpticalSettings& Settings;
  vtkUnsignedCharArray* Ghosts;
  int Hidden;
};

void WriteOptics(
  PointOptics& optics, OpticalArrays& arrays, double exaggeration, vtkIdType begin, vtkIdType end)
{
  for (vtkIdType i = begin; i < end; ++i)
  {
    double liquidRadius = 0, iceRadius = 0;
    const particles::Optics here =
      optics.IsHidden(i) ? particles::Optics() : optics.At(i, liquidRadius, iceRadius);
    arrays.Extinction->SetValue(i, static_cast<float>(here.Extinction / exaggeration));
    arrays.Albedo->SetValue(i, static_cast<float>(here.Albedo()));
    arrays.Asymmetry->SetValue(i, static_cast<float>(here.Asymmetry()));
    arrays.LiquidRadius->SetValue(i, static_cast<float>(1e6 * liquidRadius));
    arrays.IceRadius->SetValue(i, static_cast<float>(1e6 * iceRadius));
  }
}

std::vector<double> PressuresOfArray(const WaterFields& fields)
{
  vtkDataArray* array = fields.Arrays[WaterFields::Pressure];
  std::vector<double> pressures(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (std::size_t i = 0; i < pressures.size(); ++i)
  {
    pressures[i] = fields.ToPascal * array->GetComponent(static_cast<vtkIdType>(i), 0);
  }
  return pressures;
}

struct Column
{
  std::vector<double> Heights, Temperatures;
};

// The numbers of the points of a column, from the ground up: heights of the air tell which end is
// below, also where places are in other units.
std::vector<vtkIdType> PointsOfColumn(
  const WaterFields& fields, const UprightOrder& order, std::size_t number)
{
  const std::size_t stride = std::size_t(order.GetSizes()[0]) * order.GetSizes()[1];
  std::vector<vtkIdType> points;
  for (int k = 0; k < order.GetSizes()[2]; ++k)
  {
    points.push_back(static_cast<vtkIdType>(order.NumberOf(number + k * stride)));
  }
  if (fields.Value(WaterFields::Height, points.front()) >
    fields.Value(WaterFields::Height, points.back()))
  {
    std::reverse(points.begin(), points.end());
  }
  return points;
}

Column ColumnAt(const WaterFields& fields, const std::vector<vtkIdType>& points)
{
  Column column;
  for (const vtkIdType p : points)
  {
    column.Heights.push_back(fields.Value(WaterFields::Height, p));
    if (fields.Has(WaterFields::Temperature))
    {
      column.Temperatures.push_back(fields.Kelvin(p));
    }
  }
  return column;
}

std::vector<double> BalancedPressures(const WaterFields& fields, const UprightOrder& order)
{
  const vtkIdType columns = vtkIdType(order.GetSizes()[0]) * order.GetSizes()[1];
  std::vector<double> pressures(static_cast<std::size_t>(columns * order.GetSizes()[2]));
  vtkSMPTools::For(0, columns, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end; ++i)
    {
      const std::vector<vtkIdType> points = PointsOfColumn(fields, order, std::size_t(i));
      const Column here = ColumnAt(fields, points);
      const std::vector<double> column = column::Pressures(here.Heights, here.Temperatures);
      for (std::size_t k = 0; k < points.size(); ++k)
      {
        pressures[points[k]] = column[k];
      }
    }
  });
  return pressures;
}

// Without columns there is no balance of a point's own air: the standard atmosphere, geopotential
// and geometric metres alike.
std::vector<double> StandardPressures(vtkDataArray* heights)
{
  std::vector<double> pressures(static_cast<std::size_t>(heights->GetNumberOfTuples()));
  for (std::size_t p = 0; p < pressures.size(); ++p)
  {
    pressures[p] = atmosphere::Pressure(heights->GetComponent(static_cast<vtkIdType>(p), 0));
  }
  return pressures;
}
}

UprightOrder ColumnsOf(vtkDataSet* data, bool onCells)
{
  int sizes[3] = { 0, 0, 0 };
  if (auto* image = vtkImageData::SafeDownCast(data))
  {
    image->GetDimensions(sizes);
  }
  else if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(data))
  {
    rectilinear->GetDimensions(sizes);
  }
  else if (auto* structured = vtkStructuredGrid::SafeDownCast(data))
  {
    structured->GetDimensions(sizes);
  }
  else
  {
    return {};
  }
  const auto placeOf = [data](std::size_t p) {
    Vector3 place;
    data->GetPoint(static_cast<vtkIdType>(p), place.data());
    return place;
  };
  const Planet planet = FindPlanet(data);
  const UprightOrder order({ { sizes[0], sizes[1], sizes[2] } }, placeOf,
    [&planet](const Vector3& place) { return planet.UpAt(place); });
  return onCells ? order.OfCells() : order;
}

std::vector<double> PressuresOf(vtkDataSet* data, const WaterFields& fields)
{
  if (!fields.NeedsPressure())
  {
    return {};
  }
  if (fields.Has(WaterFields::Pressure))
  {
    return PressuresOfArray(fields);
  }
  const UprightOrder order = ColumnsOf(data, fields.OnCells);
  if (fields.Has(WaterFields::Height) && order.GetSizes()[2] > 1)
  {
    return BalancedPressures(fields, order);
  }
  return StandardPressures(fields.Arrays[WaterFields::Height]);
}

OpticalArrays ComputeOptics(vtkDataSet* data, const WaterFields& fields,
  const std::vector<double>& pressures, const OpticalSettings& settings,
  const std::function<bool(double)>& progress)
{
  const vtkIdType count = fields.OnCells ? data->GetNumberOfCells() : data->GetNumberOfPoints();
  OpticalArrays arrays{ MakeArray("Extinction", count), MakeArray("SingleScatteringAlbedo", count),
    MakeArray("AsymmetryParameter", count), MakeArray("LiquidEffectiveRadius", count),
    MakeArray("IceEffectiveRadius", count) };
  PointOptics optics(data, fields, pressures, settings);
  const vtkIdType stretch = 200000;
  for (vtkIdType first = 0; first < count && progress(double(first) / count); first += stretch)
  {
    vtkSMPTools::For(first, std::min(count, first + stretch), [&](vtkIdType begin, vtkIdType end) {
      WriteOptics(optics, arrays, settings.Exaggeration, begin, end);
    });
  }
  arrays.Negative = optics.Negative;
  arrays.Missing = optics.Missing;
  return arrays;
}

void ComputeColumns(vtkDataSet* data, const UprightOrder& order, vtkFloatArray* extinction,
  vtkFloatArray* above, vtkFloatArray* whole)
{
  const int levels = order.GetSizes()[2];
  const std::size_t columns = std::size_t(order.GetSizes()[0]) * order.GetSizes()[1];
  std::vector<double> values(levels), lengths(levels - 1);
  std::vector<vtkIdType> points(levels);
  for (std::size_t i = 0; i < columns; ++i)
  {
    double last[3], next[3];
    for (int k = 0; k < levels; ++k)
    {
      points[k] = static_cast<vtkIdType>(order.NumberOf(i + k * columns));
      values[k] = extinction->GetValue(points[k]);
      data->GetPoint(points[k], next);
      if (k > 0)
      {
        lengths[k - 1] = std::sqrt(vtkMath::Distance2BetweenPoints(last, next));
      }
      std::copy(next, next + 3, last);
    }
    const std::vector<double> depth = column::OpticalDepthToEnd(values, lengths);
    for (int k = 0; k < levels; ++k)
    {
      above->SetValue(points[k], static_cast<float>(depth[k]));
      whole->SetValue(points[k], static_cast<float>(depth[0]));
    }
  }
}
}
