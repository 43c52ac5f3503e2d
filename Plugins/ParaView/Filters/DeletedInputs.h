// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Displays outlive the sources of their optional inputs, such as a density volume, and filters
// their sun.
#ifndef nephoscope_DeletedInputs_h
#define nephoscope_DeletedInputs_h

class vtkSMProxy;

namespace nephoscope
{
/**
 * Call it for new proxies. ParaView deletes a display with any source that it uses; this takes a
 * source that is about to be deleted away from the optional inputs of all displays. Filters would
 * keep it, as their sun, which nobody could move.
 */
void OutliveOptionalInputs(vtkSMProxy* proxy);
}

#endif
