# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Cloud Texture: offered for surfaces, defaults and help, the cover that is asked for, texture that moves with the time, blocks."""
import math
import os

import nephoscope
import numpy as np
from CloudTextureScenes import CLOUDS, moving_clouds, sheet, sheet_view
from PluginDefinitions import compare_default, definition, nested, own_properties
from PluginTesting import (OUTPUT, SIZE, check, check_same, color_and_alpha, compose, image, inside_mean_alpha, listen, load_plugin, look,
                           new_view, passed, pvs, solid)

NOT_OF_THE_MAPPER = {"Input", "CustomWaves", "SurfaceData"}
IN_CUSTOM_WAVES = {"CustomWave", "NumberOfCustomWaves"}
INPUTS = {"DensityVolume"}
OF_RANKS = {"Region"}  # set by the representation


def check_definition():
    """Every setting of the mapper is a property, with its default and help, in a group."""
    properties = own_properties(definition("representations", "CloudTextureRepresentation"))
    mapper = nephoscope.vtkCloudTextureMapper()
    settable = {n[3:] for n in dir(mapper) if n.startswith("Get") and hasattr(mapper, "Set" + n[3:])}
    inherited = {n[3:] for n in dir(nephoscope.vtkCloudTextureMapper.__bases__[0]) if n.startswith("Get")}
    expected = settable - inherited - IN_CUSTOM_WAVES - INPUTS - OF_RANKS
    check(expected == set(properties) - NOT_OF_THE_MAPPER, f"C++ and XML differ in {sorted(expected ^ set(properties))}")
    for name in expected:
        compare_default("Cloud Texture", name, properties[name], getattr(mapper, "Get" + name)())
        check(nested(properties[name], "Documentation"), f"Cloud Texture.{name} has no help")
    display = pvs.GetRepresentation(pvs.Sphere(), new_view())
    for name in expected | INPUTS:
        check(display.GetProperty("CloudTexture" + name) is not None, f"{name} is not offered on the display")


def check_offered():
    view = new_view()
    flat, deep = [0, 8, 0, 8, 0, 0], [0, 8, 0, 8, 0, 8]
    for kind, source, expected in (
            ("surface", pvs.Sphere(), True), ("blocks", pvs.GroupDatasets(Input=[pvs.Sphere(), pvs.Cone()]), True),
            ("a flat image", pvs.Wavelet(WholeExtent=flat), True), ("a flat grid", pvs.Transform(Input=pvs.Wavelet(WholeExtent=flat)), True),
            ("an image", pvs.Wavelet(WholeExtent=deep), False), ("a grid", pvs.Transform(Input=pvs.Wavelet(WholeExtent=deep)), False),
            ("tetrahedra", pvs.Tetrahedralize(Input=pvs.Wavelet(WholeExtent=deep)), True)):
        offered = pvs.Show(source, view).GetProperty("Representation").GetAvailable()
        check((CLOUDS in offered) == expected, f"offered for {kind}: {offered}")


def check_grids_and_cells():
    """A grid one point thick is drawn as the same polygons are; the outer surface of 3-D cells is drawn with a sentence that says what is better."""
    messages = listen()
    image_of_one = pvs.Wavelet(WholeExtent=[-20, 20, -20, 20, 0, 0])
    pictures = []
    for source in (image_of_one, pvs.Transform(Input=image_of_one), pvs.ExtractSurface(Input=image_of_one)):
        view = new_view()
        compose(source, view, ("POINTS", ""), CLOUDS)
        pvs.ResetCamera(view)
        pictures.append(color_and_alpha(view)[0])
        check_same(pictures[-1], pictures[0], "one sheet as image, grid and polygons", largest=2, mean=0.1)
    check(not messages, f"of sheets: {messages}")
    view = new_view()
    compose(pvs.Tetrahedralize(Input=pvs.Wavelet(WholeExtent=[-4, 4] * 3)), view, ("POINTS", ""), CLOUDS)
    pvs.ResetCamera(view)
    inside_mean_alpha(color_and_alpha(view)[1])
    check(len(messages) == 1 and "3-D cells" in messages[0] and "Cloud Surface" in messages[0], f"of 3-D cells: {messages}")


def check_first_picture():
    """Nothing set but the choice: broken cloud, neither nothing nor all, of surfaces with and without advected coordinates."""
    for name, source in (("globe", pvs.Sphere(Radius=6.4e6, ThetaResolution=100, PhiResolution=100)), ("clouds", moving_clouds()[1])):
        view = new_view((200, 200))
        display = pvs.Show(source, view)
        surface = []
        for representation in ("Surface", CLOUDS):
            display.SetRepresentationType(representation)
            pvs.ResetCamera(view)
            surface.append(color_and_alpha(view)[1])
        share = surface[1].sum() / surface[0].sum()
        print(f"first picture of {name}: {share:.3f} of the surface is cloud, mean alpha {inside_mean_alpha(surface[1]):.3f}")
        check(0.3 < share < 0.95, f"{name}: {share:.3f} of the surface is cloud")


