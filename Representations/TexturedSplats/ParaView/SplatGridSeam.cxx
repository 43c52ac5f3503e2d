// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SplatGridSeam.h"

#include "SplatOwners.h"
#include "SplatSeam.h"

#include "vtkCommunicator.h"
#include "vtkDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkStructuredGrid.h"

#include <algorithm>

namespace nephoscope
{

SplatGridSeam::SplatGridSeam(vtkDataSet* piece, const std::vector<int>& extents)
{
  const int curved =
    vtkStructuredGrid::SafeDownCast(piece) && piece->GetNumberOfPoints() > 0 ? 1 : 0;
  int anyCurved = 0;
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  controller->AllReduce(&curved, &anyCurved, 1, vtkCommunicator::MAX_OP);
  for (std::size_t i = 0; i < extents.size(); ++i)
  {
    if (extents[i - i % 6] <= extents[i - i % 6 + 1]) // not of a rank without a piece
    {
      int& whole = this->Whole[i % 6];
      whole = i % 2 ? std::max(whole, extents[i]) : std::min(whole, extents[i]);
    }
  }
  if (!anyCurved || this->Whole[1] - this->Whole[0] + 1 < SplatSeam::FewestColumns)
  {
    return;
  }
  const auto rows = static_cast<std::size_t>(this->Whole[3] - this->Whole[2] + 1) *
    static_cast<std::size_t>(this->Whole[5] - this->Whole[4] + 1);
  this->Columns.assign(12 * rows, -VTK_DOUBLE_MAX);
  if (curved)
  {
    this->FillIn(piece);
  }
  std::vector<double> all(this->Columns.size());
  controller->AllReduce(
    this->Columns.data(), all.data(), static_cast<vtkIdType>(all.size()), vtkCommunicator::MAX_OP);
  this->Columns.swap(all);
  SplatSeam seam;
  for (std::size_t row = 0; row < rows; ++row)
  {
    seam.Compare(this->PlaceOf(0, row), this->PlaceOf(1, row), this->PlaceOf(3, row));
  }
  this->Closed = seam.IsClosed();
}

void SplatGridSeam::FillIn(vtkDataSet* piece)
{
  extentOf(piece, this->Mine);
  const std::size_t rows = this->Columns.size() / 12;
  for (vtkIdType id = 0; id < piece->GetNumberOfPoints(); ++id)
  {
    const int fromFirst = this->Column(id) - this->Whole[0];
    const int toLast = this->Whole[1] - this->Column(id);
    if (fromFirst < 2 || toLast < 2)
    {
      const auto column = static_cast<std::size_t>(fromFirst < 2 ? fromFirst : 3 - toLast);
      piece->GetPoint(id, &this->Columns[3 * (column * rows + this->Row(id))]);
    }
  }
}

int SplatGridSeam::Column(vtkIdType id) const
{
  return this->Mine[0] + static_cast<int>(id % (this->Mine[1] - this->Mine[0] + 1));
}

std::size_t SplatGridSeam::Row(vtkIdType id) const
{
  const vtkIdType above = id / (this->Mine[1] - this->Mine[0] + 1);
  const vtkIdType size = this->Mine[3] - this->Mine[2] + 1;
  const vtkIdType j = this->Mine[2] + above % size - this->Whole[2];
  const vtkIdType k = this->Mine[4] + above / size - this->Whole[4];
  return static_cast<std::size_t>(k * (this->Whole[3] - this->Whole[2] + 1) + j);
}

Vector3 SplatGridSeam::PlaceOf(std::size_t column, std::size_t row) const
{
  const double* place = &this->Columns[3 * (column * (this->Columns.size() / 12) + row)];
  return { { place[0], place[1], place[2] } };
}

void SplatGridSeam::MendEdge(vtkIdType id, SplatMatrix& jacobian) const
{
  if (this->Closed && this->Column(id) == this->Whole[0])
  {
    const Vector3 across = this->PlaceOf(1, this->Row(id)) - this->PlaceOf(2, this->Row(id));
    jacobian[0] = { { 0.5 * across[0], 0.5 * across[1], 0.5 * across[2] } };
  }
}

} // namespace nephoscope
