# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""representation_scenes.py SCENE...: every representation in ParaView, with nothing set and with its main choices, as SCENE.png.

A scene is a function that shows something in an empty view. In pvpython.
"""
import sys

from scenes_paraview import globe_grid, keep_picture, new_view, pvs

SCENES = {}


def scene(name):
    def register(fill):
        SCENES[name] = fill
        return fill
    return register


def show(source, representation, **settings):
    """Shows a source as a user would; settings without the prefix of the representation."""
    display = pvs.Show(source)
    display.SetRepresentationType(representation)
    for name, value in settings.items():
        setattr(display, representation.replace(" ", "") + name, value)
    return display


def wavelet():
    """Its first colours depend on the version of ParaView."""
    pvs.GetColorTransferFunction("RTData").ApplyPreset("Cool to Warm", True)
    return pvs.Wavelet(WholeExtent=[-8, 8] * 3)


def whirl():
    return pvs.Calculator(Input=wavelet(), ResultArrayName="wind", Function="-coordsY*iHat+coordsX*jHat+2*kHat")


def cloud():
    return pvs.CloudSurface(Input=wavelet(), ContourBy=["POINTS", "RTData"], ContourValues=[150])


# ---- Cell Compositing

@scene("representation-cells")
def cells():
    show(wavelet(), "Cell Compositing")


@scene("representation-cells-tetrahedra")
def cells_tetrahedra():
    show(pvs.Tetrahedralize(Input=wavelet()), "Cell Compositing")


@scene("representation-cells-projection")
def cells_projection():
    show(wavelet(), "Cell Compositing", Method="Cells")


@scene("representation-cells-contours")
def cells_contours():
    show(wavelet(), "Cell Compositing", ContourValues=[130, 200], ContourOpacity=0.6, OpacityScale=0.3)


@scene("representation-cells-layers")
def cells_layers():
    show(wavelet(), "Cell Compositing", ContourValues=[130, 200], LayerOpacityScales=[0, 0.2, 3])


@scene("representation-cells-solid")
def cells_solid():
    pvs.ColorBy(show(wavelet(), "Cell Compositing"), None)


@scene("representation-cells-globe")
def cells_globe():
    show(globe_grid(), "Cell Compositing")


@scene("representation-cells-divided")
def cells_divided():
    pieces = pvs.ContourCellSplitter(Input=wavelet(), ContourBy=["POINTS", "RTData"], ContourValues=[150], PolyhedralTransitions=1)
    show(pvs.PolyhedrontoTetrahedra(Input=pieces, DivideConvexPolyhedra=1), "Cell Compositing")


@scene("representation-clouds-over-the-globe")
def clouds_over_the_globe():
    clouds = pvs.CloudsovertheGlobe(Folder="Data")
    pvs.Show(clouds)
    pvs.Show(pvs.OutputPort(clouds, 1))


@scene("representation-smoke-of-polygon")
def smoke_of_polygon():
    square = pvs.Plane(Origin=[2, -1, -6], Point1=[6, -1, -6], Point2=[2, -1, -4])
    pvs.ColorBy(show(pvs.FlowVolumeFromPolygon(Input=whirl(), Polygon=square, Duration=6), "Cell Compositing"), None)


@scene("representation-smoke")
def smoke():
    pvs.ColorBy(show(pvs.FlowVolume(Input=whirl(), Center=[4, 0, -6], Radius=1.5, Duration=6), "Cell Compositing"), None)


# ---- Textured Splats

@scene("representation-splats")
def splats():
    show(wavelet(), "Textured Splats")


@scene("representation-splats-gaussian")
def splats_gaussian():
    show(wavelet(), "Textured Splats", Kernel="Gaussian")


@scene("representation-splats-streaks")
def splats_streaks():
    show(whirl(), "Textured Splats", VectorArray="wind", VectorStyle="Streaks")


@scene("representation-splats-segments")
def splats_segments():
    show(whirl(), "Textured Splats", VectorArray="wind", VectorStyle="Segments")


@scene("representation-splats-cells")
def splats_of_cells():
    show(pvs.PointDatatoCellData(Input=wavelet()), "Textured Splats")


# ---- Cloud Texture, Haze, terrain

@scene("representation-clouds")
def clouds():
    show(cloud(), "Cloud Texture")


@scene("representation-clouds-thickness")
def clouds_thickness():
    show(cloud(), "Cloud Texture", UseThickness=1)


@scene("representation-clouds-paper")
def clouds_paper():
    show(cloud(), "Cloud Texture", Waves="Paper")


@scene("representation-haze")
def haze():
    pvs.Show(pvs.Sphere(Radius=6371000, ThetaResolution=90, PhiResolution=60))
    pvs.Show(pvs.Haze())


@scene("representation-sun")
def sun():
    """vtkSunSource: one sun, from the right, for a cloud, the ground and a ball."""
    cloud = pvs.Calculator(Input=pvs.Wavelet(WholeExtent=[-8, 8] * 3), ResultArrayName="Extinction", Function="0.004*(RTData-150)*(sign(RTData-150)+1)")
    pvs.Show(pvs.Plane(Origin=[-14, -10, -9], Point1=[14, -10, -9], Point2=[-14, 10, -9]))
    pvs.Show(pvs.Sphere(Center=[-10, 0, -6], Radius=3, ThetaResolution=40, PhiResolution=40))
    pvs.Show(pvs.Sunlight(Input=cloud))
    pvs.Show(pvs.Sun(SunDirection=[3, -1, 2]))
    view = pvs.GetActiveView()
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [0, -60, 15], [0, 0, -2], [0, 0, 1]


@scene("representation-terrain")
def terrain():
    """Before black, where 2 % less colour is 2 % less light."""
    pvs.GetActiveView().Background = [0, 0, 0]
    reader = pvs.NetCDFReader(FileName=["Data/gfs_2p5deg_2011101100.nc"], SphericalCoordinates=0, Dimensions="(lat, lon)")
    pvs.Show(pvs.GlobeTerrain(Input=reader))


def main(chosen):
    for name in chosen:
        view = new_view()
        SCENES[name]()
        keep_picture({}, name + ".png")
        pvs.Delete(view)
        for source in list(pvs.GetSources().values()):
            pvs.Delete(source)
        print(f"wrote {name}.png", flush=True)


if __name__ == "__main__":
    main(sys.argv[1:])
