# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Splats as they were drawn before, against closed forms: error, processor time and a picture of each.

    ./nephoscope python Testing/Benchmarks/earlier_splats.py [--plot Documentation/images/earlier-splats.png]

A smooth cloud on a lattice, colours and extinction by its value, in a parallel view. Three pictures to compare with: quadrature of the field itself along
every ray; the same splats evaluated by numpy, whose footprint is integrated numerically; and, for ripple, a constant. Splats of
one size that face the eye are textured rectangles (a stored map of 64 x 64 footprints of 8 bits) and polygon nets (piecewise linear), drawn by
VTK from back to front into 8 bits. Milliseconds are processor time of a moving frame, with order, and for these two with what numpy takes to put them together.
"""
import argparse
import time

import nephoscope
import numpy as np
from nephoscope_testing import meshes, splats
from nephoscope_testing.offscreen import Window, float_image
from nephoscope_testing.transfer import Transfer
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkTexture

SIDE, PIXELS, EXTINCTION = 24, 256, 5.0
STEP = 2 / (SIDE - 1)
DIRECTION = np.array([0.3, 0.25, 0.92])
LOOK = Transfer([(0, 0.2, 0.35, 1), (1, 1, 0.75, 0.3)], [(0, 0), (1, EXTINCTION)])
RADII, SECTORS, MAP = (0.0, 0.55, 1.35), 8, 64  # of a polygon net, in cells; texels along a side of the stored map
FRAMES = 5


def field(points):
    far = ((points - (0.25, 0.1, 0)) ** 2).sum(axis=-1)
    near = ((points - (-0.35, -0.2, 0.3)) ** 2).sum(axis=-1)
    return 0.9 * np.exp(-5 * far) + 0.6 * np.exp(-12 * near)


def lattice(values=field):
    data = meshes.image((SIDE - 1,) * 3, (STEP,) * 3, (-1, -1, -1))
    return meshes.with_field(data, values)


def footprint(rho, kernel=splats.cubic, radius=splats.OUTER):
    """Integral of the kernel along a line at a distance of the centre, in cells."""
    x, w = np.polynomial.legendre.leggauss(200)
    half = np.sqrt(np.maximum(radius**2 - rho**2, 0))
    z = half[..., None] * x
    return half * (kernel(np.sqrt(rho[..., None] ** 2 + z**2)) @ w)


TABLE = np.linspace(0, splats.OUTER, 400)
FOOTPRINTS = footprint(TABLE)


class Scene:
    def __init__(self):
        self.window = Window((PIXELS, PIXELS))
        self.scene = self.window.add_scene()
        self.turn(0)

    def turn(self, angle):
        turned = DIRECTION + angle * np.array([1, 0, 0])
        self.scene.look(10 * turned / np.linalg.norm(turned), parallel_scale=1.2, near=5, far=15)

    def picture(self):
        self.window.render()
        return self.window.rgba()[..., :3]

    def milliseconds(self, prepare=lambda: None):
        self.picture()
        taken = []
        for i in range(FRAMES):
            self.turn(0.01 * (i + 1))
            start = time.process_time()
            prepare()
            self.window.render()
            self.window.window.GetRGBACharPixelData(0, 0, 0, 0, 0)  # until it is drawn
            taken.append(time.process_time() - start)
        return 1e3 * min(taken)


def by_mapper(configure, data=None, look=LOOK):
    made, mapper = Scene(), nephoscope.vtkTexturedSplatMapper()
    configure(mapper)
    made.scene.add_volume(mapper, data or lattice(), look)
    return made, mapper


def ripple(configure):
    """Deviation of a constant's optical depth, seen along an axis of the lattice, in percent of its mean: root mean square, greatest."""
    made, mapper = by_mapper(configure, lattice(lambda points: np.ones(len(points))), Transfer([(0, 1, 1, 1), (1, 1, 1, 1)], [(0, 0.5), (1, 0.5)]))
    made.scene.look((0, 0, 10), parallel_scale=1.2, near=5, far=15)
    made.picture()
    middle = slice(3 * PIXELS // 8, 5 * PIXELS // 8)
    depth = -np.log1p(-float_image(mapper)[middle, middle, 3])
    deviation = 100 * (depth / depth.mean() - 1)
    return deviation.std(), np.abs(deviation).max()


def sorted_splats(view):
    """Places, colours and extinctions of what is not transparent, from back to front."""
    points = meshes.points_of(lattice())
    values = field(points)
    order = np.argsort(-(points @ view.forward), kind="stable")
    order = order[values[order] > 0.002]
    shares = splats.lattice_shares((SIDE,) * 3)  # of points on the boundary
    return points[order], LOOK.color(values[order]), (LOOK.extinction(values) * shares)[order]


def software(view):
    """The same splats, one by one."""
    image = np.zeros((PIXELS, PIXELS, 3))
    scale = PIXELS / (2 * view.half[0])
    for place, color, extinction in zip(*sorted_splats(view)):
        x, y = ((place - view.eye) @ axis * scale + PIXELS / 2 - 0.5 for axis in (view.right, view.up))
        reach = splats.OUTER * STEP * scale
        rows, columns = (slice(max(0, int(np.ceil(c - reach))), min(PIXELS, int(np.floor(c + reach)) + 1)) for c in (y, x))
        v, u = np.mgrid[rows, columns]
        rho = np.hypot(u - x, v - y) / (scale * STEP)
        alpha = -np.expm1(-extinction * STEP * np.interp(rho, TABLE, FOOTPRINTS, right=0))[..., None]
        image[rows, columns] = alpha * color + (1 - alpha) * image[rows, columns]
    return image


def quadrature(view, steps=500):
    """The field itself, from front to back."""
    origins, directions, _, _ = view.rays()
    light, through = np.zeros((len(origins), 3)), np.ones(len(origins))
    for t in np.linspace(8.2, 11.8, steps):
        points = origins + t * directions
        values = np.where((np.abs(points) < 1 + STEP / 2).all(axis=1), field(points), 0)
        alpha = -np.expm1(-LOOK.extinction(values) * 3.6 / (steps - 1))
        light += (through * alpha)[:, None] * LOOK.color(values)
        through *= 1 - alpha
    return light.reshape(PIXELS, PIXELS, 3)


def polygons(corners, places, cells, alphas, colors, view):
    """One polygon data set of a pattern of corners (cells) around every place, with an opacity for each corner."""
    count, size = len(places), len(corners)
    offsets = STEP * (corners[:, :1] * view.right + corners[:, 1:] * view.up)
    points = (places[:, None] + offsets).reshape(-1, 3)
    rgba = np.empty((count, size, 4), np.uint8)
    rgba[..., :3] = np.rint(255 * colors)[:, None]
    rgba[..., 3] = np.rint(255 * alphas)
    faces = (np.arange(count)[:, None, None] * size + cells).reshape(-1, cells.shape[1])
    data, holder, array = vtkPolyData(), vtkPoints(), vtkCellArray()
    holder.SetData(numpy_to_vtk(np.ascontiguousarray(points, np.float32), deep=1))
    array.SetData(cells.shape[1], numpy_to_vtkIdTypeArray(np.ascontiguousarray(faces.ravel(), np.int64), deep=1))
    data.SetPoints(holder)
    data.SetPolys(array)
    data.GetPointData().SetScalars(numpy_to_vtk(rgba.reshape(-1, 4), deep=1))
    return data


def rectangle(view):
    corners = splats.OUTER * np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]], float)
    places, colors, extinctions = sorted_splats(view)
    peak = -np.expm1(-extinctions * STEP * FOOTPRINTS[0])
    data = polygons(corners, places, np.arange(4)[None], np.repeat(peak[:, None], 4, axis=1), colors, view)
    at = np.tile(np.array([[0, 0], [1, 0], [1, 1], [0, 1]], np.float32), (len(places), 1))
    data.GetPointData().SetTCoords(numpy_to_vtk(at, deep=1))
    return data


