# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Sparse volumes in ParaView: File > Save Data writes .vdb files, File > Open reads them, a series too; the first picture.

With the path of a file it writes that file, or tells how many points all ranks together read from it: SparseVolumeRanks.py.
"""
import os
import sys

import nephoscope
import numpy as np
from PluginDefinitions import compare_default, definition, nested, own_properties
from PluginTesting import (OUTPUT, check, check_same, color_and_alpha, image, inside_mean_alpha, load_plugin, look, new_view, passed, pvs,
                           servermanager)
from vtkmodules.util.numpy_support import vtk_to_numpy

FILE = os.path.join(OUTPUT, "SparseVolume.vdb")


def check_definitions():
    for group, name, class_ in (("internal_sources", "SparseVolumeReaderCore", nephoscope.vtkSparseVolumeReader),
                                ("writers", "SparseVolumeWriter", nephoscope.vtkSparseVolumeWriter)):
        for key, element in own_properties(definition(group, name)).items():
            if hasattr(class_, "Get" + key) and element.GetAttribute("default_values"):
                compare_default(name, key, element, getattr(class_(), "Get" + key)())
            check(nested(element, "Documentation") or element.GetAttribute("information_only"), f"{name}.{key} has no help")
        for key in ("OutputType", "SplitTiles", "MemoryLimit", "Tolerance", "Precision", "Compression", "VoxelSize"):
            check(not hasattr(class_, "Set" + key) or key in own_properties(definition(group, name)), f"{name} lacks {key}")


def density():
    """Something in the middle of an image, nothing around it."""
    return pvs.Calculator(Input=pvs.Wavelet(), ResultArrayName="smoke", Function="max(RTData-150,0)")


def values_of(proxy, name):
    proxy.UpdatePipeline()
    return vtk_to_numpy(servermanager.Fetch(proxy).GetPointData().GetArray(name))


def check_writing_and_reading():
    source = density()
    pvs.SaveData(FILE, proxy=source, Arrays=["smoke"], GridNames=["smoke", "density"])
    reader = pvs.OpenDataFile(FILE)
    check(reader.GetXMLName() == "SparseVolumeReader", f"File > Open takes {reader.GetXMLName()}")
    expected = values_of(source, "smoke")
    found = values_of(reader, "density")
    check(np.array_equal(np.sort(found), np.sort(expected[expected > 0])), "not the values that were written")
    check(list(reader.PointData.keys()) == ["density"], f"arrays {list(reader.PointData.keys())}")
    reader.OutputType = "Image"
    reader.UpdatePipeline()
    information = reader.GetDataInformation()
    check(information.GetDataSetTypeAsString() == "vtkImageData", "Output Type does not arrive")
    check(abs(values_of(reader, "density").sum() / expected.sum() - 1) < 1e-6, "the image is not that of the points")
    pvs.Delete(reader)


def check_grids():
    path = os.path.join(OUTPUT, "SparseVolumeGrids.vdb")
    pvs.SaveData(path, proxy=density(), Precision="16 Bits", Compression="None", Tolerance=10)
    reader = pvs.OpenDataFile(path)
    check(list(reader.GetProperty("Grids").GetAvailable()) == ["RTData", "smoke"], f"{reader.GetProperty('Grids').GetAvailable()}")
    reader.Grids = ["smoke"]
    check(values_of(reader, "smoke").min() > 10, "Tolerance does not arrive")
    check(list(reader.PointData.keys()) == ["smoke"], "the choice of grids does not arrive")
    plain = os.path.getsize(path)
    pvs.SaveData(path, proxy=density(), Tolerance=10)
    check(os.path.getsize(path) != plain, "Precision or Compression does not arrive")


def check_series():
    names = [os.path.join(OUTPUT, f"SparseVolumeSeries_{i:02}.vdb") for i in range(3)]
    for i, name in enumerate(names):
        moved = pvs.Calculator(Input=pvs.Wavelet(), ResultArrayName="density", Function=f"max(RTData-{100 + 40 * i},0)")
        pvs.SaveData(name, proxy=moved, Arrays=["density"])
    reader = pvs.OpenDataFile(names)
    check(len(reader.TimestepValues) == 3, f"times {reader.TimestepValues}")
    counts = []
    for time in reader.TimestepValues:
        reader.UpdatePipeline(time)
        counts.append(reader.GetDataInformation().GetNumberOfPoints())
    check(counts[0] > counts[1] > counts[2] > 0, f"{counts} points over time")


def check_first_picture():
    """Nothing is set; and the points look as the image that they come from does in the same representation."""
    view = new_view()
    display = pvs.Show(pvs.OpenDataFile(FILE), view)
    check(display.Representation in ("Textured Splats", "'Textured Splats'"), f"comes up as {display.Representation}")
    look(view)
    mean = inside_mean_alpha(color_and_alpha(view)[1])
    print(f"first picture: mean alpha {mean:.3f}", flush=True)
    check(0.25 < mean < 0.97, f"mean alpha {mean:.3f}")
    # Points at the end of an image have half a cell, voxels a whole one: in the empty space around a cloud that makes no difference.
    inside = " & ".join(f"(abs(coords{axis}) < 9.5)" for axis in "XYZ")
    cloud = pvs.Calculator(Input=pvs.Wavelet(), ResultArrayName="density", Function=f"if({inside}, max(RTData-100,0), 0)")
    path = os.path.join(OUTPUT, "SparseVolumePicture.vdb")
    pvs.SaveData(path, proxy=cloud, Arrays=["density"], GridNames=["density"])
    pictures = []
    for source in (pvs.OpenDataFile(path), cloud):
        view = new_view()
        display = pvs.Show(source, view)
        display.SetRepresentationType("Textured Splats")
        pvs.ColorBy(display, ("POINTS", "density"))
        for function in (pvs.GetColorTransferFunction("density"), pvs.GetOpacityTransferFunction("density")):
            function.RescaleTransferFunction(0, 120)  # the image has zeros, the points have none
        display.TexturedSplatsAutomaticUnitDistance = 0
        display.TexturedSplatsUnitDistance = 10
        look(view)
        pictures.append(image(view))
    check(pictures[0].mean() > 3, "nothing is drawn")
    check_same(*pictures, "points and image", largest=1, mean=0.05)


def check_particles():
    path = os.path.join(OUTPUT, "SparseVolumeParticles.vdb")
    particles = pvs.PointSource(NumberOfPoints=500, Radius=10)
    pvs.SaveData(path, proxy=particles, VoxelSize=4)
    total = values_of(pvs.OpenDataFile(path), "density").sum() * 4 ** 3
    check(abs(total / 500 - 1) < 1e-5, f"{total} particles of 500")


def check_not_offered():
    """What cannot be written is not offered."""
    factory = servermanager.vtkSMProxyManager.GetProxyManager().GetWriterFactory()
    for source, expected in ((pvs.Wavelet(), True), (pvs.Transform(Input=pvs.Wavelet()), False)):
        source.UpdatePipeline()
        offered = "vdb" in factory.GetSupportedFileTypes(source.SMProxy, 0)
        check(offered == expected, f".vdb is {'' if offered else 'not '}offered for {source.GetXMLName()}")


def count(path):
    """Points of all ranks together, as points and as an image."""
    reader = pvs.OpenDataFile(path)
    for kind in ("Points", "Image"):
        reader.OutputType = kind
        reader.UpdatePipeline()
        print(f"COUNT {reader.GetDataInformation().GetNumberOfPoints()}", flush=True)


def check_state():
    pvs.ResetSession()
    load_plugin()
    reader = pvs.OpenDataFile(FILE)
    reader.MemoryLimit = 2
    state = os.path.join(OUTPUT, "SparseVolume.pvsm")
    pvs.SaveState(state)
    pvs.ResetSession()
    load_plugin()
    pvs.LoadState(state)
    found = [p for p in pvs.GetSources().values() if p.GetXMLName() == "SparseVolumeReader"]
    check(len(found) == 1 and found[0].MemoryLimit == 2 and list(found[0].FileName) == [FILE], "the reader is not in the state")


if not nephoscope.vtkSparseVolumeReader.HasOpenVDB():
    load_plugin()
    manager = servermanager.ProxyManager().GetProxyDefinitionManager()
    check(not manager.HasDefinition("sources", "SparseVolumeReader"), "a build without OpenVDB offers to read .vdb files")
    passed()
    sys.exit()
load_plugin()
if len(sys.argv) > 1:
    count(sys.argv[1]) if os.path.exists(sys.argv[1]) else pvs.SaveData(sys.argv[1], proxy=density(), Arrays=["smoke"])
    passed()
    sys.exit()
check_definitions()
check_writing_and_reading()
check_grids()
check_series()
check_first_picture()
check_particles()
check_not_offered()
check_state()
passed()
