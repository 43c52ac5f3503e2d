# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Common parts of the functions that add a volume to a plotter: arrays, transfer functions, the actor and its scalar bar."""
from __future__ import annotations

import warnings
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Mapping

import numpy as np
import pyvista
from pyvista.core.errors import MissingDataError
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkHyperTreeGrid, vtkPiecewiseFunction, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkVolume, vtkVolumeProperty

from ._bars import add_bar
from ._blocks import cell_dimension, fitting, matching_arrays, named_blocks
from ._checks import arrays_of, as_array, listed, require_number
from ._components import are_colours, reduced, require_component, title_of
from ._copies import MediumVolume
from ._exports import warn_when_exported
from ._extinction import greatest_extinction, is_extinction, require_alone
from ._fields import find_preset, is_bright, is_helper, presets
from ._from_xarray import meshed
from ._frames import warn_of_other_frames
from ._globe_camera import look_at_region
from ._outliers import warn_of_fill_values
from ._over_time import densest, values_over_time
from ._peeling import peel_when_needed
from ._pipeline import level_of_caller, warn_when_drawing
from ._settings import MediumMapper
from ._typing import Numbers
from .transfer import OPACITY_NAMES, OpacityLike, opacity_values

ROUNDING = 16  # units of the last place
LUMINANCE = (0.2126, 0.7152, 0.0722)  # of red, green and blue
READABLE = 0.3  # the least difference of luminance between text and background


def require_plotter(plotter: Any) -> None:
    if not callable(getattr(plotter, "add_actor", None)):
        raise TypeError(f"plotter is a {type(plotter).__name__}; it must be a pyvista.Plotter.")


def wrapped(data: Any, merge_points: bool, arrays: Mapping[str, Any] | None = None) -> Any:
    """`data` as a PyVista object, also from xarray. Blocks of any kind and hyper tree grids become one dataset, if possible; otherwise `data` is unchanged.

    With `arrays` (argument: name), only blocks that fit are used; see `fitting`.
    """
    data = meshed(data)
    if isinstance(data, np.ndarray) and not isinstance(data, pyvista.pyvista_ndarray):
        data = as_array(data)
    if isinstance(data, (vtkCompositeDataSet, vtkHyperTreeGrid)):
        blocks = [(name, block) for name, block in named_blocks(data) if block.n_points]
        used = [block for _, block in blocks] if arrays is None else fitting(blocks, arrays, points_fit=not merge_points)
        merge_points = merge_points or all(cell_dimension(block) == 3 for block in used)  # splats of points on a common face would count twice
        return pyvista.MultiBlock(matching_arrays(used)).combine(merge_points=merge_points) if used else pyvista.UnstructuredGrid()
    try:
        return pyvista.wrap(data)
    except (TypeError, NotImplementedError):
        return data


def require_dataset(data: Any, argument: str, needs: str, merge_points: bool, arrays: Mapping[str, Any]) -> pyvista.DataSet:
    """`data` as one PyVista dataset, combined from the blocks that have the arrays; TypeError if that is impossible. `needs` ends the message."""
    data = wrapped(data, merge_points, arrays)
    if not isinstance(data, pyvista.DataSet):
        read = f" Read it: pyvista.read({str(data)!r})." if isinstance(data, (str, Path)) else ""
        raise TypeError(f"{argument} is a {type(data).__name__}; it must be a pyvista dataset or MultiBlock{needs}.{read}")
    return data


def one_mesh(mesh: Any) -> pyvista.DataSet:
    """A mesh for a filter that looks at the whole of it, such as that of sunlight: blocks become one; TypeError if `mesh` is none."""
    one = wrapped(mesh, True)
    if not isinstance(one, pyvista.DataSet):
        raise TypeError(f"mesh is a {type(one).__name__}; it must be a pyvista dataset or MultiBlock.")
    return one


