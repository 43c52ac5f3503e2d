// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VelocityFields.h"

#include "CellAverages.h"
#include "CellVelocity.h"
#include "CompositeVelocity.h"
#include "DataSets.h"
#include "StructuredFields.h"
#include "UnboundedField.h"
#include "VelocityProblem.h"

#include "vtkBoundingBox.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

#include <cmath>

namespace nephoscope
{
namespace
{
struct PreparedLeaf
{
  std::unique_ptr<DataSetField> Field;
  vtkSmartPointer<vtkDataSet> OnPoints;
};

PreparedLeaf MakeLeaf(vtkDataSet* data, const VelocityArray& array, std::string& problem)
{
  problem = VelocityProblem(data, array);
  if (!problem.empty())
  {
    return {};
  }
  vtkSmartPointer<vtkDataSet> onPoints = data;
  if (array.OnCells)
  {
    onPoints = WithCellArraysOnPoints(data);
  }
  vtkDataArray* velocity = onPoints->GetPointData()->GetArray(array.Name.c_str());
  int dimensions[3];
  PreparedLeaf leaf;
  leaf.OnPoints = onPoints;
  if (StructuredSize(onPoints, dimensions))
  {
    leaf.Field = MakeStructuredField(onPoints, velocity);
  }
  else
  {
    leaf.Field = std::make_unique<CellVelocity>(onPoints, velocity);
  }
  return leaf;
}

// Refined levels have smaller cells, by a factor of two or more.
int RefinementOf(vtkDataSet* data)
{
  auto* image = vtkImageData::SafeDownCast(data);
  return image ? -static_cast<int>(std::lround(std::log2(image->GetSpacing()[0]))) : 0;
}

std::unique_ptr<DataSetField> MakeComposite(
  vtkCompositeDataSet* data, const VelocityArray& array, std::string& problem)
{
  const bool refined = data->IsA("vtkUniformGridAMR") || data->IsA("vtkAMRDataObject");
  std::vector<CompositeVelocity::Leaf> leaves;
  std::string firstProblem;
  auto iterator = vtk::TakeSmartPointer(data->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    auto* block = vtkDataSet::SafeDownCast(iterator->GetCurrentDataObject());
    std::string blockProblem;
    PreparedLeaf made;
    if (block && block->GetNumberOfCells() > 0)
    {
      made = MakeLeaf(block, array, blockProblem);
      firstProblem = firstProblem.empty() ? blockProblem : firstProblem;
    }
    if (made.Field)
    {
      CompositeVelocity::Leaf leaf;
      leaf.Field = std::move(made.Field);
      leaf.Arrays = made.OnPoints->GetPointData(); // the field holds the dataset
      leaf.Level = refined ? RefinementOf(block) : 0;
      double bounds[6];
      FiniteBounds(block).GetBounds(bounds);
      leaf.Bounds.Low = { bounds[0], bounds[2], bounds[4] };
      leaf.Bounds.High = { bounds[1], bounds[3], bounds[5] };
      leaves.push_back(std::move(leaf));
    }
  }
  if (leaves.empty())
  {
    problem = firstProblem.empty()
      ? "The composite dataset is empty: no block has cells. Check its reader."
      : "No block has a velocity field. The first says: " + firstProblem;
    return nullptr;
  }
  problem.clear();
  return std::make_unique<CompositeVelocity>(std::move(leaves));
}
}

std::unique_ptr<DataSetField> MakeVelocityField(
  vtkDataObject* data, const VelocityArray& array, std::string& problem)
{
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    return MakeComposite(composite, array, problem);
  }
  if (auto* set = vtkDataSet::SafeDownCast(data))
  {
    return MakeLeaf(set, array, problem).Field;
  }
  problem = data ? std::string("A ") + data->GetClassName() +
      " has no cells, so no velocity field. Give a dataset or a composite of datasets."
                 : "There is no dataset. Connect one to the filter.";
  return nullptr;
}

std::unique_ptr<VelocityField> MakeUnboundedField(
  vtkDataSet* data, const VelocityArray& array, std::string& problem)
{
  PreparedLeaf leaf = MakeLeaf(data, array, problem);
  if (!leaf.Field)
  {
    return nullptr;
  }
  vtkDataArray* velocity = leaf.OnPoints->GetPointData()->GetArray(array.Name.c_str());
  return std::make_unique<UnboundedField>(leaf.OnPoints, velocity, std::move(leaf.Field));
}
}
