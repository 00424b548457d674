"""The values that a run is judged by: what they are called, and what they mean."""

import math
from dataclasses import dataclass, field
from typing import Callable

from report import numerals


def _diameter(area):
    return None if area is None else 2 * math.sqrt(max(area, 0) / math.pi)


@dataclass(frozen=True)
class Measure:
    """A value of every recorded day; `column`: of timeSeries.csv; `of`: makes what is shown of what is there."""

    label: str
    column: str
    unit: str
    meaning: str
    of: Callable = field(default=lambda value: value)

    def first(self, run):
        return self._made(run.first(self.column))

    def last(self, run):
        return self._made(run.last(self.column))

    def series(self, run):
        return [self._made(value) for value in run.series.get(self.column, ())]

    def shown(self, value):
        return numerals.NONE if value is None else f"{numerals.shown(value)} {self.unit}".rstrip()

    def _made(self, value):
        return None if value is None else self.of(value)


def _percent(label, column, meaning):
    return Measure(label, column, "%", meaning, lambda share: 100 * share)


THICKNESS = Measure(
    "Thickness of new tissue",
    "neointimaThickness_um",
    "µm",
    "mean over the stented section, against the lumen just after deployment",
)
THICKEST = Measure("Thickest cross-section", "neointimaThicknessMax_um", "µm", "largest mean of one cross-section")
FILLED = _percent("Lumen filled by new tissue", "neointimaAreaFraction", "share of the area of day 0, stented section")
RELATIVE = _percent(
    "Relative intima area",
    "relativeIntimaArea",
    "intima / (intima + lumen), as histology measures it; what animal studies report",
)
AREA = Measure("Smallest lumen area", "minLumenArea_mm2", "mm²", "smallest cross-section of the stented stretch")
DIAMETER = Measure(
    "Smallest lumen diameter", "minLumenArea_mm2", "mm", "of a circle with the smallest area", _diameter
)
COVERAGE = _percent(
    "Endothelium that is back", "coverage", "share of the cells at the lumen that endothelium covers; it makes them rest"
)
IN_CYCLE = _percent("Intimal cells that grow", "intimaInCycle", "share of the cells of the intima in G1 to M")
MATRIX = _percent("Matrix in the intima", "intimaMatrixShare", "share of its volume that cells have laid down")
DIVISIONS = Measure("Divisions", "divisions", "", "of cells, since deployment")
STRESS = Measure("Wall shear stress", "wssMean_Pa", "Pa", "mean over the wall, struts not counted, by the last flow")
STRESS_LOW = Measure("Low stress", "wssP5_Pa", "Pa", "5 % of the wall have less")
STRESS_HIGH = Measure("High stress", "wssP95_Pa", "Pa", "5 % of the wall have more")
LOW_SHARE = _percent(
    "Wall with too little stress", "wssLowAreaFraction", "below the stress at which covered cells rest: they may grow"
)
AGENTS = Measure("Agents", "agents", "", "cells, and pieces of laminae and struts")
SOLVES = Measure("Flow solutions", "flowSolves", "", "solved since the start")

ALL = (
    THICKNESS,
    THICKEST,
    FILLED,
    RELATIVE,
    AREA,
    DIAMETER,
    COVERAGE,
    IN_CYCLE,
    MATRIX,
    DIVISIONS,
    STRESS,
    STRESS_LOW,
    STRESS_HIGH,
    LOW_SHARE,
    AGENTS,
    SOLVES,
)
OF_TISSUE = (THICKNESS, THICKEST, FILLED, RELATIVE, COVERAGE, IN_CYCLE, MATRIX, DIVISIONS, AGENTS)


def of(run):
    """The measures that the run has."""
    return [
        measure
        for measure in ALL
        if measure.last(run) is not None and (run.has_tissue or measure not in OF_TISSUE)
    ]


def late_loss(run):
    """How much narrower the smallest lumen has become since day 0 [mm]; None where that is not known."""
    before, now = DIAMETER.first(run), DIAMETER.last(run)
    return None if before is None or now is None else before - now
