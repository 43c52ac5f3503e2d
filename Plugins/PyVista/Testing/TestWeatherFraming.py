# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""First pictures of domains of all sizes: with nothing set, the data are within the picture and fill it."""
import tempfile
import unittest
from pathlib import Path

import nephoscope
import numpy as np
import pyvista
import xarray

SIZE = 400
LEFT_OF_THE_BAR = 0.89


def flat(x, y, z):
    axes = {name: (name, np.linspace(0, size, 9), {"units": "m"}) for name, size in (("x", x), ("y", y), ("z", z)) if size}
    shape = {name: 9 for name in "zyx" if name in axes}
    return xarray.Dataset({"qc": (tuple(shape), np.random.default_rng(1).random(tuple(shape.values())), {"units": "kg/m3"})}, axes)


def region(longitudes, latitudes, bottom, top):
    heights = np.broadcast_to(np.linspace(bottom, top, 6)[:, None, None], (6, 19, 19))
    return xarray.Dataset({"tracer": (("level", "lat", "lon"), np.random.default_rng(1).random((6, 19, 19)), {"units": "1"}),
                           "height": (("level", "lat", "lon"), heights, {"units": "m", "standard_name": "altitude"})},
                          {"lon": ("lon", np.linspace(*longitudes, 19), {"units": "degrees_east"}), "lat": ("lat", np.linspace(*latitudes, 19), {"units": "degrees_north"}),
                           "level": ("level", np.arange(6.0))})


FLAT = {"box of 1 km": ((1e3, 1e3, 1e3), 1), "deep box": ((6.4e3, 6.4e3, 3e3), 1), "thin layer": ((2e4, 2e4, 500), 10), "channel of 1000 km": ((1e6, 1e6, 1.5e4), 15), "section": ((1e6, 0, 1.5e4), 30),
        "section across": ((0, 1e5, 1e4), 5), "high section": ((1e3, 0, 1e3), 1)}
GLOBE = {"hills": (((10, 10.27), (47, 47.18), 0, 2e3), 3), "tower": (((10, 10.13), (47, 47.09), 0, 1.5e4), 1), "valley": (((10, 11.3), (47, 47.9), 0, 1.5e4), 2), "country": (((8, 14), (45, 50), 0, 2e4), 10),
         "continent": (((-15, 25), (35, 65), 0, 2e4), 30), "near the pole": (((0, 60), (80, 88), 0, 2e4), 15), "across the date line": (((175, 185), (-5, 5), 0, 2e4), 20),
         "upper air of a continent": (((-15, 25), (35, 65), 1e5, 1e6), 1), "ionosphere": (((0, 340), (-90, 90), 1e5, 5e5), 5), "thermosphere": (((0, 340), (-90, 90), 1e5, 1e6), 2), "troposphere": (((0, 340), (-90, 90), 0, 2e4), 30)}


def places(plotter, points):
    """Where the points are in the picture, as shares of its width and height."""
    points = np.column_stack((points, np.ones(len(points))))
    matrix = pyvista.array_from_vtkmatrix(plotter.camera.GetCompositeProjectionTransformMatrix(plotter.window_size[0] / plotter.window_size[1], -1, 1))
    seen = points @ matrix.T
    return 0.5 + 0.5 * seen[:, :2] / seen[:, 3:]


