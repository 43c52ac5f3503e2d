# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""First pictures of oceans, of fields that are zero almost everywhere, and of their films; zeros on land that no fill value declares."""
import os
import tempfile
import unittest
import warnings
from pathlib import Path

import nephoscope
import numpy as np
import pyvista
import xarray as xr
from weather_data import frames

OUTPUT = Path(os.environ["NEPHOSCOPE_TEST_OUTPUT"], "TestWeatherOcean.png")
LON, LAT, DEPTHS = np.arange(-40, -19, 2.0), np.arange(20, 41, 2.0), np.array([0.0, 50, 200, 1000, 3000])
SEA = ("depth", "lat", "lon")
PLACES = {"lat": ("lat", LAT, {"units": "degrees_north"}), "lon": ("lon", LON, {"units": "degrees_east"})}


def ocean(values, name="thetao", standard_name="sea_water_potential_temperature", depths=DEPTHS, units="degC"):
    values = np.broadcast_to(np.asarray(values, float), (len(depths), len(LAT), len(LON))).copy()
    return xr.Dataset({name: (SEA, values, {"standard_name": standard_name, "units": units})},
                      {"depth": ("depth", depths, {"units": "m", "positive": "down", "standard_name": "depth"}), **PLACES})


def layers(surface=20.0, deep=4.0):
    return np.linspace(surface, deep, len(DEPTHS))[:, None, None]


def roms(h=1600.0):
    """Terrain-following levels over a slope, 10 m to `h` deep."""
    lon, lat = np.meshgrid(np.linspace(-75, -71, 12), np.linspace(36, 39, 11))
    s, floor = (np.arange(8) + 0.5) / 8 - 1, 10 + (h - 10) * (lon + 75) / 4
    attrs = {"standard_name": "ocean_s_coordinate_g2", "positive": "up", "formula_terms": "s: s_rho C: Cs_r eta: zeta depth: h depth_c: hc"}
    places = ("eta_rho", "xi_rho")
    return xr.Dataset({"temp": (("s_rho", *places), 20 + 10 * np.broadcast_to(s[:, None, None], (8, *lon.shape)), {"units": "Celsius", "long_name": "potential temperature"}),
                       "zeta": (places, 0.6 + 0 * lon, {"units": "meter"}), "h": (places, floor, {"units": "meter"}), "hc": ((), 20.0), "Cs_r": ("s_rho", -s * s)},
                      {"s_rho": ("s_rho", s, attrs), "lon_rho": (places, lon, {"units": "degrees_east"}), "lat_rho": (places, lat, {"units": "degrees_north"})})


def currents(u="u", v="v"):
    """Output of ROMS or CROCO that has currents alone, between the centres of the cells: u grows along xi, v along eta."""
    data = roms()
    along, across = (np.arange(11) + 0.5)[None, None, :] + np.zeros((8, 11, 1)), (np.arange(10) + 0.5)[None, :, None] + np.zeros((8, 1, 12))
    return data.drop_vars("temp").assign({u: (("s_rho", "eta_rho", "xi_u"), along, {"units": "meter second-1"}), v: (("s_rho", "eta_v", "xi_rho"), across, {"units": "meter second-1"})})


def currents_of_roms():
    """`currents` on dimensions of their own, as ROMS has them."""
    data = currents()
    return data.assign(u=(("s_rho", "eta_u", "xi_u"), data.u.values, data.u.attrs), v=(("s_rho", "eta_v", "xi_v"), data.v.values, data.v.attrs))


