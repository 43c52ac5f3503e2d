#!/usr/bin/env python3
# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Sunlight: beams in closed form, shadows on the ground and on smoke, the position of the sun, wrong input."""
import hashlib
import pathlib
import sys
import unittest

import numpy as np
from nephoscope import vtkFlowVolume, vtkSunlight, vtkSunSource
from nephoscope_testing import threads
from nephoscope_testing.messages import Messages
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_VERTEX, vtkDataSetAttributes, vtkUnstructuredGrid
from vtkmodules.vtkFiltersCore import vtkAppendFilter, vtkThreshold
from vtkmodules.vtkFiltersGeneral import vtkDataSetTriangleFilter
from vtkmodules.vtkFiltersSources import vtkPlaneSource

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from lit import add, add_to_cells, globe, image, light_of, places, values  # noqa: E402


def digest():
    """A hash of all that Sunlight writes for clouds on a grid."""
    waves = image((24, 20, 12), (100, 100, 50), lambda x, y, z: 1e-2 * np.maximum(np.sin(x / 300) * np.cos(y / 200) * np.sin(z / 90), 0))
    arrays = light_of(waves, (1, -1, 0.5))[0].GetPointData()
    made = hashlib.sha256()
    for i in range(arrays.GetNumberOfArrays()):
        made.update(vtk_to_numpy(arrays.GetArray(i)).tobytes())
    return made.hexdigest()


