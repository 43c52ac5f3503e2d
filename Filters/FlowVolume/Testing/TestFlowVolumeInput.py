# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every kind of dataset, each choice of the velocity, all arrays, automatic settings, both kinds of polygon."""
import re
import unittest

import numpy as np
from nephoscope_testing import meshes
from nephoscope_testing.flow import area_of, flow_volume, update
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkDataSetAttributes, vtkMultiBlockDataSet, vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer
from vtkmodules.vtkFiltersCore import vtkThreshold

WIND = np.array([0.2, 0.1, 1.0])
SETTINGS = dict(Center=(0.1, 0.05, -0.8), Radius=0.1, NumberOfSides=6, Duration=1.0, TimeStep=0.1)
VOLUME = area_of(0.1, 6) * np.linalg.norm(WIND)


def linear(points):
    return points @ [2.0, -1.0, 3.0] + 5


def with_wind(data, name="Flow", on_cells=False, wind=WIND):
    attributes, count = (data.GetCellData(), data.GetNumberOfCells()) if on_cells else (data.GetPointData(), data.GetNumberOfPoints())
    meshes.add_array(attributes, np.tile(np.asarray(wind, float), (count, 1)), name)
    return data


def cube(blocks=6, name="Flow", **options):
    return with_wind(meshes.image((blocks,) * 3, (2 / blocks,) * 3, (-1,) * 3), name, **options)


def axes(blocks=6):
    return np.cumsum(np.r_[-1, np.full(blocks, 2 / blocks)])


def datasets():
    rng = np.random.default_rng(3)
    yield "image", cube()
    yield "rectilinear", with_wind(meshes.rectilinear([axes(4), axes(5), axes(6)]))
    yield "structured", with_wind(meshes.structured((6, 6, 6), lambda p: 2 * p - 1 + 0.03 * np.sin(5 * p[:, ::-1]) * (np.abs(2 * p - 1) < 1)))
    yield "tetrahedra", with_wind(meshes.delaunay(rng, 0, 2 * np.array(list(np.ndindex(5, 5, 5))) / 4 - 1 + 1e-3 * rng.normal(size=(125, 3))))
    yield "cells", cube(12, on_cells=True)
    yield "blocks", blocks()


def blocks():
    whole, parts = cube(), vtkMultiBlockDataSet()
    meshes.add_array(whole.GetCellData(), np.arange(whole.GetNumberOfCells()), "id")
    for number, (low, high) in enumerate(((0, 107), (108, 215))):
        half = vtkThreshold()
        half.SetInputData(whole)
        half.SetInputArrayToProcess(0, 0, 0, 1, "id")
        half.SetLowerThreshold(low)
        half.SetUpperThreshold(high)
        half.Update()
        parts.SetBlock(2 * number, half.GetOutput())  # and an empty block
    return parts


def polygon(*corners):
    points, cells = meshes.vtk_points(corners), vtkCellArray()
    cells.InsertNextCell(len(corners), list(range(len(corners))))
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetPolys(cells)
    producer = vtkTrivialProducer()
    producer.SetOutput(data)
    return producer


