# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkSmokePuffs: what it adds and shares, how puffs move, what time it asks of its input, what it says of bad input."""
import unittest

import nephoscope
import numpy as np
from nephoscope_testing import meshes
from nephoscope_testing.messages import Messages
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonDataModel import VTK_TETRA, vtkUnstructuredGrid
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline


def column(count=40, step=0.5, density=None):
    """Tetrahedra one after the other along x, aged (i + 1/2) step, between points of age i step: no flow volume, but its arrays."""
    corners = [(0, 0, 0), (0, 1, 0), (0, 0, 1)]
    points = np.array([(x, y, z) for x in range(count + 1) for _, y, z in corners], float)
    data = meshes.grid(points, [(VTK_TETRA, (3 * i, 3 * i + 1, 3 * i + 2, 3 * i + 3)) for i in range(count)])
    meshes.add_array(data.GetPointData(), step * points[:, 0], "Age")
    cells = data.GetCellData()
    meshes.add_array(cells, step * (np.arange(count) + 0.5), "Age")
    meshes.add_array(cells, np.ones(count) if density is None else np.asarray(density, float), "Density")
    return data


def pulse(age, time, period, width=0.5, floor=0.1):
    """By the documentation, from the nearest crest."""
    crests = time + period * np.arange(-200, 200)
    away = np.abs(np.asarray(age)[:, None] - crests[None]).min(axis=1) / period
    return floor + (1 - floor) * np.where(away < width / 2, np.cos(np.pi * away / width) ** 2, 0)


def puffs(data=None, **settings):
    made = nephoscope.vtkSmokePuffs()
    if data is not None:
        made.SetInputData(data)
    for name, value in settings.items():
        getattr(made, "Set" + name)(value)
    return made


def smoke(made, time=None, points=False):
    if time is None:
        made.Update()
    else:
        made.UpdateTimeStep(time)
    out = made.GetOutput()
    return vtk_to_numpy((out.GetPointData() if points else out.GetCellData()).GetArray("SmokeDensity"))


class Source(VTKPythonAlgorithmBase):
    """A column that counts how often it is made, for which time, and says what times it has."""

    def __init__(self, steps=(), time_range=None):
        super().__init__(nInputPorts=0, nOutputPorts=1, outputType="vtkUnstructuredGrid")
        self.steps, self.time_range, self.asked = list(steps), time_range, []

    def RequestInformation(self, _request, _inputs, outputs):
        info = outputs.GetInformationObject(0)
        if self.steps:
            info.Set(Pipeline.TIME_STEPS(), self.steps, len(self.steps))
        if self.time_range:
            info.Set(Pipeline.TIME_RANGE(), self.time_range, 2)
        return 1

    def RequestData(self, _request, _inputs, outputs):
        info = outputs.GetInformationObject(0)
        wanted = info.Get(Pipeline.UPDATE_TIME_STEP()) if info.Has(Pipeline.UPDATE_TIME_STEP()) else None
        self.asked.append(wanted)
        data = column()
        if wanted is not None:
            data.GetInformation().Set(data.DATA_TIME_STEP(), wanted)
        vtkUnstructuredGrid.GetData(outputs).ShallowCopy(data)
        return 1


