#!/usr/bin/env python3
# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Builds the OpenVDB that goes into the wheel, from Debian's sources, in openvdb/prefix of the work folder."""
import argparse
import os
import subprocess
import tarfile
from pathlib import Path

from inputs import HERE, fetch_debian, unpack


def unpack_sources(archives, folder):
    for archive in archives:
        done = folder / f"{archive.name}.unpacked"
        if not done.exists():
            with tarfile.open(archive) as content:
                content.extractall(folder)
            done.touch()


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--work", type=Path, required=True, help="folder for the inputs and the library")
    parser.add_argument("options", nargs="*", help="for CMake: --, then -D...")
    arguments = parser.parse_args()
    work = arguments.work.resolve()
    files = fetch_debian("openvdb", work / "inputs")
    packages = {name: unpack(file, work / "inputs") for name, file in files.items() if file.suffix == ".deb"}
    sources = work / "openvdb/sources"
    sources.mkdir(parents=True, exist_ok=True)
    unpack_sources([file for file in files.values() if file.suffix != ".deb"], sources)
    build, prefix = work / "openvdb/build", work / "openvdb/prefix"
    subprocess.run(["cmake", "-S", HERE / "openvdb", "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", f"-DSOURCES={sources}",
                    f"-DBOOST={packages['libboost1.74-dev']}", f"-DZLIB={packages['zlib1g']}", f"-DZLIB_HEADERS={packages['zlib1g-dev']}",
                    f"-DCMAKE_INSTALL_PREFIX={prefix}", *arguments.options], check=True)
    subprocess.run(["cmake", "--build", build, "-j", str(os.cpu_count())], check=True)
    subprocess.run(["cmake", "--install", build], check=True, stdout=subprocess.DEVNULL)


if __name__ == "__main__":
    main()
