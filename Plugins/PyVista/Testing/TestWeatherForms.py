# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Forms that files in use have, drawn with nothing set, and those that cannot be drawn, with what they say."""
import tempfile
import unittest
import warnings
from pathlib import Path

import nephoscope
import numpy as np
import xarray as xr
from weather_data import AXIS, REGULAR, frames, isothermal, write_grib

LON, LAT = np.arange(0, 40, 5.0), np.arange(20, 60, 5.0)


def cubed_sphere(n=8, levels=(0.0, 5000.0)):
    """As GEOS writes it: centres and corners on six faces, false axes, a field on (level, face, row, column)."""
    edges = np.tan(np.linspace(-np.pi / 4, np.pi / 4, n + 1))
    middle = np.tan((np.arange(n) + 0.5) / n * np.pi / 2 - np.pi / 4)

    def places(t):
        a, b, one = *np.meshgrid(t, t), np.ones((len(t), len(t)))
        faces = np.array([(one, a, b), (-a, one, b), (-one, -a, b), (a, -one, b), (-b, a, one), (b, a, -one)])
        x, y, z = faces.transpose(1, 0, 2, 3) / np.linalg.norm(faces, axis=1)
        return np.degrees(np.arctan2(y, x)), np.degrees(np.arcsin(z))

    centre, corner, level = ("nf", "Ydim", "Xdim"), ("nf", "YCdim", "XCdim"), ("lev", *("nf", "Ydim", "Xdim"))
    lat = places(middle)[1]
    return xr.Dataset({"lons": (centre, places(middle)[0], {"units": "degrees_east"}), "lats": (centre, lat, {"units": "degrees_north"}), "corner_lons": (corner, places(edges)[0]),
                       "corner_lats": (corner, places(edges)[1]), "contacts": (("nf", "ncontact"), np.zeros((6, 4), int)),
                       "T": (level, np.stack([lat] * len(levels)), {"units": "K"}), "H": (level, np.ones((len(levels), 1, 1, 1)) * np.reshape(levels, (-1, 1, 1, 1)) + 0 * lat,
                                                                                        {"standard_name": "altitude", "units": "m"})},
                      {"Xdim": ("Xdim", np.arange(n) * 1.0, {"units": "degrees_east"}), "Ydim": ("Ydim", np.arange(n) * 1.0, {"units": "degrees_north"}), "lev": ("lev", [1, 2], {"positive": "up"})})


def tripolar(half, halo, rows=24, columns=96):
    """North of 30 degrees: ellipses round two poles on the 30th parallel's disc in the stereographic plane. `half`: rows lie half a row south of the fold, as T points do before an F fold."""
    eta = 1 - (np.arange(rows) + 0.0) / (rows - 1 + half)  # 1 at the 30th parallel, 0 on the fold
    xi = 2 * np.pi * (np.arange(columns) + half) / columns
    reach = np.tan(np.radians(30))  # of the 30th parallel in the plane
    focus = 0.5
    # Ellipses with foci at +-focus do not end in a circle: the minor axis shrinks to 0 and the major to the poles.
    major, minor = reach * (focus + (1 - focus) * eta), reach * eta
    x, y = major[:, None] * np.cos(xi), minor[:, None] * np.sin(xi)
    if halo:
        back = -1 if half else -2
        mirror = -np.arange(columns) - (1 if half else 0)
        x, y = np.vstack([x, x[back, mirror]]), np.vstack([y, y[back, mirror]])
    lat, lon = 90 - 2 * np.degrees(np.arctan(np.hypot(x, y))), np.degrees(np.arctan2(y, x))
    up = frames(lon, lat)[2]
    wind = 30 * np.cross(AXIS, up)
    east, north = (np.asarray(one) for one in frames(lon, lat)[:2])
    closed = np.concatenate([up[:, -1:], up, up[:, :1]], axis=1)
    along = closed[:, 2:] - closed[:, :-2]
    angle = np.arctan2((along * north).sum(-1), (along * east).sum(-1))
    u, v = (wind * east).sum(-1), (wind * north).sum(-1)
    dims = ("y", "x")
    return xr.Dataset({"uo": (dims, u * np.cos(angle) + v * np.sin(angle), {"standard_name": "x_wind", "units": "m/s"}), "vo": (dims, v * np.cos(angle) - u * np.sin(angle), {
        "standard_name": "y_wind", "units": "m/s"}), "tos": (dims, up @ [1.0, 2, 3], {"units": "1"})}, {"nav_lon": (dims, lon), "nav_lat": (dims, lat)})


