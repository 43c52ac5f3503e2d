#!/usr/bin/env python3
# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Zips a build tree's Python package into a wheel; compiles nothing, needs only the standard library.

By itself:      python3 Plugins/PyVista/packaging/nephoscope_wheel.py --build build --output dist
Through pip:    python3 -m pip install --no-deps Plugins/PyVista --config-settings build=build

The content is what `cmake --install <build> --component nephoscope_wheel` writes. A relative build folder is
relative to the root of the source tree.
"""
import argparse
import base64
import hashlib
import subprocess
import tempfile
import zipfile
from pathlib import Path
from typing import Callable

SOURCE_ROOT = Path(__file__).resolve().parents[3]


def make_wheel(build: Path, output: Path, finish: Callable[[Path], None] = lambda staging: None) -> Path:
    """Write the wheel of the build tree `build` into the folder `output`; return its path. `finish` may add to its content."""
    build = SOURCE_ROOT / build
    if not (build / "cmake_install.cmake").is_file():
        raise SystemExit(f"{build} is not a configured build tree. Build first, or name it: --config-settings build=FOLDER")
    with tempfile.TemporaryDirectory() as staging:
        subprocess.run(["cmake", "--install", str(build), "--component", "nephoscope_wheel", "--prefix", staging, "--strip"],
                       check=True, stdout=subprocess.DEVNULL)
        finish(Path(staging))
        return _zip(Path(staging), output)


def _zip(staging: Path, output: Path) -> Path:
    dist_info = next(staging.glob("*.dist-info"))
    tag = next(line.split(": ", 1)[1] for line in (dist_info / "WHEEL").read_text().splitlines() if line.startswith("Tag: "))
    wheel = output / f"{dist_info.stem}-{tag}.whl"
    output.mkdir(parents=True, exist_ok=True)
    record = []
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for path in sorted(p for p in staging.rglob("*") if p.is_file()):
            name = path.relative_to(staging).as_posix()
            data = path.read_bytes()
            digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
            record.append(f"{name},sha256={digest},{len(data)}")
            archive.writestr(_entry(name), data)
        archive.writestr(_entry(f"{dist_info.name}/RECORD"), "\n".join([*record, f"{dist_info.name}/RECORD,,", ""]))
    return wheel


def _entry(name: str) -> zipfile.ZipInfo:
    """A file in the wheel, with a fixed time: the same content makes the same wheel."""
    entry = zipfile.ZipInfo(name)
    entry.compress_type, entry.external_attr = zipfile.ZIP_DEFLATED, 0o644 << 16
    return entry


# The hooks of PEP 517 that pip calls.

def get_requires_for_build_wheel(config_settings=None):
    return []


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    return make_wheel(Path((config_settings or {}).get("build", "build")), Path(wheel_directory)).name


def build_sdist(sdist_directory, config_settings=None):
    raise SystemExit("The Python package has no source distribution of its own: its classes are built by CMake.")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=Path, default=Path("build"), help="build tree (default: build)")
    parser.add_argument("--output", type=Path, default=Path("dist"), help="folder of the wheel (default: dist)")
    arguments = parser.parse_args()
    print(make_wheel(arguments.build, arguments.output))


if __name__ == "__main__":
    main()
