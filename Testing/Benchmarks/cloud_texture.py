# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Prints what drawing textured clouds costs against drawing the same surface plainly, translucent as well.

    ./nephoscope bench
    PYTHONPATH=Testing/Python ./nephoscope python Testing/Benchmarks/cloud_texture.py 512

Clouds of the forecast about an opaque globe, with two sets of texture coordinates and normals, 1024 x 1024 pixels or as many as the argument says;
thickness also from density volumes, the cells of the forecast and an image of 200 x 200 x 200 points. Seconds are processor
time of the whole process, software OpenGL included, the least of frames of a moving camera; all ways to draw take turns, so
that what else the machine does falls on them alike. The ratio is what to quote.
"""
import sys
import time

import nephoscope
import numpy as np
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  the factory
from nephoscope_testing import meshes
from nephoscope_testing.weather import forecast_globe
from vtkmodules.vtkFiltersCore import vtkResampleToImage
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow

SIZE = int(sys.argv[1]) if len(sys.argv) > 1 else 1024
FRAMES = 5
IMAGE_POINTS = 200
COVER = 0.15


def clouds():
    contour = nephoscope.vtkCloudSurface()
    contour.SetInputData(forecast_globe())
    contour.SetInputArrayToProcess(0, 0, 0, 0, "cloud_fraction")
    contour.SetValue(0, COVER)
    contour.SetNumberOfSmoothingIterations(1)
    contour.Update()
    surface = contour.GetOutput()
    points = meshes.points_of(surface)
    radius = np.linalg.norm(points, axis=1)
    longitude = np.arctan2(points[:, 1], points[:, 0]) / (2 * np.pi)
    latitude = np.arcsin(points[:, 2] / radius) / (2 * np.pi)
    place = np.stack([longitude, latitude, np.zeros_like(radius)], axis=-1)
    for i, shift in enumerate((0.0, 0.01)):
        meshes.add_array(surface.GetPointData(), place + shift, f"TextureCoordinates{i + 1}")
    return surface, radius.min()


def textured(surface, thickness):
    mapper = nephoscope.vtkCloudTextureMapper()
    mapper.SetInputData(surface)
    mapper.SetTextureScale(9)
    mapper.SetSoftness(0.5)
    mapper.SetUseThickness(thickness)
    return mapper


def volumes():
    globe = forecast_globe()
    resample = vtkResampleToImage()
    resample.SetInputDataObject(globe)
    resample.SetSamplingDimensions(*3 * [IMAGE_POINTS])
    resample.Update()
    return {"an image": resample.GetOutput(), "cells": globe}


def in_volume(surface, volume):
    mapper = textured(surface, True)
    mapper.SetDensityVolume(volume)
    mapper.SetDensityArrayName("cloud_fraction")
    return mapper


def plain(surface):
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(surface)
    return mapper


def scene(mapper, radius, peeling):
    renderer, window = vtkRenderer(), vtkRenderWindow()
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetOpacity(0.7)
    globe, ground = vtkSphereSource(), vtkActor()
    globe.SetRadius(0.999 * radius)
    globe.SetThetaResolution(90)
    globe.SetPhiResolution(45)
    globe.Update()
    ground.SetMapper(plain(globe.GetOutput()))
    for a in (ground, actor):
        renderer.AddActor(a)
    renderer.SetUseDepthPeeling(peeling)
    renderer.SetMaximumNumberOfPeels(8)
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(SIZE, SIZE)
    window.AddRenderer(renderer)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(3.2 * radius, -2.4 * radius, 1.6 * radius)
    camera.SetFocalPoint(0, 0, 0)
    camera.SetViewUp(0, 0, 1)
    camera.SetViewAngle(30)
    renderer.ResetCameraClippingRange()
    return renderer, window


def moving_frame(renderer, window):
    renderer.GetActiveCamera().Azimuth(7)
    renderer.ResetCameraClippingRange()
    start = time.process_time()
    window.Render()
    return time.process_time() - start


def compare(surface, radius, peeling):
    ways = {"plain": plain(surface), "textured": textured(surface, False), "textured, by thickness": textured(surface, True)}
    ways.update((f"textured, by thickness in {name}", in_volume(surface, data)) for name, data in volumes().items())
    scenes = {name: scene(mapper, radius, peeling) for name, mapper in ways.items()}
    times = {name: [] for name in ways}
    for turn in range(FRAMES + 2):
        for name, (renderer, window) in scenes.items():
            taken = moving_frame(renderer, window)
            if turn > 1:  # buffers are filled and shaders compiled before
                times[name].append(taken)
    base = min(times["plain"])
    for name, taken in times.items():
        print(f"| {'peeled' if peeling else 'unpeeled'} | {name} | {min(taken):.3f} | {min(taken) / base:.2f} |", flush=True)


def main():
    surface, radius = clouds()
    print(f"{surface.GetNumberOfPolys()} triangles\n\n| | drawn | s per frame | times plain |\n|---|---|---|---|", flush=True)
    for peeling in (False, True):
        compare(surface, radius, peeling)


main()