def scalar_array(grid: pyvista.DataSet, scalars: str | np.ndarray | None, preference: str, component: Any) -> tuple[pyvista.DataSet, str, str]:
    """The grid with the scalars, the name of the array, and "point" or "cell". The array may have several components: `component` is that drawn, or None for the magnitude."""
    if preference not in ("point", "cell"):
        raise ValueError(f"preference is {preference!r}; it must be 'point' or 'cell'.")
    if scalars is None:
        preference, scalars = default_scalars(grid, vectors_too=True)
    if not isinstance(scalars, str):
        grid, scalars, preference = _with_values(grid, scalars, preference)
    return grid, scalars, association_of(grid, scalars, preference, "scalars", component, vectors_too=True)


def title_of_scalars(grid: pyvista.DataSet, name: str, association: str, component: int | None) -> str:
    """The title of the scalar bar."""
    return title_of(name, array_values(grid, name, association), component)


def default_scalars(grid: pyvista.DataSet, by_name: bool = False, vectors_too: bool = False) -> tuple[str, str]:
    """ "point" or "cell", and the active scalars or, if these do not have one component, the first array that does.

    Coordinates, masks and numbers are chosen last, and never if there are vectors. `by_name`: the caller's `scalars` is a name, not values. `vectors_too`: it may be
    that of vectors, which are chosen if there is nothing else.
    """
    association, name = grid.active_scalars_info
    arrays = [(kind, name, data[name]) for kind, data in (("point", grid.point_data), ("cell", grid.cell_data)) for name in data
              if not name.startswith("vtk")]
    if name is not None and any(its == name and kind == association.name.lower() and _is_scalar(values) for kind, its, values in arrays):
        return association.name.lower(), name
    kind_of_vectors, vectors = next(((kind, name) for kind, name, values in arrays if values.ndim == 2 and _are_numbers(values) and not is_helper(name) and not are_colours(values)), (None, None))
    scalars = [(kind, name) for kind, name, values in arrays if _is_scalar(values) and not (vectors and is_helper(name))]
    if not scalars and vectors is not None and vectors_too:
        return kind_of_vectors, vectors
    if not scalars:
        ids = "" if arrays or not grid.array_names else " Arrays of ids are not chosen; pass scalars= with the name to draw them."
        raise MissingDataError(f"there is no point or cell array with one component.{_magnitude(vectors, by_name)} {arrays_of(grid)}{ids}")
    return next((array for array in scalars if not is_helper(array[1])), scalars[0])


def named_extinction(mesh: pyvista.DataSet, opacity: Any, scalars: Any, opacity_scalars: str | None) -> str | None:
    """`opacity_scalars`. If neither these nor `scalars` say what the extinction is, an array ``Extinction`` is, or the default scalars."""
    if not is_extinction(opacity) or scalars is not None or opacity_scalars is not None:
        return opacity_scalars
    return "Extinction" if "Extinction" in mesh.array_names else default_scalars(mesh)[1]


def _magnitude(vectors: str | None, by_name: bool) -> str:
    if vectors is None:
        return ""
    norm = f'numpy.linalg.norm(mesh["{vectors}"], axis=1)'
    if by_name:
        return f' Make one of the magnitude, mesh["magnitude"] = {norm}, and pass scalars="magnitude".'
    return f" For the magnitude pass scalars={norm}."


def _is_scalar(values: np.ndarray) -> bool:
    return values.ndim == 1 and _are_numbers(values)


def _are_numbers(values: np.ndarray) -> bool:
    return np.issubdtype(values.dtype, np.number) and not np.iscomplexobj(values) or values.dtype == bool


def diagonal(grid: pyvista.DataSet) -> float:
    """The diagonal of the bounds of the finite points."""
    if np.isfinite(grid.length):
        return float(grid.length)
    points = np.asarray(grid.points, float)
    points = points[np.isfinite(points).all(axis=1)]
    return float(np.linalg.norm(np.ptp(points, axis=0))) if len(points) else 0.0


def association_of(grid: pyvista.DataSet, name: str, preference: str, argument: str, component: Any = None, vectors_too: bool = False) -> str:
    """ "point" or "cell", whichever has the array `name` with one component; `preference` if both have it. `vectors_too`: it may have several, of which the `component`
    is drawn, or the magnitude."""
    for association in (preference, "cell" if preference == "point" else "point"):
        if name in (grid.point_data if association == "point" else grid.cell_data):
            values = array_values(grid, name, association)
            if vectors_too:
                require_component(values, name, component)
            if values.ndim == 1 or vectors_too and values.dtype.kind != "c":
                values = values_over_time(grid, name, association, component) if _are_numbers(values) else values
            require_scalars(grid, values, name, argument)
            return association
    raise MissingDataError(f"{argument}: no array {name!r}. {arrays_of(grid, name)}")