class Currents(unittest.TestCase):
    """Fields on the faces of cells, of a file without any at the centres, are brought there."""

    def check(self, data, levels=8, names=("u", "v")):
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            grid = data.nephoscope.globe()
        self.assertEqual(grid.n_points, levels * 11 * 12)
        wind = np.asarray(grid["Wind"]).reshape(levels, 11, 12, 3)[:, 1:-1, 1:-1]
        east, north, _ = frames(*(data[name].values[1:-1, 1:-1] for name in ("lon_rho", "lat_rho")))
        rows = np.arange(12.0)[1:-1], np.arange(11.0)[1:-1, None]
        angle = np.arctan2(*[np.sum(wind * axis, -1) for axis in (north, east)])
        np.testing.assert_allclose(np.linalg.norm(wind, axis=-1), np.broadcast_to(np.hypot(*rows), wind.shape[:-1]), rtol=1e-5)
        self.assertLess(np.abs(angle - np.arctan2(rows[1], rows[0])).max(), 0.03)  # the rows are not quite parallels
        for name in names:
            self.assertIn(f"'{name}' averaged from ", data.nephoscope.describe())

    def test_of_levels(self):
        data = currents()
        self.check(data)
        between = 0.5 * (data.lon_rho.values[:, 1:] + data.lon_rho.values[:, :-1]), 0.5 * (data.lat_rho.values[:, 1:] + data.lat_rho.values[:, :-1])
        self.check(data.assign_coords({name: (("eta_rho", "xi_u"), values, data[f"{name[:3]}_rho"].attrs) for name, values in zip(("lon_u", "lat_u"), between)}))

    def test_of_one_level(self):
        self.check(currents("ubar", "vbar").isel(s_rho=-1, drop=True).drop_vars(["h", "hc", "Cs_r"]), 1, ("ubar", "vbar"))

    def test_one_component(self):
        for data, name in ((currents().drop_vars("v"), "u"), (currents().drop_vars("u"), "v")):
            grid = data.nephoscope.globe()
            self.assertEqual(grid.n_points, 8 * 11 * 12)
            np.testing.assert_allclose(np.asarray(grid[name]).reshape(8, 11, 12)[3, 5, 1:-1], np.arange(12.0)[1:-1] if name == "u" else 5, rtol=1e-6)

    def test_dimensions_of_their_own(self):
        self.check(currents_of_roms())
        top = currents_of_roms().isel(s_rho=-1)
        self.check(top, 1)
        self.check(top.assign({name: xr.zeros_like(top.h, float) for name in ("zeta", "ssh", "heat")}), 1)

    def test_titles(self):
        """Velocities of water are currents, and a unit has one spelling."""
        for data in (currents_of_roms(), currents_of_roms().isel(s_rho=-1)):
            for name, title in (("wind_speed", "Current speed\n[m s-1]"), ("u", "u [m s-1]"), ("zeta", "zeta [m]")):
                plotter = data.nephoscope.plot(name, screenshot=str(OUTPUT), window_size=(200, 200))
                self.addCleanup(plotter.close)
                (bar,) = plotter.scalar_bars.values()
                self.assertEqual(bar.GetTitle().replace("\n", " "), title.replace("\n", " "))
        velocities = [("eastward_wind", "Wind speed [m s-1]"), ("eastward_sea_water_velocity", "Current speed [m s-1]")]
        for standard, title in velocities:
            data = ocean(1.0, "uo", standard, units="m/s").isel(depth=0, drop=True)
            data["vo"] = data.uo.assign_attrs(standard_name=standard.replace("eastward", "northward"))
            plotter = data.nephoscope.plot("wind_speed", screenshot=str(OUTPUT), window_size=(200, 200))
            self.addCleanup(plotter.close)
            (bar,) = plotter.scalar_bars.values()
            self.assertEqual(bar.GetTitle().replace("\n", " "), title)

    def test_fields_of_one_level_beside_currents(self):
        """They are drawn as where they are alone, also by animate."""
        data = currents_of_roms().reset_coords(["lon_rho", "lat_rho"])
        data["zeta"] = data.zeta + 0.1 * np.sin(data.lon_rho)
        fields = data[["zeta", "lon_rho", "lat_rho"]]
        pictures = []
        wide = {"lon": ("lon", np.linspace(-75, -71, 5), {"units": "degrees_east"}), "lat": ("lat", np.linspace(36, 39, 5), {"units": "degrees_north"})}
        ice = xr.Dataset({"ice": (("lat", "lon"), np.outer(np.arange(5.0), np.arange(5.0)), {"units": "1"})}, wide)
        for one, name in ((data, "zeta"), (fields, "zeta"), (data.merge(ice), "ice"), (ice, "ice")):  # the ice is on another grid
            one.nephoscope.plot(name, screenshot=str(OUTPUT), window_size=(200, 200)).close()
            pictures.append(pyvista.read(OUTPUT)["PNGImage"])
        plotter = pyvista.Plotter(off_screen=True, window_size=(200, 200))
        self.addCleanup(plotter.close)
        folder = Path(self.enterContext(tempfile.TemporaryDirectory()))
        nephoscope.animate(plotter, data, "zeta", filename=folder, progress=False, show_time=False).close()
        pictures.append(pyvista.read(folder / "00000.png")["PNGImage"])
        self.assertGreater(pictures[0].std(), 10)
        for picture, other in ((0, 1), (0, 4), (2, 3)):
            self.assertLess(np.abs(pictures[picture].astype(float) - pictures[other]).mean(), 0.5)

    def test_places_in_the_file_of_the_grid(self):
        folder, data = Path(self.enterContext(tempfile.TemporaryDirectory())), currents()
        places = ["lon_rho", "lat_rho", "h", "hc", "Cs_r"]
        data.reset_coords()[places].to_netcdf(folder / "grid.nc")
        data.drop_vars(places).to_netcdf(folder / "data.nc")
        with self.assertRaisesRegex(ValueError, r"grid file of ROMS or CROCO, give it: nephoscope.open\(DATA, mesh=GRID\)"):
            nephoscope.open(folder / "data.nc").nephoscope.globe()
        self.check(nephoscope.open(folder / "data.nc", mesh=folder / "grid.nc"))


