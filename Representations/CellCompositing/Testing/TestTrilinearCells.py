# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Hexahedra, voxels, wedges and pyramids are drawn with the trilinear field of VTK's cells, and look the same however they are stored.

References: dense samples along the rays, by a formula for rectilinear grids and by VTK's cells for others; for linear fields the
exact integral over tetrahedra.
"""
import itertools
import unittest

import numpy as np
from nephoscope_testing import meshes, polyhedra, reference
from nephoscope_testing.checks import mapper
from nephoscope_testing.offscreen import Window, float_image
from nephoscope_testing.transfer import Transfer
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (VTK_HEXAHEDRON, VTK_VOXEL, vtkCellLocatorStrategy, vtkDataSetAttributes, vtkPlane,
                                           vtkPlaneCollection, vtkPolyData, vtkStaticCellLocator)
from vtkmodules.vtkFiltersCore import vtkAppendFilter, vtkProbeFilter
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkVolumeProperty

COLOURS = [(0, 0.1, 0.2, 1), (0.5, 0.2, 1, 0.3), (1, 1, 0.1, 0)]
RAMP = Transfer(COLOURS, [(0, 0), (1, 1)], unit_distance=0.4)
CLEAR_BELOW = Transfer(COLOURS, [(0, 0), (0.35, 0), (1, 1)], unit_distance=0.2)
STEP = 1 / 255
BENT = 3  # pixels of 2,304: where a ray grazes faces of the boundary that are not plane, its way in depends on their diagonals
SIZE = 48
# Position, focus, parallel scale or None; the data lie around 0 within 0.5.
VIEWS = dict(far=((1.9, 1.3, 1.1), (0, 0, 0), None), other=((-1.1, 0.7, -2.2), (0.1, 0, 0), None), along_x=((3, 0.03, 0.02), (0, 0.03, 0.02), 0.7),
             along_z=((0, 0, 3), (0, 0, 0), None), diagonal=((2, 2, 2), (0, 0, 0), 0.8), in_a_plane=((0.3, 0.1, 2), (0.3, 0.1, 0), None),
             inside=((0.13, -0.22, 0.09), (1, 0.4, -0.2), None), on_a_point=((0, 0, 0), (1, 0.4, 0.3), None), on_a_face=((0, 0.05, 0.06), (0, 1, 0.3), None))


def smooth(p):
    return 0.5 + 0.25 * np.sin(3 * p[:, 0] + 1) * np.cos(2 * p[:, 1]) + 0.25 * np.sin(2.5 * p[:, 2] + p[:, 0])


def steep(p):
    return np.random.default_rng(4).uniform(0, 1, len(p))


def with_values(data, field, kind="point"):
    attributes = data.GetPointData() if kind == "point" else data.GetCellData()
    count = data.GetNumberOfPoints() if kind == "point" else data.GetNumberOfCells()
    points = meshes.points_of(data) if kind == "point" else np.zeros((count, 3))
    meshes.add_array(attributes, np.asarray(field(points), np.float32))
    return data


def unstructured(data):
    append = vtkAppendFilter()
    append.AddInputData(data)
    append.Update()
    return append.GetOutput()


def rectilinear(blocks=6):
    return meshes.rectilinear([np.sort(np.r_[-0.5, 0.5, np.linspace(-0.5, 0.5, blocks + 1)[1:-1] + 0.03 * np.sin(np.arange(blocks - 1) + k)])
                               for k in range(3)])


def even(blocks=6):
    return meshes.image((blocks,) * 3, (1 / blocks,) * 3, (-0.5,) * 3)


def bent(blocks=6, amount=0.03):
    """Faces are not plane."""
    return meshes.structured(blocks, meshes.wobble(np.random.default_rng(5), amount))


def tapered(blocks=6):
    """Plane faces, edges that are not parallel."""
    return meshes.structured(blocks, meshes.projective(np.random.default_rng(2), 0.2))


def shell(points=(25, 13, 4)):
    """Longitude, latitude, level: closed, with cells that end in the poles."""
    r, lat, lon = np.meshgrid(np.linspace(0.3, 0.5, points[2]), np.radians(np.linspace(-90, 90, points[1])),
                              np.radians(np.linspace(0, 360, points[0])), indexing="ij")
    p = np.stack([r * np.cos(lat) * np.cos(lon), r * np.cos(lat) * np.sin(lon), r * np.sin(lat)], axis=-1)
    p[:, 0, :, :2] = p[:, -1, :, :2] = 0
    p[:, :, -1] = p[:, :, 0]
    return meshes.structured([n - 1 for n in points], lambda _: p.reshape(-1, 3))


def without_jumps(field, points=(25, 13, 4)):
    """One value where points of the shell coincide."""
    def values(p):
        v = field(p).reshape(points[::-1])
        v[:, 0], v[:, -1], v[:, :, -1] = v[:, 0, :1], v[:, -1, :1], v[:, :, 0]
        return v.ravel()
    values.__name__ = field.__name__
    return values


def turned(data, seed=6):
    """The same hexahedra and voxels, each with its vertices in another order: turned in space or mirrored, as hexahedra."""
    rng = np.random.default_rng(seed)
    order = {VTK_HEXAHEDRON: [0, 1, 3, 2, 4, 5, 7, 6], VTK_VOXEL: list(range(8))}
    cells = []
    for i in rng.permutation(data.GetNumberOfCells()):
        cell = data.GetCell(i)
        ids = [cell.GetPointId(k) for k in order[data.GetCellType(i)]]
        axes, ends = rng.permutation(3), rng.integers(0, 2, 3)
        number = [sum((((c >> k & 1) ^ ends[k]) << axes[k]) for k in range(3)) for c in range(8)]
        cells.append((VTK_HEXAHEDRON, [ids[number[c]] for c in order[VTK_HEXAHEDRON]]))
    result = meshes.grid(meshes.points_of(data), cells)
    result.GetPointData().ShallowCopy(data.GetPointData())
    return result


def clip(_scene, made):
    plane, planes = vtkPlane(), vtkPlaneCollection()
    plane.SetOrigin(0.04, 0, 0)
    plane.SetNormal(1, 0.3, 0.2)
    planes.AddItem(plane)
    made.SetClippingPlanes(planes)


class Drawn:
    def __init__(self, data, transfer=RAMP, settings=None, association="point", matrix=None, trilinear=True):
        self.window = Window((SIZE, SIZE))
        self.scene = self.window.add_scene()
        self.mapper = mapper()
        self.mapper.SetMethodToRays()
        self.mapper.SetCellInterpolation(int(trilinear))
        self.volume = self.scene.add_volume(self.mapper, data, transfer, association=association, matrix=matrix)
        if settings:
            settings(self.scene, self.mapper)

    def look(self, view):
        position, focus, scale = view
        away = np.subtract(position, focus)
        up = (0, 1, 0) if abs(away[1]) < 0.9 * np.linalg.norm(away) else (0, 0, 1)
        self.scene.camera.SetParallelProjection(scale is not None)
        self.scene.look(position, focus, up, 30, scale, near=1e-3, far=8)

    def picture(self, view=VIEWS["far"]):
        self.look(view)
        self.window.render()
        return float_image(self.mapper)


PROBED = []  # [data, places, what was found there] of the last call: another array is often asked for at the same places


def probed(data, places, name="s"):
    """By VTK's cells. What is outside the bounds is not looked for, which would take most of the time."""
    if not PROBED or PROBED[0] is not data or PROBED[1] is not places:
        PROBED[:] = [data, places, *probe_of(data, places)]
    near, found = PROBED[2:]
    values, inside = np.zeros(len(places)), np.zeros(len(places), bool)
    values[near] = vtk_to_numpy(found.GetArray(name))
    inside[near] = vtk_to_numpy(found.GetArray("vtkValidPointMask")) > 0
    return values, inside


