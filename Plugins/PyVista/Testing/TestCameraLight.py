# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Light that follows the camera (eye='camera'): single scattering against closed forms from any side, and the same picture as light computed for one eye, of cells and of splats."""
import unittest

import nephoscope
import numpy as np
import pyvista
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPiecewiseFunction
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkRenderer, vtkRenderWindow, vtkVolume

pyvista.OFF_SCREEN = True
G = 0.6
BRIGHTEST = 64.0  # that is drawn
ONCE = {"multiple_scattering": False, "sky_light": 0, "albedo": 0.9, "asymmetry": G, "eye": "camera"}


def slab(depth, across=1000.0, cells=(5, 5, 41)):
    """Level cloud of thickness 1 from z = 0, so wide that no ray leaves it through a side."""
    grid = pyvista.ImageData(dimensions=cells, spacing=(across / (cells[0] - 1), across / (cells[1] - 1), 1 / (cells[2] - 1)), origin=(-across / 2, -across / 2, 0))
    grid["Extinction"] = np.full(grid.n_points, float(depth))
    return grid


def phase(cosine, g=G):
    return (1 - g**2) / (1 + g**2 - 2 * g * cosine) ** 1.5


def unit(vector):
    return np.array(vector, float) / np.linalg.norm(vector)


def single(depth, sun, along, start=None, albedo=0.9):
    """pi times the radiance from a slab seen in the direction `along`, by one scattering; from outside, or from a height within."""
    sun, along = unit(sun), unit(along)
    z0 = (1.0 if along[2] < 0 else 0.0) if start is None else start
    length = (z0 if along[2] < 0 else 1 - z0) / abs(along[2])
    t = np.linspace(0, length, 20001)
    z = z0 + t * along[2]
    source = depth * np.exp(-depth * t - depth * (1 - z) / sun[2])
    return albedo / 4 * phase(along @ sun) * np.sum((source[1:] + source[:-1]) / 2) * (t[1] - t[0])


def light_seen(mesh, eye, middle, size=(21, 21), up=(0.1, 1, 0.2), parallel=None, angle=20, trilinear=False, clip=(1e-3, 1e4), splats=False, tolerance=0.0, haze=None):
    """The light in every pixel, in floating point; `mesh` has light, for splats on points or on cells."""
    window, renderer, volume = vtkRenderWindow(), vtkRenderer(), vtkVolume()
    mapper = nephoscope.vtkTexturedSplatMapper() if splats else nephoscope.vtkCellCompositingMapper()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(*size)
    window.AddRenderer(renderer)
    mapper.SetInputData(mesh)
    if trilinear:
        mapper.SetCellInterpolationToTrilinear()
    on_cells = "Sunlight" in mesh.cell_data
    if on_cells:
        mapper.SetScalarModeToUseCellFieldData()
    else:
        mapper.SetScalarModeToUsePointFieldData()
    if tolerance:
        mapper.SetErrorTolerance(tolerance)
    mapper.SelectScalarArray("Sunlight")
    mapper.SetOpacityArrayName("ScaledExtinction")
    volume.SetMapper(mapper)
    densest = float(mesh["ScaledExtinction"].max())
    colours = vtkColorTransferFunction()
    colours.AddRGBPoint(0, 0, 0, 0)
    colours.AddRGBPoint(BRIGHTEST, 1, 1, 1)
    opacity = vtkPiecewiseFunction()
    opacity.AddPoint(0, 0)
    opacity.AddPoint(densest, 1)
    volume.GetProperty().SetColor(colours)
    volume.GetProperty().SetScalarOpacity(opacity)
    volume.GetProperty().SetScalarOpacityUnitDistance(1 / densest)
    renderer.AddVolume(volume)
    if haze:
        nephoscope.vtkHaze.SetHaze(renderer, haze)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(*eye)
    camera.SetFocalPoint(*middle)
    camera.SetViewUp(*up)
    camera.SetViewAngle(angle)
    if parallel:
        camera.SetParallelProjection(True)
        camera.SetParallelScale(parallel)
    camera.SetClippingRange(*clip)
    window.Render()
    image = vtkImageData()
    assert mapper.CopyFloatImage(image)
    light = BRIGHTEST * vtk_to_numpy(image.GetPointData().GetArray("RGBA")).reshape(size[1], size[0], 4)[..., 0].astype(float)
    window.Finalize()
    return light


