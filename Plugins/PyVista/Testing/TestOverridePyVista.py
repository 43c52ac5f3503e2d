# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""PyVista's add_volume of unstructured grids draws Cell Compositing while override_vtk is on, whichever was imported first."""
import subprocess
import sys
import unittest

import nephoscope
import numpy as np
import pyvista

OURS = "vtkCellCompositingRayCastMapper"
LATER = """
import nephoscope
nephoscope.override_vtk()
import pyvista
mesh = pyvista.ImageData(dimensions=(3, 3, 3)).cast_to_unstructured_grid()
mesh["a"] = mesh.points[:, 0]
volume = pyvista.Plotter(off_screen=True).add_volume(mesh)
print(volume.mapper.GetClassName())
nephoscope.override_vtk(False)
print(pyvista.Plotter(off_screen=True).add_volume(mesh).mapper.GetClassName())
"""


def ball(cells=5):
    mesh = pyvista.ImageData(dimensions=(cells + 1,) * 3, origin=(-1,) * 3, spacing=(2 / cells,) * 3).cast_to_unstructured_grid()
    mesh["distance"] = np.linalg.norm(mesh.points, axis=1)
    return mesh


def on_cells(mesh):
    return mesh.point_data_to_cell_data()


class OverridePyVista(unittest.TestCase):
    def setUp(self):
        self.addCleanup(nephoscope.override_vtk, False)

    def draw(self, mesh, view="yz", **options):
        """The class that draws, and the picture."""
        plotter = pyvista.Plotter(off_screen=True, window_size=(60, 60))
        self.addCleanup(plotter.close)
        plotter.set_background("black")
        volume = plotter.add_volume(mesh, show_scalar_bar=False, **options)
        plotter.camera_position = view
        return volume.mapper.GetClassName(), plotter.screenshot(return_img=True)[..., :3].astype(int)

    def drawn_by_the_mapper(self, mesh, view):
        plotter = pyvista.Plotter(off_screen=True, window_size=(60, 60))
        self.addCleanup(plotter.close)
        plotter.set_background("black")
        volume = plotter.add_volume(mesh, show_scalar_bar=False)
        mapper = nephoscope.vtkCellCompositingMapper()
        mapper.SetInputData(volume.mapper.dataset)
        volume.SetMapper(mapper)
        plotter.camera_position = view
        return plotter.screenshot(return_img=True)[..., :3].astype(int)

    def test_volumes(self):
        for mesh, view in ((ball(), "yz"), (on_cells(ball()), "iso"), (ball(1), "yz"), (ball().clip("x", invert=False), "iso")):
            name, theirs = self.draw(mesh, view)
            self.assertEqual(name, "vtkUnstructuredGridVolumeRayCastMapper")
            nephoscope.override_vtk()
            name, ours = self.draw(mesh, view)
            self.assertEqual(name, OURS)
            nephoscope.override_vtk(False)
            np.testing.assert_array_equal(ours, self.drawn_by_the_mapper(mesh, view))
            self.assertLess(np.abs(ours - theirs).mean(), 5, "the same scene")
            self.assertGreater(ours.max(), 20)

    def test_settings_are_those_of_add_volume(self):
        nephoscope.override_vtk()
        pictures = [self.draw(ball(), **options)[1] for options in ({}, {"opacity": "sigmoid"}, {"cmap": "hot"}, {"opacity_unit_distance": 0.1})]
        for i, one in enumerate(pictures):
            for other in pictures[:i]:
                self.assertGreater(np.abs(one - other).max(), 20)

    def test_pyvista_imported_later(self):
        run = subprocess.run([sys.executable, "-c", LATER], capture_output=True, text=True)
        self.assertEqual(run.stdout.split(), [OURS, "vtkUnstructuredGridVolumeRayCastMapper"], run.stderr)


if __name__ == "__main__":
    unittest.main(verbosity=2)
