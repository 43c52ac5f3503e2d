# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Unstructured globes and other grids: the cells fill the shell, the winds are those of a solid rotation, projections are those of eccodes."""
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import nephoscope
import numpy as np
import pyvista
import xarray as xr
from nephoscope.weather.healpix import healpix_centres
from nephoscope.weather.prisms import offsets
from weather_data import AXIS, along_rows, rotation, write_grib

HALF = np.array([0.0, 1000, 3000, 9000])  # m
FULL = 0.5 * (HALF[1:] + HALF[:-1])


def degrees(points):
    return np.degrees(np.arctan2(points[:, 1], points[:, 0])), np.degrees(np.arcsin(points[:, 2] / np.linalg.norm(points, axis=1)))


def fields(lon, lat, dims, height="z"):
    """Winds of a solid rotation, and the longitude of the cell as a field."""
    _, east, north = rotation(lon, lat)
    wide = lambda field: np.repeat(field[None], 3, axis=0)
    return {"u": ((height, dims), wide(east), {"units": "m/s", "standard_name": "eastward_wind"}), "v": ((height, dims), wide(north), {"units": "m/s", "standard_name": "northward_wind"}),
            "where": ((height, dims), wide(lat), {"units": "degree"}), "z_ifc": (("z_2", dims), np.repeat(HALF[:, None], lon.size, axis=1), {"units": "m"})}


def icosphere(subdivisions):
    mesh = pyvista.Icosphere(nsub=subdivisions, radius=1.0)
    return np.asarray(mesh.points, float), mesh.faces.reshape(-1, 4)[:, 1:]


def icon(subdivisions=3):
    """Triangles with bounds in radians."""
    points, triangles = icosphere(subdivisions)
    lon, lat = degrees(points[triangles].mean(1))
    vertices = [np.radians(a)[triangles] for a in degrees(points)]
    return xr.Dataset(fields(lon, lat, "ncells", "z") | {"clon_vertices": (("ncells", "vertices"), vertices[0]), "clat_vertices": (("ncells", "vertices"), vertices[1])},
                      {"clon": ("ncells", np.radians(lon), {"units": "radian", "standard_name": "longitude", "bounds": "clon_vertices"}),
                       "clat": ("ncells", np.radians(lat), {"units": "radian", "standard_name": "latitude", "bounds": "clat_vertices"})})


def mpas(subdivisions=3):
    """Pentagons and hexagons round the vertices of an icosphere; every second clockwise, and one spare column of zeros."""
    points, triangles = icosphere(subdivisions)
    corners = points[triangles].mean(1)
    corners /= np.linalg.norm(corners, axis=1)[:, None]
    cell, corner = triangles.ravel(), np.repeat(np.arange(len(triangles)), 3)
    east, north = np.cross(AXIS, points), np.cross(points, np.cross(AXIS, points))
    angle = np.arctan2((corners[corner] * north[cell]).sum(1), (corners[corner] * east[cell]).sum(1))
    order = np.lexsort((angle, cell))
    count = np.bincount(cell)
    faces = np.zeros((len(points), 7), int)
    faces[cell[order], np.arange(len(cell)) - np.repeat(np.cumsum(count) - count, count)] = corner[order] + 1
    faces[::2, :5][count[::2] == 5] = faces[::2, :5][count[::2] == 5][:, ::-1]
    lon, lat = degrees(points)
    vertices = degrees(corners)
    own = fields(lon, lat, "nCells", "nVertLevels")
    z = own.pop("z_ifc")[1]
    own = {name: (dims[::-1], values.T, attrs) for name, (dims, values, attrs) in own.items()}
    return xr.Dataset(own | {"zgrid": (("nCells", "nVertLevelsP1"), z.T, {"units": "m"}), "verticesOnCell": (("nCells", "maxEdges"), faces), "nEdgesOnCell": ("nCells", count),
                             "lonVertex": ("nVertices", np.radians(vertices[0])), "latVertex": ("nVertices", np.radians(vertices[1])),
                             "lonCell": ("nCells", np.radians(lon)), "latCell": ("nCells", np.radians(lat))})


