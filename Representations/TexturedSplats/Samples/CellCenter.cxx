// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellCenter.h"

#include "CellKinds.h"
#include "CellMoments.h"

#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace nephoscope
{
namespace
{
// Null for other types; tetrahedra and voxels have the mean of their corners.
const CellKind* KindOf(int type)
{
  return type == VTK_HEXAHEDRON ? &hexahedron
    : type == VTK_WEDGE         ? &wedge
    : type == VTK_PYRAMID       ? &pyramid
                                : nullptr;
}
}

Vector3 CenterOfCell(vtkDataSet* data, vtkIdType id)
{
  vtkNew<vtkIdList> corners;
  data->GetCellPoints(id, corners);
  if (const CellKind* kind = KindOf(data->GetCellType(id)))
  {
    Vector3 x[8];
    for (int i = 0; i < kind->Corners; ++i)
    {
      data->GetPoint(corners->GetId(i), x[i].data());
    }
    const CellMoments moments = MomentsOf(*kind, x);
    if (moments.GetSize() > 0 && std::isfinite(moments.GetSize()))
    {
      return moments.GetCenter();
    }
  }
  std::vector<Vector3> places;
  for (const vtkIdType corner : *corners)
  {
    Vector3 x;
    data->GetPoint(corner, x.data());
    if (std::find(places.begin(), places.end(), x) == places.end())
    {
      places.push_back(x);
    }
  }
  Vector3 sum{};
  for (const Vector3& x : places)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      sum[c] += x[c] / static_cast<double>(places.size());
    }
  }
  return sum;
}
}