class Ocean(unittest.TestCase):
    def plotted(self, dataset, *names, **options):
        plotter = dataset.nephoscope.plot(*names, screenshot=str(OUTPUT), window_size=(200, 200), **options)
        self.addCleanup(plotter.close)
        return plotter, pyvista.read(OUTPUT)["PNGImage"].reshape(200, 200, -1)[..., :3].astype(float)

    def shown(self, plotter, picture, point):
        """The colour of the picture where a point of the scene is."""
        matrix = pyvista.array_from_vtkmatrix(plotter.camera.GetCompositeProjectionTransformMatrix(1, -1, 1))
        x, y, _, w = matrix @ [*point, 1]
        return picture[int(100 + 100 * y / w), int(100 + 100 * x / w)]

    def colour(self, plotter, value):
        colour = [0.0] * 3
        plotter.mapper.lookup_table.GetColor(value, colour)
        return 255 * np.array(colour)

    def test_water_is_opaque_and_seen_from_aside(self):
        """The surface has the colour of its temperature, and so has the deep water at the southern side."""
        plotter, picture = self.plotted(ocean(layers()))
        vertical = frames(-30.0, 30.0)[2]
        towards = np.array(plotter.camera.position) - plotter.camera.focal_point
        height = np.degrees(np.arcsin(towards @ vertical / np.linalg.norm(towards)))
        self.assertTrue(35 < height < 60, height)
        np.testing.assert_allclose(self.shown(plotter, picture, 6371000 * vertical), self.colour(plotter, 20), atol=4)
        stretch = float(plotter.mapper.dataset.field_data["VerticalExaggeration"][0])
        self.assertTrue(0.05 < stretch * 3000 / 2.0e6 < 0.3, stretch)
        np.testing.assert_allclose(self.shown(plotter, picture, (6371000 - 2000 * stretch) * frames(-30.0, 20.0)[2]), self.colour(plotter, 6), atol=12)
        given, _ = self.plotted(ocean(layers()), opacity="linear", view=(-30, 30), vertical_exaggeration=30)
        self.assertEqual(given.mapper.dataset.field_data["VerticalExaggeration"][0], 30)
        self.assertEqual(given.renderer.actors[next(name for name, one in given.renderer.actors.items() if isinstance(one, pyvista.Volume))].prop.GetScalarOpacity().GetValue(4.0), 0)

    def test_the_water_is_in_the_middle_of_the_picture(self):
        """A coast in the west or in the east: the picture is that of the water."""
        wet = np.where(LON < -30, np.nan, 0) + layers() + 0 * LAT[:, None]
        for land, east in ((wet, 1), (wet[..., ::-1], -1)):
            plotter, _ = self.plotted(ocean(land))
            eastward = frames(-30.0, 30.0)[0]
            self.assertGreater(east * (np.array(plotter.camera.focal_point) @ eastward), 2e5)

    def test_currents_and_salinity(self):
        for name, standard, value in (("so", "sea_water_salinity", 35.0), ("uo", "eastward_sea_water_velocity", 0.5)):
            plotter, picture = self.plotted(ocean(value * layers(1.0, 0.2), name, standard), name)
            np.testing.assert_allclose(self.shown(plotter, picture, 6371000 * frames(-30.0, 30.0)[2]), self.colour(plotter, value), atol=4)

    def test_a_plume_in_the_sea_stays_transparent(self):
        oil = np.zeros((len(DEPTHS), len(LAT), len(LON)))
        oil[1:3, 5, 5] = 1.0
        plotter, _ = self.plotted(ocean(oil, "oil", "mass_concentration_of_oil_in_sea_water", units="kg m-3"))
        volume = next(one for one in plotter.renderer.actors.values() if isinstance(one, pyvista.Volume))
        self.assertEqual(volume.prop.GetScalarOpacity().GetValue(0.0), 0)

    def test_air_is_neither_opaque_nor_seen_from_aside(self):
        air = ocean(layers(), "hus", "specific_humidity", units="g/kg").assign_coords(depth=("depth", DEPTHS, {"units": "m", "positive": "up", "standard_name": "altitude"}))
        plotter, _ = self.plotted(air)
        towards = np.array(plotter.camera.position) - plotter.camera.focal_point
        self.assertGreater(towards @ frames(-30.0, 30.0)[2], 0.99 * np.linalg.norm(towards))
        volume = next(one for one in plotter.renderer.actors.values() if isinstance(one, pyvista.Volume))
        self.assertLess(volume.prop.GetScalarOpacity().GetValue(12.0), 0.5)

    def test_levels_that_follow_the_bottom(self):
        """Depths are plausible, with tides above the sea level too; those of another unit are not."""
        own = roms()
        heights = xr.apply_ufunc(lambda s: s, own.s_rho) * own.h
        listed = roms().drop_vars(["h", "zeta", "hc", "Cs_r"]).assign_coords(z_rho=(("s_rho", "eta_rho", "xi_rho"), heights.values, {"units": "m"}))
        del listed.s_rho.attrs["standard_name"], listed.s_rho.attrs["formula_terms"], listed.s_rho.attrs["positive"]
        for data in (own, listed):
            with warnings.catch_warnings():
                warnings.simplefilter("error")
                plotter, picture = self.plotted(data, "temp")
            surface = np.asarray(plotter.mapper.dataset.points).reshape(8, 11, 12, 3)[-1, 5, 6]
            self.assertLess(np.abs(self.shown(plotter, picture, surface) - self.colour(plotter, 19.375)).max(), 12)
        with self.assertWarnsRegex(RuntimeWarning, "implausible"):
            roms(160000.0).nephoscope.globe()

    def test_terms_by_their_usual_names(self):
        """ROMS without formula_terms, by Vtransform."""
        for number in (1, 2):
            own = roms()
            own.s_rho.attrs["standard_name"] = f"ocean_s_coordinate_g{number}"
            bare = own.assign(Vtransform=number)
            bare.s_rho.attrs.clear()
            np.testing.assert_array_equal(bare.nephoscope.globe()["Height"], own.nephoscope.globe()["Height"])
        with self.assertRaisesRegex(ValueError, "heights of the levels 's_rho'"):
            bare.drop_vars("Vtransform").nephoscope.globe()

    def test_masks_of_models(self):
        """Land of ROMS, where the mask is 0, is missing in fields, and is placed as before."""
        mask = np.ones((11, 12))
        mask[:, :3] = 0
        data = roms().assign(mask_rho=(("eta_rho", "xi_rho"), mask))
        grid = data.nephoscope.globe()
        np.testing.assert_array_equal(np.isnan(np.asarray(grid["temp"]).reshape(8, 11, 12)), np.broadcast_to(mask == 0, (8, 11, 12)))
        np.testing.assert_array_equal(grid["Height"], roms().nephoscope.globe()["Height"])
        self.assertIn("land is where 'mask_rho' is 0", data.nephoscope.describe())

    def test_places_that_are_missing_need_no_advice(self):
        lon, lat = np.meshgrid(LON, LAT)
        lon[2, 3] = lat[2, 3] = np.nan
        data = xr.Dataset({"tos": (("y", "x"), 0 * LAT[:, None] + LON, {"units": "degC"})}, {"lon": (("y", "x"), lon, {"units": "degrees_east"}), "lat": (("y", "x"), lat, {"units": "degrees_north"})})
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            self.assertEqual((np.asarray(data.nephoscope.globe().point_data["vtkGhostType"]) != 0).sum(), 1)


