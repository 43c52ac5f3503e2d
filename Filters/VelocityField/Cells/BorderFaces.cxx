// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BorderFaces.h"

#include "GridCell.h"
#include "HiddenCells.h"
#include "LinearCellFaces.h"
#include "StructuredFields.h"

#include "vtkCell.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>

namespace nephoscope
{
namespace
{
class FaceCollection
{
public:
  explicit FaceCollection(vtkDataSet* data)
    : Data(data)
  {
  }

  void AddCell(vtkIdType cell)
  {
    const FaceList<int> faces = LinearCellFaces(this->Data->GetCellType(cell));
    faces.Begin ? this->AddLinear(cell, faces) : this->AddOther(cell);
  }

  // Without those that two cells share.
  std::vector<FaceCorners> Border()
  {
    std::sort(this->Faces.begin(), this->Faces.end(),
      [](const Face& a, const Face& b) { return a.Key < b.Key; });
    std::vector<FaceCorners> border;
    for (std::size_t i = 0, end = 0; i < this->Faces.size(); i = end)
    {
      for (end = i + 1; end < this->Faces.size() && this->Faces[end].Key == this->Faces[i].Key;)
      {
        ++end;
      }
      if (end == i + 1)
      {
        this->AddPolygon(this->Faces[i], border);
      }
    }
    return border;
  }

private:
  struct Face
  {
    std::array<vtkIdType, 4> Key; // the number of corners and the three lowest of them
    FaceCorners Corners;          // of more than four: the first, and which polygon
    bool IsPolygon;
  };

  void AddLinear(vtkIdType cell, FaceList<int> faces)
  {
    this->Data->GetCellPoints(cell, this->Ids);
    for (const int* face = faces.Begin; face != faces.End; face += *face + 1)
    {
      vtkIdType ids[6];
      std::transform(
        face + 1, face + 1 + *face, ids, [this](int i) { return this->Ids->GetId(i); });
      this->AddFace(ids, static_cast<std::size_t>(*face));
    }
  }

  void AddOther(vtkIdType cell)
  {
    this->Data->GetCell(cell, this->Cell);
    const bool isSolid = this->Cell->GetCellDimension() == 3;
    for (int f = 0; isSolid && f < this->Cell->GetNumberOfFaces(); ++f)
    {
      vtkCell* face = this->Cell->GetFace(f);
      this->AddFace(
        face->GetPointIds()->GetPointer(0), static_cast<std::size_t>(face->GetNumberOfEdges()));
    }
  }

  void AddFace(const vtkIdType* ids, std::size_t count)
  {
    if (count < 3)
    {
      return;
    }
    Face face{ { static_cast<vtkIdType>(count) }, { ids[0], ids[1], ids[2], -1 }, count > 4 };
    std::partial_sort_copy(ids, ids + count, face.Key.begin() + 1, face.Key.end());
    if (count == 4)
    {
      face.Corners[3] = ids[3];
    }
    if (face.IsPolygon)
    {
      face.Corners[1] = static_cast<vtkIdType>(this->Polygons.size());
      this->Polygons.emplace_back(ids, ids + count);
    }
    this->Faces.push_back(face);
  }

  void AddPolygon(const Face& face, std::vector<FaceCorners>& border) const
  {
    if (!face.IsPolygon)
    {
      border.push_back(face.Corners);
      return;
    }
    const auto& ids = this->Polygons[static_cast<std::size_t>(face.Corners[1])];
    for (std::size_t i = 2; i < ids.size(); ++i)
    {
      border.push_back({ ids[0], ids[i - 1], ids[i], -1 });
    }
  }

  vtkDataSet* Data;
  std::vector<Face> Faces;
  std::vector<std::vector<vtkIdType>> Polygons;
  vtkNew<vtkIdList> Ids;
  vtkNew<vtkGenericCell> Cell;
};

bool HasVelocity(vtkDataSet* data, vtkDataArray* velocity, vtkIdType point)
{
  double v[3];
  double x[3];
  velocity->GetTuple(point, v);
  data->GetPoint(point, x);
  return std::isfinite(v[0] + v[1] + v[2] + x[0] + x[1] + x[2]);
}

// The cells of a structured grid that have a side on its border; all of any other dataset.
class OuterCells
{
public:
  explicit OuterCells(vtkDataSet* data)
    : IsStructured(StructuredSize(data, this->Size.Points.data()))
  {
  }

  bool operator[](vtkIdType cell) const
  {
    std::array<int, 3> index;
    if (!this->IsStructured || !this->Size.IndexOfCell(cell, index))
    {
      return true;
    }
    bool outer = false;
    for (std::size_t a = 0; a < 3; ++a)
    {
      outer = outer || index[a] == 0 || index[a] == this->Size.Cells(a) - 1;
    }
    return outer;
  }

private:
  GridSize Size;
  bool IsStructured;
};
}

bool HasVelocityEverywhere(vtkDataSet* data, vtkDataArray* velocity)
{
  for (vtkIdType point = 0; point < data->GetNumberOfPoints(); ++point)
  {
    if (!HasVelocity(data, velocity, point))
    {
      return false;
    }
  }
  return !HiddenCells(data).Any();
}

std::vector<FaceCorners> BorderFaces(vtkDataSet* data, vtkDataArray* velocity)
{
  const HiddenCells hidden(data);
  const bool everywhere = HasVelocityEverywhere(data, velocity);
  const OuterCells outer(data);
  FaceCollection faces(data);
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    if (everywhere)
    {
      if (outer[cell])
      {
        faces.AddCell(cell);
      }
      continue;
    }
    data->GetCellPoints(cell, ids);
    if (!hidden[cell] && std::all_of(ids->begin(), ids->end(), [&](vtkIdType point) {
          return HasVelocity(data, velocity, point);
        }))
    {
      faces.AddCell(cell);
    }
  }
  return faces.Border();
}
}
