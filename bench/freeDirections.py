"""The share of directions around a cell that no neighbour covers (docs/model/biology.md, eq. 2 and 3).

    /usr/bin/python3 bench/freeDirections.py RESULTS

Of the first recorded state of a results folder, by the model's equations with the defaults of [contactInhibition],
apart from the program's own code. Agents within 150 um of the vessel's ends are left out, where the wall goes on as a
mirror image, and so are fixed ones; of a longer vessel only the middle 1.2 mm are taken. Needs python3-vtk9 and
python3-scipy.
"""

import pathlib
import sys

import numpy
import vtk
from scipy.spatial import cKDTree
from vtk.util.numpy_support import vtk_to_numpy

THRESHOLD, RANGE, CELL_COVER, LAMINA_COVER, DIRECTIONS = 0.15, 2.0, 1.25, 1.9, 60
SMC, IEL, EEL = 0, 1, 2
END, LONGEST = 150e-6, 1.2e-3  # [m]


def read(folder):
    reader = vtk.vtkXMLPolyDataReader()
    reader.SetFileName(str(sorted((pathlib.Path(folder) / "tissue").glob("*.vtp"))[0]))
    reader.Update()
    data = reader.GetOutput()
    names = ("radius", "kind", "fixed", "injuredIel")
    return (vtk_to_numpy(data.GetPoints().GetData()).astype(float),
            *(vtk_to_numpy(data.GetPointData().GetArray(name)) for name in names))


def fibonacci(n):
    k = numpy.arange(n)
    height = 1 - (2 * k + 1) / n
    ring, turn = numpy.sqrt(1 - height**2), numpy.pi * (3 - 5**0.5) * k
    return numpy.column_stack((ring * numpy.cos(turn), ring * numpy.sin(turn), height))


def freeShare(centre, radius, kind, chosen, sheets=True):
    """Of each chosen agent. Without sheets laminae cover as much beside them as behind them."""
    directions = fibonacci(DIRECTIONS)
    normal = centre * (1, 1, 0)
    normal /= numpy.linalg.norm(normal, axis=1)[:, None]
    tree = cKDTree(centre)
    share = []
    for i in chosen:
        near = numpy.array(tree.query_ball_point(centre[i], RANGE * (radius[i] + radius.max())))
        offset = centre[near] - centre[i]
        distance = numpy.linalg.norm(offset, axis=1)
        within = (distance > 0) & (distance <= RANGE * (radius[i] + radius[near]))
        near, offset, distance = near[within], offset[within], distance[within]
        facing = (offset * normal[near]).sum(axis=1) / distance if sheets else 1
        cover = CELL_COVER + numpy.isin(kind[near], (IEL, EEL)) * (LAMINA_COVER - CELL_COVER) * facing**2
        limit = numpy.sqrt(numpy.maximum(0, distance**2 - (cover * radius[near]) ** 2))
        share.append((directions @ offset.T < limit).all(axis=1).mean())
    return numpy.array(share)


def shares(folder):
    """{agents: (number, median, 99 %, 99.9 %, largest, number above the threshold)}"""
    centre, radius, kind, fixed, injured = read(folder)
    z = centre[:, 2]
    length = min(z.max() - 2 * END, LONGEST)
    chosen = (fixed == 0) & (abs(z - (z.min() + z.max()) / 2) < length / 2)
    groups = {"SMC": ((kind == SMC) & (injured == 0), True), "IEL": (kind == IEL, True),
              "IEL, injured": (injured == 1, True), "IEL, injured, no sheets": (injured == 1, False)}
    table = {}
    for name, (group, sheets) in groups.items():
        agents = numpy.flatnonzero(group & chosen)
        if len(agents):
            share = freeShare(centre, radius, kind, agents, sheets)
            table[name] = (len(agents), *(round(numpy.quantile(share, q), 3) for q in (0.5, 0.99, 0.999, 1)),
                           int((share > THRESHOLD + 1e-9).sum()))
    return table


if __name__ == "__main__":
    for agents, values in shares(sys.argv[1]).items():
        print(agents.ljust(24), *values)
