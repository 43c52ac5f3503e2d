// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TetrahedronList.h"

#include "ProgressLoop.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <atomic>
#include <utility>

namespace nephoscope
{
namespace
{
vtkDataArray* ConnectivityOf(vtkDataSet* data)
{
  auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
  return grid && grid->GetCells() ? grid->GetCells()->GetConnectivityArray() : nullptr;
}

Tetrahedron Sorted(Tetrahedron t)
{
  std::sort(t.begin(), t.end());
  return t;
}
}

std::vector<Tetrahedron> TetrahedronList::Copy() const
{
  std::vector<Tetrahedron> copy(this->Size);
  for (std::size_t i = 0; i < this->Size; ++i)
  {
    copy[i] = (*this)[i];
  }
  return copy;
}

void TetrahedronList::Resize(std::size_t size)
{
  *this = TetrahedronList(std::vector<Tetrahedron>(size));
}

void TetrahedronList::ReadFrom(vtkDataSet* data)
{
  TetrahedronList cells;
  cells.Size = this->Size;
  cells.NumberOfPoints = static_cast<std::uint64_t>(data->GetNumberOfPoints());
  std::atomic<bool> same(cells.Attach(data));
  if (same)
  {
    ForEachIndex(this->Size, {}, [&](std::size_t i) {
      if (same && Sorted(this->List[i]) != Sorted(cells[i]))
      {
        same = false;
      }
    });
  }
  if (same)
  {
    *this = std::move(cells);
  }
}

bool TetrahedronList::Follow(vtkDataSet* data)
{
  return this->Input ? this->Attach(data) : !this->Lost;
}

bool TetrahedronList::Attach(vtkDataSet* data)
{
  vtkDataArray* ids = ConnectivityOf(data);
  const int size = ids && ids->HasStandardMemoryLayout() ? ids->GetDataTypeSize() : 0;
  if ((size != sizeof(std::int32_t) && size != sizeof(std::int64_t)) ||
    ids->GetNumberOfValues() < static_cast<vtkIdType>(4 * this->Size))
  {
    return false;
  }
  this->Input = ids;
  return this->Refresh();
}

bool TetrahedronList::Refresh(vtkDataSet* data)
{
  return (!this->Input || ConnectivityOf(data) == this->Input.Get()) && this->Refresh();
}

bool TetrahedronList::Refresh()
{
  if (!this->Input)
  {
    return !this->Lost;
  }
  if (this->Input->GetNumberOfValues() < static_cast<vtkIdType>(4 * this->Size))
  {
    *this = TetrahedronList();
    this->Lost = true;
    return false;
  }
  this->Ids = this->Input->GetVoidPointer(0);
  this->IdSize = this->Input->GetDataTypeSize();
  return true;
}

} // namespace nephoscope
