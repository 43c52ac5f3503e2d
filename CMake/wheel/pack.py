#!/usr/bin/env python3
# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Packs a build for VTK's wheel into a wheel, with stubs for type checkers. Prints its path."""
import argparse
import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from inputs import PYTHONS, cpython

TOP = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(TOP / "Plugins/PyVista/packaging"))
from nephoscope_wheel import make_wheel  # noqa: E402

# The newest symbols of the system's libraries that manylinux_2_34 allows (PEP 600; auditwheel's policy).
PLATFORM = "manylinux_2_34_x86_64"
ALLOWED = {"GLIBC": (2, 34), "GLIBCXX": (3, 4, 29), "CXXABI": (1, 3, 13), "GCC": (11, 0), "ZLIB": (1, 2, 9)}
DESCRIBE = """
import json, sys
import nephoscope
from nephoscope import _modules
classes = {name: getattr(nephoscope, name).__module__.split(".")[-1] for name in nephoscope.__all__ if name.startswith("vtk")}
json.dump({"modules": _modules.MODULES, "classes": classes, "star": sorted({*nephoscope.__all__, *nephoscope.PYVISTA_FUNCTIONS} - {"open"}), "functions": {**nephoscope.VTK_FUNCTIONS, **nephoscope.PYVISTA_FUNCTIONS}}, sys.stdout)
"""


def newer_versions(listed):
    """Versions of symbols that a library needs, by what readelf says of it, and the platform does not promise."""
    needed = listed.split("Version needs section", 1)[-1]
    found = {(name, tuple(map(int, version.split(".")))) for name, version in re.findall(r"Name: (\w+)_([\d.]+)", needed)}
    return sorted(f"{name}_{'.'.join(map(str, version))}" for name, version in found if version > ALLOWED.get(name, (0,)))


def check_libraries(package):
    problems = []
    for library in sorted(package.glob("*.so")):
        listed = subprocess.run(["readelf", "--version-info", "--wide", library], check=True, capture_output=True, text=True).stdout
        if newer_versions(listed):
            problems.append(f"{library.name} needs {', '.join(newer_versions(listed))}")
    if problems:
        sys.exit("\n".join([f"These libraries do not run on all systems of {PLATFORM}:", *problems]))


def classes_of(vtk):
    """{class: module} of VTK's own stubs."""
    return {name: f"vtkmodules.{stub.stem}" for stub in (vtk / "vtkmodules").glob("vtk*.pyi") for name in re.findall(r"^class (\w+)", stub.read_text(), re.MULTILINE)}


def with_imports(stub, modules):
    """VTK's program names classes of other modules, and the type of properties, without importing them; type checkers then know nothing of them."""
    own = re.findall(r"^class (\w+)", stub, re.MULTILINE)
    others = {name for name in re.findall(r"'(vtk\w+)'", stub) if name not in own and name in modules}
    stub = re.sub(r"'(vtk\w+)'", lambda found: f"'{modules[found[1]]}.{found[1]}'" if found[1] in others else found[0], stub)
    imports = "".join(f"import {module}\n" for module in sorted({modules[name] for name in others}) if f"import {module}\n" not in stub)
    return stub.replace("\nimport vtkmodules", f"\n{imports}import vtkmodules", 1).replace(":'getset_descriptor'", ":Any")


def make_stubs(staging, vtk, stubs):
    """Stubs of the wrapped classes, by VTK's own program, and of the package; `vtk` is the folder that has vtkmodules."""
    environment = {**os.environ, "PYTHONPATH": f"{staging}:{vtk}"}
    described = subprocess.run([sys.executable, "-c", DESCRIBE], env=environment, check=True, stdout=subprocess.PIPE, text=True).stdout
    content = json.loads(described)
    stubs.mkdir(parents=True, exist_ok=True)
    for old in stubs.glob("*.pyi"):
        old.unlink()
    subprocess.run([sys.executable, "-m", "vtkmodules.generate_pyi", "-p", "nephoscope", "-o", stubs, *content["modules"]],
                   env=environment, check=True)
    modules = classes_of(vtk)
    for stub in stubs.glob("*.pyi"):
        stub.write_text(with_imports(stub.read_text(), modules))
    lines = [f"from .{module} import {name} as {name}" for name, module in sorted(content["classes"].items())]
    lines += [f"from .{file} import {name} as {name}" for name, file in sorted(content["functions"].items())]
    (stubs / "__init__.pyi").write_text("\n".join([*lines, "", "__version__: str", f"__all__ = {content['star']}", "VTK_FUNCTIONS: dict[str, str]", "PYVISTA_FUNCTIONS: dict[str, str]", ""]))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--python", choices=PYTHONS, default="3.11", help="version of Python (default: 3.11)")
    parser.add_argument("--work", type=Path, required=True, help="folder of make_sdk.py")
    parser.add_argument("--build", type=Path, required=True, help="the build for that Python")
    parser.add_argument("--output", type=Path, default=Path("dist"), help="folder of the wheel (default: dist)")
    arguments = parser.parse_args()
    work, tag = arguments.work.resolve(), cpython(arguments.python)
    stubs = work / "stubs"

    def finish(staging):
        package = staging / "nephoscope"
        check_libraries(package)
        if "%d.%d" % sys.version_info[:2] == arguments.python:  # the same for all versions
            make_stubs(staging, work / f"inputs/unpacked/vtk-{tag}", stubs)
        if not (stubs / "__init__.pyi").is_file():
            sys.exit("There are no stubs yet: make the wheel for Python %d.%d first." % sys.version_info[:2])
        for stub in stubs.glob("*.pyi"):
            (package / stub.name).write_bytes(stub.read_bytes())
        (package / "py.typed").touch()
        for licence in (work / "openvdb/prefix/licenses").glob("*.txt"):
            shutil.copy(licence, next(staging.glob("*.dist-info")) / "licenses")

    print(make_wheel(arguments.build.resolve(), arguments.output.resolve(), finish))


if __name__ == "__main__":
    main()
