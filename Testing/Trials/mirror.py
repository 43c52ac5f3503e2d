# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""A mesh behind a mirror at x = 0: its cells are inside out then."""
import numpy as np


def mirror(mesh):
    result = mesh.copy()
    result.points = np.asarray(mesh.points, float) * np.array([-1, 1, 1])
    for data in (result.point_data, result.cell_data):
        for name in data:
            values = data[name]
            if values.ndim == 2 and values.shape[1] == 3 and values.dtype.kind == "f":  # vectors
                data[name] = values * np.array([-1, 1, 1], values.dtype)
    return result
