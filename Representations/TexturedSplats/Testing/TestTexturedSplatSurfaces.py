# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Splats among translucent surfaces, cut by them where the renderer peels volumes; against quadrature along every ray."""
import unittest

import nephoscope
import numpy as np
from nephoscope_testing import meshes, splats, surfaces
from nephoscope_testing.checks import ImageTestCase
from nephoscope_testing.offscreen import Window
from nephoscope_testing.transfer import Transfer
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPlane

# VTK's pass keeps what it has peeled in 8 bits and rounds it at every peel, half a step each time.
PEEL_TOLERANCE = 4 / 255
COLORS = Transfer([(0, 1, 0.2, 0.1), (1, 0.1, 0.3, 1)], [(0, 0.8), (1, 2.5)])
BACKGROUND = (0.2, 0.4, 0.8)
RED, GREEN, WHITE = (0.8, 0.2, 0), (0, 0.8, 0.2), (1, 1, 1)


def quad(z, tilt=0.0, size=9.0):
    points = np.array([(-size, -size, z - tilt), (size, -size, z + tilt), (size, size, z + tilt), (-size, size, z - tilt)], float)
    return meshes.surface(points, [(0, 1, 2), (0, 2, 3)])


def block(count=(2, 2, 2)):
    data = meshes.image(count, (0.7, 0.8, 0.9), (-0.7, -0.8, -0.9))
    return meshes.with_field(data, lambda p: (np.sin(3 * p[:, 0]) * np.cos(2 * p[:, 1] + p[:, 2]) + 1) / 2)


def render_splats(data, transfer):
    points = meshes.points_of(data)
    jacobians = splats.lattice_jacobians(points, data.GetDimensions())
    values = np.array([data.GetPointData().GetArray("s").GetValue(i) for i in range(len(points))])
    extinctions = transfer.extinction(values) * splats.lattice_shares(data.GetDimensions())
    return lambda view, begin, end: splats.render(view, points, jacobians, transfer.color(values), extinctions, end, begin)


class Picture:
    def __init__(self, data, layers, opaque=None, look=None, peels=True, configure=None, size=(44, 40), transfer=COLORS):
        self.layers, self.opaque, self.data, self.transfer = layers, opaque, data, transfer
        self.window = Window(size)
        self.scene = self.window.add_scene(background=BACKGROUND)
        renderer = self.scene.renderer
        renderer.SetUseDepthPeeling(peels)
        renderer.SetUseDepthPeelingForVolumes(peels)
        renderer.SetMaximumNumberOfPeels(50)
        renderer.SetOcclusionRatio(0)
        self.actors = []
        for polydata, color, opacity in layers:
            self.actors.append(self.scene.add_opaque(polydata, color))
            self.actors[-1].GetProperty().SetOpacity(opacity)
        if opaque:
            self.scene.add_opaque(*opaque)
        self.mapper = nephoscope.vtkTexturedSplatMapper()
        if configure:
            configure(self.mapper)
        self.scene.add_volume(self.mapper, data, transfer)
        (look or (lambda s: s.look((1.1, 0.7, 8), near=1, far=14)))(self.scene)

    def draw(self):
        self.window.render()
        return self.scene.rgb()

    def expected(self):
        layers = [surfaces.Layer(meshes.triangles_of(p), c, o) for p, c, o in self.layers]
        opaque = self.opaque and (meshes.triangles_of(self.opaque[0]), self.opaque[1])
        return surfaces.composite([render_splats(self.data, self.transfer)], self.scene.view(), layers, opaque, BACKGROUND)


