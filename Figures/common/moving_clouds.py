# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Textured clouds of figure 9 in the wind of a forecast, at any hour of a day that comes back to its beginning.

    window, renderer, clouds = scene((1920, 1080), os.environ["NEPHOSCOPE_FORECAST"])
    clouds.update(12)
    window.Render()

or, with loop=False, at any hour of the series, where both sets of texture coordinates start from the grid at its beginning.
"""
import nephoscope
import numpy
from vtkmodules.numpy_interface import dataset_adapter
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonDataModel import vtkStructuredGrid
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline
from vtkmodules.vtkRenderingCore import vtkRenderer

import globe_scene
import looped_series
import stopwatch
import vtk_globe
from globe_scene import on_globe

DAY = 24.0  # hours
FADE = 12.0  # hours over which the end of the day turns into its beginning
EXAGGERATION = 10
COVER = 0.15  # of the surface
FULL_COVER = 1.0  # cloud fraction of a column under which the texture is closed
PERIOD = 8.0  # hours that a set of texture coordinates lives; the day is a multiple
TEXTURE_SCALE = 14  # repetitions around the equator
SOFTNESS = 0.5
RELIEF = 0.03
EXTINCTION = 8e-5  # per metre of the display
VISIBILITY = 6e6  # metres of level air at the ground that leave 2 % of the contrast
PEELS = 8  # surfaces behind one another that are drawn


class ColumnCover(VTKPythonAlgorithmBase):
    """Adds ColumnCover, the share of the sky that the texture is to fill: from 0, where the greatest cloud fraction above and below a
    point is that of the surface's edge, to 1. So clouds thin out towards the edges of the surface. And there is none at the lowest and
    the highest level, so that the surface is closed, as clouds with a thickness must be."""

    def __init__(self, source):
        VTKPythonAlgorithmBase.__init__(self, inputType="vtkStructuredGrid", outputType="vtkStructuredGrid")
        self.SetInputConnection(source.GetOutputPort())

    def RequestData(self, request, inputs, outputs):
        output = vtkStructuredGrid.GetData(outputs)
        output.ShallowCopy(vtkStructuredGrid.GetData(inputs[0]))
        points = dataset_adapter.WrapDataObject(output).PointData
        size = [0, 0, 0]
        output.GetDimensions(size)  # VTK 9.6 has no other form
        i, j, k = size
        clouds = numpy.asarray(points["cloud_fraction"]).reshape(k, j * i)
        share = numpy.clip((clouds.max(axis=0) - COVER) / (FULL_COVER - COVER), 0, 1)
        points.append(numpy.tile(share, k).astype(numpy.float32), "ColumnCover")
        closed = clouds.copy()
        closed[[0, -1]] = 0
        points.append(closed.ravel(), "cloud_fraction")
        return 1


class MovingClouds:
    """The pipeline; update(hour) makes `actor` that of an hour, `watch` tells where the time has gone."""

    def __init__(self, file, life=PERIOD, loop=True):
        self.series, self.loop = vtk_globe.read_fields(file), loop
        if loop:
            self.series = looped_series.LoopedSeries(self.series, DAY, FADE)
        self.series.Update()
        self.times = self.series.GetOutputInformation(0).Get(Pipeline.TIME_STEPS()) or [0.0]
        self.unit = 1.0 if loop else looped_series.hours_of_unit(self.series.GetOutput())
        self.grid = vtk_globe.on_globe_grid(self.series, EXAGGERATION)
        self.texture = nephoscope.vtkTextureCoordinateAdvection()
        self.texture.SetInputConnection(self.grid.GetOutputPort())
        self.texture.SetTimeScale(3600 * self.unit)
        self.texture.SetPeriod(3600 * life)
        self.texture.SetStartFromGrid(not loop)
        self.texture.SetKeyFrameInterval(3600)
        self.smooth = nephoscope.vtkStructuredSmoothing()
        self.smooth.SetInputConnection(self.texture.GetOutputPort())
        self.smooth.SetInputArrayToProcess(0, 0, 0, 0, "cloud_fraction")
        self.smooth.SetIsotropic(True)
        self.columns = ColumnCover(self.smooth)
        self.surface = vtk_globe.cloud_surface(self.columns, COVER, iterations=0)
        self.mapper = nephoscope.vtkCloudTextureMapper()
        self.mapper.SetInputConnection(self.surface.GetOutputPort())
        self.mapper.ScalarVisibilityOff()
        self.mapper.SetCoverageArrayName("ColumnCover")
        self.mapper.SetTextureScale(TEXTURE_SCALE)
        self.mapper.SetSoftness(SOFTNESS)
        self.mapper.SetWavesToPaper()
        self.mapper.SetThinColor(1, 1, 1)
        self.mapper.SetRelief(RELIEF)
        self.mapper.UseThicknessOn()
        self.mapper.SetExtinction(EXTINCTION)
        self.actor = vtk_globe.actor_of(self.mapper, ambient=0.35, diffuse=0.75)
        self.actor.ForceTranslucentOn()
        self.watch = stopwatch.Stopwatch()
        for name, algorithm in (("reading", self.series), ("grid", self.grid), ("advection", self.texture), ("smoothing", self.smooth),
                                ("smoothing", self.columns), ("surface", self.surface)):
            self.watch.follow(name, algorithm)

    def hours(self):
        """The length of the series."""
        return (self.times[-1] - self.times[0]) * self.unit

    def update(self, hour):
        # In a loop the second round: paths lead back into the first one.
        self.surface.UpdateTimeStep(DAY + hour % DAY if self.loop else self.times[0] + hour / self.unit)


def haze():
    result = nephoscope.vtkHaze()
    result.SetVisibility(VISIBILITY)
    result.SetVerticalExaggeration(EXAGGERATION)
    return result


def scene(size, file, life=PERIOD, loop=True):
    """From the south over the eastern Pacific, a hurricane in the middle and North America behind, the sun in the west; returns the
    window and the clouds."""
    clouds = MovingClouds(file, life, loop)
    window, renderer = vtk_globe.make_window(size), vtkRenderer()
    window.SetAlphaBitPlanes(1)  # for peeling
    window.AddRenderer(renderer)
    for actor in (vtk_globe.terrain(ambient=0.5, diffuse=1.0), clouds.actor):
        renderer.AddActor(actor)
    renderer.GradientBackgroundOn()
    renderer.SetBackground(globe_scene.NIGHT[0])
    renderer.SetBackground2(globe_scene.NIGHT[1])
    renderer.SetUseDepthPeeling(True)
    renderer.SetMaximumNumberOfPeels(PEELS)
    renderer.SetOcclusionRatio(0)
    renderer.UseFXAAOn()
    nephoscope.vtkHaze.SetHaze(renderer, haze())
    vtk_globe.add_sun(renderer, on_globe(-150, 34, 10))
    vtk_globe.look(renderer, eye=on_globe(-118, -12, 2.6), focus=on_globe(-110, 6, 0.9), up=on_globe(-110, 15), angle=31)
    clouds.update(0)
    renderer.ResetCameraClippingRange()
    return window, renderer, clouds


def add_caption(renderer, words):
    renderer.AddViewProp(vtk_globe.text(
        "%s\nWinds and clouds: barotropic forecast from GFS, 2011-10-11 00 UTC\nHeights exaggerated %d times" % (words, EXAGGERATION),
        (28, 960), 24, spacing=1.15))  # in the sky, in pictures of 1920 x 1080
