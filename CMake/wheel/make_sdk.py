#!/usr/bin/env python3
# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Makes an SDK of the `vtk` wheel of the Python package index, which has none: what is needed to build VTK modules for it.

Headers, CMake package and wrapping programs are those of Debian's VTK of the same version; the CMake targets point to the wheel's
libraries. Prints the folder to give to CMake as VTK_DIR.
"""
import argparse
import re
import shutil
import sys
import zipfile
from pathlib import Path

from cmake_package import CMakePackage
from inputs import PYTHONS, cpython, fetch_debian, fetch_vtk, python_headers, unpack, vtk_version

TRIPLE = "x86_64-linux-gnu"
SERIES = ".".join(vtk_version().split(".")[:2])
PROGRAMS = {f"vtkWrapPython-{SERIES}": "python3-vtk9", f"vtkWrapPythonInit-{SERIES}": "python3-vtk9", f"vtkWrapHierarchy-{SERIES}": "vtk9"}
# Debian's programs want a newer C library than the machine may have: its own loader runs them.
LAUNCHER = """#!/bin/sh
folder=$(dirname "$(readlink -f "$0")")/../libexec
exec "$folder/lib/ld-linux-x86-64.so.2" --inhibit-cache --library-path "$folder/lib" "$folder/{program}" "$@"
"""


def edit(path, *pairs):
    text = path.read_text()
    for pattern, replacement in pairs:
        text, count = re.subn(pattern, replacement, text, flags=re.MULTILINE)
        if not count:
            sys.exit(f"{path} is not as expected: nothing matches {pattern}")
    path.write_text(text)


def unpack_wheel(wheel, folder):
    """The folder `vtkmodules` of VTK's wheel."""
    if not folder.is_dir():
        partial = folder.with_name(folder.name + ".partial")
        shutil.rmtree(partial, ignore_errors=True)
        with zipfile.ZipFile(wheel) as archive:
            archive.extractall(partial)
        partial.rename(folder)
    return folder / "vtkmodules"


def copy_headers(sdk, packages):
    shutil.copytree(packages["libvtk9-dev"] / f"usr/include/vtk-{SERIES}", sdk / f"include/vtk-{SERIES}")
    shutil.copytree(packages[f"libvtk{SERIES}"] / f"usr/lib/{TRIPLE}/vtk-{SERIES}/hierarchy", sdk / f"lib/{TRIPLE}/vtk-{SERIES}/hierarchy")
    # The wheel is built without TBB, and Sequential is its default.
    edit(sdk / f"include/vtk-{SERIES}/vtkSMP.h",
         (r"^#define VTK_SMP_TBB$", "#define VTK_SMP_Sequential"), (r'VTK_SMP_BACKEND "TBB"', 'VTK_SMP_BACKEND "Sequential"'),
         (r"VTK_SMP_ENABLE_TBB 1", "VTK_SMP_ENABLE_TBB 0"), (r"IMPLEMENTATION_SEQUENTIAL 0", "IMPLEMENTATION_SEQUENTIAL 1"),
         (r"IMPLEMENTATION_TBB 1", "IMPLEMENTATION_TBB 0"))


def copy_programs(sdk, packages):
    libraries = sdk / "libexec/lib"
    libraries.mkdir(parents=True)
    (sdk / "bin").mkdir()
    for name in ("ld-linux-x86-64.so.2", "libc.so.6", "libm.so.6"):
        shutil.copy(packages["libc6"] / f"usr/lib/{TRIPLE}" / name, libraries)
    tools = f"libvtkWrappingTools-{SERIES}.so.1"
    shutil.copy(packages[f"libvtk{SERIES}"] / f"usr/lib/{TRIPLE}" / tools, libraries)
    for program, package in PROGRAMS.items():
        shutil.copy(packages[package] / "usr/bin" / program, sdk / "libexec")
        launcher = sdk / "bin" / program
        launcher.write_text(LAUNCHER.format(program=program))
        launcher.chmod(0o755)


def make_common(sdk, packages):
    """What all versions of Python share."""
    if (sdk / "libexec").is_dir() and not (sdk / ".partial").exists():
        return
    shutil.rmtree(sdk, ignore_errors=True)
    sdk.mkdir(parents=True)
    (sdk / ".partial").touch()
    copy_headers(sdk, packages)
    copy_programs(sdk, packages)
    (sdk / ".partial").unlink()


def share_encoder(package):
    """CMake's commands that write the shaders name their script: one path for all versions of Python, or another version would compile all shaders again."""
    script = package / "vtkEncodeString.cmake"
    shared = package.with_name(script.name)
    if not shared.exists():
        script.rename(shared)
    script.write_text(f'include("{shared}")\n')


def make_package(sdk, packages, python, vtkmodules, headers):
    """The CMake package for one version of Python."""
    folder = sdk / f"lib/{TRIPLE}/cmake/vtk-{cpython(python)}"
    partial = folder.with_name(folder.name + ".partial")
    for old in (folder, partial):
        shutil.rmtree(old, ignore_errors=True)
    shutil.copytree(packages["libvtk9-dev"] / f"usr/lib/{TRIPLE}/cmake/vtk-{SERIES}", partial)

    def file_of(path):
        name = Path(path).name
        if path.startswith("bin/"):
            file = sdk / "bin" / name
        else:
            library = name.split(f"-{SERIES}")[0]
            file = vtkmodules / (re.sub(r"(WrappingPythonCore)3\.\d+$", rf"\g<1>{python}", library) + ".so")
        return file if file.exists() else None

    package = CMakePackage(partial, sdk, file_of)
    package.rewrite(python, headers)
    share_encoder(partial)
    partial.rename(folder)
    print(f"{len(package.kept())} of {len(package.blocks)} targets of VTK are in its wheel")
    return folder


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--python", choices=PYTHONS, default="3.11", help="version of Python (default: 3.11)")
    parser.add_argument("--work", type=Path, required=True, help="folder for the inputs and the SDK")
    arguments = parser.parse_args()
    work = arguments.work.resolve()
    headers = python_headers(arguments.python, work / "inputs")
    packages = {name: unpack(file, work / "inputs") for name, file in fetch_debian("sdk", work / "inputs").items()}
    vtkmodules = unpack_wheel(fetch_vtk(arguments.python, work / "inputs"), work / "inputs/unpacked" / f"vtk-{cpython(arguments.python)}")
    make_common(work / "sdk", packages)
    print(make_package(work / "sdk", packages, arguments.python, vtkmodules, headers))


if __name__ == "__main__":
    main()