def check_cover():
    """A flat sheet with many repetitions: alpha is the cover times the opacity of a layer seen from above."""
    view = sheet_view()
    display = compose(sheet(), view, ("POINTS", ""), CLOUDS)
    solid(display, [1, 1, 1])
    display.CloudTextureTextureScale = 60
    for cover, depth, opacity in ((0.15, 3, 1), (0.5, 3, 1), (0.85, 3, 1), (0.5, 0.5, 1), (0.5, 3, 0.5)):
        display.CloudTextureCoverage = cover
        display.CloudTextureOpticalDepth = depth
        display.Opacity = opacity
        found = color_and_alpha(view)[1].mean()
        expected = cover * (1 - math.exp(-depth)) * opacity
        print(f"cover {cover}, depth {depth}, opacity {opacity}: {found:.4f}, expected {expected:.4f}")
        check(abs(found - expected) < 0.01, f"cover {cover}: {found}, expected {expected}")


def check_cover_array():
    view = sheet_view()
    source = pvs.Calculator(Input=sheet(), ResultArrayName="Cover", Function="coordsX+0.5")
    display = compose(source, view, ("POINTS", ""), CLOUDS)
    solid(display, [1, 1, 1])
    display.CloudTextureTextureScale = 60
    display.CloudTextureCoverageArrayName = "Cover"
    columns = color_and_alpha(view)[1].mean(axis=0) / (1 - math.exp(-3))
    display.CloudTextureDensityArrayName = "None"  # as the menu says it
    slope = np.polyfit(np.arange(len(columns)) / len(columns), columns, 1)
    display.CloudTextureCoverageArrayName = "None"
    check(abs(color_and_alpha(view)[1].mean() / (1 - math.exp(-3)) - 0.5) < 0.02, "None is taken for an array")
    check(abs(slope[0] - 1) < 0.03 and abs(slope[1]) < 0.02, f"cover across the sheet is {slope}, expected 1, 0")


def check_moves_with_time():
    """The wind moves the texture while the surface stands still; a time that comes again gives the same picture."""
    texture, clouds = moving_clouds()
    view = new_view((200, 200))
    display = pvs.Show(clouds, view)
    display.SetRepresentationType(CLOUDS)
    solid(display, [1, 1, 1])
    pvs.ResetCamera(view)
    pictures = []
    for time in (0.0, 0.1, 0.2, 0.1):
        view.ViewTime = time
        pictures.append(image(view))
    check(np.abs(pictures[1] - pictures[0]).mean() > 2, "the texture does not move with the time")
    check_same(pictures[1], pictures[3], "the same time again", largest=1, mean=0.01)
    display.CloudTextureFirstCoordinatesName = display.CloudTextureSecondCoordinatesName = ""
    still = image(view)
    view.ViewTime = 0.0
    check_same(still, image(view), "positions as coordinates", largest=1, mean=0.01)
    pvs.Delete(texture)


def check_moving_camera():
    """Data beyond the threshold of level of detail are drawn whole while the camera moves."""
    view = new_view((200, 200))
    compose(pvs.Sphere(ThetaResolution=60, PhiResolution=60), view, ("POINTS", ""), CLOUDS)
    look(view, (2, 1, 2))
    view.LODThreshold = 0
    still = image(view)
    view.UseInteractiveRenderingForScreenshots = 1
    check_same(still, image(view), "while the camera moves", largest=1, mean=0.01)
    check(still.mean() > 5, "nothing is drawn")


