# SPDX-License-Identifier: MIT
"""The functions of a C source that clang-format has laid out: their braces, and
nothing else's, stand alone at the left."""
import re


def functions(text):
    """(name, first line, last line) of each, counted from 1."""
    lines = text.split("\n")
    for open_at, line in enumerate(lines):
        if line != "{":
            continue
        first = open_at
        while first > 0 and re.match(r"\w| +[^ *]", lines[first - 1]):
            first -= 1
        head = " ".join(lines[first:open_at])
        name = re.search(r"\b(\w+|operator\W+?)\s*\(", head)
        yield name[1], first + 1, lines.index("}", open_at) + 1
