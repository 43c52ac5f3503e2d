# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pressure, temperature and humidity of a reading, and the heights of its points from the best data available."""
from __future__ import annotations

from functools import cached_property

import numpy as np

from .._checks import listed
from .columns import KAPPA, from_half_levels, geometric, geopotential_height, hypsometric, midpoints, standard_height, standard_temperature, virtual_temperature
from .reading import Reading
from .units import GRAVITY, converted
from .vertical import VerticalError, formula_terms, runs_down, usual_coefficients

SEA_LEVEL = 101325.0  # Pa
CLEAR = 2.0  # least ratio between the thicknesses of the outermost layers that tells which one is uppermost


class Air:
    """The state of the air in a reading. Each quantity is loaded on first use; levels are in the dataset's order."""

    def __init__(self, reading: Reading) -> None:
        self.reading = reading

    @cached_property
    def shape(self) -> tuple[int, ...]:
        reading = self.reading
        return (reading.dataset.sizes[reading.vertical.dim], *reading.horizontal.shape)

    def _columns(self, values: np.ndarray) -> np.ndarray:
        """Values at every point, level by level."""
        return np.broadcast_to(values.reshape(-1, *[1] * (len(self.shape) - 1)), self.shape)

    # The ground

    @cached_property
    def terrain(self) -> np.ndarray | None:
        reading = self.reading
        if reading.has("terrain"):
            return reading.role("terrain").astype(float)
        if reading.has("surface_geopotential"):
            return geometric(reading.role("surface_geopotential").astype(float) / GRAVITY)
        return None

    @cached_property
    def surface_pressure(self) -> np.ndarray | None:
        reading = self.reading
        if reading.has("surface_pressure"):
            return reading.role("surface_pressure").astype(float)
        if reading.has("log_surface_pressure"):
            return np.exp(reading.role("log_surface_pressure").astype(float))
        name = formula_terms(reading.dataset, reading.vertical).get("ps") if reading.vertical else None
        if name in reading.dataset.variables and set(reading.dataset[name].dims) == set(reading.horizontal.dims):  # under another name
            values, note = converted(reading.values(name).astype(float), reading.dataset[name].attrs.get("units"), "pressure", name)
            reading.note(note)
            return values
        return None

    # Levels

    @cached_property
    def pressure(self) -> np.ndarray | None:
        """Pa."""
        reading = self.reading
        if reading.vertical is None:
            return None if reading.level_pressure is None else np.full(reading.horizontal.shape, reading.level_pressure)
        if reading.vertical.kind == "pressure":
            return self._columns(reading.levels())
        if reading.has("pressure"):
            return reading.role("pressure").astype(float)
        if reading.vertical.kind == "log pressure":
            terms = formula_terms(reading.dataset, reading.vertical)
            p0 = float(_pascal(reading.dataset, terms["p0"])) if terms.get("p0") in reading.dataset else 1e5
            return self._columns(p0 * np.exp(-reading.levels()))
        return self._hybrid_pressure() if reading.vertical.kind in ("hybrid", "sigma") else self._summed_pressure()

    def _summed_pressure(self) -> np.ndarray | None:
        """From the thicknesses of the layers: upwards from the pressure at the ground, or downwards from none."""
        if not self.reading.has("pressure_thickness"):
            return None
        layers = self.reading.role("pressure_thickness").astype(float)
        top_first = self._is_top_first("pressure_thickness", layers, thin_top=True)
        self.reading.note("pressure summed over the layers" + ("" if self.surface_pressure is not None else ", from 0 Pa at the top"))
        if self.surface_pressure is None:
            return midpoints(layers, top_first)
        return self.surface_pressure - midpoints(layers, not top_first)

    def _is_top_first(self, role: str, layers: np.ndarray, thin_top: bool) -> bool:
        """Whether the first layer is the uppermost. This follows from heights or the axis, otherwise from the thicknesses, with a warning unless they differ much."""
        reading = self.reading
        for other in ("altitude", "geopotential_height", "geopotential"):
            if reading.has(other) and reading.vertical.dim in reading.dataset[reading.roles[other]].dims:
                values = reading.role(other)
                return bool(np.nanmean(values[0]) > np.nanmean(values[-1]))
        if (falls := runs_down(reading.dataset, reading.vertical)) is not None:
            return falls
        first, last = np.nanmean(layers[0]), np.nanmean(layers[-1])
        top_first = bool(first < last if thin_top else first > last)
        if max(first, last) < CLEAR * min(first, last) and len(layers) > 1:
            name, dim = reading.roles[role], reading.vertical.dim
            reading.warn(f"{name!r}: its layers are summed with the {'first' if top_first else 'last'} one uppermost, which is a guess from their thicknesses. If the first one is {'lowest' if top_first else 'uppermost'}, "
                         f"say so: ds = ds.assign_coords({dim}=({dim!r}, range({len(layers)}), {{'positive': {'up' if top_first else 'down'!r}}})); or name the pressure, "
                         "globe(pressure='...').")
        return top_first

    def _hybrid_pressure(self) -> np.ndarray | None:
        reading = self.reading
        a, b = hybrid_coefficients(reading)
        if self.surface_pressure is None:
            if np.any(b != 0):
                raise VerticalError(f"Hybrid and sigma levels ({reading.vertical.dim!r}) need the pressure at the ground, but there is none: no surface_air_pressure, sp, ps or "
                                    f"lnsp on {listed(reading.horizontal.dims)}. Add it, or name it: globe(surface_pressure='...').")
            return self._columns(a)
        return self._columns(a) + self._columns(b) * self.surface_pressure

    @cached_property
    def temperature(self) -> np.ndarray | None:
        """Temperature in K, from the potential temperature if there is no other."""
        reading = self.reading
        if reading.has("temperature"):
            return reading.role("temperature").astype(float)
        if reading.has("potential_temperature") and self.pressure is not None:
            reading.note("temperature from the potential temperature and the pressure")
            return reading.role("potential_temperature") * (self.pressure / 1e5) ** KAPPA
        return None

    @cached_property
    def specific_humidity(self) -> np.ndarray | None:
        reading = self.reading
        if reading.has("specific_humidity"):
            return reading.role("specific_humidity").astype(float)
        if reading.has("mixing_ratio"):
            ratio = reading.role("mixing_ratio").astype(float)
            return ratio / (1 + ratio)
        if reading.has("relative_humidity") and self.temperature is not None and self.pressure is not None:
            from .humidity import specific_from_relative
            return specific_from_relative(reading.role("relative_humidity").astype(float), self.temperature, self.pressure)
        return None

    @cached_property
    def virtual_temperature(self) -> np.ndarray | None:
        if self.temperature is None:
            return None
        self.reading.note("virtual temperature " + ("with the humidity" if self.specific_humidity is not None else "of dry air: no humidity was found"))
        return virtual_temperature(self.temperature, self.specific_humidity)

    # Heights

    @cached_property
    def heights(self) -> np.ndarray:
        """Geometric heights above sea level, in m; `height_source` names their source."""
        for way in (self._given_heights, self._level_heights, self._hybrid_heights, self._sleve_heights, self._ocean_heights, self._summed_heights, self._model_heights, self._pressure_heights):
            found = way()
            if found is not None:
                return found
        vertical = self.reading.vertical
        raise VerticalError(f"The heights of the levels {vertical.dim!r} ({vertical.kind}) were not found: there is no height, geopotential, pressure or formula_terms on them. "
                            f"Variables on them: {listed([name for name, _ in self.reading.field_variables()])}. Name one: globe(altitude='...'), globe(geopotential='...') or "
                            f"globe(pressure='...'). Or draw one level: ds.isel({vertical.dim}=0)." + self._of_model_levels() + "".join(f" Left out: {problem}" for problem in self.reading.unusable.values()))

    def _of_model_levels(self) -> str:
        """What the numbers of levels of a model need, as in NetCDF files of ECMWF."""
        numbers = self.reading.levels()
        if self.reading.vertical.kind != "levels" or not self.reading.vertical.name or np.any(numbers % 1) or numbers.min(initial=1) < 1:
            return ""
        return (" If they are model levels, such as ECMWF's, their pressures need the model's coefficients a and b, and the pressure at the ground (lnsp or sp). GRIB files have the coefficients, NetCDF "
                "files of ECMWF do not: get the data with lnsp as GRIB, and open that file.")

    height_source = ""

    def interfaces(self, order: np.ndarray) -> np.ndarray:
        """Heights of the surfaces between the levels, from the bottom to the top: the model's own if it has them, otherwise midway between levels."""
        reading = self.reading
        if reading.vertical is None:
            return np.zeros((1, *reading.horizontal.shape))
        own = self._own_interfaces()
        if own is not None:
            return own
        heights = self.heights[order]
        if len(heights) == 1:
            return heights
        middle = 0.5 * (heights[1:] + heights[:-1])
        bottom, top = 1.5 * heights[0] - 0.5 * heights[1], 1.5 * heights[-1] - 0.5 * heights[-2]
        if self.terrain is not None and reading.vertical.kind not in ("pressure", "height", "depth"):
            bottom = np.minimum(self.terrain, heights[0])
        return np.concatenate([bottom[None], middle, top[None]])

    def _own_interfaces(self) -> np.ndarray | None:
        reading = self.reading
        if not reading.has("altitude") or reading.vertical.dim in reading.dataset[reading.roles["altitude"]].dims:
            return None
        array = reading.dataset[reading.roles["altitude"]]
        dim = next(dim for dim in array.dims if dim not in reading.horizontal.dims)
        if array.sizes[dim] != self.shape[0] + 1:
            return None
        found = array.transpose(dim, *reading.horizontal.dims).values.astype(float)
        return found if np.nanmean(found[0]) < np.nanmean(found[-1]) else found[::-1]

    def _given_heights(self) -> np.ndarray | None:
        reading = self.reading
        for role, made in (("altitude", lambda z: z), ("geopotential_height", geometric), ("geopotential", lambda z: geometric(z / GRAVITY))):
            if reading.has(role):
                values, quantity = reading.role_as(role)
                values = values.astype(float)
                self.height_source = f"{role.replace('_', ' ')} {reading.roles[role]!r}"
                return geometric(values / GRAVITY) if quantity == "geopotential" else made(values)
        return None

    def _level_heights(self) -> np.ndarray | None:
        kind = self.reading.vertical.kind
        if kind not in ("height", "height above ground", "depth"):
            return None
        heights = self._columns(self.reading.levels())
        self.height_source = "the levels" + (", depths" if kind == "depth" else "")
        if kind != "height above ground":
            return heights
        if self.terrain is None:
            self.reading.note("heights above the ground are used as heights above sea level, because no height of the ground was found")
            return heights
        self.height_source = f"the levels, above the ground {self.reading.roles.get('terrain', self.reading.roles.get('surface_geopotential'))!r}"
        return heights + self.terrain

    def _hybrid_heights(self) -> np.ndarray | None:
        """z = a + b orog (CF, appendix D)."""
        reading = self.reading
        if reading.vertical.kind != "hybrid height":
            return None
        listed_terms = terms_of_full_levels(reading)
        if listed_terms is not None:
            self.height_source = "hybrid heights, a + b * height of the ground, by the list of vertical coordinates in the header"
            return self._columns(listed_terms[0]) + self._columns(listed_terms[1]) * self._ground()
        terms = formula_terms(reading.dataset, reading.vertical)
        a, b, orog = (reading.dataset[terms[term]] if terms.get(term) in reading.dataset.variables else None for term in ("a", "b", "orog"))
        if a is None or b is None or (orog is None and self.terrain is None):
            raise VerticalError(f"The levels {reading.vertical.name!r} are hybrid heights, a + b * orog, but of their formula_terms, {terms}, not all are in the dataset.")
        ground = self.terrain if orog is None else reading.values(terms["orog"]).astype(float)
        self.height_source = f"hybrid heights, {terms['a']} + {terms['b']} * {terms.get('orog', 'orog')}"
        return self._columns(a.values.astype(float)) + self._columns(b.values.astype(float)) * ground

    def _sleve_heights(self) -> np.ndarray | None:
        """z = a ztop + b1 zsurf1 + b2 zsurf2 (CF, appendix D)."""
        reading = self.reading
        if reading.vertical.kind != "sleve":
            return None
        terms = formula_terms(reading.dataset, reading.vertical)
        missing = [term for term in ("a", "b1", "b2", "ztop", "zsurf1", "zsurf2") if terms.get(term) not in reading.dataset.variables]
        if missing:
            raise VerticalError(f"The levels {reading.vertical.name!r} are an atmosphere_sleve_coordinate, but of their formula_terms, {terms}, these are not in the dataset: {', '.join(missing)}.")
        a, b1, b2 = (self._columns(reading.dataset[terms[term]].values.astype(float)) for term in ("a", "b1", "b2"))
        top, large, small = (converted(reading.values(terms[term]).astype(float), reading.dataset[terms[term]].attrs.get("units"), "height", terms[term])[0] for term in ("ztop", "zsurf1", "zsurf2"))
        self.height_source = f"{terms['a']} * {terms['ztop']} + {terms['b1']} * {terms['zsurf1']} + {terms['b2']} * {terms['zsurf2']}"
        return a * top + b1 * large + b2 * small

    def _ocean_heights(self) -> np.ndarray | None:
        if self.reading.vertical.kind != "ocean sigma":
            return None
        from .ocean import heights_of_terms
        found, self.height_source = heights_of_terms(self.reading)
        return found

    def _summed_heights(self) -> np.ndarray | None:
        """From the thicknesses of the layers, upwards from the ground."""
        if not self.reading.has("thickness"):
            return None
        layers = np.abs(self.reading.role("thickness").astype(float))
        top_first = self._is_top_first("thickness", layers, thin_top=False)
        self.height_source = f"the layers' thickness {self.reading.roles['thickness']!r}"
        return midpoints(layers, not top_first) + self._ground()

    def _model_heights(self) -> np.ndarray | None:
        """Hybrid sigma-pressure levels: the hypsometric equation over half levels if they are known, otherwise over full levels."""
        reading = self.reading
        if reading.vertical.kind not in ("hybrid", "sigma"):
            return None
        if self.virtual_temperature is None:
            return None
        virtual = self.virtual_temperature
        ground = self._ground_for_hypsometry()
        half = half_coefficients(reading)
        if half is not None:
            self.height_source = "the hypsometric equation over half levels"
            a, b = (values.reshape(-1, *[1] * (len(self.shape) - 1)) for values in half)
            order = np.argsort(self._columns_mean())  # top first
            back = np.empty(self.shape)
            back[order] = from_half_levels(a + b * self.surface_pressure, virtual[order], ground)
            return geometric(back)
        self.height_source = "the hypsometric equation over full levels"
        return geometric(hypsometric(self.pressure, virtual, self.surface_pressure if self.surface_pressure is not None else np.full(self.shape[1:], SEA_LEVEL), ground))

    def _columns_mean(self) -> np.ndarray:
        return np.nanmean(self.pressure.reshape(self.shape[0], -1), axis=1)

    def _ground(self) -> np.ndarray:
        if self.terrain is None:
            self.reading.warn("No height of the ground was found (orog, surface_altitude, surface geopotential): heights are counted from a ground at 0 m. Name it: "
                              "globe(terrain='...').")
            return np.zeros(self.shape[1:])
        return self.terrain

    def _ground_for_hypsometry(self) -> np.ndarray:
        return geopotential_height(self._ground())

    def _pressure_heights(self) -> np.ndarray | None:
        reading = self.reading
        if self.pressure is None:
            return None
        if self.virtual_temperature is not None and self.surface_pressure is not None and self.terrain is not None:
            self.height_source = "the hypsometric equation from the ground"
            return geometric(hypsometric(self.pressure, self.virtual_temperature, self.surface_pressure, self._ground_for_hypsometry()))
        self.height_source = "the pressure by the standard atmosphere"
        if reading.vertical.kind in ("hybrid", "sigma"):
            reading.warn(f"No temperature was found on the levels {reading.vertical.dim!r}: their heights are those of the standard atmosphere. Add it from its own file, "
                         "xarray.merge([ds, nephoscope.open('ta.nc')], compat='override'), or name it: globe(temperature='...').")
        reading.note("no geopotential, and not all of temperature, surface pressure and height of the ground")
        return geometric(standard_height(self.pressure))

    @cached_property
    def temperature_or_standard(self) -> np.ndarray:
        if self.virtual_temperature is not None:
            return self.virtual_temperature
        self.reading.note("temperature of the standard atmosphere, for the conversion of Pa/s to m/s")
        return standard_temperature(self.pressure)


