// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The unit of the times of a series.
#ifndef nephoscope_TimeUnit_h
#define nephoscope_TimeUnit_h

#include "vtkNephoscopeFiltersCommonModule.h" // for export macro

class vtkDataObject;

namespace nephoscope
{
// Seconds in the unit that the field array `time_units` names, as VTK's readers of NetCDF files
// write it, such as "hours since 2011-10-11"; 0 without such an array, or for another unit.
VTKNEPHOSCOPEFILTERSCOMMON_EXPORT double SecondsInUnitOfTime(vtkDataObject* data);
}

#endif
