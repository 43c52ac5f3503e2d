# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Any property of the cloud texture may be set at any time, in any order: the picture is that of a mapper that had it from the start."""
import unittest

import nephoscope
import numpy as np
from cloud_bodies import box, sphere, together
from nephoscope_testing import meshes
from nephoscope_testing.any_time import AnyTime
from nephoscope_testing.offscreen import Window
from vtkmodules.vtkRenderingCore import vtkActor

SIZE = (64, 48)
VALUES = {
    "Coverage": [0.3, 0.7], "Softness": [0.0, 0.4], "TextureScale": [1.0, 4.0], "TextureLength": [0.0, 1.5], "OpticalDepth": [1.0, 8.0],
    "UseThickness": [True, False], "Extinction": [0.0, 2.0], "DensityArrayName": ["", "density"], "CoverageArrayName": ["", "cover"],
    "MaximumNumberOfLayers": [2, 6], "Relief": [0.0, 0.05], "UseThreshold": [True, False], "Threshold": [-0.5, 1.0], "Waves": [0, 1, 2, 3, 4],
    "NumberOfCustomWaves": [1, 3], "CustomWave": [(0, 1.0, 3, 1, 0, 0, 0, 0, 0, 0.2), (0, 2.0, 0, 4, 0, 1.0, 1, 0, 0, 0)], "UseAltitude": [True, False],
    "AltitudeRange": [(0.0, 0.0), (-1.0, 3.0)], "ThinColor": [(1.0, 1.0, 1.0), (1.0, 0.0, 0.0)], "ThickColor": [(1.0, 1.0, 1.0), (0.0, 0.0, 1.0)],
    "ColorRange": [0.5, 3.0], "ThicknessEffect": [0, 1], "ThicknessWeight": [0.0, 2.0],
}


def bodies():
    data = together(sphere(0.8, 24), box((0.3, -0.6, -0.5), (1.4, 0.6, 0.5)))
    points = meshes.points_of(data)
    meshes.add_array(data.GetPointData(), 1 + points[:, 0] ** 2, "density")
    meshes.add_array(data.GetPointData(), 0.5 + 0.3 * np.sin(3 * points[:, 1]), "cover")
    return data


class Properties(AnyTime, unittest.TestCase):
    def setUp(self):
        self.data = bodies()

    def scene(self):
        window = Window(SIZE)
        scene = window.add_scene(background=(0.1, 0.2, 0.4))
        mapper, actor = nephoscope.vtkCloudTextureMapper(), vtkActor()
        mapper.SetInputDataObject(self.data)
        mapper.ScalarVisibilityOff()
        actor.SetMapper(mapper)
        scene.renderer.AddActor(actor)
        scene.renderer.SetUseDepthPeeling(1)
        scene.look((1.5, 1, 5), near=1, far=20)
        return window, mapper

    def test_density_after_thickness(self):
        self.play([("UseThickness", True), ("DensityArrayName", "density"), ("DensityArrayName", ""), ("UseThickness", False),
                   ("DensityArrayName", "density"), ("UseThickness", True)])

    def test_arrays_after_relief(self):
        self.play([("Relief", 0.05), ("CoverageArrayName", "cover"), ("UseThickness", True), ("DensityArrayName", "density"),
                   ("Relief", 0.0), ("CoverageArrayName", ""), ("MaximumNumberOfLayers", 2)])

    def test_waves_and_colours(self):
        self.play([("Waves", 3), ("ThinColor", (1.0, 0.0, 0.0)), ("Waves", 4), ("CustomWave", (0, 2.0, 0, 4, 0, 1.0, 1, 0, 0, 0)), ("UseThreshold", True),
                   ("NumberOfCustomWaves", 1), ("Threshold", 1.0), ("UseThickness", True), ("ThicknessEffect", 1), ("ThicknessWeight", 2.0),
                   ("ThinColor", (1.0, 1.0, 1.0)), ("UseAltitude", True), ("AltitudeRange", (-1.0, 3.0)), ("Waves", 0)])

    def test_altitude(self):
        self.play([("UseAltitude", True), ("AltitudeRange", (-1.0, 3.0)), ("TextureScale", 4.0), ("UseAltitude", False)])

    def test_any_order(self):
        self.play_at_random(VALUES, seed=5, plays=3, steps=12)


if __name__ == "__main__":
    unittest.main()