class Beam(unittest.TestCase):
    """Direct light, with single scattering alone: exp(-optical depth), exactly."""

    SUNS = ((0, 0, 1), (1, 0, 0), (0, -1, 0), (1, 1, 0), (1, 1, 1), (0.3, -0.5, 0.7), (-0.9, 0.1, 0.2), (0, 0, -1))

    def check(self, data, sun, places_of, rate=lambda x: 0 * x[:, 0] + 0.7):
        output, messages = light_of(data, sun, MultipleScattering=False, SkyLight=0)
        self.assertTrue(all("below the horizon" in message for message in messages), messages)
        expected = np.exp(-places_of(places(output), np.array(sun) / np.linalg.norm(sun))) * (sun[2] >= 0)  # no beam through flat ground
        np.testing.assert_allclose(values(output, "SunTransmittance"), expected, rtol=2e-4, atol=1e-6)

    @staticmethod
    def way_out(x, s):
        """Length from x inside the box [0, 4] x [0, 3] x [0, 5] to its boundary along s."""
        with np.errstate(divide="ignore", invalid="ignore"):
            ends = np.where(s > 0, (np.array([4.0, 3.0, 5.0]) - x) / s, np.where(s < 0, -x / s, np.inf))
        return np.maximum(ends.min(axis=1), 0)

    def test_box(self):
        data = image((5, 4, 6), (1, 1, 1), lambda x, y, z: 0 * x + 0.7)
        for sun in self.SUNS:
            with self.subTest(sun):
                self.check(data, sun, lambda x, s: 0.7 * self.way_out(x, s))

    def test_linear_extinction(self):
        """beta = 1 + x + 2 y + 3 z: its mean along the way is that in the middle."""
        data = image((5, 4, 6), (1, 1, 1), lambda x, y, z: 0.05 * (1 + x + 2 * y + 3 * z))

        def depth(x, s):
            length = self.way_out(x, s)
            middle = x + 0.5 * length[:, None] * s
            return 0.05 * (1 + middle @ [1, 2, 3]) * length
        for sun in self.SUNS:
            with self.subTest(sun):
                self.check(data, sun, depth)

    def test_tetrahedra_are_the_same(self):
        data = image((5, 4, 6), (1, 1, 1), lambda x, y, z: 0.05 * (1 + x + 2 * y + 3 * z))
        divider = vtkDataSetTriangleFilter()
        divider.SetInputData(data)
        divider.Update()
        for sun in self.SUNS:
            a, b = (values(light_of(d, sun, MultipleScattering=False)[0], "SunTransmittance") for d in (data, divider.GetOutput()))
            np.testing.assert_allclose(a, b, rtol=1e-4, atol=1e-6)

    def test_behind_a_hole_the_beam_goes_on(self):
        """Cells that are hidden, or not in the mesh, leave a hole. Points are left out from which the sun is seen along its faces."""
        hole = np.array([[1, 1, 2], [3, 2, 4]])
        hidden = image((5, 4, 6), (1, 1, 1), lambda x, y, z: 0 * x + 0.7)
        hidden.AllocateCellGhostArray()
        for cell in range(hidden.GetNumberOfCells()):
            middle = np.reshape(hidden.GetCell(cell).GetBounds(), (3, 2)).mean(axis=1)
            if np.all((middle > hole[0]) & (middle < hole[1])):
                hidden.GetCellGhostArray().SetValue(cell, vtkDataSetAttributes.HIDDENCELL)
        absent = vtkThreshold()  # cells around the hole
        add_to_cells(hidden, "inside", vtk_to_numpy(hidden.GetCellGhostArray()) == 0)
        absent.SetInputData(hidden)
        absent.SetInputArrayToProcess(0, 0, 0, 1, "inside")
        absent.SetLowerThreshold(0.5)
        absent.Update()
        for data in (hidden, absent.GetOutput()):
            for sun in self.SUNS[:-1]:
                with self.subTest(sun, of=data.GetClassName()):
                    output, _ = light_of(data, sun, MultipleScattering=False, SkyLight=0)
                    x, s = places(output), np.array(sun) / np.linalg.norm(sun)
                    with np.errstate(divide="ignore", invalid="ignore"):
                        ends = np.sort((hole[:, None] - x) / s, axis=0)
                    ends[:, :, s == 0] = np.where((x[:, s == 0] > hole[0, s == 0]) & (x[:, s == 0] < hole[1, s == 0]), [[[-np.inf]], [[np.inf]]], np.inf)
                    free = np.maximum(ends[1].min(axis=1) - np.maximum(ends[0].max(axis=1), 0), 0)
                    along = np.any((s == 0) & ((x == hole[0]) | (x == hole[1])), axis=1)
                    expected = np.exp(-0.7 * (self.way_out(x, s) - np.where(np.isfinite(free), free, 0)))
                    np.testing.assert_allclose(values(output, "SunTransmittance")[~along], expected[~along], rtol=2e-4)

    def test_parts_that_do_not_meet(self):
        """Two boxes apart, and a fine one on a coarse one, in one unstructured grid."""
        def boxes(*all_of_them):
            append = vtkAppendFilter()
            for box in all_of_them:
                append.AddInputData(box)
            append.Update()
            return append.GetOutput()
        lower = image((5, 4, 3), (1, 1, 1), lambda x, y, z: 0 * x + 0.7)
        for gap, upper in ((1, image((5, 4, 3), (1, 1, 1), lambda x, y, z: 0 * x + 0.7, (0, 0, 3))),
                           (0, image((17, 13, 7), (0.25, 0.25, 0.5), lambda x, y, z: 0 * x + 0.7, (0, 0, 2))),
                           (0, image((6, 5, 4), (0.8, 0.75, 1), lambda x, y, z: 0 * x + 0.7, (0, 0, 2)))):
            for sun in ((0, 0, 1), (0.1, -0.2, 1), (1, 1, 1), (0.3, -0.5, 0.7)):
                def depth(x, s, gap=gap):
                    z = np.minimum(x[:, 2] + self.way_out(x, s) * s[2], 5)
                    cut = np.maximum(np.minimum(z, 2 + gap) - np.maximum(x[:, 2], 2), 0) / s[2]
                    return 0.7 * (self.way_out(x, s) - cut)
                with self.subTest(sun, gap=gap):
                    self.check(boxes(lower, upper), sun, depth)

    def test_single_scattering(self):
        """Sunlight for an eye: albedo P(angle) T / 4, times pi."""
        data = image((3, 3, 9), (1, 1, 0.5), lambda x, y, z: 0 * x + 0.7)
        output, _ = light_of(data, (0, 0, 1), MultipleScattering=False, UseViewPosition=True, ParallelView=True, ViewPosition=(1, 0, 0), Asymmetry=0.6, Albedo=0.9)
        phase = (1 - 0.36) / (1 + 0.36) ** 1.5  # at right angles
        np.testing.assert_allclose(values(output, "Sunlight"), 0.25 * 0.9 * phase * np.exp(-0.7 * (4 - places(output)[:, 2])), rtol=1e-4)


