# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Contour surfaces and layers through ParaView's properties, against ParaView's own contours."""
import numpy as np
from PluginTesting import check, check_same, color_and_alpha, compose, image, load_plugin, look, new_view, passed, pvs, render, save_image, solid

VALUES = [130.0, 200.0]
PLACE = (36, 27, 42)


def clear(display):
    """The medium away: only surfaces are left."""
    display.CellCompositingOpacityScale = 0.0


def surfaces(source, values=VALUES, **properties):
    view = new_view()
    display = compose(source, view)
    clear(display)
    display.CellCompositingContourValues = values
    display.CellCompositingContourLighting = 0
    for name, value in properties.items():
        setattr(display, "CellCompositing" + name, value)
    render(view)
    look(view, PLACE)
    return view, display


def polygons(source, values, colors):
    view = new_view()
    for value, color in zip(values, colors):
        contour = pvs.Contour(Input=source, ContourBy=["POINTS", "RTData"], Isosurfaces=[value])
        display = pvs.Show(contour, view)
        solid(display, color)
        display.Ambient, display.Diffuse, display.Specular = 1.0, 0.0, 0.0
    render(view)  # the first picture of a view places the camera
    look(view, PLACE)
    return view


def check_against_polygons(source):
    """Opaque: the same pixels as polygons, but where an outline falls between pixels."""
    colors = [[0.9, 0.2, 0.1], [0.1, 0.4, 0.9]]
    view, _ = surfaces(source, ContourOpacity=1.0, ContourColors=sum(colors, []))
    ours, theirs = image(view), image(polygons(pvs.Tetrahedralize(Input=source), VALUES, colors))
    save_image(ours, "Contours")
    different = (np.abs(ours - theirs).max(axis=2) > 2).mean()
    print(f"contours against polygons: {different:.3%} of the pixels differ", flush=True)
    check((theirs.max(axis=2) > 0).mean() > 0.1, "the polygons are not there")
    check(different < 0.01, "contour surfaces are not where ParaView's are")


def check_properties(source):
    view, display = surfaces(source, ContourOpacity=0.25)
    _, alpha = color_and_alpha(view)
    levels = -np.log1p(-np.clip(alpha[alpha > 0.02], 0, 0.999)) / -np.log(0.75)
    check(np.abs(levels - np.rint(levels)).max() < 0.1, "alphas are not those of whole numbers of surfaces")
    display.CellCompositingContourOpacities = [0.0, 0.25]
    second = image(view)
    display.CellCompositingContourValues = VALUES[1:]
    display.CellCompositingContourOpacities = []
    check_same(second, image(view), "an opacity of 0 and a value left out")
    display.Opacity = 0.0
    check(image(view).max() == 0, "Opacity 0 leaves a surface")
    display.Opacity = 1.0
    plain = image(view)
    display.CellCompositingContourLighting = 1
    lit = image(view)
    check(np.abs(lit - plain).max() > 10, "light makes no difference")
    display.CellCompositingSmoothContourNormals = 0
    check(np.abs(image(view) - lit).max() > 3, "smooth and flat normals look the same")
    display.CellCompositingContourValues = []
    check(image(view).max() == 0, "without values something is drawn")


def check_material(source):
    """Surfaces reflect light as the display says: as ParaView's own contour of an image, however the cells are stored."""
    settings = {"Diffuse": 0.6, "Specular": 0.8, "SpecularPower": 20, "Ambient": 0.1}
    contour = new_view()
    shown = pvs.Show(pvs.Contour(Input=source, ContourBy=["POINTS", "RTData"], Isosurfaces=[200]), contour)
    solid(shown, [0.0, 1.0, 0.0])
    for name, value in settings.items():
        setattr(shown, name, value)
    look(contour, PLACE)
    expected = image(contour)
    for cells in (source, pvs.Transform(Input=source), pvs.AppendDatasets(Input=source), pvs.GroupDatasets(Input=[source])):
        view, display = surfaces(cells, [200], ContourOpacity=1.0, ContourLighting=1, ContourColors=[0.0, 1.0, 0.0])
        before = image(view)
        for name, value in settings.items():
            setattr(display, name, value)
        picture = image(view)
        check(np.abs(picture - before).max() > 50, f"{cells.GetXMLName()}: the material makes no difference")
        difference = np.abs(picture - expected).max(axis=2)
        print(f"{cells.GetXMLName()}: {np.median(difference[difference > 0]):.0f}/255, {np.mean(difference > 20):.4f} of the picture beyond 20/255", flush=True)
        check(np.mean(difference > 20) < 0.02, f"{cells.GetXMLName()}: not as ParaView lights its contour")


