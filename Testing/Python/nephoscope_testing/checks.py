# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""A test case that draws a volume and holds it against the reference."""
import os
import unittest

import numpy as np

from . import polyhedra, reference
from .compare import Difference, edge_mask
from .offscreen import Window, float_image

FLOAT_TOLERANCE = 1e-4
BYTE_TOLERANCE = 1 / 255


def mapper():
    import nephoscope
    return nephoscope.vtkCellCompositingMapper()


class ImageTestCase(unittest.TestCase):
    """check() draws; every failure names the scene and keeps the three pictures.

    The float image is held to FLOAT_TOLERANCE except at pixels on an edge of a tetrahedron (compare.NEAR_EDGE);
    the 8-bit picture to one step everywhere except on the silhouette.
    """

    def fail_on_messages(self, window, label=""):
        self.assertEqual(window.messages.all, [], f"{label}: a normal scene must draw without messages")

    def check_float(self, image, expected, label, tolerance=FLOAT_TOLERANCE, mask=None):
        difference = Difference(image, expected, mask)
        print(f"  {label}: float {difference}", flush=True)
        if not difference.maximum <= tolerance:
            keep(label, image, expected)
            self.fail(f"{label}: float image differs by more than {tolerance:g}: {difference}")
        return difference

    def check_bytes(self, rgb, expected_rgb, label, mask=None):
        difference = Difference(rgb, np.clip(expected_rgb, 0, 1), mask)
        if not difference.maximum <= BYTE_TOLERANCE + 1e-9:
            keep(label + " 8-bit", rgb, expected_rgb)
            self.fail(f"{label}: 8-bit picture differs by more than 1/255: {difference}")
        return difference

    def check(self, data, transfer, label, association="point", decompose=False, size=(96, 96), matrix=None,
              configure=None, look=None, opaque=None, tolerance=FLOAT_TOLERANCE, background=(0, 0, 0), split=True):
        """Draws data and compares the float and the 8-bit picture. look: options of Scene.look_at, or a function of
        the scene. opaque: (polydata, triangles, colour). Returns (mapper, window, scene, reference)."""
        window = Window(size)
        scene = window.add_scene(background=background)
        ours = mapper()
        volume = scene.add_volume(ours, data, transfer, association=association, matrix=matrix)
        (look or (lambda s: s.look_at(volume)))(scene) if not isinstance(look, dict) else scene.look_at(volume, **look)
        if configure:
            configure(ours)
        cells = polyhedra.from_dataset(data, "s", association, decompose)
        if matrix is not None:
            cells = cells.transformed(matrix)
        view = scene.view()
        distance, under, edges = None, np.asarray(background, float), cells.boundary_edges()
        if opaque:
            polydata, triangles, color = opaque
            scene.add_opaque(polydata, color)
            distance = reference.opaque_distance(triangles, view).reshape(view.height, view.width)
            under = np.where(np.isfinite(distance)[..., None], color, background)
            edges = np.concatenate([edges, np.stack([triangles, np.roll(triangles, 1, 1)], 2).reshape(-1, 2, 3)])
        window.render()
        expected = reference.render(cells, view, transfer, distance, split=split)
        mask = edge_mask(edges, view)
        self.check_float(float_image(ours), expected, label, tolerance, mask | edge_mask(cells.drawn_edges(), view))
        self.check_bytes(scene.rgb(), reference.over(expected, under), label, mask)
        self.fail_on_messages(window, label)
        return ours, window, scene, expected


def keep(label, image, expected):
    """Writes got, expected and difference as .npy and one PNG beside each other, where the build keeps test output."""
    folder = os.environ.get("NEPHOSCOPE_TEST_OUTPUT")
    if not folder:
        return
    from .pictures import write_png
    name = os.path.join(folder, "".join(c if c.isalnum() else "_" for c in label))
    np.savez_compressed(name + ".npz", image=image, expected=expected)
    difference = np.abs(np.nan_to_num(image) - expected)
    scale = max(difference.max(), 1e-12)
    write_png(name + ".png", np.hstack([p[..., :3] for p in (image, expected, difference / scale)]))
