# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""A forecast as a NetCDF file of hourly fields, that goes on where it was interrupted and appears under its name when it is whole."""
import json
import os
import time

import numpy as np

from . import model, netcdf_classic

FIELDS = {  # name: (units, long name, standard name, cell of the packed files)
    "u": ("m s-1", "eastward wind", "eastward_wind", ("i2", 0.01)),
    "v": ("m s-1", "northward wind", "northward_wind", ("i2", 0.01)),
    "w": ("Pa s-1", "omega, carried along", "lagrangian_tendency_of_air_pressure", ("i2", 0.001)),
    "t": ("K", "temperature, carried along", "air_temperature", ("i2", 0.01)),
    "clwmr": ("kg kg-1", "cloud water mixing ratio, carried along", "cloud_liquid_water_mixing_ratio", ("i2", 1e-7)),
    "cloud_fraction": ("1", "cloud fraction, carried along", "cloud_area_fraction_in_atmosphere_layer", ("i1", 0.01)),
}
STILL = {
    "gh": ("m", "geopotential height of the first time", "geopotential_height", ("i2", 1.0)),
    "orog": ("m", "height of the ground", "surface_altitude", ("i2", 1.0)),
    "sp": ("Pa", "pressure at the ground, of the first time", "surface_air_pressure", ("i2", 10.0)),
}
REFERENCE_TIME = "hours since 2011-01-01 00:00:00"


class Series:
    """names: which of FIELDS to write. packed: as whole numbers, a half or a quarter as large."""

    def __init__(self, path, layout, hours, names=tuple(FIELDS), packed=False, **settings):
        self.path, self.layout, self.hours, self.names, self.packed, self.settings = path, layout, hours, names, packed, settings
        self.unfinished, self.checkpoint = path + ".unfinished", path + ".state.npz"

    def make(self, analysis, report=print):
        forecast = model.Forecast(self.layout, **self.settings)
        done = self.resume(forecast, analysis)
        if done is None:
            forecast.start(analysis)
            file, done = self.begin(analysis), 0
            self.finish_hour(file, forecast, analysis, 0)
        else:
            report("%d of %d hours are there already" % (done, self.hours))
            file = self.open(analysis, done + 1)
        try:
            self.go_on(forecast, file, analysis, done, report)
        finally:
            file.close()
        os.replace(self.unfinished, self.path)
        os.remove(self.checkpoint)

    def go_on(self, forecast, file, analysis, done, report):
        started = time.monotonic()
        for hour in range(done + 1, self.hours + 1):
            forecast.advance_one_hour()
            self.finish_hour(file, forecast, analysis, hour)
            left = (time.monotonic() - started) / (hour - done) * (self.hours - hour)
            report("hour %d of %d, %.0f s left" % (hour, self.hours, left))

    def identity(self, analysis):
        """What the state depends on. Not the number of hours: a longer series goes on with a shorter one's state."""
        layout = self.layout
        return json.dumps([analysis.digest, layout.longitudes, list(layout.latitudes), list(layout.levels), layout.truncation, layout.refinement,
                           list(self.names), self.packed, self.settings])

    def resume(self, forecast, analysis):
        """The hour that is done and the forecast set to it; None where there is nothing, or something else, to go on with."""
        try:
            with np.load(self.checkpoint) as state:
                if str(state["identity"]) != self.identity(analysis) or int(state["hour"]) > self.hours:
                    return None
                if not os.path.exists(self.unfinished):
                    return None
                forecast.resume(analysis, state)
                return int(state["hour"])
        except (OSError, ValueError, KeyError):
            return None

    def finish_hour(self, file, forecast, analysis, hour):
        fields = forecast.fields()
        file.write("time", analysis.time + hour, hour)
        for name in self.names:
            file.write(name, fields[name].transpose(2, 1, 0), hour)
        file.finish_record(hour)
        # A state of its own name is a whole one, and never ahead of the records.
        with open(self.checkpoint + ".new", "wb") as state:
            np.savez(state, identity=self.identity(analysis), hour=hour, **forecast.state())
        os.replace(self.checkpoint + ".new", self.checkpoint)

    def begin(self, analysis):
        file, layout = self.open(analysis, None), self.layout
        file.write("lev", layout.levels)
        file.write("lat", np.degrees(layout.latitudes))
        file.write("lon", np.degrees(layout.longitude_values()))
        for name in STILL:
            levels = layout.levels if name == "gh" else None
            file.write(name, model.sampled(analysis, name, layout, levels).transpose(2, 1, 0))
        return file

    def open(self, analysis, keep_records):
        return netcdf_classic.Writer(self.unfinished, self.dimensions(), self.axes() + self.variables(), {
            "Conventions": "CF-1.8",
            "title": "Forecast of %d hours by the barotropic vorticity equation on each level, clouds carried along" % self.hours,
            "source": "NCEP GFS (US government, public domain), Data/gfs_2p5deg_2011101100.nc of Nephoscope",
            "comment": "made by Data/forecast/make_forecast.py; no weather forecast to rely on",
        }, keep_records)

    def dimensions(self):
        return {"time": None, "lev": len(self.layout.levels), "lat": len(self.layout.latitudes), "lon": self.layout.longitudes}

    def axes(self):
        variable = netcdf_classic.Variable
        return [
            variable("time", ("time",), "f8", {"units": REFERENCE_TIME, "calendar": "standard", "standard_name": "time", "axis": "T"}),
            variable("lev", ("lev",), "f4", {"units": "hPa", "standard_name": "air_pressure", "positive": "down", "axis": "Z"}),
            variable("lat", ("lat",), "f8", {"units": "degrees_north", "standard_name": "latitude", "axis": "Y"}),
            variable("lon", ("lon",), "f8", {"units": "degrees_east", "standard_name": "longitude", "axis": "X"}),
        ]

    def variables(self):
        space = ("lev", "lat", "lon")
        still = [self.variable(name, space if name == "gh" else space[1:], STILL[name]) for name in STILL]
        return still + [self.variable(name, ("time",) + space, FIELDS[name]) for name in self.names]

    def variable(self, name, dimensions, description):
        units, long_name, standard_name, (kind, step) = description
        attributes = {"units": units, "long_name": long_name, "standard_name": standard_name}
        return netcdf_classic.Variable(name, dimensions, kind if self.packed else "f4", attributes, step if self.packed else None)
