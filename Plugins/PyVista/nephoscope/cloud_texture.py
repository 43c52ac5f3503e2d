# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces of clouds with a texture of broken cloud (`vtkCloudTextureMapper`)."""
from __future__ import annotations

import warnings
from typing import Any, Sequence

import numpy as np
import pyvista
from pyvista.core.errors import MissingDataError
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkDataSet, vtkHyperTreeGrid, vtkOverlappingAMR, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor

from . import vtkCloudTextureMapper
from ._bars import add_mesh
from ._blocks import cell_dimension, named_blocks, outer_surface
from ._checks import arrays_of, as_array, choose, listed, require_number
from ._components import require_component, title_of
from ._copies import copied_mapper
from ._exports import warn_when_exported
from ._fields import is_bright
from ._from_xarray import meshed
from ._medium import default_scalars, require_plotter, wrapped
from ._pipeline import warn_when_drawing
from ._settings import KnownSettings
from ._typing import Numbers
from .light import add_sun, brightest, lit_colours, lit_surface

AMBIENT = 0.4  # of the light on a surface that faces the sun, on one that does not, as clouds scatter light all around

GREY, THIN = "#a3b8cf", "#f0f4f8"  # of clouds on a bright background, whose thin parts are lighter


class CloudTextureMapper(KnownSettings, vtkCloudTextureMapper):
    """The mapper with what PyVista's actors and scalar bars read and write."""

    @property
    def dataset(self) -> pyvista.PolyData:
        self.GetInputAlgorithm(0, 0).Update()
        return pyvista.wrap(self.GetInput())

    @property
    def lookup_table(self) -> Any:
        return self.GetLookupTable()

    @lookup_table.setter
    def lookup_table(self, table: Any) -> None:
        self.SetLookupTable(table)

    @property
    def scalar_range(self) -> tuple[float, float]:
        return self.GetScalarRange()

    @scalar_range.setter
    def scalar_range(self, clim: Numbers) -> None:
        self.SetScalarRange(*clim)
        if hasattr(self.GetLookupTable(), "scalar_range"):
            self.GetLookupTable().scalar_range = tuple(clim)

    def copy(self) -> CloudTextureMapper:
        """A mapper with the same settings, independent of this one except for the shared data."""
        mapper = copied_mapper(self)
        mapper.SelectColorArray(self.GetArrayName())  # which ShallowCopy leaves out
        return mapper

    @property
    def bounds(self) -> tuple[float, ...]:
        return self.GetBounds()


def _density_volume(volume: Any, name: str | None) -> tuple[pyvista.DataObject, str]:
    """The grid, or its blocks, and the name of the array of densities."""
    volume = meshed(volume)
    if isinstance(volume, (vtkHyperTreeGrid, vtkOverlappingAMR)):  # leaves out cells that finer cells cover
        volume = wrapped(volume, merge_points=False)
    if not isinstance(volume, (vtkDataSet, vtkCompositeDataSet)):
        raise TypeError(f"density_volume is a {type(volume).__name__}; it must be a PyVista grid, or blocks of grids.")
    blocks = [block for _, block in named_blocks(volume) if block.n_points] if isinstance(volume, vtkCompositeDataSet) else [pyvista.wrap(volume)]
    if not any(cell_dimension(block) == 3 for block in blocks):
        raise ValueError("density_volume has no three-dimensional cells.")
    if name is None:
        name = default_scalars(blocks[0])[1]
    if not any(name in block.point_data or name in block.cell_data for block in blocks):
        raise MissingDataError(f"density: no array {name!r}. {arrays_of(blocks[0])}")
    return volume, name


