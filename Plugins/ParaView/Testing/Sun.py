# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""One Sun in ParaView: it lights all Sunlight filters, the surfaces and the haze of its view, from a direction or a date; states keep it."""
import os

import numpy as np
from paraview import smstate
from PluginTesting import OUTPUT, check, check_same, image, listen, load_plugin, new_view, passed, pvs, solid

EXTENT = [-4, 4] * 3


def cloud():
    """It reaches the sides of the data, which Sunlight warns about."""
    return pvs.Calculator(Input=pvs.Wavelet(WholeExtent=EXTENT), ResultArrayName="Extinction", Function="0.2+0*coordsX")


def sun_of(light):
    pvs.UpdatePipeline(proxy=light)
    return np.array([light.FieldData["SunDirection"].GetRange(c)[0] for c in range(3)])


def check_sun(light, expected, what):
    found = sun_of(light)
    check(np.allclose(found, np.divide(expected, np.linalg.norm(expected)), atol=1e-6), f"{what}: the sun is at {found}, not {expected}")


def ball_view(radius=10.0):
    """A white ball, seen from +y, z up: brightness left (+x), right (-x), top."""
    view = new_view((90, 90))
    display = pvs.Show(pvs.Sphere(Radius=radius, ThetaResolution=60, PhiResolution=60), view)
    solid(display, [1, 1, 1])
    display.Ambient, display.Specular = 0.0, 0.0
    pvs.Render(view)  # the first one resets the camera
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [0, 5 * radius, 0], [0, 0, 0], [0, 0, 1]
    return view


def brightness(view):
    picture = image(view).mean(axis=2)
    return picture[45, 25], picture[45, 65], picture[65, 45]


def check_one_change_moves_all():
    """Suns made before and after the filters are their input; one with a sun keeps it."""
    first = pvs.Sunlight(Input=cloud())
    sun = pvs.Sun(SunDirection=[0, 3, 4])
    second = pvs.Sunlight(Input=cloud())
    for light in (first, second):
        check(light.Sun is not None, "a Sunlight filter has no sun")
        check_sun(light, (0, 3, 4), "made")
    sun.SunDirection = [1, 0, 1]
    for light in (first, second):
        check_sun(light, (1, 0, 1), "moved")
    other = pvs.Sun(SunDirection=[0, 0, 1])
    check_sun(first, (1, 0, 1), "another sun")
    third = pvs.Sunlight(Input=cloud())
    check_sun(third, (0, 0, 1), "the latest sun")
    for one in (first, second, third, sun, other):
        pvs.Delete(one)
    check_sun(pvs.Sunlight(Input=cloud()), (1, -1, 1), "without a sun")


def check_deleted():
    """A filter whose sun a script deletes has its own direction again."""
    sun = pvs.Sun(SunDirection=[0, 3, 4])
    light = pvs.Sunlight(Input=cloud())
    check_sun(light, (0, 3, 4), "made")
    pvs.Delete(sun)
    check(light.Sun is None, "the deleted sun shines")
    light.SunDirection = [1, 0, 1]
    check_sun(light, (1, 0, 1), "after the sun")
    pvs.Delete(light)


def check_light_of_view():
    view, other = ball_view(), ball_view()
    for one in (view, other, view, other):
        image(one)  # edges are smooth from the second view's picture on
    plain_other, plain = image(other), image(view)
    sun = pvs.Sun(SunDirection=[1, 0, 0])
    display = pvs.Show(sun, view)
    left, right, _ = brightness(view)
    check(left > 2 * right and right > 2, f"with the sun on the left, the ball has {left:.0f} there and {right:.0f} on the right")
    sun.SunDirection = [-1, 0, 0]
    left, right, _ = brightness(view)
    check(right > 2 * left, f"with the sun on the right, the ball has {right:.0f} there and {left:.0f} on the left")
    check(40 < left < 0.35 * right, f"by default the night has {left:.0f} of 255, the day {right:.0f}")
    display.FillLight = 0.0
    check(brightness(view)[0] < 2, "the night is not black without fill light")
    display.Intensity = 0.0
    check(image(view).max() < 2, "there is light without a sun")
    pvs.Hide(sun, view)
    check_same(image(view), plain, "hidden sun")
    pvs.Show(sun, view)
    display.Intensity = 1.0
    check(brightness(view)[1] > 100, "the sun that is shown again does not shine")
    check_same(image(other), plain_other, "another view")
    pvs.Delete(sun)
    check_same(image(view), plain, "deleted sun")
    pvs.Delete(view)
    pvs.Delete(other)


def check_haze():
    """Haze takes the sun of the view, unless it has one."""
    view = ball_view()
    haze = pvs.Show(pvs.Haze(), view)
    haze.Projection, haze.VisualRange, haze.ScaleHeight = "Map", 60.0, 20.0
    plain = image(view)
    haze.SunDirection = [1.0, 0.0, 1.0]
    expected = image(view)
    check(np.abs(expected - plain).mean() > 3, "haze does not change with its sun")
    haze.SunDirection = [0.0, 0.0, 0.0]
    sun = pvs.Sun(SunDirection=[1, 0, 1])
    pvs.Show(sun, view)
    sky = image(view)[80:, :10]  # no ball there, whose light is another
    check_same(sky, expected[80:, :10], "haze in the sun of the view")
    pvs.Hide(sun, view)
    check_same(image(view), plain, "haze without sun")
    pvs.Delete(view)


