// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SplatError.h"

#include "OwnThreads.h"
#include "SplatClasses.h"
#include "SplatGaussian.h"
#include "SplatKernel.h"
#include "SplatSamples.h"
#include "SplatTree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace nephoscope
{
namespace
{
using Picture = SplatGaussian<2>;

constexpr double aroundEye = 1.3; // of the kernel's reach: the eye is in it, or it fills the view
constexpr double pixelVariance = 1.0 / 12.0;
constexpr double transition = 0.25; // beyond those bounds, over which errors grow and fall

// The plane at right angles to the line of sight to a place, as it is seen from the eye.
struct Screen
{
  Vector3 Center, Right, Up;
  double Distance = 1; // from the eye; 1 in a parallel projection
  double Pixel;        // its size there

  Screen(const Vector3& place, const SplatCutView& view)
    : Center(place)
  {
    Vector3 ray = { { view.Eye[0], view.Eye[1], view.Eye[2] } };
    ray = view.Eye[3] != 0 ? place - ray : ray;
    const double length = Norm(ray);
    this->Distance = view.Eye[3] != 0 ? length : 1;
    this->Pixel = view.Pixel * this->Distance;
    std::size_t least = std::abs(ray[0]) < std::abs(ray[1]) ? 0 : 1;
    least = std::abs(ray[2]) < std::abs(ray[least]) ? 2 : least;
    Vector3 other{};
    other[least] = 1;
    this->Right = Cross(other, ray);
    const double across = Norm(this->Right);
    for (double& e : this->Right)
    {
      e /= across > 0 ? across : 1;
    }
    this->Up = Cross(ray, this->Right);
    for (double& e : this->Up)
    {
      e /= length > 0 ? length : 1;
    }
  }

  Picture PictureOf(
    const Vector3& place, const SplatMatrix& jacobian, const std::array<float, 4>& color) const
  {
    Picture picture;
    const Vector3 offset = place - this->Center;
    picture.Place = { { Dot(offset, this->Right), Dot(offset, this->Up) } };
    const double spread = pixelVariance * this->Pixel * this->Pixel;
    double xx = 0, xy = 0, yy = 0;
    for (const Vector3& column : jacobian)
    {
      const double x = Dot(column, this->Right), y = Dot(column, this->Up);
      xx += x * x;
      xy += x * y;
      yy += y * y;
    }
    constexpr double v = cubic_kernel::variance;
    picture.Covariance = { { { { v * xx + spread, 0 } }, { { v * xy, v * yy + spread } } } };
    const double mass = color[3] * std::abs(Determinant(jacobian));
    picture.Mass = { { mass * color[0], mass * color[1], mass * color[2], mass } };
    return picture;
  }
};

// The length of a ray of this direction (of any length) in a cell: 1 / |J^-1 e|.
double Thickness(const SplatMatrix& j, const Vector3& direction)
{
  const Vector3 rows[3] = { Cross(j[1], j[2]), Cross(j[2], j[0]), Cross(j[0], j[1]) };
  const Vector3 cells = { { Dot(rows[0], direction), Dot(rows[1], direction),
    Dot(rows[2], direction) } };
  return std::abs(Dot(j[0], rows[0])) * Norm(direction) / Norm(cells);
}

class ErrorFinder
{
public:
  ErrorFinder(const SplatTree& tree, const SplatSamples& samples, const SplatClasses& classes,
    const SplatErrorRule& rule, const SplatCutView& view)
    : Tree(tree)
    , Samples(samples)
    , Classes(classes)
    , Rule(rule)
    , View(view)
  {
    const Vector3 eye = Times(view.ToWorld, Vector3{ { view.Eye[0], view.Eye[1], view.Eye[2] } });
    std::copy(eye.begin(), eye.end(), this->View.Eye.begin());
  }

  std::vector<float> Find() const
  {
    const auto& nodes = this->Tree.Nodes();
    std::vector<float> errors(nodes.size());
    if (this->Rule.OfImage)
    {
      const std::vector<double> squares = this->FindSquares();
      this->ForNodes([&](std::size_t n) {
        errors[n] = this->InView(nodes[n], this->OfImage(nodes[n], squares[n]));
      });
    }
    else
    {
      this->ForNodes(
        [&](std::size_t n) { errors[n] = this->InView(nodes[n], this->OfData(nodes[n])); });
    }
    return errors;
  }

private:
  Vector3 Place(const std::array<float, 3>& place) const
  {
    return Times(this->View.ToWorld, ToDouble(place));
  }

  SplatMatrix Cell(const std::array<std::array<float, 3>, 3>& jacobian) const
  {
    return Product(this->View.ToWorld, ToDouble(jacobian));
  }

  template <typename Body>
  void ForNodes(Body body) const
  {
    ForAll(this->Tree.Nodes().size(), body);
  }

  Picture PictureOf(std::int32_t splat, const Screen& screen) const
  {
    if (!this->Tree.IsLeaf(splat))
    {
      const SplatTreeNode& node = this->Tree.Node(splat);
      return screen.PictureOf(this->Place(node.Position), this->Cell(node.Jacobian), node.Color);
    }
    const auto leaf = static_cast<std::size_t>(splat);
    const auto sample = static_cast<std::size_t>(this->Classes.Samples[leaf]);
    return screen.PictureOf(this->Place(this->Samples.Positions[sample]),
      this->Cell(this->Samples.JacobianOf(sample)), this->Classes.Colors[leaf]);
  }

  // The integral over the screen of the square of what a node differs from its children.
  double OwnSquare(const SplatTreeNode& node) const
  {
    const Screen screen(this->Place(node.Position), this->View);
    const Picture one =
      screen.PictureOf(this->Place(node.Position), this->Cell(node.Jacobian), node.Color);
    std::array<Picture, 8> pictures; // a node has at most eight children
    const std::int32_t* begin = this->Tree.BeginChildren(node);
    const auto count = static_cast<std::size_t>(this->Tree.EndChildren(node) - begin);
    for (std::size_t i = 0; i < count; ++i)
    {
      pictures[i] = this->PictureOf(begin[i], screen);
    }
    return SquareDistance(
      one, pictures.begin(), pictures.begin() + static_cast<std::ptrdiff_t>(count));
  }

  // From its children and from theirs; nodes come after their children.
  std::vector<double> FindSquares() const
  {
    const auto& nodes = this->Tree.Nodes();
    std::vector<double> squares(nodes.size());
    this->ForNodes([&](std::size_t n) { squares[n] = this->OwnSquare(nodes[n]); });
    for (std::size_t n = 0; n < nodes.size(); ++n)
    {
      for (const std::int32_t* c = this->Tree.BeginChildren(nodes[n]);
           c != this->Tree.EndChildren(nodes[n]); ++c)
      {
        squares[n] +=
          this->Tree.IsLeaf(*c) ? 0 : squares[static_cast<std::size_t>(*c) - this->Tree.Leaves()];
      }
    }
    return squares;
  }

  double OfImage(const SplatTreeNode& node, double square) const
  {
    const Screen screen(this->Place(node.Position), this->View);
    const SplatMatrix jacobian = this->Cell(node.Jacobian);
    const Picture picture = screen.PictureOf(this->Place(node.Position), jacobian, node.Color);
    const double perArea = Overlap(picture, picture);
    const bool greatest = this->Rule.As == SplatErrorRule::Measure::Greatest;
    const double vector = this->Rule.Vector * node.Span *
      (greatest ? node.GreatestVectorError : node.RootMeanSquareVectorError);
    double error = std::sqrt(square * perArea);
    if (greatest)
    {
      error =
        std::max(error, node.GreatestError * Thickness(jacobian, Cross(screen.Right, screen.Up)));
    }
    error = this->Rule.Extinction * error + vector;
    return this->Rule.As == SplatErrorRule::Measure::Picture
      ? error / (std::sqrt(perArea) * screen.Pixel)
      : error;
  }

  double OfData(const SplatTreeNode& node) const
  {
    const bool greatest = this->Rule.As == SplatErrorRule::Measure::Greatest;
    return std::max(
      this->Rule.Extinction * (greatest ? node.GreatestError : node.RootMeanSquareError),
      this->Rule.Vector * (greatest ? node.GreatestVectorError : node.RootMeanSquareVectorError));
  }

  float InView(const SplatTreeNode& node, double error) const
  {
    const Screen screen(this->Place(node.Position), this->View);
    const double reach = this->Rule.KernelRadius * LargestStretch(this->Cell(node.Jacobian));
    if (this->View.Eye[3] != 0)
    {
      const double outside = (screen.Distance / (aroundEye * reach) - 1) / transition;
      if (!(outside > 0))
      {
        return std::numeric_limits<float>::infinity();
      }
      error /= std::min(outside, 1.0);
    }
    const double larger = (reach / screen.Pixel - 1) / transition; // than a pixel
    constexpr double most = std::numeric_limits<float>::max();
    return static_cast<float>(std::min(error * std::clamp(larger, 0.0, 1.0), most));
  }

  const SplatTree& Tree;
  const SplatSamples& Samples;
  const SplatClasses& Classes;
  const SplatErrorRule& Rule;
  SplatCutView View; // with the eye in the world
};
}

std::vector<float> FindSplatErrors(const SplatTree& tree, const SplatSamples& samples,
  const SplatClasses& classes, const SplatErrorRule& rule, const SplatCutView& view)
{
  return ErrorFinder(tree, samples, classes, rule, view).Find();
}

} // namespace nephoscope
