# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""mesh.nephoscope.flow_volume and smoke_puffs: closed-form volumes, arguments, errors."""
import os
import unittest
import warnings

import nephoscope
import numpy as np
import pyvista
from pyvista.core.errors import MissingDataError
from vtkmodules.vtkCommonDataModel import vtkPartitionedDataSet, vtkPartitionedDataSetCollection

AREA = 12 / 2 * np.sin(2 * np.pi / 12)  # of the regular polygon of radius 1


def uniform(velocity=(2.0, 0.0, 0.0), n=9):
    """A cube of side 20 about the origin in a uniform wind."""
    mesh = pyvista.ImageData(dimensions=(n,) * 3, spacing=(20 / (n - 1),) * 3, origin=(-10,) * 3)
    mesh.point_data["wind"] = np.tile(velocity, (mesh.n_points, 1))
    mesh.point_data["x"] = mesh.points[:, 0]
    return mesh


def around_a_cylinder(radius=0.5, far=10.0):
    """Potential flow along x around a cylinder along z, on a grid that has a hole there."""
    share = (np.exp(4 * np.linspace(0, 1, 40)) - 1) / (np.exp(4) - 1)
    r, angle, z = np.meshgrid(radius + (far - radius) * share, np.linspace(0, 2 * np.pi, 80), np.linspace(0, 5, 6), indexing="ij")
    mesh = pyvista.StructuredGrid(r * np.cos(angle), r * np.sin(angle), z)
    r, angle = r.ravel("F"), angle.ravel("F")
    along, across = (1 - radius**2 / r**2) * np.cos(angle), -(1 + radius**2 / r**2) * np.sin(angle)
    mesh["U"] = np.column_stack([along * np.cos(angle) - across * np.sin(angle), along * np.sin(angle) + across * np.cos(angle), 0 * r])
    return mesh


def mass(smoke):
    return float(np.sum(smoke.compute_cell_sizes(length=False, area=False)["Volume"] * smoke.cell_data["Density"]))


def wind_over(*extents):
    """10 m/s along x and a little along y, on a grid with axes of these lengths."""
    mesh = pyvista.RectilinearGrid(*(np.linspace(0, extent, 9) for extent in extents))
    mesh["wind"] = np.tile((10.0, 1.0, 0.0), (mesh.n_points, 1))
    return mesh


class Units(unittest.TestCase):
    """Smoke that is short because of the units of coordinates or times: a sentence says so, and what to do."""

    def told(self, mesh, **options):
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter("always")
            nephoscope.flow_volume(mesh, **options)
        return [str(one.message) for one in told if "speed of" in str(one.message)]

    def test_degrees_and_metres(self):
        for height in (1e4, 1e3):
            (told,) = self.told(wind_over(60, 40, height))
            self.assertRegex(told, r"60 x 40 x 1e\+0., in 6 seconds\. .*degrees.*mesh\.nephoscope\.globe\(\), kilometres by mesh\.scale\(1000\)")

    def test_kilometres(self):
        mesh = wind_over(3000, 2000, 15)
        for times, options in (([0, 21600], {}), ([0, 6], {"time_scale": 3600})):
            (told,) = self.told([mesh] * 2, times=times, **options)
            self.assertRegex(told, r"crosses the data 60 times between two time steps\. time_scale is .*mesh\.scale\(1000\)")
        self.assertEqual(self.told([mesh.scale(1000)] * 2, times=[0, 86400]), [])

    def test_hours(self):
        mesh = wind_over(3e6, 2e6, 15e3)
        (told,) = self.told([mesh] * 2, times=[0, 24])
        self.assertRegex(told, "moves by only 241.* in the 24 seconds .* time_scale is 1 s per unit of time: set it to 3600 for time steps in hours")
        self.assertEqual(self.told([mesh] * 2, times=[0, 24], time_scale=3600), [])

    def test_unit_of_the_file(self):
        """What `read_cf` tells is used for times of the file, and not for others."""
        mesh = wind_over(3e6, 2e6, 15e3)
        mesh.field_data["time_units"], mesh.field_data["TimeValue"] = ["hours since 2011-10-11"], [6.0]
        hours = [float(nephoscope.flow_volume([mesh] * 2, times=[6, 30], **options).cell_data["Age"].max()) for options in ({}, {"time_scale": 3600})]
        self.assertEqual(hours[0], hours[1])
        self.assertEqual(self.told([mesh] * 2, times=[6, 30]), [])
        del mesh.field_data["TimeValue"]
        self.assertEqual(float(nephoscope.flow_volume([mesh] * 2, times=[6, 30]).cell_data["Age"].max()), hours[0])
        mesh.field_data["TimeValue"] = [6.0]
        seconds = nephoscope.flow_volume([mesh] * 2, times=[0, 86400])
        self.assertAlmostEqual(float(seconds.cell_data["Age"].max()) / hours[0], 1)

    def test_first_wind_zero(self):
        """The polygon is where the first wind blows."""
        still, windy = wind_over(30, 20, 10), wind_over(30, 20, 10)
        still["wind"] *= 0
        smoke = nephoscope.flow_volume([still, still, windy], times=[0, 1, 2])
        self.assertGreater(smoke.n_cells, 100)
        self.assertAlmostEqual(float(smoke.cell_data["Age"].max()), 1, 1)
        with self.assertRaisesRegex(ValueError, "no position with a flow"):
            nephoscope.flow_volume([still, still], times=[0, 1])

    def test_none(self):
        for extents in ((60, 40, 10), (3000, 2000, 15), (3e6, 2e6, 15e3), (1, 0.2, 0.2)):
            self.assertEqual(self.told(wind_over(*extents)), [], extents)


