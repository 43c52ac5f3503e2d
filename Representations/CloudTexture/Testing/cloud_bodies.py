# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Closed bodies of cloud, how long rays stay in them, and scenes where all of their surface is cloud."""
import numpy as np
from cloud_sheets import TextureTestCase
from nephoscope_testing import meshes
from nephoscope_testing.offscreen import Window
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkFiltersSources import vtkSphereSource

CORNERS = np.array([(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)], float)
FACES = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))  # they look outwards


def box(low, high, density=None):
    """density: function of places."""
    points = np.array(low) + CORNERS * np.subtract(high, low)
    data = meshes.surface(points, FACES)
    if density is not None:
        meshes.add_array(data.GetPointData(), np.asarray(density(points), float), "density")
    return data


def sphere(radius, resolution=256):
    source = vtkSphereSource()
    source.SetRadius(radius)
    source.SetThetaResolution(resolution)
    source.SetPhiResolution(resolution)
    source.Update()
    source.GetOutput().GetPointData().SetNormals(None)
    return source.GetOutput()


def together(*bodies):
    append = vtkAppendPolyData()
    for body in bodies:
        append.AddInputData(body)
    append.Update()
    return append.GetOutput()


def torus(large, small, count=400):
    """About the z axis."""
    u, v = (a.ravel() for a in np.meshgrid(*2 * [2 * np.pi * np.arange(count) / count]))
    r = large + small * np.cos(v)
    ids = np.arange(count * count).reshape(count, count)
    right, up = np.roll(ids, -1, 1), np.roll(ids, -1, 0)
    cells = np.stack([ids, right, np.roll(right, -1, 0), up], -1).reshape(-1, 4)
    return meshes.surface(np.stack([r * np.cos(u), r * np.sin(u), small * np.sin(v)], -1), cells)


def stay_in_box(origins, directions, low, high):
    """Ray lengths at which rays enter and leave; equal where they miss."""
    with np.errstate(divide="ignore"):
        a, b = ((np.array(side) - origins) / np.where(directions == 0, 1e-300, directions) for side in (low, high))
    near, far = np.minimum(a, b).max(axis=1), np.maximum(a, b).min(axis=1)
    return near, np.maximum(near, far)


def opacity(optical_depth):
    return 1 - np.exp(-optical_depth)


def wall(z, half=3.0):
    """An opaque thing to put into clouds."""
    return meshes.surface([(-half, -half, z), (half, -half, z), (half, half, z), (-half, half, z)], [(0, 1, 2, 3)])


class BodyTestCase(TextureTestCase):
    def bodies(self, data, size=(96, 96), extinction=1.0, color=(1, 1, 1), **look):
        """White clouds in the dark, without lights: what is drawn is their opacity."""
        window = Window(size)
        scene = window.add_scene()
        mapper, actor = self.add_sheet(scene, data, color)
        mapper.SetCoverage(1)
        mapper.UseThicknessOn()
        mapper.SetExtinction(extinction)
        scene.look(**{"position": (1.2, 0.9, 5), "near": 0.5, "far": 20, **look})
        return window, scene, mapper, actor

    def rays(self, scene):
        origins, directions, near, _ = scene.view().rays()
        return origins, directions, near

    def compare(self, drawn, expected, allowed=1.5 / 255, share=1.0):
        """share: of the pixels that have to agree; at edges rounding decides which side a pixel is on."""
        difference = np.abs(drawn.ravel() - expected)
        self.assertGreater(expected.max(), 0.2)
        self.assertGreaterEqual((difference <= allowed).mean(), share,
                                f"largest difference {difference.max():.4f}, {(difference > allowed).sum()} pixels")


def set_normals(data, normals):
    data.GetPointData().SetNormals(numpy_to_vtk(np.ascontiguousarray(normals, np.float32), deep=True))
