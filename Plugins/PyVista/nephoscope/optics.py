# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Extinction of clouds from the water of a weather model (`vtkCloudOptics`)."""
from __future__ import annotations

import re
from typing import Any, Callable, Literal

import pyvista

from . import vtkCloudOptics
from ._checks import arrays_of, choose, require_number
from ._cloud_water import optics_of_fraction
from ._fields import FLAT_GRID
from ._medium import one_mesh
from ._pipeline import set_input, vtk_messages
from ._typing import AnyMesh, Mesh
from .weather.flat_air import FlatAir


def _names(say: Callable[[str], str]) -> dict[str, str]:
    """Terms in messages of vtkCloudOptics, and their names in Python."""
    words = {"TotalWater": "water", "Liquid": "liquid", "Ice": "ice", "Rain": "rain", "Snow": "snow", "Temperature": "temperature", "Pressure": "pressure",
             "CloudFraction": "cloud_fraction", "Land": "land", "Height": "height"}
    return {**{f"{vtk}ArrayName": say(name) for vtk, name in words.items()}, "WaterUnits": say("units"),
            "set TotalWaterArrayName, or LiquidArrayName and IceArrayName": f"name one by {say('water')}, or two by {say('liquid')} and {say('ice')}",
            "put the fields through Globe Grid": "put the fields through to_globe", "which Globe Grid adds to its output": "which to_globe adds to its output"}


_NAMES = _names(str)
UNITS = {"automatic": "AUTOMATIC", "kg/kg": "MIXING_RATIO", "g/kg": "MIXING_RATIO_GRAMS", "kg/m3": "CONTENT", "g/m3": "CONTENT_GRAMS"}


def cloud_optics(mesh: AnyMesh, water: str = "", *, liquid: str = "", ice: str = "", rain: str = "", snow: str = "",
                 temperature: str = "", pressure: str = "", cloud_fraction: str = "", land: str = "", height: str = "",
                 units: Literal["automatic", "kg/kg", "g/kg", "kg/m3", "g/m3"] = "automatic",
                 liquid_radius: float | None = None, ice_radius: float | None = None,
                 droplets_over_land: float = 300.0, droplets_over_sea: float = 100.0) -> Mesh:
    """Add extinction and the other optical properties of clouds in visible light, from the water of a weather model.

    Also the accessor method ``mesh.nephoscope.cloud_optics(...)``. Arrays that you do not name are found by the names that models use; ``"none"``
    leaves one out.

    Parameters
    ----------
    mesh : pyvista.DataSet, pyvista.MultiBlock, xarray.Dataset or xarray.DataArray
        The dataset with the water, on points or cells; it is not changed. A MultiBlock is combined into one grid.
    water : str, optional
        Cloud water, the sum of liquid and ice; the temperature determines how much of it is ice.
    liquid, ice, rain, snow : str, optional
        Cloud liquid, cloud ice, rain and snow.
    temperature, pressure, cloud_fraction, land, height : str, optional
        Temperature (K, or °C if its units say so), pressure (Pa or hPa), cloud fraction and land fraction (0 to 1), height (m). Without a pressure array,
        the pressure is in hydrostatic balance with the heights of a structured grid; for other meshes it is that of the standard
        atmosphere. In a mesh of ``dataset.nephoscope.grid()``, potential temperature and density are used too, z is the height, and the standard atmosphere
        gives missing values, with a warning. If there is a cloud fraction but no water, clouds get the usual water at their height, with a warning.
    units : {"automatic", "kg/kg", "g/kg", "kg/m3", "g/m3"}, default: "automatic"
        Units of the water. Automatic: those in the file, otherwise kg/kg.
    liquid_radius, ice_radius : float, optional
        Uniform effective radius of droplets and of crystals, in micrometres. Default: computed from the water, the number of droplets and the temperature.
    droplets_over_land, droplets_over_sea : float
        Number of droplets per cm3.

    Returns
    -------
    pyvista.DataSet
        The mesh with ``Extinction`` (1/m of the lengths of the mesh, so that exaggerated heights keep the vertical optical depth),
        ``SingleScatteringAlbedo``, ``AsymmetryParameter``, ``LiquidEffectiveRadius``, ``IceEffectiveRadius`` (micrometres) and, on points of
        structured grids, ``OpticalDepthAbove`` and ``ColumnOpticalDepth``.

    Raises
    ------
    TypeError
        If `mesh` is not a dataset.
    ValueError
        If a number or a choice is out of range.
    RuntimeError
        If an array is missing, or has values that cannot be water in these units.

    Warns
    -----
    RuntimeWarning
        If water has negative or missing values.
    UserWarning
        If the standard atmosphere gives the temperature or the pressure, or the cloud fraction the water.
    """
    options = dict(locals())
    return optics_of(options.pop("mesh"), str, **options)


