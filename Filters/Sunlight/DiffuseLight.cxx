// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DiffuseLight.h"

#include "AndersonMixing.h"
#include "PhaseFunction.h"

#include <algorithm>
#include <cmath>

namespace nephoscope
{
namespace
{
constexpr float pi = 3.14159265358979f;
constexpr int groups = 4; // of directions: sums do not depend on the number of threads

// Radiance that comes along a piece of optical depth t from a source that goes linearly from that upstream to that here.
struct PieceWeights
{
  float Transmittance, Upstream, Here;

  explicit PieceWeights(float t)
  {
    this->Transmittance = std::exp(-t);
    const float mean = t < 1e-3f ? 1 - 0.5f * t : (1 - this->Transmittance) / t;
    this->Upstream = mean - this->Transmittance;
    this->Here = 1 - mean;
    if (t < 1e-3f)
    {
      this->Upstream = this->Here = 0.5f * t;
    }
  }
};

// Where light in one direction comes from: the point between four neighbours on the next plane upstream.
struct Upstream
{
  std::size_t Points[4];
  float Weights[4];
  float Length;

  float Of(const std::vector<float>& values) const
  {
    return this->Weights[0] * values[this->Points[0]] + this->Weights[1] * values[this->Points[1]] +
      this->Weights[2] * values[this->Points[2]] + this->Weights[3] * values[this->Points[3]];
  }
};

class Sweep
{
public:
  Sweep(const LightGrid& grid, const Direction& direction, const std::vector<float>& beam)
    : Grid(grid)
    , Beam(beam)
    , D{ direction.X, direction.Y, direction.Z }
    , Weight(direction.Weight)
    , Stride{ 1, std::ptrdiff_t(grid.Size[0]), std::ptrdiff_t(grid.Columns()) }
  {
  }

  // Radiance from `radiance`, that of the last iteration; adds to moments and vertical fluxes.
  void Run(const std::vector<float>& moments, const std::vector<float>& groundUp,
    std::vector<float>& radiance, DiffuseField& sums)
  {
    this->MakeSource(moments);
    const int* n = this->Grid.Size;
    for (int c = 0; c < n[2]; ++c)
    {
      const int k = this->D[2] > 0 ? c : n[2] - 1 - c;
      for (int b = 0; b < n[1]; ++b)
      {
        const int j = this->D[1] > 0 ? b : n[1] - 1 - b;
        for (int a = 0; a < n[0]; ++a)
        {
          const int i = this->D[0] > 0 ? a : n[0] - 1 - a;
          this->Visit({ i, j, k }, groundUp, radiance);
        }
      }
    }
    if (this->Grid.Periodic)
    {
      this->CloseSeam(radiance);
    }
    this->Add(radiance, sums);
  }

private:
  bool IsInflow(int k) const { return this->D[2] > 0 ? k == 0 : k == this->Grid.Size[2] - 1; }

  void MakeSource(const std::vector<float>& moments)
  {
    const std::size_t n = this->Grid.Points();
    this->Emission.resize(n);
    for (std::size_t p = 0; p < n; ++p)
    {
      const float* m = moments.data() + 4 * p;
      const float g = this->Grid.Asymmetry[p];
      const float along = this->D[0] * m[1] + this->D[1] * m[2] + this->D[2] * m[3];
      const float source = this->Grid.Albedo[p] / (4 * pi) * (m[0] + 3 * g * along + this->Beam[p]);
      this->Emission[p] = std::max(source, 0.0f) * this->Grid.Extinction[p];
    }
  }

  int Next(int index, int axis) const
  {
    const int step = this->D[axis] > 0 ? index - 1 : index + 1;
    const int n = this->Grid.Size[axis];
    if (step >= 0 && step < n)
    {
      return step;
    }
    return axis == 0 && this->Grid.Periodic
      ? (step < 0 ? n - 2 : 1)
      : index; // outside the medium goes on as it is at the boundary
  }

