"""The triangles of a lumen file that a run has written."""
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkPointDataToCellData
from vtkmodules.vtkFiltersVerdict import vtkCellSizeFilter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader


def triangles(file, *names):
    """Centres (n, 3) [m], areas [m^2] and the fields of these names, those of points as means of the corners."""
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(file))
    means = vtkPointDataToCellData()
    means.SetInputConnection(reader.GetOutputPort())
    sizes = vtkCellSizeFilter()
    sizes.SetInputConnection(means.GetOutputPort())
    sizes.Update()
    surface = sizes.GetOutput()
    corners = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    centres = vtk_to_numpy(surface.GetPoints().GetData())[corners].mean(1)
    return centres, *(vtk_to_numpy(surface.GetCellData().GetArray(name)) for name in ("Area", *names))
