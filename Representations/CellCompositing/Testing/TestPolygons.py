# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Polygons of the input between its cells: those of vtkContourCellSplitter, composited with the pieces in one order.

The reference is a ray through the cells before they were divided, with the surfaces where the scalar has their values."""
import unittest

import nephoscope
import numpy as np
from nephoscope_testing import contours, meshes
from nephoscope_testing.checks import SHIFTS, ImageTestCase, cells_of, forgive_shift, mapper
from nephoscope_testing.compare import Difference, edge_mask
from nephoscope_testing.contours import Surface
from nephoscope_testing.offscreen import Window, float_image
from nephoscope_testing.transfer import Transfer, constant, random_transfer
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import VTK_LINE, VTK_QUAD, VTK_TRIANGLE, vtkDataObject
from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource

SHADING = (0.1, 0.7, 0.2, 10)  # defaults of vtkVolumeProperty
CLEAR = Transfer([(0, 1, 0.5, 0), (1, 0, 0.5, 1)], [(0, 0), (1, 0)])
RED = (1, 0, 0)


def split(data, values):
    splitter = nephoscope.vtkContourCellSplitter()
    splitter.SetInputDataObject(data)
    splitter.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, "s")
    for i, value in enumerate(values):
        splitter.SetValue(i, value)
    splitter.Update()
    return splitter.GetOutputDataObject(0)


def part(grid, which):
    """The cells of a grid for which `which(ContourIndex)` holds, in a grid with points of its own and no ContourIndex."""
    index = vtk_to_numpy(grid.GetCellData().GetArray("ContourIndex"))
    kinds = []
    for i in np.flatnonzero(which(index)):
        cell = grid.GetCell(int(i))  # the same object for all
        kinds.append((cell.GetCellType(), [cell.GetPointId(k) for k in range(cell.GetNumberOfPoints())]))
    result = meshes.grid(meshes.points_of(grid), kinds)
    meshes.add_array(result.GetPointData(), vtk_to_numpy(grid.GetPointData().GetArray("s")))
    return result


def appended(*grids):
    append = vtkAppendFilter()
    for grid in grids:
        append.AddInputData(grid)
    append.Update()
    return append.GetOutput()


def linear_mesh(seed, count=80):
    rng = np.random.default_rng([61, seed])
    data = meshes.delaunay(rng, count)
    return rng, meshes.with_field(data, meshes.linear_field(rng, data))


class PolygonTestCase(ImageTestCase):
    def scene(self, data, transfer, configure=None, look=None, association="point", size=(96, 96)):
        window = Window(size)
        scene = window.add_scene()
        ours = mapper()
        volume = scene.add_volume(ours, data, transfer, association=association)
        scene.look_at(volume, **(look or {}))
        ours.ContourLightingOff()
        if configure:
            configure(ours)
        return window, scene, ours

    def draw(self, *arguments, **options):
        window, scene, ours = self.kept = self.scene(*arguments, **options)
        window.render()
        self.fail_on_messages(window)
        return float_image(ours), scene.view()

    def compare(self, image, draw, view, edges, label, tolerance=1e-4):
        expected, mask = draw(view), edge_mask(edges, view)
        if Difference(image, expected, mask).maximum > tolerance:
            image = forgive_shift(image, expected, [draw(view.shifted(*s)) for s in SHIFTS], label)
        self.check_float(image, expected, label, tolerance, mask)


def dress(ours, surfaces):
    for i, surface in enumerate(surfaces):
        ours.SetPolygonOpacity(i, surface.opacity)
        if surface.color:
            ours.SetPolygonColor(i, *surface.color)


class OfTheSplitter(PolygonTestCase):
    def test_random_meshes(self):
        """Clear and in a medium, lit and not, both projections, one surface hidden, the middle layer with a function of its own."""
        for seed in range(4):
            rng, data = linear_mesh(seed)
            values, parallel = np.sort(rng.uniform(0.15, 0.85, 3)), seed % 2 == 0
            pieces = split(data, values)
            transfer = CLEAR if seed == 0 else random_transfer(rng, 4)
            layers = {1: random_transfer(rng, 4)} if seed else None
            surfaces = [Surface(v, o, c, SHADING if parallel else None)
                        for v, o, c in zip(values, (0.5, 0 if seed == 1 else 1 if seed == 2 else 0.4, 0.7), (None, RED, None))]

            def configure(ours):
                dress(ours, surfaces)
                ours.SetContourLighting(parallel)
                ours.SmoothContourNormalsOff()
                if layers:
                    ours.SetLayerArrayName("Layer")
                    ours.SetLayerProperty(1, layers[1].volume_property())
            image, view = self.draw(pieces, transfer, configure, dict(direction=rng.normal(size=3), parallel=parallel))
            cells = cells_of(data)
            edges = cells_of(part(pieces, lambda index: index < 0), decompose=True).drawn_edges()
            self.compare(image, lambda v: contours.render(cells, v, transfer, surfaces, layers=layers), view, edges, f"split mesh {seed}")

    def test_appended_polygons(self):
        """Points of their own and no ContourIndex: all polygons are asked for, and the order of the cells does not matter."""
        rng, data = linear_mesh(9)
        pieces = split(data, [0.4, 0.7])
        solid, polygons = part(pieces, lambda index: index < 0), part(pieces, lambda index: index >= 0)
        transfer = random_transfer(rng, 4)
        whole, view = self.draw(pieces, transfer, lambda m: m.SetPolygonOpacity(0.6))

        def configure(ours):
            ours.SetPolygonsToAll()
            ours.SetPolygonOpacity(0.6)
        for label, data in (("polygons last", appended(solid, polygons)), ("polygons first", appended(polygons, solid))):
            image, _ = self.draw(data, transfer, configure)
            self.check_float(image, whole, label, 1e-5, edge_mask(cells_of(solid, decompose=True).drawn_edges(), view))
            plain, _ = self.draw(data, transfer, lambda m: m.SetPolygonsToNone())
            self.assertGreater(np.abs(plain - whole).max(), 0.1)

    def test_smooth_normals(self):
        """On a ball: nearer to the light of the true normal than facets are."""
        data = meshes.with_field(meshes.Lattice(14).mesh("tetra"), lambda p: np.linalg.norm(p - 0.5, axis=1))
        pieces, errors = split(data, [0.35]), []
        for smooth in (True, False):
            def configure(ours):
                ours.ContourLightingOn()
                ours.SetSmoothContourNormals(smooth)
                ours.SetPolygonOpacity(1.0)
                ours.SetPolygonColor(0, 1, 1, 1)
            image, view = self.draw(pieces, CLEAR, configure, dict(direction=(0, 0, 1), parallel=True))
            y, x = np.mgrid[0:96, 0:96]
            origins, directions, _, _ = view.rays()
            offset = origins - 0.5
            square = (offset ** 2).sum(axis=1) - (offset * directions).sum(axis=1) ** 2
            towards = np.sqrt(np.clip(1 - square / 0.35 ** 2, 0, 1)).reshape(96, 96)
            inside = square.reshape(96, 96) < 0.3 ** 2
            light = np.minimum(SHADING[0] + SHADING[1] * towards + SHADING[2] * towards ** SHADING[3], 1)
            errors.append(np.abs(image[..., 0] - light)[inside].mean())
        print(f"  error of light on a ball: smooth {errors[0]:.4f}, flat {errors[1]:.4f}")
        self.assertLess(errors[0], 0.02)
        self.assertLess(errors[0], 0.6 * errors[1])


class OfFaces(PolygonTestCase):
    LOOK = dict(direction=(0.02, 0.03, 1), parallel=True)

    def stack(self, count=4):
        """Boxes one on the other, with a square between the second and the third, and one on either end."""
        lattice = meshes.Lattice((1, 1, count)).mesh("hexahedron")
        points = meshes.points_of(lattice)
        cells = [(lattice.GetCellType(i), [lattice.GetCell(i).GetPointId(k) for k in range(8)]) for i in range(count)]
        for z in (0, 0.5, 1):
            corner = lambda x, y: int(np.flatnonzero((points == (x, y, z)).all(axis=1))[0])
            cells.append((VTK_QUAD, [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)]))
        data = meshes.grid(points, cells)
        return meshes.with_field(data, lambda p: p[:, 2])

    def test_squares(self):
        """Closed form from both sides: each square once, at its place between the boxes; cells of a colour of their own too."""
        data = self.stack()
        transfer = Transfer([(0, 0, 0, 1), (1, 0, 0, 1)], [(0, 1), (1, 1)])
        for side in (1, -1):
            def configure(ours):
                ours.SetPolygonsToAll()
                ours.SetPolygonOpacity(0.25)
                ours.SetPolygonColor(-1, *RED)
            look = dict(self.LOOK, direction=(0.02, 0.03, side))
            image, view = self.draw(data, transfer, configure, look)
            half = 0.5 * np.sqrt(1 + 0.02 ** 2 + 0.03 ** 2)
            clear = np.exp(-half)
            red = 0.25 * (1 + 0.75 * clear + 0.75 ** 2 * clear ** 2)
            blue = 0.75 * (1 - clear) * (1 + 0.75 * clear)
            np.testing.assert_allclose(image[48, 48], [red, 0, blue, 1 - 0.75 ** 3 * clear ** 2], atol=2e-6)
        meshes.add_array(data.GetCellData(), np.array([0, 0, 0, 0, 1.0, 1, 1]), "s")
        coloured = Transfer([(0, 0, 0, 1), (1, 1, 0, 0)], [(0, 1), (1, 1)])
        image, _ = self.draw(data, coloured, lambda m: (m.SetPolygonsToAll(), m.SetPolygonOpacity(0.25)), look, association="cell")
        np.testing.assert_allclose(image[48, 48], [red, 0, blue, 1 - 0.75 ** 3 * clear ** 2], atol=2e-6)

    def test_eyes_anywhere(self):
        """Along an axis, in a plane of the grid, beside edges, and inside: each square that the ray passes once."""
        data = self.stack()
        transfer = constant(0.0)
        configure = lambda m: (m.SetPolygonsToAll(), m.SetPolygonOpacity(0.25))
        window, scene, ours = self.scene(data, transfer, configure)
        for direction in ((0, 0, 1), (0, 0, -1), (0.1, 0, 1), (0, -0.2, 1)):
            scene.look_at((0, 1, 0, 1, 0, 1), direction, (0, 1, 0), parallel=True)
            window.render()
            count = np.log1p(-float_image(ours)[44:52, 44:52, 3]) / np.log(0.75)
            np.testing.assert_allclose(count, 3, atol=1e-4, err_msg=f"from {direction}")
            self.assertEqual(ours.GetNumberOfRayLayers(), 1)
            scene.camera.ParallelProjectionOff()
        for eye, up, down in (((0.4, 0.3, 0.3), 2, 1), ((0.5, 0.5, 0.25), 2, 1), ((0.5, 0.5, 0.75), 1, 2), ((0.2, 0.5, 0.6), 1, 2)):
            for side, expected in ((1, up), (-1, down)):
                scene.look(eye, np.add(eye, (0, 0, side)), (0, 1, 0), 10, near=1e-3, far=10)
                window.render()
                count = np.log1p(-float_image(ours)[..., 3]) / np.log(0.75)
                np.testing.assert_allclose(count, expected, atol=1e-4, err_msg=f"at {eye} towards {side}")
        self.fail_on_messages(window)

    def test_where_values_jump(self):
        """Between blocks with points and values of their own."""
        points = np.array([(x, y, z) for z in (0, 1, 1, 2) for y in (0, 1) for x in (0, 1)], float)
        cube = [0, 1, 3, 2, 4, 5, 7, 6]
        data = meshes.grid(points, [(12, cube), (12, [8 + i for i in cube]), (VTK_QUAD, [4, 5, 7, 6])])
        meshes.with_field(data, lambda p: np.where(np.arange(16) < 8, 0.2, 0.9))
        for side in (1, -1):
            for lighting in (False, True):
                image, _ = self.draw(data, constant(0.0), lambda m: (m.SetPolygonsToAll(), m.SetPolygonOpacity(0.25), m.SetContourLighting(lighting)),
                                     dict(self.LOOK, direction=(0.02, 0.03, side)))
                self.assertAlmostEqual(image[48, 48, 3], 0.25, places=5)

    def test_opaque_geometry_hides_them(self):
        """A ball between the second and the third square leaves two of three."""
        ball = vtkSphereSource()
        ball.SetCenter(0.5, 0.5, 0.75)
        ball.SetRadius(0.2)
        ball.Update()
        for side, squares in ((1, 1), (-1, 2)):
            window, scene, ours = self.scene(self.stack(), constant(0.0), lambda m: (m.SetPolygonsToAll(), m.SetPolygonOpacity(0.5)),
                                             dict(self.LOOK, direction=(0.02, 0.03, side)))
            scene.add_opaque(ball.GetOutput(), (0, 1, 0))
            window.render()
            self.assertAlmostEqual(float_image(ours)[48, 48, 3], 1 - 0.5 ** squares, places=5)

    def test_changes_are_drawn(self):
        window, scene, ours = self.scene(self.stack(), constant(0.0), lambda m: (m.SetPolygonsToAll(), m.SetPolygonOpacity(0.5)), self.LOOK)
        look = lambda: (window.render(), float_image(ours)[48, 48, 3])[1]
        self.assertAlmostEqual(look(), 1 - 0.5 ** 3, places=5)
        ours.SetPolygonOpacity(0, 0.25)
        self.assertAlmostEqual(look(), 1 - 0.75 ** 3, places=5)
        self.assertAlmostEqual(ours.GetPolygonOpacity(0), 0.25)
        self.assertAlmostEqual(ours.GetPolygonOpacity(7), 0.5)
        ours.SetPolygonsToNone()
        self.assertAlmostEqual(look(), 0, places=6)
        self.assertEqual(ours.GetNumberOfDrawnTetrahedra(), 0)
        ours.SetPolygonsToAll()
        self.assertAlmostEqual(look(), 1 - 0.75 ** 3, places=5)
        self.fail_on_messages(window)

    def test_faces_of_cycles(self):
        """Faces of tetrahedra that hide one another in a cycle. Rays draw them where projection is asked for, which cannot."""
        from TestCellCompositingOrder import cyclic_ring
        ring = cyclic_ring()
        kinds = [(ring.GetCellType(i), [ring.GetCell(i).GetPointId(k) for k in range(4)]) for i in range(ring.GetNumberOfCells())]
        faces = [(VTK_TRIANGLE, [ids[k] for k in range(4) if k != i]) for _, ids in kinds for i in range(4)]
        data = meshes.with_field(meshes.grid(meshes.points_of(ring), kinds + faces), lambda p: 0 * p[:, 0])

        def configure(ours):
            ours.SetPolygonsToAll()
            ours.SetPolygonOpacity(0.25)
            ours.SetMethodToProjection()
            ours.SetPolygonColor(-1, *RED)
        image, view = self.draw(data, constant(0.0), configure, dict(direction=(0, 0, 1)))
        window, _, ours = self.kept
        self.assertGreater(ours.GetNumberOfRayLayers(), 0)
        cells = cells_of(ring_with_values(ring))
        distinct = {tuple(sorted(ids)): None for _, ids in faces}  # two tetrahedra that touch have one face
        alpha = 1 - 0.75 ** hits(meshes.points_of(ring)[list(distinct)], view).reshape(96, 96).astype(float)
        expected = np.stack([alpha, 0 * alpha, 0 * alpha, alpha], axis=2)
        self.check_float(image, expected, "faces of a cycle", 1e-4, edge_mask(cells.drawn_edges(), view))

    def test_between_peeled_surfaces(self):
        """A translucent ball cuts the squares: as the mapper's own contour at the same place."""
        pictures = []
        for polygons in (True, False):
            data = self.stack()
            window, scene, ours = self.scene(data, constant(0.3), None, dict(direction=(0.3, 0.5, 1)))
            if polygons:
                ours.SetPolygonsToAll()
                ours.SetPolygonColor(-1, *RED)
                ours.SetPolygonOpacity(0.6)
            else:
                ours.SetPolygonsToNone()
                for i, value in enumerate((1e-6, 0.5, 1 - 1e-6)):
                    ours.SetContourValue(i, value)
                    ours.SetContourColor(i, *RED)
                    ours.SetContourOpacity(i, 0.6)
            ball = vtkSphereSource()
            ball.SetCenter(0.5, 0.5, 0.5)
            ball.SetRadius(0.4)
            ball.SetPhiResolution(40)
            ball.SetThetaResolution(40)
            ball.Update()
            scene.add_opaque(ball.GetOutput(), (0, 1, 0)).GetProperty().SetOpacity(0.5)
            scene.renderer.UseDepthPeelingOn()
            scene.renderer.UseDepthPeelingForVolumesOn()
            scene.renderer.SetMaximumNumberOfPeels(50)
            scene.renderer.SetOcclusionRatio(0)
            window.render()
            self.fail_on_messages(window)
            pictures.append(scene.rgb())
        different = (np.abs(pictures[0] - pictures[1]).max(axis=2) > 3 / 255).mean()
        print(f"  polygons and contours between peeled surfaces: {different:.3%} of the pixels differ")
        self.assertLess(different, 0.005)
        self.assertGreater(pictures[0].max(), 0.3)