def add_cloud_texture(plotter: pyvista.BasePlotter, mesh: Any, scalars: str | np.ndarray | None = None, *,
                      color: Any = None, coverage: float | str | None = None, threshold: float | None = None, texture_scale: float = 0.0,
                      texture_length: float = 0.0, waves: str | Any = "clouds", use_altitude: bool = False,
                      altitude_range: Numbers = (0.0, 0.0), softness: float | None = None, relief: float = 0.03, thin_color: Any = None,
                      thick_color: Any = None, color_range: float = 1.5, optical_depth: float = 3.0, use_thickness: bool | None = None,
                      thickness_effect: str | None = None, thickness_weight: float = 1.0, extinction: float = 0.0, density: str | None = None,
                      density_volume: Any = None, layers: int = 8,
                      coordinates: Sequence[str] = ("TextureCoordinates1", "TextureCoordinates2"), peels: int = 8,
                      sun: Any = None, exposure: float | None = None, tone_mapping: str = "contrast", **options: Any) -> pyvista.Actor:
    """Add a cloud surface to a plotter, with a texture of broken cloud whose cloud fraction you choose.

    Parameters
    ----------
    plotter : pyvista.Plotter
        The plotter; its active renderer gets the surface.
    mesh : pyvista.PolyData, pyvista.MultiBlock or pyvista.DataSet
        The surface, for example from `cloud_surface`. Blocks are combined; for other data the outer surface is drawn. With the coordinates of
        `advect_texture` the texture moves with the wind; without them it is fixed to positions.
    scalars : str or numpy.ndarray, optional
        Point or cell array that colours the clouds; vectors give their magnitude, or one component if `component` is among the options. Default: none, the clouds have one colour.
    color : ColorLike, optional
        The colour without `scalars`. Default: white; on a bright background a bluish grey with soft edges and weak shades, unless
        the plotter has another surface, such as the ground. White clouds look more natural on a blue or dark background.
    coverage : float or str, optional
        Fraction of the surface that is cloud, 0 to 1, or the name of a point array with it, such as the cloud fraction of a model. Default: 0.5;
        with ``thickness_effect="threshold"``, which adds cloud where the thickness is large, 0.1.
    threshold : float, optional
        Instead of `coverage`: texture value above which there is cloud, in standard deviations. The cover then follows from it.
    texture_scale : float, default: 0.0
        Number of texture periods around the equator, or along the longest side of a surface that is not a globe, up to 1e6. 0: chosen from the
        shape of the surface.
    texture_length : float, default: 0.0
        Length of one texture unit if positions are the texture coordinates, >= 0. 0: chosen from the surface.
    waves : str or array_like, default: "clouds"
        The waves that add up to the texture: ``"clouds"``, in all directions; ``"paper"``, 7 waves with a phase shift across each wave;
        ``"printed"``, the formula as the paper prints it; ``"gardner"``, along the axes; or up to 16 rows of 9 numbers, as in
        `vtkCloudTextureMapper.SetCustomWave`.
    use_altitude : bool, default: False
        True: the third texture coordinate is the altitude, 0 to 1; on a globe the other two are longitude and latitude, as in the paper.
    altitude_range : sequence of 2 float, default: (0.0, 0.0)
        With `use_altitude`: the altitudes that map to 0 and 1. If they are not in increasing order: the range of the data.
    softness : float, optional
        Width of cloud edges, in standard deviations of the texture, 0 to 2. Default: 0.4; 0.8 with the bluish grey that `color` has on a bright background.
    relief : float, default: 0.03
        Height of the bump map that shades the clouds, as a fraction of the longest wavelength of the texture, 0 to 1.
    thin_color : ColorLike, optional
        Colour where the texture just exceeds the threshold; it multiplies the colour of the surface. Default: a bluish grey; nearly white with the bluish grey that `color` has on a
        bright background.
    thick_color : ColorLike, optional
        Colour where the texture exceeds the threshold by `color_range` or more; smaller values blend it with `thin_color`. Default: white.
    color_range : float, default: 1.5
        Interval of texture values from `thin_color` to `thick_color`, in standard deviations of the texture, > 0.
    optical_depth : float, default: 3.0
        Optical depth of the clouds at normal incidence, >= 0.
    use_thickness : bool, optional
        Opacity follows the thickness of the clouds: from each front face to the next back face, or to an opaque object. Default: True if
        `thickness_effect`, `extinction`, `density` or `density_volume` is given.
    thickness_effect : str, optional
        With `use_thickness`. ``"opacity"``, the default: the thickness sets the opacity. ``"threshold"``: `thickness_weight` times the optical depth is added
        to the texture before the threshold, so that thin edges break up.
    thickness_weight : float, default: 1.0
        With ``thickness_effect="threshold"``: weight of the optical depth, >= 0.
    extinction : float, default: 0.0
        With `use_thickness`: extinction coefficient, per unit of length, >= 0. 0: rays have `optical_depth` on average.
    density : str, optional
        With `use_thickness`: array that multiplies `extinction`. It is a point array of the surface, and varies linearly along rays between its
        faces, or a point or cell array of `density_volume`.
    density_volume : pyvista.DataSet, pyvista.MultiBlock, xarray.Dataset or xarray.DataArray, optional
        With `use_thickness`: cloud density in space, integrated exactly along rays inside the surface; for example the grid from which the surface
        was made. `density` is then by default its active array, otherwise the first one.
    layers : int, default: 8
        With `use_thickness`: maximum number of clouds behind one another in a pixel, 2 to 16.
    coordinates : sequence of 2 str, default: ("TextureCoordinates1", "TextureCoordinates2")
        Point arrays of texture coordinates. Missing arrays are ignored.
    peels : int, default: 8
        Number of depth peels of the renderer, which draw clouds in order: behind one another, and in front of, inside and behind the volumes of `add_cells`,
        `add_splats` and `add_smoke`. Multi-sampling is turned off for it. 0: the plotter is not changed.
    sun : sequence of 3 float, str, dict or True, optional
        Lights the surface by the sun, given as in `add_cells`. A surface made by `cloud_surface` from lit data carries the array ``Sunlight``, with the shadows of
        the clouds: True uses it. Otherwise True is the direction (1, -1, 1), and the surface is sunlit, except on the night side of a globe and in the shadows of ``{'clouds': lit_clouds}``. A light
        from the sun replaces the lights of the renderer, unless it has scene lights, so that slopes and the ground are lit too.
    exposure, tone_mapping
        As in `add_cells`.
    **options
        Other arguments of `pyvista.Plotter.add_mesh`: `cmap`, `clim`, `opacity`, `lighting`, `specular`, `name`, ... A surface with normals, as from
        `cloud_surface`, is smooth unless `smooth_shading` is False.

    Returns
    -------
    pyvista.Actor
        The actor; its `.mapper` is the `vtkCloudTextureMapper`.

    Raises
    ------
    TypeError
        If `plotter` is not a plotter.
    pyvista.core.errors.MissingDataError
        (a ValueError) If a point array does not exist; the message lists the arrays that do.
    ValueError
        If a number is out of range, or the mesh has no polygons.

    Warns
    -----
    RuntimeWarning
        If `use_thickness` is False and an argument that needs it is given.
    """
    require_plotter(plotter)
    surface = _surface(mesh)
    mapper = CloudTextureMapper()
    warn_when_drawing(mapper)
    use_thickness = _needs_thickness(use_thickness, {"thickness_effect": thickness_effect, "extinction": extinction or None, "density": density,
                                                     "density_volume": density_volume})
    if coverage is None:
        coverage = 0.1 if use_thickness and thickness_effect == "threshold" else 0.5
    _set_cover(mapper, surface, coverage, threshold)
    mapper.SetTextureScale(require_number(texture_scale, "texture_scale", least=0, most=1e6))
    mapper.SetTextureLength(require_number(texture_length, "texture_length", least=0))
    in_grey = scalars is None and color is None and _needs_grey(plotter)
    mapper.SetSoftness(require_number((0.8 if in_grey else 0.4) if softness is None else softness, "softness", least=0, most=2))
    mapper.SetRelief(require_number(relief, "relief", least=0, most=1))
    _set_waves(mapper, waves)
    mapper.SetUseAltitude(use_altitude)
    if len(altitude_range) != 2:
        raise ValueError(f"altitude_range is {altitude_range!r}; it must be two altitudes.")
    mapper.SetAltitudeRange([require_number(altitude, "altitude_range") for altitude in altitude_range])
    for given, setter in ((THIN if in_grey and thin_color is None else thin_color, mapper.SetThinColor), (thick_color, mapper.SetThickColor)):
        if given is not None:
            setter(pyvista.Color(given).float_rgb)
    mapper.SetColorRange(require_number(color_range, "color_range", least=1e-6, most=1e6))
    mapper.SetOpticalDepth(require_number(optical_depth, "optical_depth", least=0))
    mapper.SetUseThickness(use_thickness)
    choose({"opacity": mapper.SetThicknessEffectToMultiplyOpacity, "threshold": mapper.SetThicknessEffectToAddToTexture},
           thickness_effect or "opacity", "thickness_effect")
    mapper.SetThicknessWeight(require_number(thickness_weight, "thickness_weight", least=0))
    mapper.SetExtinction(require_number(extinction, "extinction", least=0))
    _set_density(mapper, surface, density, density_volume)
    mapper.SetMaximumNumberOfLayers(int(require_number(layers, "layers", least=2, most=16)))
    if isinstance(coordinates, str) or len(coordinates) != 2:
        raise ValueError(f"coordinates is {coordinates!r}; it must be the names of two point arrays.")
    mapper.SetFirstCoordinatesName(coordinates[0])
    mapper.SetSecondCoordinatesName(coordinates[1])
    peels = int(require_number(peels, "peels", least=0))
    if scalars is not None and not isinstance(scalars, str):
        scalars = as_array(scalars)
    if scalars is not None and not options.get("rgb"):
        _say_component(surface, scalars, options)
    if scalars is None:
        options["color"] = color if color is not None else GREY if in_grey else "white"
    if in_grey and not {"ambient", "diffuse"} & set(options):
        options.update(ambient=AMBIENT, diffuse=1 - AMBIENT)
    brightest(None, exposure, tone_mapping)  # rejects wrong values, also without sun
    if sun is not None:
        surface, scalars = _light(plotter, surface, scalars, sun, exposure, tone_mapping, options)
    render = options.pop("render", True)
    actor = add_mesh(plotter, surface, scalars if isinstance(scalars, str) else "Data", scalars=scalars, render=False, **options)  # its mapper is not yet ours
    _replace_mapper(plotter, actor, mapper)
    if "smooth_shading" not in options and surface.point_data.GetNormals() is not None and actor.prop.interpolation.name == "FLAT":
        actor.prop.interpolation = "Phong"
    warn_when_exported(plotter)
    if peels > 0:
        plotter.enable_depth_peeling(peels)
        plotter.renderer.UseDepthPeelingForVolumesOn()  # as in ParaView: the clouds may be in front of volumes, or in them
        plotter.render_window.SetMultiSamples(0)  # VTK does not peel in a multi-sampled window
    if render:
        plotter.render()
    return actor