  Upstream Before(const std::array<int, 3>& at, std::size_t p) const
  {
    float rate[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      rate[axis] = std::abs(this->D[axis]) / std::max(this->Grid.Spacing[p][axis], 1e-30f);
    }
    rate[0] = this->Grid.Size[0] > 1 ? rate[0] : 0;
    rate[1] = this->Grid.Size[1] > 1 ? rate[1] : 0;
    const int m = rate[2] >= rate[0] && rate[2] >= rate[1] ? 2 : rate[0] >= rate[1] ? 0 : 1;
    const int u = (m + 1) % 3, v = (m + 2) % 3;
    const float ru = rate[u] / rate[m], rv = rate[v] / rate[m];
    const auto shift = [&](int axis) {
      return (this->Next(at[axis], axis) - at[axis]) * this->Stride[axis];
    };
    const std::size_t base = p + shift(m);
    const std::ptrdiff_t du = shift(u), dv = shift(v);
    return { { base, base + du, base + dv, base + du + dv },
      { (1 - ru) * (1 - rv), ru * (1 - rv), (1 - ru) * rv, ru * rv }, 1 / rate[m] };
  }

  void Visit(const std::array<int, 3>& at, const std::vector<float>& groundUp,
    std::vector<float>& radiance) const
  {
    const std::size_t p =
      at[0] * this->Stride[0] + at[1] * this->Stride[1] + at[2] * this->Stride[2];
    if (this->IsInflow(at[2]))
    {
      const std::size_t column = p % this->Grid.Columns();
      radiance[p] = this->D[2] > 0 ? groundUp[column] / pi : this->Grid.Sky[column] / pi;
      return;
    }
    const Upstream before = this->Before(at, p);
    const float here = this->Grid.Extinction[p], there = before.Of(this->Grid.Extinction);
    const float depth = 0.5f * (here + there) * before.Length;
    float value = before.Of(radiance);
    if (depth > 0)
    {
      const PieceWeights w(depth);
      const float sourceHere = here > 0 ? this->Emission[p] / here : 0.0f;
      const float sourceThere = there > 0 ? before.Of(this->Emission) / there : sourceHere;
      value = value * w.Transmittance + w.Upstream * sourceThere +
        w.Here * (here > 0 ? sourceHere : sourceThere);
    }
    radiance[p] = value;
  }

  // The sweep met the seam with the values of the last iteration at its first column.
  void CloseSeam(std::vector<float>& radiance) const
  {
    const int n = this->Grid.Size[0];
    for (std::size_t row = 0; row < radiance.size(); row += n)
    {
      (this->D[0] > 0 ? radiance[row] : radiance[row + n - 1]) =
        this->D[0] > 0 ? radiance[row + n - 1] : radiance[row];
    }
  }

  void Add(const std::vector<float>& radiance, DiffuseField& sums) const
  {
    for (std::size_t p = 0; p < radiance.size(); ++p)
    {
      const float light = this->Weight * radiance[p];
      float* m = sums.Moments.data() + 4 * p;
      m[0] += light;
      m[1] += light * this->D[0];
      m[2] += light * this->D[1];
      m[3] += light * this->D[2];
      sums.Vertical[p] += light * std::abs(this->D[2]);
    }
  }

  const LightGrid& Grid;
  const std::vector<float>& Beam; ///< what the sun's beam scatters into this direction
  const float D[3];
  const float Weight;
  const std::ptrdiff_t Stride[3];
  std::vector<float> Emission;
};

void clear(DiffuseField& field, const LightGrid& grid)
{
  field.Moments.assign(4 * grid.Points(), 0.0f);
  field.Vertical.assign(grid.Points(), 0.0f);
}

void addTo(std::vector<float>& sum, const std::vector<float>& part)
{
  std::transform(
    sum.begin(), sum.end(), part.begin(), sum.begin(), [](float a, float b) { return a + b; });
}

class Iteration
{
public:
  Iteration(const LightGrid& grid, const LightSettings& settings)
    : Grid(grid)
    , Directions(directionSet(settings.Zenith, settings.Azimuth))
    , Radiances(this->Directions.size())
    , Groups(groups)
  {
    for (auto& radiance : this->Radiances)
    {
      radiance.assign(grid.Points(), 0.0f);
    }
    this->MakeBeams();
  }