def ugrid():
    """Triangles and squares: a latitude-longitude mesh with poles."""
    lon, lat = np.arange(0, 360, 10.0), np.arange(-80, 81, 10.0)
    nodes = np.array([(x, y) for y in lat for x in lon] + [(0, -90), (0, 90)])
    at = lambda j, i: j * 36 + i % 36
    faces = [(at(j, i), at(j, i + 1), at(j + 1, i + 1), at(j + 1, i)) for j in range(16) for i in range(36)]
    faces += [(612, at(0, i + 1), at(0, i), -999) for i in range(36)] + [(613, at(16, i), at(16, i + 1), -999) for i in range(36)]
    faces = np.array(faces)
    mesh = {"Mesh2": ((), 0, {"cf_role": "mesh_topology", "topology_dimension": 2, "node_coordinates": "node_x node_y", "face_node_connectivity": "face_nodes"}),
            "node_x": ("node", nodes[:, 0], {"units": "degrees_east"}), "node_y": ("node", nodes[:, 1], {"units": "degrees_north"}),
            "face_nodes": (("face", "corner"), np.where(faces < 0, -999, faces + 1), {"start_index": 1, "_FillValue": -999})}
    corners = [np.radians(nodes[:, c]) for c in (0, 1)]
    xyz = np.stack([np.cos(corners[1]) * np.cos(corners[0]), np.cos(corners[1]) * np.sin(corners[0]), np.sin(corners[1])], 1)
    middle = (xyz[np.maximum(faces, 0)] * (faces >= 0)[..., None]).sum(1)
    return mesh, degrees(middle), nodes.T