class Forms(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def test_a_tripolar_grid_on_a_map(self):
        """It fills the map from side to side, without the row that closes the fold, in pictures of fields, of integrals and in films."""
        for half, halo in ((False, False), (True, False), (False, True), (True, True)):
            with self.subTest(half=half, halo=halo):
                grid = tripolar(half, halo).nephoscope.globe(projection="map")
                west, east, south, north = np.degrees(np.array(grid.bounds[:4]) / 6371000)
                self.assertTrue(355 < east - west < 372 and abs(south - 30) < 1 and north <= 90, grid.bounds)
                self.assertEqual(grid.dimensions[:2], (97, 24))
                self.assertIn("Wind", grid.point_data)
                series = xr.concat([tripolar(half, halo)] * 2, "time").assign_coords(time=np.array(["2020-01-01", "2020-01-02"], "M8[ns]")).nephoscope.series(projection="map")
                np.testing.assert_array_equal(series[1]["tos"], grid["tos"])

    def test_a_cubed_sphere_is_closed(self):
        for take in (slice(None), slice(None, None, -1)):
            grid = cubed_sphere().isel(lev=take).nephoscope.globe(radius=1e5)
            self.assertEqual((grid.n_cells, grid.n_points), (6 * 64 * 2, 3 * (6 * 64 + 2)))  # corners of faces that meet are one
            lat = np.degrees(np.arcsin((c := grid.cell_centers().points)[:, 2] / np.linalg.norm(c, axis=1)))
            np.testing.assert_allclose(grid.cell_data["T"], lat, atol=1.5)
        one_field = cubed_sphere()[["T", "lons", "lats", "corner_lons", "corner_lats"]].isel(lev=0)
        self.assertEqual(one_field.nephoscope.globe().n_cells, 384)
        with self.assertRaisesRegex(ValueError, r"no longitudes and latitudes of the cell corners.*ds.isel\(nf=0\)"):
            cubed_sphere().drop_vars(["corner_lons", "corner_lats"]).nephoscope.globe()

    def test_lists_of_points_with_one_level(self):
        rows = np.arange(20, 52, 4)
        octahedral = {"gridType": "reduced_gg", "N": 8, "pl": np.concatenate([rows, rows[::-1]]), "latitudeOfFirstGridPointInDegrees": 84, "latitudeOfLastGridPointInDegrees": -84,
                      "longitudeOfFirstGridPointInDegrees": 0, "longitudeOfLastGridPointInDegrees": 352}
        pixels = {"gridType": "healpix", "Nside": 4, "orderingConvention": "ring", "longitudeOfFirstGridPointInDegrees": 45}
        for name, keys, sample, cells in (("rows", octahedral, "reduced_gg_pl_32_grib2", 48 * 17), ("pixels", pixels, "GRIB2", 192)):
            path = self.folder / f"{name}.grib2"
            write_grib(path, [("2t", "heightAboveGround", 2, 280.0)], keys, sample=sample)
            grid = nephoscope.open(path).nephoscope.globe()
            self.assertEqual(grid.n_cells, cells)
            np.testing.assert_allclose(grid["t2m"], 280, atol=1e-3)

    def test_the_pressure_at_the_ground_is_no_vertical_axis_of_a_list(self):
        lon, lat = (place.ravel()[np.random.default_rng(1).permutation(648)] for place in np.meshgrid(np.arange(5.0, 360, 10), np.arange(-85.0, 90, 10)))
        west, south = lon.ravel()[:, None] + [-5, 5, 5, -5], lat.ravel()[:, None] + [-5, -5, 5, 5]
        data = xr.Dataset({"PS": ("ncol", np.full(648, 1e5), {"units": "Pa"}), "T": (("lev", "ncol"), np.full((3, 648), 250.0), {"units": "K"})},
                          {"lev": ("lev", [900.0, 500, 100], {"units": "hPa"})})
        mesh = xr.Dataset({"grid_center_lon": ("grid_size", lon.ravel(), {"units": "degrees"}), "grid_center_lat": ("grid_size", lat.ravel(), {"units": "degrees"}),
                           "grid_corner_lon": (("grid_size", "grid_corners"), west), "grid_corner_lat": (("grid_size", "grid_corners"), south)})
        data.to_netcdf(self.folder / "data.nc")
        mesh.to_netcdf(self.folder / "scrip.nc")
        grid = nephoscope.open(self.folder / "data.nc", mesh=self.folder / "scrip.nc").nephoscope.globe()
        self.assertEqual(grid.n_cells, 3 * 648)
        with self.assertRaisesRegex(ValueError, r"No longitudes.*nephoscope.open\(DATA, mesh=GRID\)"):
            nephoscope.open(self.folder / "data.nc").nephoscope.globe()
        mesh.isel(grid_size=slice(10)).to_netcdf(self.folder / "other.nc")
        with self.assertRaisesRegex(ValueError, "mesh: it has grid_size 10, .*ncol 648.*other data"):
            nephoscope.open(self.folder / "data.nc", mesh=self.folder / "other.nc")

    def test_bounds_are_no_fields(self):
        dataset = isothermal(LON, LAT)
        bounds = {name: ((name, "bnds"), np.stack([dataset[name].values] * 2, 1)) for name in ("lon", "lat", "plev")}
        dataset = dataset[["ta"]].assign({f"{name}_bnds": value for name, value in bounds.items()})
        for name in bounds:
            dataset[name].attrs["bounds"] = f"{name}_bnds"
        self.assertEqual(dataset.nephoscope.globe().dimensions[2], 4)

    def test_one_of_several_members(self):
        dataset = xr.concat([isothermal(LON, LAT), isothermal(LON, LAT, temperature=260.0)], "realization")
        with self.assertWarnsRegex(UserWarning, r"'realization' has 2 entries; the first was taken. Choose one: ds.isel\(realization=0\)"):
            self.assertEqual(dataset.nephoscope.globe()["ta"].max(), 250)
        self.assertEqual(dataset.isel(realization=1).nephoscope.globe()["ta"].max(), 260)

    def test_depths_go_down_and_are_not_hidden(self):
        dataset = xr.Dataset({"thetao": (("lev", "lat", "lon"), np.ones((3, LAT.size, LON.size)), {"units": "degC", "standard_name": "sea_water_potential_temperature"})},
                             {"lev": ("lev", [5.0, 100, 3000], {"units": "m", "positive": "down", "axis": "Z"}), "lat": ("lat", LAT), "lon": ("lon", LON)})
        grid = dataset.nephoscope.globe(projection="map")
        np.testing.assert_allclose(np.unique(grid["Height"]), [-3000, -100, -5])
        self.assertNotIn("vtkGhostType", grid.array_names)
        self.assertIn("levels: depth", dataset.nephoscope.describe())

    def test_points_without_a_place_are_hidden(self):
        x, y = np.meshgrid(LON, LAT)
        x[2, 3], y[2, 3] = 9.96921e36, 9.96921e36
        y[4, 5] = np.nan
        dataset = xr.Dataset({"tos": (("j", "i"), np.ones(x.shape))}, {"nav_lon": (("j", "i"), x), "nav_lat": (("j", "i"), y)})
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            grid = dataset.nephoscope.globe(projection="map")
        self.assertEqual(list(np.flatnonzero(grid["vtkGhostType"])), [9, 10, 16, 17, 25, 26, 32, 33])  # the four cells round each
        self.assertLess(np.abs(grid.points).max(), 6371000 * np.pi)
        self.assertIn("2 of 64 points have no longitude or latitude", dataset.nephoscope.describe())
        with self.assertRaisesRegex(ValueError, "only fill values"):
            dataset.assign_coords(nav_lat=dataset.nav_lat * np.nan).nephoscope.globe()

    def test_all_spellings_of_degrees(self):
        """CF 1.11, sections 4.1 and 4.2; the names say nothing."""
        lon, lat = np.meshgrid(LON, LAT)
        for east in ("degrees_east", "degree_east", "degree_E", "degrees_E", "degreeE", "degreesE"):
            north = east.replace("east", "north").replace("E", "N")
            dataset = xr.Dataset({"tos": (("j", "i"), lat)}, {"p": (("j", "i"), lon, {"units": east}), "q": (("j", "i"), lat, {"units": north})})
            grid = dataset.nephoscope.globe()
            sines = np.asarray(grid.points)[:, 2] / np.linalg.norm(grid.points, axis=1)
            np.testing.assert_allclose(np.degrees(np.arcsin(sines)), np.asarray(grid["tos"]), atol=1e-3, err_msg=east)

    def test_the_seam_of_an_ocean_model_is_closed_once(self):
        """Columns round the globe, bent and shifted; without a halo, with one of two columns, and with the first repeated."""
        columns = np.arange(36)
        for halo, take in (("none", columns), ("two", np.append(columns, [0, 1])), ("one", np.append(columns, 0))):
            lat, lon = np.meshgrid(np.linspace(-60, 60, 13), 73.0 + 10 * columns[take], indexing="ij")
            lat = lat + 3 * np.sin(np.radians(lon))
            lon = np.mod(lon + 180, 360) - 180
            value = np.cos(np.radians(lon))
            dataset = xr.Dataset({"tos": (("y", "x"), value), "nav_lon": (("y", "x"), lon), "nav_lat": (("y", "x"), lat)})
            grid = dataset.nephoscope.globe()
            with self.subTest(halo=halo):
                self.assertEqual(tuple(grid.dimensions), (37, 13, 1))
                points = np.asarray(grid.points).reshape(13, 37, 3)
                np.testing.assert_allclose(points[:, 0], points[:, -1], atol=1)
                np.testing.assert_allclose(np.asarray(grid["tos"]), np.cos(np.arctan2(*np.asarray(grid.points).T[1::-1])), atol=1e-5)
        half = dataset.isel(x=slice(0, 18)).nephoscope.globe()
        self.assertEqual(half.dimensions[0], 18)

    def test_the_northern_fold_of_an_ocean_model_is_closed_once(self):
        """A tripolar grid in closed form, of four layouts, from south to north and back: its surface is that of the sphere north of its first row, no cell is there twice, and a rotation's wind is right at the fold."""
        for name, half, halo in (("F", 0.5, 0), ("F with a halo", 0.5, 1), ("T", 0.0, 0), ("T with a halo", 0.0, 1)):
            for turned in (False, True):
                with self.subTest(name, turned=turned):
                    dataset = tripolar(half, halo)
                    grid = (dataset.isel(y=slice(None, None, -1)) if turned else dataset).nephoscope.globe(radius=1.0)
                    shown = grid.extract_cells(np.flatnonzero(grid.cell_data.get("vtkGhostType", np.zeros(grid.n_cells)) == 0)) if "vtkGhostType" in grid.cell_data else grid
                    area = shown.compute_cell_sizes()["Area"].sum()
                    self.assertAlmostEqual(area / (2 * np.pi * (1 - np.sin(np.radians(30)))), 1, delta=0.004)
                    up = np.asarray(shown.points)
                    np.testing.assert_allclose(np.asarray(shown["Wind"]), 30 * np.cross(AXIS, up), atol=1.5)
                    np.testing.assert_allclose(np.asarray(shown["tos"]), up @ [1, 2, 3], atol=1e-4)

    def test_some_levels_of_a_model(self):
        """Pressures of hybrid levels that are not neighbours are those of their own half levels."""
        a, b = np.array([0.0, 100, 300, 200, 0]), np.array([0.0, 0.1, 0.3, 0.7, 1.0])
        pv = {"PVPresent": 1, "pv": np.concatenate([a, b])}
        path = self.folder / "levels.grib2"
        write_grib(path, [("t", "hybrid", level, 250.0, pv) for level in (2, 4)] + [("sp", "surface", 0, 1e5), ("orog", "surface", 0, 0.0)], REGULAR)
        from nephoscope.weather.air import Air
        from nephoscope.weather.reading import Reading
        pressure = Air(Reading(nephoscope.open(path))).pressure[:, 0, 0]
        np.testing.assert_allclose(pressure, (0.5 * (a[:-1] + a[1:]) + 0.5 * (b[:-1] + b[1:]) * 1e5)[[1, 3]], rtol=1e-6)
        self.assertIn("over full levels", nephoscope.open(path).nephoscope.describe())

    def test_grib_behind_a_header(self):
        path = self.folder / "bulletin.grib2"
        write_grib(path, [("2t", "heightAboveGround", 2, 280.0)], REGULAR)
        path.write_bytes(b"\x00" * 6000 + path.read_bytes())
        np.testing.assert_allclose(nephoscope.open(path).nephoscope.globe()["t2m"], 280, atol=1e-3)

    def test_times_that_cannot_be_decoded(self):
        for units, attributes in (("fortnights since 1850-01-01", {}), ("hours since an unknown day", {}), ("hours", {"dtype": "timedelta64[ns]"})):
            dataset = xr.concat([isothermal(LON, LAT)] * 2, "time").assign_coords(time=("time", [0.0, 6.0], {"units": units, **attributes}))
            dataset.to_netcdf(path := self.folder / f"times of {units}.nc")
            with nephoscope.open(path) as opened, self.subTest(units=units):
                self.assertIn("(of 2, to ", opened.nephoscope.describe(time=0))
                self.assertEqual(len(list(opened.nephoscope.series())), 2)

    def test_land_alone_is_no_ground(self):
        dataset = isothermal(LON, LAT)[["ta"]].assign(lsm=(("lat", "lon"), np.ones((LAT.size, LON.size)), {"standard_name": "land_binary_mask"}))
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            dataset.nephoscope.globe()

    def test_levels_without_units(self):
        """Pressures by their values; a count is none."""
        first = isothermal(LON, LAT)
        for values, factor in (([1000.0, 850, 500, 200], 100), ([100000.0, 85000, 50000, 20000], 1)):
            bare = xr.Dataset({"ta": (("lev", "lat", "lon"), first.ta.values, {"units": "K"})}, {"lev": values, "lat": first.lat, "lon": first.lon})
            known = bare.assign_coords(lev=("lev", np.array(values) * factor, {"units": "Pa"}))
            np.testing.assert_array_equal(bare.nephoscope.globe()["Height"], known.nephoscope.globe()["Height"])
            self.assertIn("'lev' has no units: its values are taken as pressures in", bare.nephoscope.describe())
        with self.assertRaisesRegex(ValueError, "heights of the levels 'lev'"):
            bare.assign_coords(lev=[401.0, 402, 403, 404]).nephoscope.globe()

    def test_hybrid_levels_without_a_temperature(self):
        """CMIP's cl alone: heights of the standard atmosphere at a + b ps, with a warning."""
        first = isothermal(LON, LAT)
        model = xr.Dataset({"ps": first.ps, "ap": ("lev", [0.0, 1000, 5000]), "b": ("lev", [1.0, 0.8, 0.2]),
                            "cl": (("lev", "lat", "lon"), first.ta.values[:3], {"units": "%"})}, {"lev": ("lev", [1.0, 0.8, 0.2], {
                "standard_name": "atmosphere_hybrid_sigma_pressure_coordinate", "formula_terms": "ap: ap b: b ps: ps"}), "lat": first.lat, "lon": first.lon})
        with self.assertWarnsRegex(UserWarning, "No temperature was found on the levels 'lev'.*standard atmosphere"):
            grid = model.nephoscope.globe()
        pressures = np.array([1.02e5, 8.26e4, 2.54e4])
        standard = isothermal(LON, LAT, pressures)[["ta"]].nephoscope.globe()
        np.testing.assert_allclose(np.unique(grid["Height"]), np.unique(standard["Height"]), rtol=1e-5)

    def test_months_and_seasons_are_times(self):
        first = isothermal(LON, LAT)
        for dim in ("month", "season"):
            with self.assertWarnsRegex(UserWarning, f"2 times ..{dim}"):
                grid = xr.concat([first.ta, first.ta + 9], dim).to_dataset(name="ta").assign(ps=first.ps, orog=first.orog).nephoscope.globe()
            np.testing.assert_allclose(grid["ta"], 250)

    def test_unknown_dimensions_have_a_remedy(self):
        mesh = cubed_sphere().isel(lev=0).stack(cell=("nf", "Ydim", "Xdim"), create_index=False)[["lons", "lats", "T"]].reset_coords(drop=True)
        layers = mesh.assign(soil=(("tile", "cell"), np.ones((4, 384)))).drop_vars("T")
        with self.assertRaisesRegex(ValueError, r"ds.isel\(tile=0\)"):
            layers.nephoscope.globe()
        with self.assertRaisesRegex(ValueError, "grid mapping 'azimuthal' is not a known one"):
            xr.Dataset({"tas": (("y", "x"), np.ones((3, 3)), {"grid_mapping": "crs"}), "crs": ((), 0, {"grid_mapping_name": "azimuthal"})}).nephoscope.globe()

    def test_one_column(self):
        dataset = isothermal([5.0], [50.0])
        with self.assertRaisesRegex(ValueError, r"\(lat, lon\) is one column.*ds\['ta'\].squeeze\(\).plot\(\), with y='plev'"):
            dataset.nephoscope.globe()

    def test_groups_of_a_file(self):
        import netCDF4
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "groups.nc")

            def write(*names):
                with netCDF4.Dataset(path, "w") as file:
                    for name, values, units in (("lon", LON, "degrees_east"), ("lat", LAT, "degrees_north")):
                        file.createDimension(name, 8)
                        file.createVariable(name, "f4", (name,))[:] = values
                        file[name].units = units
                    for name in names:
                        file.createVariable(name, "f4", ("lat", "lon"))[:] = np.arange(64).reshape(8, 8)

            write("PRODUCT/cloud", "PRODUCT/DETAIL/phase")
            grid = nephoscope.open(path).nephoscope.globe()
            self.assertEqual({"cloud", "phase"} - set(grid.point_data.keys()), set())
            np.testing.assert_array_equal(grid["phase"], np.arange(64))
            Path(path).unlink()
            write("A/cloud", "B/cloud")
            with self.assertRaisesRegex(ValueError, r"2 groups, '/A', '/B', which do not fit together \('cloud' is in several\).*group='/A'\)"):
                nephoscope.open(path)
            self.assertEqual(nephoscope.open(path, group="/B").cloud.shape, (8, 8))


