// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// A data object, composite or not, as its datasets.
#ifndef nephoscope_DataSets_h
#define nephoscope_DataSets_h

#include "vtkNephoscopeFiltersCommonModule.h" // for export macro

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <vector>

class vtkBoundingBox;
class vtkDataSet;

namespace nephoscope
{
// Calls function(leaf) for the leaves of a composite dataset, or for the data itself.
template <typename Function>
void ForEachLeaf(vtkDataObject* data, Function&& function)
{
  auto* composite = vtkCompositeDataSet::SafeDownCast(data);
  if (!composite)
  {
    function(data);
    return;
  }
  auto leaves = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
  {
    function(leaves->GetCurrentDataObject());
  }
}

// Those that have cells: the leaves of a composite dataset, or the dataset itself.
VTKNEPHOSCOPEFILTERSCOMMON_EXPORT std::vector<vtkDataSet*> DataSetsOf(vtkDataObject* data);

// Bounds of the points with finite positions; invalid if there are none.
VTKNEPHOSCOPEFILTERSCOMMON_EXPORT vtkBoundingBox FiniteBounds(vtkDataSet* set);
VTKNEPHOSCOPEFILTERSCOMMON_EXPORT vtkBoundingBox BoundsOf(const std::vector<vtkDataSet*>& sets);

// When the data or one of its leaves last changed; 0 without data.
VTKNEPHOSCOPEFILTERSCOMMON_EXPORT vtkMTimeType NewestMTime(vtkDataObject* data);

// Without cells, or with vertices as its only cells.
VTKNEPHOSCOPEFILTERSCOMMON_EXPORT bool HasOnlyVertices(vtkDataSet* data);

// Whether it is an image, a rectilinear or a structured grid.
VTKNEPHOSCOPEFILTERSCOMMON_EXPORT bool IsStructured(vtkDataObject* data);

// A copy that shares the arrays, and stays as it is when a reader fills its output anew.
VTKNEPHOSCOPEFILTERSCOMMON_EXPORT vtkSmartPointer<vtkDataObject> SharedCopy(vtkDataObject* data);
}

#endif
