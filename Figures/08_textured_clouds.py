# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 8: the smoothed surface of 15 % cloud cover with a texture of broken cloud, moved by the wind of the last 24 hours.

After figure 8 of Max, Crawfis and Becker (1993), without its haze. Uses the time series of `./nephoscope forecast` (NEPHOSCOPE_FORECAST).
"""
import os
import sys

import nephoscope
from vtkmodules.vtkRenderingCore import vtkRenderer

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "common"))
from globe_scene import on_globe  # noqa: E402
import pictures  # noqa: E402
import vtk_globe  # noqa: E402

EXAGGERATION = 20
COVER = 0.15
HOUR = 6792.0 + 24  # of the series


def clouds():
    globe = vtk_globe.on_globe_grid(vtk_globe.read_fields(os.environ["NEPHOSCOPE_FORECAST"]), EXAGGERATION)
    texture = nephoscope.vtkTextureCoordinateAdvection()
    texture.SetInputConnection(globe.GetOutputPort())
    texture.SetTimeScale(3600)
    surface = vtk_globe.cloud_surface(texture, COVER, iterations=1)
    surface.UpdateTimeStep(HOUR)
    mapper = nephoscope.vtkCloudTextureMapper()
    mapper.SetInputConnection(surface.GetOutputPort())
    mapper.ScalarVisibilityOff()
    mapper.SetCoverage(0.55)
    mapper.SetTextureScale(9)
    mapper.SetSoftness(0.5)
    actor = vtk_globe.actor_of(mapper, ambient=0.25, diffuse=0.8)
    actor.ForceTranslucentOn()
    return actor


def main():
    renderer, window = vtkRenderer(), vtk_globe.make_window((1280, 720))
    for actor in (vtk_globe.terrain(ambient=0.5, diffuse=1.0), clouds()):
        renderer.AddActor(actor)
    renderer.SetBackground(0.01, 0.015, 0.035)
    renderer.SetUseDepthPeeling(True)
    renderer.SetMaximumNumberOfPeels(8)
    vtk_globe.add_sun(renderer, on_globe(-150, 34, 10))
    vtk_globe.look(renderer, eye=on_globe(-118, -12, 2.6), focus=on_globe(-110, 6, 0.9), up=on_globe(-110, 15), angle=31)
    window.SetAlphaBitPlanes(1)
    window.AddRenderer(renderer)
    renderer.ResetCameraClippingRange()
    window.Render()
    pictures.write(window, os.path.join(os.environ["NEPHOSCOPE_GALLERY"], "08_textured_clouds.png"))


main()
