# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Cell compositing: any 3-D cells as a volume in a PyVista plotter, with the exact ray integral."""
from __future__ import annotations

from typing import Any, Sequence

import numpy as np
import pyvista
from pyvista.core.errors import MissingDataError
from vtkmodules.vtkCommonDataModel import vtkGenericCell

from . import vtkCellCompositingMapper
from ._checks import arrays_of, choose, require_number
from ._surfaces import Surfaces
from .transfer import OpacityLike, colour_function, opacity_function, opacity_values


class CellCompositingMapper(vtkCellCompositingMapper):
    """The mapper with the properties that PyVista's plotters and scalar bars read and write.

    Attributes
    ----------
    dataset : pyvista.DataSet
        The grid drawn.
    lookup_table : pyvista.LookupTable
        Colours of the scalar bar and, over its range, of the volume.
    scalar_range : tuple of float
        Range of the transfer functions. Setting it (`Plotter.update_scalar_bar_range` does) moves colours and opacities.
    """

    def attach(self, prop: pyvista.VolumeProperty, table: pyvista.LookupTable, opacities: np.ndarray,
               opacity_clim: tuple[float, float] | None) -> None:
        """Write colours and opacities to `prop`, now and whenever the scalar range changes.

        `opacity_clim` is the range of the opacities where another array than that of the colours gives them.
        """
        self._prop, self.lookup_table = prop, table
        self._opacities, self._opacity_clim = opacities, opacity_clim
        self.scalar_range = table.scalar_range

    @property
    def dataset(self) -> pyvista.DataSet:
        return pyvista.wrap(self.GetInputDataObject(0, 0))

    @property
    def scalar_range(self) -> tuple[float, float]:
        return self.lookup_table.scalar_range

    @scalar_range.setter
    def scalar_range(self, clim: Sequence[float]) -> None:
        table = self.lookup_table
        table.scalar_range = tuple(clim)
        self._prop.SetColor(colour_function(table))
        if self._opacity_clim is None:
            opacity = opacity_function(self._opacities, table.scalar_range, table.log_scale)
        else:
            opacity = opacity_function(self._opacities, self._opacity_clim, False)
        self._prop.SetScalarOpacity(opacity)


