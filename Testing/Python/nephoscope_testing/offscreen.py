# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Off-screen windows, volumes in them, and what they drew as numpy arrays (bottom row first)."""
import ctypes
import ctypes.util
import sys

import numpy as np
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  (registers the OpenGL classes)
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkRenderingCore import (vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkVolume,
                                         vtkWindowToImageFilter)

from .messages import Messages
from .view import View


IDLE = []  # windows of VTK that nobody has any more
SETTINGS = ("OffScreenRendering", "MultiSamples", "AlphaBitPlanes", "NumberOfLayers", "StereoRender", "StereoType", "UseSRGBColorSpace", "LineSmoothing",
            "PolygonSmoothing", "PointSmoothing", "AbortRender", "DesiredUpdateRate", "Interactor", "SharedRenderWindow", "SwapBuffers", "DPI")


def settings_of(window):
    return [getattr(window, "Get" + name)() for name in SETTINGS if hasattr(window, "Get" + name)]


class Window:
    """A render window without multisampling; every message of any VTK object while it draws is kept.

    The window of VTK may be one that an earlier case has left: to open one and to compile its shaders takes longer than most pictures. The first of a process is new.
    """

    def __init__(self, size=(96, 96)):
        self.window = IDLE.pop() if IDLE else self.new()
        self.settings = settings_of(self.window)
        self.window.SetSize(*size)
        self.messages = Messages()

    @staticmethod
    def new():
        window = vtkRenderWindow()
        window.SetOffScreenRendering(1)
        window.SetMultiSamples(0)
        return window

    def __del__(self):
        """Leaves the window to others, unless someone else holds it, or has changed it in a way that others would see."""
        window = self.__dict__.pop("window", None)
        if window is None or sys.is_finalizing() or sys.getrefcount(window) > 2 or window.GetReferenceCount() > 1 or settings_of(window) != self.settings:
            return
        for renderer in list(window.GetRenderers()):
            window.RemoveRenderer(renderer)
        IDLE.append(window)

    def add_scene(self, **options):
        scene = Scene(self, **options)
        self.window.AddRenderer(scene.renderer)
        return scene

    def render(self):
        with self.messages:
            self.window.Render()

    def rgba(self, alpha=True):
        """The window's 8-bit picture as floats in [0, 1]; three components without alpha."""
        grab = vtkWindowToImageFilter()
        grab.SetInput(self.window)
        grab.SetInputBufferTypeToRGBA() if alpha else grab.SetInputBufferTypeToRGB()
        grab.ReadFrontBufferOff()
        grab.ShouldRerenderOff()
        grab.Update()
        image = grab.GetOutput()
        width, height, _ = image.GetDimensions()
        return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1) / 255.0

    def gl_errors(self):
        """Error codes that OpenGL still holds for this window's context."""
        library = ctypes.CDLL(ctypes.util.find_library("GL") or "libGL.so.1")
        self.window.MakeCurrent()
        codes = []
        while len(codes) < 32:
            code = library.glGetError()
            if not code:
                break
            codes.append(hex(code))
        return codes


class Scene:
    """One renderer of a window: camera, volumes, opaque actors."""

    def __init__(self, window, viewport=(0, 0, 1, 1), background=(0, 0, 0)):
        self.window = window
        self.renderer = vtkRenderer()
        self.renderer.SetViewport(*viewport)
        self.renderer.SetBackground(*background)
        self.camera = self.renderer.GetActiveCamera()

    def look(self, position, focus=(0, 0, 0), up=(0, 1, 0), angle=30.0, parallel_scale=None, near=None, far=None):
        """Places the camera; the clipping range is fixed, so that the reference knows it."""
        c = self.camera
        c.SetPosition(*position)
        c.SetFocalPoint(*focus)
        c.SetViewUp(*up)
        if parallel_scale is None:
            c.SetViewAngle(angle)
        else:
            c.ParallelProjectionOn()
            c.SetParallelScale(parallel_scale)
        distance = np.linalg.norm(np.subtract(position, focus))
        c.SetClippingRange(near or 0.05 * distance, far or 4 * distance)

    def look_at(self, dataset, direction=(0.45, 0.3, 0.84), up=(0, 1, 0), zoom=1.0, parallel=False, angle=30.0):
        """Frames the bounds (given or of a data set) from a direction."""
        b = np.array(dataset.GetBounds() if hasattr(dataset, "GetBounds") else dataset).reshape(3, 2)
        center, radius = b.mean(axis=1), 0.5 * np.linalg.norm(b[:, 1] - b[:, 0])
        direction = np.asarray(direction, float) / np.linalg.norm(direction)
        distance = radius / np.sin(np.radians(angle / 2)) / zoom
        self.look(center + distance * direction, center, up, angle, radius / zoom if parallel else None,
                  max(distance - 1.5 * radius, 0.01 * distance), distance + 1.5 * radius)

    def add_volume(self, mapper, data, transfer, array="s", association="point", matrix=None):
        if data is not None:
            mapper.SetInputData(data)
        if association == "point":
            mapper.SetScalarModeToUsePointFieldData()
        else:
            mapper.SetScalarModeToUseCellFieldData()
        mapper.SelectScalarArray(array)
        volume = vtkVolume()
        volume.SetMapper(mapper)
        if transfer is not None:
            volume.SetProperty(transfer if hasattr(transfer, "GetScalarOpacity") else transfer.volume_property())
        if matrix is not None:
            volume.SetUserMatrix(vtk_matrix(matrix))
        self.renderer.AddVolume(volume)
        return volume

    def add_opaque(self, polydata, color):
        """A surface of one flat colour, without lighting."""
        mapper = vtkPolyDataMapper()
        mapper.SetInputData(polydata)
        mapper.ScalarVisibilityOff()
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(*color)
        actor.GetProperty().LightingOff()
        self.renderer.AddActor(actor)
        return actor

    def pixel_box(self):
        """x0, y0, width, height of the viewport."""
        width, height = self.window.window.GetSize()
        x0, y0, x1, y1 = self.renderer.GetViewport()
        left, bottom = round(x0 * width), round(y0 * height)
        return left, bottom, round(x1 * width) - left, round(y1 * height) - bottom

    def view(self):
        return View(self.camera, self.pixel_box()[2:])

    def rgb(self):
        x, y, width, height = self.pixel_box()
        return self.window.rgba()[y:y + height, x:x + width, :3]


def float_image(mapper):
    """The mapper's own float picture (height, width, 4)."""
    image = vtkImageData()
    if not mapper.CopyFloatImage(image):
        raise AssertionError("CopyFloatImage returned false")
    width, height, depth = image.GetDimensions()
    array = image.GetPointData().GetArray("RGBA")
    assert depth == 1 and array is not None and array.GetNumberOfComponents() == 4
    return vtk_to_numpy(array).reshape(height, width, 4).astype(float)


def vtk_matrix(matrix):
    result = vtkMatrix4x4()
    result.DeepCopy([float(v) for v in np.asarray(matrix, float).ravel()])
    return result
