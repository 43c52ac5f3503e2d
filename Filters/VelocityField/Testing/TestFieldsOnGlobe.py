# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""A rotation of the whole globe about an axis in the plane of the equator, followed over the poles and the seam of
vtkGlobeGrid's output: the closed form is the turn itself."""
import unittest

import nephoscope
import numpy as np
from nephoscope_testing.fields import Field, Particles
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkCommonDataModel import vtkRectilinearGrid
from vtkmodules.vtkFiltersGeneral import vtkDataSetTriangleFilter

RADIUS = 6.371e6
AXIS = np.array([np.cos(0.3), np.sin(0.3), 0.0])  # over the poles, oblique to the seam
TURN = 2.0  # radians
DURATION = 86400.0


def axis_values(values):
    return numpy_to_vtk(np.asarray(values, dtype=float), deep=True, array_type=vtkDoubleArray().GetDataType())


def globe(columns, rows):
    """Heights 0, 5 and 10 km, exaggerated 50 times; the point array "turning" is the velocity of the rotation."""
    grid = vtkRectilinearGrid()
    grid.SetDimensions(columns, rows, 3)
    grid.SetXCoordinates(axis_values(360.0 / columns * np.arange(columns)))
    grid.SetYCoordinates(axis_values(np.linspace(-90, 90, rows)))
    grid.SetZCoordinates(axis_values([0.0, 5000.0, 10000.0]))
    to_globe = nephoscope.vtkGlobeGrid()
    to_globe.SetInputData(grid)
    to_globe.SetVerticalExaggeration(50)
    to_globe.SetLevelUnitsToHeightMetre()
    to_globe.SetHeightArrayName("")
    to_globe.SetWindArrayNames("", "", "")
    to_globe.Update()
    output = to_globe.GetOutput()
    velocity = np.cross(TURN / DURATION * AXIS, vtk_to_numpy(output.GetPoints().GetData()))
    array = numpy_to_vtk(velocity, deep=True)
    array.SetName("turning")
    output.GetPointData().AddArray(array)
    return output


def seeds(count=400):
    """Around the pole, the seam and anywhere; the pole itself and points of the seam among them."""
    rng = np.random.default_rng(5)
    directions = rng.normal(size=(count, 3))
    directions[:100, :2] *= 0.02
    directions[0] = [0, 0, 1]
    directions[1] = [0, 0, -1]
    directions[100:200, 1] *= 0.02  # longitudes 0 and 180
    directions[100:110, 1] = 0
    directions /= np.linalg.norm(directions, axis=1)[:, None]
    return directions * (RADIUS + rng.uniform(150e3, 350e3, count))[:, None]


def turned(points, angle):
    along = (points @ AXIS)[:, None] * AXIS
    return along + np.cos(angle) * (points - along) + np.sin(angle) * np.cross(AXIS, points)


class Rotation(unittest.TestCase):
    def test_velocity_is_exact_everywhere(self):
        """The velocity is linear in the position."""
        points = seeds()
        expected = np.cross(TURN / DURATION * AXIS, points)
        speed = np.abs(expected).max()
        grid = globe(36, 19)
        cells = grid.GetNumberOfCells()
        for hints in (None, np.arange(400) % cells, (np.arange(400) * 7919) % cells, np.full(400, cells - 1)):
            found = Field(grid, "turning").sample(Particles(points, hints))
            self.assertLess(np.abs(found - expected).max(), 1e-10 * speed)  # NaN, too, fails

    def test_particles_over_pole_and_seam(self):
        """A linear velocity leaves the error of RK4 alone: of fourth order in the step."""
        points, errors = seeds(), []
        field = Field(globe(36, 19), "turning")
        for steps in (8, 16, 32):
            particles = field.advance(Particles(points), DURATION / steps, steps)
            self.assertTrue(particles.inside.all())
            errors.append(np.abs(particles.positions - turned(points, TURN)).max() / RADIUS)
        self.assertLess(errors[-1], 1e-6)
        for coarse, fine in zip(errors, errors[1:]):
            self.assertAlmostEqual(np.log2(coarse / fine), 4, delta=0.3)

    def test_second_order_in_the_grid_spacing(self):
        """A speed that depends on the distance from the axis is not linear: the error is that of the grid."""
        errors = []
        for columns in (36, 72, 144):
            grid = globe(columns, columns // 2 + 1)
            points = vtk_to_numpy(grid.GetPoints().GetData())
            scale = 1 + (points @ AXIS / RADIUS) ** 2
            vtk_to_numpy(grid.GetPointData().GetArray("turning"))[:] *= scale[:, None]
            start = seeds()
            exact = np.empty_like(start)
            for i, point in enumerate(start):  # the distance along the axis stays
                exact[i] = turned(point[None], TURN * (1 + (point @ AXIS / RADIUS) ** 2))[0]
            particles = Field(grid, "turning").advance(Particles(start), DURATION / 64, 64)
            self.assertTrue(particles.inside.all())
            errors.append(np.linalg.norm(particles.positions - exact, axis=1).max() / RADIUS)
        for coarse, fine in zip(errors, errors[1:]):
            self.assertAlmostEqual(np.log2(coarse / fine), 2, delta=0.4)

    def test_threads(self):
        field = Field(globe(36, 19), "turning")
        points = np.tile(seeds(), (4, 1))
        for tolerance in (0.0, 1.0):
            expected = field.advance(Particles(points), DURATION / 8, 8, tolerance, 1).positions
            for threads in (2, 4):
                got = field.advance(Particles(points), DURATION / 8, 8, tolerance, threads).positions
                self.assertTrue((got == expected).all())

    def test_adaptive_error(self):
        field = Field(globe(36, 19), "turning")
        for tolerance in (1e3, 1.0, 1e-3):
            particles = field.advance(Particles(seeds()), DURATION / 4, 4, tolerance)
            error = np.linalg.norm(particles.positions - turned(seeds(), TURN), axis=1).max()
            self.assertLess(error, 10 * tolerance)

    def test_tetrahedra_of_the_same_globe(self):
        split = vtkDataSetTriangleFilter()
        split.SetInputData(globe(36, 19))
        split.Update()
        particles = Field(split.GetOutput(), "turning").advance(Particles(seeds()), DURATION / 32, 32)
        self.assertTrue(particles.inside.all())
        self.assertLess(np.abs(particles.positions - turned(seeds(), TURN)).max() / RADIUS, 1e-6)

    def test_above_and_below_is_outside(self):
        points = seeds()
        length = np.linalg.norm(points, axis=1)[:, None]
        field = Field(globe(36, 19), "turning")
        for radius in (RADIUS * 0.98, RADIUS + 501e3):
            self.assertTrue(np.isnan(field.sample(points / length * radius)).all())


if __name__ == "__main__":
    unittest.main()
