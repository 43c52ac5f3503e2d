# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""run.py [--fast] [--host python|paraview] [--jobs N] [FUNCTION] [DATASET]: the trials, in processes of their own.

FUNCTION and DATASET are patterns as of the shell, `add_*`. Writes verdicts.csv, verdicts.md and a contact sheet for each function into
the folder that NEPHOSCOPE_TRIALS names, else build/trials. Exits with 1 if a finding is not in known.txt, or one that is there is gone.
"""
import argparse
import collections
import csv
import fnmatch
import json
import os
import shutil
import signal
import subprocess
import sys
import threading
import time

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)
HOSTS = {"python": [sys.executable], "paraview": ["pvpython"]}


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("function", nargs="?", default="*")
    parser.add_argument("dataset", nargs="?", default="*")
    parser.add_argument("--fast", action="store_true", help="the datasets marked for it alone, and of those few for combinations and wrapped classes")
    parser.add_argument("--host", choices=[*HOSTS, "both"], default="both")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--timeout", type=float, default=120, help="seconds for one trial")
    parser.add_argument("--output", default=os.environ.get("NEPHOSCOPE_TRIALS", os.path.join(HERE, "..", "..", "build", "trials")))
    return parser.parse_args()


def environment(host):
    """ParaView's Python also finds PyVista, which makes the datasets."""
    import pyvista
    packages = os.path.dirname(os.path.dirname(pyvista.__file__))
    path = os.environ.get("PYTHONPATH", "")
    return dict(os.environ, PYTHONPATH=path + os.pathsep + packages) if host == "paraview" else dict(os.environ)


def chosen(options):
    """host -> [(function, dataset)]"""
    import importlib

    from datasets import DATASETS
    datasets = [d for d in DATASETS.values() if (d.fast or not options.fast) and fnmatch.fnmatch(d.name, options.dataset)]
    hosts = HOSTS if options.host == "both" else [options.host]
    functions = {host: importlib.import_module(host + "_host").FUNCTIONS.values() for host in hosts}
    return {host: [(f.name, d.name) for f in functions[host] if fnmatch.fnmatch(f.name, options.function)
                   for d in datasets if not f.few or options.dataset == d.name or d.fast and (d.views or not options.fast)] for host in hosts}


class Worker:
    """Runs its trials in one process after the other: a new one after each crash, hang or refusal to start."""

    def __init__(self, host, trials, folder, timeout):
        self.host, self.trials, self.folder, self.timeout, self.results = host, collections.deque(trials), folder, timeout, []

    def run(self):
        """A trial in which a process ends is a finding; two processes that end before any trial, an error."""
        idle = 0
        while self.trials and idle < 2:
            before = len(self.trials)
            reason, text = self.process()
            idle = 0 if self.started or len(self.trials) < before else idle + 1
            if self.trials and self.started:
                function, dataset = self.trials.popleft()
                self.results.append({"function": function, "dataset": dataset, "said": "", "findings": [[reason, text]], "seconds": 0})
        if self.trials:
            print(f"No trial could be started in {self.host}: {text}")

    def process(self):
        """One process, until it ends. Returns ("", "") or why it ended before its trials were done."""
        folder = os.path.join(self.folder, f"worker-{threading.get_ident()}")
        shutil.rmtree(folder, ignore_errors=True)
        os.makedirs(folder)
        log = os.path.join(folder, "log")
        open(log, "w").close()
        with open(os.path.join(folder, "trials"), "w") as f:
            f.write("".join(f"{function} {dataset}\n" for function, dataset in self.trials))
        with open(os.path.join(folder, "output"), "w+") as output:
            process = subprocess.Popen([*HOSTS[self.host], os.path.join(HERE, "worker.py"), self.host, folder], stdin=subprocess.DEVNULL,
                                       env=environment(self.host), stdout=output, stderr=subprocess.STDOUT, text=True, start_new_session=True)
            reason = self.watch(process, log)
            output.seek(0)
            tail = " ".join(output.read().split())[-300:]
        for name in os.listdir(folder):
            if name.endswith(".png"):
                os.replace(os.path.join(folder, name), os.path.join(self.folder, name))
        shutil.rmtree(folder, ignore_errors=True)
        return reason, tail

    def watch(self, process, log):
        self.started, last = False, time.monotonic()
        with open(log) as lines:
            while True:
                ended = process.poll() is not None
                line = lines.readline()
                if line.endswith("\n"):
                    last = time.monotonic()
                    if line.startswith("{"):
                        self.results.append(json.loads(line))
                        self.trials.popleft()
                    self.started = line.startswith("start")
                elif ended:
                    code = process.returncode
                    return "" if not self.trials else f"crash ({signal.Signals(-code).name if code < 0 else code})"
                elif time.monotonic() - last > self.timeout:
                    os.killpg(process.pid, signal.SIGKILL)
                    process.wait()
                    return "hang"
                else:
                    time.sleep(0.05)


