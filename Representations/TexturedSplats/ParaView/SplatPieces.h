// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The changes that the Textured Splats representation makes to its input before it passes it to the
 * view.
 */
#ifndef nephoscope_SplatPieces_h
#define nephoscope_SplatPieces_h

#include "vtkSmartPointer.h"

class vtkDataObject;
class vtkDataSet;
class vtkIdList;
class vtkMatrix4x4;

namespace nephoscope
{
struct SplatSampling;

/**
 * The dataset to draw: `input` itself (a shallow copy), or the blocks of a composite that have
 * points. Null without any.
 */
vtkSmartPointer<vtkDataSet> SampledPart(vtkDataObject* input);

/**
 * Name of the array of shapes that SplatVertices makes, for
 * vtkTexturedSplatMapper::SetShapeArrayName.
 */
extern const char* const splatShapeName;

/**
 * The visible samples as single vertices with their shapes, which can be given to any rank without
 * loss: nothing of the grid is needed any more. A sample that several ranks have stays on one. Its
 * arrays, those of points or of cells as the sampling says, become cell arrays. Without a cell size
 * it is the mean spacing of the samples of all ranks. `piece` may be null. Collective.
 */
vtkSmartPointer<vtkDataSet> SplatVertices(vtkDataSet* piece, const SplatSampling& sampling);

/**
 * `piece` with the shapes of its samples as an array, where they follow from the cells around them:
 * they are found once, not by all that draws or measures the samples. On one rank; may be null.
 */
vtkSmartPointer<vtkDataSet> WithShapesOfCells(vtkDataSet* piece, const SplatSampling& sampling);

/** Moves the shapes of such vertices as the linear part of a matrix does. */
void MoveShapes(vtkDataSet* vertices, vtkMatrix4x4* matrix);

/** Some of such vertices, with their arrays and those of the whole. */
vtkSmartPointer<vtkDataSet> ChosenVertices(vtkDataSet* vertices, vtkIdList* ids);

} // namespace nephoscope

#endif
