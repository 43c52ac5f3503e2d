# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""VTK in one process with the libraries of eccodes, which hide some of VTK's own.

The package eckitlib, which eccodes of the Python package index loads, shows the symbols of its libraries to all that come later. Among them are parts of C++'s regular expressions, with
which VTK's wheels then write the labels of scalar bars, and OpenLDAP, which the system's NetCDF uses instead of its own. Both crash the process: at the first scalar bar, or when it
ends. Libraries that are loaded earlier are not touched, and those that are loaded with RTLD_DEEPBIND prefer their own symbols.
"""
from __future__ import annotations

import os
import sys
import warnings
from contextlib import contextmanager
from typing import Iterator

INTRUDER, VTK = "eckitlib", "vtkmodules.vtkCommonCore"


@contextmanager
def own_symbols() -> Iterator[None]:
    """Libraries that are imported inside prefer their own symbols to those of eckitlib."""
    deep = getattr(os, "RTLD_DEEPBIND", 0) if INTRUDER in sys.modules else 0
    flags = sys.getdlopenflags() if deep else 0
    if deep:
        sys.setdlopenflags(flags | deep)
    try:
        yield
    finally:
        if deep:
            sys.setdlopenflags(flags)


def warn_of_order() -> None:
    """Warns if eccodes has been imported before VTK of the Python package index, and VTK not by `own_symbols`."""
    names = list(sys.modules)
    if INTRUDER in names and VTK in names and names.index(INTRUDER) < names.index(VTK):
        warnings.warn("eccodes was imported before VTK and conflicts with its libraries: Python will crash at the first scalar bar ('std::bad_alloc'). Import nephoscope or pyvista before eccodes and cfgrib, and "
                      "before xarray opens a file.", RuntimeWarning, stacklevel=4)
