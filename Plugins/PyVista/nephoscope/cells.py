# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Cell compositing: volume rendering of any 3-D cells in a PyVista plotter, with the exact ray integral."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Mapping, Sequence

import numpy as np
import pyvista

from . import vtkCellCompositingMapper
from ._blocks import cell_dimension
from ._checks import choose, renamed_argument
from ._extinction import is_extinction
from ._fields import FLAT_GRID
from ._from_xarray import add_earth_for, darken_for, title_with_units
from ._layers import Layers
from ._medium import Functions, MediumMapper, add_medium, named_extinction, require_dataset, require_plotter, scalar_array, title_of_scalars
from ._options import group, refuse_unknown
from ._surfaces import CONTOUR_NAMES, POLYGON_NAMES, Contours, Polygons
from ._uniform import FAINTER, is_bare, uniform_colours
from ._typing import ContourOptions, Integration, Interpolation, Method, Numbers, OldCellNames, Order, PolygonChoice, PolygonOptions, Preference, ToneMapping
from .light import brightest, lit_medium, refuse_color
from .transfer import OpacityLike

if TYPE_CHECKING:
    from typing import Unpack  # since Python 3.11


AROUND_CONTOURS = 10.0  # times thinner than alone: a medium whose contour surfaces are to be seen


class CellCompositingMapper(MediumMapper, vtkCellCompositingMapper):
    """The mapper with the properties that PyVista expects."""

    def copy(self) -> CellCompositingMapper:
        mapper = super().copy()
        for layer in map(self.GetLayerWithProperty, range(self.GetNumberOfLayerProperties())):
            prop = pyvista.VolumeProperty()
            prop.DeepCopy(self.GetLayerProperty(layer))
            mapper.SetLayerProperty(layer, prop)
        return mapper

    def Pick(self, renderer: Any, x: float, y: float) -> bool:
        """As `vtkCellCompositingMapper.Pick`. An off-screen plotter that has not drawn the volume yet does so first."""
        plotter = getattr(renderer, "parent", None)
        if self.GetNumberOfTetrahedra() == 0 and getattr(plotter, "off_screen", False) and getattr(plotter, "render_window", None) is not None:
            plotter.screenshot(return_img=False)
        return super().Pick(renderer, x, y)


