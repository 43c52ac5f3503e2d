// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TransferFunctionTable.h"

#include "JoinedIntervals.h"
#include "ScalarSelection.h"

#include "vtkColorTransferFunction.h"
#include "vtkDiscretizableColorTransferFunction.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVariant.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace nephoscope
{
namespace
{
// At the places looked at; 1 / 4000 then holds between them. For opacity it is a fraction of the
// opacity itself, down to a small fraction of the largest: however large the scale, the error of
// the optical depth is a small part of it.
constexpr double curveTolerance = 1.0 / 5000;
// Intervals are joined where there are more nodes than this, so that frames take less time.
constexpr std::size_t fewNodes = 16;
constexpr double curveError = 1.0 / 4000;
constexpr double joinedOpacity = 1.0 / 2000 - curveError;
constexpr double halfStep = 1.0 / 510; // of an 8-bit display, the largest error of joined colors
constexpr float leastOpacity = 1e-6f;
constexpr int largestDepth = 12; // the finest piece is 1/4096 of the way between two control points

/**
 * How far inside an interval its limits are taken: as little as the arithmetic allows, so that a
 * jump stays outside.
 */
double LimitInset(double low, double high)
{
  const double rounding =
    4 * std::numeric_limits<double>::epsilon() * std::max(std::abs(low), std::abs(high));
  return std::min(0.5 * (high - low), std::max(1e-9 * (high - low), rounding));
}

/** Evaluates both functions in double, from either side of a point. */
class Sampler
{
public:
  Sampler(vtkVolumeProperty* property, TransferFunctionTable::Channels channels)
  {
    if (channels != TransferFunctionTable::Channels::Color)
    {
      this->Opacity = property->GetScalarOpacity();
    }
    if (channels != TransferFunctionTable::Channels::Opacity)
    {
      const bool rgb = property->GetColorChannels() == 3;
      this->Color = rgb ? property->GetRGBTransferFunction() : nullptr;
      this->Gray = rgb ? nullptr : property->GetGrayTransferFunction();
    }
    this->FindCategories();
    auto* discretizable = vtkDiscretizableColorTransferFunction::SafeDownCast(this->Color);
    this->Steps =
      discretizable && discretizable->GetDiscretize() ? discretizable->GetNumberOfValues() : 0;
    if (this->Color && this->Color->GetColorSpace() == VTK_CTF_LAB_CIEDE2000 &&
      this->Color->GetSize() > 1)
    {
      this->Tabulate();
    }
  }

  TransferFunctionTable::Value operator()(double x) const
  {
    double rgb[3] = { 0, 0, 0 };
    if (!this->Categories.empty())
    {
      std::copy_n(this->CategoryOf(x).begin(), 3, rgb);
    }
    else if (this->HasSteps())
    {
      this->Color->GetColor(x, rgb);
    }
    else if (!this->Tabulated.empty())
    {
      this->LookUp(x, rgb);
    }
    else if (this->Color)
    {
      this->Color->vtkColorTransferFunction::GetColor(
        x, rgb); // not the 8-bit table of the discretised one
    }
    else if (this->Gray)
    {
      rgb[0] = rgb[1] = rgb[2] = this->Gray->GetValue(x);
    }
    return { { static_cast<float>(rgb[0]), static_cast<float>(rgb[1]), static_cast<float>(rgb[2]),
      static_cast<float>(this->Opacity ? std::max(0.0, this->Opacity->GetValue(x)) : 1.0) } };
  }

  /** Control points of both functions, ascending and distinct. */
  std::vector<double> ControlPoints() const
  {
    std::vector<double> nodes;
    AddNodes(this->Opacity, 4, nodes);
    AddNodes(this->Gray, 4, nodes);
    for (std::size_t i = 1; i < this->Categories.size(); ++i)
    {
      nodes.push_back(0.5 * (this->Categories[i - 1].first + this->Categories[i].first));
    }
    AddNodes(this->Categories.empty() ? this->Color : nullptr, 6, nodes);
    if (this->Categories.empty() && this->HasSteps())
    {
      this->AddSteps(nodes);
    }
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
  }

private:
  // Indexed colours belong to annotated values; between two of them the nearer one is meant, so
  // that cells have exactly theirs.
  void FindCategories()
  {
    if (!this->Color || !this->Color->GetIndexedLookup())
    {
      return;
    }
    for (vtkIdType i = 0; i < this->Color->GetNumberOfAnnotatedValues(); ++i)
    {
      bool isNumber = false;
      const double value = this->Color->GetAnnotatedValue(i).ToDouble(&isNumber);
      double rgba[4] = { 0, 0, 0, 1 };
      this->Color->GetIndexedColor(i, rgba);
      if (isNumber && std::isfinite(value))
      {
        this->Categories.emplace_back(
          value, std::array<double, 3>{ { rgba[0], rgba[1], rgba[2] } });
      }
    }
    std::sort(this->Categories.begin(), this->Categories.end());
  }

  const std::array<double, 3>& CategoryOf(double x) const
  {
    const auto nearer = [x](const auto& a, const auto& b) {
      return std::abs(a.first - x) < std::abs(b.first - x);
    };
    return std::min_element(this->Categories.begin(), this->Categories.end(), nearer)->second;
  }

  // In this colour space VTK searches a path for every colour it is asked for, which takes it tens
  // of milliseconds; it makes a whole table with one search per control point.
  void Tabulate()
  {
    this->Color->GetRange(this->TabulatedRange);
    this->Tabulated.resize(3 * tabulatedColors);
    this->Color->vtkColorTransferFunction::GetTable(
      this->TabulatedRange[0], this->TabulatedRange[1], tabulatedColors, this->Tabulated.data());
  }

  void LookUp(double x, double rgb[3]) const
  {
    const double t =
      (x - this->TabulatedRange[0]) / (this->TabulatedRange[1] - this->TabulatedRange[0]);
    const double place = std::max(0.0, std::min(1.0, t)) * (tabulatedColors - 1);
    const int low = std::min(static_cast<int>(place), tabulatedColors - 2);
    for (int c = 0; c < 3; ++c)
    {
      const double a = this->Tabulated[3 * low + c];
      rgb[c] = a + (place - low) * (this->Tabulated[3 * low + 3 + c] - a);
    }
  }

  bool HasSteps() const { return this->Steps > 0 && this->Steps < 256; }

  // The node's own place, and the place of its midpoint, where sharp functions step. The two
  // functions differ in the size of a node: x first, midpoint and sharpness last.
  template <typename Function>
  static void AddNodes(Function* function, int nodeSize, std::vector<double>& nodes)
  {
    if (!function)
    {
      return;
    }
    double node[6], next[6];
    for (int i = 0; i < function->GetSize(); ++i)
    {
      function->GetNodeValue(i, node);
      nodes.push_back(node[0]);
      const double midpoint = node[nodeSize - 2];
      const double sharpness = node[nodeSize - 1];
      if (i + 1 < function->GetSize() && (midpoint != 0.5 || sharpness != 0.0))
      {
        function->GetNodeValue(i + 1, next);
        nodes.push_back(node[0] + midpoint * (next[0] - node[0]));
      }
    }
  }

  void AddSteps(std::vector<double>& nodes) const
  {
    const double* range = this->Color->GetRange();
    const bool logarithmic = this->Color->UsingLogScale() && range[0] > 0;
    for (vtkIdType i = 0; i <= this->Steps; ++i)
    {
      const double t = double(i) / double(this->Steps);
      nodes.push_back(logarithmic ? range[0] * std::pow(range[1] / range[0], t)
                                  : range[0] + (range[1] - range[0]) * t);
    }
  }

  vtkPiecewiseFunction* Opacity = nullptr;
  vtkColorTransferFunction* Color = nullptr;
  vtkPiecewiseFunction* Gray = nullptr;
  vtkIdType Steps = 0;

  std::vector<std::pair<double, std::array<double, 3>>> Categories; // ascending

  static constexpr int tabulatedColors = 1024;
  std::vector<double> Tabulated; // red, green, blue at even places of the range
  double TabulatedRange[2] = { 0, 1 };
};

float ColorDifference(const TransferFunctionTable::Value& a, const TransferFunctionTable::Value& b)
{
  return std::max({ std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2]) });
}

