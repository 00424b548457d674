"""vessel.png: the vessel cut open along its axis on the last day: stent, new tissue, laminae and media. animation.gif: the
same day by day. Both need a display."""

import anatomy
import matplotlib.pyplot as plt
import numpy as np
import rendering
import results
import style
from PIL import Image
from matplotlib.colors import to_rgb
from matplotlib.lines import Line2D
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkGlyph3DMapper, vtkRenderer
from vtkmodules.vtkRenderingOpenGL2 import vtkRenderStepsPass, vtkSSAOPass

LONG_SIDE = 1500  # of the picture [pixels]
DOTS = 200  # pixels to an inch
FRAMES = 25  # of an animation at most
FRAME_TIME, LAST_TIME = 300, 2500  # how long one is shown [ms]
FRAME_WIDTH = 1000  # [pixels]
WORDS = (480, 110)  # room for them on the right of the picture and below it [pixels]
TURNED, RAISED = np.radians(28), np.radians(18)  # the camera, from the x axis towards the outlet and upwards
BENEATH = 45  # from the vessel to what is written beneath it [pixels]
HIDDEN = 5  # media deeper than this, in radii, is not seen
MANY = 40000  # spheres from which on they are small, and drawn with fewer faces
SHADE = 20  # reach of shadows, in radii
SHOWN = (anatomy.STENT, anatomy.NEOINTIMA, anatomy.IEL, anatomy.MEDIA, anatomy.EEL)


class View:
    """A view from the side, along parallel lines, of points [mm] that fill the picture."""

    def __init__(self, points, margin):
        towards = (-np.cos(RAISED) * np.cos(TURNED), np.sin(RAISED), np.cos(RAISED) * np.sin(TURNED))
        self.towards = np.array(towards)
        self.right = np.cross((0, 1, 0), self.towards)
        self.right /= np.linalg.norm(self.right)
        self.up = np.cross(self.towards, self.right)
        low, high = (edge(points @ np.array([self.right, self.up]).T, axis=0) for edge in (np.min, np.max))
        self.middle, self.extent = (low + high) / 2, high - low + 2 * margin
        self.scale = LONG_SIDE / self.extent.max()  # [pixels/mm]
        self.size = [int(pixels) for pixels in np.ceil(self.scale * self.extent)]
        self.depth = np.ptp(points @ self.towards) + 2 * margin

    def aim(self, camera, points):
        """Sets a camera so that it takes this view."""
        centre = self.middle @ [self.right, self.up] + (points @ self.towards).mean() * self.towards
        camera.ParallelProjectionOn()
        camera.SetFocalPoint(*centre)
        camera.SetPosition(*(centre + 2 * self.depth * self.towards))
        camera.SetViewUp(*self.up)
        camera.SetParallelScale(self.extent[1] / 2)

    def pixel(self, point):
        """Where a point [mm] lies in the picture, to the right and downwards [pixels]."""
        across, up = np.array([self.right, self.up]) @ point - self.middle
        return self.scale * np.array([self.extent[0] / 2 + across, self.extent[1] / 2 - up])


def seen(agents, part, line):
    """Which agents of the half right of x = 0 can be seen: all but media deep beneath the cut, the ends and the IEL."""
    x, _, z = agents["position"].T
    if line is None:
        return x > 0
    deep = HIDDEN * agents["radius"]
    radius, angle, _ = anatomy.cylindrical(agents)
    inside = (x > deep) & (z > z.min() + deep) & (z < z.max() - deep) & (radius > line.at(angle, z) + deep)
    return (x > 0) & ~(inside & (part == anatomy.MEDIA))


def spheres(points, radius, colours):
    """An actor of spheres, each with its radius and its colour."""
    data, places = vtkPolyData(), vtkPoints()
    places.SetData(numpy_to_vtk(points.astype(np.float32), deep=1))
    data.SetPoints(places)
    for name, values in (("radius", radius.astype(np.float32)), ("colour", colours)):
        array = numpy_to_vtk(values, deep=1)
        array.SetName(name)
        data.GetPointData().AddArray(array)
    ball = vtkSphereSource()
    ball.SetRadius(1)
    ball.SetThetaResolution(12 if len(points) < MANY else 8)
    ball.SetPhiResolution(9 if len(points) < MANY else 6)
    mapper = vtkGlyph3DMapper()
    mapper.SetInputData(data)
    mapper.SetSourceConnection(ball.GetOutputPort())
    mapper.SetScaleArray("radius")
    mapper.SetScaleModeToScaleByMagnitude()
    mapper.OrientOff()
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray("colour")
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetAmbient(0.3)
    actor.GetProperty().SetDiffuse(0.8)
    return actor


def shadows(reach):
    """Darkens what lies between cells, so that depth is seen; `reach` in mm."""
    passes = vtkSSAOPass()
    passes.SetRadius(reach)
    passes.SetBias(0.05 * reach)
    passes.SetKernelSize(64)
    passes.BlurOn()
    passes.SetDelegatePass(vtkRenderStepsPass())
    return passes