class Ground(unittest.TestCase):
    """The shadow of clouds on data below their mesh."""

    AXES, MIDDLE = np.array([600.0, 500.0, 300.0]), np.array([1000.0, 1000.0, 1500.0])

    def test_outline(self):
        """Below a uniform box, exp(-extinction * chord), at the edges of the shadow too: sides of coarse cells interpolate the depth."""
        for extinction in (0.003, 0.02):
            for sun, most in (((1, 0, 0.4), 0), ((0.5, 0.37, 0.3), 25)):
                clouds, _ = light_of(image((21, 21, 11), (100, 100, 50), lambda x, y, z: 0 * x + extinction), sun, MultipleScattering=False)
                ground = image((101, 101, 1), (60, 60, 1), lambda x, y, z: 0 * x, origin=(-4010, -4010, -100))
                ground.GetPointData().RemoveArray("Extinction")
                lit, _ = light_of(ground, sun, clouds)
                towards, at = np.array(sun) / np.linalg.norm(sun), places(lit)
                with np.errstate(all="ignore"):
                    ways = np.nan_to_num(np.stack([-at / towards, ((2000, 2000, 500) - at) / towards]), nan=0, posinf=1e30, neginf=-1e30)
                chord = np.maximum(ways.max(0).min(1) - np.maximum(ways.min(0).max(1), 0), 0)
                chord[(towards[1] == 0) & ((at[:, 1] < 0) | (at[:, 1] > 2000))] = 0
                errors = np.abs(values(lit, "SunTransmittance") - np.exp(-extinction * chord))
                self.assertLessEqual((errors > 0.01).sum(), most, sun)

    def cloud(self, spacing):
        """An ellipsoid of 0.01 (1 - r^2), in a box that begins 1 km above the ground."""
        size = round(2000 / spacing) + 1
        return image((size, size, size // 2 + 1), (spacing,) * 3, lambda x, y, z: 0.01 * np.maximum(
            1 - (((np.stack([x, y, z], -1) - self.MIDDLE) / self.AXES) ** 2).sum(-1), 0), (0, 0, 1000))

    def test_closed_form(self):
        """The fraction of the beam on flat ground; the error falls faster than the spacing."""
        ground = image((61, 61, 2), (100, 100, 1), lambda x, y, z: 0 * x, (-2000, -2000, -1))
        x = places(ground)
        for sun in ((0, 0, 1), (1, -1, 1), (-1, 0.3, 0.5)):
            s = np.array(sun) / np.linalg.norm(sun)
            p, d = (x - self.MIDDLE) / self.AXES, s / self.AXES
            nearest = p - (p @ d)[:, None] * d / (d @ d)
            depth = 0.01 * 4 / 3 * np.maximum(1 - (nearest ** 2).sum(1), 0) ** 1.5 / np.sqrt(d @ d)
            errors = []
            for spacing in (40, 20):
                lit = light_of(self.cloud(spacing), sun, MultipleScattering=False)[0]
                found = values(light_of(ground, sun, clouds=lit, MultipleScattering=False)[0], "SunTransmittance")
                errors.append(abs(found - np.exp(-depth)).max())
            with self.subTest(sun):
                self.assertLess(errors[1], min(0.03, 0.5 * errors[0]))
                self.assertGreater((depth > 0.5).sum(), 20)

    def test_surface_without_extinction(self):
        """Clouds make it one that light reaches: sun and sky. A volume without extinction remains a fault, and so is a surface without clouds."""
        lit = light_of(self.cloud(40), (1, 0, 1), MultipleScattering=False)[0]
        plane = vtkPlaneSource()
        plane.SetOrigin(-2000, -2000, 0)
        plane.SetPoint1(4000, -2000, 0)
        plane.SetPoint2(-2000, 4000, 0)
        plane.SetResolution(50, 50)
        plane.Update()
        ground, messages = light_of(plane.GetOutput(), (1, 0, 1), clouds=lit, SkyLight=0.2)
        self.assertEqual(messages, [])
        through, light = values(ground, "SunTransmittance"), values(ground, "Sunlight")
        self.assertLess(through.min(), 0.1)
        np.testing.assert_allclose(light, np.sqrt(0.5) * through + 0.2 * (np.sqrt(0.5) + 0.1) / 1.1, rtol=1e-5)
        np.testing.assert_array_equal(values(ground, "Irradiance"), light)
        self.assertFalse(ground.GetPointData().HasArray("NephoscopeNoExtinction"))
        volume = image((3, 3, 3), (1, 1, 1), lambda x, y, z: 0 * x)
        volume.GetPointData().RemoveArray("Extinction")
        for data, clouds in ((volume, lit), (plane.GetOutput(), None)):
            self.assertIn("no array 'Extinction'", light_of(data, clouds=clouds)[1][0])

    def test_overcast_ground(self):
        """Below a thick layer with its diffuse light, a surface has the irradiance of the layer's base, below it and inside."""
        layer = image((9, 9, 21), (1000, 1000, 50), lambda x, y, z: 0 * x + 0.01, (-4000, -4000, 500))
        lit = light_of(layer, (0.6, 0, 0.8))[0]
        base = values(lit, "Irradiance").reshape(21, 9, 9)[0, 4, 4]
        self.assertGreater(base, 20 * 0.8 * values(lit, "SunTransmittance").reshape(21, 9, 9)[0, 4, 4])
        for height in (0, 500):
            plane = vtkPlaneSource()
            plane.SetOrigin(-500, -500, height)
            plane.SetPoint1(500, -500, height)
            plane.SetPoint2(-500, 500, height)
            plane.Update()
            np.testing.assert_allclose(values(light_of(plane.GetOutput(), (0.6, 0, 0.8), clouds=lit)[0], "Irradiance"), base, rtol=0.02)

    def test_up_is_that_of_the_clouds(self):
        """On ground across from y, in the sun along it, beside clouds whose y is up."""
        clouds = light_of(image((3, 3, 3), (1, 1, 1), lambda x, y, z: 0 * x + 0.1), (0, 1, 0), Up=(0, 2, 0))[0]
        np.testing.assert_array_equal(vtk_to_numpy(clouds.GetFieldData().GetArray("Up"))[0], (0, 1, 0))
        plane = vtkPlaneSource()
        plane.SetOrigin(10, -5, 0)
        plane.SetPoint1(11, -5, 0)
        plane.SetPoint2(10, -5, 1)
        plane.Update()
        output, messages = light_of(plane.GetOutput(), (0, 1, 0), clouds=clouds, SkyLight=0)
        self.assertEqual(messages, [])
        np.testing.assert_allclose(values(output, "Irradiance"), 1)

    def test_planet(self):
        """Below a shell from 1 to 1.1, a place on a smaller sphere; its facets are flat."""
        clouds = globe(3.0)
        lit = light_of(clouds, (1, 0.4, 0.3), MultipleScattering=False)[0]
        s = np.array([1, 0.4, 0.3]) / np.linalg.norm([1, 0.4, 0.3])
        inner = globe(0)
        at = places(inner)
        below = at[np.linalg.norm(at, axis=1) < 1.01] * 0.9
        ground = vtkUnstructuredGrid()
        ground.SetPoints(vtkPoints())
        ground.GetPoints().SetData(numpy_to_vtk(below, deep=1))
        for p in range(len(below)):
            ground.InsertNextCell(VTK_VERTEX, 1, [p])
        ground.SetFieldData(clouds.GetFieldData())
        add(ground, "Extinction", np.zeros(len(below)))
        found = values(light_of(ground, s, clouds=lit, MultipleScattering=False)[0], "SunTransmittance")
        along = below @ s
        ways = [np.sqrt(along ** 2 + r ** 2 - 0.81) - along for r in (1.0, 1.1)]
        high = along / 0.9 > 0.3
        np.testing.assert_allclose(found[high], np.exp(-3 * (ways[1] - ways[0]))[high], rtol=0.06)
        self.assertGreater(high.sum(), 50)