class Shells(unittest.TestCase):
    def check(self, dataset, cells, rtol):
        grid = dataset.nephoscope.globe(radius=1e5, vertical_exaggeration=2.0)
        self.assertEqual(grid.n_cells, 3 * cells)
        volume = np.abs(grid.compute_cell_sizes()["Volume"]).reshape(3, -1).sum(1)
        shell = 4 / 3 * np.pi * np.diff((1e5 + 2 * HALF) ** 3)
        np.testing.assert_allclose(volume, shell, rtol=rtol)  # but for the chords of the cells
        np.testing.assert_allclose(np.asarray(grid.cell_data["Height"]).reshape(3, -1), np.repeat(FULL[:, None], cells, 1))
        lon, lat = degrees(grid.cell_centers().points)
        np.testing.assert_allclose(np.asarray(grid.cell_data["where"]), lat, atol=3)
        expected, _, _ = rotation(lon, lat)
        np.testing.assert_allclose(np.asarray(grid.cell_data["Wind"]), expected, atol=2.0)  # centre of the prism against that of the file
        return grid

    def test_triangles_with_bounds(self):
        self.check(icon(), 1280, 0.01)

    def test_polygons_of_mpas(self):
        grid = self.check(mpas(), 642, 0.02)
        self.assertEqual(set(grid.celltypes), {15, 16})

    def test_one_level_is_hidden_by_its_pressure_alone(self):
        levels = mpas()[["where", "verticesOnCell", "nEdgesOnCell", "lonVertex", "latVertex", "lonCell", "latCell"]].isel(nVertLevels=0)
        levels = levels.assign(ps=("nCells", np.full(642, 8e4), {"standard_name": "surface_air_pressure", "units": "Pa"}),
                               orog=("nCells", np.full(642, 1500.0), {"standard_name": "surface_altitude", "units": "m"}))
        for pressure, hidden in ((500.0, 0), (850.0, 1), (None, 0)):
            dataset = levels if pressure is None else levels.assign_coords(plev=((), pressure, {"units": "hPa", "standard_name": "air_pressure"}))
            self.assertEqual(set(dataset.nephoscope.globe().cell_data["BelowGround"]), {hidden})

    def test_faces_and_nodes_of_ugrid(self):
        mesh, (lon, lat), (x, y) = ugrid()
        self.check(xr.Dataset(mesh | fields(lon, lat, "face")), 648, 0.02)
        at_nodes = xr.Dataset(mesh | fields(x, y, "node"))
        grid = at_nodes.nephoscope.globe()
        self.assertEqual(grid.n_cells, 2 * 648)
        np.testing.assert_allclose(np.linalg.norm(grid.points, axis=1) - 6371000, np.repeat(FULL, 614), atol=1)
        np.testing.assert_allclose(np.asarray(grid.point_data["Wind"]), np.tile(rotation(x, y)[0], (3, 1)), atol=1e-4)

    def test_healpix_of_both_orders(self):
        for order, nested in (("nested", True), ("ring", False)):
            lon, lat = healpix_centres(16, nested)
            dataset = xr.Dataset(fields(lon, lat, "cell") | {"crs": ((), 0, {"grid_mapping_name": "healpix", "healpix_nside": 16, "healpix_order": order})})
            self.check(dataset, 3072, 0.02)

    def test_a_part_of_healpix(self):
        """Pixels whose numbers are a coordinate are those of the whole sphere, in any order."""
        pixels = np.random.default_rng(2).permutation(3072)[:500]
        for order, keys in (("nested", {"healpix_nside": 16, "healpix_order": "nested"}), ("ring", {"refinement_level": 4, "indexing_scheme": "ring"})):
            lon, lat = healpix_centres(16, order == "nested")
            whole = xr.Dataset(fields(lon, lat, "cell") | {"crs": ((), 0, {"grid_mapping_name": "healpix", **keys})}, {"cell": np.arange(3072)})
            for part, count in ((whole.isel(cell=pixels), 500), (whole.isel(cell=slice(None, None, -1)), 3072)):
                grid = part.nephoscope.globe()
                self.assertEqual(grid.n_cells, 3 * count)
                np.testing.assert_allclose(degrees(np.asarray(grid.cell_centers().points))[1], grid["where"], atol=1.5)
                np.testing.assert_allclose(grid["where"][:count], part["where"][0], rtol=1e-5)
        with self.assertRaisesRegex(ValueError, "No longitudes were found"):
            whole.isel(cell=pixels).drop_vars("cell").nephoscope.globe()

    def test_no_cell_is_a_step_of_python(self):
        """Sixteen times the cells take the same number of calls, but for a few."""
        def healpix(subdivisions):
            lon, lat = healpix_centres(2 ** subdivisions, True)
            return xr.Dataset(fields(lon, lat, "cell") | {"crs": ((), 0, {"grid_mapping_name": "healpix", "healpix_nside": 2 ** subdivisions, "healpix_order": "nested"})})

        def calls(dataset):
            count = [0]
            dataset.nephoscope.globe()
            sys.setprofile(lambda *_: count.__setitem__(0, count[0] + 1))
            try:
                dataset.nephoscope.globe()
            finally:
                sys.setprofile(None)
            return count[0]

        for make in (icon, mpas, points_alone, healpix):
            with self.subTest(make.__name__):
                self.assertLess(calls(make(4)), 1.1 * calls(make(2)))

    def test_healpix_centres_are_those_of_eccodes(self):
        with tempfile.TemporaryDirectory() as folder:
            for order in ("ring", "nested"):
                keys = {"gridType": "healpix", "Nside": 4, "orderingConvention": order, "longitudeOfFirstGridPointInDegrees": 45}
                lat, lon = write_grib(Path(folder, "a"), [("t", "isobaricInhPa", 500, 1.0)], keys)
                ours = healpix_centres(4, order == "nested")
                np.testing.assert_allclose(ours, (np.mod(lon, 360), lat), atol=1e-6)

    def test_the_mesh_in_a_file_of_its_own(self):
        whole = mpas()
        names = ["verticesOnCell", "nEdgesOnCell", "lonVertex", "latVertex", "lonCell", "latCell", "zgrid"]
        with tempfile.TemporaryDirectory() as folder:
            whole[names].rename(nCells="cells").to_netcdf(Path(folder, "mesh.nc"))
            whole.drop_vars(names).to_netcdf(Path(folder, "data.nc"))
            self.check(nephoscope.open(Path(folder, "data.nc"), mesh=Path(folder, "mesh.nc")), 642, 0.02)

    def test_names_of_pyvista(self):
        """PyVista 0.49 has cell_offsets, and warns of offset."""
        grid = pyvista.UnstructuredGrid({pyvista.CellType.TRIANGLE: np.array([[0, 1, 2], [2, 1, 3]])}, np.eye(4, 3))
        with mock.patch.object(pyvista.UnstructuredGrid, "cell_offsets", np.array([0, 3, 6]), create=True), mock.patch.object(pyvista.UnstructuredGrid, "offset", mock.PropertyMock(side_effect=AssertionError)):
            np.testing.assert_array_equal(offsets(grid), [0, 3, 6])
        np.testing.assert_array_equal(offsets(grid), [0, 3, 6])

    def test_uneven_terrain(self):
        """Neighbours share their corners: no gaps, the mean of what meets there."""
        dataset = icon()
        dataset["z_ifc"] = dataset.z_ifc * (1 + 0.2 * np.sin(3 * dataset.clon)).values
        grid = dataset.nephoscope.globe(radius=1e5)
        self.assertEqual(grid.n_points, 4 * 642)