class SingleScattering(unittest.TestCase):
    def test_slab_from_any_side(self):
        """Above and below, along the sun and against it, perspective and parallel."""
        sun = (0.6, 0, 0.8)
        lit = slab(0.8).nephoscope.sunlight(sun, **ONCE)
        for towards in ((0, 0, 1), (0.6, 0, 0.8), (-0.6, 0, 0.8), (0, 0.8, 0.6), (0, 0, -1), (-0.6, 0, -0.8), (0.6, 0.3, -0.8), (0.8, 0, -0.6)):
            eye = 5 * unit(towards) + (0, 0, 0.5)
            expected = single(0.8, sun, -unit(towards))
            for parallel in (None, 0.5):
                with self.subTest(towards=towards, parallel=parallel):
                    found = light_seen(lit, eye, (0, 0, 0.5), parallel=parallel)[10, 10]
                    self.assertAlmostEqual(found, expected, delta=5e-3 * expected)

    def test_trilinear_cells(self):
        """The slab as a grid and as unstructured hexahedra."""
        sun = (0.6, 0, 0.8)
        grid = slab(0.8, 50.0).cast_to_structured_grid()
        for mesh in (grid, grid.cast_to_unstructured_grid()):
            lit = mesh.nephoscope.sunlight(sun, **ONCE)
            for towards in ((0.6, 0, 0.8), (0, 0.8, 0.6), (-0.6, 0, -0.8), (0.6, 0.3, -0.8)):
                with self.subTest(mesh=type(mesh).__name__, towards=towards):
                    eye = 5 * unit(towards) + (0.1, 0.2, 0.5)
                    found = light_seen(lit, eye, (0.1, 0.2, 0.5), trilinear=True)[10, 10]
                    expected = single(0.8, sun, -unit(towards))
                    self.assertAlmostEqual(found, expected, delta=5e-3 * expected)

    def test_eye_in_the_cloud(self):
        """In the middle of a cell, on a plane of the grid and on a point, towards the sun and away from it."""
        sun = (0.6, 0, 0.8)
        lit = slab(0.8, 50.0).nephoscope.sunlight(sun, **ONCE)
        for height in (0.5, 0.5 + 1 / 80, 0.5 + 0.3 / 40):
            for along in ((0.6, 0, 0.8), (-0.6, 0, -0.8), (0.3, 0.4, 0.8), (0, 0, -1)):
                with self.subTest(height=height, along=along):
                    eye = np.array((0, 0, height))
                    found = light_seen(lit, eye, eye + unit(along), up=(0.1, 1, 0.2))[10, 10]
                    expected = single(0.8, sun, along, start=height)
                    self.assertAlmostEqual(found, expected, delta=5e-3 * expected)

    def test_ball(self):
        """A ball of tetrahedra with a constant extinction, through its middle: the way of the sunlight is that in the ball."""
        points = pyvista.SolidSphere(outer_radius=1, radius_resolution=25, theta_resolution=49, phi_resolution=25)
        ball = points.triangulate() if hasattr(points, "triangulate") else points
        ball["Extinction"] = np.full(ball.n_points, 1.0)
        sun = unit((0.6, 0, 0.8))
        lit = ball.nephoscope.sunlight(sun, multiple_scattering=False, sky_light=0, asymmetry=G, eye="camera")
        for towards in (sun, -sun, unit((0.8, 0.5, -0.6)), unit((0, 1, 0.1))):
            t = np.linspace(-1, 1, 4001)
            along = t[:, None] * -towards
            middle = along @ sun
            way = -middle + np.sqrt(middle**2 + 1 - t**2)
            source = np.exp(-(t + 1) - way)
            expected = 0.25 * phase(-towards @ sun) * np.sum((source[1:] + source[:-1]) / 2) * (t[1] - t[0])
            found = light_seen(lit, 6 * towards + (1e-4, 2e-4, 3e-4), (1e-4, 2e-4, 3e-4))[10, 10]
            self.assertAlmostEqual(found, expected, delta=0.01 * expected)  # the ball has flat faces

    def test_two_media(self):
        """A clear grid around the cloud adds nothing; both are drawn in one shader."""
        lit = slab(0.8).nephoscope.sunlight((0.6, 0, 0.8), **ONCE)
        plotter = pyvista.Plotter(window_size=(60, 60))
        plotter.set_background("black")
        images = []
        for name in ("first", "second"):
            nephoscope.add_cells(plotter, lit, sun=True, exposure=1.0, show_scalar_bar=False, name=name, opacity_scale=1.0 if name == "first" else 1e-9)
            plotter.camera_position = [(-3, 0, -3.5), (0, 0, 0.5), (0, 1, 0)]
            images.append(plotter.screenshot(return_img=True).astype(float))
        plotter.close()
        self.assertGreater(images[0].mean(), 5)
        self.assertLess(np.abs(images[0] - images[1]).max(), 3)


