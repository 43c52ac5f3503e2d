# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The reader "Weather data" on two ranks, of which all or only the first run the script: its points once in all, and its time steps in the animation."""
import os
import subprocess
import sys
import tempfile

from MpiTesting import ENVIRONMENT, program

PYTHON = os.environ["NEPHOSCOPE_PYTHON"]
WRITE = """
import sys
from weather_data import REGULAR, write_grib
write_grib(sys.argv[1], [(name, "isobaricInhPa", level, value + day, {"dataDate": 20200101 + day}) for day in range(2) for level, z in ((850, 1500), (500, 5500))
                         for name, value in (("gh", z), ("t", 250))], REGULAR)
"""
RUN = """
import sys
from nephoscope.weather.paraview_reader import load
load(globals())
from paraview.simple import GetAnimationScene, GetTimeKeeper, UpdatePipeline
from paraview.modules.vtkRemotingCore import vtkProcessModule
reader = WeatherDataReader(FileName=sys.argv[1])
GetAnimationScene().UpdateAnimationUsingDataTimeSteps()
assert list(GetTimeKeeper().TimestepValues) == [0, 24], GetTimeKeeper().TimestepValues
for time in (0.0, 24.0):
    UpdatePipeline(time=time, proxy=reader)
    if vtkProcessModule.GetProcessModule().GetPartitionId() == 0:
        print("READ", reader.GetDataInformation().GetNumberOfPoints(), reader.PointData["t"].GetRange())
"""


def run(folder, *options):
    script, data = os.path.join(folder, "run.py"), os.path.join(folder, "forecast.grib2")
    with open(script, "w", encoding="utf-8") as file:
        file.write(RUN)
    told = subprocess.run([program("MPIEXEC"), "-np", "2", program("PVBATCH"), "--dr", *options, script, data], env=ENVIRONMENT, capture_output=True, text=True, timeout=150)
    return told.stdout + told.stderr


def main():
    if not os.path.exists(PYTHON) or subprocess.run([PYTHON, "-c", "import pyvista, xarray, eccodes"], capture_output=True).returncode:
        print("Skipped: the packages for weather data are not there")
        sys.exit(125)
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([PYTHON, "-c", WRITE, os.path.join(folder, "forecast.grib2")], check=True)
        for options in ((), ("--sym",)):
            told = run(folder, *options)
            for time in (0, 1):
                assert told.count(f"READ {37 * 19 * 2} ({250.0 + time}, {250.0 + time})") == 1, (options, told[-3000:])
    print("NEPHOSCOPE-PASSED")


main()