class Obstacles(unittest.TestCase):
    """Smoke that ends at a body inside the data is told; smoke that leaves the data is not."""

    def smoke(self, mesh, warned, **options):
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter("always")
            smoke = nephoscope.flow_volume(mesh, **{"radius": 0.8, "duration": 12, **options})
        told = [str(one.message) for one in told if "obstacles" in str(one.message)]
        emitted, lost, obstacle = (float(smoke.field_data[name][0]) for name in ("EmittedMass", "LostMass", "ObstacleMass"))
        self.assertAlmostEqual(mass(smoke) / (emitted - lost), 1, 6)
        self.assertEqual(len(told), warned)
        return told, emitted, lost, obstacle

    def test_a_cylinder(self):
        mesh = around_a_cylinder()
        for data in (mesh, mesh.cast_to_unstructured_grid()):
            (told,), emitted, lost, obstacle = self.smoke(data, 1, center=(-5, 0, 2.5), initial_density=3)
            self.assertAlmostEqual(obstacle / lost, 1, 3)  # the smoke does not reach the border of the data
            self.assertIn(f"lacks smoke: {100 * obstacle / emitted:.0f} % of it ended", told)
            for name in ("max_edge_length", "max_tetrahedra", "smoke.field_data['ObstacleMass']"):
                self.assertIn(name, told)

    def test_smaller_prisms(self):
        """The remedy of the warning."""
        mesh = around_a_cylinder()
        _, _, default, _ = self.smoke(mesh, 1, center=(-5, 0, 2.5))
        _, emitted, finer, obstacle = self.smoke(mesh, 1, center=(-5, 0, 2.5), max_edge_length=0.15)
        self.assertLess(finer, 0.5 * default)
        self.assertLess(obstacle, 0.1 * default)
        smoke = mesh.nephoscope.flow_volume(center=(-5, 0, 2.5), radius=0.8, duration=12, max_edge_length=0.15)
        self.assertAlmostEqual((obstacle + float(smoke.field_data["FoldedMass"][0])) / finer, 1, 3)

    def test_the_border(self):
        """It ends the smoke, not a body: beside the cylinder, and in a box."""
        _, emitted, lost, obstacle = self.smoke(around_a_cylinder(), 0, center=(-5, 3, 2.5), duration=40)
        self.assertGreater(lost, 0.4 * emitted)
        self.assertEqual(obstacle, 0)
        _, emitted, lost, obstacle = self.smoke(uniform((2.0, 0.5, 0.3)), 0, center=(0, 0, 0), duration=10)
        self.assertGreater(lost, 0.4 * emitted)
        self.assertEqual(obstacle, 0)

    def test_missing_values(self):
        """Values that are not numbers, with others behind them, and without."""
        for behind in (True, False):
            mesh = uniform(n=41)
            x, y, z = mesh.points.T
            mesh["wind"][(x > 0) & ((x < 2) | (not behind)) & (abs(y) < 3) & (abs(z) < 3)] = np.nan
            _, emitted, lost, obstacle = self.smoke(mesh, int(behind), center=(-5, 0, 0), duration=5)
            self.assertGreater(lost, 0.1 * emitted)
            self.assertAlmostEqual(obstacle, lost if behind else 0, delta=1e-6 * emitted)