def probe_of(data, places):
    """(indices of the places within the bounds, arrays there)."""
    low, high = np.array(data.GetBounds()).reshape(3, 2).T
    near = np.flatnonzero(np.all((places >= low) & (places <= high), axis=1))
    points, poly, probe, strategy = vtkPoints(), vtkPolyData(), vtkProbeFilter(), vtkCellLocatorStrategy()
    points.SetData(numpy_to_vtk(places[near], deep=1))
    poly.SetPoints(points)
    strategy.SetCellLocator(vtkStaticCellLocator())
    probe.SetFindCellStrategy(strategy)
    probe.SetInputData(poly)
    probe.SetSourceData(data)
    probe.Update()
    return near, probe.GetOutput().GetPointData()


def crossed(contoured, inside, surfaces):
    """For each surface, (value, opacity, colour): where it lies between two samples of a ray. None where a value is missing."""
    inside = inside & np.isfinite(contoured)
    for value, opacity, rgb in surfaces:
        above = contoured >= value
        between = np.zeros(above.shape, bool)
        between[:, :-1] = (above[:, 1:] != above[:, :-1]) & inside[:, 1:] & inside[:, :-1]
        yield between, opacity, rgb


def way_through(bounds, origins, directions):
    """World lengths along each ray at which it enters the box, or one a little larger, and leaves it. It misses a box that it leaves first."""
    low, high = np.array(bounds).reshape(3, 2).T
    with np.errstate(divide="ignore", invalid="ignore"):
        t = np.stack([low - 1e-6 - origins, high + 1e-6 - origins]) / directions
    return np.nanmax(t.min(axis=0), axis=1), np.nanmin(t.max(axis=0), axis=1)


