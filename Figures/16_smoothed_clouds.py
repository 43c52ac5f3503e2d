# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 16: the surface of 15 % cloud cover of a weather forecast over the globe, rough (left) and smoothed (right).

After Max, Crawfis and Becker (1993), section 4. Left as the model has it, right after the 3 x 3 x 3 filter, with the same
reach in metres at all latitudes. Colour is the altitude, an array that comes with the surface. Writes the picture (1800 x 960).
"""
import os
import sys

from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkPolyDataMapper, vtkRenderer

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "common"))
from globe_scene import on_globe  # noqa: E402
import pictures  # noqa: E402
import vtk_globe  # noqa: E402

GALLERY = os.environ["NEPHOSCOPE_GALLERY"]
SIZE = (1800, 960)
EXAGGERATION = 30
COVER = 0.15
CAPTION_COLOUR = (0.75, 0.80, 0.88)
ITERATIONS = 1
# Height in metres: warm below, white in the middle, cold above.
ALTITUDE_COLOURS = ((0, 0.96, 0.55, 0.25), (2000, 1.00, 0.76, 0.47), (4500, 1.00, 0.94, 0.84), (7500, 0.98, 0.98, 0.98),
                    (11000, 0.80, 0.89, 1.00), (15000, 0.50, 0.68, 1.00))


def cloud_actor(globe, iterations):
    surface = vtk_globe.cloud_surface(globe, COVER, iterations)
    colours = vtkColorTransferFunction()
    for point in ALTITUDE_COLOURS:
        colours.AddRGBPoint(*point)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(surface.GetOutputPort())
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray("Height")
    mapper.SetLookupTable(colours)
    mapper.UseLookupTableScalarRangeOn()
    return vtk_globe.actor_of(mapper, ambient=0.22, diffuse=0.85)


def add_globe(window, column, clouds, text):
    renderer = vtkRenderer()
    renderer.SetViewport(column / 2, 0, (column + 1) / 2, 1)
    renderer.SetBackground(0.01, 0.015, 0.035)
    for actor in (vtk_globe.terrain(ambient=0.3, diffuse=0.8, resolution=180), clouds):
        renderer.AddActor(actor)
    renderer.AddViewProp(vtk_globe.text(text, (24, 20), 24, CAPTION_COLOUR))
    vtk_globe.add_sun(renderer, on_globe(-55, 40, 10))
    # Over the eastern Pacific, where two hurricanes are.
    vtk_globe.look(renderer, eye=on_globe(-108, 22, 3.95), focus=(0, 0, 0), up=(0, 0, 1), angle=36)
    window.AddRenderer(renderer)
    renderer.ResetCameraClippingRange()


def main():
    globe = vtk_globe.analysis_grid(EXAGGERATION)
    window = vtk_globe.make_window(SIZE, samples=4)
    add_globe(window, 0, cloud_actor(globe, 0), "15 % cloud cover as the model has it\nGFS forecast for 2011-10-11 00 UTC")
    add_globe(window, 1, cloud_actor(globe, ITERATIONS), "The same, smoothed once. Orange: below 2 km; white: near 7 km;\n"
              f"blue: above 11 km. Heights exaggerated {EXAGGERATION} times")
    window.Render()
    pictures.write(window, os.path.join(GALLERY, "16_smoothed_clouds.png"))


main()
