# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every snippet of Documentation/weather-sources.md, run on a small file in the layout of its source; and files of models as they are, Data/weather."""
import os
import re
import shutil
import tempfile
import unittest
import warnings
from pathlib import Path

import nephoscope
import numpy as np
import pyvista
import xarray as xr
from TestWeatherMeshes import icon, mpas
from weather_data import GRAVITY, REGULAR, write_grib

TOP = Path(__file__).resolve().parents[3]
SAMPLES = TOP / "Data/weather"
LON, LAT = np.arange(0, 360, 20.0), np.arange(80, -81, -20.0)
PRESSURES = np.array([1000.0, 850, 500, 250])  # hPa
HEIGHTS = np.array([110.0, 1460, 5570, 10360])  # m, geopotential


def snippets():
    """{heading: script} of the page."""
    page = (TOP / "Documentation/weather-sources.md").read_text(encoding="utf-8")
    parts = re.findall(r"^## (.*?)\n(.*?)(?=^## |\Z)", page, re.DOTALL | re.MULTILINE)
    return {heading: "\n".join(line[4:] for line in text.splitlines() if line.startswith("    ") or not line.strip()) for heading, text in parts}


def times(count=2):
    return np.datetime64("2020-01-01T00", "ns") + np.arange(count) * np.timedelta64(6, "h")


def wave(levels):
    """Clouds at some longitudes, 0 to 1."""
    return np.broadcast_to(0.5 + 0.5 * np.cos(np.radians(3 * LON)), (levels, LAT.size, LON.size)).astype("f4")


def era5():
    """The Climate Data Store's NetCDF of 2024 and later."""
    dims, shape = ("valid_time", "pressure_level", "latitude", "longitude"), (2, 4, LAT.size, LON.size)
    whole = lambda field: np.broadcast_to(field, shape).astype("f4")
    keys = lambda name, units, standard: {"GRIB_shortName": name, "GRIB_gridType": "regular_ll", "units": units, "standard_name": standard, "GRIB_uvRelativeToGrid": 0}
    return xr.Dataset({"z": (dims, whole(GRAVITY * HEIGHTS.reshape(-1, 1, 1)), keys("z", "m**2 s**-2", "geopotential")), "cc": (dims, whole(wave(4)), keys("cc", "(0 - 1)", "unknown")),
                       "t": (dims, whole(260.0), keys("t", "K", "air_temperature")), "u": (dims, whole(10.0), keys("u", "m s**-1", "eastward_wind")),
                       "v": (dims, whole(0.0), keys("v", "m s**-1", "northward_wind"))},
                      {"number": ((), 0), "valid_time": ("valid_time", times(), {"standard_name": "time"}), "pressure_level": ("pressure_level", PRESSURES, {"units": "hPa", "positive": "down"}),
                       "latitude": ("latitude", LAT, {"units": "degrees_north"}), "longitude": ("longitude", LON, {"units": "degrees_east"}), "expver": ("valid_time", ["0001", "0005"])})


def gfs(path):
    cloud = 3e-4 * (1 + np.cos(np.arange(36) / 36 * 6 * np.pi))
    write_grib(path, [field for p, z in zip(PRESSURES, HEIGHTS) for field in (("gh", "isobaricInhPa", int(p), z), ("clwmr", "isobaricInhPa", int(p), np.tile(cloud, 17)),
                                                                          ("t", "isobaricInhPa", int(p), 260.0))] + [("sp", "surface", 0, 1.01e5), ("orog", "surface", 0, 100.0)], REGULAR)


def cmip():
    """cl, ta and orog; levels from the bottom to the top, as p = ap + b ps."""
    b = np.array([0.99, 0.85, 0.5, 0.25])
    places = {"lat": ("lat", LAT[::-1], {"units": "degrees_north", "axis": "Y"}), "lon": ("lon", LON, {"units": "degrees_east", "axis": "X"})}
    lev = {"lev": ("lev", b, {"standard_name": "atmosphere_hybrid_sigma_pressure_coordinate", "formula_terms": "ap: ap b: b ps: ps", "positive": "down", "axis": "Z"}), "time": ("time", times(2))}
    dims, shape = ("time", "lev", "lat", "lon"), (2, 4, LAT.size, LON.size)
    ps = (("time", "lat", "lon"), np.full((2, LAT.size, LON.size), 1.01e5, "f4"), {"units": "Pa", "standard_name": "surface_air_pressure"})
    levels = {"ap": ("lev", 0 * b, {"units": "Pa"}), "b": ("lev", b), "ps": ps, "lat_bnds": (("lat", "bnds"), np.stack([LAT[::-1] - 10, LAT[::-1] + 10], 1))}
    return {"cl_Amon.nc": xr.Dataset({"cl": (dims, np.broadcast_to(100 * wave(4), shape), {"units": "%", "standard_name": "cloud_area_fraction_in_atmosphere_layer"}), **levels}, lev | places),
            "ta_Amon.nc": xr.Dataset({"ta": (dims, np.full(shape, 260.0, "f4"), {"units": "K", "standard_name": "air_temperature"}), **levels}, lev | places),
            "orog_fx.nc": xr.Dataset({"orog": (("lat", "lon"), np.full(shape[2:], 200.0, "f4"), {"units": "m", "standard_name": "surface_altitude"})}, places)}


