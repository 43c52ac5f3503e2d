# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""A test case that draws a volume and holds it against the reference."""
import os
import unittest

import numpy as np

from . import meshes, polyhedra, reference
from .compare import Difference, edge_mask
from .offscreen import Window, float_image

FLOAT_TOLERANCE = 1e-4
BYTE_TOLERANCE = 1 / 255
# Blending into 8 bits over something else than black may round the source colour, its alpha and the product of
# (1 - alpha) with what lies below: half a step each.
BLEND_TOLERANCE = 1.5 / 255


def mapper():
    import nephoscope
    return nephoscope.vtkCellCompositingMapper()

# Vertices in float lie up to about this far (pixels) from where they belong, a tenth of half the step of the grid
# on which a rasteriser places them. Where a ray grazes a face between two cells, so small a step moves the crossing
# visibly: there the picture may be that of a ray this far away.
SHIFT = 2e-4
SHIFTS = ((SHIFT, 0), (-SHIFT, 0), (0, SHIFT), (0, -SHIFT))


def forgive_shift(image, expected, shifted, label):
    """The image, its errors lessened by what a step of SHIFT changes in the reference itself."""
    allowed = np.max([np.abs(s - expected) for s in shifted], axis=0)
    error = image - expected
    print(f"  {label}: {int((np.abs(error) > FLOAT_TOLERANCE).any(axis=2).sum())} pixels held to the reference within {SHIFT} pixel")
    return expected + np.sign(error) * np.maximum(np.abs(error) - allowed, 0)


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

    def check_bytes(self, rgb, expected_rgb, label, mask=None, tolerance=BYTE_TOLERANCE):
        difference = Difference(rgb, np.clip(expected_rgb, 0, 1), mask)
        if not difference.maximum <= tolerance + 1e-9:
            keep(label + " 8-bit", rgb, expected_rgb)
            self.fail(f"{label}: 8-bit picture differs by more than {255 * tolerance:g}/255: {difference}")
        return difference

    def verify(self, scene, ours, cells, transfer, label, opaque=None, background=(0, 0, 0), split=True,
               tolerance=FLOAT_TOLERANCE):
        """Holds what was drawn last against the reference, which is returned. opaque: (triangles, colour)."""
        view = scene.view()
        distance, under, edges = None, np.asarray(background, float), cells.boundary_edges()
        if opaque:
            triangles, color = opaque
            distance = reference.opaque_distance(triangles, view).reshape(view.height, view.width)
            under = np.where(np.isfinite(distance)[..., None], color, background)
            edges = np.concatenate([edges, np.stack([triangles, np.roll(triangles, 1, 1)], 2).reshape(-1, 2, 3)])
        draw = lambda v: reference.render(cells, v, transfer, distance, split=split)
        expected, mask, image = draw(view), edge_mask(edges, view), float_image(ours)
        off_edges = mask | edge_mask(cells.drawn_edges(), view)
        if Difference(image, expected, off_edges).maximum > tolerance:
            image = forgive_shift(image, expected, [draw(view.shifted(*s)) for s in SHIFTS], label)
        self.check_float(image, expected, label, tolerance, off_edges)
        self.check_bytes(scene.rgb(), reference.over(expected, under), label, mask,
                         BLEND_TOLERANCE if np.any(under) else BYTE_TOLERANCE)
        self.fail_on_messages(scene.window, label)
        return expected

    def check(self, data, transfer, label, association="point", decompose=False, size=(96, 96), matrix=None,
              configure=None, look=None, viewport=(0, 0, 1, 1), opaque=None, background=(0, 0, 0), **options):
        """Draws data in a window of its own and verifies it. look: options of Scene.look_at, or a function of the
        scene. opaque: (polydata, colour). Returns (mapper, window, scene, reference)."""
        window = Window(size)
        scene = window.add_scene(viewport=viewport, background=background)
        ours = mapper()
        volume = scene.add_volume(ours, data, transfer, association=association, matrix=matrix)
        if callable(look):
            look(scene)
        else:
            scene.look_at(volume, **(look or {}))
        if configure:
            configure(ours)
        if opaque:
            scene.add_opaque(*opaque)
            opaque = (meshes.triangles_of(opaque[0]), opaque[1])
        window.render()
        cells = cells_of(data, association, decompose, matrix)
        return ours, window, scene, self.verify(scene, ours, cells, transfer, label, opaque, background, **options)


def cells_of(data, association="point", decompose=False, matrix=None):
    cells = polyhedra.from_dataset(data, "s", association, decompose)
    return cells if matrix is None else cells.transformed(matrix)


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
