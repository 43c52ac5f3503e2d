# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The light of the sun in clouds (`vtkSunlight`)."""
from __future__ import annotations

import inspect
import warnings
from datetime import datetime
from typing import Any, Callable, Literal, Mapping

import numpy as np
import pyvista

from . import vtkSunlight, vtkSunSource
from ._blocks import cell_dimension
from ._checks import arrays_of, choose, require_number
from ._dates import as_time, options_of
from ._fields import preset_of_field
from ._from_xarray import is_weather, sun_for
from ._medium import default_scalars, one_mesh
from ._pipeline import level_of_caller, set_input, vtk_messages
from ._typing import AnyMesh, Mesh, Numbers
from .optics import cloud_optics, optics_of
from .tone import checked, toned


SMOKE = {"albedo": 0.9, "asymmetry": 0.6}  # as Filters/Sunlight/Clouds/SmokeOptics.cxx


def _names(say: Callable[[str], str]) -> dict[str, str]:
    """Terms in messages of vtkSunlight, and their names in Python."""
    return {"Make one by Cloud Optics": "Make one by cloud_optics", "set ExtinctionArrayName": f"name one by {say('extinction')}", "ExtinctionArrayName": say("extinction"), "ExtinctionScale": say("extinction_scale"),
            "SunDirection": say("direction"), "DateTime": say("time"), "PeriodicSides": say("periodic"), "OpenSides": say("open_sides"), "make an image by Resample To Image": "make an image by pyvista.create_grid(mesh).sample(mesh)", "set Up": f"set {say('up')}"}


_NAMES = _names(str)
BRIGHTEST = 0.6  # light that is drawn as white with an exposure of 1
DARKEST_WHITE, BRIGHTEST_WHITE = 0.15, 1.2  # limits of white with automatic exposure, so that night stays dark
TWILIGHT = 0.25  # sine of the sun's elevation below which surfaces on a globe without lit clouds get less light
PROJECTIONS = ("globe", "map")  # numbered as in the field data GlobeGridProjection
FILMIC_RANGE = 4.0  # at this multiple of it the filmic curve is nearly white


