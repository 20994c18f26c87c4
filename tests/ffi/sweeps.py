#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A map of launches has one hash: by one process, by Dask while a worker is
killed, and by MPI when the job is killed and begun again.  The package is
installed."""
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest

EXAMPLES = pathlib.Path(__file__).parents[2] / "docs" / "examples" / "python"
SIZES = {"roll": ["--leans", "80", "--spins", "300", "--rows", "2"],
         "toss": ["--leans", "80", "--spins", "2400", "--rows", "2",
                  "--kind", "toss"]}  # 40 tiles, of some 0.1 s
TILES = 40
MPIRUN = ["mpirun", "--oversubscribe", "-n", "2"]
# Neither a user nor a remote shell matters to a job of one machine.
MPI = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1",
       "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMPI_MCA_plm": "isolated"}
PATIENCE = 120  # s


def begin(folder, program, *options, before=(), environment=None):
    return subprocess.Popen(
        [*before, sys.executable, EXAMPLES / program, folder, *options],
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
        env=environment)


def end(sweep):
    """(whether it did well, its hash, what it said)."""
    out, err = sweep.communicate(timeout=PATIENCE)
    found = re.search(r"hash (\w{64})", out)
    return sweep.returncode == 0, found and found.group(1), out + err


def descendants(pid):
    for task in pathlib.Path(f"/proc/{pid}/task").glob("*/children"):
        for child in map(int, task.read_text().split()):
            yield child
            yield from descendants(child)


def command(pid):
    return pathlib.Path(f"/proc/{pid}/cmdline").read_text()


def tiles(folder):
    return {path: path.stat().st_mtime_ns
            for path in pathlib.Path(folder).glob("*/*.npz")}


def wait_for_tiles(folder, sweep, count):
    until = time.monotonic() + PATIENCE
    while len(tiles(folder)) < count:
        assert sweep.poll() is None, sweep.communicate()
        assert time.monotonic() < until
        time.sleep(0.01)


def kill_one(sweep, what):
    """A process below the sweep whose command says so."""
    victim = next(pid for pid in descendants(sweep.pid)
                  if what in command(pid))
    os.kill(victim, signal.SIGKILL)


class Sweeps(unittest.TestCase):
    size = SIZES["roll"]

    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as folder:
            well, cls.hash, cls.said = end(begin(folder, "tiles.py", *cls.size))
        assert well and cls.hash, cls.said

    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = temporary.name

    def test_a_worker_that_is_killed_costs_dask_a_tile(self):
        sweep = begin(self.folder, "sweep_dask.py", "--workers", "2",
                      *self.size)
        wait_for_tiles(self.folder, sweep, 3)
        kill_one(sweep, "spawn_main")
        self.assertLess(len(tiles(self.folder)), TILES)
        well, found, said = end(sweep)
        self.assertTrue(well, said)
        self.assertEqual(found, self.hash)
        self.assertIn("tiles, ", said)

    def test_a_rank_that_is_killed_costs_mpi_the_tiles_at_hand(self):
        sweep = begin(self.folder, "sweep_mpi.py", *self.size, before=MPIRUN,
                      environment=MPI)
        wait_for_tiles(self.folder, sweep, 3)
        kill_one(sweep, "sweep_mpi.py")
        self.assertFalse(end(sweep)[0])
        kept = tiles(self.folder)
        self.assertTrue(3 <= len(kept) < TILES, len(kept))
        well, found, said = end(begin(self.folder, "sweep_mpi.py", *self.size,
                                      before=MPIRUN, environment=MPI))
        self.assertTrue(well, said)
        self.assertEqual(found, self.hash)
        after = tiles(self.folder)
        self.assertEqual(kept, {path: after[path] for path in kept})

    def test_a_killed_process_leaves_no_half_of_a_tile(self):
        for round_ in range(3):
            sweep = begin(self.folder, "tiles.py", *self.size)
            wait_for_tiles(self.folder, sweep, 4 * round_ + 2)
            sweep.kill()
            sweep.communicate()
        well, found, said = end(begin(self.folder, "tiles.py", *self.size))
        self.assertTrue(well, said)
        self.assertEqual(found, self.hash)


class Tosses(Sweeps):
    """The same of a map of tosses."""
    size = SIZES["toss"]

    def test_either_side_ends_up(self):
        heads = float(re.search(r"([0-9.]+) of them heads", self.said)[1])
        self.assertTrue(0.4 < heads < 0.6, heads)

    def test_a_tile_that_lost_its_workers_is_told(self):
        sweep = begin(self.folder, "sweep_dask.py", "--workers", "2",
                      *self.size, environment={
                          **os.environ,
                          "DASK_DISTRIBUTED__SCHEDULER__ALLOWED_FAILURES": "0"})
        wait_for_tiles(self.folder, sweep, 3)
        kill_one(sweep, "spawn_main")
        well, _, said = end(sweep)
        self.assertFalse(well)
        self.assertIn("the same command goes on", said.lower())
        well, found, said = end(begin(self.folder, "sweep_dask.py",
                                      "--workers", "2", *self.size))
        self.assertTrue(well, said)
        self.assertEqual(found, self.hash)

    def test_nothing_to_sweep_is_told(self):
        for wrong in (["--spins", "0"], ["--kind", "spin"]):
            well, _, said = end(begin(self.folder, "tiles.py", *wrong))
            self.assertFalse(well)
            self.assertRegex(said, "1 or more|invalid choice")


if __name__ == "__main__":
    unittest.main()