class Zeros(unittest.TestCase):
    """NEMO's zeros on land and below the bottom."""

    def values(self):
        values = np.broadcast_to(layers(), (len(DEPTHS), len(LAT), len(LON))) + np.linspace(-5, 3, len(LAT))[:, None]  # from -1: 0 is among them
        values = values + 1e-3 * np.random.default_rng(0).random(values.shape)
        land = np.zeros(values.shape, bool)
        land[:, :4, :3] = True
        land[3:, 8:] = True
        return np.where(land, 0.0, values), land

    def test_are_missing_and_told(self):
        values, land = self.values()
        for name, standard in (("thetao", "sea_water_potential_temperature"), ("so", "sea_water_salinity"), ("uo", "eastward_sea_water_velocity"), ("votemper", "")):
            for data in (ocean(values, name, standard), ocean(values, name, standard).isel(depth=slice(None, None, -1))):
                with self.subTest(name), self.assertWarnsRegex(UserWarning, f"'{name}': {land.sum()} values of exactly 0.*declare a fill value"):
                    grid = data.nephoscope.globe()
                np.testing.assert_array_equal(np.isnan(np.asarray(grid[name]).reshape(land.shape)), land[::-1])
                self.assertIn(f"note: '{name}': {land.sum()} values of exactly 0", data.nephoscope.describe())

    def test_of_one_level(self):
        values, land = self.values()
        for name, told in (("tos", land[0]), ("sos", land[0])):
            data = ocean(values, name, "sea_surface_temperature").isel(depth=0, drop=True)
            with self.assertWarns(UserWarning):
                grid = data.nephoscope.globe()
            np.testing.assert_array_equal(np.isnan(np.asarray(grid[name]).reshape(told.shape)), told)

    def test_that_are_values(self):
        """Zeros of the air, of tracers, in the middle of a column, on no land, and with a fill value that is declared."""
        values, land = self.values()
        floating = values.copy()
        floating[1, 9, 9] = 0
        nowhere = np.where(land & (np.arange(len(DEPTHS)) > 2)[:, None, None], 0.0, values + 30)
        declared = ocean(values)
        declared.thetao.attrs["_FillValue"] = 1e20
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            for data in (ocean(values, "ta", "air_temperature"), ocean(values, "oil", "mass_concentration_of_oil_in_sea_water"), ocean(floating), ocean(nowhere), declared):
                name = next(iter(data.data_vars))
                self.assertFalse(np.isnan(data.nephoscope.globe()[name]).any(), name)


