# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Smoothed fields on structured grids (`vtkStructuredSmoothing`) and the surfaces of clouds (`vtkCloudSurface`)."""
from __future__ import annotations

import warnings
from typing import Any, Literal, Sequence

import numpy as np
import pyvista
from pyvista.core.errors import MissingDataError
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkDataSetAttributes, vtkImageData, vtkRectilinearGrid, vtkStructuredGrid, vtkUnstructuredGrid

from . import vtkCloudSurface, vtkStructuredSmoothing
from ._checks import arrays_of, choose, require_number
from ._fields import preset_of_field
from ._pipeline import set_input, vtk_messages
from ._typing import Mesh, Numbers
from .splitting import _point_array, _scalar_point_array, _values

# Terms in messages of the two filters, and their names in Python.
_NAMES = {"Clear MassArrayName": "Leave masses out", "switch Conservative off": "pass conservative=False", "MassArrayName": "masses", "Contour value": "isosurfaces: value", "contour values": "isosurfaces", "contour value": "value of isosurfaces"}
AXES = {"i": 0, "j": 1, "k": 2}
EDGE = 0.15     # cloud fraction of the surface of clouds
FILL = 1e30     # and more: no value
MOST = 1000     # maximum number of times the filter is applied; more could take hours


def smooth(mesh: pyvista.DataSet, iterations: int = 1, scalars: str | Sequence[str] | None = None, *, all_arrays: bool = False,
           periodic: str | Sequence[bool] = "", conservative: bool = False, masses: str | None = None, isotropic: bool = False,
           coordinates: Literal["automatic", "cartesian", "lonlat"] = "automatic", find_seam: bool = True,
           mass_array: bool = False) -> Mesh:
    """Smooth point arrays of a structured grid with a 3 x 3 x 3 filter, across seams and poles.

    Also the accessor method ``mesh.nephoscope.smooth(...)``. Hidden points, non-finite values and fill values (1e30 or more) are ignored and
    keep their values.

    Parameters
    ----------
    mesh : pyvista.ImageData, pyvista.RectilinearGrid or pyvista.StructuredGrid
        The grid; it is not changed.
    iterations : int, default: 1
        Number of times the filter is applied, 0 to 1000.
    scalars : str or sequence of str, optional
        Point arrays to smooth. Default: the active scalars; if they do not have one component, the first array that does, otherwise vectors.
    all_arrays : bool, default: False
        Smooths all point arrays of type float and double; `scalars` is then ignored.
    periodic : str or sequence of 3 bool, default: ""
        Axes along which the grid is periodic: ``"i"`` for longitudes, ``"ij"``, ... The seam of a globe is detected without it.
    conservative : bool, default: False
        Conserves the sum of mass times field, to rounding error.
    masses : str, optional
        Point array of masses. Default: volumes; on longitude-latitude grids the product of the steps in longitude, sin(latitude) and level.
    isotropic : bool, default: False
        Smooths rows near a pole more often, so that the smoothing length in metres is the same in both directions.
    coordinates : {"automatic", "cartesian", "lonlat"}, default: "automatic"
        Meaning of x and y of `mesh`: lengths, or longitude and latitude in degrees. Automatic: lengths, but degrees for image data and
        rectilinear grids with ``periodic="i"`` that span 360.
    find_seam : bool, default: True
        Detects a structured grid that closes on itself: last points at the position of the first points are treated as the same points.
    mass_array : bool, default: False
        Adds the masses as the point array ``Mass``.

    Returns
    -------
    pyvista.DataSet
        The same grid with smoothed arrays. Float and double arrays keep their type; integer arrays become double.

    Raises
    ------
    TypeError
        If `mesh` is not a structured dataset.
    pyvista.core.errors.MissingDataError
        (a ValueError) If a point array does not exist; the message lists the arrays that do.
    ValueError
        If a number or a choice is out of range.
    RuntimeError
        If the filter cannot use the grid, with its message.

    Warns
    -----
    RuntimeWarning
        The warnings of the filter: missing values, points without mass.
    """
    if isinstance(iterations, str):
        raise TypeError(f"iterations is {iterations!r}; it must be an integer. Name the array by scalars={iterations!r}.")
    smoothing = vtkStructuredSmoothing()
    set_input(smoothing, _structured(mesh))
    smoothing.SetNumberOfIterations(_count(iterations, "iterations"))
    smoothing.SetAllFloatArrays(all_arrays)
    if not all_arrays:
        names = [_default_name(mesh) if scalars is None else scalars] if scalars is None or isinstance(scalars, str) else list(scalars)
        for name in names:
            smoothing.AddArrayName(_point_array(mesh, name))
    smoothing.SetGenerateMassArray(mass_array)
    _set_up(smoothing, mesh, periodic, conservative, masses, isotropic, coordinates, find_seam)
    with vtk_messages(smoothing, _NAMES):
        smoothing.Update()
    return pyvista.wrap(smoothing.GetOutput())