def wrf():
    from TestWeatherHeights import Models
    return Models().wrf()[0]


def split(dataset, field, mesh):
    """A model that writes fields and mesh into two files."""
    dataset[field] = dataset["where"] * 0 + np.linspace(0, 1, dataset["where"].size).reshape(dataset["where"].shape)
    return dataset.drop_vars(mesh), dataset[mesh].reset_coords()


class Sources(unittest.TestCase):
    def setUp(self):
        folder, before = tempfile.TemporaryDirectory(), os.getcwd()
        os.chdir(folder.name)
        self.addCleanup(folder.cleanup)
        self.addCleanup(os.chdir, before)

    def run_snippet(self, heading):
        script = snippets()[heading]
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            exec(compile(script, heading, "exec"), {})
        picture = pyvista.read(re.search(r'screenshot="(.*?)"', script)[1])["PNGImage"].astype(float)
        self.assertGreater(picture.std(), 10)

    def test_era5(self):
        era5().to_netcdf("era5.nc")
        self.assertIn("from geopotential 'z'", nephoscope.open("era5.nc").nephoscope.describe())
        self.run_snippet("ERA5 from the Climate Data Store")

    def test_gfs(self):
        gfs(Path("gfs.grib2"))
        self.run_snippet("GFS, or another forecast in GRIB")

    def test_wrf(self):
        wrf().to_netcdf("wrfout_d01_2020-01-01_00_00_00")
        self.run_snippet("WRF")

    def test_icon(self):
        data, mesh = split(icon(), "clc", ["clon_vertices", "clat_vertices", "clon", "clat", "z_ifc"])
        data.to_netcdf("icon.nc")
        mesh.rename(ncells="cell").to_netcdf("icon_grid.nc")
        self.run_snippet("ICON")

    def test_mpas(self):
        data, mesh = split(mpas(), "qc", ["verticesOnCell", "nEdgesOnCell", "lonVertex", "latVertex", "lonCell", "latCell", "zgrid"])
        data.to_netcdf("history.nc")
        mesh.to_netcdf("init.nc")
        self.run_snippet("MPAS-Atmosphere")

    def test_cmip(self):
        for name, dataset in cmip().items():
            dataset.to_netcdf(name)
        self.run_snippet("CMIP6")

    def test_unified_model(self):
        shutil.copy(SAMPLES / "colpex_hybrid_height.nc", ".")
        self.run_snippet("Unified Model and LFRic")

    def test_every_section_has_a_test(self):
        self.assertEqual(len(snippets()), len([name for name in dir(self) if re.fullmatch("test_(?!every|samples).*", name)]))

    def test_samples_as_they_are(self):
        """Heights are a + b orog of the file's own terms; the pole is where its keys say; the cubed sphere has as many faces as its mesh."""
        hills = nephoscope.open(SAMPLES / "colpex_hybrid_height.nc")
        grid = hills.nephoscope.globe(mask_below_ground=False)
        heights = hills.level_height + hills.sigma * hills.surface_altitude
        np.testing.assert_allclose(np.asarray(grid["Height"]), heights.transpose("model_level_number", "grid_latitude", "grid_longitude").values.ravel(), atol=1e-3)
        pole = nephoscope.open(SAMPLES / "rotated_pole.nc")
        grid, keys = pole.nephoscope.globe(), pole.rotated_latitude_longitude.attrs
        x, y = np.radians(np.meshgrid(pole.grid_longitude, pole.grid_latitude))
        tilt, turn = np.radians(keys["grid_north_pole_latitude"]), np.radians(keys["grid_north_pole_longitude"])
        lat = np.arcsin(np.sin(tilt) * np.sin(y) + np.cos(tilt) * np.cos(y) * np.cos(x))  # spherical trigonometry
        points = np.asarray(grid.points) / np.linalg.norm(grid.points, axis=1, keepdims=True)
        np.testing.assert_allclose(np.arcsin(points[:, 2]), lat.ravel(), atol=1e-6)
        own = np.array([np.cos(tilt) * np.cos(turn), np.cos(tilt) * np.sin(turn), np.sin(tilt)])
        np.testing.assert_allclose(points @ own, np.sin(y).ravel(), atol=1e-6)
        self.assertEqual(nephoscope.open(SAMPLES / "lfric_c4.nc").nephoscope.globe().n_cells, 96)


if __name__ == "__main__":
    unittest.main()
