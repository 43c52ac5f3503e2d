# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What of the input is drawn, where and how far it reaches: transparent samples, actors that stretch, bounds."""
import unittest

import nephoscope
import numpy as np
from nephoscope_testing import meshes
from nephoscope_testing.checks import ImageTestCase
from nephoscope_testing.offscreen import Window, float_image
from nephoscope_testing.transfer import Transfer
from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid
from vtkmodules.vtkFiltersCore import vtkAppendFilter

RAMP = Transfer([(0, 1, 0.2, 0.1), (1, 0.1, 0.3, 1)], [(0, 0), (1, 0.8)])
STRETCH = np.array([[0.4, 0, 0, 1], [0, 2.5, 0, -2], [0.3, 0, 1, 0.5], [0, 0, 0, 1.0]])
SIZE = (11, 9, 8)


def winds(points):
    x, y, z = points.T
    return np.stack([1 + 0.1 * y, 0.7 * np.sin(x), 0.3 + 0.1 * z], 1)


def block(bend=None, size=SIZE):
    """A structured grid, and what it holds; `bend` moves its points and turns its vectors."""
    data = meshes.structured(size, lambda p: p * (np.array(size) - 1) - (np.array(size) - 1) / 2)
    points = meshes.points_of(data)
    values = np.maximum(0, np.sin(points[:, 0]) * np.cos(0.7 * points[:, 1] + points[:, 2]))
    vectors = winds(points)
    if bend is not None:
        data = meshes.structured(size, lambda p: bend[:3, 3] + (p * (np.array(size) - 1) - (np.array(size) - 1) / 2) @ bend[:3, :3].T)
        vectors = vectors @ bend[:3, :3].T
    meshes.add_array(data.GetPointData(), values)
    meshes.add_array(data.GetPointData(), vectors, "v")
    return data


def each_sample(mapper):
    mapper.InterpolateScalarsBeforeMappingOff()


