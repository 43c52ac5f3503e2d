# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The files that the wheel is made from: named in debian.txt and vtk.txt, fetched once, compared with their SHA-256 always."""
import hashlib
import os
import re
import shutil
import subprocess
import sys
import urllib.error
import urllib.request
from pathlib import Path

HERE = Path(__file__).resolve().parent
# A version that the archive has replaced is still in the archive of all days.
ARCHIVES = ("http://deb.debian.org/debian/", "http://snapshot.debian.org/archive/debian/20261122T000000Z/",
            "http://snapshot.debian.org/archive/debian-security/20261122T000000Z/")
PYTHONS = ("3.11", "3.12", "3.13", "3.14")


def cpython(python):
    """'3.11' as wheels have it: 'cp311'."""
    return "cp" + python.replace(".", "")


def vtk_version():
    """The version of VTK that vtk.txt pins."""
    return re.search(r"^vtk==(\S+)", (HERE / "vtk.txt").read_text(), re.MULTILINE)[1]


def debian_packages(purpose):
    """[(SHA-256, path in the archive)] of the packages for a purpose: 'sdk', 'cp311', ..."""
    lines = [line.split() for line in (HERE / "debian.txt").read_text().splitlines() if line and line[0] != "#"]
    return [(digest, path) for key, digest, path in lines if key == purpose]


def sha256(path):
    with open(path, "rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


def fetch_debian(purpose, folder):
    """The packages for a purpose, as {name: file} in a folder; exits with the remedy where one cannot be had."""
    folder.mkdir(parents=True, exist_ok=True)
    return {Path(path).name.split("_")[0]: _fetch(digest, path, folder) for digest, path in debian_packages(purpose)}


def _fetch(digest, path, folder):
    file = folder / Path(path).name
    if file.is_file() and sha256(file) == digest:
        return file
    archives = [os.environ["NEPHOSCOPE_DEBIAN_ARCHIVE"]] if "NEPHOSCOPE_DEBIAN_ARCHIVE" in os.environ else ARCHIVES
    problems = []
    for archive in archives:
        print(f"fetching {file.name}", flush=True)
        try:
            with urllib.request.urlopen(archive + path, timeout=60) as answer:
                file.write_bytes(answer.read())
        except (urllib.error.URLError, OSError) as error:
            problems.append(f"{archive}{path}: {error}")
            continue
        if sha256(file) == digest:
            return file
        file.unlink()
        problems.append(f"{archive}{path}: its SHA-256 is not {digest}")
    sys.exit("\n".join(["Could not fetch a Debian package that the wheel is made from:", *problems,
                        "Set NEPHOSCOPE_DEBIAN_ARCHIVE to the URL of an archive that has it, ending in '/'."]))


def fetch_vtk(python, folder):
    """The wheel of VTK for a Python, by pip, which compares its hash with vtk.txt."""
    pattern = f"vtk-{vtk_version()}-{cpython(python)}-{cpython(python)}-*x86_64.whl"
    folder.mkdir(parents=True, exist_ok=True)
    pinned = set(re.findall(r"sha256:(\w+)", (HERE / "vtk.txt").read_text()))
    for file in folder.glob(pattern):
        if sha256(file) in pinned:
            return file
        file.unlink()
    subprocess.run([sys.executable, "-m", "pip", "download", "--no-deps", "--only-binary=:all:", "--require-hashes", "--dest", folder,
                    "--python-version", python, "--implementation", "cp", "--platform", "manylinux2014_x86_64",
                    "--requirement", HERE / "vtk.txt"], check=True)
    return next(folder.glob(pattern))


def python_headers(python, folder):
    """The folders to include for a Python: of Debian's package, or of an interpreter on the path where there is no package."""
    packages = fetch_debian(cpython(python), folder)
    if packages:
        unpacked = unpack(*packages.values(), folder)
        return [unpacked / "usr/include" / f"python{python}", unpacked / "usr/include"]
    interpreter = f"python{python}"
    ask = "import sysconfig; print(sysconfig.get_path('include'))"
    try:
        include = Path(subprocess.run([interpreter, "-c", ask], check=True, capture_output=True, text=True).stdout.strip())
    except (FileNotFoundError, subprocess.CalledProcessError):
        include = Path()
    if not (include / "Python.h").is_file():
        sys.exit(f"Debian has no headers of Python {python}, and no {interpreter} with headers is on the path. Install Python {python} "
                 "with its headers, for example from python.org or by uv, and put it on the path.")
    return [include]


def unpack(package, folder):
    """The folder that holds a Debian package's files."""
    unpacked = folder / "unpacked" / package.stem
    if not unpacked.is_dir():
        unpacked.parent.mkdir(exist_ok=True)
        partial = unpacked.with_name(unpacked.name + ".partial")
        shutil.rmtree(partial, ignore_errors=True)
        subprocess.run(["dpkg-deb", "--extract", package, partial], check=True)
        partial.rename(unpacked)
    return unpacked
