"""Cells that have not made room for themselves: how many have another nearer than 0.6 (R1 + R2).

    /usr/bin/python3 bench/doublets.py RESULTS

Of the last recorded state of a results folder, counted are smooth muscle cells that have not divided since
the recorded state before it, which should be a day or more earlier. Needs python3-vtk9 and python3-scipy.
"""

import pathlib
import sys

import numpy
import vtk
from scipy.spatial import cKDTree
from vtk.util.numpy_support import vtk_to_numpy

NEAR = 0.6  # of R1 + R2
NEIGHBOURS = 12


def read(file):
    reader = vtk.vtkXMLPolyDataReader()
    reader.SetFileName(str(file))
    reader.Update()
    data = reader.GetOutput()
    arrays = {name: vtk_to_numpy(data.GetPointData().GetArray(name)) for name in ("radius", "kind", "id", "generation")}
    cells = arrays["kind"] == 0
    return vtk_to_numpy(data.GetPoints().GetData())[cells], {name: a[cells] for name, a in arrays.items()}


def doublets(folder):
    """Number of cells, how many have not divided, and the shares of both that are near another."""
    earlier, last = sorted((pathlib.Path(folder) / "tissue").glob("*.vtp"))[-2:]
    _, before = read(earlier)
    centre, cells = read(last)
    generation = dict(zip(before["id"].tolist(), before["generation"].tolist()))
    settled = numpy.array([generation.get(i) == g for i, g in zip(cells["id"].tolist(), cells["generation"].tolist())])
    distance, other = cKDTree(centre).query(centre, k=NEIGHBOURS + 1)
    radii = cells["radius"][:, None] + cells["radius"][other[:, 1:]]
    near = (distance[:, 1:] < NEAR * radii).any(axis=1)
    return len(centre), int(settled.sum()), near.mean(), near[settled].mean()


def main():
    cells, settled, near, settled_near = doublets(sys.argv[1])
    print(f"{cells} cells, {settled} of them not divided since the record before")
    print(f"nearer than {NEAR} (R1 + R2) to another: {near:.4%} of all, {settled_near:.4%} of those")


if __name__ == "__main__":
    main()