class Maps(unittest.TestCase):
    def test_a_map_elsewhere_needs_a_place(self):
        """Japan, in metres on a map: once, with a date alone, from the filter or from a source."""
        radius = 6371229.0
        japan = image((5, 5, 5), (1e5, 1e5, 1e3), lambda x, y, z: 0 * x + 1e-4, tuple(radius * np.radians((137, 35))) + (0,))
        for name, value in (("GlobeGridProjection", 1.0), ("PlanetRadius", radius)):
            array = numpy_to_vtk(np.array([value]), deep=1)
            array.SetName(name)
            japan.GetFieldData().AddArray(array)
        here = {"Longitude": 139, "Latitude": 37}
        for options, warned in (({}, True), (here, False)):
            messages = light_of(japan, DateTime="2020-06-21 12:00", **options)[1]
            self.assertEqual([m for m in messages if "longitude 139 and latitude 37, but the sun" in m] != [], warned, messages)
            source = vtkSunSource()
            source.SetDateTime("2020-06-21 12:00")
            for name, value in options.items():
                getattr(source, "Set" + name)(value)
            light = vtkSunlight()
            light.SetInputData(japan)
            light.SetInputConnection(2, source.GetOutputPort())
            with Messages() as messages:
                for hours in range(3):
                    source.SetHoursLater(hours / 10)
                    light.Update()
            self.assertEqual(len([m for m in messages.all if "set Longitude and Latitude" in m]), int(warned), messages.all)
        for data, options in ((japan, {"sun": (1, 1, 1)}), (image((5, 5, 5), (1e5, 1e5, 1e3), lambda x, y, z: 0 * x), {"DateTime": "2020-06-21 12:00"})):
            self.assertFalse([m for m in light_of(data, **options)[1] if "set Longitude" in m])


