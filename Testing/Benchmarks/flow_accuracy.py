# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Errors of vtkFlowVolume in flows of which particles and volumes are known, and their order.

    ./nephoscope bench

Smoke of one second in N layers, from a triangle of n x n triangles. A row doubles what its third column names, three times; the order
is the slope of the logarithms from the first to the last. Lengths are in those of the data: the legs of the triangle are 0.2. Linear
flows are exact on any grid; that of Arnold, Beltrami and Childress (ABC) is sampled on an image, of 96^3 cells unless a row says otherwise.
"""
import math

import numpy as np
from nephoscope_testing import known_flows as known
from nephoscope_testing.flow import flow_volume, radius_of, update
from nephoscope_testing.particle_surface import hausdorff_distance, surface_of_particles
from nephoscope_testing.time_series import TimeSeries

LAYERS = (8, 16, 32, 64)
DIVISIONS = (1, 2, 4, 8)
ROUNDING = 1e-12
CHAOTIC = known.ABC()
RUNGE_KUTTA_45 = {"Integrator": 1, "Tolerance": 1e-9}


def row(flow, quantity, refined, errors):
    errors = list(errors)
    if max(map(abs, errors)) < ROUNDING:
        order = "rounding"
    else:
        order = f"{math.log2(abs(errors[0] / errors[-1])) / (len(errors) - 1):.1f}"
    print(f"| {flow} | {quantity} | {refined} | " + " | ".join(f"{error:+.1e}" for error in errors) + f" | {order} |", flush=True)


class Study:
    """One flow, sampled once; a volume that several rows ask for is made once."""

    def __init__(self, flow, blocks=2):
        self.flow, self.data, self.made = flow, known.sampled(flow, blocks), {}

    def smoke(self, steps, n, **settings):
        key = steps, n, *settings.items()
        if key not in self.made:
            self.made[key] = known.smoke_of(self.flow, steps, n, self.data, **settings)
        return self.made[key]

    def volume_error(self, steps, n):
        return self.smoke(steps, n).volumes().sum() / self.flow.volume() - 1

    def bilinear_error(self, steps, n):
        return known.bilinear_volumes(self.smoke(steps, n), steps).sum() / self.flow.volume() - 1

    def drift(self, steps, n):
        return known.drift(self.smoke(steps, n), self.flow, steps)

    def row(self, quantity, measure, n=None):
        """By layers: with n x n triangles, or n = N / 4."""
        row(self.flow.name, quantity, f"N from 8, n = {n or 'N/4'}", [measure(steps, n or steps // 4) for steps in LAYERS])


def volumes(study, *divisions):
    for n in divisions:
        study.row("volume of tetrahedra", study.volume_error, n)


def linear(flow):
    study = Study(flow)
    volumes(study, 1, 4)
    return study


def prisms(study):
    """Bilinear prisms beside the closed form of what a step of Runge-Kutta 4, and of the true flow, moves."""
    flow = study.flow

    def by_runge_kutta(steps):
        return flow.layered_volume(steps, lambda matrix: known.series(matrix, 4)) / flow.volume() - 1

    study.row("volume of prisms", study.bilinear_error, 4)
    study.row("the same, less its closed form", lambda steps, n: study.bilinear_error(steps, n) - by_runge_kutta(steps), 4)
    row(flow.name, "closed form without error of Runge-Kutta 4", "N from 8", [flow.layered_volume(steps) / flow.volume() - 1 for steps in LAYERS])


def shape(study):
    study.row("points from their particles", lambda steps, n: known.furthest_particle(study.smoke(steps, n), study.flow, steps), 4)
    study.row("the same, Runge-Kutta 4-5", lambda steps, n: known.furthest_particle(
        study.smoke(steps, n, **RUNGE_KUTTA_45), study.flow, steps), 4)
    study.row("drift of a layer", study.drift, 4)
    study.row("drift of a layer", study.drift)
    particles = surface_of_particles(study.flow)
    distance = lambda steps, n: hausdorff_distance(study.smoke(steps, n), particles)
    study.row("Hausdorff distance", distance, 4)
    study.row("Hausdorff distance", distance)


def spreading():
    study = linear(known.SPREADING)
    prisms(study)

    def ratio_error(steps, n):
        density = study.smoke(steps, n).density
        return density[-1] / density[0] / math.exp(-2 * (1 - 1 / steps)) - 1

    def density_error(steps, n):
        smoke = study.smoke(steps, n)
        return np.abs(smoke.density * np.exp(2 * smoke.cell_array("Age")) - 1).max()

    study.row("density, last over first layer", ratio_error, 4)
    study.row("density, from exp(-2 age)", density_error, 4)


def chaotic():
    """Errors of the steps, of the straight edges of the triangles, and of the grid, one after the other."""
    study = Study(CHAOTIC, 96)
    volumes(study, 1, 4, 8)
    study.row("volume of tetrahedra", study.volume_error)
    shape(study)
    row("ABC", "volume of prisms", "n from 1, N = 64", [study.bilinear_error(64, n) for n in DIVISIONS])
    row("ABC", "flux through the polygon", "n from 1, N = 64", [study.smoke(64, n).made.GetEmittedMass() / CHAOTIC.flux - 1 for n in DIVISIONS])
    by_grid = [Study(CHAOTIC, blocks).smoke(64, 16) for blocks in (12, 24, 48, 96)]
    refined = "grid from 12^3 cells, N = 64, n = 16"
    row("ABC", "points from their particles", refined, [known.furthest_particle(smoke, CHAOTIC, 64) for smoke in by_grid])
    row("ABC", "volume of tetrahedra", refined, [smoke.volumes().sum() / CHAOTIC.volume() - 1 for smoke in by_grid])


def circling(_points, time):
    return np.cos(known.TURN * time), np.sin(known.TURN * time), 1


def streak_of(steps, data_steps):
    source = TimeSeries(np.linspace(0, 1, data_steps + 1), circling)
    return update(flow_volume(source, Unsteady=True, NormalToFlow=False, Radius=radius_of(0.02), NumberOfSides=3, TimeStep=1 / steps,
                              MaximumEdgeLength=10))[0]


def streak():
    """(cos, sin, 1) turns once; smoke of t = 1/2 is at (0, -1 / pi, 1/2) in the end. Between time steps of the data the wind is linear."""
    made = [streak_of(steps, 64) for steps in LAYERS]
    row("streak", "volume of tetrahedra", "N from 8, 64 time steps of data", [smoke.volumes().sum() / 0.02 - 1 for smoke in made])
    by_data = [streak_of(16, steps) for steps in LAYERS]
    places = [smoke.points[np.abs(smoke.age - 0.5) < 1e-9].mean(axis=0) for smoke in by_data]
    row("streak", "place of smoke of half a second", "time steps of data from 8, N = 16",
        [np.linalg.norm(place - (0, -1 / np.pi, 0.5)) for place in places])


def main():
    print("| flow | error of | doubled | | | | | order |")
    print("|---|---|---|---|---|---|---|---|")
    linear(known.UNIFORM)
    linear(known.OBLIQUE)
    for flow in (known.SADDLE, known.HELIX):
        study = linear(flow)
        prisms(study)
        shape(study)
    spreading()
    chaotic()
    streak()


if __name__ == "__main__":
    main()
