# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""run_with_pyvista.py INTERPRETER SCRIPT...: runs a test with PyVista, or exits with 125 (skipped) if there is none; tests of weather data need eccodes too."""
import os
import subprocess
import sys

interpreter, *command = sys.argv[1:]
if not os.path.exists(interpreter):
    sys.exit(print(f"Skipped: {interpreter} does not exist; './nephoscope test' makes it.") or 125)
wanted = ["pyvista", "xarray", "eccodes", "dask", "zarr"] if "TestWeather" in command[0] or "regional_model" in command[-1] else ["pyvista"]
# Found but not imported: that takes longer than many a test.
find = "import importlib.util, sys; print(*(name for name in sys.argv[1:] if not importlib.util.find_spec(name)))"
missing = subprocess.run([interpreter, "-c", find, *wanted], capture_output=True, text=True, check=True).stdout.split()
if missing:
    sys.exit(print(f"Skipped: {interpreter} has no {' and no '.join(missing)}.") or 125)
sys.exit(subprocess.run([interpreter, *command]).returncode)
