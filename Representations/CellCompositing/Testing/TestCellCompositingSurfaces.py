# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Translucent surfaces in front of, inside and behind the cells, in the right order where the renderer peels volumes."""
import os
import unittest

import numpy as np
from nephoscope_testing import meshes, reference, surfaces
from nephoscope_testing.checks import BLEND_TOLERANCE, ImageTestCase, cells_of, mapper
from nephoscope_testing.compare import edge_mask
from nephoscope_testing.offscreen import Window
from nephoscope_testing.surfaces import sphere
from nephoscope_testing.transfer import random_transfer
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersSources import vtkSphereSource

# VTK's pass keeps what it has peeled in 8 bits and rounds it at every peel, half a step each time.
PEEL_TOLERANCE = 4 / 255
BACKGROUND = (51 / 255, 102 / 255, 204 / 255)
RED, GREEN, BLUE, YELLOW, WHITE = (0.8, 0.2, 0), (0, 0.8, 0.2), (0, 0.2, 0.8), (1, 1, 0), (1, 1, 1)


def sample(seed, count=30, extinction=2.0, offset=(0, 0, 0)):
    rng = np.random.default_rng(seed)
    data = meshes.delaunay(rng, count)
    meshes.with_field(data, meshes.linear_field(rng, data))
    data.SetPoints(meshes.vtk_points(meshes.points_of(data) + offset))
    return data, random_transfer(rng, 5, max_extinction=extinction)


def plane(center, size=1.5, normal=(0.1, 0.2, 1)):
    return surfaces.plane(center, size, normal)


def peel(renderer, peels=50):
    renderer.UseDepthPeelingOn()
    renderer.UseDepthPeelingForVolumesOn()
    renderer.SetMaximumNumberOfPeels(peels)
    renderer.SetOcclusionRatio(0)


class Picture:
    """A window with volumes, translucent surfaces and, where given, one opaque surface."""

    def __init__(self, volumes, layers, opaque=None, background=BACKGROUND, size=(96, 96), look=None, peels=50, **options):
        """volumes: (data, transfer) pairs; layers: (polydata, colour, opacity); opaque: (polydata, colour)."""
        self.volumes, self.layers, self.opaque, self.background = volumes, layers, opaque, background
        self.window = Window(size)
        self.scene = self.window.add_scene(background=background, **options)
        peel(self.scene.renderer, peels)
        self.actors = [self.translucent(*layer) for layer in layers]
        if opaque:
            self.scene.add_opaque(*opaque)
        self.mappers = [mapper() for _ in volumes]
        for ours, (data, transfer) in zip(self.mappers, volumes):
            self.volume = self.scene.add_volume(ours, data, transfer)
        look(self.scene) if callable(look) else self.scene.look_at(volumes[0][0], **(look or {}))

    def translucent(self, polydata, color, opacity):
        actor = self.scene.add_opaque(polydata, color)
        actor.GetProperty().SetOpacity(opacity)
        return actor

    def draw(self):
        self.window.render()
        return self.scene.rgb()

    def expected(self, layers=None):
        layers = [surfaces.Layer(meshes.triangles_of(p), c, o) for p, c, o in layers or self.layers]
        opaque = self.opaque and (meshes.triangles_of(self.opaque[0]), self.opaque[1])
        return surfaces.composite([(cells_of(d), t) for d, t in self.volumes], self.scene.view(), layers, opaque,
                                  self.background)

    def mask(self):
        """Pixels on an edge, where a ray may just miss what the rasterizer just hits."""
        polydata = [layer[0] for layer in self.layers] + ([self.opaque[0]] if self.opaque else [])
        triangles = np.concatenate([meshes.triangles_of(p) for p in polydata])
        edges = [np.stack([triangles, np.roll(triangles, 1, 1)], 2).reshape(-1, 2, 3)]
        edges += [cells_of(data).boundary_edges() for data, _ in self.volumes]
        return edge_mask(np.concatenate(edges), self.scene.view())


