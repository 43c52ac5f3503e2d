# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Flat sheets with texture coordinates that fill the view, and what is drawn of them."""
import unittest

import nephoscope
import numpy as np
from nephoscope_testing import meshes
from nephoscope_testing.offscreen import Window
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkRenderingCore import vtkActor

COLUMNS = 17
HALF = 1.0  # the sheet goes from -1 to 1


def add_field(data, name, values):
    array = vtkDoubleArray()
    array.SetName(name)
    array.SetNumberOfComponents(len(values))
    array.InsertNextTuple(values)
    data.GetFieldData().AddArray(array)


def sheet(corners, sets, weights=None, frame=1, wrap=False, center=(0, 0, 0), tilt=0, with_normals=False):
    """Texture coordinates go from corners[0] at the lower left to corners[1] at the upper right: u across, v up, w both.
    sets: shift and factor of each set of coordinates. wrap: u is left in 0 ... 1, as longitudes are."""
    s, t = (a.ravel() for a in np.meshgrid(*2 * [np.linspace(0, 1, COLUMNS)]))
    angle = np.radians(tilt)
    x, y = HALF * (2 * s - 1), HALF * (2 * t - 1)
    ids = np.arange(COLUMNS * COLUMNS).reshape(COLUMNS, COLUMNS)
    cells = np.stack([ids[:-1, :-1], ids[:-1, 1:], ids[1:, 1:], ids[1:, :-1]], -1).reshape(-1, 4)
    data = meshes.surface(np.stack([x * np.cos(angle), y, x * np.sin(angle)], -1) + center, cells)
    p = coordinates(corners, s, t)
    for i, (shift, factor) in enumerate(sets):
        q = factor * p + shift
        if wrap:
            q[:, 0] %= 1
        meshes.add_array(data.GetPointData(), q, f"TextureCoordinates{i + 1}")
    add_field(data, "TextureFrame", [0 if wrap else frame])
    if weights is not None:
        add_field(data, "TextureWeights", weights)
    if with_normals:
        normal = np.tile((-np.sin(angle), 0, np.cos(angle)), (s.size, 1))
        data.GetPointData().SetNormals(numpy_to_vtk(normal.astype(np.float32), deep=True))
    return data


def coordinates(corners, s, t):
    low, high = np.array(corners, float)
    share = np.stack([s, t, 0.5 * (s + t)], -1)
    return low + share * (high - low)


def coordinates_of_pixels(corners, pixels):
    middle = (np.arange(pixels) + 0.5) / pixels
    s, t = np.meshgrid(middle, middle)
    return coordinates(corners, s, t)


class TextureTestCase(unittest.TestCase):
    def add_sheet(self, scene, data, color=(1, 1, 1)):
        """Opaque where there is cloud, in one colour, without lights and with edges that are nearly sharp."""
        mapper = nephoscope.vtkCloudTextureMapper()
        mapper.SetInputDataObject(data)
        mapper.ScalarVisibilityOff()
        mapper.SetTextureScale(1)
        mapper.SetOpticalDepth(1e6)
        mapper.SetWavesToPaper()
        mapper.SetSoftness(0.15)
        mapper.SetRelief(0)
        mapper.SetThinColor(1, 1, 1)
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(*color)
        actor.GetProperty().LightingOff()
        scene.renderer.AddActor(actor)
        return mapper, actor

    def scene(self, data, size, center=(0, 0, 0), parallel=True, color=(1, 1, 1)):
        window = Window(size)
        scene = window.add_scene()
        mapper, _ = self.add_sheet(scene, data, color)
        scene.look(np.add(center, (0, 0, 10)), center, parallel_scale=HALF if parallel else None)
        self.last_scene = scene
        return window, mapper, scene

    def draw(self, window):
        """Brightness of the picture; normal scenes draw without messages."""
        window.render()
        self.assertEqual(window.messages.all, [])
        self.assertEqual(window.gl_errors(), [])
        return window.rgba()[..., 0]