class MultipleScattering(unittest.TestCase):
    """A cloud whose optical depth is 10 across."""

    def cloud(self, densest=20, **options):
        mesh = pyvista.ImageData(dimensions=(21, 21, 21), spacing=(0.05,) * 3)
        radius = np.linalg.norm(mesh.points - 0.5, axis=1)
        mesh["Extinction"] = densest * np.clip(1.8 - 4 * radius, 0, 1)
        return mesh.nephoscope.sunlight((1, 0, 0.2), sky_light=0, **options)

    def test_parts_are_the_light_for_one_eye(self):
        """The arrays give the source function for a distant eye."""
        eye = unit((-0.3, 0.8, 0.5))
        one, parts = self.cloud(eye=eye, parallel=True), self.cloud(eye="camera")
        sun, mean = parts.field_data["SunDirection"][0], self.cloud()
        cosine = -eye @ sun
        angle = np.degrees(np.arccos(cosine))
        factors = np.array([np.interp(angle, np.linspace(0, 180, 1801), column) for column in parts.field_data["PhaseFunction"].T])
        np.testing.assert_allclose(parts["Sunlight"], mean["Sunlight"], atol=1e-7)
        source = parts["Sunlight"] + parts["DiffuseFlux"] @ eye + (1.5 * eye[2]**2 - 0.5) * parts["DiffuseSecondMoment"] + parts["SingleScattering"] @ (factors - 1)
        wet = parts["ScaledExtinction"] > 0
        np.testing.assert_allclose(np.maximum(source, 0)[wet], one["Sunlight"][wet], atol=2e-3)

    def level_clouds(self, on_globe):
        """Thin, and wider than deep: much of the light in them runs level."""
        if on_globe:
            grid = pyvista.RectilinearGrid(np.linspace(0, 360, 37)[:-1], np.linspace(-90, 90, 19), np.linspace(0, 10000, 9))
            mesh = grid.nephoscope.globe(level_units="m", vertical_exaggeration=60, mask_below_ground=False)
            heights, places = np.linalg.norm(mesh.points, axis=1) / 6371e3 - 1, 4 * mesh.points / 6371e3
            mesh["Extinction"] = 2e-5 * np.clip(1 - np.abs(heights / 0.047 - 1), 0, 1) * (1.2 + np.sin(places).prod(axis=1))
            return mesh
        mesh = pyvista.ImageData(dimensions=(15, 15, 9), spacing=(2, 2, 0.125))
        mesh["Extinction"] = 2 * np.clip(2 - np.abs(4 * mesh.points[:, 2] - 2), 0, 1) * (1.2 + np.sin(mesh.points).prod(axis=1))
        return mesh

    def test_picture_for_one_eye(self):
        """Light that follows the camera has the picture of light for this eye, on flat ground and on a globe, where up turns along a ray."""
        for on_globe, eyes in ((False, ((14, 14, 160), (-180, 120, 60), (60, 140, -90))), (True, ((2e7, 3e6, 5e6), (2e6, 1e6, 2e7)))):
            mesh = self.level_clouds(on_globe)
            middle = np.array((0, 0, 0) if on_globe else mesh.center)
            for eye in eyes:
                with self.subTest(on_globe=on_globe, eye=eye):
                    one, parts = (mesh.nephoscope.sunlight((0.9, 0.2, 0.3), eye=given) for given in (eye, "camera"))
                    images = [light_seen(lit, eye, middle, size=(31, 31), angle=40 if on_globe else 10, clip=(1e3, 1e8) if on_globe else (1e-3, 1e4)) for lit in (one, parts)]
                    self.assertGreater(images[0].max(), 0.02)
                    moments = np.abs(parts["DiffuseSecondMoment"]).max() / parts["Sunlight"].max()
                    self.assertGreater(moments, 0.03)
                    self.assertLess(np.abs(images[0] - images[1]).max(), 0.01 * images[0].max())

    def test_silver_lining(self):
        """Against the sun, the edge of the cloud is brighter than with the sun behind the eye, and far brighter than its middle."""
        lit = self.cloud(densest=100, eye="camera")
        into, away = (light_seen(lit, np.array((0.5, 0.5, 0.5)) + side * 3 * unit((1, 0, 0.2)), (0.5, 0.5, 0.5), size=(81, 81), up=(0, 1, 0)) for side in (-1, 1))
        self.assertGreater(into.max(), 3 * into[40, 40])
        self.assertGreater(into.max(), 3 * away.max())
        self.assertLess(into[40, 40], 0.5 * away[40, 40])

    def test_others_stay(self):
        """Other arrays than Sunlight, and Sunlight without the parts, are drawn as they are."""
        plotter = pyvista.Plotter()
        nephoscope.add_cells(plotter, self.cloud(eye="camera"), scalars="SunTransmittance")
        plotter.screenshot(return_img=True)
        plotter.close()
        for eye in ("screen", (1, 2)):
            with self.assertRaisesRegex(ValueError, "eye"):
                self.cloud(eye=eye)
        with self.assertRaisesRegex(ValueError, "phase_function"):
            self.cloud(eye="camera", phase_function="mie")


