// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "HiddenSamples.h"

#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace nephoscope
{
namespace
{
using Flags = std::vector<unsigned char>;

constexpr int hiddenCell = vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::REFINEDCELL;

// Empty if none is set.
Flags FlagsOf(vtkUnsignedCharArray* ghosts, int mask)
{
  Flags flags;
  const vtkIdType count = ghosts ? ghosts->GetNumberOfTuples() : 0;
  for (vtkIdType id = 0; id < count; ++id)
  {
    if (ghosts->GetValue(id) & mask)
    {
      flags.resize(static_cast<std::size_t>(count), 0);
      flags[static_cast<std::size_t>(id)] = 1;
    }
  }
  return flags;
}

void HideCellsOfPoints(vtkDataSet* data, const Flags& points, Flags& cells)
{
  cells.resize(static_cast<std::size_t>(data->GetNumberOfCells()), 0);
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    data->GetCellPoints(cell, corners);
    const bool hidden = std::any_of(corners->begin(), corners->end(),
      [&](vtkIdType point) { return points[static_cast<std::size_t>(point)] != 0; });
    cells[static_cast<std::size_t>(cell)] |= static_cast<unsigned char>(hidden);
  }
}

void HidePointsOfCells(vtkDataSet* data, const Flags& cells, Flags& points)
{
  Flags ofDrawn(static_cast<std::size_t>(data->GetNumberOfPoints()), 0), ofHidden(ofDrawn);
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    data->GetCellPoints(cell, corners);
    Flags& of = cells[static_cast<std::size_t>(cell)] ? ofHidden : ofDrawn;
    for (const vtkIdType point : *corners)
    {
      of[static_cast<std::size_t>(point)] = 1;
    }
  }
  points.resize(ofDrawn.size(), 0);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    points[i] |= static_cast<unsigned char>(ofHidden[i] && !ofDrawn[i]);
  }
}
}

std::vector<unsigned char> FindHiddenSamples(vtkDataSet* data, bool onCells, bool withDuplicates)
{
  const int duplicateCell = withDuplicates ? 0 : int(vtkDataSetAttributes::DUPLICATECELL);
  if (onCells)
  {
    Flags cells = FlagsOf(data->GetCellGhostArray(), hiddenCell | duplicateCell);
    const Flags corners = FlagsOf(data->GetPointGhostArray(), vtkDataSetAttributes::HIDDENPOINT);
    if (!corners.empty())
    {
      HideCellsOfPoints(data, corners, cells);
    }
    return cells;
  }
  const int hiddenPoint = vtkDataSetAttributes::HIDDENPOINT |
    (withDuplicates ? 0 : int(vtkDataSetAttributes::DUPLICATEPOINT));
  Flags points = FlagsOf(data->GetPointGhostArray(), hiddenPoint);
  // One after the other: a point between a hidden cell of this process and a shown one of another
  // is shown.
  for (const int mask : { hiddenCell, duplicateCell })
  {
    const Flags cells = FlagsOf(data->GetCellGhostArray(), mask);
    if (!cells.empty())
    {
      HidePointsOfCells(data, cells, points);
    }
  }
  return points;
}

std::vector<unsigned char> FindHiddenCells(vtkDataSet* data)
{
  return FlagsOf(data->GetCellGhostArray(), hiddenCell);
}

} // namespace nephoscope