def check_contour_array(source):
    """Planes of another array, under Solid Color as well."""
    second = pvs.Calculator(Input=source, ResultArrayName="height", Function="coordsZ")
    for colored in (True, False):
        view, display = surfaces(second, [0.5], ContourArray="height", ContourOpacity=1.0)
        if not colored:
            solid(display, [0.0, 1.0, 0.0])
        look(view, position=(1.8, 1.2, 66))
        picture = image(view)
        check((picture[120:180, 120:180].max(axis=2) > 50).all(), f"no surface of another array, coloured {colored}")
        if not colored:
            check((picture[150, 150] == [0, 255, 0]).all(), f"the surface is {picture[150, 150]}, not green")


def show_layers(source):
    """View, display and opacity of the layers between the two values, without surfaces."""
    view = new_view()
    display = compose(source, view)
    display.CellCompositingContourValues = VALUES
    display.CellCompositingContourOpacity = 0.0
    render(view)
    look(view, PLACE)
    return view, display, color_and_alpha(view)[1]


def check_layers(source):
    """With layer 1 emptied, only what lies outside the two values is left."""
    view, display, whole = show_layers(source)
    display.CellCompositingLayerOpacityScales = [1.0, 0.0, 1.0]
    _, hollow = color_and_alpha(view)
    display.CellCompositingLayerOpacityScales = [0.0, 1.0, 0.0]
    _, shell = color_and_alpha(view)
    # Optical depths add up, to the rounding of two 8-bit pictures.
    check(0.02 < hollow.max() and 0.02 < shell.max(), "a layer is missing")
    together = 1 - (1 - hollow) * (1 - shell)
    print(f"layers put together: max {255 * np.abs(together - whole).max():.1f}/255", flush=True)
    check(np.abs(together - whole).max() < 4 / 255, "layers do not add up to the whole")
    display.CellCompositingLayerOpacityScales = []
    check_same(color_and_alpha(view)[1] * 255, whole * 255, "layers and back")


def check_layer_colors(source):
    """Colours that jump between layers: what each layer adds is its own colour, and the opacity stays."""
    view, display, whole = show_layers(source)
    display.CellCompositingLayerColors = [1, 0, 0, 0, 1, 0, 0, 0, 1]
    rgb, alpha = color_and_alpha(view)
    save_image(rgb, "LayerColors")
    check((rgb.max(axis=(0, 1)) > 10).all(), "a layer's colour is missing")
    check(np.abs(rgb.sum(axis=2) - 255 * alpha).max() <= 3, "something has another colour than those of the layers")
    check(np.abs(alpha - whole).max() < 2 / 255, "colours change the opacity")
    display.CellCompositingLayerOpacityScales = [0.0, 1.0, 0.0]
    check(image(view)[..., [0, 2]].max() == 0, "layer 1 is not green alone")
    display.CellCompositingLayerOpacityScales = []
    maps = [pvs.CreateLookupTable(RGBPoints=[0, *color, 300, *color]) for color in ([1, 0, 0], [0, 1, 0], [0, 0, 1])]
    display.CellCompositingLayerColors = []
    display.CellCompositingLayerLookupTables = maps
    check_same(image(view), rgb, "layer colour maps", 1, 0.1)
    display.CellCompositingLayerColors = [-1, 0, 0, 0, 0, 1]
    red, green, _ = image(view).max(axis=(0, 1))
    check(green < red, "a colour must go before a colour map, and a negative red is none")
    display.CellCompositingLayerLookupTables = []
    display.CellCompositingLayerColors = []
    check_same(color_and_alpha(view)[1] * 255, whole * 255, "layer colours and back")


def check_polygons(source):
    """The pieces of Contour Cell Splitter with the polygons between them: the picture of contour surfaces in whole cells."""
    tetrahedra = pvs.Tetrahedralize(Input=source)
    pictures, shown = [], []
    for pieces in (pvs.ContourCellSplitter(Input=tetrahedra, ContourBy=["POINTS", "RTData"], ContourValues=VALUES), tetrahedra):
        view = new_view()
        display = compose(pieces, view)
        if pieces is tetrahedra:
            display.CellCompositingContourValues = VALUES
        display.CellCompositingContourOpacities = [0.8, 0.5]
        display.CellCompositingContourColors = [1, 0, 0]
        display.CellCompositingSmoothContourNormals = 0
        render(view)
        look(view, PLACE)
        pictures.append(image(view))
        shown.append((view, display))
    save_image(pictures[0], "Polygons")
    different = (np.abs(pictures[0] - pictures[1]).max(axis=2) > 2).mean()
    print(f"polygons against contours: {different:.3%} of the pixels differ", flush=True)
    check(different < 0.005, "polygons of the splitter are not drawn as contour surfaces are")
    split_view, split_display = shown[0]
    split_display.CellCompositingPolygons = "None"
    check(np.abs(image(split_view) - pictures[0]).max() > 20, "without polygons the picture is the same")


load_plugin()
wavelet = pvs.Wavelet(WholeExtent=[-6, 6] * 3)
check_against_polygons(wavelet)
check_properties(wavelet)
check_contour_array(wavelet)
check_material(wavelet)
check_layers(wavelet)
check_layer_colors(wavelet)
check_polygons(wavelet)
passed()
