#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Breaks the library in the ways of mutants.txt: the tests must notice each.

Two copies of the sources take turns.  For each mutant one text is replaced,
what depends on it is rebuilt, and the tests run until one fails: first the
test named after the file, last test_selftest, which would see any change of a
bit and so hide what the others miss.  A mutant that no test notices fails the
gate; so does one that does not compile, a text that does not occur just once,
and a source without a mutant.

    mutants.py SRC                  the table alone is looked at: for lint
    mutants.py SRC WORK [FILE...]   those of the named files of lib/ only
"""
import concurrent.futures
import os
import pathlib
import queue
import re
import shutil
import subprocess
import sys

PARALLEL = 2
SECONDS = 30  # for one test program; a loop that a mutant made endless ends


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


def complaints(lib, mutants):
    """What is wrong with the table itself."""
    for file, old, new in mutants:
        count = (lib / file).read_text().count(old)
        if count != 1:
            yield f"{file}: '{old}' occurs {count} times, not once"
        if old == new:
            yield f"{file}: '{old}' is not changed"
    code = {str(f.relative_to(lib)) for f in lib.rglob("*.[ch]")
            if re.search(r"^{$", f.read_text(), re.M)}  # has a function
    for file in sorted(code - {file for file, _, _ in mutants}):
        yield f"{file}: no mutant"


class Copy:
    """A copy of the sources with a build of its own."""

    def __init__(self, src, root):
        self.src, self.out = root / "src", root / "out"
        shutil.copytree(src, self.src, ignore=shutil.ignore_patterns(
            ".git", "build", "__pycache__"))
        errors = self.build() or self.failing_test(self.all_tests())
        if errors:
            sys.exit(f"mutants: the unbroken library fails\n{errors}")

    def build(self, target="build-tests"):
        """What the compiler complains of."""
        make = ["make", "-s", "-C", self.src, f"O={self.out}", target,
                "CFLAGS=-O1 -w"]
        run = subprocess.run(make, capture_output=True, text=True)
        return run.stderr if run.returncode else ""

    def own_test(self, file):
        """The test programs that are named after a source or its folder."""
        own = {"test_" + re.split("[/.]", file)[0],
               "test_" + pathlib.Path(file).stem}
        return [self.out / "tests" / name for name in sorted(own)
                if (self.src / f"tests/{name}.c").exists()]

    def all_tests(self):
        tests = [t for t in self.out.glob("tests/test_*") if not t.suffix]
        if not tests:
            sys.exit("mutants: no test program")
        return sorted(tests, key=lambda t: (t.name == "test_selftest", t.name))

    def failing_test(self, tests):
        """The name of the first test that fails, if one does."""
        for test in tests:
            try:
                run = subprocess.run([test], capture_output=True,
                                     cwd=self.out, timeout=SECONDS)
            except subprocess.TimeoutExpired:
                return f"{test.name} (endless)"
            if run.returncode:
                return test.name
        return ""

    def judge(self, mutant):
        """(what became of a mutant, the test that noticed)."""
        file, old, new = mutant
        path = self.src / "lib" / file
        text = path.read_text()
        path.write_text(text.replace(old, new))
        try:
            own = self.own_test(file)
            if any(self.build(test) for test in own):
                return "ERROR", "does not compile"
            killer = self.failing_test(own)
            if not killer:
                if self.build():
                    return "ERROR", "does not compile"
                killer = self.failing_test(self.all_tests())
            return ("killed", killer) if killer else ("SURVIVED", "")
        finally:
            path.write_text(text)


def main(src, work=None, *files):
    mutants = read_table(src / "tests/mutants/mutants.txt")
    wrong = list(complaints(src / "lib", mutants))
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
        for (file, old, new), (fate, by) in zip(mutants,
                                                pool.map(judge, mutants)):
            print(f"{fate:8}  {file:13} {by:24} {old}  =>  {new}", flush=True)
            killed += fate == "killed"
    print(f"{len(mutants)} mutants, {killed} killed")
    sys.exit(killed != len(mutants))


main(*map(pathlib.Path, sys.argv[1:3]), *sys.argv[3:])
