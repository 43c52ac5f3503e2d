#!/usr/bin/env python3
# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Make gfs_2p5deg_2011101100.nc from gfs.grb, or compare a file with it.

    make_gfs.py gfs.grb OUT.nc [--compare Data/gfs_2p5deg_2011101100.nc]

gfs.grb ships in Debian's package python-grib-doc (usr/share/doc/python-grib-doc/examples/gfs.grb) and in the
source distribution of pygrib 2.1.8 (sampledata/gfs.grb). Needs: eccodes, netCDF4, numpy.
"""
import argparse
import hashlib
import sys

import eccodes
import netCDF4
import numpy

GRIB_SHA256 = "618ccb8c3d955d6859009038556c04fa47143bded89a4a94ea832ab9b99fe88c"
LEVELS = [1000, 975, 950, 925, 900, 850, 800, 750, 700, 650, 600, 550, 500, 450, 400, 350, 300, 250, 200,
          150, 100]  # hPa; clwmr and w reach no higher
# Our name: (GRIB short name, type of level, units, long name)
ON_LEVELS = {
    "u": ("u", "isobaricInhPa", "m s-1", "eastward wind"),
    "v": ("v", "isobaricInhPa", "m s-1", "northward wind"),
    "w": ("w", "isobaricInhPa", "Pa s-1", "omega"),
    "t": ("t", "isobaricInhPa", "K", "temperature"),
    "r": ("r", "isobaricInhPa", "%", "relative humidity"),
    "clwmr": ("clwmr", "isobaricInhPa", "kg kg-1", "cloud water mixing ratio"),
    "gh": ("gh", "isobaricInhPa", "m", "geopotential height"),
}
ON_SURFACE = {
    "orog": ("orog", "surface", "m", "orog"),
    "lsm": ("lsm", "surface", "1", "lsm"),
    "sp": ("sp", "surface", "Pa", "sp"),
    "prmsl": ("prmsl", "meanSea", "Pa", "prmsl"),
    "tcc": ("tcc", "atmosphereSingleLayer", "%", "6-h mean cloud cover atm"),
    "tcc_low": ("tcc", "lowCloudLayer", "%", "6-h mean cloud cover lowCloudLayer"),
    "tcc_mid": ("tcc", "middleCloudLayer", "%", "6-h mean cloud cover middleCloudLayer"),
    "tcc_high": ("tcc", "highCloudLayer", "%", "6-h mean cloud cover highCloudLayer"),
}
CLOUD_FRACTION_NAME = "DERIVED: Xu and Randall (1996) cloud fraction from t, r, clwmr"


def check_source(path):
    with open(path, "rb") as file:
        digest = hashlib.sha256(file.read()).hexdigest()
    if digest != GRIB_SHA256:
        sys.exit(f"{path}: sha256 {digest}, expected {GRIB_SHA256}")


def read_grib(path):
    """{(short name, type of level, level): field of 73 x 144, south to north}."""
    eccodes.codes_grib_multi_support_on()  # u and v share a message: without this v is silently missing
    fields = {}
    with open(path, "rb") as file:
        while (message := eccodes.codes_grib_new_from_file(file)) is not None:
            key = tuple(eccodes.codes_get(message, k) for k in ("shortName", "typeOfLevel", "level"))
            if eccodes.codes_get(message, "Ni") == 144 and eccodes.codes_get(message, "Nj") == 73:
                values = eccodes.codes_get_values(message).reshape(73, 144)
                fields.setdefault(key, values[::-1])  # GRIB rows run north to south
            eccodes.codes_release(message)
    return fields


def saturation_vapour_pressure(temperature):
    """Pa: water above 0 C (Bolton 1980, equation 10), ice below -20 C (Magnus form), linear between; in kelvin."""
    celsius = temperature - 273.15
    water = 611.2 * numpy.exp(17.67 * celsius / (celsius + 243.5))
    ice = 611.2 * numpy.exp(22.46 * celsius / (celsius + 272.6))
    liquid = numpy.clip((temperature - 253.15) / 20.0, 0.0, 1.0)
    return liquid * water + (1.0 - liquid) * ice


def cloud_fraction(temperature, relative_humidity, cloud_water, pressure):
    """Xu and Randall (1996), equation 1: p = 0.25, alpha = 100, gamma = 0.49.

    RH^p (1 - exp(-alpha q / ((1 - RH) q*)^gamma)); 1 at RH = 1 where there is cloud water, 0 without it.
    """
    vapour = numpy.minimum(saturation_vapour_pressure(temperature), 0.99 * pressure)
    saturation = 0.622 * vapour / (pressure - 0.378 * vapour)  # specific humidity, kg/kg
    humidity = numpy.clip(relative_humidity / 100.0, 0.0, 1.0)
    water = numpy.maximum(cloud_water, 0.0)
    deficit = numpy.maximum((1.0 - humidity) * saturation, 1e-12) ** 0.49
    return humidity**0.25 * (1.0 - numpy.exp(-100.0 * water / deficit))


def build(path):
    """{name: (array as float32, units, long name)}."""
    fields = read_grib(path)
    made = {}
    for name, (short, kind, units, long_name) in ON_LEVELS.items():
        stack = numpy.stack([fields[short, kind, level] for level in LEVELS])
        made[name] = (stack.astype("f4"), units, long_name)
    for name, (short, kind, units, long_name) in ON_SURFACE.items():
        made[name] = (fields[short, kind, 0].astype("f4"), units, long_name)
    pressure = 100.0 * numpy.array(LEVELS, "f8")[:, None, None]
    t, r, q = (made[name][0].astype("f8") for name in ("t", "r", "clwmr"))
    fraction = cloud_fraction(t, r, q, pressure).astype("f4")
    made["cloud_fraction"] = (fraction, "1", CLOUD_FRACTION_NAME)
    return made


def add_axis(data, name, values, **attributes):
    data.createDimension(name, len(values))
    variable = data.createVariable(name, "f8" if name == "time" else "f4", (name,))
    variable[:] = values
    variable.setncatts(attributes)


def write(path, made):
    with netCDF4.Dataset(path, "w") as data:
        data.Conventions = "CF-1.8"
        data.title = "NCEP GFS 2.5 deg forecast, converted from gfs.grb"
        data.source = ("NOAA/NWS/NCEP GFS (US government, public domain), as shipped in pygrib sampledata / "
                       "Debian python-grib-doc")
        add_axis(data, "time", [6792.0], units="hours since 2011-01-01 00:00:00", long_name="valid time",
                 standard_name="time")
        add_axis(data, "lev", LEVELS, units="hPa", long_name="pressure", standard_name="air_pressure",
                 positive="down")
        add_axis(data, "lat", numpy.linspace(-90.0, 90.0, 73), units="degrees_north", long_name="latitude",
                 standard_name="latitude")
        add_axis(data, "lon", numpy.arange(144) * 2.5, units="degrees_east", long_name="longitude",
                 standard_name="longitude")
        for name, (values, units, long_name) in made.items():
            axes = ("time", "lev", "lat", "lon") if values.ndim == 3 else ("time", "lat", "lon")
            variable = data.createVariable(name, "f4", axes, zlib=True, complevel=9)
            variable[0] = values
            variable.setncatts({"units": units, "long_name": long_name})


def compare(made, path):
    """Print the largest difference of every variable; return 1 if one differs by more than 1e-6."""
    worst = 0.0
    with netCDF4.Dataset(path) as data:
        for name, (values, _, _) in made.items():
            difference = numpy.abs(values.astype("f8") - data[name][0].astype("f8"))
            largest = float(difference.max())
            print(f"{name:15s} largest difference {largest:.3g} at {int((difference > 0).sum())} points")
            worst = max(worst, largest)
    return int(worst > 1e-6)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("grib")
    parser.add_argument("output")
    parser.add_argument("--compare", metavar="FILE", help="print how FILE differs from what was made")
    arguments = parser.parse_args()
    check_source(arguments.grib)
    made = build(arguments.grib)
    write(arguments.output, made)
    return compare(made, arguments.compare) if arguments.compare else 0


if __name__ == "__main__":
    sys.exit(main())