def add_cells(plotter: pyvista.BasePlotter, grid: Any, scalars: str | np.ndarray | None = None, *,
              cmap: Any = None, opacity: OpacityLike = "linear", clim: float | Sequence[float] | None = None,
              n_colors: int = 256, flip_scalars: bool = False, log_scale: bool = False,
              opacity_scalars: str | None = None, opacity_clim: float | Sequence[float] | None = None,
              opacity_scale: float = 1.0, unit_distance: float | None = None,
              integration: str = "exact", order: str = "exact", preference: str = "point",
              contours: int | Sequence[float] | None = None, contour_opacity: float | Sequence[float] = 0.3,
              contour_color: Any = None, contour_scalars: str | None = None, contour_lighting: bool = True,
              smooth_contours: bool = True, layers: dict | None = None, layer_scalars: str | None = None,
              name: str | None = None, show_scalar_bar: bool | None = None, scalar_bar_args: dict | None = None,
              reset_camera: bool | None = None, pickable: bool = True, user_matrix: Any = None,
              render: bool = True) -> pyvista.Volume:
    """Add a grid of 3-D cells to a plotter as a volume drawn by `vtkCellCompositingMapper`.

    Extinction per unit length is opacity * `opacity_scale` / `unit_distance`; it and the colour vary linearly inside each
    tetrahedron of a cell. Arguments that `pyvista.Plotter.add_volume` has mean the same here unless noted.

    Parameters
    ----------
    plotter : pyvista.Plotter
        The plotter; its active renderer gets the volume.
    grid : pyvista.DataSet or pyvista.MultiBlock
        Tetrahedra, hexahedra, voxels, wedges, pyramids or convex polyhedra, structured or not. A MultiBlock is combined into
        one grid, coincident points merged; arrays that not all blocks have are lost. A 3-D numpy array becomes an image.
    scalars : str or numpy.ndarray, optional
        Name of a point or cell array, or values of shape (n_points,) or (n_cells,). Default: the active scalars.
        Unlike `add_volume`, this does not change `grid`.
    cmap : str, list or pyvista.LookupTable, optional
        Colour map, the source colour of the medium. Default: the theme's. A LookupTable also sets range and scale.
    opacity : str, float or sequence of float, default: "linear"
        ``'linear'``, ``'geom'``, ``'sigmoid'``, ``'sigmoid_5'``, ... each also with ``'_r'``, or ``'foreground'``;
        one value; or values in 0 to 1 at equal steps over `clim`. Evaluated in floating point, not in 8 bits.
    clim : sequence of float or float, optional
        Scalars of the first and last colour; one number c means (-c, c). Default: the range of the finite scalars, half a
        unit to either side when they are all the same.
    n_colors : int, default: 256
        Entries of the colour table.
    flip_scalars : bool, default: False
        Reverse the colour map.
    log_scale : bool, default: False
        Colours and opacities at equal steps of the logarithm. A lower limit that is not positive is replaced by the
        smallest positive scalar.
    opacity_scalars : str, optional
        Point or cell array that `opacity` is a function of, where it is not `scalars`: clouds coloured by height, say.
    opacity_clim : sequence of float or float, optional
        Values of `opacity_scalars` of the first and last opacity. Default: its range. Only with `opacity_scalars`.
    opacity_scale : float, default: 1.0
        Factor on the extinction, >= 0.
    unit_distance : float, optional
        Length in world units over which a medium of opacity 1 has optical depth 1 (`add_volume` calls it
        `opacity_unit_distance`), > 0. Default: diagonal of the bounds / cube root of the number of cells.
    integration : {"exact", "average"}, default: "exact"
        Along a ray inside a tetrahedron: the closed-form integral, or the mean colour of the two ends.
    order : {"exact", "centroid", "none"}, default: "exact"
        Visibility order of the tetrahedra: topological, by distance of the centroid, as stored.
    preference : {"point", "cell"}, default: "point"
        Which array is meant when points and cells have one of the same name, or are equally many.
    contours : int or sequence of float, optional
        Values of lit, translucent surfaces inside the volume, drawn without geometry and in exact order with it; or their
        number, at equal steps inside the range.
    contour_opacity : float or sequence of float, default: 0.3
        Of all surfaces or of each, 0 to 1. 0: not drawn.
    contour_color : color or sequence of color, optional
        Of all surfaces or of each. Default: the colour map's where the surface is.
    contour_scalars : str, optional
        Point array that `contours` are values of, where it is not `scalars`.
    contour_lighting, smooth_contours : bool, default: True
        Light the surfaces by the plotter's lights; interpolate their normals between points.
    layers : dict of int to pyvista.VolumeProperty, optional
        Colour function, opacity function and unit distance of single layers, which may jump at their borders. The layer of a
        point is the number of `contours` at or below its scalar, unless `layer_scalars` is given.
    layer_scalars : str, optional
        Cell array that numbers the layers.
    name : str, optional
        An actor of that name in the plotter is replaced.
    show_scalar_bar : bool, optional
        Default: the theme's.
    scalar_bar_args : dict, optional
        Passed on to `pyvista.Plotter.add_scalar_bar`.
    reset_camera, pickable, render : bool, optional
        Passed on to `pyvista.Plotter.add_actor`.
    user_matrix : array_like, optional
        Transformation of the volume, shape (4, 4).

    Returns
    -------
    pyvista.Volume
        The volume in the plotter: `.mapper` is the `vtkCellCompositingMapper`, `.prop` the volume property.

    Raises
    ------
    TypeError
        If `plotter` or `grid` is not what it should be, or the scalars are not numbers.
    pyvista.core.errors.MissingDataError
        (a ValueError) If there is no such array; the message lists those that are there.
    ValueError
        If an argument is out of range, the grid has no 3-D cells, or the scalars are not one number per point or cell.

    Examples
    --------
    >>> plotter = pyvista.Plotter()  # doctest: +SKIP
    >>> nephoscope.add_cells(plotter, clouds, scalars="cloud_fraction", cmap=["white", "white"])  # doctest: +SKIP
    """
    if not callable(getattr(plotter, "add_actor", None)):
        raise TypeError(f"plotter is a {type(plotter).__name__}; it must be a pyvista.Plotter.")
    grid = _solid_grid(grid)
    grid, array_name, association = _scalar_array(grid, scalars, preference)
    table = _lookup_table(plotter, cmap, _values(grid, array_name, association), array_name, clim, n_colors, flip_scalars,
                          log_scale)
    opacities = _opacities(table, cmap, opacity, n_colors, on_bar=opacity_scalars is None)
    opacity_range = _opacity_range(grid, opacity_scalars, opacity_clim, preference)
    mapper = _mapper(grid, array_name, association, integration, order)
    mapper.SetOpacityArrayName(opacity_scalars or "")
    Surfaces(contours, contour_scalars, contour_opacity, contour_color, contour_lighting, smooth_contours, layers,
             layer_scalars).apply(mapper, grid, array_name, association)
    mapper.SetOpacityScale(require_number(opacity_scale, "opacity_scale", least=0))
    if unit_distance is None:
        unit_distance = grid.length / np.cbrt(grid.n_cells)
    prop = pyvista.VolumeProperty(opacity_unit_distance=require_number(unit_distance, "unit_distance", above=0))
    mapper.attach(prop, table, opacities, opacity_range)
    volume = pyvista.Volume()
    volume.prop, volume.mapper = prop, mapper
    if user_matrix is not None:
        volume.user_matrix = user_matrix
    plotter.add_actor(volume, reset_camera=reset_camera, name=name, pickable=pickable, render=render)
    _add_scalar_bar(plotter, mapper, array_name, show_scalar_bar, scalar_bar_args)
    return volume


