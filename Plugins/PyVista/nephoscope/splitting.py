# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Cells divided at contour values (`vtkContourCellSplitter`)."""
from __future__ import annotations

import warnings
from typing import Literal

import numpy as np
import pyvista
from pyvista.core.errors import MissingDataError
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkDataObject
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm

from . import vtkContourCellSplitter
from ._blocks import named_blocks
from ._checks import arrays_of, as_array, choose
from ._medium import array_values, default_scalars, require_scalars
from ._pipeline import set_input, vtk_messages
from ._typing import Numbers

PRECISIONS = {"double": vtkAlgorithm.DOUBLE_PRECISION, "single": vtkAlgorithm.SINGLE_PRECISION, "input": vtkAlgorithm.DEFAULT_PRECISION}

# Terms in messages of vtkContourCellSplitter, and their names in Python.
_NAMES = {"Choose one with SetInputArrayToProcess": "Name one by scalars", "Contour value": "isosurfaces: value", "contour values": "isosurfaces", "contour value": "value of isosurfaces",
          "GenerateSurfaces": "surfaces", "PolyhedralTransitions": "polyhedral_transitions"}


def split_cells(mesh: pyvista.DataSet | pyvista.MultiBlock, isosurfaces: int | float | Numbers = 10, scalars: str | None = None, *,
                rng: Numbers | None = None, surfaces: bool = True,
                polyhedral_transitions: bool = False, precision: Literal["double", "single", "input"] = "double") -> pyvista.UnstructuredGrid | pyvista.MultiBlock:
    """Divide the 3-D cells that contour values cross into convex pieces, each on one side of every value.

    Also the accessor method ``mesh.nephoscope.split_cells(...)``. Cells that no value crosses stay unchanged.

    Parameters
    ----------
    mesh : pyvista.DataSet or pyvista.MultiBlock
        Any mesh with 3-D cells; it is not changed. The blocks of a MultiBlock are divided at the same values, each separately.
    isosurfaces : int, float or sequence of float, default: 10
        The contour values, in any order; or, if an int, the number of values at equal steps from the first to the last of `rng`. As in
        `pyvista.DataSetFilters.contour`.
    scalars : str, optional
        Point array with one component. Default: the active scalars; if they do not have one component, the first array that does.
    rng : sequence of 2 float, optional
        Range of the values if `isosurfaces` is an int. Default: the range of the finite scalars.
    surfaces : bool, default: True
        Adds the polygons of the contour surfaces.
    polyhedral_transitions : bool, default: False
        Turns undivided neighbours of divided cells into polyhedra with the same triangles, so that the mesh is conforming.
    precision : {"double", "single", "input"}, default: "double"
        Precision of the coordinates; ``"input"``: that of the points of `mesh`. Rounding to single precision can invert thin pieces.

    Returns
    -------
    pyvista.UnstructuredGrid, or pyvista.MultiBlock of them
        Pieces, then polygons. Cell arrays: those of the original cell; ``Layer``, the number of contour values below the piece; and
        ``ContourIndex``, the index of the contour value for polygons and -1 for pieces. Point arrays are interpolated; on a cut `scalars` is
        exactly the contour value.

    Raises
    ------
    TypeError
        If `mesh` is not a dataset.
    pyvista.core.errors.MissingDataError
        (a ValueError) If a point array does not exist; the message lists the arrays that do.
    ValueError
        If a value is not finite, the number of values is negative, or the scalars do not have one value per point.
    RuntimeError
        If the filter cannot use the mesh, with its message.

    Warns
    -----
    RuntimeWarning
        The warnings of the filter: scalars that are NaN; cells that are not three-dimensional, convex or linear; a MultiBlock without points.
    """
    if isinstance(mesh, vtkCompositeDataSet):
        if not isinstance(mesh, pyvista.MultiBlock):
            mesh = pyvista.MultiBlock([block for _, block in named_blocks(mesh)])
        name, array = _array_of_blocks(mesh, scalars)
    elif isinstance(mesh, pyvista.DataSet):
        name = _scalar_point_array(mesh, scalars)
        array = mesh.point_data[name]
    else:
        raise TypeError(f"mesh is a {type(mesh).__name__}; it must be a pyvista dataset or MultiBlock.")
    splitter = vtkContourCellSplitter()
    set_input(splitter, mesh)
    splitter.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, name)
    values = _values(array, isosurfaces, rng)
    splitter.SetNumberOfContours(len(values))
    for i, value in enumerate(values):
        splitter.SetValue(i, value)
    splitter.SetGenerateSurfaces(surfaces)
    splitter.SetPolyhedralTransitions(polyhedral_transitions)
    choose({name: lambda value=value: splitter.SetOutputPointsPrecision(value) for name, value in PRECISIONS.items()}, precision, "precision")
    with vtk_messages(splitter, _NAMES):
        splitter.Update()
    return pyvista.wrap(splitter.GetOutputDataObject(0))


def _array_of_blocks(blocks: vtkCompositeDataSet, scalars: str | None) -> tuple[str, np.ndarray]:
    """The name of an array that all blocks have, and the values of all blocks."""
    meshes = [mesh for _, mesh in named_blocks(blocks) if mesh.n_points]
    if not meshes:
        warnings.warn("The MultiBlock has no block with points, so there is nothing to divide.", RuntimeWarning, stacklevel=3)
    name = scalars if scalars is not None else _scalar_point_array(meshes[0], None) if meshes else ""
    arrays = [np.asarray(mesh.point_data[_scalar_point_array(mesh, name)], float) for mesh in meshes]
    return name, np.concatenate(arrays or [np.empty(0)])


def _point_array(mesh: pyvista.DataSet, scalars: str | None) -> str:
    if scalars is None:
        scalars = default_scalars(mesh, by_name=True)[1]
    if scalars not in mesh.point_data:
        remedy = " It is on cells: use mesh.cell_data_to_point_data() first." if scalars in mesh.cell_data else ""
        raise MissingDataError(f"scalars: no point array {scalars!r}.{remedy} {arrays_of(mesh, scalars)}")
    return scalars


def _scalar_point_array(mesh: pyvista.DataSet, scalars: str | None) -> str:
    """The name of a point array with one component."""
    name = _point_array(mesh, scalars)
    values = array_values(mesh, name, "point")
    if values.ndim > 1:
        require_scalars(mesh, values, name, "scalars")
    return name


def _values(array: np.ndarray, isosurfaces: int | float | Numbers, rng: Numbers | None, inside: bool = False) -> np.ndarray:
    """The values; `inside`: a number of values inside the range of the array, because its ends give no surface."""
    if isinstance(isosurfaces, (int, np.integer)) and not isinstance(isosurfaces, bool):
        if isosurfaces < 0:
            raise ValueError(f"isosurfaces is {isosurfaces}; a number of values must be at least 0.")
        if rng is None:
            finite = array[np.isfinite(array)]
            rng = (finite.min(), finite.max()) if finite.size else (0.0, 0.0)
            if inside:
                return np.linspace(*rng, isosurfaces + 2)[1:-1]
        values = np.linspace(rng[0], rng[1], isosurfaces)
    else:
        values = np.atleast_1d(as_array(isosurfaces).astype(float))
    if values.ndim != 1 or not np.isfinite(values).all():
        raise ValueError(f"isosurfaces is {isosurfaces!r} and rng {rng!r}; the values must be finite numbers.")
    return values
