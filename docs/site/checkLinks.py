#!/usr/bin/env python3
"""Checks that links, pictures and anchors of a site lead somewhere, and that no page loads anything from elsewhere.

    docs/site/checkLinks.py SITE
"""
import html.parser
import pathlib
import sys
import urllib.parse

LOADING = {("img", "src"), ("script", "src"), ("link", "href")}


class Page(html.parser.HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.anchors, self.targets = set(), []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        given = dict(attributes)
        self.anchors |= {given[name] for name in ("id", "name") if given.get(name)}
        for name in ("href", "src"):
            if given.get(name) is not None:
                self.targets.append((tag, name, given[name]))


def problems(site):
    pages = {path.resolve(): Page(path.read_text(encoding="utf-8")) for path in site.rglob("*.html")
             if path.name != "404.html"}  # its links count from the root of a server
    for path, page in pages.items():
        for tag, name, target in page.targets:
            parts = urllib.parse.urlsplit(target)
            if parts.scheme or parts.netloc:
                if (tag, name) in LOADING and parts.scheme != "data":
                    yield f"{path}: loads {target}"
                continue
            to = (path.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else path
            anchor = urllib.parse.unquote(parts.fragment)
            if to.is_dir():
                to = to / "index.html"
            if not to.exists():
                yield f"{path}: {target} does not exist"
            elif anchor and to in pages and anchor not in pages[to].anchors and not anchor.startswith("__"):
                yield f"{path}: {target} has no such anchor"


def main():
    found = list(problems(pathlib.Path(sys.argv[1])))
    print("\n".join(found), file=sys.stderr, end="\n" if found else "")
    return 1 if found else 0


sys.exit(main())
