"""Numbers as people read them."""

NONE = "–"


def shown(value, digits=3):
    """A number with so many significant digits, thousands apart."""
    if value is None:
        return NONE
    if value == 0:
        return "0"
    if abs(value) >= 10**digits:
        return f"{value:,.0f}"
    text = f"{value:.{digits}g}"
    return text if "e" not in text else f"{value:.2e}"


def percent(share):
    return NONE if share is None else f"{shown(100 * share)} %"


def times(count):
    return "once" if count == 1 else f"{count:,} times"


def duration(seconds):
    if seconds < 100:
        return f"{shown(seconds)} s"
    minutes, rest = divmod(round(seconds), 60)
    if minutes < 60:
        return f"{minutes} min {rest:02} s"
    hours, minutes = divmod(minutes, 60)
    return f"{hours} h {minutes:02} min"


def rounded(value, digits=5):
    """A number with fewer digits, for data that is drawn."""
    return None if value is None else float(f"{value:.{digits}g}")
