#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A page as Doxygen reads it: each heading has a label, a link to a heading of
a page is a reference to it, and what else it links to lies below docs/.  The
page that tosses coins is a link wherever it is named.

    markdown.py PAGE
"""
import pathlib
import posixpath
import re
import sys

PAGE = pathlib.Path(sys.argv[1]).resolve().relative_to(pathlib.Path.cwd())

TOY = "docs/page/index.html"    # a clone and the site have it


def label(page, heading=""):
    """Of a page, or of a heading of it; README.md is the first page."""
    if str(page) == "README.md" and not heading:
        return "mainpage"
    return "page_" + str(page)[:-3].lower().replace("/", "_") + heading


def slug(title):
    """What GitHub makes of it in a link."""
    kept = re.sub(r"[^\w\- ]", "", title.lower().replace("`", ""))
    return kept.strip().replace(" ", "-")


def one_line(text):
    return " ".join(text.split())


def heading(match):
    marks, title = match.groups()
    of = "" if marks == "#" else "_" + slug(title)
    return f"{marks} {title} {{#{label(PAGE, of)}}}"


def target(to):
    """Where a link leads, in the site."""
    if re.match(r"https?:", to):
        return to
    path, _, part = to.partition("#")
    path = posixpath.normpath(posixpath.join(str(PAGE.parent), path)) if path else ""
    if path in ("include/coin.h", "include/coinf.h"):
        return "@ref " + posixpath.basename(path)
    if not path or path.endswith(".md"):
        return "@ref " + label(path or PAGE, part and "_" + part)
    return path + ("#" + part if part else "")


def main(text):
    parts = re.split(r"(```.*?\n```)", text, flags=re.S)
    for k in range(0, len(parts), 2):
        part = re.sub(r"^(#+) (.*)$", heading, parts[k], flags=re.M)
        part = re.sub(r"`[^`]+`", lambda m: one_line(m[0]), part)
        part = re.sub(r"!\[([^]]*)\]\(([^)]*)\)", lambda m: '<img src="{}" '
                      'alt="{}"/>'.format(target(m[2]), one_line(m[1])),
                      part)
        part = re.sub(r"\[(<img [^>]*>)\]\(([^)]*)\)", lambda m:
                      f'<a href="{target(m[2])}">{m[1]}</a>', part)
        part = re.sub(r"\[([^]]*)\]\(([^)]*)\)",
                      lambda m: f"[{one_line(m[1])}]({target(one_line(m[2]))})",
                      part)
        part = part.replace(f"`{TOY}`", f"[{TOY}]({TOY})")
        parts[k] = re.sub(r"^<!--.*-->\n", "", part, flags=re.M)
    print("".join(parts))


main(PAGE.read_text())
