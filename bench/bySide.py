"""Neointimal thickness and wall shear stress by the angle around a vessel's axis."""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkPointDataToCellData
from vtkmodules.vtkFiltersVerdict import vtkCellSizeFilter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader


def sides(lumen, low, high, sectors):
    """Of a lumen file between two places [mm] along the vessel, for each of so many sectors: its middle angle [degrees],
    mean thickness [um] and mean stress [Pa] of its wall and struts. Of a bent vessel 90 degrees is the inner side."""
    reader, means, sizes = vtkXMLPolyDataReader(), vtkPointDataToCellData(), vtkCellSizeFilter()
    reader.SetFileName(str(lumen))
    means.SetInputConnection(reader.GetOutputPort())
    sizes.SetInputConnection(means.GetOutputPort())
    sizes.Update()
    surface = sizes.GetOutput()
    straight = surface.GetCellData().GetArray("straightPosition")
    if straight:
        x, y, z = vtk_to_numpy(straight).T
    else:
        corners = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
        x, y, z = vtk_to_numpy(surface.GetPoints().GetData())[corners].mean(1).T
    area, thickness, stress = (vtk_to_numpy(surface.GetCellData().GetArray(name))
                               for name in ("Area", "neointimaThickness", "WSS"))
    angle = np.degrees(np.arctan2(y, x)) % 360
    inside = (z > 1e-3 * low) & (z < 1e-3 * high) & np.isfinite(stress) & np.isfinite(thickness)
    sector = (angle * sectors / 360).astype(int) % sectors
    for n in range(sectors):
        those = inside & (sector == n)
        yield ((n + 0.5) * 360 / sectors, 1e6 * np.average(thickness[those], weights=area[those]),
               np.average(stress[those], weights=area[those]))