class Surfaces(ImageTestCase):
    def check_picture(self, picture, label, tolerance=PEEL_TOLERANCE):
        image = picture.draw()
        self.fail_on_messages(picture.window, label)
        self.assertEqual(picture.window.gl_errors(), [], label)
        self.check_float(image, picture.expected(), label, tolerance)
        return image

    def test_in_front_of_inside_and_behind(self):
        for z in (2.5, 0.9, 0.0, -0.43, -3.0):
            for parallel in (False, True):
                look = lambda s: s.look((1.1, 0.7, 8), near=1, far=14, parallel_scale=2 if parallel else None)
                self.check_picture(Picture(block(), [(quad(z, 0.2), RED, 0.5)], look=look), f"surface at {z}, parallel {parallel}")

    def test_several_and_opaque(self):
        layers = [(quad(z, t), c, 0.4) for z, t, c in ((-0.8, 0.5, RED), (0.1, 0, GREEN), (0.5, -0.4, WHITE), (2, 0, RED))]
        self.check_picture(Picture(block(), layers), "four surfaces")
        self.check_picture(Picture(block(), layers, (quad(-0.5, 1.5), WHITE)), "and something opaque")

    def test_ways_of_drawing(self):
        """Far splats as points, near ones as parallelograms, those around the eye over the viewport; cut in each."""
        layers = [(quad(0.3, 0.4), RED, 0.5), (quad(-0.4), GREEN, 0.3)]
        far = lambda s: s.look((41, 26, 300), near=280, far=330, angle=0.9)
        near = lambda s: s.look((0.4, 0.3, 2.6), (0, 0, 0), angle=70, near=0.05, far=9)
        inside = lambda s: s.look((0.1, 0.2, 0.55), (-0.3, 0.1, -1), angle=70, near=0.01, far=9)
        for label, look in (("far", far), ("near", near), ("eye inside", inside)):
            self.check_picture(Picture(block(), layers, look=look), label)

    def test_a_surface_that_is_hardly_there(self):
        """Whatever is drawn: beside a surface of an opacity of 1/255 the picture is the one without it."""
        data = block((4, 4, 4))
        rng = np.random.default_rng(3)
        meshes.add_array(data.GetPointData(), rng.normal(size=(data.GetNumberOfPoints(), 3)), "v")
        cases = {"splats": None, "quadratic": lambda m: m.SetKernelToQuadratic(), "gaussian": lambda m: m.SetKernelToGaussian(),
                 "hierarchy": lambda m: m.SetErrorTolerance(0.5), "streaks": splats.with_vectors(0, 0), "segments": splats.with_vectors(1, 0),
                 "streaks in layers": splats.with_vectors(0, 1), "segments in layers": splats.with_vectors(1, 1)}
        look = lambda s: s.look((3, 2, 9), (0.7, 0.8, 0.9), near=1, far=20)
        for label, configure in cases.items():
            plain = Picture(data, [], look=look, peels=False, configure=configure)
            peeled = Picture(data, [(quad(0.8, 0.5), BACKGROUND, 1 / 255)], look=look, configure=configure)
            expected, image = plain.draw(), peeled.draw()
            self.fail_on_messages(peeled.window, label)
            self.assertGreater(np.abs(expected - BACKGROUND).max(), 0.2, label)
            error = np.abs(image - expected)
            print(f"  {label}: {255 * error.max():.1f}/255, mean {255 * error.mean():.2f}/255")
            # Splats whose parts before and behind the surface change places: a few splats at a few pixels.
            self.assertLess(error.mean(), 1.5 / 255, label)
            self.assertLess(np.quantile(error, 0.99), 8 / 255, label)

    def test_beside_a_cloud_texture(self):
        """The suite's own translucent surface, at the other side of the picture: the splats are what they are alone."""
        look = lambda s: s.look((1.5, 0, 9), (1.5, 0, 0), near=1, far=14, angle=40)
        alone = Picture(block(), [], look=look).draw()
        picture = Picture(block(), [], look=look)
        sheet = meshes.surface(np.array([(2.5, -1, 0), (4, -1, 0), (4, 1, 0.5), (2.5, 1, 0.5)], float), [(0, 1, 2), (0, 2, 3)])
        actor = picture.scene.add_opaque(sheet, WHITE)
        cloud = nephoscope.vtkCloudTextureMapper()
        cloud.SetInputData(sheet)
        cloud.ScalarVisibilityOff()
        actor.SetMapper(cloud)
        image = picture.draw()
        self.fail_on_messages(picture.window)
        changed = np.abs(image - alone).max(axis=2) > 2.5 / 255
        columns = np.flatnonzero(changed.any(axis=0))
        self.assertGreater(len(columns), 3, "no cloud")
        self.assertGreater(columns.min(), 24)

    def test_with_clipping_planes(self):
        plane = vtkPlane()
        plane.SetOrigin(0.1, 0, 0.2)
        plane.SetNormal(0.6, 0.2, -1)
        picture = Picture(block(), [(quad(0.3, 0.4), RED, 0.5)], configure=lambda m: m.AddClippingPlane(plane))
        from nephoscope_testing import reference
        first, last = reference.between_planes(picture.scene.view(), [(plane.GetOrigin(), plane.GetNormal())])
        whole = render_splats(picture.data, picture.transfer)
        clipped = lambda view, begin, end: whole(view, np.maximum(begin, first), np.maximum(np.minimum(end, last), np.maximum(begin, first)))
        layers = [surfaces.Layer(meshes.triangles_of(p), c, o) for p, c, o in picture.layers]
        expected = surfaces.composite([clipped], picture.scene.view(), layers, None, BACKGROUND)
        image = picture.draw()
        self.fail_on_messages(picture.window)
        self.check_float(image, expected, "surface and plane", PEEL_TOLERANCE)

    def test_with_haze_and_clipping_planes(self):
        """All three at once: beside a surface that is hardly there the picture is the one without it."""
        plane = vtkPlane()
        plane.SetOrigin(0.1, 0, 0.2)
        plane.SetNormal(0.6, 0.2, -1)
        pictures = []
        for layers in ([], [(quad(0.3, 0.4), BACKGROUND, 1 / 255)]):
            picture = Picture(block(), layers, peels=bool(layers), configure=lambda m: m.AddClippingPlane(plane))
            haze = nephoscope.vtkHaze()
            haze.SetProjectionToMap()
            haze.SetBaseLevel(-2)
            haze.SetScaleHeight(1)
            haze.SetExtinction(0.15)
            nephoscope.vtkHaze.SetHaze(picture.scene.renderer, haze)
            pictures.append(picture.draw())
            self.fail_on_messages(picture.window)
        error = np.abs(pictures[1] - pictures[0])
        print(f"  haze and plane: {255 * error.max():.1f}/255")
        self.assertGreater(np.ptp(pictures[0], axis=(0, 1)).max(), 0.2)
        self.assertLess(error.mean(), 1.5 / 255)
        self.assertLess(np.quantile(error, 0.99), 5 / 255)

    def test_peeling_leaves_no_trace(self):
        picture = Picture(block(), [(quad(0.0), RED, 0.5)])
        peeled = picture.draw()
        with picture.window.messages as messages:
            self.assertFalse(picture.mapper.CopyFloatImage(vtkImageData()))
        self.assertIn("without peeling volumes", messages.all[-1])
        picture.window.messages.clear()
        picture.actors[0].VisibilityOff()
        bare = picture.draw()
        picture.actors[0].VisibilityOn()
        np.testing.assert_array_equal(picture.draw(), peeled)
        fresh = Picture(block(), [])
        np.testing.assert_array_equal(fresh.draw(), bare)
        picture.window.window.SetSize(60, 38)
        self.check_picture(picture, "another size")


if __name__ == "__main__":
    unittest.main()
