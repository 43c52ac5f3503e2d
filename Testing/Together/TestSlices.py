# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Slices of depth change nothing: a volume looks the same among faint splats, for which it is drawn in slices, as alone."""
import unittest

import nephoscope
import numpy as np
from nephoscope_testing import meshes
from nephoscope_testing.checks import ImageTestCase, mapper
from nephoscope_testing.haze import Haze
from nephoscope_testing.offscreen import Window
from nephoscope_testing.transfer import Transfer, constant

WARM = Transfer([(0, 1, 0, 0), (1, 1, 0.6, 0)], [(0, 0.4), (0.5, 6), (1, 0.2)])
THICK = Transfer([(0, 1, 0, 0), (1, 0, 0.6, 1)], [(0, 0), (0.3, 0), (0.31, 90), (1, 200)])
FAINT = constant(5e-4, (0.5, 0.5, 0.5))
AIR = Haze(0.05, 1e7, color=(0.6, 0.6, 0.7))
BOUNDS = (0, 1, 0, 1, 0, 1)


def wave(p):
    return 0.5 + 0.5 * np.sin(4 * p @ (1, 0.6, 0.3))


def mesh(kind):
    """Cells whose points are moved a little, but for images."""
    if kind == "image":
        return meshes.with_field(meshes.image((7,) * 3, np.full(3, 1 / 7), (0, 0, 0)), wave)
    data = meshes.Lattice(5).mesh(kind)
    points = meshes.points_of(data)
    inner = np.all((points > 0.01) & (points < 0.99), axis=1)[:, None]
    data.SetPoints(meshes.vtk_points(points + 0.04 * inner * np.sin(9 * points[:, [1, 2, 0]])))
    return meshes.with_field(data, wave)


def aslant(scene):
    scene.look_at(BOUNDS)


def along_axis(scene):
    scene.look_at(BOUNDS, direction=(0, 0, -1), up=(0, 1, 0))


def parallel_along_axis(scene):
    scene.look_at(BOUNDS, direction=(-1, 0, 0), up=(0, 0, 1), parallel=True)


def inside(scene):
    scene.look((0.4, 0.6, 0.4), (0.9, 0.7, 0.8), angle=60, near=0.005, far=9)


def contours(cells):
    cells.SetNumberOfContourValues(2)
    cells.SetContourValue(0, 0.3)
    cells.SetContourValue(1, 0.7)
    cells.SetContourOpacity(0, 0.6)
    cells.SetContourOpacity(1, 1)


def trilinear(cells):
    cells.SetCellInterpolationToTrilinear()


def trilinear_contours(cells):
    trilinear(cells)
    contours(cells)


class Slices(ImageTestCase):
    def picture(self, data, transfer, look, configure, prepare, among_splats):
        window = Window((60, 52))
        scene = window.add_scene()
        cells = mapper()
        scene.add_volume(cells, data, transfer)
        if configure:
            configure(cells)
        if among_splats:
            scene.add_volume(nephoscope.vtkTexturedSplatMapper(), data, FAINT)
        if prepare:
            prepare(scene)
        look(scene)
        window.render()
        self.fail_on_messages(window)
        self.assertEqual(window.gl_errors(), [])
        return scene.rgb()

    def check(self, kind, transfer=WARM, look=aslant, configure=None, prepare=None):
        alone, sliced = (self.picture(mesh(kind), transfer, look, configure, prepare, among_splats) for among_splats in (False, True))
        label = f"{kind}, {look.__name__}, {getattr(configure, '__name__', 'plain')}"
        self.assertGreater(np.ptp(alone), 0.2, label)
        self.assertLessEqual(np.abs(alone - sliced).max(), 1.01 / 255, label)

    def test_kinds_of_cells(self):
        for kind in ("image", "tetra", "voxel", "hexahedron", "wedge", "pyramid"):
            for configure in (None, trilinear, contours, trilinear_contours):
                self.check(kind, configure=configure)

    def test_cameras(self):
        for kind in ("image", "tetra", "hexahedron"):
            for look in (along_axis, parallel_along_axis, inside):
                for configure in (None, trilinear):
                    self.check(kind, look=look, configure=configure)

    def test_thick_clouds(self):
        """Nothing shines through them, and their edges are as sharp."""
        for kind in ("image", "tetra", "hexahedron"):
            for configure in (None, trilinear):
                self.check(kind, THICK, configure=configure)

    def test_in_haze(self):
        for kind in ("image", "tetra", "hexahedron"):
            for configure in (None, trilinear, contours):
                self.check(kind, configure=configure, prepare=lambda scene: nephoscope.vtkHaze.SetHaze(scene.renderer, AIR.make(nephoscope.vtkHaze)))


if __name__ == "__main__":
    unittest.main(verbosity=2)
