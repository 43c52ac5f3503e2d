# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What several ranks of ParaView cost: time, memory and bytes of the first frame, which redistributes the data, and of frames of a moved camera.

    ./nephoscope bench
    ./nephoscope python Testing/Benchmarks/ranks.py [CELLS [RANKS...]]

RANKS are numbers of ranks beside 1; without them 2, 4 and 8.

Weak scaling: each rank starts with CELLS cells (30,000), in layers of a cube, as from a reader that divides a file by its order. Each rank has one
thread, and more ranks than cores share these: processor time, which a waiting rank does not spend, then tells more than elapsed time. Bytes are
those that the ranks give to MPI (mpi_bytes.c). Then the same data on all numbers of ranks: the largest difference of the pictures to those
of one rank, at rest and with the level of detail of a moving camera. Antialiasing is off.
"""
import ctypes
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time

import numpy as np

HERE = pathlib.Path(__file__).resolve().parent
SIZE = (512, 512)
FRAMES = 3
SCENES = {"image": "Cell Compositing", "hexahedra": "Cell Compositing", "splats of hexahedra": "Textured Splats", "surface": "Cloud Texture"}
PICTURES = ("at rest", "moving")


def field(x, y, z):
    return np.clip(np.sin(7 * x + 2 * np.sin(5 * y)) * np.cos(6 * y + z) * np.cos(3 * z) - 0.15, 0, 1)


def fill_hexahedra(output, side, piece, pieces):
    """The layers of a bent cube of side³ hexahedra that a piece has; called by ParaView on each rank."""
    from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import VTK_HEXAHEDRON, vtkCellArray
    first, last = (side * p // pieces for p in (piece, piece + 1))
    axis = np.linspace(-1, 1, side + 1)
    z, y, x = np.meshgrid(axis[first:last + 1], axis, axis, indexing="ij")
    corner = np.arange(z.size).reshape(z.shape)
    ids = np.stack([corner[k:last - first + k, j:side + j, i:side + i].ravel()
                    for k in (0, 1) for j, i in ((0, 0), (0, 1), (1, 1), (1, 0))], axis=-1)
    points, cells = vtkPoints(), vtkCellArray()
    places = np.stack([x + 0.2 * y * z, y + 0.2 * z * z - 0.1, z - 0.15 * x * x], axis=-1)
    points.SetData(numpy_to_vtk(places.reshape(-1, 3).astype(np.float32), deep=1))
    cells.SetData(numpy_to_vtkIdTypeArray(np.arange(0, ids.size + 1, 8), deep=1), numpy_to_vtkIdTypeArray(ids.ravel(), deep=1))
    values = numpy_to_vtk(field(x, y, z).ravel().astype(np.float32), deep=1)
    values.SetName("cloud")
    output.SetPoints(points)
    output.SetCells(VTK_HEXAHEDRON, cells)
    output.GetPointData().SetScalars(values)


def source(name, cells):
    """A proxy of data with so many cells on all ranks together."""
    from paraview import simple as pvs
    side = round(cells ** (1 / 3))
    if name.endswith("hexahedra"):
        request = "executive = self.GetExecutive()\noutput = executive.GetOutputInformation(0)\n"
        return pvs.ProgrammableSource(
            OutputDataSetType="vtkUnstructuredGrid", ScriptRequestInformation=request + "output.Set(self.CAN_HANDLE_PIECE_REQUEST(), 1)",
            Script=f"import sys\nsys.path.insert(0, {str(HERE)!r})\nimport ranks\n{request}"
                   f"ranks.fill_hexahedra(self.GetOutput(), {side}, output.Get(executive.UPDATE_PIECE_NUMBER()), output.Get(executive.UPDATE_NUMBER_OF_PIECES()))")
    half = side / 2
    wavelet = pvs.Wavelet(WholeExtent=[-(side // 2), side - side // 2] * 3)
    cube = "*".join(f"sin(coords{axis}*{6 / half})" for axis in "XYZ")
    cloud = pvs.Calculator(Input=wavelet, ResultArrayName="cloud", Function=f"0.5+0.5*{cube}")
    return pvs.Contour(Input=cloud, ContourBy=["POINTS", "cloud"], Isosurfaces=[0.6]) if name == "surface" else cloud


class Rank:
    """What this rank has used, all of it since its start."""
    def __init__(self):
        from vtkmodules.vtkParallelCore import vtkMultiProcessController
        self.controller = vtkMultiProcessController.GetGlobalController()
        self.count = ctypes.CDLL(None).nephoscope_mpi_counts

    def used(self):
        self.controller.Barrier()
        bytes_and_messages = (ctypes.c_double * 4)()
        self.count(bytes_and_messages)
        return np.array([time.perf_counter(), time.process_time(), *bytes_and_messages])

    def cost(self, work):
        before = self.used()
        work()
        return self.used() - before


def memory(entry):
    with open("/proc/self/status") as file:
        return next(int(line.split()[1]) << 10 for line in file if line.startswith(entry))


def trim():
    ctypes.CDLL("libc.so.6").malloc_trim(0)
    with open("/proc/self/clear_refs", "w") as file:
        file.write("5")  # the peak begins anew


def look(view, name, cells, turn=0.0):
    radius = round(cells ** (1 / 3)) / 2 if name in ("image", "surface") else 1
    view.CameraPosition = [radius * (3.6 + turn), radius * 2.8, radius * (5 - turn)]
    view.CameraFocalPoint, view.CameraViewUp = [0, 0, 0], [0, 1, 0]


def pixels(view):
    from vtkmodules.util.numpy_support import vtk_to_numpy
    return vtk_to_numpy(view.SMProxy.CaptureWindow(1).GetPointData().GetScalars()).astype(int)


def show(name, cells):
    from paraview import simple as pvs
    view = pvs.CreateRenderView(ViewSize=list(SIZE), OrientationAxesVisibility=0, UseFXAA=0, UseColorPaletteForBackground=0, Background=[0, 0, 0])
    pvs.Render(view)
    data = source(name, cells)
    data.UpdatePipeline()
    display = pvs.Show(data, view)
    pvs.ColorBy(display, ["POINTS", "" if name == "surface" else "cloud"])
    display.SetRepresentationType(SCENES[name])
    for function in (pvs.GetColorTransferFunction("cloud"), pvs.GetOpacityTransferFunction("cloud")):
        function.RescaleTransferFunction(0, 1)  # not to the range of one rank
    look(view, name, cells)
    return data, view


def forget(data, view):
    from paraview import simple as pvs
    pvs.Delete(view)
    while data:
        data, given = getattr(data, "Input", None), data
        pvs.Delete(given)


def measure(rank, name, cells):
    from paraview import simple as pvs
    data, view = show(name, cells)
    trim()
    before = memory("VmRSS")
    first = rank.cost(lambda: pvs.Render(view))
    frames = []
    for i in range(FRAMES):
        look(view, name, cells, 0.2 * (i + 1))
        frames.append(rank.cost(lambda: pvs.Render(view)))
    forget(data, view)
    return {"first": first.tolist(), "frame": np.median(frames, axis=0).tolist(), "peak": memory("VmHWM"), "grown": memory("VmHWM") - before}


def draw(name, cells, prefix):
    from paraview import simple as pvs
    data, view = show(name, cells)
    display = pvs.GetRepresentation(data, view)
    if SCENES[name] == "Cell Compositing":
        display.CellCompositingAutoAdjustSampleDistances = 0  # the number of rays would depend on the time that they take
    pvs.Render(view)
    found = {"at rest": pixels(view)}
    view.LODThreshold = 0
    view.ImageReductionFactor = 1  # ParaView draws every second pixel on several ranks
    view.UseInteractiveRenderingForScreenshots = 1
    look(view, name, cells, 0.2)
    view.SMProxy.InteractiveRender()
    found["moving"] = pixels(view)
    forget(data, view)
    np.savez(prefix, **found)


def run_rank(cells, prefix, scenes):
    import nephoscope_testing.quick_paraview  # noqa: F401
    rank = Rank()
    number, ranks = rank.controller.GetLocalProcessId(), rank.controller.GetNumberOfProcesses()
    measure(rank, "image", 1000)  # shaders and fonts
    used = {name: measure(rank, name, cells * ranks) for name in scenes}
    for name in scenes:
        draw(name, cells, f"{prefix}-{name}-{ranks}-{number}.npz")
    with open(f"{prefix}-{ranks}-{number}.json", "w") as file:
        json.dump(used, file)


def counter(folder):
    """The library that counts bytes; in it, a rank that waits sleeps."""
    library, sleep = f"{folder}/mpi_bytes.so", HERE.parent.parent / "Plugins/ParaView/Testing/sleeping_yield.c"
    subprocess.run(["mpicc", "-O2", "-shared", "-fPIC", "-o", library, str(HERE / "mpi_bytes.c"), str(sleep)], check=True)
    return library


def start(cells, ranks, prefix, library, scenes=tuple(SCENES)):
    """What each rank has used."""
    preload = ":".join(filter(None, (os.environ.get("LD_PRELOAD"), library)))
    environment = dict(os.environ, LD_PRELOAD=preload, OMPI_MCA_mpi_yield_when_idle="1", LP_NUM_THREADS="0", VTK_SMP_MAX_THREADS="1",
                       PYTHONPATH=f"{HERE.parent / 'Python'}:{os.environ.get('PYTHONPATH', '')}")
    command = [os.environ.get("NEPHOSCOPE_MPIEXEC", "mpiexec"), "-np", str(ranks), os.environ.get("NEPHOSCOPE_PVBATCH", "pvbatch"), "--sym", __file__, str(cells), "--rank", prefix, *scenes]
    done = subprocess.run(command, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=1200)
    files = [f"{prefix}-{ranks}-{rank}.json" for rank in range(ranks)]
    if done.returncode or not all(map(os.path.exists, files)):
        sys.exit(f"{' '.join(command)}: failed\n{done.stdout}")
    return [json.load(open(file)) for file in files]


def row(name, ranks, cells, used):
    """MB of 10⁶ bytes, kB of 10³."""
    first, frame = (np.array([each[name][stage] for each in used]) for stage in ("first", "frame"))
    peak, grown = (max(each[name][kind] for each in used) for kind in ("peak", "grown"))
    sent, gathered = first[:, 2], first[:, 4]
    return (f"| {name} | {ranks} | {cells * ranks:,} | {first[:, 0].max():.2f} | {first[:, 1].mean():.2f} | {sent.mean() / 1e6:.2f} | {sent.max() / 1e6:.2f} | "
            f"{gathered.max() / 1e6:.2f} | {frame[:, 0].max():.2f} | {frame[:, 1].mean():.2f} | {frame[:, 2].mean() / 1e3:.0f} | {frame[:, 2].max() / 1e3:.0f} | "
            f"{peak / 1e6:.0f} | {grown / 1e6:.0f} |")


def differences(prefix, name, ranks):
    one, many = (np.load(f"{prefix}-{name}-{number}-0.npz") for number in (1, ranks))
    return " | ".join(f"{np.abs(one[picture] - many[picture]).max()} | {np.abs(one[picture] - many[picture]).mean():.3f}" for picture in PICTURES)


def main():
    cells = int(sys.argv[1]) if len(sys.argv) > 1 else 30000
    if sys.argv[2:3] == ["--rank"]:
        sys.path.insert(0, str(HERE))
        import ranks  # a programmable source puts names of its own into __main__
        ranks.run_rank(cells, sys.argv[3], sys.argv[4:])
        return
    numbers = sorted({1, *map(int, sys.argv[2:] or (2, 4, 8))})
    print(f"1 to {max(numbers)} processes of one thread each on {len(os.sched_getaffinity(0))} cores, {SIZE[0]} x {SIZE[1]} pixels\n")
    with tempfile.TemporaryDirectory() as folder:
        library, prefix = counter(folder), f"{folder}/run"
        used = {number: start(cells, number, prefix, library) for number in numbers}
        print("| data | ranks | cells | first frame, s | processor s per rank | sent per rank, MB | most | gathered by a rank, MB | moved camera, s | processor s per rank | sent per rank, kB | most | "
              "peak memory, MB | above ParaView |\n" + 14 * "|---" + "|")
        for name in SCENES:
            for number in numbers:
                print(row(name, number, cells, used[number]), flush=True)
        print("\n| the same data | ranks | at rest: largest | mean | moving: largest | mean |\n" + 6 * "|---" + "|")
        for name in SCENES:
            for number in numbers[1:]:
                print(f"| {name} | {number} | {differences(prefix, name, number)} |", flush=True)


if __name__ == "__main__":
    main()