def array_values(grid: pyvista.DataSet, name: str, association: str) -> np.ndarray:
    return (grid.point_data if association == "point" else grid.cell_data)[name]


def _with_values(grid: pyvista.DataSet, values: Any, preference: str) -> tuple[pyvista.DataSet, str, str]:
    """A shallow copy of the grid with `values` as the array "Data"."""
    values = as_array(values)
    counts = {"point": grid.n_points, "cell": grid.n_cells}
    fitting = [kind for kind, count in counts.items() if len(np.atleast_1d(values)) == count]
    if not fitting:
        raise ValueError(f"scalars has shape {values.shape}; it must have one value for each of the "
                         f"{grid.n_points} points or {grid.n_cells} cells.")
    kind = preference if preference in fitting else fitting[0]
    grid = grid.copy(deep=False)
    (grid.point_data if kind == "point" else grid.cell_data).set_array(values, "Data")
    return grid, "Data", kind


def require_scalars(grid: pyvista.DataSet, values: np.ndarray, name: str, argument: str) -> None:
    """Raises TypeError or ValueError unless the `values` of the array `name` are numeric, have one component and include a finite value."""
    if not _are_numbers(values):
        raise TypeError(f"{argument}: the array {name!r} is of type {values.dtype}; numbers are needed.")
    if values.ndim != 1:
        raise ValueError(f"{argument}: the array {name!r} has {values.shape[1]} components; one is needed. "
                         f"{_arrays_of_one_component(grid)} Name one of these, or make one: a column, or "
                         f'numpy.linalg.norm(mesh["{name}"], axis=1).')
    if not np.isfinite(values).any():
        raise ValueError(f"{argument}: the array {name!r} has no finite value.")


def _arrays_of_one_component(grid: pyvista.DataSet) -> str:
    points, cells = ([name for name in data if _is_scalar(data[name]) and not name.startswith("vtk")] for data in (grid.point_data, grid.cell_data))
    return f"Point arrays of one component: {listed(points)}; cell arrays: {listed(cells)}."


def _limits(clim: float | Numbers) -> tuple[float, float]:
    try:
        if any(isinstance(limit, str) for limit in np.atleast_1d(clim)):
            raise ValueError
        low, high = (-clim, clim) if np.isscalar(clim) else map(float, clim)
    except (TypeError, ValueError):
        raise ValueError(f"clim is {clim!r}; it must be two finite numbers, ascending, or one number.") from None
    return low, high


def _scalar_range(values: np.ndarray, name: str, clim: float | Numbers | None,
                  log_scale: bool) -> tuple[float, float]:
    finite = values[np.isfinite(values)]
    if clim is None:
        low, high = float(finite.min()), float(finite.max())
        if _is_constant(finite, low, high):
            low, high = _around(low, log_scale)
    else:
        low, high = _limits(clim)
    if log_scale and low <= 0:
        positive = finite[finite > 0]
        if positive.size == 0:
            raise ValueError(f"log_scale: the array {name!r} has no value above 0.")
        low = float(positive.min())
    if not (np.isfinite(low) and np.isfinite(high) and low < high):
        raise ValueError(f"clim is ({low:g}, {high:g}) for the array {name!r}; it must be two finite numbers, ascending.")
    return float(low), float(high)


def _is_constant(values: np.ndarray, low: float, high: float) -> bool:
    """Whether values from `low` to `high` differ by rounding errors alone."""
    precision = np.finfo(values.dtype).eps if np.issubdtype(values.dtype, np.floating) else 0.0
    return high - low <= ROUNDING * precision * max(abs(low), abs(high))


def _around(value: float, log_scale: bool) -> tuple[float, float]:
    """A range around a single value, so that it is drawn."""
    if log_scale and value > 0:
        return value / 2, value * 2
    half = max(0.5, 1e-6 * abs(value))
    return value - half, value + half


