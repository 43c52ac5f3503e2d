# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The place that hosts start smoke from: the flow goes far from there, and does not leave the data at once."""
import unittest

import numpy as np
from nephoscope import vtkFlowVolume, vtkFlowVolumePlacement
from nephoscope_testing import meshes
from nephoscope_testing.messages import Messages
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.util.misc import calldata_type
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkDataSetAttributes, vtkRectilinearGrid, vtkStructuredGrid
from vtkmodules.vtkFiltersCore import vtkAppendFilter


def box(velocity, cells=(24, 24, 12), size=(2.0, 2.0, 1.0), origin=(-1.0, -1.0, -0.5)):
    data = meshes.image(cells, [s / n for s, n in zip(size, cells)], origin)
    places = np.array([data.GetPoint(i) for i in range(data.GetNumberOfPoints())])
    meshes.add_array(data.GetPointData(), velocity(*places.T).T, "Flow")
    return data


def whirl(x, y, z):
    """Fastest in the corners, where it leaves the data at once."""
    return np.array([-y, x, 0 * z])


def channel(x, y, z):
    return np.array([1 - y ** 2, 0 * y, 0 * z])


def outlet(x, y, z):
    """Ten times as fast just before the outlet."""
    return np.array([1 + 9 * (x > 0.8), 0 * y, 0 * z])


def eye(x, y, z):
    """A small vortex, by far the fastest, in a slow flow along y."""
    near = np.exp(-((x - 0.5) ** 2 + y ** 2) / 0.003)
    return np.array([-40 * y * near, 1 + 40 * (x - 0.5) * near, 0 * z])


def saddle(x, y, z):
    return np.array([x, -y, 0.05 + 0 * z])


def body(x, y, z):
    """Potential flow around a ball, which is still inside."""
    r2 = np.maximum(x * x + y * y + z * z, 1e-9)
    half = 0.5 * (0.3 / np.sqrt(r2)) ** 3
    return np.where(r2 < 0.09, 0, np.array([1 + half - 3 * half * x * x / r2, -3 * half * x * y / r2, -3 * half * x * z / r2]))


def jet(x, y, z):
    return np.array([0.05 + np.exp(-25 * (y ** 2 + z ** 2)), 0 * y, 0 * z])


FLOWS = {"whirl": (whirl, 0.9), "channel": (channel, 0.6), "outlet": (outlet, 0.8), "eye": (eye, 0.7), "saddle": (saddle, 0.7),
         "uniform": (lambda x, y, z: np.array([1 + 0 * x, 0 * y, 0 * z]), 0.5), "jet": (jet, 0.5), "body": (body, 0.5)}


def storages(data):
    """The same cells as an image, as grids, and as unstructured data, with points in double and single precision."""
    yield "image", data
    rectilinear = vtkRectilinearGrid()
    rectilinear.SetDimensions(data.GetDimensions())
    points = meshes.points_of(data)
    for axis, set_axis in enumerate((rectilinear.SetXCoordinates, rectilinear.SetYCoordinates, rectilinear.SetZCoordinates)):
        set_axis(numpy_to_vtk(np.unique(points[:, axis]), deep=True))
    rectilinear.GetPointData().ShallowCopy(data.GetPointData())
    yield "rectilinear", rectilinear
    for kind in (float, np.float32):
        grid, places = vtkStructuredGrid(), vtkPoints()
        places.SetData(numpy_to_vtk(points.astype(kind), deep=True))
        grid.SetDimensions(data.GetDimensions())
        grid.SetPoints(places)
        grid.GetPointData().ShallowCopy(data.GetPointData())
        yield f"structured, {kind.__name__}", grid
        append = vtkAppendFilter()
        append.SetInputData(grid)
        append.Update()
        yield f"unstructured, {kind.__name__}", append.GetOutput()


