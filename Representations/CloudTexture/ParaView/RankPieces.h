// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Pieces that ranks send one another, or to the client that draws them. They travel as VTK's files,
 * which lose the extent of an image and round its lattice to 6 digits: a field array keeps these.
 */
#ifndef nephoscope_RankPieces_h
#define nephoscope_RankPieces_h

#include "vtkSmartPointer.h"

class vtkDataObject;
class vtkDataSet;
class vtkMultiBlockDataSet;

namespace nephoscope
{

/** That field array; of other data it tells that they are pieces. */
constexpr const char* pieceName = "NephoscopePiece";

/** Adds it to the field data, which must be the set's own. */
void MarkPiece(vtkDataSet* set);

/** What MarkPiece has kept, where it is an image. */
void RestorePiece(vtkDataSet* set);

/** Whether some are pieces of several ranks. `data` may be null. */
bool HasMarkedPieces(vtkDataObject* data);

/**
 * Puts marked copies of the leaves of `own`, which may be null, into blocks that no other rank
 * uses. ParaView joins the blocks of one number on their way to the client: it keeps only the first
 * of several images, and does not tell surfaces apart. Collective.
 */
void PlacePieces(vtkDataObject* own, vtkMultiBlockDataSet* placed);

} // namespace nephoscope

#endif
