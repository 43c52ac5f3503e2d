// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DirectionalLight.h"

#include "OwnThreads.h"

#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>

namespace nephoscope
{
namespace
{
// A Henyey-Greenstein function has one asymmetry parameter for all: the mean of the extinction.
double MeanAsymmetry(const DirectionalSource& source)
{
  double sum = 0, weights = 0;
  for (std::size_t p = 0; p < source.Extinction.size(); ++p)
  {
    const double g = source.Asymmetry[p];
    sum += source.Extinction[p] * (source.Scales ? g / (1 - g) : g); // before scaling
    weights += source.Extinction[p];
  }
  return weights > 0 ? std::max(-0.99, std::min(0.99, sum / weights)) : 0.0;
}
}

void AddDirectionalLight(vtkDataSet* data, const DirectionalSource& source, PhaseKind kind)
{
  const vtkIdType count = data->GetNumberOfPoints();
  vtkNew<vtkFloatArray> single, flux, moment, phase;
  single->SetName("SingleScattering");
  single->SetNumberOfComponents(2);
  single->SetNumberOfTuples(count);
  flux->SetName("DiffuseFlux");
  flux->SetNumberOfComponents(3);
  flux->SetNumberOfTuples(count);
  moment->SetName("DiffuseSecondMoment");
  moment->SetNumberOfTuples(count);
  InParallel(count, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType p = begin; p < end; ++p)
    {
      const float shadow = source.Shadow.empty() ? 1.0f : source.Shadow[p];
      const float scaled = std::exp(-source.ScaledDepth[p]);
      const float direct = std::min(source.Transmittance[p], scaled);
      const float light = 0.25f * source.Albedo[p] * shadow;
      single->SetTypedComponent(p, 0, light * direct);
      single->SetTypedComponent(p, 1, light * (scaled - direct));
      moment->SetValue(p,
        source.SecondMoment.empty() ? 0.0f
                                    : 0.25f * source.Albedo[p] *
            SecondMomentFactor(source.Asymmetry[p]) * source.SecondMoment[p]);
      const float forward = 0.75f * source.Albedo[p] * source.Asymmetry[p];
      for (int c = 0; c < 3; ++c)
      {
        flux->SetTypedComponent(
          p, c, source.Flux.empty() ? 0.0f : forward * source.Flux[p][std::size_t(c)]);
      }
    }
  });
  const auto factors = PhaseFactors(PhaseTable(kind, MeanAsymmetry(source)), source.Scales);
  phase->SetName("PhaseFunction");
  phase->SetNumberOfComponents(2);
  for (const std::array<float, 2>& pair : factors)
  {
    phase->InsertNextTuple(pair.data());
  }
  data->GetPointData()->AddArray(single);
  data->GetPointData()->AddArray(flux);
  data->GetPointData()->AddArray(moment);
  data->GetFieldData()->AddArray(phase);
}
}
