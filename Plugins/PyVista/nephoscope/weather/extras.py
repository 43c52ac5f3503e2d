# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The packages that only weather data need, imported when they are needed."""
import importlib
import sys

REMEDY = {"eccodes": "eccodes eccodeslib"}


def need(module: str, purpose: str):
    """The module, or one error with the line that installs it."""
    try:
        return importlib.import_module(module)
    except ImportError as missing:
        packages = REMEDY.get(module, module)
        raise ModuleNotFoundError(
            f"{purpose[0].upper()}{purpose[1:]} needs the Python package {module!r}, which is not there for {sys.executable}: {missing}. Install it with the other packages for weather "
            f"data, nephoscope[data], or alone, beside the numpy that is there: {sys.executable} -m pip install {packages} \"numpy=={_numpy()}\"", name=module) from missing


def _numpy() -> str:
    import numpy
    return numpy.__version__