def check_threshold_and_waves():
    """The cover of a threshold; waves that are set, as stripes; the colours of the texture."""
    view = sheet_view()
    display = compose(sheet(), view, ("POINTS", ""), CLOUDS)
    solid(display, [1, 1, 1])
    display.CloudTextureTextureScale = 60
    display.CloudTextureUseThreshold = 1
    opaque = 1 - math.exp(-3)
    for threshold in (-1, 0, 1):
        display.CloudTextureThreshold = threshold
        spread = math.sqrt(1 + 0.4 ** 2)
        cover = 0.5 * math.erfc(threshold / spread / math.sqrt(2))  # the sum of many waves is nearly Gaussian
        found = color_and_alpha(view)[1].mean() / opaque
        print(f"threshold {threshold}: cover {found:.4f}, Gaussian {cover:.4f}")
        check(abs(found - cover) < 0.02, f"threshold {threshold}: cover {found}, expected {cover}")
    display.CloudTextureTextureScale = 1
    display.CloudTextureThreshold = 0
    display.CloudTextureSoftness = 0
    display.CloudTextureWaves = "Custom"
    display.CloudTextureCustomWaves = [1, 4, 0, 0, 0, 0, 0, 0, 0.25]  # 4 stripes across
    columns = color_and_alpha(view)[1].mean(axis=0) > 0.5 * opaque
    check(np.count_nonzero(np.diff(columns.astype(int)) == 1) in (3, 4), "custom waves are not drawn")
    display.CloudTextureThinColor = display.CloudTextureThickColor = [0, 1, 0]
    check(color_and_alpha(view)[0][:, :, [0, 2]].max() < 0.02, "the colours of the texture are not drawn")


def thick_ball():
    """A view of a ball of cloud that is as opaque as it is thick, and its display."""
    view = new_view((100, 100))
    ball = pvs.Sphere(Radius=1, ThetaResolution=100, PhiResolution=100)
    display = compose(ball, view, ("POINTS", ""), CLOUDS)
    solid(display, [1, 1, 1])
    display.CloudTextureCoverage = 1
    display.CloudTextureUseThickness = 1
    return view, display


