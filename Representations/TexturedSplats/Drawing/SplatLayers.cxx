// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SplatLayers.h"

#include "GridSamples.h"
#include "OwnThreads.h"
#include "SplatClasses.h"
#include "SplatSamples.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nephoscope
{
namespace
{
constexpr std::uint32_t middle = 0x80000000u; // of the numbers of layers
constexpr double clearly =
  1.2; // by this factor another axis must point at the eye better than the last one
constexpr double flat =
  3.0; // by this factor rays must cross more layers of one axis than of the others

// Not of unit length.
Vector3 TowardsEye(const SplatSamples::Float3& place, const SplatEye& eye)
{
  Vector3 d;
  for (std::size_t c = 0; c < 3; ++c)
  {
    d[c] = eye[3] == 0 ? eye[c] : eye[c] - place[c];
  }
  return d;
}

// In the world.
double LengthOf(const Vector3& d, const SplatMetric& metric)
{
  return std::sqrt(std::max(Dot(d, Times(metric, d)), 0.0));
}

// The axis whose edges point most towards the eye, on the mean.
int FacingAxis(const SplatSamples& samples, const SplatEye& eye, const SplatMetric& metric)
{
  double facing[3] = { 0, 0, 0 };
  for (std::size_t i = 0; i < samples.Size(); i += samples.StrideOfSome())
  {
    const Vector3 d = TowardsEye(samples.Positions[i], eye);
    const Vector3 covector = Times(metric, d);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const Vector3 edge = ToDouble(samples.SomeJacobianOf(i)[axis]);
      const double length = LengthOf(edge, metric) * LengthOf(d, metric);
      facing[axis] += length > 0 ? std::abs(Dot(edge, covector)) / length : 0;
    }
  }
  const int other = facing[0] > facing[1] ? 0 : 1;
  return facing[other] > clearly * facing[2] ? other : 2;
}
}

double SplatLayers::Thickness(const SplatSamples& samples, const SplatMetric& metric)
{
  return samples.LongestEdge *
    std::sqrt(LargestStretch(metric)); // which is that of the transform, squared
}

void SplatLayers::Find(vtkDataSet* data, bool onCells, const SplatSamples& samples,
  const SplatEye& eye, const SplatMetric& metric, int axis)
{
  const GridSamples grid(data, onCells);
  const int along = axis >= 0 ? axis : FacingAxis(samples, eye, metric);
  const double thickness = std::max(Thickness(samples, metric), 1e-30);
  this->Layers.resize(samples.Size());
  ForAll(this->Layers.size(), [&](std::size_t i) {
    const Vector3 d = TowardsEye(samples.Positions[i], eye);
    const Vector3 covector = Times(metric, d);
    if (grid.IsGrid())
    {
      const auto index = static_cast<std::uint32_t>(grid.Index(samples.Ids[i], along));
      const Vector3 edge = samples.Jacobians.empty()
        ? grid.Direction(samples.Ids[i], along)
        : ToDouble(samples.JacobianOf(i)[static_cast<std::size_t>(along)]);
      const bool towards = Dot(edge, covector) >= 0;
      this->Layers[i] = towards ? middle + index : middle - 1 - index;
      return;
    }
    const double distance = LengthOf(d, metric);
    const double nearness =
      eye[3] == 0 ? Dot(ToDouble(samples.Positions[i]), covector) / distance : -distance;
    const double layer = std::floor(nearness / thickness);
    this->Layers[i] =
      static_cast<std::uint32_t>(std::clamp(layer, -2.0e9, 2.0e9) + static_cast<double>(middle));
  });
}

int SplatLayers::FlatAxis(
  const SplatSamples& samples, const SplatEye& eye, const SplatMetric& metric)
{
  double lengths[3] = { 0, 0, 0 }, crossed[3] = { 0, 0, 0 }; // on the way of one length
  for (std::size_t i = 0; i < samples.Size(); i += samples.StrideOfSome())
  {
    const Vector3 d = TowardsEye(samples.Positions[i], eye);
    const auto& jacobian = samples.SomeJacobianOf(i);
    const Vector3 edges[3] = { ToDouble(jacobian[0]), ToDouble(jacobian[1]),
      ToDouble(jacobian[2]) };
    const double volume = std::abs(Dot(edges[0], Cross(edges[1], edges[2]))) * LengthOf(d, metric);
    for (std::size_t axis = 0; volume > 0 && axis < 3; ++axis)
    {
      lengths[axis] += LengthOf(edges[axis], metric);
      crossed[axis] +=
        std::abs(Dot(d, Cross(edges[(axis + 1) % 3], edges[(axis + 2) % 3]))) / volume;
    }
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    const int second = (axis + 1) % 3, third = (axis + 2) % 3;
    if (flat * lengths[axis] < std::min(lengths[second], lengths[third]) &&
      crossed[axis] > flat * std::max(crossed[second], crossed[third]))
    {
      return axis;
    }
  }
  return -1;
}

std::vector<std::int32_t> SplatLayers::Sort(
  const SplatClasses& classes, const std::vector<std::int32_t>& order, std::size_t near) const
{
  std::vector<std::uint32_t> keys(order.size() - std::min(near, order.size()));
  for (std::size_t i = 0; i < keys.size(); ++i)
  {
    const auto splat = static_cast<std::size_t>(order[i]);
    keys[i] = this->Layers[static_cast<std::size_t>(classes.Samples[splat])];
  }
  std::vector<std::int32_t> items = SortKeys(keys); // stable: from back to front in a layer
  for (std::int32_t& item : items)
  {
    item = order[static_cast<std::size_t>(item)];
  }
  items.insert(items.end(), order.begin() + static_cast<std::ptrdiff_t>(items.size()), order.end());
  return items;
}

std::vector<std::int32_t> SplatLayers::Alternate(
  const SplatClasses& classes, const std::vector<std::int32_t>& order, std::size_t near) const
{
  const std::size_t far = order.size() - std::min(near, order.size());
  std::vector<std::uint32_t> keys(far);
  for (std::size_t i = 0; i < far; ++i)
  {
    const auto splat = static_cast<std::size_t>(order[i]);
    keys[i] = this->Layers[static_cast<std::size_t>(classes.Samples[splat])];
  }
  std::vector<std::uint32_t> used = keys;
  const std::vector<std::int32_t> sorted = SortKeys(used); // stable: from back to front in a layer
  std::vector<std::int32_t> items;
  items.reserve(far + order.size());
  const auto keyAt = [&](std::size_t i) { return keys[static_cast<std::size_t>(sorted[i])]; };
  const auto splatAt = [&](std::size_t i) { return order[static_cast<std::size_t>(sorted[i])]; };
  for (std::size_t begin = 0, end = 0; begin < far; begin = end)
  {
    for (; end < far && keyAt(end) == keyAt(begin); ++end)
    {
      items.push_back(splatAt(end));
    }
    for (std::size_t i = begin; i < end; ++i)
    {
      items.push_back(~splatAt(i));
    }
  }
  items.insert(items.end(), order.begin() + static_cast<std::ptrdiff_t>(far), order.end());
  return items;
}

} // namespace nephoscope
