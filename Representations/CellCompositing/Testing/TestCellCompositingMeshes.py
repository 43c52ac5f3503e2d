# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Random meshes of every cell type, both projections, point and cell scalars, random transfer functions:
each pixel against the per-ray reference. Seeds are printed; the count is fixed."""
import unittest

import numpy as np
from nephoscope_testing import meshes, polyhedra, reference
from nephoscope_testing.checks import ImageTestCase, cells_of
from nephoscope_testing.compare import Difference
from nephoscope_testing.offscreen import float_image
from nephoscope_testing.transfer import Transfer, random_transfer


def random_look(rng, parallel):
    direction = rng.normal(size=3)
    return dict(direction=direction, up=rng.normal(size=3), parallel=parallel, zoom=1.3, angle=rng.uniform(15, 60))


def divided(made):
    made.SetCellInterpolationToTetrahedra()


class Meshes(ImageTestCase):
    def both_projections(self, seed, label, build, **options):
        """build(rng): a mesh without scalars. Linear point field and constant cell field by turns."""
        for parallel in (False, True):
            for association in ("point", "cell"):
                rng = np.random.default_rng([seed, parallel, association == "cell"])
                data = build(rng)
                meshes.with_field(data, meshes.linear_field(rng, data), association)
                transfer = random_transfer(rng, int(rng.integers(2, 8)), max_extinction=rng.choice([0.3, 2.0, 10.0]))
                name = f"{label} seed {seed} {'parallel' if parallel else 'perspective'} {association}"
                self.check(data, transfer, name, association, look=random_look(rng, parallel), **options)

    def test_one_tetrahedron(self):
        for seed in range(6):
            self.both_projections(seed, "one tetrahedron", lambda r: meshes.tetrahedra(r.normal(size=(4, 3)), [(0, 1, 2, 3)]))

    def test_two_tetrahedra_sharing_a_face(self):
        def pair(rng):
            face = rng.normal(size=(3, 3))
            normal = np.cross(face[1] - face[0], face[2] - face[0])
            side = face.mean(axis=0) + 0.2 * rng.normal(size=(2, 3))
            sign = np.sign((side - face[0]) @ normal)
            side = side + normal / np.linalg.norm(normal) * np.array([[1.0], [-1.0]]) * (1 + np.abs(sign[:, None]))
            return meshes.tetrahedra(np.vstack([face, side]), [(0, 1, 2, 3), (0, 1, 2, 4)])
        for seed in (10, 11, 12):
            self.both_projections(seed, "two tetrahedra", pair)

    def test_delaunay(self):
        for seed, count in ((20, 30), (21, 120)):
            self.both_projections(seed, f"delaunay {count}", lambda r: meshes.delaunay(r, count))

    def test_planar_cells_of_every_type(self):
        for seed, kind in enumerate(("hexahedron", "wedge", "pyramid", "mixed"), 30):
            self.both_projections(seed, kind, lambda r: meshes.Lattice(3).mesh(kind, meshes.projective(r, 0.2)))

    def test_voxels(self):
        self.both_projections(40, "voxel cells", lambda r: meshes.Lattice(3).mesh("voxel"))

    def test_image_data(self):
        self.both_projections(41, "image data", lambda r: meshes.image((4, 3, 2), (0.5, 0.8, 1.1), (-1, 2, 0.3)))

    def test_rectilinear_grid(self):
        def build(rng):
            return meshes.rectilinear([np.cumsum(rng.uniform(0.2, 1, n)) for n in (4, 5, 3)])
        self.both_projections(42, "rectilinear grid", build)

    def test_structured_grid(self):
        self.both_projections(43, "structured grid", lambda r: meshes.structured((3, 4, 2), meshes.projective(r, 0.2)))

    def test_polyhedron(self):
        def dodecahedron(rng):
            g = (1 + 5 ** 0.5) / 2
            points = [(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
            for a in (-1, 1):
                for b in (-1, 1):
                    points += [(0, a / g, b * g), (a / g, b * g, 0), (b * g, 0, a / g)]
            points = np.array(points, float)
            faces = []
            for a in (-1, 1):
                for b in (-1, 1):
                    for normal in ((0, a * g, b), (a * g, b, 0), (b, 0, a * g)):
                        n = np.array(normal)
                        height = points @ n
                        on = np.nonzero(height > height.max() - 1e-9)[0]
                        center = points[on].mean(axis=0)
                        u = points[on[0]] - center
                        v = np.cross(n, u) / np.linalg.norm(n)
                        angle = np.arctan2((points[on] - center) @ v, (points[on] - center) @ u)
                        faces.append(on[np.argsort(angle)])
            return meshes.polyhedron(meshes.projective(rng, 0.1)(points / 4 + 0.5), faces)
        self.both_projections(44, "polyhedron", dodecahedron)

    def test_faces_that_are_not_planar(self):
        """The documented division: coned from the smallest corner by (x, y, z), faces from their own smallest."""
        for seed, kind in enumerate(("hexahedron", "wedge", "pyramid"), 50):
            def build(rng):
                return meshes.Lattice(3).mesh(kind, meshes.wobble(rng, 0.04))
            self.both_projections(seed, f"warped {kind}", build, decompose=True, configure=divided)

    def test_a_field_that_is_not_linear_in_a_hexahedron(self):
        for parallel in (False, True):
            rng = np.random.default_rng([60, parallel])
            data = meshes.with_field(meshes.Lattice(3).mesh("hexahedron", meshes.projective(rng, 0.2)),
                                     lambda p: rng.uniform(0, 1, len(p)))
            self.check(data, random_transfer(rng, 5, max_extinction=3), f"random field seed 60 {parallel}", decompose=True,
                       look=random_look(rng, parallel), configure=divided)

    def test_array_types(self):
        """The scalar array may be of any numeric type."""
        rng = np.random.default_rng(70)
        data = meshes.delaunay(rng, 20)
        values = rng.integers(0, 100, data.GetNumberOfPoints())
        for kind in (np.uint8, np.int16, np.int64, np.float32, np.float64):
            meshes.add_array(data.GetPointData(), values.astype(kind))
            transfer = random_transfer(np.random.default_rng(71), 4, 0, 100, 2.0)
            self.check(data, transfer, f"scalars of type {kind.__name__}")


class TransferFunctions(ImageTestCase):
    def scene(self, seed, extinction):
        rng = np.random.default_rng(seed)
        data = meshes.delaunay(rng, 25)
        meshes.with_field(data, meshes.linear_field(rng, data))
        return data, random_transfer(rng, 8, max_extinction=extinction)

    def test_thin_to_opaque(self):
        for extinction in (1e-3, 0.1, 10.0, 1e3):
            data, transfer = self.scene(80, extinction)
            self.check(data, transfer, f"extinction up to {extinction:g}")

    def test_narrow_peaks(self):
        data, _ = self.scene(81, 1)
        peaks = [(0, 0)] + [p for c in (0.2, 0.5, 0.8) for p in ((c - 0.01, 0), (c, 30), (c + 0.01, 0))] + [(1, 0)]
        self.check(data, Transfer([(0, 1, 0, 0), (0.5, 0, 1, 0), (1, 0, 0, 1)], peaks), "narrow peaks")

    def test_values_outside_the_control_points(self):
        data, _ = self.scene(82, 1)
        transfer = Transfer([(0.3, 1, 0.2, 0), (0.6, 0, 0.5, 1)], [(0.35, 0.2), (0.7, 2.5)])
        self.check(data, transfer, "control points inside the range of the data")

    def test_unit_distance_and_opacity_scale(self):
        data, transfer = self.scene(83, 1.0)
        transfer.unit_distance = 0.25
        self.check(data, transfer, "unit distance 0.25")
        transfer.opacity_scale = 0.5
        self.check(data, transfer, "opacity scale 0.5", configure=lambda m: m.SetOpacityScale(0.5))
        transfer.opacity_scale = 0.0
        self.check(data, transfer, "opacity scale 0", configure=lambda m: m.SetOpacityScale(0.0))

    def test_without_splitting_the_function_is_linear_between_the_ends(self):
        """Off: colour and extinction linear between the segment's ends (one tetrahedron: one segment per ray)."""
        rng = np.random.default_rng(84)
        data = meshes.tetrahedra(rng.normal(size=(4, 3)), [(0, 1, 2, 3)])
        meshes.with_field(data, meshes.linear_field(rng, data))
        transfer = random_transfer(rng, 8, max_extinction=10)
        ours, _, scene, expected = self.check(data, transfer, "not split", split=False,
                                              configure=lambda m: m.SplitAtControlPointsOff())
        exact = reference.render(polyhedra.from_dataset(data), scene.view(), transfer)
        error = Difference(float_image(ours), exact)
        print("  error of not splitting:", error)
        self.assertGreater(error.maximum, 0.01, "this scene must show the difference")

    def test_changes_reach_the_next_picture(self):
        """Transfer function, field and points modified in place."""
        data, transfer = self.scene(85, 2.0)
        ours, window, scene, before = self.check(data, transfer, "before the change")
        volume = scene.renderer.GetVolumes().GetLastProp()
        second = self.scene(86, 3.0)[1]
        volume.SetProperty(second.volume_property())
        self.again(ours, window, scene, data, second, "another property")
        volume.GetProperty().GetScalarOpacity().RemoveAllPoints()
        for row in transfer.opacities:
            volume.GetProperty().GetScalarOpacity().AddPoint(*row)
        second.opacities = transfer.opacities
        self.again(ours, window, scene, data, second, "opacity function edited in place")
        meshes.add_array(data.GetPointData(), np.random.default_rng(5).uniform(0, 1, data.GetNumberOfPoints()))
        data.Modified()
        self.again(ours, window, scene, data, second, "another array of that name")
        data.SetPoints(meshes.vtk_points(meshes.points_of(data) * [1.0, 0.8, 1.1]))
        self.again(ours, window, scene, data, second, "points moved")

    def again(self, ours, window, scene, data, transfer, label):
        window.render()
        self.verify(scene, ours, cells_of(data), transfer, label)


if __name__ == "__main__":
    unittest.main(verbosity=2)