class Scenes(ImageTestCase):
    def draw(self, data, configure=None, matrix=None, look=None, transfer=RAMP, association="point"):
        window = Window((120, 100))
        scene = window.add_scene()
        mapper = nephoscope.vtkTexturedSplatMapper()
        if configure:
            configure(mapper)
        scene.add_volume(mapper, data, transfer, association=association, matrix=matrix)
        (look or (lambda s: s.look((14, 18, 22), (0, 0, 0), angle=50)))(scene)
        window.render()
        self.fail_on_messages(window)
        return mapper, float_image(mapper)

    def test_transparent_samples_are_not_drawn(self):
        """At the foot of a ramp of opacity samples cost nothing, and the picture is that of the others alone."""
        for least in (0.0, -0.1, -0.3, -0.45, -0.7, -1.1):  # the ramp's foot is amid the range
            self.check_foot_of_ramp(least, RAMP)
            self.check_foot_of_ramp(least, Transfer([(0, 1, 0.2, 0.1), (1, 0.1, 0.3, 1)], [(-2, 0), (0, 0), (1, 0.8)]))

    def check_foot_of_ramp(self, least, transfer):
        data = block()
        array = data.GetPointData().GetArray("s")
        array.SetValue(0, least)
        values = np.array([array.GetValue(i) for i in range(data.GetNumberOfPoints())])
        for i in np.flatnonzero(values == 0)[::2]:
            array.SetValue(i, 1e-7)  # half of a millionth of the greatest
        mapper, image = self.draw(data, each_sample, transfer=transfer)
        self.assertEqual(mapper.GetNumberOfSamples(), np.count_nonzero(values > 0))
        self.assertLess(mapper.GetNumberOfSamples(), 0.7 * len(values))
        ghosts = data.AllocatePointGhostArray()
        for i, value in enumerate(values):
            ghosts.SetValue(i, 0 if value > 0 else 2)  # hidden
        _, alone = self.draw(data, each_sample, transfer=transfer)
        self.check_float(image, alone, "without the transparent", 1e-6)

    def test_transparent_samples_keep_their_vectors(self):
        data = block()
        mapper, _ = self.draw(data, lambda m: m.SetVectorArrayName("v"))
        self.assertEqual(mapper.GetNumberOfSamples(), data.GetNumberOfPoints())

    def test_bounds_hold_streaks_and_segments(self):
        """Nothing is drawn outside of the bounds as the camera sees them, and something near each side."""
        points = np.array([[0, 0, 0], [1, 0.3, 0.2]])
        for style in (0, 1):
            data = meshes.particles(points)
            meshes.add_array(data.GetPointData(), np.ones(2))
            meshes.add_array(data.GetPointData(), np.array([[1, 2, 0.5], [1, 2, 0.5]]), "v")

            def vectors(mapper):
                mapper.SetVectorArrayName("v")
                mapper.SetVectorStyle(style)
                mapper.SetCellSize(0.2)
                mapper.SetStreakPeriod(12)
                mapper.SetSegmentLength(10)
                mapper.SetVectorOpacity(50)
            mapper, image = self.draw(data, vectors, look=lambda s: s.look((0, 0, 20), (0, 0, 0), parallel_scale=3))
            shown = np.argwhere(image[..., 3] > 1e-3)
            pixel = 6 / image.shape[0]
            seen = np.array([shown[:, 1].min() - 60, shown[:, 1].max() - 59, shown[:, 0].min() - 50, shown[:, 0].max() - 49]) * pixel
            bounds = np.array(mapper.GetBounds())[:4]
            print(f"  style {style}: seen {seen}, bounds {bounds}")
            outside = (bounds - seen) * np.array([1, -1, 1, -1])
            self.assertLess(outside.max(), 3 * pixel)  # lines are some pixels wide
            self.assertGreater(outside.min(), -0.35)

    def test_vectors_around_the_eye(self):
        """With the eye in a splat its vector is drawn, too: what medium and vector let through is multiplied."""
        for style, placement in ((0, 0), (1, 0), (1, 1)):
            data = meshes.particles(np.zeros((1, 3)))
            meshes.add_array(data.GetPointData(), np.ones(1))
            meshes.add_array(data.GetPointData(), np.array([[1, 0.5, 0]]), "v")

            def vectors(mapper):
                mapper.SetVectorArrayName("v")
                mapper.SetVectorStyle(style)
                mapper.SetVectorPlacement(placement)
                mapper.SetStreakPeriod(0.4)
                mapper.SetStreakWidth(0.05)
                mapper.SetSegmentWidth(5)
                mapper.SetCellSize(2)

            def look(scene):
                scene.look((0.1, 0.2, 3.6 if style == 0 else 2.5), (0, 0, 0), angle=70, near=0.01, far=20)
            clear = Transfer([(0, 1, 1, 1), (1, 1, 1, 1)], [(0, 0), (1, 0)])
            _, medium = self.draw(data, lambda m: m.SetCellSize(2), look=look)
            _, alone = self.draw(data, vectors, look=look, transfer=clear)
            _, both = self.draw(data, vectors, look=look)
            self.assertGreater(alone[..., 3].max(), 0.3)
            self.assertGreater(medium[..., 3].max(), 0.3)
            expected = 1 - (1 - medium[..., 3:]) * (1 - alone[..., 3:])
            self.check_float(both[..., 3:], expected, f"vector of style {style}, placement {placement} around the eye", 1e-5)

    def test_ghosts(self):
        """Hidden, refined and duplicate cells, given for cells or points, draw nothing; points do if all of their cells are such."""
        hide, shown = {}, {}
        points = np.array([p for p in np.ndindex(SIZE[2] + 1, SIZE[1] + 1, SIZE[0] + 1)])[:, ::-1]
        cells = np.array([c for c in np.ndindex(SIZE[2], SIZE[1], SIZE[0])])[:, ::-1]
        for name, flag in (("hidden", 32), ("refined", 8), ("duplicate", 1)):
            hide[name] = lambda data, flag=flag: ghost(data.AllocateCellGhostArray(), cells[:, 0] >= 5, flag)
            shown[name] = {"cell": int((cells[:, 0] < 5).sum()), "point": int((points[:, 0] <= 5).sum())}
        hidden = (cells[:, 0] == 4) & (cells[:, 1] < 2)  # at the border of two processes, where the other one's are shown
        hide["border"] = lambda data: ghost(data.AllocateCellGhostArray(), cells[:, 0] >= 5, 1) or ghost(data.GetCellGhostArray(), hidden, 32)
        shown["border"] = {"cell": int(((cells[:, 0] < 5) & ~hidden).sum()), "point": int((points[:, 0] <= 5).sum())}
        hide["hidden point"] = lambda data: ghost(data.AllocatePointGhostArray(), points[:, 0] >= 5, 2)
        shown["hidden point"] = {"cell": int((cells[:, 0] < 4).sum()), "point": int((points[:, 0] < 5).sum())}

        def ghost(array, flags, flag):
            for i in np.flatnonzero(flags):
                array.SetValue(i, flag)
        opaque = Transfer([(0, 1, 1, 1), (2, 1, 1, 1)], [(0, 0.5), (2, 0.5)])
        for name, set_ghosts in hide.items():
            for association in ("cell", "point"):
                for unstructured in (False, True):
                    data = meshes.structured(SIZE, lambda p: p * (np.array(SIZE) - 1) - (np.array(SIZE) - 1) / 2)
                    if unstructured:
                        grid = vtkUnstructuredGrid()
                        append = vtkAppendFilter()
                        append.SetInputData(data)
                        append.Update()
                        grid.ShallowCopy(append.GetOutput())
                        data = grid
                    attributes = data.GetPointData() if association == "point" else data.GetCellData()
                    meshes.add_array(attributes, np.ones(len(points) if association == "point" else len(cells)))
                    set_ghosts(data)
                    mapper, image = self.draw(data, transfer=opaque, association=association)
                    self.assertEqual(mapper.GetNumberOfSamples(), shown[name][association], (name, association, unstructured))
                    self.assertGreater(image[..., 3].max(), 0.3)

    def test_seam_of_a_closed_grid(self):
        """A ring whose last column is its first once more: constant density is as flat across the seam as elsewhere."""
        columns = 36

        def ring(points):
            angle = 2 * np.pi * points[:, 0]
            radius = 5 + 3 * points[:, 1]
            return np.stack([radius * np.cos(angle), radius * np.sin(angle), points[:, 2]], 1)
        data = meshes.structured((columns, 8, 8), ring)
        meshes.add_array(data.GetPointData(), np.ones(data.GetNumberOfPoints()))
        constant = Transfer([(0, 1, 1, 1), (2, 1, 1, 1)], [(0, 0.5), (2, 0.5)])
        mapper, image = self.draw(data, look=lambda s: s.look((0, 0, 30), (0, 0, 0), parallel_scale=9), transfer=constant)
        self.assertEqual(mapper.GetNumberOfSamples(), columns * 81)
        depth = -np.log1p(-image[..., 3])
        y, x = (np.mgrid[0:100, 0:120] - np.array([49.5, 59.5])[:, None, None]) * 0.18
        inside = depth[np.abs(np.hypot(x, y) - 6.5) < 0.2]
        print(f"  ring: {inside.min():.4f} to {inside.max():.4f}")
        self.assertLess(inside.max() / inside.min(), 1.02)

    def check_stretch(self, label, configure=None, tolerance=2e-5):
        """An actor that stretches and shears is the data stretched and sheared."""
        for view, look in (("perspective", lambda s: s.look((9, 15, 18), (1, -2, 0.5), angle=50)),
                           ("parallel", lambda s: s.look((9, 15, 18), (1, -2, 0.5), parallel_scale=9))):
            first, by_actor = self.draw(block(), configure, STRETCH, look)
            second, by_data = self.draw(block(STRETCH), configure, None, look)
            self.assertGreater(by_data[..., 3].max(), 0.5)
            self.check_float(by_actor, by_data, f"{label}, {view}", tolerance)
            self.assertLessEqual(abs(first.GetNumberOfDrawnSplats() - second.GetNumberOfDrawnSplats()),
                                 0.01 * second.GetNumberOfDrawnSplats())
        return second

    def test_stretched_actor(self):
        self.check_stretch("samples")

    def test_no_layers_once_there_are_no_vectors(self):
        """Layers that are switched off, by the placement or with the vectors, leave nothing behind."""
        data = block()

        def layered(mapper):
            mapper.SetVectorArrayName("v")
            mapper.SetLayerAxis(0)
            mapper.SetVectorPlacementToLayers()

        def plain(mapper):
            mapper.SetLayerAxis(0)

        window = Window((120, 100))
        scene = window.add_scene()
        mapper = nephoscope.vtkTexturedSplatMapper()
        layered(mapper)
        scene.add_volume(mapper, data, RAMP)
        scene.look((14, 18, 22), (0, 0, 0), angle=50)
        window.render()
        mapper.SetVectorArrayName("")
        scene.look((15, 17, 22), (0, 0, 0), angle=50)
        window.render()
        self.fail_on_messages(window)
        fresh = self.draw(data, plain, look=lambda s: s.look((15, 17, 22), (0, 0, 0), angle=50))[1]
        np.testing.assert_allclose(float_image(mapper), fresh, atol=1e-6)

    def test_stretched_actor_in_layers(self):
        """The stretch decides which axis faces the eye."""
        def segments(mapper):
            mapper.SetVectorArrayName("v")
            mapper.SetVectorStyleToSegments()
            mapper.SetVectorPlacementToLayers()
            mapper.SetSegmentLength(1e-6)  # vectors are stretched, too: dots are alike
            mapper.SetGreatestSpeed(1e-3)
            mapper.SetVectorUnit(1)
        self.check_stretch("layers", segments, 1e-4)


if __name__ == "__main__":
    unittest.main()
