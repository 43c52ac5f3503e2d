# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Velocity fields and particles from Python, through the C interface that the tests build (field_driver.cxx)."""
import ctypes
import os
import pathlib

import nephoscope
import numpy as np
from vtkmodules.vtkCommonDataModel import vtkPointData

# In the build tree, also where the package is installed elsewhere.
LIBRARIES = os.environ.get("NEPHOSCOPE_TEST_LIBRARIES") or pathlib.Path(nephoscope.__file__).resolve().parents[3]
LIBRARY = pathlib.Path(LIBRARIES) / "libnephoscope_field_driver.so"


def _driver():
    driver = ctypes.CDLL(str(LIBRARY))
    pointer, whole, real = ctypes.c_void_p, ctypes.c_longlong, ctypes.c_double
    for name, result, arguments in (
            ("field_make", pointer, [pointer, ctypes.c_char_p, ctypes.c_int, ctypes.c_char_p, ctypes.c_int]),
            ("field_delete", None, [pointer]),
            ("hints_make", pointer, [whole]),
            ("hints_delete", None, [pointer]),
            ("hints_set", None, [pointer, whole, pointer]),
            ("field_sample", None, [pointer, whole, pointer, pointer, pointer, pointer]),
            ("field_sample_arrays", None, [pointer, whole, pointer, pointer, pointer]),
            ("field_advance", None,
             [pointer, whole, pointer, pointer, pointer, real, ctypes.c_int, real, ctypes.c_int])):
        function = getattr(driver, name)
        function.restype, function.argtypes = result, arguments
    return driver


DRIVER = _driver()


def _address(vtk_object):
    return int(vtk_object.__this__.split("_")[1], 16) if vtk_object is not None else None


class Particles:
    """Positions (n x 3) with their hints; `inside` says which are still in the field."""

    def __init__(self, positions, cells=None):
        self.positions = np.array(positions, dtype=float).reshape(-1, 3)
        self.inside = np.ones(len(self.positions), dtype=np.uint8)
        self.hints = DRIVER.hints_make(len(self.positions))
        if cells is not None:
            cells = np.ascontiguousarray(cells, dtype=np.int64)
            DRIVER.hints_set(self.hints, len(cells), cells.ctypes.data)

    def __del__(self):
        DRIVER.hints_delete(self.hints)


class Field:
    """The velocity field of a dataset. Raises ValueError with the problem if there is none."""

    def __init__(self, data, name, on_cells=False):
        text = ctypes.create_string_buffer(4000)
        self.data = data
        self.handle = DRIVER.field_make(_address(data), name.encode(), on_cells, text, len(text))
        if not self.handle:
            raise ValueError(text.value.decode())

    def __del__(self):
        if getattr(self, "handle", None):
            DRIVER.field_delete(self.handle)

    def sample(self, particles):
        """Velocities; NaN outside."""
        if not isinstance(particles, Particles):
            particles = Particles(particles)
        velocities = np.zeros_like(particles.positions)
        inside = np.zeros(len(velocities), dtype=np.uint8)
        DRIVER.field_sample(self.handle, len(velocities), particles.positions.ctypes.data, particles.hints,
                            velocities.ctypes.data, inside.ctypes.data)
        velocities[inside == 0] = np.nan
        return velocities

    def arrays(self, particles):
        """A vtkPointData with every array at the positions."""
        if not isinstance(particles, Particles):
            particles = Particles(particles)
        output = vtkPointData()
        DRIVER.field_sample_arrays(self.handle, len(particles.positions), particles.positions.ctypes.data,
                                   particles.hints, _address(output))
        return output

    def advance(self, particles, step, steps=1, tolerance=0.0, threads=1):
        """RK4, or the adaptive method where there is a tolerance."""
        DRIVER.field_advance(self.handle, len(particles.positions), particles.positions.ctypes.data, particles.hints,
                             particles.inside.ctypes.data, step, steps, tolerance, threads)
        return particles
