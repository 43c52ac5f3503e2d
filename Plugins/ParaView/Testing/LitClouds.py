# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Cloud Optics and Sunlight with nothing set, on good and bad data: a picture that shows something, or one sentence that says why not and what to do."""
from PluginTesting import GFS, check, check_same, clear, empty_view, image, listen, load_plugin, new_view, passed, pvs, set_background

SIZE = (150, 150)
BACKGROUND = (0.32, 0.34, 0.43)
messages = listen()


def sentences():
    """Without the heads of messages, which ParaView sends in lines of their own; the same one again counts once."""
    return list(dict.fromkeys(line.split("): ", 1)[1].strip() for text in messages for line in text.splitlines() if "): " in line and "vtk" in line))


def with_water(source, code):
    """`code`: the new water, of the old one `w`."""
    return pvs.ProgrammableFilter(Input=source, Script="import numpy as np\nfor n in inputs[0].PointData.keys():\n    output.PointData.append(inputs[0].PointData[n], n)\n"
                                  f"w = np.array(inputs[0].PointData['clwmr'])\noutput.PointData.append({code}, 'clwmr')")


def tells(said, words):
    """Programmable Filter replaces `all` by its own."""
    return len(said) == len(words) and not [one for word, one in zip(words, said) if word not in one]


def lit(source, **options):
    """The share of the picture that shows anything, and the sentences."""
    messages.clear()
    view = empty_view(SIZE)
    set_background(view, BACKGROUND)
    pvs.Show(pvs.Sunlight(Input=pvs.CloudOptics(Input=source), **options), view)
    pvs.ResetCamera(view)
    pvs.Render(view)
    picture = image(view)  # says nothing again
    clear(view)
    return (abs(picture - picture[0, 0]).max(axis=2) > 8).mean(), sentences()


def check_first_colours(source):
    """Light is shown by its own array, although a new display takes over the colours of its input."""
    view = new_view(SIZE, BACKGROUND)
    optics = pvs.CloudOptics(Input=source)
    pvs.ColorBy(pvs.Show(optics, view), ("POINTS", "Extinction"))
    pvs.Hide(optics, view)
    colours = pvs.Show(pvs.Sunlight(Input=optics), view).ColorArrayName
    check(colours[1] == "Sunlight", f"light is coloured by {colours[1]}")
    pvs.Delete(view)


def check_ground():
    """A surface below the mesh of lit clouds shows their shadow, without an extinction of its own."""
    messages.clear()
    view = new_view(SIZE, BACKGROUND)
    extinction = pvs.Calculator(Input=pvs.Wavelet(WholeExtent=[-10, 10, -10, 10, 5, 15]), Function="max(0, RTData - 90) * 0.01", ResultArrayName="Extinction")
    clouds = pvs.Sunlight(Input=extinction, SunDirection=[1, 0, 1])
    plane = pvs.Plane(Origin=[-20, -20, -5], Point1=[20, -20, -5], Point2=[-20, 20, -5], XResolution=50, YResolution=50)
    ground = pvs.Sunlight(Input=plane, Clouds=clouds, SunDirection=[1, 0, 1])
    colours = pvs.Show(ground, view).ColorArrayName
    (least, most), (darkest, _) = (ground.PointData[name].GetRange() for name in ("Sunlight", "SunTransmittance"))
    print(f"ground: {least:.3f} to {most:.3f}, at least {darkest:.3f} of the beam", flush=True)
    check(colours[1] == "Sunlight" and least < 0.7 and most > 0.75 and darkest < 0.4, f"the ground has {colours[1]} from {least} to {most}, {darkest} of the beam")
    check(not messages, f"{messages}")
    pvs.Delete(view)


def check_splats_follow_camera():
    """Textured Splats draw the light towards the camera of each picture as Sunlight computes it for that eye."""
    view = new_view(SIZE)
    options = {"SunDirection": [1, 0, 0.2], "OpenSides": 1}
    extinction = pvs.Calculator(Input=pvs.Wavelet(), Function="max(0, RTData - 130) * 0.005", ResultArrayName="Extinction")
    follows = pvs.Sunlight(Input=extinction, FollowCamera=1, **options)
    for eye in ([-120, 0, -24], [120, 0, 24], [20, -120, 40]):  # afar, where a splat has one colour
        view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = eye, [0, 0, 0], [0, 0, 1]
        view.CameraViewAngle = 15
        pictures = []
        for light in (follows, pvs.Sunlight(Input=extinction, UseViewPosition=1, ViewPosition=eye, **options), pvs.Sunlight(Input=extinction, **options)):
            display = pvs.Show(light, view)
            display.SetRepresentationType("Textured Splats")
            display.LookupTable.RescaleTransferFunction(0, 0.6)  # each light has its own white
            pictures.append(image(view))
            pvs.Hide(light, view)
        check_same(pictures[0], pictures[1], f"splats seen from {eye}", largest=1, mean=0.02)
        check(abs(pictures[1] - pictures[2]).max() > 20, f"the light from {eye} is the mean light")
    pvs.Delete(view)


def main():
    check_ground()
    check_splats_follow_camera()
    weather = pvs.ExtractSubset(Input=pvs.NetCDFReader(FileName=[GFS], SphericalCoordinates=0), VOI=[0, 10**6] * 3, SampleRateI=6, SampleRateJ=6, SampleRateK=2)
    globe, flat = pvs.GlobeGrid(Input=weather, VerticalExaggeration=30), pvs.GlobeGrid(Input=weather, Projection="Map", VerticalExaggeration=30)
    check_first_colours(flat)
    for name, source, options, words in (
            ("globe", globe, {}, []), ("map", flat, {}, []), ("tetrahedra of a globe", pvs.Tetrahedralize(Input=globe), {}, []),
            ("cells", pvs.PointDatatoCellData(Input=flat), {}, []),
            ("some negative water", with_water(flat, "w - 1e-6"), {}, ["below 0"]), ("some NaN", with_water(flat, "w * np.resize([np.nan, 1, 1, 1, 1], len(w))"), {}, ["missing"]),
            ("night", flat, {"SunDirection": [0, 0, -1]}, ["below the horizon"])):
        share, said = lit(source, **options)
        print(f"{name}: {share:.1%}, {said}", flush=True)
        check(share > 0.02, f"{name}: {share:.1%} of the picture show anything")
        check(tells(said, words), f"{name}: {said}")
    for name, source, words in (
            ("no water", with_water(flat, "0 * w"), ["no clouds"]), ("negative water", with_water(flat, "-w"), ["below 0", "no clouds"]),
            ("NaN", with_water(flat, "np.nan * w"), ["missing", "no clouds"]), ("g/kg", with_water(flat, "1000 * w"), ["Set Water Units to g/kg"]),
            ("no water at all", pvs.Wavelet(), ["no array of cloud water"]), ("a reader's grid", weather, ["Globe Grid first"])):
        share, said = lit(source)
        print(f"{name}: {said}", flush=True)
        check(tells(said, words), f"{name}: {said}")


load_plugin()
pvs._DisableFirstRenderCameraReset()
main()
passed()
