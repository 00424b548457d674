"""Loads a results folder in ParaView as a user would, and checks what arrives.

    pvpython tests/regression/loadInParaView.py RESULTS

Opens tissue.pvd, lumen.pvd and every flow/*/case.foam; checks that they have the time steps, arrays and ranges that
the results promise. Exit status 0 when all is well; each fault is printed.
"""

import csv
import math
import sys
from pathlib import Path

from paraview import servermanager, simple

TISSUE = {"radius": (1e-6, 1e-4), "kind": (0, 3), "state": (0, 2), "stress": (-1e9, 1e9), "NO": (0, 10), "wss": (0, 1e3)}
faults = []


def check(condition, message):
    if not condition:
        faults.append(message)


def array_range(attributes, name):
    found = attributes.GetArray(name)
    return found.GetRange(-1 if found.GetNumberOfComponents() > 1 else 0) if found else None


def check_array(where, attributes, name, bounds):
    found = array_range(attributes, name)
    if found is None:
        faults.append(f"{where}: no array {name}")
    else:
        check(bounds[0] <= found[0] <= found[1] <= bounds[1], f"{where}: {name} goes from {found[0]} to {found[1]}")


def recorded_days(folder):
    with open(folder / "timeSeries.csv", newline="", encoding="utf-8") as file:
        return [float(row["day"]) for row in csv.DictReader(file)]


def time_steps(reader):
    values = reader.TimestepValues
    return [float(values)] if isinstance(values, (int, float)) else [float(value) for value in values]


def at_time(reader, time):
    simple.UpdatePipeline(time=time, proxy=reader)
    return servermanager.Fetch(reader)


def check_tissue(folder, last_day):
    reader = simple.OpenDataFile(str(folder / "tissue.pvd"))
    steps = time_steps(reader)
    check(abs(steps[-1] - last_day) < 1e-6, f"tissue.pvd ends on day {steps[-1]}, timeSeries.csv on day {last_day}")
    for day in {steps[0], steps[-1]}:
        data = at_time(reader, day)
        check(data.GetNumberOfPoints() > 0, f"tissue.pvd, day {day}: no agents")
        for name, bounds in TISSUE.items():
            check_array(f"tissue.pvd, day {day}", data.GetPointData(), name, bounds)
    print(f"tissue.pvd: {len(steps)} time steps, {data.GetNumberOfPoints()} agents at the end")


def check_lumen(folder):
    reader = simple.OpenDataFile(str(folder / "lumen.pvd"))
    steps = time_steps(reader)
    solved = False
    for day in steps:
        data = at_time(reader, day)
        check(data.GetNumberOfCells() > 0, f"lumen.pvd, day {day}: no faces")
        check_array(f"lumen.pvd, day {day}", data.GetCellData(), "region", (0, 1))
        shear = data.GetCellData().GetArray("WSS")
        if shear is None:
            faults.append(f"lumen.pvd, day {day}: no array WSS")
        elif not math.isnan(shear.GetTuple1(0)):
            solved = True
            check_array(f"lumen.pvd, day {day}", data.GetCellData(), "WSS", (0, 1e3))
    print(f"lumen.pvd: {len(steps)} time steps, WSS {'known' if solved else 'not solved'}")


def blocks(data):
    """The data sets of a multiblock tree that have cells."""
    if not data.IsA("vtkMultiBlockDataSet"):
        return [data] if data is not None and data.GetNumberOfCells() > 0 else []
    children = (data.GetBlock(k) for k in range(data.GetNumberOfBlocks()))
    return [leaf for child in children if child is not None for leaf in blocks(child)]


def check_case(case):
    reader = simple.OpenFOAMReader(FileName=str(case))
    reader.MeshRegions = reader.MeshRegions.Available
    reader.CellArrays = reader.CellArrays.Available
    steps = time_steps(reader)
    found = blocks(at_time(reader, steps[-1]))
    check(found, f"{case}: no mesh")
    for name in ("U", "p", "wallShearStress"):
        ranges = [array_range(block.GetCellData(), name) for block in found]
        ranges = [r for r in ranges if r]
        check(ranges, f"{case}: no array {name}")
        check(all(math.isfinite(end) for r in ranges for end in r), f"{case}: {name} is not finite")
    print(f"{case}: {len(found)} regions, time {steps[-1]}")


def main():
    if len(sys.argv) != 2:
        print(__doc__)
        return 2
    folder = Path(sys.argv[1]).resolve()
    days = recorded_days(folder)
    check_tissue(folder, days[-1])
    check_lumen(folder)
    for case in sorted(folder.glob("flow/*/case.foam")):
        check_case(case)
    for fault in faults:
        print(f"FAULT: {fault}")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
