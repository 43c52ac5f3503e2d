# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 20: the air over the hills of a regional weather model, on levels that follow the terrain.

Potential temperature of the Met Office's Unified Model, 100 m from column to column, over the Clun valley on a September evening (Data/weather). Air that is cooler than
the rest of its level is blue, warmer air is orange: thermals and their surroundings. The walls show the same air with the model's levels as lines. Heights are exaggerated
3 times. Writes the picture (1920 x 1080). `./nephoscope demo 20 --data FILE` draws another file of a regional model in the same way.
"""
import os
import subprocess
import sys
import warnings

DATA = os.environ.get("NEPHOSCOPE_FIGURE_DATA") or os.path.join(os.environ["NEPHOSCOPE_DATA"], "weather", "colpex_hybrid_height.nc")
SIZE = (1920, 1080)
STEEPNESS = 0.3  # of the block: height by width, about
GROUND = ["#2f4a2b", "#55703a", "#8a8a52", "#a88b62", "#c9b79c"]  # valley to top
AIR = ["#23386b", "#4277ad", "#a9c9d6", "#f2e6bd", "#e89a52", "#b9492f"]  # from cool to warm
COOL, NEUTRAL, WARM = "#4a9bf0", "#e8e4dc", "#f5862c"


def drawn_by_python_with_the_packages():
    """pvbatch has no xarray and must not load eccodes: the environment of ./nephoscope draws."""
    python = os.environ.get("NEPHOSCOPE_PYTHON") or os.path.join(os.environ["NEPHOSCOPE_VENV"], "bin", "python3")
    return subprocess.call([python, __file__, "draw"])


def local(mesh, centre):
    """Metres to the east, to the north and up of `centre`."""
    import numpy as np
    up = centre / np.linalg.norm(centre)
    east = np.cross((0, 0, 1), up)
    east /= np.linalg.norm(east)
    mesh.points = (np.asarray(mesh.points, float) - centre) @ np.array([east, np.cross(up, east), up]).T
    return mesh


def against_its_level(grid, name):
    """The field less its mean on each level, in standard deviations."""
    import numpy as np
    values = np.array(grid[name], float).reshape(grid.dimensions[2], -1)
    mean, spread = np.nanmean(values, axis=1, keepdims=True), np.nanstd(values, axis=1, keepdims=True)
    return ((values - mean) / np.where(spread > 0, spread, 1)).ravel().astype(np.float32)


def add_wall(plotter, grid, box, name, title):
    """A side of the block with its levels as lines."""
    import numpy as np
    import pyvista
    wall = grid.extract_subset(box)
    plotter.add_mesh(wall.extract_surface(), scalars=name, cmap=table(AIR, np.nanpercentile(grid[name], (1, 99))), lighting=False, scalar_bar_args=dict(
        title=title, vertical=False, width=0.3, height=0.1, position_x=0.03, position_y=0.05, fmt="%.4g", title_font_size=26, label_font_size=22, n_labels=2))
    for row in np.asarray(wall.points).reshape(wall.dimensions[2], -1, 3):
        plotter.add_mesh(pyvista.lines_from_points(row), color="#20242c", line_width=1.5, opacity=0.6, lighting=False)


def exaggeration(dataset):
    """Which round number makes the block steep enough: 3 for the sample."""
    import numpy as np
    grid = dataset.nephoscope.globe(time=0, variables=[], mask_below_ground=False)
    width, height = np.ptp(np.asarray(grid.points), axis=0).max(), np.ptp(np.asarray(grid["Height"]))
    return float(min((1, 2, 3, 5, 10, 20, 30, 50, 100), key=lambda factor: abs(np.log(factor * height / width / STEEPNESS))))


def terrain(dataset, centre, factor):
    """None where the file does not tell the height of the ground."""
    try:
        return local(dataset.nephoscope.terrain(time=0, vertical_exaggeration=factor), centre)
    except ValueError as missing:
        print(missing, file=sys.stderr)
        return None


def draw():
    import nephoscope
    import numpy as np
    import pyvista
    warnings.simplefilter("ignore")
    dataset = nephoscope.open(DATA)
    factor = exaggeration(dataset)
    grid = dataset.nephoscope.globe(time=0, vertical_exaggeration=factor, mask_below_ground=False)
    if not isinstance(grid, pyvista.StructuredGrid) or min(grid.dimensions) < 2:
        raise SystemExit(f"{DATA} has no grid of rows, columns and levels, which this figure draws. Try nephoscope.open(...).nephoscope.plot().")
    name = grid.active_scalars_name or next(iter(grid.point_data))
    grid["anomaly"] = against_its_level(grid, name)
    centre = np.asarray(grid.points, float).mean(axis=0)
    grid, ground = local(grid, centre), terrain(dataset, centre, factor)
    size = np.ptp(np.asarray(grid.points)[:, :2])
    plotter = pyvista.Plotter(off_screen=True, window_size=SIZE, theme=pyvista.themes.DarkTheme(), lighting="none")
    plotter.set_background("#0b1018", top="#2c3d55")
    plotter.add_light(pyvista.Light(position=(-1, -0.75, 0.62), light_type="scene light", intensity=1.0))
    if ground is not None:
        heights = np.nanmin(ground["Terrain"]), np.nanmax(ground["Terrain"])
        plotter.add_mesh(ground, scalars="Terrain", cmap=table(GROUND, heights), smooth_shading=True, ambient=0.22, diffuse=1.0, show_scalar_bar=False)
    nx, ny, nz = grid.dimensions
    about = dataset[name].attrs if name in dataset else {}
    title = f"{about.get('long_name', about.get('standard_name', name)).replace('_', ' ').replace('air ', '')} ({about.get('units', '1')})"
    for box in ((0, nx - 1, ny - 1, ny - 1, 0, nz - 1), (nx - 1, nx - 1, 0, ny - 1, 0, nz - 1)):
        add_wall(plotter, grid, box, name, title)
    nephoscope.add_cells(plotter, grid, "anomaly", cmap=[COOL, COOL, NEUTRAL, WARM, WARM], clim=(-2.5, 2.5), opacity=[0.9, 0.25, 0.0, 0.0, 0.0, 0.25, 0.9],
                         opacity_unit_distance=size / 12, show_scalar_bar=False)
    plotter.camera.position, plotter.camera.focal_point, plotter.camera.up = np.array((-0.98, -1.17, 0.78)) * size, (0.02 * size, 0, -0.085 * size), (0, 0, 1)
    plotter.camera.view_angle = 34
    plotter.reset_camera_clipping_range()
    path = os.path.join(os.environ["NEPHOSCOPE_GALLERY"], "20_regional_model.png")
    plotter.screenshot(path)
    print("wrote", path, flush=True)


def table(colours, limits):
    """A colour table of 256 colours through these."""
    import numpy as np
    import pyvista
    stops = np.array([pyvista.Color(colour).int_rgba for colour in colours], float)
    place = np.linspace(0, len(stops) - 1, 256)
    found = pyvista.LookupTable(values=np.stack([np.interp(place, np.arange(len(stops)), stops[:, c]) for c in range(4)], 1).astype(np.uint8))
    found.scalar_range = limits
    return found


if sys.argv[1:] == ["draw"]:
    draw()
else:
    status = drawn_by_python_with_the_packages()
    if status:
        raise SystemExit(status)
