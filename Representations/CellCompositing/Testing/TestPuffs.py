# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Puffs: the opacity of the same cells changes from frame to frame. Each picture is that of a mapper that never drew before, and
neither mesh nor order is made again, which progress events would tell of."""
import unittest

import numpy as np
from nephoscope_testing import meshes, smoke
from nephoscope_testing.checks import ImageTestCase, mapper
from nephoscope_testing.offscreen import Window, float_image
from nephoscope_testing.transfer import Transfer
from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid

ONE_COLOR = Transfer([(0, 1, 0.5, 0.25)], [(0, 0), (1, 4)])
COLORS = Transfer([(0, 1, 0.2, 0), (1, 0, 0.3, 1)], [(0, 0), (1, 4)])
METHODS = ("Automatic", "Projection", "Rays")
# Geometry and order are the first 95 of 100; then comes what is uploaded.
MADE = 0.95


def pulse(data, phase):
    """Density 0 to 1, smooth in the number of the cell, that moves on with the phase: 0 in half of the cells."""
    i = np.arange(data.GetNumberOfCells())
    return np.maximum(np.cos(2 * np.pi * (3 * i / len(i) - phase)), 0)


class Puffs(ImageTestCase):
    def start(self, method, transfer, data=None, association="cell"):
        self.data = data or smoke.loop()
        meshes.with_field(self.data, lambda p: 0.5 + 0.3 * p[:, 1])
        attributes = self.data.GetCellData() if association == "cell" else self.data.GetPointData()
        meshes.add_array(attributes, pulse(self.data, 0) if association == "cell" else meshes.points_of(self.data)[:, 0] + 1, "Density")
        self.method, self.transfer = method, transfer
        self.window, self.mapper, self.events = Window(), mapper(), []
        self.scene = self.window.add_scene()
        self.scene.add_volume(self.set_up(self.mapper), self.data, transfer)
        self.scene.look_at(self.data)
        self.mapper.AddObserver("ProgressEvent", lambda *_: self.events.append(self.mapper.GetProgress()))
        self.window.render()
        self.assertLess(min(self.events), 0.5, "the first frame makes the mesh")

    def set_up(self, ours):
        ours.SetOpacityArrayName("Density")
        getattr(ours, "SetMethodTo" + self.method)()
        return ours

    def expected(self):
        window, ours = Window(), mapper()
        scene = window.add_scene()
        copy = vtkUnstructuredGrid()
        copy.DeepCopy(self.data)
        scene.add_volume(self.set_up(ours), copy, self.transfer)
        scene.camera.DeepCopy(self.scene.camera)
        window.render()
        self.expected_count = ours.GetNumberOfDrawnTetrahedra()
        return float_image(ours)

    def check_frame(self, label, made=False, tolerance=0):
        """Draws; the picture must be that of a new mapper, and must not be that of the last frame."""
        before = float_image(self.mapper)
        self.mapper.Update()  # whose events, 0 and 1, are the pipeline's
        self.events.clear()
        self.window.render()
        image = float_image(self.mapper)
        self.assertLessEqual(np.abs(image - self.expected()).max(), tolerance, label)
        self.assertEqual(self.mapper.GetNumberOfDrawnTetrahedra(), self.expected_count, label)
        self.assertGreater(np.abs(image - before).max(), 0.01, f"{label}: the picture must change")
        self.assertEqual(any(e < MADE for e in self.events), made, f"{label}: {self.events}")
        self.fail_on_messages(self.window)

    def test_every_way_to_change_an_array(self):
        for method in METHODS:
            for transfer in (ONE_COLOR, COLORS):
                self.start(method, transfer)
                density = lambda: self.data.GetCellData().GetArray("Density")
                values = lambda: meshes.vtk_to_numpy(density())
                meshes.add_array(self.data.GetCellData(), pulse(self.data, 0.2), "Density")
                self.check_frame(f"{method}, another array")
                values()[:] = pulse(self.data, 0.4)
                density().Modified()
                self.check_frame(f"{method}, the array says so")
                values()[:] = pulse(self.data, 0.6)
                self.data.Modified()
                self.check_frame(f"{method}, the dataset says so")
                meshes.add_array(self.data.GetCellData(), 1.7 * pulse(self.data, 0.8), "Density")
                self.check_frame(f"{method}, another range")
                other = vtkUnstructuredGrid()
                other.ShallowCopy(self.data)
                meshes.add_array(other.GetCellData(), pulse(self.data, 0.9), "Density")
                self.data = other
                self.mapper.SetInputData(other)
                self.check_frame(f"{method}, another dataset with the same points and cells")

    def test_nothing_changes(self):
        for method in METHODS:
            self.start(method, COLORS)
            meshes.add_array(self.data.GetCellData(), np.arange(float(self.data.GetNumberOfCells())), "another")
            self.data.Modified()
            self.mapper.Update()
            self.events.clear()
            self.window.render()
            self.assertEqual(self.events, [], f"{method}: nothing is made or uploaded")

    def test_the_mesh_changes(self):
        for method in METHODS:
            self.start(method, COLORS)
            points = self.data.GetPoints()
            for label, told in (("points", points), ("dataset", self.data)):
                meshes.vtk_to_numpy(points.GetData())[10:60, 2] += 0.3
                told.Modified()
                # VTK keeps the bounds of points that are not told: another centre, and other roundings of float.
                self.check_frame(f"{method}, points moved in place, the {label} says so", True, 0 if told is points else 3e-5)
            connectivity = meshes.vtk_to_numpy(self.data.GetCells().GetConnectivityArray())
            connectivity[:] = connectivity.reshape(-1, 4)[::-1].ravel()  # the cells, in the opposite order
            self.data.GetCells().Modified()
            self.check_frame(f"{method}, cells in place", True, 3e-5)

    def test_missing_values_come_and_go(self):
        for method in METHODS:
            self.start(method, COLORS)
            values = meshes.vtk_to_numpy(self.data.GetCellData().GetArray("Density"))
            before = values.copy()
            for label, missing in (("come", slice(20, 60)), ("go", slice(0, 0))):
                values[:] = before
                values[missing] = np.nan
                self.data.GetCellData().GetArray("Density").Modified()
                self.events.clear()
                self.window.render()
                np.testing.assert_array_equal(float_image(self.mapper), self.expected(), f"{method}, missing values {label}")
            self.assertTrue(all("'Density'" in m and "not finite" in m for m in self.window.messages.all) and self.window.messages.all)

    def test_densities_of_points(self):
        for method in METHODS:
            for transfer in (ONE_COLOR, COLORS):
                self.start(method, transfer, association="point")
                meshes.add_array(self.data.GetPointData(), 2 - meshes.points_of(self.data)[:, 0], "Density")
                self.check_frame(f"{method}, densities of points")

    def test_blocks_that_touch(self):
        """Points at the same place with values of their own, which rays may have taken for one."""
        for method in METHODS:
            data = smoke.boxes([((0, 0, 0), (1, 1, 1)), ((1, 0, 0), (2, 1, 1))])
            self.start(method, COLORS, data, "point")
            half = meshes.vtk_to_numpy(self.data.GetPointData().GetArray("Density")).copy()
            half[len(half) // 2:] = 0.2
            meshes.add_array(self.data.GetPointData(), half, "Density")
            self.check_frame(f"{method}, densities that jump between blocks", made=method != "Projection")

    def test_colours_change_too(self):
        for method in METHODS:
            self.start(method, COLORS)
            for name, association in (("s", self.data.GetPointData()), ("Density", self.data.GetCellData())):
                n = association.GetArray(name).GetNumberOfTuples()
                meshes.add_array(association, np.linspace(0, 1, n) ** 2, name)
                self.check_frame(f"{method}, new {name}")

    def test_puffs_that_turn_into_one_colour(self):
        """Colour and opacity of one array, whose range changes what is one colour."""
        transfer = Transfer([(0, 1, 0, 0), (1, 1, 0, 0), (1.5, 0, 0, 1)], [(0, 0), (1, 3)])
        for method in METHODS:
            self.start(method, transfer)
            self.mapper.SetOpacityArrayName("")
            self.set_up = lambda ours: getattr(ours, "SetMethodTo" + self.method)() or ours
            self.mapper.SetScalarModeToUsePointFieldData()
            for scale in (1, 1.5, 0.7):
                meshes.add_array(self.data.GetPointData(), scale * np.linspace(0, 1, self.data.GetNumberOfPoints()), "s")
                self.window.render()
                self.assertEqual(self.mapper.GetOrderIndependent(), scale <= 1)
                np.testing.assert_array_equal(float_image(self.mapper), self.expected(), f"{method}, up to {scale}")


if __name__ == "__main__":
    unittest.main(verbosity=2)
