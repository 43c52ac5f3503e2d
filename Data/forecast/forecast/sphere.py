# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Spherical harmonics on grids of latitudes and evenly spaced longitudes, with numpy alone.

A field on a grid has the axes (longitude, latitude, level), its coefficients (m, n, level) for order m and degree n, triangular
truncation: field = sum over m, n of a[m, n] P[m, n](sin latitude) exp(i m longitude), with the sum over both signs of m, and
associated Legendre functions whose squares integrate to 1 over -1 to 1. Latitudes and longitudes are in radians.
"""
import numpy as np

EARTH_RADIUS = 6371000.0  # metres
EARTH_ROTATION = 7.292115e-5  # radians per second
# The east and north components have no limit at a pole. A row there stands for a circle of a few metres around it.
NEAREST_TO_POLE = np.radians(90.0 - 1e-5)


def gaussian_latitudes(count):
    """(latitudes from south to north, weights whose sum is 2)."""
    nodes, weights = np.polynomial.legendre.leggauss(count)
    return np.arcsin(nodes), weights


def area_weights(latitudes):
    """The part of the sphere of each row, times 2: rows of cells that meet halfway between the latitudes."""
    middle = 0.5 * (latitudes[1:] + latitudes[:-1])
    return np.diff(np.sin(np.concatenate(([-0.5 * np.pi], middle, [0.5 * np.pi]))))


class Harmonics:
    """Transforms between coefficients up to the degree `truncation` and a grid; back to coefficients only with `weights`."""

    def __init__(self, truncation, latitudes, longitudes, weights=None):
        """longitudes: their number, more than 2 truncation."""
        if longitudes <= 2 * truncation:
            raise ValueError("%d longitudes cannot hold the orders up to %d" % (longitudes, truncation))
        self.truncation, self.longitudes, self.weights = truncation, longitudes, weights
        self.latitudes = np.clip(latitudes, -NEAREST_TO_POLE, NEAREST_TO_POLE)
        self.degrees = np.arange(truncation + 1)
        sine, cosine = np.sin(self.latitudes), np.cos(self.latitudes)
        functions, slopes = legendre(truncation, sine, cosine)
        self.functions = functions
        # The derivatives along the longitude (but for the factor i) and the latitude, both on the unit sphere.
        self.along = functions * self.degrees[:, None, None] / cosine[None, :, None]
        self.across = slopes / cosine[None, :, None]

    def to_grid(self, coefficients, table=None):
        """table: functions (default), along or across."""
        rows = np.matmul(self.functions if table is None else table, _as_reals(coefficients))
        return np.fft.irfft(_as_complex(rows), self.longitudes, axis=0, norm="forward")

    def from_grid(self, field, table=None):
        rows = np.fft.rfft(field, axis=0, norm="forward")[: self.truncation + 1] * self.weights[None, :, None]
        table = self.functions if table is None else table
        return _as_complex(np.matmul(table.transpose(0, 2, 1), _as_reals(rows)))

    def gradient(self, potential):
        """(eastward, northward) on the grid, per radius."""
        return self.to_grid(1j * potential, self.along), self.to_grid(potential, self.across)

    def divergence(self, east, north):
        """Coefficients of the divergence of a vector field on the grid, per radius; integrated by parts, no derivative is taken."""
        return 1j * self.from_grid(east, self.along) - self.from_grid(north, self.across)

    def curl(self, east, north):
        """Coefficients of the vertical component of the curl, per radius."""
        return self.divergence(north, -east)

    def inverse_laplacian(self, coefficients):
        """The inverse Laplacian on the unit sphere; the mean, which has none, becomes 0."""
        n = np.maximum(self.degrees, 1)
        factor = np.where(self.degrees > 0, -1.0 / (n * (n + 1)), 0.0)
        return coefficients * factor[None, :, None]

    def power(self, coefficients):
        """Mean square over the sphere that each degree holds: axes (n, level)."""
        both_signs = np.where(self.degrees > 0, 2.0, 1.0)[:, None, None]
        return 0.5 * (both_signs * np.abs(coefficients) ** 2).sum(axis=0)


def legendre(truncation, sine, cosine):
    """(functions, cosine^2 times their derivatives by the sine), axes (m, latitude, n); 0 for n < m.

    By the recurrences in the degree, stable upwards: sine P[n] = e[n + 1] P[n + 1] + e[n] P[n - 1],
    cosine^2 P'[n] = (n + 1) e[n] P[n - 1] - n e[n + 1] P[n + 1], e[n]^2 = (n^2 - m^2)/(4 n^2 - 1).
    """
    size = truncation + 1
    functions, slopes = np.zeros((size, len(sine), size + 1)), np.zeros((size, len(sine), size))
    diagonal = np.full(len(sine), np.sqrt(0.5))
    n = np.arange(size + 1, dtype=float)
    for m in range(size):
        if m > 0:
            diagonal = diagonal * cosine * np.sqrt((2 * m + 1) / (2 * m))
        e = np.sqrt(np.maximum(n * n - m * m, 0.0) / (4.0 * n * n - 1.0 + 2 * (n == 0)))
        p = functions[m]
        p[:, m] = diagonal
        for k in range(m, size):
            below = e[k] * p[:, k - 1] if k > m else 0.0
            p[:, k + 1] = (sine * p[:, k] - below) / e[k + 1]
            slopes[m][:, k] = (k + 1) * below - k * e[k + 1] * p[:, k + 1]
    return np.ascontiguousarray(functions[:, :, :size]), slopes


def across_the_poles(field, latitudes, sign=1.0):
    """The field on whole meridian circles: (longitude, 2 pi of latitude, level), and their first latitude.

    latitudes: evenly spaced from pole to pole. sign: -1 for components of vectors, whose directions turn round at a pole.
    """
    beyond = sign * np.roll(field, field.shape[0] // 2, axis=0)[:, -2:0:-1]
    return np.concatenate((field, beyond), axis=1)


def to_latitudes(field, latitudes, targets, sign=1.0):
    """A field on evenly spaced rows from pole to pole, at other latitudes: the trigonometric interpolation along whole meridians,
    exact for what the rows can hold (Machenhauer and Daley 1972)."""
    circle = across_the_poles(field, latitudes, sign)
    count = circle.shape[1]
    angle = targets[:, None] - (latitudes[0] + 2.0 * np.pi / count * np.arange(count))[None, :]
    kernel = dirichlet(angle, count)
    return np.einsum("tc,ick->itk", kernel, circle, optimize=True)


def dirichlet(angle, count):
    """The periodic function of an even number of points that is 1 at one of them and 0 at the others."""
    half = 0.5 * angle
    small = np.abs(np.sin(half)) < 1e-12
    safe = np.where(small, 1.0, half)
    return np.where(small, 1.0, np.sin(count * safe) / (count * np.tan(safe)))


def _as_reals(values):
    return np.ascontiguousarray(values).view(float)


def _as_complex(values):
    return values.view(complex)
