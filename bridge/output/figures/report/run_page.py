"""The page of one run."""

import sys

from report import assembly, curves, limits, measures, numerals, provenance, remarks, verdict
from report.images import embedded
from report.markup import Markup, element, items, joined, table
from report.record import Run

PICTURES = {
    "vessel.png": "The vessel cut open along its axis on the last day: stent, new tissue, laminae and media. "
    "The scale bar lies along the vessel.",
    "section.png": "The wall where new tissue is thickest, on the first and the last day in the same frame: across (A), "
    "enlarged (B) and along the vessel (C). The line is that of the inner elastic lamina, which goes on where it is "
    "injured.",
    "beats.png": "The stress over the last beat of the last flow: its mean size (A), how far it goes to and fro (B), how "
    "long blood stays at the wall (C), and what acts across the flow (D).",
    "crossCheck.png": "Wall shear stress by another method against the run's own, and what it would have decided.",
}
PARTS = {
    "pack": "the wall is packed with cells",
    "deploy": "the stent is pressed in",
    "relax": "tissue comes to rest in each step",
    "biology": "cells cycle, divide, rest",
    "surface": "the lumen's surface is taken",
    "mesh": "the lumen is meshed",
    "flow": "the flow is solved",
    "crossCheck": "another method checks the flow",
    "output": "files are written",
}
SCRIPTS = ("packed.js", "colours.js", "curves.js")
SPACE_SCRIPTS = (assembly.LIBRARY, "lumenData.js", "space.js", "maps.js", "lumen.js")


def write(folder, path):
    """Writes the page of a results folder; NothingToDraw where it holds no run."""
    run = Run(folder)
    lumen = lumen_in_space(folder)
    panels = curves.of(run) if run.grows else []
    values = {
        "title": element("span", run.title),
        "name": element("span", run.name),
        "status": status(run),
        "headline": element("p", verdict.headline(run), class_="headline"),
        "verdict": joined(element("p", text) for text in verdict.sentences(run)),
        "tiles": tiles(run),
        "curves": Markup(" ") if panels else "",
        "lumen": Markup(" ") if lumen else "",
        "maps": Markup(" ") if lumen and lumen["kind"] == "grid" else "",
        "growth": Markup(" ") if run.grows else "",
        "still": Markup(" ") if not run.has_tissue else "",
        "struts": Markup(" ") if lumen and lumen["struts"] else "",
        "resting": Markup(" ") if lumen and lumen["resting_Pa"] and lumen["stress"] else "",
        "values": table_of_values(run),
        "columns": all_columns(run),
        "pictures": pictures(folder),
        "remarks": list_of_remarks(run),
        "severities": joined((f"{level}: {text}" for level, text in remarks.MEANING.items()), "; "),
        "limits": items(limits.of(run)) if limits.of(run) else "",
        "plan": plan(run),
        "cost": cost(run),
        "differences": differences(run),
        "scene": element("pre", run.scene_text) if run.scene_text else "",
        "provenance": table(("", ""), provenance.of(run)),
        "version": element("span", run.summary.get("version", "unknown")),
    }
    data = {"panels": panels, "lumen": lumen}
    scripts = SCRIPTS + (SPACE_SCRIPTS if lumen else ()) + ("page.js",)
    assembly.write(path, "run.html", f"{run.title}: restenosisFoam", values, data, scripts)


def lumen_in_space(folder):
    """lumens.of(folder); None where it cannot be made, which is said in the log."""
    try:
        from report import lumens

        return lumens.of(folder)
    except Exception as error:  # without the packages, or with files cut short: the page is written all the same
        print(f"report.html has no lumen in space: {type(error).__name__}: {error}", file=sys.stderr)
        return None


def status(run):
    kind = "good" if run.ended_well else "open"
    text = {"occluded": "lumen closed"}.get(run.status, run.status)
    return element("span", text, class_=f"status {kind if run.status != 'failed' else 'bad'}")


def tiles(run):
    """The few values that a reader looks for first."""
    chosen = [m for m in (measures.FILLED, measures.DIAMETER, measures.COVERAGE, measures.STRESS) if run.grows]
    chosen = chosen or [measures.STRESS, measures.STRESS_LOW, measures.STRESS_HIGH, measures.DIAMETER]
    shown = []
    for measure in chosen:
        now, before = measure.last(run), measure.first(run)
        if now is None:
            continue
        was = f"day 0: {measure.shown(before)}" if before is not None and run.grows else ""
        shown.append(
            element(
                "li",
                element("span", measure.shown(now), class_="number"),
                element("span", measure.label, class_="label"),
                element("span", was, class_="before"),
            )
        )
    return element("ul", *shown, class_="tiles") if shown else ""