def _warn_of_transparency(values: np.ndarray, name: str, function: vtkPiecewiseFunction, limits: str) -> None:
    """Warns if the opacity function is 0 at all values. `limits`: the argument that gives its range."""
    finite = np.asarray(values, float)[np.isfinite(values)]
    nodes = np.zeros((function.GetSize(), 4))
    for i, node in enumerate(nodes):
        function.GetNodeValue(i, node)
    if nodes[:, 1].any() and not np.interp(finite, nodes[:, 0], nodes[:, 1]).any():
        low, high = finite.min(), finite.max()
        told = f"is {low:g} everywhere" if low == high else f"is {low:g} to {high:g}"
        warnings.warn(f"Nothing will be visible: the array {name!r} {told}, where the opacity function is 0. Choose another {limits} or opacity.",
                      UserWarning, stacklevel=level_of_caller())


def _warn_of_one_opacity(values: np.ndarray, name: str, function: vtkPiecewiseFunction, clim: tuple[float, float], limits: str) -> None:
    """Warns if all values are beyond the range of the opacities, at an end that is not transparent: the whole grid is a block. `limits`: the argument that gives the range."""
    finite = np.asarray(values, float)[np.isfinite(values)]
    low, high = finite.min(), finite.max()
    side, end = ("above", "upper") if low > clim[1] else ("below", "lower")
    if (low > clim[1] or high < clim[0]) and function.GetValue(low) > 0:
        what = "opacity" if limits == "opacity_clim" else "colour and the opacity"
        warnings.warn(f"The whole grid will have the {what} of the {end} end: the array {name!r} is {low:g} to {high:g}, all {side} {limits}, {clim[0]:g} to {clim[1]:g}. Choose another {limits}.",
                      UserWarning, stacklevel=level_of_caller())


def _refuse_values(grid: pyvista.DataSet, opacity: Any, n_colors: int) -> None:
    """Raises ValueError if `opacity`, a function of the scalars, is an array of the grid or its name; warns if it may be one."""
    if isinstance(opacity, str):
        if opacity in grid.array_names and opacity not in OPACITY_NAMES and not is_extinction(opacity):
            raise ValueError(f"opacity is {opacity!r}, the name of an array: pass opacity_scalars={opacity!r}. A name given as opacity is that of a function of the scalars.")
        return
    count = np.size(opacity) if opacity is not None else 0
    if count <= 2 or count not in (grid.n_points, grid.n_cells):  # two values are those of a function
        return
    arrays = [name for data in (grid.point_data, grid.cell_data) for name in data.keys() if np.shape(data[name]) == np.shape(opacity)
              and np.array_equal(data[name], opacity)]
    wanted = f"opacity_scalars={arrays[0]!r}" if arrays else 'mesh["name"] = values and opacity_scalars="name"'
    kind = "points" if count == grid.n_points else "cells"
    told = f"opacity has {count} values, as many as the grid has {kind}, but its values are those of a function, at equal steps over the range of the scalars."
    if arrays or count > n_colors:
        raise ValueError(f"{told} For opacities of {kind} pass {wanted}.")
    warnings.warn(f"{told} For opacities of {kind} pass {wanted}.", UserWarning, stacklevel=level_of_caller())


def _with_scalars(grid: pyvista.DataSet, name: str, association: str, component: int | None) -> pyvista.DataSet:
    """The grid; if the array has several components, a shallow copy in which it has those values that are drawn."""
    values = array_values(grid, name, association)
    if values.ndim == 1:
        return grid
    grid = grid.copy(deep=False)
    (grid.point_data if association == "point" else grid.cell_data)[name] = reduced(values, component)
    return grid


def _ramp(values: np.ndarray) -> vtkVolumeProperty:
    """Opacities from 0 to 1 over the range of the values. Their scale does not matter, so that with limits set by the user a medium fades as
    its values do."""
    low, high = _scalar_range(np.asarray(values, float), "", None, False)
    opacities = vtkPiecewiseFunction()
    opacities.AddPoint(low, 0)
    opacities.AddPoint(high, 1)
    prop = vtkVolumeProperty()
    prop.SetScalarOpacity(opacities)
    return prop


