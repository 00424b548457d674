"""A square ring in a tube: its surface, square to the flow or oblique, and a resolved solution of the square one.

The tube has a radius of 0.9 mm, the ring 0.09 mm in both directions; blood flows with 0.133 m/s in the mean.
"""
import math

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersVerdict import vtkCellSizeFilter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

import wedge
from tubes import writeTube

RADIUS, STRUT = 0.9e-3, 0.09e-3  # [m]
INNER = RADIUS - STRUT
MEAN_VELOCITY, VISCOSITY, DENSITY = 0.133, 2.7e-6, 1000


def profile(length):
    """(r, z, is strut) of the corners of a tube with a ring half way along, small pieces apart [m]."""
    begin, end = (length - STRUT) / 2, (length + STRUT) / 2
    pieces, ring = 80, 9
    part = STRUT / ring
    return ([(RADIUS, begin * i / pieces, False) for i in range(pieces)]
            + [(RADIUS - part * i, begin, True) for i in range(ring)]
            + [(INNER, begin + part * i, True) for i in range(ring)]
            + [(INNER + part * i, end, True) for i in range(ring)]
            + [(RADIUS, end + (length - end) * i / pieces, False) for i in range(pieces + 1)])


def writeScene(folder, length, slope=0):
    """scene.toml and its lumen. The ring's plane is inclined: z rises by `slope` times x, less towards the ends."""
    def inclined(r, z, cosine, sine):
        x = r * cosine
        return x, r * sine, z + slope * x * min(1, max(0, 1 - (abs(z - length / 2) - 0.1e-3) / (length / 2 - 0.2e-3)))

    return writeTube(folder, profile(length), inclined)


def strutStress(file):
    """Mean wall shear stress [Pa] on the struts of a lumen_*.vtp."""
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(file))
    sizes = vtkCellSizeFilter()
    sizes.SetInputConnection(reader.GetOutputPort())
    sizes.Update()
    of = {name: vtk_to_numpy(sizes.GetOutput().GetCellData().GetArray(name)) for name in ("Area", "WSS", "region")}
    strut = of["region"] == 1
    return float(np.average(of["WSS"][strut], weights=of["Area"][strut]))


def graded(length, first):
    """Number of cells over a length, growing from `first`, and the ratio of last to first."""
    count, along, cell = 0, 0.0, first
    while along < length:
        along, count, cell = along + cell, count + 1, min(1.05 * cell, 20e-6)
    low, high = 1.0000001, 1e4
    for _ in range(200):
        ratio = math.sqrt(low * high)
        growth = ratio ** (1 / (count - 1))
        low, high = (ratio, high) if length * (growth - 1) / (growth ** count - 1) > first else (low, ratio)
    return count, ratio


def ringWedge(length, cell):
    begin, end = (length - STRUT) / 2, (length + STRUT) / 2
    along, alongRatio = graded(begin, cell)
    core, coreRatio = graded(INNER, cell)
    across = round(STRUT / cell)
    mesh = wedge.Wedge()
    before, at, behind = (((0, begin), (along, 1 / alongRatio)), ((begin, end), (across, 1)),
                          ((end, length), (along, alongRatio)))
    for z, axial in (before, at, behind):
        mesh.block(z, (0, 0), (INNER, INNER), (core, 1 / coreRatio), axial)
    for z, axial in (before, behind):
        mesh.block(z, (INNER, INNER), (RADIUS, RADIUS), (across, 1), axial)
        mesh.face("wall", "wall", (RADIUS, z[0]), (RADIUS, z[1]))
    for patch, z in (("inlet", 0), ("outlet", length)):
        mesh.face(patch, "patch", (0, z), (INNER, z))
        mesh.face(patch, "patch", (INNER, z), (RADIUS, z))
    mesh.face("top", "wall", (INNER, begin), (INNER, end))
    mesh.face("front", "wall", (INNER, begin), (RADIUS, begin))
    mesh.face("back", "wall", (INNER, end), (RADIUS, end))
    return mesh


def resolved(folder, length, cell):
    """Mean wall shear stress [Pa] on the square ring, of an axisymmetric solution with cells of this size [m] at it."""
    samples = folder / "postProcessing/ring"
    if not samples.exists():
        samplers = " ".join("%s {type patch; patches (%s);}" % (patch, patch) for patch in ("top", "front", "back"))
        wedge.solve(folder, ringWedge(length, cell), meanVelocity=MEAN_VELOCITY, inletRadius=RADIUS, viscosity=VISCOSITY,
                    functions="""
  stress {type wallShearStress; libs ("libfieldFunctionObjects.so"); writeControl writeTime;}
  ring {type surfaces; libs ("libsampling.so"); writeControl writeTime; surfaceFormat raw; fields (wallShearStress);
        interpolate false; surfaces (%s);}
""" % samplers)
    last = max(samples.iterdir(), key=lambda time: float(time.name))
    force, area = 0.0, 0.0
    for patch in ("top", "front", "back"):
        (file,) = last.glob(f"*_{patch}.raw")
        x, y, z, stressX, stressY, stressZ = np.loadtxt(file).T
        r = np.hypot(x, y)
        # Along the face: what OpenFOAM gives across it is its discretisation's
        along, stress = (z, stressZ) if patch == "top" else (r, (x * stressX + y * stressY) / r)
        order = np.argsort(along)
        along = along[order]
        between = (along[1:] + along[:-1]) / 2
        ends = ((length - STRUT) / 2, (length + STRUT) / 2) if patch == "top" else (INNER, RADIUS)
        edges = np.concatenate(([ends[0]], between, [ends[1]]))
        own = np.diff(edges) * 2 * np.pi * INNER if patch == "top" else np.pi * np.diff(edges ** 2)
        force += float(DENSITY * np.abs(stress)[order] @ own)
        area += float(own.sum())
    return force / area
