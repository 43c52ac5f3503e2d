// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The order in which the volumes of a renderer are drawn: from back to front, whichever was added
 * first. VTK draws them as they were added.
 *
 * Mappers enrol themselves. The first of a renderer's enrolled volumes that VTK draws, draws all of
 * them, from back to front; the others then draw nothing. Volumes whose boxes are apart are in
 * order exactly. Those that overlap are drawn in slices of depth (VolumeSlices.h), unless their
 * mappers draw them as one medium.
 */
#ifndef nephoscope_VolumeOrder_h
#define nephoscope_VolumeOrder_h

#include "vtkNephoscopeRepresentationsCommonModule.h" // for export macro

#include <cstddef>
#include <functional>

class vtkAbstractVolumeMapper;
class vtkRenderer;
class vtkVolume;
class vtkWindow;

namespace nephoscope
{

class DepthTiles;

class VTKNEPHOSCOPEREPRESENTATIONSCOMMON_EXPORT VolumeOrder
{
public:
  struct Part
  {
    /** Draws this volume now, together with the volumes of the same medium. */
    std::function<void(vtkRenderer*, vtkVolume*)> Draw;
    /** How many its mapper draws as one medium, of those that may be; 1: it may not. */
    std::function<std::size_t(vtkRenderer*, vtkVolume*)> Mixes;
    /** Whether it can be drawn in slices. */
    std::function<bool()> MayBeSliced;
    /** Adds what it draws; false: that may be anywhere in its box. Empty for the same. */
    std::function<bool(vtkRenderer*, vtkVolume*, DepthTiles&)> AddTo;
    /** Slices that it draws at once: 2, as the ranges of a peel, or VolumeSlices::PerPass. */
    int SlicesAtOnce = 2;
  };
  static void Enrol(vtkAbstractVolumeMapper* mapper, const Part& part);
  static void Leave(vtkAbstractVolumeMapper* mapper);
  static void ReleaseGraphicsResources(vtkAbstractVolumeMapper* mapper, vtkWindow* window);

  /** The work of Render() of an enrolled mapper. */
  static void Draw(vtkAbstractVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume);
  /** Whether a volume is drawn that cannot be one medium with others. */
  static bool HasOthers(vtkRenderer* renderer);

  static bool IsEnrolled(vtkVolume* volume);
  /** Visible, not culled (vtkCuller), and with bounds. */
  static bool IsDrawn(vtkVolume* volume);
  static bool Overlap(vtkVolume* a, vtkVolume* b);
};

} // namespace nephoscope

#endif
