# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Translucent meshes among the volumes of a view: depth peeling of volumes, turned on where the view has both."""
from __future__ import annotations

import weakref

import pyvista
from vtkmodules.vtkRenderingCore import vtkRenderer

from . import vtkCellCompositingMapper, vtkTexturedSplatMapper

PEELS = 10  # a peel takes two surfaces of each pixel
_watched: "weakref.WeakSet[pyvista.BasePlotter]" = weakref.WeakSet()


def peel_when_needed(plotter: pyvista.BasePlotter) -> None:
    """Turns peeling on before the first picture in which a renderer has a visible volume of cells or splats and a visible translucent mesh.

    It is done once for each renderer, so that `disable_depth_peeling` stays in effect afterwards. Multisampling of the window is turned off, because VTK
    does not peel with it.
    """
    if plotter in _watched:
        return
    _watched.add(plotter)
    reference = weakref.ref(plotter)
    done: "weakref.WeakSet[vtkRenderer]" = weakref.WeakSet()

    def before_picture(window, _event) -> None:
        current = reference()
        for renderer in current.renderers if current is not None else ():
            if renderer not in done and _needs_peeling(renderer):
                done.add(renderer)
                _peel(window, renderer)
    plotter.render_window.AddObserver("StartEvent", before_picture)


def _needs_peeling(renderer: vtkRenderer) -> bool:
    volumes = [volume for volume in renderer.GetVolumes() if volume.GetVisibility()]
    if not any(isinstance(volume.GetMapper(), (vtkCellCompositingMapper, vtkTexturedSplatMapper)) for volume in volumes):
        return False
    return any(actor.GetVisibility() and actor.HasTranslucentPolygonalGeometry() for actor in renderer.GetActors())


def _peel(window, renderer: vtkRenderer) -> None:
    renderer.UseDepthPeelingForVolumesOn()
    if not renderer.GetUseDepthPeeling():
        renderer.UseDepthPeelingOn()
        renderer.SetMaximumNumberOfPeels(PEELS)
        renderer.SetOcclusionRatio(0)  # every surface counts
    window.SetMultiSamples(0)