def sunlight(mesh: AnyMesh, direction: Numbers | str | datetime | None = None, *, time: str | datetime = "", place: Numbers | None = None, up: Numbers | str = "z",
             extinction: str = "Extinction", albedo: str | float = "SingleScatteringAlbedo", asymmetry: str | float = "AsymmetryParameter",
             extinction_scale: float = 1.0, ground_albedo: float = 0.1, sky_light: float = 0.08, periodic: bool = False, open_sides: bool = False, multiple_scattering: bool = True,
             zenith_angles: int | None = None, azimuth_angles: int | None = None, eye: Numbers | Literal["camera"] | None = None, parallel: bool = False,
             phase_function: str = "henyey-greenstein", clouds: pyvista.DataSet | None = None) -> Mesh:
    """Add the light of sun and sky to a mesh with an extinction: shadows, dark bases and multiple scattering.

    Also the accessor method ``mesh.nephoscope.sunlight(...)``. `add_cells` with `sun` calls it.

    Parameters
    ----------
    mesh : pyvista.DataSet, pyvista.MultiBlock, xarray.Dataset or xarray.DataArray
        The mesh with the extinction, as from `cloud_optics`; smoke of `flow_volume` or `smoke_puffs`, which needs no such array; or, with `clouds`, a
        surface such as the ground, which gets their shadows. It is not changed. A MultiBlock is combined into one grid, so that its blocks cast shadows on one another.
    direction : sequence of 3 float, str or datetime.datetime, optional
        Direction towards the sun in the coordinates of the mesh, or a date and time, as in `time`. Default: (1, -1, 1).
    time : str or datetime.datetime, optional
        Date and time in UTC, such as ``"2011-10-11 18:30"``, instead of a direction; also a date of NumPy, pandas or cftime. A datetime with a time zone is converted to UTC.
    place : sequence of 2 float, optional
        Longitude and latitude (degrees) for which the sun is computed at `time`, if the mesh is not a globe from `to_globe`; x points east
        and y north there. Default: the middle of a map from `to_globe`, with a warning if it is wider than 30 degrees; otherwise (0, 0), with a warning.
    up : str or sequence of 3 float, default: "z"
        The direction upwards from flat ground: an axis of the mesh, such as ``"y"`` or ``"-z"``, or a vector. On a globe up is away from its centre. The default `direction`, and
        x and y of `place`, are turned with the axis: where y is up, -z points north.
    extinction : str, default: "Extinction"
        Array of the extinction coefficient, 1/length of the mesh.
    albedo, asymmetry : str or float
        Array of the single-scattering albedo and of the asymmetry parameter, or one number for all. Default without these arrays: 1 and 0.85.
    extinction_scale : float, default: 1.0
        Multiplies the extinction.
    ground_albedo : float, default: 0.1
        Fraction of the light that the ground below the mesh reflects, 0 to 1.
    sky_light : float, default: 0.08
        Irradiance from the sky under an overhead sun, as a fraction of the sun's irradiance, 0 to 10.
    periodic : bool, default: False
        The clouds of an image, a rectilinear or a structured grid repeat beyond its sides, as in a model with periodic boundaries. The copies cast shadows into the
        grid and scatter light into it. If the extinction is equal on opposite sides, these sides count as the same points. Otherwise the next copy begins one grid spacing beyond the last
        points. False: no shadows come from beyond the sides, which are mirrors for diffuse light or, with `open_sides`, open.
    open_sides : bool, default: False
        Diffuse light leaves through the sides of the mesh, and only the light of sun and sky enters there: for clouds that are alone in a box that fits tightly. False: the sides are mirrors
        for diffuse light, as if the clouds continued beyond them. Grids that close around, such as globes of all longitudes, have no open sides. `periodic` takes precedence.
    multiple_scattering : bool, default: True
        Includes light that is scattered more than once.
    zenith_angles, azimuth_angles : int, optional
        Number of directions of the diffuse light: zenith angles in each hemisphere (1 to 16), azimuth angles (4 to 64; twice as many at
        zenith angles with larger solid angles). Default: 6 and 8 for grids of up to 20,000 points, 4 and 6 up to 120,000, else 3 and 4.
    eye : sequence of 3 float or "camera", optional
        Position of the eye for which ``Sunlight`` is computed. ``"camera"``: the light of the sun's beam is kept in a separate array, and `add_cells` draws the light
        scattered towards the camera of each frame. Default: the mean over all directions.
    parallel : bool, default: False
        True: `eye` is the direction towards a distant eye.
    phase_function : {"henyey-greenstein", "double-henyey-greenstein", "droplets"}, default: "henyey-greenstein"
        With ``eye="camera"``: the distribution of scattered light over directions. The first has the mean asymmetry parameter of the mesh; the other two are for water
        droplets in green light, with an effective radius of 10 micrometres. ``"droplets"``, from Mie theory, has fogbow and glory.
    clouds : pyvista.DataSet, optional
        Clouds lit by the same sun, which attenuate the direct sunlight on the mesh. Without `direction` and `time` the sun is that of the
        clouds.

    Returns
    -------
    pyvista.DataSet
        The mesh with the point arrays ``Sunlight`` (1: a white surface that faces the sun), ``ScaledExtinction`` (1/length of the mesh), ``SunTransmittance`` (fraction of the sun's beam
        that arrives), ``Irradiance`` and ``UpwardIrradiance`` (of a horizontal surface, from above with the sun and from below; 1: the sun's), and ``AbsorbedLight`` (power that becomes
        heat per volume, in the sun's irradiance/length of the mesh).

    Raises
    ------
    TypeError
        If `mesh` is not a dataset.
    ValueError
        If a number is out of range, `direction` has no length, or `time` is not a valid time.
    RuntimeError
        If there is no extinction.

    Warns
    -----
    RuntimeWarning
        For negative and missing extinctions, if the sun is below the horizon, for a time without a place, for clouds that reach sunlit sides of a tall mesh without `periodic` and `open_sides`,
        if both of these are True, and for an extinction without 3-D cells, as on an image one point thick, which casts no shadows.
    """
    direction, time = as_time(direction), as_time(time)
    if isinstance(direction, str) and not time:
        direction, time = None, direction
    options = dict(locals())
    return light_of(options.pop("mesh"), str, **options)