def known_findings():
    """(function, dataset, kind) -> reason; a kind that ends in a question mark may be gone."""
    result = {}
    with open(os.path.join(HERE, "known.txt")) as lines:
        for line in lines:
            if line.strip() and not line.startswith("#"):
                function, dataset, kind, reason = line.split(None, 3)
                result[function, dataset, kind] = reason.strip()
    return result


def judged(results, known):
    """Rows (function, dataset, state, kinds, text, said, seconds), and what is to be told."""
    rows, told, seen = [], [], set()
    for r in results:
        name = r["function"], r["dataset"]
        kinds = list(dict.fromkeys(kind.split()[0] for kind, _ in r["findings"]))
        reasons = {k: reason for k in kinds for (f, d, kk), reason in known.items() if kk.rstrip("?") == k and fnmatch.fnmatch(name[0], f)
                   and fnmatch.fnmatch(name[1], d)}
        for (f, d, k) in known:
            if k.rstrip("?") in kinds and fnmatch.fnmatch(name[0], f) and fnmatch.fnmatch(name[1], d):
                seen.add((f, d, k))
        new = [k for k in kinds if k not in reasons]
        state = "finding" if new else "known" if kinds else "ok"
        text = "; ".join(f"{k}: {t}" for k, t in r["findings"])
        rows.append((*name, state, " ".join(kinds), text, r["said"], r["seconds"]))
        if new:
            told.append(f"{name[0]} of {name[1]}: {text}")
    tried = {(r["function"], r["dataset"]) for r in results}
    for (f, d, k), reason in known.items():
        if not k.endswith("?") and (f, d, k) not in seen and any(fnmatch.fnmatch(a, f) and fnmatch.fnmatch(b, d) for a, b in tried):
            told.append(f"{f} of {d}: {k} is in known.txt ({reason}) and is no more: take the line out")
    return rows, told


def write_tables(folder, rows):
    from pictures import contact_sheet
    heads = ("function", "dataset", "state", "kinds", "findings", "said", "seconds")
    with open(os.path.join(folder, "verdicts.csv"), "w", newline="") as f:
        csv.writer(f).writerows([heads, *rows])
    with open(os.path.join(folder, "verdicts.md"), "w") as f:
        f.write("| function | trials | ok | known | findings |\n|---|---|---|---|---|\n")
        for function in dict.fromkeys(r[0] for r in rows):
            mine = [r for r in rows if r[0] == function]
            count = collections.Counter(r[2] for r in mine)
            f.write(f"| {function} | {len(mine)} | {count['ok']} | {count['known']} | {count['finding']} |\n")
            contact_sheet(os.path.join(folder, f"sheet-{function.replace(' ', '_')}.png"), [(r[0], r[1], r[2], r[5] or r[4]) for r in mine], folder)
        f.write("\n| function | dataset | findings |\n|---|---|---|\n")
        f.writelines(f"| {r[0]} | {r[1]} | {r[4].replace('|', '/')} |\n" for r in rows if r[2] != "ok")


def main():
    options = arguments()
    folder = os.path.abspath(options.output)
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    trials = chosen(options)
    workers = [Worker(host, [t for f in dict.fromkeys(f for f, _ in part) for t in part if t[0] == f], folder, options.timeout)
               for host, all_of_host in trials.items() for part in parts(all_of_host, options.jobs)]
    start = time.monotonic()
    lanes = [workers[k::options.jobs] for k in range(options.jobs)]
    threads = [threading.Thread(target=lambda lane=lane: [w.run() for w in lane]) for lane in lanes if lane]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    order = {name: k for k, name in enumerate(t for all_of_host in trials.values() for t in all_of_host)}
    results = sorted((r for w in workers for r in w.results), key=lambda r: order[r["function"], r["dataset"]])
    rows, told = judged(results, known_findings())
    write_tables(folder, rows)
    print("\n".join(told))
    count = collections.Counter(r[2] for r in rows)
    print(f"{len(rows)} trials in {time.monotonic() - start:.0f} s: {count['ok']} ok, {count['known']} with known findings, {count['finding']} with "
          f"findings. Tables and contact sheets: {folder}")
    return 1 if told or len(rows) != len(order) else 0


def parts(trials, jobs):
    """Shares of about equal size, neighbours together."""
    size = max(-(-len(trials) // jobs), 1)
    return [trials[k:k + size] for k in range(0, len(trials), size)]


if __name__ == "__main__":
    sys.exit(main())
