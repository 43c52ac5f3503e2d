// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The input arrays that a volume mapper reads, and its messages about arrays that cannot be drawn.
 */
#ifndef nephoscope_ArraySelection_h
#define nephoscope_ArraySelection_h

#include "ArrayNames.h"
#include "ScalarSelection.h"

#include "vtkNephoscopeRepresentationsCommonModule.h" // for export macro

#include <string>

class vtkAbstractVolumeMapper;
class vtkVolumeProperty;

namespace nephoscope
{

/** Empty when the selected array has a value for every point or cell. */
VTKNEPHOSCOPEREPRESENTATIONSCOMMON_EXPORT std::string CheckLength(
  vtkDataSet* input, const ScalarSelection& scalars);

/**
 * The array that the mapper's ScalarMode and SelectScalarArray name. Returns the problem, or an
 * empty string.
 */
VTKNEPHOSCOPEREPRESENTATIONSCOMMON_EXPORT std::string SelectScalars(vtkAbstractVolumeMapper* mapper,
  vtkDataSet* input, vtkVolumeProperty* property, ScalarSelection& scalars);

/**
 * The point or cell array called `name`; none if the name is empty. Returns the problem, or an
 * empty string.
 */
VTKNEPHOSCOPEREPRESENTATIONSCOMMON_EXPORT std::string SelectOpacity(const std::string& name,
  vtkDataSet* input, const ScalarSelection& scalars, ScalarSelection& opacity);

/**
 * The array that the opacity function reads: that called `name`, or the coloured one, `scalars`. No
 * array if either is missing.
 */
VTKNEPHOSCOPEREPRESENTATIONSCOMMON_EXPORT ScalarSelection SelectOpaque(
  vtkAbstractVolumeMapper* mapper, vtkDataSet* input, vtkVolumeProperty* property,
  const std::string& name, ScalarSelection& scalars);

/** Empty if the input is a dataset; otherwise how to make one. */
VTKNEPHOSCOPEREPRESENTATIONSCOMMON_EXPORT std::string CheckIsDataSet(vtkDataObject* input);

/** Empty when the property's ScalarOpacityUnitDistance is a length. */
VTKNEPHOSCOPEREPRESENTATIONSCOMMON_EXPORT std::string CheckUnitDistance(
  vtkVolumeProperty* property);

/**
 * Empty when the sides of the data are at most `largest` long: graphics cards calculate in single
 * precision, up to 3e38.
 */
VTKNEPHOSCOPEREPRESENTATIONSCOMMON_EXPORT std::string CheckLengths(
  vtkDataSet* input, double largest);

} // namespace nephoscope

#endif
