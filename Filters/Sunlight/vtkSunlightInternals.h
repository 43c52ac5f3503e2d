// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** What the parts of vtkSunlight share. */
#ifndef vtkSunlightInternals_h
#define vtkSunlightInternals_h

#include "vtkSunlight.h"

#include "JoinedClouds.h"
#include "LitData.h"
#include "Vector3.h"

#include "vtkDataSet.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkType.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

struct vtkSunlight::Work
{
  nephoscope::Planet Planet;
  std::array<double, 3> Sun;
  bool Repeats = false; // the data are the grid of a RepeatedGrid
  std::vector<nephoscope::Place> Places;
  std::vector<float> Extinction, Scaled, Albedo, Asymmetry; // the last two scaled
  std::vector<float> Transmittance, ScaledDepth;
  // The medium of the diffuse light lacks this share of the forward peak, g^2, where that which is
  // drawn lacks all; its depth towards the sun.
  double Taken = 1;
  std::vector<float> DiffuseDepth;
  // By clouds of the second input, if there are any: the fraction of sunlight; the irradiance of
  // surfaces, negative where it is that of the open sky.
  std::vector<float> Shadow, BelowClouds;
  std::vector<float> Fluence, Up, Down, Absorbed, SecondMoment;

  void StartDiffuse()
  {
    for (std::vector<float>* one :
      { &this->Fluence, &this->Up, &this->Down, &this->Absorbed, &this->SecondMoment })
    {
      one->assign(this->Places.size(), 0.0f);
    }
    this->Flux.assign(this->Places.size(), nephoscope::Vector{ { 0, 0, 0 } });
  }
  std::vector<nephoscope::Vector> Flux;

  /** The light at some of its points, without their places. */
  Work At(const std::vector<std::int32_t>& numbers) const
  {
    Work at;
    at.Planet = this->Planet;
    at.Sun = this->Sun;
    const auto take = [&numbers](const auto& from, auto& to) {
      to.resize(from.empty() ? 0 : numbers.size()); // empty: without shading clouds, for example
      for (std::size_t p = 0; p < to.size(); ++p)
      {
        to[p] = from[numbers[p]];
      }
    };
    for (const auto member : { &Work::Extinction, &Work::Scaled, &Work::Albedo, &Work::Asymmetry,
           &Work::Transmittance, &Work::ScaledDepth, &Work::Shadow, &Work::BelowClouds,
           &Work::Fluence, &Work::Up, &Work::Down, &Work::Absorbed, &Work::SecondMoment })
    {
      take(this->*member, at.*member);
    }
    take(this->Flux, at.Flux);
    return at;
  }
};

/** Clouds of several blocks or ranks. */
struct vtkSunlight::Joint
{
  nephoscope::JoinedClouds Clouds;
  std::vector<double> State; // that they were joined for
  std::unique_ptr<Work> Light;
  bool Told = false; // the warnings about the light
};

namespace nephoscope
{

// Residues of a model's arithmetic are no cloud: divided by such an extinction, rounding errors of
// the light would count as light.
inline void CutResidues(std::vector<float>& extinction)
{
  constexpr float faintest = 1e-7f; // of the greatest
  const auto greatest = std::max_element(extinction.begin(), extinction.end());
  const float limit = greatest == extinction.end() ? 0.0f : faintest * *greatest;
  std::replace_if(
    extinction.begin(), extinction.end(), [limit](float one) { return one < limit; }, 0.0f);
}

inline vtkFloatArray* AddPointArray(vtkDataSet* data, const char* name)
{
  vtkNew<vtkFloatArray> array;
  array->SetName(name);
  array->SetNumberOfTuples(data->GetNumberOfPoints());
  data->GetPointData()->AddArray(array);
  return array;
}

} // namespace nephoscope

#endif
