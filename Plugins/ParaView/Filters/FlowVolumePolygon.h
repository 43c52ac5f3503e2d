// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The generating polygon of Flow Volume, drawn in place of the cylinder of ParaView's widget that
// it is moved by.
#ifndef nephoscope_FlowVolumePolygon_h
#define nephoscope_FlowVolumePolygon_h

class vtkSMProxy;

namespace nephoscope
{
/** Call it once for every new render view of the client. */
void DrawPolygonsOfWidgets(vtkSMProxy* view);
}

#endif
