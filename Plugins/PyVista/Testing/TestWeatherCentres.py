# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Layouts of single centres and models: heights, winds and hidden points against closed forms."""
import tempfile
import unittest
import warnings
from pathlib import Path

import nephoscope
import numpy as np
import xarray as xr
from weather_data import GRAVITY, LAMBERT, REGULAR, isothermal, write_grib

LON, LAT = np.arange(0, 40, 5.0), np.arange(20, 60, 5.0)
SHAPE = (LAT.size, LON.size)


def on_levels(dim, values, fields, attributes=None, **ground):
    """Fields {name: (values of the levels, attributes)}, the same at all places, and fields at the ground."""
    size = len(values)
    arrays = {name: ((dim, "lat", "lon"), np.broadcast_to(np.reshape(np.asarray(field, float), (-1, 1, 1)), (size, *SHAPE)).copy(), about) for name, (field, about) in fields.items()}
    arrays |= {name: (("lat", "lon"), np.full(SHAPE, float(value)), about) for name, (value, about) in ground.items()}
    return xr.Dataset(arrays, {dim: (dim, np.array(values, float), attributes or {}), "lat": ("lat", LAT, {"units": "degrees_north"}), "lon": ("lon", LON, {"units": "degrees_east"})})


def heights(dataset, **options):
    return np.unique(np.asarray(dataset.nephoscope.globe(mask_below_ground=False, **options)["Height"]))


def written(dataset):
    return dataset.nephoscope.describe()


