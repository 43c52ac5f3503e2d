// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The faces method (Lucas1992; MaxCrawfisBecker1993 section 2), in software: faces, not cells, are
 * drawn in the order of their centroids, and a buffer of the size of the picture holds for each
 * pixel the depth, the colour and the extinction of the face drawn last. Each face composites the
 * segment between itself and that one (FaceSegment.h), and takes its place.
 *
 * A face reads and writes its pixels' buffer before the next face may, which the blending of OpenGL
 * 3.2 cannot do; hence software.
 * The picture is divided into tiles, which are drawn in parallel, each face in the same order in
 * each: the result does not depend on the number of threads.
 *
 *   points ─► screen ─► faces cut at the near plane ─► sorted ─► one list per tile ─► tiles
 *             └────────────── FaceProjection ───────────────┘    └───── FaceSweep ──────┘
 */
#ifndef nephoscope_FaceSweep_h
#define nephoscope_FaceSweep_h

#include "FaceProjection.h"
#include "TransferFunctionTable.h"

#include <cstdint>
#include <vector>

namespace nephoscope
{

class FaceSweep
{
public:
  struct Scene
  {
    const CellGeometry* Geometry = nullptr;
    const TransferFunctionTable* Color =
      nullptr; ///< colour, and opacity unless the geometry has opacity scalars
    const TransferFunctionTable* Opacity = nullptr; ///< read by the opacity scalars
    const std::vector<std::int32_t>* TablesOfTetrahedra =
      nullptr;                  ///< which of both tables, one after the other; none or empty: 0
    double ExtinctionScale = 1; ///< extinction per world length at opacity 1
    bool AverageIntegration = false;
    const float* OpaqueDepth =
      nullptr; ///< depths in [0, 1], bottom row first; none: nothing opaque
  };

  /** Premultiplied RGBA, bottom row first. */
  static std::vector<float> Draw(
    const Scene& scene, const FaceProjection& projection, const FaceView& view);
};

} // namespace nephoscope

#endif