def is_on_globe(mesh: pyvista.DataSet) -> bool:
    return "GlobeGridProjection" in mesh.field_data and PROJECTIONS[int(mesh.field_data["GlobeGridProjection"][0])] == "globe"


def _middle_of_map(mesh: pyvista.DataSet) -> tuple[float, float]:
    """Longitude and latitude in degrees of the middle of a map of `to_globe`; 0 and 0 of any other mesh."""
    if "GlobeGridProjection" not in mesh.field_data or is_on_globe(mesh):
        return 0.0, 0.0
    metres = np.radians(1) * float(mesh.field_data["PlanetRadius"][0])
    longitude, latitude = mesh.center[0] / metres, mesh.center[1] / metres
    return float((longitude + 180) % 360 - 180), float(np.clip(latitude, -90, 90))


def _warn_of_wide_map(mesh: pyvista.DataSet, say: Callable[[str], str]) -> None:
    longitude, latitude = _middle_of_map(mesh)
    width = np.ptp(mesh.bounds[:2])
    if "GlobeGridProjection" in mesh.field_data and not is_on_globe(mesh) and width > np.radians(30) * float(mesh.field_data["PlanetRadius"][0]):
        warnings.warn(f"A map has one sun: at {say('time')}, it is that of the middle, longitude {longitude:.0f} and latitude {latitude:.0f}. Give {say('place')}, or draw a globe, which "
                      "has day and night.", RuntimeWarning, stacklevel=4)


def light_of(mesh: pyvista.DataSet, say: Callable[[str], str], direction: Numbers | None, time: str, place: Numbers | None, up: Numbers | str, extinction: str,
             albedo: str | float, asymmetry: str | float, extinction_scale: float, ground_albedo: float, sky_light: float, periodic: bool, open_sides: bool, multiple_scattering: bool,
             zenith_angles: int | None, azimuth_angles: int | None, eye: Numbers | Literal["camera"] | None, parallel: bool, phase_function: str, clouds: pyvista.DataSet | None) -> pyvista.DataSet:
    """`sunlight`; messages call its arguments `say(name)`, and begin with the name of the class if that is `str`."""
    _require_sun(direction, time, say)
    mesh = one_mesh(mesh)
    light = vtkSunlight()
    set_input(light, mesh)
    if clouds is not None:
        _require_light(clouds, say("clouds"))
        set_input(light, clouds, 1)
        direction = clouds.field_data["SunDirection"][0] if direction is None and not time and "SunDirection" in clouds.field_data else direction
    axis = upwards(up, say)
    light.SetUp(*axis)
    light.SetSunDirection(*(turned(light.GetSunDirection(), axis) if direction is None else direction))
    light.SetDateTime(str(time))
    if time and place is None and "GlobeGridProjection" not in mesh.field_data:
        warnings.warn(f"{say('time')} is a date and time without a place: the sun is that of longitude 0 and latitude 0. Give {say('place')}, the longitude and latitude; "
                      "x points east and y north.", RuntimeWarning, stacklevel=3)
    if time and place is None:
        _warn_of_wide_map(mesh, say)
    place = _middle_of_map(mesh) if place is None else place
    light.SetLongitude(require_number(place[0], say("place"), least=-360, most=360))
    light.SetLatitude(require_number(place[1], say("place"), least=-90, most=90))
    light.SetExtinctionArrayName(extinction)
    light.SetExtinctionScale(require_number(extinction_scale, say("extinction_scale"), least=0, most=1e29))
    _set_optics(light, albedo, asymmetry, say)
    light.SetGroundAlbedo(require_number(ground_albedo, say("ground_albedo"), least=0, most=1))
    light.SetSkyLight(require_number(sky_light, say("sky_light"), least=0, most=10))
    light.SetPeriodicSides(bool(periodic))
    light.SetOpenSides(bool(open_sides))
    light.SetMultipleScattering(bool(multiple_scattering))
    light.SetZenithAngles(0 if zenith_angles is None else int(require_number(zenith_angles, say("zenith_angles"), least=1, most=16)))
    light.SetAzimuthAngles(0 if azimuth_angles is None else int(require_number(azimuth_angles, say("azimuth_angles"), least=4, most=64)))
    choose({"henyey-greenstein": light.SetPhaseFunctionToHenyeyGreenstein, "double-henyey-greenstein": light.SetPhaseFunctionToDoubleHenyeyGreenstein,
            "droplets": light.SetPhaseFunctionToCloudDroplets}, phase_function, say("phase_function"))
    if isinstance(eye, str):
        choose({"camera": light.FollowCameraOn}, eye, say("eye"))
    elif eye is not None:
        light.SetUseViewPosition(True)
        light.SetViewPosition(*_three(eye, say("eye")))
    if phase_function != "henyey-greenstein" and eye != "camera":
        warnings.warn(f"{say('phase_function')} is {phase_function!r}, which needs {say('eye')}='camera'; the light has the phase function of Henyey and Greenstein.", UserWarning,
                      stacklevel=level_of_caller())
    light.SetParallelView(bool(parallel))
    with vtk_messages(light, _names(say), by_class=say is str):
        light.Update()
    return pyvista.wrap(light.GetOutput())


