// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TransitionCells.h"

#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkSMPTools.h"

#include <algorithm>

namespace nephoscope
{

TransitionCells::TransitionCells(vtkDataSet* data, const std::vector<SplitBatch>& batches)
  : Data(data)
  , Touched(static_cast<std::size_t>(data->GetNumberOfPoints()), 0)
{
  for (const SplitBatch& batch : batches)
  {
    this->Faces.insert(this->Faces.end(), batch.DividedFaces.begin(), batch.DividedFaces.end());
  }
  std::sort(this->Faces.begin(), this->Faces.end());
  for (const FaceKey& face : this->Faces)
  {
    for (vtkIdType point : face)
    {
      this->Touched[static_cast<std::size_t>(point)] = 1;
    }
  }
}

void TransitionCells::Convert(std::vector<SplitBatch>& batches) const
{
  vtkSMPTools::For(
    0, static_cast<vtkIdType>(batches.size()), 1, [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType b = begin; b < end; ++b)
      {
        this->ConvertBatch(batches[static_cast<std::size_t>(b)]);
      }
    });
}

bool TransitionCells::Touches(const vtkIdType* begin, const vtkIdType* end) const
{
  return std::count_if(begin, end, [this](vtkIdType point) {
    return point >= 0 && point < static_cast<vtkIdType>(this->Touched.size()) &&
      this->Touched[point] != 0;
  }) >= static_cast<std::ptrdiff_t>(std::tuple_size<FaceKey>::value);
}

void TransitionCells::ConvertBatch(SplitBatch& batch) const
{
  CellTetrahedra cell(this->Data);
  SplitCells& cells = batch.Volume;
  vtkIdType begin = 0;
  for (std::size_t i = 0; i < cells.Size(); ++i)
  {
    const bool alone = (i == 0 || cells.Sources[i - 1] != cells.Sources[i]) &&
      (i + 1 == cells.Size() || cells.Sources[i + 1] != cells.Sources[i]);
    if (alone && this->Touches(cells.Corners.data() + begin, cells.Corners.data() + cells.Ends[i]))
    {
      cell.Load(cells.Sources[i]);
      const auto first = static_cast<vtkIdType>(batch.FaceStreams.size());
      if (this->MakeFaces(cell, batch.FaceStreams))
      {
        cells.Types[i] = VTK_POLYHEDRON;
        batch.Transitions.push_back({ static_cast<vtkIdType>(i), first });
      }
    }
    begin = cells.Ends[i];
  }
}

// Appends the number of faces, then the size and the points of each; or nothing, if no face is
// divided.
bool TransitionCells::MakeFaces(CellTetrahedra& cell, std::vector<vtkIdType>& stream) const
{
  const std::size_t start = stream.size();
  bool divided = false;
  stream.push_back(0);
  cell.ForEachFace([&](const int* begin, const int* end) {
    if (std::binary_search(this->Faces.begin(), this->Faces.end(), cell.KeyOf(begin, end)))
    {
      divided = true;
      CellTetrahedra::EmitFan(begin, end, [&](int a, int b, int c) {
        ++stream[start];
        stream.insert(stream.end(), { 3, cell.Point(a), cell.Point(b), cell.Point(c) });
      });
    }
    else if (end - begin >= 3)
    {
      ++stream[start];
      stream.push_back(static_cast<vtkIdType>(end - begin));
      std::for_each(begin, end, [&](int vertex) { stream.push_back(cell.Point(vertex)); });
    }
  });
  if (!divided)
  {
    stream.resize(start);
  }
  return divided;
}

} // namespace nephoscope
