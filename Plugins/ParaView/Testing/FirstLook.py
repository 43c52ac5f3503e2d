# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The first picture of every filter and source, nothing set: representation, colours, opacities and camera."""
import functools
import math
import re

import nephoscope
import numpy as np
from PluginTesting import GFS, SIZE, check, compose, image, load_plugin, new_view, passed, pvs, render, save_image, servermanager
from vtkmodules.vtkRenderingCore import vtkVolumeProperty


def drawn(view, name):
    """Where the picture shows anything."""
    picture = image(view)
    save_image(picture, f"FirstLook-{name}")
    return abs(picture - picture[0, 0]).max(axis=2) > 8


def shown(view, name):
    """The share of the picture that shows anything."""
    return drawn(view, name).mean()


def apply(source, view, earlier=None):
    """What Apply does in the window, but for the camera: shows a filter in place of its input."""
    display = pvs.Show(source, view)
    if earlier:
        pvs.Hide(earlier, view)
    return display


def look_first(source):
    view = new_view(SIZE)
    display = pvs.Show(source, view)
    pvs.ResetCamera(view)
    render(view)
    return view, display


def check_display(display, what, representation, array, association="POINTS"):
    name = list(display.ColorArrayName)
    check(display.Representation == representation, f"{what} is shown as {display.Representation}")
    check(name[1] == array and (not array or name[0] == association), f"{what} is coloured by {name}")


@functools.cache
def globe(rate=3):
    weather = pvs.ExtractSubset(Input=pvs.NetCDFReader(FileName=[GFS], SphericalCoordinates=0), VOI=[0, 10**6] * 3, SampleRateI=rate, SampleRateJ=rate)
    return weather, pvs.GlobeGrid(Input=weather, VerticalExaggeration=30)


def check_camera():
    """From degrees to metres, with a camera that nobody touches, and with one that somebody does."""
    weather, clouds = globe()
    view, _ = look_first(weather)
    degrees = list(view.CameraPosition)
    display = apply(clouds, view, weather)
    check_display(display, "Globe Grid", "Cell Compositing", "cloud_fraction")
    share = shown(view, "globe")
    check(0.1 < share < 0.9, f"{share:.1%} of the picture of a globe after one in degrees show anything")
    metres = list(view.CameraPosition)
    check(math.hypot(*metres) > 1e7, f"the camera is at {metres}")
    # Between data of one place and scale it stays.
    pvs.Show(pvs.StructuredSmoothing(Input=clouds), view)
    pvs.Render(view)
    check(list(view.CameraPosition) == metres, "the camera has moved between data of one scale")
    pvs.Delete(view)

    view, _ = look_first(weather)
    apply(pvs.GlobeGrid(Input=weather), view, weather)
    view.CameraPosition = [x + 1 for x in degrees]
    pvs.Render(view)
    check(list(view.CameraPosition) == [x + 1 for x in degrees], "the camera has moved although it had been set")
    pvs.Delete(view)


def eye_over(view):
    """Longitude and latitude in degrees that the camera looks down on, and the height of north in the picture, -1 to 1."""
    eye = np.subtract(view.CameraPosition, view.CameraFocalPoint)
    eye /= np.linalg.norm(eye)
    right = np.cross(view.CameraViewUp, eye)
    up = np.cross(eye, right / np.linalg.norm(right))
    return math.degrees(math.atan2(eye[1], eye[0])), math.degrees(math.asin(eye[2])), up[2] / max(math.cos(math.asin(eye[2])), 1e-9)


