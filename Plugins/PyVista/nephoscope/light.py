# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The light of the sun in clouds (`vtkSunlight`)."""
from __future__ import annotations

import inspect
from typing import Any, Callable, Mapping, Sequence

import numpy as np
import pyvista
from vtkmodules.vtkCommonDataModel import vtkDataSet

from . import vtkSunlight
from ._checks import require_number
from ._pipeline import vtk_messages
from .optics import cloud_optics, optics_of
from .tone import checked, toned


def _names(say: Callable[[str], str]) -> dict[str, str]:
    """What the messages of vtkSunlight say, and what it is called here."""
    return {"Make one by Cloud Optics": "Make one by cloud_optics", "set ExtinctionArrayName": f"name one by {say('extinction')}", "ExtinctionArrayName": say("extinction"),
            "SunDirection": say("direction"), "DateTime": say("time")}


_NAMES = _names(str)
BRIGHTEST = 0.6  # light that is drawn white at an exposure of 1
DARKEST_WHITE, BRIGHTEST_WHITE = 0.15, 1.2  # and the limits of that of automatic exposure: night stays dark
FILMIC_RANGE = 4.0  # times that, and the filmic curve is nearly white


def sunlight(mesh: pyvista.DataSet, direction: Sequence[float] | None = None, *, time: str = "", place: Sequence[float] = (0.0, 0.0),
             extinction: str = "Extinction", albedo: str | float = "SingleScatteringAlbedo", asymmetry: str | float = "AsymmetryParameter",
             extinction_scale: float = 1.0, ground_albedo: float = 0.1, sky_light: float = 0.08, multiple_scattering: bool = True,
             zenith_angles: int = 3, azimuth_angles: int = 4, eye: Sequence[float] | None = None, parallel: bool = False) -> pyvista.DataSet:
    """Add the light of sun and sky to a mesh with an extinction: shadows, dark bases and light that is scattered several times.

    Also the accessor method ``mesh.nephoscope.sunlight(...)``. `add_cells` with `sun` calls it.

    Parameters
    ----------
    mesh : pyvista.DataSet
        The mesh with the extinction, as `cloud_optics` makes it; it is not changed.
    direction : sequence of 3 float, optional
        Direction towards the sun in the coordinates of the mesh. Default: (1, -1, 1).
    time : str, optional
        Date and time in UTC, such as ``"2011-10-11 18:30"``, instead of a direction.
    place : sequence of 2 float, default: (0, 0)
        Degrees east and north from where the sun is seen at `time`, if the mesh is not a globe of `to_globe`.
    extinction : str, default: "Extinction"
        Array of the extinction coefficient, 1/length of the mesh.
    albedo, asymmetry : str or float
        Array of the single-scattering albedo and of the asymmetry parameter, or one number for all. Without the arrays 1 and 0.85.
    extinction_scale : float, default: 1.0
        Multiplies the extinction.
    ground_albedo : float, default: 0.1
        Share of the light that the ground below the mesh reflects, 0 to 1.
    sky_light : float, default: 0.08
        Irradiance from the sky under an overhead sun, as a share of that of the sun, 0 to 10.
    multiple_scattering : bool, default: True
        Light that is scattered more than once.
    zenith_angles, azimuth_angles : int
        Directions of diffuse light: zenith angles in each hemisphere (1 to 16), azimuth angles (4 to 64).
    eye : sequence of 3 float, optional
        Position of the eye for which ``Sunlight`` is computed. Default: the mean over all directions.
    parallel : bool, default: False
        `eye` is the direction towards an eye far away.

    Returns
    -------
    pyvista.DataSet
        The mesh with the point arrays ``Sunlight`` (1: a white surface that faces the sun), ``ScaledExtinction``, ``SunTransmittance`` and ``Irradiance``.

    Raises
    ------
    TypeError
        If `mesh` is not a dataset.
    ValueError
        If a number is out of range.
    RuntimeError
        If there is no extinction, or the time is none.

    Warns
    -----
    RuntimeWarning
        For negative and missing extinctions, and if the sun is below the horizon.
    """
    options = dict(locals())
    return light_of(options.pop("mesh"), str, **options)


