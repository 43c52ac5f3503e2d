// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Where a direction from the planet's centre lies among the columns and rows of a
// longitude-latitude grid. Plain C++17.
//
// A cell is the bilinear patch between the unit vectors of its corners, seen from the centre. What
// is interpolated on it is divided by the length of the interpolated unit vector, so a vector field
// that is linear in the position, a rotation of the sphere about any axis, is interpolated without
// error on any grid, at the poles and the seam too. No angle is computed where the cell of the last
// search, or its neighbour, is the right one.
#ifndef nephoscope_GlobeColumns_h
#define nephoscope_GlobeColumns_h

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace nephoscope
{
// The cell that a direction was found in last, or -1: where the next search begins.
struct ColumnHint
{
  int Column = -1;
  int Row = -1;
};

struct ColumnPosition
{
  int Column;   // of the cell's western corners
  int Row;      // of its southern corners
  double East;  // 0 on the western edge, 1 on the eastern
  double North; // 0 on the southern edge, 1 on the northern
  double Scale; // what sums over the corners are to be multiplied by, see above
  bool Inside;  // false: beyond a border of a regional grid; the column is on the border
};

class GlobeColumns
{
public:
  static constexpr double PI = 3.14159265358979323846;

  GlobeColumns() = default;

  // Radians; longitudes rise from column to column and span no more than a turn, latitudes rise
  // from row to row. If they span a turn up to rounding the grid is closed.
  GlobeColumns(std::vector<double> longitudes, const std::vector<double>& latitudes)
    : Longitudes(std::move(longitudes))
  {
    for (std::size_t i = 0; i + 1 < this->Longitudes.size(); ++i)
    {
      const double middle = 0.5 * (this->Longitudes[i] + this->Longitudes[i + 1]);
      const double half = 0.5 * (this->Longitudes[i + 1] - this->Longitudes[i]);
      this->Gaps.push_back({ std::cos(middle), std::sin(middle), 0.5 / std::tan(half),
        std::cos(half), std::sin(half) });
    }
    for (const double latitude : latitudes)
    {
      const bool pole = std::abs(latitude) > 0.5 * PI - 1e-9;
      this->Rows.push_back({ pole ? 0.0 : std::cos(latitude),
        pole ? std::copysign(1.0, latitude) : std::sin(latitude) });
    }
    this->Closed = std::abs(this->Longitudes.back() - this->Longitudes.front() - 2.0 * PI) < 1e-6;
  }

  int ColumnCount() const { return static_cast<int>(this->Longitudes.size()); }
  int RowCount() const { return static_cast<int>(this->Rows.size()); }
  bool IsClosed() const { return this->Closed; }
  double Longitude(int column) const { return this->Longitudes[static_cast<std::size_t>(column)]; }
  double FirstLongitude() const { return this->Longitudes.front(); }
  double SineOfLatitude(int row) const { return this->Rows[static_cast<std::size_t>(row)].Sine; }
  double CosineOfLatitude(int row) const
  {
    return this->Rows[static_cast<std::size_t>(row)].Cosine;
  }

  // `p` need not have unit length; the origin is nowhere, but gives no error.
  ColumnPosition Find(const double p[3], ColumnHint& hint) const
  {
    ColumnPosition column{};
    column.Inside = true;
    Local local{};
    this->FindColumn(p, hint.Column, column, local);
    this->FindRow(p[2], local, hint.Row, column);
    hint.Column = column.Column;
    hint.Row = column.Row;
    return column;
  }

private:
  struct Gap // between two columns
  {
    double CosineOfMiddle;
    double SineOfMiddle;
    double HalfCotangent; // of half the width
    double CosineOfHalf;
    double SineOfHalf;
  };

  struct Row
  {
    double Cosine;
    double Sine;
  };

  // Components of the direction towards the middle meridian of a gap and to the east of it.
  struct Local
  {
    double Along;
    double Across;
    double CosineOfHalf;
  };

  bool TryColumn(const double p[3], int column, Local& local, double& east) const
  {
    const Gap& gap = this->Gaps[static_cast<std::size_t>(column)];
    local.Along = p[0] * gap.CosineOfMiddle + p[1] * gap.SineOfMiddle;
    local.Across = p[1] * gap.CosineOfMiddle - p[0] * gap.SineOfMiddle;
    local.CosineOfHalf = gap.CosineOfHalf;
    east = 0.5 + local.Across / local.Along * gap.HalfCotangent;
    return local.Along > 0.0 && east >= 0.0 && east <= 1.0;
  }

  void FindColumn(const double p[3], int known, ColumnPosition& column, Local& local) const
  {
    const int count = static_cast<int>(this->Gaps.size());
    if (known >= 0 && known < count)
    {
      column.Column = known;
      if (this->TryColumn(p, known, local, column.East))
      {
        return;
      }
      int next = known + (local.Across > 0.0 ? 1 : -1);
      next = this->Closed ? (next + count) % count : std::clamp(next, 0, count - 1);
      column.Column = next;
      if (this->TryColumn(p, next, local, column.East))
      {
        return;
      }
    }
    this->SearchColumn(p, column, local);
  }

  void SearchColumn(const double p[3], ColumnPosition& column, Local& local) const
  {
    const double turn = 2.0 * PI;
    const double angle =
      p[0] == 0.0 && p[1] == 0.0 ? this->Longitudes.front() : std::atan2(p[1], p[0]);
    double longitude = angle + turn * std::ceil((this->Longitudes.front() - angle) / turn);
    if (!this->Closed && longitude > this->Longitudes.back())
    {
      // Beyond a border: the nearer one.
      const double beyond = longitude - this->Longitudes.back();
      const double before = this->Longitudes.front() + turn - longitude;
      this->PutOnBorder(p, before < beyond, column, local);
      return;
    }
    const auto after =
      std::upper_bound(this->Longitudes.begin(), this->Longitudes.end(), longitude);
    const int count = static_cast<int>(this->Gaps.size());
    column.Column =
      std::clamp(static_cast<int>(after - this->Longitudes.begin()) - 1, 0, count - 1);
    this->TryColumn(p, column.Column, local, column.East);
    if (!(local.Along > 0.0)) // on the axis
    {
      local.Along = local.Across = 0.0;
      column.East = 0.5;
    }
    column.East = std::clamp(column.East, 0.0, 1.0);
  }

  void PutOnBorder(const double p[3], bool west, ColumnPosition& column, Local& local) const
  {
    column.Column = west ? 0 : static_cast<int>(this->Gaps.size()) - 1;
    column.East = west ? 0.0 : 1.0;
    column.Inside = false;
    const Gap& gap = this->Gaps[static_cast<std::size_t>(column.Column)];
    const double radius = std::sqrt(p[0] * p[0] + p[1] * p[1]);
    local = { radius * gap.CosineOfHalf, (west ? -radius : radius) * gap.SineOfHalf,
      gap.CosineOfHalf };
  }

  // Positive north of the row, on the great circle between its points on either side.
  double BeyondRow(double z, const Local& local, int row) const
  {
    const Row& r = this->Rows[static_cast<std::size_t>(row)];
    return local.CosineOfHalf * r.Cosine * z - r.Sine * local.Along;
  }

  void FindRow(double z, const Local& local, int known, ColumnPosition& column) const
  {
    const int last = this->RowCount() - 2;
    int row = known >= 0 && known <= last ? known : this->GuessRow(z, local);
    double south = this->BeyondRow(z, local, row);
    double north = this->BeyondRow(z, local, row + 1);
    while (south < 0.0 && row > 0)
    {
      --row;
      north = south;
      south = this->BeyondRow(z, local, row);
    }
    while (north > 0.0 && row < last)
    {
      ++row;
      south = north;
      north = this->BeyondRow(z, local, row + 1);
    }
    const double width = south - north;
    const double fraction = width > 0.0 ? south / width : local.Along > 0.0 || z < 0.0 ? 0.0 : 1.0;
    column.North = std::clamp(fraction, 0.0, 1.0);
    column.Inside = column.Inside && fraction >= -1e-9 && fraction <= 1.0 + 1e-9;
    column.Row = row;
    column.Scale = this->ScaleAt(z, local, column);
  }

  int GuessRow(double z, const Local& local) const
  {
    const double radius = std::hypot(local.Along, local.Across);
    const double sine = z / std::max(std::hypot(radius, z), 1e-300);
    const auto after = std::upper_bound(this->Rows.begin(), this->Rows.end(), sine,
      [](double s, const Row& r) { return s < r.Sine; });
    return std::clamp(static_cast<int>(after - this->Rows.begin()) - 1, 0, this->RowCount() - 2);
  }

  // The interpolated unit vector is m p; sums are scaled by 1 / m, so that they belong to p itself.
  double ScaleAt(double z, const Local& local, const ColumnPosition& column) const
  {
    const Row& south = this->Rows[static_cast<std::size_t>(column.Row)];
    const Row& north = this->Rows[static_cast<std::size_t>(column.Row) + 1];
    const double cosine = south.Cosine + column.North * (north.Cosine - south.Cosine);
    const double sine = south.Sine + column.North * (north.Sine - south.Sine);
    const double radius2 = local.Along * local.Along + local.Across * local.Across;
    const double horizontal =
      local.Along > 0.0 ? cosine * local.CosineOfHalf * radius2 / local.Along : 0.0;
    const double dot = horizontal + sine * z;
    return dot > 0.0 ? (radius2 + z * z) / dot : 1.0;
  }

  std::vector<double> Longitudes;
  std::vector<Gap> Gaps;
  std::vector<Row> Rows;
  bool Closed = false;
};

constexpr double TURN = 2.0 * GlobeColumns::PI;
}

#endif
