// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "JoinedClouds.h"

#include "TetrahedronSource.h"

#include "vtkCellData.h"
#include "vtkCommunicator.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRectilinearGrid.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <memory>
#include <numeric>

namespace nephoscope
{
namespace
{
constexpr int opticalFields = 4; // extinction, albedo, asymmetry, weight

// At each point, the mean of the cells around it that are drawn.
class CellMeans
{
public:
  explicit CellMeans(vtkDataSet* data)
    : Data(data)
    , Copy(vtkSmartPointer<vtkDataSet>::Take(data->NewInstance()))
    , Weights(static_cast<std::size_t>(data->GetNumberOfPoints()), 0.0f)
  {
    this->Copy->CopyStructure(data);
    this->ForPoints([this](vtkIdType, vtkIdType p) { ++this->Weights[p]; });
  }

  vtkDataSet* GetCopy() const { return this->Copy; }
  std::vector<float> GetWeights() const { return this->Weights; }

  void Add(const std::string& name)
  {
    vtkDataArray* onCells = this->Data->GetCellData()->GetArray(name.c_str());
    if (!onCells)
    {
      this->Copy->GetPointData()->AddArray(this->Data->GetPointData()->GetArray(name.c_str()));
      return;
    }
    vtkNew<vtkDoubleArray> means;
    means->SetName(name.c_str());
    means->SetNumberOfTuples(this->Data->GetNumberOfPoints());
    means->FillValue(0);
    double* values = means->GetPointer(0);
    this->ForPoints([&](vtkIdType cell, vtkIdType p) {
      values[p] += onCells->GetComponent(cell, 0) / this->Weights[p];
    });
    this->Copy->GetPointData()->AddArray(means);
  }

private:
  template <typename Body>
  void ForPoints(Body body)
  {
    TetrahedronSource cells(this->Data);
    for (vtkIdType cell = 0; cell < this->Data->GetNumberOfCells(); ++cell)
    {
      if (!cells.IsHidden(cell))
      {
        for (const vtkIdType p : *cells.GetPoints())
        {
          body(cell, p);
        }
      }
    }
  }

  vtkDataSet* Data;
  vtkSmartPointer<vtkDataSet> Copy;
  std::vector<float> Weights;
};

bool IsInSinglePrecision(vtkDataSet* data)
{
  auto* set = vtkPointSet::SafeDownCast(data);
  auto* grid = vtkRectilinearGrid::SafeDownCast(data);
  return (set && set->GetPoints() && set->GetPoints()->GetDataType() == VTK_FLOAT) ||
    (grid && grid->GetXCoordinates()->GetDataType() == VTK_FLOAT);
}

// Points with their optics, and cells. A cell is its type, its division (ChessboardDivision.h), a
// count, and as many numbers: its points, or the stream of its faces.
struct Pieces
{
  vtkNew<vtkDoubleArray> Places;
  vtkNew<vtkFloatArray> Optics;
  vtkNew<vtkIdTypeArray> Cells;
  int IsSingle = 0;

  Pieces()
  {
    this->Places->SetNumberOfComponents(3);
    this->Optics->SetNumberOfComponents(opticalFields);
  }