class Output(unittest.TestCase):
    def test_points_and_cells_are_shared(self):
        data = column()
        made = puffs(data, Period=4)
        made.Update()
        out = made.GetOutput()
        self.assertIs(out.GetPoints(), data.GetPoints())
        self.assertIs(out.GetCells(), data.GetCells())
        for name in ("Age", "Density"):
            self.assertIs(out.GetCellData().GetArray(name), data.GetCellData().GetArray(name))
        self.assertEqual(out.GetCellData().GetNumberOfArrays(), 3)
        self.assertIsNone(data.GetCellData().GetArray("SmokeDensity"))

    def test_is_density_times_pulse(self):
        density = np.linspace(0.2, 9, 40)
        made = puffs(column(density=density), Period=4.3, Width=0.4, Floor=0.25)
        for time in (0, 0.7, -3.1, 11.0):
            made.SetTime(time)
            expected = density * pulse(0.5 * (np.arange(40) + 0.5), time, 4.3, 0.4, 0.25)
            np.testing.assert_allclose(smoke(made), expected, atol=1e-12)

    def test_points(self):
        """Density is the mean over the cells of a point, the age that of the point."""
        density = np.linspace(0.2, 9, 40)
        data = column(density=density)
        made = puffs(data, Period=4.3, Association=nephoscope.vtkSmokePuffs.POINTS)
        found = smoke(made, 0.9, points=True)
        mean = np.zeros(123)
        mean[:120] = np.repeat(density, 3)
        mean[3:120:3] = (density[:-1] + density[1:]) / 2  # where one tetrahedron ends and the next begins
        mean[120] = density[-1]
        ages = vtk_to_numpy(data.GetPointData().GetArray("Age"))
        np.testing.assert_allclose(found, mean * pulse(ages, 0.9, 4.3), atol=1e-12)
        self.assertIsNone(made.GetOutput().GetCellData().GetArray("SmokeDensity"))
        vtk_to_numpy(data.GetCellData().GetArray("Density"))[:] *= 2
        data.GetCellData().GetArray("Density").Modified()
        data.Modified()
        np.testing.assert_allclose(smoke(made, 0.9, points=True), 2 * found, atol=1e-12)
        made.SetAssociationToCells()
        smoke(made, 0.9)
        self.assertIsNone(made.GetOutput().GetPointData().GetArray("SmokeDensity"))

    def test_maximum_density(self):
        density = np.linspace(0.2, 9, 40)
        free, cut = puffs(column(density=density), Period=4), puffs(column(density=density), Period=4, MaximumDensity=3)
        np.testing.assert_allclose(smoke(cut), smoke(free) * np.minimum(density, 3) / density, atol=1e-12)

    def test_mean_normalization_keeps_the_mass(self):
        """8 cells to a period, pulses of 4: samples of a cosine square at equal distances add up to its mean."""
        made = puffs(column(), Period=4, Floor=0.2)
        made.SetNormalizationToMean()
        for time in (0, 0.1, 0.33, 1.7):
            self.assertAlmostEqual(smoke(made, time).mean(), 1, places=12)
        made.SetNormalizationToPeak()
        self.assertAlmostEqual(smoke(made, 0.25).max(), 1, places=12)
        self.assertAlmostEqual(smoke(made, 0.25).mean(), 0.2 + 0.8 * 0.25, places=12)

    def test_floor_one_is_the_density(self):
        density = np.linspace(0.2, 9, 40)
        np.testing.assert_array_equal(smoke(puffs(column(density=density), Period=4, Floor=1)), density)

    def test_arrays_of_other_types(self):
        data = column()
        meshes.add_array(data.GetCellData(), np.arange(40).astype("f4"), "Age")
        meshes.add_array(data.GetCellData(), np.full(40, 2), "Density")
        np.testing.assert_allclose(smoke(puffs(data, Period=7)), 2 * pulse(np.arange(40), 0, 7), atol=1e-12)

    def test_puffs_of_puffs(self):
        """The older array is replaced, wherever it was."""
        first = puffs(column(), Period=4, Association=1)
        second = puffs(Period=3)
        second.SetInputConnection(first.GetOutputPort())
        np.testing.assert_allclose(smoke(second), smoke(puffs(column(), Period=3)))
        self.assertIsNone(second.GetOutput().GetPointData().GetArray("SmokeDensity"))


