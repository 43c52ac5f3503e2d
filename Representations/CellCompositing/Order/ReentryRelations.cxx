// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ReentryRelations.h"

#include "Buckets.h"
#include "FaceRaster.h"

#include <algorithm>
#include <iterator>

namespace nephoscope
{
namespace
{
using Face = FaceNeighbors::Face;

constexpr int rowsOfBand = 8;

/** One crossing of a pixel's ray through the surface. */
struct Crossing
{
  double Depth;
  std::int32_t Pixel; // of the band
  std::int32_t Face;  // number of the boundary face
  bool Enters;
  bool operator<(const Crossing& other) const
  {
    return std::tie(this->Pixel, this->Depth, this->Face) <
      std::tie(other.Pixel, other.Depth, other.Face);
  }
};

/** A stretch of rows of the picture, and the relations that its rays find. */
class Band
{
public:
  Band(const CellGeometry& geometry, const std::vector<Face>& boundary, const OrderView& view,
    int number)
    : Geometry(geometry)
    , Boundary(boundary)
    , View(view)
    , FirstRow(number * rowsOfBand)
    , LastRow(std::min(this->FirstRow + rowsOfBand, view.Height))
  {
  }

  void Add(std::int32_t number)
  {
    const Face& face = this->Boundary[static_cast<std::size_t>(number)];
    const auto p = this->Geometry.Vertices(static_cast<std::size_t>(face.Tetrahedron));
    const auto& f = tetrahedronFaces[face.Opposite];
    const Vector3& apex = p[static_cast<std::size_t>(face.Opposite)];
    const double eyeSide = planeSide(p[f[0]], p[f[1]], p[f[2]], this->View.Eye);
    const double apexSide =
      planeSide(p[f[0]], p[f[1]], p[f[2]], { { apex[0], apex[1], apex[2], 1.0 } });
    if (eyeSide == 0)
    {
      return; // seen edge-on
    }
    const bool enters = (eyeSide > 0) != (apexSide > 0);
    const FaceRaster raster(this->View, p[f[0]], p[f[1]], p[f[2]]);
    const int last = std::min(raster.LastRow, this->LastRow);
    for (int row = std::max(raster.FirstRow, this->FirstRow); row < last; ++row)
    {
      const std::int32_t rowStart = (row - this->FirstRow) * this->View.Width;
      raster.VisitRow(row, [&](int column, double depth) {
        this->Crossings.push_back({ depth, rowStart + column, number, enters });
      });
    }
  }

  void Relate(std::vector<ReentryRelation>& relations)
  {
    this->SortCrossings();
    for (auto begin = this->Crossings.begin(); begin != this->Crossings.end();)
    {
      const auto end = std::find_if(
        begin, this->Crossings.end(), [&](const Crossing& c) { return c.Pixel != begin->Pixel; });
      if (end - begin > 2)
      {
        this->RelateOneRay(begin, end, relations);
      }
      begin = end;
    }
    std::sort(relations.begin(), relations.end());
    relations.erase(std::unique(relations.begin(), relations.end()), relations.end());
  }

private:
  using Iterator = std::vector<Crossing>::const_iterator;

  // Pixels by counting; then each pixel's few crossings.
  void SortCrossings()
  {
    const int pixels = (this->LastRow - this->FirstRow) * this->View.Width;
    std::vector<std::size_t> next(static_cast<std::size_t>(std::max(pixels, 0)) + 1, 0);
    for (const Crossing& c : this->Crossings)
    {
      ++next[static_cast<std::size_t>(c.Pixel) + 1];
    }
    for (std::size_t i = 1; i < next.size(); ++i)
    {
      next[i] += next[i - 1];
    }
    std::vector<Crossing> sorted(this->Crossings.size());
    for (const Crossing& c : this->Crossings)
    {
      sorted[next[static_cast<std::size_t>(c.Pixel)]++] = c;
    }
    std::size_t begin = 0;
    for (std::size_t i = 0; i + 1 < next.size(); ++i) // next[i] is now where pixel i ends
    {
      std::sort(sorted.begin() + std::ptrdiff_t(begin), sorted.begin() + std::ptrdiff_t(next[i]));
      begin = next[i];
    }
    this->Crossings.swap(sorted);
  }