@dataclass
class Functions:
    """The arguments of `add_cells` that give colour and opacity; see there."""
    cmap: Any = None
    opacity: OpacityLike | None = None
    clim: float | Numbers | None = None
    n_colors: int = 256
    flip_scalars: bool = False
    log_scale: bool = False
    opacity_scalars: str | None = None
    opacity_clim: float | Numbers | None = None
    opacity_scale: float = 1.0
    preset: str | bool | None = None
    fainter: float = 1.0  # multiplies the default unit distance
    component: int | None = None  # of vectors; None: their magnitude
    opacity_of_table: bool = False  # found when the defaults are

    def attach(self, mapper: MediumMapper, plotter: pyvista.BasePlotter, grid: pyvista.DataSet, name: str, association: str,
               preference: str, unit_distance: float | None) -> pyvista.VolumeProperty:
        """The property of a volume of the array `name`, which `mapper` will draw. The default `unit_distance` makes the medium visible."""
        if is_extinction(self.opacity):
            unit_distance = self._take_extinction(grid, name, preference, unit_distance)
        limits_given = (self.clim if self.opacity_scalars is None else self.opacity_clim) is not None
        _refuse_values(grid, self.opacity, self.n_colors)
        clim = self.clim
        self._take_preset(plotter, grid, name, association)
        table = self._lookup_table(plotter, values_over_time(grid, name, association, self.component), name)
        if clim is not None and table is not self.cmap and table.log_scale and _limits(clim)[0] <= 0:
            warnings.warn(f"clim begins at {_limits(clim)[0]:g}, but a logarithmic scale at a positive number: {table.scalar_range[0]:g} is taken, the smallest positive value of {name!r}.",
                          UserWarning, stacklevel=level_of_caller())
        if clim is None and table is not self.cmap:
            warn_of_fill_values(values_over_time(grid, name, association, self.component), name, grid, "clim")
        opacities = self._opacities(table)
        opacity_range = self._opacity_range(grid, preference)
        mapper.SetInputData(grid)
        mapper.SelectScalarArray(name)
        if association == "point":
            mapper.SetScalarModeToUsePointFieldData()
        else:
            mapper.SetScalarModeToUseCellFieldData()
        mapper._vectors, mapper._component = array_values(grid, name, association).ndim > 1, self.component
        mapper.SetOpacityArrayName(self.opacity_scalars or "")
        mapper.SetOpacityScale(require_number(self.opacity_scale, "opacity_scale", least=0))
        given = 1.0 if unit_distance is None else require_number(unit_distance, "opacity_unit_distance", above=0)
        prop = pyvista.VolumeProperty(opacity_unit_distance=given)
        mapper.attach(prop, table, opacities, opacity_range)
        read = name if self.opacity_scalars is None else self.opacity_scalars
        read_at = association if self.opacity_scalars is None else association_of(grid, read, preference, "opacity_scalars")
        values = values_over_time(grid, read, read_at, self.component)
        _warn_of_transparency(values, read, prop.GetScalarOpacity(), "clim" if self.opacity_scalars is None else "opacity_clim")
        if table is not self.cmap:
            _warn_of_one_opacity(values, read, prop.GetScalarOpacity(), opacity_range or table.scalar_range, "clim" if self.opacity_scalars is None else "opacity_clim")
        if unit_distance is None:
            measured = _ramp(values) if limits_given else prop
            mapper.SetInputData(_with_scalars(densest(grid, read, measured.GetScalarOpacity(), self.component), read, read_at, self.component))
            prop.opacity_unit_distance = self.fainter * (mapper.FindUnitDistance(measured) or diagonal(grid) or 1.0)
            mapper.SetInputData(grid)
        return prop

    def _take_extinction(self, grid: pyvista.DataSet, name: str, preference: str, unit_distance: float | None) -> float:
        """Lets the opacity be the extinction coefficient, without a function. Returns the unit distance."""
        require_alone(opacity_unit_distance=unit_distance, opacity_clim=self.opacity_clim)
        self.opacity_scalars = self.opacity_scalars or name
        values = values_over_time(grid, self.opacity_scalars, association_of(grid, self.opacity_scalars, preference, "opacity='extinction'"))
        greatest = greatest_extinction(values, self.opacity_scalars, diagonal(grid), require_number(self.opacity_scale, "opacity_scale", least=0))
        self.opacity, self.opacity_clim = "linear", (0.0, greatest)
        return 1 / greatest

    def _take_preset(self, plotter: pyvista.BasePlotter, grid: pyvista.DataSet, name: str, association: str) -> None:
        """Takes colours, opacities and range from the preset, unless the user has set them."""
        if isinstance(self.cmap, str) and self.cmap in presets():
            self.cmap = presets()[self.cmap].colour_map(is_bright(plotter.background_color))
        chosen = find_preset(self.preset, title_of_scalars(grid, name, association, self.component), grid)
        if self.preset is None and (self.cmap is not None or self.log_scale or plotter.theme.cmap != pyvista.themes.Theme().cmap):
            chosen = None
        ours = chosen is not None and self.opacity is None and self.opacity_scalars is None
        if chosen is not None:
            self.cmap = chosen.colour_map(is_bright(plotter.background_color)) if self.cmap is None else self.cmap
            self.clim = chosen.clim(values_over_time(grid, name, association, self.component)) if self.clim is None else self.clim
        self.opacity_of_table = self.opacity is None and isinstance(self.cmap, pyvista.LookupTable)
        if self.opacity is None:
            self.opacity = chosen.opacity_values() if ours else "linear"

    def _lookup_table(self, plotter: pyvista.BasePlotter, values: np.ndarray, name: str) -> pyvista.LookupTable:
        if isinstance(self.cmap, pyvista.LookupTable):
            return self.cmap
        return lookup_table(plotter, values, name, self.cmap, self.clim, n_colors=self.n_colors, flip=self.flip_scalars,
                            log_scale=self.log_scale)

    def _opacities(self, table: pyvista.LookupTable) -> np.ndarray:
        """Opacities at equal steps, from `cmap` if it is a table and none are given. Those of other tables are also written to the scalar bar, if they
        belong to its array."""
        if self.opacity_of_table:
            return np.resize(np.asarray(table.values)[:, 3] / 255.0, max(table.n_values, 2))
        opacities = opacity_values(self.opacity, self.n_colors)
        if table is not self.cmap and self.opacity_scalars is None and np.any(opacities):  # vectors only: their colours are in the bar
            steps = np.linspace(0, 1, table.n_values)
            table.values[:, 3] = np.rint(255 * np.interp(steps, np.linspace(0, 1, len(opacities)), opacities))
        return opacities

    def _opacity_range(self, grid: pyvista.DataSet, preference: str) -> tuple[float, float] | None:
        """The range of `opacity_scalars`; None if opacity has no separate array."""
        name = self.opacity_scalars
        if name is None:
            if self.opacity_clim is not None:
                raise ValueError("opacity_clim is given without opacity_scalars; the range of scalars is clim.")
            return None
        association = association_of(grid, name, preference, "opacity_scalars")
        values = values_over_time(grid, name, association)
        if self.opacity_clim is None:
            warn_of_fill_values(values, name, grid, "opacity_clim")
        return _scalar_range(values, name, self.opacity_clim, False)


