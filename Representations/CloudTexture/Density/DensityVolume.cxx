// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DensityVolume.h"

#include "DataSets.h"
#include "DensityCells.h"
#include "DensityImage.h"

#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <vector>

namespace nephoscope
{
namespace
{
vtkDataArray* ArrayOf(vtkDataSetAttributes* attributes, const std::string& name)
{
  return name.empty() ? attributes->GetScalars() : attributes->GetArray(name.c_str());
}

/** The density of the points where there is such an array, else of the cells. */
DensityBlock DensityOf(vtkDataSet* block, const std::string& name)
{
  vtkDataArray* ofPoints = ArrayOf(block->GetPointData(), name);
  return { block, ofPoints ? ofPoints : ArrayOf(block->GetCellData(), name), !ofPoints };
}

std::string ErrorOf(const DensityBlock& block, const std::string& name)
{
  if (!block.Densities)
  {
    return name.empty()
      ? "has no active scalars: choose one of its arrays as DensityArrayName"
      : "has no point array '" + name + "' of the density, and no such cell array";
  }
  const char* its = block.Densities->GetName();
  const int components = block.Densities->GetNumberOfComponents();
  return components == 1
    ? std::string()
    : "needs an array of one component: " + std::string(its ? its : "its scalars") + " has " +
      std::to_string(components);
}

bool IsPlainImage(const DensityBlock& block)
{
  return !block.OnCells && vtkImageData::SafeDownCast(block.Data) &&
    !block.Data->GetCellGhostArray() && !block.Data->GetPointGhostArray();
}

std::unique_ptr<DensityVolume> MakeImage(const DensityBlock& block, std::string& error)
{
  auto* image = vtkImageData::SafeDownCast(block.Data);
  const int* size = image->GetDimensions();
  if (std::min({ size[0], size[1], size[2] }) < 2)
  {
    error = "needs two points or more along each axis";
    return nullptr;
  }
  return std::unique_ptr<DensityVolume>(new DensityImage(image, block.Densities));
}
}

std::unique_ptr<DensityVolume> MakeDensityVolume(
  vtkDataObject* data, const std::string& name, std::string& error)
{
  error.clear();
  if (!data)
  {
    return nullptr;
  }
  std::vector<DensityBlock> blocks;
  std::size_t without = 0;
  for (vtkDataSet* block : DataSetsOf(data))
  {
    const DensityBlock density = DensityOf(block, name);
    const std::string wrong = ErrorOf(density, name);
    without += !wrong.empty();
    error = wrong.empty() ? error : wrong;
    if (wrong.empty())
    {
      blocks.push_back(density);
    }
  }
  if (blocks.empty())
  {
    error = !error.empty() ? error
      : vtkDataSet::SafeDownCast(data) || vtkCompositeDataSet::SafeDownCast(data)
      ? "has no cells"
      : "is a " + std::string(data->GetClassName()) +
        ", which has no cells to integrate in: convert it to an unstructured grid";
    return nullptr;
  }
  if (blocks.size() == 1 && without == 0 && IsPlainImage(blocks.front()))
  {
    return MakeImage(blocks.front(), error);
  }
  std::unique_ptr<DensityCells> cells(new DensityCells);
  const std::string told = error;
  error = cells->Take(blocks);
  if (!error.empty())
  {
    return nullptr;
  }
  if (without > 0)
  {
    cells->Warning = "is incomplete: one of its blocks " + told +
      (cells->Warning.empty() ? "" : "; it " + cells->Warning);
  }
  return cells;
}

} // namespace nephoscope
