// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The volume swept by a steady flow through a polygon, layer by layer (MaxBeckerCrawfis1993, made
// conforming). No VTK object.
#ifndef nephoscope_SteadyVolume_h
#define nephoscope_SteadyVolume_h

#include "SmokeMesh.h"

namespace nephoscope
{
// The sum over the tetrahedra of density times volume is SmokeReport::KeptMass to rounding: density
// is mass over the volume of the bilinear prism, times one factor per emission step that makes up
// for the difference between that volume and the one of the tetrahedra. Where triangles have ended
// it is the mass of those that went on.
//
// The flow is that of `time`. A triangle that the flow crosses backwards is turned round. The
// result does not depend on the order of the polygon's points and triangles, beyond rounding, nor
// on the number of threads. Never throws for bad input; a polygon outside the field, or one that
// the flow does not cross, gives no tetrahedra (see mesh.Report).
SmokeMesh BuildSteadyVolume(const VelocityField& field, const PolygonMesh& polygon,
  const FlowVolumeSettings& settings, double time, const ProgressFunction& progress);
}

#endif
