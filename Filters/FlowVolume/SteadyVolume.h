// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The volume swept by a steady flow through a polygon, layer by layer.
#ifndef nephoscope_SteadyVolume_h
#define nephoscope_SteadyVolume_h

#include "SmokeMesh.h"

namespace nephoscope
{
SmokeMesh BuildSteadyVolume(const VelocityField& field, const PolygonMesh& polygon,
  const FlowVolumeSettings& settings, double time, const ProgressFunction& progress);
}

#endif
