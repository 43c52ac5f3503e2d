// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FieldSmoother.h"

#include "SmoothingKernel.h"

#include "vtkSMPTools.h"

namespace nephoscope
{
namespace
{
constexpr double fillValue = 1e30;

// Calls function(j, k, id of the row's first point) for all rows of distinct points, in threads.
template <typename Function>
void ForEachRow(const GridTopology& topology, const Function& function)
{
  const vtkIdType rows = topology.Distinct(1);
  vtkSMPTools::For(0, rows * topology.Distinct(2), [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType r = begin; r < end; ++r)
    {
      const int j = static_cast<int>(r % rows);
      const int k = static_cast<int>(r / rows);
      function(j, k, topology.Id({ { 0, j, k } }));
    }
  });
}
}

bool IsMissingValue(double value)
{
  return !(std::abs(value) < fillValue);
}

std::vector<unsigned char> FieldSmoother::MissingPoints(const Field& field) const
{
  std::vector<unsigned char> missing(field.size());
  for (std::size_t id = 0; id < field.size(); ++id)
  {
    missing[id] =
      this->Plan.IsHidden(static_cast<vtkIdType>(id)) || IsMissingValue(field[id]) ? 1 : 0;
  }
  return missing;
}

bool FieldSmoother::Smooth(
  Field& field, int iterations, const std::function<bool(double)>& keepGoing) const
{
  Field masses = this->Plan.Masses();
  const std::vector<unsigned char> missing = this->MissingPoints(field);
  for (std::size_t id = 0; id < masses.size(); ++id)
  {
    masses[id] = missing[id] ? 0.0 : masses[id];
  }
  this->AverageAtPoles(masses, field);
  Field next = field;
  for (int iteration = 0; iteration < iterations; ++iteration)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      if (this->Plan.Topology().Distinct(axis) > 1)
      {
        axis == 0 ? this->PassAlongRows(masses, field, next)
                  : this->PassAcrossRows(axis, masses, field, next);
        field.swap(next);
        this->AverageAtPoles(masses, field);
      }
      if (!keepGoing((3.0 * iteration + axis + 1.0) / (3.0 * iterations)))
      {
        return false;
      }
    }
  }
  this->CopyToRepeated(field);
  return true;
}

void FieldSmoother::PassAlongRows(const Field& masses, const Field& in, Field& out) const
{
  const GridTopology& topology = this->Plan.Topology();
  const int columns = topology.Distinct(0);
  ForEachRow(topology, [&](int j, int k, std::int64_t first) {
    const RepeatedPass passes = PassesFor(this->Plan.RowRatio(j, k), columns);
    const double* mass = masses.data() + first;
    Field from(in.begin() + first, in.begin() + first + columns);
    Field to = from;
    for (int pass = 0; pass < passes.Count; ++pass)
    {
      for (int i = 0; i < columns; ++i)
      {
        const int before = topology.Step(0, i, -1);
        const int after = topology.Step(0, i, +1);
        to[i] = SmoothedValue(
          from[i], mass[i], from[before], mass[before], from[after], mass[after], passes.Strength);
      }
      from.swap(to);
    }
    std::copy(from.begin(), from.end(), out.begin() + first);
  });
}

void FieldSmoother::PassAcrossRows(int axis, const Field& masses, const Field& in, Field& out) const
{
  const GridTopology& topology = this->Plan.Topology();
  const int columns = topology.Distinct(0);
  ForEachRow(topology, [&](int j, int k, std::int64_t row) {
    GridIndex neighbor = { { 0, j, k } };
    const int index = neighbor[axis];
    neighbor[axis] = topology.Step(axis, index, -1);
    const std::int64_t before = topology.Id(neighbor);
    neighbor[axis] = topology.Step(axis, index, +1);
    const std::int64_t after = topology.Id(neighbor);
    for (int i = 0; i < columns; ++i)
    {
      out[row + i] = SmoothedValue(in[row + i], masses[row + i], in[before + i], masses[before + i],
        in[after + i], masses[after + i]);
    }
  });
}

// As a deviation from the row's first value, so that a constant stays exactly.
void FieldSmoother::AverageAtPoles(const Field& masses, Field& field) const
{
  const GridTopology& topology = this->Plan.Topology();
  for (const PoleRow& pole : topology.Poles)
  {
    const int third = 3 - pole.Along - pole.Across;
    GridIndex at;
    at[pole.Across] = pole.AtEnd ? topology.Size[pole.Across] - 1 : 0;
    for (at[third] = 0; at[third] < topology.Distinct(third); ++at[third])
    {
      double reference = 0.0;
      double deviation = 0.0;
      double total = 0.0;
      double low = 0.0;
      double high = 0.0;
      for (at[pole.Along] = 0; at[pole.Along] < topology.Distinct(pole.Along); ++at[pole.Along])
      {
        const std::int64_t id = topology.Id(at);
        if (masses[id] > 0.0)
        {
          reference = total > 0.0 ? reference : field[id];
          low = std::min(low, field[id] - reference);
          high = std::max(high, field[id] - reference);
          deviation += masses[id] * (field[id] - reference);
          total += masses[id];
        }
      }
      const double mean = reference + std::max(low, std::min(high, deviation / total));
      for (at[pole.Along] = 0; at[pole.Along] < topology.Distinct(pole.Along); ++at[pole.Along])
      {
        const std::int64_t id = topology.Id(at);
        field[id] = masses[id] > 0.0 ? mean : field[id];
      }
    }
  }
}

void FieldSmoother::CopyToRepeated(Field& field) const
{
  const GridTopology& topology = this->Plan.Topology();
  if (!topology.Repeated[0] && !topology.Repeated[1] && !topology.Repeated[2])
  {
    return;
  }
  for (std::int64_t id = 0; id < topology.Count(); ++id)
  {
    const GridIndex at = topology.Index(id);
    field[id] = field[topology.Id(topology.Canonical(at))];
  }
}
}
