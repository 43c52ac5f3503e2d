// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VdbArrays.h"

namespace nephoscope
{

openvdb::GridBase::Ptr NewGridFor(vtkDataArray* array, VdbPrecision precision)
{
  const bool isDouble = array->GetDataType() == VTK_DOUBLE && precision == VdbPrecision::AsInput;
  if (array->GetNumberOfComponents() == 3)
  {
    return isDouble ? openvdb::GridBase::Ptr(openvdb::Vec3DGrid::create())
                    : openvdb::GridBase::Ptr(openvdb::Vec3SGrid::create());
  }
  if (array->GetNumberOfComponents() != 1)
  {
    return {};
  }
  switch (array->GetDataType())
  {
    case VTK_FLOAT:
      return openvdb::FloatGrid::create();
    case VTK_DOUBLE:
      return isDouble ? openvdb::GridBase::Ptr(openvdb::DoubleGrid::create())
                      : openvdb::GridBase::Ptr(openvdb::FloatGrid::create());
    case VTK_BIT:
      return openvdb::BoolGrid::create();
    default:
      break;
  }
  const bool wide = array->GetDataTypeSize() > 4 || array->GetDataType() == VTK_UNSIGNED_INT;
  return wide ? openvdb::GridBase::Ptr(openvdb::Int64Grid::create())
              : openvdb::GridBase::Ptr(openvdb::Int32Grid::create());
}

} // namespace nephoscope
