// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OrderRelations.h"

namespace nephoscope
{

bool OrderRelations::Find(const OrderView& view, const Progress& progress)
{
  this->Reentries.clear();
  this->Flags.resize(this->Geometry.Tetrahedra.size());
  if (!forEach(this->Flags.size(), progress.Part(0, 0.5),
        [&](std::size_t i) { this->Flags[i] = this->FlagsOf(i, view.Eye); }))
  {
    return false;
  }
  if (this->Faces.IsConvex() || view.Width <= 0 || view.Height <= 0)
  {
    return progress.Report(1);
  }
  if (!findReentryRelations(
        this->Geometry, this->Faces.GetBoundary(), view, this->Reentries, progress.Part(0.5, 1)))
  {
    return false;
  }
  for (const ReentryRelation& r : this->Reentries)
  {
    this->Flags[static_cast<std::size_t>(r.Front)] |= hasReentries;
  }
  return true;
}

// A face hides its neighbour when the eye is on the same side of it as the tetrahedron itself. Two neighbours ask each for
// itself: near the tolerance one of them may find no relation, but never do both find themselves in front.
std::uint8_t OrderRelations::FlagsOf(std::size_t tetrahedron, const Vector4& eye) const
{
  const std::array<Vector3, 4> p = this->Geometry.Vertices(tetrahedron);
  std::uint8_t flags = 0;
  for (int face = 0; face < 4; ++face)
  {
    if (this->Faces.Get(tetrahedron, face) >= 0)
    {
      const auto& f = tetrahedronFaces[face];
      const Vector3& apex = p[static_cast<std::size_t>(face)];
      const double own =
        planeSide(p[f[0]], p[f[1]], p[f[2]], { { apex[0], apex[1], apex[2], 1.0 } });
      const int eyeSide =
        planeSideWithin(p[f[0]], p[f[1]], p[f[2]], eye, this->Faces.GetCoordinateError());
      flags |= static_cast<std::uint8_t>((eyeSide * own > 0) << face);
    }
  }
  return flags;
}

std::int32_t OrderRelations::NextReentry(
  std::int32_t tetrahedron, std::int32_t& cursor, std::int32_t& opposite) const
{
  const auto first = std::lower_bound(this->Reentries.begin(), this->Reentries.end(), tetrahedron,
    [](const ReentryRelation& r, std::int32_t t) { return r.Front < t; });
  const std::ptrdiff_t number = cursor - 4;
  if (this->Reentries.end() - first <= number || first[number].Front != tetrahedron)
  {
    return -1;
  }
  ++cursor;
  opposite = first[number].Opposite;
  return first[number].Behind;
}

} // namespace nephoscope
