# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Datasets of xarray whose x, y and z are lengths: their meshes, what is assumed, pictures, and the functions that take them in place of a mesh."""
import itertools
import tempfile
import unittest
import warnings
from pathlib import Path

import nephoscope
import numpy as np
import pyvista
import xarray as xr
from nephoscope.weather.flat import is_flat
from nephoscope.weather.scales import ticks
from nephoscope.weather.horizontal import GridError
from weather_data import isothermal

X, Y, Z = np.arange(0, 1200, 100.0), np.arange(-400, 400, 100.0), np.arange(25, 500, 50.0)


def field(z=Z, y=Y, x=X):
    """A cloud in the middle, and a value by which each point is known."""
    up, north, east = np.meshgrid(z, y, x, indexing="ij")
    return np.clip(1 - ((east - 500) ** 2 + north**2 + (up - 250) ** 2) / 3e5, 0, None), east + 1e4 * north + 1e8 * up


def simulation(units="m", factor=1.0, order="zyx", **more):
    values, places = field()
    axes = {"x": X, "y": Y, "z": Z}
    coords = {name: (name, axis / factor, {"units": units} if units else {}) for name, axis in axes.items()}
    dataset = xr.Dataset({"ql": (("z", "y", "x"), 1e-3 * values, {"units": "kg/kg"}), "place": (("z", "y", "x"), places)}, coords=coords)
    return dataset.transpose(..., *order).assign(more)


