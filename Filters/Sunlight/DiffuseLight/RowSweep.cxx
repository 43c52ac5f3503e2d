// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RowSweep.h"

namespace nephoscope
{
namespace
{
/**
 * The way to a point from between four others: across an axis, and by how much along the two
 * others.
 */
struct Crossing
{
  const float *Rate, *RateU, *RateV;
  float Slope, SlopeU, SlopeV;
  SweepRow From[4];
};

// Rest: the light that arrives. Along a row, what the point before adds comes later, by its factor.
// The source goes linearly from that upstream to that here.
template <bool alongRow>
void FindPieces(int count, float slope, float slopeU, float slopeV, const float* rate,
  const float* rateU, const float* rateV, const float* e0, const float* e1, const float* e2,
  const float* e3, const float* s0, const float* s1, const float* s2, const float* s3,
  const float* r0, const float* r1, const float* r2, const float* r3, const float* extinction,
  const float* emission, float* __restrict factor, float* __restrict rest)
{
  constexpr float least = 1e-30f;
  for (int i = 0; i < count; ++i)
  {
    const float length = 1 / (slope * rate[i]), x = slopeU * rateU[i] * length,
                y = slopeV * rateV[i] * length;
    const float w0 = (1 - x) * (1 - y), w1 = x * (1 - y), w2 = (1 - x) * y, w3 = x * y;
    const float here = extinction[i], there = w0 * e0[i] + w1 * e1[i] + w2 * e2[i] + w3 * e3[i];
    const float source = w0 * s0[i] + w1 * s1[i] + w2 * s2[i] + w3 * s3[i];
    const float light = w1 * r1[i] + w2 * r2[i] + w3 * r3[i];
    const float t = 0.5f * (here + there) * length, thick = ExpOfMinus(t);
    const float thinMean = 1 - t * (0.5f - t * (1.0f / 6 - t * (1.0f / 24 - t / 120)));
    const float thickMean = (1 - thick) / std::max(t, 0.1f), thin = 1 - t * thinMean;
    const float mean = t < 0.1f ? thinMean : thickMean, transmittance = t < 0.1f ? thin : thick;
    const float upstream = source / std::max(there, least),
                own = emission[i] / std::max(here, least);
    const float before = there > 0 ? upstream : own, last = here > 0 ? own : upstream;
    const float emitted = (mean - transmittance) * before + (1 - mean) * last;
    const float light0 = alongRow ? 0.0f : w0 * r0[i];
    factor[i] = transmittance * w0;
    rest[i] = emitted + transmittance * (light + light0);
  }
}

template <bool alongRow>
void FindPiecesFrom(
  int first, int count, const Crossing& c, const SweepRow& here, float* factor, float* rest)
{
  const SweepRow(&f)[4] = c.From;
  FindPieces<alongRow>(count, c.Slope, c.SlopeU, c.SlopeV, c.Rate + first, c.RateU + first,
    c.RateV + first, f[0].Extinction + first, f[1].Extinction + first, f[2].Extinction + first,
    f[3].Extinction + first, f[0].Emission + first, f[1].Emission + first, f[2].Emission + first,
    f[3].Emission + first, f[0].Radiance + first, f[1].Radiance + first, f[2].Radiance + first,
    f[3].Radiance + first, here.Extinction + first, here.Emission + first, factor + first,
    rest + first);
}
}

void RowSweep::FindAxes(int low, int count)
{
  const float *x = this->Rates[0] + low, *y = this->Rates[1] + low, *z = this->Rates[2] + low;
  const float slopeX = this->Slopes[0], slopeY = this->Slopes[1], slopeZ = this->Slopes[2];
  std::int32_t* __restrict along = this->Along.data() + low;
  for (int i = 0; i < count; ++i)
  {
    const float across = std::max(slopeX * x[i], slopeY * y[i]);
    const std::int32_t beside = slopeX * x[i] >= slopeY * y[i] ? 0 : 1;
    along[i] = slopeZ * z[i] >= across ? 2 : beside;
  }
}

void RowSweep::Run(int first, int count, int forward, std::ptrdiff_t upstream)
{
  const int low = forward > 0 ? first : first - count + 1;
  this->FindAxes(low, count);
  const SweepRow points[8] = { this->Here, this->Here.Moved(upstream), this->Beside,
    this->Beside.Moved(upstream), this->Before, this->Before.Moved(upstream), this->Diagonal,
    this->Diagonal.Moved(upstream) };
  static constexpr int upstreamOf[3][4] = { { 1, 3, 5, 7 }, { 2, 3, 6, 7 }, { 4, 5, 6, 7 } };
  for (int done = 0; done < count;)
  {
    const int start = first + forward * done, axis = this->Along[start];
    int same = 1;
    while (done + same < count && this->Along[start + forward * same] == axis)
    {
      ++same;
    }
    const int least = forward > 0 ? start : start - same + 1;
    const int u = axis == 0 ? 1 : 0, v = axis == 2 ? 1 : 2;
    const Crossing crossing{ this->Rates[axis], this->Rates[u], this->Rates[v], this->Slopes[axis],
      this->Slopes[u], this->Slopes[v],
      { points[upstreamOf[axis][0]], points[upstreamOf[axis][1]], points[upstreamOf[axis][2]],
        points[upstreamOf[axis][3]] } };
    (axis == 0 ? FindPiecesFrom<true> : FindPiecesFrom<false>)(least, same, crossing, this->Here,
      this->Factor.data(), this->Rest.data());
    float* radiance = this->Here.Radiance;
    for (int n = 0, i = start; n < same; ++n, i += forward)
    {
      radiance[i] =
        axis == 0 ? this->Rest[i] + this->Factor[i] * radiance[i + upstream] : this->Rest[i];
    }
    done += same;
  }
}
}
