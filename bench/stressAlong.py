"""Mean wall shear stress along a lumen in which two methods were compared."""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersVerdict import vtkCellSizeFilter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader


def stressAlong(file, first, last, step):
    """z [mm], and the stress of either method [Pa], of compare.vtp: means over rings of the wall that are `step` mm wide."""
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(file))
    sizes = vtkCellSizeFilter()
    sizes.SetInputConnection(reader.GetOutputPort())
    sizes.Update()
    surface = sizes.GetOutput()
    corners = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    z = 1e3 * vtk_to_numpy(surface.GetPoints().GetData())[corners].mean(1)[:, 2]
    area, foam, lattice = (vtk_to_numpy(surface.GetCellData().GetArray(name)) for name in ("Area", "WSS_foam", "WSS_lbm"))
    for start in np.arange(first, last, step):
        ring = (z >= start) & (z < start + step)
        if ring.any():
            yield start + step / 2, *(round(float(np.average(of[ring], weights=area[ring])), 4) for of in (foam, lattice))
