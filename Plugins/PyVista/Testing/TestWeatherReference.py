# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Heights and derived quantities against MetPy 1.7.1, whose numbers metpy_reference.py prints, and turned winds against an independent formula."""
import tempfile
import unittest
from pathlib import Path

import nephoscope
import numpy as np
import xarray as xr
from weather_data import frames, isothermal, write_grib

PRESSURES = np.array([100000.0, 85000, 70000, 50000, 30000])
TEMPERATURES = [295.0, 287, 278, 258, 230]
HUMIDITIES = [0.014, 0.009, 0.0045, 0.0012, 0.0001]
METPY = {"thickness": [1394.0045754449393, 3006.0972283865603, 5650.240690286826, 9300.094399996822],
         "relative_humidity": [0.8532930378358371, 0.7736966139833792, 0.58550658904503, 0.5102695810177938, 0.3536623083816774],
         "potential_temperature": [295.0, 300.6407996887241, 307.82401522363887, 314.50552278475465, 324.430565268998],
         "equivalent_potential_temperature": [335.82465475072553, 327.6434330769292, 322.033958790034, 318.64486126170385, 324.8418134477319],
         "vorticity": [2.5394133544265596e-06, 2.49638413030822e-06, 4.2628359151508956e-06]}
EARTH = 6371229.0


def sounding():
    dataset = isothermal(np.arange(0, 20, 5.0), np.arange(20, 40, 5.0), PRESSURES, ground=0.0, surface_pressure=1e5)
    column = lambda values: np.reshape(values, (-1, 1, 1)) * np.ones(dataset.ta.shape)
    return dataset.assign(ta=(dataset.ta.dims, column(TEMPERATURES), dataset.ta.attrs), hus=(dataset.ta.dims, column(HUMIDITIES), {"standard_name": "specific_humidity", "units": "kg kg-1"}))


def hybrid():
    """The same air on hybrid levels, p = ap + b ps."""
    share = np.array([1.0, 0.8, 0.5, 0.2, 0.0])
    dataset = sounding().drop_vars("plev").rename(plev="lev")
    dataset["lev"] = ("lev", share, {"standard_name": "atmosphere_hybrid_sigma_pressure_coordinate", "formula_terms": "ap: ap b: b ps: ps"})
    return dataset.assign(ap=("lev", PRESSURES - share * 1e5, {"units": "Pa"}), b=("lev", share))


def column(dataset, name, **options):
    grid = dataset.nephoscope.globe(**options)
    return np.asarray(grid[name]).reshape(grid.dimensions[::-1])[:, 2, 2]


class MetPy(unittest.TestCase):
    def test_heights_by_virtual_temperature(self):
        """To 1e-4, by which the gas constants differ; without humidity they would be 0.4 % lower."""
        for dataset in (sounding(), hybrid()):
            found = column(dataset, "Height")
            geopotential = EARTH * found / (EARTH + found)
            np.testing.assert_allclose(geopotential[1:] - geopotential[0], METPY["thickness"], rtol=1e-4)
            dry = column(dataset.drop_vars("hus"), "Height")
            self.assertGreater(abs(dry[1] / found[1] - 1), 0.003)

    def test_derived_quantities(self):
        for dataset in (sounding(), hybrid()):
            for name, tolerance in (("relative_humidity", 0.012), ("potential_temperature", 2e-4), ("equivalent_potential_temperature", 6e-4)):
                with self.subTest(name):
                    np.testing.assert_allclose(column(dataset, name, derive=name), METPY[name], rtol=tolerance)

    def test_vorticity(self):
        lon, lat = np.arange(0, 40, 2.0), np.arange(20, 60, 2.0)
        dataset = isothermal(lon, lat)
        a, b = np.meshgrid(np.radians(lon), np.radians(lat))
        winds = {"ua": 20 * np.cos(b) * (1 + 0.3 * np.sin(3 * a)), "va": 10 * np.sin(2 * b) * np.cos(2 * a)}
        dataset = dataset.assign({name: (dataset.ta.dims, np.tile(values, (4, 1, 1)), {"units": "m/s"}) for name, values in winds.items()})
        grid = dataset.nephoscope.globe(derive="vorticity")
        found = np.asarray(grid["vorticity"]).reshape(grid.dimensions[::-1])[0]
        np.testing.assert_allclose([found[place] for place in ((5, 5), (10, 10), (15, 3))], METPY["vorticity"], rtol=0.02)


