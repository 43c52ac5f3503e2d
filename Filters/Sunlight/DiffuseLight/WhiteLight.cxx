// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "WhiteLight.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace nephoscope
{
namespace
{
constexpr double withoutClouds = 0.6, least = 0.15, most = 1.2;

// The mean of P - 1 over the directions of view with the sun behind the camera.
double MeanFactorBehind(vtkDataArray* factors, int component)
{
  const vtkIdType steps = factors->GetNumberOfTuples() - 1;
  double sum = 0, weights = 0;
  for (vtkIdType i = (steps + 1) / 2; i <= steps; ++i)
  {
    const double weight = std::sin(3.14159265358979323846 * double(i) / double(steps));
    sum += weight * (factors->GetComponent(i, component) - 1);
    weights += weight;
  }
  return weights > 0 ? sum / weights : 0;
}

/** What light towards cameras with the sun behind them adds to the mean of all directions. */
struct LightBehind
{
  vtkDataArray* Single;
  vtkDataArray* Flux;
  std::array<double, 3> Sun;
  std::array<double, 2> Factors = { { 0, 0 } };

  LightBehind(vtkDataSet* data, const std::array<double, 3>& sun)
    : Single(data->GetPointData()->GetArray("SingleScattering"))
    , Flux(data->GetPointData()->GetArray("DiffuseFlux"))
    , Sun(sun)
  {
    vtkDataArray* phase = data->GetFieldData()->GetArray("PhaseFunction");
    this->Single = this->Flux && phase && phase->GetNumberOfTuples() > 1 ? this->Single : nullptr;
    for (int c = 0; c < 2 && this->Single; ++c)
    {
      this->Factors[std::size_t(c)] = MeanFactorBehind(phase, c);
    }
  }

  double At(vtkIdType p) const
  {
    if (!this->Single)
    {
      return 0;
    }
    double flux = 0;
    for (int c = 0; c < 3; ++c)
    {
      flux += this->Flux->GetComponent(p, c) * this->Sun[std::size_t(c)];
    }
    return 0.5 * flux + // the mean cosine over a hemisphere is a half
      this->Factors[0] * this->Single->GetComponent(p, 0) +
      this->Factors[1] * this->Single->GetComponent(p, 1);
  }
};

double WhiteLight(vtkDataSet* data, const std::array<double, 3>& sun)
{
  vtkDataArray* light = data->GetPointData()->GetArray("Sunlight");
  vtkDataArray* extinction = data->GetPointData()->GetArray("ScaledExtinction");
  const double inCloud = 0.02 * std::max(extinction->GetRange(0)[1], 0.0);
  const LightBehind behind(data, sun);
  std::vector<double> seen;
  for (vtkIdType p = 0; p < data->GetNumberOfPoints(); ++p)
  {
    if (extinction->GetComponent(p, 0) > inCloud)
    {
      seen.push_back(light->GetComponent(p, 0) + behind.At(p));
    }
  }
  if (seen.empty())
  {
    return withoutClouds;
  }
  const auto place = seen.begin() + static_cast<std::ptrdiff_t>(0.98 * double(seen.size() - 1));
  std::nth_element(seen.begin(), place, seen.end());
  return std::min(std::max(1.1 * *place, least), most);
}
}

void AddWhiteLight(vtkDataSet* data, const std::array<double, 3>& sun)
{
  vtkNew<vtkDoubleArray> white;
  white->SetName("WhiteLight");
  white->InsertNextValue(WhiteLight(data, sun));
  data->GetFieldData()->AddArray(white);
}
}