class SurfacesTestCase(ImageTestCase):
    def check_picture(self, picture, label, tolerance=PEEL_TOLERANCE, expected=None):
        image = picture.draw()
        expected = picture.expected() if expected is None else expected
        self.fail_on_messages(picture.window, label)
        self.assertEqual(picture.window.gl_errors(), [], label)
        difference = self.check_float(image, expected, label, tolerance, picture.mask())
        self.assertLess(difference.mean, 2 / 255, label)
        return image


class Order(SurfacesTestCase):
    def test_one_surface_in_front_of_inside_and_behind(self):
        for z in (2.0, 0.4, 0.0, -0.4, -2.0):
            for parallel in (False, True):
                far = lambda s: s.look((0, 0, 6), near=1, far=12, parallel_scale=1.6 if parallel else None)
                self.check_picture(Picture([sample(1)], [(plane((0, 0, z), 3), RED, 0.4)], look=far),
                                   f"plane at {z}, parallel {parallel}")

    def test_many_surfaces_that_cut_each_other(self):
        layers = [(plane((0, 0, 0)), RED, 0.4), (plane((0, 0, 0.5), 1.5, (1, 0.2, 0.3)), GREEN, 0.5),
                  (sphere((0.1, -0.1, 0.2), 0.5), BLUE, 0.3), (plane((0, 0, 1.2), 0.7), YELLOW, 0.5)]
        for parallel in (False, True):
            for order in (1, -1):
                picture = Picture([sample(2)], layers[::order], look=dict(parallel=parallel))
                self.check_picture(picture, f"four surfaces, parallel {parallel}, order {order}")
                picture.mappers[0].SetMethodToProjection()
                self.check_picture(picture, f"four surfaces, parallel {parallel}, order {order}, projected")

    def test_with_opaque_geometry(self):
        """The opaque sphere hides what lies behind; in front of the wall VTK's pass alone would lose all but one layer."""
        layers = [(plane((0, 0, z), 3), c, 0.5) for z, c in ((-1.5, RED), (-1.2, GREEN), (0.3, BLUE), (1.6, YELLOW))]
        front = lambda s: s.look((0, 0, 6), near=1, far=14)
        self.check_picture(Picture([sample(3)], layers, (sphere((0.2, 0, 0), 0.5), WHITE), look=front), "sphere")
        self.check_picture(Picture([sample(3)], layers, (plane((0, 0, -2.5), 9), WHITE), look=front), "wall")
        self.check_picture(Picture([sample(3)], layers[:2], (plane((0, 0, -2.5), 9), WHITE), look=front), "all behind")

    def test_many_small_cells(self):
        """Cells of a few pixels, most of which a peel leaves out as a whole."""
        layers = [(plane((0, 0, z)), c, 0.4) for z, c in ((-0.4, RED), (0, GREEN), (0.4, BLUE))]
        picture = Picture([sample(16, 250)], layers + [(sphere((0, 0, 0), 0.6), YELLOW, 0.3)], size=(130, 110))
        self.check_picture(picture, "small cells")
        picture.mappers[0].SetMethodToProjection()
        self.check_picture(picture, "small cells, projected")

    def test_camera_inside(self):
        layers = [(plane((0, 0, z), 2), c, 0.5) for z, c in ((-0.3, RED), (0.1, GREEN))]
        self.check_picture(Picture([sample(4, 40, 1.0)], layers, look=lambda s: s.look(
            (0.1, 0.2, 0.5), (0, 0, -1), angle=60, near=0.02, far=6)), "camera inside")

    def test_viewport_away_from_the_origin(self):
        layers = [(plane((0, 0, 0)), RED, 0.4), (plane((0, 0, 0.4)), GREEN, 0.6)]
        self.check_picture(Picture([sample(5)], layers, size=(160, 96), viewport=(0.4, 0.5, 1, 1)), "viewport")

    def test_several_volumes(self):
        """One behind the other on the screen, a surface between them and one through each."""
        volumes = [sample(7, offset=(0.3, 0.2, -3)), sample(6)]  # drawn in this order
        layers = [(plane((0, 0, z), 4), c, 0.4) for z, c in ((-3, RED), (-1.5, GREEN), (0, BLUE))]
        picture = Picture(volumes, layers, look=lambda s: s.look((0, 0, 6), near=2, far=14))
        self.check_picture(picture, "two volumes")

    def test_lit_as_vtk_lights(self):
        """The colours of a lit sphere are taken from a picture that VTK makes of it alone."""
        smooth = vtkSphereSource()
        smooth.SetRadius(0.6)
        smooth.SetThetaResolution(20)
        smooth.SetPhiResolution(20)
        smooth.Update()
        color = (0.6, 0.3, 0.1)  # the highlight stays below 1: VTK clamps only what it has multiplied by opacity

        def dress(actor, opacity):
            shading = actor.GetProperty()
            shading.LightingOn()
            shading.SetInterpolationToPhong()
            shading.SetSpecular(0.6)
            shading.SetSpecularPower(20)
            shading.BackfaceCullingOn()
            shading.SetOpacity(opacity)

        look = lambda s: s.look((0, 0, 6), near=1, far=12, angle=25)
        alone = Picture([], [(smooth.GetOutput(), color, 1.0)], look=look, background=(0, 0, 0))
        dress(alone.actors[0], 1.0)
        lit = alone.draw()
        self.assertGreater(lit[..., 1].max(), 0.45, "no highlight")
        picture = Picture([sample(8)], [(smooth.GetOutput(), color, 0.5)], look=look)
        dress(picture.actors[0], 0.5)
        view, cells, transfer = picture.scene.view(), cells_of(picture.volumes[0][0]), picture.volumes[0][1]
        hit = surfaces.Layer(meshes.triangles_of(smooth.GetOutput()), color, 0.5).hits(view)[:, 0]
        front = reference.render(cells, view, transfer, hit)
        behind = reference.over(reference.render(cells, view, transfer, begin=np.where(np.isfinite(hit), hit, 1e9)), BACKGROUND)
        veiled = np.isfinite(hit).reshape(behind.shape[:2])[..., None]
        expected = reference.over(front, np.where(veiled, 0.5 * lit + 0.5 * behind, behind))
        self.check_picture(picture, "lit sphere", expected=expected)


