# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Clouds, smoke and wind for VTK, PyVista and ParaView.

``import nephoscope`` gives every wrapped class: ``nephoscope.vtkGlobeGrid()``.
"""
import importlib as _importlib

from ._modules import MODULES as _MODULES

for _name in _MODULES:
    _module = _importlib.import_module("." + _name, __name__)
    globals().update({k: v for k, v in vars(_module).items() if k.startswith("vtk")})