class Skewed(unittest.TestCase):
    """A few values far from the others do not take the colours of these, and the scalar bar tells how many there are."""

    def values(self):
        """From 34 to 36, but fresh where rivers end: 3 of 121 places."""
        values = 34 + (LAT[:, None] - 20) / 10 + 0 * LON
        values[5, :3] = 5, 10, 2
        return values

    def bar(self, data, *names, **options):
        plotter = data.nephoscope.plot(*names, screenshot=str(OUTPUT), window_size=(200, 200), **options)
        self.addCleanup(plotter.close)
        (bar,) = plotter.scalar_bars.values()
        return bar.GetLookupTable().GetRange(), bar.GetTitle().split("\n")

    def test_salinity(self):
        surface = xr.Dataset({"sos": (("lat", "lon"), self.values(), {"standard_name": "sea_surface_salinity", "units": "psu"})}, PLACES)
        water = ocean(self.values(), "so", "sea_water_salinity", units="psu")
        for data, share in ((surface, "2.5 %"), (water, "2.5 %"), (water.isel(lon=1), "9.1 %")):
            with self.subTest(dict(data.sizes)):
                limits, title = self.bar(data)
                if share == "9.1 %":  # of more than 5 % on one side, all have colours
                    self.assertAlmostEqual(limits[0], 10)
                    continue
                np.testing.assert_allclose(limits, (34, 36), atol=1e-4)
                self.assertEqual(title[-1], f"{share} beyond")
        limits, title = self.bar(surface, projection="map")
        self.assertIn("[psu], 2.5 % beyond", title[0])

    def test_ranges_that_stay(self):
        spread = 34 + (LAT[:, None] - 20) / 10 + 0 * LON
        spot = np.exp(-((LON + 30) ** 2 + (LAT[:, None] - 30) ** 2) / 8)
        for values, options, expected in ((spread, {}, (34, 36)), (spot, {}, (spot.min(), 1)), (self.values(), {"clim": (0, 40)}, (0, 40)), (self.values(), {"log_scale": True}, (2, 36))):
            limits, title = self.bar(xr.Dataset({"field": (("lat", "lon"), values)}, PLACES), **options)
            np.testing.assert_allclose(limits, expected, atol=1e-4)
            self.assertNotIn("beyond", "".join(title))

    def test_of_films(self):
        """The range of all steps, of which the second has the fresh water."""
        data = xr.Dataset({"sos": (("time", "lat", "lon"), np.stack([np.maximum(self.values(), 34), self.values()]))}, {"time": np.array(["2020-01-01", "2020-01-02"], "M8[ns]"), **PLACES})
        plotter = pyvista.Plotter(off_screen=True, window_size=(300, 300))
        self.addCleanup(plotter.close)
        nephoscope.animate(plotter, data, "sos")
        (bar,) = plotter.scalar_bars.values()
        self.assertGreater(bar.GetLookupTable().GetRange()[0], 30)
        self.assertRegex(bar.GetTitle(), "[12]([.][0-9])? % beyond")