class FlowVolume(unittest.TestCase):
    def test_cylinder(self):
        mesh = uniform()
        names = list(mesh.array_names)
        smoke = mesh.nephoscope.flow_volume(center=(-5, 0, 0), radius=1, duration=4, time_step=0.5)
        self.assertIsInstance(smoke, pyvista.UnstructuredGrid)
        self.assertAlmostEqual(smoke.volume, AREA * 2 * 4, places=9)
        self.assertEqual(set(smoke.cell_data["EmissionStep"]), set(range(8)))
        np.testing.assert_allclose(smoke.cell_data["Density"], 1, rtol=1e-9)
        np.testing.assert_allclose(smoke.point_data["Age"], (smoke.points[:, 0] + 5) / 2, atol=1e-12)
        np.testing.assert_allclose(smoke.point_data["x"], smoke.points[:, 0], atol=1e-12)
        self.assertEqual(mesh.array_names, names)

    def test_normal_and_density(self):
        smoke = uniform().nephoscope.flow_volume(center=(-5, 0, 0), radius=1, normal=(1, 1, 0), duration=2, time_step=0.5,
                                                 initial_density=3)
        self.assertAlmostEqual(smoke.volume, AREA * np.sqrt(0.5) * 2 * 2, places=9)
        sizes = smoke.compute_cell_sizes(length=False, area=False)["Volume"]
        self.assertAlmostEqual(float(np.sum(sizes * smoke.cell_data["Density"])), 3 * smoke.volume, places=9)

    def test_polygon(self):
        square = pyvista.Plane(center=(-5, 0, 0), direction=(1, 0, 0), i_size=2, j_size=2, i_resolution=1, j_resolution=1)
        smoke = uniform().nephoscope.flow_volume(square, duration=2, time_step=0.5, integrator="rk45")
        self.assertAlmostEqual(smoke.volume, 4 * 4, places=9)
        oblique = pyvista.Plane(center=(-5, 0, 0), direction=(1, 0, 1), i_size=2, j_size=2, i_resolution=1, j_resolution=1)
        for normal, area in ((None, 4 / np.sqrt(2)), ("flow", 4)):  # as it is, or turned
            smoke = uniform().nephoscope.flow_volume(oblique, duration=2, time_step=0.5, normal=normal)
            self.assertAlmostEqual(smoke.volume, area * 4, places=5)  # pyvista.Plane is in single precision

    def test_messages_name_arguments(self):
        with self.assertWarnsRegex(RuntimeWarning, r"max_tetrahedra \(500\).* time_step of .* polygon_edge_length of .* max_edge_length of"):
            smoke = uniform().nephoscope.flow_volume(center=(-5, 0, 0), radius=1, time_step=0.01, max_tetrahedra=500)
        self.assertLessEqual(smoke.n_cells, 500)
        with self.assertRaisesRegex(RuntimeError, r"turn it \(normal\), or leave normal out"):
            uniform().nephoscope.flow_volume(center=(0, 0, 0), normal=(0, 1, 0))
        mesh = uniform()
        mesh["other"] = mesh["wind"]
        with self.assertRaisesRegex(RuntimeError, "choose one of them"):
            mesh.nephoscope.flow_volume(center=(0, 0, 0))

    def test_smoke_without_cells(self):
        with self.assertRaisesRegex(ValueError, "no smoke was traced"):
            nephoscope.add_smoke(pyvista.Plotter(off_screen=True), pyvista.UnstructuredGrid())

    def test_too_many_steps(self):
        with self.assertWarnsRegex(RuntimeWarning, "for a duration of .* a time_step of .* Shorten duration"):
            uniform().nephoscope.flow_volume(center=(-5, 0, 0), radius=1, duration=5e6)

    def test_much_coarser(self):
        """Automatic lengths that the limit on tetrahedra has made much coarser are told of; a few turns are not."""
        mesh = pyvista.ImageData(dimensions=(21, 21, 11), spacing=(0.1,) * 3, origin=(-1, -1, 0))
        x, y, _ = mesh.points.T
        mesh["U"] = np.column_stack([-y, x, 0 * x])
        for duration, warned in ((6, 0), (60, 0), (600, 1)):
            with warnings.catch_warnings(record=True) as told:
                warnings.simplefilter("always")
                mesh.nephoscope.flow_volume(center=(0.5, 0, 0.5), radius=0.1, duration=duration)
            self.assertEqual(len(told), warned, duration)
        self.assertRegex(str(told[0].message), r"much coarser than usual.*max_tetrahedra \(100000\).*time_step of .*Allow more tetrahedra, or shorten the duration")

    def test_weather(self):
        """The first smoke is whole, and small enough to turn, whatever the exaggeration."""
        weather = nephoscope.read_cf(os.environ["NEPHOSCOPE_DATA"] + "/gfs_2p5deg_2011101100.nc")
        for exaggeration in (1, 20, 50):
            globe = weather.nephoscope.globe(vertical_exaggeration=exaggeration)
            with warnings.catch_warnings():
                warnings.simplefilter("error")
                smoke = globe.nephoscope.flow_volume()
            steps = np.bincount(smoke["EmissionStep"])
            self.assertTrue(1000 < smoke.n_cells <= 100_000 and steps.min() > 0, (exaggeration, smoke.n_cells, steps))

    def test_cells_and_blocks(self):
        mesh = uniform()
        on_cells = mesh.point_data_to_cell_data()
        self.assertAlmostEqual(on_cells.nephoscope.flow_volume(vectors="wind", center=(-5, 0, 0), radius=1, duration=2).volume, AREA * 4,
                               places=9)
        blocks = pyvista.MultiBlock([mesh.extract_subset((0, 4, 0, 8, 0, 8)), mesh.extract_subset((4, 8, 0, 8, 0, 8))])
        smoke = nephoscope.flow_volume(blocks, vectors="wind", center=(-5, 0, 0), radius=1, duration=5)
        self.assertAlmostEqual(smoke.volume, AREA * 10, places=9)

    def test_partitions(self):
        """Blocks of any kind, which PyVista's own filters do not take."""
        parts = vtkPartitionedDataSet()
        parts.SetPartition(0, uniform())
        collection = vtkPartitionedDataSetCollection()
        collection.SetPartitionedDataSet(0, parts)
        for data in (parts, collection):
            smoke = nephoscope.flow_volume(data, center=(-5, 0, 0), radius=1, duration=4, time_step=0.5)
            self.assertAlmostEqual(smoke.volume, AREA * 2 * 4, places=9)

    def test_points_that_are_nowhere(self):
        mesh = uniform().cast_to_unstructured_grid()
        expected = mesh.nephoscope.flow_volume(duration=4)
        mesh.points = np.vstack([mesh.points, [[np.inf, 0, 0], [0, np.nan, 0]]])  # which no cell has
        mesh.point_data["wind"] = np.tile((2.0, 0, 0), (mesh.n_points, 1))
        self.assertAlmostEqual(nephoscope.flow_volume(mesh, vectors="wind", duration=4).volume, expected.volume, places=6)

    def test_place(self):
        """Without a centre the polygon is where the flow is fast, here a jet off the middle, and fits in."""
        mesh = uniform(n=21)
        y, z = mesh.points[:, 1] - 4, mesh.points[:, 2] + 3
        mesh.point_data["wind"] = np.outer(np.exp(-(y ** 2 + z ** 2) / 4), (3, 0, 0))
        smoke = mesh.nephoscope.flow_volume(duration=0.5)
        start = smoke.points[smoke.point_data["Age"] == 0]
        self.assertLess(np.linalg.norm(start.mean(axis=0)[1:] - (4, -3)), 1)
        self.assertAlmostEqual(np.ptp(start[:, 1]), 2 * mesh.length / 50, delta=0.05)

    def test_errors(self):
        mesh = uniform()
        with self.assertRaisesRegex(MissingDataError, "no array 'v' of three components. Point arrays: 'wind', 'x'"):
            mesh.nephoscope.flow_volume(vectors="v")
        with self.assertRaisesRegex(MissingDataError, "'x'"):
            mesh.nephoscope.flow_volume(vectors="x")
        with self.assertRaisesRegex(ValueError, "radius is 0"):
            mesh.nephoscope.flow_volume(radius=0)
        with self.assertRaisesRegex(ValueError, "n_sides is 2"):
            mesh.nephoscope.flow_volume(n_sides=2)
        with self.assertRaisesRegex(ValueError, "center is .* three finite"):
            mesh.nephoscope.flow_volume(center=(0, np.nan, 0))
        with self.assertRaisesRegex(ValueError, "integrator is 'euler'; it must be one of 'rk4', 'rk45'"):
            mesh.nephoscope.flow_volume(integrator="euler")
        with self.assertRaisesRegex(ValueError, "no position with a flow"):
            uniform((0, 0, 0)).nephoscope.flow_volume()
        with self.assertRaisesRegex(RuntimeError, "outside"):
            mesh.nephoscope.flow_volume(center=(100, 0, 0))
        with self.assertRaisesRegex(TypeError, "mesh is a list"):
            nephoscope.flow_volume([1])
        for several, words in (([mesh, mesh], r"pass times=\[...\] with the times of the 2 meshes"), ({0: mesh, 1: mesh}, r"times=list\(meshes\)"), (lambda time: mesh, r"a function of the time pass times=")):
            with self.assertRaisesRegex(TypeError, words):
                nephoscope.flow_volume(several)
        with self.assertRaisesRegex(TypeError, "polygon is a ImageData"):
            mesh.nephoscope.flow_volume(mesh)
        for other in ({"radius": 1}, {"normal": (0, 0, 1)}):
            with self.assertRaisesRegex(ValueError, f"'{list(other)[0]}' as well"):
                mesh.nephoscope.flow_volume(pyvista.Plane(), **other)
        with self.assertRaisesRegex(ValueError, "normal is 'wind'; it must be three finite numbers or 'flow'"):
            mesh.nephoscope.flow_volume(normal="wind")


