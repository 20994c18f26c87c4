# SPDX-License-Identifier: MIT
"""Rows of a table, shared out among threads: the library lets go of Python's
lock, and a row's bits depend on no other."""
from __future__ import annotations

import operator
import os
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor, wait
from typing import Callable, Iterator, Tuple

Part = Callable[[int, int], None]
"""What is to be done of so many rows, from one on."""

BLOCKS = 16
"""To each thread, so that none waits long for the last."""


def threads_of(workers: int) -> int:
    """How many threads `workers` means: -1 is one for each processor that this
    process may use."""
    number = operator.index(workers)
    if number != -1 and number < 1:
        raise ValueError(f"workers: {number} where 1 or more belongs, or -1 "
                         "for every processor")
    if number > 0:
        return number
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def slices(first: int, end: int) -> Iterator[Tuple[int, int]]:
    """(first, how many) of parts that take some 50 ms each, so that between
    them Python sees Ctrl-C.  No bit depends on them."""
    length = 1
    while first < end:
        length = min(length, end - first)
        before = time.monotonic()
        yield first, length
        taken = time.monotonic() - before
        first += length
        length = 2 * length if taken < 0.05 else max(1, length // 2)


class _Progress:
    """A line on a terminal, of work that takes more than two seconds."""

    def __init__(self, count: int) -> None:
        self.count, self.begun, self.shown = count, time.monotonic(), False

    def show(self, done: int) -> None:
        taken = time.monotonic() - self.begun
        if taken < 2 or not done or not sys.stderr.isatty():
            return
        left = taken * (self.count - done) / done
        print(f"\r{done} of {self.count}, {left:.0f} s to go\033[K", end="",
              file=sys.stderr, flush=True)
        self.shown = True

    def end(self) -> None:
        if self.shown:
            print("\r\033[K", end="", file=sys.stderr, flush=True)


def share_out(count: int, workers: int, do: Part) -> None:
    """Has do(first, how many) done for `count` rows.  After Ctrl-C some are
    done, and some are not."""
    threads = threads_of(workers)
    if threads == 1:
        for part in slices(0, count):
            do(*part)
    elif count:
        _by_threads(count, threads, do)


def _by_threads(count: int, threads: int, do: Part) -> None:
    block = -(-count // (BLOCKS * threads))
    stop, done = threading.Event(), [0] * -(-count // block)

    def run(number: int) -> None:
        first = number * block
        for part in slices(first, min(first + block, count)):
            if stop.is_set():
                return
            do(*part)
            done[number] += part[1]

    progress = _Progress(count)
    with ThreadPoolExecutor(threads) as pool:
        jobs = [pool.submit(run, number) for number in range(len(done))]
        try:
            while wait(jobs, timeout=0.5).not_done:
                progress.show(sum(done))
        finally:
            stop.set()
            progress.end()
    for job in jobs:
        job.result()