def cloud_surface(mesh: pyvista.DataSet, isosurfaces: int | float | Numbers | None = None, scalars: str | None = None, *,
                  smoothing: int = 1, rng: Numbers | None = None, normals: bool = True, join_seams: bool = True,
                  periodic: str | Sequence[bool] = "", conservative: bool = False, masses: str | None = None,
                  isotropic: bool = False, coordinates: Literal["automatic", "cartesian", "lonlat"] = "automatic",
                  find_seam: bool = True) -> pyvista.PolyData:
    """Smooth a point array of a structured grid and contour it. The surface is closed across seam and poles and carries every point array.

    Also the accessor method ``mesh.nephoscope.cloud_surface(...)``. Hidden cells are not contoured.

    Parameters
    ----------
    mesh : pyvista.ImageData, pyvista.RectilinearGrid or pyvista.StructuredGrid
        The grid; it is not changed.
    isosurfaces : int, float or sequence of float, optional
        The contour values, in any order; or, if an int, the number of values at equal steps from the first to the last of `rng`, or inside the
        range of the scalars. Default for a cloud fraction: 0.15, or 15 in percent, if the smoothed values lie on both sides of it. Default
        otherwise, for cloud water and all other arrays: the middle of the range of the visible, finite smoothed values.
    scalars : str, optional
        Point array with one component to smooth and contour. Default: the active scalars; if they do not have one component, the first array
        that does.
    smoothing : int, default: 1
        Number of times the 3 x 3 x 3 filter is applied first, 0 to 1000.
    rng : sequence of 2 float, optional
        First and last value if `isosurfaces` is an int. Default: values inside the range of the finite scalars.
    normals : bool, default: True
        Adds ``Normals`` from the gradient of the smoothed field. They point towards lower values.
    join_seams : bool, default: True
        Merges points of a seam or a pole that have the same position.
    periodic, conservative, masses, isotropic, coordinates, find_seam
        As in `smooth`. A periodic structured grid whose last points are neighbours of the first is closed there.

    Returns
    -------
    pyvista.PolyData
        Triangles. Point arrays: all arrays of `mesh`, interpolated linearly (`scalars` is the contour value), and ``Normals``. Cell array:
        ``ContourIndex``, the index of the contour value.

    Raises
    ------
    TypeError, pyvista.core.errors.MissingDataError, ValueError, RuntimeError
        As `smooth` does.

    Warns
    -----
    RuntimeWarning
        The warnings of the filter: missing values.
    """
    surface = vtkCloudSurface()
    set_input(surface, _structured(mesh))
    name = _scalar_point_array(mesh, scalars)
    if isosurfaces is None:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # cloud_surface reports the same
            smoothed = smooth(mesh, smoothing, name, periodic=periodic, conservative=conservative, masses=masses, isotropic=isotropic,
                              coordinates=coordinates, find_seam=find_seam)
        isosurfaces = _usual_value(smoothed, name)
    surface.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, name)
    values = _values(mesh.point_data[name], isosurfaces, rng, inside=True)
    surface.SetNumberOfContours(len(values))
    for i, value in enumerate(values):
        surface.SetValue(i, value)
    surface.SetNumberOfSmoothingIterations(_count(smoothing, "smoothing"))
    surface.SetComputeNormals(normals)
    surface.SetJoinSeams(join_seams)
    _set_up(surface, mesh, periodic, conservative, masses, isotropic, coordinates, find_seam)
    with vtk_messages(surface, _NAMES):
        surface.Update()
    return pyvista.wrap(surface.GetOutput())