class Words(unittest.TestCase):
    """Units and names as other programs write them."""

    def test_units_of_axes(self):
        for north, east in (("degrees north", "degrees east"), ("Degree_North", "Degree_East"), ("deg N", "deg E"), ("\u00b0N", "\u00b0E"), ("degreesN", "degreesE")):
            data = xr.Dataset({"a": (("y", "x"), np.ones((5, 6)))}, {"y": ("y", np.arange(5.0), {"units": north}), "x": ("x", np.arange(6.0), {"units": east})})
            self.assertIn("longitude 0 to 5 (x), latitude 0 to 4 (y)", data.nephoscope.describe())

    def test_a_dimension_without_a_coordinate_along_which_heights_increase(self):
        heights = np.arange(4.0)[:, None, None] * 1000 + np.arange(6.0)
        axes = {"lat": ("lat", np.arange(5.0), {"units": "degrees_north"}), "lon": ("lon", np.arange(6.0), {"units": "degrees_east"})}
        for name, values, attrs in (("height", heights + np.zeros((4, 5, 6)), {"standard_name": "altitude", "units": "m"}), ("p", 1e5 - 20 * heights + np.zeros((4, 5, 6)), {"standard_name": "air_pressure", "units": "Pa"})):
            data = xr.Dataset({"q": (("k", "lat", "lon"), np.ones((4, 5, 6))), name: (("k", "lat", "lon"), values, attrs)}, axes)
            self.assertEqual(data.nephoscope.globe().dimensions, (6, 5, 4))
            self.assertIn(f"note: 'k' is vertical: '{name}' {'in' if name == 'height' else 'de'}creases along it", data.nephoscope.describe())
        data[name] = data[name] * 0 + np.array([9e4, 5e4, 9e4, 5e4])[:, None, None]  # neither increases nor decreases
        with self.assertRaisesRegex(ValueError, "No vertical axis was found"):
            data.nephoscope.globe()

    def test_temperatures_in_celsius_without_units(self):
        data = isothermal(LON, LAT)
        data["ta"] = (data.ta - 273.15).assign_attrs(standard_name="air_temperature")
        with self.assertRaisesRegex(ValueError, r"not plausible for temperature in K. Set them: ds\['ta'\].attrs\['units'\] = 'degC'"):
            data.nephoscope.globe()

    def test_winds_at_10_metres(self):
        """They are used if a dataset has no other winds."""
        ones = xr.ones_like(isothermal(LON, LAT).ta.isel(plev=0, drop=True)).assign_attrs(units="m s**-1", standard_name="")
        level = xr.Dataset({"u10": 3 * ones.assign_attrs(units="m s**-1"), "v10": 4 * ones})
        for name in level:
            level[name].attrs = {"units": "m s**-1"}
        np.testing.assert_allclose(np.asarray(level.nephoscope.globe(derive="wind_speed")["wind_speed"]), 5, rtol=1e-6)
        air = isothermal(LON, LAT)
        both = air.assign(u10=level.u10, v10=level.v10, ua=(air.ta * 0 + 6).assign_attrs(units="m/s"), va=(air.ta * 0 + 8).assign_attrs(units="m/s"))
        np.testing.assert_allclose(np.asarray(both.nephoscope.globe(derive="wind_speed")["wind_speed"]), 10, rtol=1e-6)

    def test_powers_in_titles(self):
        from nephoscope.weather.units import usual
        for units, written in (("kg kg**-1", "kg kg-1"), ("W m^-2", "W m-2"), ("m s**-1", "m s-1"), ("10**-6 m2", "10**-6 m2")):
            self.assertEqual(usual(units), written)


if __name__ == "__main__":
    unittest.main()
