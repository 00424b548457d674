#!/usr/bin/env python3
"""Grid convergence of the OpenFOAM backend in a stented lumen.

    /usr/bin/python3 bench/convergence.py PROGRAM WORKFOLDER PICTURE

Writes a lumen with two square rings as STL, solves the flow in it by PROGRAM (restenosisFoam) on three meshes with a
constant refinement ratio and at the fidelity `standard`, and prints three tables: cost and quantities by mesh; observed
order, extrapolated value and grid convergence index by quantity (Celik et al., J. Fluids Eng. 130:078001, 2008); how far
these and some more meshes are from the finest between the rings. Draws the stress along the vessel into PICTURE. Runs that are finished in WORKFOLDER are not made again.
"""
import json
import math
import subprocess
import sys
from pathlib import Path

import matplotlib
import numpy
import vtk
from vtk.util.numpy_support import vtk_to_numpy

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

RADIUS, LENGTH, STRUT = 0.9, 1.5, 0.09  # mm
RINGS = (0.5, 1.0)  # where the middles of the rings are [mm]
BETWEEN = (RINGS[0] + STRUT / 2, RINGS[1] - STRUT / 2)
DENSITY = 1000  # kg/m^3, the default of [flow]
RATIO = math.sqrt(2)
MESHES = {"coarse": 45 * RATIO**2, "medium": 45 * RATIO, "fine": 45.0}  # core cells [um]; "fine" is `reference`
STANDARD = 60.0
MORE = {  # keys of [foam]
    "52 um": {"cellSize": "52 um"},
    "standard, 4 rows between sizes": {"cellSize": "60 um", "bufferCells": 4},
    "standard, 15 um at the wall": {"cellSize": "60 um", "wallLevel": 2},
    "fine, 4 rows between sizes": {"cellSize": "45 um", "bufferCells": 4},
}
SIDES = 128
BIN = 0.02  # mm, of the stress along the vessel
SAFETY = 1.25  # of the GCI, for three meshes (Celik et al.)

SCENE = """[scene]
title = "Two rings: grid convergence"
duration = "1 h"
step = "1 h"

[vessel]
lumenSurface = "rings.stl"

[flow]
backend = "foam"
meanVelocity = "0.133 m/s"

[foam]
{}

[output]
pictures = false
"""


def write_surface(path):
    """The closed lumen, its solids named, swept by a profile of radius and z."""
    profile = [(RADIUS, 0.0)]
    for middle in RINGS:
        low, high = middle - STRUT / 2, middle + STRUT / 2
        profile += [(RADIUS, low), (RADIUS - STRUT, low), (RADIUS - STRUT, high), (RADIUS, high)]
    profile += [(RADIUS, LENGTH)]
    step = 2 * math.pi / SIDES
    widening = math.sqrt(step / math.sin(step))  # the polygon has the area of the circle

    def point(ring, side):
        radius, z = profile[ring]
        return (radius * widening * math.cos(side * step), radius * widening * math.sin(side * step), z)

    solids = {"wall": [], "strut": [], "inlet": [], "outlet": []}
    for ring in range(len(profile) - 1):
        name = "wall" if ring % 4 == 0 else "strut"
        for i in range(SIDES):
            a, b, c, d = point(ring, i), point(ring, i + 1), point(ring + 1, i + 1), point(ring + 1, i)
            solids[name] += [(a, b, c), (a, c, d)]
    last = len(profile) - 1
    for i in range(SIDES):
        solids["inlet"].append(((0, 0, 0), point(0, i + 1), point(0, i)))
        solids["outlet"].append(((0, 0, LENGTH), point(last, i), point(last, i + 1)))
    with open(path, "w") as stl:
        for name, triangles in solids.items():
            stl.write(f"solid {name}\n")
            for triangle in triangles:
                stl.write("facet normal 0 0 0\nouter loop\n")
                stl.writelines("vertex {:.9g} {:.9g} {:.9g}\n".format(*vertex) for vertex in triangle)
                stl.write("endloop\nendfacet\n")
            stl.write(f"endsolid {name}\n")


