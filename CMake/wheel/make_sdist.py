#!/usr/bin/env python3
# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Packs the sources that a wheel is built from into a source distribution for pip. Prints its path.

Reads the names of the files of the tree from standard input, each ended by a zero byte.
"""
import argparse
import gzip
import io
import re
import sys
import tarfile
from pathlib import Path

TOP = Path(__file__).resolve().parents[2]
LEFT_OUT = re.compile(r"(^|/)(Testing|Figures|Gallery)/|^(Data|Documentation|[.].*)/|^nephoscope$|^[.]")
TIME = 315532800  # 1980, as in the wheel: the same content makes the same file


def project():
    """Version and description of the project."""
    return re.search(r'^project\(Nephoscope VERSION (\S+)[^)]*DESCRIPTION "([^"]+)"\)', (TOP / "CMakeLists.txt").read_text(), re.MULTILINE).groups()


def sample_data():
    """Names of the files that the build installs from Data."""
    (names,) = re.findall(r"foreach [(]file IN ITEMS ([^)]*)[)]", (TOP / "CMake/NephoscopeData.cmake").read_text())
    return {f"Data/{name}" for name in names.split()}


def metadata(version, summary):
    description = (TOP / "Plugins/PyVista/packaging/description.md").read_text()
    return "\n".join(["Metadata-Version: 2.4", "Name: nephoscope", f"Version: {version}", f"Summary: {summary}", "License-Expression: BSD-3-Clause",
                      "License-File: LICENSE", "Requires-Python: >=3.11", "Description-Content-Type: text/markdown", "", description])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--output", type=Path, default=Path("dist"), help="folder of the file (default: dist)")
    output = parser.parse_args().output.resolve()
    names = sorted(name.removeprefix("./") for name in sys.stdin.read().split("\0") if name)
    samples = sample_data()
    version, summary = project()
    stem = f"nephoscope-{version}"
    output.mkdir(parents=True, exist_ok=True)
    path = output / f"{stem}.tar.gz"
    with open(path, "wb") as file, gzip.GzipFile("", "wb", 9, file, TIME) as packed, tarfile.open(fileobj=packed, mode="w") as archive:
        def add(name, data, mode):
            entry = tarfile.TarInfo(f"{stem}/{name}")
            entry.size, entry.mode, entry.mtime = len(data), mode, TIME
            archive.addfile(entry, io.BytesIO(data))

        for name in names:
            if name in samples or not LEFT_OUT.search(name):
                add(name, (TOP / name).read_bytes(), (TOP / name).stat().st_mode & 0o755 | 0o644)
        add("pyproject.toml", (TOP / "CMake/wheel/source/pyproject.toml").read_bytes(), 0o644)
        add("PKG-INFO", metadata(version, summary).encode(), 0o644)
    print(path)


if __name__ == "__main__":
    main()
