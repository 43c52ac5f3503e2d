# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Eyes anywhere: on vertices, edges, faces, grid planes, seam, poles and the boundary, and at random.

At most 0.1 % of the pixels may be off. The field is linear, so the reference does not depend on how the cells are divided. A pixel whose
ray lies within a plane of the mesh has no one right value at a silhouette: it must lie between the values a little to either side.
`--all` tries 10^4 random and 10^3 special positions per mesh.
"""
import sys
import time
import unittest

import numpy as np
from nephoscope_testing import meshes, polyhedra, reference
from nephoscope_testing.checks import mapper
from nephoscope_testing.offscreen import Window, float_image
from nephoscope_testing.transfer import Transfer
from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkmodules.vtkFiltersGeneral import vtkDataSetTriangleFilter

RANDOM, SPECIAL = (10000, 1000) if "--all" in sys.argv else (60, 120)
sys.argv = [a for a in sys.argv if a != "--all"]
OFF = 2 / 255
DIRECTIONS = np.array([(0.3, 0.2, -1), (0, 0, -1), (1, 0, 0), (1, 1, 0), (1, 1, 1), (0, -1, 0), (-0.3, 0.4, 0.2)])


def unstructured(data):
    append = vtkAppendFilter()
    append.AddInputData(data)
    append.Update()
    return append.GetOutput()


def tetrahedra(data):
    divide = vtkDataSetTriangleFilter()
    divide.SetInputData(data)
    divide.Update()
    return divide.GetOutput()


STORAGES = dict(structured=lambda data: data, unstructured=unstructured, tetrahedra=tetrahedra)


class Eyes(unittest.TestCase):
    """Draws a mesh from given eyes and counts the pixels that are off."""

    def setUp(self):
        self.rng = np.random.default_rng(5)

    def start(self, data, cells, size, unit):
        self.cells, self.size = cells, size
        self.transfer = Transfer([(0, 1, 0, 0), (0.5, 0, 1, 0), (1, 0, 0, 1)], [(0, 0.1), (0.4, 1), (1, 0.1)], unit_distance=unit)
        self.window = Window((12, 12))
        self.scene = self.window.add_scene()
        self.mapper = mapper()
        self.scene.add_volume(self.mapper, data, self.transfer)

    def off(self, eye, direction):
        """Number of pixels that are off, or None where nothing is in view."""
        up = (0, 1, 0) if abs(direction[1]) < 0.9 * np.linalg.norm(direction) else (0, 0, 1)
        self.scene.look(eye, eye + self.size * direction / np.linalg.norm(direction), up, 60, near=0.003 * self.size, far=10 * self.size)
        self.window.render()
        view = self.scene.view()
        first = reference.render(self.cells, view, self.transfer)
        if first.max() == 0: # VTK does not ask the mapper to draw
            return None
        image = float_image(self.mapper)
        if np.abs(image - first).max() <= OFF:
            return 0
        beside = [reference.render(self.cells, view.shifted(x, y), self.transfer)
                  for x, y in ((3e-4, 2e-4), (-3e-4, -2e-4), (2e-4, -3e-4), (-2e-4, 3e-4))]
        low, high = np.min(beside, axis=0), np.max(beside, axis=0)
        return int((np.maximum(low - image, image - high).max(axis=2) > OFF).sum())

    def check(self, name, eyes):
        counts = [self.off(np.array(eye, float), DIRECTIONS[i % len(DIRECTIONS)]) for i, eye in enumerate(eyes)]
        seen = [c for c in counts if c is not None]
        share = sum(seen) / (144 * len(seen))
        print(f"{name}: {100 * share:.4f} % of the pixels of {len(seen)} pictures are off", flush=True)
        self.assertGreater(len(seen), len(counts) // 3, name)
        self.assertLessEqual(share, 1e-3, name)
        self.assertLess(max(seen), 30, f"{name}: a picture is lost")


class Box(Eyes):
    HALF = 4
    NAMED = [(0, 0, 0), (0, 0, 4), (2, 3, 1), (0.37, 0.21, 0), (0.3, 0.2, 0.1), (4, 4, 4), (0.5, 0.5, 0.5), (1, 1, 0.25), (4, 0.3, 0.2)]

    def eyes(self, count):
        """Half grid planes, edges and vertices, inside, on the boundary and outside; also near them, by rounding or more."""
        h, rng = self.HALF, self.rng
        on_plane = rng.random((count, 3)) < 0.5
        special = np.where(on_plane, rng.integers(-2 * h, 2 * h + 1, (count, 3)) / 2, rng.uniform(-1.3 * h, 1.3 * h, (count, 3)))
        return special + rng.choice([0, 0, 0, 1e-12, -1e-7, 1e-6, -1e-5, 1e-4], (count, 3))

    def test_box(self):
        h = self.HALF
        field = lambda p: 0.5 + p @ (0.6 * np.array([0.31, 0.17, -0.43]) / h)
        cells = polyhedra.from_dataset(meshes.with_field(meshes.image((1, 1, 1), (2 * h,) * 3, (-h,) * 3), field))
        for name, store in STORAGES.items():
            self.start(store(meshes.with_field(meshes.image((2 * h,) * 3, origin=(-h,) * 3), field)), cells, h, 0.1 * h)
            self.check(f"box, {name}, named", [e for e in self.NAMED for _ in DIRECTIONS[1:]])
            self.check(f"box, {name}, special", self.eyes(SPECIAL))
            self.check(f"box, {name}, random", self.rng.uniform(-h, h, (RANDOM, 3)))


class Globe(Eyes):
    LONGITUDES, LATITUDES, LEVELS, RADII = 12, 6, 2, (1.0, 1.3)

    def place(self, level, row, column):
        r = np.interp(level, (0, self.LEVELS), self.RADII)
        latitude = np.interp(row, (0, self.LATITUDES), (-np.pi / 2, np.pi / 2))
        longitude = 2 * np.pi * np.asarray(column) / self.LONGITUDES
        return np.stack([r * np.cos(latitude) * np.cos(longitude), r * np.cos(latitude) * np.sin(longitude), r * np.sin(latitude)], -1)

    def eyes(self, count):
        """Vertices, edges, grid planes, seam, poles and the boundary, and near them."""
        rng = self.rng
        top = (self.LEVELS, self.LATITUDES, self.LONGITUDES)
        whole = np.stack([rng.integers(0, n + 1, count) for n in top], -1)
        free = np.stack([rng.uniform(0, n, count) for n in top], -1)
        index = np.where(rng.random((count, 3)) < 0.6, whole, free)
        index[rng.random(count) < 0.2, 1] = self.LATITUDES # a pole
        index[rng.random(count) < 0.2, 2] = 0 # the seam
        index += rng.choice([0, 0, 0, 1e-13, -1e-9, 1e-6, -1e-4], (count, 3))
        return self.place(*index.T) * np.where(rng.random((count, 1)) < 0.2, rng.uniform(0.5, 2.5, (count, 1)), 1)

    def grid(self, field):
        blocks = (self.LONGITUDES, self.LATITUDES, self.LEVELS)
        return meshes.with_field(meshes.structured(blocks, lambda p: self.place(*(p * blocks)[:, ::-1].T)), field)

    def test_globe(self):
        field = lambda p: 0.5 + p @ np.array([0.31, 0.17, -0.33])
        cells = polyhedra.from_dataset(self.grid(field))
        for name, store in STORAGES.items():
            self.start(store(self.grid(field)), cells, 1.0, 0.3)
            self.check(f"globe, {name}, special", self.eyes(SPECIAL // 2 if SPECIAL < 1000 else SPECIAL))
            index = [self.rng.uniform(0, n, RANDOM // 2) for n in (self.LEVELS, self.LATITUDES, self.LONGITUDES)]
            self.check(f"globe, {name}, random", self.place(*index))


class TestTimeInside(unittest.TestCase):
    """To find where an eye inside is takes a time proportional to the number of cells."""

    def seconds(self, blocks):
        """The processor time of a frame from a new eye inside, without the first one."""
        window = Window((12, 12))
        scene = window.add_scene()
        data = meshes.with_field(unstructured(meshes.structured((blocks,) * 3, lambda p: p)), lambda p: p[:, 0])
        scene.add_volume(mapper(), data, Transfer([(0, 1, 1, 1), (1, 1, 1, 1)], [(0, 1), (1, 1)], unit_distance=1))
        times = []
        for x in (0.31, 0.33, 0.35, 0.37):
            scene.look((x, 0.42, 0.43), (2, 0.4, 0.4), (0, 0, 1), 60, near=0.001, far=10)
            start = time.process_time()
            window.render()
            times.append(time.process_time() - start)
        return min(times[1:])

    def test_many_cells(self):
        few, many = self.seconds(15), self.seconds(45)  # 27 times as many
        print(f"an eye inside: {few:.3f} s with 3,375 cells, {many:.3f} s with 91,125")
        self.assertLess(many, 60 * few)  # 729 times if each cell looked at all points


if __name__ == "__main__":
    unittest.main(verbosity=2)
