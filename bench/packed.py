"""How many neighbours the agents of a wall have that is as it was packed.

    /usr/bin/python3 bench/packed.py RESULTS

Of the first recorded state of a results folder whose scene has no stent. Agents within two cell diameters of
the vessel's ends are left out: they have neighbours on one side only. Needs python3-vtk9 and python3-scipy.
"""

import pathlib
import sys

import numpy
import vtk
from scipy.spatial import cKDTree
from vtk.util.numpy_support import vtk_to_numpy

RANGES = (1.06, 1.1, 1.5, 2.0)  # of R1 + R2


def read(file):
    reader = vtk.vtkXMLPolyDataReader()
    reader.SetFileName(str(file))
    reader.Update()
    data = reader.GetOutput()
    radius, kind = (vtk_to_numpy(data.GetPointData().GetArray(name)) for name in ("radius", "kind"))
    return vtk_to_numpy(data.GetPoints().GetData()).astype(float), radius.astype(float), kind


def neighbours(centre, radius, factor):
    """How many centres are within factor (R1 + R2) of each agent's."""
    pairs = cKDTree(centre).query_pairs(2 * factor * radius.max(), output_type="ndarray")
    distance = numpy.linalg.norm(centre[pairs[:, 0]] - centre[pairs[:, 1]], axis=1)
    near = pairs[distance <= factor * radius[pairs].sum(axis=1)]
    return numpy.bincount(near.ravel(), minlength=len(centre))


def main():
    centre, radius, kind = read(sorted((pathlib.Path(sys.argv[1]) / "tissue").glob("*.vtp"))[0])
    size = radius.mean()
    within = (centre[:, 2] > 4 * size) & (centre[:, 2] < centre[:, 2].max() - 4 * size)
    from_axis = numpy.hypot(centre[:, 0], centre[:, 1])
    iel, eel = from_axis[kind == 1].mean(), from_axis[kind == 2].mean()
    cell = (kind == 0) & within
    groups = {
        "cells, the middle third of the wall": cell & (abs(from_axis - (iel + eel) / 2) < (eel - iel) / 6),
        "cells at the IEL": cell & (from_axis < iel + 3 * size),
        "IEL": (kind == 1) & within,
        "EEL": (kind == 2) & within,
    }
    print(f"{len(centre)} agents; neighbours, mean +- standard deviation [least, most]")
    print("within".ljust(14) + "".join(f"{name:>38}" for name in groups))
    for factor in RANGES:
        count = neighbours(centre, radius, factor)
        texts = (f"{n.mean():.1f} +- {n.std():.1f} [{n.min()}, {n.max()}]" for n in (count[g] for g in groups.values()))
        print(f"{factor} (R1 + R2)".ljust(14) + "".join(f"{text:>38}" for text in texts))


if __name__ == "__main__":
    main()
