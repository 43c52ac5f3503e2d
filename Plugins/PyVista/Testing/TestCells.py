# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""nephoscope.add_cells: arguments reach mapper and property, bad ones are named. Draws nothing."""
import unittest
import warnings

import nephoscope
import numpy as np
import pyvista
from nephoscope._medium import default_scalars
from plotters import PlotterTestCase
from pyvista.core.errors import MissingDataError
from vtkmodules.vtkCommonDataModel import vtkPartitionedDataSet, vtkPartitionedDataSetCollection
from vtkmodules.vtkFiltersAMR import vtkAMRGaussianPulseSource
from vtkmodules.vtkFiltersSources import vtkRandomHyperTreeGridSource


def cube(n=3):
    grid = pyvista.ImageData(dimensions=(n, n, n))
    grid.point_data["x"] = grid.points[:, 0]
    grid.cell_data["layer"] = np.arange(grid.n_cells, dtype=float)
    grid.point_data["wind"] = np.zeros((grid.n_points, 3))
    return grid


class Cells(PlotterTestCase):
    def add(self, grid=None, scalars="x", **options):
        return nephoscope.add_cells(self.plotter, cube() if grid is None else grid, scalars, render=False, **options)


class Accepted(Cells):
    def test_defaults(self):
        volume = self.add()
        self.assertIsInstance(volume.mapper, nephoscope.vtkCellCompositingMapper)
        self.assertEqual(volume.mapper.GetIntegration(), nephoscope.vtkCellCompositingMapper.EXACT_INTEGRATION)
        self.assertEqual(volume.mapper.GetVisibilityOrder(), nephoscope.vtkCellCompositingMapper.EXACT_ORDER)
        self.assertEqual(volume.mapper.GetOpacityScale(), 1)
        self.assertEqual(volume.mapper.scalar_range, (0, 2))
        # mean chord of the cube, 4/3, times the mean of the ramp, for a mean optical depth of 2
        self.assertAlmostEqual(volume.prop.opacity_unit_distance, 4 / 3 * 0.5 / 2)

    def test_choices_and_numbers(self):
        volume = self.add(integration="average", order="centroid", opacity_scale=2.5, opacity_unit_distance=7)
        self.assertEqual(volume.mapper.GetIntegration(), 1)
        self.assertEqual(volume.mapper.GetVisibilityOrder(), 1)
        self.assertEqual(volume.mapper.GetOpacityScale(), 2.5)
        self.assertEqual(volume.prop.opacity_unit_distance, 7)
        self.assertEqual(self.add(order="none").mapper.GetVisibilityOrder(), 2)

    def test_transfer_functions(self):
        volume = self.add(cmap=["black", "white"], opacity=[0, 0.5, 0], clim=(-1, 3))
        self.assertAlmostEqual(volume.prop.GetScalarOpacity().GetValue(1), 0.5)
        self.assertAlmostEqual(volume.prop.GetScalarOpacity().GetValue(0), 0.25)
        np.testing.assert_allclose(volume.prop.GetRGBTransferFunction().GetColor(1), (0.5,) * 3, atol=0.01)
        self.assertEqual(self.add(clim=4).mapper.scalar_range, (-4, 4))

    def test_flip_and_lookup_table(self):
        flipped = self.add(cmap=["black", "white"], flip_scalars=True).prop.GetRGBTransferFunction()
        np.testing.assert_allclose(flipped.GetColor(0), (1, 1, 1))
        table = pyvista.LookupTable(cmap=["black", "white"], scalar_range=(0, 10))
        table.apply_opacity(0.5)
        prop = self.add(cmap=table).prop
        self.assertAlmostEqual(prop.GetScalarOpacity().GetValue(3), 0.5, delta=1 / 255)
        np.testing.assert_allclose(prop.GetRGBTransferFunction().GetColor(5), (0.5,) * 3, atol=0.01)

    def test_opacity_beside_a_table(self):
        """What is given counts; the opacities of the table are taken otherwise, and it is not changed."""
        table = pyvista.LookupTable(cmap=["black", "white"], scalar_range=(0, 10))
        table.apply_opacity(0.5)
        before = np.array(table.values)
        for opacity, expected in (([0, 1], (0, 0.5, 1)), (0.1, (0.1, 0.1, 0.1)), (None, (0.5, 0.5, 0.5))):
            function = self.add(cmap=table, opacity=opacity).prop.GetScalarOpacity()
            np.testing.assert_allclose([function.GetValue(s) for s in (0, 5, 10)], expected, atol=0.01)
            np.testing.assert_array_equal(table.values, before)

    def test_opacity_of_another_array(self):
        volume = self.add(opacity_scalars="layer", opacity="linear")
        self.assertEqual(volume.mapper.GetOpacityArrayName(), "layer")
        self.assertAlmostEqual(volume.prop.GetScalarOpacity().GetValue(3.5), 0.5)
        self.assertEqual(volume.mapper.lookup_table.values[:, 3].min(), 255)  # the bar shows colours alone
        self.assertEqual(self.add().mapper.lookup_table.values[0, 3], 0)
        volume.mapper.scalar_range = (0, 100)
        self.assertAlmostEqual(volume.prop.GetScalarOpacity().GetValue(3.5), 0.5)
        volume = self.add(opacity_scalars="layer", opacity_clim=(0, 14))
        self.assertAlmostEqual(volume.prop.GetScalarOpacity().GetValue(3.5), 0.25)

    def test_log_scale_takes_the_smallest_positive(self):
        self.assertEqual(self.add(log_scale=True).mapper.scalar_range, (1, 2))

    def test_arrays(self):
        self.assertEqual(self.add(scalars="layer").mapper.GetScalarModeAsString(), "UseCellFieldData")
        grid = cube()
        volume = self.add(grid, np.arange(27.0))
        self.assertEqual(volume.mapper.GetArrayName(), "Data")
        self.assertNotIn("Data", grid.array_names)
        grid.set_active_scalars("layer")
        self.assertEqual(self.add(grid, None).mapper.GetArrayName(), "layer")

    def test_constant_and_partly_missing_values(self):
        self.assertEqual(self.add(scalars=np.full(27, 4.0)).mapper.scalar_range, (3.5, 4.5))
        self.assertEqual(self.add(scalars=np.full(27, 4.0), log_scale=True, show_scalar_bar=False).mapper.scalar_range, (2, 8))
        self.assertEqual(self.add(scalars=np.r_[np.nan, np.arange(26.0)]).mapper.scalar_range, (0, 25))

    def test_colours_beyond_the_range(self):
        """Values beyond the range of a table have the colours and opacities that it has for them, in cells, in splats and in `add_mesh`; those within keep theirs."""
        for limits, log_scale in (((0, 1), False), ((101324, 101326), False), ((1e-3, 10), True)):
            table = pyvista.LookupTable("viridis", n_values=8, scalar_range=limits, log_scale=log_scale)
            plain = self.add(scalars=np.full(27, 1.0), cmap=table, show_scalar_bar=False).prop
            table.below_range_color, table.above_range_color = (1.0, 0.0, 0.0, 0.5), "blue"
            for add in (nephoscope.add_cells, nephoscope.add_splats):
                prop = add(self.plotter, cube(), "x", cmap=table, show_scalar_bar=False).prop
                colour, opacity = prop.GetRGBTransferFunction(), prop.GetScalarOpacity()
                low, high = limits
                below, above = (low * 0.99, high * 1.01) if log_scale else (low - 0.01 * (high - low), high + 0.01 * (high - low))
                for value, wanted in ((below, (1, 0, 0)), (-1e6, (1, 0, 0)), (above, (0, 0, 1)), (1e9, (0, 0, 1))):
                    np.testing.assert_allclose(colour.GetColor(value), wanted)
                    self.assertAlmostEqual(opacity.GetValue(value), 0.5 if value < high else 1, delta=0.01)
                for value in np.linspace(low, high, 9):
                    np.testing.assert_allclose(colour.GetColor(value), plain.GetRGBTransferFunction().GetColor(value), atol=1e-6)

    def test_pictures_of_colours_beyond_the_range(self):
        table = pyvista.LookupTable("viridis", scalar_range=(0, 1))
        table.below_range_color, table.above_range_color = "red", "blue"
        for value, wanted in ((-1.0, (255, 0, 0)), (2.0, (0, 0, 255))):
            for add in (nephoscope.add_cells, nephoscope.add_splats):
                plotter = pyvista.Plotter(off_screen=True, window_size=(41, 41))
                self.addCleanup(plotter.close)
                add(plotter, cube(), np.full(27, value), cmap=table, opacity_unit_distance=0.01, show_scalar_bar=False)
                np.testing.assert_array_equal(plotter.screenshot(return_img=True)[20, 20], wanted)

    def test_rounding_errors_are_no_range(self):
        """Values that differ in the last digits are drawn like a constant, without a warning; a range of more digits is one."""
        noise = np.random.default_rng(1).uniform(-1, 1, 27)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            for values in (1 + 1e-16 * noise, 1 + 1e-15 * noise, -250 - 1e-13 * noise, (300 + 1e-4 * noise).astype(np.float32)):
                low, high = self.add(scalars=values, show_scalar_bar=False).mapper.scalar_range
                np.testing.assert_allclose((low, high), values[0] + np.array([-0.5, 0.5]), rtol=1e-6)
            for values in (1 + 1e-13 * noise, 1e-20 * noise, (300 + 0.01 * noise).astype(np.float32)):
                self.assertEqual(self.add(scalars=values, show_scalar_bar=False).mapper.scalar_range, (values.min(), values.max()))
            self.add(scalars=1 + 1e-16 * noise, clim=(1, np.nextafter(1, 2)), opacity="sigmoid")

    def test_grids_of_every_kind(self):
        image = cube()
        for grid in (image, image.cast_to_rectilinear_grid(), image.cast_to_structured_grid(), image.cast_to_unstructured_grid(),
                     image.cast_to_structured_grid().cast_to_explicit_structured_grid(),
                     image.cast_to_unstructured_grid().triangulate(), pyvista.MultiBlock([image, None, image])):
            with self.subTest(type(grid).__name__):
                self.assertGreaterEqual(self.add(grid).mapper.dataset.n_cells, 8)

    def test_a_hidden_point_at_the_corner(self):
        grid = cube().cast_to_structured_grid()
        grid.hide_points([0])
        self.assertEqual(self.add(grid).mapper.dataset.n_cells, 8)

    def test_values_without_opacity_are_told(self):
        for options, told in (({"clim": (5, 6)}, r"'x' is 0 to 2, where the opacity function is 0. Choose another clim"),
                              ({"opacity_scalars": "layer", "opacity_clim": (9, 10)}, r"'layer' is 0 to 7.*another opacity_clim"),
                              ({"scalars": np.zeros(27), "preset": "wind component"}, r"'Data' is 0 everywhere")):
            with self.assertWarnsRegex(UserWarning, "Nothing will be visible: the array " + told):
                self.add(**options)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            self.add(opacity=0)  # as the user wants
            self.add(clim=(1, 6))

    def test_values_beyond_the_range_are_told(self):
        """They make one opaque block; the range of a field that merely leaves it is not told."""
        for add in (nephoscope.add_cells, nephoscope.add_splats):
            for options, told in (({"clim": (-10, -5)}, r"colour and the opacity of the upper end: the array 'x' is 0 to 2, all above clim, -10 to -5. Choose another clim"),
                                  ({"clim": (5, 6), "opacity": "linear_r"}, r"colour and the opacity of the lower end: the array 'x' is 0 to 2, all below clim, 5 to 6"),
                                  ({"opacity_scalars": "y", "opacity_clim": (-9, -1)}, r"opacity of the upper end: the array 'y' is 0 to 2, all above opacity_clim")):
                with self.subTest(add=add.__name__, told=told), self.assertWarnsRegex(UserWarning, "The whole grid will have the " + told):
                    mesh = cube()
                    mesh["y"] = mesh.points[:, 1]
                    add(self.plotter, mesh, "x", **options)
            with warnings.catch_warnings():
                warnings.simplefilter("error")
                for options in ({"clim": (-1, 0)}, {"clim": (-1, 0.5)}, {"clim": (2, 3), "opacity": 0.5}):
                    add(self.plotter, cube(), "x", **options)

    def test_plotter_knows_the_grid(self):
        grid = cube()
        self.add(grid)
        self.assertEqual([mesh.n_cells for mesh in self.plotter.meshes], [8])
        self.assertEqual(tuple(self.plotter.bounds), tuple(grid.bounds))

    def test_name_replaces(self):
        first, second = self.add(name="clouds"), self.add(name="clouds")
        self.assertNotIn(first, self.plotter.actors.values())
        self.assertIs(self.plotter.actors["clouds"], second)

    def test_scalar_bar_comes_goes_and_moves_the_range(self):
        volume = self.add(name="clouds", show_scalar_bar=True, scalar_bar_args={"title": "fraction"})
        self.assertIn("fraction", self.plotter.scalar_bars)
        self.plotter.update_scalar_bar_range((0, 20), "fraction")
        self.assertAlmostEqual(volume.prop.GetScalarOpacity().GetValue(10), 0.5)
        self.plotter.remove_actor("clouds")
        self.assertNotIn("fraction", self.plotter.scalar_bars)
        self.add(show_scalar_bar=False)
        self.assertEqual(len(self.plotter.scalar_bars), 0)


