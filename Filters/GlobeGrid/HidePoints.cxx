// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "HidePoints.h"

#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace nephoscope
{
namespace
{
// The array of that name, carried from the input or new.
vtkUnsignedCharArray* GhostArray(vtkDataSetAttributes* data, vtkIdType count)
{
  const char* name = vtkDataSetAttributes::GhostArrayName();
  if (auto* carried = vtkUnsignedCharArray::SafeDownCast(data->GetArray(name)))
  {
    return carried;
  }
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(name);
  ghosts->SetNumberOfTuples(count);
  ghosts->FillValue(0);
  data->AddArray(ghosts);
  return ghosts; // held by data
}

// The up to eight cells that touch a point; `size` counts points, and a flat axis has one layer of
// cells.
void HideCellsAround(int i, int j, int k, const int size[3], vtkUnsignedCharArray* ghosts)
{
  const int at[3] = { i, j, k };
  int first[3], last[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const int cells = std::max(size[axis] - 1, 1);
    first[axis] = std::max(at[axis] - 1, 0);
    last[axis] = std::min(at[axis], cells - 1);
  }
  const vtkIdType columns = std::max(size[0] - 1, 1);
  const vtkIdType rows = std::max(size[1] - 1, 1);
  for (int c = first[2]; c <= last[2]; ++c)
  {
    for (int b = first[1]; b <= last[1]; ++b)
    {
      for (int a = first[0]; a <= last[0]; ++a)
      {
        const vtkIdType cell = a + columns * (b + rows * c);
        ghosts->SetValue(cell, ghosts->GetValue(cell) | vtkDataSetAttributes::HIDDENCELL);
      }
    }
  }
}
}

void HidePoints(const std::vector<unsigned char>& flags, vtkStructuredGrid* output)
{
  if (std::all_of(flags.begin(), flags.end(), [](unsigned char h) { return h == 0; }))
  {
    return;
  }
  vtkUnsignedCharArray* pointGhosts =
    GhostArray(output->GetPointData(), output->GetNumberOfPoints());
  vtkUnsignedCharArray* cellGhosts = GhostArray(output->GetCellData(), output->GetNumberOfCells());
  int size[3];
  output->GetDimensions(size);
  vtkIdType id = 0;
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i, ++id)
      {
        if (flags[id])
        {
          pointGhosts->SetValue(id, pointGhosts->GetValue(id) | vtkDataSetAttributes::HIDDENPOINT);
          HideCellsAround(i, j, k, size, cellGhosts);
        }
      }
    }
  }
}
}
