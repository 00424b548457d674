"""lumen3d.png: the lumen in space on several days, opened along its axis, coloured by wall shear stress.

Run by itself, with a display: lumen3d.py RESULTS.
"""

import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
import results
import style
import vtkmodules.vtkInteractionStyle  # noqa: F401  (registers what rendering needs)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkFiltersCore import vtkCellDataToPointData, vtkPolyDataNormals
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkWindowToImageFilter,
)

FRAMES = 4
PANEL = (900, 760)  # pixels


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


def render(data, table, length, radius):
    """A picture of one lumen as an array (height, width, 3)."""
    opening = vtkPlane()
    opening.SetNormal(-1, 0, 0)
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(smoothed(data))
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
    camera.SetFocalPoint(-0.35 * radius, 0, 0.5 * length)
    camera.SetPosition(4.2 * radius, 2.2 * radius, 0.5 * length - 2.4 * radius)
    camera.SetViewUp(0, 1, 0)
    camera.ParallelProjectionOn()
    camera.SetParallelScale(0.62 * max(length, 2.2 * radius))
    renderer.ResetCameraClippingRange()

    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(*PANEL)
    window.AddRenderer(renderer)
    window.Render()
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.Update()
    image = grab.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[::-1, :, :3].copy()


def trimmed(images):
    """Cuts the white margin that all images share."""
    ink = np.min([image.min(axis=2) for image in images], axis=0) < 250
    rows, columns = np.flatnonzero(ink.any(axis=1)), np.flatnonzero(ink.any(axis=0))
    if rows.size == 0:
        return images
    return [image[rows[0] : rows[-1] + 1, columns[0] : columns[-1] + 1] for image in images]


def draw(folder, path):
    style.apply()
    entries = results.spread(results.frames(folder, "lumen"), FRAMES)
    data = [results.poly_data(file) for _, file in entries]
    shear = np.concatenate([vtk_to_numpy(d.GetCellData().GetArray("WSS")) for d in data])
    shear = shear[np.isfinite(shear)]
    top = np.percentile(shear, 98) if shear.size else 1.0
    table = colour_table(style.WSS_MAP, 0.0, top)
    bounds = data[0].GetBounds()
    images = trimmed([render(d, table, bounds[5], bounds[1]) for d in data])

    figure, axes = plt.subplots(1, len(images), figsize=(3.2 * len(images) + 0.8, 3.3), squeeze=False)
    for axis, image, (day, _) in zip(axes[0], images, entries):
        axis.imshow(image)
        axis.set_axis_off()
        axis.set_title(style.day_label(day), loc="center")
    colours = matplotlib.cm.ScalarMappable(matplotlib.colors.Normalize(0, top), style.WSS_MAP)
    label = "wall shear stress [Pa]\n(grey: not solved yet)" if shear.size else "no flow was solved"
    figure.colorbar(colours, ax=axes, label=label, shrink=0.8, pad=0.01, extend="max")
    style.save(figure, path)
    plt.close(figure)


if __name__ == "__main__":
    try:
        draw(Path(sys.argv[1]), Path(sys.argv[1]) / "lumen3d.png")
    except FileNotFoundError as missing:
        sys.exit(str(missing))
