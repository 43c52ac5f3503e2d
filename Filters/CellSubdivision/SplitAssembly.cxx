// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SplitAssembly.h"

#include "vtkBitArray.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <numeric>

namespace nephoscope
{
namespace
{
// One cell's faces, as vtkUnstructuredGrid::InsertNextCell takes them.
void CopyFaces(const std::vector<vtkIdType>& streams, vtkIdType first, vtkIdList* faces)
{
  auto at = static_cast<std::size_t>(first);
  faces->Reset();
  vtkIdType left = streams[at];
  faces->InsertNextId(streams[at++]);
  for (; left > 0; --left)
  {
    for (vtkIdType size = streams[at]; size >= 0; --size)
    {
      faces->InsertNextId(streams[at++]);
    }
  }
}
}

SplitAssembly::SplitAssembly(vtkDataSet* input, const ContourLevels& levels,
  std::vector<SplitBatch>& batches, const CutNumbering& cuts, const SplitPoints& points)
  : Input(input)
  , Levels(levels)
  , Points(points)
  , NumberOfInputPoints(input->GetNumberOfPoints())
{
  for (std::size_t b = 0; b < batches.size(); ++b)
  {
    this->AddPart(batches[b].Volume, &batches[b], &cuts.Numbers[b]);
  }
  for (std::size_t b = 0; b < batches.size(); ++b)
  {
    this->AddPart(batches[b].Surface, nullptr, &cuts.Numbers[b]);
  }
  this->CollectFacesOnLevels(batches);
  this->AddPart(this->FacesOnLevels, nullptr, nullptr);
}

void SplitAssembly::AddPart(
  const SplitCells& cells, const SplitBatch* batch, const std::vector<vtkIdType>* cutNumbers)
{
  this->Parts.push_back({ &cells, batch, cutNumbers, this->NumberOfCells, this->NumberOfCorners });
  this->NumberOfCells += static_cast<vtkIdType>(cells.Size());
  this->NumberOfCorners += static_cast<vtkIdType>(cells.Corners.size());
}

// A face with cells above its value on both sides comes twice: the first one stays.
void SplitAssembly::CollectFacesOnLevels(const std::vector<SplitBatch>& batches)
{
  std::vector<FaceOnLevel> faces;
  for (const SplitBatch& batch : batches)
  {
    faces.insert(faces.end(), batch.FacesOnLevels.begin(), batch.FacesOnLevels.end());
  }
  std::vector<std::size_t> order(faces.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b) { return faces[a].Key < faces[b].Key; });
  const auto same = [&](std::size_t a, std::size_t b) { return faces[a].Key == faces[b].Key; };
  order.erase(std::unique(order.begin(), order.end(), same), order.end());
  std::sort(order.begin(), order.end());
  for (std::size_t i : order)
  {
    SplitCells& to = this->FacesOnLevels;
    to.Corners.insert(to.Corners.end(), faces[i].Corners.begin(), faces[i].Corners.end());
    to.EndCell(VTK_TRIANGLE, faces[i].Source, faces[i].Level);
  }
}

vtkIdType SplitAssembly::PointOf(vtkIdType corner, const Part& part) const
{
  if (corner < 0)
  {
    return this->Points.FirstCut() + (*part.CutNumbers)[static_cast<std::size_t>(-1 - corner)];
  }
  return corner < this->NumberOfInputPoints
    ? corner
    : this->Points.CentreNumber(corner - this->NumberOfInputPoints);
}

template <typename Function>
void SplitAssembly::ForEachPart(Function&& function) const
{
  vtkSMPTools::For(
    0, static_cast<vtkIdType>(this->Parts.size()), 1, [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType p = begin; p < end; ++p)
      {
        function(this->Parts[static_cast<std::size_t>(p)]);
      }
    });
}

bool SplitAssembly::HasPolyhedra() const
{
  return std::any_of(this->Parts.begin(), this->Parts.end(), [](const Part& part) {
    const auto& types = part.Cells->Types;
    return std::find(types.begin(), types.end(), VTK_POLYHEDRON) != types.end();
  });
}

void SplitAssembly::AddCells(vtkUnstructuredGrid* output) const
{
  this->HasPolyhedra() ? this->InsertOneByOne(output) : this->AddCellArrays(output);
}

void SplitAssembly::AddCellArrays(vtkUnstructuredGrid* output) const
{
  vtkNew<vtkUnsignedCharArray> types;
  vtkNew<vtkIdTypeArray> offsets;
  vtkNew<vtkIdTypeArray> corners;
  types->SetNumberOfValues(this->NumberOfCells);
  offsets->SetNumberOfValues(this->NumberOfCells + 1);
  corners->SetNumberOfValues(this->NumberOfCorners);
  offsets->SetValue(0, 0);
  this->ForEachPart([&](const Part& part) {
    const SplitCells& cells = *part.Cells;
    std::copy(cells.Types.begin(), cells.Types.end(), types->GetPointer(0) + part.FirstCell);
    vtkIdType* ends = offsets->GetPointer(0) + part.FirstCell + 1;
    for (vtkIdType end : cells.Ends)
    {
      *ends++ = part.FirstCorner + end;
    }
    vtkIdType* points = corners->GetPointer(0) + part.FirstCorner;
    for (vtkIdType corner : cells.Corners)
    {
      *points++ = this->PointOf(corner, part);
    }
  });
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, corners);
  output->SetCells(types, cells);
}

