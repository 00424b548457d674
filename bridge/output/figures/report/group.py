"""Runs that are shown as one line: a run alone, or those of a study that differ in their seed alone."""

import itertools

from nothing_to_draw import NothingToDraw
from report.record import Run

MOST_KEYS = 3  # in a name
MOST_GROUPS = 8  # of a study; with more, as of a table of points, all its runs are one


class Group:
    """Runs with a name. Values are means over the runs, from the least to the most."""

    def __init__(self, name, runs):
        self.name, self.runs = name, runs

    @property
    def run(self):
        return self.runs[0]

    def days(self):
        return max((run.series.get("day", []) for run in self.runs), key=len)

    def last_day(self):
        """The last day that all of its runs have reached."""
        return min((run.series["day"][-1] for run in self.runs if run.series.get("day")), default=None)

    def on(self, measure, day):
        """(mean, least, most) of a measure on a day; None where no run has it."""
        values = [value for run in self.runs if (value := value_on(run, measure, day)) is not None]
        return (sum(values) / len(values), min(values), max(values)) if values else None

    def scene(self):
        """{"section.key": value} of the resolved scene; of keys that its runs differ in every value."""
        scenes = [flat(run.scene) for run in self.runs]
        names = dict.fromkeys(name for scene in scenes for name in scene)
        values = {name: list(dict.fromkeys(scene.get(name, "") for scene in scenes)) for name in names}
        return {name: ", ".join(found[:6]) + (", ..." if len(found) > 6 else "") for name, found in values.items()}


def flat(scene):
    return {
        f"{section}.{key}": str(value).lower() if isinstance(value, bool) else str(value)
        for section, keys in scene.items()
        if isinstance(keys, dict)
        for key, value in keys.items()
    }


def value_on(run, measure, day):
    """A measure on a day, on the line between two records; None before the first and after the last."""
    known = [(x, y) for x, y in zip(run.series.get("day", ()), measure.series(run)) if y is not None]
    for (before, first), (after, second) in itertools.pairwise(known):
        if before <= day <= after:
            return first + (second - first) * (day - before) / (after - before)
    return known[0][1] if known and known[0][0] == day else None


def is_study(folder):
    return (folder / "runs").is_dir() and not (folder / "timeSeries.csv").exists()


def of(folders):
    """All groups of results folders and studies; folders of one name are told apart by those they lie in."""
    names = [folder.resolve().name for folder in folders]
    told = [
        name if names.count(name) == 1 else f"{folder.resolve().parent.name}/{name}"
        for folder, name in zip(folders, names)
    ]
    return [group for folder, name in zip(folders, told) for group in _groups_of(folder, name)]


def _groups_of(folder, study):
    """The run in a results folder, or the groups of a study's runs."""
    if not is_study(folder):
        return [Group(study, [Run(folder)])]
    runs = list(filter(None, map(_run_or_none, sorted((folder / "runs").iterdir()))))
    if not runs:
        raise NothingToDraw(f"{folder}: none of its runs has recorded anything yet")
    alike = {}
    for run in runs:
        alike.setdefault(_without_seed(run), []).append(run)
    if len(alike) > MOST_GROUPS:
        return [Group(f"{study} ({len(runs)} runs)", runs)]
    return [Group(f"{study}: {_name(group, alike.values())}", group) for group in alike.values()]


def _run_or_none(folder):
    try:
        return Run(folder) if folder.is_dir() else None
    except NothingToDraw:
        return None


def _without_seed(run):
    scene = flat(run.scene).items()
    return tuple(sorted((name, value) for name, value in scene if name not in ("scene.seed", "scene.title")))


def _name(group, groups):
    """The scene's name, and what sets it apart from the study's other groups of this name."""
    scenes = [dict(_without_seed(runs[0])) for runs in groups if runs[0].name == group[0].name]
    own = dict(_without_seed(group[0]))
    apart = [f"{name} = {value}" for name, value in own.items() if len({scene.get(name) for scene in scenes}) > 1]
    seeds = f"{len(group)} seeds" if len(group) > 1 else ""
    return ", ".join(filter(None, [group[0].name, *apart[:MOST_KEYS], seeds]))
