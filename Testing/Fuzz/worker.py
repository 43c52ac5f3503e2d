# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""worker.py LOG NAME FIRST COUNT [--calls]: cases FIRST, FIRST + 1, ... of a class. Says in LOG what starts and what was found."""
import faulthandler
import os
import sys
import traceback

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import subjects  # noqa: E402
import vtkmodules.vtkRenderingOpenGL2  # noqa: E402, F401
from vtkmodules.vtkCommonCore import vtkObject, vtkOutputWindow  # noqa: E402


def main():
    log, name, first, count = open(sys.argv[1], "a", buffering=1), sys.argv[2], int(sys.argv[3]), int(sys.argv[4])
    faulthandler.enable()
    if "--calls" not in sys.argv:
        vtkOutputWindow.GetInstance().SetDisplayModeToNever()
        vtkObject.GlobalWarningDisplayOff()
    for seed in range(first, first + count):
        log.write(f"start {seed}\n")
        made = []
        try:
            subjects.run(name, seed, made)
        except subjects.Finding as finding:
            log.write(f"found {finding}\n")
        except Exception:
            log.write(f"found exception: {' '.join(traceback.format_exc().splitlines()[-3:])}\n")
        if "--calls" in sys.argv:
            print("\n".join(made))
    log.write("end\n")
    os._exit(0)


main()
