# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""run_with_pyvista.py INTERPRETER SCRIPT...: runs a test with PyVista, or exits with 125 (skipped) if there is none."""
import os
import subprocess
import sys

interpreter, *command = sys.argv[1:]
if not os.path.exists(interpreter):
    sys.exit(print(f"Skipped: {interpreter} does not exist; './nephoscope test' makes it.") or 125)
probe = subprocess.run([interpreter, "-c", "import pyvista"], capture_output=True, text=True)
if "ModuleNotFoundError" in probe.stderr:
    sys.exit(print(f"Skipped: {interpreter} has no PyVista.\n{probe.stderr}") or 125)
sys.exit(subprocess.run([interpreter, *command]).returncode)