class Series(unittest.TestCase):
    def test_dates_as_times(self):
        dates = np.datetime64("2020-01-01") + np.arange(2) * np.timedelta64(2, "s")
        for times in (dates, list(dates), dates.astype(object), list(dates.astype(object))):
            with self.assertRaisesRegex(TypeError, "seconds since the first one pass"):
                nephoscope.flow_volume([uniform()] * 2, times=times)
        dates = np.asarray(list(dates.astype(object)), "datetime64[ns]")  # as the message says
        smoke = nephoscope.flow_volume([uniform()] * 2, times=(dates - dates[0]) / np.timedelta64(1, "s"), center=(0, 0, 0))
        self.assertAlmostEqual(smoke["Age"].max(), 2 - 1 / 64)

    def test_array_of_one_mesh_is_missing(self):
        meshes = [uniform() for _ in range(3)]
        meshes[1].clear_data()
        with self.assertRaisesRegex(RuntimeError, "'wind'.* This is time step 1, at 0.5"):
            nephoscope.flow_volume(meshes, times=[0, 0.5, 1], vectors="wind", center=(0, 0, 0))

    def test_after_the_last_mesh(self):
        with self.assertWarnsRegex(RuntimeWarning, "no data at time 5: the last time step of the input is at 1"):
            nephoscope.flow_volume([uniform()] * 2, times=[0, 1], time=5, center=(0, 0, 0))