  // All directions once. `field` becomes what they make of the moments.
  void Step(const std::vector<float>& moments, const Parallel& parallel, DiffuseField& field)
  {
    const std::vector<float> groundUp = this->GroundLight(field);
    parallel(groups, [&](int group) {
      clear(this->Groups[group], this->Grid);
      for (std::size_t d = group; d < this->Directions.size(); d += groups)
      {
        Sweep(this->Grid, this->Directions[d], this->Beams[d])
          .Run(moments, groundUp, this->Radiances[d], this->Groups[group]);
      }
    });
    clear(field, this->Grid);
    for (const DiffuseField& part : this->Groups)
    {
      addTo(field.Moments, part.Moments);
      addTo(field.Vertical, part.Vertical);
    }
  }

private:
  // The beam keeps its energy: its phase function has the mean 1 over the directions.
  void MakeBeams()
  {
    this->Beams.assign(this->Directions.size(), std::vector<float>(this->Grid.Points(), 0.0f));
    std::vector<float> phase(this->Directions.size());
    for (std::size_t p = 0; p < this->Grid.Points(); ++p)
    {
      if (this->Grid.Transmittance[p] * this->Grid.Extinction[p] <= 0)
      {
        continue;
      }
      const Vector& s = this->Grid.SunAt(p);
      float sum = 0;
      for (std::size_t d = 0; d < phase.size(); ++d)
      {
        const Direction& to = this->Directions[d];
        phase[d] =
          henyeyGreenstein(this->Grid.Asymmetry[p], to.X * s[0] + to.Y * s[1] + to.Z * s[2]);
        sum += phase[d] * to.Weight;
      }
      for (std::size_t d = 0; d < phase.size(); ++d)
      {
        this->Beams[d][p] = phase[d] * 4 * pi / sum * this->Grid.Transmittance[p];
      }
    }
  }

  std::vector<float> GroundLight(const DiffuseField& field) const
  {
    std::vector<float> up(this->Grid.Columns());
    for (std::size_t c = 0; c < up.size(); ++c)
    {
      const float direct = std::max(-this->Grid.SunAt(c)[2], 0.0f) * this->Grid.Transmittance[c];
      up[c] =
        static_cast<float>(this->Grid.GroundAlbedo) * (direct + std::max(field.Down(c), 0.0f));
    }
    return up;
  }

  const LightGrid& Grid;
  std::vector<Direction> Directions;
  std::vector<std::vector<float>> Radiances, Beams;
  std::vector<DiffuseField> Groups;
};

double largestChange(const std::vector<float>& a, const std::vector<float>& b)
{
  double change = 0, largest = 1e-30;
  for (std::size_t i = 0; i < a.size(); i += 4)
  {
    change = std::max(change, double(std::abs(a[i] - b[i])));
    largest = std::max(largest, double(std::abs(b[i])));
  }
  return change / largest;
}
}

DiffuseField diffuseLight(const LightGrid& grid, const LightSettings& settings,
  const Parallel& parallel, const std::function<bool(double)>& progress)
{
  DiffuseField field;
  clear(field, grid);
  std::vector<float> moments = field.Moments;
  Iteration iteration(grid, settings);
  AndersonMixing mixing(6);
  do
  {
    iteration.Step(moments, parallel, field);
    field.Change = largestChange(moments, field.Moments);
    mixing.Mix(moments, field.Moments);
    ++field.Iterations;
  } while (progress(double(field.Iterations) / settings.MostIterations) &&
    field.Change > settings.Tolerance && field.Iterations < settings.MostIterations);
  return field;
}
}