class Motion(unittest.TestCase):
    def test_a_loop_closes(self):
        made = puffs(column(), Period=4)
        first = smoke(made, 0).copy()
        for periods in (1, 2, 7):
            np.testing.assert_allclose(smoke(made, 4 * periods), first, atol=1e-12)
        self.assertGreater(np.abs(smoke(made, 2) - first).max(), 0.5)

    def test_puffs_go_with_the_flow(self):
        """In a uniform flow of 3 m/s the centre of a puff, by its density, moves downstream by 3 m/s."""
        flow = nephoscope.vtkFlowVolume()
        image = meshes.image((16, 8, 8), (1, 1, 1))
        meshes.add_array(image.GetPointData(), np.tile([3.0, 0, 0], (image.GetNumberOfPoints(), 1)), "DisplayVelocity")
        flow.SetInputData(image)
        flow.SetCenter(0.5, 4, 4)
        flow.SetRadius(1)
        flow.SetDuration(5)
        flow.SetTimeStep(0.05)
        made = puffs(Period=5, Width=0.2, Floor=0)
        made.SetInputConnection(flow.GetOutputPort())
        centres, times = [], np.linspace(1, 4, 13)
        for time in times:
            density = smoke(made, time)
            out = made.GetOutput()
            middles = np.array([np.mean([out.GetPoint(out.GetCell(i).GetPointId(k)) for k in range(4)], axis=0)
                                for i in np.flatnonzero(density)])
            centres.append(np.average(middles, axis=0, weights=density[density > 0]))
        centres = np.array(centres)
        np.testing.assert_allclose(centres[:, 0], 0.5 + 3 * times, atol=0.02)
        np.testing.assert_allclose(centres[:, 1:], 4, atol=0.05)


class Time(unittest.TestCase):
    def connected(self, source, **settings):
        made = puffs(**settings)
        made.SetInputConnection(source.GetOutputPort())
        return made

    def announced(self, made):
        made.UpdateInformation()
        info = made.GetOutputInformation(0)
        steps = info.Get(Pipeline.TIME_STEPS()) if info.Has(Pipeline.TIME_STEPS()) else ()
        return info.Get(Pipeline.TIME_RANGE()), steps

    def test_input_without_time_runs_once(self):
        source = Source()
        made = self.connected(source, Period=4)
        self.assertEqual(self.announced(made), ((0, 4), ()))
        found = [smoke(made, t).copy() for t in (0, 0.5, 1.0, 4.0)]
        self.assertEqual(source.asked, [None])
        self.assertGreater(np.abs(found[1] - found[0]).max(), 0.1)
        np.testing.assert_allclose(found[3], found[0], atol=1e-12)
        self.assertEqual(made.GetOutput().GetInformation().Get(made.GetOutput().DATA_TIME_STEP()), 4.0)

    def test_only_time_step_is_asked_for_once(self):
        source = Source([6792.0], [6792.0, 6792.0])
        made = self.connected(source, Period=4)
        self.assertEqual(self.announced(made), ((6792, 6796), ()))
        for time in (6792.0, 6793.0, 6795.5):
            np.testing.assert_allclose(smoke(made, time), pulse(0.5 * (np.arange(40) + 0.5), time - 6792, 4), atol=1e-9)
        self.assertEqual(source.asked, [6792.0])

    def test_time_series_is_passed_on(self):
        source = Source([1.0, 2.0, 4.0], [1.0, 4.0])
        made = self.connected(source, Period=3)
        self.assertEqual(self.announced(made), ((1, 4), (1, 2, 4)))
        smoke(made, 2.0)
        smoke(made, 4.0)
        self.assertEqual(source.asked, [2.0, 4.0])

    def test_unsteady_smoke_keeps_its_pulse(self):
        """Released at time - age: at any later time, the smoke of one release has the same pulse."""
        made = self.connected(Source([0.0, 0.5, 7.5], [0.0, 7.5]), Period=3)
        early, late = smoke(made, 0.5).copy(), smoke(made, 7.5)
        np.testing.assert_allclose(late[14:], early[:-14], atol=1e-12)  # 7 s later it is 14 cells on

    def test_time_scale(self):
        made = self.connected(Source(), Period=4, TimeScale=0.5)
        self.assertEqual(self.announced(made)[0], (0, 8))
        np.testing.assert_allclose(smoke(made, 2), smoke(puffs(column(), Period=4, Time=1)), atol=1e-12)

    def test_time_without_a_request(self):
        made = puffs(column(), Period=4, Time=1.0, TimeScale=1000.0)
        np.testing.assert_allclose(smoke(made), pulse(0.5 * (np.arange(40) + 0.5), 1.0, 4), atol=1e-12)

    def test_automatic_period(self):
        """A quarter of the oldest age, 19.75 s."""
        made = self.connected(Source())
        self.assertEqual(self.announced(made)[0], (0, 1))  # not known yet
        np.testing.assert_allclose(smoke(made, 1.0), pulse(0.5 * (np.arange(40) + 0.5), 1.0, 19.75 / 4), atol=1e-12)
        self.assertEqual(made.GetActualPeriod(), 19.75 / 4)
        self.assertEqual(self.announced(made)[0], (0, 19.75 / 4))
        late = puffs()
        late.SetInputConnection(made.GetInputConnection(0, 0))
        self.assertEqual(self.announced(late)[0], (0, 19.75 / 4))  # the data are there already