class FlatDatasets(unittest.TestCase):
    def check_places(self, mesh, stretch=1.0):
        """Every value is where the dataset has it."""
        x, y, z = (mesh.points / (1, 1, stretch)).T
        np.testing.assert_allclose(mesh["place"], x + 1e4 * y + 1e8 * z, rtol=1e-6)

    def plotter(self):
        plotter = pyvista.Plotter(off_screen=True, window_size=(80, 80))
        self.addCleanup(plotter.close)
        return plotter

    def warm(self):
        """A temperature that is known at each height, below a mountain at the second time missing."""
        warmth = np.broadcast_to((290 + 0.02 * Z)[:, None, None], (len(Z), len(Y), len(X))) + np.array([0, 5])[:, None, None, None]
        warmth[1, :3, :, -4:] = np.nan
        return simulation(ta=(("time", "z", "y", "x"), warmth, {"units": "K", "standard_name": "air_temperature"})).assign_coords(time=[0.0, 60.0])

    def test_temperatures_are_on_the_faces(self):
        for options, faces in (({}, True), ({"opacity": "linear"}, False), ({"contours": [295]}, False)):
            with self.subTest(**options):
                plotter = self.plotter()
                self.warm().isel(time=0).nephoscope.plot("ta", plotter=plotter, **options)
                meshes = [getattr(getattr(actor, "mapper", None), "dataset", None) for actor in plotter.renderer.actors.values()]
                drawn = [mesh for mesh in meshes if "ta" in getattr(mesh, "array_names", ())]
                self.assertEqual([isinstance(mesh, pyvista.PolyData) for mesh in drawn], [faces])
                self.assertEqual("outer faces" in next(iter(plotter.scalar_bars.values())).GetTitle(), faces)
                if faces:
                    np.testing.assert_allclose(drawn[0]["ta"], 290 + 0.02 * drawn[0].points[:, 2], rtol=1e-6)
                    np.testing.assert_allclose(drawn[0].volume, np.ptp(X) * np.ptp(Y) * np.ptp(Z), rtol=1e-6)  # closed, and seen from outside
                    actor = next(actor for actor in plotter.renderer.actors.values() if getattr(getattr(actor, "mapper", None), "dataset", None) is drawn[0])
                    plotter.render()
                    self.assertFalse(actor.HasTranslucentPolygonalGeometry(), "the faces behind are seen through those in front")

    def test_temperatures_on_the_faces_in_time(self):
        """The range is that of all times; where a time has no values, it has no faces."""
        plotter = self.plotter()
        with tempfile.TemporaryDirectory() as folder:
            series = nephoscope.animate(plotter, self.warm(), "ta", filename=folder, progress=False)
        self.addCleanup(series.close)
        np.testing.assert_allclose(series.range("ta"), (290 + 0.02 * Z[0], 295 + 0.02 * Z[-1]))
        whole = np.ptp(X) * np.ptp(Y) * np.ptp(Z)
        for step, volume in ((0, whole), (1, whole - 4 * 100.0 * np.ptp(Y) * 150.0), (0, whole)):
            series.show(step)
            np.testing.assert_allclose(series.mesh.volume, volume, rtol=1e-6)
            np.testing.assert_allclose(series.mesh["ta"], 290 + 5 * step + 0.02 * series.mesh.points[:, 2], rtol=1e-6)

    def test_any_order_and_unit_of_length(self):
        for order in map("".join, itertools.permutations("xyz")):
            for units, factor in (("m", 1), ("km", 1000), ("metres", 1), ("kilometers", 1000)):
                with self.subTest(order=order, units=units):
                    mesh = simulation(units, factor, order).nephoscope.grid()
                    self.assertIsInstance(mesh, pyvista.ImageData)
                    self.assertEqual(mesh.dimensions, (len(X), len(Y), len(Z)))
                    np.testing.assert_allclose(mesh.spacing, (100, 100, 50))
                    self.check_places(mesh)
                    self.assertEqual(mesh.active_scalars_name, "ql")

    def test_descending_and_uneven_axes(self):
        mesh = simulation().isel(y=slice(None, None, -1), z=slice(None, None, -1)).nephoscope.grid()
        self.assertIsInstance(mesh, pyvista.ImageData)
        self.check_places(mesh)
        mesh = simulation().isel(z=[0, 1, 2, 4, 8]).nephoscope.grid(vertical_exaggeration=3)
        self.assertIsInstance(mesh, pyvista.RectilinearGrid)
        self.check_places(mesh, 3)

    def test_single_precision_of_distant_axes_is_even(self):
        dataset = simulation()
        dataset = dataset.assign_coords(x=("x", (X / 1000 + 4321.7).astype(np.float32), {"units": "km"}))
        self.assertIsInstance(dataset.nephoscope.grid(), pyvista.ImageData)

    def test_depths_are_below(self):
        dataset = simulation()
        dataset["z"].attrs["positive"] = "down"
        np.testing.assert_allclose(dataset.nephoscope.grid().bounds[4:], (-Z[-1], -Z[0]))

    def test_without_units_or_coordinates(self):
        dataset = simulation(units="")
        self.check_places(dataset.nephoscope.grid())
        self.assertIn("note: 'x' has no units: its values are taken as metres", dataset.nephoscope.describe())
        bare = dataset.drop_vars([*"xyz"])
        np.testing.assert_allclose(bare.nephoscope.grid().bounds, (0, len(X) - 1, 0, len(Y) - 1, 0, len(Z) - 1))
        self.assertIn("note: 'y' has no coordinate: its points are 1 m apart", bare.nephoscope.describe())

    def test_possible_degrees_are_told(self):
        with self.assertWarnsRegex(UserWarning, "'x' and 'y' have no units: .*'degrees_east'"):
            simulation(units="", factor=10).nephoscope.grid()

    def test_coordinates_of_other_names(self):
        """Those of models: dimensions without a coordinate of their own, centres and faces."""
        dataset = simulation().rename(x="xt", y="yt", z="zt")
        self.check_places(dataset.nephoscope.grid())
        dataset = simulation().rename(x="ni", y="nj", z="nk").reset_index(["ni", "nj", "nk"]).reset_coords(drop=True)
        dataset = dataset.assign_coords(xh=("ni", X / 1000, {"units": "km"}), yh=("nj", Y / 1000, {"units": "km"}), zh=("nk", Z / 1000, {"units": "km"}))
        self.check_places(dataset.nephoscope.grid())

    def test_heights_of_other_names(self):
        for name in ("alt", "msl", "agl", "levels_of_radar"):
            with self.subTest(name):
                self.check_places(simulation().rename(z=name).nephoscope.grid())
        with self.assertRaisesRegex(GridError, "'diameter', whose coordinate is 'diameter' .m., which is not known to be a length along x, y or z"):
            simulation().rename(z="diameter").nephoscope.grid()

    def test_named_axes(self):
        dataset = simulation().drop_vars([*"xyz"]).rename(x="a", y="b", z="c").assign_coords(width=("a", X, {"units": "m"}))
        for call in (dataset.nephoscope.plot, lambda: nephoscope.add_cells(self.plotter(), dataset.ql), dataset.nephoscope.grid):
            with self.assertRaisesRegex(ValueError, r"grid\(x='...', y='...', z='...'\)"):
                call()
        mesh = dataset.nephoscope.grid(x="width", y="b", z="c")
        np.testing.assert_allclose(mesh.bounds, (0, 1100, 0, len(Y) - 1, 0, len(Z) - 1))
        with self.assertRaisesRegex(ValueError, "x: 'd' is neither"):
            dataset.nephoscope.grid(x="d")

    def test_winds_on_faces(self):
        faces = np.append(X - 50, X[-1] + 50)
        u = xr.DataArray(np.broadcast_to(faces, (len(Z), len(Y), len(faces))), dims=("z", "y", "xh"), coords={"xh": ("xh", faces, {"units": "m"})}, attrs={"units": "m/s"})
        v = xr.DataArray(np.full((len(Z), len(Y), len(X)), 2.0), dims=("z", "y", "x"), attrs={"units": "m s-1"})
        dataset = simulation(u=u, v=v, w=3 * v)
        mesh = dataset.nephoscope.grid(vertical_exaggeration=2)
        np.testing.assert_allclose(mesh["Wind"], np.column_stack([mesh.points[:, 0], 0 * mesh.points[:, 0] + 2, 0 * mesh.points[:, 0] + 6]), atol=1e-3)
        np.testing.assert_allclose(mesh["DisplayVelocity"], mesh["Wind"] * (1, 1, 2))
        self.assertIn("wind: 'u', 'v', 'w'", dataset.nephoscope.describe())
        nephoscope.add_splats(self.plotter(), dataset, "ql", vectors="Wind")

    def test_times(self):
        series = xr.concat([simulation(), simulation() * 2], "time").assign_coords(time=[0.0, 60.0])
        with self.assertWarnsRegex(UserWarning, "2 times"):
            series.nephoscope.grid()
        np.testing.assert_allclose(series.nephoscope.grid(time=1)["ql"], 2 * simulation().nephoscope.grid()["ql"])
        plotter = self.plotter()
        film = nephoscope.animate(plotter, series, "ql")
        self.assertEqual(film.range("ql"), (0, np.float32(2e-3 * field()[0].max())))
        film.close()

    def test_sheets_and_sections(self):
        dataset = simulation()
        for chosen, dimensions in (({"z": 3}, (12, 8, 1)), ({"y": 3}, (12, 1, 10)), ({"x": 3}, (1, 8, 10))):
            self.assertEqual(dataset.isel(chosen).nephoscope.grid().dimensions, dimensions)
        both = dataset.assign(lwp=dataset.ql.sum("z"))
        self.assertNotIn("lwp", both.nephoscope.grid().array_names)
        self.assertEqual(both.nephoscope.grid(variables=["lwp"]).dimensions, (12, 8, 1))

    def test_pictures(self):
        dataset = simulation()
        with tempfile.TemporaryDirectory() as folder:
            for name, its in (("volume", dataset), ("level", dataset.isel(z=4)), ("section", dataset.isel(y=4)), ("other", dataset.isel(x=4))):
                path = Path(folder, name + ".png")
                self.addCleanup(its.nephoscope.plot("cloud_water", screenshot=str(path)).close)
                picture = pyvista.read(path)["PNGImage"].reshape(800, 800, -1)[..., :3].astype(int)
                drawn = picture.max(-1) > 40
                with self.subTest(name):
                    self.assertGreater(picture[400, 380].max(), 150)  # the cloud is in the middle
                    self.assertGreater(drawn.mean(), 0.05)
                    self.assertFalse(drawn[:, :8].any() or drawn[:8].any() or drawn[-8:].any())  # nothing is cut off
        bare = dataset.copy()
        bare["ql"].attrs.clear()
        colours = [nephoscope.add_cells(self.plotter(), data, "ql").mapper.lookup_table.values[-1] for data in (dataset, bare)]
        np.testing.assert_array_equal(*colours)  # those of clouds, with and without units
        with self.assertRaisesRegex(TypeError, "'projection'.*lengths"):
            dataset.nephoscope.plot(projection="map")
        with self.assertRaisesRegex(ValueError, "'place'"):
            dataset.nephoscope.plot("plaice")

    def flow(self, **more):
        """Rotation about the z axis, and a vertical wind from -1 to 4 m/s."""
        up, north, east = np.meshgrid(Z, Y, X, indexing="ij")
        parts = {"u": -1e-3 * north, "v": 1e-3 * east, "w": np.linspace(-1, 4, north.size).reshape(north.shape)}
        return simulation(**{name: (("z", "y", "x"), values, {"units": "m/s"}) for name, values in parts.items()}, **more)

    def test_computed_quantities(self):
        dataset = self.flow(T=("z", 290 - 0.0065 * Z, {"units": "K"}), p=("z", 1e5 * np.exp(-Z / 8000), {"units": "Pa"}), qv=("z", 0.01 + 0 * Z, {"units": "kg/kg"}))
        dataset["qv"] = dataset.qv.broadcast_like(dataset.ql).assign_attrs(units="kg/kg")
        mesh = dataset.nephoscope.grid(derive=["wind_speed", "wind_magnitude", "vorticity", "potential_temperature", "relative_humidity", "cloud_content", "water_vapour"],
                                       vertical_exaggeration=3)
        x, y, z = (mesh.points / (1, 1, 3)).T
        air = 1e5 * np.exp(-z / 8000) / (287.05 * (290 - 0.0065 * z))
        for name, expected in (("wind_speed", 1e-3 * np.hypot(x, y)), ("wind_magnitude", np.linalg.norm(mesh["Wind"], axis=1)), ("vorticity", 2e-3 + 0 * x),
                               ("potential_temperature", (290 - 0.0065 * z) * np.exp(0.2857 * z / 8000)), ("cloud_content", mesh["ql"] * air), ("water_vapour", 0.01 * air)):
            np.testing.assert_allclose(mesh[name], expected, rtol=1e-3, atol=1e-6, err_msg=name)
        self.assertTrue(0.5 < mesh["relative_humidity"].min() and mesh["relative_humidity"].max() < 2)
        with tempfile.TemporaryDirectory() as folder:
            for name, text in (("wind_speed", "Wind speed\n[m s-1]"), ("Wind", "Wind magnitude\n[m s-1]"), ("vorticity", "Vorticity\n[s-1]")):
                for its in (dataset, dataset.isel(z=3)):
                    plotter = its.nephoscope.plot(name, screenshot=str(Path(folder, "picture.png")), window_size=(200, 150))
                    self.addCleanup(plotter.close)
                    self.assertEqual([bar.GetTitle() for bar in plotter.scalar_bars.values()], [text])
            self.assertEqual(pyvista.read(Path(folder, "picture.png")).dimensions[:2], (200, 150))
        with self.assertRaisesRegex(ValueError, "'vortisity'. Did you mean 'vorticity'"):
            dataset.nephoscope.plot("vortisity")
        with self.assertRaisesRegex(ValueError, "vorticity needs the wind along x and along y"):
            simulation().nephoscope.plot("vorticity")

    def test_columns(self):
        content = simulation()
        content["ql"] = (content.ql * 0 + 1e-3).assign_attrs(units="g/m3")
        column = content.nephoscope.column("ql")
        self.assertEqual((column.dimensions, str(column.field_data["column_units"][0])), ((len(X), len(Y), 1), "kg m-2"))
        np.testing.assert_allclose(column["column"], 1e-6 * (Z[-1] - Z[0]), rtol=1e-5)
        np.testing.assert_allclose(content.isel(z=[0, 1, 4, 9]).nephoscope.column("ql")["column"], 1e-6 * (Z[-1] - Z[0]), rtol=1e-5)
        p = 9.80665 * 100 * np.exp(-Z / 1e9) * 1000  # the density of 1 kg/m3
        air = simulation(p=("z", p, {"units": "Pa"}), T=("z", p / 287.05, {"units": "K"}))
        np.testing.assert_allclose(air.nephoscope.column()["column"].reshape(len(Y), len(X)), np.trapezoid(air.ql, Z, axis=0) if hasattr(np, "trapezoid") else np.trapz(air.ql, Z, axis=0), rtol=1e-4, atol=1e-9)
        with self.assertWarnsRegex(UserWarning, "no temperature and no pressure: taken from the standard atmosphere"):
            simulation().nephoscope.column()
        for call, words in ((lambda: simulation().isel(y=2).nephoscope.column("ql"), "no axis y"), (lambda: simulation().nephoscope.column("qq"), "'qq' is neither 'cloud_content'"),
                            (lambda: self.flow().nephoscope.column("u"), "units of 'u'.*mass fraction")):
            with self.assertRaisesRegex(ValueError, words):
                call()

    def test_sections_have_the_colours_of_volumes_and_scales(self):
        dataset = self.flow()
        with tempfile.TemporaryDirectory() as folder:
            for name, limits in (("w", (-4, 4)), ("ql", (0, float(dataset.ql.max())))):
                colours = []
                for its in (dataset, dataset.isel(y=4), dataset.isel(z=4)):
                    plotter = its.nephoscope.plot(name, screenshot=str(Path(folder, "picture.png")), vertical_exaggeration=2, clim=limits)
                    self.addCleanup(plotter.close)
                    bar, = plotter.scalar_bars.values()
                    table = bar.GetLookupTable()
                    colours.append([[round(255 * part) for part in table.GetTableValue(i)[:3]] for i in (0, table.GetNumberOfTableValues() // 2, table.GetNumberOfTableValues() - 1)])
                np.testing.assert_allclose(colours[1], colours[0], atol=1)
                np.testing.assert_allclose(colours[2], colours[0], atol=1)
            plotter = dataset.isel(y=4).nephoscope.plot("w", screenshot=str(Path(folder, "picture.png")), vertical_exaggeration=2)
            self.addCleanup(plotter.close)
            low, high = plotter.scalar_bars["w"].GetLookupTable().GetTableRange()
            self.assertAlmostEqual(low, -high)
            for letter, axis, values in (("x", 0, [0, 200, 400, 600, 800, 1000]), ("z", 2, [100, 200, 300, 400])):  # at round values, heights without the exaggeration
                scale, labels = (plotter.renderer.actors[name].GetMapper() for name in (f"scale_{letter}", f"labels_{letter}-labels"))
                np.testing.assert_allclose(scale.dataset.points[:-2:2, axis] / (1 if letter == "x" else 2), values)
                labels.GetInputAlgorithm().Update()
                words = labels.GetInputAlgorithm().GetInputDataObject(0, 0).GetPointData().GetAbstractArray("labels")
                self.assertEqual([words.GetValue(k) for k in range(words.GetNumberOfValues())], [*map(str, values), f"{letter} [m]"])
            self.assertEqual([list(ticks(*limits)) for limits in ((0, 1), (25, 475), (-2.5, 2.5), (1, 1))], [[0, 0.2, 0.4, 0.6000000000000001, 0.8, 1], [100, 200, 300, 400], [-2, -1, 0, 1, 2], [1]])
            with self.assertRaisesRegex(ValueError, "sun: an option of volumes"):
                dataset.isel(y=4).nephoscope.plot(sun=(1, 0, 1), screenshot=str(Path(folder, "none.png")))
            lit = simulation(T=("z", 290 - 0.0065 * Z, {"units": "K"}), p=("z", 1e5 * np.exp(-Z / 8000), {"units": "Pa"}))
            plotter = lit.nephoscope.plot(sun=(1, 0, 1), exposure=1, screenshot=str(Path(folder, "picture.png")))
            self.addCleanup(plotter.close)
            self.assertIn("Sunlight", [getattr(actor.mapper, "array_name", "") for actor in plotter.renderer.actors.values() if isinstance(actor, pyvista.Volume)]
                          + [name for actor in plotter.renderer.actors.values() if isinstance(actor, pyvista.Volume) for name in actor.mapper.dataset.array_names])
            self.assertGreater(pyvista.read(Path(folder, "picture.png"))["PNGImage"].reshape(800, 800, -1)[400, 380, :3].max(), 100)

    def test_films_take_the_look_of_plots(self):
        series = xr.concat([simulation(), simulation() * 2], "time").assign_coords(time=[0.0, 60.0])
        series["ql"].attrs["units"] = "kg/kg"
        for its in (series, series.isel(z=4), series.isel(y=4), series.isel(x=4)):
            plotter = pyvista.Plotter(off_screen=True, window_size=(120, 100))
            self.addCleanup(plotter.close)
            film = nephoscope.animate(plotter, its, "ql", clim=(0, 3e-3), cmap="viridis", opacity=0.5)
            self.addCleanup(film.close)
            bar, = plotter.scalar_bars.values()
            self.assertEqual(bar.GetLookupTable().GetTableRange(), (0, 3e-3))
        with self.assertRaisesRegex(TypeError, "clim: an option for the field"):
            nephoscope.animate(self.plotter(), series, lambda plotter, mesh: None, clim=(0, 1))
        with self.assertRaisesRegex(TypeError, "no option 'sun'"):
            nephoscope.animate(self.plotter(), series, "ql", sun=(1, 0, 1))

    def test_small_faults_are_told(self):
        with self.assertRaisesRegex(ValueError, r"no 3-D cells. It is one level or section: .*\.plot\(\)"):
            nephoscope.add_cells(self.plotter(), simulation().isel(z=2), "ql")
        with self.assertRaisesRegex(AttributeError, r"no attribute 'add_cells'. It is a function of the package: nephoscope.add_cells\(plotter, dataset, ...\)"):
            simulation().nephoscope.add_cells(self.plotter(), "ql")
        repeated = simulation().isel(z=[0, 1, 1, 2, 3])
        with self.assertWarnsRegex(UserWarning, "'z' repeats values: .* 1 are left out"):
            self.assertEqual(repeated.nephoscope.grid().dimensions[2], 4)
        lit = simulation(T=("z", 290 - 0.0065 * Z, {"units": "K"}), p=("z", 1e5 * np.exp(-Z / 8000), {"units": "Pa"}))
        image = nephoscope.satellite_image(lit, sun=(0, 0, 1), size=(20, 20))
        self.assertGreater(image.reflectance.max(), 0.2)

    def test_functions_that_take_a_mesh(self):
        dataset = simulation()
        for data in (dataset, dataset.ql):
            for add in (nephoscope.add_cells, nephoscope.add_splats):
                volume = add(self.plotter(), data)
                self.assertEqual((volume.mapper.dataset.bounds, volume.mapper.dataset.active_scalars_name), (dataset.nephoscope.grid().bounds, "ql"))
        globe = isothermal(np.arange(0, 40, 5.0), np.arange(20, 60, 5.0))
        volume = nephoscope.add_cells(self.plotter(), globe, "ta", opacity=0.5)
        self.assertEqual(volume.mapper.dataset.n_points, globe.nephoscope.globe().n_points)

    def test_filters_and_smoke(self):
        steady = xr.full_like(simulation().ql, 2).assign_attrs(units="m/s")
        dataset = simulation(u=steady, v=0 * steady, w=0 * steady)
        smoke = nephoscope.flow_volume(dataset, center=(100, 0, 250), radius=50, duration=20)
        np.testing.assert_allclose(smoke.bounds[:2], (100, 140), atol=1)
        light = nephoscope.sunlight(dataset.ql * 10, (0, 0, 1), extinction="ql")
        self.assertEqual(light.dimensions, dataset.nephoscope.grid().dimensions)
        air = simulation(t=0 * steady + 280, p=0 * steady + 8e4)
        self.assertGreater(nephoscope.cloud_optics(air, liquid="ql", temperature="t", pressure="p")["Extinction"].max(), 0)
        sheet = pyvista.Plane(center=(500, 0, 250), i_size=1000, j_size=600)
        nephoscope.add_cloud_texture(self.plotter(), sheet, density_volume=dataset.ql)

    def test_the_air_may_be_profiles_of_a_base_state(self):
        """Temperature and pressure along z alone, in any units and on faces; potential temperature and density stand for them."""
        t, p = 290 - 0.0065 * Z, 1e5 * np.exp(-Z / 8000)
        theta, rho = t * (1e5 / p) ** 0.2857, p / (287.05 * t)
        whole = {name: (("z", "y", "x"), np.broadcast_to(values[:, None, None], field()[0].shape), {"units": units}) for name, values, units in (("T", t, "K"), ("p", p, "Pa"))}
        expected = nephoscope.cloud_optics(simulation(**whole))["Extinction"]
        faces = np.append(Z - 25, Z[-1] + 25)
        for air in ({"T": ("z", t, {"units": "K"}), "p": ("z", p, {"units": "Pa"})},
                    {"T0": ("z", t - 273.15, {"units": "degC"}), "p_ref": ("z", p / 100, {"units": "hPa"})},
                    {"theta": ("z", theta, {"units": "K"}), "pres": ("z", p / 1000, {"units": "kPa"})},
                    {"thref": ("z", theta, {"units": "K"}), "rho0": ("z", rho, {"units": "kg m-3"})},
                    {"TABS": ("z", t, {"units": "K"}), "rho": ("z", rho, {"units": "kg/m3"}), "p": whole["p"][:1] + (whole["p"][1] - 1e5, {"units": "Pa"})},
                    {"T": ("zh", 290 - 0.0065 * faces, {"units": "K"}), "p": ("z", p, {"units": "Pa"})}):
            dataset = simulation(**air)
            for its in (dataset, dataset.isel(z=slice(None, None, -1)) if "zh" not in dataset.dims else dataset):
                with self.subTest(tuple(air)), warnings.catch_warnings():
                    warnings.simplefilter("error")
                    np.testing.assert_allclose(nephoscope.cloud_optics(its)["Extinction"], expected, rtol=2e-3, atol=1e-9)
        dataset = simulation(T=("z", t, {"units": "K"}), p=("z", p, {"units": "Pa"}), lwp=(("y", "x"), np.ones((len(Y), len(X)))), shf=3.0)
        for line in ("temperature: 'T', a profile along z (K), the same in every column", "pressure: 'p', a profile along z", "left out: 'lwp' (y, x), 'shf' (one value)"):
            self.assertIn(line, dataset.nephoscope.describe())
        self.assertNotIn("left out", simulation().nephoscope.describe())
        with self.assertRaisesRegex(ValueError, r"'T' has the dimension 'z' alone.*ds\['T'\].plot"):
            dataset.nephoscope.plot("T")
        nephoscope.add_cells(self.plotter(), dataset, sun=(1, -1, 1))

    def test_the_standard_atmosphere_where_the_air_is_missing(self):
        air = nephoscope.weather.columns.standard_air
        np.testing.assert_allclose(air(np.array([0.0, 5000, 11000, 20000, 32000])), [[101325, 54020, 22632, 5474.9, 868.02], [288.15, 255.65, 216.65, 216.65, 228.65]], rtol=1e-4)
        p, t = air(Z)
        full = nephoscope.cloud_optics(simulation(T=("z", t, {"units": "K"}), p=("z", p, {"units": "Pa"})))["Extinction"]
        warm = nephoscope.cloud_optics(simulation(T=("z", t + 10, {"units": "K"}), p=("z", p, {"units": "Pa"})))["Extinction"]
        for dataset, missing, expected in ((simulation(), "no temperature and no pressure", full), (simulation(T=("z", t, {"units": "K"})), "no pressure", full),
                                           (simulation(p=("z", p, {"units": "Pa"})), "no temperature", full), (simulation(T=("z", t + 10, {"units": "K"})), "no pressure", warm)):
            for factor in (1, 3):
                with self.assertWarnsRegex(UserWarning, f"The grid has {missing}: taken from the standard atmosphere"):
                    optics = dataset.nephoscope.grid(vertical_exaggeration=factor).nephoscope.cloud_optics()
                np.testing.assert_allclose(optics["Extinction"] * factor, expected, rtol=2e-3)
        self.assertFalse([name for name in optics.array_names if "FlatGrid" in name and name in optics.point_data])
        content = simulation()
        content["ql"].attrs["units"] = "kg/m3"
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            nephoscope.cloud_optics(content)  # needs no air
        with self.assertRaisesRegex(RuntimeError, "There is no array of cloud water: [^F]*$"):
            nephoscope.cloud_optics(simulation().place)
        with self.assertRaisesRegex(RuntimeError, "no temperature"):
            nephoscope.cloud_optics(self.bare())

    def bare(self):
        mesh = simulation().nephoscope.grid()
        mesh.clear_field_data()
        return mesh

    def test_exaggeration_keeps_the_vertical_optical_depth(self):
        """As on globes: extinction is per metre of the picture."""
        ones = xr.ones_like(simulation().ql)
        air = simulation(T=(280 * ones).assign_attrs(units="K"), p=(8e4 * ones).assign_attrs(units="Pa"))
        depths, shadows = [], []
        for factor in (1, 5):
            clouds = air.nephoscope.grid(vertical_exaggeration=factor).nephoscope.cloud_optics()
            depths.append(clouds["ColumnOpticalDepth"].max())
            shadows.append(clouds.nephoscope.sunlight((0, 0, 1), multiple_scattering=False)["SunTransmittance"].min())
        np.testing.assert_allclose(depths[1], depths[0], rtol=1e-4)
        np.testing.assert_allclose(shadows[1], shadows[0], rtol=1e-3)
        plotter = self.plotter()
        nephoscope.add_cells(plotter, air.nephoscope.grid(), "ql")
        with self.assertWarnsRegex(RuntimeWarning, "exaggeration of the data is 5, .* is 1. .* in grid"):
            nephoscope.add_cells(plotter, air.nephoscope.grid(vertical_exaggeration=5), "ql")

    def test_haze_of_exaggerated_heights(self):
        """A scale height that you give is exaggerated with the data; the default is a share of the scene as it is drawn."""
        pictures = []
        for factor, options in ((5, {}), (5, {"vertical_exaggeration": 1}), (5, {"scale_height": 100}), (1, {"scale_height": 500}), (1, {"scale_height": 100})):
            plotter = self.plotter()
            mesh = simulation().nephoscope.grid(vertical_exaggeration=factor)
            stretched = mesh.copy()
            stretched.spacing, stretched.origin = ([*mesh.spacing[:2], 250.0], [0, -400, 125])
            plotter.add_mesh(stretched.outline())
            nephoscope.add_haze(plotter, mesh, visibility=2000, **options)
            plotter.view_vector((0, -1, 0))
            pictures.append(plotter.screenshot(return_img=True).astype(int))
        np.testing.assert_array_equal(pictures[0], pictures[1])
        np.testing.assert_array_equal(pictures[2], pictures[3])
        self.assertGreater(np.abs(pictures[3] - pictures[4]).max(), 20)

    def test_dimensions_of_series_and_species(self):
        series = simulation().expand_dims(time_series_600=[0.0, 600.0])
        self.check_places(series.nephoscope.grid(time=1))
        species = simulation().expand_dims(species=3)
        with self.assertRaisesRegex(GridError, r"besides the axes.*ds\.isel\(species=0\)"):
            species.nephoscope.plot()
        pressures = simulation().assign_coords(z=("z", 1000 - Z, {"units": "hPa"}))
        with self.assertRaisesRegex(GridError, r"'z' \(hPa\).*not known to be a length"):
            pressures.nephoscope.grid()
        with self.assertRaisesRegex(GridError, "The selection is empty: 'x'"):
            simulation().isel(x=slice(0, 0)).nephoscope.plot()
        with self.assertRaisesRegex(ValueError, "vertical_exaggeration is 0"):
            simulation().nephoscope.plot(vertical_exaggeration=0, screenshot="none.png")
        missing = simulation().assign_coords(x=("x", np.where(X > 500, np.nan, X), {"units": "m"}))
        with self.assertRaisesRegex(GridError, "'x' has missing values"):
            missing.nephoscope.grid()

    def test_data_on_the_earth_are_not_flat(self):
        with self.assertRaisesRegex(GridError, r"lengths.*ds\.nephoscope\.grid\(\)"):
            simulation().nephoscope.globe()
        dataset = simulation()
        self.assertTrue(is_flat(dataset))
        self.assertFalse(is_flat(isothermal(X[:4], Y[:4] / 10)))
        placed = dataset.assign_coords(lon=(("y", "x"), np.ones((len(Y), len(X)))), lat=(("y", "x"), np.ones((len(Y), len(X)))))
        self.assertFalse(is_flat(placed))
        dataset["ql"].attrs["grid_mapping"] = "crs"
        self.assertFalse(is_flat(dataset))
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            self.check_places(dataset.nephoscope.grid())  # by request


if __name__ == "__main__":
    unittest.main()
