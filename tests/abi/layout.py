#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Whether structs have only grown as docs/installing.md allows.

    layout.py OLD NEW    two lists, as header.py makes them

Each struct of OLD keeps its size, and each member its offset and size, except
the members called reserved and private_...: the library alone reads those, so
that their places may be divided anew.  No other member may be added there than
within a place that was reserved.  Structs may be added.
"""
import re
import sys

LINE = re.compile(r"(\w+)(?:\.(\w+) offset (\d+))? size (\d+)")


def structs(file):
    """{struct: {member: (begin, end)}}; the struct itself is member None."""
    found = {}
    for line in open(file, encoding="ascii"):
        name, member, offset, size = LINE.fullmatch(line.strip()).groups()
        begin = int(offset or 0)
        found.setdefault(name, {})[member] = begin, begin + int(size)
    if not found:
        raise ValueError(f"{file}: no struct")
    return found


def is_spare(member):
    return member is not None and (member == "reserved" or
                                   member.startswith("private_"))


def problems(old, new):
    for name, members in old.items():
        now = new.get(name, {})
        for member, place in members.items():
            if not is_spare(member) and now.get(member) != place:
                yield f"{name}.{member or 'size'}: {place}, now " \
                      f"{now.get(member, 'gone')}"
        reserved = members.get("reserved", (0, 0))
        for member, (begin, end) in now.items():
            if member not in members and not is_spare(member) and not (
                    reserved[0] <= begin and end <= reserved[1]):
                yield f"{name}.{member}: not where reserved was"


old, new = map(structs, sys.argv[1:3])
found = list(problems(old, new))
print(*found, sep="\n", end="\n" if found else "")
sys.exit(bool(found))