TransferFunctionTable::Value Mix(
  const TransferFunctionTable::Value& a, const TransferFunctionTable::Value& b, float t)
{
  TransferFunctionTable::Value result;
  for (std::size_t c = 0; c < 4; ++c)
  {
    result[c] = a[c] + t * (b[c] - a[c]);
  }
  return result;
}

/**
 * Limits at the ends of an interval: the line through two places just inside, which are as near as
 * rounding allows.
 */
TransferFunctionTable::Interval Limits(const Sampler& sample, double low, double high)
{
  const double inset = LimitInset(low, high);
  const double from = low + inset, to = high - inset; // rounded: the distances are taken from these
  const auto a = sample(from), b = sample(to);
  if (!(to > from))
  {
    return { a, a };
  }
  TransferFunctionTable::Interval result = { Mix(a, b,
                                               static_cast<float>((low - from) / (to - from))),
    Mix(a, b, static_cast<float>((high - from) / (to - from))) };
  for (std::size_t c = 0; c < 4; ++c)
  {
    result.Low[c] = std::max(0.0f, result.Low[c]);
    result.High[c] = std::max(0.0f, result.High[c]);
  }
  return result;
}

/**
 * True when the function is a straight line between its limits at two places, as far as one can
 * tell.
 */
bool IsStraight(const Sampler& sample, double low, double high)
{
  const auto [a, b] = Limits(sample, low, high);
  for (const double t :
    { 0.07, 0.2, 0.31, 0.4, 0.5, 0.6, 0.69, 0.8, 0.93 }) // several, for kinks lie anywhere
  {
    const double x = low + t * (high - low);
    const auto value = sample(x);
    const auto line = Mix(a, b, static_cast<float>((x - low) / (high - low))); // x is rounded
    const double opacityTolerance = curveTolerance * std::max({ value[3], line[3], leastOpacity });
    if (ColorDifference(value, line) >= curveTolerance ||
      std::abs(value[3] - line[3]) >= opacityTolerance)
    {
      return false;
    }
  }
  return true;
}