def _light(plotter: pyvista.BasePlotter, surface: pyvista.PolyData, scalars: Any, sun: Any, exposure: float | None, tone_mapping: str,
           options: dict[str, Any]) -> tuple[pyvista.PolyData, str]:
    """The surface with its light, and the name of that; options of `add_mesh` that draw it, and a light for the slopes."""
    if scalars is not None:
        raise ValueError("scalars and sun are both given: the colours are those of the light. Leave one out; color multiplies the light.")
    surface, direction = lit_surface(surface, sun)
    tint = pyvista.Color(options.pop("color")).float_rgb
    own = {"cmap": lit_colours(256, tone_mapping, tint), "clim": (0.0, brightest(surface, exposure, tone_mapping)), "show_scalar_bar": False,
           "ambient": AMBIENT, "diffuse": 1 - AMBIENT}
    options.update({name: value for name, value in own.items() if name not in options})
    add_sun(plotter, direction)
    return surface, "Sunlight"


def _say_component(surface: pyvista.PolyData, scalars: str | np.ndarray, options: dict[str, Any]) -> None:
    """Titles the scalar bar of vectors, of which `add_mesh` draws the magnitude or a component. Raises TypeError or ValueError as `require_component` does."""
    name = scalars if isinstance(scalars, str) else "Data"
    values = surface[name] if isinstance(scalars, str) and name in surface.array_names else scalars
    if np.ndim(values) == 2:
        require_component(values, name, options.get("component"), "For the colours themselves pass rgb=True.")
        options["scalar_bar_args"] = {"title": title_of(name, values, options.get("component")), **(options.get("scalar_bar_args") or {})}


