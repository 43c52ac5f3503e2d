# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of hard transfer functions with and without cuts at control points, and their errors."""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from . import contours, meshes
from .checks import SHIFTS, cells_of, forgive_shift, mapper
from .compare import Difference, edge_mask
from .offscreen import Window, float_image


def picture(data, case, split, look, size=96):
    window = Window((size, size))
    scene = window.add_scene()
    ours = mapper()
    volume = scene.add_volume(ours, data, case.prop)
    scene.look_at(volume, **look)
    ours.SetSplitAtControlPoints(split)
    window.render()
    return float_image(ours), scene.view(), window.messages.all


def random_mesh(rng, case, count=60):
    """A linear field from case.low to case.high."""
    data = meshes.delaunay(rng, count)
    field = meshes.linear_field(rng, data)
    return meshes.with_field(data, lambda p: case.low + (case.high - case.low) * field(p))


class Unit(contours.Jumps):
    """A function of the scalar counted from 0 to 1, so that the reference loses no digits to large scalars."""

    def __init__(self, case):
        f = case.pieces
        to_unit = lambda rows: np.column_stack([(rows[:, 0] - case.low) / (case.high - case.low), rows[:, 1:]])
        super().__init__(to_unit(f.colors), to_unit(f.opacities), f.unit_distance, f.opacity_scale)
        self.cuts = (f.breakpoints - case.low) / (case.high - case.low)

    @property
    def breakpoints(self):
        return self.cuts


def errors(case, seed, forgive=False):
    """Differences with cuts and without. forgive: less what a step of checks.SHIFT changes in the reference, where they are large."""
    rng = np.random.default_rng(seed)
    data = random_mesh(rng, case)
    look = dict(direction=rng.normal(size=3), parallel=bool(seed % 2))
    result = []
    for split in (True, False):
        image, view, said = picture(data, case, split, look)
        if said:
            raise SystemExit(f"{case.name}: {said[0]}")
        if split:
            unit = data.NewInstance()
            unit.DeepCopy(data)
            values = (vtk_to_numpy(data.GetPointData().GetArray("s")) - case.low) / (case.high - case.low)
            unit.GetPointData().RemoveArray("s")
            meshes.add_array(unit.GetPointData(), values)
            cells = cells_of(unit)
            draw = lambda v: contours.render(cells, v, Unit(case))
            expected, mask = draw(view), edge_mask(cells.drawn_edges(), view)
            if forgive and Difference(image, expected, mask).maximum > 1 / 255:
                image = forgive_shift(image, expected, [draw(view.shifted(*s)) for s in SHIFTS], case.name)
        result.append(Difference(image, expected, mask))
    return result
