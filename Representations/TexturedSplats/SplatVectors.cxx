// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SplatVectors.h"

#include "SplatClasses.h"
#include "SplatSamples.h"
#include "VectorTexture.h"

#include "vtkDataArray.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace nephoscope
{
namespace
{
float lengthOf(const std::array<float, 3>& v)
{
  return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

// The same for a sample in every run: a hash of where it is.
float startOf(const std::array<float, 3>& position)
{
  double sum = 0.0;
  constexpr double irrational[3] = { 12.9898, 78.233, 37.719 };
  for (std::size_t c = 0; c < 3; ++c)
  {
    sum += position[c] * irrational[c];
  }
  const double sine = std::sin(sum) * 43758.5453;
  return static_cast<float>(sine - std::floor(sine));
}

// Length of a cell: that of a cube of its volume, as the shader has it on the screen.
double cellSize(const SplatSamples::Jacobian& j)
{
  const double determinant = j[0][0] * (double(j[1][1]) * j[2][2] - double(j[1][2]) * j[2][1]) +
    j[0][1] * (double(j[1][2]) * j[2][0] - double(j[1][0]) * j[2][2]) +
    j[0][2] * (double(j[1][0]) * j[2][1] - double(j[1][1]) * j[2][0]);
  return std::cbrt(std::abs(determinant));
}
}

void SplatVectors::Read(vtkDataArray* vectors, const SplatSamples& samples)
{
  const std::size_t count = samples.Size();
  this->Vectors.resize(count);
  if (this->Starts.size() != count)
  {
    this->Starts.resize(count);
    this->Moved.assign(count, 0.0f);
  }
  this->Greatest = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    double v[3];
    vectors->GetTuple(samples.Ids[i], v);
    const bool finite = std::isfinite(v[0] + v[1] + v[2]);
    for (std::size_t c = 0; c < 3; ++c)
    {
      this->Vectors[i][c] = finite ? static_cast<float>(v[c]) : 0.0f;
    }
    this->Greatest = std::max(this->Greatest, lengthOf(this->Vectors[i]));
    this->Starts[i] = startOf(samples.Positions[i]);
  }
}

void SplatVectors::Advance(double time, double period, const SplatSamples& samples)
{
  for (std::size_t i = 0; i < this->Moved.size(); ++i)
  {
    const double size = cellSize(samples.JacobianOf(i));
    this->Moved[i] = static_cast<float>(
      AdvancePhase(this->Moved[i], lengthOf(this->Vectors[i]), period * size, time));
  }
}

void SplatVectors::SetLoop(double share, int cycles)
{
  this->LoopShare = share;
  this->LoopCycles = cycles;
}

std::vector<std::array<float, 4>> SplatVectors::Pack(const SplatClasses& classes) const
{
  std::vector<std::array<float, 4>> packed;
  packed.reserve(classes.Samples.size());
  for (const std::int32_t sample : classes.Samples)
  {
    const auto i = static_cast<std::size_t>(sample);
    const auto& v = this->Vectors[i];
    const double loop = this->Greatest > 0
      ? this->LoopShare * std::round(this->LoopCycles * lengthOf(v) / this->Greatest)
      : 0.0;
    const double phase = this->Starts[i] + this->Moved[i] + loop;
    packed.push_back({ { v[0], v[1], v[2], static_cast<float>(phase - std::floor(phase)) } });
  }
  return packed;
}

} // namespace nephoscope
