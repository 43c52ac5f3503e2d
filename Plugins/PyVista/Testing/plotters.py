# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""A plotter for tests of the functions that add something to one."""
import unittest

import pyvista


class PlotterTestCase(unittest.TestCase):
    """Subclasses have add(...), which adds to self.plotter without drawing."""

    def setUp(self):
        self.plotter = pyvista.Plotter(off_screen=True)
        self.addCleanup(self.plotter.close)

    def fails(self, error, pattern, *args, **options):
        before = dict(self.plotter.actors)
        with self.assertRaisesRegex(error, pattern):
            self.add(*args, **options)
        self.assertEqual(dict(self.plotter.actors), before, "a failed call left an actor")