def dense(data, view, *arguments, **options):
    """(height, width, 4) of `samples_of` rays where they are within the bounds; others see nothing."""
    origins, directions, near, far = view.rays()
    enter, leave = way_through(data.GetBounds(), origins, directions)
    start, end = np.maximum(near, enter), np.minimum(far, leave)
    hit = start < end
    rgba = np.zeros((len(hit), 4))
    rgba[hit] = samples_of(data, [a[hit] for a in (origins, directions, start, end)], *arguments, **options)
    return rgba.reshape(view.height, view.width, 4)


def samples_of(data, rays, transfer, field=None, samples=700, opacity=None, surfaces=(), contoured=None):
    """Samples in the middles of as many parts of each ray, composited, and surfaces between them. opacity, contoured: fields of arrays
    of their own."""
    origins, directions, start, end = rays
    step = (end - start) / samples
    t = start[:, None] + step[:, None] * (np.arange(samples) + 0.5)
    places = (origins[:, None] + t[..., None] * directions[:, None]).reshape(-1, 3)
    values, inside = field(places) if field else probed(data, places)
    seen = opacity(places)[0].reshape(t.shape) if opacity else values.reshape(t.shape)
    values, inside = values.reshape(t.shape), inside.reshape(t.shape)
    depth = np.zeros(t.shape)
    depth[inside] = transfer.extinction(seen[inside])
    depth *= step[:, None]
    found = list(crossed(contoured(places)[0].reshape(t.shape) if contoured else values, inside, surfaces))
    through = np.exp(-depth)
    clear = through.copy()
    for between, a, _ in found:
        clear[between] *= 1 - a
    reached = np.cumprod(np.concatenate([np.ones((len(t), 1)), clear[:, :-1]], axis=1), axis=1)
    weight = reached * -np.expm1(-depth)
    color = np.zeros((*t.shape, 3))
    color[inside] = transfer.color(values[inside])
    rgba = np.concatenate([np.einsum("ij,ijk->ik", weight, color), weight.sum(axis=1)[:, None]], axis=1)
    for between, a, rgb in found:
        rgba += (reached * through * between).sum(axis=1)[:, None] * a * np.append(rgb, 1)
    return rgba


