// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Light that is scattered more than once.
#include "vtkSunlight.h"

#include "DiffuseLight.h"
#include "LitData.h"
#include "PhaseFunction.h"
#include "ThreadTeam.h"
#include "Vector3.h"
#include "vtkSunlightInternals.h"

#include "vtkDataSet.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

using nephoscope::AddPointArray;
using nephoscope::Dot;
using nephoscope::Vector;

namespace
{
// From the medium that is drawn to that of the diffuse light, which keeps more of the forward peak.
void ScaleForDiffuse(
  nephoscope::LightGrid& grid, const std::vector<float>& extinction, double taken)
{
  grid.Second.resize(grid.Points());
  for (std::size_t p = 0; p < grid.Points(); ++p)
  {
    const double g = grid.Asymmetry[p] / (1.0 - grid.Asymmetry[p]), peak = g * g;
    const double albedo = grid.Albedo[p] / (1 - peak + grid.Albedo[p] * peak);
    const nephoscope::ScaledMedium medium =
      nephoscope::Scaled(extinction[p], albedo, g, taken * peak);
    grid.Extinction[p] = static_cast<float>(medium.Extinction);
    grid.Albedo[p] = static_cast<float>(medium.Albedo);
    grid.Asymmetry[p] = static_cast<float>(medium.Asymmetry);
    grid.Second[p] = static_cast<float>(medium.Second);
  }
}
}

// On structured data; otherwise Sample has made some of it.
bool vtkSunlight::Diffuse(vtkDataSet* data, Work& work)
{
  nephoscope::LightGrid grid;
  nephoscope::GridAxes axes;
  if (!nephoscope::MakeGrid(data, work.Planet, work.Places, grid, axes))
  {
    return this->Sample(data, work);
  }
  grid.Closed[0] = grid.Closed[0] || work.Repeats;
  grid.Closed[1] = work.Repeats;
  grid.Open = this->OpenSides && !grid.Closed[0] && !grid.Closed[1];
  grid.Extinction = axes.Order.Of(work.Scaled);
  grid.Albedo = axes.Order.Of(work.Albedo);
  grid.Asymmetry = axes.Order.Of(work.Asymmetry);
  grid.Depth = axes.Order.Of(work.DiffuseDepth);
  ScaleForDiffuse(grid, axes.Order.Of(work.Extinction), work.Taken);
  grid.Shadow = axes.Order.Of(work.Shadow);
  grid.GroundAlbedo = this->GroundAlbedo;
  grid.Sun.resize(grid.Points());
  for (std::size_t p = 0; p < grid.Points(); ++p)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const Vector& e = axes.Axes[p][axis];
      grid.Sun[p][axis] =
        -static_cast<float>(e[0] * work.Sun[0] + e[1] * work.Sun[1] + e[2] * work.Sun[2]);
    }
  }
  grid.Sky.resize(grid.Columns());
  for (std::size_t c = 0; c < grid.Columns(); ++c)
  {
    grid.Sky[c] = this->SkyAt(work.Places[axes.Order.NumberOf(c)], work);
  }
  this->WarnOfSides(grid);
  nephoscope::LightSettings settings;
  settings.Angles = { this->ZenithAngles, this->AzimuthAngles };
  nephoscope::ThreadTeam team;
  const auto parallel = [&team](int n, const std::function<void(int)>& body) { team.Run(n, body); };
  const nephoscope::DiffuseLight light = nephoscope::FindDiffuseLight(
    grid, settings, parallel, [this](double fraction) { return this->GoOn(0.5 + 0.5 * fraction); });
  this->NumberOfIterations = light.Iterations;
  this->LastChange = light.Change;
  for (std::size_t p = 0; p < grid.Points(); ++p)
  {
    const std::size_t q = axes.Order.NumberOf(p);
    // What is diffuse here, but comes straight from the sun in the medium that is drawn.
    const float straight =
      grid.ShadowAt(p) * (std::exp(-work.ScaledDepth[q]) - std::exp(-work.DiffuseDepth[q]));
    const Vector& sun = grid.SunAt(p);
    work.SecondMoment[q] =
      light.Field.SecondMoment[p] - straight * nephoscope::SecondLegendre(sun[2]);
    work.Absorbed[q] = light.Absorption[p];
    work.Fluence[q] = std::max(light.Field.Fluence[p], 0.0f) - straight;
    work.Up[q] = std::max(light.Field.Up(p), 0.0f);
    work.Down[q] = std::max(light.Field.Down(p), 0.0f) - straight * std::max(-sun[2], 0.0f);
    Vector flux = light.Field.Flux[p];
    for (int axis = 0; axis < 3; ++axis)
    {
      flux[axis] -= straight * sun[axis];
    }
    for (int c = 0; c < 3; ++c)
    {
      work.Flux[q][c] =
        flux[0] * axes.Axes[p][0][c] + flux[1] * axes.Axes[p][1][c] + flux[2] * axes.Axes[p][2][c];
    }
  }
  return !this->GetAbortExecute();
}