class Winds(unittest.TestCase):
    def test_rotated_pole(self):
        """By the formula of the COSMO model (Doms and Baldauf 2018, part I, 3.6): the angle between the meridians of both poles."""
        pole_lon, pole_lat = -162.0, 39.25
        x, y = np.linspace(-18, 18, 13), np.linspace(-16, 16, 11)
        dims, ones = ("rlat", "rlon"), np.ones((11, 13))
        attributes = lambda name: {"standard_name": name, "units": "m/s", "grid_mapping": "pole"}
        dataset = xr.Dataset({"u": (dims, 6 * ones, attributes("grid_eastward_wind")), "v": (dims, 8 * ones, attributes("grid_northward_wind")), "pole": ((), 0, {
            "grid_mapping_name": "rotated_latitude_longitude", "grid_north_pole_longitude": pole_lon, "grid_north_pole_latitude": pole_lat})}, {
                "rlon": ("rlon", x, {"standard_name": "grid_longitude", "units": "degrees"}), "rlat": ("rlat", y, {"standard_name": "grid_latitude", "units": "degrees"})})
        grid = dataset.nephoscope.globe(radius=1.0)
        points = np.asarray(grid.points, float)
        lon, lat = np.arctan2(points[:, 1], points[:, 0]), np.arcsin(points[:, 2] / np.linalg.norm(points, axis=1))
        east = np.stack([-np.sin(lon), np.cos(lon), 0 * lon], -1)
        north = np.cross(points, east)
        wind = np.asarray(grid["Wind"])
        p, d = np.radians(pole_lat), np.radians(pole_lon) - lon
        angle = np.arctan2(np.cos(p) * np.sin(d), np.cos(lat) * np.sin(p) - np.sin(lat) * np.cos(p) * np.cos(d))
        np.testing.assert_allclose((wind * east).sum(1), 6 * np.cos(angle) + 8 * np.sin(angle), atol=1e-4)
        np.testing.assert_allclose((wind * north).sum(1), 8 * np.cos(angle) - 6 * np.sin(angle), atol=1e-4)

    GRIDS = {  # keys of eccodes, the same projection for pyproj, and how well the directions are known (m/s of 10): by the projection or from point to point
        "south polar stereographic": ({"gridType": "polar_stereographic", "Nx": 41, "Ny": 31, "latitudeOfFirstGridPointInDegrees": -50, "longitudeOfFirstGridPointInDegrees": 200, "LaDInDegrees": -60,
                                       "orientationOfTheGridInDegrees": 0, "DxInMetres": 100000, "DyInMetres": 100000, "projectionCentreFlag": 128, "jScansPositively": 1, "shapeOfTheEarth": 6,
                                       "resolutionAndComponentFlags": 8}, "+proj=stere +lat_0=-90 +lat_ts=-60 +lon_0=0 +R=6371229", 1e-5),
        "Lambert azimuthal": ({"gridType": "lambert_azimuthal_equal_area", "Nx": 40, "Ny": 30, "latitudeOfFirstGridPointInDegrees": 35, "longitudeOfFirstGridPointInDegrees": 345,
                               "standardParallelInDegrees": 52, "centralLongitudeInDegrees": 10, "DxInMetres": 100000, "DyInMetres": 100000, "jScansPositively": 1, "shapeOfTheEarth": 6,
                               "resolutionAndComponentFlags": 8}, "+proj=laea +lat_0=52 +lon_0=10 +R=6371229", 0.02),
        "rotated pole, from north to south": ({"gridType": "rotated_ll", "Ni": 40, "Nj": 30, "latitudeOfFirstGridPointInDegrees": 14, "latitudeOfLastGridPointInDegrees": -15,
                                               "longitudeOfFirstGridPointInDegrees": 340, "longitudeOfLastGridPointInDegrees": 19, "iDirectionIncrementInDegrees": 1,
                                               "jDirectionIncrementInDegrees": 1, "latitudeOfSouthernPoleInDegrees": -32.5, "longitudeOfSouthernPoleInDegrees": 10,
                                               "resolutionAndComponentFlags": 56}, "+proj=ob_tran +o_proj=longlat +o_lon_p=0 +o_lat_p=32.5 +lon_0=10 +to_meter=0.0174532925199433 +R=6371229", 1e-5)}

    def test_grids_of_eccodes_with_directions_of_pyproj(self):
        """Places of eccodes to a millimetre, values at their places, and winds of 6 along and 8 across the rows, whose direction pyproj tells."""
        import pyproj
        for name, (keys, definition, tolerance) in self.GRIDS.items():
            with self.subTest(name), tempfile.TemporaryDirectory() as folder:
                path, size = Path(folder, "a.grib2"), (keys.get("Nx") or keys["Ni"]) * (keys.get("Ny") or keys["Nj"])
                lat, lon = write_grib(path, [(kind, "isobaricInhPa", level, values) for level, z in ((850, 1500.0), (500, 5500.0))
                                             for kind, values in (("u", 6.0), ("v", 8.0), ("gh", z), ("q", np.arange(size)))], keys)
                grid = nephoscope.open(path).nephoscope.globe()
                projection = pyproj.Proj(definition)
                x, y = projection(lon, lat)
                before, after = (projection(x + step * np.ptp(x), y, inverse=True) for step in (-1e-4, 1e-4))
                up = frames(lon, lat)[2]
                along = frames(*after)[2] - frames(*before)[2]
                along /= np.linalg.norm(along, axis=1)[:, None]
                wind = 6 * along + 8 * np.cross(up, along)
                points = np.asarray(grid.points, float)[:size]
                points /= np.linalg.norm(points, axis=1)[:, None]
                place = (points @ up.T).argmax(axis=1)
                np.testing.assert_allclose(points, up[place], atol=1e-3 / EARTH)
                np.testing.assert_allclose(np.asarray(grid["Wind"])[:size], wind[place], atol=tolerance)
                np.testing.assert_allclose(np.asarray(grid["q"])[:size], place, atol=0.01)
                np.testing.assert_allclose(np.unique(grid["Height"]), [1500 * EARTH / (EARTH - 1500), 5500 * EARTH / (EARTH - 5500)], atol=0.01)


if __name__ == "__main__":
    unittest.main()
