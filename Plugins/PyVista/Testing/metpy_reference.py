# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Prints the numbers that TestWeatherReference.py has as those of MetPy: python -m venv V && V/bin/pip install metpy==1.7.1 && V/bin/python metpy_reference.py"""
import metpy.calc as calc
import numpy as np
import xarray as xr
from metpy.units import units

p = np.array([1000.0, 850, 700, 500, 300]) * units.hPa
t = np.array([295.0, 287, 278, 258, 230]) * units.K
q = np.array([14.0, 9, 4.5, 1.2, 0.1]) * units("g/kg")
w = calc.mixing_ratio_from_specific_humidity(q)
layers = [calc.thickness_hydrostatic(p[i:i + 2], t[i:i + 2], mixing_ratio=w[i:i + 2]).m_as("m") for i in range(4)]
print("virtual_temperature", calc.virtual_temperature(t, w).m.tolist())
print("thickness", np.cumsum(layers).tolist())
print("relative_humidity", calc.relative_humidity_from_specific_humidity(p, t, q).m_as("").tolist())
print("potential_temperature", calc.potential_temperature(p, t).m.tolist())
print("equivalent_potential_temperature", calc.equivalent_potential_temperature(p, t, calc.dewpoint_from_specific_humidity(p, q)).m.tolist())

lon, lat = np.arange(0, 40, 2.0), np.arange(20, 60, 2.0)
a, b = np.meshgrid(np.radians(lon), np.radians(lat))
wind = {"u": 20 * np.cos(b) * (1 + 0.3 * np.sin(3 * a)), "v": 10 * np.sin(2 * b) * np.cos(2 * a)}
dataset = xr.Dataset({name: (("lat", "lon"), values, {"units": "m/s"}) for name, values in wind.items()}, {
    "lat": ("lat", lat, {"units": "degrees_north", "standard_name": "latitude"}), "lon": ("lon", lon, {"units": "degrees_east", "standard_name": "longitude"})})
dataset = dataset.metpy.assign_crs(grid_mapping_name="latitude_longitude", earth_radius=6371229.0)
vorticity = calc.vorticity(dataset.u, dataset.v)
print("vorticity", [float(vorticity[place]) for place in ((5, 5), (10, 10), (15, 3))])
