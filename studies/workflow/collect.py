#!/usr/bin/python3
"""Collects the runs of a study. Usage, in the folder of its results: collect.py STUDY.toml

Writes curves.csv, every record of every run, and table.csv, the columns of the study on its days: the mean over the
seeds, the least and the most; over the points, where the study has a table of them.
"""
import csv
import sys
from pathlib import Path

from kept import Kept
from study import Study, WrongStudy, at_day


def write(file, lines):
    with open(file, "w", newline="") as out:
        csv.writer(out, lineterminator="\n").writerows(lines)


def main():
    study = Study(sys.argv[1])
    kept = Kept(study)
    numbered = ["point"] if study.points else []
    curves, table = [["scene", *study.grid, *numbered, "seed", "day", *study.columns]], []
    values = {}
    for run in study.runs.values():
        if run not in kept:
            kept.add(run.name, Path("runs") / run.name)  # where it ended before the study kept any
        rows = kept.rows(run, Path("runs") / run.name)
        place = [run.scene.stem, *([] if run.number else [value for _, value in run.point])]
        for row in rows:
            curves.append([*place, *([run.number] if run.number else []), run.seed, row["day"], *(row[column] for column in study.columns)])
        for day in study.days:
            for column in study.columns:
                values.setdefault((tuple(place), day, column), []).append(at_day(rows, column, day))
    table.append(["scene", *study.grid, "day", "column", "mean", "least", "most", "runs"])
    for (place, day, column), of_seeds in values.items():
        known = [value for value in of_seeds if value is not None]
        if known:
            numbers = [f"{number:.6g}" for number in (sum(known) / len(known), min(known), max(known))]
            table.append([*place, day, column, *numbers, len(known)])
    write("curves.csv", curves)
    write("table.csv", table)


try:
    main()
except WrongStudy as error:
    sys.exit(f"collect.py: {error}")
