# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The frames of the package's films, loaded from the sources: figures that ParaView draws do without the package."""
import os
from importlib.util import module_from_spec, spec_from_file_location

TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
_spec = spec_from_file_location("_film_frames", os.path.join(TOP, "Plugins", "PyVista", "nephoscope", "_film_frames.py"))
_module = module_from_spec(_spec)
_spec.loader.exec_module(_module)
Frames, require_whole = _module.Frames, _module.require_whole