def lookup_table(plotter: pyvista.BasePlotter, values: np.ndarray, name: str, cmap: Any, clim: float | Numbers | None, *,
                 n_colors: int = 256, flip: bool = False, log_scale: bool = False) -> pyvista.LookupTable:
    """The colours of the array `name`: by default the theme's colours over the range of the array."""
    require_number(n_colors, "n_colors", least=1)
    if cmap is not None and not isinstance(cmap, str) and hasattr(cmap, "__len__") and len(cmap) == 0:
        raise ValueError("cmap has no colours: give at least one, or the name of a colour map.")
    table = pyvista.LookupTable()
    table.apply_cmap(plotter.theme.cmap if cmap is None else cmap, int(n_colors), flip=flip)
    table.log_scale = log_scale
    table.scalar_range = _scalar_range(values, name, clim, log_scale)
    return table


def is_light(plotter: pyvista.BasePlotter) -> bool:
    """Whether dark grey stands out better than white from the background of the active renderer."""
    return float(np.dot(plotter.background_color.float_rgb, LUMINANCE)) > 0.7


def _warn_of_camouflage(plotter: pyvista.BasePlotter, table: pyvista.LookupTable) -> None:
    """Warns about a medium with the colour of the background, which is invisible unless a surface or another volume may be behind it."""
    colours = np.asarray(table.values, float)[:, :3] / 255.0
    contrast = np.abs(colours - plotter.background_color.float_rgb).max()
    if contrast < 0.1 and not any(map(_may_be_a_backdrop, plotter.renderer.actors.values())):
        warnings.warn("The volume has the colour of the background, so it will be invisible: choose another colour (color or cmap), or "
                      "call plotter.set_background('black') first.", UserWarning, stacklevel=level_of_caller())


