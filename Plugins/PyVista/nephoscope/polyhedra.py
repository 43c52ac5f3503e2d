# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Polyhedra that are not convex, divided into tetrahedra (`vtkPolyhedronToTetrahedra`)."""
from __future__ import annotations

import pyvista

from . import vtkPolyhedronToTetrahedra
from ._checks import require_number
from ._pipeline import vtk_messages

# What the messages of vtkPolyhedronToTetrahedra say, and what it is called here.
_NAMES = {"Set UseTetGen on": "Pass tetgen=True", "UseTetGen": "tetgen", "FaceWarpTolerance": "warp_tolerance", "DivideConvexPolyhedra": "convex"}


def divide_polyhedra(mesh: pyvista.DataSet, *, convex: bool = False, warp_tolerance: float = 0.1, tetgen: bool = True) -> pyvista.DataSet:
    """Divide the polyhedra that are not convex into tetrahedra, so that `add_cells` draws them right. Everything else stays as it is.

    Also the accessor method ``mesh.nephoscope.divide_polyhedra(...)``.

    Parameters
    ----------
    mesh : pyvista.DataSet
        The mesh, that of OpenFOAM or MPAS say; it is not changed.
    convex : bool, default: False
        Divide convex polyhedra too, so that none is left.
    warp_tolerance : float, default: 0.1
        Largest distance of the corners of a face from its plane that counts as warp and not as a fold, as a share of the diagonal of the cell's
        bounds, 0 to 1. A cell that would be drawn wrong is divided whatever it is.
    tetgen : bool, default: True
        Use TetGen for cells that no single point sees the whole of, where the build has it.

    Returns
    -------
    pyvista.DataSet
        The mesh, an UnstructuredGrid if it was one. Points are added where a cell is divided around its middle; point arrays are interpolated there.

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
    divider.SetInputData(mesh)
    divider.SetDivideConvexPolyhedra(bool(convex))
    divider.SetFaceWarpTolerance(require_number(warp_tolerance, "warp_tolerance", least=0, most=1))
    divider.SetUseTetGen(bool(tetgen))
    with vtk_messages(divider, _NAMES):
        divider.Update()
    return pyvista.wrap(divider.GetOutput())
