// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MovedData.h"

#include "vtkBoundingBox.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkMatrixToLinearTransform.h"
#include "vtkNew.h"
#include "vtkRectilinearGrid.h"
#include "vtkTransformFilter.h"

namespace nephoscope
{
namespace
{
bool Turns(vtkMatrix4x4* matrix)
{
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      const double element = matrix->GetElement(row, column);
      if (row == column ? !(element > 0.0) : element != 0.0)
      {
        return true;
      }
    }
  }
  return false;
}

vtkSmartPointer<vtkDataSet> MovedRectilinear(vtkRectilinearGrid* grid, vtkMatrix4x4* matrix)
{
  auto moved = vtkSmartPointer<vtkRectilinearGrid>::Take(grid->NewInstance());
  moved->ShallowCopy(grid);
  vtkDataArray* const old[3] = { grid->GetXCoordinates(), grid->GetYCoordinates(),
    grid->GetZCoordinates() };
  vtkNew<vtkDoubleArray> coordinates[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    coordinates[axis]->SetNumberOfTuples(old[axis]->GetNumberOfTuples());
    for (vtkIdType i = 0; i < old[axis]->GetNumberOfTuples(); ++i)
    {
      coordinates[axis]->SetValue(i,
        matrix->GetElement(axis, axis) * old[axis]->GetComponent(i, 0) +
          matrix->GetElement(axis, 3));
    }
  }
  moved->SetXCoordinates(coordinates[0]);
  moved->SetYCoordinates(coordinates[1]);
  moved->SetZCoordinates(coordinates[2]);
  return moved;
}

vtkSmartPointer<vtkDataSet> MovedImage(vtkImageData* image, vtkMatrix4x4* matrix)
{
  auto moved = vtkSmartPointer<vtkImageData>::Take(image->NewInstance());
  moved->ShallowCopy(image);
  double origin[4] = { 0, 0, 0, 1 }, spacing[3];
  image->GetOrigin(origin);
  image->GetSpacing(spacing);
  matrix->MultiplyPoint(origin, origin);
  for (int axis = 0; axis < 3; ++axis)
  {
    spacing[axis] *= matrix->GetElement(axis, axis);
  }
  moved->SetOrigin(origin);
  moved->SetSpacing(spacing);
  return moved;
}

}

bool TurnsOrShifts(vtkMatrix4x4* matrix)
{
  return Turns(matrix) || matrix->GetElement(0, 3) != 0.0 || matrix->GetElement(1, 3) != 0.0 ||
    matrix->GetElement(2, 3) != 0.0;
}

vtkSmartPointer<vtkDataSet> MovedData(vtkDataSet* data, vtkMatrix4x4* matrix)
{
  auto* image = vtkImageData::SafeDownCast(data);
  if (image && !Turns(matrix) && image->GetDirectionMatrix()->IsIdentity())
  {
    return MovedImage(image, matrix);
  }
  auto* rectilinear = vtkRectilinearGrid::SafeDownCast(data);
  if (rectilinear && !Turns(matrix))
  {
    return MovedRectilinear(rectilinear, matrix);
  }
  vtkNew<vtkMatrixToLinearTransform> transform;
  transform->SetInput(matrix);
  vtkNew<vtkTransformFilter> filter;
  filter->SetInputData(data);
  filter->SetTransform(transform);
  filter->TransformAllInputVectorsOn();
  filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  filter->Update();
  auto moved =
    vtkSmartPointer<vtkDataSet>(vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0)));
  moved->GetFieldData()->ShallowCopy(data->GetFieldData());
  return moved;
}

void MoveBounds(double bounds[6], vtkMatrix4x4* matrix)
{
  vtkBoundingBox moved;
  for (int corner = 0; corner < 8; ++corner)
  {
    double x[4] = { bounds[corner & 1], bounds[2 + (corner >> 1 & 1)], bounds[4 + (corner >> 2)],
      1 };
    matrix->MultiplyPoint(x, x);
    moved.AddPoint(x);
  }
  moved.GetBounds(bounds);
}

} // namespace nephoscope
