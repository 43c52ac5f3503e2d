// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** The surfaces of a composite data set as one: thickness runs across the borders of its blocks. */
#ifndef JoinedSurfaces_h
#define JoinedSurfaces_h

#include "vtkAppendPolyData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>

namespace nephoscope
{

class JoinedSurfaces
{
public:
  /** Blocks without polygonal data are left out; each field array comes from the first block that has it. */
  vtkPolyData* Join(vtkCompositeDataSet* data)
  {
    vtkMTimeType time = data->GetMTime();
    forEachBlock(data, [&](vtkPolyData* block) { time = std::max(time, block->GetMTime()); });
    if (data == this->JoinedFrom && time == this->JoinedAt)
    {
      return this->Joined;
    }
    this->JoinedFrom = data;
    this->JoinedAt = time;
    vtkNew<vtkAppendPolyData> append;
    vtkNew<vtkFieldData> fields;
    forEachBlock(data, [&](vtkPolyData* block) {
      append->AddInputData(block);
      for (int i = 0; i < block->GetFieldData()->GetNumberOfArrays(); ++i)
      {
        vtkAbstractArray* array = block->GetFieldData()->GetAbstractArray(i);
        if (array->GetName() && !fields->HasArray(array->GetName()))
        {
          fields->AddArray(array);
        }
      }
    });
    this->Joined = vtkSmartPointer<vtkPolyData>::New();
    if (append->GetNumberOfInputConnections(0) > 0)
    {
      append->Update();
      this->Joined->ShallowCopy(append->GetOutput());
    }
    this->Joined->SetFieldData(fields);
    return this->Joined;
  }

private:
  template <typename Work>
  static void forEachBlock(vtkCompositeDataSet* data, Work work)
  {
    auto blocks = vtk::TakeSmartPointer(data->NewIterator());
    for (blocks->InitTraversal(); !blocks->IsDoneWithTraversal(); blocks->GoToNextItem())
    {
      auto* block = vtkPolyData::SafeDownCast(blocks->GetCurrentDataObject());
      if (block && block->GetNumberOfPoints() > 0)
      {
        work(block);
      }
    }
  }

  vtkCompositeDataSet* JoinedFrom = nullptr; // not to be looked into
  vtkMTimeType JoinedAt = 0;
  vtkSmartPointer<vtkPolyData> Joined;
};

} // namespace nephoscope

#endif
