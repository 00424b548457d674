"""What a run has written of itself, read without any package."""

import csv
import json
import math
import tomllib

from nothing_to_draw import NothingToDraw

UNFINISHED = "unfinished"  # no end was recorded: the run is under way, or was killed
ENDED_WELL = ("finished", "occluded")


class Run:
    """A results folder: summary (empty where no end was recorded), time series by column, scene."""

    def __init__(self, folder):
        self.folder = folder
        self.summary = _json(folder / "summary.json")
        self.series = _series(folder / "timeSeries.csv")
        if not self.summary and not self.series:
            raise NothingToDraw(f"{folder} holds no summary.json, and no record in timeSeries.csv")
        source = folder / "scene.toml"
        self.scene_text = source.read_text(encoding="utf-8", errors="replace") if source.exists() else ""
        self.scene = _toml(self.scene_text)

    @property
    def name(self):
        return self.summary.get("scene") or self.folder.resolve().name

    @property
    def title(self):
        return self.summary.get("title") or self.scene.get("scene", {}).get("title") or self.name

    @property
    def status(self):
        return self.summary.get("status", UNFINISHED)

    @property
    def ended_well(self):
        return self.status in ENDED_WELL

    @property
    def has_tissue(self):
        return (self.folder / "tissue.pvd").exists()

    @property
    def has_flow(self):
        return self.last("wssMean_Pa") is not None

    @property
    def grows(self):
        """Whether the run has tissue whose cells divide, and more than one recorded day."""
        return self.has_tissue and "cellCycle" in self.scene and len(self.series.get("day", ())) > 1

    def first(self, column):
        """A column on the first recorded day; None where it is not known."""
        values = self.series.get(column)
        return values[0] if values else None

    def last(self, column):
        """A column at the end, to all digits where the summary has it; None where it is not known."""
        final = self.summary.get("final", {})
        if column in final:
            return final[column]
        values = self.series.get(column)
        return values[-1] if values else None

    def known(self, column):
        return any(value is not None for value in self.series.get(column, ()))

    def planned_days(self):
        """The days that the scene asks for; None where that cannot be read."""
        try:
            number, unit = str(self.scene["scene"]["duration"]).split()
            return float(number) * {"d": 1, "h": 1 / 24, "min": 1 / 1440, "s": 1 / 86400}[unit]
        except (KeyError, ValueError):
            return None


def _json(path):
    if not path.exists():
        return {}
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except ValueError as error:
        raise NothingToDraw(f"{path} is no JSON: {error}") from error


def _toml(text):
    try:
        return tomllib.loads(text)
    except tomllib.TOMLDecodeError:
        return {}


def _number(text):
    value = float(text) if text else math.nan
    return value if math.isfinite(value) else None


def _series(path):
    """The columns of timeSeries.csv by name; None where a field is empty. No columns where there is no row."""
    if not path.exists():
        return {}
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    try:
        return {name: [_number(row[name]) for row in rows] for name in rows[0]} if rows else {}
    except (TypeError, ValueError) as error:
        raise NothingToDraw(f"{path} is no table of numbers: {error}") from error
