# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Polyhedra that are not convex: Cell Compositing draws them rightly by itself, and the filter is there."""
import nephoscope
import numpy as np
from nephoscope_testing import dual_meshes, meshes, nonconvex
from PluginTesting import check, check_same, compose, image, load_plugin, look, new_view, passed, pvs
from vtkmodules.vtkCommonDataModel import VTK_HEXAHEDRON

HAS_TETGEN = nephoscope.vtkPolyhedronToTetrahedra.HasTetGen()
SQUARE = ((0, 0), (1, 0), (1, 1), (0, 1))


def producer(data):
    source = pvs.TrivialProducer()
    source.GetClientSideObject().SetOutput(data)
    source.UpdatePipeline()
    return source


def picture(data, array=("POINTS", "s"), position=(4, 3, 10), focal_point=(1.5, 1, 0.5)):
    view = new_view()
    display = compose(producer(data), view, array)
    display.CellCompositingOpacityScale = 2
    look(view, position, focal_point)
    result = image(view)
    check(result.mean() > 3, "nothing is drawn")
    return result


def cubes(corners):
    offsets = np.array(meshes.HEXAHEDRON)
    points = np.vstack([np.array(c, float) + offsets for c in corners])
    return meshes.grid(points, [(VTK_HEXAHEDRON, range(8 * i, 8 * i + 8)) for i in range(len(corners))])


def check_picture_is_that_of_convex_cells():
    field = lambda p: p @ [0.5, -0.3, 0.4]
    for name, polygon, corners in (
            ("L", nonconvex.L_POLYGON, [(0, 0), (1, 0), (0, 1)]),
            ("plus", nonconvex.PLUS_POLYGON, [(1, 1), (0, 1), (2, 1), (1, 0), (1, 2)]),
            ("U", nonconvex.U_POLYGON, [(0, 0), (1, 0), (2, 0), (0, 1), (2, 1)])):
        if name == "U" and not HAS_TETGEN:
            continue
        # A cube apart, so that the cell data have a range.
        points, faces, _ = nonconvex.prism(polygon)
        cube, cube_faces, _ = nonconvex.prism(SQUARE)
        cells = [faces, [[v + len(points) for v in face] for face in cube_faces]]
        whole = meshes.with_field(nonconvex.grid_of(np.vstack([points, cube + (3.5, 0, 0)]), cells), field)
        parts = meshes.with_field(cubes([(x, y, 0) for x, y in corners] + [(3.5, 0, 0)]), field)
        check_same(picture(whole), picture(parts), f"{name}-shaped polyhedron and cubes", largest=1, mean=0.02)
        meshes.add_array(whole.GetCellData(), np.array([1.0, 0.0]), "c")
        meshes.add_array(parts.GetCellData(), np.array([1.0] * len(corners) + [0.0]), "c")
        check_same(picture(whole, ("CELLS", "c")), picture(parts, ("CELLS", "c")), f"{name}, cell data", largest=1, mean=0.02)


def check_dual_mesh():
    """The dual of a mesh with a linear field looks as the mesh does."""
    mesh, primal = dual_meshes.openfoam_like(np.random.default_rng(1), 0.6, 0.2)
    field = lambda p: p @ [0.5, -0.3, 0.4]
    look_at = dict(position=(1.5, 1, 4), focal_point=(0, 0, 0))
    pictures = [picture(meshes.with_field(d, field), **look_at) for d in (mesh.grid(), primal)]
    check_same(*pictures, "dual mesh", largest=2, mean=0.05)


def check_filter():
    points, faces, volume = nonconvex.schonhardt()
    cube, cube_faces, _ = nonconvex.prism(SQUARE)
    data = nonconvex.grid_of(np.vstack([points, cube + (4, 0, 0)]),
                             [faces, [[v + len(points) for v in f] for f in cube_faces]])
    meshes.with_field(data, lambda p: p[:, 2])
    divider = pvs.PolyhedrontoTetrahedra(Input=producer(data))
    divider.UpdatePipeline()
    information = divider.GetDataInformation()
    check(information.GetNumberOfCells() == 8 + 1, f"{information.GetNumberOfCells()} cells")
    check(information.GetNumberOfPoints() == 6 + 8 + 1, f"{information.GetNumberOfPoints()} points")
    divider.DivideConvexPolyhedra = 1
    divider.UpdatePipeline()
    check(divider.GetDataInformation().GetNumberOfCells() == 8 + 6, "the cube should be six tetrahedra")
    sizes = pvs.IntegrateVariables(Input=divider)
    sizes.UpdatePipeline()
    found = sizes.CellData["Volume"].GetRange()[0]
    check(abs(found - volume - 1) < 1e-6, f"volume {found}, expected {volume + 1}")


load_plugin()
pvs._DisableFirstRenderCameraReset()
check_filter()
check_picture_is_that_of_convex_cells()
check_dual_mesh()
passed()
