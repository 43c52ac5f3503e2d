# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Files with wrong bytes, cut or lengthened, in the readers that this project has or that its users have before its filters."""
import os
import resource
import tempfile

import nephoscope
import numpy as np
import random_data
from vtkmodules.vtkIONetCDF import vtkNetCDFCFReader

FOLDER = tempfile.TemporaryDirectory()
MEMORY = 2 << 30  # bytes of address space: little more than the process itself takes, so that a string of a gigabyte is refused at once
HEADER = 8192  # libnetcdf reads for minutes what a damaged header says
FORECAST = os.path.join(os.environ.get("NEPHOSCOPE_DATA", "Data"), "forecast_10deg_6h.nc")


def sound_volume():
    """A small .vdb file, made once."""
    name = os.path.join(FOLDER.name, "sound.vdb")
    if not os.path.exists(name):
        image = random_data.fill(random_data.Dice(1), random_data.image(random_data.Dice(1)))
        writer = nephoscope.vtkSparseVolumeWriter()
        writer.SetInputDataObject(image)
        writer.SetFileName(name)
        writer.Write()
    return name


def damaged(dice, source, suffix, sound=0):
    """A copy in which some bytes after the first `sound` ones are others; most of them near the beginning, where the structure is."""
    content = bytearray(open(source, "rb").read())
    for _ in range(dice.pick([0, 1, 1, 2, 10, 100])):
        reach = min(len(content) - sound, dice.pick([64, 1024, 1 << 30]))
        content[sound + dice.rng.integers(reach)] = dice.pick([0, 255, 1, 127, 128, int(dice.rng.integers(256))])
    if dice.rng.random() < 0.3:
        content = content[:sound + dice.rng.integers(len(content) - sound)]
    if dice.rng.random() < 0.1:
        content += bytes(100)
    name = os.path.join(FOLDER.name, "damaged" + suffix)
    with open(name, "wb") as file:
        file.write(content)
    return name


def read_volume(dice, made):
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))  # OpenVDB makes strings as long as a damaged file says: up to 4 GB
    reader = nephoscope.vtkSparseVolumeReader()
    reader.SetFileName(damaged(dice, sound_volume(), ".vdb"))
    reader.Update()
    return reader.GetOutputDataObject(0)


def read_forecast(dice, made):
    reader = vtkNetCDFCFReader()
    reader.SetFileName(damaged(dice, FORECAST, ".nc", sound=HEADER))
    reader.SetSphericalCoordinates(False)
    globe = nephoscope.vtkGlobeGrid()
    globe.SetInputConnection(reader.GetOutputPort())
    globe.Update()
    return globe.GetOutputDataObject(0)


READERS = {"netcdf": read_forecast, **({"vdb": read_volume} if hasattr(nephoscope, "vtkSparseVolumeReader") else {})}


def run(name, seed, made):
    np.seterr(all="ignore")
    return READERS[name](random_data.Dice(seed), made)
