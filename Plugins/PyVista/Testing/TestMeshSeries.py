# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""nephoscope.animate with PyVista meshes: a list, a dict or a function of time; their values, points and cells follow."""
import datetime
import subprocess
import sys
import tempfile
import unittest
import warnings
from pathlib import Path

import nephoscope
import numpy as np
import pyvista


def block(value, size=5, spacing=1.0):
    mesh = pyvista.ImageData(dimensions=(size,) * 3, spacing=(spacing,) * 3)
    mesh["T"] = np.full(mesh.n_points, float(value))
    mesh["c"] = np.linspace(0, 1, mesh.n_points)
    return mesh


class Meshes(unittest.TestCase):
    def setUp(self):
        self.plotter = pyvista.Plotter(off_screen=True, window_size=(80, 60))
        self.addCleanup(self.plotter.close)

    def picture(self, series, step):
        series.show(step)
        self.plotter.render()
        return self.plotter.screenshot(return_img=True).astype(int)

    def test_values_follow_and_no_mesh_is_changed(self):
        meshes, drawn = [block(k) for k in (1, 3, 2)], []
        series = nephoscope.animate(self.plotter, meshes, lambda plotter, mesh: drawn.append(nephoscope.add_cells(plotter, mesh, "T", show_scalar_bar=False)))
        self.assertEqual((len(drawn), len(series), series.times), (1, 3, ["0", "1", "2"]))
        self.assertEqual(drawn[0].mapper.scalar_range, (1, 3))  # of all
        for step in (1, 2, 0):
            series.show(step)
            self.assertEqual(set(drawn[0].mapper.dataset["T"]), {(1, 3, 2)[step]})
        self.assertEqual([mesh["T"][0] for mesh in meshes], [1, 3, 2])
        self.assertEqual(list(series.seconds), [0, 1, 2])

    def test_a_film_of_a_name(self):
        with tempfile.TemporaryDirectory() as folder:
            nephoscope.animate(self.plotter, [block(k) for k in (1, 3)], "T", filename=Path(folder, "film.gif"), progress=False, show_time=False)
            self.assertTrue(Path(folder, "film.gif").exists())

    def test_points_and_cells_follow(self):
        """Cells, points and arrays are those of the step, whatever draws them, and the steps can be shown in any order."""
        balls = {time: pyvista.Sphere(radius=size, theta_resolution=count).elevation(set_active=True) for time, size, count in ((0.0, 1, 10), (0.5, 0.5, 20), (2.0, 1, 10))}
        boxes = [block(1, 5), block(1, 9, 0.25), block(1, 5)]
        for meshes, draw in ((balls, lambda plotter, mesh: plotter.add_mesh(mesh, scalars="Elevation", show_scalar_bar=False)),
                             (boxes, lambda plotter, mesh: nephoscope.add_cells(plotter, mesh, "c", show_scalar_bar=False)),
                             ([box.cast_to_unstructured_grid() for box in boxes], lambda plotter, mesh: nephoscope.add_splats(plotter, mesh, "c", show_scalar_bar=False))):
            self.plotter.clear()
            series = nephoscope.animate(self.plotter, meshes, draw, show_time=False)
            self.plotter.clear_slider_widgets()
            self.plotter.view_xy()
            first, second, third = (self.picture(series, step) for step in (0, 1, 2))
            seen = [np.count_nonzero(np.abs(picture - picture[0, 0]).max(axis=2) > 3) for picture in (first, second, third)]
            self.assertLess(seen[1], 0.5 * seen[0])
            self.assertLess(np.abs(first - third).max(), 3)
            self.assertLess(np.abs(first - self.picture(series, 0)).max(), 3)
        self.assertEqual(list(nephoscope.animate(self.plotter, balls, lambda plotter, mesh: None).seconds), [0, 0.5, 2])

    def test_times(self):
        start, draw = datetime.datetime(2020, 1, 1), lambda plotter, mesh: None
        meshes = [block(1), block(2)]
        for times, told, seconds in (([0.5, 3], ["0.5", "3"], [0, 2.5]), ([start, start + datetime.timedelta(hours=1)], ["2020-01-01 00:00:00", "2020-01-01 01:00:00"], [0, 3600]),
                                     (np.array(["2020-01-01T00", "2020-01-01T06"], "M8[h]"), ["2020-01-01T00", "2020-01-01T06"], [0, 21600]), (["then", "now"], ["then", "now"], [0, 1])):
            series = nephoscope.animate(self.plotter, meshes, draw, times=times)
            self.assertEqual((series.times, list(series.seconds)), (told, seconds))
        asked = []
        self.plotter.camera_position = "xy"  # else the bounds of all steps are asked for
        series = nephoscope.animate(self.plotter, lambda time: asked.append(time) or block(time), draw, times=[2.0, 4.0])
        series.show(1)
        self.assertEqual(set(series.mesh["T"]), {4})
        self.assertEqual(asked, [2.0, 4.0])

    def test_what_is_accepted_is_told(self):
        draw = lambda plotter, mesh: None
        one = block(1)
        for error, words, dataset, options in ((TypeError, "single ImageData.*list of PyVista datasets", one, {}), (TypeError, r"pass list\(dataset\)", pyvista.MultiBlock([one, one]), {}),
                                               (TypeError, "of one type.*cast_to_unstructured_grid", [one, one.cast_to_unstructured_grid()], {}),
                                               (TypeError, "a str; each.*path of a file", [one, "x"], {}), (FileNotFoundError, "No such file: gone.vtu", [one, "gone.vtu"], {}), (FileNotFoundError, r"gone_\*.vtu", "gone_*.vtu", {}), (TypeError, "heights", [one], {"heights": True}),
                                               (TypeError, "projection", [one], {"projection": "map"}), (TypeError, "pass times=", lambda time: one, {}),
                                               (TypeError, "whose keys", {0: one}, {"times": [0]}), (ValueError, "1 meshes and 2 times", [one], {"times": [0, 1]})):
            with self.subTest(words), self.assertRaisesRegex(error, words):
                nephoscope.animate(self.plotter, dataset, draw, **options)

    def test_files(self):
        """A list, a dict, a pattern, and a file that has times; each is read when it is shown."""
        with tempfile.TemporaryDirectory() as folder:
            names = [str(Path(folder, f"case_{k}.vti")) for k in (1, 2, 3)]
            for k, name in zip((1, 3, 2), names):
                block(k).save(name)
            collection = Path(folder, "case.pvd")
            collection.write_text('<VTKFile type="Collection"><Collection>' + "".join(f'<DataSet timestep="{time}" part="0" file="{Path(name).name}"/>' for time, name in zip((0.5, 1, 4), names)) +
                                  "</Collection></VTKFile>")
            single = str(Path(folder, "case_1.vti"))
            with self.assertRaisesRegex(TypeError, r"single file .* has one time; pass a list of files"):
                nephoscope.animate(self.plotter, single, "T")
            cut = Path(folder, "cut.vti")
            cut.write_bytes(Path(single).read_bytes()[:300])
            with self.assertRaisesRegex(OSError, "The file '.*cut.vti' cannot be read: Error parsing XML"):
                nephoscope.animate(self.plotter, str(cut), "T")
            with self.assertRaisesRegex(TypeError, "has its own times"):
                nephoscope.animate(self.plotter, collection, "T", times=[1, 2, 3])
            for dataset, options, told in ((names, {}, ["0", "1", "2"]), ([Path(name) for name in names], {"times": [1, 2, 3]}, ["1", "2", "3"]), (dict(zip((2, 3, 4), names)), {}, ["2", "3", "4"]),
                                           (str(Path(folder, "case_*.vti")), {}, ["0", "1", "2"]), ([block(1), names[1], block(2)], {}, ["0", "1", "2"]), (str(collection), {}, ["0.5", "1", "4"])):
                self.plotter.clear()
                drawn = []
                series = nephoscope.animate(self.plotter, dataset, lambda plotter, mesh: drawn.append(nephoscope.add_cells(plotter, mesh, "T", show_scalar_bar=False)), **options)
                self.assertEqual((series.times, drawn[0].mapper.scalar_range), (told, (1, 3)))
                self.assertEqual([set(mesh["T"]) for mesh in series], [{1}, {3}, {2}])

    def test_blocks(self):
        """The blocks of a step are one mesh, without patches of the boundary, which are named once."""
        steps = [pyvista.MultiBlock({"fluid": block(k), "more": pyvista.MultiBlock([block(k + 5).translate((4, 0, 0))]), "wall": pyvista.Plane()}) for k in (1, 2)]
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter("always")
            series = nephoscope.animate(self.plotter, steps, "T", show_time=False)
            pictures = [self.picture(series, step) for step in (0, 1)]
        self.assertEqual([str(one.message) for one in told if "wall" in str(one.message)], ["Blocks that are not drawn, because others have cells of a higher dimension: 'wall'."])
        self.assertEqual((series.mesh.n_cells, series.bounds, series.range("T")), (128, (0, 8, 0, 4, 0, 4), (1, 7)))
        self.assertGreater(np.abs(pictures[0] - pictures[1]).max(), 10)
        alone = pyvista.Plotter(off_screen=True, window_size=(80, 60))
        self.addCleanup(alone.close)
        nephoscope.add_cells(alone, steps[1], "T", clim=(1, 7))
        single = alone.screenshot(return_img=True).astype(int)
        self.assertLess(np.mean(np.abs(single - pictures[1]).max(axis=2) > 40), 0.25)  # the slider is on one of them
        with self.assertRaisesRegex(TypeError, r"pass list\(dataset\)"):
            nephoscope.animate(self.plotter, steps[0], "T")
        called = nephoscope.animate(self.plotter, lambda time: steps[int(time)], "T", times=[0, 1])
        self.assertEqual(called.mesh.n_cells, 128)

    def test_without_xarray(self):
        code = ("import sys; sys.modules['xarray'] = None\nimport nephoscope, pyvista\nmesh = pyvista.ImageData(dimensions=(4, 4, 4)); mesh['T'] = mesh.points[:, 0]\n"
                "print(len(nephoscope.animate(pyvista.Plotter(off_screen=True), [mesh, mesh], 'T')))")
        self.assertEqual(subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout, "2\n")


if __name__ == "__main__":
    unittest.main()