class Datasets(unittest.TestCase):
    def test_uniform_flow_through_each(self):
        for name, data in datasets():
            with self.subTest(name):
                smoke, messages = update(flow_volume(data, **SETTINGS))
                self.assertEqual(messages, [])
                self.assertGreater(smoke.volumes().min(), 0)
                self.assertAlmostEqual(smoke.volumes().sum() / VOLUME, 1, places=9)
                self.assertAlmostEqual(smoke.mass() / VOLUME, 1, places=9)
                self.assertAlmostEqual(smoke.made.GetEmittedMass() / VOLUME, 1, places=9)
                np.testing.assert_allclose(smoke.made.GetNormalUsed(), WIND / np.linalg.norm(WIND), atol=1e-9)
                self.assertTrue(smoke.is_one_piece())

    def test_blanked_cells_end_it(self):
        data = cube(8)
        ghosts = np.zeros(data.GetNumberOfCells(), np.uint8)
        ghosts.reshape(8, 8, 8)[5:] = vtkDataSetAttributes.HIDDENCELL
        meshes.add_array(data.GetCellData(), ghosts, "vtkGhostType")
        smoke, messages = update(flow_volume(data, **{**SETTINGS, "Duration": 2.0}))
        self.assertEqual(messages, [])
        self.assertLessEqual(smoke.points[:, 2].max(), 0.25 + 1e-9)
        self.assertGreater(smoke.points[:, 2].max(), 0.0)
        made = smoke.made
        self.assertGreater(made.GetLostMass(), 0)
        self.assertAlmostEqual((smoke.mass() + made.GetLostMass()) / made.GetEmittedMass(), 1, places=9)

    def test_blanked_cell_between_corners(self):
        """A cell of 1/24 of the cube in front of a polygon of four triangles. The smoke behind it is missing; without the search, nothing."""
        data = cube(24, wind=(0, 0, 1))
        ghosts = np.zeros(data.GetNumberOfCells(), np.uint8)
        ghosts.reshape(24, 24, 24)[11, 12, 11] = vtkDataSetAttributes.HIDDENCELL
        meshes.add_array(data.GetCellData(), ghosts, "vtkGhostType")
        settings = dict(Center=(0, 0, -0.8), Radius=0.4, NumberOfSides=4, PolygonEdgeLength=1, Duration=1.5, TimeStep=0.25, MaximumEdgeLength=0.8)
        lost = {}
        for size, levels in ((10, 2), (0, 2), (0, 5), (0.04, 5)):
            smoke, messages = update(flow_volume(data, ObstacleSize=size, ObstacleLevels=levels, **settings))
            lost[size, levels] = made = smoke.made.GetObstacleMass()
            self.assertAlmostEqual(made, smoke.made.GetLostMass(), places=12)
            self.assertAlmostEqual((smoke.mass() + made) / smoke.made.GetEmittedMass(), 1, places=9)
            self.assertEqual(len(messages), made > 0.01 * smoke.made.GetEmittedMass(), messages)
            self.assertTrue((smoke.volumes() > 0).all())
        least = (2 / 24)**2 * (1.5 - 0.7)
        self.assertEqual(lost[10, 2], 0)
        self.assertGreater(lost[0, 2], lost[0, 5])
        self.assertGreater(lost[0, 5], least)
        self.assertLess(lost[0, 5], 4 * least)
        self.assertGreater(lost[0.04, 5], least)

    def test_missing_values_end_it(self):
        data = cube(8)
        v = vtk_to_numpy(data.GetPointData().GetArray("Flow"))
        v[meshes.points_of(data)[:, 2] > 0.3] = np.nan
        smoke, messages = update(flow_volume(data, **{**SETTINGS, "Duration": 2.0}))
        missing = int(np.isnan(v[:, 0]).sum())
        self.assertEqual(len(messages), 1)
        self.assertRegex(messages[0], rf"'Flow'\) is not a finite number at {missing} of {len(v)} points")
        self.assertTrue(np.isfinite(smoke.points).all())
        self.assertLessEqual(smoke.points[:, 2].max(), 0.25 + 1e-9)

    def test_missing_values_as_obstacles(self):
        """In the middle of the data, where bodies are: they are told first, and named where the smoke that is lost is told."""
        data = cube(8)
        v = vtk_to_numpy(data.GetPointData().GetArray("Flow"))
        v[np.abs(meshes.points_of(data)[:, 2] - 0.3) < 0.2] = np.nan
        smoke, messages = update(flow_volume(data, **{**SETTINGS, "Duration": 2.0}))
        self.assertGreater(smoke.made.GetObstacleMass(), 0.05 * smoke.made.GetEmittedMass())
        self.assertEqual(len(messages), 2)
        self.assertIn("is not a finite number", messages[0])
        self.assertIn("% of it ended at missing velocities or obstacles inside the data", messages[1])

    def test_far_from_the_origin(self):
        data = meshes.image((6, 6, 6), (1e6,) * 3, (1e9, 0, 0))
        smoke, messages = update(flow_volume(with_wind(data, wind=WIND * 1e6), Center=(1e9 + 3e6, 3e6, 1e6), Radius=1e5, Duration=2.0))
        self.assertEqual(messages, [])
        self.assertAlmostEqual(smoke.mass() / (2e6 * area_of(1e5, 12) * np.linalg.norm(WIND)), 1, places=5)


