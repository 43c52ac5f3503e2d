# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""long_run.py [--minutes M]: films of changing data, again and again, with cells, splats, smoke and texture; some are cancelled, some data are damaged, processes are killed.

Memory must not grow, no half frame may be taken for whole, and what was interrupted must end as what was not. Exits with 1 otherwise.
"""
import argparse
import _thread
import gc
import random
import signal
import statistics
import subprocess
import sys
import tempfile
import threading
import time
import warnings
from pathlib import Path

import nephoscope
import numpy as np
import pyvista
from PIL import Image

STEPS, DAMAGED = 6, 3
MOST = 20  # kB in a round of films: less than one of its pictures or meshes
KILLED = 0.15  # of the time goes to processes that are killed
SIZE = 11
LONGEST = 12  # steps of the film whose process is killed


class Finding(Exception):
    """What must not happen."""


def private():
    """kB of memory that the process has to itself."""
    with open("/proc/self/smaps_rollup", encoding="ascii") as lines:
        return sum(int(line.split()[1]) for line in lines if line.startswith("Private_Dirty"))


# ---- data that change

def whirl(time, seed):
    """A ball that moves, in a vortex that goes up."""
    mesh = pyvista.ImageData(dimensions=(SIZE,) * 3, spacing=(2 / (SIZE - 1),) * 3, origin=(-1, -1, -1))
    x, y, z = np.asarray(mesh.points).T
    mesh["T"] = np.exp(-3 * ((x - 0.5 * np.sin(time + seed)) ** 2 + y ** 2 + (z - 0.3 * np.cos(time)) ** 2))
    mesh["U"] = np.column_stack([-y, x, 0.4 + 0.1 * np.sin(seed + x)])
    return mesh


def smoke(time, seed):
    winds = [whirl(k, seed) for k in range(STEPS)]
    return nephoscope.flow_volume(winds, vectors="U", times=list(range(STEPS)), time=0.2 * time, center=(0.4, 0, -0.8), radius=0.1, normal=(0, 0, 1), max_tetrahedra=3000)


def cloud(time, seed):
    return nephoscope.cloud_surface(nephoscope.advect_texture(whirl(time, seed), 0.5 * time, vectors="U", period=4.0), 0.4, scalars="T")


def write(folder, seed, count=STEPS, damaged=DAMAGED):
    """Files of the steps, one of which ends early."""
    files = [folder / f"step{k:02d}.vti" for k in range(count)]
    for k, file in enumerate(files):
        whirl(k, seed).save(file)
        if k == damaged:
            file.write_bytes(file.read_bytes()[:-900])
    return files


def draw_cells(plotter, mesh):
    nephoscope.add_cells(plotter, mesh, "T", clim=(0, 1), contours=[0.5], show_scalar_bar=False)


FILMS = {  # the data of a time and a seed, and what draws them
    "cells": (None, draw_cells),
    "splats": (whirl, lambda plotter, mesh: nephoscope.add_splats(plotter, mesh, "T", vectors="U", show_scalar_bar=False)),
    "smoke": (smoke, nephoscope.add_smoke),
    "texture": (cloud, nephoscope.add_cloud_texture),
}


# ---- films

class Plotter(pyvista.Plotter):
    """Counts its pictures."""

    drawn = 0

    def screenshot(self, *arguments, **options):
        self.drawn += 1
        return super().screenshot(*arguments, **options)


PLOTTERS = []  # one, since a window leaves some kB behind when it is closed, whatever it has shown


def film(name, seed, work, path, dataset=None):
    """Makes the film; returns how many frames were drawn."""
    made, draw = FILMS[name]
    times = range(1, STEPS + 1) if made else None
    if not PLOTTERS:
        PLOTTERS.append(Plotter(off_screen=True, window_size=(120, 90)))
    plotter = PLOTTERS[0]
    plotter.clear()
    plotter.camera_position = [(3, -4, 2), (0, 0, 0), (0, 0, 1)]
    plotter.drawn = 0
    nephoscope.animate(plotter, dataset or (lambda time: made(time, seed)), draw, times=times, filename=path, progress=False)
    return plotter.drawn


def pictures(folder):
    """Those of a film that is a folder; each must be whole."""
    found = []
    for file in sorted(Path(folder).glob("[0-9]*.png")):
        with Image.open(file) as picture:
            found.append(np.asarray(picture.convert("RGB"), int))
    return found


def cancelled(dice, *arguments):
    """The film with Control-C at any time; whether it has come before the end."""
    timer = threading.Timer(dice.uniform(0.02, 1.0), _thread.interrupt_main)
    try:
        timer.start()
        try:
            film(*arguments)
        finally:
            timer.cancel()
            timer.join()
        return False
    except KeyboardInterrupt:
        return True


def aborted(dice, seed):
    """A filter that is told to stop at any share of its work; then again without."""
    made = nephoscope.vtkFlowVolume()
    made.SetInputData(whirl(0, seed))
    made.SetInputArrayToProcess(0, 0, 0, 0, "U")
    polygon = pyvista.Polygon(center=(0.4, 0, -0.8), radius=0.1, n_sides=12)
    made.SetInputData(1, polygon)
    share = dice.random()
    tag = made.AddObserver("ProgressEvent", lambda caller, _: caller.SetAbortExecute(caller.GetProgress() >= share))
    made.Update()
    made.RemoveObserver(tag)
    made.SetAbortExecute(0)
    made.Modified()
    made.Update()
    if made.GetOutput().GetNumberOfCells() == 0:
        raise Finding("a flow volume that was told to stop has no cells the next time")


def one_round(seed, work):
    """All films once; returns how many were cancelled."""
    dice, count = random.Random(seed), 0
    for name in FILMS:
        dataset = write(work, seed) if name == "cells" else None
        path = work / (name + (".gif" if dice.random() < 0.3 else ""))
        kept = path if path.suffix == "" else work / (path.name + ".frames")
        arguments = (name, seed, work, path, dataset)
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter("always")
            if dice.random() < 0.5 and cancelled(dice, *arguments):
                count += 1
                found = len(list(kept.glob("[0-9]*.png"))) if (kept / "settings.txt").exists() else 0
                drawn = film(*arguments)
                if drawn > STEPS - found + bool(found):
                    raise Finding(f"{path.name} of seed {seed}: {drawn} frames were drawn, though {found} of {STEPS} were there")
            else:
                film(*arguments)
        unreadable = {str(one.message) for one in told if "cannot be read" in str(one.message)}
        if len(unreadable) != (name == "cells"):
            raise Finding(f"{path.name} of seed {seed}: warnings {sorted(unreadable)}")
        if path.suffix == "" and len(pictures(path)) != STEPS or not path.exists() or path.suffix and kept.exists():
            raise Finding(f"{path.name} of seed {seed} is not whole")
        for file in kept.glob("*"):
            file.unlink()
    aborted(dice, seed)
    return count


def memory(minutes):
    """Rounds for that time; prints how memory grows in the second half, and returns whether it is flat."""
    end, used, cancels = time.monotonic() + 60 * minutes, [], 0
    with tempfile.TemporaryDirectory() as work:
        while time.monotonic() < end or len(used) < 8:
            cancels += one_round(len(used), Path(work))
            gc.collect()
            used.append(private())
            if len(used) % 50 == 0:
                print(f"{len(used)} rounds, {used[-1] / 1000:.1f} MB", flush=True)
    quarter = len(used) // 4
    third, last = (statistics.median(used[start:start + quarter]) for start in (len(used) - 2 * quarter, len(used) - quarter))
    grown = (last - third) / quarter
    print(f"{len(used)} rounds of {len(FILMS)} films, {cancels} cancelled: {used[0] / 1000:.1f} MB after the first, {last / 1000:.1f} MB at the end; {grown:.1f} kB in a round of the second half"
          f"{', too much' if grown > MOST else ''}", flush=True)
    return grown <= MOST


# ---- processes that are killed

def killed(minutes):
    """A film whose process is killed again and again is that of one process."""
    end, lives, dice = time.monotonic() + 60 * minutes, 0, random.Random(1)
    while lives == 0 or time.monotonic() < end:
        with tempfile.TemporaryDirectory() as work:
            lives += killed_film(Path(work), lives, dice)
    print(f"{lives} processes were killed", flush=True)


def killed_film(work, seed, dice):
    """Returns how many processes were killed before the film was whole."""
    files, lives, before = write(work, seed, LONGEST), 0, 0
    while True:
        process = subprocess.Popen([sys.executable, "-W", "ignore", __file__, "--film", work / "film", str(seed)], stderr=subprocess.PIPE)
        kept = work / "film" / "settings.txt"
        while process.poll() is None and not kept.exists():
            time.sleep(0.01)
        try:
            process.wait(dice.uniform(0.0, 1.0) if lives < 8 else 60)
        except subprocess.TimeoutExpired:
            process.send_signal(signal.SIGKILL)
            lives += 1
        error = process.communicate()[1].decode()
        if process.returncode not in (0, -signal.SIGKILL):
            raise Finding(f"the process of a film ended with {process.returncode}: {error}")
        found = len(pictures(work / "film"))
        if found < before:
            raise Finding(f"a film that was killed had {before} frames, now {found}")
        before = found
        if process.returncode == 0:
            break
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        film("cells", seed, work, work / "whole", files)
    pairs = list(zip(pictures(work / "film"), pictures(work / "whole")))
    if len(pairs) != LONGEST or any(np.abs(one - other).max() > 2 for one, other in pairs):
        raise Finding(f"the film of seed {seed} is not that of one process")
    return lives


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--minutes", type=float, default=60, help="how long (default: 60)")
    parser.add_argument("--film", nargs=2, metavar=("PATH", "SEED"), help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.film:
        path = Path(options.film[0])
        film("cells", int(options.film[1]), path.parent, path, sorted(path.parent.glob("step*.vti")))
        return 0
    try:
        killed(KILLED * options.minutes)
        return 0 if memory((1 - KILLED) * options.minutes) else 1
    except Finding as finding:
        print(finding, flush=True)
        return 1


if __name__ == "__main__":
    sys.exit(main())