def points_alone(subdivisions=3):
    """The fields of `mpas` at the centres of cells of which the file does not tell the corners."""
    return mpas(subdivisions).drop_vars(["verticesOnCell", "nEdgesOnCell", "lonVertex", "latVertex"])


class PointsAlone(unittest.TestCase):
    """Lists of points without cells: wedges over Delaunay's triangles."""

    def test_a_globe_is_closed(self):
        dataset = points_alone()
        self.assertIn("cells: triangles between the 642 points, since there is no mesh", dataset.nephoscope.describe())
        grid = dataset.nephoscope.globe(radius=1e5, vertical_exaggeration=2.0)
        self.assertEqual((grid.n_points, grid.n_cells, set(grid.celltypes)), (3 * 642, 2 * 1280, {13}))
        volume = np.abs(grid.compute_cell_sizes()["Volume"]).reshape(2, -1).sum(1)
        np.testing.assert_allclose(volume, 4 / 3 * np.pi * np.diff((1e5 + 2 * FULL) ** 3), rtol=0.02)
        np.testing.assert_allclose(np.asarray(grid["Wind"]), np.tile(rotation(*(np.degrees(dataset[name].values) for name in ("lonCell", "latCell")))[0], (3, 1)), atol=1e-4)

    def test_a_gap_stays_open(self):
        """A continent that the file leaves out: a quarter of the longitudes, 60 degrees of latitude."""
        dataset = points_alone(4)
        lon, lat = (np.degrees(dataset[name].values) for name in ("lonCell", "latCell"))
        inside = (np.abs(lon) < 45) & (np.abs(lat) < 30)
        grid = dataset.isel(nCells=np.flatnonzero(~inside)).nephoscope.globe(vertical_exaggeration=1.0)
        x, y = degrees(grid.cell_centers().points)
        self.assertFalse(((np.abs(x) < 36) & (np.abs(y) < 22)).any())
        cells = dataset.nephoscope.globe(vertical_exaggeration=1.0).n_cells
        self.assertAlmostEqual(grid.n_cells / cells, 1 - 0.25 * 0.5, delta=0.02)

    def test_a_region_is_not_closed_round_the_globe(self):
        x, y = np.meshgrid(np.arange(0, 10, 0.5), np.arange(40, 50, 0.5))
        lon, lat = x.ravel(), y.ravel()  # four on each circle
        dataset = xr.Dataset(fields(lon, lat, "station")).assign_coords(lon=("station", lon, {"units": "degrees_east"}), lat=("station", lat, {"units": "degrees_north"}))
        grid = dataset.nephoscope.globe(radius=1.0, vertical_exaggeration=0.0)
        area = np.radians(9.5) * (np.sin(np.radians(49.5)) - np.sin(np.radians(40)))
        self.assertAlmostEqual(grid.extract_surface(algorithm=None).area / 2 / area, 1, delta=0.015)

    def test_repeated_and_missing_stations(self):
        dataset = points_alone()
        twice = xr.concat([dataset, dataset.isel(nCells=slice(0, 50))], "nCells", data_vars="minimal")
        twice["lonCell"][3] = np.nan
        self.assertEqual(twice.nephoscope.globe().n_cells, 2 * 1280)

    def test_too_few_points_name_the_remedy(self):
        for some in (slice(0, 2), slice(0, 12)):
            with self.assertRaisesRegex(ValueError, r"too few or too far.*open\(DATA, mesh=GRID\)"):
                points_alone().isel(nCells=some).nephoscope.globe()
        self.assertIn("too few or too far", points_alone().isel(nCells=slice(0, 2)).nephoscope.describe())

    def test_no_places_name_the_file_of_the_mesh(self):
        dataset = points_alone().drop_vars(["lonCell", "latCell"])
        with self.assertRaisesRegex(ValueError, r"mesh=GRID.*icon_grid_"):
            dataset.nephoscope.globe()
        with self.assertRaisesRegex(ValueError, r"mesh=GRID.*number_of_grid_used 26"):
            dataset.assign_attrs(number_of_grid_used=26).nephoscope.globe()
        with self.assertRaisesRegex(ValueError, r"healpix_nside'\] = 4"):
            dataset.isel(nCells=slice(0, 192)).nephoscope.globe()


