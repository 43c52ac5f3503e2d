# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Processor time of vtkPolyhedronToTetrahedra per cell: cells that pass, are divided, need a new point, need TetGen."""
import time

import nephoscope
import numpy as np
from nephoscope_testing import dual_meshes, nonconvex


def copies(shape, count):
    points, faces, _ = shape
    n = len(points)
    all_points = np.vstack([points + (5 * i, 0, 0) for i in range(count)])
    return nonconvex.grid_of(all_points, [[[v + n * i for v in face] for face in faces] for i in range(count)])


def measure(label, data, **settings):
    divider = nephoscope.vtkPolyhedronToTetrahedra()
    divider.SetInputData(data)
    for name, value in settings.items():
        getattr(divider, "Set" + name)(value)
    wall, cpu = time.perf_counter(), time.process_time()
    divider.Update()
    wall, cpu = time.perf_counter() - wall, time.process_time() - cpu
    cells = data.GetNumberOfCells()
    print(f"{label}: {cells} cells, {divider.GetNumberOfDividedCells()} divided, {1e6 * cpu / cells:.1f} us of processor time "
          f"a cell, {1e6 * wall / cells:.1f} us on the clock", flush=True)


layers = dual_meshes.mpas_like(5, 8, 0.1).grid()
measure("prisms that pass", layers)
measure("prisms divided", layers, DivideConvexPolyhedra=True)
measure("new point", copies(nonconvex.schonhardt(), 20000))
if nephoscope.vtkPolyhedronToTetrahedra.HasTetGen():
    measure("TetGen, whose own process time is on the clock only", copies(nonconvex.prism(nonconvex.U_POLYGON), 2000))