def _may_be_a_backdrop(actor: Any) -> bool:
    """A volume, or an actor with polygons that are filled; not lines, points or text."""
    if not isinstance(actor, vtkActor):
        return isinstance(actor, vtkVolume)
    mapper = actor.GetMapper()
    data = mapper.GetInputDataObject(0, 0) if mapper is not None and mapper.GetNumberOfInputPorts() else None
    has_polygons = not isinstance(data, vtkPolyData) or data.GetNumberOfPolys() + data.GetNumberOfStrips() > 0
    return has_polygons and actor.GetProperty().GetRepresentationAsString() == "Surface"


def text_colour(plotter: pyvista.BasePlotter) -> pyvista.Color:
    """The theme's colour of text, if it can be read on the background of the active renderer; see `readable`."""
    return readable(plotter.theme.font.color, plotter.background_color)


def readable(colour: pyvista.Color, background: pyvista.Color) -> pyvista.Color:
    """`colour`, or black or white if text of it could not be read on the background."""
    back, text = (float(np.dot(one.float_rgb, LUMINANCE)) for one in (background, colour))
    return colour if abs(back - text) >= READABLE else pyvista.Color("black" if back > 0.5 else "white")


def _add_bar(plotter: pyvista.BasePlotter, mapper: MediumMapper, title: str, words: str, table: pyvista.LookupTable | None, options: dict) -> None:
    annotated = table is not None and table.GetNumberOfAnnotatedValues() > 0
    upright = {"vertical": True} if annotated else {}
    bar = add_bar(plotter, **{"title": title, "color": text_colour(plotter), **upright, **options, "mapper": mapper})
    if bar is not None and "title" not in options:
        bar.SetTitle(words)
    if bar is None or table in (None, mapper.lookup_table):
        return
    bar.SetLookupTable(table)
    bar.SetMaximumNumberOfColors(table.n_values)
    if annotated:
        bar.SetDrawTickLabels(False)


def add_medium(plotter: pyvista.BasePlotter, mapper: MediumMapper, prop: pyvista.VolumeProperty, title: str, *, user_matrix: Any,
               words: str | None = None, bar_table: pyvista.LookupTable | None = None, show_scalar_bar: bool | None, scalar_bar_args: dict | None, **actor_options: Any) -> pyvista.Volume:
    """Adds the volume and its scalar bar to the plotter. `words`: the title of the bar, if it is not `title`, by which PyVista knows it. `bar_table`: the colours of the bar,
    if they are not those of the mapper."""
    warn_of_other_frames(plotter, mapper.dataset)
    warn_when_drawing(mapper)
    volume = MediumVolume()
    volume.prop, volume.mapper = prop, mapper
    if user_matrix is not None:
        volume.user_matrix = user_matrix
    _warn_of_camouflage(plotter, mapper.lookup_table)
    plotter.add_actor(volume, **actor_options)
    if actor_options.get("reset_camera") is None and user_matrix is None and not plotter.renderer.camera.is_set:
        look_at_region(plotter, mapper.dataset)
    warn_when_exported(plotter)
    peel_when_needed(plotter)
    plotter.mapper = mapper  # as in add_volume: later calls without a mapper refer to the last one added
    if plotter.theme.show_scalar_bar if show_scalar_bar is None else show_scalar_bar:
        _add_bar(plotter, mapper, title, title if words is None else words, bar_table, scalar_bar_args or {})
    return volume
