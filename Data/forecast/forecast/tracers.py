# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Fields that the wind carries over the sphere: semi-Lagrangian, bicubic, within the bounds of their surroundings.

Axes are (longitude, latitude, level). Each point takes the value of the place that its air comes from, one step before: the middle
of the way is found by iteration in Cartesian coordinates (Ritchie 1987), so that poles are like other places. The interpolation
is clipped to the four values around (Bermejo and Staniforth 1992).

Interpolation mixes, which air in this wind does not: the wind has no divergence, so the area over which a field exceeds a value,
for every value, must not change. AreaDistribution gives it back, and with it the mean and the extremes.
"""
import numpy as np

from . import sphere

HALO = 2  # rows beyond each pole


class Carrier:
    """Carries fields on one grid. latitudes: from south to north, in radians; rows at the poles may be among them."""

    def __init__(self, latitudes, longitudes, radius=sphere.EARTH_RADIUS):
        self.latitudes, self.longitudes, self.radius = latitudes, longitudes, radius
        self.rows, self.turned = rows_beyond_poles(latitudes)
        self.row_latitudes = extended_latitudes(latitudes)
        angle = 2.0 * np.pi * np.arange(longitudes) / longitudes
        lon, lat = np.meshgrid(angle, latitudes, indexing="ij")
        self.east = np.stack((-np.sin(lon), np.cos(lon), 0 * lon))[..., None]
        self.north = np.stack((-np.sin(lat) * np.cos(lon), -np.sin(lat) * np.sin(lon), np.cos(lat)))[..., None]
        self.points = np.stack((np.cos(lat) * np.cos(lon), np.cos(lat) * np.sin(lon), np.sin(lat)))[..., None]

    def carry(self, fields, east, north, seconds):
        """The fields after a step with the wind (m/s) of the middle of the step."""
        place = Place(self, self.departures(east, north, seconds))
        return [place.bounded(self.extend(field)) for field in fields]

    def departures(self, east, north, seconds, iterations=3):
        velocity = (self.east * east + self.north * north) / self.radius
        middle = self.points
        here = velocity
        for _ in range(iterations):
            middle = self.points - 0.5 * seconds * here
            middle = middle / np.sqrt((middle * middle).sum(axis=0))
            place = Place(self, middle)
            here = np.stack([place.linear(self.extend(component)) for component in velocity])
        return 2.0 * (self.points * middle).sum(axis=0) * middle - self.points

    def extend(self, field):
        """The field with HALO more rows beyond each pole, on the meridian opposite: (level, row * longitude)."""
        turned = np.roll(field, self.longitudes // 2, axis=0)
        rows = np.where(self.turned[None, :, None], turned[:, self.rows], field[:, self.rows])
        return np.ascontiguousarray(rows.transpose(2, 1, 0)).reshape(field.shape[2], -1)

    def sample(self, field, latitudes, longitudes):
        """The field at all the given latitudes and longitudes, bicubic within the bounds of the four values around."""
        lon, lat = np.meshgrid(longitudes, latitudes, indexing="ij")
        points = np.stack((np.cos(lat) * np.cos(lon), np.cos(lat) * np.sin(lon), np.sin(lat)))[..., None]
        place = Place(self, np.broadcast_to(points, points.shape[:3] + field.shape[2:]))
        return place.bounded(self.extend(field))


class Place:
    """Where points lie in a carrier's grid, for all interpolations there."""

    def __init__(self, carrier, points):
        self.shape, self.width = points.shape[1:], carrier.longitudes
        x, y, z = (p.transpose(2, 1, 0).reshape(points.shape[3], -1) for p in points)
        longitude = np.arctan2(y, x) * (self.width / (2.0 * np.pi))
        column = np.floor(longitude).astype(np.int64)
        self.along = longitude - column
        self.columns = [(column + k) % self.width for k in (-1, 0, 1, 2)]
        latitude = np.arctan2(z, np.hypot(x, y))
        rows = carrier.row_latitudes
        self.row = np.clip(np.searchsorted(rows, latitude.ravel(), "right").reshape(latitude.shape) - 1, 1, len(rows) - 3)
        self.nodes = [rows[self.row + k] for k in (-1, 0, 1, 2)]
        self.latitude = latitude

    def corner(self, padded, row, column):
        index = (self.row + (row - 1)) * self.width + self.columns[column]
        return np.take_along_axis(padded, index, axis=1)

    def around(self, padded):
        """The four values around."""
        return [self.corner(padded, row, column) for row in (1, 2) for column in (1, 2)]

    def linear(self, padded):
        a, b, c, d = self.around(padded)
        up = (self.latitude - self.nodes[1]) / (self.nodes[2] - self.nodes[1])
        lower, upper = a + self.along * (b - a), c + self.along * (d - c)
        return self.back(lower + up * (upper - lower))

    def bounded(self, padded):
        """Bicubic, between the lowest and the highest of the four values around."""
        along = lagrange(self.along, [-1.0, 0.0, 1.0, 2.0])
        across = lagrange(self.latitude, self.nodes)
        cubic = sum(across[r] * sum(along[c] * self.corner(padded, r, c) for c in range(4)) for r in range(4))
        a, b, c, d = self.around(padded)
        low, high = np.minimum(np.minimum(a, b), np.minimum(c, d)), np.maximum(np.maximum(a, b), np.maximum(c, d))
        return self.back(np.clip(cubic, low, high))

    def back(self, values):
        levels, (longitudes, latitudes) = self.shape[2], self.shape[:2]
        return values.reshape(levels, latitudes, longitudes).transpose(2, 1, 0)


