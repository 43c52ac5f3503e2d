// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** The surfaces of a composite data set as one: thickness runs across the borders of its blocks. */
#ifndef nephoscope_JoinedSurfaces_h
#define nephoscope_JoinedSurfaces_h

#include "vtkAppendPolyData.h"
#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <string>
#include <vector>

namespace nephoscope
{

/** The array that surfaces are coloured by: the name, empty if none, and whether it is on cells. */
struct SurfaceColorArray
{
  std::string Name;
  bool OnCells = false;

  bool operator==(const SurfaceColorArray& other) const
  {
    return this->Name == other.Name && this->OnCells == other.OnCells;
  }

  vtkDataSetAttributes* Of(vtkPolyData* surface) const
  {
    return surface->GetAttributes(this->OnCells ? vtkDataObject::CELL : vtkDataObject::POINT);
  }
};

/** By the scalar modes for field data; none by the others. */
inline SurfaceColorArray ColoredArrayOf(vtkMapper* mapper)
{
  const bool onCells = mapper->GetScalarMode() == VTK_SCALAR_MODE_USE_CELL_FIELD_DATA;
  const bool isNamed = mapper->GetScalarVisibility() &&
    mapper->GetArrayAccessMode() == VTK_GET_ARRAY_BY_NAME &&
    (onCells || mapper->GetScalarMode() == VTK_SCALAR_MODE_USE_POINT_FIELD_DATA);
  const char* name = isNamed ? mapper->GetArrayName() : nullptr;
  return { name ? name : "", onCells };
}

/** In joined surfaces of which some lack the coloured array: 1 where they do, 0 elsewhere. */
constexpr const char* withoutColorName = "NephoscopeWithoutColor";

class JoinedSurfaces
{
public:
  /**
   * Blocks without polygonal data are left out; each field array comes from the first block that
   * has it. Those other arrays remain that all blocks have, and the coloured one, which is 0 in the
   * others.
   */
  vtkPolyData* Join(vtkCompositeDataSet* data, const SurfaceColorArray& colored)
  {
    vtkMTimeType time = data->GetMTime();
    forEachBlock(data, [&](vtkPolyData* block) { time = std::max(time, block->GetMTime()); });
    if (data == this->JoinedFrom && time == this->JoinedAt && colored == this->Colored)
    {
      return this->Joined;
    }
    this->JoinedFrom = data;
    this->JoinedAt = time;
    this->Colored = colored;
    vtkDataArray* model = this->FindPartial(data);
    vtkNew<vtkAppendPolyData> append;
    vtkNew<vtkFieldData> fields;
    forEachBlock(data, [&](vtkPolyData* block) {
      const vtkSmartPointer<vtkPolyData> complete = this->Complete(block, model);
      append->AddInputData(complete);
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
  /** The coloured array of the first block that has it, if others do not; otherwise null. */
  vtkDataArray* FindPartial(vtkCompositeDataSet* data) const
  {
    vtkDataArray* model = nullptr;
    bool isPartial = false;
    forEachBlock(data, [&](vtkPolyData* block) {
      vtkDataArray* array = this->Colored.Of(block)->GetArray(this->Colored.Name.c_str());
      isPartial = isPartial || !array;
      model = model ? model : array;
    });
    return isPartial ? model : nullptr;
  }

  /**
   * A copy that shares the arrays, with the coloured one and what tells where it has been missing;
   * without a model, the block.
   */
  vtkSmartPointer<vtkPolyData> Complete(vtkPolyData* block, vtkDataArray* model) const
  {
    if (!model)
    {
      return block;
    }
    auto result = vtkSmartPointer<vtkPolyData>::New();
    result->ShallowCopy(block);
    vtkDataSetAttributes* arrays = this->Colored.Of(result);
    const vtkIdType count =
      this->Colored.OnCells ? result->GetNumberOfCells() : result->GetNumberOfPoints();
    const bool lacks = !arrays->HasArray(model->GetName());
    vtkNew<vtkUnsignedCharArray> without;
    without->SetName(withoutColorName);
    without->SetNumberOfTuples(count);
    without->FillValue(lacks ? 1 : 0);
    arrays->AddArray(without);
    if (lacks)
    {
      auto array = vtk::TakeSmartPointer(model->NewInstance());
      array->SetName(model->GetName());
      array->SetNumberOfComponents(model->GetNumberOfComponents());
      array->SetNumberOfTuples(count);
      array->Fill(0.0);
      arrays->AddArray(array);
    }
    return result;
  }

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
  SurfaceColorArray Colored;
  vtkSmartPointer<vtkPolyData> Joined;
};

} // namespace nephoscope

#endif