class Patch:
    """Faces of a patch: places [mm], areas [mm^2] and wall shear stresses [Pa]."""

    def __init__(self, path):
        reader = vtk.vtkXMLPolyDataReader()
        reader.SetFileName(str(path))
        reader.Update()
        data = reader.GetOutput()
        points = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
        stress = vtk_to_numpy(data.GetCellData().GetArray("wallShearStress"))
        self.stress = numpy.linalg.norm(stress, axis=1) * DENSITY * 1e-6
        self.centre = numpy.empty((len(stress), 3))
        self.area = numpy.empty(len(stress))
        ids = vtk.vtkIdList()
        for face in range(len(stress)):
            data.GetCellPoints(face, ids)
            corners = points[[ids.GetId(i) for i in range(ids.GetNumberOfIds())]]
            middle = corners.mean(axis=0)
            cross = numpy.cross(corners - middle, numpy.roll(corners, -1, axis=0) - middle)
            self.area[face] = numpy.linalg.norm(cross.sum(axis=0)) / 2
            self.centre[face] = middle

    def within(self, low, high):
        """The faces between two z [mm]."""
        part = object.__new__(Patch)
        inside = (self.centre[:, 2] > low) & (self.centre[:, 2] < high)
        part.centre, part.area, part.stress = self.centre[inside], self.area[inside], self.stress[inside]
        return part

    def mean(self):
        return numpy.average(self.stress, weights=self.area)

    def percentile(self, share):
        order = numpy.argsort(self.stress)
        below = numpy.cumsum(self.area[order]) / self.area.sum()
        return self.stress[order][numpy.searchsorted(below, share)]

    def along(self):
        """Mean stress by slices of z: their middles and means."""
        slices = numpy.floor(self.centre[:, 2] / BIN).astype(int)
        places = numpy.unique(slices)
        means = [numpy.average(self.stress[slices == s], weights=self.area[slices == s]) for s in places]
        return (places + 0.5) * BIN, numpy.array(means)


class Solution:
    """One finished run."""

    def __init__(self, folder):
        case = next((folder / "flow").iterdir())
        samples = max((case / "postProcessing/surface").iterdir(), key=lambda path: int(path.name))
        self.wall = Patch(samples / "wall.vtp")
        self.between = self.wall.within(*BETWEEN)
        self.strut = Patch(samples / "strut.vtp")
        parts = json.loads((folder / "summary.json").read_text())["parts"]
        self.mesh_seconds, self.solve_seconds = parts["mesh"]["seconds"], parts["flow"]["seconds"]
        log = (case / "log.checkMesh").read_text()
        self.cells = int(log.split("    cells: ")[1].split()[0])
        self.drop = self.pressure(case, "inletPressure") - self.pressure(case, "outletPressure")

    @staticmethod
    def pressure(case, name):
        table = (case / "postProcessing" / name / "0/surfaceFieldValue.dat").read_text()
        return float(table.split()[-1]) * DENSITY * 1e-6

    def quantities(self):
        return {
            "mean between rings [Pa]": self.between.mean(),
            "5th percentile there [Pa]": self.between.percentile(0.05),
            "50th percentile there [Pa]": self.between.percentile(0.5),
            "95th percentile there [Pa]": self.between.percentile(0.95),
            "mean on rings [Pa]": self.strut.mean(),
            "pressure drop [Pa]": self.drop,
        }


def solve(program, work, name, foam):
    folder = work / name.replace(", ", "_").replace(" ", "_")
    if not (folder / "summary.json").exists():
        scene = folder.with_suffix(".toml")
        scene.write_text(SCENE.format("\n".join(f"{key} = {json.dumps(value)}" for key, value in foam.items())))
        subprocess.run([program, "run", scene, "-o", folder], check=True, stdout=subprocess.DEVNULL)
    return Solution(folder)


