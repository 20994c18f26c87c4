#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What the sources cite exists.

Comments in lib/ and include/ cite equations as (14), or (20)-(22) for all
between; docs/physics.md introduces each as **(14)**, and marks those that the
code computes as **(14)** [code].  Every equation cited must be introduced,
and every marked one cited.  Every test that coin.h or lib/ names as evidence,
such as test_observe, must be a file of tests/.

    citations.py SRC
"""
import pathlib
import re
import sys


def comments(text):
    return " ".join(re.findall(r"/\*.*?\*/|//[^\n]*", text, re.S))


def cited_equations(text):
    """The numbers in "(14)", "(14), (16)" and "(14)-(16)", but not the
    argument in "f(2)"."""
    numbers = set()
    for first, last in re.findall(
            r"(?<![\w\]])\((\d{1,3})\)(?:\s*-\s*\((\d{1,3})\))?", text):
        numbers.update(range(int(first), int(last or first) + 1))
    return numbers


def problems(src):
    files = sorted([*src.glob("lib/**/*.[ch]"), *src.glob("include/*.h")])
    physics = (src / "docs/physics.md").read_text()
    marks = re.findall(r"\*\*\((\d+)\)\*\*( \[code\])?", physics)
    numbers = [int(number) for number, _ in marks]
    coded = {int(number) for number, mark in marks if mark}
    for number in sorted({n for n in numbers if numbers.count(n) > 1}):
        yield f"docs/physics.md introduces ({number}) twice"
    all_cited = set()
    for file in files:
        text = comments(file.read_text())
        cited = cited_equations(text)
        all_cited |= cited
        for number in sorted(cited - set(numbers)):
            yield f"{file}: ({number}) is not in docs/physics.md"
        for test in sorted(set(re.findall(r"\btest_\w+", text))):
            if not (src / "tests" / f"{test}.c").exists():
                yield f"{file}: there is no tests/{test}.c"
    for number in sorted(coded - all_cited):
        yield f"docs/physics.md marks ({number}) as code: nothing cites it"
    print(f"{len(numbers)} equations, {len(all_cited)} cited, "
          f"{len(coded)} marked as code")
    if not all_cited or not coded:
        yield "no citations: has the format changed?"


found = list(problems(pathlib.Path(sys.argv[1])))
print(*found, sep="\n", end="\n" if found else "")
sys.exit(bool(found))