class Limits(SurfacesTestCase):
    def test_too_few_peels(self):
        """What is left over is blended without order: near the right picture, and without complaint."""
        layers = [(plane((0, 0, z), 3), c, 0.3) for z, c in
                  ((-0.6, RED), (-0.3, GREEN), (0, BLUE), (0.3, YELLOW), (0.6, RED), (0.9, GREEN), (1.2, BLUE), (1.5, RED))]
        front = lambda s: s.look((0, 0, 6), near=1, far=12)
        means = []
        for peels in (1, 2, 3, 5):
            picture = Picture([sample(9)], layers, look=front, peels=peels)
            image, expected = picture.draw(), picture.expected()
            self.fail_on_messages(picture.window, f"{peels} peels")
            self.assertEqual(picture.window.gl_errors(), [])
            means.append(np.abs(image - expected).mean())
        print("  mean error with 1, 2, 3, 5 peels:", np.round(means, 4))
        self.assertLess(max(means), 0.1)
        self.assertLess(means[-1], 1.5 / 255)

    def test_surfaces_first_without_peeling_of_volumes(self):
        """VTK draws the cells last then, over all surfaces, and the mapper says so once."""
        layers = [(plane((0, 0, z), 3), c, 0.5) for z, c in ((0.0, RED), (1.8, GREEN))]
        for peeling in (False, True):
            picture = Picture([sample(10)], layers, look=lambda s: s.look((0, 0, 6), near=1, far=12))
            renderer = picture.scene.renderer
            renderer.SetUseDepthPeeling(peeling)
            renderer.UseDepthPeelingForVolumesOff()
            picture.volume.VisibilityOff()
            under = picture.draw()
            picture.volume.VisibilityOn()
            picture.draw()
            self.assertIn("the renderer does not peel", *picture.window.messages.all)
            picture.window.messages.clear()
            light = reference.render(cells_of(picture.volumes[0][0]), picture.scene.view(), picture.volumes[0][1])
            self.check_picture(picture, f"peeling {peeling}", BLEND_TOLERANCE, reference.over(light, under))

    def test_single_layer_peeling(self):
        """Where dual peeling is not supported VTK says so, peels surfaces alone, and draws the cells over them, and the mapper says that."""
        os.environ["VTK_USE_LEGACY_DEPTH_PEELING"] = "1"
        self.addCleanup(os.environ.pop, "VTK_USE_LEGACY_DEPTH_PEELING")
        picture = Picture([sample(11)], [(plane((0, 0, 1.8), 3), GREEN, 0.5)],
                          look=lambda s: s.look((0, 0, 6), near=1, far=12))
        picture.draw()
        first, second = picture.window.messages.all
        self.assertIn("DualDepthPeeling is not available", first)
        self.assertIn("the renderer does not peel", second)
        picture.window.messages.clear()
        light = reference.render(cells_of(picture.volumes[0][0]), picture.scene.view(), picture.volumes[0][1])
        under = 0.5 * np.array(GREEN) + 0.5 * np.array(BACKGROUND)
        self.check_picture(picture, "single-layer peeling", PEEL_TOLERANCE, reference.over(light, under))

    def test_no_float_image_of_peels(self):
        picture = Picture([sample(12)], [(plane((0, 0, 0)), RED, 0.5)])
        picture.draw()
        with picture.window.messages as messages:
            self.assertFalse(picture.mappers[0].CopyFloatImage(vtkImageData()))
        self.assertIn("without peeling volumes", messages.all[-1])


