// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "HazePlacement.h"

#include "vtkHaze.h"

#include <sstream>

namespace nephoscope
{
namespace
{
constexpr double earthRadius = 6371000;
constexpr double airHeight = 8000;
constexpr double visibilityTimesExtinction = 3.912; // -ln 0.02, Koschmieder1924
constexpr double visibleHeights = 24.5;
// For a cube that is as much; an eye that sees all of a scene from the side is two widths away.
constexpr double visibleWidths = 5.7;
constexpr double coarseness = 0.005;
constexpr double heightsInScene = 3;
constexpr double heightsInWidth = 10; // a thin scene in a thin layer would have no haze from above
constexpr double deepest = 10; // scale heights under the ground, where air is 22,000 times as dense

/**
 * 1 if the scene has the size of the Earth in metres about the origin, 1000 if in kilometres; else
 * 0.
 */
double MetresPerUnitOfEarth(const HazeScene& scene)
{
  for (const double metres : { 1.0, 1000.0 })
  {
    const double radii = scene.Reach() * metres / earthRadius;
    double offset = 0;
    for (int c = 0; c < 3; ++c)
    {
      offset = std::max(offset, std::abs(scene.Low[c] + scene.High[c]) * metres / earthRadius);
    }
    if (radii > 0.95 && radii < 1.6 && offset < 0.3)
    {
      return metres;
    }
  }
  return 0;
}

/** Along `up`, of all corners of the bounds. */
void Levels(const HazeScene& scene, const double up[3], double& low, double& high)
{
  const double length = std::hypot(up[0], up[1], up[2]);
  low = high = 0;
  for (int c = 0; c < 3; ++c)
  {
    const double ends[2] = { up[c] / length * scene.Low[c], up[c] / length * scene.High[c] };
    low += std::min(ends[0], ends[1]);
    high += std::max(ends[0], ends[1]);
  }
}

/**
 * The altitude over the ground of the eye or the highest corner of the bounds, in scale heights.
 */
double HighestAltitude(const HazePlacement& place, vtkHaze* haze, const HazeScene& scene)
{
  if (!place.OnGlobe)
  {
    double low, high;
    HazeScene seen = scene;
    for (int c = 0; c < 3; ++c)
    {
      seen.Low[c] = std::min(seen.Low[c], scene.Eye[c]);
      seen.High[c] = std::max(seen.High[c], scene.Eye[c]);
    }
    Levels(seen, haze->GetUpDirection(), low, high);
    return (high - place.BaseLevel) / place.ScaleHeight;
  }
  double farthest[3];
  for (int c = 0; c < 3; ++c)
  {
    farthest[c] = std::max(std::abs(scene.Low[c] - haze->GetCenter()[c]),
      std::abs(scene.High[c] - haze->GetCenter()[c]));
  }
  const double eye = std::hypot(scene.Eye[0] - haze->GetCenter()[0],
    scene.Eye[1] - haze->GetCenter()[1], scene.Eye[2] - haze->GetCenter()[2]);
  return (std::max(eye, std::hypot(farthest[0], farthest[1], farthest[2])) - place.Radius) /
    place.ScaleHeight;
}

std::string Describe(const HazePlacement& place, vtkHaze* haze)
{
  std::ostringstream text;
  text << "Haze hides everything: eye and scene lie deep under the ground, ";
  if (place.OnGlobe)
  {
    const double* center = haze->GetCenter();
    text
      << "a globe of radius " << place.Radius << " about (" << center[0] << ", " << center[1]
      << ", " << center[2]
      << "). Set Projection to Map or Automatic, or Planet Radius and Center to those of the scene.";
  }
  else
  {
    text << "which is flat, at Base Level " << place.BaseLevel
         << ". Set Base Level to the lowest height of the scene, or Projection to Automatic.";
  }
  return text.str();
}
}

HazePlacement::HazePlacement(vtkHaze* haze, const HazeScene& scene)
{
  const double metres = scene.IsEmpty() ? 0 : MetresPerUnitOfEarth(scene);
  const bool told = scene.GlobeGridProjection >= 0;
  const bool automatic = haze->GetProjection() == vtkHaze::AUTOMATIC;
  this->Exists = !scene.IsEmpty() || !haze->NeedsScene();
  this->OnGlobe = automatic
    ? haze->GetPlanetRadius() > 0 || (told ? scene.GlobeGridProjection == 0 : metres > 0)
    : haze->GetProjection() == vtkHaze::GLOBE;
  this->Radius = haze->GetPlanetRadius() > 0 ? haze->GetPlanetRadius()
    : scene.PlanetRadius > 0                 ? scene.PlanetRadius
    : metres > 0                             ? earthRadius / metres
                                             : earthRadius;
  double low = 0, high = 0;
  Levels(scene, haze->GetUpDirection(), low, high);
  const bool overFlatGround = !this->OnGlobe && !told && !scene.IsEmpty();
  const bool found = automatic && overFlatGround;
  this->BaseLevel = haze->GetBaseLevel() + (found ? low : 0);
  this->MovesDown = found;

  const double diagonal = overFlatGround ? scene.Diagonal() : 0;
  const double width = std::sqrt(std::max(0.0, diagonal * diagonal - (high - low) * (high - low)));
  const double height = haze->GetScaleHeight() > 0 ? haze->GetScaleHeight()
    : told || scene.IsEmpty()                      ? airHeight
    : this->OnGlobe                                ? coarseness * this->Radius
                    : std::max((high - low) / heightsInScene, width / heightsInWidth);
  const bool asDisplayed = haze->GetScaleHeight() <= 0 && overFlatGround; // a share of the scene
  const double exaggeration = haze->GetVerticalExaggeration() > 0 ? haze->GetVerticalExaggeration()
    : scene.VerticalExaggeration > 0 && !asDisplayed              ? scene.VerticalExaggeration
                                                                  : 1;
  this->ScaleHeight = (height > 0 ? height : 1) * exaggeration;
  const double visibility = std::max(visibleHeights * this->ScaleHeight, visibleWidths * width);
  this->Extinction =
    haze->GetVisibility() > 0 ? haze->GetExtinction() : visibilityTimesExtinction / visibility;
  if (this->Exists && !scene.IsEmpty() && HighestAltitude(*this, haze, scene) < -deepest)
  {
    this->Problem = Describe(*this, haze);
  }
}

} // namespace nephoscope
