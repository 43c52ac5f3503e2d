# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Smoke: meshes that overlap themselves in space, and a reference whose colour and opacity come from two arrays."""
import numpy as np

from . import meshes, polyhedra, reference


def boxes(parts, blocks=2):
    """Boxes of tetrahedra that share no points, wherever they lie: (low corner, high corner) each. Cell array "part": their numbers."""
    points, cells, part = [], [], []
    for number, (low, high) in enumerate(parts):
        box = meshes.Lattice(blocks).mesh("tetra")
        corners = meshes.points_of(box)
        first = sum(len(p) for p in points)
        points.append(np.asarray(low) + corners * (np.asarray(high, float) - low))
        cells += [[first + box.GetCell(i).GetPointId(k) for k in range(4)] for i in range(box.GetNumberOfCells())]
        part += [float(number)] * box.GetNumberOfCells()
    data = meshes.tetrahedra(np.vstack(points), cells)
    meshes.add_array(data.GetCellData(), np.array(part), "part")
    return data


def tube(centers, radius):
    """A square tube of prisms around a line of centres in the plane z = 0, which may cross itself; one connected mesh."""
    centers = np.asarray(centers, float)
    forward = np.gradient(centers, axis=0)
    side = np.stack([-forward[:, 1], forward[:, 0]], axis=1) / np.linalg.norm(forward, axis=1)[:, None]
    points, cells = [], []
    for i, (c, s) in enumerate(zip(centers, side)):
        points += [(*(c + a * radius * s), b * radius + 0.02 * i) for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
        if i + 1 < len(centers):
            ids = [4 * i + k for k in range(4)] + [4 * i + 4 + k for k in range(4)]
            cells += [[ids[k] for k in t] for t in meshes.KUHN]
    return meshes.tetrahedra(np.array(points), cells)


def loop(steps=40, radius=0.23):
    """A tube that turns once and goes on through itself."""
    t = np.linspace(-1, 1, steps)
    angle = 2 * np.pi * np.clip(t / 0.7, -1, 1) * 0.75
    centers = np.stack([1.4 * t + 0.9 * np.sin(angle), 0.9 * np.cos(angle)], axis=1)
    return tube(centers, radius)


def fan(turns=2.3, blades=23):
    """Tetrahedra around one edge, more than once around it: each place between two of them is covered twice or more."""
    angles = np.linspace(0, 2 * np.pi * turns, blades + 1)
    rim = [(np.cos(a), np.sin(a), 0.1 * np.sin(3 * a)) for a in angles]
    points = np.array([(0, 0, -0.6), (0, 0, 0.6)] + rim)
    return meshes.tetrahedra(points, [(0, 1, 2 + i, 3 + i) for i in range(blades)])


class TwoFields:
    """A transfer function of samples (colour's scalar, opacity's scalar), without control points between 0 and 1."""

    def __init__(self, transfer):
        self.transfer = transfer

    def color(self, s):
        return self.transfer.color(s[..., 0])

    def extinction(self, s):
        return self.transfer.extinction(s[..., 1])


def render(data, view, transfer, color, opacity, opaque=None):
    """RGBA (height, width, 4). color, opacity: (array, "point" or "cell"). opaque: world length along each ray."""
    fields = [polyhedra.from_dataset(data, *selection) for selection in (color, opacity)]
    origins, directions, _, _ = view.rays()
    pixel, t0, t1, cell = reference.ray_segments(fields[0], view)
    if opaque is not None:
        t1 = np.minimum(t1, opaque.ravel()[pixel])
        keep = t1 > t0
        pixel, t0, t1, cell = (a[keep] for a in (pixel, t0, t1, cell))

    def samples(t):
        places = origins[pixel] + t[:, None] * directions[pixel]
        gradients, offsets = ([np.array([f[k] for f in cells.field])[cell] for cells in fields] for k in (0, 1))
        return np.stack([np.einsum("ij,ij->i", places, g) + o for g, o in zip(gradients, offsets)], axis=1)
    depth, emission = reference.integrate(t1 - t0, samples(t0), samples(t1), TwoFields(transfer), "exact", False)
    return reference.composite(pixel, depth, emission, view)