// The light of an image that has the optics of the data, back at the points of the data.
bool vtkSunlight::Sample(vtkDataSet* data, Work& work)
{
  vtkSmartPointer<vtkDataSet> copy;
  copy.TakeReference(data->NewInstance());
  copy->CopyStructure(data);
  const std::pair<const char*, const std::vector<float>*> arrays[] = { { "Scaled", &work.Scaled },
    { "Whole", &work.Extinction }, { "Albedo", &work.Albedo }, { "Asymmetry", &work.Asymmetry } };
  for (const auto& [name, values] : arrays)
  {
    std::copy(values->begin(), values->end(), AddPointArray(copy, name)->GetPointer(0));
  }
  const nephoscope::SampleFrame frame(work.Planet, work.Places);
  vtkSmartPointer<vtkImageData> image = frame.MakeImage(work.Places, 100000, false);
  vtkSmartPointer<vtkDataSet> grid = frame.Sampled(copy, image);
  // Sides of the image are mirrors, unless they are open.
  if (!this->OpenSides && !nephoscope::SampleFrame::FillSides(grid, image))
  {
    image = frame.MakeImage(work.Places, 100000, true);
    grid = frame.Sampled(copy, image);
  }
  Work coarse;
  coarse.Planet = work.Planet;
  coarse.Sun = work.Sun;
  vtkIdType ignored = 0;
  coarse.Places = nephoscope::PlacesOf(grid);
  coarse.Scaled = nephoscope::ValuesOf(grid, "Scaled", 0, 1, ignored);
  coarse.Albedo = nephoscope::ValuesOf(grid, "Albedo", 0, 1, ignored);
  coarse.Asymmetry = nephoscope::ValuesOf(grid, "Asymmetry", 0, 1, ignored);
  coarse.Extinction = nephoscope::ValuesOf(grid, "Whole", 0, 1, ignored);
  for (std::vector<float>* one : { &coarse.Scaled, &coarse.Extinction })
  {
    nephoscope::CutResidues(*one); // of interpolation
  }
  coarse.Taken = work.Taken;
  coarse.StartDiffuse();
  if (!this->TraceSun(grid, coarse) || !this->Shade(coarse) || !this->Diffuse(grid, coarse))
  {
    return false;
  }
  vtkNew<vtkIdList> ids;
  double weights[8], parametric[3];
  double bounds[6];
  image->GetBounds(bounds);
  for (vtkIdType p = 0; p < data->GetNumberOfPoints(); ++p)
  {
    int sub = 0;
    nephoscope::Place at = frame.FromPlace(work.Places[p]);
    for (int axis = 0; axis < 3; ++axis)
    {
      at[axis] = std::min(std::max(at[axis], bounds[2 * axis]), bounds[2 * axis + 1]);
    }
    const vtkIdType cell = image->FindCell(at.data(), nullptr, -1, 1e-3, sub, parametric, weights);
    if (cell < 0)
    {
      continue;
    }
    image->GetCellPoints(cell, ids);
    for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
    {
      const vtkIdType q = ids->GetId(k);
      const float weight = static_cast<float>(weights[k]);
      work.Fluence[p] += weight * coarse.Fluence[q];
      work.Up[p] += weight * coarse.Up[q];
      work.Down[p] += weight * coarse.Down[q];
      work.SecondMoment[p] += weight * coarse.SecondMoment[q];
      work.Absorbed[p] += weight * coarse.Absorbed[q];
      for (int c = 0; c < 3; ++c)
      {
        work.Flux[p][c] += weight * coarse.Flux[q][c];
      }
    }
  }
  return true;
}
