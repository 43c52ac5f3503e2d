# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What .copy() of a volume or surface of clouds gives: the same picture, and nothing but the data in common with the original."""
import copy
import gc
import pickle
import unittest

import nephoscope
import numpy as np
import pyvista
from vtkmodules.vtkCommonDataModel import vtkPlane


def grid():
    data = pyvista.ImageData(dimensions=(6, 6, 6), spacing=(0.2,) * 3, origin=(-0.5,) * 3)
    values = np.arange(data.n_points)
    data["a"], data["Density"] = np.sin(values / 20), values / values.max()
    data["v"] = np.stack([np.cos(values), np.sin(values), values / 100], axis=1)
    return data


SURFACE = pyvista.Sphere(theta_resolution=24, phi_resolution=24)
SURFACE["z"] = SURFACE.points[:, 2]
TURN = pyvista.Transform().rotate_z(30).translate(0.1, 0.2, 0).matrix
ADD = {
    "cells": lambda p, **o: nephoscope.add_cells(p, grid(), "a", **o),
    "surfaces": lambda p, **o: nephoscope.add_cells(p, grid(), "a", contours=dict(values=[-0.3, 0.4], color=["red", "lime"], opacity=0.8),
                                                    layers={1: pyvista.VolumeProperty(opacity_unit_distance=0.3)}, user_matrix=TURN, **o),
    "splats": lambda p, **o: nephoscope.add_splats(p, grid(), "a", opacity_scalars="Density", radius_factor=1.3, **o),
    "winds": lambda p, **o: nephoscope.add_splats(p, grid(), "a", opacity=0, vectors=dict(array="v", scalars="Density"), **o),
    "smoke": lambda p, **o: nephoscope.add_smoke(p, grid().cast_to_unstructured_grid(), **o),
    "clouds": lambda p, **o: nephoscope.add_cloud_texture(p, SURFACE, "z", coverage=0.7, **o),
}


class Copies(unittest.TestCase):
    def plotter(self):
        plotter = pyvista.Plotter(off_screen=True, window_size=(80, 80))
        plotter.set_background("black")
        self.addCleanup(plotter.close)
        return plotter

    def picture(self, plotter):
        plotter.camera_position = [(2, 2, 2), (0, 0, 0), (0, 0, 1)]
        plotter.renderer.ResetCameraClippingRange()
        plotter.render()
        return plotter.screenshot(return_img=True)

    def originals(self):
        for name, add in ADD.items():
            plotter = self.plotter()
            volume = add(plotter, show_scalar_bar=False)
            if name != "clouds":
                plane = vtkPlane()
                plane.SetNormal(1, 0.2, 0)
                volume.mapper.AddClippingPlane(plane)
            with self.subTest(name):
                yield name, plotter, volume, self.picture(plotter)

    def alone(self, name, volume):
        """The picture of a plotter with nothing else in it."""
        plotter = self.plotter()
        plotter.add_actor(volume)
        if name == "clouds":
            plotter.enable_depth_peeling(8)
            plotter.render_window.SetMultiSamples(0)
        return self.picture(plotter)

    def test_the_same_picture(self):
        for name, _, volume, expected in self.originals():
            self.assertGreater(expected.max(), 50)
            for deep in (True, False):
                copy = volume.copy(deep=deep)
                self.assertIsInstance(copy, pyvista.Volume if name != "clouds" else pyvista.Actor)
                self.assertEqual((copy.mapper is volume.mapper, copy.prop is volume.prop), (not deep, not deep))
                np.testing.assert_array_equal(self.alone(name, copy), expected)

    def test_changes_of_the_copy_stay_there(self):
        for name, plotter, volume, expected in self.originals():
            copy = volume.copy()
            mapper = copy.mapper
            mapper.scalar_range = (5, 6)
            mapper.RemoveAllClippingPlanes()
            if name == "clouds":
                mapper.SetCoverage(0.1)
                copy.prop.opacity = 0.2
            else:
                copy.prop.SetScalarOpacityUnitDistance(100)
                copy.user_matrix = pyvista.Transform().translate(1, 0, 0).matrix
                mapper.SetOpacityScale(0.1)
            if name == "surfaces":
                mapper.SetContourValue(0, 0.1)
                mapper.GetLayerProperty(1).SetScalarOpacityUnitDistance(1e-3)
            if name == "winds":
                mapper.GetVectorColorFunction().SetRange(5, 6)
                mapper.phase = 0.4
            np.testing.assert_array_equal(self.picture(plotter), expected)

    def test_moved_planes_and_colours(self):
        """The copy does not follow the planes and colours of the original; it follows its own scalar range."""
        for name, _, volume, expected in self.originals():
            copy = volume.copy()
            volume.mapper.scalar_range = (-9, 9)
            if name != "clouds":
                volume.mapper.GetClippingPlanes().GetItem(0).SetOrigin(100, 0, 0)
            np.testing.assert_array_equal(self.alone(name, copy), expected)
            copy.mapper.scalar_range = (-9, 9) if name != "clouds" else (-0.01, 0)
            if name not in ("winds", "smoke"):
                self.assertGreater(np.abs(self.alone(name, copy).astype(int) - expected).max(), 8)

    def test_streaks_go_on(self):
        plotter = self.plotter()
        volume = ADD["winds"](plotter, show_scalar_bar=False)
        first = self.picture(plotter)
        volume.mapper.AdvancePhases(0.3)
        expected = self.picture(plotter)
        self.assertGreater(np.abs(first.astype(int) - expected).max(), 8)
        np.testing.assert_array_equal(self.alone("winds", volume.copy()), expected)

    def test_messages(self):
        """What the mapper of the copy reports is a Python warning, as from the original's."""
        for name in ("cells", "splats"):
            copy = ADD[name](self.plotter(), show_scalar_bar=False).copy()
            copy.mapper.SelectScalarArray("none")
            gc.collect()  # what only VTK refers to is still told
            with self.subTest(name), self.assertWarnsRegex(RuntimeWarning, "none"):
                self.alone(name, copy)

    def test_of_python(self):
        """copy.copy and copy.deepcopy are .copy(); pickle says what to do."""
        for name, _, volume, _ in self.originals():
            for copied in (copy.copy, copy.deepcopy):
                other = copied(volume.mapper)
                self.assertIs(type(other), type(volume.mapper))
                self.assertIsNot(other, volume.mapper)
                self.assertIsNot(other.lookup_table, volume.mapper.lookup_table)
                self.assertEqual(other.scalar_range, volume.mapper.scalar_range)
                self.assertEqual(other.dataset.n_points, volume.mapper.dataset.n_points)
            with self.assertRaisesRegex(TypeError, "Pickle its mesh, mapper.dataset, and add it"):
                pickle.dumps(volume.mapper)
            if name == "clouds":
                continue  # PyVista's own actor
            for copied in (copy.copy, copy.deepcopy):
                other = copied(volume)
                self.assertIsNot(other.mapper, volume.mapper)
                np.testing.assert_array_equal(self.alone(name, other), self.alone(name, volume.copy()))
            with self.assertRaisesRegex(TypeError, "Pickle its mesh, volume.mapper.dataset"):
                pickle.dumps(volume)


if __name__ == "__main__":
    unittest.main()