class Velocity(unittest.TestCase):
    OTHER = (0, 1, 0)

    def direction(self, data, **settings):
        smoke, messages = update(flow_volume(data, **{**SETTINGS, "Center": (0, 0, 0), "Duration": 0.3, **settings}))
        self.assertEqual(messages, [])
        return smoke.made.GetNormalUsed()

    def expect(self, data, wind, **settings):
        np.testing.assert_allclose(self.direction(data, **settings), np.asarray(wind) / np.linalg.norm(wind), atol=1e-12)

    def test_display_velocity_comes_first(self):
        data = with_wind(cube(name="DisplayVelocity"), "Wind", wind=self.OTHER)
        data.GetPointData().SetActiveVectors("Wind")
        self.expect(data, WIND)

    def test_then_active_vectors(self):
        data = with_wind(cube(), "Wind", wind=self.OTHER)
        data.GetPointData().SetActiveVectors("Wind")
        self.expect(data, self.OTHER)

    def test_then_the_only_one(self):
        data = with_wind(cube(), "Normals", wind=self.OTHER)
        data.GetPointData().SetActiveNormals("Normals")
        meshes.add_array(data.GetPointData(), np.ones(data.GetNumberOfPoints()), "scalar")
        colors = numpy_to_vtk(np.full((data.GetNumberOfPoints(), 3), 200, np.uint8), deep=True)
        colors.SetName("Color")
        data.GetPointData().AddArray(colors)
        self.expect(data, WIND)

    def test_points_before_cells(self):
        self.expect(with_wind(cube(), "Wind", on_cells=True, wind=self.OTHER), WIND)

    def test_choice(self):
        data = with_wind(cube(), "Wind", wind=self.OTHER)
        with_wind(data, "Flow", on_cells=True, wind=(1, 0, 0))
        self.expect(data, self.OTHER, Velocity="Wind")
        self.expect(data, WIND, Velocity="Flow")
        self.expect(data, (1, 0, 0), Velocity=("Flow", 1))


class Arrays(unittest.TestCase):
    def test_every_point_array_at_its_position(self):
        for name, data in datasets():
            if name in ("blocks", "cells"):
                continue
            with self.subTest(name):
                points = meshes.points_of(data)
                meshes.add_array(data.GetPointData(), linear(points), "linear")
                meshes.add_array(data.GetPointData(), points.astype("f4"), "place")
                meshes.add_array(data.GetPointData(), np.zeros(len(points), np.uint8), "vtkGhostType")
                smoke = update(flow_volume(data, **SETTINGS, Velocity="Flow"))[0]
                tolerance = 0.02 if name == "structured" else 1e-9  # trilinear in warped cells
                np.testing.assert_allclose(smoke.point_array("place"), smoke.points, atol=1e-6)
                np.testing.assert_allclose(smoke.point_array("linear"), linear(smoke.points), atol=tolerance)
                self.assertFalse(smoke.output.GetPointData().HasArray("vtkGhostType"))

    def test_own_arrays(self):
        smoke = update(flow_volume(cube(), **SETTINGS, InitialDensity=2.5))[0]
        step = smoke.cell_array("EmissionStep")
        self.assertEqual(set(step), set(range(10)))
        np.testing.assert_allclose(smoke.cell_array("Age"), 0.1 * (step + 0.5), atol=1e-12)
        np.testing.assert_allclose(smoke.density, 2.5, rtol=1e-9)
        np.testing.assert_allclose(smoke.age, (smoke.points - [0.1, 0.05, -0.8]) @ WIND / (WIND @ WIND), atol=1e-9)

    def test_name_of_our_own_and_field_data(self):
        data = cube()
        meshes.add_array(data.GetPointData(), np.full(data.GetNumberOfPoints(), 7.0), "Age")
        meshes.add_array(data.GetFieldData(), np.array([3.0]), "note")
        smoke, messages = update(flow_volume(data, **SETTINGS))
        self.assertTrue(len(messages) == 1 and "'Age' of the input has been replaced" in messages[0], messages)
        self.assertLessEqual(smoke.age.max(), 1 + 1e-12)
        self.assertEqual(smoke.output.GetFieldData().GetArray("note").GetValue(0), 3)


