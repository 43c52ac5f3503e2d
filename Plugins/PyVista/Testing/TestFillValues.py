# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Values that look like fill values are told once, with array, share and remedies that work; other values are not."""
import itertools
import os
import re
import tempfile
import unittest
import warnings
from pathlib import Path

import nephoscope
import numpy as np
import pyvista
import xarray

OUTPUT = Path(os.environ["NEPHOSCOPE_TEST_OUTPUT"])
ADDERS = (nephoscope.add_cells, nephoscope.add_splats)


def grid(share=0.0, *fills, kind="f4"):
    mesh = pyvista.ImageData(dimensions=(20, 20, 20))
    values = (280 + 10 * np.sin(mesh.points[:, 0] / 8)).astype(kind)
    places = np.random.default_rng(0).permutation(len(values))[:int(share * len(values))]
    for k, fill in enumerate(fills):
        values[places[k::len(fills)]] = fill
    mesh["T"] = values
    return mesh


class FillValues(unittest.TestCase):
    def told(self, add, mesh, scalars="T", **options):
        """The warnings, and the range of the colours."""
        plotter = pyvista.Plotter(off_screen=True, window_size=(40, 40))
        self.addCleanup(plotter.close)
        with warnings.catch_warnings(record=True) as found:
            warnings.simplefilter("always")
            self.volume = add(plotter, mesh, scalars, **options)
        return [str(one.message) for one in found if "fill value" in str(one.message)], self.volume.mapper.scalar_range

    def test_usual_ones(self):
        for add in ADDERS:
            for share, fills, percent in ((0.02, (1e20,), "2 %"), (0.01, (9999,), "1 %"), (0.3, (-999,), "30 %"), (0.1, (9.96921e36,), "10 %"), (0.02, (9999, -9999), "2 %"), (0.04, (1e20, -9999), "4 %"),
                                          (0.6, (-32768,), "60 %")):
                with self.subTest(add=add.__name__, fills=fills):
                    (text,), _ = self.told(add, grid(share, *fills))
                    self.assertIn(f"'T' has {' and '.join(f'{fill:.6g}' for fill in fills)} as values in {percent} of the data", text)
                    self.assertIn("far from all others, which are 280 to 289.985", text)

    def test_remedies(self):
        """What the message says can be pasted, and there is nothing more to tell."""
        for fills in ((9999,), (1e20, -9999)):
            mesh = grid(0.05, *fills)
            (text,), _ = self.told(nephoscope.add_cells, mesh)
            scalars, limits = re.search(r"Mask them: scalars=(.*); or pass clim=(\(.*\))\.$", text).groups()
            told, found = self.told(nephoscope.add_cells, mesh, eval(scalars, {"numpy": np, "mesh": mesh}))
            self.assertEqual(told, [])
            expected = tuple(limit(mesh["T"][(mesh["T"] > 0) & (mesh["T"] < 1000)]) for limit in (np.min, np.max))
            np.testing.assert_allclose(found, expected)
            told, found = self.told(nephoscope.add_cells, mesh, clim=eval(limits))
            self.assertEqual(told, [])
            np.testing.assert_allclose(found, expected, rtol=1e-5)

    def test_huge_values_that_differ(self):
        """As of fill values that were interpolated."""
        mesh = grid()
        mesh["T"][:200] = np.linspace(2e18, 1e20, 200)
        (text,), _ = self.told(nephoscope.add_cells, mesh)
        self.assertRegex(text, r"up to 1e\+20 as values in 2.5 %.*numpy.ma.masked_outside\(mesh\['T'\], 280")

    def test_one_value(self):
        for fill, count in ((7.7e6, 0), (1e20, 1)):  # one wild value is the user's
            mesh = grid()
            mesh["T"][5] = fill
            self.assertEqual(len(self.told(nephoscope.add_cells, mesh)[0]), count)

    def test_others_are_not_told(self):
        points = grid().points
        heavy = np.random.default_rng(0).lognormal(0, 4, len(points))
        for values in (heavy, 1e-12 * heavy, np.where(points[:, 0] > 5, 1.0, 0.0), np.exp(-((points - 9) ** 2).sum(axis=1)), (points[:, 0] > 3).astype(int) * 9999, np.arange(len(points)), 1e18 * (1 + points[:, 1]),
                       np.where(points[:, 0] > 5, 0, 280 + points[:, 1]), points[:, 0] > 3, np.full(len(points), 9999.0), (points[:, 2] + 990) * 1.0):
            self.assertEqual(self.told(nephoscope.add_cells, grid(), values)[0], [])

    def test_opacities_and_vectors(self):
        mesh = grid(0.02, 9999)
        mesh["x"] = mesh.points[:, 0]
        (text,), _ = self.told(nephoscope.add_cells, mesh, "x", opacity_scalars="T")
        self.assertIn("pass opacity_clim=(", text)
        mesh["wind"] = np.column_stack((mesh["T"], mesh["x"], mesh["x"]))
        (text,), _ = self.told(nephoscope.add_cells, mesh, "wind", component=0)
        self.assertIn("'wind' has 9999", text)

    def test_weather(self):
        """A level and a volume; the remedy is in words of xarray."""
        axes = {"lon": ("lon", np.arange(0, 40, 2.0), {"units": "degrees_east"}), "lat": ("lat", np.arange(0, 40, 2.0), {"units": "degrees_north"}), "plev": ("plev", [1000.0, 800, 600, 400], {"units": "hPa"})}
        values = np.random.default_rng(0).random((4, 20, 20))
        values[:, 3, :8] = 9999
        for data in (xarray.Dataset({"q": (("plev", "lat", "lon"), values)}, axes), xarray.Dataset({"q": (("lat", "lon"), values[0])}, {name: axes[name] for name in ("lon", "lat")})):
            with tempfile.TemporaryDirectory() as folder, warnings.catch_warnings(record=True) as found:
                warnings.simplefilter("always")
                data.nephoscope.plot("q", screenshot=str(Path(folder, "a.png")), window_size=(60, 60)).close()
            told = [str(one.message) for one in found if "fill value" in str(one.message)]
            self.assertEqual(len(told), 1, told)
            remedy = re.search("Mask them: (.*); or", told[0])[1]
            self.assertLess(float(eval(remedy, {"dataset": data}).max()), 1.001)

    def test_declared_ones_are_masked(self):
        """On flat grids as on globes, before values on faces are averaged, in every type and unit."""
        axes = {"z": (3, "m"), "y": (8, "m"), "x": (8, "m"), "xh": (9, "m"), "lat": (8, "degrees_north"), "lon": (8, "degrees_east")}
        coords = {dim: (dim, 5.0 * np.arange(size) - 2.5 * (dim == "xh"), {"units": unit}) for dim, (size, unit) in axes.items()}
        kinds = (("f4", "m", 7777, {"_FillValue": 7777.0}), ("f8", "m", -777, {"missing_value": [-777, 0.1]}), ("i2", "m", 77, {"missing_value": 77}), ("i2", "oktas", 9, {"_FillValue": 9}))
        for dims, (kind, unit, fill, declared) in itertools.product((("z", "lat", "lon"), ("z", "y", "x"), ("z", "y", "xh"), ("y", "x")), kinds):
            values = np.full([axes[dim][0] for dim in dims], 2, kind)
            values[..., 3, 3] = fill
            data = xarray.Dataset({"q": (dims, values, {"units": unit, **declared})}, {dim: coords[dim] for dim in dims})
            if "xh" in dims:
                data = data.assign_coords(x=coords["x"]).assign({name: (("z", "y", "x"), np.ones((3, 8, 8))) for name in ("a", "b")})
            with self.subTest(dims=dims, kind=kind, unit=unit), warnings.catch_warnings():
                warnings.simplefilter("error")
                found = np.asarray(data.nephoscope.mesh()["q"], float)
                self.assertEqual(np.isnan(found).sum(), (2 if "xh" in dims else 1) * (3 if "z" in dims else 1))
                np.testing.assert_allclose(found[np.isfinite(found)], 0.25 if unit == "oktas" else 2)
                if dims == ("z", "y", "x"):
                    data.nephoscope.plot("q", screenshot=str(OUTPUT / "declared_fill_values.png"), window_size=(60, 60))


if __name__ == "__main__":
    unittest.main()