  void Add(const CloudPart& part, vtkIdType before)
  {
    const vtkIdType first = before + this->Places->GetNumberOfTuples();
    for (vtkIdType p = 0; p < part.Data->GetNumberOfPoints(); ++p)
    {
      this->Places->InsertNextTuple(part.Data->GetPoint(p));
      const float optics[opticalFields] = { part.Optics.Extinction[p], part.Optics.Albedo[p],
        part.Optics.Asymmetry[p], part.Weights.empty() ? 1.0f : part.Weights[p] };
      this->Optics->InsertNextTypedTuple(optics);
    }
    this->AddCells(part.Data, first);
    this->IsSingle = this->IsSingle || IsInSinglePrecision(part.Data) ? 1 : 0;
  }

private:
  void AddCells(vtkDataSet* data, vtkIdType first)
  {
    auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
    auto* divisions =
      vtkUnsignedCharArray::SafeDownCast(data->GetCellData()->GetArray(divisionName));
    TetrahedronSource cells(data);
    vtkNew<vtkIdList> faces;
    for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
    {
      if (cells.IsHidden(cell))
      {
        continue;
      }
      const bool hasFaces = grid && data->GetCellType(cell) == VTK_POLYHEDRON;
      hasFaces ? grid->GetFaceStream(cell, faces) : void();
      vtkIdList* ids = hasFaces ? faces.Get() : cells.GetPoints();
      this->Cells->InsertNextValue(data->GetCellType(cell));
      this->Cells->InsertNextValue(divisions ? divisions->GetValue(cell) : 0);
      this->Cells->InsertNextValue(ids->GetNumberOfIds());
      for (const vtkIdType id : *ids)
      {
        this->Cells->InsertNextValue(id);
      }
      vtkIdType* own =
        this->Cells->GetPointer(this->Cells->GetNumberOfValues() - ids->GetNumberOfIds());
      forPoints(hasFaces, own, ids->GetNumberOfIds(), [first](vtkIdType& id) { id += first; });
    }
  }

public:
  /** Calls body(id) for the points of a cell. */
  template <typename Body>
  static void forPoints(bool hasFaces, vtkIdType* ids, vtkIdType count, Body body)
  {
    if (!hasFaces)
    {
      std::for_each(ids, ids + count, body);
      return;
    }
    for (vtkIdType* face = ids + 1; face < ids + count; face += *face + 1)
    {
      std::for_each(face + 1, face + 1 + *face, body);
    }
  }
};

// The arrays of all ranks, one after the other.
template <typename Array>
void Gather(vtkMultiProcessController* ranks, Array* array)
{
  if (ranks)
  {
    vtkNew<Array> all;
    all->SetNumberOfComponents(array->GetNumberOfComponents());
    ranks->AllGatherV(array, all);
    array->ShallowCopy(all);
  }
}

std::vector<Place> PlacesOf(const Pieces& pieces)
{
  std::vector<Place> places(static_cast<std::size_t>(pieces.Places->GetNumberOfTuples()));
  for (std::size_t p = 0; p < places.size(); ++p)
  {
    pieces.Places->GetTypedTuple(static_cast<vtkIdType>(p), places[p].data());
    for (double& x : places[p])
    {
      x = pieces.IsSingle ? static_cast<float>(x) : x; // points of both precisions coincide
    }
  }
  return places;
}

// The number of each place in `points`, where coincident places are one point.
std::vector<std::int32_t> NumbersOf(const std::vector<Place>& places, vtkPoints* points)
{
  std::vector<std::int32_t> numbers = MergedPoints(places);
  points->SetDataTypeToDouble();
  for (std::size_t p = 0; p < numbers.size(); ++p)
  {
    const auto first = static_cast<std::size_t>(numbers[p]);
    numbers[p] = first == p ? static_cast<std::int32_t>(points->InsertNextPoint(places[p].data()))
                            : numbers[first];
  }
  return numbers;
}

OpticalFields MeansOf(
  vtkFloatArray* optics, const std::vector<std::int32_t>& numbers, std::size_t count)
{
  std::vector<std::array<double, opticalFields>> sums(count, { { 0, 0, 0, 0 } });
  for (std::size_t p = 0; p < numbers.size(); ++p)
  {
    float own[opticalFields];
    optics->GetTypedTuple(static_cast<vtkIdType>(p), own);
    auto& sum = sums[numbers[p]];
    for (int k = 0; k < opticalFields - 1; ++k)
    {
      sum[k] += double(own[opticalFields - 1]) * own[k];
    }
    sum.back() += own[opticalFields - 1];
  }
  OpticalFields means;
  for (const auto& sum : sums)
  {
    const double weight = sum.back() > 0 ? sum.back() : 1;
    means.Extinction.push_back(static_cast<float>(sum[0] / weight));
    means.Albedo.push_back(static_cast<float>(sum[1] / weight));
    means.Asymmetry.push_back(static_cast<float>(sum[2] / weight));
  }
  return means;
}

void AppendCells(
  vtkUnstructuredGrid* mesh, vtkIdTypeArray* cells, const std::vector<std::int32_t>& numbers)
{
  vtkNew<vtkUnsignedCharArray> divisions;
  divisions->SetName(divisionName);
  mesh->Allocate(cells->GetNumberOfValues() / 8);
  vtkNew<vtkIdList> list;
  constexpr int head = 3;
  for (vtkIdType at = 0; at < cells->GetNumberOfValues();)
  {
    vtkIdType* cell = cells->GetPointer(at);
    const vtkIdType type = cell[0], count = cell[2];
    Pieces::forPoints(
      type == VTK_POLYHEDRON, cell + head, count, [&numbers](vtkIdType& id) { id = numbers[id]; });
    list->SetNumberOfIds(count);
    std::copy(cell + head, cell + head + count, list->GetPointer(0));
    mesh->InsertNextCell(static_cast<int>(type), list);
    divisions->InsertNextValue(static_cast<unsigned char>(cell[1]));
    at += head + count;
  }
  mesh->GetCellData()->AddArray(divisions);
}
}

CloudPart::CloudPart(vtkDataSet* data, const OpticalArrays& arrays)
  : Data(data)
{
  vtkDataSet* source = data;
  std::unique_ptr<CellMeans> means;
  if (!data->GetPointData()->HasArray(arrays[0].Name.c_str()))
  {
    means = std::make_unique<CellMeans>(data);
    std::for_each(
      arrays.begin(), arrays.end(), [&](const OpticalArray& array) { means->Add(array.Name); });
    this->Weights = means->GetWeights();
    source = means->GetCopy();
  }
  vtkIdType ignored = 0;
  const auto values = [&](int k, vtkIdType& wrong) {
    return ValuesOf(source, arrays[k].Name, arrays[k].Otherwise, arrays[k].Scale, wrong);
  };
  this->Optics = { values(0, this->Wrong), values(1, ignored), values(2, ignored) };
}

namespace
{
// Field data, which describe the planet and the sun: those of the first rank that has points.
void ShareFieldData(
  vtkMultiProcessController* ranks, const std::vector<vtkIdType>& counts, vtkFieldData* fields)
{
  const auto first = std::find_if(counts.begin(), counts.end(), [](vtkIdType n) { return n > 0; });
  if (ranks && first != counts.end())
  {
    vtkNew<vtkPolyData> holder;
    holder->GetFieldData()->ShallowCopy(fields);
    ranks->Broadcast(holder, static_cast<int>(first - counts.begin()));
    fields->ShallowCopy(holder->GetFieldData());
  }
}
}

void JoinedClouds::Join(vtkMultiProcessController* ranks)
{
  std::vector<vtkIdType> counts(ranks ? ranks->GetNumberOfProcesses() : 1, 0);
  const vtkIdType own = std::accumulate(this->Parts.begin(), this->Parts.end(), vtkIdType(0),
    [](vtkIdType sum, const CloudPart& part) { return sum + part.Data->GetNumberOfPoints(); });
  counts[0] = own;
  ranks ? ranks->AllGather(&own, counts.data(), 1) : 0;
  const int rank = ranks ? ranks->GetLocalProcessId() : 0;
  vtkIdType first = std::accumulate(counts.begin(), counts.begin() + rank, vtkIdType(0));
  Pieces pieces;
  for (const CloudPart& part : this->Parts)
  {
    pieces.Add(part, first);
  }
  Gather(ranks, pieces.Places.Get());
  Gather(ranks, pieces.Optics.Get());
  Gather(ranks, pieces.Cells.Get());
  const int isSingle = pieces.IsSingle;
  ranks ? ranks->AllReduce(&isSingle, &pieces.IsSingle, 1, vtkCommunicator::MAX_OP) : 0;

  vtkNew<vtkPoints> points;
  const std::vector<std::int32_t> numbers = NumbersOf(PlacesOf(pieces), points);
  this->Mesh = vtkSmartPointer<vtkUnstructuredGrid>::New();
  this->Mesh->SetPoints(points);
  this->Optics =
    MeansOf(pieces.Optics, numbers, static_cast<std::size_t>(points->GetNumberOfPoints()));
  AppendCells(this->Mesh, pieces.Cells, numbers);
  for (CloudPart& part : this->Parts)
  {
    const auto begin = numbers.begin() + first;
    first += part.Data->GetNumberOfPoints();
    part.Numbers.assign(begin, numbers.begin() + first);
  }
  if (!this->Parts.empty())
  {
    this->Mesh->GetFieldData()->ShallowCopy(this->Parts.front().Data->GetFieldData());
  }
  ShareFieldData(ranks, counts, this->Mesh->GetFieldData());
}
}