def light_of(mesh: pyvista.DataSet, say: Callable[[str], str], direction: Sequence[float] | None, time: str, place: Sequence[float], extinction: str,
             albedo: str | float, asymmetry: str | float, extinction_scale: float, ground_albedo: float, sky_light: float, multiple_scattering: bool,
             zenith_angles: int, azimuth_angles: int, eye: Sequence[float] | None, parallel: bool) -> pyvista.DataSet:
    """`sunlight`, with arguments that messages call `say(name)`."""
    if not isinstance(mesh, vtkDataSet):
        raise TypeError(f"mesh is a {type(mesh).__name__}; it must be a pyvista dataset.")
    light = vtkSunlight()
    light.SetInputDataObject(mesh)
    if direction is not None:
        light.SetSunDirection(*_three(direction, say("direction")))
    light.SetDateTime(time)
    light.SetLongitude(require_number(place[0], say("place"), least=-360, most=360))
    light.SetLatitude(require_number(place[1], say("place"), least=-90, most=90))
    light.SetExtinctionArrayName(extinction)
    light.SetExtinctionScale(require_number(extinction_scale, say("extinction_scale"), least=0, most=1e29))
    _set_optics(light, albedo, asymmetry, say)
    light.SetGroundAlbedo(require_number(ground_albedo, say("ground_albedo"), least=0, most=1))
    light.SetSkyLight(require_number(sky_light, say("sky_light"), least=0, most=10))
    light.SetMultipleScattering(bool(multiple_scattering))
    light.SetZenithAngles(int(require_number(zenith_angles, say("zenith_angles"), least=1, most=16)))
    light.SetAzimuthAngles(int(require_number(azimuth_angles, say("azimuth_angles"), least=4, most=64)))
    if eye is not None:
        light.SetUseViewPosition(True)
        light.SetViewPosition(*_three(eye, say("eye")))
    light.SetParallelView(bool(parallel))
    with vtk_messages(light, _names(say)):
        light.Update()
    return pyvista.wrap(light.GetOutput())


def _three(values: Sequence[float], argument: str) -> list[float]:
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


def lit(mesh: pyvista.DataSet, sun: Any) -> pyvista.DataSet:
    """`mesh` with light: by a direction, a date and time, or the arguments of `sunlight` and `cloud_optics`; as it is if it has light and `sun` is True."""
    if sun is True and {"Sunlight", "ScaledExtinction"} <= set(mesh.point_data):
        return mesh
    given = dict(sun) if isinstance(sun, Mapping) else {"time": sun} if isinstance(sun, str) else {} if sun is True else {"direction": sun}
    of_water, of_light = ({name: given.pop(name, value) for name, value in defaults.items()} for defaults in (_defaults(cloud_optics), _defaults(sunlight)))
    if given:
        raise ValueError(f"sun has no option {next(iter(given))!r}; it has {', '.join(repr(name) for name in [*of_light, *of_water])}.")
    own = sun if isinstance(sun, Mapping) else ()
    if any(name in own for name in of_water) or of_light["extinction"] == "Extinction" and not _has(mesh, "Extinction"):
        mesh = optics_of(mesh, _option, **of_water)
    return light_of(mesh, _option if isinstance(sun, Mapping) else lambda name: "sun" if name in ("direction", "time") else _option(name), **of_light)


def _option(name: str) -> str:
    return f"sun[{name!r}]"


def _has(mesh: pyvista.DataSet, name: str) -> bool:
    return name in mesh.point_data or name in mesh.cell_data


def _defaults(function: Callable[..., Any]) -> dict[str, Any]:
    return {name: parameter.default for name, parameter in inspect.signature(function).parameters.items() if name != "mesh"}


def lit_colours(count: int = 256, tone_mapping: str = "contrast") -> list[str]:
    """From night over blue shadows to warm white: the colours of light from 0 to `brightest(tone_mapping)`, as a display shows them."""
    light = np.linspace(0, 1, count)[:, None]
    tone = light ** (1 / 2.2) if checked(tone_mapping) == "linear" else toned(light * (FILMIC_RANGE if tone_mapping == "filmic" else 1), 1.0, tone_mapping)
    colours = tone * (np.array([1.0, 0.985, 0.955]) + (1 - tone) * np.array([-0.10, -0.03, 0.10]))
    return ["#%02x%02x%02x" % tuple(colour) for colour in np.rint(255 * np.clip(colours, 0, 1)).astype(int)]


def brightest(mesh: pyvista.DataSet | None = None, exposure: float | None = None, tone_mapping: str = "contrast") -> float:
    """The light that the last colour is for: white. With an exposure 0.6 / exposure; otherwise `automatic_white`."""
    white = automatic_white(mesh) if exposure is None else BRIGHTEST / require_number(exposure, "exposure", above=0)
    return white * (FILMIC_RANGE if checked(tone_mapping) == "filmic" else 1)


def automatic_white(mesh: pyvista.DataSet | None) -> float:
    """A tenth more than the light that 2 % of the points in clouds exceed: those with more than a fiftieth of the greatest extinction."""
    if mesh is None or not {"Sunlight", "ScaledExtinction"} <= set(mesh.point_data):
        return BRIGHTEST
    light, extinction = mesh.point_data["Sunlight"], mesh.point_data["ScaledExtinction"]
    seen = light[extinction > 0.02 * np.max(extinction, initial=0)]
    return float(np.clip(1.1 * np.percentile(seen, 98), DARKEST_WHITE, BRIGHTEST_WHITE)) if len(seen) else BRIGHTEST