def check_thickness():
    """Along the ray through the middle of a ball of given extinction; at the default, thinner towards the rim."""
    view, display = thick_ball()
    look(view, (0, 0, 6))
    for extinction in (0.3, 1.0):
        display.CloudTextureExtinction = extinction
        alpha = color_and_alpha(view)[1]
        expected = 1 - math.exp(-2 * extinction)
        check(abs(alpha[50, 50] - expected) < 0.02, f"extinction {extinction}: alpha {alpha[50, 50]}, expected {expected}")
    row = alpha[50][alpha[50] > 0.02]
    check(row[len(row) // 2] > row[len(row) // 20], "the ball is not thicker in the middle")


def check_density_volume():
    """A ball in grids of a linear density: through its middle by that of its centre. Back to none, and after a change of the volume."""
    view, display = thick_ball()
    display.CloudTextureExtinction = 1
    wavelet = pvs.Wavelet(WholeExtent=[-3, 3, -3, 3, -3, 3])
    grid = pvs.Calculator(Input=pvs.Transform(Input=wavelet), ResultArrayName="Water", Function="0.4 + 0.05*coordsX")
    grid.Input.Transform.Scale = [0.5, 0.5, 0.5]
    volumes = [grid, pvs.GroupDatasets(Input=[pvs.AppendDatasets(Input=grid)]), pvs.Tetrahedralize(Input=grid)]
    look(view, (0, 0, 6))
    plain = image(view)
    for volume in volumes:
        display.CloudTextureDensityVolume = volume
        display.CloudTextureDensityArrayName = "Water"
        alpha = color_and_alpha(view)[1]
        expected = 1 - math.exp(-2 * 0.4)
        print(f"density volume {volume.GetXMLName()}: {alpha[50, 50]:.4f}, expected {expected:.4f}")
        check(abs(alpha[50, 50] - expected) < 0.01, f"alpha {alpha[50, 50]}, expected {expected}")
        row = alpha[50]
        check(row[67] > row[33], "the density does not grow to the right")
        display.CloudTextureDensityVolume = None
        display.CloudTextureDensityArrayName = "None"
        check_same(plain, image(view), "without a volume again", largest=1, mean=0.01)
    display.CloudTextureDensityVolume = grid
    display.CloudTextureDensityArrayName = "Water"
    grid.Function = "0.8"
    after = color_and_alpha(view)[1]
    check(abs(after[50, 50] - (1 - math.exp(-1.6))) < 0.01, "a volume that changes is not drawn anew")
    pvs.Delete(grid)  # ParaView would delete the display too
    check(display.SMProxy in [one.SMProxy for one in view.Representations], "the display has gone with its density volume")
    check(display.CloudTextureDensityVolume is None, "the display still has the volume")
    display.CloudTextureDensityArrayName = "None"
    check_same(plain, image(view), "after the volume has been deleted", largest=1, mean=0.01)


def halves_of(whole):
    """The surfaces with x above and below 0."""
    halves = [pvs.Clip(Input=whole, Invert=i) for i in (0, 1)]
    for half in halves:
        half.ClipType.Normal = [1, 0, 0]
        half.ClipType.Origin = [0, 0, 0]
    return [pvs.ExtractSurface(Input=half) for half in halves]


def check_colors_of_some_blocks():
    """A block that lacks the coloured array does not take the colours of the others, and has the colour that it has in Surface."""
    right, left = halves_of(sheet())
    elevation = pvs.Elevation(Input=right, LowPoint=[-0.5, 0, 0], HighPoint=[0.5, 0, 0])
    colors = pvs.GetColorTransferFunction("Elevation")
    for association, blocks in (("POINTS", [elevation, left]), ("CELLS", [left, pvs.PointDatatoCellData(Input=elevation)])):
        view = sheet_view()
        display = compose(pvs.GroupDatasets(Input=blocks), view, (association, "Elevation"), "Surface")
        display.Ambient, display.Diffuse, display.DiffuseColor, display.AmbientColor = 1, 0, [0, 1, 0], [0, 1, 0]
        display.CloudTextureCoverage, display.CloudTextureOpticalDepth, display.CloudTextureRelief = 1, 20, 0
        display.CloudTextureThinColor = display.CloudTextureThickColor = [1, 1, 1]
        colors.RGBPoints, colors.ColorSpace = [0, 1, 0, 0, 1, 0, 0, 1], "RGB"
        surface = image(view)
        display.SetRepresentationType(CLOUDS)
        clouds = image(view)
        check(clouds[:, :90, 1].min() > 250 and clouds[:, 110:, 1].max() < 5, f"{association}: colours of blocks")
        check_same(surface, clouds, f"colours of blocks by {association}", largest=255, mean=0.5)


def check_blocks():
    """Blocks of a surface are drawn as the surface: one length for all."""
    pictures = []
    whole = sheet()
    blocks = pvs.GroupDatasets(Input=halves_of(whole))
    for source in (whole, blocks):
        view = sheet_view()
        solid(compose(source, view, ("POINTS", ""), CLOUDS), [1, 1, 1])
        pictures.append(image(view))
    check(pictures[0].mean() > 20, "nothing is drawn")
    check_same(*pictures, "blocks", largest=8, mean=0.05)


def check_state():
    """A saved state draws the same picture: all settings are in it. To be called before there are other views."""
    view = new_view()
    display = pvs.Show(moving_clouds()[1], view)
    display.SetRepresentationType(CLOUDS)
    solid(display, [1, 1, 0.9])
    for name, value in (("Coverage", 0.3), ("TextureScale", 5), ("Softness", 0.3), ("Relief", 0.04), ("OpticalDepth", 2)):
        setattr(display, "CloudTexture" + name, value)
    view.ViewTime = 0.2
    pvs.ResetCamera(view)
    expected = image(view)
    state = os.path.join(OUTPUT, "CloudTexture.pvsm")
    pvs.SaveState(state)
    pvs.ResetSession()
    load_plugin()
    pvs.LoadState(state)
    again, = pvs.GetViews()
    again.ViewSize, again.UseFXAA, again.ViewTime = list(SIZE), 0, 0.2  # ParaView does not keep them
    check(expected.mean() > 2, "nothing is drawn")
    check_same(expected, image(again), "after loading the state", largest=2, mean=0.01)


def check_colors():
    view = sheet_view()
    display = compose(pvs.Elevation(Input=sheet(), LowPoint=[-0.5, 0, 0], HighPoint=[0.5, 0, 0]), view, ("POINTS", "Elevation"), CLOUDS)
    display.Ambient, display.Diffuse = 1, 0
    pvs.GetColorTransferFunction("Elevation").RGBPoints = [0, 1, 0, 0, 1, 0, 0, 1]
    pvs.GetColorTransferFunction("Elevation").ColorSpace = "RGB"
    columns = color_and_alpha(view)[0].mean(axis=0)
    across = (np.arange(len(columns)) + 0.5) / len(columns)
    check(columns[:, 1].max() < 0.5, "there is green in a map of red and blue")
    difference = np.abs(columns[:, 2] / (columns[:, 0] + columns[:, 2]) - across).max()
    check(difference < 0.02, f"colours are not those of the array: share of blue is off by {difference}")
    solid(display, [0, 1, 0])
    picture = color_and_alpha(view)[0]
    check(picture[:, :, [0, 2]].max() < 2 < picture[:, :, 1].max(), "solid colour is not green")


if __name__ == "__main__":
    load_plugin()
    for check_one in (check_state, check_definition, check_offered, check_grids_and_cells, check_first_picture, check_cover, check_cover_array, check_moves_with_time,
                      check_moving_camera, check_threshold_and_waves, check_thickness, check_density_volume, check_blocks, check_colors,
                      check_colors_of_some_blocks):
        print(check_one.__name__, flush=True)
        check_one()
    passed()