constexpr float leastDistance = 1e-30f;

/** Adds the inner nodes that the curve between two places needs, ascending. */
void Refine(const Sampler& sample, double low, double high, int depth, std::vector<double>& nodes)
{
  const bool finest = depth == largestDepth || 0.5 * (high - low) <= 16 * LimitInset(low, high);
  if (finest || IsStraight(sample, low, high))
  {
    return;
  }
  const double middle = 0.5 * (low + high);
  Refine(sample, low, middle, depth + 1, nodes);
  nodes.push_back(middle);
  Refine(sample, middle, high, depth + 1, nodes);
}
}

void TransferFunctionTable::Build(
  vtkVolumeProperty* property, const double range[2], Channels channels)
{
  const Sampler sample(property, channels);
  const std::vector<double> controlPoints = sample.ControlPoints();
  std::vector<double> nodes;
  for (std::size_t i = 0; i < controlPoints.size(); ++i)
  {
    if (i > 0)
    {
      Refine(sample, controlPoints[i - 1], controlPoints[i], 0, nodes);
    }
    nodes.push_back(controlPoints[i]);
  }
  if (nodes.empty())
  {
    nodes.push_back(range[0]);
  }

  this->Nodes.clear();
  this->Intervals.clear();
  const double width = std::max(nodes.back() - nodes.front(), range[1] - range[0]);
  for (std::size_t k = 0; k <= nodes.size(); ++k)
  {
    const double low = k == 0 ? nodes.front() - width : nodes[k - 1];
    const double high = k == nodes.size() ? nodes.back() + width : nodes[k];
    const bool outside = k == 0 || k == nodes.size();
    const Value middle = sample(0.5 * low + 0.5 * high);
    this->Intervals.push_back(outside ? Interval{ middle, middle } : Limits(sample, low, high));
  }
  if (nodes.size() > fewNodes)
  {
    const bool curved = nodes.size() > controlPoints.size();
    JoinIntervals(nodes, this->Intervals, curved ? halfStep - curveError : halfStep, joinedOpacity);
  }
  this->Widths.clear();
  for (std::size_t k = 0; k < nodes.size(); ++k)
  {
    const double above = k + 1 < nodes.size() ? nodes[k + 1] : nodes[k];
    const float node = static_cast<float>(NormalizedValue(nodes[k], range));
    // Nodes too near for floats are no jump: what lies on the first has its color, not that of the
    // last. Shaders take 1e-38 for 0.
    const bool merged =
      k > 0 && nodes[k] > nodes[k - 1] && node < this->Nodes.back() + leastDistance;
    this->Nodes.push_back(merged
        ? std::max(std::nextafter(this->Nodes.back(), std::numeric_limits<float>::max()),
            this->Nodes.back() + leastDistance)
        : node);
    this->Widths.push_back(
      static_cast<float>((0.5 * above - 0.5 * nodes[k]) / (0.5 * range[1] - 0.5 * range[0])));
  }

  this->OpaqueIntervals.assign(1, 0);
  for (const Interval& interval : this->Intervals)
  {
    this->OpaqueIntervals.push_back(
      this->OpaqueIntervals.back() + (interval.Low[3] > 0 || interval.High[3] > 0));
  }
}

