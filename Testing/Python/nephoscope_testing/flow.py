# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Flow volumes made in one call, and what tests ask of them."""
import hashlib
from collections import Counter

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from .filters import configured
from .messages import Messages

FACES = ((0, 1, 2), (0, 1, 3), (0, 2, 3), (1, 2, 3))


def area_of(radius, sides):
    return 0.5 * sides * radius**2 * np.sin(2 * np.pi / sides)


def radius_of(area, sides=3):
    return np.sqrt(area / area_of(1, sides))


def flow_volume(source, **settings):
    """The filter, not yet updated. source: data or an algorithm. Velocity: name, or (name, association)."""
    import nephoscope
    velocity = settings.pop("Velocity", None)
    made = configured(nephoscope.vtkFlowVolume(), source, settings)
    if velocity:
        name, association = velocity if isinstance(velocity, tuple) else (velocity, 0)
        made.SetInputArrayToProcess(0, 0, 0, association, name)
    return made


def update(made, time=None):
    """(smoke, messages)"""
    with Messages() as messages:
        if time is None:
            made.Update()
        else:
            made.UpdateTimeStep(time)
    return Smoke(made), messages.all


class Smoke:
    """The output of a flow volume as numpy arrays."""

    def __init__(self, made):
        self.made, self.output = made, made.GetOutput()
        points = self.output.GetPoints()
        self.points = vtk_to_numpy(points.GetData()).copy() if points else np.empty((0, 3))
        count = self.output.GetNumberOfCells()
        self.cells = vtk_to_numpy(self.output.GetCells().GetConnectivityArray()).reshape(-1, 4).copy() if count else np.empty((0, 4), int)

    def point_array(self, name):
        return vtk_to_numpy(self.output.GetPointData().GetArray(name)).copy()

    def cell_array(self, name):
        return vtk_to_numpy(self.output.GetCellData().GetArray(name)).copy()

    @property
    def density(self):
        return self.cell_array("Density")

    @property
    def age(self):
        return self.point_array("Age")

    def volumes(self):
        a, b, c, d = np.moveaxis(self.points[self.cells], 1, 0)
        return np.einsum("ij,ij->i", np.cross(b - a, c - a), d - a) / 6

    def mass(self):
        return float((self.density * self.volumes()).sum()) if len(self.cells) else 0.0

    def boundary(self):
        """Faces of one cell only, as sorted point ids; fails where a face is of more than two."""
        faces = Counter(tuple(sorted(cell[list(face)])) for cell in self.cells for face in FACES)
        assert max(faces.values()) <= 2, "a face of three cells"
        return np.array([face for face, count in faces.items() if count == 1])

    def is_one_piece(self):
        """Whether the boundary is one closed surface without holes or seams, as that of a ball: no cracks, no hanging points."""
        faces = self.boundary()
        edges = Counter(edge for a, b, c in faces for edge in ((a, b), (b, c), (a, c)))
        return set(edges.values()) == {2} and len(np.unique(faces)) - len(edges) + len(faces) == 2

    def edge_lengths(self):
        pairs = np.vstack([self.cells[:, [i, j]] for i in range(4) for j in range(i)])
        return np.linalg.norm(self.points[pairs[:, 0]] - self.points[pairs[:, 1]], axis=1)

    def digest(self):
        """Hash of points, cells and all arrays."""
        made = hashlib.sha256(self.points.tobytes() + self.cells.tobytes())
        for attributes in (self.output.GetPointData(), self.output.GetCellData()):
            for i in range(attributes.GetNumberOfArrays()):
                array = attributes.GetArray(i)
                made.update(array.GetName().encode() + vtk_to_numpy(array).tobytes())
        return made.hexdigest()