def _set_cover(mapper: CloudTextureMapper, surface: pyvista.PolyData, coverage: float | str, threshold: float | None) -> None:
    if isinstance(coverage, str):
        mapper.SetCoverageArrayName(_point_array(surface, coverage, "coverage"))
    else:
        mapper.SetCoverage(require_number(coverage, "coverage", least=0, most=1))
    if threshold is not None:
        mapper.UseThresholdOn()
        mapper.SetThreshold(require_number(threshold, "threshold"))


def _set_density(mapper: CloudTextureMapper, surface: pyvista.PolyData, density: str | None, density_volume: Any) -> None:
    if density_volume is not None:
        volume, name = _density_volume(density_volume, density)
        mapper.SetDensityVolume(volume)
        mapper.SetDensityArrayName(name)
    elif density is not None:
        mapper.SetDensityArrayName(_point_array(surface, density, "density"))


def _replace_mapper(plotter: pyvista.BasePlotter, actor: pyvista.Actor, mapper: CloudTextureMapper) -> None:
    """Lets the actor draw by `mapper`, with the colours that `add_mesh` has set."""
    drawn = actor.mapper
    mapper.ShallowCopy(drawn)
    mapper.SelectColorArray(drawn.GetArrayName())  # which ShallowCopy leaves out
    mapper.SetInputConnection(drawn.GetInputConnection(0, 0))
    actor.SetMapper(mapper)
    for mappers in plotter.scalar_bars._scalar_bar_mappers.values():  # a bar belongs to the actor of its mapper
        mappers[:] = [mapper if one is drawn else one for one in mappers]
    if plotter.mapper is drawn:
        plotter.mapper = mapper


