# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Puts the package `forecast` of Data/forecast on the path: import it first."""
import os
import sys

DATA = os.environ["NEPHOSCOPE_DATA"]
sys.path.insert(0, os.path.join(DATA, "forecast"))
