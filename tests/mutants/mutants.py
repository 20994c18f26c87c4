#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Breaks the library in the ways of mutants.txt: the tests must notice each.

Two copies of the sources take turns.  For each mutant one text is replaced,
what depends on it is rebuilt, and the tests run until one fails.  First come
the tests that are named after the file, then those that noticed other mutants
of it, then the rest, the quick ones first: as in `make check`, and where none
fails once more as in `make check-long`.  test_selftest would see any change
of a bit and so hide what the others miss: only the mutants of the self-tests
are shown to it.  A mutant that no test notices fails the gate; so does one that
does not compile, a text that does not occur just once, and a source without a
mutant.

A file is named by its path below lib/, or by as much of the end of that path
as no other file has.

    mutants.py SRC                  the table alone is looked at: for lint
    mutants.py SRC WORK [FILE...]   those of the named files of lib/ only
"""
import concurrent.futures
import os
import pathlib
import queue
import re
import shutil
import signal
import subprocess
import sys
import time

PARALLEL = 2
# Of the processor, for the tests of one file: a loop that a mutant made endless
# ends, and a busy machine ends no other.
SECONDS = 30
OTHERS = {".awk", ".map", ".md", ".mk"}  # files of lib/ that no compiler reads

# The usual tests, and the long ones with the usual seeds.
USUAL = {"ROLLCOIN_TRIES": "1"}
LONG = {"ROLLCOIN_LONG": "1", "ROLLCOIN_TRIES": "8"}

# What the runs so far have taught: the tests' times, and for each file the
# tests that noticed a mutant.
SECONDS_OF, NOTICED = {}, {}


def read_table(path):
    """The (file, old, new) of each mutant."""
    mutants, file = [], None
    for line in path.read_text().splitlines():
        if line.startswith("#") or not line.strip():
            continue
        if not line[0].isspace():
            file = line.strip()
        else:
            old, new = re.split(r" +=> *", line.strip(), maxsplit=1)
            mutants.append((file, old, new))
    return mutants


def sources(lib):
    """The paths below lib of all files that could have a function."""
    return sorted(str(f.relative_to(lib)) for f in lib.rglob("*")
                  if f.suffix not in OTHERS and f.is_file())


def found(name, paths):
    """The path that a name stands for; without just one, the name."""
    if name in paths:
        return name
    ends = [path for path in paths if path.endswith("/" + name)]
    return ends[0] if len(ends) == 1 else name


def complaints(lib, mutants):
    """What is wrong with the table itself."""
    paths = sources(lib)
    for file, old, new in mutants:
        if file not in paths:
            yield f"{file}: no such file in lib/, or several"
            continue
        count = (lib / file).read_text().count(old)
        if count != 1:
            yield f"{file}: '{old}' occurs {count} times, not once"
        if old == new:
            yield f"{file}: '{old}' is not changed"
    code = {path for path in paths
            if re.search(r"^{$", (lib / path).read_text(), re.M)}
    for file in sorted(code - {file for file, _, _ in mutants}):
        yield f"{file}: no mutant"


class Copy:
    """A copy of the sources with a build of its own.  A test is the name of its
    file without .c.  The tests are linked to a shared library, so that a mutant
    seldom costs more than its own link."""

    def __init__(self, src, root):
        self.src, self.out = root / "src", root / "out"
        shutil.copytree(src, self.src, ignore=shutil.ignore_patterns(
            ".git", "build", "__pycache__"))
        self.library = self.out / "mutant.so"
        errors = self.build()
        if errors:
            sys.exit(f"mutants: the unbroken library fails\n{errors}")

    def build(self, *tests):
        """Builds the library, then these tests, or all; what the compiler
        complains of."""
        run = subprocess.run(
            ["make", "-s", "-C", self.src, f"O={self.out}", self.library,
             self.out / "librollcoin.a", "build-tests",
             *([f"TESTS={' '.join(f'tests/{t}.c' for t in tests)}"] if tests
               else []),
             "CFLAGS=-O1 -w", "HIDDEN=-fPIC", "TESTED=",
             f"CMOCKA_LIBS=-lcmocka {self.library}"],
            capture_output=True, text=True)
        return run.stderr if run.returncode else ""

    def own_tests(self, file):
        """The tests named after a source or its room: of
        float/coinf_step.c test_float_step, test_step and test_float, of
        step/rk4.t.h test_rk4."""
        *_, room, name = ["", *pathlib.Path(file).parts]
        stem = name.split(".")[0].removeprefix("coinf_")
        names = (f"test_{room}_{stem}", f"test_{stem}", f"test_{room}")
        return [name for name in names
                if (self.src / f"tests/{name}.c").exists()]

    def all_tests(self):
        return sorted(f.stem for f in self.src.glob("tests/test_*.c"))

    def failing_test(self, tests, how):
        """The name of the first test that fails, if one does."""
        for test in tests:
            start = time.monotonic()
            run = subprocess.run(["prlimit", f"--cpu={SECONDS}:",
                                  self.out / "tests/run", test],
                                 capture_output=True, cwd=self.out,
                                 env=os.environ | how)
            SECONDS_OF[test] = time.monotonic() - start
            if run.returncode == -signal.SIGXCPU:
                return f"{test} (endless)"
            if run.returncode:
                return test
        return ""

    def likely_first(self, file):
        """All tests but test_selftest, in the order to try them in for a mutant
        of a file."""
        def rank(test):
            return test not in NOTICED.get(file, ()), SECONDS_OF.get(test, 0)
        return sorted(set(self.all_tests()) - {"test_selftest"}, key=rank)

    def judge(self, mutant):
        """(what became of a mutant, the test that noticed)."""
        file, old, new = mutant
        path = self.src / "lib" / file
        text = path.read_text()
        path.write_text(text.replace(old, new))
        try:
            own = self.own_tests(file)
            if own and self.build(*own):
                return "ERROR", "does not compile"
            killer = self.failing_test(own, USUAL)
            if not killer:
                if self.build():
                    return "ERROR", "does not compile"
                rest = [test for test in self.likely_first(file)
                        if test not in own]
                killer = (self.failing_test(rest, USUAL) or
                          self.failing_test(own + rest, LONG))
                NOTICED.setdefault(file, set()).add(killer.split(" ")[0])
            return ("killed", killer) if killer else ("SURVIVED", "")
        finally:
            path.write_text(text)


def main(src, work=None, *files):
    lib = src / "lib"
    mutants = [(found(file, sources(lib)), old, new) for file, old, new
               in read_table(src / "tests/mutants/mutants.txt")]
    files = [found(file, sources(lib)) for file in files]
    wrong = list(complaints(lib, mutants))
    wrong += [f"{file}: no mutant" for file in
              sorted(set(files) - {file for file, _, _ in mutants})]
    if wrong:
        sys.exit("\n".join(wrong))
    if not work:
        return
    mutants = [m for m in mutants if not files or m[0] in files]
    work = work.absolute()
    shutil.rmtree(work, ignore_errors=True)
    os.environ.pop("MAKEFLAGS", None)  # the flags of the make that runs this
    copies = queue.SimpleQueue()

    def judge(mutant):
        copy = copies.get()
        try:
            return copy.judge(mutant)
        finally:
            copies.put(copy)

    killed = 0
    with concurrent.futures.ThreadPoolExecutor(PARALLEL) as pool:
        for copy in pool.map(lambda i: Copy(src, work / f"copy{i}"),
                             range(PARALLEL)):
            copies.put(copy)
        failing = copy.failing_test(copy.all_tests(), LONG)
        if failing:
            sys.exit(f"mutants: the unbroken library fails {failing}")
        for (file, old, new), (fate, by) in zip(mutants,
                                                pool.map(judge, mutants)):
            print(f"{fate:8}  {file:13} {by:24} {old}  =>  {new}", flush=True)
            killed += fate == "killed"
    print(f"{len(mutants)} mutants, {killed} killed")
    sys.exit(killed != len(mutants))


main(*map(pathlib.Path, sys.argv[1:3]), *sys.argv[3:])