def _mapper(grid: pyvista.DataSet, array_name: str, association: str, integration: str, order: str) -> CellCompositingMapper:
    mapper = CellCompositingMapper()
    mapper.SetInputData(grid)
    mapper.SelectScalarArray(array_name)
    if association == "point":
        mapper.SetScalarModeToUsePointFieldData()
    else:
        mapper.SetScalarModeToUseCellFieldData()
    choose({"exact": mapper.SetIntegrationToExact, "average": mapper.SetIntegrationToAverage}, integration, "integration")
    choose({"exact": mapper.SetVisibilityOrderToExact, "centroid": mapper.SetVisibilityOrderToCentroid,
            "none": mapper.SetVisibilityOrderToNone}, order, "order")
    return mapper


def _solid_grid(grid: Any) -> pyvista.DataSet:
    """`grid` as one PyVista dataset that has 3-D cells."""
    try:
        grid = pyvista.wrap(grid)
    except (TypeError, NotImplementedError):
        pass
    if isinstance(grid, pyvista.MultiBlock):
        grid = grid.combine(merge_points=True) if grid.n_blocks else pyvista.UnstructuredGrid()
    if not isinstance(grid, pyvista.DataSet):
        raise TypeError(f"grid is a {type(grid).__name__}; it must be a pyvista dataset or MultiBlock with 3-D cells.")
    if grid.n_cells == 0:
        raise ValueError(f"grid, a {type(grid).__name__} of {grid.n_points} points, has no cells.")
    if not _has_solid_cells(grid):
        raise ValueError(f"grid, a {type(grid).__name__} of {grid.n_cells} cells, has no 3-D cells. "
                         "Volumes need tetrahedra, hexahedra, voxels, wedges, pyramids or polyhedra.")
    return grid


def _has_solid_cells(grid: pyvista.DataSet) -> bool:
    if not isinstance(grid, pyvista.UnstructuredGrid):
        return min(getattr(grid, "dimensions", (1,))) > 1  # not by a cell: a hidden one is an empty cell
    cell = vtkGenericCell()
    for cell_type in np.unique(grid.celltypes):
        cell.SetCellType(int(cell_type))
        if cell.GetCellDimension() == 3:
            return True
    return False


def _scalar_array(grid: pyvista.DataSet, scalars: str | np.ndarray | None,
                  preference: str) -> tuple[pyvista.DataSet, str, str]:
    """The grid that has the scalars, the array's name, and "point" or "cell"."""
    if preference not in ("point", "cell"):
        raise ValueError(f"preference is {preference!r}; it must be 'point' or 'cell'.")
    if scalars is None:
        association, scalars = grid.active_scalars_info
        if scalars is None:
            raise MissingDataError(f"grid has no active scalars; name an array: {arrays_of(grid)}")
        preference = association.name.lower()
    if not isinstance(scalars, str):
        grid, scalars, preference = _with_values(grid, scalars, preference)
    return grid, scalars, _association(grid, scalars, preference, "scalars")


def _association(grid: pyvista.DataSet, name: str, preference: str, argument: str) -> str:
    """ "point" or "cell", where the array `name` of one number each is; `preference` if both have it."""
    for association in (preference, "cell" if preference == "point" else "point"):
        if name in (grid.point_data if association == "point" else grid.cell_data):
            _require_scalars(_values(grid, name, association), name, argument)
            return association
    raise MissingDataError(f"{argument}: no array {name!r}. {arrays_of(grid)}")


