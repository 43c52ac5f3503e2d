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
    return isDouble ? openvdb::GridBase::Ptr(NewGrid<openvdb::Vec3DGrid>())
                    : NewGrid<openvdb::Vec3SGrid>();
  }
  if (array->GetNumberOfComponents() != 1)
  {
    return {};
  }
  switch (array->GetDataType())
  {
    case VTK_FLOAT:
      return NewGrid<openvdb::FloatGrid>();
    case VTK_DOUBLE:
      return isDouble ? openvdb::GridBase::Ptr(NewGrid<openvdb::DoubleGrid>())
                      : NewGrid<openvdb::FloatGrid>();
    case VTK_BIT:
      return NewGrid<openvdb::BoolGrid>();
    default:
      break;
  }
  const bool wide = array->GetDataTypeSize() > 4 || array->GetDataType() == VTK_UNSIGNED_INT;
  return wide ? openvdb::GridBase::Ptr(NewGrid<openvdb::Int64Grid>())
              : NewGrid<openvdb::Int32Grid>();
}

} // namespace nephoscope
