# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The air of a flat grid: its variables of temperature, pressure and density, also profiles along z, and the standard atmosphere where they are missing."""
from __future__ import annotations

import re
import warnings

import numpy as np
import pyvista
from vtkmodules.vtkCommonCore import vtkStringArray

from .._fields import FLAT_GRID
from .._pipeline import level_of_caller
from .columns import GAS_CONSTANT, KAPPA, standard_air
from .roles import ROLES, Role, candidates, quantity_of
from .units import UnitsError, converted, plain

AIR = {**{name: ROLES[name] for name in ("temperature", "potential_temperature", "pressure")},
       "density": Role("density", "density of the air", ("density",), ("air_density",), (), ("rho", "density", "dens", "air_density", "rhobar", "rhobf", "rhof"))}
_BASE_STATE = re.compile(r"_?(0|ref|bar|base|mean|avg|init)$")  # endings of names: p0, theta_ref, rhobar
_DENSITIES = ("", "kgm-3", "kg/m3")


def air_roles(variables) -> dict[str, str]:
    """Role -> name of the variable among these pairs of names and variables."""
    pairs = list(variables)
    found = {}
    for key, role in AIR.items():
        for names in ({name: name for name, _ in pairs}, {_BASE_STATE.sub("", name.lower()): name for name, _ in pairs}):
            known = dict(pairs)
            fitting = [names[its] for its in candidates(role, [(its, known[name]) for its, name in names.items()]) if _fits(key, role, known[names[its]])]
            if fitting and key not in found:
                found[key] = fitting[0]
    return found


def _fits(key: str, role: Role, variable) -> bool:
    return plain(variable.attrs.get("units")) in _DENSITIES if key == "density" else quantity_of(role, variable) is not None


def mark_air(mesh: pyvista.DataSet, *found: dict[str, str]) -> None:
    """Notes in the field data which arrays are the air, those of the first `found` first."""
    for role in AIR:
        names = [roles[role] for roles in found if roles.get(role) in mesh.point_data]
        if names:
            _add_strings(mesh, _key(role), names)


def _add_strings(mesh: pyvista.DataSet, name: str, texts: list[str]) -> None:
    """As ``mesh.field_data[name] = texts``, also with letters that are not ASCII, which PyVista rejects."""
    array = vtkStringArray()
    array.SetName(name)
    for text in texts:
        array.InsertNextValue(text)
    mesh.GetFieldData().AddArray(array)


def _key(role: str) -> str:
    return FLAT_GRID + "".join(word.capitalize() for word in role.split("_"))


class FlatAir:
    """Temperature in K and pressure in Pa at the points of a mesh of ``dataset.nephoscope.grid()``, as `cloud_optics` needs them."""

    def __init__(self, mesh: pyvista.DataSet) -> None:
        self.mesh, self.on_cells = mesh, not mesh.point_data.keys() and bool(mesh.cell_data.keys())
        self.data = self.data_of(mesh)
        scale = float(mesh.field_data["VerticalExaggeration"][0]) if "VerticalExaggeration" in mesh.field_data else 1.0
        self.heights = np.asarray((mesh.cell_centers() if self.on_cells else mesh).points[:, 2], float) / scale
        self.standard_pressure, self.standard_temperature = standard_air(self.heights)

    def data_of(self, mesh: pyvista.DataSet) -> pyvista.DataSetAttributes:
        return mesh.cell_data if self.on_cells else mesh.point_data

    def deviations(self) -> list[str]:
        """The quantities of which the mesh has nothing but deviations from a base state, or other values that cannot be theirs."""
        return [role for role in ("temperature", "pressure") if _key(role) in self.mesh.field_data and self._role(role) is None]

    def arrays(self, complete: bool, left_out: set[str]) -> dict[str, np.ndarray]:
        """The temperature, and the pressure or, for the balance with the temperature, the height; with the standard atmosphere only if `complete`."""
        density, theta = self._role("density"), self._role("potential_temperature")
        pressure, temperature = (None if role in left_out else self._role(role) for role in ("pressure", "temperature"))
        if pressure is None and density is not None and temperature is None and theta is not None:
            pressure = 1e5 * (density * GAS_CONSTANT * theta / 1e5) ** (1 / (1 - KAPPA))
        if temperature is None and theta is not None and (pressure is not None or complete):
            temperature = theta * ((self.standard_pressure if pressure is None else pressure) / 1e5) ** KAPPA
        if temperature is None and complete:
            temperature = self.standard_temperature
        if pressure is None and density is not None and temperature is not None:
            pressure = density * GAS_CONSTANT * temperature
        found = {"temperature": temperature, "pressure": pressure, "height": self.heights if complete and pressure is None else None}
        return {name: values for name, values in found.items() if values is not None}

    def _role(self, role: str) -> np.ndarray | None:
        """The values of the first array with this role that are all positive."""
        names = [str(name) for name in self.mesh.field_data[_key(role)]] if _key(role) in self.mesh.field_data else []
        values = (self._values(role, name) for name in names if name in self.data)
        return next((found for found in values if np.isfinite(found).any() and np.nanmin(found) > 0), None)

    def _values(self, role: str, name: str) -> np.ndarray:
        units = str(self.mesh.field_data[f"{name}_units"][0]) if f"{name}_units" in self.mesh.field_data else None
        values = np.asarray(self.data[name], float)
        try:
            return values if role == "density" else converted(values, units, AIR[role].quantities[0], name)[0]
        except UnitsError:
            return np.zeros(0)

    def warn(self, problem: str) -> None:
        """Says what the standard atmosphere gives, of which `problem` says that it is missing."""
        missing = [role for role in ("temperature", "pressure") if f"There is no {role}" in problem and (role == "pressure" or self._role("potential_temperature") is None)]
        if missing:
            warnings.warn(f"The grid has no {' and no '.join(missing)}: taken from the standard atmosphere at the heights z of the grid. If the data have {' and '.join(missing)}, "
                          "give the variable, which may be a profile along z, its usual name or its standard_name; describe() lists what has been found.",
                          UserWarning, stacklevel=level_of_caller())