def trilinear_field(data, name="s"):
    """By the formula, for a rectilinear grid."""
    axes = [vtk_to_numpy(getattr(data, f"Get{a}Coordinates")()) for a in "XYZ"]
    values = vtk_to_numpy(data.GetPointData().GetArray(name)).reshape([len(a) for a in axes[::-1]]).astype(float)

    def at(places):
        inside = np.logical_and.reduce([(x >= a[0]) & (x <= a[-1]) for a, x in zip(axes, places.T)])
        index, part = [], []
        for axis, x in zip(axes, places[inside].T):
            i = np.clip(np.searchsorted(axis, x, side="right") - 1, 0, len(axis) - 2)
            index.append(i)
            part.append((x - axis[i]) / (axis[i + 1] - axis[i]))
        found, result = 0, np.zeros(len(places))
        for c in range(8):
            bits = [c >> k & 1 for k in range(3)]
            x, y, z = (p if b else 1 - p for p, b in zip(part, bits))
            found = found + x * y * z * values[index[2] + bits[2], index[1] + bits[1], index[0] + bits[0]]
        result[inside] = found
        return result, inside
    return at


class TrilinearCells(unittest.TestCase):
    def assert_same(self, one, other, label, tolerance=STEP, most=0):
        self.assertGreater(max(one[..., 3].max(), other[..., 3].max()), 0.05, label)
        error = np.abs(one - other).max(axis=-1)
        print(f"  {label}: largest difference {error.max() * 255:.3f}/255, {int((error > tolerance).sum())} pixels beyond", flush=True)
        self.assertLessEqual(int((error > tolerance).sum()), most, f"{label}: {np.argwhere(error > tolerance)[:5].tolist()}")

    def test_smooth_fields_against_dense_samples(self):
        for name, data in (("rectilinear", rectilinear()), ("tapered", tapered()), ("bent", bent())):
            with_values(data, smooth)
            field = trilinear_field(data) if name == "rectilinear" else None
            for view in ("far", "diagonal"):
                expected = None
                for stored in (data, unstructured(data)):
                    drawn = Drawn(stored)
                    image = drawn.picture(VIEWS[view])
                    expected = dense(data, drawn.scene.view(), RAMP, field) if expected is None else expected
                    self.assert_same(image, expected, f"{name} {view} {stored.GetClassName()}", 2 * STEP, BENT if name == "bent" else 0)

    def test_steep_fields_against_dense_samples(self):
        for name, data in (("rectilinear", rectilinear()), ("tapered", tapered())):
            with_values(data, steep)
            drawn = Drawn(unstructured(data), CLEAR_BELOW)
            image = drawn.picture()
            field = trilinear_field(data) if name == "rectilinear" else None
            expected = dense(data, drawn.scene.view(), CLEAR_BELOW, field)
            cut = Drawn(unstructured(data), CLEAR_BELOW, trilinear=False).picture()
            error, before = (np.abs(p - expected).max(axis=-1) for p in (image, cut))
            print(f"  {name}: 99 % {np.percentile(error, 99) * 255:.2f}/255, as tetrahedra {np.percentile(before, 99) * 255:.2f}/255; largest "
                  f"{error.max() * 255:.2f}, {before.max() * 255:.2f}", flush=True)
            self.assertLess(np.percentile(error, 99), np.percentile(before, 99) / 3)
            self.assertLess(error.max(), before.max() / 3)

    def test_optical_depth_of_one_point(self):
        """One wet point: the integral of its hat function, the volume of a cell. As tetrahedra it is 5/3 or 1/3 of that, for a point of the middle ones and for another."""
        expected = {True: {1.0}, False: {1 / 3, 5 / 3}}
        for trilinear, stored in itertools.product((True, False), (lambda data: data, unstructured)):
            found = []
            for wet in (2, 3):
                data = meshes.structured(6, lambda p: p)
                values = np.zeros((7, 7, 7))
                values[3, 3, wet] = 1
                drawn = Drawn(stored(with_values(data, lambda _: values.ravel())), Transfer([(0, 1, 1, 1)], [(0, 0), (1, 1)]), trilinear=trilinear)
                alpha = drawn.picture((VIEWS["far"][0], data.GetCenter(), 0.8))[..., 3].astype(float)
                depth = -np.log1p(-alpha).sum() * (1.6 / SIZE)**2
                found.append(depth / np.prod([(high - low) / 6 for low, high in zip(data.GetBounds()[::2], data.GetBounds()[1::2])]))
            print(f"  trilinear {trilinear}: {found}", flush=True)
            wanted = sorted(expected[trilinear]) if len(expected[trilinear]) == 2 else [1.0, 1.0]
            np.testing.assert_allclose(sorted(found), wanted, rtol=0.02)

    def test_the_same_cells_however_stored(self):
        for name, data in (("even", even()), ("rectilinear", rectilinear()), ("tapered", tapered()), ("bent", bent()), ("shell", shell())):
            for field, transfer in ((smooth, RAMP), (steep, CLEAR_BELOW)):
                with_values(data, without_jumps(field) if name == "shell" else field)
                pair = Drawn(data, transfer), Drawn(unstructured(data), transfer)
                for view in VIEWS:
                    one, other = (drawn.picture(VIEWS[view]) for drawn in pair)
                    self.assert_same(one, other, f"{name} {field.__name__} {view}", most=BENT if name == "bent" else 0)
                self.assertEqual(pair[0].window.messages.all + pair[1].window.messages.all, [])

    def test_the_same_cells_however_stored_as_tetrahedra(self):
        """Hexahedra are divided as those of a grid, in one piece or in blocks that repeat their points."""
        def blocks(data):
            append, i = vtkAppendFilter(), data.GetExtent()[1] // 2
            for low, high in ((0, i), (i, data.GetExtent()[1])):
                block = data.NewInstance()
                block.ShallowCopy(data)
                block.Crop([low, high, *data.GetExtent()[2:]])
                append.AddInputData(block)
            append.Update()
            return append.GetOutput()

        for name, data in (("tapered", tapered()), ("bent", bent(6, 0.01)), ("shell", shell())):
            with_values(data, without_jumps(steep) if name == "shell" else steep)
            one = Drawn(data, CLEAR_BELOW, trilinear=False)
            stored = {"unstructured": unstructured(data), "in another order": turned(unstructured(data)), "blocks": blocks(data)}
            self.assertEqual(stored["blocks"].GetNumberOfCells(), data.GetNumberOfCells())
            for label, cells in stored.items():
                other = Drawn(cells, CLEAR_BELOW, trilinear=False)
                for view in VIEWS:
                    if name == "shell" and view == "in_a_plane":
                        continue  # rays within faces
                    self.assert_same(one.picture(VIEWS[view]), other.picture(VIEWS[view]), f"{name} {label} {view}")

    def test_vertices_in_any_order(self):
        for name, data in (("even", even()), ("bent", bent())):
            data = unstructured(with_values(data, steep))
            pair = Drawn(data, CLEAR_BELOW), Drawn(turned(data), CLEAR_BELOW)
            for view in VIEWS:
                self.assert_same(*(drawn.picture(VIEWS[view]) for drawn in pair), f"{name} {view}", most=BENT if name == "bent" else 0)

    def test_mirrored(self):
        data = with_values(bent(), steep)
        mirror = np.diag([-1.0, 1, 1, 1])
        for stored in (data, unstructured(data)):
            straight = Drawn(stored, CLEAR_BELOW).picture(((0, 0.4, 2.5), (0, 0, 0), None))
            mirrored = Drawn(stored, CLEAR_BELOW, matrix=mirror).picture(((0, 0.4, 2.5), (0, 0, 0), None))
            self.assert_same(straight[:, ::-1], mirrored, stored.GetClassName())

    def test_linear_fields_of_all_kinds_are_exact(self):
        tetrahedra = meshes.Lattice(3).mesh("tetra", lambda p: p - 0.5)
        field = lambda p: 0.5 + p @ np.array([0.3, -0.25, 0.4])
        cells, expected = polyhedra.from_dataset(with_values(tetrahedra, field)), {}
        for kind in ("hexahedron", "voxel", "wedge", "pyramid", "mixed"):
            data = with_values(meshes.Lattice(3).mesh(kind, lambda p: p - 0.5), field)
            drawn = Drawn(data)
            for view in VIEWS:
                image = drawn.picture(VIEWS[view])
                if view not in expected:
                    expected[view] = reference.render(cells, drawn.scene.view(), RAMP)
                tolerance = 1e-4 if view in ("far", "other", "inside") else STEP
                self.assert_same(image, expected[view], f"{kind} {view}", tolerance)

    def test_cells_of_all_kinds_against_dense_samples(self):
        for kind in ("wedge", "pyramid", "mixed"):
            data = with_values(meshes.Lattice(4).mesh(kind, meshes.projective(np.random.default_rng(2), 0.2)), smooth)
            drawn = Drawn(data)
            image = drawn.picture()
            self.assert_same(image, dense(data, drawn.scene.view(), RAMP), kind, 2 * STEP)

    def test_cell_values(self):
        data = with_values(tapered(), steep, "cell")
        for view in ("far", "inside", "along_z"):
            one, other = (Drawn(d, CLEAR_BELOW, association="cell").picture(VIEWS[view]) for d in (data, unstructured(data)))
            cut = Drawn(unstructured(data), CLEAR_BELOW, association="cell", trilinear=False).picture(VIEWS[view])
            self.assert_same(one, other, f"stored {view}")
            self.assert_same(other, cut, f"as tetrahedra {view}")

    def test_an_opacity_array(self):
        """Colour and opacity from two arrays on points, one of them steep."""
        opacity = lambda _, made: made.SetOpacityArrayName("o")
        for name, data in (("rectilinear", rectilinear()), ("tapered", tapered())):
            with_values(data, smooth)
            meshes.add_array(data.GetPointData(), steep(meshes.points_of(data)).astype(np.float32), "o")
            field, of_opacity = ((trilinear_field(data, a) if name == "rectilinear" else lambda p, a=a: probed(data, p, a)) for a in "so")
            expected = None
            for stored in (data, unstructured(data)):
                drawn = Drawn(stored, CLEAR_BELOW, opacity)
                image = drawn.picture()
                expected = dense(data, drawn.scene.view(), CLEAR_BELOW, field, opacity=of_opacity) if expected is None else expected
                self.assert_same(image, expected, f"{name} {stored.GetClassName()}", 2 * STEP)
                self.assertEqual(drawn.window.messages.all, [])
            cut = np.abs(Drawn(unstructured(data), CLEAR_BELOW, opacity, trilinear=False).picture() - expected).max()
            print(f"  as tetrahedra {cut * 255:.1f}/255", flush=True)
            self.assertGreater(cut, 5 * STEP)

    def test_an_opacity_array_however_stored(self):
        opacity = lambda _, made: made.SetOpacityArrayName("o")
        for name, data in (("tapered", tapered()), ("bent", bent())):
            for colors, opacities in (("point", "point"), ("point", "cell"), ("cell", "point"), ("cell", "cell")):
                whole = data.NewInstance()
                whole.CopyStructure(data)
                with_values(whole, smooth if colors == "point" else steep, colors)
                attributes = whole.GetPointData() if opacities == "point" else whole.GetCellData()
                count = whole.GetNumberOfPoints() if opacities == "point" else whole.GetNumberOfCells()
                meshes.add_array(attributes, np.random.default_rng(8).uniform(0, 1, count).astype(np.float32), "o")
                pair = [Drawn(d, CLEAR_BELOW, opacity, association=colors) for d in (whole, unstructured(whole))]
                for view in ("far", "inside", "on_a_point"):
                    self.assert_same(*(drawn.picture(VIEWS[view]) for drawn in pair), f"{name} {colors} {opacities} {view}",
                                     most=BENT if name == "bent" else 0)
                if (name, colors, opacities) == ("tapered", "cell", "cell"):
                    cut = Drawn(unstructured(whole), CLEAR_BELOW, opacity, association=colors, trilinear=False).picture()
                    self.assert_same(pair[1].picture(), cut, f"{name} as tetrahedra")

    def test_hidden_cells_and_missing_values(self):
        data = with_values(tapered(), steep)
        meshes.add_array(data.GetCellData(), np.where(np.arange(data.GetNumberOfCells()) % 5 == 0, vtkDataSetAttributes.HIDDENCELL, 0).astype(np.uint8),
                         vtkDataSetAttributes.GhostArrayName())
        self.compare_storage(data, "hidden", warns=False)
        holes = with_values(tapered(), lambda p: np.where(np.arange(len(p)) % 40 == 7, np.nan, steep(p)))
        self.compare_storage(holes, "missing", warns=True)

    def compare_storage(self, data, label, warns):
        pair = Drawn(data, CLEAR_BELOW), Drawn(unstructured(data), CLEAR_BELOW)
        for view in ("far", "along_x", "other"):
            self.assert_same(*(drawn.picture(VIEWS[view]) for drawn in pair), f"{label} {view}")
        self.assertEqual(pair[1].window.messages.all != [], warns)

    def test_clipped_and_before_a_surface(self):
        def wall(scene, _made):
            source = vtkPlaneSource()
            source.SetOrigin(-1, -1, -0.1)
            source.SetPoint1(1, -1, 0.1)
            source.SetPoint2(-1, 1, 0)
            source.Update()
            scene.add_opaque(source.GetOutput(), (0, 0, 0))

        data = with_values(tapered(), smooth)
        for label, settings in (("clipped", clip), ("wall", wall)):
            cut, one, other = (Drawn(d, settings=settings, trilinear=t).picture() for d, t in ((data, False), (data, True), (unstructured(data), True)))
            self.assert_same(one, other, label)
            self.assert_same(one, cut, label + " as tetrahedra", 4 * STEP)  # of a smooth field

    def test_what_needs_tetrahedra_is_drawn_as_these(self):
        """Layers between contours."""
        data = unstructured(with_values(tapered(), steep))
        denser = vtkVolumeProperty()
        denser.DeepCopy(Drawn(data, CLEAR_BELOW).volume.GetProperty())
        denser.SetScalarOpacityUnitDistance(0.5 * denser.GetScalarOpacityUnitDistance())

        def contours(_scene, made):
            made.SetLayersFromContours(True)
            made.SetLayerProperty(1, denser)
            made.SetContourValue(0, 0.6)

        one, other = (Drawn(data, CLEAR_BELOW, contours, trilinear=t).picture() for t in (True, False))
        self.assert_same(one, other, "contours", 0)
        drawn = Drawn(data, CLEAR_BELOW)
        plain = drawn.picture()
        contours(None, drawn.mapper)
        self.assert_same(drawn.picture(), one, "contours added", 0)
        drawn.mapper.SetNumberOfContourValues(0)
        drawn.mapper.SetLayersFromContours(False)
        drawn.mapper.SetLayerProperty(1, None)
        self.assert_same(drawn.picture(), plain, "and taken away", 0)

    def test_blocks_hold_together(self):
        """Two halves with points of their own, the values of which jump or not."""
        whole = with_values(even(), steep)
        halves = []
        for low, high in ((0, 3), (3, 6)):
            half = meshes.image((high - low, 6, 6), (1 / 6,) * 3, (-0.5 + low / 6, -0.5, -0.5))
            values = vtk_to_numpy(whole.GetPointData().GetArray("s")).reshape(7, 7, 7)[:, :, low:high + 1]
            meshes.add_array(half.GetPointData(), values.ravel().copy())
            halves.append(half)
        append = vtkAppendFilter()
        for half in halves:
            append.AddInputData(half)
        append.Update()
        pair = Drawn(whole, CLEAR_BELOW), Drawn(append.GetOutput(), CLEAR_BELOW)
        for view in VIEWS:
            self.assert_same(*(drawn.picture(VIEWS[view]) for drawn in pair), view)
        self.assertLessEqual(pair[1].mapper.GetNumberOfRayLayers(), 1)

    def test_values_of_another_time(self):
        data = unstructured(with_values(tapered(), steep))
        drawn = Drawn(data, CLEAR_BELOW)
        drawn.picture()
        data.GetPointData().RemoveArray("s")
        with_values(data, smooth)
        data.Modified()
        self.assert_same(drawn.picture(), Drawn(data, CLEAR_BELOW).picture(), "new values", 0)


if __name__ == "__main__":
    unittest.main()
