# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every header of the modules compiles alone. One that comes first in the source of the same name is compiled alone by the build;
the others are compiled here, with the options of a source of their module."""
import concurrent.futures
import json
import pathlib
import re
import shlex
import subprocess
import sys

TOP = pathlib.Path(__file__).resolve().parents[2]


def first_include(source):
    found = re.search(r'^\s*#\s*include "([^"]+)"', source.read_text(encoding="utf-8"), re.MULTILINE)
    return found.group(1) if found else None


def headers_to_compile(commands):
    """(header, module folder) of the modules that this build has."""
    for module in sorted(commands):
        for header in sorted(module.rglob("*.h")):
            inside = header.relative_to(module).parts
            nested = any((folder / "vtk.module").exists() for folder in header.parents if module in folder.parents)
            own = header.with_suffix(".cxx")
            if "Testing" not in inside and not nested and not (own.exists() and first_include(own) == header.name):
                yield header, module


def commands_of_modules(build):
    """{module folder: (compiler and options of one of its sources, where they are run)}."""
    commands = {}
    for entry in json.loads((build / "compile_commands.json").read_text(encoding="utf-8")):
        source = pathlib.Path(entry["directory"], entry["file"]).resolve()
        module = next((folder for folder in source.parents if (folder / "vtk.module").exists()), None)
        if module and TOP in module.parents and build not in source.parents and "Testing" not in source.relative_to(module).parts:
            words = shlex.split(entry["command"])
            commands.setdefault(module, (words[:words.index("-o")], entry["directory"]))
    return commands


def errors_of(header, command, folder):
    words = [word for word in command if word not in ("-MD", "-c")]
    for option in ("-MT", "-MF"):
        if option in words:
            del words[words.index(option):words.index(option) + 2]
    # Not as the main file, in which #pragma once and unused functions bring warnings.
    source = f'#include "{header}"\n'
    ran = subprocess.run([*words, "-fsyntax-only", "-x", "c++", "-"], input=source, cwd=folder, capture_output=True, text=True)
    return ran.stderr if ran.returncode else ""


def main(build):
    commands = commands_of_modules(pathlib.Path(build).resolve())
    headers = list(headers_to_compile(commands))
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        results = list(pool.map(lambda each: errors_of(each[0], *commands[each[1]]), headers))
    failed = [(header, errors) for (header, _), errors in zip(headers, results) if errors]
    for header, errors in failed:
        print(f"{header.relative_to(TOP)} does not compile alone:\n{errors}")
    print(f"{len(headers)} headers, {len(failed)} do not compile alone")
    return 1 if failed or not headers else 0


sys.exit(main(sys.argv[1]))
