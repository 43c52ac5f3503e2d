# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""run.py [--cases N] [--first SEED] [--jobs N] [CLASS...]: random inputs for every filter and mapper, in processes of their own.

A finding is a crash, a hang, an exception, an invalid result, or a result that differs when the case is run again. Each has a line
`CLASS SEED what`; `run.py --cases 1 --first SEED --calls CLASS` repeats it and prints the calls. Exits with 1 if there are findings.
"""
import argparse
import fnmatch
import os
import signal
import subprocess
import sys
import tempfile
import threading
import time

HERE = os.path.dirname(os.path.abspath(__file__))
BATCH = 200


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("classes", nargs="*", default=["*"], metavar="CLASS", help="names or patterns (default: all)")
    parser.add_argument("--cases", type=int, default=500, help="cases of each class (default: 500)")
    parser.add_argument("--first", type=int, default=0, help="the first seed (default: 0)")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--timeout", type=float, default=60, help="seconds of one case after which it hangs (default: 60)")
    parser.add_argument("--calls", action="store_true", help="print calls and VTK's messages")
    return parser.parse_args()


def names():
    code = f"import sys; sys.path.insert(0, {HERE!r}); import subjects; print(*subjects.NAMES)"
    return subprocess.check_output([sys.executable, "-c", code], text=True).split()


class Batch:
    """Cases first to last of a class; a new process after each crash or hang."""

    def __init__(self, name, first, count, options, tell):
        self.name, self.next, self.last, self.options, self.tell = name, first, first + count, options, tell

    def run(self):
        while self.next < self.last:
            self.process()

    def process(self):
        with tempfile.NamedTemporaryFile("r", suffix=".log") as log, tempfile.TemporaryFile("w+") as said:
            command = [sys.executable, os.path.join(HERE, "worker.py"), log.name, self.name, str(self.next), str(self.last - self.next)]
            process = subprocess.Popen(command + ["--calls"] * self.options.calls, stdin=subprocess.DEVNULL, start_new_session=True,
                                       stdout=None if self.options.calls else said, stderr=subprocess.STDOUT)
            self.watch(process, log, said)

    def watch(self, process, log, said):
        seed, since = None, time.monotonic()
        while True:
            ended = process.poll() is not None
            line = log.readline()
            if line.startswith("start"):
                seed, since = int(line.split()[1]), time.monotonic()
                self.next = seed + 1
            elif line.startswith("found"):
                self.tell(self.name, seed, line[6:].strip())
            elif line.startswith("end"):
                process.wait()
                return
            elif ended:
                said.seek(0)
                self.end(seed, process.returncode, said.read())
                return
            elif time.monotonic() - since > self.options.timeout:
                os.killpg(process.pid, signal.SIGKILL)
                process.wait()
                self.tell(self.name, seed, f"hangs: {self.options.timeout:g} s")
                return
            else:
                time.sleep(0.02)

    def end(self, seed, code, said):
        reason = signal.Signals(-code).name if code < 0 else f"exit status {code}"
        if seed is None:
            raise RuntimeError(f"{self.name}: the worker does not start, {reason}\n{said}")
        self.tell(self.name, seed, f"crash: {reason}")


def batches(options, tell):
    chosen = [name for name in names() if any(fnmatch.fnmatch(name, pattern) for pattern in options.classes)]
    if not chosen:
        sys.exit(f"No class matches {' '.join(options.classes)}. There are: {', '.join(names())}")
    starts = range(options.first, options.first + options.cases, BATCH)
    return [Batch(name, start, min(BATCH, options.first + options.cases - start), options, tell) for start in starts for name in chosen]


def main():
    options, findings, lock, start = arguments(), [], threading.Lock(), time.monotonic()

    def tell(*finding):
        with lock:
            findings.append(finding)
            print(*finding, flush=True)

    left = batches(options, tell)[::-1]

    def work():
        while left:
            with lock:
                batch = left.pop() if left else None
            if batch:
                batch.run()

    threads = [threading.Thread(target=work) for _ in range(options.jobs)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    print(f"{options.cases} cases of each class in {time.monotonic() - start:.0f} s, {len(findings)} findings")
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
