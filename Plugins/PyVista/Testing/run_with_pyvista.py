# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""run_with_pyvista.py INTERPRETER SCRIPT...: runs a test with PyVista, or exits with 125 (skipped) if there is none; tests of weather data need eccodes too."""
import os
import subprocess
import sys

interpreter, *command = sys.argv[1:]
if not os.path.exists(interpreter):
    sys.exit(print(f"Skipped: {interpreter} does not exist; './nephoscope test' makes it.") or 125)
wanted = "pyvista, xarray, eccodes, dask, zarr" if "TestWeather" in command[0] or "regional_model" in command[-1] else "pyvista"
probe = subprocess.run([interpreter, "-c", f"import {wanted}"], capture_output=True, text=True)
if "ModuleNotFoundError" in probe.stderr:
    sys.exit(print(f"Skipped: {interpreter} has not all of {wanted}.\n{probe.stderr}") or 125)
sys.exit(subprocess.run([interpreter, *command]).returncode)
