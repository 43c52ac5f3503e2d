// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VdbReading.h"
#include "VdbValues.h"

#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"

#include <openvdb/tools/Dense.h>

namespace nephoscope
{
namespace
{
template <typename GridT>
vtkSmartPointer<vtkDataArray> FillImage(
  const GridT& grid, const VdbValues<GridT>& values, const std::string& name, const int e[6])
{
  using Traits = VdbArrayTraits<GridT>;
  const vtkIdType row = vtkIdType(e[1]) - e[0] + 1, rows = vtkIdType(e[3]) - e[2] + 1,
                  slices = vtkIdType(e[5]) - e[4] + 1;
  auto array = Traits::NewArray(name, row * rows * slices);
  auto* data = static_cast<typename Traits::Scalar*>(array->GetVoidPointer(0));
  if constexpr (std::is_same<typename Traits::Scalar, typename Traits::Element>::value)
  {
    if (values.IsStored()) // leaf by leaf
    {
      const openvdb::CoordBBox box(
        openvdb::Coord(e[0], e[2], e[4]), openvdb::Coord(e[1], e[3], e[5]));
      openvdb::tools::Dense<typename Traits::Value, openvdb::tools::LayoutXYZ> dense(
        box, reinterpret_cast<typename Traits::Value*>(data));
      openvdb::tools::copyToDense(grid, dense);
      return array;
    }
  }
  vtkSMPTools::For(0, rows * slices, [&](vtkIdType begin, vtkIdType end) {
    const auto accessor = values.Accessor();
    for (vtkIdType line = begin; line < end; ++line)
    {
      openvdb::Coord voxel(
        e[0], e[2] + static_cast<int>(line % rows), e[4] + static_cast<int>(line / rows));
      for (vtkIdType i = 0; i < row; ++i, ++voxel.x())
      {
        Traits::Store(values.At(accessor, voxel), data + (line * row + i) * Traits::Components);
      }
    }
  });
  return array;
}
}

std::string ReadVdbImage(const VdbRequest& request, vtkImageData* image, std::vector<std::string>&)
{
  int extent[6];
  image->GetExtent(extent);
  double voxels = 1;
  std::string size;
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto length = vtkTypeInt64(extent[2 * axis + 1]) - extent[2 * axis] + 1;
    voxels *= static_cast<double>(length);
    size += (axis ? " x " : "") + std::to_string(length);
  }
  std::string error = CheckMemory(voxels * BytesOfValues(request), request.MemoryLimit,
    "An image of " + size + " voxels",
    "read the grids as points, choose fewer of them, or raise MemoryLimit.");
  if (!error.empty())
  {
    return error;
  }
  VdbRead read = ReadGrids(request);
  for (std::size_t i = 0; i < read.Grids.size() && read.Error.empty(); ++i)
  {
    const VdbGridInfo& info = request.Grids[i];
    read.Grids[i]->apply<VdbGridTypes>([&](const auto& grid) {
      using GridT = std::decay_t<decltype(grid)>;
      const VdbValues<GridT> values(grid, info, request.Grids[0].IndexToWorld);
      image->GetPointData()->AddArray(FillImage(grid, values, info.Name, extent));
    });
    read.Grids[i].reset(); // no longer needed
  }
  ChooseActiveArrays(image->GetPointData());
  return read.Error;
}

} // namespace nephoscope
