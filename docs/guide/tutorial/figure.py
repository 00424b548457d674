#!/usr/bin/env python3
"""Draws figure.png: intima and smallest lumen of runs over the days.

    /usr/bin/python3 figure.py "LABEL=RESULTS" ...
"""
import csv
import sys

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot

COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7"]
PANELS = [("intimaArea_mm2", "intima [mm²]"), ("minLumenArea_mm2", "smallest lumen [mm²]")]


def column(folder, name):
    """Days and values of a column of timeSeries.csv; empty cells are left out."""
    with open(f"{folder}/timeSeries.csv", newline="") as file:
        rows = [(float(row["day"]), float(row[name])) for row in csv.DictReader(file) if row[name]]
    return zip(*rows)


figure, axes = pyplot.subplots(1, len(PANELS), figsize=(8, 3.2), layout="constrained")
for colour, run in zip(COLOURS, sys.argv[1:]):
    label, folder = run.split("=", 1)
    for axis, (name, title) in zip(axes, PANELS):
        axis.plot(*column(folder, name), color=colour, label=label)
        axis.set(xlabel="day", title=title)
axes[0].legend(frameon=False)
figure.savefig("figure.png", dpi=200)
