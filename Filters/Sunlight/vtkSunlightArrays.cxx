// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The arrays that it writes, for one eye or for all.
#include "vtkSunlight.h"

#include "DirectionalLight.h"
#include "OwnThreads.h"
#include "PhaseFunction.h"
#include "Vector3.h"
#include "WhiteLight.h"
#include "vtkSunlightInternals.h"

#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <array>
#include <cmath>

using nephoscope::AddPointArray;
using nephoscope::Dot;

// Light straight from the sun is scattered with the whole phase function, that which has been
// scattered straight on before with what makes two scatterings exact (README.md).
double vtkSunlight::PhaseTowardsEye(const Work& work, std::size_t p, double cosine) const
{
  const double scaled = work.Asymmetry[p], light = std::exp(-double(work.ScaledDepth[p]));
  if (!this->MultipleScattering || !(light > 0))
  {
    return nephoscope::HenyeyGreenstein(scaled, cosine);
  }
  const double whole = scaled / (1 - scaled); // the asymmetry parameter that was scaled
  const double straight = std::min(work.Transmittance[p] / light, 1.0);
  return straight * nephoscope::HenyeyGreenstein(whole, cosine) / (1 - whole * whole) +
    (1 - straight) * nephoscope::AfterForwardScattering(whole, cosine);
}

void vtkSunlight::Write(vtkDataSet* data, const Work& work)
{
  vtkFloatArray* light = AddPointArray(data, "Sunlight");
  vtkFloatArray* extinction = AddPointArray(data, "ScaledExtinction");
  vtkFloatArray* transmittance = AddPointArray(data, "SunTransmittance");
  vtkFloatArray* irradiance = AddPointArray(data, "Irradiance");
  vtkFloatArray* upward = AddPointArray(data, "UpwardIrradiance");
  vtkFloatArray* absorbed = AddPointArray(data, "AbsorbedLight");
  nephoscope::InParallel(data->GetNumberOfPoints(), [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType p = begin; p < end; ++p)
    {
      const std::array<double, 3> up = work.Planet.UpAt(work.Places[p]);
      double beam = 1, directed = 0; // of diffuse light, that which depends on the direction
      const double shadow = work.Shadow.empty() ? 1.0 : work.Shadow[p];
      const double sunlight = shadow * std::exp(-work.ScaledDepth[p]);
      if (this->UseViewPosition && !this->FollowCamera)
      {
        std::array<double, 3> toEye = { { this->ViewPosition[0], this->ViewPosition[1],
          this->ViewPosition[2] } };
        for (int c = 0; c < 3 && !this->ParallelView; ++c)
        {
          toEye[c] -= work.Places[p][c];
        }
        const double length = std::max(std::sqrt(Dot(toEye, toEye)), 1e-300);
        beam = this->PhaseTowardsEye(work, p, -Dot(toEye, work.Sun) / length);
        directed = 3 * work.Asymmetry[p] *
            (toEye[0] * work.Flux[p][0] + toEye[1] * work.Flux[p][1] + toEye[2] * work.Flux[p][2]) /
            length +
          nephoscope::SecondMomentFactor(work.Asymmetry[p]) *
            nephoscope::SecondLegendre(Dot(toEye, up) / length) * work.SecondMoment[p];
      }
      const double source =
        0.25 * work.Albedo[p] * std::max(work.Fluence[p] + directed + beam * sunlight, 0.0);
      extinction->SetValue(p, work.Scaled[p]);
      transmittance->SetValue(p, static_cast<float>(shadow * work.Transmittance[p]));
      const bool isBelow = this->OnSurface && !work.BelowClouds.empty() && work.BelowClouds[p] >= 0;
      const double arriving = isBelow
        ? work.BelowClouds[p]
        : std::max(std::max(Dot(up, work.Sun), 0.0) * sunlight + work.Down[p], 0.0);
      irradiance->SetValue(p, static_cast<float>(arriving));
      light->SetValue(p, static_cast<float>(this->OnSurface ? arriving : source));
      upward->SetValue(p, work.Up[p]);
      absorbed->SetValue(p, work.Absorbed[p]);
    }
  });
  if (this->FollowCamera)
  {
    nephoscope::AddDirectionalLight(data,
      { work.Extinction, work.Albedo, work.Asymmetry, work.Transmittance, work.ScaledDepth,
        work.Shadow, work.Flux, work.SecondMoment, this->MultipleScattering },
      static_cast<nephoscope::PhaseKind>(this->PhaseFunction));
  }
  nephoscope::AddWhiteLight(data, work.Sun);
  data->GetPointData()->SetActiveScalars("Sunlight");
  const auto addDirection = [data](const char* name, const std::array<double, 3>& direction) {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->SetNumberOfComponents(3);
    array->InsertNextTuple(direction.data());
    data->GetFieldData()->AddArray(array);
  };
  addDirection("SunDirection", work.Sun);
  addDirection("Up", work.Planet.Up);
}
