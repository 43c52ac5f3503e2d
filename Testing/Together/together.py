# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Everything that can be in one view, each with what it is along a ray: surfaces at a place, and media with an extinction at every place.

Places are z, rays go along -z. An element is centred at z = 0; `at` moves it. `light_of` composites any of them by the sum of their
extinctions, in fine steps, with surfaces in between: a reference that knows nothing of how each of them is drawn.
"""
import nephoscope
import numpy as np
from nephoscope_testing import meshes, splats
from nephoscope_testing.checks import mapper as cell_mapper
from nephoscope_testing.offscreen import Window, float_image
from nephoscope_testing.transfer import Transfer, constant
from vtkmodules.vtkRenderingCore import vtkActor, vtkBillboardTextActor3D

SIZE = (20, 20)
EYE, REACH, STEPS = 12.0, 6.0, 960  # rays are integrated from z = REACH to -REACH
EDGES = np.linspace(REACH, -REACH, STEPS + 1)
MIDDLES = 0.5 * (EDGES[1:] + EDGES[:-1])
BACKGROUND = (0.25, 0.1, 0.05)


WINDOW = Window(SIZE)  # one for all, which keeps the shaders


class Element:
    """A kind of thing; `add` puts it into a scene."""
    is_surface = False
    color = (1, 1, 1)

    def __init__(self, at=0.0):
        self.at = at

    def depths(self, _view):
        """Optical depth in each step, of one ray or of all: (1 or rays, STEPS)."""
        return np.zeros((1, STEPS))

    def colors(self):
        return np.broadcast_to(np.array(self.color, float), (STEPS, 3))

    def sheet(self, _view):
        """None, or (z, colour, opacity), these of one ray or of all."""
        return None


class Surface(Element):
    is_surface = True
    color, opacity = (0.1, 0.8, 0.2), 0.5

    def polygons(self):
        return meshes.surface(np.array([(-4, -4, self.at), (4, -4, self.at), (4, 4, self.at), (-4, 4, self.at)], float), [(0, 1, 2), (0, 2, 3)])

    def add(self, scene):
        self.actor = scene.add_opaque(self.polygons(), self.color)
        self.actor.GetProperty().SetOpacity(self.opacity)

    def sheet(self, view):
        return self.at, np.array(self.color, float), self.opacity


class Terrain(Surface):
    color, opacity = (0.5, 0.35, 0.2), 1.0


class CloudTops(Surface):
    color, opacity = (0.9, 0.9, 1.0), 1 - np.exp(-0.9)

    def add(self, scene):
        mapper = nephoscope.vtkCloudTextureMapper()
        mapper.SetInputDataObject(self.polygons())
        mapper.ScalarVisibilityOff()
        mapper.SetCoverage(1)
        mapper.SetOpticalDepth(0.9)
        mapper.SetRelief(0)
        mapper.SetThinColor(1, 1, 1)
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(*self.color)
        actor.GetProperty().LightingOff()
        scene.renderer.AddActor(actor)


class Label(Element):
    """A text at a place in space, as labels are. What it is along rays is seen from it alone."""
    is_surface = True

    def add(self, scene):
        text = vtkBillboardTextActor3D()
        text.SetInput("WWW")
        text.SetPosition(-0.8, -0.2, self.at)
        text.GetTextProperty().SetFontSize(16)
        text.GetTextProperty().SetColor(1, 1, 0)
        scene.renderer.AddActor(text)

    def sheet(self, view):
        black, white = (picture([Label(self.at)], background=(b, b, b)).image.reshape(-1, 3) for b in (0, 1))
        opacity = 1 - (white - black).mean(axis=1, keepdims=True)
        return self.at, np.divide(black, opacity, out=np.zeros_like(black), where=opacity > 0), opacity


def text_is_translucent():
    """Whether this release of VTK draws texts among translucent surfaces; it knows when it has drawn one."""
    scene = picture([Label(0)])
    return any(prop.HasTranslucentPolygonalGeometry() for prop in scene.renderer.GetViewProps())


class Slab(Element):
    """Cells from -0.5 to 0.5."""
    extinction = 0.9

    def depths(self, view):
        low, high = self.at - 0.5, self.at + 0.5
        inside = np.minimum(EDGES[:-1], high) - np.maximum(EDGES[1:], low)
        return self.extinction * np.maximum(inside, 0)[None]

    def add(self, scene):
        self.mapper = cell_mapper()
        self.configure(self.mapper)
        scene.add_volume(self.mapper, meshes.with_field(self.cells(), lambda p: p[:, 2] - self.at + 0.5), self.transfer())


class Smoke(Slab):
    """Tetrahedra of one colour, which are projected."""
    color = (0.9, 0.3, 0.1)

    def configure(self, mapper):
        pass

    def transfer(self):
        return constant(self.extinction, self.color)

    def cells(self):
        data = meshes.Lattice(2).mesh("tetra")
        data.SetPoints(meshes.vtk_points((meshes.points_of(data) - 0.5) * (8, 8, 1) + (0, 0, self.at)))
        return data


class Clouds(Slab):
    """An image of two colours, by rays."""
    bottom, top = np.array((0.2, 0.3, 0.9)), np.array((1.0, 1.0, 0.9))

    def configure(self, mapper):
        pass

    def transfer(self):
        return Transfer([(0, *self.bottom), (1, *self.top)], [(0, self.extinction), (1, self.extinction)])

    def cells(self):
        return meshes.image((2, 2, 4), (4, 4, 0.25), (-4, -4, self.at - 0.5))

    def colors(self):
        share = np.clip(MIDDLES - self.at + 0.5, 0, 1)[:, None]
        return self.bottom + share * (self.top - self.bottom)


class Contours(Clouds):
    """The same with a translucent surface in it."""
    place, surface_color, surface_opacity = 0.1, np.array((0.9, 0.1, 0.7)), 0.4

    def configure(self, mapper):
        mapper.SetContourValue(0, self.place + 0.5)
        mapper.SetContourColor(0, *self.surface_color)
        mapper.SetContourOpacity(0, self.surface_opacity)
        mapper.ContourLightingOff()

    def sheet(self, view):
        return self.at + self.place, self.surface_color, self.surface_opacity


class Splats(Element):
    color = (0.3, 0.9, 0.9)
    extinction, counts, spacing = 0.8, (5, 5, 2), (1.5, 1.5, 0.4)

    def data(self):
        low = [-0.5 * (n - 1) * s for n, s in zip(self.counts, self.spacing)]
        low[2] += self.at
        return meshes.with_field(meshes.image([n - 1 for n in self.counts], self.spacing, low), lambda p: 0 * p[:, 0])

    def add(self, scene):
        self.mapper = nephoscope.vtkTexturedSplatMapper()
        scene.add_volume(self.mapper, self.data(), constant(self.extinction, self.color))

    def depths(self, view):
        origins, *_ = view.rays()
        total = np.zeros((len(origins), STEPS))
        for (x, y, z), share in zip(meshes.points_of(self.data()), splats.lattice_shares(self.counts)):
            across = ((origins[:, 0] - x) / self.spacing[0]) ** 2 + ((origins[:, 1] - y) / self.spacing[1]) ** 2
            near, some = np.flatnonzero(across < splats.OUTER ** 2), np.flatnonzero(np.abs(MIDDLES - z) < splats.OUTER * self.spacing[2])
            r = np.sqrt(across[near, None] + ((MIDDLES[some] - z) / self.spacing[2])[None] ** 2)
            total[near[:, None], some] += share * splats.cubic(r)
        return self.extinction * total * (EDGES[0] - EDGES[1])


class Winds(Splats):
    """Streaks alone. Their optical depth along rays is seen from them alone; it is spread as their kernels are."""
    color = (1.0, 0.8, 0.1)
    counts, spacing = (6, 6, 1), (0.9, 0.9, 0.9)
    alone = {}  # optical depths of those at a place

    def data(self):
        data = super().data()
        meshes.add_array(data.GetPointData(), np.tile((1.0, 0.4, 0), (data.GetNumberOfPoints(), 1)), "v")
        return data

    def add(self, scene):
        self.mapper = nephoscope.vtkTexturedSplatMapper()
        self.mapper.SetVectorArrayName("v")
        self.mapper.UseVectorColorOn()
        self.mapper.SetVectorColor(*self.color)
        self.mapper.SetVectorOpacity(0.8)
        scene.add_volume(self.mapper, self.data(), constant(0, self.color))

    def depths(self, view):
        if self.at not in self.alone:
            picture([self])
            self.alone[self.at] = -np.log1p(-np.minimum(float_image(self.mapper)[..., 3].reshape(-1, 1), 0.999))
        profile = splats.cubic(np.abs(MIDDLES - self.at) / self.spacing[2])
        return self.alone[self.at] * (profile / profile.sum())


def picture(elements, peels=False, background=BACKGROUND, haze=None, renders=1):
    """The scene as drawn, from elements in the order in which they are added."""
    WINDOW.window.GetRenderers().RemoveAllItems()
    WINDOW.messages.clear()
    scene = WINDOW.add_scene(background=background)
    renderer = scene.renderer
    renderer.SetUseDepthPeeling(peels)
    renderer.SetUseDepthPeelingForVolumes(peels)
    renderer.SetMaximumNumberOfPeels(20)
    renderer.SetOcclusionRatio(0)
    for element in elements:
        element.add(scene)
    if haze:
        air = haze.make(nephoscope.vtkHaze)
        air.BackgroundOff()
        nephoscope.vtkHaze.SetHaze(renderer, air)
    scene.look((0, 0, EYE), parallel_scale=1, near=1, far=EYE + REACH + 4)
    for _ in range(renders):
        WINDOW.render()
    scene.image, scene.messages = scene.rgb(), list(WINDOW.messages.all)
    return scene


def light_of(elements, view, background=BACKGROUND, haze=None):
    """The reference: (height, width, 3)."""
    rays = view.width * view.height
    media = [(element.depths(view), element.colors()) for element in elements]
    steps = np.flatnonzero(np.any([own.any(axis=0) for own, _ in media], axis=0))  # those with a medium: in others no light changes
    depth, emission = np.zeros((rays, len(steps))), np.zeros((rays, len(steps), 3))
    for own, colors in media:
        depth += own[:, steps]
        emission += own[:, steps, None] * colors[steps]
    share = np.where(depth > 1e-12, -np.expm1(-depth) / np.maximum(depth, 1e-12), 1.0)
    opacity = -np.expm1(-depth)
    air = np.ones(STEPS + 1) if not haze else np.exp(-haze.extinction * (EYE - EDGES))
    middle = np.sqrt(air[1:] * air[:-1])[steps][None, :, None]
    light = share[..., None] * emission * middle
    if haze:
        light += (opacity[..., None] * (1 - middle)) * np.asarray(haze.color)
    clear = np.concatenate([np.ones((rays, 1)), np.cumprod(1 - opacity, axis=1)], axis=1)
    sheets = sorted((s for s in (e.sheet(view) for e in elements) if s), key=lambda s: -s[0])
    total, passed, begin = np.zeros((rays, 3)), np.ones((rays, 1)), 0
    for z, color, alpha in sheets + [(EDGES[-1], None, None)]:
        edge = int(np.argmin(np.abs(EDGES - z)))
        end = int(np.searchsorted(steps, edge))
        total += np.einsum("ij,ijk->ik", passed * clear[:, begin:end], light[:, begin:end]) / clear[:, begin:begin + 1]
        passed = passed * (clear[:, end] / clear[:, begin])[:, None]
        if color is not None:
            t = air[edge]
            seen = color * t + (1 - t) * np.asarray(haze.color) if haze else color
            total, passed = total + passed * alpha * seen, passed * (1 - alpha)
        begin = end
    return (total + passed * np.asarray(background)).reshape(view.height, view.width, 3)