def hits(triangles, view):
    """How many triangles the ray of each pixel crosses."""
    origins, directions, _, _ = view.rays()
    count = np.zeros(len(origins), int)
    for a, b, c in triangles:
        sides = [np.einsum("ij,ij->i", np.cross(q - p, p - origins), directions) for p, q in ((a, b), (b, c), (c, a))]
        count += (np.sign(sides[0]) == np.sign(sides[1])) & (np.sign(sides[1]) == np.sign(sides[2]))
    return count


def ring_with_values(ring):
    return meshes.with_field(ring, lambda p: 0 * p[:, 0])


class Messages(PolygonTestCase):
    def said(self, data, configure=None):
        window, _, _ = self.scene(data, constant(), configure, size=(16, 16))
        window.render()
        window.render()
        return [str(m).split("): ", 1)[1] for m in window.messages.all]

    def test_polygons_that_were_not_asked_for(self):
        data = OfFaces.stack(self)
        said = self.said(data)
        self.assertEqual(len(said), 1, said)
        self.assertIn("3 polygons are not drawn: call SetPolygonsToAll()", said[0])
        self.assertEqual(self.said(data, lambda m: m.SetPolygonsToNone()), [])
        self.assertEqual(self.said(data, lambda m: m.SetPolygonsToAll()), [])

    def test_polygons_in_no_face(self):
        data = OfFaces.stack(self)
        points = meshes.points_of(data)
        far = [int(np.flatnonzero((points == p).all(axis=1))[0]) for p in ((0, 0, 0), (1, 0, 0.5), (1, 1, 1))]
        data.InsertNextCell(VTK_TRIANGLE, 3, far)
        data.InsertNextCell(VTK_LINE, 2, far[:2])
        said = self.said(data, lambda m: m.SetPolygonsToAll())
        self.assertEqual(len(said), 2, said)
        self.assertTrue(any("1 polygon is not drawn: it does not lie in faces of cells" in m for m in said), said)
        self.assertTrue(any("1 cell is not drawn" in m for m in said), said)

    def test_earlier_methods_say_so(self):
        for method in ("Faces", "TrianglesTable"):
            said = self.said(OfFaces.stack(self), lambda m: (m.SetPolygonsToAll(), getattr(m, "SetMethodTo" + method)()))
            self.assertEqual(len(said), 1, said)
            self.assertIn("without the polygons: choose another method", said[0])


if __name__ == "__main__":
    unittest.main(verbosity=2)