class LowestLevel(unittest.TestCase):
    """A temperature is drawn in the lowest cell or point of each column above the ground, at the ground; with an opacity it is a volume."""

    def datasets(self):
        mesh, (lon, lat), (x, y) = ugrid()
        return {"icon": icon(2), "mpas": mpas(2), "points": points_alone(2), "faces": xr.Dataset(mesh | fields(lon, lat, "face")), "nodes": xr.Dataset(mesh | fields(x, y, "node"))}

    def with_temperature(self, dataset):
        """10 K warmer with each level, 1 K with each degree to the north, over a plain in the south and a plateau above the lowest level in the north."""
        (level,) = [dim for dim in dataset["where"].dims if dataset.sizes[dim] == 3]
        warmer = xr.DataArray(10.0 * np.arange(3), dims=level)
        north = dataset["where"].isel({level: 0})
        return dataset.assign(ta=(250 + dataset["where"] + warmer).assign_attrs(units="K", standard_name="air_temperature"),
                              orog=xr.where(north > 0, 1500.0, 0.0).assign_attrs(units="m", standard_name="surface_altitude")), north.values

    def plotted(self, dataset, **options):
        with tempfile.TemporaryDirectory() as folder:
            plotter = dataset.nephoscope.plot("ta", screenshot=str(Path(folder, "a.png")), window_size=(60, 60), **options)
        self.addCleanup(plotter.close)
        return plotter

    def test_a_surface_of_the_lowest_level(self):
        for name, dataset in self.datasets().items():
            with self.subTest(name):
                data, north = self.with_temperature(dataset)
                plotter = self.plotted(data)
                sheet = next(actor.mapper.dataset for actor in plotter.renderer.actors.values() if "NephoscopeForm" in getattr(getattr(actor.mapper, "dataset", None), "array_names", ()))
                self.assertEqual(sheet.n_cells, data.nephoscope.globe().n_cells // (3 if "ta" in sheet.cell_data else 2))
                np.testing.assert_allclose(sheet["ta"], 250 + north + 10 * (north > 0), atol=1e-3)
                np.testing.assert_allclose(np.linalg.norm(sheet.points, axis=1), 6371000, atol=1)
                self.assertAlmostEqual(sheet.extract_surface(algorithm=None).area / (4 * np.pi * 6371000 ** 2), 1, delta=0.07)  # but for the chords
                self.assertIn("lowest level", next(iter(plotter.scalar_bars.values())).GetTitle())

    def test_a_volume_where_one_is_asked_for(self):
        data, _ = self.with_temperature(icon(2))
        self.assertEqual(self.plotted(data, opacity="linear").renderer.GetVolumes().GetNumberOfItems(), 1)

    def test_films(self):
        """The colours are those of the level in all steps."""
        first, north = self.with_temperature(mpas(2))
        data = xr.concat([first, first.assign(ta=(first.ta + 5).assign_attrs(first.ta.attrs))], "time", data_vars=["ta"]).assign_coords(time=np.array(["2020-01-01", "2020-01-02"], "M8[ns]"))
        plotter = pyvista.Plotter(off_screen=True, window_size=(60, 60))
        self.addCleanup(plotter.close)
        series = nephoscope.animate(plotter, data, "ta")
        self.addCleanup(series.close)
        series.show(1)
        expected = 250 + north + 10 * (north > 0)
        np.testing.assert_allclose(series.mesh["ta"], expected + 5, atol=1e-3)
        np.testing.assert_allclose(series.range("ta"), (expected.min(), expected.max() + 5), atol=1e-3)


class Projections(unittest.TestCase):
    CASES = {
        "polar_stereographic": {"gridType": "polar_stereographic", "Nx": 30, "Ny": 30, "latitudeOfFirstGridPointInDegrees": 30, "longitudeOfFirstGridPointInDegrees": 230, "LaDInDegrees": 60,
                                "orientationOfTheGridInDegrees": 280, "DxInMetres": 150000, "DyInMetres": 150000, "jScansPositively": 1, "shapeOfTheEarth": 6},
        "mercator": {"gridType": "mercator", "Ni": 40, "Nj": 30, "latitudeOfFirstGridPointInDegrees": -30, "longitudeOfFirstGridPointInDegrees": 100,
                     "latitudeOfLastGridPointInDegrees": 30, "longitudeOfLastGridPointInDegrees": 160, "LaDInDegrees": 20, "DiInMetres": 160000, "DjInMetres": 200000, "jScansPositively": 1, "shapeOfTheEarth": 6},
        "rotated_latitude_longitude": {"gridType": "rotated_ll", "Ni": 40, "Nj": 30, "latitudeOfFirstGridPointInDegrees": -15, "latitudeOfLastGridPointInDegrees": 14,
                                       "longitudeOfFirstGridPointInDegrees": 340, "longitudeOfLastGridPointInDegrees": 19, "iDirectionIncrementInDegrees": 1, "jDirectionIncrementInDegrees": 1,
                                       "latitudeOfSouthernPoleInDegrees": -40, "longitudeOfSouthernPoleInDegrees": 15, "jScansPositively": 1},
    }

    def test_winds_along_the_grid(self):
        for name, keys in self.CASES.items():
            with self.subTest(name), tempfile.TemporaryDirectory() as folder:
                path = Path(folder, "a.grib2")
                keys = {**keys, "resolutionAndComponentFlags": 8 if "Nx" in keys else 56}
                shape = (keys.get("Ny", keys.get("Nj")), keys.get("Nx", keys.get("Ni")))
                lat, lon = (a.reshape(shape) for a in write_grib(path, [("gh", "isobaricInhPa", 500, 1.0)], keys))
                wind, east, north = rotation(lon, lat)
                u, v = along_rows(lon, lat, east, north)
                write_grib(path, [f for level, z in ((850, 1500.0), (500, 5500.0)) for f in (("u", "isobaricInhPa", level, u), ("v", "isobaricInhPa", level, v), ("gh", "isobaricInhPa", level, z))], keys)
                dataset = nephoscope.open(path)
                got = np.asarray(dataset.nephoscope.globe()["Wind"]).reshape(2, *shape, 3)
                np.testing.assert_allclose(got[0][:, 2:-2], wind[:, 2:-2], atol=0.02)
                if name != "mercator":
                    self.assertIn(name, dataset.nephoscope.describe())

    def test_places_by_grid_mapping_alone(self):
        """x and y in metres, no longitudes: the projection's own, as eccodes has them."""
        from weather_data import LAMBERT
        with tempfile.TemporaryDirectory() as folder:
            lat, lon = (a.reshape(40, 60) for a in write_grib(Path(folder, "a"), [("gh", "isobaricInhPa", 500, 1.0)], LAMBERT))
        from nephoscope.weather.projections import Conic
        conic = Conic("lambert_conformal_conic", (265, 25), (25,))
        turn, radius = np.radians(conic.n * (lon[0, 0] - 265)), conic._radius(np.radians(lat[0, 0]))
        x, y = radius * np.sin(turn) + 8e4 * np.arange(60), conic._y0 - radius * np.cos(turn) + 8e4 * np.arange(40)
        dataset = xr.Dataset({"t": (("z", "y", "x"), np.ones((2, 40, 60)), {"units": "K", "grid_mapping": "crs"}),
                              "crs": ((), 0, {"grid_mapping_name": "lambert_conformal_conic", "standard_parallel": 25.0, "longitude_of_central_meridian": -95.0,
                                              "latitude_of_projection_origin": 25.0, "earth_radius": 6371229.0})},
                             {"z": ("z", [0.0, 1000], {"units": "m", "axis": "Z"}), "x": ("x", x / 1000, {"units": "km", "standard_name": "projection_x_coordinate"}),
                              "y": ("y", y / 1000, {"units": "km", "standard_name": "projection_y_coordinate"})})
        grid = dataset.nephoscope.globe()
        found = degrees(np.asarray(grid.points, float)[:2400])
        np.testing.assert_allclose(np.mod(found[0], 360), np.mod(lon.ravel(), 360), atol=1e-4)
        np.testing.assert_allclose(found[1], lat.ravel(), atol=1e-4)

    def test_reduced_gaussian_rows(self):
        for octahedral in (False, True):
            pl = np.array([20 + 4 * i if octahedral else 18 + 3 * i for i in range(8)])
            pl = np.concatenate([pl, pl[::-1]])
            keys = {"gridType": "reduced_gg", "N": 8, "Nj": 16, "pl": pl, "latitudeOfFirstGridPointInDegrees": 84, "latitudeOfLastGridPointInDegrees": -84,
                    "longitudeOfFirstGridPointInDegrees": 0, "longitudeOfLastGridPointInDegrees": 352}
            keys = {key: value for key, value in keys.items() if key not in ("Nj",)}
            with tempfile.TemporaryDirectory() as folder:
                path = Path(folder, "a.grib2")
                write_grib(path, [("t", "isobaricInhPa", 500, 0.0)], keys, sample="reduced_gg_pl_32_grib2")
                lat, lon = write_grib(path, [("t", "isobaricInhPa", 500, 0.0)], keys, sample="reduced_gg_pl_32_grib2")
                values = 250 + 20 * np.sin(np.radians(lat)) + np.cos(np.radians(lon))
                write_grib(path, [("t", "isobaricInhPa", level, values) for level in (500, 850)], keys, sample="reduced_gg_pl_32_grib2")
                dataset = nephoscope.open(path)
                grid = dataset.nephoscope.globe()
                self.assertIn("reduced Gaussian", dataset.nephoscope.describe())
            self.assertEqual(tuple(grid.dimensions), (pl.max() + 1, 18, 2))  # seam and poles are closed
            x, y = degrees(np.asarray(grid.points, float))
            inside = np.abs(y) < 85
            np.testing.assert_allclose(np.asarray(grid["t"])[inside], (250 + 20 * np.sin(np.radians(y)) + np.cos(np.radians(x)))[inside], atol=0.03)


if __name__ == "__main__":
    unittest.main()
