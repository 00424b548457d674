"""Makes HTML of values: text is escaped, what is made here is not escaped again."""

import html


class Markup(str):
    """Text that is HTML already."""


def escape(value):
    return value if isinstance(value, Markup) else Markup(html.escape(str(value)))


def element(name, *children, **attributes):
    """<name attributes>children</name>; a trailing underscore of an attribute's name is left out."""
    given = "".join(
        f' {key.rstrip("_").replace("_", "-")}="{html.escape(str(value))}"' for key, value in attributes.items()
    )
    return Markup(f"<{name}{given}>{joined(children)}</{name}>")


def joined(parts, separator=""):
    return Markup(separator.join(escape(part) for part in parts))


def table(head, rows, classes=()):
    """A table that scrolls sideways where it is too wide; `classes`: of the cells of a column."""
    classes = [*classes, *[""] * (len(head) - len(classes))]

    def line(kind, cells):
        return element("tr", *(element(kind, cell, class_=cls) for cell, cls in zip(cells, classes)))

    body = element("tbody", *(line("td", row) for row in rows))
    return element("div", element("table", element("thead", line("th", head)), body), class_="wide")


def items(texts):
    return element("ul", *(element("li", text) for text in texts))
