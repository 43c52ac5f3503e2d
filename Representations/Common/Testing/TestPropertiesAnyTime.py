# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Any property of Cell Compositing and of Textured Splats may be set at any time, in any order."""
import unittest

import nephoscope
import numpy as np
from nephoscope_testing import meshes
from nephoscope_testing.any_time import AnyTime
from nephoscope_testing.offscreen import Window
from nephoscope_testing.transfer import Transfer

SIZE = (48, 36)
TRANSFER = Transfer([(0, 0.1, 0.3, 1), (0.5, 1, 1, 1), (1, 1, 0.3, 0.1)], [(0, 0.1), (1, 1.5)])
M = nephoscope.vtkCellCompositingMapper
CELLS = {
    "Method": [M.RAY_METHOD, M.PROJECTION_METHOD, M.CELLS_METHOD, M.TRIANGLES_TABLE_METHOD, M.TRIANGLES_LINEAR_METHOD],
    "Integration": [M.EXACT_INTEGRATION, M.AVERAGE_INTEGRATION], "VisibilityOrder": [M.EXACT_ORDER, M.CENTROID_ORDER],
    "OpacityScale": [0.5, 1.0, 2.0], "OpacityArrayName": ["", "other"], "SplitAtControlPoints": [True, False],
    "ContourValue": [(0, 0.3), (1, 0.6), (0, 0.5)], "ContourOpacity": [(0, 0.8), (1, 0.3)],
    "ContourColor": [(0, 1.0, 0.2, 0.1)], "ContourLighting": [True, False], "SmoothContourNormals": [True, False],
    "LayersFromContours": [True, False],
}
S = nephoscope.vtkTexturedSplatMapper
SPLATS = {
    "Kernel": [S.CUBIC_KERNEL, S.QUADRATIC_KERNEL, S.GAUSSIAN_KERNEL], "RadiusFactor": [0.8, 1.5], "OpacityScale": [0.5, 2.0],
    "OpacityArrayName": ["", "other"], "VectorArrayName": ["", "wind"], "VectorStyle": [S.STREAKS, S.SEGMENTS],
    "VectorPlacement": [S.PLACEMENT_MIDDLE, S.PLACEMENT_LAYERS], "LayerAxis": [-1, 2], "VectorOpacity": [0.5, 2.0], "MaximumSpeed": [0.0, 3.0],
    "StreakWidth": [0.1, 0.4], "SegmentLength": [0.0, 2.0], "Phase": [0.0, 0.4], "PhaseSteps": [0, 16], "UseVectorColor": [True, False],
    "VectorColorArrayName": ["", "s"], "ErrorTolerance": [0.0, 0.05],
}


def data():
    image = meshes.with_field(meshes.image((6,) * 3, (1 / 3,) * 3, (-1,) * 3), lambda p: np.exp(-2 * (p ** 2).sum(axis=1)))
    x, y, z = meshes.points_of(image).T
    meshes.add_array(image.GetPointData(), 0.5 + 0.4 * np.sin(3 * x + y), "other")
    meshes.add_array(image.GetPointData(), np.column_stack([-y, x, 0.3 + 0 * z]), "wind")
    return image


class MapperCase(AnyTime):
    def setUp(self):
        self.data = data()

    def scene(self):
        window = Window(SIZE)
        scene = window.add_scene(background=(0.2, 0.3, 0.4))
        mapper = self.mapper()
        scene.add_volume(mapper, self.data, TRANSFER)
        scene.look_at(self.data)
        return window, mapper


class Cells(MapperCase, unittest.TestCase):
    expected = ("Triangles and faces are drawn without the contour surfaces", "No contour surface is seen")

    def mapper(self):
        mapper = M()
        mapper.SetNumberOfContourValues(2)
        return mapper

    def test_any_order(self):
        self.play_at_random(CELLS, seed=1, plays=2, steps=12)


class Splats(MapperCase, unittest.TestCase):
    mapper = S

    def test_any_order(self):
        self.play_at_random(SPLATS, seed=2, plays=3, steps=12)

    def test_old_names(self):
        mapper = S()
        mapper.SetGreatestSpeed(3)
        mapper.SetVectorShare(0.25)
        self.assertEqual((mapper.GetMaximumSpeed(), mapper.GetVectorFraction()), (3, 0.25))
        self.assertEqual((mapper.GetGreatestSpeed(), mapper.GetVectorShare()), (3, 0.25))
        self.assertEqual((S.IN_THE_MIDDLE, S.IN_LAYERS), (S.PLACEMENT_MIDDLE, S.PLACEMENT_LAYERS))


if __name__ == "__main__":
    unittest.main()
