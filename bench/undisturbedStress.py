#!/usr/bin/env python3
"""Wall shear stress near the inlet, at the first solve of a finished run of scenes/quick.toml.

    /usr/bin/python3 bench/undisturbedStress.py results/quick

Prints for slices of the wall their area-weighted mean radius and stress, and 4 mu U / R of the undeformed lumen.
"""
import sys
from pathlib import Path

import numpy
import vtk
from vtk.util.numpy_support import vtk_to_numpy

VISCOSITY, MEAN_VELOCITY, RADIUS = 2.7e-3, 0.133, 0.9e-3  # Pa s, m/s, m: the scene's
SLICES = [(0.00, 0.05), (0.05, 0.10), (0.10, 0.15), (0.15, 0.20), (0.25, 0.30)]  # mm


def first_solved(results):
    """The first lumen of the series that carries a stress: its file's name and its polygons."""
    for path in sorted((Path(results) / "lumen").glob("*.vtp")):
        reader = vtk.vtkXMLPolyDataReader()
        reader.SetFileName(str(path))
        reader.Update()
        stress = reader.GetOutput().GetCellData().GetArray("WSS")
        if stress and not numpy.isnan(vtk_to_numpy(stress)).all():
            return path.name, reader.GetOutput()
    sys.exit(f"{results}: no lumen with wall shear stress")


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    name, lumen = first_solved(sys.argv[1])
    centres = vtk.vtkCellCenters()
    centres.SetInputData(lumen)
    centres.Update()
    points = vtk_to_numpy(centres.GetOutput().GetPoints().GetData()) * 1e3  # mm
    stress = vtk_to_numpy(lumen.GetCellData().GetArray("WSS"))
    area = numpy.array([lumen.GetCell(i).ComputeArea() for i in range(lumen.GetNumberOfCells())])
    radius = numpy.hypot(points[:, 0], points[:, 1])
    exact = 4 * VISCOSITY * MEAN_VELOCITY / RADIUS
    print(f"{name}: 4 mu U / R = {exact:.3f} Pa")
    for low, high in SLICES:
        inside = (points[:, 2] >= low) & (points[:, 2] < high)
        mean = numpy.average(stress[inside], weights=area[inside])
        print(f"z {low:.2f} to {high:.2f} mm  R {1e3 * numpy.average(radius[inside], weights=area[inside]):6.1f} um  "
              f"WSS {mean:.3f} Pa  {100 * (mean / exact - 1):+5.1f} %")


main()