class Settings(unittest.TestCase):
    def test_automatic(self):
        smoke, messages = update(flow_volume(cube(), Center=(0, 0, 0)))
        made, diagonal = smoke.made, 2 * np.sqrt(3)
        self.assertEqual(messages, [])
        self.assertAlmostEqual(made.GetDurationUsed(), 0.5 * diagonal / np.linalg.norm(WIND), places=12)
        self.assertAlmostEqual(made.GetTimeStepUsed(), made.GetDurationUsed() / 64, places=12)
        first = smoke.points[smoke.age == 0]
        self.assertAlmostEqual(np.linalg.norm(first, axis=1).max(), diagonal / 50, places=12)

    def test_duration_longer_than_the_data(self):
        """The smoke goes as far as the data: a step is a 32nd of the diagonal at most."""
        for duration in (100, 1e5):
            made = update(flow_volume(cube(), Center=(0, 0, -0.5), Radius=0.05, Duration=duration))
            self.assertEqual(made[1], [])
            self.assertGreater(made[0].points[:, 2].max(), 1 - 2 * np.sqrt(3) / 32)
            self.assertAlmostEqual(made[0].made.GetTimeStepUsed(), 2 * np.sqrt(3) / 32 / np.linalg.norm(WIND), places=12)

    def test_duration_of_too_many_steps(self):
        """A duration of more than two million usual steps has one warning, with both steps and the remedy: layers of smoke become visible."""
        usual = 2 * np.sqrt(3) / 32 / np.linalg.norm(WIND)
        for times, told in ((1.5, 0), (8, 1), (40, 1)):
            smoke, messages = update(flow_volume(cube(), Center=(0, 0, -0.5), Radius=0.05, Duration=times * 1e6 * usual))
            self.assertEqual(len(messages), told, messages)
            self.assertAlmostEqual(smoke.made.GetTimeStepUsed() / usual, times, places=4)
            numbers = re.findall(r"Duration of (\S+) s, a TimeStep of (\S+) s .* so it is (\S+) s\. Shorten Duration, to (\S+) s", " ".join(messages))
            for found in numbers:
                np.testing.assert_allclose(np.array(found, float), usual * np.array([times * 1e6, 1, times, 1e6]), rtol=1e-4)
            self.assertEqual(len(numbers), told, messages)

    def test_fixed_normal(self):
        for normal in ((0, 0, 5), (0, 0, -1)):
            smoke = update(flow_volume(cube(), **SETTINGS, NormalToFlow=False, Normal=normal))[0]
            self.assertAlmostEqual(smoke.mass(), area_of(0.1, 6) * WIND[2], places=12)
            self.assertGreater(smoke.volumes().min(), 0)
            self.assertAlmostEqual(abs(smoke.made.GetNormalUsed()[2]), 1, places=12)


def sheared(rate, turn=0.0):
    """A wind along x that grows with y, in a wide box: it stretches everything, without end."""
    data = meshes.image((8, 8, 8), (1000, 1, 1), (-4000, -4, -4))
    points = meshes.points_of(data)
    meshes.add_array(data.GetPointData(), np.column_stack([2 + rate * points[:, 1], turn * points[:, 2], -turn * points[:, 1]]), "Flow")
    return data


