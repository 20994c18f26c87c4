#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every link of a site leads to a file, and to a place of it that is there;
nothing is taken from a network.

    links.py SITE
"""
import html.parser
import pathlib
import sys
import urllib.parse


class Page(html.parser.HTMLParser):
    def __init__(self, file):
        super().__init__()
        self.names, self.links = set(), []
        self.feed(file.read_text(errors="replace"))

    def handle_starttag(self, tag, attrs):
        attrs = dict(attrs)
        self.names |= {attrs[a] for a in ("id", "name") if attrs.get(a)}
        for a in "href", "src", "data":
            if attrs.get(a):
                self.links.append((tag, attrs[a]))


def problems(site):
    pages = {f: Page(f) for f in sorted(site.glob("*.html"))}
    for file, page in pages.items():
        for tag, link in page.links:
            to = urllib.parse.urlparse(link)
            if to.scheme in ("http", "https"):
                if tag != "a":
                    yield f"{file.name}: {tag} needs the network: {link}"
                continue
            if to.scheme:
                continue
            path = (file.parent / urllib.parse.unquote(to.path)
                    if to.path else file)
            if not path.exists():
                yield f"{file.name}: no {link}"
            elif to.fragment and path in pages and \
                    urllib.parse.unquote(to.fragment) not in pages[path].names:
                yield f"{file.name}: no place {link}"
    print(f"{len(pages)} pages, {sum(len(p.links) for p in pages.values())} links")


found = sorted(set(problems(pathlib.Path(sys.argv[1]))))
print(*found, sep="\n", end="\n" if found else "")
sys.exit(bool(found))