void TransferFunctionTable::ScaleOpacity(double factor)
{
  for (Interval& interval : this->Intervals)
  {
    interval.Low[3] = static_cast<float>(interval.Low[3] * factor);
    interval.High[3] = static_cast<float>(interval.High[3] * factor);
  }
}

std::size_t TransferFunctionTable::FindInterval(float s) const
{
  return static_cast<std::size_t>(
    std::upper_bound(this->Nodes.begin(), this->Nodes.end(), s) - this->Nodes.begin());
}

TransferFunctionTable::Value TransferFunctionTable::Evaluate(float s) const
{
  const std::size_t k = this->FindInterval(s);
  const Interval& interval = this->Intervals[k];
  if (k == 0 || k == this->Nodes.size())
  {
    return interval.Low;
  }
  const float width = this->Widths[k - 1];
  return Mix(interval.Low, interval.High,
    width > 0 ? std::max(0.0f, std::min(1.0f, (s - this->Nodes[k - 1]) / width)) : 0.0f);
}

float TransferFunctionTable::GreatestOpacity() const
{
  float greatest = 0;
  for (const Interval& interval : this->Intervals)
  {
    greatest = std::max({ greatest, interval.Low[3], interval.High[3] });
  }
  return greatest;
}

bool TransferFunctionTable::IsTransparent(float low, float high) const
{
  const std::size_t first = this->FindInterval(low);
  const std::size_t last = this->FindInterval(high);
  if (first == last)
  {
    return this->Evaluate(low)[3] <= 0 && this->Evaluate(high)[3] <= 0;
  }
  if (this->OpaqueIntervals[last] - this->OpaqueIntervals[first + 1] > 0)
  {
    return false; // an interval strictly between is not transparent
  }
  return this->Evaluate(low)[3] <= 0 && this->Intervals[first].High[3] <= 0 &&
    this->Intervals[last].Low[3] <= 0 && this->Evaluate(high)[3] <= 0;
}

std::array<float, 2> TransferFunctionTable::LongestTransparentRange() const
{
  constexpr float infinite = std::numeric_limits<float>::max();
  std::array<float, 2> longest = { { infinite, -infinite } };
  std::size_t first = 0;
  for (std::size_t k = 0; k < this->Intervals.size(); ++k)
  {
    if (this->Intervals[k].Low[3] > 0 || this->Intervals[k].High[3] > 0)
    {
      first = k + 1;
      continue;
    }
    const float low = first == 0 ? -infinite : this->Nodes[first - 1];
    const float high = k + 1 == this->Intervals.size() ? infinite : this->Nodes[k];
    // Scalars lie between 0 and 1.
    const auto length = [](float from, float to) {
      return std::min(to, 1.0f) - std::max(from, 0.0f);
    };
    if (length(low, high) > length(longest[0], longest[1]))
    {
      longest = { { low, high } };
    }
  }
  return longest;
}

} // namespace nephoscope
