"""Neointimal thickness by the wall shear stress after stenting, as Sanmartin et al. (2006) have it."""
import numpy as np
from scipy.spatial import cKDTree
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkPointDataToCellData
from vtkmodules.vtkFiltersVerdict import vtkCellSizeFilter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader


def triangles(file, name):
    """Places of a lumen surface's triangles on the wall, along [m] and around it as at a radius of 1 mm, their areas, and
    a field."""
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(file))
    means = vtkPointDataToCellData()
    means.SetInputConnection(reader.GetOutputPort())
    sizes = vtkCellSizeFilter()
    sizes.SetInputConnection(means.GetOutputPort())
    sizes.Update()
    surface = sizes.GetOutput()
    corners = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    x, y, z = vtk_to_numpy(surface.GetPoints().GetData())[corners].mean(1).T
    return np.column_stack((z, 1e-3 * np.arctan2(y, x))), *(vtk_to_numpy(surface.GetCellData().GetArray(a)) for a in ("Area", name))


def quartiles(stressed, grown, low, high):
    """Mean stress [Pa] in one lumen file and thickness [um] in another, in each quarter of the area between two places
    [mm] along the vessel, by the stress; and the correlation of both."""
    places, area, stress = triangles(stressed, "WSS")
    grownPlaces, _, thickness = triangles(grown, "neointimaThickness")
    thickness = 1e6 * thickness[cKDTree(grownPlaces).query(places)[1]]
    inside = (places[:, 0] > 1e-3 * low) & (places[:, 0] < 1e-3 * high) & np.isfinite(stress) & np.isfinite(thickness)
    area, stress, thickness = area[inside], stress[inside], thickness[inside]

    order = np.argsort(stress)
    quarter = np.empty(len(order), dtype=int)
    quarter[order] = np.minimum(4 * np.cumsum(area[order]) / area.sum(), 3).astype(int)
    of_quarters = [(np.average(stress[quarter == n], weights=area[quarter == n]),
                    np.average(thickness[quarter == n], weights=area[quarter == n])) for n in range(4)]
    return of_quarters, np.corrcoef(stress, thickness)[0, 1]