class AreaDistribution:
    """How much of the sphere a field exceeds each value on, level by level."""

    def __init__(self, field, latitudes):
        self.poles = has_pole_rows(latitudes)
        self.areas = np.broadcast_to(sphere.area_weights(latitudes) / (2.0 * field.shape[0]), field.shape[:2]).ravel()
        levels = field.reshape(-1, field.shape[2]).T
        self.references = [self.ranked(level)[1:] for level in levels]

    def ranked(self, values):
        """(order, values in order, area below each of them), the area without its own half."""
        order = np.argsort(values, kind="stable")
        areas = self.areas[order]
        return order, values[order], np.cumsum(areas) - 0.5 * areas

    def restore(self, field):
        """The values changed, their order kept, so that the distribution is that of the first field."""
        made = np.empty_like(field)
        for k, (values, below) in enumerate(self.references):
            order, now, now_below = self.ranked(field[:, :, k].ravel())
            restored = np.interp(now_below, below, values)
            restored[now <= values[0]] = values[0]  # one value over an area: its places have no order
            level = np.empty_like(restored)
            level[order] = restored
            made[:, :, k] = level.reshape(field.shape[:2])
        if self.poles:
            for row in (0, -1):
                made[:, row] = made[:, row].mean(axis=0)
        return made


def lagrange(x, nodes):
    """The weights of four nodes at x."""
    weights = []
    for i, node in enumerate(nodes):
        weight = 1.0
        for k, other in enumerate(nodes):
            if k != i:
                weight = weight * (x - other) / (node - other)
        weights.append(weight)
    return weights


def has_pole_rows(latitudes):
    return bool(abs(latitudes[0]) > 0.5 * np.pi - 1e-6)


def rows_beyond_poles(latitudes):
    """(row, whether it is taken half a turn away) of every extended row."""
    count, first = len(latitudes), 1 if has_pole_rows(latitudes) else 0
    south = [first + HALO - 1 - k for k in range(HALO)]
    rows = np.array(south + list(range(count)) + [count - 1 - row for row in reversed(south)])
    turned = np.zeros(len(rows), bool)
    turned[:HALO] = turned[-HALO:] = True
    return rows, turned


def extended_latitudes(latitudes):
    rows, turned = rows_beyond_poles(latitudes)
    extended = latitudes[rows]
    extended[:HALO] = -np.pi - extended[:HALO]
    extended[-HALO:] = np.pi - extended[-HALO:]
    return extended
