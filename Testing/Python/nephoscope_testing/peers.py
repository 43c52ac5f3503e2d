# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""VTK's own mappers for unstructured volumes, to draw beside ours."""
from vtkmodules.vtkRenderingVolume import (vtkProjectedTetrahedraMapper, vtkUnstructuredGridLinearRayIntegrator,
                                           vtkUnstructuredGridVolumeRayCastMapper)

from .offscreen import Window


def projected_tetrahedra():
    return vtkProjectedTetrahedraMapper()


def ray_cast():
    mapper = vtkUnstructuredGridVolumeRayCastMapper()
    mapper.SetRayIntegrator(vtkUnstructuredGridLinearRayIntegrator())
    mapper.AutoAdjustSampleDistancesOff()
    mapper.SetImageSampleDistance(1.0)
    return mapper


def draw(mapper, data, transfer, look, size=(96, 96), viewport=(0, 0, 1, 1), matrix=None):
    """The scene after two frames (the projected-tetrahedra mapper leaves the first one empty). look(scene)."""
    window = Window(size)
    scene = window.add_scene(viewport=viewport)
    scene.add_volume(mapper, data, transfer, matrix=matrix)
    look(scene)
    window.render()
    window.render()
    return scene
