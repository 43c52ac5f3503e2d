# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The reader "Weather data" in ParaView, on a GRIB file of three times that the Python of the tests writes: arrays, levels, times, messages."""
import os
import subprocess
import sys
import tempfile

from paraview import servermanager
from paraview.simple import CloudOptics, CreateRenderView, Delete, OpenDataFile, Render, Show, UpdatePipeline
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow

PYTHON = os.environ["NEPHOSCOPE_PYTHON"]
WRITE = """
import sys
from weather_data import REGULAR, write_grib
fields = [(name, "isobaricInhPa", level, value + day, {"dataDate": 20200101 + day}) for day in range(3) for level, z in ((850, 1500), (500, 5500), (200, 12000))
          for name, value in (("gh", z), ("t", 250), ("cc", 0.5))]
write_grib(sys.argv[1], fields, REGULAR)
"""
WRITE_HYBRID = """
import sys
import numpy as np
import xarray
axes = {"lat": ("lat", np.arange(-60.0, 61, 20), {"units": "degrees_north"}), "lon": ("lon", np.arange(0.0, 360, 30), {"units": "degrees_east"})}
level = ("lev", [0.9, 0.5, 0.2], {"standard_name": "atmosphere_sigma_coordinate", "axis": "Z", "formula_terms": "sigma: lev ps: ps ptop: ptop", "positive": "down"})
xarray.Dataset({"cl": (("lev", "lat", "lon"), np.full((3, 7, 12), 0.5, "f4"), {"standard_name": "cloud_area_fraction_in_atmosphere_layer", "units": "1"}),
                "ps": (("lat", "lon"), np.full((7, 12), 1e5, "f4"), {"standard_name": "surface_air_pressure", "units": "Pa"}), "ptop": ((), 0.0, {"units": "Pa"})},
               coords={**axes, "lev": level}).to_netcdf(sys.argv[1])
"""


def files(folder):
    """Files that cannot be read: name, and what is told in ParaView's words."""
    contents = {"empty.nc": (b"", "is empty: copy or download"), "mesh.vtu": (b"<VTKFile type='UnstructuredGrid'>", "is a mesh. Open it with one of ParaView's own readers."),
                "gfs.grib2.gz": (b"\x1f\x8b\x08" + bytes(20), "compressed by gzip. Unpack it: gunzip gfs.grib2.gz."), "a.nc": (bytes(range(40)), "neither GRIB nor NetCDF nor Zarr"),
                "p.tif": (b"II*\0" + bytes(9), "GeoTIFF. Convert it to NetCDF"), "table.csv": (b"lat,lon\n1,2\n", "ParaView's reader of delimited text")}
    for name, (content, words) in contents.items():
        with open(os.path.join(folder, name), "wb") as file:
            file.write(content)
        yield name, words
    os.mkdir(os.path.join(folder, "some"))
    yield from (("nothing.nc", "There is no file"), ("some", "is a folder, and no Zarr store: choose a file in it."))


def refused(read, path, words):
    try:
        read(path)
    except RuntimeError as problem:
        assert words in str(problem) and "pyvista" not in str(problem) and "pip" not in str(problem), problem
    else:
        raise AssertionError(f"{path} was read")


def told(reader, path, folder, window):
    """What the window says of a file that is not whole, and of a Python that is not there."""
    broken = os.path.join(folder, "broken.grib2")
    with open(path, "rb") as whole, open(broken, "wb") as part:
        part.write(whole.read()[:-100])
    reader.FileName = broken
    reader.UpdatePipelineInformation()
    assert "26 complete fields" in window.GetOutput(), window.GetOutput()
    from nephoscope.weather.paraview_reader import check, read
    for attempt in (lambda: read(broken), lambda: check(reader)):  # a script sees what the window tells
        try:
            attempt()
        except RuntimeError as problem:
            assert "26 complete fields" in str(problem), problem
        else:
            raise AssertionError("a file that is not whole was read")
    reader.FileName = path
    assert check(reader) is reader and reader.GetDataInformation().GetNumberOfPoints() > 0
    os.environ["NEPHOSCOPE_PYTHON"] = "/nowhere/python3"  # so the files are looked at before Python starts
    for name, words in files(folder):
        refused(read, os.path.join(folder, name), words)
    view = CreateRenderView()
    Show(globals()["WeatherDataReader"](FileName=path), view)
    Render(view)
    assert "Nothing is drawn" not in window.GetOutput(), window.GetOutput()  # the reader has told why
    Delete(view)
    assert "/nowhere/python3" in window.GetOutput() and "export NEPHOSCOPE_PYTHON=" in window.GetOutput(), window.GetOutput()