class WholeDuration(unittest.TestCase):
    """However few tetrahedra there may be, the smoke lasts as long as it is asked to, and it is said where it is coarser than asked for."""

    def check(self, smoke, limit, duration):
        self.assertLessEqual(len(smoke.cells), limit)
        self.assertAlmostEqual(smoke.age.max() / duration, 1, places=9)
        self.assertGreater(smoke.volumes().min(), 0)
        self.assertAlmostEqual(smoke.mass() / smoke.made.GetEmittedMass(), 1, places=9)
        self.assertTrue(smoke.is_one_piece())

    def test_automatic(self):
        """Nothing but a duration is set: nothing is to be told."""
        smoke, messages = update(flow_volume(sheared(1.8, 0.02), Radius=1, Duration=150.0))
        self.assertEqual(messages, [])
        self.check(smoke, 100_000, 150.0)
        self.assertGreater(smoke.made.GetMaximumEdgeLengthUsed(), 10, "this flow does not test anything: it has not been coarsened")

    def test_all_automatic(self):
        smoke, messages = update(flow_volume(sheared(1.5, 0.02), Radius=1, Center=(-3500, 0, 0)))
        self.assertEqual(messages, [])
        self.check(smoke, 100_000, smoke.made.GetDurationUsed())

    def test_asked_for(self):
        rng = np.random.default_rng(5)
        for limit in (1000, 3000, 20_000):
            for name, value in (("MaximumEdgeLength", 0.3), ("TimeStep", 0.01), ("PolygonEdgeLength", 0.1)):
                with self.subTest(limit=limit, setting=name):
                    data = sheared(rng.uniform(0.5, 1.8), rng.uniform(0, 0.1))
                    smoke, messages = update(flow_volume(data, Radius=1, Duration=20.0, MaximumNumberOfTetrahedra=limit, **{name: value}))
                    self.assertTrue(len(messages) == 1 and "coarser than requested" in messages[0] and "Allow more" in messages[0], messages)
                    self.check(smoke, limit, 20.0)


class Polygons(unittest.TestCase):
    """An L that is not convex: 3/4 of a square of side 0.4."""
    CORNERS = np.array([(0, 0, 0), (0.4, 0, 0), (0.4, 0.2, 0), (0.2, 0.2, 0), (0.2, 0.4, 0), (0, 0.4, 0)]) + (-0.2, -0.2, -0.8)

    def smoke(self, corners=CORNERS, messages=0, **settings):
        made = flow_volume(cube(), **{**SETTINGS, **settings})
        source = polygon(*corners)
        made.SetPolygonConnection(source.GetOutputPort())
        smoke, told = update(made)
        self.assertEqual(len(told), messages, told)
        return smoke, told

    def test_not_convex(self):
        smoke, _ = self.smoke(NormalToFlow=False, PolygonEdgeLength=0.06)
        self.assertAlmostEqual(smoke.mass(), 0.12 * WIND[2], places=10)
        self.assertTrue(smoke.is_one_piece())
        first = smoke.points[smoke.age == 0]
        self.assertTrue(((first[:, 0] <= 1e-9) | (first[:, 1] <= 1e-9)).all())

    def test_stays_as_it_is(self):
        """Unless NormalToFlow is set, a polygon of one's own is not turned; a regular one is."""
        smoke, _ = self.smoke()
        self.assertAlmostEqual(smoke.mass(), 0.12 * WIND[2], places=10)
        np.testing.assert_allclose(np.abs(smoke.made.GetNormalUsed()), (0, 0, 1), atol=1e-12)
        regular = update(flow_volume(cube(), **SETTINGS))[0]
        np.testing.assert_allclose(regular.made.GetNormalUsed(), WIND / np.linalg.norm(WIND), atol=1e-9)

    def test_turned(self):
        smoke, _ = self.smoke(NormalToFlow=True)
        self.assertAlmostEqual(smoke.mass(), 0.12 * np.linalg.norm(WIND), places=10)
        np.testing.assert_allclose(smoke.made.GetNormalUsed(), WIND / np.linalg.norm(WIND), atol=1e-9)

    def test_moved(self):
        producer = polygon(*self.CORNERS)
        made = flow_volume(cube(), **SETTINGS)
        made.SetPolygonConnection(producer.GetOutputPort())
        update(made)
        producer.GetOutputDataObject(0).SetPoints(meshes.vtk_points(self.CORNERS + (0.1, 0, 0)))
        smoke, messages = update(made)
        self.assertEqual(messages, [])
        self.assertAlmostEqual(smoke.points[smoke.age == 0][:, 0].max(), 0.3, delta=0.02)

    def test_bad(self):
        for corners in (self.CORNERS[:2], np.tile(self.CORNERS[:1], (3, 1)), self.CORNERS[:1] + np.outer(range(4), (0.1, 0.1, 0))):
            smoke, _ = self.smoke(corners, messages=1)
            self.assertEqual(len(smoke.cells), 0)
        bent = self.CORNERS + np.outer([0, 0, 1, 0, 0, 0], (0, 0, 0.2))
        self.assertEqual(len(self.smoke(bent, messages=1)[0].cells), 0)


if __name__ == "__main__":
    unittest.main()
