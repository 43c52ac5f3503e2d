# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Heights of the terrain-following levels of ocean models, by the formulas of the CF conventions (appendix D)."""
from __future__ import annotations

import numpy as np

from .vertical import VerticalError, formula_terms, usual_terms

_NEEDED = {"ocean_sigma_coordinate": ("sigma", "eta", "depth"), "ocean_s_coordinate_g1": ("s", "C", "eta", "depth", "depth_c"), "ocean_s_coordinate_g2": ("s", "C", "eta", "depth", "depth_c")}


def heights_of_terms(reading) -> tuple[np.ndarray, str]:
    """Heights, negative below the sea, and their source."""
    vertical = reading.vertical
    terms = formula_terms(reading.dataset, vertical)
    kind, terms = (reading.dataset[vertical.name].attrs["standard_name"], terms) if terms else usual_terms(reading.dataset, vertical.dim)
    missing = [term for term in _NEEDED[kind] if terms.get(term) not in reading.dataset.variables]
    if missing:
        raise VerticalError(f"The levels {vertical.name!r} are an {kind}, but of their formula_terms, {terms}, these are not in the dataset: {', '.join(missing)}.")
    found = {term: _term(reading, terms[term]) for term in _NEEDED[kind]}
    return _FORMULAS[kind](**found), f"{kind}: {', '.join(terms[term] for term in _NEEDED[kind])}"


def _term(reading, name: str) -> np.ndarray:
    values = reading.values(name).astype(float)
    return values.reshape(-1, *[1] * len(reading.horizontal.dims)) if reading.dataset[name].dims == (reading.vertical.dim,) else values


def _sigma(sigma, eta, depth):
    return eta + sigma * (depth + eta)


def _g1(s, C, eta, depth, depth_c):
    at_rest = depth_c * s + (depth - depth_c) * C
    return at_rest + eta * (1 + at_rest / depth)


def _g2(s, C, eta, depth, depth_c):
    return eta + (eta + depth) * (depth_c * s + depth * C) / (depth_c + depth)


_FORMULAS = {"ocean_sigma_coordinate": _sigma, "ocean_s_coordinate_g1": _g1, "ocean_s_coordinate_g2": _g2}
