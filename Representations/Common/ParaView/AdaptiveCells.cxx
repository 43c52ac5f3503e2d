// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "AdaptiveCells.h"

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkHyperTreeGrid.h"
#include "vtkHyperTreeGridToUnstructuredGrid.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkStaticCleanUnstructuredGrid.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>

namespace nephoscope
{
namespace
{
struct Box
{
  double Bounds[6];
  double CellVolume;
};

Box BoxOf(vtkImageData* image)
{
  Box box;
  image->GetBounds(box.Bounds);
  const double* spacing = image->GetSpacing();
  box.CellVolume = spacing[0] * spacing[1] * spacing[2];
  return box;
}

// The cells of an image that have their centre between two bounds: first and last index along each
// axis. False without any.
bool CellsWithin(vtkImageData* image, const double bounds[6], int range[6])
{
  const double* origin = image->GetOrigin();
  const double* spacing = image->GetSpacing();
  int extent[6];
  image->GetExtent(extent);
  for (int axis = 0; axis < 3; ++axis)
  {
    const int size = std::max(1, extent[2 * axis + 1] - extent[2 * axis]);
    const double first = origin[axis] + spacing[axis] * (extent[2 * axis] + 0.5);
    const double low = std::ceil((bounds[2 * axis] - first) / spacing[axis]);
    const double high = std::floor((bounds[2 * axis + 1] - first) / spacing[axis]);
    range[2 * axis] = static_cast<int>(std::max(low, 0.0));
    range[2 * axis + 1] = static_cast<int>(std::min(high, size - 1.0));
    if (low >= size || high < 0.0 || range[2 * axis] > range[2 * axis + 1])
    {
      return false;
    }
  }
  return true;
}

vtkUnsignedCharArray* OwnGhosts(vtkImageData* image)
{
  vtkNew<vtkUnsignedCharArray> ghosts;
  if (vtkUnsignedCharArray* given = image->GetCellGhostArray())
  {
    ghosts->DeepCopy(given);
  }
  else
  {
    ghosts->SetNumberOfValues(image->GetNumberOfCells());
    ghosts->FillValue(0);
  }
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  image->GetCellData()->AddArray(ghosts);
  return image->GetCellGhostArray();
}

void HideCells(vtkImageData* image, const int range[6])
{
  int dimensions[3];
  image->GetDimensions(dimensions);
  const vtkIdType row = std::max(1, dimensions[0] - 1);
  const vtkIdType layer = row * std::max(1, dimensions[1] - 1);
  vtkUnsignedCharArray* ghosts = image->GetCellGhostArray();
  for (int k = range[4]; k <= range[5]; ++k)
  {
    for (int j = range[2]; j <= range[3]; ++j)
    {
      for (int i = range[0]; i <= range[1]; ++i)
      {
        const vtkIdType cell = i + row * j + layer * k;
        ghosts->SetValue(cell,
          ghosts->GetValue(cell) | vtkDataSetAttributes::REFINEDCELL |
            vtkDataSetAttributes::HIDDENCELL);
      }
    }
  }
}
} // namespace

vtkSmartPointer<vtkDataSet> LeafCells(vtkDataObject* leaf)
{
  if (!vtkHyperTreeGrid::SafeDownCast(leaf))
  {
    return vtkDataSet::SafeDownCast(leaf);
  }
  vtkNew<vtkHyperTreeGridToUnstructuredGrid> cells;
  cells->SetInputDataObject(leaf);
  vtkNew<vtkStaticCleanUnstructuredGrid> joined; // every cell has come with points of its own
  joined->SetInputConnection(cells->GetOutputPort());
  joined->SetTolerance(1e-9);
  joined->Update();
  return joined->GetOutput();
}

void HideCoveredCells(std::vector<vtkSmartPointer<vtkDataSet>>& blocks)
{
  std::vector<Box> boxes;
  for (auto& block : blocks)
  {
    auto image = vtkImageData::SafeDownCast(block);
    if (!image)
    {
      return; // no AMR data
    }
    auto copy = vtkSmartPointer<vtkImageData>::Take(image->NewInstance());
    copy->ShallowCopy(image);
    OwnGhosts(copy); // all blocks need one, or appending drops it
    boxes.push_back(BoxOf(copy));
    block = copy;
  }
  for (std::size_t coarse = 0; coarse < blocks.size(); ++coarse)
  {
    auto image = vtkImageData::SafeDownCast(blocks[coarse]);
    for (const Box& fine : boxes)
    {
      int range[6];
      if (fine.CellVolume < 0.75 * boxes[coarse].CellVolume &&
        CellsWithin(image, fine.Bounds, range))
      {
        HideCells(image, range);
      }
    }
  }
}

} // namespace nephoscope