def upwards(up: Numbers | str, say: Callable[[str], str]) -> np.ndarray:
    """The unit vector of an axis such as "-y", or of a vector."""
    axes = {sign + name: factor * np.eye(3)[axis] for sign, factor in (("", 1), ("+", 1), ("-", -1)) for axis, name in enumerate("xyz")}
    if isinstance(up, str):
        if up not in axes:
            raise ValueError(f"{say('up')} is {up!r}; it must be an axis, such as 'y' or '-z', or a vector.")
        return axes[up]
    vector = np.array(_three(up, say("up")))
    if not vector.any():
        raise ValueError(f"{say('up')} is {up!r}; it must be longer than 0.")
    return vector / np.linalg.norm(vector)


def turned(vector: Numbers, up: np.ndarray) -> np.ndarray:
    """A vector turned as z is, the shortest way to `up`."""
    if up[2] <= -1:
        return np.array(vector) * (1, -1, -1)
    axis = np.cross((0, 0, 1), up)
    return up[2] * np.array(vector) + np.cross(axis, vector) + np.dot(axis, vector) / (1 + up[2]) * axis


def _require_light(clouds: Any, argument: str) -> None:
    if not isinstance(clouds, pyvista.DataSet) or "SunTransmittance" not in clouds.point_data:
        raise ValueError(f"{argument} is a {type(clouds).__name__} without the array 'SunTransmittance'; it must be a result of sunlight().")


def _require_sun(direction: Numbers | None, time: str, say: Callable[[str], str]) -> None:
    """Raises ValueError if these are no direction and no date and time."""
    if direction is not None and not any(_three(direction, say("direction"))):
        raise ValueError(f"{say('direction')} is {direction!r}; it must be the direction towards the sun, such as (1, 0, 1), longer than 0.")
    if time and not _is_date(time):
        other = ", or the direction towards the sun, such as (1, 0, 1)" if say("time") == say("direction") else ""
        raise ValueError(f"{say('time')} is {time!r}; it must be a date and time in UTC, such as '2011-10-11 18:30'{other}.")


def _is_date(time: Any) -> bool:
    sun = vtkSunSource()
    sun.SetDateTime(str(time))
    try:
        with vtk_messages(sun):
            sun.Update()
    except RuntimeError:
        return False
    return True


def _three(values: Numbers, argument: str) -> list[float]:
    if np.shape(values) != (3,):
        raise ValueError(f"{argument} is {values!r}; it must be three numbers.")
    return [require_number(value, argument) for value in values]