class Neighbours(SurfacesTestCase):
    def test_peeling_leaves_no_trace(self):
        """With and without surfaces by turns, and in another size: each picture is as if it were the first."""
        data, transfer = sample(13)
        picture = Picture([(data, transfer)], [(plane((0, 0, 0)), RED, 0.5)])
        peeled = picture.draw()
        picture.actors[0].VisibilityOff()
        bare = picture.draw()
        picture.actors[0].VisibilityOn()
        np.testing.assert_array_equal(picture.draw(), peeled)
        picture.actors[0].VisibilityOff()
        np.testing.assert_array_equal(picture.draw(), bare)
        fresh = Picture([(data, transfer)], [(plane((0, 0, 0)), RED, 0.5)])
        fresh.actors[0].VisibilityOff()
        np.testing.assert_array_equal(fresh.draw(), bare)
        picture.actors[0].VisibilityOn()
        picture.window.window.SetSize(120, 70)
        self.check_picture(picture, "another size")

    def test_other_volumes_and_actors_are_undisturbed(self):
        """A ray-cast image with its own surfaces in one half of the picture: the same whether cells fill the other or not."""
        from vtkmodules.vtkRenderingVolume import vtkGPUVolumeRayCastMapper
        image = vtkImageData()
        image.SetDimensions(9, 9, 9)
        image.SetSpacing(0.25, 0.25, 0.25)
        image.SetOrigin(-3, -1, -1)
        meshes.with_field(image, lambda p: (np.sin(3 * p[:, 0]) * np.cos(2 * p[:, 1]) + 1) / 2)
        layers = [(plane((0, 0, z), 3), c, 0.5) for z, c in ((0.0, RED), (0.6, GREEN))]
        data, transfer = sample(14, offset=(2, 0, 0))
        picture = Picture([(data, transfer)], layers, (sphere((-2, -1.5, 0), 0.3), WHITE), size=(160, 80),
                          look=lambda s: s.look((0, 0, 8), near=1, far=16, angle=35))
        picture.scene.add_volume(vtkGPUVolumeRayCastMapper(), image, transfer)
        both = picture.draw()
        self.fail_on_messages(picture.window)
        picture.volume.VisibilityOff()
        alone = picture.draw()
        np.testing.assert_array_equal(both[:, :70], alone[:, :70])
        self.assertGreater(np.abs(both - alone)[:, 90:].max(), 0.1, "the cells are not drawn")


if __name__ == "__main__":
    unittest.main(verbosity=2)
