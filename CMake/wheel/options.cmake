# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
# What a build for VTK's wheel is; `./nephoscope wheel` gives it to CMake before the first configuration.
set(CMAKE_BUILD_TYPE Release CACHE STRING "")
set(NEPHOSCOPE_FOR_PYPI ON CACHE BOOL "")
set(NEPHOSCOPE_USE_PARAVIEW OFF CACHE BOOL "")
set(NEPHOSCOPE_USE_TETGEN OFF CACHE STRING "") # GNU AGPL 3
set(NEPHOSCOPE_USE_OPENVDB ON CACHE STRING "") # of make_openvdb.py
set(BUILD_TESTING ON CACHE BOOL "") # the Python tests, run with the wheel
