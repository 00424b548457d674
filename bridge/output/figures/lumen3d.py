"""lumen3d.png: the lumen in space on several days, opened along its axis if it has one, coloured by wall shear stress.

Needs a display.
"""

import matplotlib
import matplotlib.pyplot as plt
import numpy as np
import rendering
import results
import style
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkFiltersCore import vtkCellDataToPointData, vtkPolyDataNormals
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer

FRAMES = 4
PANEL = (900, 760)  # pixels
WIDTH, LEAST_HEIGHT = 3.2, 1.6  # of a panel [in]


def colour_table(name, low, high):
    table = vtkLookupTable()
    table.SetNumberOfTableValues(256)
    for k, colour in enumerate(matplotlib.colormaps[name](np.linspace(0, 1, 256))):
        table.SetTableValue(k, *colour)
    table.SetNanColor(0.78, 0.78, 0.78, 1)
    table.SetTableRange(low, high)
    return table


def smoothed(data):
    """The lumen with its colours on the points, and normals."""
    points = vtkCellDataToPointData()
    points.SetInputData(data)
    normals = vtkPolyDataNormals()
    normals.SetInputConnection(points.GetOutputPort())
    normals.SplittingOff()
    normals.Update()
    return normals.GetOutput()


def into_the_half(camera, data):
    """Looks at the half of a lumen about the z axis that is right of x = 0, from the open side."""
    bounds = data.GetBounds()
    length, radius = bounds[5], bounds[1]
    camera.SetFocalPoint(0.35 * radius, 0, 0.5 * length)
    camera.SetPosition(-4.2 * radius, 2.2 * radius, 0.5 * length + 2.4 * radius)
    camera.SetViewUp(0, 1, 0)
    camera.SetParallelScale(0.62 * max(length, 2.2 * radius))


def at_the_widest_side(camera, data):
    """Looks at a lumen that lies as it likes along the direction that it reaches least far in, its longest across."""
    points = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
    middle = 0.5 * (points.min(axis=0) + points.max(axis=0))
    longest, second, least = np.linalg.svd(points - points.mean(axis=0), full_matrices=False)[2]
    reach = [np.abs((points - middle) @ axis).max() for axis in (longest, second, least)]
    camera.SetFocalPoint(*middle)
    camera.SetPosition(*(middle + 3 * (reach[0] + reach[2]) * least))
    camera.SetViewUp(*second)
    camera.SetParallelScale(1.08 * max(reach[1], reach[0] * PANEL[1] / PANEL[0]))


def render(data, table, opened):
    """A picture of one lumen as an array (height, width, 3); `opened`: cut along its axis."""
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(smoothed(data))
    if opened:
        opening = vtkPlane()
        opening.SetNormal(1, 0, 0)
        mapper.AddClippingPlane(opening)
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray("WSS")
    mapper.SetLookupTable(table)
    mapper.UseLookupTableScalarRangeOn()
    mapper.InterpolateScalarsBeforeMappingOn()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetAmbient(0.25)
    actor.GetProperty().SetDiffuse(0.75)
    actor.GetProperty().SetSpecular(0.15)

    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    renderer.AddActor(actor)
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    (into_the_half if opened else at_the_widest_side)(camera, data)
    renderer.ResetCameraClippingRange()
    return rendering.image_of(renderer, PANEL)


def draw(folder, path):
    style.apply()
    opened = not results.only_flow_from_file(folder)
    entries = results.spread(results.frames(folder, "lumen"), FRAMES)
    if not opened:
        entries = entries[-1:]  # it does not change
    data = [results.poly_data(file) for _, file in entries]
    shear = np.concatenate([vtk_to_numpy(d.GetCellData().GetArray("WSS")) for d in data])
    shear = shear[np.isfinite(shear)]
    top = np.percentile(shear, 98) if shear.size else 1.0
    table = colour_table(style.WSS_MAP, 0.0, top)
    images = rendering.trimmed([render(d, table, opened) for d in data])

    height = max(WIDTH * images[0].shape[0] / images[0].shape[1], LEAST_HEIGHT)
    figure, axes = plt.subplots(1, len(images), figsize=(WIDTH * len(images) + 0.8, height + 0.4), squeeze=False)
    for axis, image, (day, _) in zip(axes[0], images, entries):
        axis.imshow(image)
        axis.set_axis_off()
        axis.set_title(style.day_label(day))
    style.letter_panels(axes[0])
    colours = matplotlib.cm.ScalarMappable(matplotlib.colors.Normalize(0, top), style.WSS_MAP)
    label = "wall shear stress [Pa]\n(grey: not solved yet)" if shear.size else "no flow was solved"
    figure.colorbar(colours, ax=axes, label=label, shrink=0.8, pad=0.01, extend="max")
    style.save(figure, path)
    plt.close(figure)