def _set_optics(light: vtkSunlight, albedo: str | float, asymmetry: str | float, say: Callable[[str], str]) -> None:
    if isinstance(albedo, str):
        light.SetAlbedoArrayName(albedo)
    else:
        light.SetAlbedoArrayName("")
        light.SetAlbedo(require_number(albedo, say("albedo"), least=0, most=1))
    if isinstance(asymmetry, str):
        light.SetAsymmetryArrayName(asymmetry)
    else:
        light.SetAsymmetryArrayName("")
        light.SetAsymmetry(require_number(asymmetry, say("asymmetry"), least=-0.99, most=0.99))


def lit(mesh: pyvista.DataSet, sun: Any, needs_cells: bool = True, resolve: Callable[[pyvista.DataSet, list[str]], pyvista.DataSet] | None = None,
        **defaults: Any) -> pyvista.DataSet:
    """`mesh` with light, computed from a direction, a date and time, or the arguments of `sunlight` and `cloud_optics`; unchanged if it has light and `sun` is True.

    `resolve` returns the mesh to light, from one with optics and the names of their arrays. `defaults` are those of `sunlight` that are others for this mesh.
    """
    if sun is True and {"Sunlight", "ScaledExtinction"} <= set(mesh.point_data):
        return mesh
    if needs_cells and cell_dimension(mesh) < 3:
        raise ValueError(f"sun: light cannot be computed on a {type(mesh).__name__} without 3-D cells. Compute it on a grid, mesh.nephoscope.sunlight(), "
                         "sample it at the points, and pass sun=True.")
    given = options_of(sun)
    of_water, of_light = ({name: given.pop(name, value) for name, value in defaults.items()} for defaults in (_defaults(cloud_optics), {**_defaults(sunlight), **defaults}))
    if given:
        raise ValueError(f"sun has no option {next(iter(given))!r}; it has {', '.join(repr(name) for name in [*of_light, *of_water])}.")
    say = _option if isinstance(sun, Mapping) else lambda name: "sun" if name in ("direction", "time") else _option(name)
    _require_sun(of_light["direction"], of_light["time"], say)
    own = sun if isinstance(sun, Mapping) else ()
    if any(name in own for name in of_water) or of_light["extinction"] == "Extinction" and not _has(mesh, "Extinction") and not is_smoke(mesh):
        mesh = _with_optics(mesh, of_water, of_light["direction"], of_light["time"])
    if resolve is not None:
        mesh = resolve(mesh, [of_light[name] for name in ("extinction", "albedo", "asymmetry") if isinstance(of_light[name], str)])
    return light_of(mesh, say, **of_light)


def _with_optics(mesh: pyvista.DataSet, of_water: dict[str, Any], direction: Numbers | None, time: str) -> pyvista.DataSet:
    """The mesh with the extinction of its water. Without water the message says how another array is named."""
    try:
        return optics_of(mesh, _option, **of_water)
    except RuntimeError as problem:
        if "There is no array of cloud water" not in str(problem):
            other = " Or name an array of the extinction coefficient, per unit of length of the mesh, by sun['extinction']." if "which is needed" in str(problem) else ""
            raise RuntimeError(f"{problem}{other}") from None
        raise RuntimeError(f"sun needs an extinction, and the mesh has neither an array 'Extinction' nor cloud water. {_other_extinction(mesh, direction, time)} "
                           "Or name the cloud water by sun['water'], or by sun['liquid'] and sun['ice'], with sun['temperature'] and sun['pressure']. "
                           f"{arrays_of(mesh)}") from None


