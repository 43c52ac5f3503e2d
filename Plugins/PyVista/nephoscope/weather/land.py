# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Land in data of oceans that the file does not declare as missing: zeros there, and the masks of models."""
from __future__ import annotations

import re
from typing import Any

import numpy as np

from .units import FILLS

_STATE = "temperature|salinity|velocity|density"
_WATER = re.compile(rf"(sea ?water|sea surface|ocean).*({_STATE})|({_STATE}).*(sea ?water|ocean)|salinity|(potential|conservative) temperature")
_NAMES = re.compile("(thetao|to|so|tos|sos|sst|sss|uo|vo|wo|votemper|vosaline|vozocrtx|vomecrty|sosstsst|sosaline|toce|soce|temp|salt)")
SEA_MASKS = ("mask_rho", "tmask", "tmaskutil")  # of ROMS and NEMO: 0 on land
LEAST, LEAST_OF_LEVEL = 0.001, 0.02  # of all values: the zeros of land
OFTEN = 20  # times as often as any other value


def zeros_of_land(name: str, variable: Any, values: np.ndarray, on_levels: bool, top_first: bool) -> np.ndarray | None:
    """Where `values`, with the levels first if there are any, are exactly 0 on land and below the bottom of the sea. None if the variable is not one of sea water, has
    another fill value, or has zeros elsewhere.

    On several levels all zeros must reach down to the lowest level, in some columns from the uppermost one. On one level 0 must be far below all
    other values, or much more frequent than any of them.
    """
    if not may_have_zeros(name, variable):
        return None
    zero = values == 0
    if not np.isfinite(values).all() or zero.mean() < LEAST or zero.all():
        return None
    if not on_levels or len(values) < 2:
        return zero if zero.mean() > LEAST_OF_LEVEL and _stands_out(zero.sum(), values[~zero]) else None
    downwards = zero if top_first else zero[::-1]
    reaches_down = (downwards[1:] >= downwards[:-1]).all()
    return zero if reaches_down and downwards[0].any() else None


def _stands_out(zeros: int, others: np.ndarray) -> bool:
    far = others.min() > 0.2 * np.ptp(others) > 0
    return bool(far or zeros > OFTEN * np.unique(others, return_counts=True)[1].max())


def may_have_zeros(name: str, variable: Any) -> bool:
    """Whether the variable is temperature, salinity, density or a current of the sea, and the file does not say which value is missing."""
    texts = [str(variable.attrs.get(key, "")).replace("_", " ").lower() for key in ("standard_name", "long_name")]
    declared = any(key in keys for keys in (variable.attrs, variable.encoding) for key in FILLS)
    return variable.dtype.kind == "f" and not declared and bool(_NAMES.fullmatch(name.lower()) or any(map(_WATER.search, texts)))
