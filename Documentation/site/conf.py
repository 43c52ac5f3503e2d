# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Sphinx's settings for the site that `./nephoscope docs` makes. Nothing of it is fetched from the network."""
import pathlib
import re
import sys
import types

TOP = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(TOP / "Plugins/PyVista"), str(TOP / "Documentation/site")]
import headers  # noqa: E402
import python_api  # noqa: E402


def stand_in(name, **contents):
    sys.modules[name] = types.ModuleType(name)
    vars(sys.modules[name]).update(contents)


project = "Nephoscope"
author = "The Nephoscope authors"
copyright = author  # noqa: A001
release = version = re.search(r"project\(.*?VERSION\s+([\d.]+)", (TOP / "CMakeLists.txt").read_text(encoding="utf-8"), re.DOTALL)[1]

extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.napoleon", "sphinx_copybutton"]
root_doc = "index"
default_role = "literal"
highlight_language = "none"

myst_enable_extensions = ["colon_fence"]
myst_heading_anchors = 4

# The docstrings are in the Python files: the site needs neither a build nor PyVista.
autodoc_mock_imports = ["nephoscope._vtk", "vtkmodules", "pyvista", "numpy"]
stand_in("nephoscope._modules", MODULES=["_classes"], VERSION=release, FROM_PYPI=False)
stand_in("nephoscope._classes", **{path.stem: type(path.stem, (), {}) for path in headers.paths()})
autodoc_typehints = "none"
autodoc_member_order = "bysource"
napoleon_numpy_docstring = True
napoleon_google_docstring = False
napoleon_use_rtype = False
python_use_unqualified_type_names = True
add_module_names = False

html_theme = "furo"
html_title = f"Nephoscope {release}"
html_static_path = ["static"]
html_css_files = ["site.css"]
html_search_scorer = str(TOP / "Documentation/site/static/scorer.js")
html_copy_source = False
html_show_sphinx = False
copybutton_prompt_text = ""

linkcheck_timeout = 20
linkcheck_retries = 2


def link_names(_app, _what, _name, _object, _options, lines):
    lines[:] = python_api.linked("\n".join(lines)).split("\n")


def setup(app):
    app.connect("autodoc-process-docstring", link_names)