def optics_of(mesh: pyvista.DataSet, say: Callable[[str], str], **options: Any) -> pyvista.DataSet:
    """`cloud_optics`; messages call its arguments `say(name)`, and begin with the name of the class if that is `str`."""
    mesh = one_mesh(mesh)
    try:
        return _optics(mesh, say, **options)
    except RuntimeError as problem:
        if "There is no array of cloud water" not in str(problem):
            raise
        found = optics_of_fraction(mesh, options, lambda other, **given: _optics(other, say, **given))
        if found is None:
            raise
        return found


def _optics(mesh: pyvista.DataSet, say: Callable[[str], str], **options: Any) -> pyvista.DataSet:
    if FLAT_GRID not in mesh.field_data or options["height"]:
        return _filtered(mesh, say, **options)
    air = FlatAir(mesh)
    try:
        return _with_air(air, False, say, options)
    except RuntimeError as problem:
        missing = str(problem)
        if "There is no temperature" not in missing and "There is no pressure" not in missing:
            raise
    result = _with_air(air, True, say, options)
    air.warn(missing)
    return result


def _with_air(air: FlatAir, complete: bool, say: Callable[[str], str], options: dict) -> pyvista.DataSet:
    """The optics with arrays of the air besides those that the user has named."""
    left_out = {name for name in ("temperature", "pressure") if options[name] == "none"}
    used = {name: values for name, values in air.arrays(complete, left_out).items() if not options[name] or complete and name in left_out}
    mesh = air.mesh.copy(deep=False)
    for name, values in used.items():
        air.data_of(mesh)[f"{FLAT_GRID}_{name}"] = values
    names = {**{name: "none" for name in air.deviations() if not options[name]}, **{name: f"{FLAT_GRID}_{name}" for name in used}}
    try:
        result = _filtered(mesh, say, **{**options, **names})
    except RuntimeError as problem:
        raise RuntimeError(re.sub(rf", '{FLAT_GRID}_\w+'", "", str(problem))) from None
    for name in used:
        del air.data_of(result)[f"{FLAT_GRID}_{name}"]
    return result


def _filtered(mesh: pyvista.DataSet, say: Callable[[str], str], water: str, liquid: str, ice: str, rain: str, snow: str, temperature: str, pressure: str,
              cloud_fraction: str, land: str, height: str, units: str, liquid_radius: float | None, ice_radius: float | None,
              droplets_over_land: float, droplets_over_sea: float) -> pyvista.DataSet:
    optics = vtkCloudOptics()
    set_input(optics, mesh)
    arrays = {"water": (optics.SetTotalWaterArrayName, water), "liquid": (optics.SetLiquidArrayName, liquid), "ice": (optics.SetIceArrayName, ice),
              "rain": (optics.SetRainArrayName, rain), "snow": (optics.SetSnowArrayName, snow), "temperature": (optics.SetTemperatureArrayName, temperature),
              "pressure": (optics.SetPressureArrayName, pressure), "cloud_fraction": (optics.SetCloudFractionArrayName, cloud_fraction),
              "land": (optics.SetLandArrayName, land), "height": (optics.SetHeightArrayName, height)}
    for argument, (set_name, name) in arrays.items():
        if not isinstance(name, str):
            raise TypeError(f"{say(argument)} is {name!r}; it must be the name of an array. {arrays_of(mesh)}")
        set_name(name)
    choose({name: lambda value=value: optics.SetWaterUnits(getattr(vtkCloudOptics, value)) for name, value in UNITS.items()}, units, say("units"))
    if liquid_radius is not None:
        optics.SetLiquidRadiusType(optics.CONSTANT)
        optics.SetLiquidRadius(require_number(liquid_radius, say("liquid_radius"), least=1, most=1e4))
    if ice_radius is not None:
        optics.SetIceRadiusType(optics.CONSTANT)
        optics.SetIceRadius(require_number(ice_radius, say("ice_radius"), least=1, most=1e4))
    optics.SetDropletsOverLand(require_number(droplets_over_land, say("droplets_over_land"), least=1, most=1e5))
    optics.SetDropletsOverSea(require_number(droplets_over_sea, say("droplets_over_sea"), least=1, most=1e5))
    with vtk_messages(optics, _names(say), by_class=say is str):
        optics.Update()
    return pyvista.wrap(optics.GetOutput())