class Clear(unittest.TestCase):
    def test_residues_are_no_cloud(self):
        """Extinctions that are no more than the rounding of a model leave no light of their own."""
        def cloud(least):
            return lambda x, y, z: np.where((abs(x) < 3) & (abs(z - 4) < 2), 0.5, least)

        alone, _ = light_of(image((13, 13, 9), (1, 1, 1), cloud(0.0), (-6, -6, 0)), (0.5, 0, 1))
        for residue in (1e-9, 1e-14, 1e-20, 1e-37):
            output, messages = light_of(image((13, 13, 9), (1, 1, 1), cloud(residue), (-6, -6, 0)), (0.5, 0, 1))
            self.assertEqual(messages, [])
            for name in ("Sunlight", "Irradiance", "UpwardIrradiance", "ScaledExtinction"):
                np.testing.assert_allclose(values(output, name), values(alone, name), atol=1e-6, err_msg=f"{name}, {residue}")
        self.assertLess(values(alone, "Sunlight").max(), 1.5)

    def test_night_over_flat_ground(self):
        """The sun does not shine through the ground; only the sky is left, and goes with twilight."""
        cloud = image((9, 9, 9), (1, 1, 1), lambda x, y, z: np.where((z > 2) & (z < 6), 0.5, 0.0))
        day, dusk, night = (light_of(cloud, sun)[0] for sun in ((0, 0, 1), (1, 0, -0.02), (0, 0, -1)))
        self.assertEqual(values(night, "SunTransmittance").max(), 0.0)
        self.assertLess(values(night, "Sunlight").max(), 1e-6)
        self.assertEqual(values(dusk, "SunTransmittance").max(), 0.0)
        self.assertLess(values(dusk, "Sunlight").max(), 0.1 * values(day, "Sunlight").max())


