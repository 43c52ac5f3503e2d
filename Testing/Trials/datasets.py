# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The datasets of the trials, one line each: name, what can be shown of it, how it is made.

What can be shown, as one letter each:
    c   3-D cells with finite scalars: cell compositing            p   points or cells with finite scalars: splats
    s   polygons, its own or those around its cells                f   3-D cells with point scalars: contours, division
    g   structured grid with point scalars: smoothing, clouds      v   vectors at the points of 3-D cells: smoke, winds
    l   longitude, latitude, level in degrees: a globe             w   point scalars and point vectors "v": streaks
A function that needs what a dataset does not have must say so; one that has all it needs must draw. A star: in the fast subset.
"""
import os

import numpy as np
import pyvista as pv
import vtkmodules.all as vtk
from pyvista import examples
from pyvista.examples import cells as example_cells

DATASETS = {}


class Dataset:
    def __init__(self, name, shows, make, views):
        self.name, self.make, self.fast, self.views = name, make, "*" in shows, views
        self.shows = set(shows.replace("*", ""))
        self.shows |= {"w"} if "v" in self.shows and "p" in self.shows else set()


def add(name, shows, make, views=False):
    """views: drawn by the special cameras too."""
    assert name not in DATASETS, name
    DATASETS[name] = Dataset(name, shows, make, views)


# --- fields -----------------------------------------------------------------------------------------------------------

def field(mesh, low=0.0, high=1.0):
    """Point scalars `s` from low to high, not symmetric, and vectors `v`, a vortex with a through-flow, in lengths of the bounds."""
    low_corner, size = np.array(mesh.bounds[::2]), max(mesh.length, 1e-300)
    x, y, z = ((np.asarray(mesh.points, float) - low_corner) / size).T
    s = 0.5 + 0.5 * np.sin(5 * x + 3 * y) * np.cos(4 * z + x)
    s = (s - s.min()) / max(np.ptp(s), 1e-300)
    mesh.point_data["s"] = low + (high - low) * s
    mesh.point_data["v"] = np.stack([0.3 - (y - y.mean()), x - x.mean(), 0.2 + 0 * z], 1) * size
    mesh.set_active_scalars("s")
    return mesh


def image(dimensions=(9, 8, 7), spacing=(1, 1, 1), origin=(-4, -3.5, -3), **options):
    return field(pv.ImageData(dimensions=dimensions, spacing=spacing, origin=origin), **options)


def curvilinear(sign=1):
    r, a, z = np.meshgrid(np.linspace(1, 2, 6), np.linspace(0, 2.5, 9), np.linspace(0, 1, 5), indexing="ij")
    return field(pv.StructuredGrid(sign * r * np.cos(a), r * np.sin(a), z))


def shell(n=(13, 9, 3)):
    """Longitudes closed by a repeated column, both poles: as a globe grid."""
    lon, lat, r = np.meshgrid(*[np.linspace(*x) for x in ((0, 2 * np.pi, n[0]), (-np.pi / 2, np.pi / 2, n[1]), (1, 1.3, n[2]))], indexing="ij")
    return field(pv.StructuredGrid(r * np.cos(lat) * np.cos(lon), r * np.cos(lat) * np.sin(lon), r * np.sin(lat)))


def hexahedra():
    return image().cast_to_unstructured_grid()


def tetrahedra():
    mesh = image((6, 5, 5), origin=(0, 0, 0)).to_tetrahedra() if hasattr(pv.ImageData, "to_tetrahedra") else image().triangulate()
    return field(mesh.cast_to_unstructured_grid())


def random_tetrahedra():
    return field(pv.PolyData(np.random.default_rng(3).random((60, 3))).delaunay_3d())


def points():
    return field(pv.PolyData(np.random.default_rng(5).random((200, 3))))


def moved(mesh, scale=1.0, offset=(0, 0, 0)):
    mesh = mesh.cast_to_unstructured_grid() if not isinstance(mesh, pv.ImageData) else mesh
    if isinstance(mesh, pv.ImageData):
        mesh.spacing, mesh.origin = np.array(mesh.spacing) * scale, np.array(mesh.origin) * scale + offset
    else:
        mesh.points = np.asarray(mesh.points, float) * scale + offset
    return field(mesh)


def one_array(values, name="s", mesh=None, where="point"):
    """The image, or mesh, with one array alone: values, or a function of the number of values."""
    mesh = image() if mesh is None else mesh
    mesh.clear_data()
    n = mesh.n_points if where == "point" else mesh.n_cells
    data = mesh.point_data if where == "point" else mesh.cell_data
    data[name] = values(n) if callable(values) else values
    mesh.set_active_scalars(name, where) if data[name].dtype.kind not in "USOb" and data[name].ndim == 1 else None
    return mesh


def ramp(n):
    return np.sin(np.arange(n) * 0.1) * 0.5 + 0.5


def holed(values, mesh=None):
    """Every seventh value is replaced."""
    mesh = image() if mesh is None else mesh
    mesh["s"][::7] = values
    return mesh


def changed_points(change, mesh=None):
    mesh = tetrahedra() if mesh is None else mesh
    xyz = np.array(mesh.points, float)
    change(xyz)
    mesh.points = xyz
    return mesh


def separate_cells(mesh):
    """Every cell with points of its own: coincident points everywhere."""
    return mesh.separate_cells() if hasattr(mesh, "separate_cells") else mesh.explode(0)


def doubled(mesh):
    return mesh.merge(mesh.copy(), merge_points=False)


def blocks(*members):
    return pv.MultiBlock(list(members))


def made_by(source, *settings):
    source = source()
    for name, *values in settings:
        getattr(source, name)(*values)
    source.Update()
    return pv_or_vtk(source.GetOutputDataObject(0))


def pv_or_vtk(data):
    try:
        return pv.wrap(data)
    except (TypeError, NotImplementedError):
        return data


def cell_source(cell_type):
    return made_by(vtk.vtkCellTypeSource, ("SetCellType", cell_type), ("SetCellOrder", 2))


def weather():
    import nephoscope
    return nephoscope.read_cf(os.path.join(os.environ["NEPHOSCOPE_DATA"], "gfs_2p5deg_2011101100.nc"))


def globe(**options):
    import nephoscope
    result = nephoscope.to_globe(weather(), **{"vertical_exaggeration": 30, **options})
    result.set_active_scalars("cloud_fraction")
    return result


def coarse_globe():
    return globe().extract_subset((0, 144, 0, 72, 0, 25), rate=(6, 6, 8), boundary=True)


def lonlat(units="degrees"):
    scale = np.pi / 180 if units == "radians" else 1.0
    mesh = pv.RectilinearGrid(np.arange(0, 360, 30.0) * scale, np.linspace(-75, 75, 6) * scale, np.array([0.0, 5000, 10000]))
    return field(mesh)


SOLID, GRID = "cpsfv", "cpsfvg"

# --- structured -------------------------------------------------------------------------------------------------------
add("image", GRID + "*", image, views=True)
add("wavelet", "cpsfg", lambda: pv.Wavelet(extent=(-4, 4, -4, 4, -4, 4)), views=True)
add("image-flat-voxels", GRID, lambda: image(spacing=(1, 0.05, 20)))
add("image-extent", GRID, lambda: field(made_by(vtk.vtkRTAnalyticSource, ("SetWholeExtent", 3, 9, -7, -1, 12, 18))))
add("image-two-points", GRID, lambda: image((2, 2, 2)))
add("image-one-layer", "psw", lambda: image((9, 8, 1)))
add("image-line", "pw", lambda: image((9, 1, 1)))
add("image-one-point", "pw", lambda: image((1, 1, 1)))
add("rectilinear", GRID, lambda: field(pv.RectilinearGrid(np.arange(7.0) ** 2, np.geomspace(1, 50, 8), np.array([0, 1, 1.5, 9, 20.0]))))
add("rectilinear-falling", GRID, lambda: field(pv.RectilinearGrid(-np.arange(7.0) ** 2, np.arange(8.0), -np.arange(5.0))))
add("curvilinear", GRID + "*", curvilinear, views=True)
add("curvilinear-left-handed", GRID, lambda: curvilinear(-1))
add("shell", GRID, shell, views=True)
add("hidden-cells", GRID, lambda: curvilinear().hide_cells(np.arange(0, 160, 3)))
add("hidden-all", "", lambda: curvilinear().hide_cells(np.arange(160)))
add("explicit-structured", "cpsfv", lambda: field(examples.load_explicit_structured()))

# --- unstructured -----------------------------------------------------------------------------------------------------
add("tetrahedra", SOLID + "*", tetrahedra, views=True)
add("tetrahedra-random", SOLID, random_tetrahedra, views=True)
add("hexahedra", SOLID, hexahedra, views=True)
add("shell-tetrahedra", SOLID, lambda: field(shell().triangulate()), views=True)
add("shell-hexahedra", SOLID, lambda: shell().cast_to_unstructured_grid())
add("separate-cells", SOLID, lambda: field(separate_cells(hexahedra())))
add("swiss-cheese", SOLID, lambda: field(hexahedra().extract_cells(np.flatnonzero(np.random.default_rng(1).random(336) < 0.6))))
add("slabs", "cpsfw", lambda: field(pv.merge([pv.ImageData(dimensions=(3, 3, 2), spacing=(1, 1, 0.01), origin=(0, 0, k)) for k in range(20)])))
add("cells-twice", SOLID, lambda: doubled(tetrahedra()))
add("overlapping", SOLID, lambda: field(image().cast_to_unstructured_grid().merge(image(origin=(-2.3, -3.1, -1.7)), merge_points=False)))
for kind in ("Tetrahedron", "Hexahedron", "Voxel", "Wedge", "Pyramid", "PentagonalPrism", "HexagonalPrism", "Polyhedron", "ConvexPointSet",
             "QuadraticTetrahedron", "QuadraticHexahedron", "QuadraticWedge", "QuadraticPyramid", "TriQuadraticHexahedron",
             "BiQuadraticQuadraticHexahedron", "BiQuadraticQuadraticWedge", "QuadraticLinearWedge", "LagrangeTetrahedron",
             "LagrangeHexahedron", "LagrangeWedge", "BezierTetrahedron", "BezierHexahedron", "BezierWedge", "TriQuadraticPyramid"):
    add("one-" + kind.lower(), SOLID + ("*" if kind in ("Polyhedron", "QuadraticHexahedron") else ""),
        lambda kind=kind: field(getattr(example_cells, kind)()))
for kind in ("Vertex", "PolyVertex", "Line", "PolyLine", "QuadraticEdge"):
    add("one-" + kind.lower(), "pw", lambda kind=kind: field(getattr(example_cells, kind)()))
for kind in ("Triangle", "TriangleStrip", "Polygon", "Pixel", "Quadrilateral", "QuadraticTriangle", "LagrangeQuadrilateral"):
    add("one-" + kind.lower(), "psw", lambda kind=kind: field(getattr(example_cells, kind)()))
for kind, shows in (("TETRA", "cpsf"), ("WEDGE", "cpsf"), ("QUADRATIC_HEXAHEDRON", "cpsf"), ("LAGRANGE_HEXAHEDRON", "cpsf"),
                    ("BEZIER_WEDGE", "cpsf"), ("QUADRATIC_TRIANGLE", "ps")):
    add("source-" + kind.lower(), shows, lambda kind=kind: cell_source(int(pv.CellType[kind])))
add("hexbeam", SOLID, lambda: field(examples.load_hexbeam()))
add("tetbeam", SOLID, lambda: field(examples.load_tetbeam()))
add("mixed", SOLID, lambda: field(pv.merge([example_cells.Tetrahedron(), example_cells.Hexahedron().translate((2, 0, 0)),
                                            example_cells.Triangle().translate((0, 2, 0)), example_cells.Line().translate((0, 0, 2))])))

# --- sizes and places -------------------------------------------------------------------------------------------------
add("tiny-1e-9", SOLID + "*", lambda: moved(tetrahedra(), 1e-9))
add("tiny-image-1e-9", GRID, lambda: moved(image(), 1e-9))
add("huge-1e6", SOLID, lambda: moved(tetrahedra(), 1e6))
add("huge-image-1e9", GRID, lambda: moved(image(), 1e9))
add("offset-1e9", SOLID, lambda: moved(tetrahedra(), 1e6, (1e9, -2e9, 1e9)))
add("offset-image-1e9", GRID + "*", lambda: moved(image(), 1e6, (1e9, -2e9, 1e9)))
add("offset-far", SOLID, lambda: moved(tetrahedra(), 1, (1e5, 1e5, 1e5)))
add("needle", SOLID, lambda: changed_points(lambda p: p.__imul__((1, 1, 30))))

# --- degenerate -------------------------------------------------------------------------------------------------------
add("some-flat-cells", SOLID, lambda: changed_points(lambda p: p.__setitem__(slice(0, 30), p[0])))
add("all-flat", "psw", lambda: changed_points(lambda p: p.__imul__((1, 1, 0))))
add("all-one-place", "pw", lambda: changed_points(lambda p: p.__imul__(0)))
add("inside-out", SOLID, lambda: changed_points(lambda p: p.__imul__((-1, 1, 1))))
add("nan-point", "cpsfv", lambda: changed_points(lambda p: p.__setitem__((7, 0), np.nan)))
add("inf-point", "cpsfv", lambda: changed_points(lambda p: p.__setitem__((7, 0), np.inf)))
add("nan-all-points", "", lambda: changed_points(lambda p: p.fill(np.nan)))

# --- values -----------------------------------------------------------------------------------------------------------
add("nan-some", GRID + "*", lambda: holed(np.nan))
add("nan-some-tetrahedra", SOLID, lambda: holed(np.nan, tetrahedra()))
add("inf-some", GRID, lambda: holed(np.inf))
add("minus-inf-some", GRID, lambda: holed(-np.inf))
add("nan-all", "s*", lambda: holed(np.nan, one_array(lambda n: np.full(n, np.nan))))
add("fill-1e30", GRID, lambda: holed(1e30))
add("values-1e300", GRID, lambda: image(low=-1e300, high=1e300))
add("values-1e-300", GRID, lambda: image(low=0, high=1e-300))
add("values-1e9-apart-1", GRID, lambda: image(low=1e9, high=1e9 + 1))
add("values-negative", GRID, lambda: image(low=-5, high=-2))
add("constant", "cpsf*", lambda: one_array(lambda n: np.full(n, 3.0)))
add("constant-zero", "cpsf", lambda: one_array(lambda n: np.zeros(n)))
add("two-values", GRID, lambda: image(low=0, high=0.4) if not image()["s"].__imul__(0).any() else None)
for kind in ("uint8", "int8", "int16", "uint16", "int32", "int64", "uint64", "float32"):
    add("array-" + kind, "cpsfg", lambda kind=kind: one_array(lambda n: (ramp(n) * 100).astype(kind)))
add("array-bool", "cpsfg", lambda: one_array(lambda n: ramp(n) > 0.5))
add("array-string", "s", lambda: one_array(lambda n: np.array(["a", "b"])[np.arange(n) % 2]))
add("array-complex", "s", lambda: one_array(lambda n: ramp(n) + 1j))
add("array-rgb", "s", lambda: one_array(lambda n: (np.stack([ramp(n)] * 3, 1) * 255).astype(np.uint8)))
add("array-vectors-only", "sv", lambda: one_array(lambda n: np.random.default_rng(2).random((n, 3)) + 0.5, "v"))
add("array-name-empty", "cpsfg", lambda: one_array(ramp, " "))
add("array-name-odd", "cpsfg", lambda: one_array(ramp, "Wolken µ/m² \"%s\" {0}"))
add("cell-data", "cps*", lambda: one_array(ramp, where="cell"))
add("cell-data-tetrahedra", "cps", lambda: one_array(ramp, mesh=tetrahedra(), where="cell"))
add("cell-nan", "cps", lambda: one_array(lambda n: np.where(np.arange(n) % 5, ramp(n), np.nan), where="cell"))
add("no-arrays", "cps*", lambda: pv.ImageData(dimensions=(5, 4, 3)))
add("ghost-cells", SOLID, lambda: ghosts(tetrahedra()))
add("same-name-twice", GRID, lambda: twice_named(image()))


def ghosts(mesh):
    mesh.cell_data["vtkGhostType"] = (np.arange(mesh.n_cells) % 4 == 0).astype(np.uint8)
    return mesh


def twice_named(mesh):
    mesh.cell_data["s"] = np.arange(mesh.n_cells, dtype=float)
    return mesh


# --- nothing, and not grids -------------------------------------------------------------------------------------------
add("empty-unstructured", "*", pv.UnstructuredGrid)
add("empty-image", "", pv.ImageData)
add("empty-structured", "", pv.StructuredGrid)
add("empty-polydata", "", pv.PolyData)
add("empty-blocks", "*", pv.MultiBlock)
add("points-no-cells", "pw", lambda: field(pv.UnstructuredGrid(np.array([], int), np.array([], np.uint8), np.random.default_rng(1).random((50, 3)))))
add("point-cloud", "pw*", points)
add("lines", "pw", lambda: field(pv.Spline(np.random.default_rng(1).random((8, 3)), 60)))
add("sphere", "psw", lambda: field(pv.Sphere(theta_resolution=12, phi_resolution=9)))
add("plane", "psw*", lambda: field(pv.Plane(i_resolution=6, j_resolution=6)))
add("airplane", "psw", lambda: field(examples.load_airplane()))
add("random-hills", "ps", examples.load_random_hills)
add("structured-sheet", "psw", lambda: field(examples.load_structured()))
add("table", "", lambda: pv.Table({"s": np.arange(5.0)}))
add("none", "", lambda: None)
add("text", "", lambda: "clouds.vtk")
add("numpy-volume", "cpsf", lambda: np.random.default_rng(1).random((5, 6, 7)))
add("numpy-points", "", lambda: np.random.default_rng(1).random((50, 3)))

# --- several ----------------------------------------------------------------------------------------------------------
add("blocks", "cpsfv*", lambda: blocks(image(), image(origin=(6, 0, 0))))
add("blocks-mixed", "cpsfv", lambda: blocks(image(), field(tetrahedra().translate((8, 0, 0))), field(pv.Sphere(center=(0, 9, 0)))))
add("blocks-nested", "cpsfv", lambda: blocks(image(), blocks(image(origin=(6, 0, 0)), blocks(image(origin=(0, 9, 0))))))
add("blocks-with-none", "cpsfv", lambda: blocks(None, image(), None))
add("blocks-other-arrays", "s", lambda: blocks(one_array(ramp, "a"), one_array(ramp, "b", image(origin=(6, 0, 0)))))
add("blocks-partial", "sv", lambda: blocks(image(), pv.ImageData(dimensions=(3, 3, 3))))
add("partitioned", "cpsfv", lambda: partitioned(image(), image(origin=(6, 0, 0))))
add("partitioned-collection", "cpsfv", lambda: collection(image(), image(origin=(6, 0, 0))))
add("amr", "cps", lambda: made_by(vtk.vtkAMRGaussianPulseSource))
add("hyper-tree-grid", "cps", lambda: hyper_tree_grid())


def partitioned(*members):
    data = vtk.vtkPartitionedDataSet()
    for k, member in enumerate(members):
        data.SetPartition(k, member)
    return pv_or_vtk(data)


def collection(*members):
    data = vtk.vtkPartitionedDataSetCollection()
    for k, member in enumerate(members):
        data.SetPartition(k, 0, member)
    return pv_or_vtk(data)


def hyper_tree_grid():
    return made_by(vtk.vtkRandomHyperTreeGridSource, ("SetDimensions", (4, 4, 4)), ("SetMaxDepth", 3), ("SetSeed", 3))


# --- weather ----------------------------------------------------------------------------------------------------------
add("gfs", "cpsfgl", weather)
add("gfs-globe", GRID, globe)
add("gfs-globe-default", GRID, lambda: globe(vertical_exaggeration=1))
add("gfs-globe-tetrahedra", SOLID, lambda: coarse_globe().triangulate(), views=True)
add("gfs-globe-hexahedra", SOLID, lambda: coarse_globe().cast_to_unstructured_grid())
add("gfs-map", GRID, lambda: globe(projection="map"))
add("lonlat", "cpsfgvl*", lonlat)
add("lonlat-radians", "pwg", lambda: lonlat("radians"))
add("channels", "cps", lambda: examples.load_channels().extract_subset((0, 250, 0, 250, 0, 250), rate=(12, 12, 12)))
add("hydrogen", "cpsfg", lambda: examples.load_hydrogen_orbital(3, 2, -1, zoom_fac=0.5).resample(dimensions=(16, 16, 16)))
add("uniform", "cpsfg", examples.load_uniform)
add("rectilinear-example", "cps", lambda: examples.load_rectilinear())