class AnyData(Cells):
    """Data as it comes from other readers and sources."""

    def test_without_active_scalars_the_first_array_of_numbers_is_drawn(self):
        grid = cube()
        grid.clear_data()
        grid.point_data["wind"] = grid.points
        grid.point_data["words"] = ["a"] * 27
        grid.cell_data["cover"] = np.arange(8) > 3
        grid.set_active_scalars(None)
        self.assertEqual(self.add(grid, None).mapper.GetArrayName(), "cover")
        grid.point_data["x"] = grid.points[:, 0]
        grid.set_active_scalars(None)
        self.assertEqual(self.add(grid, None).mapper.GetArrayName(), "x")

    def test_vectors_first(self):
        """As OpenFOAM writes them: the active scalars are vectors, and the first array of one number each is drawn."""
        grid = pyvista.ImageData(dimensions=(4, 4, 4))
        grid["U"] = np.tile((1.0, 0, 0), (grid.n_points, 1))
        grid["pointIds"] = np.arange(grid.n_points)
        grid.cell_data["vtkGhostType"] = np.zeros(grid.n_cells, np.uint8)
        self.assertEqual(nephoscope.add_cells(self.plotter, grid).mapper.GetArrayName(), "U")
        grid["T"] = grid.points[:, 0]
        grid["p"] = grid.points[:, 1]
        self.assertEqual(grid.active_scalars_name, "U")
        for add in (nephoscope.add_cells, nephoscope.add_splats):
            for data in (grid, pyvista.MultiBlock([grid, grid.copy()])):
                self.assertEqual(add(self.plotter, data, render=False).mapper.GetArrayName(), "T")

    def test_truth_values(self):
        grid = cube()
        grid.point_data["inside"] = grid.points[:, 0] > 0.5
        self.assertEqual(self.add(grid, "inside").mapper.scalar_range, (0, 1))

    def test_unit_distance_from_finite_points(self):
        mesh = cube().cast_to_unstructured_grid()
        expected = self.add(mesh.copy(), "x").prop.opacity_unit_distance
        points = mesh.points.copy()
        points[13] = np.inf
        mesh.points = points
        found = self.add(mesh, "x").prop.opacity_unit_distance  # parts of cells at that point have no volume
        self.assertTrue(0.5 * expected < found < expected, (found, expected))

    def test_adaptive_and_partitioned_grids(self):
        amr = vtkAMRGaussianPulseSource()
        amr.Update()
        drawn = self.add(amr.GetOutput(), None).mapper.dataset
        covered = sum(pyvista.ImageData(amr.GetOutput().GetDataSet(0, k)).volume for k in range(amr.GetOutput().GetNumberOfDataSets(0)))
        self.assertAlmostEqual(drawn.volume, covered, delta=1e-6 * covered, msg="coarse cells below fine ones are drawn too")
        tree = vtkRandomHyperTreeGridSource()
        tree.Update()
        box = np.prod(np.ptp(np.reshape(tree.GetOutputDataObject(0).GetBounds(), (3, 2)), axis=1))
        self.assertAlmostEqual(self.add(tree.GetOutputDataObject(0), None).mapper.dataset.volume, box, delta=1e-5 * box)
        parts, parts_of_parts = vtkPartitionedDataSet(), vtkPartitionedDataSetCollection()
        for k, data in enumerate((cube(), cube().translate((2, 0, 0)))):
            parts.SetPartition(k, data)
            parts_of_parts.SetPartition(k, 0, data)
        for data in (parts, parts_of_parts):
            self.assertEqual(self.add(data, "x").mapper.dataset.n_cells, 16)


