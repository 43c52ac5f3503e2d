// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ObstacleSearch.h"

#include "AdvanceParticles.h"
#include "SmokeGeometry.h"

#include <algorithm>
#include <cmath>

namespace nephoscope
{
namespace
{
constexpr std::size_t batchSize = 65536; // positions, which bounds the memory

double LongestSide(const Vector3* corners, std::size_t count)
{
  double longest = 0.0;
  for (std::size_t i = 1; i < count; ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      longest = std::max(longest, Distance(corners[i], corners[j]));
    }
  }
  return longest;
}

Vector3 InTriangle(const std::array<Vector3, 3>& corners, double b, double c)
{
  return (1.0 - b - c) * corners[0] + b * corners[1] + c * corners[2];
}
}

ObstacleSearch::ObstacleSearch(
  const VelocityField& field, double time, double spacing, std::size_t count)
  : Field(field)
  , Time(time)
  , Spacing(spacing)
  , Blocked(count, 0)
{
}

int ObstacleSearch::Intervals(double length) const
{
  const double most = mostIntervals;
  return static_cast<int>(std::clamp(std::ceil(length / this->Spacing), 1.0, most));
}

void ObstacleSearch::AddPrism(std::size_t owner, const std::array<Vector3, 3>& bottom,
  const std::array<Vector3, 3>& top, bool withBottom, const CellHint& hint)
{
  if (!(this->Spacing > 0.0))
  {
    return;
  }
  double way = 0.0;
  for (std::size_t c = 0; c < 3; ++c)
  {
    way = std::max(way, Distance(bottom[c], top[c]));
  }
  const int n =
    this->Intervals(std::max(LongestSide(bottom.data(), 3), LongestSide(top.data(), 3)));
  const int levels = this->Intervals(way);
  for (int level = withBottom ? 0 : 1; level <= levels; ++level)
  {
    std::array<Vector3, 3> section;
    for (std::size_t c = 0; c < 3; ++c)
    {
      const double share = static_cast<double>(level) / levels;
      section[c] = (1.0 - share) * bottom[c] + share * top[c];
    }
    for (int i = 0; i <= n; ++i)
    {
      for (int j = 0; i + j <= n; ++j)
      {
        this->Add(
          owner, InTriangle(section, static_cast<double>(i) / n, static_cast<double>(j) / n), hint);
      }
    }
  }
}

void ObstacleSearch::AddTetrahedron(
  std::size_t owner, const std::array<Vector3, 4>& corners, const CellHint& hint)
{
  if (!(this->Spacing > 0.0))
  {
    return;
  }
  const int n = this->Intervals(LongestSide(corners.data(), 4));
  for (int k = 0; n > 1 && k < n; ++k)
  {
    std::array<Vector3, 3> section;
    for (std::size_t c = 0; c < 3; ++c)
    {
      const double share = static_cast<double>(k) / n;
      section[c] = (1.0 - share) * corners[c] + share * corners[3];
    }
    const int sides = n - k;
    for (int i = 0; i <= sides; ++i)
    {
      for (int j = 0; i + j <= sides; ++j)
      {
        this->Add(owner,
          InTriangle(section, static_cast<double>(i) / sides, static_cast<double>(j) / sides),
          hint);
      }
    }
  }
}

void ObstacleSearch::Add(std::size_t owner, const Vector3& position, const CellHint& hint)
{
  this->Owners.push_back(owner);
  this->Positions.push_back(position);
  this->Hints.push_back(hint);
  if (this->Positions.size() == batchSize)
  {
    this->Sample();
  }
}

const std::vector<unsigned char>& ObstacleSearch::Find()
{
  this->Sample();
  return this->Blocked;
}

// A step of no time by threads, of which only the answer counts whether a
// position is inside.
void ObstacleSearch::Sample()
{
  IntegrationSettings once;
  once.Method = IntegrationMethod::Euler;
  std::vector<unsigned char> inside(this->Positions.size(), 1);
  AdvanceParticles(this->Field,
    { this->Positions.data(), this->Hints.data(), inside.data(), inside.size() }, this->Time, 0.0,
    once);
  for (std::size_t i = 0; i < inside.size(); ++i)
  {
    this->Blocked[this->Owners[i]] |= !inside[i];
  }
  this->Owners.clear();
  this->Positions.clear();
  this->Hints.clear();
}
}
