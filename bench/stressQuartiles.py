"""Neointimal thickness by the wall shear stress after stenting, as Sanmartin et al. (2006) have it."""
import csv

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersVerdict import vtkCellSizeFilter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader


def lumen(file):
    """Centres [m], areas, and wall shear stress [Pa] of the triangles of a lumen surface."""
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(file))
    sizes = vtkCellSizeFilter()
    sizes.SetInputConnection(reader.GetOutputPort())
    sizes.Update()
    surface = sizes.GetOutput()
    corners = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    centres = vtk_to_numpy(surface.GetPoints().GetData())[corners].mean(1)
    return (centres, *(vtk_to_numpy(surface.GetCellData().GetArray(name)) for name in ("Area", "WSS")))


def quartiles(folder, step, low, high):
    """Mean stress [Pa] and thickness at the end [um] in each quarter of the area between two places [mm] along the
    vessel, by the stress of a step; and the correlation of both."""
    with open(folder / "thicknessMap.csv", newline="") as file:
        table = np.array([[float(value) for value in line.values()] for line in csv.DictReader(file)])
    along, angles = (np.unique(table[:, column]) for column in (0, 1))
    thickness = table[:, 3].reshape(len(along), len(angles))

    centres, area, stress = lumen(folder / f"lumen/lumen_{step:06d}.vtp")
    z = 1e3 * centres[:, 2]
    row = np.rint(np.interp(z, along, np.arange(len(along)))).astype(int)
    degrees = np.degrees(np.arctan2(centres[:, 1], centres[:, 0])) % 360
    column = np.rint(degrees / 360 * len(angles)).astype(int) % len(angles)
    grown = thickness[row, column]
    inside = (z > low) & (z < high) & np.isfinite(stress) & np.isfinite(grown)
    area, stress, grown = area[inside], stress[inside], grown[inside]

    order = np.argsort(stress)
    quarter = np.empty(len(order), dtype=int)
    quarter[order] = np.minimum(4 * np.cumsum(area[order]) / area.sum(), 3).astype(int)
    of_quarters = [(np.average(stress[quarter == n], weights=area[quarter == n]),
                    np.average(grown[quarter == n], weights=area[quarter == n])) for n in range(4)]
    return of_quarters, np.corrcoef(stress, grown)[0, 1]