class Again(unittest.TestCase):
    def test_another_eye_computes_nothing(self):
        """Progress is told by what is computed; light is that of a filter that begins."""
        data = image((9, 9, 9), (1, 1, 1), lambda x, y, z: 0.2 + 0 * x)
        light, steps = vtkSunlight(), []
        light.AddObserver("ProgressEvent", lambda *_: steps.append(light.GetProgress()))
        light.SetInputData(data)
        light.UseViewPositionOn()
        for change, computes in ((lambda: None, True), (lambda: light.SetViewPosition(9, 1, 30), False), (lambda: light.SetSunDirection(1, 0, 3), True),
                                 (lambda: data.GetPointData().GetArray("Extinction").FillComponent(0, 0.4), True)):
            steps.clear()
            change()
            data.GetPointData().GetArray("Extinction").Modified() if computes else None
            light.Modified()
            light.Update()
            self.assertEqual(any(0 < step < 1 for step in steps), computes)
            fresh = light_of(data, light.GetSunDirection(), UseViewPosition=True, ViewPosition=light.GetViewPosition())[0]
            np.testing.assert_array_equal(values(light.GetOutput(), "Sunlight"), values(fresh, "Sunlight"))


class Wrong(unittest.TestCase):
    def test_sides(self):
        """A tall cloud that reaches the sides of its grid is told, with the fraction of the beam that enters there, but not a wide one, one in clear air, or one that repeats."""
        tall = image((5, 5, 31), (100, 100, 100), lambda x, y, z: 0 * x + 0.02)
        wide = image((31, 31, 5), (100, 100, 100), lambda x, y, z: 0 * x + 0.02)
        alone = image((9, 9, 31), (100, 100, 100), lambda x, y, z: 0.02 * ((np.abs(x - 400) < 350) & (np.abs(y - 400) < 350)))
        for name, data, sun, told, options in (("tall", tall, (1, 0, 1), "and 6 times as much sunlight enters there as from above", {}), ("from -y", tall, (0, -1, 1), "times as much", {}),
                                               ("as much", tall, (1, 0, 5), "and about as much sunlight", {}), ("less", tall, (1, 0, 9), "and more than half as much sunlight", {}), ("on the horizon", tall, (1, 0, 0), "all sunlight", {}), ("overhead", tall, (0, 0, 1), "", {}), ("wide", wide, (1, 0, 1), "", {}),
                                               ("alone", alone, (1, 0, 1), "", {}), ("periodic", tall, (1, 0, 1), "", {"PeriodicSides": True})):
            with self.subTest(name):
                found = [message for message in light_of(data, sun, **options)[1] if "reach the sides" in message]
                self.assertEqual(len(found), int(bool(told)), found)
                self.assertIn(told, "".join(found))

    def test_data_without_depth(self):
        """An extinction on surfaces casts no shadow: it is told, however they lie and whatever they are; not that of clear air or of one cell of depth."""
        some, clear = lambda x, y, z: 0 * x + 0.5, lambda x, y, z: 0 * x
        curtain = image((5, 1, 5), (1, 1, 1), some)
        append = vtkAppendFilter()
        append.AddInputData(curtain)
        append.Update()
        for name, data, told in (("flat", image((5, 5, 1), (1, 1, 1), some), True), ("curtain", curtain, True), ("line", image((1, 1, 5), (1, 1, 1), some), True), ("unstructured", append.GetOutput(), True),
                                 ("clear", image((5, 5, 1), (1, 1, 1), clear), False), ("one cell", image((5, 5, 2), (1, 1, 1), some), False)):
            with self.subTest(name):
                output, messages = light_of(data)
                found = [message for message in messages if "no 3-D cells" in message]
                self.assertEqual(len(found), int(told), messages)
                self.assertEqual(output.GetNumberOfPoints(), data.GetNumberOfPoints())

    def test_messages(self):
        fine = image((3, 3, 3), (1, 1, 1), lambda x, y, z: 0 * x + 1)
        for data, options, word in ((fine, {"ExtinctionArrayName": "no"}, "'no'"), (fine, {"sun": (0, 0, 0)}, "SunDirection"),
                                    (fine, {"DateTime": "tomorrow"}, "'tomorrow'")):
            output, messages = light_of(data, **options)
            self.assertEqual(len(messages), 1, messages)
            self.assertIn(word, messages[0])
            self.assertEqual(output.GetNumberOfPoints(), 0)
        output, messages = light_of(fine, (0, 1, -1))
        self.assertIn("night", messages[0])
        output, messages = light_of(image((3, 3, 3), (1, 1, 1), lambda x, y, z: np.where(x > 1, np.nan, -1.0)))
        self.assertIn("27 values", messages[0])
        self.assertTrue(np.isfinite(values(output, "Sunlight")).all())

    def test_depths_that_no_cloud_has(self):
        """Warnings of an array that is no extinction and of an extinction per metre on a mesh in kilometres; none of thick clouds in clear air."""
        for data, options, words in (
                (image((9, 9, 9), (1, 1, 1), lambda x, y, z: 150 + x), {}, ("optical depth above 200", "ExtinctionScale, such as 0.006")),
                (image((9, 9, 9), (1, 1, 1), lambda x, y, z: 150 + x), {"ExtinctionScale": 1e-4}, ()),
                (image((9, 9, 9), (1, 1, 0.5), lambda x, y, z: 0 * x + 1e-4), {}, ("maximum optical depth across the data is 0.001", "such as 8000")),
                (image((9, 9, 9), (1000, 1000, 500), lambda x, y, z: 0.05 * (z > 2000) * (x > 5000)), {}, ()),
                (image((9, 9, 9), (1, 1, 1), lambda x, y, z: 0 * x), {}, ())):
            _, messages = light_of(data, **options)
            self.assertEqual(len(messages), 1 if words else 0, messages)
            for word in words:
                self.assertIn(word, messages[0])