class Limits(unittest.TestCase):
    """The limits of steps, edges and obstacles."""

    def test_reach_the_filter(self):
        mesh = uniform()
        x, y, z = mesh.points.T
        mesh["wind"] = np.column_stack([-y, x, 0.3 + 0.03 * z])  # turns by 22 degrees in a step
        cells = lambda **options: mesh.nephoscope.flow_volume(center=(5, 0, -5), radius=1, duration=3, time_step=0.375, **options).n_cells
        usual = cells()
        self.assertLess(cells(max_halvings=0), usual)
        self.assertGreater(cells(max_divergence=1e-3), usual)
        self.assertGreater(cells(max_area_ratio=1.0001), usual)
        blanked = uniform((2, 0, 0), 33)
        blanked.cell_data["vtkGhostType"] = np.where(np.arange(blanked.n_cells) == blanked.find_containing_cell((0.3, 0.3, 0.3)), 32, 0).astype(np.uint8)
        lost = lambda **options: float(blanked.nephoscope.flow_volume(center=(-5, 0, 0), radius=3, polygon_edge_length=6, duration=5, time_step=0.5,
                                                                     **options).field_data["LostMass"][0])
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            self.assertEqual(lost(obstacle_size=100), 0)
            self.assertGreater(lost(), 0)
            self.assertGreater(lost(obstacle_levels=0), lost())

    def test_out_of_range(self):
        for options in ({"max_halvings": -1}, {"max_halvings": 17}, {"edge_levels": 20}, {"obstacle_levels": -2}, {"obstacle_size": 0},
                        {"max_area_ratio": -1}, {"max_divergence": np.nan}):
            with self.assertRaisesRegex(ValueError, next(iter(options))):
                uniform().nephoscope.flow_volume(center=(0, 0, 0), **options)


