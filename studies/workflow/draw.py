#!/usr/bin/python3
"""Draws the curves of a study. Usage, in the folder of its results: draw.py STUDY.toml

figure.png and figure.pdf: a panel a column, a line for every scene and point of the grid: the mean over the seeds, and a
band from the least to the most.
"""
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

from kept import Kept
from study import Study, at_day

study = Study(sys.argv[1])
kept = Kept(study)
groups = {}
for run in study.runs.values():
    groups.setdefault(run.group, []).append(kept.rows(run, Path("runs") / run.name))

picture, panels = plt.subplots(1, len(study.columns), figsize=(5 * len(study.columns), 4), layout="constrained",
                               squeeze=False)
for panel, column in zip(panels[0], study.columns):
    for group, of_seeds in groups.items():
        days = sorted({row["day"] for rows in of_seeds for row in rows})
        lines = [[value for rows in of_seeds if (value := at_day(rows, column, day)) is not None] for day in days]
        days, lines = zip(*((day, values) for day, values in zip(days, lines) if values)) if any(lines) else ((), ())
        line, = panel.plot(days, [sum(values) / len(values) for values in lines], label=group)
        panel.fill_between(days, [min(values) for values in lines], [max(values) for values in lines],
                           color=line.get_color(), alpha=0.25, linewidth=0)
    name, _, unit = column.rpartition("_")
    panel.set(xlabel="day", ylabel=f"{name} [{unit}]" if name else column, xlim=(0, None))
    panel.grid(alpha=0.3)
panels[0][0].legend(fontsize="small")
for kind in ("png", "pdf"):
    picture.savefig(f"figure.{kind}", dpi=150)
