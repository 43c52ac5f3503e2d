# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Reference pages of the Python package: its functions by what they are for, taken from the package's own list."""
import ast
import pathlib
import re

import headers

TOP = pathlib.Path(__file__).resolve().parents[2]
PACKAGE = TOP / "Plugins/PyVista/nephoscope"
GROUPS = {  # title: (page, what the names of its functions begin with, introduction)
    "Functions for plotters": ("plotters", ("add_", "animate"), "They draw in a ``pyvista.Plotter`` and return what they have added."),
    "Files": ("files", ("open", "read_", "write_", "cf_", "sample_"), "Readers and writers, and data to begin with."),
    "In the browser": ("browser", ("serve", "viewer"), "They draw here and send pictures to a page; :doc:`how </Documentation/web>`."),
    "VTK's mappers": ("override", ("override_",), "They need VTK alone, not PyVista."),
    "Filters": ("filters", ("",), "They take a mesh and return one. Most are methods of meshes too: "
                "``mesh.nephoscope.smooth(...)`` is ``nephoscope.smooth(mesh, ...)``, and ``mesh.nephoscope.globe(...)`` is ``to_globe``, "
                "``mesh.nephoscope.terrain(...)`` is ``terrain_surface``."),
}


def functions():
    """{name: module}, as the package lists them."""
    listed = {}
    for node in ast.parse((PACKAGE / "__init__.py").read_text(encoding="utf-8")).body:
        if isinstance(node, ast.Assign) and node.targets[0].id in ("VTK_FUNCTIONS", "PYVISTA_FUNCTIONS"):
            listed.update(ast.literal_eval(node.value))
    return listed


def linked(text):
    """Names of classes and functions in a docstring as links, like those in Markdown (sources.py)."""
    roles = {**{name: f":func:`~nephoscope.{name}`" for name in functions()}, **{path.stem: f":cpp:class:`{path.stem}`" for path in headers.paths()}}
    return re.sub(r"(?<![`:])`(\w+)`(?!`)", lambda match: roles.get(match[1], match[0]), text)


def summary(name, module):
    tree = ast.parse((PACKAGE / f"{module.replace('.', '/')}.py").read_text(encoding="utf-8"))
    function = next(node for node in tree.body if isinstance(node, ast.FunctionDef) and node.name == name and ast.get_docstring(node))
    return linked(" ".join(ast.get_docstring(function).split("\n\n")[0].split()))


def page(title, introduction, chosen):
    rows = [f":func:`~nephoscope.{name}`\n   {summary(name, module)}\n" for name, module in chosen.items()]
    documented = [f".. autofunction:: nephoscope.{name}\n" for name in chosen]
    return "\n".join([title, "=" * len(title), "", introduction, "", *rows, *documented])


def files():
    """{path on the site: text}"""
    left, made = functions(), {}
    for title, (name, beginnings, introduction) in GROUPS.items():
        chosen = {function: module for function, module in left.items() if function.startswith(beginnings)}
        left = {function: module for function, module in left.items() if function not in chosen}
        made[f"api/python/{name}.rst"] = page(title, introduction, chosen)
    made["api/python.rst"] = "\n".join([
        "Python", "======", "", "``import nephoscope`` gives these functions and every :doc:`VTK class <vtk>`.",
        "", ".. toctree::", "   :maxdepth: 1", "", *[f"   python/{name}" for name, _, _ in GROUPS.values()], ""])
    return made
