# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""processor_times.py BUILD [PATTERN]: runs the tests of a build folder whose names match one after the other and prints the processor seconds
of each, with those of all its processes, and at the end all of them sorted. These, unlike times by the clock, hardly depend on what else runs."""
import json
import os
import re
import resource
import subprocess
import sys


def tests(build, pattern):
    listed = subprocess.run(["ctest", "--test-dir", build, "--show-only=json-v1"], capture_output=True, text=True, check=True)
    for test in json.loads(listed.stdout)["tests"]:
        if re.search(pattern, test["name"]):
            yield test["name"], test["command"], {p["name"]: p["value"] for p in test["properties"]}


def seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def verdict(command, properties):
    environment = dict(entry.split("=", 1) for entry in properties.get("ENVIRONMENT", []))
    try:
        ran = subprocess.run(command, env={**os.environ, **environment}, cwd=properties["WORKING_DIRECTORY"], stdout=subprocess.PIPE,
                             stderr=subprocess.STDOUT, text=True, errors="replace", timeout=properties.get("TIMEOUT", 1500))
    except subprocess.TimeoutExpired:
        return "timeout"
    said = properties.get("PASS_REGULAR_EXPRESSION")
    if ran.returncode == properties.get("SKIP_RETURN_CODE"):
        return "skipped"
    return "passed" if (any(re.search(s, ran.stdout) for s in said) if said else ran.returncode == 0) else "failed"


def main(build, pattern=""):
    rows = []
    for name, command, properties in tests(build, pattern):
        before = seconds()
        state = verdict(command, properties)
        rows.append((seconds() - before, name, state))
        print(f"{rows[-1][0]:8.2f} s  {name}  {state}", flush=True)
    print(f"\n{sum(row[0] for row in rows):8.2f} s  {len(rows)} tests")
    for used, name, state in sorted(rows, reverse=True):
        print(f"{used:8.2f} s  {name}  {state}")


if __name__ == "__main__":
    main(*sys.argv[1:])
