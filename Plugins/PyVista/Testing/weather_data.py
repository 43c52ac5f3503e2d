# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Weather in closed forms, as datasets and as GRIB files, for the tests of nephoscope.open."""
import numpy as np
import xarray as xr

GRAVITY, GAS, RADIUS = 9.80665, 287.05, 6371229.0
AXIS = np.array([0.3, -0.5, 0.81])  # of the solid rotation, about


def isothermal(longitude, latitude, pressures=(100000.0, 85000, 50000, 20000), temperature=250.0, ground=0.0, surface_pressure=1.02e5):
    """Dataset of an atmosphere of one temperature: geopotential height = ground + R T / g ln(ps / p)."""
    shape = (len(pressures), len(latitude), len(longitude))
    ones = np.ones(shape, np.float32)
    return xr.Dataset({"ta": (("plev", "lat", "lon"), temperature * ones, {"standard_name": "air_temperature", "units": "K"}),
                       "ps": (("lat", "lon"), surface_pressure * ones[0], {"standard_name": "surface_air_pressure", "units": "Pa"}),
                       "orog": (("lat", "lon"), ground * ones[0], {"standard_name": "surface_altitude", "units": "m"})},
                      {"plev": ("plev", np.array(pressures), {"standard_name": "air_pressure", "units": "Pa", "positive": "down"}),
                       "lat": ("lat", np.array(latitude, float), {"units": "degrees_north"}), "lon": ("lon", np.array(longitude, float), {"units": "degrees_east"})})


def frames(lon, lat):
    """East, north and up at places in degrees: arrays (..., 3)."""
    a, b = np.radians(lon), np.radians(lat)
    up = np.stack([np.cos(b) * np.cos(a), np.cos(b) * np.sin(a), np.sin(b)], -1)
    east = np.stack([-np.sin(a), np.cos(a), np.zeros_like(a)], -1)
    return east, np.cross(up, east), up


def rotation(lon, lat, speed=30.0):
    """Solid rotation about AXIS: the wind as a vector, and its eastward and northward parts."""
    east, north, up = frames(lon, lat)
    wind = speed * np.cross(AXIS, up)
    return wind, (wind * east).sum(-1), (wind * north).sum(-1)


def along_rows(lon, lat, eastward, northward):
    """Components along the rows and across them, from the places of the points alone: by central differences of fourth order."""
    places = frames(lon, lat)[2]
    along = np.gradient(places, axis=1)
    along[:, 2:-2] = (8 * (places[:, 3:-1] - places[:, 1:-3]) - (places[:, 4:] - places[:, :-4])) / 12
    east, north, _ = frames(lon, lat)
    angle = np.arctan2((along * north).sum(-1), (along * east).sum(-1))
    return eastward * np.cos(angle) + northward * np.sin(angle), northward * np.cos(angle) - eastward * np.sin(angle)


def write_grib(path, fields, keys, sample="GRIB2", mode="wb"):
    """`fields`: (short name, type of level, level, values[, more keys]); `keys`: of the grid, set in their order. Returns latitudes and longitudes."""
    import eccodes as ec
    places = None
    with open(path, mode) as file:
        for name, kind, level, values, *more in fields:
            handle = ec.codes_grib_new_from_samples(sample)
            for key, value in {**keys, **(more[0] if more else {})}.items():
                (ec.codes_set_array if np.ndim(value) else ec.codes_set)(handle, key, value)
            ec.codes_set(handle, "shortName", name)
            ec.codes_set(handle, "typeOfLevel", kind)
            ec.codes_set(handle, "level", level)
            size = keys.get("Ni", 0) * keys.get("Nj", 0) or keys.get("Nx", 0) * keys.get("Ny", 0) or int(np.sum(keys.get("pl", 0))) or 12 * keys.get("Nside", 0) ** 2
            values = np.broadcast_to(np.asarray(values, float).ravel(), size)
            if np.isnan(values).any():
                ec.codes_set(handle, "bitmapPresent", 1)
                ec.codes_set(handle, "missingValue", 9999)
            ec.codes_set(handle, "bitsPerValue", 24)
            ec.codes_set_values(handle, np.where(np.isnan(values), 9999, values))
            places = ec.codes_get_array(handle, "latitudes"), ec.codes_get_array(handle, "longitudes")
            ec.codes_write(handle, file)
            ec.codes_release(handle)
    return places


REGULAR = {"gridType": "regular_ll", "Ni": 36, "Nj": 17, "latitudeOfFirstGridPointInDegrees": 80, "latitudeOfLastGridPointInDegrees": -80,
           "longitudeOfFirstGridPointInDegrees": 0, "longitudeOfLastGridPointInDegrees": 350, "iDirectionIncrementInDegrees": 10, "jDirectionIncrementInDegrees": 10}
LAMBERT = {"gridType": "lambert", "Nx": 60, "Ny": 40, "latitudeOfFirstGridPointInDegrees": 16.281, "longitudeOfFirstGridPointInDegrees": 233.862, "LaDInDegrees": 25,
           "LoVInDegrees": 265, "DxInMetres": 80000, "DyInMetres": 80000, "Latin1InDegrees": 25, "Latin2InDegrees": 25, "jScansPositively": 1, "uvRelativeToGrid": 1, "resolutionAndComponentFlags": 8,
           "shapeOfTheEarth": 6}
