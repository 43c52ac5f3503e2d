// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** VTK's arrays as grids of OpenVDB: which type of grid, and the values. */
#ifndef nephoscope_VdbArrays_h
#define nephoscope_VdbArrays_h

#include "VdbGrids.h"
#include "VdbWriting.h"

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

#include <openvdb/openvdb.h>

namespace nephoscope
{

/** Values of an array of any type, as a grid holds them. */
template <typename Value>
class ArrayValues
{
public:
  explicit ArrayValues(vtkDataArray* array);

  Value operator()(vtkIdType id) const { return this->Get(this->Data, id); }

private:
  vtkSmartPointer<vtkDataArray>
    Kept; // a copy, where the array does not keep its values one after another
  const void* Data;
  Value (*Get)(const void* data, vtkIdType id) = nullptr;
};

/** Numbers, and all components of vectors. */
template <typename Value>
bool IsFiniteValue(const Value& value)
{
  using Traits = openvdb::VecTraits<Value>;
  if constexpr (Traits::IsVec)
  {
    return std::isfinite(static_cast<double>(value[0]) + value[1] + value[2]);
  }
  else
  {
    return std::isfinite(static_cast<double>(value));
  }
}

/** Absolute value, or length of a vector. */
template <typename Value>
double Magnitude(const Value& value)
{
  if constexpr (openvdb::VecTraits<Value>::IsVec)
  {
    return std::sqrt(
      double(value[0]) * value[0] + double(value[1]) * value[1] + double(value[2]) * value[2]);
  }
  else
  {
    return std::abs(static_cast<double>(value));
  }
}

/**
 * An empty grid of the type that fits the array, or null if none does (other than one or three
 * components).
 */
openvdb::GridBase::Ptr NewGridFor(vtkDataArray* array, VdbPrecision precision);

namespace detail
{
template <typename Value, typename Scalar>
Value getValue(const void* data, vtkIdType id)
{
  const auto* values = static_cast<const Scalar*>(data);
  if constexpr (openvdb::VecTraits<Value>::IsVec)
  {
    using Element = typename openvdb::VecTraits<Value>::ElementType;
    return Value(static_cast<Element>(values[3 * id]), static_cast<Element>(values[3 * id + 1]),
      static_cast<Element>(values[3 * id + 2]));
  }
  else
  {
    return static_cast<Value>(values[id]);
  }
}
}

template <typename Value>
ArrayValues<Value>::ArrayValues(vtkDataArray* array)
  : Kept(array)
{
  if (!array->HasStandardMemoryLayout() || array->GetDataType() == VTK_BIT)
  {
    this->Kept = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(
      array->GetDataType() == VTK_BIT ? VTK_UNSIGNED_CHAR : array->GetDataType()));
    this->Kept->DeepCopy(array);
  }
  this->Data = this->Kept->GetVoidPointer(0);
  switch (this->Kept->GetDataType())
  {
    vtkTemplateMacro((this->Get = &detail::getValue<Value, VTK_TT>));
  }
}

} // namespace nephoscope

#endif
