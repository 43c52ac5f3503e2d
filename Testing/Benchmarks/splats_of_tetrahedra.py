# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Constant cell data of tetrahedra as splats: mass and ripple of the optical depth, by the factor of the radius. ./nephoscope python Testing/Benchmarks/splats_of_tetrahedra.py

Ripple is the root mean square deviation of the optical depth in the middle of the picture from a polynomial of second degree, over the mean. An 8-bit picture hides less than 0.3 %.
"""
import nephoscope
import numpy as np
import pyvista

COLUMNS, MIDDLE = 16, slice(125, 175)
VIEWS = {"along an axis": (0, 0, 1), "oblique": (0.2, 0.1, 1)}


def meshes():
    for layers in (1, 4, 16):
        image = pyvista.ImageData(dimensions=(COLUMNS + 1, COLUMNS + 1, layers + 1))
        for count in (5, 6):
            yield f"{count} in every cube, {layers} layers", image.to_tetrahedra(count)
    corners = np.array(np.meshgrid(*[[0, COLUMNS]] * 3)).reshape(3, -1).T
    points = COLUMNS * np.random.default_rng(1).random((3000, 3))
    yield "Delaunay", pyvista.PolyData(np.vstack([points, corners])).delaunay_3d()


def optical_depth(mesh, factor, direction):
    mesh = pyvista.UnstructuredGrid(mesh.cells, mesh.celltypes, mesh.points)
    mesh.cell_data["a"] = np.ones(mesh.n_cells)
    plotter = pyvista.Plotter(off_screen=True, window_size=(300, 300))
    plotter.set_background("black")
    depth = 2.0 / np.ptp(mesh.points[:, 2])
    nephoscope.add_splats(plotter, mesh, "a", cmap=["white", "white"], opacity=[depth / (1 + depth)] * 2, opacity_unit_distance=1 / (1 + depth), clim=(0, 2), radius_factor=factor,
                          show_scalar_bar=False, preset=False)
    plotter.view_vector(direction, viewup=(0, 1, 0))
    plotter.enable_parallel_projection()
    plotter.camera.parallel_scale = COLUMNS
    light = plotter.screenshot(return_img=True).astype(float)[..., 0] / 255
    plotter.close()
    return -np.log(np.clip(1 - light, 1 / 255, 1))


def ripple(depth):
    y, x = (axis.ravel() for axis in np.mgrid[-0.5:0.5:50j, -0.5:0.5:50j])
    terms = np.stack([np.ones(x.size), x, y, x * x, y * y, x * y], axis=1)
    return (depth.ravel() - terms @ np.linalg.lstsq(terms, depth.ravel(), rcond=None)[0]).std() / depth.mean()


print(f"{'tetrahedra':30s} {'view':14s} factor  depth    mass  ripple")
for name, mesh in meshes():
    for view, direction in VIEWS.items():
        whole = None
        for factor in (1.0, 1.25, 1.5):
            depth = optical_depth(mesh, factor, direction)
            whole = whole or depth.sum()
            middle = depth[MIDDLE, MIDDLE]
            print(f"{name:30s} {view:14s} {factor:6.2f} {middle.mean():6.3f} {depth.sum() / whole:7.4f} {100 * ripple(middle):6.2f} %")
