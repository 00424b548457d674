"""What a study keeps of its runs beside its study.toml, so that it goes on from there on any machine.

The folder that `kept` names has runs.csv, a run a line, and curves.csv, the columns of the study at every record of every
run. As a program, in the folder of the results: kept.py STUDY.toml RUN adds a run that has ended.
"""
import csv
import fcntl
import os
import sys
from contextlib import contextmanager
from pathlib import Path

from study import Study, WrongStudy, numbers, read_rows, read_summary


def read(file):
    if not file.exists():
        return []
    with open(file, newline="") as lines:
        return list(csv.DictReader(lines))


def write(file, lines):
    """Writes lines under all the columns that any of them has: whole or not at all."""
    columns = list(dict.fromkeys(column for line in lines for column in line))
    part = file.with_suffix(".part")
    with open(part, "w", newline="") as out:
        table = csv.DictWriter(out, columns, lineterminator="\n")
        table.writeheader()
        table.writerows(lines)
    part.replace(file)


@contextmanager
def locked(folder):
    """Runs that end together wait for each other."""
    descriptor = os.open(folder, os.O_RDONLY)
    try:
        fcntl.flock(descriptor, fcntl.LOCK_EX)
        yield
    finally:
        os.close(descriptor)


def run_line(name, folder):
    """What runs.csv and the page say of a run: seconds in all and of its parts, and memory."""
    summary = read_summary(folder)
    parts = summary["parts"]

    def peak(of):
        return round(max((part.get(of, 0) for part in parts.values()), default=0))

    return {"run": name, "status": summary["status"], "version": summary["version"],
            "digest": summary["stateDigest"], "seconds": round(summary["totalSeconds"], 1),
            "peak_MiB": peak("peakMemory_MiB"), "peakChildProcess_MiB": peak("peakChildProcessMemory_MiB"),
            **{f"{part}_s": round(cost["seconds"], 1) for part, cost in parts.items()}}


class Kept:
    """The runs that a study has kept; none where it keeps nothing."""

    def __init__(self, study):
        self._study = study
        self._folder = study.file.parent / study.kept if study.kept else None
        self._runs = {line["run"]: line for line in self._read("runs.csv")}
        self._curves = {}
        for row in self._read("curves.csv"):
            self._curves.setdefault(row.pop("run"), []).append(numbers(row))
        for name in self._runs:
            if name not in self._curves:
                raise WrongStudy(f"{self._folder / 'curves.csv'}: no run {name}, which runs.csv has")

    def _read(self, name):
        return read(self._folder / name) if self._folder else []

    def __contains__(self, run):
        return run.name in self._runs

    def rows(self, run, folder):
        """The records of a run: those that are kept, or else those in its folder."""
        return self._curves[run.name] if run in self else read_rows(folder)

    def line(self, run, folder):
        """The line of a run in runs.csv, as it is kept or would be."""
        return self._runs.get(run.name) or run_line(run.name, folder)

    def add(self, name, folder):
        """Keeps a run that has ended, where the study keeps any and may write beside itself."""
        if not self._folder or not os.access(self._study.file.parent, os.W_OK):
            return
        line, rows = run_line(name, folder), read_rows(folder)
        kept = [{"run": name, "day": row["day"], **{column: row[column] for column in self._study.columns}} for row in rows]
        self._folder.mkdir(exist_ok=True)
        with locked(self._folder):
            # The curves first: a run that runs.csv has is whole
            for file, lines in (("curves.csv", kept), ("runs.csv", [line])):
                known = [former for former in self._read(file) if former["run"] != name]
                write(self._folder / file, known + lines)


def main():
    study = Study(sys.argv[1])
    Kept(study).add(sys.argv[2], Path("runs") / sys.argv[2])


if __name__ == "__main__":
    try:
        main()
    except WrongStudy as error:
        sys.exit(f"kept.py: {error}")