def render(view, points, radius, part):
    """The picture as an array (height, width, 3)."""
    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    palette = np.array([to_rgb(colour) for _, colour in anatomy.PARTS])
    renderer.AddActor(spheres(points, radius, (255 * palette[part]).astype(np.uint8)))
    view.aim(renderer.GetActiveCamera(), points)
    renderer.ResetCameraClippingRange()
    renderer.SetPass(shadows(SHADE * radius.mean()))
    return rendering.image_of(renderer, view.size, samples=0)


def beneath(axis, view, points, share, text, **look):
    """A line along the vessel, beneath it, over a share of its length (from, to), with a text below it."""
    edge = np.array([0, points[:, 1].min(), 0])
    ends = [view.pixel(edge + [0, 0, z * points[:, 2].max()]) + [0, BENEATH] for z in share]
    axis.annotate("", ends[1], ends[0], arrowprops={"color": style.BLACK, "shrinkA": 0, "shrinkB": 0, **look})
    run, fall = ends[1] - ends[0]
    axis.annotate(
        text,
        (ends[0] + ends[1]) / 2,
        xytext=(0, -5),
        textcoords="offset points",
        ha="center",
        va="top",
        rotation=np.degrees(np.arctan2(-fall, run)),
        rotation_mode="anchor",
    )


def mark(axis, view, points, flows):
    """A scale bar, and an arrow of the flow where there is one."""
    length = points[:, 2].max()
    bar = style.round_length(0.4 * length)
    beneath(axis, view, points, (0.02, 0.02 + bar / length), style.length_label(bar), arrowstyle="-", linewidth=3.5)
    if flows:
        beneath(axis, view, points, (0.55, 0.95), "blood flow", arrowstyle="-|>", linewidth=2, mutation_scale=18)


def legend(figure, part, title):
    """Names the colours that occur, to the right of the picture."""
    found = [anatomy.PARTS[number] for number in SHOWN if (part == number).any()]
    handles = [
        Line2D([], [], marker="o", markersize=10, linestyle="", color=colour, label=name) for name, colour in found
    ]
    figure.legend(
        handles=handles,
        title=title,
        title_fontsize=13,
        alignment="left",
        loc="center right",
        fontsize=10,
        labelspacing=1.2,
        handletextpad=0.3,
    )


def framed(image):
    """A figure with the image pixel by pixel on its left, and room for words on its right and below."""
    height, width = image.shape[:2]
    size = np.array([width + WORDS[0], height + WORDS[1]])
    figure = plt.figure(figsize=size / DOTS, dpi=DOTS, layout="none")
    axis = figure.add_axes((0, 0, width / size[0], 1))
    axis.imshow(image, aspect="auto")
    axis.set_ylim(size[1], 0)
    axis.set_axis_off()
    return figure, axis


def visible(file):
    """Places and radii [mm] of the agents that are seen, and the part that each belongs to."""
    agents = results.agents(file)
    line = anatomy.iel_line(agents)
    part = anatomy.parts(agents, line)
    shown = seen(agents, part, line)
    return 1e3 * agents["in_space"][shown], 1e3 * agents["radius"][shown], part[shown]


def view_of(points, radius, _):
    return View(points, margin=2 * radius.max())


def picture(view, spheres_seen, day, flows, named):
    """A figure of a day; `named`: parts for the legend."""
    points, _, _ = spheres_seen
    figure, axis = framed(render(view, *spheres_seen))
    mark(axis, view, points, flows)
    legend(figure, named, style.day_label(day))
    return figure


def draw(folder, path):
    day, file = results.frames(folder, "tissue")[-1]
    last = visible(file)
    style.apply()
    figure = picture(view_of(*last), last, day, results.flows(folder), last[2])
    style.save(figure, path)
    plt.close(figure)


def animate(folder, path):
    frames = results.frames(folder, "tissue")
    chosen = np.unique(np.linspace(0, len(frames) - 1, FRAMES).round().astype(int))
    last = visible(frames[-1][1])
    view, flows = view_of(*last), results.flows(folder)
    style.apply()
    images = []
    for day, file in (frames[number] for number in chosen):
        figure = picture(view, visible(file), day, flows, last[2])
        figure.canvas.draw()
        image = Image.fromarray(np.asarray(figure.canvas.buffer_rgba())[..., :3])
        plt.close(figure)
        height = round(FRAME_WIDTH * image.height / image.width)
        images.append(image.resize((FRAME_WIDTH, height), Image.LANCZOS))
    colours = images[-1].quantize(96)  # of the last day, which has all that the legend names
    images = [image.quantize(palette=colours, dither=Image.Dither.NONE) for image in images]
    times = [FRAME_TIME] * (len(images) - 1) + [LAST_TIME]
    unfinished = path.with_suffix(".partial.gif")
    images[0].save(unfinished, save_all=True, append_images=images[1:], duration=times, loop=0)
    unfinished.replace(path)