  // Every gap lies between the k-th exit and the next entry, counted from the far end: a ray may start inside, but never ends
  // there. Counting entries and exits apart keeps blocks in order whose common side differs by rounding.
  void RelateOneRay(Iterator begin, Iterator end, std::vector<ReentryRelation>& relations)
  {
    this->Entries.clear();
    this->Exits.clear();
    for (Iterator c = begin; c != end; ++c)
    {
      (c->Enters ? this->Entries : this->Exits).push_back(c);
    }
    const std::size_t entries = this->Entries.size(), exits = this->Exits.size();
    if (exits == entries || exits == entries + 1)
    {
      const double rounding = 1e-3 * ((end - 1)->Depth - begin->Depth);
      for (std::size_t k = 1; k <= entries && k < exits; ++k)
      {
        const Crossing& exit = *this->Exits[exits - 1 - k];
        const Crossing& entry = *this->Entries[entries - k];
        if (exit.Depth <= entry.Depth + rounding) // else cells overlap
        {
          this->Relate(exit, entry, relations);
        }
      }
      return;
    }
    for (Iterator c = begin; c + 1 != end; ++c)
    {
      if (!c->Enters && (c + 1)->Enters)
      {
        this->Relate(*c, *(c + 1), relations);
      }
    }
  }

  void Relate(
    const Crossing& exit, const Crossing& entry, std::vector<ReentryRelation>& relations) const
  {
    const Face& out = this->Boundary[static_cast<std::size_t>(exit.Face)];
    const Face& in = this->Boundary[static_cast<std::size_t>(entry.Face)];
    const ReentryRelation relation = { out.Tetrahedron, out.Opposite, in.Tetrahedron };
    // Neighbouring rays mostly say the same.
    if (relation.Front != relation.Behind && (relations.empty() || !(relations.back() == relation)))
    {
      relations.push_back(relation);
    }
  }

  const CellGeometry& Geometry;
  const std::vector<Face>& Boundary;
  const OrderView& View;
  const int FirstRow, LastRow;
  std::vector<Crossing> Crossings;
  std::vector<Iterator> Entries, Exits;
};

struct Rows
{
  std::int32_t First, Last;
};

bool findRows(const CellGeometry& geometry, const std::vector<Face>& boundary,
  const OrderView& view, std::vector<Rows>& rows, const Progress& progress)
{
  rows.resize(boundary.size());
  return forEach(boundary.size(), progress, [&](std::size_t i) {
    const auto p = geometry.Vertices(static_cast<std::size_t>(boundary[i].Tetrahedron));
    const auto& f = tetrahedronFaces[boundary[i].Opposite];
    const FaceRaster raster(view, p[f[0]], p[f[1]], p[f[2]]);
    rows[i] = { raster.FirstRow, raster.LastRow };
  });
}

// Bands find the same relation several times. Buckets of consecutive tetrahedra keep the list in order.
bool mergeRelations(const std::vector<std::vector<ReentryRelation>>& found, std::size_t tetrahedra,
  std::vector<ReentryRelation>& relations, const Progress& progress)
{
  Buckets<ReentryRelation> buckets;
  const std::size_t size = std::max<std::size_t>(std::min<std::size_t>(tetrahedra, 4096), 1);
  return buckets.Fill(found.size(), size, progress.Part(0, 0.5),
           [&](std::size_t band, auto add) {
             for (const ReentryRelation& r : found[band])
             {
               add(static_cast<std::size_t>(r.Front) * size / tetrahedra, r);
             }
           }) &&
    buckets.ForEach(progress.Part(0.5, 0.9),
      [&](ReentryRelation* begin, ReentryRelation* end) { std::sort(begin, end); }) &&
    buckets.ForEachInTurn(progress.Part(0.9, 1), [&](ReentryRelation* begin, ReentryRelation* end) {
      std::unique_copy(begin, end, std::back_inserter(relations));
    });
}
}

bool findReentryRelations(const CellGeometry& geometry, const std::vector<Face>& boundary,
  const OrderView& view, std::vector<ReentryRelation>& relations, const Progress& progress)
{
  relations.clear();
  std::vector<Rows> rows;
  const std::size_t bands =
    static_cast<std::size_t>(std::max((view.Height + rowsOfBand - 1) / rowsOfBand, 1));
  Buckets<std::int32_t> faces;
  if (!findRows(geometry, boundary, view, rows, progress.Part(0, 0.2)) ||
    !faces.Fill(boundary.size(), bands, progress.Part(0.2, 0.3), [&](std::size_t i, auto add) {
      for (int band = rows[i].First / rowsOfBand; band * rowsOfBand < rows[i].Last; ++band)
      {
        add(static_cast<std::size_t>(band), static_cast<std::int32_t>(i));
      }
    }))
  {
    return false;
  }
  std::vector<std::vector<ReentryRelation>> found(bands);
  return forEach(
           bands, progress.Part(0.3, 0.9),
           [&](std::size_t number) {
             Band band(geometry, boundary, view, static_cast<int>(number));
             for (const std::int32_t* face = faces.Begin(number); face != faces.End(number); ++face)
             {
               band.Add(*face);
             }
             band.Relate(found[number]);
           },
           1) &&
    mergeRelations(found, geometry.Tetrahedra.size(), relations, progress.Part(0.9, 1));
}

} // namespace nephoscope