def add_cells(plotter: pyvista.BasePlotter, grid: Any, scalars: str | np.ndarray | None = None, *, component: int | None = None,
              color: Any = None, cmap: Any = None, opacity: OpacityLike | None = None, clim: float | Numbers | None = None,
              n_colors: int = 256, flip_scalars: bool = False, log_scale: bool = False,
              opacity_scalars: str | None = None, opacity_clim: float | Numbers | None = None,
              opacity_scale: float = 1.0, opacity_unit_distance: float | None = None,
              integration: Integration = "exact", order: Order = "exact", method: Method = "automatic", split_at_control_points: bool = True,
              interpolation: Interpolation = "automatic",
              preference: Preference = "point",
              contours: int | Numbers | ContourOptions | Mapping[str, Any] | None = None,
              polygons: PolygonChoice | PolygonOptions | Mapping[str, Any] = "contours",
              layers: Mapping[int, Any] | Sequence[Any] | None = None, layer_scalars: str | None = None,
              name: str | None = None, show_scalar_bar: bool | None = None, scalar_bar_args: dict | None = None,
              reset_camera: bool | None = None, pickable: bool = True, user_matrix: Any = None,
              render: bool = True, preset: str | bool | None = None, sun: Any = None, exposure: float | None = None,
              tone_mapping: ToneMapping = "contrast", **old: Unpack[OldCellNames]) -> pyvista.Volume:
    """Add a grid of 3-D cells to a plotter as a volume drawn by `vtkCellCompositingMapper`.

    The extinction coefficient is opacity * `opacity_scale` / `opacity_unit_distance`, or your own array with ``opacity='extinction'``. Scalars vary inside cells as `interpolation` says.
    Arguments that `pyvista.Plotter.add_volume` also has mean the same here unless noted.

    Parameters
    ----------
    plotter : pyvista.Plotter
        The plotter; its active renderer gets the volume.
    grid : pyvista.DataSet, pyvista.MultiBlock, xarray.Dataset or xarray.DataArray
        Tetrahedra, hexahedra, voxels, wedges, pyramids or convex polyhedra, structured or not. A MultiBlock is combined into one grid with
        coincident points merged; blocks without 3-D cells or without the requested arrays are skipped, with a warning. A 3-D numpy array becomes
        an ImageData. Data of xarray become the mesh of ``dataset.nephoscope.mesh()``, with true heights; the scalar bar then has the
        name and the unit of the field. If they are on a globe and the sub-plot is empty, the Earth is drawn below them.
    scalars : str or numpy.ndarray, optional
        Name of a point or cell array, or values of shape (n_points,) or (n_cells,). Masked values count as missing. Default: the active scalars, otherwise the first numeric
        array, otherwise vectors; none if `color` is given or the grid has no arrays. Unlike `add_volume`, this does not change `grid`.
    component : int, optional
        If `scalars` are vectors or tensors: the component to draw, from 0. Default: their magnitude. The title of the scalar bar says which.
    color : ColorLike, optional
        One colour for the whole volume; `scalars` then set the opacity only. Without `scalars` the medium is uniform. Default for a grid
        without arrays: the theme's colour of meshes.
    cmap : str, list or pyvista.LookupTable, optional
        Colour map of the medium's emission; the name of a `preset` selects its colours. Default: the preset's, otherwise the theme's. A
        LookupTable also sets range and scale, the opacities unless `opacity` is given, and the colours and opacities beyond its range:
        ``below_range_color``, ``above_range_color``.
    opacity : str, float or sequence of float, optional
        A name: ``'linear'``, ``'geom'``, ``'sigmoid'``, ``'sigmoid_5'``, ..., each also with ``'_r'``, or ``'foreground'``; one value; or values
        from 0 to 1 at equal steps over `clim`. Evaluated in floating point, not in 8 bits. Opacities of points or cells are an array of the grid,
        `opacity_scalars`. ``'extinction'``: an array is the extinction coefficient itself, in 1/length of the grid, so that a length L of extinction b transmits exp(-b L). It is
        `opacity_scalars`, otherwise `scalars`, otherwise an array ``Extinction`` or the default scalars. Do not give `opacity_unit_distance` and `opacity_clim` then.
        Default: the preset's if there is one, otherwise ``'linear'``.
    clim : sequence of float or float, optional
        Scalars of the first and last colour; one number c means (-c, c). Default: the preset's, otherwise the range of the finite scalars,
        widened by half a unit on either side if all are equal.
    n_colors : int, default: 256
        Entries of the colour table.
    flip_scalars : bool, default: False
        Reverses the colour map.
    log_scale : bool, default: False
        Maps colours and opacities to the logarithm of the scalars. A lower limit that is not positive is replaced by the smallest positive
        scalar, with a warning if `clim` has it.
    opacity_scalars : str, optional
        Point or cell array for `opacity`, if it differs from `scalars`: for example clouds coloured by height.
    opacity_clim : sequence of float or float, optional
        With `opacity_scalars`: values of that array for the first and last opacity. Default: its range.
    opacity_scale : float, default: 1.0
        Multiplies the extinction coefficient, >= 0.
    opacity_unit_distance : float, optional
        Length in world units over which a medium of opacity 1 has an optical depth of 1, > 0. Default: the length that gives rays through the
        grid a mean optical depth of 2 (0.4 in a uniform medium), with opacities scaled to reach 1. The medium is more transparent if the opacity is concentrated in a
        small part of the grid. It depends on the size and thickness of the grid and on its opacities, but not on the number of cells. With `clim` (or `opacity_clim`) it assumes opacities that are linear over the range of the scalars, so
        that in a time series the medium fades as its values do. To compare pictures, pass the same distance for all.
    integration : {"exact", "average"}, default: "exact"
        Integration along a ray inside a tetrahedron: in closed form, or with the mean colour of the two ends.
    order : {"exact", "centroid", "none"}, default: "exact"
        Visibility order of the tetrahedra: exact, by distance of the centroid, or as stored. With ``method='cells'``, exact stands for a topological
        order, which is exact for convex meshes without cycles.
    method : {"automatic", "rays", "cells", "triangles-linear", "triangles-table", "faces"}, default: "automatic"
        Rendering method. Automatic: rays if `order` is exact, otherwise cells. Rays: each pixel traverses the mesh. The others are earlier methods,
        for comparison: cells one after another in visibility order, projected tetrahedra with interpolated opacities or with a table, and faces.
    split_at_control_points : bool, default: True
        Splits rays where `cmap` or `opacity` has a control point inside a cell, so that the integral is exact. False: both are linear between
        the ends of a ray in a cell, which is faster.
    interpolation : {"automatic", "trilinear", "tetrahedra"}, default: "automatic"
        Point scalars inside hexahedra, voxels, wedges and pyramids. Trilinear: the field of VTK's cells, without edges along the diagonals of
        cells. Tetrahedra: linear in the tetrahedra into which cells are divided, which is faster except in evenly spaced grids. Automatic:
        trilinear, except in unstructured meshes of which more than half of the cells are tetrahedra. Polygons and layers need tetrahedra.
    preference : {"point", "cell"}, default: "point"
        Which array to use if points and cells both have an array of that name, or if their numbers are equal.
    contours : int, sequence of float or dict, optional
        Lit, translucent contour surfaces inside the volume, drawn in exact order with it; no geometry is extracted. A number, or a sequence, is
        the option ``values``. The medium then has a tenth of the extinction, so that the surfaces are visible, unless you give one of `opacity`, `opacity_scalars`, `opacity_scale`,
        `opacity_unit_distance` and `layers`. Options:

        - ``values``: the values, or their number at equal steps inside the range.
        - ``opacity``, default 0.3: opacity of all surfaces, or of each surface, 0 to 1. 0: not drawn.
        - ``color``: colour of all surfaces, or of each surface. Default: the colour map's colour at the surface.
        - ``scalars``: point array to contour, if it differs from `scalars`.
        - ``lighting``, ``smooth``, default True: light the surfaces with the plotter's lights; interpolate their normals between points.
    polygons : {"contours", "all", "none"} or dict, default: "contours"
        Which polygons of the grid to draw between its cells: those that `split_cells` adds, all, or none. They are translucent surfaces in exact
        order, lit like `contours`, and must lie in faces of cells. Options:

        - ``which``: one of these.
        - ``opacity``, default 0.3: opacity of all polygons, or one for each ``ContourIndex``, 0 to 1. 0: not drawn.
        - ``color``: colour of all polygons, or one for each ``ContourIndex``. Default: the colour map's colour at the polygon.
    layers : sequence, or dict of int, optional
        How each layer is drawn: a colour, the name of a colour map over `clim` (both with the opacities of the volume), a
        `pyvista.VolumeProperty` with its own colours and opacities, or None for a layer like the volume. An item of a sequence is for the
        layer 0, 1, ... The layer of a point is the number of `contours` at or below its scalar, unless `layer_scalars` is given. A property
        whose unit distance is 1, VTK's default, has that of the volume.
        The scalar bar has the colours of the layers. It belongs to the array that divides the volume, unless that is `scalars`; each layer must then have one colour, otherwise there is no bar.
    layer_scalars : str, optional
        Cell array with the layer number of each cell.
    name : str, optional
        Name of the actor. It replaces an actor of the same name in the plotter.
    show_scalar_bar : bool, optional
        Default: the theme's; False with `sun` or `color`.
    scalar_bar_args : dict, optional
        Passed on to `pyvista.Plotter.add_scalar_bar`.
    reset_camera, pickable, render : bool, optional
        Passed on to `pyvista.Plotter.add_actor`.
    user_matrix : array_like, optional
        Transformation matrix of the volume, shape (4, 4).
    preset : str or False, optional
        Default colours, opacities and range for a weather field: ``'clouds'``, ``'cloud water'``, ``'wind speed'``, ``'wind component'``,
        ``'temperature'``, ``'humidity'``, ``'rain'`` or ``'smoke'``. Arguments that you pass take precedence. Default: chosen by the name of
        `scalars`: a CF standard name, an unambiguous name or, in data from Globe Grid and `read_cf`, a short name. No preset is chosen if `cmap`
        or `log_scale` is given or the theme's colour map has been changed. False: no preset.
    sun : sequence of 3 float, str, dict or True, optional
        Draws clouds lit by the sun: the direction towards the sun, a date and time in UTC such as ``"2011-10-11 18:30"``, or a dict of
        arguments of `sunlight` and `cloud_optics`: ``{'time': "2011-10-11 18:30", 'liquid': 'QC', 'units': 'g/kg'}``. True: uses the light in `grid`, or computes it with
        `sunlight` if there is none; for data of xarray on a globe it uses the sun at their time, as ``dataset.nephoscope.plot`` does, for other data the direction (1, -1, 1): where x
        points east and y north, the sun is in the south-east, 35 degrees above the horizon. Without an array ``Extinction``, ``'extinction'`` names the array that is the extinction coefficient, per unit of length:
        ``{'direction': (1, 0, 1), 'extinction': 'f'}``; otherwise `cloud_optics` computes it from the water of `grid`. The light then determines `scalars`, opacities and the unit
        distance; `cmap`, `clim` and `opacity_scale` may
        be given. A light from the sun replaces the lights of the renderer, unless it has scene lights, so that the ground is lit too. It stays when the volume is removed:
        ``plotter.remove_all_lights()`` and ``plotter.enable_lightkit()`` bring PyVista's lights back.
    exposure : float, optional
        With `sun`: multiplies the light, > 0. With 1, a light of 0.6 is white. Default: white is 1.1 times the light that 2 % of the
        points in clouds exceed, between 0.15 and 1.2. Set it to compare pictures, and for films in which the sun moves.
    tone_mapping : {"contrast", "linear", "filmic"}, default: "contrast"
        With `sun`: contrast displays the square of the light, like a photographic print, so that shadows are visible; filmic keeps differences
        between bright clouds visible. All include the encoding of the display.
    **old
        Earlier names of options, with a DeprecationWarning that gives the current name: `unit_distance`, `contour_opacity`, `contour_color`,
        `contour_scalars`, `contour_lighting`, `smooth_contours`, `polygon_opacity` and `polygon_color`.

    Returns
    -------
    pyvista.Volume
        The volume in the plotter: `.mapper` is the `vtkCellCompositingMapper`, `.prop` the volume property.

    Raises
    ------
    TypeError
        If `plotter` or `grid` has the wrong type, the scalars are not numeric, or an option does not exist.
    pyvista.core.errors.MissingDataError
        (a ValueError) If an array does not exist; the message lists the arrays that do.
    ValueError
        If an argument is out of range, the grid has no 3-D cells, or the scalars do not have one value per point or cell.

    Examples
    --------
    >>> plotter = pyvista.Plotter()  # doctest: +SKIP
    >>> nephoscope.add_cells(plotter, clouds, scalars="cloud_fraction", cmap=["white", "white"])  # doctest: +SKIP
    """
    require_plotter(plotter)
    data, field = grid, scalars
    surfaces = group("contours", contours, Contours, "values", old, CONTOUR_NAMES)
    painted = group("polygons", polygons, Polygons, "which", old, POLYGON_NAMES)
    opacity_unit_distance = renamed_argument(opacity_unit_distance, "opacity_unit_distance", old.pop("unit_distance", None), "unit_distance")
    refuse_unknown(add_cells, old)
    brightest(None, exposure, tone_mapping)  # rejects wrong values, also without sun
    if sun is not None:
        refuse_color(color)
        show_scalar_bar = bool(show_scalar_bar)
        light = lit_medium(plotter, data, _solid_grid(grid, {}), sun, cmap, clim, n_colors, exposure, tone_mapping)
        grid, scalars, opacity_scalars, opacity, opacity_clim, opacity_unit_distance, cmap, clim = light.values()
    grid = _solid_grid(grid, {**({"scalars": scalars} if color is None or scalars is not None else {}), "opacity_scalars": opacity_scalars,
                              "contours['scalars']": surfaces.scalars, "layer_scalars": layer_scalars})
    opacity_scalars = named_extinction(grid, opacity, scalars, opacity_scalars)
    if color is not None and scalars is None and is_extinction(opacity):
        scalars = opacity_scalars  # contours are of the extinction, in one colour
    uniform = scalars is None and (color is not None or is_bare(grid))
    if color is not None or uniform:
        cmap, show_scalar_bar = uniform_colours(plotter, color, cmap), bool(show_scalar_bar)
    if uniform:
        scalars, clim, preference = np.ones(grid.n_cells), (0, 1), "cell"
    grid, array_name, association = scalar_array(grid, scalars, preference, component)
    darken_for(plotter, data, grid)
    mapper = CellCompositingMapper()
    has_own_opacity = (any(one is not None for one in (opacity, opacity_scalars, opacity_unit_distance, layers)) or opacity_scale != 1
                       or isinstance(cmap, pyvista.LookupTable))
    if uniform and opacity_scalars is None:
        fainter = FAINTER
    else:
        fainter = 1.0 if surfaces.values is None or has_own_opacity else AROUND_CONTOURS
    prop = Functions(cmap, opacity, clim, n_colors, flip_scalars, log_scale, opacity_scalars, opacity_clim, opacity_scale, preset, fainter, component).attach(mapper, plotter, grid, array_name, association, preference, opacity_unit_distance)
    choose({"exact": mapper.SetIntegrationToExact, "average": mapper.SetIntegrationToAverage}, integration, "integration")
    choose({"exact": mapper.SetVisibilityOrderToExact, "centroid": mapper.SetVisibilityOrderToCentroid,
            "none": mapper.SetVisibilityOrderToNone}, order, "order")
    choose({"automatic": mapper.SetCellInterpolationToAutomatic, "trilinear": mapper.SetCellInterpolationToTrilinear,
            "tetrahedra": mapper.SetCellInterpolationToTetrahedra}, interpolation, "interpolation")
    choose({"automatic": mapper.SetMethodToAutomatic, "rays": mapper.SetMethodToRays, "cells": mapper.SetMethodToCells,
            "triangles-linear": mapper.SetMethodToTrianglesLinear, "triangles-table": mapper.SetMethodToTrianglesTable,
            "faces": mapper.SetMethodToFaces}, method, "method")
    mapper.SetSplitAtControlPoints(bool(split_at_control_points))
    count = surfaces.apply(mapper, grid, array_name, association, component)
    divided = Layers(layers, layer_scalars)
    divided.apply(mapper, grid, count, prop)
    painted.apply(mapper)
    bar = (mapper.lookup_table, title_of_scalars(grid, array_name, association, component))
    if layers is not None and (bar := divided.bar(mapper, grid, array_name, surfaces.scalars or array_name, bar[1])) is None:
        show_scalar_bar, bar = False, (mapper.lookup_table, "")
    add_earth_for(plotter, data, grid, array_name if sun is None else field, sun is not None)
    words = title_with_units(data, grid, array_name, bar[1]) if layers is None else None
    return add_medium(plotter, mapper, prop, bar[1], words=words, bar_table=bar[0], user_matrix=user_matrix, show_scalar_bar=show_scalar_bar, scalar_bar_args=scalar_bar_args,
                      reset_camera=reset_camera, name=name, pickable=pickable, render=render)


def _solid_grid(grid: Any, arrays: Mapping[str, Any]) -> pyvista.DataSet:
    """`grid` as one PyVista dataset with 3-D cells. If there are several blocks, only those with 3-D cells and the `arrays` are used."""
    grid = require_dataset(grid, "grid", " with 3-D cells", merge_points=True, arrays=arrays)
    if grid.n_cells == 0:
        raise ValueError(f"grid, a {type(grid).__name__} of {grid.n_points} points, has no cells.")
    if cell_dimension(grid) < 3:
        is_weather = FLAT_GRID in grid.field_data or "GlobeGridProjection" in grid.field_data
        raise ValueError(f"grid, a {type(grid).__name__} of {grid.n_cells} cells, has no 3-D cells. "
                         + ("It is one level or section: draw it by dataset.nephoscope.plot(), or as a surface, plotter.add_mesh(dataset.nephoscope.mesh())." if is_weather else
                            "Volumes need tetrahedra, hexahedra, voxels, wedges, pyramids or polyhedra."))
    return grid