class Refused(Cells):
    def test_arrays(self):
        self.fails(MissingDataError, "no array 'cloud'. Point arrays: 'x', 'wind'; cell arrays: 'layer'", scalars="cloud")
        self.fails(ValueError, r"shape \(5,\).*27 points or 8 cells", scalars=np.zeros(5))
        self.fails(ValueError, "'Data' has no finite value", scalars=np.full(27, np.nan))
        self.fails(MissingDataError, "opacity_scalars: no array 'cloud'", opacity_scalars="cloud")
        self.fails(ValueError, "opacity_scalars: the array 'wind' has 3", opacity_scalars="wind")
        self.fails(ValueError, "opacity_clim is given without", opacity_clim=(0, 1))
        words = cube()
        words.cell_data["words"] = ["a"] * 8
        self.fails(TypeError, "'words' is of type", words, "words")
        bare = pyvista.ImageData(dimensions=(2, 2, 2))
        bare.cell_data["vtkOriginalCellIds"] = [0]
        with self.assertRaisesRegex(MissingDataError, "'vtkOriginalCellIds'. Arrays of ids are not chosen"):
            default_scalars(bare)
        bare.cell_data["wind"] = [[1, 0, 0]]
        self.assertEqual(default_scalars(bare, vectors_too=True), ("cell", "wind"))
        self.assertEqual(self.add(bare, None).mapper.GetArrayName(), "wind")

    def test_numbers_and_choices(self):
        for bad in (0, -1, np.nan, np.inf):
            self.fails(ValueError, "opacity_unit_distance is .*greater than 0", opacity_unit_distance=bad)
        self.fails(ValueError, "opacity_scale is -1.*at least 0", opacity_scale=-1)
        self.fails(ValueError, "integration is 'simpson'.*'exact', 'average'", integration="simpson")
        self.fails(ValueError, "order is 'random'.*'exact', 'centroid', 'none'", order="random")
        self.fails(ValueError, "clim is .*ascending", clim=(2, 1))
        self.fails(ValueError, "preference", preference="both")
        self.fails(ValueError, "'x' has no value above 0|ascending", clim=(-2, -1), log_scale=True)
        self.fails(ValueError, "opacity 'thick' is unknown", opacity="thick")
        self.fails(ValueError, "interpolation is 'cubic'.*'automatic', 'trilinear', 'tetrahedra'", interpolation="cubic")
        self.fails(ValueError, "n_colors is 0", n_colors=0)
        self.fails(ValueError, "cmap has no colours", cmap=[])
        self.fails(TypeError, "unexpected keyword argument 'colour'. Did you mean 'color'", colour="red")
        for name, remedy in (("shade", "sun="), ("ambient", "[.]prop"), ("nan_color", "not drawn"), ("above_color", "LookupTable as cmap"), ("blending", "composited")):
            self.fails(TypeError, rf"add_cells\(\) has no argument '{name}'[.] .*{remedy}", **{name: 1})
        self.fails(TypeError, "opacity is a function; .*linspace", opacity=lambda x: x)
        with self.assertRaisesRegex(TypeError, r"grid is a str; .* Read it: pyvista.read\('case.vtu'\)"):
            nephoscope.add_cells(pyvista.Plotter(), "case.vtu")

    def test_grids(self):
        self.fails(ValueError, "PolyData of .* has no 3-D cells", pyvista.Sphere(), None)
        self.fails(ValueError, "no 3-D cells", pyvista.ImageData(dimensions=(3, 3, 1)), None)
        self.fails(ValueError, "no 3-D cells", pyvista.Sphere().cast_to_unstructured_grid(), None)
        self.fails(ValueError, "has no cells", pyvista.MultiBlock(), None)
        self.fails(TypeError, "grid is a str", "grid", None)

    def test_plotter(self):
        with self.assertRaisesRegex(TypeError, "plotter is a UniformGrid|plotter is a ImageData"):
            nephoscope.add_cells(cube(), cube(), "x")


if __name__ == "__main__":
    unittest.main()
