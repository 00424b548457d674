"""A study: the runs that a study.toml asks for, and what they have written. studies/README.md has its keys."""
import csv
import itertools
import json
import re
import tomllib
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BUILT = ROOT / "build/release/restenosisFoam"
INSTALLED = ROOT.parents[1] / "bin/restenosisFoam"  # where ROOT is share/restenosisFoam
IS_INSTALLED = INSTALLED.is_file() and not BUILT.is_file()
PROGRAM = INSTALLED if IS_INSTALLED else BUILT
RESULTS = (Path.cwd() if IS_INSTALLED else ROOT) / "results"
ENDED = ("finished", "occluded")
# Keys of a study: kind, and what holds without it. What has no such value must be there.
KEYS = {"title": (str, ""), "scenes": (list, None), "seeds": (list, [1]), "threads": (int, 1), "ranks": (int, 1),
        "memory_MiB": (int, 2048), "columns": (list, None), "days": (list, None), "settings": (dict, {}),
        "grid": (dict, {}), "points": (str, ""), "first": (int, 0), "kept": (str, "")}


class WrongStudy(Exception):
    """What is wrong with a study, for people."""


@dataclass(frozen=True)
class Run:
    """One run of a study."""
    scene: Path
    seed: int
    point: tuple  # (key, value) of the grid
    settings: tuple  # (key, value) of every run
    number: int = 0  # of the line of a table of points; 0: there is none

    @property
    def group(self):
        """What runs that differ in their seed alone have in common, or in their point of a table."""
        return " ".join([self.scene.stem, *(f"{key}={value}" for key, value in self.point if not self.number)])

    @property
    def name(self):
        """Of its folder."""
        if self.number:
            return f"{self.scene.stem}_point{self.number:04}"
        return re.sub(r"[^\w.=+-]+", "_", f"{self.group} seed{self.seed}")

    def options(self):
        """What sets the run's scene apart from the file."""
        return [word for key, value in (*self.settings, *self.point, ("scene.seed", self.seed))
                for word in ("--set", f"{key}={value}")]


class Study:
    """A study.toml, checked."""

    def __init__(self, file):
        self.file = Path(file).resolve()
        try:
            given = tomllib.loads(self.file.read_text())
        except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
            raise WrongStudy(f"{file}: {getattr(error, 'strerror', None) or error}") from error
        for key in given:
            if key not in KEYS:
                raise WrongStudy(f"{file}: no such key: '{key}'; a study has: {', '.join(KEYS)}")
        for key, (kind, default) in KEYS.items():
            value = given.get(key, default)
            if value is None:
                raise WrongStudy(f"{file}: '{key}' is missing")
            if not isinstance(value, kind) or isinstance(value, bool):
                raise WrongStudy(f"{file}: '{key}' is not a {kind.__name__}")
            if default in (None, [1]) and not value:
                raise WrongStudy(f"{file}: '{key}' is empty")
            setattr(self, key, value)
        self._check()
        self.runs = self._runs()

    def _check(self):
        for key, kinds, what in (("scenes", str, "names of files"), ("seeds", int, "whole numbers"),
                                 ("columns", str, "columns of timeSeries.csv"), ("days", (int, float), "numbers")):
            if not all(isinstance(value, kinds) and not isinstance(value, bool) for value in getattr(self, key)):
                raise WrongStudy(f"{self.file}: '{key}' must be {what}")
        for key in ("threads", "ranks", "memory_MiB"):
            if getattr(self, key) < 1:
                raise WrongStudy(f"{self.file}: '{key}' must be at least 1")
        for key, values in self.grid.items():
            if not isinstance(values, list) or not values:
                raise WrongStudy(f"{self.file}: '{key}' of the grid must be a list of values")
        if self.points and (self.grid or len(self.seeds) > 1):
            raise WrongStudy(f"{self.file}: a table of points goes with one seed and no grid; it may have a column "
                             "scene.seed")
        for key in (*self.settings, *self.grid):
            if key == "scene.seed":
                raise WrongStudy(f"{self.file}: the seeds are given by 'seeds', not by 'scene.seed'")
            if key in self.settings and key in self.grid:
                raise WrongStudy(f"{self.file}: '{key}' is in [settings] and in [grid]")
        for scene in self.scenes:
            if not (self.file.parent / scene).is_file():
                raise WrongStudy(f"{self.file}: no such scene: {self.file.parent / scene}")

    def _table(self, settings):
        """The runs of a table of points: a line each of every scene, a column each key; the seed may be one."""
        try:
            with open(self.file.parent / self.points, newline="") as file:
                lines = list(csv.DictReader(file))
        except OSError as error:
            raise WrongStudy(f"{self.file.parent / self.points}: {error.strerror}") from error
        runs = {}
        for (number, line), scene in itertools.product(enumerate(lines[:self.first or None], 1), self.scenes):
            seed = line.get("scene.seed", self.seeds[0])
            point = tuple((key, value) for key, value in line.items() if key != "scene.seed")
            run = Run((self.file.parent / scene).resolve(), seed, point, settings, number)
            runs[run.name] = run
        if not runs:
            raise WrongStudy(f"{self.file.parent / self.points}: no points")
        return runs

    def _runs(self):
        def words(values):
            return [str(value).lower() if isinstance(value, bool) else str(value) for value in values]

        settings = tuple(zip(self.settings, words(self.settings.values())))
        if self.points:
            return self._table(settings)
        points = [tuple(zip(self.grid, values)) for values in itertools.product(*map(words, self.grid.values()))]
        # Seeds outermost: the first results are one of each kind
        runs = {}
        for seed, scene, point in itertools.product(self.seeds, self.scenes, points):
            run = Run((self.file.parent / scene).resolve(), seed, point, settings)
            if run.name in runs:
                raise WrongStudy(f"{self.file}: two runs are called {run.name}")
            runs[run.name] = run
        return runs


def read_summary(folder):
    """summary.json of a run that has ended."""
    summary = json.loads((folder / "summary.json").read_text())
    if summary["status"] not in ENDED:
        raise WrongStudy(f"{folder}: the run has not ended: {summary['status']}")
    return summary


def numbers(row):
    """A line of a table of numbers: {column: number, or None where it is empty}."""
    return {column: float(text) if text else None for column, text in row.items()}


def read_rows(folder):
    """timeSeries.csv of a run that has ended: numbers, by recorded step."""
    read_summary(folder)
    with open(folder / "timeSeries.csv", newline="") as file:
        return [numbers(row) for row in csv.DictReader(file)]


def at_day(rows, column, day):
    """A column on a day, on the line between two records; before the first and after the last as on them."""
    if column not in rows[0]:
        raise WrongStudy(f"timeSeries.csv has no column '{column}'; it has: {', '.join(rows[0])}")
    known = [(row["day"], row[column]) for row in rows if row[column] is not None]
    if not known:
        return None
    for (before, first), (after, second) in itertools.pairwise(known):
        if before <= day <= after:
            return first + (second - first) * (day - before) / (after - before)
    return known[0][1] if day < known[0][0] else known[-1][1]