def check_globe_camera():
    """A globe is first seen from above middle latitudes, a region from above itself, north up; a camera that somebody has turned stays."""
    view = new_view(SIZE)
    example = pvs.CloudsovertheGlobe()
    for port in range(2):  # as Apply does
        pvs.Show(pvs.OutputPort(example, port), view)
    share = shown(view, "globe-from-the-side")
    _, latitude, north = eye_over(view)
    check(15 < latitude < 50 and north > 0.999, f"the example is seen from latitude {latitude:.0f}, north {north:.2f}")
    check(0.2 < share < 0.9, f"{share:.1%} of the picture of the example show anything")
    pvs.Delete(view)

    _, clouds = globe(6)
    for what in ("camera reset", "smoke too"):  # before the first picture, as the window does
        view = new_view(SIZE)
        pvs.Show(clouds, view)
        if what == "smoke too":
            pvs.Show(pvs.FlowVolume(Input=globe(12)[1]), view)
        pvs.ResetCamera(view)
        pvs.Render(view)
        _, latitude, north = eye_over(view)
        check(15 < latitude < 50 and north > 0.999, f"{what}: a globe is seen from latitude {latitude:.0f}, north {north:.2f}")
        pvs.Delete(view)

    for (west, east), (south, north) in (((100, 120), (42, 62)), ((4, 20), (4, 20)), ((0, 143), (68, 72))):
        weather = pvs.NetCDFReader(FileName=[GFS], SphericalCoordinates=0)
        weather.UpdatePipeline()
        region = pvs.ExtractSubset(Input=weather, VOI=[west, east, south, north, 0, 20])
        place = pvs.GlobeGrid(Input=region, VerticalExaggeration=30)
        place.UpdatePipeline()
        view = new_view(SIZE)
        pvs.Show(place, view)
        share = shown(view, f"region-{west}-{south}")
        check(share > 0.1, f"{share:.1%} of the picture of a region show anything")
        bounds = np.reshape(place.GetDataInformation().GetBounds(), (3, 2)).mean(axis=1)
        eye = np.subtract(view.CameraPosition, view.CameraFocalPoint)
        check(bounds @ eye > 0.99 * np.linalg.norm(bounds) * np.linalg.norm(eye), f"region {west} {south}: seen from {eye}, is at {bounds}")
        pvs.Delete(view)

    view = new_view(SIZE)
    view.CameraPosition, view.CameraViewUp = [3e7, 0, 0], [0, 1, 0]
    pvs.Show(clouds, view)
    pvs.Render(view)
    check(list(view.CameraPosition) == [3e7, 0, 0], "the camera has turned although it had been set")
    pvs.Delete(view)
    view = new_view(SIZE)
    pvs.Show(clouds, view)
    view.CameraPosition, view.CameraFocalPoint = [0, 0, 3e7], [0, 0, 0]
    pvs.Render(view)
    check(list(view.CameraPosition) == [0, 0, 3e7], "the camera has turned although it had been set above the pole")
    pvs.Delete(view)


def check_smoke():
    """Smoke is white, and no dot in the picture of the globe it was made in."""
    weather, _ = globe(4)
    clouds = pvs.GlobeGrid(Input=weather)
    view, _ = look_first(clouds)
    smoke = pvs.FlowVolume(Input=clouds)
    check_display(apply(smoke, view, clouds), "Flow Volume", "Cell Compositing", "")
    rows, columns = drawn(view, "smoke").nonzero()
    check(len(rows) > 0, "there is no smoke")
    size = max(np.ptp(rows), np.ptp(columns)) / SIZE[0]
    check(size > 0.2, f"smoke is {size:.2f} of the picture long")
    check_display(apply(pvs.SmokePuffs(Input=smoke), view, smoke), "Smoke Puffs", "Cell Compositing", "")
    light = pvs.Sunlight(Input=smoke, SunDirection=view.CameraPosition)
    display = apply(light, view, smoke)
    check_display(display, "Sunlight", "Cell Compositing", "Sunlight")
    check(shown(view, "lit-smoke") > 0, "there is no lit smoke")
    white, brightest = display.LookupTable.RGBPoints[-4], light.PointData["Sunlight"].GetRange()[1]
    check(abs(white - 0.7 * brightest) < 1e-4, f"lit smoke is grey: white is a light of {white:.2f}, its greatest {brightest:.2f}")
    low, high = light.PointData["SunTransmittance"].GetRange()
    check(low < 0.5 and high > 0.95, f"{low:.2f} to {high:.2f} of the sun comes through smoke")
    pvs.Delete(view)