class Sheer(unittest.TestCase):
    """Fields of one level that are zero almost everywhere show the ground there."""

    def plotted(self, values, name="field", **attrs):
        data = xr.Dataset({name: (("lat", "lon"), values, attrs)}, PLACES)
        plotter = data.nephoscope.plot(name, screenshot=str(OUTPUT), window_size=(100, 100))
        self.addCleanup(plotter.close)
        return plotter.mapper.lookup_table

    def test_zero_is_transparent(self):
        spot = np.exp(-((LON + 30) ** 2 + (LAT[:, None] - 30) ** 2) / 8)
        for values, name, attrs, opaque in ((spot, "something", {}, False), (spot - 0.5, "something", {}, True), (spot + 1, "something", {}, True), (np.where(spot > 0.5, 56, 1), "basin", {}, True), (spot, "cover", {"flag_values": [0, 1]}, True), (1 - spot, "something", {}, True),
                                            (0.3 + spot, "od550aer", {"long_name": "Aerosol Optical Thickness at 550 nm"}, False),
                                            (0.3 + spot, "x", {"standard_name": "atmosphere_optical_thickness_due_to_cloud"}, False),
                                            (0.3 + spot, "y", {"long_name": "thickness of the cloud layer"}, True)):
            with self.subTest(name, attrs=attrs):
                table = self.plotted(values, name, **attrs)
                self.assertEqual(table.values[0, 3], 255 if opaque else 0)
                self.assertEqual(table.values[-1, 3], 255)

    def test_zero_is_transparent_with_a_list_of_colours(self):
        spot = np.exp(-((LON + 30) ** 2 + (LAT[:, None] - 30) ** 2) / 8)
        data = xr.Dataset({"field": (("lat", "lon"), spot)}, PLACES)
        for colours in (["blue", "red"], ["blue", "green", "red"]):
            plotter = data.nephoscope.plot("field", cmap=colours, screenshot=str(OUTPUT), window_size=(100, 100))
            self.addCleanup(plotter.close)
            table = plotter.mapper.lookup_table.values
            self.assertEqual((table[0, 3], table[-1, 3]), (0, 255))

    def test_the_near_side_hides_the_far_one(self):
        """Also where the ground below wide cells does not, and with values missing elsewhere."""
        longitudes, latitudes = np.arange(-180, 180, 20.0), np.arange(-80, 81, 20.0)
        near = np.where(np.abs(longitudes) < 90, 1.0, 0.0) * np.ones((len(latitudes), 1))
        near[-1, 9] = np.nan
        data = xr.Dataset({"field": (("lat", "lon"), near)}, {"lat": ("lat", latitudes, {"units": "degrees_north"}), "lon": ("lon", longitudes, {"units": "degrees_east"})})
        plotter = data.nephoscope.plot("field", screenshot=str(OUTPUT), window_size=(200, 200), view=(0, 0), cmap=["blue", "red"], background="black")
        self.addCleanup(plotter.close)
        picture = pyvista.read(OUTPUT)["PNGImage"].reshape(200, 200, -1)[..., :3].astype(int)
        below = picture[:150, :148]  # without the bar and the pole
        self.assertGreater((below[..., 0] > 200).sum(), 8000)
        self.assertEqual((below[..., 2] > 100).sum(), 0)

    def test_the_near_side_hides_the_far_one_in_films(self):
        """Beside the ground, which is lower than wide cells, where the near side is missing; rows northward or southward."""
        longitudes, latitudes = np.arange(0, 360, 15.0), np.arange(-82.5, 90, 15.0)
        field = np.where((longitudes < 90) | (longitudes > 270), 2.0, 1.0) * np.ones((len(latitudes), 1))
        field[(np.abs(latitudes) > 25)[:, None] & (field == 2)] = np.nan
        data = xr.Dataset({"field": (("time", "lat", "lon"), np.stack([field, field]))}, {"time": np.array(["2020-01-01", "2020-01-02"], "M8[ns]"),
                          "lat": ("lat", latitudes, {"units": "degrees_north"}), "lon": ("lon", longitudes, {"units": "degrees_east"})})
        for turned in (data, data.isel(lat=slice(None, None, -1))):
            plotter = pyvista.Plotter(off_screen=True, window_size=(300, 300))
            self.addCleanup(plotter.close)
            nephoscope.animate(plotter, turned, "field", cmap=["blue", "red"])
            plotter.camera_position = [(3.2e7, 0, 0), (0, 0, 0), (0, 0, 1)]
            plotter.remove_scalar_bar()
            picture = plotter.screenshot(return_img=True)[60:].astype(int)
            self.assertGreater((picture[..., 0] > 200).sum(), 5000)
            self.assertEqual(((picture[..., 2] > 80) & (picture[..., 1] < 25)).sum(), 0)  # blue, not the sea of the ground

    def test_aerosol_has_not_the_colour_of_deserts(self):
        table = self.plotted(0.3 + np.random.default_rng(0).random((len(LAT), len(LON))), "aod")
        self.assertGreater(np.ptp(table.values[-1, :3].astype(int)), 100)

    def test_films_have_the_labels_of_all_steps(self):
        """The first step has values from 0 to 1e-3 of the last."""
        growth = np.array([1e-3, 1.0])[:, None, None] * (1 + np.random.default_rng(0).random((2, len(LAT), len(LON))))
        for attrs in ({}, {"standard_name": "air_temperature", "units": "K"}, {"standard_name": "specific_humidity", "units": "kg kg-1"}):
            data = xr.Dataset({"field": (("time", "lat", "lon"), growth, attrs)}, {"time": np.array(["2020-01-01", "2020-01-02"], "M8[ns]"), **PLACES})
            plotter = pyvista.Plotter(off_screen=True, window_size=(300, 300))
            self.addCleanup(plotter.close)
            series = nephoscope.animate(plotter, data, "field")
            (bar,) = plotter.scalar_bars.values()
            self.assertAlmostEqual(bar.GetLookupTable().GetRange()[1], series.range("field")[1], places=5)
            self.assertLess(len(bar.GetLabelFormat() % growth.max()), 6, bar.GetLabelFormat())


if __name__ == "__main__":
    unittest.main()