def _structured(mesh: Any) -> pyvista.DataSet:
    if not isinstance(mesh, (vtkImageData, vtkRectilinearGrid, vtkStructuredGrid)):
        remedy = " Sample it on an image first: image.sample(mesh), with a pyvista.ImageData." if isinstance(mesh, vtkUnstructuredGrid) and mesh.GetNumberOfCells() else ""
        raise TypeError(f"mesh is a {type(mesh).__name__}; it must be an ImageData, a RectilinearGrid or a StructuredGrid.{remedy}")
    return mesh


def _default_name(mesh: pyvista.DataSet) -> str:
    try:
        return _point_array(mesh, None)
    except MissingDataError:
        if mesh.active_scalars_name in mesh.point_data.keys():
            return mesh.active_scalars_name  # vectors: each component is smoothed
        raise


def _usual_value(smoothed: pyvista.DataSet, name: str) -> float:
    """A value inside the range of the array; for cloud fractions, the value at the edge of clouds."""
    values = np.asarray(smoothed.point_data[name], float)[_visible_points(smoothed)]
    values = values[np.abs(values) < FILL]  # and NaN is ignored
    if not values.size:
        return EDGE  # the filter says what is wrong
    low, high = float(values.min()), float(values.max())
    preset = preset_of_field(name, smoothed)
    edge = EDGE if high <= 1.01 else 100 * EDGE
    return edge if preset is not None and preset.name == "clouds" and low < edge < high else 0.5 * (low + high)


def _visible_points(mesh: pyvista.DataSet) -> np.ndarray:
    """For each point, whether it is a corner of a visible cell and is not hidden itself."""
    visible = np.ones(mesh.n_points, bool)
    if "vtkGhostType" in mesh.cell_data.keys():
        cells = np.flatnonzero(mesh.cell_data["vtkGhostType"] & vtkDataSetAttributes.HIDDENCELL == 0)
        visible[:] = False
        visible[mesh.extract_cells(cells).point_data["vtkOriginalPointIds"]] = True
    if "vtkGhostType" in mesh.point_data.keys():
        visible &= mesh.point_data["vtkGhostType"] & vtkDataSetAttributes.HIDDENPOINT == 0
    return visible


def _count(value: int, argument: str) -> int:
    if isinstance(value, bool) or require_number(value, argument, least=0, most=MOST) != int(value):
        raise ValueError(f"{argument} is {value!r}; it must be a whole number, 0 to {MOST}.")
    return int(value)


def _set_up(algorithm: vtkStructuredSmoothing | vtkCloudSurface, mesh: pyvista.DataSet, periodic: str | Sequence[bool],
            conservative: bool, masses: str | None, isotropic: bool, coordinates: str, find_seam: bool) -> None:
    """The settings common to both filters."""
    if isinstance(periodic, str):
        unknown = set(periodic) - set(AXES)
        if unknown:
            raise ValueError(f"periodic is {periodic!r}; it must name axes by the letters 'i', 'j' and 'k'.")
        periodic = [letter in periodic for letter in AXES]
    if len(periodic) != 3:
        raise ValueError(f"periodic is {periodic!r}; it must have three values, or be letters of 'ijk'.")
    for axis, closes in enumerate(periodic):
        algorithm.SetPeriodic(axis, bool(closes))
    algorithm.SetConservative(conservative)
    if masses is not None:
        if masses not in mesh.point_data:
            raise MissingDataError(f"masses: no point array {masses!r}. {arrays_of(mesh)}")
        algorithm.SetMassArrayName(masses)
    algorithm.SetIsotropic(isotropic)
    algorithm.SetFindSeam(find_seam)
    choose({"automatic": algorithm.SetCoordinatesToAutomatic, "cartesian": algorithm.SetCoordinatesToCartesian,
            "lonlat": algorithm.SetCoordinatesToLongitudeLatitude}, coordinates, "coordinates")
