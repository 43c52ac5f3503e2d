# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""A forecast of wind and clouds for some days, of one analysis. Read in this order: sphere, barotropic, tracers, gfs, model,
netcdf_classic, series."""
import os

# One thread: with several the sums in products of matrices can come in another order, and no two runs would be equal.
for _name in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ.setdefault(_name, "1")
