# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Where the time of a film goes.

    watch = Stopwatch()
    watch.follow("reading", reader)    every execution of an algorithm, without those before it in the pipeline
    with watch.part("drawing"):
        window.Render()
    print(watch.report(96))            seconds a frame: elapsed, and of all processors
"""
import contextlib
import time


class Stopwatch:
    def __init__(self):
        self.parts = {}

    def follow(self, name, algorithm):
        started = []
        self.parts.setdefault(name, [0.0, 0.0])
        algorithm.AddObserver("StartEvent", lambda *_: started.append(now()))
        algorithm.AddObserver("EndEvent", lambda *_: self.add(name, started.pop()) if started else None)

    @contextlib.contextmanager
    def part(self, name):
        start = now()
        yield
        self.add(name, start)

    def add(self, name, start):
        part = self.parts.setdefault(name, [0.0, 0.0])
        for i, (end, begin) in enumerate(zip(now(), start)):
            part[i] += end - begin

    def report(self, frames):
        frames = max(1, frames)
        parts = ["%s %.2f (%.2f)" % (name, elapsed / frames, processor / frames) for name, (elapsed, processor) in self.parts.items()]
        return "seconds a frame, elapsed (of all processors): " + ", ".join(parts)


def now():
    return time.monotonic(), time.process_time()
