# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Fine clouds of the forecast after some hours, in which its wind has moved them.

    grid = moved_grid((-130, -80), (0, 35), 0.15, hours=13)   degrees; vtkRectilinearGrid with clwmr, t and gh

Cloud water and cloud fraction are taken from where the air was before, traced back in the wind of the one forecast time: horizontally, on each level, without condensation. The noise
that breaks the clouds (fine_clouds.py) is moved by the mean wind of the troposphere, so that it is wound into bands which are as deep as those of a storm. Water is then smoothed over
neighbouring points. As in fine_clouds.py, what is finer than 2.5 degrees is made up; the mean water of the grid is that of the forecast.
"""
import fine_clouds
import numpy

EARTH_RADIUS = 6371000.0  # metres
DEEP = (300, 850)  # hPa: the levels whose mean wind moves the noise
STEP = 1800.0  # seconds of the way back
NOISE_REACH = 12.0  # degrees from where noise is made: air comes from outside


def cubic(field, axes, x, y):
    """The field (latitude, longitude) at places in degrees, by the cubic of Catmull and Rom; `axes`: its longitudes, around the globe, and latitudes."""
    def parts(axis, at):
        at = (at - axis[0]) / (axis[1] - axis[0])
        first = numpy.floor(at).astype(int)
        t = at - first
        return first - 1, (-0.5 * t + t**2 - 0.5 * t**3, 1 - 2.5 * t**2 + 1.5 * t**3, 0.5 * t + 2 * t**2 - 1.5 * t**3, -0.5 * t**2 + 0.5 * t**3)

    height, width = field.shape
    i, of_x = parts(axes[0], x)
    j, of_y = parts(axes[1], y)
    return sum(b * a * field[numpy.clip(j + n, 0, height - 1), (i + m) % width] for n, b in enumerate(of_y) for m, a in enumerate(of_x))


def traced_back(x, y, wind, axes, hours):
    """Longitudes and latitudes where air was `hours` before it came to the points of a grid, by midpoint steps."""
    lon, lat = numpy.meshgrid(x, y)
    count = int(numpy.ceil(hours * 3600 / STEP))

    def moved(at, share):
        u, v = (cubic(field, axes, *at) for field in wind)
        degrees = share * numpy.degrees(hours * 3600 / count / EARTH_RADIUS)
        return lon - degrees * u / numpy.cos(numpy.radians(at[1])), lat - degrees * v

    for _ in range(count):
        lon, lat = moved(moved((lon, lat), 0.5), 1)
    return lon, lat


def smooth(field):
    """The field (latitude, longitude) with the weights 1, 2, 1 three times in both directions: softer edges, the same mean."""
    for axis in 3 * (0, 1):
        padded = numpy.pad(field, [(1, 1) if k == axis else (0, 0) for k in (0, 1)], "edge")
        field = 0.25 * (padded[:-2] + 2 * padded[1:-1] + padded[2:] if axis == 0 else padded[:, :-2] + 2 * padded[:, 1:-1] + padded[:, 2:])
    return field


def origins(x, y, winds, axes, hours):
    """For each of the winds: longitudes and latitudes where the air of a grid was. Traced at every degree, cubic in between."""
    coarse = [numpy.arange(numpy.floor(values[0]) - 2, values[-1] + 3.0) for values in (x, y)]
    traced = numpy.array([traced_back(*coarse, wind, axes, hours) for wind in winds])
    shifts = traced - numpy.meshgrid(*coarse)
    here = numpy.meshgrid(x, y)
    return [[at + cubic(shift, coarse, *here) for at, shift in zip(here, level)] for level in shifts]


def moved_grid(longitudes, latitudes, step, hours, seed=1, slope=3.0, power=6, longest=14.0, thickness=8.0):
    """Noise of power k^-slope, up to the wavelength `longest` (degrees), smooth over `thickness` levels; `power`: as in fine_clouds.broken."""
    (lon, lat, level), fields = fine_clouds.forecast(("cloud_fraction", "clwmr", "t", "gh", "u", "v"))
    x, y = (numpy.arange(a, b + step / 2, step) for a, b in (longitudes, latitudes))
    back = origins(x, y, zip(fields["u"], fields["v"]), (lon, lat), hours)
    deep = (abs(level) >= DEEP[0]) & (abs(level) <= DEEP[1])  # the reader turns the axis round
    (swirl,) = origins(x, y, [(fields["u"][deep].mean(axis=0), fields["v"][deep].mean(axis=0))], (lon, lat), hours)
    noise_axes = [numpy.arange(a - NOISE_REACH, b + NOISE_REACH, step) for a, b in (longitudes, latitudes)]
    noise = fine_clouds.fractal_noise((len(level), len(noise_axes[1]), len(noise_axes[0])), seed, slope, thickness, longest / step)
    along, up = fine_clouds.weights(lon, x, len(lon)), fine_clouds.weights(lat, y)
    fine = {name: numpy.einsum("yj,kji,xi->kyx", up, fields[name], along, optimize=True) for name in ("t", "gh")}
    water, fraction = (numpy.array([cubic(field, (lon, lat), *at) for field, at in zip(fields[name], back)]) for name in ("clwmr", "cloud_fraction"))
    noise = numpy.array([cubic(field, noise_axes, *swirl) for field in noise])
    broken = fine_clouds.broken(numpy.maximum(water, 0), numpy.clip(fraction, 0, 1), numpy.clip(noise, 0, 1), power)
    smoothed = numpy.array([smooth(field) for field in broken])
    fine["clwmr"] = smoothed * (water.clip(min=0).mean() / smoothed.mean())
    return fine_clouds.grid_of(x, y, level, fine)