def hybrid_coefficients(reading: Reading) -> tuple[np.ndarray, np.ndarray]:
    """Coefficients a (Pa) and b of the full levels: p = a + b ps."""
    dataset, vertical = reading.dataset, reading.vertical
    if (listed_full := terms_of_full_levels(reading)) is not None:
        return listed_full
    listed_half = _parameters(reading)
    if listed_half is not None:
        above = reading.levels().astype(int) - 1
        return tuple(0.5 * (values[above] + values[above + 1]) for values in listed_half)
    terms = formula_terms(dataset, vertical) or usual_coefficients(dataset, vertical.dim) or {}
    if vertical.kind == "sigma":
        sigma = dataset[terms.get("sigma", vertical.name)].values.astype(float)
        top = float(_pascal(dataset, terms["ptop"])) if terms.get("ptop") in dataset.variables else 0.0
        return top * (1 - sigma), sigma
    b = _term(dataset, terms, "b")
    if "ap" in terms:
        return _pascal(dataset, terms["ap"]), b
    a = _term(dataset, terms, "a")
    if str(dataset[terms["a"]].attrs.get("units", "1")).lower() in ("pa", "hpa"):
        return _pascal(dataset, terms["a"]), b
    p0 = terms.get("p0") if terms.get("p0") in dataset.variables else next((name for name in ("P0", "p0") if name in dataset.variables), None)
    if p0 is None and np.nanmax(np.abs(a)) > 2:  # in Pa, not a fraction of a reference pressure
        return a, b
    return a * (_pascal(dataset, p0) if p0 else 1e5), b


