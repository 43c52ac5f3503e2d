// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** What the Textured Splats representation does to its input before it hands it to the view. */
#ifndef SplatPieces_h
#define SplatPieces_h

#include "vtkSmartPointer.h"

class vtkDataObject;
class vtkDataSet;

namespace nephoscope
{

/** The dataset to draw: `input` itself (a shallow copy), or the blocks of a composite that have points. Null without any. */
vtkSmartPointer<vtkDataSet> sampledPart(vtkDataObject* input);

} // namespace nephoscope

#endif