class BadInput(unittest.TestCase):
    def told(self, data, *texts, **settings):
        made = puffs(data, **settings)
        with Messages() as messages:
            made.Update()
        self.assertEqual(len(messages.all), len(texts), messages.all)
        for text, message in zip(texts, messages.all):
            self.assertIn(text, message)
        return made.GetOutput()

    def test_puffs_shorter_than_the_steps(self):
        """They fall between the cells; told once for each period."""
        data = column()
        meshes.add_array(data.GetCellData(), np.arange(40), "EmissionStep")
        self.told(data, "Period is 1.9 s, the time step is 0.5 s. Set Period to 2 s or more, or make the flow volume with time steps of 0.475 s or less", Period=1.9)
        for settings in ({"Period": 2.0}, {"Period": 1.9, "Width": 0.6}, {"Period": 1.9, "Floor": 1.0}, {}):
            self.told(data, **settings)
        self.told(column(), Period=1.9)  # nothing is known of its steps
        made = puffs(data, Period=1.0)
        with Messages() as messages:
            for time in (0.0, 0.1, 0.2):
                smoke(made, time)
            made.SetPeriod(1.1)
            smoke(made)
        self.assertEqual(len(messages.all), 2, messages.all)

    def test_missing_arrays(self):
        for name in ("Age", "Density"):
            data = column()
            data.GetCellData().RemoveArray(name)
            out = self.told(data, f"There is no numeric array '{name}' on cells")
            self.assertEqual(out.GetNumberOfCells(), 0)  # cells of another field would look like smoke
        data = column()
        data.GetPointData().RemoveArray("Age")
        self.told(data, "There is no numeric array 'Age' on points", Association=1)
        self.told(data)

    def test_wrong_arrays(self):
        data = column()
        meshes.add_array(data.GetCellData(), np.ones((40, 3)), "Density")
        self.told(data, "'Density' has 40 values of 3 components where the input has 40 cells")
        data = column()
        meshes.add_array(data.GetCellData(), np.ones(7), "Age")
        self.told(data, "'Age' has 7 values of 1 components where the input has 40 cells")

    def test_values_that_are_no_numbers(self):
        for name, bad in (("Age", np.nan), ("Age", np.inf), ("Density", np.nan), ("Density", np.inf)):
            data = column()
            vtk_to_numpy(data.GetCellData().GetArray(name))[[3, 9]] = bad
            out = self.told(data, "2 cells have no smoke", Period=4, MaximumDensity=2)
            found = vtk_to_numpy(out.GetCellData().GetArray("SmokeDensity"))
            self.assertEqual(found[3], 0)
            self.assertTrue(np.isfinite(found).all())
            self.assertGreater((found > 0).sum(), 37)

    def test_empty(self):
        self.assertEqual(self.told(vtkUnstructuredGrid(), "The input is empty").GetNumberOfCells(), 0)
        made = puffs(vtkUnstructuredGrid(), Association=1)
        made.Update()

    def test_settings_are_clamped(self):
        made = puffs(Period=-1.0, Width=7.0, Floor=-0.5, MaximumDensity=-2.0)
        self.assertEqual((made.GetPeriod(), made.GetWidth(), made.GetFloor(), made.GetMaximumDensity()), (0, 1, 0, 0))


if __name__ == "__main__":
    unittest.main()
