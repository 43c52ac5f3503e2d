#!/usr/bin/env python3
# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Make a time series of wind and clouds from the GFS file: a NetCDF file with one field an hour.

    make_forecast.py OUT.nc [--grid gfs|paper|test] [--hours N] [--analysis Data/gfs_2p5deg_2011101100.nc]

Grids: gfs, the file's own 144 x 73 x 21 (default); paper, 320 x 160 x 19, Gaussian; test, 36 x 19 x 5 and packed. An interrupted
run goes on where it stopped. Needs: numpy and VTK, for /usr/bin/python3 of Debian the packages python3-numpy and python3-vtk9 or
python3-paraview. The same machine makes the same file, bit for bit.
"""
import argparse
import os
import sys

import forecast.series  # first: it settles the number of threads
from forecast import gfs, model

HERE = os.path.dirname(os.path.abspath(__file__))
ANALYSIS = os.path.join(os.path.dirname(HERE), "gfs_2p5deg_2011101100.nc")
FINE_LEVELS = [1000, 975, 950, 925, 900] + list(range(850, 50, -50))  # hPa
PAPER_LEVELS = list(range(1000, 50, -50))
TEST_LEVELS = [850, 700, 500, 300, 200]
HOURS = {"gfs": 48, "paper": 48, "test": 6}


def series(path, grid, hours):
    if grid == "gfs":
        return forecast.series.Series(path, model.even_layout(144, 73, FINE_LEVELS, 85, refinement=2), hours)
    if grid == "paper":
        return forecast.series.Series(path, model.gaussian_layout(320, 160, PAPER_LEVELS, 106), hours)
    names = ("u", "v", "w", "cloud_fraction")
    return forecast.series.Series(path, model.even_layout(36, 19, TEST_LEVELS, 15), hours, names, packed=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("output")
    parser.add_argument("--grid", choices=sorted(HOURS), default="gfs")
    parser.add_argument("--hours", type=int, help="length, at least 1; default 48, for the grid `test` 6")
    parser.add_argument("--analysis", default=ANALYSIS)
    arguments = parser.parse_args()
    hours = HOURS[arguments.grid] if arguments.hours is None else arguments.hours
    if hours < 1:
        parser.error("--hours must be at least 1")
    made = series(arguments.output, arguments.grid, hours)
    made.make(gfs.Analysis(arguments.analysis), report=lambda line: print(line, flush=True))
    print("wrote", arguments.output)
    return 0


if __name__ == "__main__":
    sys.exit(main())