def warned(folder, window):
    """What was assumed is told once, with what a user of ParaView can do; a reader with another file starts anew."""
    path = os.path.join(folder, "clouds.nc")
    subprocess.run([PYTHON, "-c", WRITE_HYBRID, path], check=True)
    before = window.GetOutput()
    reader = globals()["WeatherDataReader"](FileName=path)
    for levels in ([0, 2], [0, 1]):
        reader.Levels = levels
        reader.UpdatePipeline()
    words = window.GetOutput()[len(before):]
    assert words.count("No temperature was found on the levels 'lev'") == 1, words
    assert f"(In ParaView: do that in Python, with ds = nephoscope.open({path!r})" in words and "save('globe.vtk')" in words, words
    Delete(reader)


def known_to_the_dialog(path):
    """What File > Open asks: which readers there are for a name. A GRIB file has this one alone. Its clouds are drawn as a volume, and one level as a surface."""
    factory = servermanager.vtkSMProxyManager.GetProxyManager().GetReaderFactory()
    factory.UpdateAvailableReaders()  # which the window does
    session = servermanager.ActiveConnection.Session
    for name in ("a.grib2", "a.grb", "a.nc", "a.zarr", ".zmetadata", "wrfout_d01_2020-01-01_00_00_00"):
        readers = factory.GetPossibleReaders(os.path.join(os.path.dirname(path), name), session)
        assert "WeatherDataReader" in [readers.GetString(i) for i in range(readers.GetNumberOfStrings())], name
    reader = OpenDataFile(path)
    assert reader.GetXMLName() == "WeatherDataReader", reader
    display = Show(reader)
    assert (display.Representation, display.ColorArrayName[1]) == ("Cell Compositing", "cc"), (display.Representation, display.ColorArrayName)
    extent = reader.GetDataInformation().GetExtent()
    assert list(reader.Levels) == [0, extent[5]] and extent[5] > 0, (list(reader.Levels), extent)  # the panel shows those of the file
    reader.Levels = [1, 1]
    assert Show(reader, CreateRenderView()).Representation == "Surface"
    Delete(reader)


def computed(reader):
    """Derived quantities are read if they are chosen. Cloud Optics makes clouds from the water of a cloud fraction."""
    known = reader.Variables.Available
    assert {"potential_temperature", "cloud_content"} <= set(known) and "cloud_content" not in reader.Variables, known
    reader.Variables = ["t", "cc", "cloud_content"]
    optics = CloudOptics(Input=reader, TotalWaterArray="cloud_content")
    optics.UpdatePipeline(0.0)
    water, extinction = (optics.PointData[name].GetRange() for name in ("cloud_content", "Extinction"))
    assert 0 < water[0] < water[1] < 0.5 * 0.21e-3 and 0 < extinction[0] < extinction[1], (water, extinction)
    assert "potential_temperature" not in optics.PointData.keys()
    Delete(optics)


def main():
    if not os.path.exists(PYTHON) or subprocess.run(
            [PYTHON, "-c", "import importlib.util as u, sys; sys.exit(None in map(u.find_spec, ('pyvista', 'xarray', 'eccodes')))"]).returncode:
        print("Skipped: the packages for weather data are not there")
        sys.exit(125)
    from nephoscope.weather.paraview_reader import load
    load(globals())
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "forecast.grib2")
        subprocess.run([PYTHON, "-c", WRITE, path], check=True)
        known_to_the_dialog(path)
        reader = globals()["WeatherDataReader"](FileName=path)
        assert list(reader.TimestepValues) == [0, 24, 48], reader.TimestepValues
        UpdatePipeline(time=24.0, proxy=reader)
        information = reader.GetDataInformation()
        assert information.GetDataSetTypeAsString() == "vtkStructuredGrid" and information.GetNumberOfPoints() == 37 * 19 * 3, information.GetNumberOfPoints()
        assert reader.PointData["t"].GetRange() == (251, 251), reader.PointData["t"].GetRange()
        reader.Levels = [1, 2]
        reader.Variables = ["gh"]
        UpdatePipeline(time=0.0, proxy=reader)
        assert reader.GetDataInformation().GetNumberOfPoints() == 37 * 19 * 2 and "t" not in reader.PointData.keys()
        computed(reader)
        usual, window = vtkOutputWindow.GetInstance(), vtkStringOutputWindow()
        vtkOutputWindow.SetInstance(window)
        try:
            warned(folder, window)
            told(reader, path, folder, window)
        finally:
            vtkOutputWindow.SetInstance(usual)  # what is printed goes there too
        Delete(reader)
    print("NEPHOSCOPE-PASSED")


main()
