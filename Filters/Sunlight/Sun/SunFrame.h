// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Points and clouds as the sun sees them: x and y across its direction, z towards it. Plain C++17.
 */
#ifndef nephoscope_SunFrame_h
#define nephoscope_SunFrame_h

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace nephoscope
{
using Place = std::array<double, 3>;
using Fields =
  std::array<float, 2>; ///< that depths are integrals of; the first is 0 where the second is

/** Calls body(begin, end) for parts of [0, count), perhaps by several threads. */
using Loop = std::function<void(
  std::int64_t count, const std::function<void(std::int64_t, std::int64_t)>& body)>;

/**
 * A depth at which less than 1e-17 of the light is left, so that the rest of the way changes
 * nothing.
 */
constexpr double darkDepth = 40;

struct SunPoint
{
  double X, Y, Z;
  Fields Values;
};

/**
 * The points in the frame of a sun in this direction, of length 1. Coincident points, whose numbers
 * in `merged` are equal, have the values of one of them.
 */
std::vector<SunPoint> SunPoints(const std::vector<Place>& places, const std::vector<Fields>& fields,
  const std::vector<std::int32_t>& merged, const Place& towardsSun, const Loop& loop);

struct SunBox
{
  double Least[2], Most[2], Height;
  SunBox();
  void Add(const SunPoint& point);
};

/**
 * Where the last clouds are towards the sun: a map across its direction, of pixels no lower than
 * the clouds in them.
 */
class LastClouds
{
public:
  LastClouds() = default;
  explicit LastClouds(const std::vector<SunPoint>& points);

  /** A cell with these vertices, if there is a cloud in it. */
  template <typename Vertices>
  void Add(const std::vector<SunPoint>& points, const Vertices& vertices)
  {
    SunBox box;
    bool isCloudy = false;
    for (const auto p : vertices)
    {
      box.Add(points[p]);
      isCloudy = isCloudy || points[p].Values[0] > 0;
    }
    if (isCloudy)
    {
      this->Raise(box);
    }
  }

  double HeightAt(double x, double y) const
  {
    return this->Heights[this->Pixel(x, 0) + this->Size * std::size_t(this->Pixel(y, 1))];
  }

private:
  int Pixel(double x, int axis) const;
  void Raise(const SunBox& box);

  int Size = 0;
  double Origin[2] = { 0, 0 }, PerLength[2] = { 0, 0 };
  std::vector<double> Heights;
};

/** The ways from points to the sun, through cells. */
class SunPaths
{
public:
  virtual ~SunPaths() = default;
  /**
   * Integrals of the fields from points [first, last) to the exit of their paths from the mesh, or
   * to the last cloud.
   */
  virtual void FindDepths(
    std::int32_t first, std::int32_t last, std::array<double, 2>* depths) const = 0;
};

/** Paths that are found point by point. */
class SunPathsOfPoints : public SunPaths
{
public:
  virtual std::array<double, 2> DepthsFrom(std::int32_t point) const = 0;

  void FindDepths(
    std::int32_t first, std::int32_t last, std::array<double, 2>* depths) const override
  {
    for (std::int32_t point = first; point < last; ++point)
    {
      *depths++ = this->DepthsFrom(point);
    }
  }
};

/** Point numbers that are equal for coincident points: seams and poles. */
std::vector<std::int32_t> MergedPoints(const std::vector<Place>& places);
}

#endif
