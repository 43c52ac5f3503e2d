// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The cells of one range of the input, divided. Batches are made in parallel, each by one thread,
 * and put together in order, so that the output does not depend on the number of threads.
 */
#ifndef nephoscope_SplitBatch_h
#define nephoscope_SplitBatch_h

#include "CellTetrahedra.h"
#include "ContourScalars.h"
#include "CutTable.h"
#include "TetrahedronSlabs.h"

#include "vtkType.h"

#include <array>
#include <vector>

namespace nephoscope
{

using PointCut = Cut<vtkIdType>;

/**
 * Output cells. A corner is the number of an input point p; the centre of input cell c, as (number
 * of points) + c; or cut k of the batch, as -1 - k.
 */
struct SplitCells
{
  std::vector<unsigned char> Types;
  std::vector<vtkIdType> Ends; // of each cell among the corners
  std::vector<vtkIdType> Corners;
  std::vector<vtkIdType> Sources; // input cells
  std::vector<int> Layers;        // of polygons: the level they lie on

  void EndCell(int type, vtkIdType source, int layer)
  {
    this->Types.push_back(static_cast<unsigned char>(type));
    this->Ends.push_back(static_cast<vtkIdType>(this->Corners.size()));
    this->Sources.push_back(source);
    this->Layers.push_back(layer);
  }
  std::size_t Size() const { return this->Types.size(); }
};

/** A point in the middle of a cell. */
struct CellCentre
{
  vtkIdType Cell;
  Vector3 Place;
  double Scalar;
};

/** A triangle of a cell's face that lies on a value, with the cell above it. */
struct FaceOnLevel
{
  std::array<vtkIdType, 3> Corners; // input points, or a centre
  std::array<vtkIdType, 3> Key;     // the same, sorted
  vtkIdType Source;
  int Level;
};

/** How many cells were special, and the first of them. */
struct CellCount
{
  vtkIdType Count = 0;
  vtkIdType First = -1;

  void Add(vtkIdType cell) { this->First = this->Count++ == 0 ? cell : this->First; }
  void Add(const CellCount& later)
  {
    this->First = this->Count == 0 ? later.First : this->First;
    this->Count += later.Count;
  }
};

/**
 * An undivided cell that has become a polyhedron: its index among the 3-D cells, and the start of
 * its faces.
 */
struct Transition
{
  vtkIdType Piece;
  vtkIdType FirstFace;
};

struct SplitBatch
{
  SplitCells Volume;
  SplitCells Surface;
  std::vector<FaceOnLevel> FacesOnLevels;
  std::vector<CellCentre> Centres;
  std::vector<PointCut> Cuts;
  std::vector<FaceKey> DividedFaces;   // that no value crosses, so that the neighbour may be whole
  std::vector<Transition> Transitions; // in the order of pieces
  std::vector<vtkIdType> FaceStreams;  // number of faces, then size, points, ...
  CellCount Missing;                   // a scalar is not a number
  CellCount Flat;                      // not three-dimensional
  CellCount Undivided;                 // crossed, but without volume
  CellCount NotConvex;                 // and divided
  CellCount NotLinear;                 // and divided
};

/** Fills batches. One object per thread. */
class CellSplitter
{
public:
  struct Settings
  {
    bool Surfaces;
    bool Transitions; ///< collect the faces that TransitionCells wants
  };
  CellSplitter(vtkDataSet* data, const ContourScalars& scalars, const Settings& settings);

  SplitBatch Split(vtkIdType begin, vtkIdType end);

private:
  void AddCell(vtkIdType cell);
  void AddWhole(int layer);
  void AddDivided();
  void AddTetrahedron(const CellTetrahedra::Tetrahedron& part);
  void AddFaceOnLevel(const std::array<vtkIdType, 3>& corners, int level);
  void AddFacesOnLevel(int code);
  void CollectDividedFaces();
  void ReadCodes();
  void PlaceCentre();

  vtkIdType NumberOfPoints;
  const ContourScalars& Scalars;
  Settings With;
  CellTetrahedra Cell;
  vtkIdType CellNumber = -1;
  std::vector<vtkIdType> Corners; // of the present cell and its centre
  std::vector<int> Codes;
  CutTable<vtkIdType> Cuts;
  SplitBatch Batch;
};

} // namespace nephoscope

#endif
