"""The page of several runs and studies side by side."""

from report import assembly, curves, group, measures, numerals, remarks, verdict
from report.curves import panels_of
from report.markup import Markup, element, joined, table

SCRIPTS = ("curves.js", "page.js")
LEFT_OUT = ("scene.title", "output.")  # keys that change no result


def write(folders, path):
    """Writes the page of results folders; NothingToDraw where one holds no run."""
    groups = group.of(folders)
    runs = [run for one in groups for run in one.runs]
    day = min((last for one in groups if (last := one.last_day()) is not None), default=None)
    panels = [panel(one, groups) for one in panels_of(runs)]
    values = {
        "count": numerals.shown(len(runs)),
        "legend": legend(groups),
        "day": numerals.shown(day),
        "curves": Markup(" ") if panels else "",
        "values": table_of_values(groups, day) if day is not None else "",
        "differences": table_of_differences(groups),
        "runs": table_of_runs(groups),
    }
    heading = " and ".join(folder.resolve().name for folder in folders)
    assembly.write(path, "comparison.html", f"{heading}: restenosisFoam", values, {"panels": panels, "day": day}, SCRIPTS)


def legend(groups):
    return joined(
        element(
            "li",
            element("span", "", class_=f"swatch curve{number % 8}"),
            element("strong", one.name),
            ": ",
            verdict.headline(one.run) if len(one.runs) == 1 else f"{len(one.runs)} runs, shown by their mean and range.",
        )
        for number, one in enumerate(groups)
    )


def panel(drawn, groups):
    """A panel with a line for each group, and a band where it has several runs."""
    lines, bands = [], []
    for number, one in enumerate(groups):
        if not any(run.known(drawn.main.column) for run in one.runs):
            continue
        if len(one.runs) == 1:
            lines.append(curves.line(one.run, drawn.main, "", group=number))
            continue
        days = curves.thinned(one.days())
        found = [one.on(drawn.main, day) for day in days]
        mean, least, most = ([value and numerals.rounded(value[k]) for value in found] for k in range(3))
        lines.append({"name": "", "x": days, "y": mean, "dashed": False, "group": number})
        bands.append({"name": "", "x": days, "low": least, "high": most, "group": number})
    return {"title": drawn.title, "unit": drawn.main.unit, "lines": lines, "bands": bands}


def table_of_values(groups, day):
    rows = []
    for measure in measures.ALL:
        found = [one.on(measure, day) for one in groups]
        if all(value is None for value in found):
            continue
        cells = [_cell(measure, value) for value in found]
        rows.append((f"{measure.label}{f' [{measure.unit}]' if measure.unit else ''}", *cells, *_changes(found)))
    others = [f"{one.name} against {groups[0].name}" for one in groups[1:]] if len(groups) == 2 else []
    return table(("", *(one.name for one in groups), *others), rows, ("", *["number"] * (len(groups) + len(others))))


def _cell(measure, value):
    if value is None:
        return numerals.NONE
    mean, least, most = value
    text = numerals.shown(mean)
    return text if least == most else f"{text} ({numerals.shown(least)} to {numerals.shown(most)})"


def _changes(found):
    """How far the second of two is from the first."""
    if len(found) != 2:
        return []
    if None in found or not found[0][0]:
        return [numerals.NONE]
    return [f"{100 * (found[1][0] / found[0][0] - 1):+.3g} %"]


def table_of_differences(groups):
    scenes = [one.scene() for one in groups]
    sections = [{name.split(".")[0] for name in scene} for scene in scenes]
    rows = []
    for name in dict.fromkeys(name for scene in scenes for name in scene):
        if name.startswith(LEFT_OUT) or len({scene.get(name) for scene in scenes}) == 1:
            continue
        if any(name.split(".")[0] not in modelled for modelled in sections):
            continue  # said once, of the section
        rows.append((element("code", name), *(scene.get(name, numerals.NONE) for scene in scenes)))
    for section in dict.fromkeys(name for modelled in sections for name in sorted(modelled)):
        if len({section in modelled for modelled in sections}) > 1:
            said = ("modelled" if section in modelled else "not modelled" for modelled in sections)
            rows.append((element("code", f"[{section}]"), *said))
    return table(("key", *(one.name for one in groups)), rows) if rows else ""


def table_of_runs(groups):
    rows = []
    for number, one in enumerate(groups):
        for run in one.runs:
            summary = run.summary
            serious = sum(remarks.severity(text) == remarks.WRONG for text in summary.get("remarks", ()))
            name = joined((element("span", "", class_=f"swatch curve{number % 8}"), run.folder.resolve().name))
            rows.append((
                name,
                run.status,
                numerals.shown(run.last("day")),
                summary.get("seed", numerals.NONE),
                summary.get("version", numerals.NONE),
                numerals.duration(summary["totalSeconds"]) if "totalSeconds" in summary else numerals.NONE,
                f"{len(summary.get('remarks', ()))}" + (f", {serious} of weight" if serious else ""),
            ))
    return table(("run", "status", "day", "seed", "version", "time", "remarks"), rows, ("name", "", "number", "number"))
