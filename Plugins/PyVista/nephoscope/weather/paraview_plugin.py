# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""A plugin of ParaView: the reader "Weather data (GRIB, Zarr, NetCDF, WRF, MPAS, ICON)".

The compiled plugin has the reader: weather_data_reader.xml names the class below. Where there is no compiled plugin, load this file in Tools > Manage Plugins > Load New. A separate
process, run by the Python that NEPHOSCOPE_PYTHON names, calls `nephoscope.open` (worker.py). If a Python package that the file needs is missing there, the message has the command that
installs it.
"""
import importlib
import importlib.util
import json
import os
import subprocess
import sys
import tempfile

from vtkmodules.vtkCommonCore import vtkDataArraySelection, vtkOutputWindow, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkUnstructuredGrid
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as SDDP
from vtkmodules.vtkIOLegacy import vtkDataSetReader
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase

NAME_ANOTHER = ("The environment variable NEPHOSCOPE_PYTHON names the Python that reads the data; set it before ParaView starts, or pvserver where a server reads the data, "
                "for example export NEPHOSCOPE_PYTHON=/opt/python/bin/python.")
MADE = "~/nephoscope-python/bin/python"  # by the command in the message
FOLDER = os.path.dirname(os.path.abspath(__file__))
DEFINITION = os.path.join(FOLDER, "weather_data_reader.xml")


def _neighbour(name):
    """A file next to this one, as a module of a separate package: ParaView may have loaded this file alone, without nephoscope."""
    package = "nephoscope_weather"
    if package not in sys.modules:
        found = importlib.util.spec_from_file_location(package, os.path.join(FOLDER, "__init__.py"), submodule_search_locations=[FOLDER])
        sys.modules[package] = importlib.util.module_from_spec(found)
    return importlib.import_module(f"{package}.{name}")


def interpreter():
    """The Python that has the packages: NEPHOSCOPE_PYTHON, the environment of ./nephoscope, the one that the message makes, or python3."""
    own = os.path.join(os.environ.get("NEPHOSCOPE_VENV", ""), "bin", "python3")
    there = [path for path in (own, os.path.expanduser(MADE)) if os.path.isabs(path) and os.path.exists(path)]
    return os.environ.get("NEPHOSCOPE_PYTHON") or next(iter(there), "python3")


def missing_packages(python, path):
    """What to do about packages that the file needs and `python` lacks; empty if none is missing. Raises a RuntimeError if the file cannot be read."""
    files = _neighbour("paraview_files")
    needed = files.packages(path)
    probe = f"import importlib.util as u; print(*[n.split('|')[0] for n in {needed!r} if not any(map(u.find_spec, n.split('|')))])"
    try:
        told = subprocess.run([python, "-c", probe], capture_output=True, text=True)
    except OSError as problem:
        told = subprocess.CompletedProcess([], 1, "", str(problem))
    if told.returncode != 0:
        return f"The Python {python} does not run: {told.stderr.strip()[-200:]}. {NAME_ANOTHER}"
    missing = told.stdout.split()
    if not missing:
        return ""
    kind = files.file_format(path).split()[-1]
    without = files.own_reader(path) if kind == "NetCDF" else ""
    return (f"The reader needs Python packages for {kind} that {python} does not have: {', '.join(missing)}. {without + ' Or install' if without else 'Install'} them, "
            f"and open the file again: {_command(python, kind, missing)}\n{NAME_ANOTHER}")


def _command(python, kind, missing):
    """What installs the packages of a format; by their names where this file alone was loaded, into a ParaView without the package."""
    try:
        from nephoscope.samples import requirements
    except ImportError:
        names = {**dict.fromkeys(("nephoscope", "pyvista"), "'nephoscope[pyvista]'"), "eccodes": "eccodes eccodeslib"}
        return " ".join([python, "-m pip install", *dict.fromkeys(names.get(name, name) for name in missing)])
    command, own, _ = requirements(*["requirements.txt"] * ("pyvista" in missing), f"requirements-{kind.lower()}.txt", options="--no-deps ", python=python).partition(", and use")
    return command + (", and unset NEPHOSCOPE_PYTHON" if own and "NEPHOSCOPE_PYTHON" in os.environ else "")


class Process:
    """The worker process, started at the first request."""

    def __init__(self):
        self._process = None

    def ask(self, **request):
        if self._process is None or self._process.poll() is not None:
            self._start()
        self._process.stdin.write(json.dumps(request) + "\n")
        self._process.stdin.flush()
        line = self._process.stdout.readline()
        if not line:
            raise RuntimeError("the process that reads weather data has ended.")
        answer = json.loads(line)
        if "error" in answer:
            raise RuntimeError(answer["error"])
        return answer

    def _start(self):
        self._process = subprocess.Popen([interpreter(), "-m", "nephoscope.weather.worker"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)


class WeatherDataReader(VTKPythonAlgorithmBase):
    """Reads one time step of a weather file onto a globe or a map."""

    def __init__(self):
        super().__init__(nInputPorts=0, nOutputPorts=1, outputType="vtkDataSet")
        self._settings = {"path": None, "mesh": None, "grid": -1, "levels": (0, 100000), "globe": {"projection": "globe", "vertical_exaggeration": 30.0, "radius": 6371000.0}}
        self._process, self._folder = Process(), tempfile.TemporaryDirectory()
        self._problem, self._told = "", set()
        self._is_open, self._times, self._first, self._last_level = False, None, None, 100000
        self._selection = vtkDataArraySelection()
        self._selection.AddObserver("ModifiedEvent", lambda *_: self._changed(False))

    def _ask(self, **request):
        """The answer of the worker, whose warnings are shown once for each file."""
        answer = self._process.ask(**request)
        for text in answer["warnings"]:
            if text not in self._told:
                self._told.add(text)
                vtkOutputWindow.GetInstance().DisplayWarningText(f"Weather data: {text}\n")
        return answer

    def _set(self, key, value, reopen=False):
        if self._settings[key] != value:
            self._settings[key] = value
            self._changed(reopen)

    def _changed(self, reopen):
        self._first = None
        if reopen:
            self._is_open = False
            self._told.clear()
        self.Modified()

    def SetFileName(self, path):
        self._set("path", None if path in (None, "", "None") else path, True)

    def SetMeshFileName(self, path):
        self._set("mesh", None if path in (None, "", "None") else path, True)

    def SetGridNumber(self, number):
        """Number of the grid, from 0, in a GRIB file with several grids; -1: the only one."""
        self._set("grid", number, True)

    def SetLevels(self, first, last):
        """First and last level to read, counted from 0 in the file's order."""
        self._set("levels", (first, last))

    def SetProjection(self, projection):
        self._set("globe", {**self._settings["globe"], "projection": "map" if projection else "globe"})

    def SetVerticalExaggeration(self, factor):
        self._set("globe", {**self._settings["globe"], "vertical_exaggeration": factor})

    def SetPlanetRadius(self, radius):
        self._set("globe", {**self._settings["globe"], "radius": radius})

    def GetLevelRange(self):
        """First and last level of the file."""
        return (0, self._last_level)

    def GetVariables(self):
        return self._selection

    def GetProblem(self):
        """Why the last reading failed; empty if it did not."""
        return self._problem

    def GetTimestepValues(self):
        return None if self._times is None else list(self._times)

    # The pipeline

    def _open(self):
        path, grid = self._settings["path"], self._settings["grid"]
        path = path[:-len("/.zmetadata")] if path.endswith("/.zmetadata") else path
        for file in filter(None, (self._settings["mesh"], path)):
            if problem := missing_packages(interpreter(), file):
                raise RuntimeError(problem)
        found = self._ask(do="open", path=path, mesh=self._settings["mesh"], grid=None if grid < 0 else grid)
        for name in {self._selection.GetArrayName(i) for i in range(self._selection.GetNumberOfArrays())} - {*found["variables"], *found["computed"]}:  # of an earlier file
            self._selection.RemoveArrayByName(name)
        for name in (*found["variables"], *found["computed"]):
            if not self._selection.ArrayExists(name):
                self._selection.AddArray(name, name in found["variables"])  # derived quantities are off until they are chosen
        self._times, self._last_level, self._is_open = found["times"] or None, found["levels"] - 1, True

    def _mesh(self, step):
        """The mesh that the pipeline requests; the first one is kept."""
        if step == 0 and self._first is not None:
            return self._first
        names = [self._selection.GetArrayName(i) for i in range(self._selection.GetNumberOfArrays())]
        file = os.path.join(self._folder.name, "mesh.vtk")
        self._ask(do="mesh", file=file, step=None if self._times is None else step, levels=list(self._settings["levels"]),
                  variables=[name for name in names if self._selection.ArrayIsEnabled(name)], options=self._settings["globe"])
        reader = vtkDataSetReader()
        reader.SetFileName(file)
        reader.ReadAllScalarsOn()
        reader.ReadAllVectorsOn()
        reader.Update()
        mesh = reader.GetOutput().NewInstance()
        mesh.ShallowCopy(reader.GetOutput())
        if step == 0:
            self._first = mesh
        return mesh

    def _attempt(self, action):
        """Returns 1, or 0 after reporting an error."""
        try:
            action()
            self._problem = ""
            return 1
        except Exception as failure:  # shown in ParaView's window
            self._problem = str(failure)
            vtkOutputWindow.GetInstance().DisplayErrorText(f"Weather data: {failure}\n")
            return 0

    def RequestDataObject(self, request, inputs, outputs):
        def make():
            if not self._is_open:
                self._open()
            mesh, info = self._mesh(0), outputs.GetInformationObject(0)
            if not (info.Has(vtkDataObject.DATA_OBJECT()) and info.Get(vtkDataObject.DATA_OBJECT()).IsA(mesh.GetClassName())):
                info.Set(vtkDataObject.DATA_OBJECT(), mesh.NewInstance())
        if self._settings["path"] is None or not self._attempt(make):
            outputs.GetInformationObject(0).Set(vtkDataObject.DATA_OBJECT(), vtkUnstructuredGrid())
        return 1

    def RequestInformation(self, request, inputs, outputs):
        info = outputs.GetInformationObject(0)
        if self._first is not None and self._first.IsA("vtkStructuredGrid"):
            info.Set(SDDP.WHOLE_EXTENT(), self._first.GetExtent(), 6)
        if self._times is not None:
            times = [float(time) for time in self._times]
            info.Set(SDDP.TIME_STEPS(), times, len(times))
            info.Set(SDDP.TIME_RANGE(), [times[0], times[-1]], 2)
        return 1

    def RequestData(self, request, inputs, outputs):
        info = outputs.GetInformationObject(0)
        if not self._is_open:  # empty; RequestDataObject has reported why, and ParaView's own report of a failure would hide that
            failed = vtkUnsignedCharArray()
            failed.SetName("NephoscopeFailed")  # whoever draws the data need not say that there are none
            vtkDataObject.GetData(outputs).GetFieldData().AddArray(failed)
            return 1
        step = 0
        if self._times is not None and info.Has(SDDP.UPDATE_TIME_STEP()):
            asked = info.Get(SDDP.UPDATE_TIME_STEP())
            step = min(range(len(self._times)), key=lambda i: abs(self._times[i] - asked))
        output = vtkDataObject.GetData(outputs)

        def read():
            output.ShallowCopy(self._mesh(step))
            if self._times is not None:
                output.GetInformation().Set(vtkDataObject.DATA_TIME_STEP(), float(self._times[step]))
        return self._attempt(read)


with open(DEFINITION, encoding="utf-8") as definition:  # for ParaView's loader of plugins in Python
    WeatherDataReader._pvsm_proxy_xml = definition.read().replace("nephoscope.weather.paraview_plugin.", f"{__name__}.")