def grid_convergence(coarse, medium, fine):
    """Kind of convergence, observed order, extrapolated value, GCI of the fine mesh [-]."""
    first, second = medium - fine, coarse - medium
    if first == 0:
        return "no change", None, fine, 0.0
    if first * second < 0:
        return "oscillates", None, None, None
    if abs(first) >= abs(second):
        return "diverges", None, None, None
    order = math.log(second / first) / math.log(RATIO)
    extrapolated = fine - first / (RATIO**order - 1)
    return "monotone", order, extrapolated, SAFETY * abs(first / fine) / (RATIO**order - 1)


def rms_between(solution, reference):
    """Relative rms of the stress between the rings against another solution's: face by face (the nearest), and of
    the means by slices."""
    mine, other = solution.between, reference.between
    nearest = numpy.array([numpy.argmin(((other.centre - place) ** 2).sum(axis=1)) for place in mine.centre])
    squares = (mine.stress - other.stress[nearest]) ** 2
    faces = math.sqrt(numpy.average(squares, weights=mine.area)) / other.mean()
    places, means = mine.along()
    theirs = numpy.interp(places, *other.along())
    return faces, math.sqrt(numpy.mean((means - theirs) ** 2)) / other.mean()


def draw(solutions, picture):
    figure, axes = pyplot.subplots(figsize=(8, 4.5))
    for name, solution in solutions.items():
        axes.plot(*solution.wall.along(), ".-", markersize=3, linewidth=1,
                  label=f"{name}: {solution.cells:,} cells")
    for middle in RINGS:
        axes.axvspan(middle - STRUT / 2, middle + STRUT / 2, color="0.85")
    axes.set(xlabel="z [mm]", ylabel="WSS on the wall, mean around [Pa]", xlim=(0, LENGTH), ylim=(0, None))
    axes.legend()
    axes.grid(alpha=0.3)
    figure.tight_layout()
    figure.savefig(picture, dpi=130)


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    program, work, picture = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve(), sys.argv[3]
    work.mkdir(parents=True, exist_ok=True)
    write_surface(work / "rings.stl")
    sizes = {**MESHES, "standard": STANDARD}
    solutions = {name: solve(program, work, name, {"cellSize": f"{size} um"}) for name, size in sizes.items()}
    more = {name: solve(program, work, name, foam) for name, foam in MORE.items()}

    quantities = {name: solution.quantities() for name, solution in solutions.items()}
    print("| mesh | core [um] | cells | mesh [s] | solve [s] | " + " | ".join(quantities["fine"]) + " |")
    print("|---" * (5 + len(quantities["fine"])) + "|")
    for name, s in solutions.items():
        values = " | ".join(f"{value:.4g}" for value in quantities[name].values())
        print(f"| {name} | {sizes[name]:.4g} | {s.cells:,} | {s.mesh_seconds:.1f} | {s.solve_seconds:.1f} | {values} |")
    print("\n| quantity | convergence | observed order | extrapolated | fine from it [%] | GCI of fine [%] |")
    print("|---|---|---|---|---|---|")
    for key, fine in quantities["fine"].items():
        kind, order, limit, gci = grid_convergence(quantities["coarse"][key], quantities["medium"][key], fine)
        if order is None:
            print(f"| {key} | {kind} | - | - | - | - |")
        else:
            print(f"| {key} | {kind} | {order:.2f} | {limit:.4g} | {100 * (fine / limit - 1):+.1f} | {100 * gci:.1f} |")
    print()
    print("| mesh | cells | mesh and solve [s] | mean between rings [Pa] | rms against fine, face by face [%] | of means around [%] |")
    print("|---|---|---|---|---|---|")
    for name, s in (solutions | more).items():
        faces, slices = rms_between(s, solutions["fine"])
        print(f"| {name} | {s.cells:,} | {s.mesh_seconds + s.solve_seconds:.0f} | {s.between.mean():.4g} | "
              f"{100 * faces:.1f} | {100 * slices:.1f} |")
    draw(solutions, picture)


main()