def net(view):
    angles = 2 * np.pi * np.arange(SECTORS) / SECTORS
    rings = [np.zeros((1, 2))] + [r * np.column_stack((np.cos(angles), np.sin(angles))) for r in RADII[1:]]
    corners = np.concatenate(rings)
    k, after = np.arange(SECTORS), (np.arange(SECTORS) + 1) % SECTORS
    cells = [np.column_stack((0 * k, 1 + k, 1 + after))]
    for ring in range(1, len(RADII) - 1):
        inner, outer = 1 + (ring - 1) * SECTORS, 1 + ring * SECTORS
        cells += [np.column_stack((inner + k, outer + k, outer + after)), np.column_stack((inner + k, outer + after, inner + after))]
    places, colors, extinctions = sorted_splats(view)
    values = np.interp(np.hypot(*corners.T), TABLE, FOOTPRINTS)
    values[-SECTORS:] = 0  # the border
    alphas = -np.expm1(-extinctions[:, None] * STEP * values)
    return polygons(corners, places, np.concatenate(cells), alphas, colors, view)


def stored_map():
    axis = (np.arange(MAP) + 0.5) / MAP * 2 - 1
    u, v = np.meshgrid(axis, axis)
    values = np.interp(splats.OUTER * np.hypot(u, v), TABLE, FOOTPRINTS, right=0) / FOOTPRINTS[0]
    texels = np.full((MAP * MAP, 4), 255, np.uint8)
    texels[:, 3] = np.rint(255 * values.ravel())
    image, texture = vtkImageData(), vtkTexture()
    image.SetDimensions(MAP, MAP, 1)
    image.GetPointData().SetScalars(numpy_to_vtk(texels, deep=1))
    texture.SetInputData(image)
    texture.InterpolateOn()
    texture.RepeatOff()
    return texture


