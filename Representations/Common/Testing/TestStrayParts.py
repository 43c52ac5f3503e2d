# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Lengths that follow the data do not follow one particle, one point or a small part far away from all others."""
import unittest

import nephoscope
import numpy as np
from nephoscope_testing import meshes
from nephoscope_testing.offscreen import Window
from nephoscope_testing.transfer import Transfer
from vtkmodules.vtkCommonDataModel import VTK_HEXAHEDRON

RAMP = Transfer([(0, 1, 1, 1), (2, 1, 1, 1)], [(0, 0), (2, 1)])
LATTICE = np.stack(np.meshgrid(*[np.arange(10.0)] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
FAR = (1e3, -2e4, 10.0)  # so far that floats still tell the others apart
CUBE = (10, (0, 0, 0), 1)
CUBIC = 1.556228


def cloud(points):
    return filled(meshes.particles(points))


def filled(data):
    return meshes.with_field(data, lambda points: np.ones(len(points)))


def cubes(*boxes):
    """Points and hexahedra of cubes, each with its number of cells along an edge, its least corner, and the edge of a cell."""
    points, cells = [], []
    for count, corner, edge in boxes:
        lattice = meshes.Lattice(count)
        first = sum(map(len, points))
        cells += [(VTK_HEXAHEDRON, np.add(lattice.ids(block), first)) for block in lattice.all_blocks()]
        points.append(lattice.points * count * edge + corner)
    return np.concatenate(points), cells


def mesh(points, cells):
    return filled(meshes.grid(points, cells))


def unit_distance(mapper_class, data, **settings):
    mapper = mapper_class()
    mapper.SetInputDataObject(data)
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectScalarArray("s")
    for name, value in settings.items():
        getattr(mapper, "Set" + name)(value)
    return mapper.FindUnitDistance(RAMP.volume_property())


class TestStrayParts(unittest.TestCase):
    def check_distance(self, mapper_class, data, stray, share=0.03, **settings):
        expected, found = (unit_distance(mapper_class, d, **settings) for d in (data, stray))
        self.assertGreater(expected, 0)
        self.assertLess(abs(found / expected - 1), share, f"unit distance {found}, without the stray part {expected}")

    def test_particles(self):
        for settings in ({}, {"CellSizeFromCells": False, "CellSizeFromNeighbors": True}, {"CellSize": 1.0}):
            for stray in ([FAR], LATTICE[:60] * 0.5 + FAR):
                with self.subTest(settings=settings, count=len(stray)):
                    self.check_distance(nephoscope.vtkTexturedSplatMapper, cloud(LATTICE), cloud(np.vstack([LATTICE, stray])), **settings)

    def test_size_of_splats(self):
        """The bounds of the mapper are those of the splats: one radius around the stray one."""
        for neighbors in (False, True):
            mapper = nephoscope.vtkTexturedSplatMapper()
            mapper.SetInputDataObject(cloud(np.vstack([LATTICE, [FAR]])))
            mapper.SetScalarModeToUsePointFieldData()
            mapper.SelectScalarArray("s")
            mapper.SetCellSizeFromNeighbors(neighbors)
            radius = mapper.GetBounds()[1] - FAR[0]
            self.assertLess(radius, 2.2 * CUBIC, f"from neighbours: {neighbors}")
            self.assertGreater(radius, 0.85 * CUBIC)

    def test_cells(self):
        near = mesh(*cubes(CUBE))
        for mapper_class in (nephoscope.vtkCellCompositingMapper, nephoscope.vtkTexturedSplatMapper):
            with self.subTest(mapper_class.__name__, stray="part"):
                self.check_distance(mapper_class, near, mesh(*cubes(CUBE, (2, FAR, 1))))
            with self.subTest(mapper_class.__name__, stray="point"):
                points, cells = cubes(CUBE)
                points[-1] = FAR  # its only cell becomes a needle, whose volume the splats of its other corners share
                splats = mapper_class is nephoscope.vtkTexturedSplatMapper
                self.check_distance(mapper_class, near, mesh(points, cells), share=3 if splats else 0.03)

    def test_structured(self):
        grid = filled(meshes.structured((10, 10, 10), lambda p: p))
        bent = filled(meshes.structured((10, 10, 10), lambda p: np.where(np.arange(len(p))[:, None] == 555, 1e3, p)))
        for mapper_class in (nephoscope.vtkCellCompositingMapper, nephoscope.vtkTexturedSplatMapper):
            with self.subTest(mapper_class.__name__):
                self.check_distance(mapper_class, grid, bent, share=0.1)

    def test_all_of_it_counts(self):
        """Coarse cells around fine ones are no stray part, however few they are."""
        data = mesh(*cubes((20, (-10, -10, -10), 1), (5, (-100, -100, -100), 40)))
        found = unit_distance(nephoscope.vtkCellCompositingMapper, data)
        self.assertGreater(found, 0.9 * 200 * 2 / 3 * 0.5 / 2, "mean chord of the cube of coarse cells, half its opacity, a depth of 2")

    def test_tail_counts(self):
        """Smoke thins out to long cells: so many are no stray part."""
        points, cells = cubes(CUBE, (6, (0, 0, 0), 1))
        points[11 ** 3:, 2] *= 100
        cube, all_of_it = (unit_distance(nephoscope.vtkCellCompositingMapper, mesh(*some)) for some in (cubes(CUBE), (points, cells)))
        self.assertGreater(abs(all_of_it / cube - 1), 0.2)

    def test_picture(self):
        """Particles with one far away are drawn as those without: neither blank nor one blob."""
        pictures = []
        for points in (LATTICE, np.vstack([LATTICE, [FAR]])):
            window = Window((64, 64))
            scene = window.add_scene()
            mapper = nephoscope.vtkTexturedSplatMapper()
            prop = RAMP.volume_property()
            scene.add_volume(mapper, cloud(points), prop)
            prop.SetScalarOpacityUnitDistance(mapper.FindUnitDistance(prop))
            scene.look((4.5, 4.5, 50), focus=(4.5, 4.5, 4.5))
            window.render()
            pictures.append(window.rgba())
        self.assertGreater(np.ptp(pictures[0]), 0.3)
        self.assertLess(np.abs(pictures[1] - pictures[0]).mean(), 0.02)


if __name__ == "__main__":
    unittest.main()
