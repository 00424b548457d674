"""How much a remark of a run matters."""

import re

WRONG, CHECK, NOTE = "may change the result", "worth a look", "for the record"
MEANING = {
    WRONG: "the numbers may be off, or mean something else than was asked for",
    CHECK: "probably harmless: see whether it is as you meant it",
    NOTE: "handled by the program; nothing to do",
}
# Words of remarks as the program makes them; the first that fits counts, and what none fits is worth a look.
RULES = (
    (r"highly skew faces", NOTE),
    (r"solved at the (second|third) attempt", NOTE),
    (r"meshed again|started from rest", NOTE),
    (r"tissue covers the struts but for", NOTE),
    (r"of which struts have passed", WRONG),
    (r"made no cell synthetic", WRONG),
    (r"may be far off", WRONG),
    (r"outflow and inflow differ", WRONG),
    (r"have no lattice node near them", WRONG),
    (r"the mean stress by \S+ differs by", WRONG),
    (r"agents are pressed deeper than the contact law holds for", WRONG),
    (r"the state may differ", WRONG),
    (r"goes on from rest on a new mesh", WRONG),
    (r"solved with other settings than before", WRONG),
    (r"Reynolds|turbulen", WRONG),
    (r"the wall can grow out of its cut face", WRONG),
)
ORDER = (WRONG, CHECK, NOTE)


def severity(remark):
    return next((level for pattern, level in RULES if re.search(pattern, remark)), CHECK)


def by_severity(remarks):
    """[(severity, remark)], what matters most first."""
    return sorted(((severity(remark), remark) for remark in remarks), key=lambda entry: ORDER.index(entry[0]))