def check_smoke_on_white():
    """Smoke is dark where the palette is bright: it would not be seen."""
    pvs.LoadPalette("WhiteBackground")
    wind = pvs.Calculator(Input=pvs.Wavelet(), Function="iHat + 0.1*jHat", ResultArrayName="wind")
    view = new_view(SIZE)
    view.UseColorPaletteForBackground = 1
    pvs.Show(pvs.FlowVolume(Input=wind), view)
    pvs.ResetCamera(view)
    share = shown(view, "smoke-on-white")
    check(image(view)[0, 0].min() > 250, "the background is not white")
    check(share > 0.005, f"{share:.2%} of the picture of smoke on white show anything")
    pvs.Delete(view)
    pvs.LoadPalette("BlueGrayBackground")


def check_terrain():
    """The ground in the colours of its altitude, in metres, the sea apart."""
    fields = pvs.NetCDFReader(FileName=[GFS], SphericalCoordinates=0, Dimensions="(lat, lon)")
    terrain = pvs.GlobeTerrain(Input=fields)
    view, display = look_first(terrain)
    check_display(display, "Globe Terrain", "Surface", "Terrain")
    points = list(display.LookupTable.RGBPoints)
    check((points[0], points[-4]) == (-100, 6000), f"the colours of terrain go from {points[0]} to {points[-4]}")
    red, green, blue = (image(view)[..., c].astype(float) for c in range(3))
    sea, land = (blue > 1.3 * green).mean(), ((green > 1.2 * blue) & (green > 40)).mean()
    check(sea > 0.05 and land > 0.05, f"{sea:.1%} of the picture are sea, {land:.1%} land")
    pvs.Delete(view)


