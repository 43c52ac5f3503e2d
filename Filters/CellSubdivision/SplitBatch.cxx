// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SplitBatch.h"

#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkWedge.h"

#include <utility>

namespace nephoscope
{
namespace
{
// VTK 9.7 turned its wedges: the points of their first triangle were counter-clockwise seen from
// outside.
bool WedgeBeginsOutside()
{
  static const bool beginsOutside = vtkWedge::GetFaceArray(0)[1] == 1;
  return beginsOutside;
}

int TypeOf(PieceShape shape)
{
  constexpr int types[] = { VTK_EMPTY_CELL, VTK_EMPTY_CELL, VTK_EMPTY_CELL, VTK_TRIANGLE, VTK_QUAD,
    VTK_TETRA, VTK_PYRAMID, VTK_WEDGE, VTK_HEXAHEDRON };
  return types[static_cast<int>(shape)];
}

void AddPiece(SplitCells& cells, Piece<vtkIdType> piece, vtkIdType source, int layer)
{
  if (piece.Shape == PieceShape::Wedge && !WedgeBeginsOutside())
  {
    std::swap(piece.Corners[1], piece.Corners[2]);
    std::swap(piece.Corners[4], piece.Corners[5]);
  }
  cells.Corners.insert(cells.Corners.end(), piece.Corners.begin(),
    piece.Corners.begin() + NumberOfCorners(piece.Shape));
  cells.EndCell(TypeOf(piece.Shape), source, layer);
}
}

CellSplitter::CellSplitter(
  vtkDataSet* data, const ContourScalars& scalars, const Settings& settings)
  : NumberOfPoints(data->GetNumberOfPoints())
  , Scalars(scalars)
  , With(settings)
  , Cell(data)
{
}

SplitBatch CellSplitter::Split(vtkIdType begin, vtkIdType end)
{
  this->Batch = SplitBatch();
  for (vtkIdType cell = begin; cell < end; ++cell)
  {
    this->AddCell(cell);
  }
  this->Batch.Cuts = this->Cuts.TakeCuts();
  return std::move(this->Batch);
}

void CellSplitter::AddCell(vtkIdType cell)
{
  this->CellNumber = cell;
  switch (this->Cell.Load(cell))
  {
    case CellTetrahedra::Kind::Hidden:
      return;
    case CellTetrahedra::Kind::Flat:
      this->Batch.Flat.Add(cell);
      return;
    default:
      break;
  }
  this->ReadCodes();
  const auto codes = std::minmax_element(this->Codes.begin(), this->Codes.end());
  const int least = *codes.first;
  const int largest = *codes.second;
  if (least == ContourLevels::MissingCode)
  {
    this->Batch.Missing.Add(cell);
    this->AddWhole(-1);
  }
  else if (IsCrossed(least, largest))
  {
    this->AddDivided();
  }
  else
  {
    this->AddWhole(HighestLayer(largest));
    if (this->With.Surfaces && (least & 1) != 0 && largest > least)
    {
      this->AddFacesOnLevel(least);
    }
  }
}

void CellSplitter::ReadCodes()
{
  const auto size = static_cast<std::size_t>(this->Cell.Size());
  this->Corners.resize(size);
  this->Codes.resize(size);
  for (std::size_t i = 0; i < size; ++i)
  {
    this->Corners[i] = this->Cell.Point(static_cast<int>(i));
    this->Codes[i] = this->Scalars.Code(this->Corners[i]);
  }
}

void CellSplitter::AddWhole(int layer)
{
  SplitCells& cells = this->Batch.Volume;
  cells.Corners.insert(cells.Corners.end(), this->Corners.begin(), this->Corners.end());
  cells.EndCell(this->Cell.Type(), this->CellNumber, layer);
}

void CellSplitter::AddDivided()
{
  const bool convex = this->Cell.Divide();
  if (this->Cell.Tetrahedra().empty())
  {
    this->Batch.Undivided.Add(this->CellNumber);
    this->AddWhole(-1);
    return;
  }
  if (!convex)
  {
    this->Batch.NotConvex.Add(this->CellNumber);
  }
  if (this->Cell.IsHigherOrder())
  {
    this->Batch.NotLinear.Add(this->CellNumber);
  }
  if (this->With.Transitions)
  {
    this->CollectDividedFaces();
  }
  if (this->Cell.Centre() >= 0)
  {
    this->PlaceCentre();
  }
  for (const CellTetrahedra::Tetrahedron& part : this->Cell.Tetrahedra())
  {
    this->AddTetrahedron(part);
  }
}

// The scalar in the middle is the mean of the vertices', as that of a linear field is.
void CellSplitter::PlaceCentre()
{
  CellCentre centre;
  centre.Cell = this->CellNumber;
  centre.Place = this->Cell.PlaceOf(this->Cell.Centre());
  double low = this->Scalars.Value(this->Corners[0]);
  double high = low;
  double sum = 0;
  for (vtkIdType point : this->Corners)
  {
    const double value = this->Scalars.Value(point);
    low = std::min(low, value);
    high = std::max(high, value);
    sum += value / static_cast<double>(this->Corners.size());
  }
  centre.Scalar = this->Scalars.Snap(sum, high - low, this->Cell);
  this->Codes.push_back(this->Scalars.Levels().Code(centre.Scalar));
  this->Corners.push_back(this->NumberOfPoints + this->CellNumber);
  this->Batch.Centres.push_back(centre);
}

void CellSplitter::AddTetrahedron(const CellTetrahedra::Tetrahedron& part)
{
  std::array<int, 4> v = part.Vertices;
  bool mirrored = part.Volume < 0;
  const auto order = [&](int a, int b) {
    if (this->Codes[v[b]] < this->Codes[v[a]])
    {
      std::swap(v[a], v[b]);
      mirrored = !mirrored;
    }
  };
  order(0, 1);
  order(2, 3);
  order(0, 2);
  order(1, 3);
  order(1, 2);
  std::array<vtkIdType, 4> corners;
  std::array<int, 4> codes;
  for (int i = 0; i < 4; ++i)
  {
    corners[i] = this->Corners[v[i]];
    codes[i] = this->Codes[v[i]];
  }
  if (this->With.Surfaces && (codes[0] & 1) != 0 && codes[2] == codes[0] && codes[3] > codes[0])
  {
    const vtkIdType second = corners[mirrored ? 2 : 1];
    const vtkIdType third = corners[mirrored ? 1 : 2];
    this->AddFaceOnLevel({ { corners[0], second, third } }, codes[0] / 2);
  }
  const auto cut = [&](int i, int j, int level) {
    const PointCut key{ std::min(corners[i], corners[j]), std::max(corners[i], corners[j]), level };
    return -1 - static_cast<vtkIdType>(this->Cuts.Number(key));
  };
  TetrahedronSplitter<vtkIdType, decltype(cut)> splitter(corners, codes, mirrored, cut);
  splitter.Split([&](const Piece<vtkIdType>& piece,
                   int layer) { AddPiece(this->Batch.Volume, piece, this->CellNumber, layer); },
    [&](const Piece<vtkIdType>& polygon, int level) {
      if (this->With.Surfaces)
      {
        AddPiece(this->Batch.Surface, polygon, this->CellNumber, level);
      }
    });
}

void CellSplitter::AddFaceOnLevel(const std::array<vtkIdType, 3>& corners, int level)
{
  FaceOnLevel face{ corners, corners, this->CellNumber, level };
  std::sort(face.Key.begin(), face.Key.end());
  this->Batch.FacesOnLevels.push_back(face);
}

void CellSplitter::CollectDividedFaces()
{
  this->Cell.VisitFaces([this](const int* begin, const int* end) {
    const auto order = [this](int a, int b) { return this->Codes[a] < this->Codes[b]; };
    if (end - begin < 4)
    {
      return;
    }
    const auto codes = std::minmax_element(begin, end, order);
    if (!IsCrossed(this->Codes[*codes.first], this->Codes[*codes.second]))
    {
      this->Batch.DividedFaces.push_back(this->Cell.KeyOf(begin, end));
    }
  });
}

// The cell lies above the value and has a face on it.
void CellSplitter::AddFacesOnLevel(int code)
{
  if (std::count(this->Codes.begin(), this->Codes.end(), code) < 3)
  {
    return;
  }
  this->Cell.EmitFaceTriangles(
    [&](const int* begin, const int* end) {
      return std::all_of(begin, end, [&](int vertex) { return this->Codes[vertex] == code; });
    },
    [&](int a, int b, int c) {
      this->AddFaceOnLevel({ { this->Corners[a], this->Corners[b], this->Corners[c] } }, code / 2);
    });
}

} // namespace nephoscope
