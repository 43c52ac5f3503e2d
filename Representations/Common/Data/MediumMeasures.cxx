// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MediumMeasures.h"

#include "vtkDataArray.h"
#include "vtkPiecewiseFunction.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>

namespace nephoscope
{
namespace
{
constexpr double pi = 3.14159265358979323846;

// The share of the corners of the bounds that the medium fills.
double FilledCorners(const std::array<double, 8>& reach)
{
  const double round = std::sqrt(3.0);
  double sum = 0.0;
  for (const double one : reach)
  {
    sum += std::min(std::max((one - round) / (3.0 - round), 0.0), 1.0);
  }
  return sum / 8.0;
}
} // namespace

void ExtendBounds(MediumBounds& bounds, const double place[3])
{
  if (!std::isfinite(place[0] + place[1] + place[2]))
  {
    return;
  }
  const bool first = bounds[0] > bounds[1];
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    bounds[2 * axis] = first ? place[axis] : std::min(bounds[2 * axis], place[axis]);
    bounds[2 * axis + 1] = first ? place[axis] : std::max(bounds[2 * axis + 1], place[axis]);
  }
}

void MediumMeasures::AddPlace(
  const MediumBounds& frame, const double place[3], const double half[3])
{
  double low[3], high[3]; // -1 to 1 in the frame
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double side = 0.5 * (frame[2 * axis + 1] - frame[2 * axis]);
    const double x = place[axis] - 0.5 * (frame[2 * axis] + frame[2 * axis + 1]);
    low[axis] = side > 0.0 ? (x - half[axis]) / side : -1.0;
    high[axis] = side > 0.0 ? (x + half[axis]) / side : 1.0;
  }
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    double reach = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      reach += corner >> axis & 1 ? high[axis] : -low[axis];
    }
    this->Reach[corner] = std::max(this->Reach[corner], reach);
  }
}

void MediumMeasures::AddPart(const MediumBounds& frame, const Part& part)
{
  this->Volume += part.Volume;
  if (!std::isfinite(part.Scalar))
  {
    return;
  }
  const double scalar = part.Volume * part.Scalar;
  const double opacity = part.Volume * part.Opacity;
  this->FiniteVolume += part.Volume;
  this->ScalarIntegral += scalar;
  this->OpacityIntegral += opacity;
  this->Projections.Add(frame, part.Box, { { part.Volume, scalar, opacity } });
}

void MediumMeasures::Scale(double factor)
{
  for (double* one : { &this->Volume, &this->FiniteVolume, &this->ScalarIntegral,
         &this->OpacityIntegral, &this->Silhouettes })
  {
    *one *= factor;
  }
  for (double& pixel : this->Projections.GetPixels())
  {
    pixel *= factor;
  }
}

double ScalarOf(vtkDataArray* scalars, vtkIdType tuple)
{
  const int components = scalars->GetNumberOfComponents();
  if (components == 1)
  {
    return scalars->GetComponent(tuple, 0);
  }
  double sum = 0.0;
  for (int c = 0; c < components; ++c)
  {
    sum += scalars->GetComponent(tuple, c) * scalars->GetComponent(tuple, c);
  }
  return std::sqrt(sum);
}

double MeanChordOf(const MediumMeasures& measures, const MediumBounds& b)
{
  const double size[3] = { b[1] - b[0], b[3] - b[2], b[5] - b[4] };
  const double faces = size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
  const double filled = FilledCorners(measures.Reach);
  const double silhouette = (filled + (1.0 - filled) * pi / 6.0) * 0.5 * faces;
  return measures.Volume > 0.0 && silhouette > 0.0 ? measures.Volume / silhouette : 0.0;
}

double MeanSamples(const MediumMeasures& measures, const MediumBounds& common)
{
  return measures.Volume > 0.0
    ? MeanChordOf(measures, common) * measures.Silhouettes / measures.Volume
    : 0.0;
}

double MeanRamp(const MediumMeasures& measures)
{
  const double low = measures.ScalarRange[0];
  const double high = measures.ScalarRange[1];
  if (!(high > low) || measures.Volume <= 0.0)
  {
    return 0.5;
  }
  const double integral = measures.ScalarIntegral - low * measures.FiniteVolume;
  return std::min(std::max(integral / measures.Volume / (high - low), 0.0), 1.0);
}

void FindFiniteRange(vtkDataArray* array, double range[2])
{
  const auto values = vtkSmartPointer<vtkDataArray>::Take(array->NewInstance());
  values->ShallowCopy(array); // without what is known of it
  values->GetFiniteRange(range, values->GetNumberOfComponents() > 1 ? -1 : 0);
}

std::function<double(double)> FullOpacity(vtkPiecewiseFunction* function)
{
  double greatest = 0.0;
  for (int i = 0; function && i < function->GetSize(); ++i)
  {
    double node[4];
    function->GetNodeValue(i, node);
    greatest = std::max(greatest, node[1]);
  }
  if (!(greatest > 0.0))
  {
    return {};
  }
  return [function, greatest](double scalar) { return function->GetValue(scalar) / greatest; };
}

double DefaultUnitDistance(const MediumMeasures& measures, const MediumBounds& common, bool ramp)
{
  if (!(measures.Volume > 0.0))
  {
    return 0.0;
  }
  const double opacity = ramp ? MeanRamp(measures) : measures.OpacityIntegral / measures.Volume;
  const double localization = ramp ? measures.Projections.Localization(measures.ScalarRange)
                                   : measures.Projections.Localization();
  const double distance = MeanChordOf(measures, common) * opacity / meanOpticalDepth *
    std::max(localization / localOpticalDepth, 1.0);
  return std::isfinite(distance) ? distance : 0.0;
}

} // namespace nephoscope