def by_polygons(make, texture=None):
    made, mapper, actor = Scene(), vtkPolyDataMapper(), vtkActor()
    mapper.SetColorModeToDirectScalars()
    actor.SetMapper(mapper)
    actor.SetTexture(texture)
    actor.GetProperty().LightingOff()
    actor.ForceOpaqueOn()  # drawn as they come, from back to front; VTK blends them all the same
    made.scene.renderer.AddActor(actor)

    def prepare():
        mapper.SetInputData(make(made.scene.view()))
    prepare()
    return made, prepare, mapper


def rms(image, other):
    return np.sqrt(((image - other) ** 2).mean())


def kernel(number):
    return lambda mapper: mapper.SetKernel(number)


def octree(mapper):
    """Eight cells are one where none differs from their average by more than the tolerance: Laur and Hanrahan (1991)."""
    mapper.SetErrorMeasureToGreatest()
    mapper.SetErrorToleranceUnitToData()
    mapper.SetErrorTolerance(0.1 * EXTINCTION)
    mapper.SetLevelBlending(0)


def ways():
    """Name, picture, milliseconds, number of what is drawn, ripple."""
    for name, configure in (("cubic", kernel(0)), ("gaussian (Westover)", kernel(2)), ("quadratic (2-D)", kernel(1)), ("octree", octree)):
        made, mapper = by_mapper(configure)
        picture = made.picture()
        drawn = mapper.GetNumberOfDrawnSplats()
        yield name, picture, made.milliseconds(), "%d splats" % drawn, "%.2f / %.2f" % ripple(configure) if name != "octree" else ""
    for name, make, texture in (("stored map", rectangle, stored_map()), ("polygon net", net, None)):
        made, prepare, mapper = by_polygons(make, texture)
        picture = made.picture()
        yield name, picture, made.milliseconds(prepare), "%d polygons" % mapper.GetInput().GetNumberOfCells(), ""


def translations(steps=16, phases=24):
    """Root mean square and greatest difference of streaks that step through stored patterns from those that move continuously."""
    data = lattice(lambda points: np.zeros(len(points)))
    meshes.add_array(data.GetPointData(), np.tile((1.0, 0.5, 0.0), (SIDE**3, 1)), "v")
    made, mapper = by_mapper(lambda m: (m.SetVectorArrayName("v"), m.SetVectorFraction(0.2)), data)
    found = []
    for phase in np.arange(phases) / phases:
        mapper.SetPhase(phase)
        pictures = []
        for stored in (0, steps):
            mapper.SetPhaseSteps(stored)
            pictures.append(made.picture())
        found.append((rms(*pictures), np.abs(pictures[0] - pictures[1]).max()))
    return np.max(found, axis=0)


def write_sheet(path, rows):
    """Rows of pictures (y, x, 3), 0 to 1."""
    sheet = np.concatenate([np.concatenate(row, axis=1) for row in rows[::-1]])
    image, writer = vtkImageData(), vtkPNGWriter()
    image.SetDimensions(sheet.shape[1], sheet.shape[0], 1)
    image.GetPointData().SetScalars(numpy_to_vtk(np.rint(255 * np.clip(sheet, 0, 1)).astype(np.uint8).reshape(-1, 3), deep=1))
    writer.SetFileName(path)
    writer.SetInputData(image)
    writer.Write()
    print("wrote", path)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--plot", metavar="FILE.png", help="pictures of all ways, and eight times what they differ from numpy's splats")
    wanted, _ = parser.parse_known_args()
    view = Scene().scene.view()
    reference, truth = software(view), quadrature(view)
    print("| way | drawn | rms error, against the splats by numpy | greatest | rms error, against the field | ripple of a constant, rms / greatest, % | ms |")
    print("|---|---|---|---|---|---|---|")
    print("| numpy | | | | %.4f | | |" % rms(reference, truth))
    pictures, differences = [reference], [np.zeros_like(reference)]
    for name, picture, milliseconds, drawn, ripples in ways():
        print("| %s | %s | %.4f | %.3f | %.4f | %s | %.0f |" % (
            name, drawn, rms(picture, reference), np.abs(picture - reference).max(), rms(picture, truth), ripples, milliseconds))
        pictures.append(picture)
        differences.append(8 * np.abs(picture - reference))
    print("\nSixteen stored translations of streaks, against any phase: rms %.4f, greatest %.2f" % tuple(translations()))
    if wanted.plot:
        write_sheet(wanted.plot, [pictures, differences])


if __name__ == "__main__":
    main()
