# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Segments cut at control points: hard transfer functions to less than a step of an 8-bit picture."""
import unittest

import numpy as np
from nephoscope_testing import contours, hard_functions, meshes
from nephoscope_testing.checks import cells_of, mapper
from nephoscope_testing.compare import Difference, edge_mask
from nephoscope_testing.control_points import errors
from nephoscope_testing.offscreen import Window, float_image

STEP = 1 / 255


class HardFunctions(unittest.TestCase):
    def test_all(self):
        for number, case in enumerate(hard_functions.cases()):
            with self.subTest(case.name):
                cut, uncut = errors(case, 100 + number, forgive=True)
                print(f"  {case.name}: cut {255 * cut.maximum:.3f}, not cut {255 * uncut.maximum:.1f}; 99.5 % {255 * cut.percentile:.4f}",
                      flush=True)
                self.assertLess(cut.maximum, STEP)
                self.assertGreater(cut.covered, 300)
                if not case.curved:
                    self.assertGreater(uncut.maximum, STEP, "cuts make no difference: the case is not hard")

    def test_a_spike_in_the_opacity_of_another_array(self):
        """Two arrays: the narrow function is that of the opacity, colours have points of their own."""
        rng = np.random.default_rng(61)
        case = hard_functions.spike(1e-6)
        data = meshes.delaunay(rng, 60)
        field = meshes.linear_field(rng, data)
        meshes.with_field(data, field)
        meshes.add_array(data.GetPointData(), field(meshes.points_of(data)), "o")
        window = Window((96, 96))
        scene = window.add_scene()
        ours = mapper()
        scene.look_at(scene.add_volume(ours, data, case.prop))
        ours.SetOpacityArrayName("o")
        window.render()
        cells, view = cells_of(data), scene.view()
        expected = contours.render(cells, view, case.pieces)
        difference = Difference(float_image(ours), expected, edge_mask(cells.drawn_edges(), view))
        print(f"  {difference}")
        self.assertLess(difference.maximum, STEP)
        self.assertGreater(expected[..., 3].max(), 0.3)


if __name__ == "__main__":
    unittest.main(verbosity=2)