class Centres(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def test_fields_at_the_ground_on_levels_of_their_own(self):
        """As AROME of MET Norway: (hybrid, ensemble_member, y, x) and (height0, ensemble_member, y, x)."""
        b = np.array([0.2, 0.6, 0.99])
        model = on_levels("hybrid", b, {"air_temperature_ml": (250.0, {"standard_name": "air_temperature", "units": "K"})}, {
            "standard_name": "atmosphere_hybrid_sigma_pressure_coordinate", "formula_terms": "ap: ap b: b ps: surface_air_pressure", "positive": "down"})
        model["ap"], model["b"] = ("hybrid", [1e3, 1e3, 0.0]), ("hybrid", b)
        for name, value, units in (("surface_air_pressure", 1e5, "Pa"), ("surface_geopotential", 300 * GRAVITY, "m^2/s^2")):
            model[name] = ("height0", "lat", "lon"), np.full((1, *SHAPE), value), {"standard_name": name, "units": units}
        model = model.assign_coords(height0=("height0", [0.0], {"units": "m", "positive": "up"})).expand_dims(ensemble_member=[0])
        with warnings.catch_warnings():
            warnings.simplefilter("error")  # one member is no choice
            found = heights(model)
        up = 300 + 287.05 * 250 / GRAVITY * np.log(1e5 / (np.array([1e3, 1e3, 0]) + b * 1e5))
        np.testing.assert_allclose(found, np.sort(6371229.0 * up / (6371229.0 - up)), rtol=2e-5)

    def test_a_level_of_pressure_is_no_ground(self):
        one = isothermal(LON, LAT).assign(z=(("level", "lat", "lon"), np.full((1, *SHAPE), 5e4), {"standard_name": "geopotential", "units": "m2 s-2"})).drop_vars("orog")
        one = one.assign_coords(level=("level", [500.0], {"units": "hPa"}))
        self.assertNotIn("geopotential of the ground", written(one))

    def test_formula_terms_with_errors(self):
        """CESM2 writes hybrid levels in hPa with formula_terms at the bounds alone, and GFDL "formula_term"; neither a nor ap is a pressure axis."""
        a, b = np.array([0.0, 0.1]), np.array([0.9, 0.2])
        fields, ground = {"cl": (0.5, {"units": "%"}), "ta": (250.0, {"units": "K"})}, {"ps": (6e4, {"units": "Pa"}), "orog": (4000.0, {"units": "m"})}
        cesm = on_levels("lev", [900, 300], fields, {"units": "hPa", "positive": "down"}, **ground).assign(a=("lev", a), b=("lev", b), p0=((), 1e5, {"units": "Pa"}))
        gfdl = on_levels("lev", [1, 2], fields, {"standard_name": "atmosphere_hybrid_sigma_pressure_coordinate", "formula_term": "ap: ap b: b ps: ps", "units": "1"}, **ground)
        gfdl = gfdl.assign(ap=("lev", a * 1e5, {"units": "Pa"}), b=("lev", b))
        z = 6371229.0 * 4000 / (6371229.0 + 4000) + 287.05 * 250 / GRAVITY * np.log(6e4 / (a * 1e5 + b * 6e4))
        other = gfdl.rename(ps="at_the_ground").drop_attrs(deep=False)
        del other["at_the_ground"].attrs["units"]
        other["lev"].attrs |= {"formula_terms": "ap: ap b: b ps: at_the_ground"}
        for model in (cesm, gfdl, other):
            np.testing.assert_allclose(heights(model), 6371229.0 * z / (6371229.0 - z), rtol=1e-4)

    def test_bounds_of_terms_are_no_fields(self):
        b = np.array([0.9, 0.2])
        model = on_levels("lev", b, {"cl": (0.5, {"units": "%"})}, {"standard_name": "atmosphere_hybrid_height_coordinate", "formula_terms": "a: a b: b orog: orog", "bounds": "lev_bnds"}, orog=(100.0, {"units": "m"}))
        model = model.assign(a=("lev", [10.0, 5000]), b=("lev", b), **{name: (("lev", "two"), np.ones((2, 2))) for name in ("lev_bnds", "first", "second")}).isel(lat=slice(3), lon=slice(3))
        model["lev_bnds"].attrs["formula_terms"] = "a: first b: second orog: orog"
        np.testing.assert_allclose(heights(model), [100, 5020], rtol=1e-6)

    def test_thickness_of_layers(self):
        """As FV3 writes it, from the top, with reference pressures as its coordinate; as MERRA-2, with pressures only; and both from the bottom."""
        dz, dp = np.array([-4000.0, -1000, -200]), np.array([10000.0, 20000, 30000])
        levels = {"long_name": "ref full pressure level", "units": "mb", "positive": "down"}
        about = {"tmp": (250.0, {"units": "K"}), "delz": (dz, {"units": "m"}), "dpres": (dp, {"units": "pa"})}
        ground = {"hgtsfc": (500.0, {"units": "gpm"}), "pressfc": (6.1e4, {"units": "pa"})}
        model = on_levels("pfull", [100, 300, 700], about, levels, **ground).rename(hgtsfc="orog")
        for take in (slice(None), slice(None, None, -1)):
            np.testing.assert_allclose(heights(model.isel(pfull=take)), [600, 1200, 3700], rtol=1e-6)
            self.assertIn("from the layers' thickness 'delz'", written(model))
        pressures = np.array([6.1e4 - 15000, 6.1e4 - 40000, 6.1e4 - 55000])
        z = 500 + 287.05 * 250 / GRAVITY * np.log(6.1e4 / pressures)
        for take in (slice(None), slice(None, None, -1)):
            np.testing.assert_allclose(heights(model.drop_vars("delz").isel(pfull=take)), 6371229.0 * z / (6371229.0 - z), rtol=1e-4)
        bare = model.drop_vars(["delz", "pressfc", "orog", "tmp"]).assign(cld_amt=model.tmp * 0)
        self.assertIn("pressure summed over the layers, from 0 Pa at the top", written(bare))

    def test_variables_that_a_description_names(self):
        """As RAQMS writes them: levels from the top, numbered by values without attributes, layers that are thicker upwards, and names that only the description explains."""
        names = {"delp": ([3000.0, 2000, 1700], "delta pressure", "mb"), "pdash": ([91000.0, 94000, 96000], "pressure", "mb"), "geop": ([900.0, 600, 400], "geopotential height", "m"), "x": (1e-8, "o3 volume mixing ratio", "ppv")}
        model = on_levels("lev", [233.2, 228.4, 223.6], {name: (np.array(values) / (100 if units == "mb" else 1), {"description": told, "units": units}) for name, (values, told, units) in names.items()}, {}, psfc=(97850.0, {"units": "Pa"}))
        np.testing.assert_allclose(heights(model), 6371229.0 * np.array([400, 600, 900]) / (6371229.0 - np.array([400, 600, 900])), rtol=1e-4)
        self.assertIn("pressure: 'pdash'", written(model))
        for key in ("long_name", "desc", "title"):
            other = model.copy()
            other["geop"].attrs = {key: "Geopotential_Height", "units": "m"}
            self.assertIn("geopotential height: 'geop'", written(other))
        other["geop"].attrs["units"] = "kg"
        self.assertNotIn("'geop'", written(other))

    def test_levels_of_metgrid(self):
        """The input of WRF has numbered levels, heights GHT in m and pressures PRES without units."""
        model = on_levels("num_metgrid_levels", [0, 1, 2], {"PRES": ([1e5, 9e4, 7e4], {"units": "", "description": ""}), "GHT": ([100.0, 900, 3000], {"units": "m", "description": "Height"}), "TT": (280.0, {"units": "K", "description": "Temperature"})})
        for data in (model, model.drop_vars("num_metgrid_levels"), model.rename(num_metgrid_levels="levels_of_mine").drop_vars("levels_of_mine")):
            np.testing.assert_allclose(heights(data), 6371229.0 * np.array([100, 900, 3000.0]) / (6371229.0 - np.array([100, 900, 3000.0])), rtol=1e-5)
            self.assertIn("pressure: 'PRES'", written(data))
            self.assertIn("temperature: 'TT' (K)", written(data))

    def test_order_of_summed_layers(self):
        """Heights or the axis give it. If the layers differ little, a warning tells that it is a guess, at the line of the user."""
        dp = {"delp": ([3000.0, 2000, 1700], {"units": "Pa"}), "geop": ([900.0, 600, 400], {"units": "gpm", "long_name": "geopotential height"}), "x": (1.0, {"units": "1"})}
        model = on_levels("lev", [233.2, 228.4, 223.6], dp, {}, psfc=(97850.0, {"units": "Pa"}))
        pressure = lambda data, **roles: data.nephoscope._understood(0, None, roles)[1].pressure[:, 0, 0]  # noqa: E731
        right = 97850 - np.array([5200.0, 2700, 850])
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            np.testing.assert_allclose(pressure(model), right)
            np.testing.assert_allclose(pressure(model.drop_vars("geop").assign_coords(lev=("lev", range(3), {"positive": "down"}))), right)
            np.testing.assert_allclose(pressure(model.drop_vars("geop").assign_coords(lev=("lev", range(3), {"positive": "up"}))), 97850 - np.array([1500.0, 4000, 5850]))
        with self.assertWarnsRegex(UserWarning, r"'delp': its layers are summed with the last one uppermost, which is a guess .* ds.assign_coords\(lev=\('lev', range\(3\), \{'positive': 'down'\}\)\)") as told:
            pressure(model.drop_vars("geop"))
        self.assertEqual(told.filename, __file__)

    def test_heights_of_merra(self):
        model = on_levels("lev", [1, 2, 3], {"H": ([9000, 3000, 100], {"units": "m", "standard_name": "mid_layer_heights"}), "QL": (1e-4, {"units": "kg kg-1", "standard_name": "mass_fraction_of_cloud_liquid_water"})},
                          {"units": "layer", "positive": "down", "standard_name": "model_layers"})
        np.testing.assert_allclose(heights(model), [100, 3000, 9000])
        self.assertIn("cloud liquid water: 'QL'", written(model))

    def test_levels_that_only_count(self):
        """ICON's levels are called heights, and are numbers."""
        for attributes in ({"standard_name": "height", "long_name": "generalized_height", "units": "m"}, {"standard_name": "height"}):
            model = on_levels("height", [1, 2, 3, 4], {"temp": (250.0, {"units": "K"})}, {**attributes, "axis": "Z"})
            with self.assertRaisesRegex(ValueError, "heights of the levels 'height' .levels. were not found"):
                model.nephoscope.globe()
            model["z_mc"] = model.temp.dims, np.broadcast_to(np.reshape([9000.0, 4000, 1000, 100], (-1, 1, 1)), model.temp.shape), {"units": "m", "standard_name": "altitude"}
            np.testing.assert_allclose(heights(model), [100, 1000, 4000, 9000])
        mast = on_levels("height", [10, 20, 50], {"temp": (250.0, {"units": "K"})}, {"standard_name": "height", "units": "m"})
        np.testing.assert_allclose(heights(mast), [10, 20, 50])

    def test_levels_of_ocean_models(self):
        s, c, h, zeta, hc = np.array([-0.9, -0.5, -0.1]), np.array([-0.8, -0.3, -0.02]), 1000.0, 1.5, 200.0
        forms = {"ocean_sigma_coordinate": ("sigma: s eta: zeta depth: h", zeta + s * (h + zeta)),
                 "ocean_s_coordinate_g1": ("s: s C: C eta: zeta depth: h depth_c: hc", (rest := hc * s + (h - hc) * c) + zeta * (1 + rest / h)),
                 "ocean_s_coordinate_g2": ("s: s C: C eta: zeta depth: h depth_c: hc", zeta + (zeta + h) * (hc * s + h * c) / (hc + h))}
        for name, (terms, expected) in forms.items():
            sea = on_levels("s", s, {"temp": (10.0, {"units": "Celsius"})}, {"standard_name": name, "formula_terms": terms}, h=(h, {"units": "meter"}), zeta=(zeta, {"units": "meter"}))
            sea = sea.assign(C=("s", c), hc=hc)
            with self.subTest(name):
                np.testing.assert_allclose(heights(sea), np.sort(expected), rtol=1e-5)
                self.assertNotIn("vtkGhostType", sea.nephoscope.globe().array_names)
        with self.assertRaisesRegex(ValueError, "not in the dataset: depth"):
            sea.drop_vars("h").nephoscope.globe()

    def test_currents_between_the_centres(self):
        """ROMS' u lies between the centres, in one column fewer; its directions are those of the rows, which here run north."""
        lat, lon = np.meshgrid(LAT, LON)
        places = ("eta_rho", "xi_rho")
        sea = xr.Dataset({"temp": (("s_rho", *places), np.ones((2, 8, 8)), {"units": "Celsius"}), "u": (("s_rho", "eta_rho", "xi_u"), np.broadcast_to(np.arange(7.0), (2, 8, 7)), {"units": "m/s"}),
                          "v": (("s_rho", "eta_v", "xi_rho"), np.zeros((2, 7, 8)), {"units": "m/s"})}, {"s_rho": ("s_rho", [10.0, 100.0], {"units": "m", "positive": "down"}),
                                                                                                       "lat_rho": (places, lat), "lon_rho": (places, lon)})
        grid = sea.nephoscope.globe()
        np.testing.assert_allclose(np.asarray(grid["v"]).reshape(2, 8, 8)[1, 3], [0, 0.5, 1.5, 2.5, 3.5, 4.5, 5.5, 6], atol=1e-5)
        np.testing.assert_allclose(grid["u"], 0, atol=1e-5)

    def test_fill_values_that_are_not_declared(self):
        for fill in (-9999.0, -999.0, -32767.0):
            dataset = isothermal(LON, LAT)
            dataset["ta"][1, 2, 3] = fill
            grid = dataset.nephoscope.globe()
            self.assertEqual((np.isnan(grid["ta"]).sum(), np.nanmin(grid["ta"])), (1, 250))
            self.assertGreater(np.nanmin(grid["Height"]), 0)
            self.assertIn(f"'ta': 1 values of {fill:g} are taken as missing", written(dataset))
        deep = on_levels("z", [0, 1000], {"topography": (-9999.0, {"units": "m"})}, {"units": "m", "positive": "up"})
        np.testing.assert_allclose(deep.nephoscope.globe()["topography"], -9999)

    def test_a_level_without_wind_is_drawn(self):
        levels = ((850, 1500), (700, 3000), (500, 5500))
        fields = [("t", "isobaricInhPa", p, 250.0) for p, _ in levels] + [("gh", "isobaricInhPa", p, z) for p, z in levels]
        fields += [(name, "isobaricInhPa", p, 5.0) for name in "uv" for p in (850, 500)]
        write_grib(path := self.folder / "levels.grib2", fields, REGULAR)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            grid = nephoscope.open(path).nephoscope.globe()
        self.assertNotIn("vtkGhostType", grid.array_names)
        for name in ("u", "Wind", "DisplayVelocity"):
            missing = np.isnan(np.asarray(grid[name]).reshape(3, grid.n_points // 3, -1)).any(-1)
            self.assertEqual(missing.all(1).tolist(), [False, True, False])
            self.assertFalse(missing[[0, 2]].any())

    def test_damaged_netcdf(self):
        isothermal(LON, LAT).to_netcdf(path := self.folder / "part.nc")
        path.write_bytes(path.read_bytes()[:2000])
        with self.assertRaisesRegex(ValueError, "part.nc cannot be read, probably because it is incomplete or damaged.*Fetch it again"):
            nephoscope.open(path)


class Grib(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = Path(folder.name, "file.grib2")

    def test_the_same_points_under_two_headers(self):
        write_grib(self.path, [("t", "isobaricInhPa", p, 250.0) for p in (850, 500)], REGULAR)
        write_grib(self.path, [("sp", "surface", 0, 1e5)], {**REGULAR, "shapeOfTheEarth": 6}, mode="ab")
        self.assertEqual({"t", "sp"} - set(nephoscope.open(self.path)), set())
        write_grib(self.path, [("sp", "surface", 0, 1e5)], {**REGULAR, "latitudeOfFirstGridPointInDegrees": 79}, mode="ab")
        with self.assertRaisesRegex(ValueError, "fields on 2 grids"):
            nephoscope.open(self.path)

    def test_rows_of_alternating_direction(self):
        """The value is the longitude; the message has every other row from its end, as the WMO's scanning mode 16 says."""
        lat, lon = write_grib(self.path, [("2t", "heightAboveGround", 2, 0.0)], LAMBERT)
        rows = lon.reshape(40, 60).copy()
        rows[1::2] = rows[1::2, ::-1]
        write_grib(self.path, [("2t", "heightAboveGround", 2, rows)], {**LAMBERT, "alternativeRowScanning": 1})
        opened = nephoscope.open(self.path)
        np.testing.assert_allclose(opened.t2m, opened.longitude, atol=1e-3)
        np.testing.assert_allclose(opened.longitude.values.ravel(), lon)

    def test_hybrid_heights_by_the_list_in_the_header(self):
        """Level k has the k-th entry of each half of the list."""
        a, b = np.array([0.0, 100, 1000, 9000]), np.array([1, 0.9, 0.5, 0.0])
        write_grib(self.path, [("t", "hybridHeight", k, 250.0, {"PVPresent": 1, "pv": np.concatenate([a, b])}) for k in (1, 2, 3)] + [("orog", "surface", 0, 200.0)], REGULAR)
        np.testing.assert_allclose(heights(nephoscope.open(self.path)), (a + b * 200)[1:], rtol=1e-5)


if __name__ == "__main__":
    unittest.main()