def _other_extinction(mesh: pyvista.DataSet, direction: Numbers | None, time: str) -> str:
    """How the first array of numbers, or the active one, is taken for the extinction."""
    numbers = [name for data in (mesh.point_data, mesh.cell_data) for name in data.keys() if data[name].ndim == 1 and np.issubdtype(data[name].dtype, np.number)]
    if not numbers:
        return "Give it one: mesh['Extinction'] = ..., per unit of length of the mesh."
    sun: dict[str, Any] = {"direction": tuple(float(f"{part:.4g}") for part in np.asarray(direction))} if direction is not None else {"time": time} if time else {}
    name = sun["extinction"] = mesh.active_scalars_name if mesh.active_scalars_name in numbers else numbers[0]
    preset = preset_of_field(name, mesh)
    if preset is not None and preset.name == "clouds":  # a fraction, or percent
        sun["extinction_scale"] = 0.01 if np.nanmax(mesh[name], initial=0) <= 1.5 else 0.0001
        return f"If the cloud fraction is all that you have, pass it as extinction coefficient, 0.01 per metre where the sky is overcast: sun={sun}."
    return f"Name the array that is the extinction coefficient, per unit of length of the mesh: sun={sun}; sun['extinction_scale'] multiplies it. Clouds of water have 0.01 to 0.1 per metre."


def is_smoke(mesh: pyvista.DataSet) -> bool:
    return {"Density", "EmissionStep"} <= set(mesh.cell_data)


def _option(name: str) -> str:
    return f"sun[{name!r}]"


def _has(mesh: pyvista.DataSet, name: str) -> bool:
    return name in mesh.point_data or name in mesh.cell_data


def _defaults(function: Callable[..., Any]) -> dict[str, Any]:
    return {name: parameter.default for name, parameter in inspect.signature(function).parameters.items() if name != "mesh"}


def refuse_color(color: Any) -> None:
    """For a medium with `sun`."""
    if color is not None:
        raise ValueError("color and sun are both given, but sun determines the colours. Pass cmap for other colours.")


def lit_medium(plotter: pyvista.BasePlotter, data: Any, mesh: pyvista.DataSet, sun: Any, cmap: Any, clim: Any, n_colors: int, exposure: float | None,
               tone_mapping: str) -> dict[str, Any]:
    """The lit mesh that `add_cells` and `add_splats` draw with `sun`, and the arguments for drawing it. The plotter gets the sun. `data`: what the mesh was made from."""
    field = default_scalars(mesh)[1] if is_weather(data) else None
    mesh = lit(mesh, sun_for(data, mesh, sun))
    if field is not None:
        mesh.set_active_scalars(field)  # what the camera looks at
    add_sun(plotter, recorded_sun(mesh))
    densest = float(np.max(mesh["ScaledExtinction"], initial=0)) or 1.0
    return {"mesh": mesh, "scalars": "Sunlight", "opacity_scalars": "ScaledExtinction", "opacity": "linear", "opacity_clim": (0.0, densest),
            "opacity_unit_distance": 1 / densest, "cmap": lit_colours(n_colors, tone_mapping) if cmap is None else cmap,
            "clim": (0.0, brightest(mesh, exposure, tone_mapping)) if clim is None else clim}


def direction_of(sun: Any, fields: Any, center: Numbers = (0.0, 0.0, 0.0)) -> np.ndarray:
    """Towards the sun, given as in `add_cells`, where the field data and the centre are those of a mesh."""
    if sun is True:
        if "SunDirection" not in fields:
            raise ValueError("sun is True, but no mesh with light from sunlight() is given or in the scene: pass it as mesh, or a direction or a date as sun.")
        return fields["SunDirection"][0]
    place = pyvista.PolyData([tuple(map(float, center))])
    for name in ("GlobeGridProjection", "PlanetRadius"):
        if name in fields:
            place.field_data[name] = fields[name]
    place["NoExtinction"] = np.zeros(1)
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", ".*The sun is below the horizon", RuntimeWarning)  # haze is dark then
        return lit(place, sun, needs_cells=False, extinction="NoExtinction", multiple_scattering=False).field_data["SunDirection"][0]


def recorded_sun(mesh: pyvista.DataSet) -> np.ndarray | None:
    """The direction towards the sun that `sunlight` has recorded."""
    return mesh.field_data["SunDirection"][0] if "SunDirection" in mesh.field_data else None


