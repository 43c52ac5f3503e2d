# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The accessor ``dataset.nephoscope`` of xarray.Dataset and xarray.DataArray."""
from __future__ import annotations

import warnings
from typing import TYPE_CHECKING, Any, Sequence

import numpy as np

from .roles import ROLES

if TYPE_CHECKING:
    import pyvista
    import xarray

    from .._typing import Numbers
    from .series import Series


FLAT = ("time", "variables", "x", "y", "z", "vertical_exaggeration", "derive")  # options of grid
LOOK = ("opacity", "cmap", "clim", "log_scale")  # of a picture
LOOK_OF_PLOT = (*LOOK, "contours", "layers", "preset", "sun", "exposure", "tone_mapping", "opacity_scale", "opacity_unit_distance")
GLOBE = ("time", "variables", "vertical", "derive")  # options of globe itself


def _options(names: dict[str, Any]) -> tuple[dict[str, Any], dict[str, Any]]:
    """Splits the options into roles and those of `to_globe`."""
    return {k: v for k, v in names.items() if k in ROLES}, {k: v for k, v in names.items() if k not in ROLES}


class WeatherAccessor:
    """Draws weather from an xarray.Dataset on a globe, a map or a flat grid, and loads only the data that are drawn.

    Parameters
    ----------
    dataset : xarray.Dataset
        The dataset that the methods read; it is not changed.
    """

    def __init__(self, dataset: xarray.Dataset) -> None:
        from .dates import with_dates
        from .naming import with_words
        self._dataset = with_dates(with_words(dataset))

    if not TYPE_CHECKING:  # for which there is nothing but the methods
        def __getattr__(self, name):
            from .. import PYVISTA_FUNCTIONS
            function = f". It is a function of the package: nephoscope.{name}(plotter, dataset, ...)." if name.startswith("add_") and name in PYVISTA_FUNCTIONS else ""
            raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}{function}")

    def _understood(self, time, vertical, roles):
        from .air import Air
        from .reading import Reading
        reading = Reading(self._dataset, time=time, vertical=vertical, names=roles)
        return reading, Air(reading)

    def _reading(self, time, options):
        """Reads one time step, by default the first, with the options of `globe`."""
        from .reading import Reading
        return Reading(self._dataset, time=0 if time is None else time, vertical=options.get("vertical"), names=_options(options)[0])

    def _air_for_light(self):
        """What `derive` must compute for light in clouds."""
        from .in_the_sun import missing_air
        return missing_air(self._reading(None, {}))

    def _of_field(self, name, time, options):
        """Returns the array that `name` means, and the options that select it."""
        if name is None:
            return None, options
        if self._is_flat(options):
            from .flat_mesh import flat_field
            found, more = flat_field(self._dataset, name)
            return found, {**more, **options} if not {"variables", "derive"} & set(options) else options
        from .naming import named
        from .vertical import axis_of
        reading = self._reading(time, options)
        name = reading.elsewhere.get(name, name)
        if "vertical" not in options and (own := axis_of(reading, name)):  # not the axis of most variables
            options = {**options, "vertical": own}
            reading = self._reading(time, options)
        found, more = named(reading, name)
        return found, {**more, **options} if not {"variables", "derive"} & set(options) else options

    def globe(self, *, time: int | str | np.datetime64 | None = None, variables: Sequence[str] | None = None, vertical: str | None = None,
              derive: str | Sequence[str] = (), **options: Any) -> pyvista.StructuredGrid | pyvista.UnstructuredGrid:
        """Make the mesh of one time step on a globe or a map, with true heights and with winds as vectors.

        Parameters
        ----------
        time : int, str or datetime, optional
            Index of the time step, or its date. Default: the first, with a warning if there are several.
        variables : sequence of str, optional
            Variables to put on the mesh. Default: all variables on the grid. Winds and heights are always read.
        vertical : str, optional
            The vertical dimension. Default: found by the attributes axis, positive, standard_name and units, by the GRIB type of level, or by name.
        derive : str or sequence of str, optional
            Quantities to compute: ``"relative_humidity"`` (1), ``"temperature"``, ``"potential_temperature"`` and ``"equivalent_potential_temperature"`` (K), ``"wind_speed"``
            (m/s), ``"vorticity"`` (1/s), ``"cloud_content"`` and ``"water_vapour"`` (kg/m3), ``"cloud_fraction"`` (1, computed from the humidity if the model has none).
        **options
            Names of variables for roles that were not found, or were found wrongly: ``u``, ``v``, ``w``, ``temperature``, ``specific_humidity``,
            ``relative_humidity``, ``pressure``, ``geopotential``, ``geopotential_height``, ``altitude``, ``surface_pressure``, ``terrain``, ``land``,
            and the clouds. False: no variable has this role. All other options are those of `nephoscope.to_globe`, for example ``vertical_exaggeration``.

        Returns
        -------
        pyvista.StructuredGrid
            As `nephoscope.to_globe` returns it.

        Raises
        ------
        ValueError
            If coordinates, levels, heights or units cannot be found; the message names what was looked for and what the dataset has.
        """
        from .derived import derived
        from .naming import refuse_unknown
        from .placing import place
        refuse_unknown("globe", options, GLOBE)
        roles, rest = _options(options)
        reading, air = self._understood(time, vertical, roles)
        return place(reading, air, variables, derived(derive, reading, air), rest)

    def grid(self, *, time: int | str | np.datetime64 | None = None, variables: Sequence[str] | None = None, x: str | None = None, y: str | None = None,
             z: str | None = None, vertical_exaggeration: float = 1.0, derive: str | Sequence[str] = ()) -> pyvista.ImageData | pyvista.RectilinearGrid:
        """Make the mesh of one time step on a flat grid, for data whose x, y and z are lengths: large-eddy simulations and cloud-resolving models.

        Points are in metres, at the positions in the dataset, and fields are on the points. Fields on faces (Arakawa C) are averaged to the centres. Temperature,
        pressure and density may be profiles along z (a base state); they become fields that are the same in every column.

        Parameters
        ----------
        time : int, str or datetime, optional
            As in `globe`.
        variables : sequence of str, optional
            Variables to put on the mesh. Default: all variables on the grid that most of them have, and the winds as the vectors ``Wind``.
        x, y, z : str, optional
            The dimensions along these axes, or coordinates along them. Default: found by units of length, axis and name, in any order. Without units
            the values are taken as metres, without a coordinate the points are 1 m apart; `describe` reports this.
        vertical_exaggeration : float, default: 1.0
            Multiplies heights, > 0. If it is not 1, ``DisplayVelocity`` is the wind in the exaggerated space.
        derive : str or sequence of str, optional
            Quantities to compute: ``"wind_speed"`` (horizontal, m/s), ``"wind_magnitude"`` (with the vertical part, m/s), ``"vorticity"`` (its upward part, 1/s),
            ``"potential_temperature"`` (K), ``"relative_humidity"`` (1), ``"cloud_content"`` and ``"water_vapour"`` (kg/m3).

        Returns
        -------
        pyvista.ImageData or pyvista.RectilinearGrid
            An ImageData if the points are evenly spaced. Two axes make a sheet.

        Raises
        ------
        ValueError
            If an axis cannot be found or is not a length; the message names what the dataset has.
        """
        from .flat import Flat
        from .flat_mesh import flat_mesh
        return flat_mesh(Flat(self._dataset, time=time, variables=variables, names={"x": x, "y": y, "z": z}), variables, vertical_exaggeration, derive)

    def mesh(self, **options: Any) -> pyvista.DataSet:
        """Make the mesh of one time step: `grid` if x and y are lengths, otherwise `globe`. Functions that take a mesh, such as `nephoscope.add_cells`,
        also take the dataset itself, and call this.

        Parameters
        ----------
        **options
            Those of `grid` or `globe`.

        Returns
        -------
        pyvista.DataSet
            As `grid` or `globe` returns it.
        """
        return (self.grid if self._is_flat(options) else self.globe)(**options)

    def series(self, *, heights: bool = False, **options: Any) -> Series:
        """Make the meshes of all time steps, each on demand.

        Parameters
        ----------
        heights : bool, default: False
            The points of ``mesh`` move with the heights of each step.
        **options
            Those of `globe` or, for a flat grid, of `grid`.

        Returns
        -------
        nephoscope.weather.series.Series
            A sequence of meshes with ``times``, ``seconds``, ``mesh`` and ``show(step)``. ``show`` gives ``mesh`` the values of a step.
        """
        from .dataset_series import DatasetSeries
        return DatasetSeries(self._dataset, heights=heights, **options)

    def column(self, quantity: str = "cloud_content", *, time: int | str | np.datetime64 | None = None, vertical: str | None = None,
               **options: Any) -> pyvista.DataSet:
        """Integrate a quantity over height, for drawing on a map or on the ground of a globe.

        Every level stands for a layer. On pressure, sigma and hybrid levels the mass of a layer is dp/g; on other levels it is the density of the air times the thickness.
        Layers meet midway between levels, or at the half levels of the model if these are known. The lowest layer above the ground reaches down to the ground, if its
        pressure or height is known. The uppermost layer of a model reaches half a layer beyond its level; levels of pressure or height and flat grids end at the last
        level, and flat grids begin at the first one. Missing values count as 0.

        Parameters
        ----------
        quantity : str, default: "cloud_content"
            ``"cloud_content"``, ``"water_vapour"``, or a variable that is a mass fraction or a content in kg/m3 or g/m3.
        time, vertical, **options
            As in `globe`; for a flat grid ``time``, ``x``, ``y`` and ``z``, as in `grid`. Heights are 0.

        Returns
        -------
        pyvista.DataSet
            One level, with the array ``column`` in kg/m2.
        """
        if self._is_flat(options):
            return self._flat_column(quantity, time, options)
        from .integrals import column_of
        from .placing import place_sheet
        from .vertical import axis_of
        roles, rest = _options(options)
        reading, air = self._understood(time, vertical, roles)
        if vertical is None and (own := axis_of(reading, quantity)):  # not the axis of most variables
            reading, air = self._understood(time, own, roles)
        return place_sheet(reading, {"column": column_of(quantity, reading, air)}, "kg m-2", rest)

    def terrain(self, *, time: int | str | np.datetime64 | None = None, vertical: str | None = None, **options: Any) -> pyvista.StructuredGrid:
        """Make the terrain as a surface, as `nephoscope.terrain_surface` does.

        Parameters
        ----------
        time, vertical
            As in `globe`.
        **options
            ``terrain`` and ``land`` name the variables; all others are those of `nephoscope.terrain_surface`.

        Returns
        -------
        pyvista.StructuredGrid
            As `nephoscope.terrain_surface` returns it.
        """
        from ..terrain import terrain_surface
        from .placing import ground_mesh
        roles, rest = _options(options)
        reading, air = self._understood(0 if time is None else time, vertical, roles)
        if air.terrain is None:
            raise ValueError("terrain: no height of the ground was found (surface_altitude, orog, HGT, surface geopotential). Name it: terrain(terrain='...').")
        return terrain_surface(ground_mesh(reading, air), "orog", **rest)

    def plot(self, scalars: str | None = None, *, time: int | str | np.datetime64 | None = None, screenshot: str | None = None, vertical_exaggeration: float | None = None,
             opacity: Any = None, cmap: Any = None, clim: float | Numbers | None = None, window_size: Sequence[int] | None = None, view: Any = None,
             background: Any = None, plotter: pyvista.Plotter | None = None, **options: Any) -> pyvista.Plotter:
        """Draw one field as a volume over the Earth, in a window or into a file; a field of one level as a surface with coasts.

        A section at one longitude or latitude, or a mean along these, is drawn by latitude or longitude and height; one row or column of a rotated or
        curvilinear grid by the distance along it. With ``projection="map"`` the picture is a map, seen from above with north up. Data whose x and y are lengths are drawn flat; see `grid`.

        Parameters
        ----------
        scalars : str, optional
            The variable, its standard name, its role (``"cloud_water"``) or a usual name of that (``"clwc"``), or a quantity to compute (``"vorticity"``; see `globe`). Default: cloud fraction,
            cloud water, or the first.
        time : int, str or datetime, optional
            As in `globe`.
        screenshot : str, optional
            File for the picture. Default: a window.
        vertical_exaggeration : float, optional
            Multiplies heights. Default: 30, but less for data that would be higher than 0.4 of their width or of the radius of the planet, such as those of small regions and
            of the thermosphere, and more for water below the sea level, so that its sides are visible. For a flat grid 1, but more if it is lower than a tenth of its width (a fifth in a section); the picture shows the factor.
        opacity, cmap, clim : optional
            As in `nephoscope.add_cells`. Water below the sea level is opaque by default, unless the field is zero almost everywhere.
            Air temperature is drawn at the lowest level above the ground, and on the outer faces of a flat grid, unless ``opacity`` or another option of
            volumes is given. Geopotentials, heights, pressures and densities on levels are drawn as departures from the mean of the level or, for data around the globe, from the zonal mean. The scalar bar
            says which. If one of these options, ``cmap`` or ``clim`` is given, the values themselves are drawn.
        window_size : sequence of 2 int, optional
            Width and height of the picture in pixels. Default: (800, 800), and less high for a map that is wider than high.
        view : sequence of 2 float, str or sequence, optional
            What the camera looks at. On a globe the longitude and latitude (degrees) that are seen from straight above, ``view=(100, 30)``. For any data, a camera position of
            PyVista: ``"xy"``, or position, focal point and upward direction. Default: the middle of the data; for data around the whole globe the side with the highest values, if there is one. Regions of an ocean
            are seen obliquely from the south. Maps are seen from above.
        background : ColorLike, optional
            Colour behind the picture; text is black or white, whichever can be read. Default: that of PyVista's global theme, if it is not white, otherwise black.
        plotter : pyvista.Plotter, optional
            Draw into the active sub-plot of this plotter, which keeps its size and its background, and do not show it: call ``plotter.show()``. If the field is also in other
            sub-plots, for example at another time, it has one colour range in all of them, unless `clim` is given or the ranges overlap by less than half.
        **options
            Those of `globe` or, for a flat grid, of `grid`, and ``log_scale``, ``contours``, ``layers``, ``preset``, ``sun``, ``exposure``, ``tone_mapping``,
            ``opacity_scale`` and ``opacity_unit_distance`` of `nephoscope.add_cells`. The sun lights all clouds, whatever `scalars` are. On a globe or a map, ``sun=True``
            is the sun at the time of the data. If they have no time, or it is night in their middle, the sun is 45 degrees above the horizon there, with a warning. A map is lit by the sun of its middle.
            On a flat grid in lengths, ``sun=True`` is the direction (1, -1, 1), as in `add_cells`.

        Returns
        -------
        pyvista.Plotter
            The plotter, after it has been shown. After ``screenshot`` it can draw further pictures: set ``plotter.camera_position``, and call ``plotter.screenshot("other.png")``.
        """
        from .naming import word
        from .plotting import Plot, plotted
        scalars = None if scalars is None else word(scalars)
        from .view import Frame
        look = {name: value for name, value in {"opacity": opacity, "cmap": cmap, "clim": clim}.items() if value is not None}
        look |= {name: options.pop(name) for name in LOOK_OF_PLOT if name in options}
        return plotted(Plot(self._dataset, scalars, time, vertical_exaggeration, look, Frame(screenshot, window_size, view, background, plotter), options))

    def _exaggeration(self, options: dict[str, Any]) -> float:
        """What suits a picture of the first step."""
        from .exaggeration import USUAL, suitable
        usual = 1.0 if self._is_flat(options) else USUAL
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # the series will tell
            return suitable(self.mesh(**{"time": 0, **options, "vertical_exaggeration": usual}), usual)

    def _is_flat(self, options: dict[str, Any]) -> bool:
        from .flat import is_flat
        return bool({"x", "y", "z"} & set(options)) or is_flat(self._dataset)

    def _flat_column(self, quantity: str, time: Any, options: dict[str, Any]) -> pyvista.DataSet:
        from .flat import Flat
        from .flat_mesh import flat_column
        unknown = [name for name in options if name not in ("x", "y", "z")]
        if unknown:
            raise TypeError(f"column() has no option {unknown[0]!r} for this dataset, whose x and y are lengths. It takes quantity, time, x, y and z.")
        return flat_column(Flat(self._dataset, time=time, names=options), quantity)

    def describe(self, *, time: int | str | np.datetime64 | None = None, vertical: str | None = None, **roles: Any) -> str:
        """Describe what `globe` or `grid` finds: grid, levels, heights, variables by their roles, and its assumptions.

        Parameters
        ----------
        time, vertical, **roles
            As in `globe`; for a flat grid ``time``, ``x``, ``y`` and ``z``, as in `grid`.

        Returns
        -------
        str
            Lines to print. If the grid or the levels are not recognized, they say why and what to do, and list the variables.
        """
        from .describing import not_understood
        from .horizontal import GridError
        from .vertical import VerticalError
        try:
            return self._described(time, vertical, roles)
        except (GridError, VerticalError) as problem:
            return not_understood(self._dataset, problem)

    def _described(self, time: int | str | np.datetime64 | None, vertical: str | None, roles: dict[str, Any]) -> str:
        if self._is_flat(roles):
            from .flat import Flat
            from .flat_mesh import described_flat
            return described_flat(Flat(self._dataset, time=0 if time is None else time, names={k: v for k, v in roles.items() if k in "xyz"}), self._dataset)
        from .describing import described
        reading, air = self._understood(0 if time is None else time, vertical, roles)
        return described(reading, air, self._dataset)


class ArrayAccessor(WeatherAccessor):
    """The accessor of a dataset that has one variable, for an xarray.DataArray."""

    def __init__(self, array: xarray.DataArray) -> None:
        super().__init__(array.to_dataset(name=array.name or "field"))


def register() -> None:
    import xarray

    from .extras import load_netcdf_of_vtk
    load_netcdf_of_vtk()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", xarray.core.extensions.AccessorRegistrationWarning)
        xarray.register_dataset_accessor("nephoscope")(WeatherAccessor)
        xarray.register_dataarray_accessor("nephoscope")(ArrayAccessor)
