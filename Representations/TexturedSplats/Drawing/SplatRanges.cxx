// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SplatRanges.h"

#include "DepthTiles.h"
#include "SplatKernel.h"
#include "SplatPass.h"
#include "SplatReach.h"
#include "SplatSamples.h"
#include "ViewState.h"

#include "vtkMatrix4x4.h"

#include <limits>

namespace nephoscope
{
namespace
{
// A point's square may be so much larger than the parallelogram of a long splat that is drawn
// instead, at a higher price for a pixel.
constexpr double largestExcess = 1.8;
constexpr std::size_t probes = 64;
constexpr std::size_t all =
  std::numeric_limits<std::size_t>::max(); // vectors in layers are more than the splats

SplatMatrix Turned(const SplatSamples::Jacobian& jacobian, const SplatMatrix& toView)
{
  SplatMatrix result;
  for (std::size_t c = 0; c < 3; ++c)
  {
    result[c] = Times(toView, { { jacobian[c][0], jacobian[c][1], jacobian[c][2] } });
  }
  return result;
}

// Squares over parallelograms, in the mean of a few splats.
double MeanExcess(const SplatSamples& samples, const SplatMatrix& toView)
{
  const std::size_t count = samples.SomeJacobians.size();
  const std::size_t step = std::max<std::size_t>(count / probes, 1);
  double sum = 0.0;
  std::size_t seen = 0;
  for (std::size_t i = 0; i < count; i += step, ++seen)
  {
    sum += SquareExcess(Turned(samples.SomeJacobians[i], toView));
  }
  return seen > 0 ? sum / static_cast<double>(seen) : 1.0;
}

SplatEye EyeOf(const SceneView& view)
{
  return { { view.EyeModel[0], view.EyeModel[1], view.EyeModel[2], view.EyeModel[3] } };
}

double FindLargestSlope(vtkMatrix4x4* viewToDevice)
{
  double sum = 0.0;
  for (int i = 0; i < 2; ++i)
  {
    const double slope =
      (1.1 + std::abs(viewToDevice->GetElement(i, 2))) / std::abs(viewToDevice->GetElement(i, i));
    sum += slope * slope;
  }
  return std::sqrt(sum);
}

// How far any item reaches from its place, in view coordinates.
double LargestReach(
  const SortedSplats& splats, const SplatMatrix& toView, const SplatDrawingOptions& options)
{
  const double kernel = KernelRadius(options.Kernel);
  const VectorLook look = { options.Segments, options.VectorUnit, options.StreakPeriod,
    options.SegmentLength };
  const double ofVectors = options.Vectors ? VectorReach(look, kernel, splats.LongestEdge) : 0.0;
  return LargestStretch(toView) * std::max(kernel * splats.LongestEdge, ofVectors);
}
}

SplatMatrix LinearPart(vtkMatrix4x4* from)
{
  SplatMatrix matrix;
  for (std::size_t column = 0; column < 3; ++column)
  {
    for (std::size_t row = 0; row < 3; ++row)
    {
      matrix[column][row] = from->GetElement(static_cast<int>(row), static_cast<int>(column));
    }
  }
  return matrix;
}

SplatMatrix ToViewMatrix(const SceneView& view)
{
  return LinearPart(view.ModelToView);
}

SplatMetric MetricOf(const SplatMatrix& toView)
{
  SplatMetric metric;
  for (std::size_t column = 0; column < 3; ++column)
  {
    for (std::size_t row = 0; row < 3; ++row)
    {
      metric[column][row] = Dot(toView[row], toView[column]);
    }
  }
  return metric;
}

void FindSplatRanges(const SortedSplats& splats, const SplatSamples& samples, const SceneView& view,
  const int pixels[2], SplatDrawingOptions& options)
{
  const SplatMatrix toView = ToViewMatrix(view);
  const SplatMetric metric = MetricOf(toView);
  const SplatEye eye = EyeOf(view);
  SplatReach reach;
  const double radius = KernelRadius(options.Kernel) * LargestStretch(toView);
  reach.Radius = radius * splats.LongestEdge;
  for (int i = 0; i < 2; ++i)
  {
    reach.PixelsPerSlope =
      std::max(reach.PixelsPerSlope, 0.5 * pixels[i] * view.ViewToDevice->GetElement(i, i));
  }
  reach.LargestSlope = FindLargestSlope(view.ViewToDevice);
  reach.LargestPoint = SplatPass::LargestPoint;
  const auto within = [&](double distance) {
    return CountNear(splats.Places, splats.Items, splats.Order, eye, distance, metric);
  };
  options.NearSplats = within(1.3 * radius * samples.LongestEdge);
  options.LargeSplats = options.CloserSplats = all;
  if (options.Vectors || MeanExcess(samples, toView) > largestExcess)
  {
    return;
  }
  if (eye[3] == 0)
  {
    options.LargeSplats = options.CloserSplats = ParallelPoints(reach) ? 0 : all;
    return;
  }
  const double points = std::max(PointDistance(reach), options.LeastPointDistance * reach.Radius);
  options.LargeSplats = within(points);
  options.CloserSplats = within(std::max(points, FirstOrderDistance(reach)));
}

void AddSplats(const SortedSplats& splats, const SceneView& view,
  const SplatDrawingOptions& options, DepthTiles& tiles)
{
  const vtkMatrix4x4* toView = view.ModelToView;
  const double reach = LargestReach(splats, ToViewMatrix(view), options);
  for (const std::int32_t item : splats.Items)
  {
    const std::array<float, 3>& place = splats.Places[static_cast<std::size_t>(item)];
    const auto row = [&](int i) {
      return toView->GetElement(i, 0) * place[0] + toView->GetElement(i, 1) * place[1] +
        toView->GetElement(i, 2) * place[2] + toView->GetElement(i, 3);
    };
    tiles.Add({ { row(0), row(1), row(2) } }, reach);
  }
}

void FindSplatsBetween(const SortedSplats& splats, const SceneView& view,
  const std::array<double, 2>& distances, SplatDrawingOptions& options)
{
  const SplatEye eye = EyeOf(view);
  if (eye[3] == 0)
  {
    return;
  }
  const SplatMatrix toView = ToViewMatrix(view);
  const SplatMetric metric = MetricOf(toView);
  const double reach = LargestReach(splats, toView, options);
  const double slope = FindLargestSlope(view.ViewToDevice);
  const auto within = [&](double distance) {
    return distance > 0
      ? CountNear(splats.Places, splats.Items, splats.Order, eye, distance, metric)
      : 0;
  };
  const double farthest = distances[1] * std::sqrt(1 + slope * slope) + reach;
  options.FirstSplat = splats.Order.size() - within(farthest);
  options.SplatsAfter = within(distances[0] - reach);
}

} // namespace nephoscope
