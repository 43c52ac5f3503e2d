# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The data that come with Nephoscope."""
from __future__ import annotations

import sys
from pathlib import Path

SAMPLES = ("gfs_2p5deg_2011101100.nc", "forecast_10deg_6h.nc", "blue_marble_2048.jpg")
OWN_PYTHON = "~/nephoscope-python/bin/python"  # made by the command in messages of a Debian package
PACKAGE = Path(__file__).resolve().parent


def shared(name: str) -> str:
    """Path of an installed file, "" if there is none."""
    return next((str(above / "share/nephoscope" / name) for above in PACKAGE.parents if (above / "share/nephoscope" / name).is_file()), "")


def requirements(*names: str, options: str = "", python: str = sys.executable or "python3") -> str:
    """The command that installs requirement files of Nephoscope next to the system's VTK: installed ones, or those of its source folder."""
    files = [shared(name) for name in names]
    if all(files):  # Debian's Python takes no packages from pip
        return (f"sudo apt install python3-venv && python3 -m venv --system-site-packages ~/nephoscope-python && {OWN_PYTHON} -m pip install "
                f"{options}{_listed(files)}, and use {OWN_PYTHON}")
    return f"{python} -m pip install {options}{_listed(_in_source(name) for name in names)}"


def _listed(files) -> str:
    return " ".join(f"-r {file}" for file in files)


def _in_source(name: str) -> str:
    """Path from the top folder of the source, whole where the build lies in it."""
    path = Path("Plugins/PyVista") / name
    return next((str(above / path) for above in PACKAGE.parents if (above / path).is_file()), str(path))


def sample_data(name: str) -> str:
    """Find a file that comes with Nephoscope, for first pictures.

    Parameters
    ----------
    name : {"gfs_2p5deg_2011101100.nc", "forecast_10deg_6h.nc", "blue_marble_2048.jpg"}
        ``"gfs_2p5deg_2011101100.nc"``: weather of the whole globe, 2011-10-11 00 UTC, at 2.5 degrees on 21 levels from 1000 to 100 hPa: the
        72-hour forecast of NCEP's GFS, a work of the US government in the public domain. ``cloud_fraction`` is derived (Xu and Randall 1996).
        ``"forecast_10deg_6h.nc"``: a coarse forecast with several time steps, for films and moving textures.
        ``"blue_marble_2048.jpg"``: the Earth without clouds, a map of 2048 x 1024 pixels, longitudes -180 to 180. NASA's Blue Marble, public domain.

    Returns
    -------
    str
        The path of the file.

    Raises
    ------
    ValueError
        If there is no sample of that name; the message lists the names.
    FileNotFoundError
        If the file has not been installed; the message names the folders where it may be.

    Examples
    --------
    >>> import nephoscope
    >>> weather = nephoscope.read_cf(nephoscope.sample_data("gfs_2p5deg_2011101100.nc"))  # doctest: +SKIP
    """
    if name not in SAMPLES:
        raise ValueError(f"There are no sample data {name!r}. There are: {', '.join(map(repr, SAMPLES))}.")
    folders = [PACKAGE / "data", *(above / "share/nephoscope" for above in PACKAGE.parents)]  # of a wheel; of a build or an installation
    for folder in folders:
        if (folder / name).is_file():
            return str(folder / name)
    raise FileNotFoundError(f"The sample data {name} are not installed: neither in {folders[0]} nor in share/nephoscope of a folder above. "
                            "Nephoscope's sources have them in the folder Data.")
