"""A square ring in a tube: its surface, square to the flow or oblique, and a resolved solution of the square one.

The tube has a radius of 0.9 mm, the ring 0.09 mm in both directions; blood flows with 0.133 m/s in the mean.
"""
import math
import os
import subprocess
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersVerdict import vtkCellSizeFilter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

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


class Wedge:
    """The blockMesh of a wedge of five degrees around the axis, by (r, z) [m]."""

    def __init__(self):
        self.points, self.blocks = {}, []

    def at(self, r, z, side):
        key = (r, z, side if r > 0 else 0)
        return self.points.setdefault(key, len(self.points))

    def rectangle(self, z0, z1, r0, r1):
        """A face between two corners of a cut, across the wedge."""
        return "(%d %d %d %d)" % (self.at(r0, z0, -1), self.at(r1, z1, -1), self.at(r1, z1, 1), self.at(r0, z0, 1))

    def side(self, r0, r1, z0, z1, side):
        return "(%d %d %d %d)" % tuple(self.at(r, z, side) for r, z in ((r0, z0), (r1, z0), (r1, z1), (r0, z1)))

    def block(self, r, z, radial, axial):
        (r0, r1), (z0, z1) = r, z
        corners = [self.at(r, z, side) for z in (z0, z1) for r, side in ((r0, -1), (r1, -1), (r1, 1), (r0, 1))]
        self.blocks.append("hex (%s) (%d 1 %d) simpleGrading (%.8g 1 %.8g)" % (
            " ".join(map(str, corners)), radial[0], axial[0], radial[1], axial[1]))

    def vertices(self):
        half = math.radians(2.5)
        return "\n".join("(%.12g %.12g %.12g)" % (r * math.cos(half), side * r * math.sin(half), z)
                         for r, z, side in self.points)


def writeFoam(folder, name, kind, text):
    file = folder / name
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text("FoamFile{version 2.0;format ascii;class %s;object %s;}\n%s\n" % (kind, file.name, text))


def writeWedge(folder, length, cell):
    begin, end = (length - STRUT) / 2, (length + STRUT) / 2
    along, alongRatio = graded(begin, cell)
    core, coreRatio = graded(INNER, cell)
    across = round(STRUT / cell)
    wedge = Wedge()
    cuts = [((0, begin), (along, 1 / alongRatio)), ((begin, end), (across, 1)), ((end, length), (along, alongRatio))]
    for z, axial in cuts:
        wedge.block((0, INNER), z, (core, 1 / coreRatio), axial)
    for z, axial in (cuts[0], cuts[2]):
        wedge.block((INNER, RADIUS), z, (across, 1), axial)
    cells = [(0, INNER, *z) for z, _ in cuts] + [(INNER, RADIUS, *z) for z, _ in (cuts[0], cuts[2])]
    patches = {
        "inlet": ("patch", [wedge.rectangle(0, 0, 0, INNER), wedge.rectangle(0, 0, INNER, RADIUS)]),
        "outlet": ("patch", [wedge.rectangle(length, length, 0, INNER), wedge.rectangle(length, length, INNER, RADIUS)]),
        "wall": ("wall", [wedge.rectangle(0, begin, RADIUS, RADIUS), wedge.rectangle(end, length, RADIUS, RADIUS)]),
        "top": ("wall", [wedge.rectangle(begin, end, INNER, INNER)]),
        "front": ("wall", [wedge.rectangle(begin, begin, INNER, RADIUS)]),
        "back": ("wall", [wedge.rectangle(end, end, INNER, RADIUS)]),
        "minus": ("wedge", [wedge.side(*cell, -1) for cell in cells]),
        "plus": ("wedge", [wedge.side(*cell, 1) for cell in cells]),
        "axis": ("empty", [wedge.side(0, 0, *z, 0) for z, _ in cuts]),
    }
    writeFoam(folder, "system/blockMeshDict", "dictionary",
              "convertToMeters 1;\nvertices (\n%s\n);\nblocks (\n%s\n);\nedges ();\nboundary (\n%s\n);" % (
                  wedge.vertices(), "\n".join(wedge.blocks),
                  "\n".join("%s {type %s; faces (%s);}" % (patch, kind, " ".join(faces))
                            for patch, (kind, faces) in patches.items())))
    samples = " ".join("%s {type patch; patches (%s);}" % (patch, patch) for patch in ("top", "front", "back"))
    writeFoam(folder, "system/controlDict", "dictionary", """application simpleFoam;
startFrom startTime; startTime 0; stopAt endTime; endTime 4000; deltaT 1;
writeControl timeStep; writeInterval 4000; writeFormat ascii; writePrecision 10;
functions {
  stress {type wallShearStress; libs ("libfieldFunctionObjects.so"); writeControl writeTime;}
  ring {type surfaces; libs ("libsampling.so"); writeControl writeTime; surfaceFormat raw; fields (wallShearStress);
        interpolate false; surfaces (%s);}
}""" % samples)
    writeFoam(folder, "system/fvSchemes", "dictionary", """ddtSchemes {default steadyState;}
gradSchemes {default Gauss linear;}
divSchemes {default none; div(phi,U) bounded Gauss linear; div((nuEff*dev2(T(grad(U))))) Gauss linear;}
laplacianSchemes {default Gauss linear corrected;}
interpolationSchemes {default linear;}
snGradSchemes {default corrected;}""")
    writeFoam(folder, "system/fvSolution", "dictionary", """solvers {
  p {solver GAMG; smoother GaussSeidel; tolerance 1e-14; relTol 0.01;}
  U {solver smoothSolver; smoother symGaussSeidel; tolerance 1e-14; relTol 0.05;}
}
SIMPLE {consistent yes; nNonOrthogonalCorrectors 0; residualControl {p 1e-7; U 1e-7;}}
relaxationFactors {equations {U 0.9;}}""")
    writeFoam(folder, "constant/transportProperties", "dictionary", "transportModel Newtonian; nu %g;" % VISCOSITY)
    writeFoam(folder, "constant/turbulenceProperties", "dictionary", "simulationType laminar;")
    walls, wedges = '"(wall|top|front|back)"', '"(minus|plus)" {type wedge;} axis {type empty;}'
    developed = '"vector(0,0,%g*(1-(pos().x()*pos().x()+pos().y()*pos().y())/sqr(%g)))"' % (2 * MEAN_VELOCITY, RADIUS)
    writeFoam(folder, "0/U", "volVectorField", """dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 0.1);
boundaryField {inlet {type exprFixedValue; value uniform (0 0 %g); valueExpr %s;} outlet {type zeroGradient;}
%s {type noSlip;} %s}""" % (MEAN_VELOCITY, developed, walls, wedges))
    writeFoam(folder, "0/p", "volScalarField", """dimensions [0 2 -2 0 0 0 0]; internalField uniform 0;
boundaryField {inlet {type zeroGradient;} outlet {type fixedValue; value uniform 0;}
%s {type zeroGradient;} %s}""" % (walls, wedges))


def resolved(folder, length, cell):
    """Mean wall shear stress [Pa] on the square ring, of an axisymmetric solution with cells of this size [m] at it."""
    samples = folder / "postProcessing/ring"
    if not samples.exists():
        writeWedge(folder, length, cell)
        for program in ("blockMesh", "simpleFoam"):
            with open(folder / f"log.{program}", "w") as log:
                subprocess.run([program, "-case", folder], check=True, stdout=log, stderr=subprocess.STDOUT,
                               env={"WM_PROJECT_DIR": "/usr/share/openfoam"} | os.environ)  # Debian's
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