def check_light():
    """Clouds in the sun: coloured by their light, as opaque as the extinction it was computed for, exp(-depth)."""
    cloud = pvs.Calculator(Input=pvs.Wavelet(WholeExtent=[-6, 6] * 3), ResultArrayName="Extinction", Function="0.1+0*coordsX")
    light = pvs.Sunlight(Input=cloud, SunDirection=[0, 0, 1])
    view, display = look_first(light)
    view.UseColorPaletteForBackground, view.BackgroundColorMode, view.Background = 0, "Single Color", [0, 0, 1]
    check_display(display, "Sunlight", "Cell Compositing", "Sunlight")
    white = pvs.servermanager.Fetch(light).GetFieldData().GetArray("WhiteLight").GetValue(0)
    check(0.15 < white < 0.6 and abs(display.LookupTable.RGBPoints[-4] - white) < 1e-9, f"the colours of light go to {display.LookupTable.RGBPoints[-4]}")
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp, view.CameraParallelProjection = [0, -40, 0], [0, 0, 0], [0, 0, 1], 1
    display.LookupTable.RGBPoints = [0, 0, 0, 0, 1, 0, 0, 0]  # black: blue is what comes through
    expected = math.exp(-12 * light.PointData["ScaledExtinction"].GetRange()[1])
    for representation in ("Cell Compositing", "Textured Splats"):
        display.Representation = representation
        check_display(display, "Sunlight", representation, "Sunlight")
        through = image(view)[SIZE[1] // 2, SIZE[0] // 2, 2] / 255
        check(abs(through - expected) < 0.02, f"{representation}: {through:.3f} of the light comes through the cloud, for {expected:.3f}")
    pvs.Delete(view)


def lit_cloud(**options):
    cloud = pvs.Calculator(Input=pvs.Wavelet(WholeExtent=[-6, 6] * 3), ResultArrayName="Extinction", Function="0.5*exp(-(coordsX^2+coordsY^2+coordsZ^2)/9)")
    return pvs.Sunlight(Input=cloud, SunDirection=[0, 0, 1], **options)


def white_of(light):
    return pvs.servermanager.Fetch(light).GetFieldData().GetArray("WhiteLight").GetValue(0)


def check_contour_of_light():
    """A surface in the light of clouds has the grey of the clouds, although these are not shown."""
    pvs.Delete(pvs.GetColorTransferFunction("Sunlight"))  # of the other tests
    light = lit_cloud()
    view = new_view(SIZE)
    display = pvs.Show(pvs.Contour(Input=light, ContourBy=["POINTS", "ScaledExtinction"], Isosurfaces=[0.05]), view)
    display.SMProxy.SetScalarColoring("Sunlight", 0)  # as the window does; ColorBy fits the range to the data
    pvs.ResetCamera(view)
    points = np.reshape(display.LookupTable.RGBPoints, (-1, 4))
    check(np.ptp(points[:, 1:], axis=1).max() < 0.06, f"a contour in the colours {points.tolist()}")
    check(abs(points[-1, 0] - white_of(light)) < 1e-9, f"white is {points[-1, 0]}, not {white_of(light)}")
    picture = image(view)
    save_image(picture, "FirstLook-contour-of-light")
    seen = picture[picture.max(axis=2) > 30]
    check(len(seen) > 1000 and np.ptp(seen, axis=1).max() < 30, "the contour is not grey")
    display.LookupTable.RGBPoints = [0, 0, 0, 0, 1, 0, 0, 1]
    pvs.Show(pvs.Slice(Input=light), view)
    check(list(display.LookupTable.RGBPoints) == [0, 0, 0, 0, 1, 0, 0, 1], "colours that somebody has chosen are gone")
    pvs.Delete(view)


def check_follow_camera():
    """White follows Follow Camera, unless somebody has set it, and never the sun: a film of a day has a night."""
    light = lit_cloud()
    view, display = look_first(light)
    def whites():
        pvs.Render(view)
        return display.LookupTable.RGBPoints[-4], white_of(light)
    first, _ = whites()
    light.FollowCamera = 1
    shown, told = whites()
    check(abs(told / first - 1) > 0.02 and abs(shown - told) < 1e-9, f"with Follow Camera white is {shown}, not {told}; before {first}")
    light.SunDirection = [1, 0, 0.1]
    check(whites()[0] == shown, "white follows the sun")
    display.LookupTable.RescaleTransferFunction(0, 0.9)
    light.FollowCamera = 0
    check(abs(whites()[0] - 0.9) < 1e-9, "white that somebody has set is another")
    pvs.Delete(view)


def check_optics():
    """The extinction, although the clouds were coloured by another array; arrays that the menus call Automatic are found by their names."""
    weather, _ = globe()
    clouds = pvs.GlobeGrid(Input=weather)
    view, _ = look_first(clouds)
    optics = pvs.CloudOptics(Input=clouds)
    check(optics.TotalWaterArray == "Automatic", f"the water array is {optics.TotalWaterArray!r}")
    display = apply(optics, view, clouds)
    check_display(display, "Cloud Optics", "Cell Compositing", "Extinction")
    check(min(display.LookupTable.RGBPoints[-3:]) > 0.99, f"clouds are not white: {list(display.LookupTable.RGBPoints)}")
    check(optics.PointData["Extinction"].GetRange()[1] > 0, "there is no extinction")
    pvs.Delete(view)


def check_filters():
    wavelet = pvs.Wavelet(WholeExtent=[-6, 6] * 3)
    view, _ = look_first(wavelet)
    for make, representation, array, association in ((pvs.CloudSurface, "Surface", "", "POINTS"), (pvs.ContourCellSplitter, "Surface", "Layer", "CELLS"),
                                                     (pvs.StructuredSmoothing, "Cell Compositing", "RTData", "POINTS")):
        source = make(Input=wavelet)
        check_display(apply(source, view, wavelet), source.GetXMLName(), representation, array, association)
        share = shown(view, source.GetXMLName())
        check(share > 0.05, f"{source.GetXMLName()}: {share:.1%} of the picture show anything")
        pvs.Hide(source, view)
    other = pvs.CloudSurface(Input=pvs.Calculator(Input=wavelet, ResultArrayName="x", Function="coordsX"), ContourBy=["POINTS", "RTData"])
    display = apply(other, view)
    check(display.ColorArrayName[1] != "RTData", f"a surface of one value is coloured by {display.ColorArrayName}")
    wind = pvs.Calculator(Input=wavelet, ResultArrayName="v", Function="-coordsY*iHat+coordsX*jHat")
    texture = pvs.TextureCoordinateAdvection(Input=wind)
    check_display(apply(texture, view), "Texture Coordinate Advection", "Cell Compositing", "RTData")
    pvs.Delete(view)


def check_constant_fields():
    """A field of one value is drawn, too, be it 0."""
    for value in (0, 1):
        source = pvs.Calculator(Input=pvs.Wavelet(WholeExtent=[-3, 3] * 3), ResultArrayName="constant", Function=f"{value}+0*coordsX")
        for representation in ("Cell Compositing", "Textured Splats"):
            view = new_view(SIZE)
            compose(source, view, ("POINTS", "constant"), representation)
            pvs.ResetCamera(view)
            share = shown(view, f"constant-{value}-{representation}".replace(" ", "-"))
            check(share > 0.1, f"a field of {value}, by {representation}: {share:.1%} of the picture show anything")
            pvs.Delete(view)


def check_switched():
    """A display that becomes a medium gets an array, as it does for Volume; one colour may be chosen afterwards."""
    view = new_view(SIZE)
    for representation in ("Cell Compositing", "Textured Splats"):
        display = pvs.Show(pvs.Wavelet(WholeExtent=[-3, 3] * 3), view)
        pvs.ColorBy(display, None)  # it is an outline, which has no array
        display.Representation = representation
        check(list(display.ColorArrayName) == ["POINTS", "RTData"], f"{representation} is coloured by {list(display.ColorArrayName)}")
        pvs.ColorBy(display, None)
        check(not display.ColorArrayName[1], f"{representation} cannot have one colour")
    pvs.Delete(view)


def check_clouds_of_contours():
    """Cloud Texture of a contour is white, not blue or brown as the map has its value; an array that is chosen, and one with many values, stay."""
    view = new_view(SIZE)
    wavelet = pvs.Wavelet(WholeExtent=[-4, 4] * 3)
    contour = pvs.Contour(Input=wavelet, ContourBy=["POINTS", "RTData"], Isosurfaces=[200])
    display = pvs.Show(contour, view)
    check_display(display, "a contour", "Surface", "RTData")
    display.Representation = "Cloud Texture"
    check_display(display, "a contour", "Cloud Texture", "")
    pvs.ResetCamera(view)
    clouds = image(view)
    save_image(clouds, "FirstLook-clouds-of-contour")
    check(clouds.max() > 100 and np.ptp(clouds, axis=2).max() < 30, f"clouds of a contour have colours: channels differ by {np.ptp(clouds, axis=2).max()}")
    pvs.ColorBy(display, ("POINTS", "RTData"))
    for name in ("Surface", "Cloud Texture"):
        display.Representation = name
        check_display(display, "a contour in chosen colours", name, "RTData")
    pvs.Hide(contour, view)
    high = pvs.Elevation(Input=pvs.Sphere())
    display = pvs.Show(high, view)
    pvs.ColorBy(display, ("POINTS", "Elevation"))
    display.Representation = "Cloud Texture"
    check_display(display, "a surface of many values", "Cloud Texture", "Elevation")
    pvs.Delete(view)


def check_chosen_solid_color():
    """Who has chosen Solid Color keeps it in the other representation; who chooses an array has that again."""
    display = pvs.Show(pvs.Wavelet(), pvs.CreateRenderView())
    display.SetRepresentationType("Cell Compositing")
    check_display(display, "wavelet", "Cell Compositing", "RTData")
    pvs.ColorBy(display, None)
    for representation in ("Textured Splats", "Surface", "Cell Compositing"):
        display.SetRepresentationType(representation)
        check(not display.ColorArrayName[1], f"Solid Color becomes {display.ColorArrayName[1]} in {representation}")
    pvs.ColorBy(display, ("POINTS", "RTData"))
    pvs.ColorBy(display, None)
    pvs.ColorBy(display, ("POINTS", "RTData"))
    display.SetRepresentationType("Textured Splats")
    check_display(display, "coloured again", "Textured Splats", "RTData")


def settings_of(display, *names):
    """The mapper's settings, as it has drawn last."""
    text = str(display.SMProxy.GetProperty("TexturedSplatsVectorOpacity").GetParent().GetClientSideObject())
    return [float(re.search(rf"{name}: ([-+.e0-9]+)", text)[1]) for name in names]


def check_vector_color(display, mapper):
    """That of Python, and far from the background and from every colour of the medium."""
    colors = pvs.GetColorTransferFunction("RTData").GetClientSideObject()
    prop = vtkVolumeProperty()
    prop.SetColor(colors)
    mapper.SuitVectorColor(prop, (0, 0, 0))
    text = str(display.SMProxy.GetProperty("TexturedSplatsVectorOpacity").GetParent().GetClientSideObject())
    found = np.array(re.search(r"VectorColor: (\S+) (\S+) (\S+)", text).groups(), float)
    medium = np.array([(colors.GetRedValue(x), colors.GetGreenValue(x), colors.GetBlueValue(x)) for x in np.linspace(*colors.GetRange(), 100)] + [(0, 0, 0)])
    check(np.allclose(found, mapper.GetVectorColor()), f"streaks have the colour {found}, in Python {mapper.GetVectorColor()}")
    check(np.linalg.norm(medium - found, axis=1).min() > 0.35, f"the colour of streaks, {found}, is one of the medium")


def check_vectors():
    """Vectors suit the medium that they are chosen beside, as in Python; what is set stays."""
    source = pvs.Calculator(Input=pvs.Wavelet(WholeExtent=[-8, 8] * 3), ResultArrayName="v", Function="-coordsY*iHat+coordsX*jHat+3*kHat")
    view = new_view(SIZE)
    display = compose(source, view, representation="Textured Splats")
    display.TexturedSplatsVectorArray = "v"
    pvs.ResetCamera(view)
    suited = image(view)
    mapper = nephoscope.vtkTexturedSplatMapper()
    mapper.SetInputDataObject(servermanager.Fetch(source))
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectScalarArray("RTData")
    mapper.SetVectorArrayName("v")
    mapper.SuitVectorsToMedium()
    found = settings_of(display, "VectorOpacity", "VectorFraction", "UseVectorColor")
    expected = [mapper.GetVectorOpacity(), mapper.GetVectorShare(), 1]
    check(expected[1] < 0.9 and all(math.isclose(a, b, rel_tol=0.01) for a, b in zip(found, expected)), f"vectors: {found}, in Python {expected}")
    check_vector_color(display, mapper)
    function = pvs.GetOpacityTransferFunction("RTData")
    points = list(function.Points)
    function.Points = [value if i % 4 != 1 else 0.0 for i, value in enumerate(points)]
    image(view)
    alone = settings_of(display, "VectorOpacity", "VectorFraction", "UseVectorColor")
    check(alone[0] == 2 and math.isclose(alone[1], expected[1], rel_tol=0.01) and alone[2] == 0, f"vectors alone: {alone}")
    function.Points = points
    display.TexturedSplatsVectorOpacity, display.TexturedSplatsVectorShare, display.TexturedSplatsUseVectorColor = 1.5, 1, 0
    check(abs(image(view) - suited).mean() > 0.5, "vectors look the same whatever is set")
    check(settings_of(display, "VectorOpacity", "VectorFraction", "UseVectorColor") == [1.5, 1, 0], "what is set does not stay")
    pvs.Delete(view)


def check_opacities():
    """Arrays that begin with the colours of a preset have its opacities too."""
    view = new_view((40, 40))
    wavelet = pvs.Wavelet(WholeExtent=[-4, 4] * 3)
    for array, opacities in (("cloud_fraction", [0, 0.05, 1]), ("clwmr", [0, 0.01, 0.3, 1]), ("RTData", [0, 1])):
        compose(pvs.Calculator(Input=wavelet, ResultArrayName=array, Function="RTData"), view, ("POINTS", array), "Cell Compositing")
        points = list(pvs.GetOpacityTransferFunction(array).Points)
        scaled = [(x - points[0]) / (points[-4] - points[0]) for x in points[::4]]
        check(len(scaled) == len(opacities) and all(math.isclose(a, b, abs_tol=1e-6) for a, b in zip(scaled, opacities)),
              f"opacities of {array}: {points}")
    pvs.Delete(view)


load_plugin()
pvs._DisableFirstRenderCameraReset()
check_camera()
check_globe_camera()
check_smoke()
check_smoke_on_white()
check_filters()
check_terrain()
check_light()
check_contour_of_light()
check_follow_camera()
check_optics()
check_constant_fields()
check_vectors()
check_opacities()
check_switched()
check_clouds_of_contours()
check_chosen_solid_color()
passed()
