"""Puts a page together from the files in page/: one file that needs no network."""

import json
import re
import string
from pathlib import Path

from report.markup import escape

PAGE = Path(__file__).parent / "page"
LIBRARY = "vendor/three.min.js"


def _read(name):
    return (PAGE / name).read_text(encoding="utf-8")


def _without_empty(template, values):
    """The template without the parts, between <!--name--> and <!--/name-->, whose value is empty."""

    def kept(match):
        return _without_empty(match[2], values) if values.get(match[1]) else ""

    return re.sub(r"<!--(\w+)-->(.*?)<!--/\1-->", kept, template, flags=re.DOTALL)


def _script_data(data):
    """JSON that cannot end the element it stands in."""
    return json.dumps(data, separators=(",", ":"), allow_nan=False).replace("<", "\\u003c")


def _filled(template, values):
    return string.Template(_without_empty(_read(template), values)).substitute(values)


def write(path, template, heading, values, data, scripts):
    """Fills a template by `values`, HTML by name; `data` is for the scripts. Replaces the file once it is whole."""
    whole = {
        "heading": escape(heading),
        "style": _read("page.css"),
        "body": _filled(template, values),
        "data": _script_data(data),
        "scripts": "\n".join(f"<script>\n{_read(name)}</script>" for name in scripts),
    }
    page = _filled("page.html", whole)
    partial = path.with_name(path.name + ".partial")
    partial.write_text(page, encoding="utf-8")
    partial.replace(path)