// Polyhedra have faces besides points.
void SplitAssembly::InsertOneByOne(vtkUnstructuredGrid* output) const
{
  output->AllocateEstimate(this->NumberOfCells, 6);
  for (const Part& part : this->Parts)
  {
    this->InsertPart(part, output);
  }
}

void SplitAssembly::InsertPart(const Part& part, vtkUnstructuredGrid* output) const
{
  auto* source = vtkUnstructuredGrid::SafeDownCast(this->Input);
  vtkNew<vtkIdList> faces;
  std::vector<vtkIdType> corners;
  const SplitCells& cells = *part.Cells;
  std::size_t transition = 0; // the next one
  vtkIdType begin = 0;
  for (std::size_t i = 0; i < cells.Size(); ++i)
  {
    if (cells.Types[i] != VTK_POLYHEDRON)
    {
      corners.clear();
      for (vtkIdType k = begin; k < cells.Ends[i]; ++k)
      {
        corners.push_back(this->PointOf(cells.Corners[static_cast<std::size_t>(k)], part));
      }
      output->InsertNextCell(
        cells.Types[i], static_cast<vtkIdType>(corners.size()), corners.data());
    }
    else
    {
      const auto& transitions = part.Batch->Transitions;
      if (transition < transitions.size() &&
        transitions[transition].Piece == static_cast<vtkIdType>(i))
      {
        CopyFaces(part.Batch->FaceStreams, transitions[transition++].FirstFace, faces);
      }
      else
      {
        source->GetFaceStream(cells.Sources[i], faces);
      }
      output->InsertNextCell(VTK_POLYHEDRON, faces);
    }
    begin = cells.Ends[i];
  }
}

void SplitAssembly::CarryCellArrays(vtkUnstructuredGrid* output) const
{
  vtkDataSetAttributes* input = this->Input->GetCellData();
  for (int a = 0; a < input->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* from = input->GetAbstractArray(a);
    auto to =
      vtkSmartPointer<vtkAbstractArray>::Take(vtkAbstractArray::CreateArray(from->GetDataType()));
    to->SetName(from->GetName());
    to->SetNumberOfComponents(from->GetNumberOfComponents());
    to->CopyComponentNames(from);
    to->SetNumberOfTuples(this->NumberOfCells);
    const auto copy = [&](const Part& part) {
      for (std::size_t i = 0; i < part.Cells->Size(); ++i)
      {
        to->SetTuple(part.FirstCell + static_cast<vtkIdType>(i), part.Cells->Sources[i], from);
      }
    };
    if (vtkDataArray::SafeDownCast(to) && !vtkBitArray::SafeDownCast(to))
    {
      this->ForEachPart(copy);
    }
    else // neighbouring bits share a byte; text is not for threads
    {
      std::for_each(this->Parts.begin(), this->Parts.end(), copy);
    }
    output->GetCellData()->AddArray(to);
    // Several pieces have the id of their cell, so that the ids stay plain arrays.
    const int attribute = input->IsArrayAnAttribute(a);
    if (attribute >= 0 && attribute != vtkDataSetAttributes::GLOBALIDS &&
      attribute != vtkDataSetAttributes::PEDIGREEIDS)
    {
      output->GetCellData()->SetActiveAttribute(from->GetName(), attribute);
    }
  }
}

void SplitAssembly::AddLayers(vtkUnstructuredGrid* output) const
{
  vtkNew<vtkIntArray> layers;
  vtkNew<vtkIntArray> contours;
  layers->SetName("Layer");
  contours->SetName("ContourIndex");
  layers->SetNumberOfValues(this->NumberOfCells);
  contours->SetNumberOfValues(this->NumberOfCells);
  this->ForEachPart([&](const Part& part) {
    for (std::size_t i = 0; i < part.Cells->Size(); ++i)
    {
      // A polygon on the value number k has k values below it.
      const int layer = part.Cells->Layers[i];
      layers->SetValue(part.FirstCell + static_cast<vtkIdType>(i), layer);
      contours->SetValue(
        part.FirstCell + static_cast<vtkIdType>(i), part.Batch ? -1 : this->Levels.Index(layer));
    }
  });
  output->GetCellData()->AddArray(layers);
  output->GetCellData()->AddArray(contours);
}

} // namespace nephoscope