def _needs_thickness(use_thickness: bool | None, settings: dict[str, Any]) -> bool:
    """`use_thickness` if it is given, otherwise whether any setting of the thickness is given. Warns about settings that have no effect."""
    given = [name for name, value in settings.items() if value is not None]
    if use_thickness is None:
        return bool(given)
    if given and not use_thickness:
        warnings.warn(f"use_thickness is False: {listed(given)} will not be used.", RuntimeWarning, stacklevel=3)
    return use_thickness


def _set_waves(mapper: CloudTextureMapper, waves: Any) -> None:
    if isinstance(waves, str):
        choose({"clouds": mapper.SetWavesToClouds, "paper": mapper.SetWavesToPaper, "printed": mapper.SetWavesToPrinted,
                "gardner": mapper.SetWavesToGardner}, waves.lower(), "waves")
        return
    table = as_array(waves).astype(float)
    if table.ndim != 2 or table.shape[1] != 9 or not 1 <= len(table) <= 16 or not np.isfinite(table).all():
        raise ValueError(f"waves has the shape {table.shape}; it must be 1 to 16 rows of 9 finite numbers, or the name of a preset.")
    mapper.SetWavesToCustom()
    mapper.SetNumberOfCustomWaves(len(table))
    for i, row in enumerate(table):
        mapper.SetCustomWave(i, *row)


def _needs_grey(plotter: pyvista.BasePlotter) -> bool:
    """Whether white would not be visible: on a bright background, without the ground."""
    return is_bright(plotter.background_color) and not any(_is_ground(actor) for actor in plotter.renderer.actors.values())


def _is_ground(actor: Any) -> bool:
    """True for a surface that this package did not draw."""
    data = actor.GetMapper().GetInputDataObject(0, 0) if isinstance(actor, vtkActor) and actor.GetMapper() else None
    ours = data is None or isinstance(actor.GetMapper(), vtkCloudTextureMapper)
    return not ours and (not isinstance(data, vtkPolyData) or data.GetNumberOfPolys() + data.GetNumberOfStrips() > 0)


def _surface(mesh: Any) -> pyvista.PolyData:
    mesh = wrapped(mesh, merge_points=False)
    if not isinstance(mesh, pyvista.DataSet):
        raise TypeError(f"mesh is a {type(mesh).__name__}; it must be a surface, or blocks of surfaces.")
    if not isinstance(mesh, pyvista.PolyData):
        mesh = outer_surface(mesh)
    if mesh.GetNumberOfPolys() + mesh.GetNumberOfStrips() == 0:
        if mesh.n_points == 0:
            raise ValueError("mesh is empty: it has no points and no polygons, so there is no surface to draw. If it comes from cloud_surface "
                             "or contour, choose isosurfaces within the range of their array.")
        raise ValueError(f"mesh has {mesh.n_points} points but no polygons: there is no surface to draw. Make one (cloud_surface, contour, "
                         "delaunay_2d, reconstruct_surface), or draw points with add_splats.")
    return mesh


def _point_array(surface: pyvista.PolyData, name: str, argument: str) -> str:
    if name not in surface.point_data:
        raise MissingDataError(f"{argument}: no point array {name!r}. {arrays_of(surface)}")
    return name
