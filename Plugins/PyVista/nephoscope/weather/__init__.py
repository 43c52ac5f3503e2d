# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Weather data in common formats: xarray datasets, GRIB, WRF, ICON and MPAS files.

Reading order: `opening.py` (a path to a dataset), `roles.py` (which variable is what), `horizontal.py` and `vertical.py` (where it is), `placing.py` (the
mesh), `accessor.py` (what users call).
"""
