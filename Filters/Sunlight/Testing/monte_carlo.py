#!/usr/bin/env python3
# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""
Reference light of periodic clouds by Monte Carlo, for TestSunlightMonteCarlo, and of cubes of cloud alone, for TestSunlightOpen. It shares no code with the filter. Photons move by the
method of the greatest extinction (WoodcockEtAl1965); the periodic clouds do not change along y. Phase function: Henyey and Greenstein, g = 0.85; black ground; no light of the sky.

    python3 Filters/Sunlight/Testing/monte_carlo.py [CASE ...]   # writes the cases, or all, to monte_carlo.json: half an hour of processor time for all
"""
import json
import pathlib
import sys

import numpy as np

TABLE = pathlib.Path(__file__).with_suffix(".json")
ASYMMETRY, BATCH, BATCHES = 0.85, 50000, {"cumulus 30": 260}  # photons; batches for a statistical error below 0.5 %, by default 200


class Cloud:
    """Extinctions (1/km) at points, as [level, column], with their spacings in km. Between points they are linear, or those of the nearest column."""

    def __init__(self, extinction, across, up, nearest=False):
        self.extinction, self.across, self.up, self.nearest = extinction, across, up, nearest
        self.levels, self.columns = extinction.shape
        self.height, self.densest = up * (self.levels - 1), extinction.max()

    def column(self, x):
        return np.floor(x / self.across + 0.5).astype(int) % self.columns

    def at(self, x, z):
        if self.nearest:
            return self.extinction[0, self.column(x)]
        i, k = np.floor(x / self.across).astype(int), np.minimum((z / self.up).astype(int), self.levels - 2)
        a, c = x / self.across - i, z / self.up - k
        i, j = i % self.columns, (i + 1) % self.columns
        low, high = (self.extinction[k + n, i] * (1 - a) + self.extinction[k + n, j] * a for n in (0, 1))
        return low * (1 - c) + high * c


def cascade(steps=6, mean=13.0, share=0.5, scaling=2 ** (-1 / 3)):
    """Optical depths of a bounded cascade, as of marine stratocumulus (CahalanEtAl1994): in each step half of every part gives a share to the other half."""
    depths, random = np.array([mean]), np.random.default_rng(6)
    for n in range(steps):
        moved = share * scaling**n * random.choice((-1, 1), depths.size)
        depths = np.ravel([depths * (1 + moved), depths * (1 - moved)], "F")
    return depths


def cumulus(columns=64, levels=33):
    """A row of three clouds with flat bases; optical depths up to 22."""
    x, z = np.meshgrid(np.arange(columns) / columns, np.arange(levels) / (levels - 1))
    lumps = [(0.2, 0.14, 0.8), (0.52, 0.08, 0.45), (0.75, 0.12, 0.62)]  # middle, half width, height of the top
    dense = sum(np.maximum(1 - ((x - a) / w) ** 2 - (np.maximum(z - 0.2, 0) / (h - 0.2)) ** 2, 0) for a, w, h in lumps)
    return np.where(z < 0.15, 0, 60 * dense)


CLOUDS = {"step": Cloud(np.repeat([8.0, 72.0], 16)[None].repeat(33, 0), 0.015625, 0.25 / 32, nearest=True),  # I3RC case 1
          "cascade": Cloud(cascade()[None].repeat(33, 0) / 0.3, 0.025, 0.3 / 32), "cumulus": Cloud(cumulus(), 0.025, 0.8 / 32)}
# Cloud, zenith angle of the sun, its azimuth (from -x: 180, from y: 90), single-scattering albedo.
CASES = {"step 0": ("step", 0, 0, 1), "step 30": ("step", 30, 180, 1), "step 60": ("step", 60, 180, 1), "step 60 along": ("step", 60, 90, 1),
         "step 75": ("step", 75, 180, 1), "step 0 absorbing": ("step", 0, 0, 0.99), "step 60 absorbing": ("step", 60, 180, 0.99),
         "cascade 60": ("cascade", 60, 180, 1), "cumulus 30": ("cumulus", 30, 180, 1), "cumulus 60 absorbing": ("cumulus", 60, 180, 0.99)}

# Optical depth along each edge of a cube, and the rest as above.
CUBES = {"cube 0": (10, 0, 0, 1), "cube 60": (10, 60, 180, 1), "cube 60 absorbing": (10, 60, 180, 0.99),
         "thin cube 0": (2, 0, 0, 1), "thick cube 0": (40, 0, 0, 1)}


def sun_of(zenith, azimuth):
    a, b = np.radians((zenith, azimuth))
    return np.array((np.sin(a) * np.cos(b), np.sin(a) * np.sin(b), np.cos(a)))


def scattered(way, random):
    """Directions after scattering, from those before as (3, photons)."""
    g = ASYMMETRY
    cosine = (1 + g * g - ((1 - g * g) / (1 - g + 2 * g * random.random(way.shape[1]))) ** 2) / (2 * g)
    sine, angle = np.sqrt(np.maximum(1 - cosine**2, 0)), 2 * np.pi * random.random(way.shape[1])
    x, y, z = way
    flat = np.hypot(x, y)
    p, q = sine * np.cos(angle), sine * np.sin(angle)
    new = np.array((cosine * x + (p * x * z - q * y) / flat, cosine * y + (p * y * z + q * x) / flat, cosine * z - p * flat))
    return new / np.sqrt((new * new).sum(0))


def batch(cloud, sun, albedo, random, once=False):
    """Reflected, transmitted and absorbed fraction, as [kind, column]. `once`: in place of the first the radiance straight up after one scattering, times pi, over the irradiance of the sun."""
    x, z = random.random(BATCH) * cloud.columns * cloud.across, np.full(BATCH, cloud.height)
    way, weight, found = -sun[:, None].repeat(BATCH, 1), np.ones(BATCH), np.zeros((3, cloud.columns))
    way[0, way[2] == -1] = 1e-9
    while x.size:
        step = random.exponential(1 / cloud.densest, x.size)
        x, z = x + step * way[0], z + step * way[2]
        out = (z >= cloud.height) | (z <= 0)
        edge = np.where(z > 0, cloud.height, 0)[out]
        leaving = cloud.column(x[out] + (edge - z[out]) * way[0, out] / way[2, out])
        if not once:
            np.add.at(found, ((edge == 0).astype(int), leaving), weight[out])
        x, z, way, weight = x[~out], z[~out], way[:, ~out], weight[~out]
        hit = random.random(x.size) * cloud.densest < cloud.at(x, z)
        if once:  # for clouds that are the same at all levels
            angle, dense = way[2, hit], cloud.at(x[hit], z[hit])
            phase = (1 - ASYMMETRY**2) / (1 + ASYMMETRY**2 - 2 * ASYMMETRY * angle) ** 1.5
            np.add.at(found[0], cloud.column(x[hit]), sun[2] * albedo / 4 * phase * np.exp(-dense * (cloud.height - z[hit])))
            x, z, way, weight = x[~hit], z[~hit], way[:, ~hit], weight[~hit]
            continue
        if albedo < 1:
            np.add.at(found[2], cloud.column(x[hit]), (1 - albedo) * weight[hit])
            weight[hit] *= albedo
        way[:, hit] = scattered(way[:, hit], random)
    return found * cloud.columns / BATCH


def cube_batch(depth, sun, albedo, random):
    """Fractions of the light on a uniform cube that leave its top, its base and its sides, and that it absorbs."""
    lit = np.abs(sun) / np.abs(sun).sum()  # of its faces
    photons, face = np.arange(BATCH), random.choice(3, BATCH, p=lit)
    at, way, weight, found = random.random((3, BATCH)), -sun[:, None].repeat(BATCH, 1), np.ones(BATCH), np.zeros(4)
    at[face, photons] = sun[face] > 0
    way[0, way[2] == -1] = 1e-9
    while weight.size:
        at = at + random.exponential(1 / depth, weight.size) * way
        beyond = np.maximum(np.where(way > 0, at - 1, -at), 0) / np.maximum(np.abs(way), 1e-30)  # the way since each face
        out, last = beyond.max(0) > 0, beyond.argmax(0)
        kind = np.where(last < 2, 2, way[2] < 0)
        np.add.at(found, kind[out], weight[out])
        at, way, weight = at[:, ~out], way[:, ~out], weight[~out]
        found[3] += (1 - albedo) * weight.sum()
        weight, way = albedo * weight, scattered(way, random)
    return found / BATCH


def cube_table(name):
    depth, zenith, azimuth, albedo = CUBES[name]
    found = np.array([cube_batch(depth, sun_of(zenith, azimuth), albedo, np.random.default_rng((7, n))) for n in range(40)])
    mean, error = found.mean(0), found[:, :3].std(0) / np.sqrt(len(found))
    return {**{kind: float(f"{v:.5g}") for kind, v in zip(("top", "base", "sides", "absorbed"), mean)}, "error": float(f"{(error / mean[:3]).max():.2g}")}


def table(name):
    """Means of the batches, and the greatest of their statistical errors, relative to the value."""
    once = name.endswith("once")
    cloud, zenith, azimuth, albedo = CASES[name.removesuffix(" once")]
    found = np.array([batch(CLOUDS[cloud], sun_of(zenith, azimuth), albedo, np.random.default_rng((7, n)), once) for n in range(1600 if once else BATCHES.get(name, 200))])
    mean, error = found.mean(0), found.std(0) / np.sqrt(len(found))
    made = {kind: [float(f"{v:.4g}") for v in mean[n]] for n, kind in enumerate(("reflectance", "transmittance", "absorptance")) if mean[n].any()}
    return {**made, "error": float(f"{(error[0] / mean[0]).max():.2g}")}


if __name__ == "__main__":
    for name in sys.argv[1:] or [*CASES, "step 0 once", "step 60 once", *CUBES]:
        made = cube_table(name) if name in CUBES else table(name)
        tables = {**(json.loads(TABLE.read_text()) if TABLE.exists() else {}), name: made}
        TABLE.write_text(json.dumps(dict(sorted(tables.items())), indent=0).replace(",\n", ", ").replace("], ", "],\n").replace("}, ", "},\n") + "\n")
