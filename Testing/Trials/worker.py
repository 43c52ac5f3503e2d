# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""worker.py HOST FOLDER: runs the trials that FOLDER/trials names, `function dataset` a line, one after the other.

Writes `start FUNCTION DATASET` and then one line of JSON for each to FOLDER/log, and pictures beside it; the parent sees from it where
a worker ended or hangs. It is a process of its own, so that a crash is one finding.
"""
import faulthandler
import importlib
import json
import os
import sys
import time

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))


def main():
    host, folder = sys.argv[1:3]
    faulthandler.enable(os.fdopen(os.dup(2), "w"))  # the trials redirect 2
    log = open(os.path.join(folder, "log"), "a", buffering=1)
    from datasets import DATASETS
    from pictures import write
    module = importlib.import_module(host + "_host")
    for line in open(os.path.join(folder, "trials")).read().splitlines():  # not standard input: pvpython keeps that
        function, dataset = line.split()
        log.write(f"start {function} {dataset}\n")
        start = time.monotonic()
        verdict, image = module.trial(function, DATASETS[dataset])
        if image is not None:
            write(os.path.join(folder, f"{function}@{dataset}.png"), image)
        log.write(json.dumps({"function": function, "dataset": dataset, "said": verdict.said, "findings": verdict.findings,
                              "seconds": round(time.monotonic() - start, 2)}) + "\n")
    log.write("end\n")
    log.close()
    os._exit(0)  # what ends after this is Python's and VTK's own


main()
