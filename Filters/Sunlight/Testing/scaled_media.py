#!/usr/bin/env python3
# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""
Errors of delta scaling, by the Monte Carlo of monte_carlo.py: light in scaled media against the tables of the unscaled ones, and the filter's aureole behind level clouds.

    ./nephoscope python Filters/Sunlight/Testing/scaled_media.py [cloud] [cube] [aureole]   # prints these figures of the README, or all: about ten minutes
"""
import json
import sys

import monte_carlo
import numpy as np

G = monte_carlo.ASYMMETRY
COSINES = np.linspace(-1, 1, 4001)
TABLES = json.loads(monte_carlo.TABLE.read_text())


def henyey_greenstein(g):
    return (1 - g * g) / (1 + g * g - 2 * g * COSINES) ** 1.5


def cut_series(f):
    """Two Legendre coefficients less the forward peak f, not below 0: the P of the README."""
    first, second = (G - f) / (1 - f), (G * G - f) / (1 - f)
    return np.maximum(1 + 3 * first * COSINES + 2.5 * second * (3 * COSINES**2 - 1), 0)


MEDIA = {"f = g^2, P = H(g')": (G**2, henyey_greenstein(G / (1 + G))), "f = g^3, P = max(1 + 3 g' x + 5 h' P2, 0)": (G**3, cut_series(G**3))}


def use_phase(phase):
    """Lets monte_carlo scatter by a phase function at COSINES."""
    sums = np.concatenate(([0], np.cumsum(phase[1:] + phase[:-1])))

    def scattered(way, random):
        cosine = np.interp(random.random(way.shape[1]) * sums[-1], sums, COSINES)
        sine, angle = np.sqrt(np.maximum(1 - cosine**2, 0)), 2 * np.pi * random.random(way.shape[1])
        x, y, z = way
        flat = np.maximum(np.hypot(x, y), 1e-12)
        p, q = sine * np.cos(angle), sine * np.sin(angle)
        new = np.array((cosine * x + (p * x * z - q * y) / flat, cosine * y + (p * y * z + q * x) / flat, cosine * z - p * flat))
        return new / np.sqrt((new * new).sum(0))

    monte_carlo.scattered = scattered


def print_cloud(batches=24):
    """Greatest errors over the suns and albedos of the step cloud: of the mean reflectance, of a column of it, and of a column of transmittance."""
    step = monte_carlo.CLOUDS["step"]
    for name, (f, phase) in MEDIA.items():
        use_phase(phase)
        worst = np.zeros(3)
        for case, (cloud, zenith, azimuth, w) in monte_carlo.CASES.items():
            if cloud == "step":
                scaled = monte_carlo.Cloud((1 - w * f) * step.extinction, step.across, step.up, nearest=True)
                found = np.mean([monte_carlo.batch(scaled, monte_carlo.sun_of(zenith, azimuth), (1 - f) * w / (1 - w * f), np.random.default_rng((9, n)))
                                 for n in range(batches)], axis=0)
                up, down = (np.array(TABLES[case][kind]) for kind in ("reflectance", "transmittance"))
                worst = np.maximum(worst, (abs(found[0].mean() / up.mean() - 1), np.abs(found[0] / up - 1).max(), np.abs(found[1] / down - 1).max()))
        print(f"step cloud, {name}: mean {worst[0]:.1%}, column {worst[1]:.1%}, column of transmittance {worst[2]:.1%}", flush=True)


def print_cube(batches=40):
    """The thin cube below an overhead sun."""
    for name, (f, phase) in MEDIA.items():
        use_phase(phase)
        found = np.mean([monte_carlo.cube_batch(2 * (1 - f), monte_carlo.sun_of(0, 0), 1, np.random.default_rng((9, n))) for n in range(batches)], axis=0)
        print(f"thin cube, {name}: top {found[0]:.4f}, base {found[1]:.4f}, sides {found[2]:.4f}", flush=True)


def leaving(depth, edges, photons=1500000, batch=100000):
    """pi times the radiance below a level cloud under an overhead sun, scattered at least once, between angles from the beam; and its statistical errors."""
    random, counts = np.random.default_rng(1), np.zeros(len(edges) - 1)
    for _ in range(photons // batch):
        z, way, times = np.full(batch, float(depth)), np.array((1e-9, 0, -1.0))[:, None].repeat(batch, 1), np.zeros(batch, int)
        while z.size:
            z = z + random.exponential(1, z.size) * way[2]
            below = (z < 0) & (times > 0)
            counts += np.histogram(np.arccos(np.clip(-way[2, below], -1, 1)), edges)[0]
            inside = (z > 0) & (z < depth)
            z, way, times = z[inside], way[:, inside], times[inside] + 1
            way = monte_carlo.scattered(way, random)
    solid = np.pi * (np.sin(edges[1:]) ** 2 - np.sin(edges[:-1]) ** 2)
    return np.pi * counts / photons / solid, 1 / np.sqrt(np.maximum(counts, 1))


def filtered(depth, angles):
    """The same by the filter."""
    from TestSunlightView import LEVELS, Column
    column, light = Column(depth, 1.0), []
    for angle in angles:
        way = np.array((np.sin(angle), 0, -np.cos(angle)))
        place = np.arccos(-way @ column.sun) / np.pi * (len(column.phase) - 1)
        factors = [np.interp(place, np.arange(len(column.phase)), column.phase[:, k]) - 1 for k in (0, 1)]
        source = column.values("Sunlight") + column.values("DiffuseFlux") @ way + column.values("SingleScattering") @ factors
        source += (1.5 * way[2] ** 2 - 0.5) * column.values("DiffuseSecondMoment")
        heights, levels = np.linspace(0, 1, 2001), np.linspace(0, 1, LEVELS)
        source, extinction = (np.interp(heights, levels, values) for values in (source, column.values("ScaledExtinction")))
        below = np.append(0, np.cumsum(extinction[1:] + extinction[:-1])) / 4000 / np.cos(angle)
        sent = source * extinction / np.cos(angle) * np.exp(-below)
        light.append(np.sum(sent[1:] + sent[:-1]) / 4000)
    return np.array(light)


def print_aureole():
    edges = np.radians([0, 1, 2, 3.5, 5, 7, 10, 15])
    use_phase(henyey_greenstein(G))
    for depth in (0.3, 1, 3, 6, 10):
        light, errors = leaving(depth, edges)
        ratios = filtered(depth, (edges[1:] + edges[:-1]) / 2) / light
        print(f"optical depth {depth}: within 5 degrees {ratios[:4].min():.2f} to {ratios[:4].max():.2f}, 10 to 15 degrees {ratios[-1]:.2f}; statistical errors "
              f"{errors.min():.1%} to {errors.max():.1%}", flush=True)


if __name__ == "__main__":
    prints = {"cloud": print_cloud, "cube": print_cube, "aureole": print_aureole}
    for name in sys.argv[1:] or prints:
        prints[name]()
