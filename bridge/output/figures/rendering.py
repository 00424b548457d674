"""What pictures in space share: one picture of a scene as an array. Needs a display."""

import numpy as np
import vtkmodules.vtkInteractionStyle  # noqa: F401  (registers what rendering needs)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import vtkRenderWindow, vtkWindowToImageFilter


def image_of(renderer, size, samples=8):
    """The picture of a renderer as an array (height, width, 3); `size`: width and height in pixels.

    `samples`: of a pixel, for smooth edges; 0 where the renderer has passes of its own.
    """
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(samples)
    window.SetSize(*size)
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
