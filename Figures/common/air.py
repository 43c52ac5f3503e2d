# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The light that clear air scatters once (Rayleigh), in red, green and blue, before a globe whose heights are exaggerated.

Optical depths of the whole atmosphere at 650, 550 and 450 nm after Bodhaine et al. (1999); density falls by e in 8 km.
"""
import numpy

DEPTHS = numpy.array([0.049, 0.097, 0.222])
SCALE_HEIGHT = 8000.0
STEPS = 28


class Air:
    def __init__(self, radius, exaggeration, sun):
        self.radius, self.height, self.sun = radius, SCALE_HEIGHT * exaggeration, numpy.asarray(sun) / numpy.linalg.norm(sun)

    def sunlight(self, places):
        """The share of sunlight in each colour that arrives at places (..., 3); 0 in the planet's shadow."""
        r = numpy.linalg.norm(places, axis=-1)
        cosine = (places @ self.sun) / r
        # Airmass of Kasten and Young (1989) down to the horizon, and beyond it that of the horizon, until the planet hides the sun.
        angle = numpy.degrees(numpy.arccos(numpy.clip(cosine, 0, 1)))
        airmass = 1 / (numpy.clip(cosine, 0, 1) + 0.50572 * (96.07995 - angle) ** -1.6364)
        depth = numpy.exp(-numpy.maximum(r - self.radius, 0) / self.height) * airmass
        lit = (cosine > 0) | (r * numpy.sqrt(numpy.maximum(1 - cosine**2, 0)) > self.radius)
        return lit[..., None] * numpy.exp(-depth[..., None] * DEPTHS)

    def before(self, origin, direction, stop):
        """Light of the air before `stop` times the direction (NaN: the sky), and the share of the light from there that passes."""
        top = self.radius + 6 * self.height
        middle = -(origin * direction).sum(-1)
        root = top**2 - (origin**2).sum(-1) + middle**2
        half = numpy.sqrt(numpy.maximum(root, 0))
        start, end = numpy.maximum(middle - half, 0), numpy.where(numpy.isfinite(stop), stop, middle + half)
        step = numpy.where(root > 0, numpy.maximum(end - start, 0), 0) / STEPS
        phase = 0.75 * (1 + (direction @ self.sun) ** 2)
        light, depth = numpy.zeros(step.shape + (3,)), numpy.zeros(step.shape)
        for k in range(STEPS):
            place = origin + (start + (k + 0.5) * step)[..., None] * direction
            density = numpy.exp(-numpy.maximum(numpy.linalg.norm(place, axis=-1) - self.radius, 0) / self.height) / self.height * step
            passed = numpy.exp(-(depth + 0.5 * density)[..., None] * DEPTHS)
            light += 0.25 * (phase * density)[..., None] * DEPTHS * self.sunlight(place) * passed
            depth += density
        return light, numpy.exp(-depth[..., None] * DEPTHS)
