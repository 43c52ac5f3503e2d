# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The barotropic vorticity equation on every level by itself, and the divergence carried along.

    d(zeta)/dt = -div((zeta + f) v) + held        dD/dt = -div(D v)        v = the rotational wind of zeta

Spectral transform method: products on a grid that has no aliasing for them, classical Runge-Kutta of order 4, and a hyperdiffusion
of the eighth order integrated exactly. Without hyperdiffusion and `held` the equation keeps the kinetic energy and the enstrophy.

`held` keeps the planetary waves: of the degrees up to `hold` of the first state alone it is minus the tendency. Without the
mountains and the heating of the ground that keep these waves in their places they would run westwards, much too fast.
"""
import numpy as np

from . import sphere


def transform_grid(truncation):
    """Harmonics on the smallest handy Gaussian grid on which products of two fields have no aliasing."""
    longitudes = _handy(3 * truncation + 1)
    latitudes, weights = sphere.gaussian_latitudes(longitudes // 2)
    return sphere.Harmonics(truncation, latitudes, longitudes, weights)


class Barotropic:
    def __init__(self, harmonics, hold=0, diffusion_hours=6.0, rotation=sphere.EARTH_ROTATION, radius=sphere.EARTH_RADIUS):
        """diffusion_hours: time in which the hyperdiffusion takes 1/e of the highest degree; 0 for none."""
        self.harmonics, self.hold, self.radius = harmonics, hold, radius
        self.coriolis = 2.0 * rotation * np.sin(harmonics.latitudes)[None, :, None]
        n, top = harmonics.degrees, harmonics.truncation
        self.diffusion = (n * (n + 1) / (top * (top + 1.0))) ** 4 / (3600.0 * diffusion_hours) if diffusion_hours else 0.0 * n
        self.held = 0.0

    def analyse(self, east, north):
        """(vorticity, divergence) as coefficients, per second, of a wind on the harmonics' grid."""
        return self.harmonics.curl(east, north) / self.radius, self.harmonics.divergence(east, north) / self.radius

    def start(self, vorticity):
        """To be called with the first state: sets what is held."""
        if self.hold:
            low = vorticity * (self.harmonics.degrees <= self.hold)[None, :, None]
            self.held = 0.0
            self.held = -self.tendency(low, np.zeros_like(low))[0]

    def rotational_wind(self, vorticity, harmonics=None):
        """(east, north) in m/s on the grid of `harmonics`, by default that of the model."""
        harmonics = harmonics or self.harmonics
        east, north = harmonics.gradient(harmonics.inverse_laplacian(vorticity) * self.radius)
        return -north, east

    def divergent_wind(self, divergence, harmonics=None):
        harmonics = harmonics or self.harmonics
        return harmonics.gradient(harmonics.inverse_laplacian(divergence) * self.radius)

    def tendency(self, vorticity, divergence):
        east, north = self.rotational_wind(vorticity)
        both = self.harmonics.to_grid(np.concatenate((vorticity, divergence), axis=2))
        levels = vorticity.shape[2]
        both[..., :levels] += self.coriolis
        change = self.harmonics.divergence(both * np.tile(east, 2), both * np.tile(north, 2)) / -self.radius
        return change[..., :levels] + self.held, change[..., levels:]

    def step(self, vorticity, divergence, seconds):
        state, sums = (vorticity, divergence), [0.0, 0.0]
        slope = (0.0, 0.0)
        for reach, weight in ((0.0, 1.0), (0.5, 2.0), (0.5, 2.0), (1.0, 1.0)):
            slope = self.tendency(*(s + reach * seconds * d for s, d in zip(state, slope)))
            sums = [total + weight / 6.0 * d for total, d in zip(sums, slope)]
        damping = np.exp(-seconds * self.diffusion)[None, :, None]
        return tuple((s + seconds * total) * damping for s, total in zip(state, sums))

    def kinetic_energy(self, vorticity):
        """Mean over the sphere of half the square of the rotational wind, m2/s2, of each level."""
        n = np.maximum(self.harmonics.degrees, 1)
        return 0.5 * (self.harmonics.power(vorticity) * (self.radius**2 / (n * (n + 1)))[:, None]).sum(axis=0)

    def enstrophy(self, vorticity):
        """Mean over the sphere of half the square of the vorticity, 1/s2, of each level."""
        return 0.5 * self.harmonics.power(vorticity).sum(axis=0)


def _handy(least):
    """The smallest number from `least` on that is 4 times powers of 2, 3 and 5: fast to transform, half of it even."""
    count = -(-least // 4) * 4
    while True:
        rest = count
        for factor in (2, 3, 5):
            while rest % factor == 0:
                rest //= factor
        if rest == 1:
            return count
        count += 4
