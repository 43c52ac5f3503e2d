# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Non-convex polyhedra, divided into tetrahedra (`vtkPolyhedronToTetrahedra`)."""
from __future__ import annotations

import pyvista

from . import vtkPolyhedronToTetrahedra
from ._checks import require_number
from ._pipeline import set_input, vtk_messages

# Terms in messages of vtkPolyhedronToTetrahedra, and their names in Python.
_NAMES = {"Set UseTetGen on": "Pass tetgen=True", "UseTetGen": "tetgen", "FaceWarpTolerance": "warp_tolerance", "DivideConvexPolyhedra": "convex"}


def divide_polyhedra(mesh: pyvista.DataSet, *, convex: bool = False, warp_tolerance: float = 0.1, tetgen: bool = True) -> pyvista.DataSet:
    """Divide non-convex polyhedra into tetrahedra, so that `add_cells` draws them correctly. All other cells stay unchanged.

    Also the accessor method ``mesh.nephoscope.divide_polyhedra(...)``.

    Parameters
    ----------
    mesh : pyvista.DataSet
        The mesh, for example from OpenFOAM or MPAS; it is not changed.
    convex : bool, default: False
        Divides convex polyhedra too, so that none is left.
    warp_tolerance : float, default: 0.1
        Largest distance of a face's corners from its mean plane, as a fraction of the diagonal of the cell's bounds, at which the face still
        counts as planar, 0 to 1. Cells that would be drawn wrong are always divided.
    tetgen : bool, default: True
        Uses TetGen, if the build has it, for polyhedra that are not star-shaped (no inner point sees all of the boundary).

    Returns
    -------
    pyvista.DataSet
        The mesh, an UnstructuredGrid if it was one. A cell that is divided around its middle gets a new point, with interpolated point arrays.

    Raises
    ------
    TypeError
        If `mesh` is not a dataset.
    ValueError
        If a number is out of range.

    Warns
    -----
    RuntimeWarning
        For cells that could not be divided.
    """
    if not isinstance(mesh, pyvista.DataSet):
        raise TypeError(f"mesh is a {type(mesh).__name__}; it must be a pyvista dataset.")
    divider = vtkPolyhedronToTetrahedra()
    set_input(divider, mesh)
    divider.SetDivideConvexPolyhedra(bool(convex))
    divider.SetFaceWarpTolerance(require_number(warp_tolerance, "warp_tolerance", least=0, most=1))
    divider.SetUseTetGen(bool(tetgen))
    with vtk_messages(divider, _NAMES):
        divider.Update()
    return pyvista.wrap(divider.GetOutput())