class Placement(unittest.TestCase):
    def extent(self, data):
        """Diagonal of the bounds of the smoke, as a share of half the diagonal of the data."""
        place = vtkFlowVolumePlacement()
        self.assertTrue(place.Find(data))
        self.assertGreater(place.GetQuality(), 0)
        smoke = vtkFlowVolume()
        smoke.SetInputData(data)
        smoke.SetCenter(place.GetCenter())
        smoke.SetRadius(place.GetRadius())
        smoke.Update()
        bounds = np.reshape(smoke.GetOutput().GetBounds(), (3, 2))
        ages = vtk_to_numpy(smoke.GetOutput().GetCellData().GetArray("Age"))
        return np.linalg.norm(np.ptp(bounds, axis=1)) / (data.GetLength() / 2), ages.max()

    def test_smoke_goes_far(self):
        for name, (velocity, least) in FLOWS.items():
            with self.subTest(name):
                extent, _ = self.extent(box(velocity))
                self.assertGreater(extent, least)

    def test_long_way_in_a_stagnation_flow(self):
        """Whose fastest places are the corners, where it leaves the data at once; in a cube, every n-th of whose cells lies in few planes."""
        data = box(lambda x, y, z: np.array([x, -y, 1 + 0 * z]), (20, 20, 20), (20.0, 20.0, 20.0), (-10.0, -10.0, -10.0))
        extent, _ = self.extent(data)
        self.assertGreater(extent, 0.65)

    def test_place_does_not_depend_on_the_storage(self):
        for name, (velocity, _) in FLOWS.items():
            found = {}
            for kind, data in storages(box(velocity)):
                place = vtkFlowVolumePlacement()
                self.assertTrue(place.Find(data))
                found[kind] = (*place.GetCenter(), *place.GetNormal(), place.GetRadius())
            for kind, place in found.items():
                np.testing.assert_allclose(place, found["image"], atol=1e-5, err_msg=f"{name}, {kind}")

    def test_message_where_smoke_leaves_at_once(self):
        """One, which names the remedy; none where the smoke goes far, or is lost at the end of a long way."""
        data = box(saddle)
        for center, duration, expected in (((-0.9, -0.8, 0.0), 0.0, 1), ((0.1, 0.8, 0.0), 0.0, 0), ((0.1, 0.8, 0.0), 50.0, 0)):
            smoke = vtkFlowVolume()
            warnings = []

            @calldata_type(VTK_STRING)
            def note(caller, event, text):
                warnings.append(text)
            smoke.AddObserver("WarningEvent", note)
            smoke.SetInputData(data)
            smoke.SetCenter(center)
            smoke.SetDuration(duration)
            smoke.Update()
            self.assertEqual(len([text for text in warnings if "leaves the data at once" in text and "Center" in text]), expected, f"{center}, {warnings}")

    def test_the_air_of_a_globe_is_thin(self):
        """The message names the remedy where heights are hardly exaggerated, and on a globe alone."""
        for projection, exaggeration, expected in ((0, 1, True), (0, 30, False), (1, 1, False)):
            data = box(saddle)
            for name, value in (("GlobeGridProjection", projection), ("VerticalExaggeration", exaggeration)):
                array = numpy_to_vtk(np.array([float(value)]), deep=True)
                array.SetName(name)
                data.GetFieldData().AddArray(array)
            with Messages() as messages:
                smoke = vtkFlowVolume()
                smoke.SetInputData(data)
                smoke.SetCenter((-0.9, -0.8, 0.0))
                smoke.Update()
            self.assertEqual("exaggerate its heights first (vertical exaggeration, now 1)" in " ".join(messages.warnings), expected)

    def test_no_faster_place_is_left_for_nothing(self):
        """In a channel the smoke is in its middle, where the flow is fastest."""
        place = vtkFlowVolumePlacement()
        self.assertTrue(place.Find(box(channel)))
        self.assertLess(abs(place.GetCenter()[1]), 0.3)
        self.assertAlmostEqual(place.GetRadius(), 3 * 3 / 50)  # of the diagonal, 3; three times as wide at the inflow

    def test_room_around_the_polygon(self):
        """Along a wall, where a flow without friction is fastest, smoke would lose a part at once."""
        data = box(lambda x, y, z: np.array([1.5 + z, 0 * y, 0 * z]))
        place = vtkFlowVolumePlacement()
        self.assertTrue(place.Find(data))
        room = 0.5 - abs(place.GetCenter()[2])
        self.assertGreater(room, 2.9 * 3 / 50)  # of the diagonal
        self.assertGreater(room, 2 * place.GetRadius())

    def test_inflow(self):
        """Where flow passes through, smoke starts where it enters, in a polygon that has as much room around it as in it, and is nearly a sixth as wide as the data or more."""
        def duct(length, velocity, along=0):
            size = np.roll((length, 1.0, 1.0), along)
            return box(velocity, tuple(int(n) for n in 12 * size), tuple(size), tuple(-size / 2))

        def turned(angle):
            return lambda x, y, z: np.array([np.cos(angle) + 0 * x, np.sin(angle) + 0 * y, 0 * z])
        ducts = {"uniform": (duct(4, turned(0)), (1, 0, 0)), "backwards": (duct(4, turned(np.pi)), (-1, 0, 0)), "long": (duct(10, turned(0)), (1, 0, 0)),
                 "upwards": (duct(5, lambda x, y, z: np.array([0 * x, 0 * y, 2 + 0 * z]), 2), (0, 0, 1)), "askew": (duct(4, turned(0.1)), (1, 0, 0)),
                 "cube": (duct(1, turned(0)), (1, 0, 0)), "around a body": (box(body), (1, 0, 0)),
                 "with walls": (duct(6, lambda x, y, z: np.array([(1 - 4 * y * y) * (1 - 4 * z * z), 0 * y, 0 * z])), (1, 0, 0)),
                 "with a throat": (duct(6, lambda x, y, z: np.array([1 + 2.5 * np.exp(-3 * x * x), 0 * y, 0 * z])), (1, 0, 0))}
        for name, (data, along) in ducts.items():
            with self.subTest(name):
                place = vtkFlowVolumePlacement()
                self.assertTrue(place.Find(data))
                bounds, center, radius = np.reshape(data.GetBounds(), (3, 2)), np.array(place.GetCenter()), place.GetRadius()
                way = np.abs(along) @ np.ptp(bounds, axis=1)
                self.assertLess(np.dot(along, center) + way / 2, 0.1 * way)
                across = np.abs(along) < 0.5
                room = np.min((np.ptp(bounds, axis=1) / 2 - np.abs(center))[across])
                self.assertGreater(2 * radius, 0.16 * np.ptp(bounds, axis=1)[across].min())
                self.assertGreaterEqual(room, 1.5 * radius)

    def test_polygon_is_no_wider_than_a_jet(self):
        """A jet in a box of nearly still air: the polygon starts at the inflow, but is no wider than the jet."""
        place = vtkFlowVolumePlacement()
        self.assertTrue(place.Find(box(jet)))
        self.assertLess(place.GetCenter()[0], -0.9)
        self.assertAlmostEqual(place.GetRadius(), 3 / 50)

    def test_no_inflow_of_what_goes_round(self):
        """A vortex enters a box beside its corners, where there is no room: the polygon is not wider there, but where smoke goes far."""
        place = vtkFlowVolumePlacement()
        self.assertTrue(place.Find(box(whirl)))
        self.assertAlmostEqual(place.GetRadius(), 3 / 50)

    def test_narrow_data_have_a_small_polygon(self):
        place = vtkFlowVolumePlacement()
        self.assertTrue(place.Find(box(lambda x, y, z: np.array([1 + 0 * x, 0 * y, 0 * z]), (40, 4, 2), (4.0, 0.1, 0.05), (0.0, 0.0, 0.0))))
        self.assertLess(place.GetRadius(), 0.025)

    def test_all_points_of_the_polygon_are_inside(self):
        """Whatever the number of its sides, also where cells are hidden: there is nothing to warn of in a place that was chosen."""
        for name, (velocity, _) in FLOWS.items():
            for sides, holes in ((12, 0), (3, 0), (7, 40), (100, 120)):
                data = box(velocity)
                hidden = np.zeros(data.GetNumberOfCells(), np.uint8)
                hidden[np.random.default_rng(sides).choice(len(hidden), holes, replace=False)] = vtkDataSetAttributes.HIDDENCELL
                meshes.add_array(data.GetCellData(), hidden, vtkDataSetAttributes.GhostArrayName())
                place = vtkFlowVolumePlacement()
                place.SetNumberOfSides(sides)
                self.assertTrue(place.Find(data))
                smoke = vtkFlowVolume()
                warnings = []

                @calldata_type(VTK_STRING)
                def note(caller, event, text):
                    if "ended at obstacles" not in text:  # smoke that meets hidden cells on its way
                        warnings.append(text)
                smoke.AddObserver("WarningEvent", note)
                smoke.SetInputData(data)
                smoke.SetNumberOfSides(sides)
                smoke.SetCenter(place.GetCenter())
                smoke.SetRadius(place.GetRadius())
                smoke.Update()
                self.assertFalse(warnings, f"{name}, {sides} sides, {holes} hidden cells")

    def test_same_place_again(self):
        data = box(saddle)
        places = []
        for _ in range(2):
            place = vtkFlowVolumePlacement()
            place.Find(data)
            places.append((place.GetCenter(), place.GetRadius()))
        self.assertEqual(*places)

    def test_calm(self):
        self.assertFalse(vtkFlowVolumePlacement().Find(box(lambda x, y, z: np.zeros((3, len(x))))))


if __name__ == "__main__":
    unittest.main()
