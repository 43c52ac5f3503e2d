// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * One cell of a dataset at a time: its points, and the tetrahedra that it divides into. One object
 * per thread.
 *
 * Every face is cut as a fan from its least vertex by coordinates (x, then y, then z), which
 * depends neither on numbering nor on blocks and ranks; if that gives a flat triangle, because
 * vertices lie on one line, it is cut from the next vertex that gives none. The inside of a cell
 * does not affect its neighbours: a cell is coned from its least vertex, or from its centre where
 * the least vertex does not see all faces (faces that share a plane, warped faces).
 */
#ifndef nephoscope_CellTetrahedra_h
#define nephoscope_CellTetrahedra_h

#include "Vector3.h"

#include "vtkDataSet.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <vector>

namespace nephoscope
{

/** A face with four vertices or more, by the least four of its points. */
using FaceKey = std::array<vtkIdType, 4>;

class CellTetrahedra
{
public:
  enum class Kind
  {
    Solid,
    Hidden, ///< blanked or refined, or it touches a hidden point
    Flat    ///< not three-dimensional
  };

  struct Tetrahedron
  {
    std::array<int, 4> Vertices; ///< places in the cell
    double Volume;               ///< six times the volume, signed
  };

  explicit CellTetrahedra(vtkDataSet* data);

  /** Makes a cell the present one; everything below is about it. */
  Kind Load(vtkIdType cell);
  int Type() const { return this->CellType; }
  int Size() const { return static_cast<int>(this->PointIds->GetNumberOfIds()); }
  vtkIdType Point(int vertex) const { return this->PointIds->GetId(vertex); }

  /** Reads the coordinates, which only what follows needs. */
  void Locate();
  const Vector3& PlaceOf(int vertex) const { return this->Places[vertex]; }
  /** Least distance between two distinct vertices; 0 if there are none. */
  double ShortestDistance() const;

  /** Divides the cell. False if it is not convex: the tetrahedra then overlap or leave gaps. */
  bool Divide();
  const std::vector<Tetrahedron>& Tetrahedra() const { return this->Parts; }
  /** The present cell, which has been divided, is none of VTK's linear cells. */
  bool IsHigherOrder() const { return this->CellType != VTK_TETRA && this->FaceStream.empty(); }
  /** The number of the centre among the vertices, if the tetrahedra use it; else -1. */
  int Centre() const { return this->CentreVertex; }

  /**
   * Calls emit(a, b, c) for the triangles of each face that wanted(first vertex, past the last)
   * picks; each turns so that the cell lies where it faces. Cells that are not linear have none.
   */
  template <typename Wanted, typename Emit>
  void EmitFaceTriangles(Wanted wanted, Emit emit)
  {
    this->Locate();
    this->ReadFaces();
    const Vector3 middle = this->Mean();
    this->VisitFaces([&](const int* begin, const int* end) {
      if (wanted(begin, end))
      {
        EmitFan(begin, end, [&](int a, int b, int c) {
          const bool outward =
            Volume(this->Places[a], this->Places[b], this->Places[c], middle) < 0;
          outward ? emit(a, c, b) : emit(a, b, c);
        });
      }
    });
  }

  /**
   * Calls visit(first vertex, past the last) for each face of a linear cell or polyhedron; the
   * first vertex is that of its fan.
   */
  template <typename Visit>
  void ForEachFace(Visit visit)
  {
    this->Locate();
    this->ReadFaces();
    this->VisitFaces(visit);
  }
  /** The same of a cell that has been divided. */
  template <typename Visit>
  void VisitFaces(Visit visit) const
  {
    for (std::size_t i = 0; i < this->FaceStream.size();
         i += static_cast<std::size_t>(this->FaceStream[i]) + 1)
    {
      const int* face = this->FaceStream.data() + i;
      visit(face + 1, face + 1 + *face);
    }
  }

  /** Calls emit(a, b, c) for the triangles of a face that ForEachFace visits. */
  template <typename Emit>
  static void EmitFan(const int* begin, const int* end, Emit emit)
  {
    for (const int* vertex = begin + 1; vertex + 1 < end; ++vertex)
    {
      emit(*begin, *vertex, *(vertex + 1));
    }
  }

  /** All -1 for a triangle. */
  FaceKey KeyOf(const int* begin, const int* end) const;

private:
  static double Volume(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d);
  bool IsHidden() const;
  int DimensionOf(int cellType);
  void ReadFaces();
  void ReadPolyhedronFaces();
  void RankVertices();
  void MergeRepeatedVertices();
  void TurnFaces();
  void TurnToFullFan(int* begin, int* end) const;
  bool HasFlatTriangle(const int* begin, const int* end) const;
  Vector3 Mean() const;
  double Extent() const;
  bool DivideLinear();
  bool ConeFrom(int apex);
  bool DivideByVTK();
  bool IsAt(int vertex, const double x[3]) const;

  vtkDataSet* Data;
  vtkUnstructuredGrid* Grid;
  vtkUnsignedCharArray* CellGhosts;
  vtkUnsignedCharArray* PointGhosts;
  vtkIdType Cell = -1;
  int CellType = VTK_EMPTY_CELL;
  int CentreVertex = -1;
  std::array<signed char, 256> Dimensions;
  vtkNew<vtkIdList> PointIds;
  vtkNew<vtkIdList> Stream;
  vtkNew<vtkPoints> TrianglePoints;
  vtkNew<vtkGenericCell> AnyCell;
  std::vector<Vector3> Places;
  std::vector<int> Order; // vertices from the least to the largest
  std::vector<int> Ranks;
  std::vector<int> Representatives; // of vertices in one place, the one with the least number
  std::vector<int> FaceStream;      // size, vertices, size, vertices, ...
  std::vector<Tetrahedron> Parts;
};

} // namespace nephoscope

#endif
