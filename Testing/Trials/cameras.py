# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Special places for the eye: name -> (position, focal point, view up, parallel), from the centre, the size and the points."""
import numpy as np

ASKEW = np.array([0.3, 0.2, -1.0])


def cameras(mesh):
    points = np.asarray(mesh.points, float)
    points = points[np.isfinite(points).all(axis=1)]
    low, high = points.min(axis=0), points.max(axis=0)
    center, size = (low + high) / 2, np.linalg.norm(high - low)
    away = 1.6 * size
    axes = {"x": (1, 0, 0), "-x": (-1, 0, 0), "y": (0, 1, 0), "-y": (0, -1, 0), "z": (0, 0, 1), "-z": (0, 0, -1)}
    result = {"along " + name: (center + away * np.array(axis), center, (0, 1, 0) if axis[2] else (0, 0, 1), False)
              for name, axis in axes.items()}
    result["parallel"] = (center + away * np.array([0.5, 0.6, 0.7]), center, (0, 0, 1), True)
    result["parallel x"] = (center + away * np.array([1, 0, 0]), center, (0, 0, 1), True)
    middle = points[np.argmin(np.linalg.norm(points - center, axis=1))]
    cell = np.asarray(mesh.get_cell(mesh.n_cells // 2).points, float)
    places = {"centre": center, "vertex": middle, "corner": high, "pole": points[np.argmax(points[:, 2])], "cell": cell.mean(axis=0),
              "edge": cell[:2].mean(axis=0), "face": cell[:3].mean(axis=0), "grid plane": np.array([low[0], *(center + 0.1 * size)[1:]])}
    focus = center + 0.23 * size * ASKEW  # also from the boundary there is something to see
    result.update({"eye on " + name: (place, focus, (0, 1, 0), False) for name, place in places.items()})
    result["far"] = (center + 300 * size * np.array([0.5, 0.6, 0.7]), center, (0, 0, 1), False)
    return result


def mirrored(camera):
    """The camera behind a mirror at x = 0."""
    position, focus, up, parallel = camera
    flip = np.array([-1, 1, 1])
    return position * flip, focus * flip, np.array(up) * flip, parallel
