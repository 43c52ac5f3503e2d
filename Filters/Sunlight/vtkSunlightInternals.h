// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** What the parts of vtkSunlight share. */
#ifndef vtkSunlightInternals_h
#define vtkSunlightInternals_h

#include "vtkSunlight.h"

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
#include <vector>

struct vtkSunlight::Work
{
  nephoscope::Planet Planet;
  std::array<double, 3> Sun;
  bool Repeats = false; // on a RepeatedGrid
  std::vector<nephoscope::Place> Places;
  std::vector<float> Extinction, Scaled, Albedo, Asymmetry; // the last two scaled
  std::vector<float> Transmittance, ScaledDepth;
  // By clouds of the second input, if there are any: the fraction of sunlight; the irradiance of surfaces, negative where it is that of the open sky.
  std::vector<float> Shadow, BelowClouds;
  std::vector<float> Fluence, Up, Down, Absorbed;

  void StartDiffuse()
  {
    for (std::vector<float>* one : { &this->Fluence, &this->Up, &this->Down, &this->Absorbed })
    {
      one->assign(this->Places.size(), 0.0f);
    }
    this->Flux.assign(this->Places.size(), nephoscope::Vector{ { 0, 0, 0 } });
  }
  std::vector<nephoscope::Vector> Flux;
  vtkIdType Wrong = 0;
};

namespace nephoscope
{

// Residues of a model's arithmetic are no cloud: divided by such an extinction, rounding errors of the light would count as light.
inline void cutResidues(std::vector<float>& extinction)
{
  constexpr float faintest = 1e-7f; // of the greatest
  const auto greatest = std::max_element(extinction.begin(), extinction.end());
  const float limit = greatest == extinction.end() ? 0.0f : faintest * *greatest;
  std::replace_if(
    extinction.begin(), extinction.end(), [limit](float one) { return one < limit; }, 0.0f);
}

inline vtkFloatArray* addPointArray(vtkDataSet* data, const char* name)
{
  vtkNew<vtkFloatArray> array;
  array->SetName(name);
  array->SetNumberOfTuples(data->GetNumberOfPoints());
  data->GetPointData()->AddArray(array);
  return array;
}

} // namespace nephoscope

#endif