class Splats(unittest.TestCase):
    """Splats have the light towards the camera of each frame. Light that was computed for its eye has it at the same samples."""

    SUN = (1, 0, 0.2)
    MIDDLE = np.array((0.5, 0.5, 0.5))

    def cloud(self, n=21, **options):
        mesh = pyvista.ImageData(dimensions=(n,) * 3, spacing=(1 / (n - 1),) * 3)
        mesh["Extinction"] = 20 * np.clip(1.8 - 4 * np.linalg.norm(mesh.points - 0.5, axis=1), 0, 1)
        return mesh.nephoscope.sunlight(self.SUN, **options)

    def check(self, found, expected, share=1e-4):
        self.assertGreater(expected.max(), 0.02)
        self.assertLess(np.abs(found - expected).max(), share * expected.max())

    def test_any_camera(self):
        """Along the axes, towards the sun and away from it, between, from afar: points of one colour each; the mean light is another one."""
        parts, mean = self.cloud(eye="camera"), self.cloud()
        sun = unit(self.SUN)
        for towards in ((1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, 0, 1), (0, 0, -1), sun, -sun, (0.3, -0.8, 0.5)):
            for distance, angle in ((3, 20), (100, 0.7)):
                with self.subTest(towards=towards, distance=distance):
                    eye = self.MIDDLE + distance * unit(towards)
                    found, expected, other = (light_seen(lit, eye, self.MIDDLE, angle=angle, splats=True) for lit in (parts, self.cloud(eye=tuple(eye)), mean))
                    self.check(found, expected)
                    self.assertGreater(np.abs(other - expected).max(), 0.05 * expected.max())
            parallel = [light_seen(lit, self.MIDDLE + 3 * unit(towards), self.MIDDLE, parallel=0.6, splats=True) for lit in (parts, self.cloud(eye=unit(towards), parallel=True))]
            self.check(*parallel)

    def test_near(self):
        """Near the eye and around it each pixel of a splat has the light of its own direction, as in cells."""
        parts = self.cloud(eye="camera")
        inside, away = self.MIDDLE + (0.01, 0.02, 0.03), 0.9 * unit((0.3, -0.8, 0.5))
        for eye, along, share in ((inside, unit(self.SUN), 0.1), (inside, -unit(self.SUN), 0.01), (inside, (0, 1, 0), 0.01), (self.MIDDLE + away, -away, 0.02)):
            with self.subTest(eye=eye, along=along):
                splats, cells = (light_seen(parts, eye, eye + np.array(along), angle=60, splats=each) for each in (True, False))
                self.check(splats, cells, share)

    def test_hierarchy(self):
        """Blocks of samples have the mean of their parts: as far from all samples as with light for one eye."""
        parts = self.cloud(41, eye="camera")
        for towards in ((0, 1, 0), -unit(self.SUN)):
            eye = self.MIDDLE + 12 * unit(towards)
            found, expected = (light_seen(lit, eye, self.MIDDLE, size=(61, 61), angle=5, splats=True, tolerance=0.03) for lit in (parts, self.cloud(41, eye=tuple(eye))))
            self.check(found, expected, 0.01)

    def test_globe_and_cells(self):
        """Where up turns along a ray; and with the arrays on the cells of vertices, as ParaView draws splats."""
        mesh, eye = MultipleScattering().level_clouds(True), (4e7, 2e7, 4e8)
        pairs = [[mesh.nephoscope.sunlight((0.9, 0.2, 0.3), eye=given) for given in (eye, "camera")]]
        self.assertGreater(np.abs(pairs[0][1]["DiffuseSecondMoment"]).max(), 0.02)
        pairs.append([pyvista.PolyData(lit.points) for lit in pairs[0]])
        for lit, vertices in zip(*pairs):
            for arrays, own in ((lit.point_data, vertices.cell_data), (lit.field_data, vertices.field_data)):
                for name in arrays:
                    own[name] = arrays[name]
        for one, parts in pairs:
            expected, found = (light_seen(lit, eye, (0, 0, 0), size=(31, 31), angle=2, clip=(1e3, 1e9), splats=True) for lit in (one, parts))
            self.check(found, expected, 1e-3)

    def test_haze(self):
        """Haze dims the light of splats around the eye and of others."""
        parts = self.cloud(eye="camera")
        haze = nephoscope.vtkHaze()
        haze.SetProjectionToMap()
        haze.SetVisibility(0.5)
        haze.SetScaleHeight(1)
        haze.SetColor(0.002, 0.003, 0.004)
        for distance, angle, share in ((0, 60, 0.05), (0.9, 90, 0.01), (3, 20, 1e-4)):
            along = unit((-0.3, 0.8, -0.5))
            eye = self.MIDDLE - distance * along
            found, expected, clear = (light_seen(lit, eye, eye + along, angle=angle, splats=True, haze=air)
                                      for lit, air in ((parts, haze), (self.cloud(eye=tuple(eye)), haze), (parts, None)))
            self.check(found, expected, share)
            self.assertGreater(np.abs(found - clear).max(), 0.05 * expected.max())

    def test_smoke(self):
        """Smoke as splats."""
        grid = pyvista.ImageData(dimensions=(21,) * 3, spacing=(0.05,) * 3)
        grid["velocity"] = np.column_stack([np.ones(grid.n_points), 0.2 * np.sin(6 * grid.points[:, 1]), 0.1 * np.cos(6 * grid.points[:, 0])])
        smoke, eye = nephoscope.flow_volume(grid, center=(0.1, 0.5, 0.5), radius=0.15), (-8, 0.5, 0.1)
        pictures = [light_seen(smoke.nephoscope.sunlight(self.SUN, eye=given), eye, smoke.center, angle=10, splats=True) for given in ("camera", eye, None)]
        self.check(*pictures[:2])
        self.assertGreater(np.abs(pictures[2] - pictures[1]).max(), 0.5 * pictures[1].max())

    def test_add_splats(self):
        """The same from Python: sun={'eye': 'camera'}."""
        mesh = pyvista.ImageData(dimensions=(21,) * 3, spacing=(0.05,) * 3)
        mesh["Extinction"] = 20 * np.clip(1.8 - 4 * np.linalg.norm(mesh.points - 0.5, axis=1), 0, 1)
        pictures = []
        for eye in ("camera", (-2.0, 0.5, 0.0), None):
            plotter = pyvista.Plotter(window_size=(80, 80))
            plotter.set_background("black")
            nephoscope.add_splats(plotter, mesh, sun={"direction": self.SUN, "eye": eye}, exposure=0.3, show_scalar_bar=False)
            plotter.camera_position = [(-2, 0.5, 0), (0.5, 0.5, 0.5), (0, 0, 1)]
            pictures.append(plotter.screenshot(return_img=True).astype(float))
            plotter.close()
        self.assertLessEqual(np.abs(pictures[0] - pictures[1]).max(), 1)
        self.assertGreater(np.abs(pictures[0] - pictures[2]).max(), 50)


if __name__ == "__main__":
    unittest.main()