class Puffs(unittest.TestCase):
    def setUp(self):
        self.smoke = uniform().nephoscope.flow_volume(center=(-5, 0, 0), radius=1, duration=4, time_step=0.125)

    def puffs(self, *args, **options):
        return self.smoke.nephoscope.smoke_puffs(*args, **options)

    def test_crests_move_with_the_flow(self):
        for time in (0.0, 0.25, 0.5):
            volume = self.puffs(time, period=1, floor=0, on_points=True)
            x = volume.points[volume.point_data["SmokeDensity"] > 0.99, 0]
            phase = ((x + 5) / 2 - time + 0.5) % 1 - 0.5
            self.assertTrue(x.size and np.all(np.abs(phase) < 0.08))
        self.assertNotIn("SmokeDensity", self.smoke.array_names)

    def test_options(self):
        np.testing.assert_allclose(self.puffs(0.3, period=1)["SmokeDensity"], self.puffs(1.3, period=1)["SmokeDensity"], atol=1e-12)
        self.assertAlmostEqual(self.puffs(floor=0.25, width=0.2)["SmokeDensity"].min(), 0.25)
        self.assertAlmostEqual(self.puffs(max_density=0.5)["SmokeDensity"].max(), 0.5, places=2)
        self.assertGreater(self.puffs(normalization="mean", floor=0)["SmokeDensity"].max(), 3)

    def test_errors(self):
        for argument, value in (("width", 2), ("width", 0), ("floor", -1), ("floor", 1.5), ("period", 0), ("max_density", 0)):
            with self.assertRaisesRegex(ValueError, f"{argument} is"):
                self.puffs(**{argument: value})
        with self.assertRaisesRegex(TypeError, "UnstructuredGrid"):
            nephoscope.smoke_puffs(uniform())
        with self.assertRaisesRegex(RuntimeError, "Pass the smoke that flow_volume has made"):
            nephoscope.smoke_puffs(uniform().cast_to_unstructured_grid())


if __name__ == "__main__":
    unittest.main()
