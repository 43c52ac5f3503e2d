# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The forecast: winds by the barotropic vorticity equation on each level, clouds and the rest carried by the rotational wind."""
import numpy as np

from . import barotropic, sphere, tracers

CARRIED = ("cloud_fraction", "clwmr", "t", "w")


class Layout:
    """The grid of a series. latitudes in radians from south to north; levels in hPa; truncation of the model.

    refinement: what is carried is carried on a grid so many times as fine, whose rows and columns include these ones.
    """

    def __init__(self, longitudes, latitudes, levels, truncation, refinement=1):
        self.longitudes, self.latitudes, self.levels, self.truncation = longitudes, latitudes, levels, truncation
        self.refinement = refinement

    def longitude_values(self):
        return 2.0 * np.pi / self.longitudes * np.arange(self.longitudes)

    def refined(self):
        rows = np.arange(len(self.latitudes))
        fine = np.interp(np.arange((len(rows) - 1) * self.refinement + 1) / self.refinement, rows, self.latitudes)
        return Layout(self.longitudes * self.refinement, fine, self.levels, self.truncation)


def even_layout(longitudes, latitudes, levels, truncation, refinement=1):
    """Rows evenly spaced from pole to pole."""
    return Layout(longitudes, np.linspace(-0.5 * np.pi, 0.5 * np.pi, latitudes), levels, truncation, refinement)


def gaussian_layout(longitudes, latitudes, levels, truncation):
    return Layout(longitudes, sphere.gaussian_latitudes(latitudes)[0], levels, truncation)


class Forecast:
    """State: vorticity and divergence as coefficients, and what is carried, on the refined grid."""

    def __init__(self, layout, hold=10, diffusion_hours=6.0):
        self.layout = layout
        self.model = barotropic.Barotropic(barotropic.transform_grid(layout.truncation), hold, diffusion_hours)
        self.fine = layout.refined()
        self.output = sphere.Harmonics(layout.truncation, self.fine.latitudes, self.fine.longitudes)
        self.carrier = tracers.Carrier(self.fine.latitudes, self.fine.longitudes)
        # The highest waves must turn by less than 2.8 radians a step, the limit of Runge-Kutta on the imaginary axis; half is accurate.
        self.steps_per_hour = 2 if layout.truncation <= 90 else 4

    def start(self, analysis):
        wind = wind_on(self.model.harmonics, analysis, self.layout.levels)
        self.vorticity, self.divergence = self.model.analyse(*wind)
        self.model.start(self.vorticity)
        self.carried = {name: sampled(analysis, name, self.fine, self.layout.levels) for name in CARRIED}
        self.distributions = distributions(self.carried, self.fine.latitudes)
        # Between the points of the analysis the refined grid has values of its own: what is written needs a measure of its own.
        self.written = distributions(self.thinned(self.carried), self.layout.latitudes)

    def state(self):
        return {"vorticity": self.vorticity, "divergence": self.divergence, **self.carried}

    def resume(self, analysis, state):
        """Goes on with what state() gave, to the last bit as if never interrupted."""
        self.start(analysis)
        self.vorticity, self.divergence = state["vorticity"], state["divergence"]
        self.carried = {name: state[name] for name in CARRIED}

    def advance_one_hour(self):
        self.advance_model(self.steps_per_hour // 2)
        wind = self.model.rotational_wind(self.vorticity, self.output)  # that of the middle
        self.advance_model(self.steps_per_hour // 2)
        carried = self.carrier.carry(self.carried.values(), *wind, 3600.0)
        self.carried = {name: self.distributions[name].restore(field) for name, field in zip(self.carried, carried)}

    def advance_model(self, steps):
        for _ in range(steps):
            self.vorticity, self.divergence = self.model.step(self.vorticity, self.divergence, 3600.0 / self.steps_per_hour)

    def fields(self):
        """{name: (longitude, latitude, level)}."""
        rotational = self.model.rotational_wind(self.vorticity, self.output)
        divergent = self.model.divergent_wind(self.divergence, self.output)
        wind = dict(zip("uv", (a + b for a, b in zip(rotational, divergent))))
        carried = {name: self.written[name].restore(field) for name, field in self.thinned(self.carried).items()}
        return {**self.thinned(wind), **carried}

    def thinned(self, fields):
        each = self.layout.refinement
        return {name: field[::each, ::each] for name, field in fields.items()}


def distributions(fields, latitudes):
    return {name: tracers.AreaDistribution(field, latitudes) for name, field in fields.items()}


def wind_on(harmonics, analysis, levels):
    """(east, north) of the analysis on a Gaussian grid: exactly what its rows and columns hold, but for the highest orders."""
    made = []
    for name in ("u", "v"):
        rows = sphere.to_latitudes(analysis.on_levels(name, levels), analysis.latitudes, harmonics.latitudes, sign=-1.0)
        waves = np.fft.rfft(rows, axis=0, norm="forward")[: harmonics.truncation + 1]
        made.append(np.fft.irfft(waves, harmonics.longitudes, axis=0, norm="forward"))
    return made


def sampled(analysis, name, layout, levels=None):
    """A field of the analysis on the layout's grid: itself where the grids are the same, else bicubic and within bounds; the mean
    over each cell where these are larger than the analysis'."""
    field = analysis.fields[name] if levels is None else analysis.on_levels(name, levels)
    longitudes, latitudes = layout.longitude_values(), layout.latitudes
    if longitudes.shape == analysis.longitudes.shape and np.allclose(latitudes, analysis.latitudes, atol=1e-6):
        return field
    carrier = tracers.Carrier(analysis.latitudes, len(analysis.longitudes))
    parts = max(1, round(len(analysis.longitudes) / len(longitudes)))
    offsets = (np.arange(parts) + 0.5) / parts - 0.5
    total = 0.0
    for shift in np.diff(longitudes)[0] * offsets:
        for lift in np.diff(latitudes).mean() * offsets:
            total = total + carrier.sample(field, np.clip(latitudes + lift, -0.5 * np.pi, 0.5 * np.pi), longitudes + shift)
    mean = total / parts**2
    for row in (0, -1):
        if tracers.has_pole_rows(latitudes):
            mean[:, row] = mean[:, row].mean(axis=0)
    return mean
