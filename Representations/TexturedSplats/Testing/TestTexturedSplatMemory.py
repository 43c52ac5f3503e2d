# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a splat needs in memory, and that what is freed once the graphics card has it is found again where it is needed."""
import ctypes
import os
import subprocess
import sys
import unittest

import nephoscope
import numpy as np
from nephoscope_testing import meshes
from nephoscope_testing.checks import ImageTestCase
from nephoscope_testing.offscreen import Window, float_image
from nephoscope_testing.transfer import Transfer
from vtkmodules.util.numpy_support import vtk_to_numpy

COLORS = [(0, 1, 0.2, 0.1), (1, 0.1, 0.3, 1)]
RAMP = Transfer(COLORS, [(0, 0), (0.4, 0), (1, 0.8)])
FEW = 40
MANY = 100  # samples along an edge


def grid(height=1.0):
    """A structured grid that is bent, so that every sample has a shape of its own; flat ones are drawn in layers."""
    data = meshes.structured((14, 12, 10), lambda p: (np.stack([p[:, 0] + 0.1 * p[:, 1] * p[:, 2], p[:, 1], height * (p[:, 2] - 0.1 * p[:, 0]**2)], 1) - 0.5) * 4)
    points = meshes.points_of(data)
    meshes.add_array(data.GetPointData(), 0.5 + 0.5 * np.sin(2 * points[:, 0]) * np.cos(3 * points[:, 1]))
    meshes.add_array(data.GetPointData(), np.stack([points[:, 1], -points[:, 0], 0.2 + 0 * points[:, 0]], 1), "v")
    return data


def numbered_backwards(data):
    """The points of a grid as particles, in the opposite order."""
    points = meshes.points_of(data)[::-1]
    result = meshes.particles(points)
    for name in ("s", "v"):
        meshes.add_array(result.GetPointData(), vtk_to_numpy(data.GetPointData().GetArray(name))[::-1], name)
    return result


def own_shapes():
    mapper = nephoscope.vtkTexturedSplatMapper()
    mapper.CellSizeFromNeighborsOn()  # of particles
    return mapper


class Memory(ImageTestCase):
    def draw(self, data, mapper, volume=None, angle=0.0):
        self.window = Window((100, 90))
        scene = self.window.add_scene()
        self.volume = scene.add_volume(mapper, data, RAMP)
        if volume:
            self.volume.SetProperty(volume.GetProperty())
        self.scene = scene
        self.turn(angle)
        self.window.render()
        return float_image(mapper)

    def turn(self, angle):
        self.scene.look((8 * np.sin(angle), 3, 8 * np.cos(angle)), (0, 0, 0), angle=40)

    def again(self, mapper):
        self.window.render()
        self.fail_on_messages(self.window)
        return float_image(mapper)

    def check_edits(self, name, data):
        mapper = own_shapes()
        self.draw(data, mapper)
        volume, window, scene = self.volume, self.window, self.scene
        opacity = volume.GetProperty().GetScalarOpacity()
        color = volume.GetProperty().GetRGBTransferFunction()
        edits = {
            "colours": lambda: color.AddRGBPoint(0.5, 0, 1, 0),
            "opacity of the same samples": lambda: opacity.AddPoint(1, 0.5),
            "more samples": lambda: opacity.AddPoint(0.2, 0.3),
            "fewer samples": lambda: (opacity.RemoveAllPoints(), opacity.AddPoint(0, 0), opacity.AddPoint(0.7, 0), opacity.AddPoint(1, 0.8)),
            "blocks": lambda: mapper.SetErrorTolerance(0.05),
            "no blocks": lambda: mapper.SetErrorTolerance(0),
            "vectors": lambda: mapper.SetVectorArrayName("v"),
            "no vectors": lambda: mapper.SetVectorArrayName(""),
            "released": lambda: mapper.ReleaseGraphicsResources(window.window),
        }
        for number, (what, edit) in enumerate(edits.items()):
            with self.subTest(name, edit=what):
                for step in (1, 2, 3):  # what is freed is freed once the camera moves
                    self.window, self.scene = window, scene
                    self.turn(0.1 * (3 * number + step))
                    self.again(mapper)
                edit()
                picture = self.again(mapper)
                fresh = own_shapes()
                fresh.SetErrorTolerance(mapper.GetErrorTolerance())
                fresh.SetVectorArrayName(mapper.GetVectorArrayName())
                expected = self.draw(data, fresh, volume, 0.1 * (3 * number + 3))
                self.assertGreater(expected.max(), 0.05)
                np.testing.assert_array_equal(picture, expected)

    def test_pictures_after_edits_are_those_of_a_new_mapper(self):
        for name, data in {"grid": grid(), "flat grid": grid(0.05), "particles": numbered_backwards(grid())}.items():
            self.check_edits(name, data)

    def test_order_of_particles_is_without_effect(self):
        """Also after the camera has moved and other samples are drawn."""
        pictures = []
        backwards = numbered_backwards(grid())
        for data in (backwards, numbered_backwards(backwards)):
            mapper = own_shapes()
            self.draw(data, mapper)
            for angle in (0.2, 0.4):
                self.turn(angle)
                self.again(mapper)
            self.volume.GetProperty().GetScalarOpacity().AddPoint(0.2, 0.3)
            pictures.append(self.again(mapper))
        np.testing.assert_array_equal(pictures[0], pictures[1])

    def test_bytes_of_a_splat_of_its_own_shape(self):
        """At most 100 above the input once the camera has moved, with the buffers of software OpenGL; what pictures need once does not count."""
        grown = {}
        for side in (FEW, MANY):
            command = [sys.executable, __file__, "grow", str(side)]
            run = subprocess.run(command, check=True, env=dict(os.environ, LP_NUM_THREADS="0"), stdout=subprocess.PIPE, text=True)
            grown[side] = int(run.stdout.split()[-1])
        print(f"{(grown[MANY] - grown[FEW]) / (MANY**3 - FEW**3):.1f} bytes for each splat")
        self.assertLess(grown[MANY] - grown[FEW], 100 * (MANY**3 - FEW**3))


def resident():
    ctypes.CDLL(None).malloc_trim(0)
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def uneven(side):
    axis = np.linspace(-1, 1, side)
    data = meshes.rectilinear([axis + 0.1 * axis**2] * 3)
    meshes.add_array(data.GetPointData(), np.linspace(0.1, 1, side**3))
    return data


def print_growth(side):
    def draw(data):
        window = Window((64, 64))
        scene = window.add_scene()
        scene.add_volume(nephoscope.vtkTexturedSplatMapper(), data, Transfer(COLORS, [(0, 1), (1, 1)]))
        scene.look((0, 0, 8), (0, 0, 0))
        window.render()
        for x in (1, 2):
            scene.look((x, 0, 8), (0, 0, 0))
            window.render()
        return window

    first = draw(uneven(8))
    data = uneven(side)
    before = resident()
    second = draw(data)
    print(resident() - before)
    del first, second


if __name__ == "__main__":
    if sys.argv[1:2] == ["grow"]:
        print_growth(int(sys.argv[2]))
    else:
        unittest.main()
