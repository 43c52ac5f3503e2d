// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MediumProjections.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace nephoscope
{
namespace
{
// The pixels that an interval covers, and the fraction of the interval in each.
struct CoveredRow
{
  int First = 0, Last = 0;
  double Low = 0.0, High = 0.0; // in pixels

  CoveredRow(const double frame[2], const double interval[2])
  {
    const double side = MediumProjections::Side;
    const double scale = frame[1] > frame[0] ? side / (frame[1] - frame[0]) : 0.0;
    this->Low = std::clamp((interval[0] - frame[0]) * scale, 0.0, side);
    this->High = std::clamp((interval[1] - frame[0]) * scale, 0.0, side);
    this->First = std::min(static_cast<int>(this->Low), MediumProjections::Side - 1);
    this->Last = std::clamp(
      static_cast<int>(std::ceil(this->High)) - 1, this->First, MediumProjections::Side - 1);
  }
  double Fraction(int pixel) const
  {
    if (this->First == this->Last)
    {
      return 1.0;
    }
    const double covered = std::min(this->High, pixel + 1.0) - std::max<double>(this->Low, pixel);
    return covered / (this->High - this->Low);
  }
};

// The mean of the squares over the square of the mean.
class Unevenness
{
public:
  void Add(double value)
  {
    this->Sum += value;
    this->Squares += value * value;
  }
  double Get() const { return this->Sum > 0.0 ? this->Squares / (this->Sum * this->Sum) : 0.0; }

private:
  double Sum = 0.0, Squares = 0.0;
};
} // namespace

void MediumProjections::Add(
  const std::array<double, 6>& frame, const std::array<double, 6>& box, const Amounts& amounts)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::size_t across = 2 * ((axis + 1) % 3), up = 2 * ((axis + 2) % 3);
    const CoveredRow columns(&frame[across], &box[across]);
    const CoveredRow rows(&frame[up], &box[up]);
    double* pixels = this->Pixels.data() + axis * NUMBER_OF_QUANTITIES * Size;
    for (int row = rows.First; row <= rows.Last; ++row)
    {
      for (int column = columns.First; column <= columns.Last; ++column)
      {
        const double fraction = rows.Fraction(row) * columns.Fraction(column);
        for (int quantity = 0; quantity < NUMBER_OF_QUANTITIES; ++quantity)
        {
          pixels[quantity * Size + row * Side + column] += fraction * amounts[quantity];
        }
      }
    }
  }
}

double MediumProjections::Localization(const Amounts& opacityOf) const
{
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double* pixels = this->Pixels.data() + axis * NUMBER_OF_QUANTITIES * Size;
    Unevenness opaque, filled;
    for (int pixel = 0; pixel < Size; ++pixel)
    {
      const double volume = pixels[VOLUME * Size + pixel];
      filled.Add(volume);
      opaque.Add(std::max(0.0,
        opacityOf[VOLUME] * volume + opacityOf[SCALAR] * pixels[SCALAR * Size + pixel] +
          opacityOf[OPACITY] * pixels[OPACITY * Size + pixel]));
    }
    if (filled.Get() > 0.0)
    {
      least = std::min(least, opaque.Get() / filled.Get());
    }
  }
  return std::isfinite(least) ? std::max(least, 1.0) : 1.0;
}

double MediumProjections::Localization() const
{
  return this->Localization(Amounts{ { 0.0, 0.0, 1.0 } });
}

double MediumProjections::Localization(const double range[2]) const
{
  return range[1] > range[0] ? this->Localization(Amounts{ { -range[0], 1.0, 0.0 } }) : 1.0;
}

} // namespace nephoscope