class Smoke(unittest.TestCase):
    """A straight beam along x of radius 1: an optical depth of 1 through its middle, whatever the density."""

    @classmethod
    def setUpClass(cls):
        wind = image((9, 5, 5), (2.5, 2, 2), lambda x, y, z: 0 * x, origin=(-10, -4, -4))
        vectors = numpy_to_vtk(np.tile((1.0, 0, 0), (wind.GetNumberOfPoints(), 1)), deep=1)
        vectors.SetName("wind")
        wind.GetPointData().AddArray(vectors)
        flow = vtkFlowVolume()
        flow.SetInputData(wind)
        flow.SetInputArrayToProcess(0, 0, 0, 0, "wind")
        flow.SetCenter(-8, 0, 0)
        flow.SetRadius(1)
        flow.SetNumberOfSides(60)
        flow.SetDuration(16)
        flow.SetTimeStep(0.25)
        flow.SetInitialDensity(7)
        flow.Update()
        cls.smoke = flow.GetOutput()

    def test_own_shadow(self):
        output, messages = light_of(self.smoke, sun=(0, 1, 1e-6))
        self.assertEqual(messages, [])
        y = np.array([output.GetPoint(p)[1] for p in range(output.GetNumberOfPoints())])
        z = np.array([output.GetPoint(p)[2] for p in range(output.GetNumberOfPoints())])
        way = np.maximum(np.sqrt(np.maximum(1 - z**2, 0)) - y, 0)
        np.testing.assert_allclose(values(output, "SunTransmittance"), np.exp(-0.5 * way), atol=0.02)
        np.testing.assert_allclose(values(output, "ScaledExtinction"), 0.5 * (1 - 0.9 * 0.36), rtol=0.01)

    def test_initial_density(self):
        """Smoke of an unsteady flow tells it; it is the reference in place of the mean density."""
        smoke = self.smoke.NewInstance()
        smoke.ShallowCopy(self.smoke)
        for density, factor in ((14.0, 0.5), (0.0, 1.0)):
            initial = numpy_to_vtk(np.array([density]), deep=1)
            initial.SetName("InitialDensity")
            smoke.GetFieldData().AddArray(initial)
            np.testing.assert_allclose(values(light_of(smoke)[0], "ScaledExtinction"), factor * 0.5 * (1 - 0.9 * 0.36), rtol=0.01)

    def test_beside_the_light_of_clouds(self):
        """Smoke that was made in lit clouds carries their arrays, which are not its own."""
        self.assertTrue(self.smoke.GetPointData().HasArray("Extinction"))  # 0, of the data in setUpClass
        output, _ = light_of(self.smoke)
        self.assertTrue(output.GetPointData().HasArray("SmokeExtinction"))
        self.assertEqual(values(output, "Extinction").max(), 0)
        self.assertGreater(values(output, "ScaledExtinction").min(), 0.3)

    def test_optics_can_be_set(self):
        output, _ = light_of(self.smoke, ExtinctionScale=2, AlbedoArrayName="", AsymmetryArrayName="", Albedo=0.5, Asymmetry=0)
        np.testing.assert_allclose(values(output, "ScaledExtinction"), 1, rtol=0.01)
        other, _ = light_of(self.smoke, ExtinctionScale=2)
        self.assertLess(values(output, "Sunlight").mean(), 0.7 * values(other, "Sunlight").mean())

    def test_shadow_of_clouds(self):
        cloud = image((41, 17, 21), (0.5, 0.5, 0.5), lambda x, y, z: np.where((abs(x) <= 2) & (z >= 3), 0.6, 0.0), origin=(-10, -4, -4))
        clouds, _ = light_of(cloud)
        options = {"AsymmetryArrayName": "", "Asymmetry": 0, "ExtinctionScale": 1e-9, "MultipleScattering": False}
        clear, shaded = light_of(self.smoke, **options)[0], light_of(self.smoke, clouds=clouds, **options)[0]
        x = np.array([clear.GetPoint(p)[0] for p in range(clear.GetNumberOfPoints())])
        below, beside = abs(x) <= 2, abs(x) > 2.5
        expected = np.exp(-0.6 * 3.25)  # half a cell below the lowest cloudy points as well
        for name in ("Sunlight", "SunTransmittance"):
            share = values(shaded, name) / values(clear, name)
            np.testing.assert_allclose(share[below], expected, rtol=0.01)
            np.testing.assert_allclose(share[beside], 1)

    def test_light_in_a_shadow_is_weaker_by_it(self):
        """All light is in proportion to the sun: where a cloud dims all of it by the same factor, the whole light is dimmer by that."""
        for thin in (lambda x, y, z: 0 * x + 0.5, lambda x, y, z: np.where(z > 0, 0.3, 0)):
            data = image((9, 9, 9), (1, 1, 1), thin)
            veil = image((2, 2, 2), (20, 20, 40), lambda x, y, z: 0 * x, (-5, -5, -5))
            add(veil, "SunTransmittance", np.full(8, 0.3))
            options = {"SkyLight": 0}
            bright, dim = light_of(data, **options)[0], light_of(data, clouds=veil, **options)[0]
            for name in ("Sunlight", "UpwardIrradiance", "Irradiance"):
                np.testing.assert_allclose(values(dim, name), 0.3 * values(bright, name), rtol=0.01, atol=1e-4)

    def test_clouds_without_light(self):
        cloud = image((3, 3, 3), (1, 1, 1), lambda x, y, z: 0 * x)
        self.assertIn("The clouds have no array 'SunTransmittance'", light_of(self.smoke, clouds=cloud)[1][0])
        self.assertIn("lit from another direction", " ".join(light_of(self.smoke, sun=(1, 0, 1), clouds=light_of(cloud)[0])[1]))


class Threads(unittest.TestCase):
    def test_any_number_gives_the_same(self):
        self.assertEqual(len(threads.results(__file__, "digest()")), 1)


if __name__ == "__main__":
    unittest.main()
