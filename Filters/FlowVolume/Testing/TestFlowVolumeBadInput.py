# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Each bad input gets its own message, which names the cause and the remedy; nothing crashes, nothing is put out."""
import unittest

import numpy as np
from nephoscope_testing import meshes
from nephoscope_testing.flow import flow_volume, update
from vtkmodules.vtkCommonDataModel import vtkDataSetAttributes, vtkImageData, vtkMultiBlockDataSet, vtkPolyData, vtkTable
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer
from vtkmodules.vtkFiltersCore import vtkThreshold


def cube(velocity=(0, 0, 1), name="Flow"):
    data = meshes.image((4, 4, 4), (0.5,) * 3, (-1,) * 3)
    points = meshes.points_of(data)
    values = velocity(points) if callable(velocity) else np.tile(np.asarray(velocity, float), (len(points), 1))
    meshes.add_array(data.GetPointData(), values, name)
    return data


class BadInput(unittest.TestCase):
    def expect(self, data, *texts, polygon=None, **settings):
        """One message that holds all the texts, and no cells."""
        made = flow_volume(data, **{"Radius": 0.1, "Duration": 0.5, **settings})
        if polygon is not None:
            producer = vtkTrivialProducer()
            producer.SetOutput(polygon)
            made.SetPolygonConnection(producer.GetOutputPort())
        smoke, messages = update(made)
        self.assertEqual(len(messages), 1, messages)
        for text in texts:
            self.assertIn(text, messages[0])
        self.assertEqual(len(smoke.cells), 0)
        return smoke

    def test_no_input(self):
        self.expect(None, "Input port 0", "0 connections")

    def test_empty(self):
        for data in (vtkImageData(), vtkMultiBlockDataSet(), meshes.grid(np.empty((0, 3)), []), vtkTable(), vtkPolyData()):
            self.expect(data, "has no cells")

    def test_points_without_cells(self):
        data = meshes.grid(np.zeros((4, 3)), [])
        meshes.add_array(data.GetPointData(), np.ones((4, 3)), "Flow")
        self.expect(data, "has no cells")

    def test_no_velocity(self):
        data = meshes.with_field(meshes.image((2, 2, 2)), lambda p: p[:, 0])
        self.expect(data, "has no velocity", "Merge Vector Components")
        self.expect(data, "'s' has 1 components", "three", Velocity="s")
        self.expect(cube(), "no point array 'Wind'", "'Flow'", Velocity="Wind")
        self.expect(cube(), "no cell array 'Flow'", "It is on points", Velocity=("Flow", 1))

    def test_several_that_may_be_it(self):
        data = cube()
        meshes.add_array(data.GetPointData(), np.ones((125, 3)), "Gradient")
        self.expect(data, "several arrays", "'Flow', 'Gradient'", "choose one of them")

    def test_polygon_outside(self):
        self.expect(cube(), "(3, 0, 0) is outside the data, which are within x -1 to 1", "move the polygon", Center=(3, 0, 0))
        self.expect(cube(), "No smoke comes", "outside the data", Center=(3, 0, 0), NormalToFlow=False)

    def test_polygon_in_a_hole(self):
        """Inside the bounds, but in no cell: the message says so and names a place with a flow, which works."""
        hollow = vtkThreshold()
        data = cube()
        meshes.add_array(data.GetPointData(), np.linalg.norm(meshes.points_of(data), axis=1), "r")
        hollow.SetInputData(data)
        hollow.SetInputArrayToProcess(0, 0, 0, 0, "r")
        hollow.SetUpperThreshold(0.6)
        hollow.SetThresholdFunction(vtkThreshold.THRESHOLD_UPPER)
        hollow.Update()
        for settings in ({}, {"NormalToFlow": False}):
            self.expect(hollow.GetOutput(), "(0.2, 0.15, 0.1) is in no cell", "within the bounds", "in a hole", "by Center", Center=(0.2, 0.15, 0.1), Radius=0.02, **settings)
        nearest = (0.75, 0.75, 0.25)
        made = flow_volume(hollow.GetOutput(), Center=(0.2, 0.15, 0.1), Radius=0.02, Duration=0.1)
        self.assertIn("The nearest cell is around (0.75, 0.75, 0.25)", update(made)[1][0])
        smoke, messages = update(flow_volume(hollow.GetOutput(), Center=nearest, Radius=0.02, Duration=0.1))
        self.assertTrue(len(smoke.cells) and not messages, messages)

    def test_polygon_partly_outside(self):
        smoke, messages = update(flow_volume(cube(), Center=(0.95, 0, 0), Radius=0.2, Duration=0.5))
        self.assertTrue(len(messages) == 1 and "points of the generating polygon are outside the data" in messages[0], messages)
        self.assertGreater(len(smoke.cells), 0)

    def test_polygon_larger_than_the_data(self):
        """With its centre alone inside: shorter edges help, turning it does not."""
        for settings in ({"Radius": 100}, {"Radius": 1e20}, {"Radius": 100, "NormalToFlow": False}):
            smoke, messages = update(flow_volume(cube(), Duration=0.5, **settings))
            self.assertEqual(len(messages), 2, messages)
            self.assertIn("points of the generating polygon are outside the data", messages[0])
            self.assertIn("Shorten PolygonEdgeLength", messages[1])
            self.assertEqual(len(smoke.cells), 0)
        self.expect(cube(), "smaller Radius", Radius=1e300)

    def test_too_thin(self):
        """No tetrahedron has a volume that the coordinates could resolve: all of the mass is lost."""
        for settings in ({"Radius": 1e-12}, {"Duration": 1e-18}):
            smoke = self.expect(cube(), "too thin for the precision", **settings)
            self.assertGreater(smoke.made.GetEmittedMass(), 0)
            self.assertEqual(smoke.made.GetLostMass(), smoke.made.GetEmittedMass())

    def test_blanked_at_the_polygon(self):
        data = cube()
        meshes.add_array(data.GetCellData(), np.full(64, vtkDataSetAttributes.HIDDENCELL, np.uint8), "vtkGhostType")
        self.expect(data, "is blanked")

    def test_missing_values_at_the_polygon(self):
        for settings in ({}, {"NormalToFlow": False}):
            self.expect(cube((np.nan, 0, 1)), "is not a finite number", "replace the missing values", **settings)
        self.expect(cube((np.inf, 0, 1)), "is not a finite number")

    def test_no_flow(self):
        data = cube()
        still = np.where(np.abs(meshes.points_of(data)[:, :1]) < 0.9, 0.0, [[0.0, 0.0, 1.0]])
        meshes.add_array(data.GetPointData(), still, "Flow")
        self.expect(data, "'Flow') is zero at the centre", "move the polygon")
        self.expect(data, "'Flow') is zero at the generating polygon", NormalToFlow=False)
        for settings in ({}, {"NormalToFlow": False}):
            self.expect(cube((0, 0, 0)), "'Flow') is zero everywhere", "another array", **settings)

    def test_parallel_flow(self):
        self.expect(cube((1, 0, 0)), "parallel to the generating polygon", "NormalToFlow", NormalToFlow=False)
        self.expect(cube((0.3, 0.1, 0.2)), "parallel", NormalToFlow=False, Normal=(0, 2, -1))

    def test_settings(self):
        for name in ("Radius", "PolygonEdgeLength", "Duration", "TimeStep", "MaximumEdgeLength", "MinimumEdgeLength", "MaximumAreaRatio",
                     "MaximumDivergence", "ObstacleSize"):
            for value in (-1.0, np.nan, np.inf):
                self.expect(cube(), f"{name} is {value:g}", "must be positive", **{name: value})
        self.expect(cube(), "Center and Normal", Center=(np.nan, 0, 0))
        self.expect(cube(), "Normal is (0, 0, 0)", Normal=(0, 0, 0), NormalToFlow=False)
        self.expect(cube(), "InitialDensity (nan)", InitialDensity=np.nan)
        self.expect(cube(), "more than a million steps", "longer TimeStep", TimeStep=1e-8)
        self.expect(cube(), "more than a million steps", TimeStep=1e-320)
        self.expect(cube(), "Choose a longer PolygonEdgeLength", PolygonEdgeLength=1e-9)

    def test_polygons_without_polygons(self):
        self.expect(cube(), "polygon", polygon=vtkPolyData())

    def test_limit(self):
        smoke, messages = update(flow_volume(cube(), Radius=0.1, Duration=0.5, MaximumNumberOfTetrahedra=1000))
        self.assertTrue(len(messages) == 1 and "MaximumNumberOfTetrahedra (1000)" in messages[0], messages)
        self.assertLessEqual(len(smoke.cells), 1000)
        self.assertGreater(len(smoke.cells), 300)
        self.assertAlmostEqual(smoke.mass() / smoke.made.GetEmittedMass(), 1, places=9)
        self.assertAlmostEqual(smoke.age.max(), 0.5, places=9, msg="it ends early")

    def test_limit_out_of_reach(self):
        """Even the coarsest volume has more: it ends early, and says so."""
        smoke, messages = update(flow_volume(cube(), Radius=0.1, Duration=0.5, MaximumNumberOfTetrahedra=5))
        self.assertTrue(len(messages) == 1 and "ends early" in messages[0] and "Allow more" in messages[0], messages)
        self.assertLessEqual(len(smoke.cells), 5)

    def test_ended_at_once(self):
        smoke = self.expect(cube(), "ended at once", "Shorten TimeStep", Center=(0, 0, 0.9), TimeStep=0.3)
        self.assertAlmostEqual(smoke.made.GetLostMass() / smoke.made.GetEmittedMass(), 1, places=12)

    def test_one_cell(self):
        data = meshes.image((1, 1, 1), (2,) * 3, (-1,) * 3)
        meshes.add_array(data.GetPointData(), np.tile([0.0, 0.0, 1.0], (8, 1)), "Flow")
        smoke, messages = update(flow_volume(data, Radius=0.1, Duration=0.5))
        self.assertEqual(messages, [])
        self.assertAlmostEqual(smoke.points[:, 2].max(), 0.5, places=12)

    def test_flat_data(self):
        """A plane has no cells with an inside of its own in three dimensions; whatever is answered is said."""
        data = meshes.image((4, 4, 0), (0.5,) * 3, (-1, -1, 0))
        meshes.add_array(data.GetPointData(), np.tile([1.0, 0.0, 0.0], (25, 1)), "Flow")
        made = flow_volume(data, Radius=0.1, Duration=0.5)
        smoke, messages = update(made)
        self.assertEqual(len(smoke.cells), 0)
        self.assertGreater(len(messages), 0)

    def test_results_after_an_error(self):
        made = flow_volume(cube(), Radius=0.1, Duration=0.5)
        update(made)
        self.assertGreater(made.GetEmittedMass(), 0)
        made.SetCenter(9, 9, 9)
        update(made)
        self.assertEqual((made.GetEmittedMass(), made.GetLostMass(), made.GetDurationUsed(), made.GetTimeStepUsed()), (0, 0, 0, 0))
        self.assertEqual(made.GetNormalUsed(), (0, 0, 0))


if __name__ == "__main__":
    unittest.main()