def _term(dataset, terms: dict, term: str) -> np.ndarray:
    if terms.get(term) not in dataset.variables:
        raise VerticalError(f"The hybrid levels' formula_terms, {terms}, need the variable {terms.get(term, term)!r} ({term}), which the dataset does not have. It has: "
                            f"{listed([str(name) for name in dataset.variables])}.")
    return dataset[terms[term]].values.astype(float)


def _pascal(dataset, name: str) -> np.ndarray:
    values = dataset[name].values.astype(float)
    return converted(values, dataset[name].attrs.get("units", "Pa"), "pressure", name)[0]


def terms_of_full_levels(reading: Reading) -> tuple[np.ndarray, np.ndarray] | None:
    """Coefficients a and b of the full levels, from GRIB's list for the levels hybridHeight and hybridPressure: those of level k are the k-th of each half, from 0."""
    if reading.vertical.dim not in ("hybridHeight", "hybridPressure") or (pv := _list_of_header(reading)) is None:
        return None
    numbers, count = reading.levels().astype(int), len(pv) // 2
    return (pv[numbers], pv[count + numbers]) if numbers.max() < count else None


def _list_of_header(reading: Reading) -> np.ndarray | None:
    found = next((variable.attrs["GRIB_pv"] for _, variable in reading.field_variables() if "GRIB_pv" in variable.attrs), None)
    return None if found is None else np.asarray(found, dtype=float)


def _parameters(reading: Reading) -> tuple[np.ndarray, np.ndarray] | None:
    """Coefficients a and b of all half levels of the model, top first, from GRIB's list of vertical coordinate parameters; None if no list covers the dataset's levels."""
    pv = _list_of_header(reading)
    if pv is None or reading.vertical.kind != "hybrid" or reading.vertical.dim == "hybridPressure":
        return None
    a, b = pv[:len(pv) // 2], pv[len(pv) // 2:]
    return (a, b) if len(a) and reading.levels().min() >= 1 and reading.levels().max() < len(a) else None


def half_coefficients(reading: Reading) -> tuple[np.ndarray, np.ndarray] | None:
    """Coefficients a and b of the half levels around the dataset's levels, top first, if these are all levels of the model above the ground."""
    found = _parameters(reading)
    numbers = np.sort(reading.levels().astype(int)) if found else []
    if found is None or np.any(np.diff(numbers) != 1) or numbers[-1] != len(found[0]) - 1:
        return None
    return found[0][numbers[0] - 1:], found[1][numbers[0] - 1:]