def table_of_values(run):
    if not run.has_tissue:  # one state, on no day of its own
        rows = [(one.label, one.shown(one.last(run)), _meaning(one)) for one in measures.of(run)]
        return table(("", "value", "what it is"), rows, ("", "number", "meaning")) if rows else ""
    rows = []
    for measure in measures.of(run):
        rows.append((measure.label, measure.shown(measure.first(run)), measure.shown(measure.last(run)), _meaning(measure)))
        if measure is measures.DIAMETER and (loss := measures.late_loss(run)) is not None and run.grows:
            row = ("Late lumen loss", numerals.NONE, f"{numerals.shown(loss)} mm", "smallest diameter of day 0, less that of the last day")
            rows.append(row)
    day = numerals.shown(run.last("day"))
    return table(("", "day 0", f"day {day}", "what it is"), rows, ("", "number", "number", "meaning")) if rows else ""


def _meaning(measure):
    return joined((measure.meaning, " ", element("code", measure.column)))


def all_columns(run):
    final = run.summary.get("final") or {name: run.last(name) for name in run.series}
    rows = [(element("code", name), numerals.shown(value, 5)) for name, value in final.items() if value is not None]
    return table(("column of timeSeries.csv", "last value"), rows, ("", "number")) if rows else ""


def pictures(folder):
    return joined(
        element(
            "figure",
            Markup(f'<img src="{embedded(folder / name)}" alt="{name.removesuffix(".png")}">'),
            element("figcaption", caption),
        )
        for name, caption in PICTURES.items()
        if (folder / name).exists()
    )


def list_of_remarks(run):
    said = remarks.by_severity(run.summary.get("remarks", ()))
    classes = dict(zip(remarks.ORDER, ("wrong", "check", "note")))
    return joined(
        element("li", element("span", level, class_=f"severity {classes[level]}"), " ", text) for level, text in said
    )


def plan(run):
    rows = [
        (element("span", "runs" if part["runs"] else "does not run", class_="runs" if part["runs"] else "idle"),
         part["part"], part["explanation"])
        for part in run.summary.get("plan", ())
    ]
    skipped = run.summary.get("flow", {}).get("skippedBecause") or {}
    done = run.summary.get("flow", {}).get("solvesDone")
    text = table(("", "part", "when, or why not"), rows, ("", "name", "")) if rows else ""
    if done is not None and skipped:
        why = joined((f"{numerals.times(count)} because {reason}" for reason, count in skipped.items()), "; ")
        text = joined((text, element("p", f"The flow was solved {numerals.times(done)}, and left out ", why, ".")))
    return text


def cost(run):
    """A bar of the parts' shares, and a table."""
    parts = sorted(run.summary.get("parts", {}).items(), key=lambda part: -part[1]["seconds"])
    total = run.summary.get("totalSeconds") or sum(part["seconds"] for _, part in parts)
    if not parts or total <= 0:
        return ""
    bar, rows = [], []
    for number, (name, part) in enumerate(parts):
        share = part["seconds"] / total
        label = f"{name} {numerals.percent(share)}"
        style = f"flex-grow: {share:.4f}"
        bar.append(element("span", name if share > 0.07 else "", class_=f"part{number % 8}", style=style, title=label))
        swatch = element("span", "", class_=f"swatch part{number % 8}")
        memory = max(part["peakMemory_MiB"], part.get("peakChildProcessMemory_MiB", 0))
        rows.append((joined((swatch, name)), numerals.duration(part["seconds"]), numerals.percent(share),
                     f"{numerals.shown(memory)} MiB", f"{part['calls']:,}", PARTS.get(name, "")))
    rows.append(("all", numerals.duration(total), "100 %", "", "", ""))
    head = ("part", "time", "share", "peak memory", "calls", "")
    return joined((
        element("div", *bar, class_="bar", role="img", aria_label="Shares of the time by part"),
        table(head, rows, ("", "number", "number", "number", "number", "meaning")),
    ))


def differences(run):
    rows = [
        (element("code", entry["key"]), entry["value"], entry["default"] or "required", entry["meaning"])
        for entry in run.summary.get("differsFromDefaults", ())
        if entry["key"] != "scene.title"
    ]
    return table(("key", "here", "default", "what it is"), rows, ("", "name", "name", "meaning")) if rows else ""
