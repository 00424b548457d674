#!/usr/bin/env python3
"""What deployment does to the wall: how far agents move along it, how much they overlap, how thick the media is.

    /usr/bin/python3 bench/deployed.py PACKED DEPLOYED

Both are results folders of one scene and seed whose first record is compared: PACKED of a run with
`stent.deploymentDepth = "0 um"`, so that the wall is as it was packed. Needs python3-vtk9 and python3-scipy.
"""

import pathlib
import sys

import numpy
import vtk
from scipy.spatial import cKDTree
from vtk.util.numpy_support import vtk_to_numpy

KINDS = {0: "SMC", 1: "IEL", 2: "EEL"}
STRUT = 3
NEIGHBOURS = 14
CYLINDER = 900  # [um]; the lumen's radius before deployment


class Wall:
    """The agents of the first record of a results folder, in the order of their numbers [um]."""

    def __init__(self, results):
        reader = vtk.vtkXMLPolyDataReader()
        reader.SetFileName(str(sorted((pathlib.Path(results) / "tissue").glob("*.vtp"))[0]))
        reader.Update()
        data = reader.GetOutput()
        order = numpy.argsort(vtk_to_numpy(data.GetPointData().GetArray("id")))
        centre = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
        self.centre = 1e6 * centre[order]
        self.size = 1e6 * self.array(data, "radius")[order]
        self.kind = self.array(data, "kind")[order]
        self.id = self.array(data, "id")[order]
        self.free = self.array(data, "fixed")[order] == 0
        self.radius = numpy.hypot(self.centre[:, 0], self.centre[:, 1])
        self.angle = numpy.arctan2(self.centre[:, 1], self.centre[:, 0])

    @staticmethod
    def array(data, name):
        return vtk_to_numpy(data.GetPointData().GetArray(name))

    def onto_cylinder(self, agents):
        """Where agents are on a cylinder of the same radius for all, so that radial distances do not count."""
        angle = self.angle[agents]
        return numpy.column_stack([CYLINDER * numpy.cos(angle), CYLINDER * numpy.sin(angle), self.centre[agents, 2]])


def axial_shift(packed, deployed):
    before = dict(zip(packed.id.tolist(), packed.centre[:, 2].tolist()))
    print("axial shift [um]         rms   95 %   largest")
    for kind, name in KINDS.items():
        of = numpy.flatnonzero((deployed.kind == kind) & deployed.free)
        shift = numpy.array([deployed.centre[i, 2] - before[deployed.id[i]] for i in of if deployed.id[i] in before])
        if not shift.size:
            print(f"  {name:<20}   held")
            continue
        size = numpy.abs(shift)
        print(f"  {name:<20}{numpy.sqrt((shift**2).mean()):7.2f}{numpy.percentile(size, 95):7.2f}{size.max():10.2f}")


def overlaps(name, wall):
    """Of touching pairs without struts, relative to R1 + R2."""
    tissue = numpy.flatnonzero(wall.kind != STRUT)
    distance, other = cKDTree(wall.centre[tissue]).query(wall.centre[tissue], k=NEIGHBOURS + 1)
    size = wall.size[tissue]
    overlap = 1 - distance[:, 1:] / (size[:, None] + size[other[:, 1:]])
    kind = wall.kind[tissue]
    print(f"overlaps, {name:<14} median   95 %   99.9 %  largest  (share of R1 + R2)")
    for chosen, label in [(kind == 0, "SMC"), (kind == 1, "IEL"), (kind == 2, "EEL")]:
        touching = overlap[chosen][overlap[chosen] > 0]
        p = numpy.percentile(touching, [50, 95, 99.9])
        print(f"  {label:<20}{p[0]:9.3f}{p[1]:7.3f}{p[2]:9.3f}{touching.max():9.3f}")


def media(name, wall, struts, under):
    """Distance of the laminae across the wall: each IEL agent's radius from the mean radius of the EEL near it."""
    iel, eel = numpy.flatnonzero(wall.kind == 1), numpy.flatnonzero(wall.kind == 2)
    near = cKDTree(wall.onto_cylinder(eel)).query(wall.onto_cylinder(iel), k=4)[1]
    thickness = wall.radius[eel][near].mean(axis=1) - wall.radius[iel]
    to_strut = cKDTree(struts).query(wall.onto_cylinder(iel))[0]
    for chosen, label in [(to_strut < under, "under struts"), (to_strut > 300, "300 um away from struts")]:
        if chosen.any():
            p = numpy.percentile(thickness[chosen], [5, 50, 95])
            print(f"  {name:<10}{label:<26}{p[0]:8.1f}{p[1]:8.1f}{p[2]:8.1f}   of {chosen.sum()} IEL agents")


def main():
    packed, deployed = Wall(sys.argv[1]), Wall(sys.argv[2])
    axial_shift(packed, deployed)
    overlaps("packed", packed)
    overlaps("deployed", deployed)
    of_strut = numpy.flatnonzero(deployed.kind == STRUT)
    under = 2 * numpy.median(deployed.size[of_strut])  # from the middle of an agent of a strut
    struts = deployed.onto_cylinder(of_strut)
    print("IEL to EEL [um]                         5 %  median    95 %")
    media("packed", packed, struts, under)
    media("deployed", deployed, struts, under)


if __name__ == "__main__":
    main()
