# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Transfer functions: the names mean what PyVista means by them, and few points lie close to the curve."""
import unittest

import numpy as np
import pyvista
from nephoscope import transfer


class Opacities(unittest.TestCase):
    def test_every_name_of_pyvista_within_its_8_bits(self):
        steps = np.linspace(0, 1, 256)
        for name in transfer.OPACITY_NAMES:
            try:
                theirs = pyvista.opacity_transfer_function(name, 256) / 255
            except ValueError:
                self.assertTrue(name.endswith("_r"), name)  # PyVista lacks some of the reversed ones
                continue
            ours = transfer.opacity_values(name)
            ours = np.interp(steps, np.linspace(0, 1, len(ours)), ours)
            np.testing.assert_allclose(ours, theirs, atol=1 / 255 + 1e-9, err_msg=name)

    def test_faint_values_are_kept(self):
        function = transfer.opacity_function(transfer.opacity_values([0, 1e-6, 0]), (0, 2), False)
        self.assertAlmostEqual(function.GetValue(1), 1e-6, delta=1e-12)

    def test_bytes_and_constants(self):
        np.testing.assert_array_equal(transfer.opacity_values(np.array([0, 255], np.uint8)), [0, 1])
        np.testing.assert_array_equal(transfer.opacity_values(0.25), [0.25, 0.25])

    def test_errors(self):
        with self.assertRaisesRegex(ValueError, "'sigmoid_3'"):
            transfer.opacity_values("sigmoidal")
        for bad in ([0, 2.0], [-0.1], [np.nan]):
            with self.assertRaisesRegex(ValueError, "outside 0 to 1"):
                transfer.opacity_values(bad)
        with self.assertRaisesRegex(ValueError, "shape"):
            transfer.opacity_values([[0, 1], [0, 1]])


class ControlPoints(unittest.TestCase):
    def test_a_straight_line_has_two(self):
        scalars, values = transfer.control_points(np.linspace(0, 1, 256), (-3, 5), False, 1e-6)
        np.testing.assert_allclose(scalars, [-3, 5])
        np.testing.assert_allclose(values[:, 0], [0, 1])

    def test_the_polyline_stays_within_the_tolerance(self):
        x = np.linspace(0, 1, 256)
        for log_scale in (False, True):
            curve = 1 / (1 + np.exp(-np.linspace(-10, 10, 256)))
            scalars, values = transfer.control_points(curve, (1e-3, 10), log_scale, 1e-3)
            at = transfer.scalars_at(x, (1e-3, 10), log_scale)
            self.assertLess(np.abs(np.interp(at, scalars, values[:, 0]) - curve).max(), 1.001e-3)
            self.assertLess(len(scalars), 80)

    def test_logarithmic_line_at_the_decades(self):
        function = transfer.opacity_function(np.array([0.0, 1.0]), (1e-4, 1.0), True)
        for scalar, opacity in ((1e-4, 0), (1e-3, 0.25), (1e-2, 0.5), (1e-1, 0.75), (1, 1)):
            self.assertAlmostEqual(function.GetValue(scalar), opacity, delta=1e-3)

    def test_white_has_two_points(self):
        table = pyvista.LookupTable(cmap=["white", "white"])
        self.assertEqual(transfer.colour_function(table).GetSize(), 2)


if __name__ == "__main__":
    unittest.main()
