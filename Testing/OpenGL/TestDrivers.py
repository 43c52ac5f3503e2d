# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What drivers differ in: numbers of many vertices, arrays larger than the smallest buffer texture, primitives, rounding of corners."""
import os
import subprocess
import sys
import unittest

import nephoscope
import numpy as np
from nephoscope_testing import meshes
from nephoscope_testing.checks import ImageTestCase, mapper
from nephoscope_testing.offscreen import Window, float_image
from nephoscope_testing.transfer import Transfer, constant

SMALLEST_BUFFER = 65536  # elements that any OpenGL gives a buffer texture
RAMP = Transfer([(0, 0, 0, 0), (1, 1, 1, 1)], [(0, 1), (1, 2)])


class Drivers(ImageTestCase):
    def draw(self, ours, data, transfer, direction, parallel_scale, size=48):
        window = Window((size, size))
        scene = window.add_scene()
        scene.add_volume(ours, data, transfer)
        center, direction = np.array(data.GetCenter()), np.asarray(direction, float)
        distance = 10 * data.GetLength()
        scene.look(center + distance * direction / np.linalg.norm(direction), center, (0.1, 1, 0.05),
                   parallel_scale=parallel_scale, near=0.5 * distance, far=2 * distance)
        window.render()
        self.fail_on_messages(window)
        self.assertEqual(window.gl_errors(), [])
        return float_image(ours)

    def test_driver(self):
        window = Window((8, 8))
        window.add_scene()
        window.render()
        lines = window.window.ReportCapabilities().splitlines()
        renderer = next(line for line in lines if line.startswith("OpenGL renderer"))
        print("  " + renderer)
        self.assertIn(os.environ.get("GALLIUM_DRIVER", ""), renderer)

    def check_slab(self, ours, label, cells, layers=8):
        """Inside of a slab of constant extinction that is seen obliquely."""
        data = meshes.with_field(meshes.image((cells, cells, layers)), lambda p: 0 * p[:, 0])
        depth = -np.log1p(-self.draw(ours, data, constant(0.1), (0.3, -0.2, 1), 3)[..., 3])
        exact = 0.1 * layers * np.sqrt(1 + 0.3**2 + 0.2**2)
        error = np.abs(depth / exact - 1).max()
        print(f"  {label}: {error:.2g}")
        return error

    def test_many_splats(self):
        """More than the vertices that software numbers in one go."""
        self.assertLessEqual(self.check_slab(nephoscope.vtkTexturedSplatMapper(), "splats", 40), 0.006)

    def test_many_cells(self):
        for method in ("Rays", "Projection"):
            ours = mapper()
            getattr(ours, "SetMethodTo" + method)()
            self.assertLessEqual(self.check_slab(ours, method, 20), 2e-5, method)

    def test_arrays_larger_than_the_smallest_buffer(self):
        """The same picture of a field as of coarse cells, by rays through 41³ points and through the tetrahedra of a mesh."""
        def image_of(blocks, kind):
            lattice = meshes.image((blocks,) * 3, (1 / blocks,) * 3) if kind == "image" else meshes.Lattice(blocks).mesh(kind)
            data = meshes.with_field(lattice, lambda p: p @ (0.2, 0.3, 0.5))
            ours = mapper()
            ours.SetMethodToRays()
            return self.draw(ours, data, RAMP, (0.4, 0.3, 1), 0.8)

        for kind, blocks in (("image", 41), ("tetra", 15)):
            many, few = image_of(blocks, kind), image_of(3, kind)
            self.assertGreater((blocks + 1)**3 if kind == "image" else 4 * 6 * blocks**3, SMALLEST_BUFFER)
            error = np.percentile(np.abs(many - few), 99)  # a few rays run along faces, and pass a little beside
            print(f"  {kind}: {error:.2g}")
            self.assertLessEqual(error, 5e-5)
            self.assertGreater(many[..., 3].max(), 0.5)

    def draw_with_wrong(self, ways, settings="pass"):
        """(picture, messages) of a process in which the check of the ways of drawing fails."""
        script = ("import sys, numpy as np; sys.path.insert(0, sys.argv[1]); from TestDrivers import *\n"
                  "ours, window = mapper(), Window((32, 32)); scene = window.add_scene()\n"
                  "data = meshes.with_field(meshes.image((2, 2, 2)), lambda p: p[:, 2] / 2)\n"
                  f"{settings}; scene.add_volume(ours, data, RAMP); scene.look_at(data); window.render(); window.render()\n"
                  "print(*window.messages.all, sep='\\n'); print('LIGHT', float_image(ours).mean() if not window.messages.errors else 0)")
        result = subprocess.run([sys.executable, "-c", script, os.path.dirname(os.path.abspath(__file__))], capture_output=True, text=True,
                                env=dict(os.environ, NEPHOSCOPE_WRONG_DRAWING=ways))
        self.assertEqual(result.returncode, 0, result.stderr)
        text, light = result.stdout.rsplit("LIGHT", 1)
        return float(light), text

    def test_the_way_around_a_wrong_way(self):
        right, none = self.draw_with_wrong("")
        self.assertNotIn("OpenGL", none)
        projected, warning = self.draw_with_wrong("Rays")
        self.assertEqual(warning.count("does not draw rays"), 1)
        self.assertAlmostEqual(projected, right, places=5)
        self.assertGreater(right, 0.05)
        _, left_out = self.draw_with_wrong("Rays", "ours.SetContourValue(0, 0.5)")
        self.assertEqual(left_out.count("Projected cells are drawn without the contour surfaces"), 1)
        _, error = self.draw_with_wrong("Rays, Projection")
        self.assertEqual(error.count("does not draw cells"), 1)
        self.assertIn("LIBGL_ALWAYS_SOFTWARE", error)


if __name__ == "__main__":
    unittest.main(verbosity=2)