def add_sun(plotter: pyvista.BasePlotter, direction: Numbers | None) -> None:
    """Lets a light from the sun replace the lights of the active renderer, unless it has scene lights. None: the sun is unknown."""
    if direction is not None and not any(light.is_scene_light for light in plotter.renderer.lights):
        plotter.renderer.remove_all_lights()  # the plotter's own methods change those of all subplots
        plotter.renderer.add_light(pyvista.Light(position=direction, focal_point=(0, 0, 0), light_type="scene light"))


def lit_surface(surface: pyvista.PolyData, sun: Any) -> tuple[pyvista.PolyData, np.ndarray]:
    """`surface` with an array ``Sunlight``, and the direction towards the sun.

    The array is that of the lit data which the surface was made of, if the sun is there; otherwise sunlight that meets no clouds, or those of
    ``sun={'clouds': ...}``, and the night of a globe.
    """
    carried = recorded_sun(surface) if "Sunlight" in surface.point_data else None
    if carried is not None and sun is True:
        return surface, carried
    clear = surface.copy(deep=False)
    clear.clear_data()
    clear.GetFieldData().PassData(surface.GetFieldData())  # PyVista does not take strings that are not ASCII
    clear["NoExtinction"] = np.zeros(surface.n_points)
    clear = lit(clear, sun, needs_cells=False, extinction="NoExtinction", multiple_scattering=False)
    direction = clear.field_data["SunDirection"][0]
    if carried is None or np.dot(carried, direction) < 0.9998:
        surface = surface.copy(deep=False)
        on_globe = "GlobeGridProjection" in surface.field_data and int(surface.field_data["GlobeGridProjection"][0]) == 0
        dusk = np.minimum(clear["Irradiance"] / TWILIGHT, 1) if on_globe else clear["SunTransmittance"]
        surface["Sunlight"] = BRIGHTEST * dusk
        if "ScaledExtinction" in surface.point_data:
            del surface.point_data["ScaledExtinction"]  # of other light
    return surface, direction


def lit_colours(count: int = 256, tone_mapping: str = "contrast", tint: Numbers = (1.0, 1.0, 1.0)) -> list[str]:
    """From night over blue shadows to warm white: the colours of light from 0 to `brightest(tone_mapping)`, as a display shows them; `tint` multiplies."""
    light = np.linspace(0, 1, count)[:, None]
    tone = light ** (1 / 2.2) if checked(tone_mapping) == "linear" else toned(light * (FILMIC_RANGE if tone_mapping == "filmic" else 1), 1.0, tone_mapping)
    colours = tint * tone * (np.array([1.0, 0.985, 0.955]) + (1 - tone) * np.array([-0.10, -0.03, 0.10]))
    return ["#%02x%02x%02x" % tuple(colour) for colour in np.rint(255 * np.clip(colours, 0, 1)).astype(int)]


def brightest(mesh: pyvista.DataSet | None = None, exposure: float | None = None, tone_mapping: str = "contrast") -> float:
    """The light that the last colour, white, represents: 0.6 / exposure if an exposure is given, otherwise `automatic_white`."""
    white = automatic_white(mesh) if exposure is None else BRIGHTEST / require_number(exposure, "exposure", above=0)
    return white * (FILMIC_RANGE if checked(tone_mapping) == "filmic" else 1)


def automatic_white(mesh: pyvista.DataSet | None) -> float:
    """1.1 times the light that 2 % of the points in clouds exceed: the field array `WhiteLight`, or computed from the points of data without it.

    A point is in a cloud if its extinction is above a fiftieth of the maximum. Light that depends on the direction of view counts as cameras with the sun
    behind them see it.
    """
    if mesh is not None and "WhiteLight" in mesh.field_data:
        return float(np.max(mesh.field_data["WhiteLight"]))
    if mesh is None or not {"Sunlight", "ScaledExtinction"} <= set(mesh.point_data):
        return BRIGHTEST
    light, extinction = mesh.point_data["Sunlight"], mesh.point_data["ScaledExtinction"]
    seen = light[extinction > 0.02 * np.max(extinction, initial=0)]
    return float(np.clip(1.1 * np.percentile(seen, 98), DARKEST_WHITE, BRIGHTEST_WHITE)) if len(seen) else BRIGHTEST
