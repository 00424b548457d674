"""The panels of curves: what each shows, as data that the page draws."""

from dataclasses import dataclass

from report import measures
from report.numerals import rounded

MOST_POINTS = 400  # of a line; more cannot be told apart


@dataclass(frozen=True)
class Panel:
    """A panel: its title, the curve, one that is drawn dashed, and the two that a band lies between."""

    title: str
    main: measures.Measure
    dashed: measures.Measure | None = None
    band: tuple = ()


PANELS = (
    Panel("New tissue", measures.THICKNESS, dashed=measures.THICKEST),
    Panel("Lumen filled by new tissue", measures.FILLED),
    Panel("Relative intima area", measures.RELATIVE),
    Panel("Smallest lumen area", measures.AREA),
    Panel("Endothelium that is back", measures.COVERAGE),
    Panel("Intimal cells that grow", measures.IN_CYCLE),
    Panel("Wall shear stress", measures.STRESS, band=(measures.STRESS_LOW, measures.STRESS_HIGH)),
    Panel("Wall with too little stress", measures.LOW_SHARE),
)


def panels_of(runs):
    """The panels that one of the runs has a curve for."""
    return [panel for panel in PANELS if any(_has(run, panel.main) for run in runs)]


def of(run):
    """The panels of one run."""
    return [
        {
            "title": panel.title,
            "unit": panel.main.unit,
            "lines": [line(run, panel.main, "mean" if panel.dashed or panel.band else "")]
            + ([line(run, panel.dashed, "thickest cross-section", dashed=True)] if _has(run, panel.dashed) else []),
            "bands": [band(run, panel.band, " on 90 % of the wall")] if _has(run, *panel.band) and panel.band else [],
        }
        for panel in panels_of([run])
    ]


def _has(run, *asked):
    return all(measure is not None and run.known(measure.column) for measure in asked)


def line(run, measure, name, dashed=False, group=0):
    xs, ys = thinned(run.series["day"]), thinned(measure.series(run))
    return {"name": name, "x": _numbers(xs), "y": _numbers(ys), "dashed": dashed, "group": group}


def band(run, between, name, group=0):
    low, high = (_numbers(thinned(measure.series(run))) for measure in between)
    return {"name": name, "x": _numbers(thinned(run.series["day"])), "low": low, "high": high, "group": group}


def _numbers(values):
    return [rounded(value) for value in values]


def thinned(values):
    """Every so many values, and the last."""
    stride = -(-len(values) // MOST_POINTS)
    return values if stride <= 1 else [*values[: -1 : stride], values[-1]]
