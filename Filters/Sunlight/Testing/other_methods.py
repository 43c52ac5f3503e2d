#!/usr/bin/env python3
# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""
Other approximations of multiple scattering, compared with the Monte Carlo tables of monte_carlo.py: the reflectance of every column of periodic clouds. They share no code with the filter.
The errors of the filter itself are printed by `ctest -R TestSunlightMonteCarlo -V`.

- Independent columns: every column reflects as a level cloud of its optical depth, by the delta-Eddington approximation (JosephWiscombeWeinman1976) in the closed form of
  MeadorWeaver1980. The sun is slanted, but its beam stays inside the column.
- Octaves (WrenningeKullaLundqvist2013): a sum of single scatterings. In the i-th the extinction towards sun and eye is multiplied by a^i, the scattered light by b^i and the asymmetry
  parameter by c^i; a = b = c = 0.5, i = 0 to 7. Rays go straight through the periodic cloud. pi times the radiance straight up is not a flux, so it would differ from the
  Monte Carlo even without an error. The flux, the integral of the radiance over all upward directions, is therefore compared too. Some renderers keep the whole extinction
  towards the eye: "sun only".

    python3 Filters/Sunlight/Testing/other_methods.py [CASE ...]   # prints a Markdown table of the cases, or all: mean reflectance, its error, worst column, rms
"""
import json
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import monte_carlo  # noqa: E402

SCALE = 0.5  # a, b and c of the octaves
STEPS, RAYS = 256, 8  # steps of a ray; rays that leave the top of each column
COSINES, AZIMUTHS = 6, 12  # directions of the flux


def two_stream(depth, sun, albedo, asymmetry=monte_carlo.ASYMMETRY):
    """Reflectance of level clouds by delta-Eddington, above black ground. `depth`: an array of optical depths; `sun`: cosine of its zenith angle."""
    f = asymmetry**2
    t, w, g = (1 - albedo * f) * np.asarray(depth, float), (1 - f) * albedo / (1 - albedo * f), asymmetry / (1 + asymmetry)
    y1, y2, y3 = (7 - w * (4 + 3 * g)) / 4, (w * (4 - 3 * g) - 1) / 4, (2 - 3 * g * sun) / 4
    if albedo == 1:
        return (y1 * t + (y3 - y1 * sun) * (1 - np.exp(-t / sun))) / (1 + y1 * t)
    k, a2 = np.sqrt(y1 * y1 - y2 * y2), y1 * y3 + y2 * (1 - y3)
    beam, fade = np.exp(-t / sun), np.exp(-k * t)  # all terms below are multiplied by fade
    terms = (1 - k * sun) * (a2 + k * y3) - (1 + k * sun) * (a2 - k * y3) * fade**2 - 2 * k * (y3 - a2 * sun) * beam * fade
    return w * terms / ((1 - (k * sun) ** 2) * (k + y1 + (k - y1) * fade**2))


def independent_columns(cloud, sun, albedo):
    dense = cloud.extinction
    return two_stream(cloud.up * (dense.sum(0) - (dense[0] + dense[-1]) / 2), sun[2], albedo)


def rays(cloud, way):
    """Rays along the upward direction `way`, in order of where they leave the top: positions x, optical depths of the steps and optical depths up to the top, as [step, ray]."""
    z = (np.arange(STEPS)[:, None] + 0.5) * cloud.height / STEPS
    top = ((np.arange(cloud.columns * RAYS) + 0.5) / RAYS - 0.5) * cloud.across
    x = top - (cloud.height - z) * way[0] / way[2]
    steps = cloud.at(x, np.broadcast_to(z, x.shape)) * cloud.height / STEPS / way[2]
    return x, steps, np.cumsum(steps[::-1], 0)[::-1] - steps / 2


def towards_sun(cloud, sun, x, depth):
    """Optical depths from points towards the sun, between those of the nearest two rays. `depth`: of the rays towards the sun."""
    height = (np.arange(STEPS)[::-1, None] + 0.5) * cloud.height / STEPS  # from each step to the top
    ray = ((x + height * sun[0] / sun[2]) / cloud.across + 0.5) * RAYS - 0.5
    before, step = np.floor(ray).astype(int), np.arange(STEPS)[:, None]
    part, count = ray - before, depth.shape[1]
    return depth[step, before % count] * (1 - part) + depth[step, (before + 1) % count] * part


def radiance(cloud, sun, albedo, view, octaves=8, sun_only=False):
    """pi times the radiance in the upward direction `view` above every column, over the irradiance of the sun on a level surface. `sun_only`: octaves keep the extinction towards the eye."""
    x, steps, to_eye = rays(cloud, view)
    to_sun, cosine, light = towards_sun(cloud, sun, x, rays(cloud, sun)[2]), -np.dot(sun, view), 0
    for scale in SCALE ** np.arange(octaves):
        g = scale * monte_carlo.ASYMMETRY
        phase = (1 - g * g) / (1 + g * g - 2 * g * cosine) ** 1.5
        light = light + scale * phase * (steps * np.exp(-scale * to_sun - (1 if sun_only else scale) * to_eye)).sum(0)
    return albedo / (4 * sun[2]) * light.reshape(cloud.columns, RAYS).mean(1)


def nadir_of_octaves(cloud, sun, albedo):
    return radiance(cloud, sun, albedo, (0, 0, 1))


def nadir_of_sun_only(cloud, sun, albedo):
    return radiance(cloud, sun, albedo, (0, 0, 1), sun_only=True)


def flux_of_octaves(cloud, sun, albedo, octaves=8):
    nodes, weights = np.polynomial.legendre.leggauss(COSINES)
    flux = 0
    for cosine, weight in zip((nodes + 1) / 2, weights / 2):
        for azimuth in (np.arange(AZIMUTHS) + 0.5) * 360 / AZIMUTHS:
            view = monte_carlo.sun_of(np.degrees(np.arccos(cosine)), azimuth)
            flux = flux + 2 * weight * cosine / AZIMUTHS * radiance(cloud, sun, albedo, view, octaves)
    return flux


METHODS = {"independent columns": independent_columns, "octaves, radiance straight up": nadir_of_octaves, "the same, sun only": nadir_of_sun_only, "octaves, flux": flux_of_octaves}


def errors(case, method):
    """Mean reflectance; relative errors of the mean, of the worst column, and rms of columns."""
    name, zenith, azimuth, albedo = monte_carlo.CASES[case]
    found = method(monte_carlo.CLOUDS[name], monte_carlo.sun_of(zenith, azimuth), albedo)
    true = np.array(json.loads(monte_carlo.TABLE.read_text())[case]["reflectance"])
    error = found / true - 1
    return found.mean(), found.mean() / true.mean() - 1, np.abs(error).max(), np.sqrt((error**2).mean())


if __name__ == "__main__":
    print("| cloud and sun | " + " | ".join(METHODS) + " |\n" + "|---" * (1 + len(METHODS)) + "|")
    for case in sys.argv[1:] or monte_carlo.CASES:
        cells = ("{:.3f} ({:+.0%}); {:.0%}, {:.0%}".format(*errors(case, method)).replace("%", " %") for method in METHODS.values())
        print(f"| {case} | " + " | ".join(cells) + " |")
