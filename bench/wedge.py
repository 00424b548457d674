"""An axisymmetric flow resolved by OpenFOAM on a wedge of five degrees, with nothing of the program in it."""
import math
import os
import subprocess


class Wedge:
    """Its blockMesh, of blocks in the plane of r and z [m]. They meet where their corners are the same."""

    def __init__(self):
        self.points, self.blocks, self.patches = {}, [], {"minus": ("wedge", []), "plus": ("wedge", []), "axis": ("empty", [])}

    def at(self, r, z, side):
        return self.points.setdefault((r, z, side if r > 0 else 0), len(self.points))

    def face(self, patch, kind, a, b):
        """A face of a patch between two corners (r, z), across the wedge."""
        corners = (self.at(*a, -1), self.at(*b, -1), self.at(*b, 1), self.at(*a, 1))
        self.patches.setdefault(patch, (kind, []))[1].append("(%d %d %d %d)" % corners)

    def block(self, z, inner, outer, radial, axial):
        """From z[0] to z[1], between the radii inner[0] and outer[0] there, and inner[1] and outer[1]; `radial` and
        `axial` are numbers of cells and ratios of the last to the first."""
        corners = [self.at(r, along, side) for n, along in enumerate(z)
                   for r, side in ((inner[n], -1), (outer[n], -1), (outer[n], 1), (inner[n], 1))]
        self.blocks.append("hex (%s) (%d 1 %d) simpleGrading (%.8g 1 %.8g)" % (
            " ".join(map(str, corners)), radial[0], axial[0], radial[1], axial[1]))
        for patch, side in (("minus", -1), ("plus", 1)):
            self.patches[patch][1].append("(%d %d %d %d)" % tuple(
                self.at(r, along, side)
                for r, along in ((inner[0], z[0]), (outer[0], z[0]), (outer[1], z[1]), (inner[1], z[1]))))
        if inner == (0, 0):
            self.face("axis", "empty", (0, z[0]), (0, z[1]))

    def dictionary(self):
        half = math.radians(2.5)
        points = "\n".join("(%.12g %.12g %.12g)" % (r * math.cos(half), side * r * math.sin(half), z)
                           for r, z, side in self.points)
        patches = "\n".join("%s {type %s; faces (%s);}" % (patch, kind, " ".join(faces))
                            for patch, (kind, faces) in self.patches.items())
        return ("convertToMeters 1;\nvertices (\n%s\n);\nblocks (\n%s\n);\nedges ();\nboundary (\n%s\n);" % (
            points, "\n".join(self.blocks), patches))


def write(folder, name, kind, text):
    file = folder / name
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text("FoamFile{version 2.0;format ascii;class %s;object %s;}\n%s\n" % (kind, file.name, text))


def solve(folder, wedge, *, meanVelocity, inletRadius, viscosity, functions):
    """Developed flow enters by the patch `inlet` and leaves by `outlet`; the function objects write when it is steady."""
    write(folder, "system/blockMeshDict", "dictionary", wedge.dictionary())
    write(folder, "system/controlDict", "dictionary", """application simpleFoam;
startFrom startTime; startTime 0; stopAt endTime; endTime 4000; deltaT 1;
writeControl timeStep; writeInterval 4000; writeFormat ascii; writePrecision 10;
functions {%s}""" % functions)
    write(folder, "system/fvSchemes", "dictionary", """ddtSchemes {default steadyState;}
gradSchemes {default Gauss linear;}
divSchemes {default none; div(phi,U) bounded Gauss linear; div((nuEff*dev2(T(grad(U))))) Gauss linear;}
laplacianSchemes {default Gauss linear corrected;}
interpolationSchemes {default linear;}
snGradSchemes {default corrected;}""")
    write(folder, "system/fvSolution", "dictionary", """solvers {
  p {solver GAMG; smoother GaussSeidel; tolerance 1e-12; relTol 0.01; maxIter 100;}
  U {solver smoothSolver; smoother symGaussSeidel; tolerance 1e-14; relTol 0.05;}
}
SIMPLE {consistent yes; nNonOrthogonalCorrectors 0; residualControl {p 1e-9;}}
relaxationFactors {equations {U 0.9;}}""")
    write(folder, "constant/transportProperties", "dictionary", "transportModel Newtonian; nu %g;" % viscosity)
    write(folder, "constant/turbulenceProperties", "dictionary", "simulationType laminar;")
    walls = '"(%s)"' % "|".join(patch for patch, (kind, _) in wedge.patches.items() if kind == "wall")
    wedges = '"(minus|plus)" {type wedge;} axis {type empty;}'
    developed = '"vector(0,0,%g*(1-(pos().x()*pos().x()+pos().y()*pos().y())/sqr(%g)))"' % (2 * meanVelocity, inletRadius)
    write(folder, "0/U", "volVectorField", """dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 0.1);
boundaryField {inlet {type exprFixedValue; value uniform (0 0 %g); valueExpr %s;} outlet {type zeroGradient;}
%s {type noSlip;} %s}""" % (meanVelocity, developed, walls, wedges))
    write(folder, "0/p", "volScalarField", """dimensions [0 2 -2 0 0 0 0]; internalField uniform 0;
boundaryField {inlet {type zeroGradient;} outlet {type fixedValue; value uniform 0;}
%s {type zeroGradient;} %s}""" % (walls, wedges))
    for program in ("blockMesh", "simpleFoam"):
        with open(folder / f"log.{program}", "w") as log:
            subprocess.run([program, "-case", folder], check=True, stdout=log, stderr=subprocess.STDOUT,
                           env={"WM_PROJECT_DIR": "/usr/share/openfoam"} | os.environ)  # Debian's