def _values(grid: pyvista.DataSet, name: str, association: str) -> np.ndarray:
    return (grid.point_data if association == "point" else grid.cell_data)[name]


def _with_values(grid: pyvista.DataSet, values: Any, preference: str) -> tuple[pyvista.DataSet, str, str]:
    """A shallow copy of the grid that has `values` as the array "Data"."""
    values = np.asarray(values)
    counts = {"point": grid.n_points, "cell": grid.n_cells}
    fitting = [kind for kind, count in counts.items() if len(np.atleast_1d(values)) == count]
    if not fitting:
        raise ValueError(f"scalars has shape {values.shape}; it must have one value for each of the "
                         f"{grid.n_points} points or {grid.n_cells} cells.")
    kind = preference if preference in fitting else fitting[0]
    grid = grid.copy(deep=False)
    (grid.point_data if kind == "point" else grid.cell_data).set_array(values, "Data")
    return grid, "Data", kind


def _require_scalars(values: np.ndarray, name: str, argument: str) -> None:
    if not np.issubdtype(values.dtype, np.number):
        raise TypeError(f"{argument}: the array {name!r} is of type {values.dtype}; numbers are needed.")
    if values.ndim != 1:
        raise ValueError(f"{argument}: the array {name!r} has {values.shape[1]} components; one is needed. "
                         "Pass a column, or numpy.linalg.norm(array, axis=1).")
    if not np.isfinite(values).any():
        raise ValueError(f"{argument}: the array {name!r} has no finite value.")


def _scalar_range(values: np.ndarray, name: str, clim: float | Sequence[float] | None,
                  log_scale: bool) -> tuple[float, float]:
    finite = values[np.isfinite(values)]
    if clim is None:
        low, high = float(finite.min()), float(finite.max())
        if low == high and not log_scale:
            low, high = low - 0.5, high + 0.5
    else:
        low, high = (-clim, clim) if np.isscalar(clim) else clim
    if log_scale and low <= 0:
        positive = finite[finite > 0]
        if positive.size == 0:
            raise ValueError(f"log_scale: the array {name!r} has no value above 0.")
        low = float(positive.min())
    if not (np.isfinite(low) and np.isfinite(high) and low < high):
        raise ValueError(f"clim is ({low:g}, {high:g}) for the array {name!r}; it must be two finite numbers, ascending.")
    return float(low), float(high)


def _opacity_range(grid: pyvista.DataSet, name: str | None, clim: float | Sequence[float] | None,
                   preference: str) -> tuple[float, float] | None:
    """The range of the array `name`; None if there is no array for the opacity alone."""
    if name is None:
        if clim is not None:
            raise ValueError("opacity_clim is given without opacity_scalars; the range of scalars is clim.")
        return None
    association = _association(grid, name, preference, "opacity_scalars")
    return _scalar_range(_values(grid, name, association), name, clim, False)


def _lookup_table(plotter: pyvista.BasePlotter, cmap: Any, values: np.ndarray, name: str,
                  clim: float | Sequence[float] | None, n_colors: int, flip_scalars: bool,
                  log_scale: bool) -> pyvista.LookupTable:
    if isinstance(cmap, pyvista.LookupTable):
        return cmap
    table = pyvista.LookupTable()
    table.apply_cmap(plotter.theme.cmap if cmap is None else cmap, n_colors, flip=flip_scalars)
    table.log_scale = log_scale
    table.scalar_range = _scalar_range(values, name, clim, log_scale)
    return table


def _opacities(table: pyvista.LookupTable, cmap: Any, opacity: OpacityLike, n_colors: int, on_bar: bool) -> np.ndarray:
    """Opacities at equal steps, from `cmap` if that is a table; else, if `on_bar`, also written into the scalar bar's table."""
    if table is cmap:
        return np.resize(np.asarray(table.values)[:, 3] / 255.0, max(table.n_values, 2))
    opacities = opacity_values(opacity, n_colors)
    if on_bar:
        steps = np.linspace(0, 1, table.n_values)
        table.values[:, 3] = np.rint(255 * np.interp(steps, np.linspace(0, 1, len(opacities)), opacities))
    return opacities


def _add_scalar_bar(plotter: pyvista.BasePlotter, mapper: CellCompositingMapper, title: str, show: bool | None,
                    options: dict | None) -> None:
    plotter.mapper = mapper  # as add_volume does: later calls without a mapper mean the last one added
    if plotter.theme.show_scalar_bar if show is None else show:
        plotter.add_scalar_bar(**{"title": title, **(options or {}), "mapper": mapper})