def check_date():
    """At noon in Greenwich the sun is over the Atlantic on a globe, and in the south of a place in Europe."""
    sun = pvs.Sun(DateTime="2011-03-20 12:00", Longitude=0, Latitude=45)
    view = ball_view()
    pvs.Show(sun, view).FillLight = 0.1
    north = brightness(view)
    view.CameraPosition = [0, -50, 0]
    south = brightness(view)
    check(north[2] < 30 and south[2] > 200, f"a sun in the south gives the top of a ball {north[2]:.0f} in the north, {south[2]:.0f} in the south")
    globe = pvs.CloudsovertheGlobe()
    pvs.Show(pvs.OutputPort(globe, 1), view)
    clouds = pvs.Show(globe, view)
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [0, -3e7, 0], [0, 0, 0], [0, 0, 1]
    clouds.Opacity = 0.0
    left, right, _ = brightness(view)
    check(right > 2 * left, f"at noon in Greenwich America, on the left, has {left:.0f}, the Atlantic {right:.0f}")
    sun.HoursLater = 12
    later, gone, _ = brightness(view)
    check(later > 2 * gone, f"twelve hours later the left has {later:.0f}, the right {gone:.0f}")
    pvs.Delete(view)
    pvs.Delete(sun)


def inside(view):
    return image(view)[25:65, 25:65]  # of the ball: edges differ between first and later pictures of ParaView


def reloaded(kind):
    """The sources by their names, after a state file of this kind."""
    file = os.path.join(OUTPUT, "sun.pvsm")
    pvs.SaveState(file)
    script = smstate.get_state() if kind == ".py" else ""
    pvs.ResetSession()
    if script:
        exec(script, {"__name__": "__main__"})
    else:
        pvs.LoadState(file)
    return {source.GetXMLName(): source for source in pvs.GetSources().values()}


def check_states():
    """State files of both kinds: the sun is that of the filter and of the view, and one change moves both."""
    for kind in (".pvsm", ".py"):
        drawn = kind == ".pvsm"  # in a third session ParaView 5.11 has errors of OpenGL, with any plugin or without
        pvs.ResetSession()
        view = ball_view() if drawn else pvs.CreateRenderView()
        light = pvs.Sunlight(Input=cloud())
        sun = pvs.Sun(SunDirection=[1, 0, 0])
        pvs.Show(sun, view)
        pvs.Show(light, view)
        saved = inside(view) if drawn else None
        found = reloaded(kind)
        check(found["Sunlight"].Sun is not None, f"{kind}: the filter has lost its sun")
        check("Sun" in {shown.Input.GetXMLName() for shown in pvs.GetRenderViews()[0].Representations}, f"{kind}: the view has lost its sun")
        if drawn:
            view = pvs.GetRenderViews()[0]
            view.ViewSize = [90, 90]
            check_same(inside(view), saved, f"state {kind}", largest=1, mean=0.05)
        found["Sun"].SunDirection = [0, 0, 1]
        check_sun(found["Sunlight"], (0, 0, 1), kind)
        check(not drawn or np.abs(inside(view) - saved).mean() > 3, f"{kind}: the light of the view does not follow the sun")


def check_volumes_without_light(messages):
    """A sun beside volumes none of which is lit: one sentence, however often they are drawn. Beside surfaces, or lit volumes, none."""
    view = new_view((60, 60))
    sun = pvs.Sun()
    pvs.Show(sun, view)
    pvs.Show(pvs.Sphere(), view)
    pvs.Render(view)
    check(not messages, f"beside a surface: {messages}")
    display = pvs.Show(cloud(), view)
    for representation in ("Cell Compositing", "Textured Splats"):
        display.SetRepresentationType(representation)
        pvs.Render(view)
        pvs.Render(view)
    check(len(messages) == 1 and "no volume in this view" in messages[0] and all(words in messages[0] for words in ("For clouds apply Cloud Optics", "apply Sunlight alone", "hide the Sun")), f"beside plain cells: {messages}")
    messages.clear()
    pvs.Show(pvs.Sunlight(Input=cloud(), PeriodicSides=True), view).SetRepresentationType("Cell Compositing")
    pvs.Render(view)
    check(not messages, f"beside lit cells: {messages}")
    pvs.Delete(view)
    pvs.Delete(sun)


messages = listen()
load_plugin()
check_volumes_without_light(messages)
check_one_change_moves_all()
check_deleted()
check_light_of_view()
check_haze()
check_date()
check_states()
others = [message for message in messages if "Clouds reach the sides" not in message]
check(not others, f"messages: {others}")
passed()
