// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// What vtkSunSource tells in its field data.
#ifndef nephoscope_SharedSun_h
#define nephoscope_SharedSun_h

#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"

#include <array>

namespace nephoscope
{
/**
 * Unit vectors towards the sun: for data that are not on a globe, and for those of vtkGlobeGrid
 * that are.
 */
struct SharedSun
{
  std::array<double, 3> Direction = { { 0, 0, 0 } };
  std::array<double, 3> DirectionOnGlobe = { { 0, 0, 0 } };
};

inline void WriteSun(const SharedSun& sun, vtkDataObject* data)
{
  const auto add = [data](const char* name, const std::array<double, 3>& direction) {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->SetNumberOfComponents(3);
    array->InsertNextTuple(direction.data());
    data->GetFieldData()->AddArray(array);
  };
  add("SunDirection", sun.Direction);
  add("SunDirectionOnGlobe", sun.DirectionOnGlobe);
}

/** False: the data have no sun. */
inline bool ReadSun(vtkDataObject* data, SharedSun& sun)
{
  const auto take = [data](const char* name, std::array<double, 3>& direction) {
    vtkDataArray* array = data ? data->GetFieldData()->GetArray(name) : nullptr;
    const bool found =
      array && array->GetNumberOfComponents() == 3 && array->GetNumberOfTuples() > 0;
    if (found)
    {
      array->GetTuple(0, direction.data());
    }
    return found;
  };
  if (!take("SunDirection", sun.Direction))
  {
    return false;
  }
  sun.DirectionOnGlobe = sun.Direction;
  take("SunDirectionOnGlobe", sun.DirectionOnGlobe);
  return true;
}
}

#endif