class Framing(unittest.TestCase):
    def plotted(self, dataset, **options):
        with tempfile.TemporaryDirectory() as folder:
            plotter = dataset.nephoscope.plot(screenshot=str(Path(folder, "picture.png")), window_size=(SIZE, SIZE), **options)
        self.addCleanup(plotter.close)
        return plotter, dataset.nephoscope.mesh(**{name: value for name, value in options.items() if name == "projection"}, vertical_exaggeration=self.factor_of(plotter))

    @staticmethod
    def factor_of(plotter):
        meshes = [actor.mapper.dataset for actor in plotter.renderer.actors.values() if hasattr(actor, "mapper") and hasattr(actor.mapper, "dataset")]
        drawn = next(mesh for mesh in meshes if {"qc", "tracer"} & set(mesh.array_names))
        return float(np.ravel(drawn.field_data.get("VerticalExaggeration", [1]))[0])

    def test_levels_of_regions_of_all_sizes_are_seen(self):
        """VTK cuts what is nearer than a thousandth of the distance to the far side of the Earth."""
        for name in ("tower", "hills", "valley", "country", "continent"):
            with self.subTest(name), tempfile.TemporaryDirectory() as folder:
                path = Path(folder, "picture.png")
                self.addCleanup(region(*GLOBE[name][0]).isel(level=0).nephoscope.plot(cmap=["red", "red"], screenshot=str(path), window_size=(100, 100)).close)
                picture = pyvista.read(path)["PNGImage"].reshape(100, 100, -1)[35:65, 12:42, :3].astype(float)
                red = (picture[..., 0] > 200) & (picture[..., 1] < 50)
                self.assertGreater(red.mean(), 0.5)  # but for coasts

    def check_filled(self, plotter, mesh, share):
        low, high = (limit(places(plotter, np.asarray(mesh.points)), axis=0) for limit in (np.min, np.max))
        self.assertTrue((low > 0).all() and (high < (LEFT_OF_THE_BAR, 1)).all(), (low, high))
        self.assertGreater(np.prod(high - low), share)
        return low, high

    def test_flat(self):
        for name, (sizes, factor) in FLAT.items():
            with self.subTest(name):
                plotter, mesh = self.plotted(flat(*sizes))
                self.assertEqual(self.factor_of(plotter), factor)
                self.check_filled(plotter, mesh, 0.18)
                self.assertEqual("vertical_exaggeration" in plotter.renderer.actors, factor != 1)

    def test_globe(self):
        for name, (limits, factor) in GLOBE.items():
            with self.subTest(name):
                plotter, mesh = self.plotted(region(*limits))
                self.assertEqual(self.factor_of(plotter), factor)
                low, high = self.check_filled(plotter, mesh, 1 / 3)
                self.assertGreater((high - low).max(), 0.72)

    def test_maps(self):
        for name, factor in (("hills", 5), ("thermosphere", 2), ("continent", 30)):  # a degree of longitude is as long as one of latitude
            limits, _ = GLOBE[name]
            self.assertEqual(self.factor_of(self.plotted(region(*limits), projection="map")[0]), factor)

    def test_what_is_given_stays(self):
        for dataset, factor in ((flat(1e6, 1e6, 1.5e4), 1), (region(*GLOBE["hills"][0]), 30)):
            self.assertEqual(self.factor_of(self.plotted(dataset, vertical_exaggeration=factor)[0]), factor)

    def test_films(self):
        for dataset, factor in ((flat(2e4, 2e4, 500), 10), (region(*GLOBE["hills"][0]), 3)):
            plotter = pyvista.Plotter(off_screen=True, window_size=(SIZE, SIZE))
            self.addCleanup(plotter.close)
            series = nephoscope.animate(plotter, dataset.expand_dims(time=2), list(dataset)[0])
            self.assertEqual(float(series.mesh.field_data["VerticalExaggeration"][0]), factor)

    def test_sheets(self):
        """One level has no height, whatever the exaggeration."""
        dataset = region(*GLOBE["hills"][0]).isel(level=0)
        self.check_filled(*self.plotted(dataset), 1 / 3)

    def test_regions_in_a_plotter(self):
        """Regions added by add_cells and add_splats are seen from above, with north up, whatever is added before or after; a camera that is set stays, and so does PyVista's for a whole globe."""
        mesh = region(*GLOBE["country"][0]).nephoscope.globe(vertical_exaggeration=10)
        whole = region(*GLOBE["troposphere"][0]).nephoscope.globe()
        mine = [(3e7, 1e6, 2e6), (0, 0, 0), (0, 0, 1)]
        for add in (nephoscope.add_cells, nephoscope.add_splats):
            with self.subTest(add.__name__):
                seen = []
                for before, data, after in ((None, mesh, None), (nephoscope.globe_surface(), mesh, None), (None, mesh, nephoscope.globe_surface()), (None, whole, None), (mine, mesh, None)):
                    plotter = pyvista.Plotter(off_screen=True, window_size=(SIZE, SIZE))
                    self.addCleanup(plotter.close)
                    if isinstance(before, list):
                        plotter.camera_position = before
                    elif before is not None:
                        plotter.add_mesh(before)
                    add(plotter, data)
                    if after is not None:
                        plotter.add_mesh(after)
                    plotter.show(auto_close=False)
                    seen.append(np.array([*plotter.camera_position]))
                np.testing.assert_allclose(seen[1:3], [seen[0]] * 2, rtol=1e-6)
                position, focus, _ = seen[0]
                towards = mesh.points.mean(axis=0) / np.linalg.norm(mesh.points.mean(axis=0))
                self.assertGreater((position - focus) @ towards, 0.999 * np.linalg.norm(position - focus))
                self.assertGreater(np.linalg.norm(position), 6.4e6)
                np.testing.assert_allclose(seen[4], mine, rtol=1e-6)
                np.testing.assert_allclose(np.diff(np.abs(seen[3][0] - seen[3][1])), 0, atol=1e3)  # from (1, 1, 1)
                plotter = pyvista.Plotter(off_screen=True, window_size=(SIZE, SIZE))
                self.addCleanup(plotter.close)
                add(plotter, mesh)
                plotter.show(auto_close=False)
                self.check_filled(plotter, mesh, 1 / 3)
                low, high = places(plotter, mesh.points[mesh["Height"] < 1][[0, -1]])
                self.assertTrue((low < high).all())  # from the south-west to the north-east


if __name__ == "__main__":
    unittest.main()
