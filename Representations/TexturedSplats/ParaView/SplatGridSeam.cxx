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
namespace
{
int SizeAlong(const int extent[6], int axis)
{
  return extent[2 * axis + 1] - extent[2 * axis] + 1;
}
}

SplatGridSeam::SplatGridSeam(vtkDataSet* piece, const std::vector<int>& extents, int axis)
  : Axis(axis)
  , Across{ (axis + 1) % 3, (axis + 2) % 3 }
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
  if (piece)
  {
    ExtentOf(piece, this->Mine);
  }
  if (!anyCurved || SizeAlong(this->Whole, axis) < SplatSeam::FewestColumns)
  {
    return;
  }
  const auto rows = static_cast<std::size_t>(SizeAlong(this->Whole, this->Across[0])) *
    static_cast<std::size_t>(SizeAlong(this->Whole, this->Across[1]));
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
  const std::size_t rows = this->Columns.size() / 12;
  for (vtkIdType id = 0; id < piece->GetNumberOfPoints(); ++id)
  {
    const int fromFirst = this->Column(id) - this->Whole[2 * this->Axis];
    const int toLast = this->Whole[2 * this->Axis + 1] - this->Column(id);
    if (fromFirst < 2 || toLast < 2)
    {
      const auto column = static_cast<std::size_t>(fromFirst < 2 ? fromFirst : 3 - toLast);
      piece->GetPoint(id, &this->Columns[3 * (column * rows + this->Row(id))]);
    }
  }
}

// In the whole grid.
int SplatGridSeam::IndexOf(vtkIdType id, int axis) const
{
  for (int lower = 0; lower < axis; ++lower)
  {
    id /= SizeAlong(this->Mine, lower);
  }
  return this->Mine[2 * axis] + static_cast<int>(id % SizeAlong(this->Mine, axis));
}

int SplatGridSeam::Column(vtkIdType id) const
{
  return this->IndexOf(id, this->Axis);
}

std::size_t SplatGridSeam::Row(vtkIdType id) const
{
  const int a = this->Across[0], b = this->Across[1];
  const vtkIdType j = this->IndexOf(id, a) - this->Whole[2 * a];
  const vtkIdType k = this->IndexOf(id, b) - this->Whole[2 * b];
  return static_cast<std::size_t>(k * SizeAlong(this->Whole, a) + j);
}

Vector3 SplatGridSeam::PlaceOf(std::size_t column, std::size_t row) const
{
  const double* place = &this->Columns[3 * (column * (this->Columns.size() / 12) + row)];
  return { { place[0], place[1], place[2] } };
}

double SplatGridSeam::ShareInGrid(vtkIdType id) const
{
  const int first = this->Whole[2 * this->Axis], last = this->Whole[2 * this->Axis + 1];
  const int column = this->Column(id);
  return first < last && (column == first || column == last) && !this->Closed ? 0.5 : 1.0;
}

void SplatGridSeam::MendEdge(vtkIdType id, SplatMatrix& jacobian) const
{
  if (this->Closed && this->Column(id) == this->Whole[2 * this->Axis])
  {
    const Vector3 across = this->PlaceOf(1, this->Row(id)) - this->PlaceOf(2, this->Row(id));
    Vector3& column = jacobian[static_cast<std::size_t>(this->Axis)];
    // At a pole there is no length across; beside it needles have been widened.
    const double length = 0.5 * Norm(across), widened = Norm(column);
    const double scale = 0.5 * (widened > 1.5 * length ? widened / length : 1.0);
    column = length > 1e-6 * widened
      ? Vector3{ { scale * across[0], scale * across[1], scale * across[2] } }
      : column;
  }
}

} // namespace nephoscope
