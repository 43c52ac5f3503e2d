# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""
The exact light that a level slab of cloud reflects, by doubling of thin layers (Hansen1971) for each Fourier term of the azimuth. Black ground, no light
of the sky, Henyey-Greenstein phase function.
"""
import numpy as np


def legendre(order, cosines, terms):
    """Associated Legendre functions of one order, normalized so that their products for two directions add up to the phase function: an array (terms, cosines)."""
    x = np.asarray(cosines, float)
    table = np.zeros((terms, x.size))
    table[order] = np.prod([np.sqrt((1 - x * x) * (2 * k - 1) / (2 * k)) for k in range(1, order + 1)], axis=0)
    for degree in range(order + 1, terms):
        before = table[degree - 2] if degree - 2 >= order else 0
        table[degree] = ((2 * degree - 1) * x * table[degree - 1] - np.sqrt((degree - 1) ** 2 - order**2) * before) / np.sqrt(degree**2 - order**2)
    return table


def reflected(depth, asymmetry, sun, views, albedo=1, streams=16, orders=24, terms=120):
    """
    pi times the radiance, divided by the irradiance of the sun. `sun`: cosine of its zenith angle. `views`: pairs of the cosine of the zenith angle of the outgoing light
    and its azimuth, relative to the direction in which sunlight travels.
    """
    nodes, weights = np.polynomial.legendre.leggauss(streams)
    cosines = np.concatenate([0.5 * (nodes + 1), [sun], [view[0] for view in views]])
    weights = np.concatenate([0.5 * weights, np.zeros(1 + len(views))])
    light = np.zeros(len(views))
    halves = 18 + max(0, int(np.ceil(np.log2(depth))))
    for order in range(orders):
        coefficients = (2 * np.arange(terms) + 1) * asymmetry ** np.arange(terms)
        up, down = (legendre(order, sign * cosines, terms) for sign in (1, -1))
        forward, backward = ((up * coefficients[:, None]).T @ other for other in (up, down))
        if order == 0:  # makes the quadrature conserve light
            whole = 0.5 * (forward + backward) @ weights
            forward, backward = forward / whole[:, None], backward / whole[:, None]
        thin = depth / 2**halves
        direct = np.exp(-thin / cosines)
        back, through = backward * thin / (2 * cosines[:, None]), forward * thin / (2 * cosines[:, None])
        if order == 0:  # accounts for light scattered twice in the thin layer
            kept = albedo * cosines * (1 - direct) / ((weights * cosines) @ (back + through))
        back, through = back * kept, through * kept
        for _ in range(halves):
            echo = back * weights
            below = np.linalg.solve(np.eye(cosines.size) - echo @ echo, through + echo @ (back * direct))
            above = back * direct + echo @ below
            back, through = (back + direct[:, None] * above + (through * weights) @ above, direct[:, None] * below + through * direct + (through * weights) @ below)
            direct = direct * direct
        azimuths = np.array([view[1] for view in views])
        light += 0.5 * (1 if order == 0 else 2) * np.cos(order * azimuths) * back[streams + 1:, streams]
    return light


def reflected_fraction(depth, asymmetry, sun, albedo=1, streams=24):
    """The light that goes up from the slab, as a fraction of sunlight."""
    nodes, weights = np.polynomial.legendre.leggauss(streams)
    cosines = 0.5 * (nodes + 1)
    return reflected(depth, asymmetry, sun, [(cosine, 0) for cosine in cosines], albedo, streams, orders=1) @ (weights * cosines) / sun
