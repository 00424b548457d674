"""section.png: the wall where new tissue is thickest, on the first and on the last day: agents as a plane cuts them."""

import anatomy
import matplotlib.pyplot as plt
import numpy as np
import results
import style
from matplotlib.collections import EllipseCollection
from matplotlib.lines import Line2D
from matplotlib.patches import Rectangle

COLOURS = [colour for _, colour in anatomy.PARTS] + [style.SKY, style.VERMILION]
NAMES = [name for name, _ in anatomy.PARTS] + ["media, synthetic", "cell growing or dividing"]
SYNTHETIC, DIVIDING = len(anatomy.PARTS), len(anatomy.PARTS) + 1
SHOWN = (anatomy.STENT, anatomy.NEOINTIMA, DIVIDING, anatomy.MEDIA, SYNTHETIC, anatomy.IEL, anatomy.EEL)
BESIDE = 12  # the stented section reaches so many radii beyond its struts
SECTORS = 72  # in which new tissue is measured
WIDE = 1.5  # an enlarged part is so much wider than high
LUMEN = 0.18  # and shows so much of its height of the lumen
LINE = {"color": style.BLACK, "linewidth": 1.1, "marker": ""}  # of the IEL
PANEL = 2.7  # height of a panel [in]


class Tissue:
    """The agents of a day, with what they are and the line of the IEL; lengths in mm."""

    def __init__(self, file):
        agents = results.agents(file)
        self.line = anatomy.iel_line(agents)
        self.part = anatomy.parts(agents, self.line)
        self.new = self.part == anatomy.NEOINTIMA
        smc = agents["kind"] == results.KINDS["smc"]
        self.colour = np.where((self.part == anatomy.MEDIA) & (agents["synthetic"] > 0), SYNTHETIC, self.part)
        self.colour[smc & (agents["state"] > 0)] = DIVIDING
        self.radius = 1e3 * agents["radius"]
        self.x, self.y, self.z = 1e3 * agents["position"].T

    def turned(self, angle):
        """The agents' places across the vessel, turned so that an angle points upwards."""
        return self.x * np.sin(angle) - self.y * np.cos(angle), self.x * np.cos(angle) + self.y * np.sin(angle)

    def iel_at(self, angle, z):
        """The distance of the IEL's line from the axis."""
        return 1e3 * self.line.at(angle, 1e-3 * np.asarray(z))


class Cut:
    """Where the wall is cut: across at `z`, along at `angle`; where new tissue is thickest in the stented section."""

    def __init__(self, tissue):
        struts = tissue.z[tissue.part == anatomy.STENT]
        chosen = tissue.new
        if struts.size:
            beside = BESIDE * tissue.radius.mean()
            chosen = chosen & (tissue.z >= struts.min() - beside) & (tissue.z <= struts.max() + beside)
        if not chosen.any():
            self.z, self.angle = plane_of_struts(tissue.z, struts), 0.0
            return
        volume = tissue.radius[chosen] ** 3
        angle = np.arctan2(tissue.y, tissue.x)[chosen]
        self.z = peak(tissue.z[chosen], volume, 4 * tissue.radius.mean())
        near = np.abs(tissue.z[chosen] - self.z) < 4 * tissue.radius.mean()
        self.angle = peak_around(angle[near], volume[near])


def plane_of_struts(z, struts):
    """The place of the strut agent nearest to the middle of the vessel; the middle where there is no strut."""
    middle = 0.5 * (z.min() + z.max())
    return struts[np.argmin(np.abs(struts - middle))] if struts.size else middle


def peak(place, weight, width):
    """Where the weight in a window of that width is largest."""
    edges = np.arange(place.min(), place.max() + width / 4, width / 4)
    if len(edges) < 2:
        return place.mean()
    sums = np.convolve(np.histogram(place, edges, weights=weight)[0], np.ones(4), mode="same")
    best = np.argmax(sums)
    return 0.5 * (edges[best] + edges[best + 1])


def peak_around(angle, weight):
    """The angle about which the weight in a window of a few sectors is largest."""
    counts, edges = np.histogram(angle, SECTORS, (-np.pi, np.pi), weights=weight)
    sums = sum(np.roll(counts, shift) for shift in range(-3, 4))
    best = np.argmax(sums)
    return 0.5 * (edges[best] + edges[best + 1])


def discs(axis, tissue, across, up, depth):
    """Draws the discs in which the plane at `depth` = 0 cuts the agents, as far as the axis shows them.

    Returns which colours these have.
    """
    cut = np.abs(depth) < tissue.radius
    for places, limits in ((across, axis.get_xlim()), (up, axis.get_ylim())):
        cut &= (places > limits[0] - tissue.radius) & (places < limits[1] + tissue.radius)
    half = np.sqrt(tissue.radius[cut] ** 2 - depth[cut] ** 2)
    order = np.argsort(half)
    sizes = 2 * half[order]
    axis.add_collection(
        EllipseCollection(
            sizes,
            sizes,
            np.zeros_like(sizes),
            units="xy",
            offsets=np.column_stack([across[cut], up[cut]])[order],
            transOffset=axis.transData,
            facecolors=np.array(COLOURS)[tissue.colour[cut][order]],
            edgecolors="white",
            linewidths=0.15,
        )
    )
    return set(tissue.colour[cut])


def line_across(axis, tissue, cut):
    """The line of the IEL in a section across."""
    if tissue.line is not None:
        turn = np.linspace(-np.pi, np.pi, 1441)
        radius = tissue.iel_at(turn + cut.angle, np.full_like(turn, cut.z))
        axis.plot(-radius * np.sin(turn), radius * np.cos(turn), **LINE)


def line_along(axis, tissue, cut):
    """The line of the IEL in a section along the vessel."""
    if tissue.line is not None:
        z = np.linspace(*axis.get_xlim(), 400)
        axis.plot(z, tissue.iel_at(np.full_like(z, cut.angle), z), **LINE)


def whole(axis, tissue, cut, box):
    """The whole cross-section, with the part that is enlarged."""
    reach = 1.03 * np.hypot(tissue.x, tissue.y).max()
    axis.set(xlim=(-reach, reach), ylim=(-reach, reach))
    found = discs(axis, tissue, *tissue.turned(cut.angle), tissue.z - cut.z)
    line_across(axis, tissue, cut)
    axis.add_patch(Rectangle((box[0], box[2]), box[1] - box[0], box[3] - box[2], fill=False, linewidth=1.2))
    return found


def across(axis, tissue, cut, box):
    """The part of the cross-section about the cut's angle."""
    axis.set(xlim=box[:2], ylim=box[2:])
    found = discs(axis, tissue, *tissue.turned(cut.angle), tissue.z - cut.z)
    line_across(axis, tissue, cut)
    return found


def along(axis, tissue, cut, box):
    """The part of the section along the vessel about the cut's place."""
    width = box[1] - box[0]
    start = max(tissue.z.min(), min(cut.z - width / 2, tissue.z.max() - width))
    axis.set(xlim=(start, start + width), ylim=box[2:])
    sideways, outwards = tissue.turned(cut.angle)
    found = discs(axis, tissue, tissue.z, outwards, sideways)
    line_along(axis, tissue, cut)
    return found


def enlarged_box(tissues, cut):
    """Left, right, lower and upper limit of the enlarged part: the wall about the cut, on all days, and some lumen."""
    near = 6 * tissues[0].radius.mean()
    low, high = np.inf, -np.inf
    for tissue in tissues:
        sideways, outwards = tissue.turned(cut.angle)
        wall = (np.abs(sideways) < near) & (np.abs(tissue.z - cut.z) < near) & (outwards > 0)
        if wall.any():
            low, high = min(low, outwards[wall].min()), max(high, outwards[wall].max())
    height = (high - low + near / 2) / (1 - LUMEN)
    top = high + near / 4
    return -WIDE * height / 2, WIDE * height / 2, top - height, top


def legend(figure, found, line):
    """Names the colours that were found, and the line where there is one, below the panels."""
    handles = [
        Line2D([], [], marker="o", markersize=7, linestyle="", color=COLOURS[number], label=NAMES[number])
        for number in SHOWN
        if number in found
    ]
    if line:
        handles.append(Line2D([], [], label="line of the IEL", **LINE))
    figure.legend(handles=handles, loc="lower center", ncol=4, handletextpad=0.4, bbox_to_anchor=(0.5, 0))


def draw_day(axes, day, tissue, cut, box):
    """The three panels of a day; returns which colours they have."""
    found = set()
    for axis, part in zip(axes, (whole, across, along)):
        found |= part(axis, tissue, cut, box)
        axis.set_aspect("equal")
        axis.grid(False)
        axis.set(xticks=[], yticks=[])
        axis.spines[:].set_visible(axis is not axes[0])
    ring, enlarged, sideways = axes
    style.scale_bar(ring, 0.3 * np.ptp(ring.get_xlim()), (0.5, 0.4))
    ring.annotate("lumen", (0.5, 0.55), xycoords="axes fraction", ha="center")
    for axis in (enlarged, sideways):
        style.scale_bar(axis, 0.3 * np.ptp(axis.get_xlim()))
    ring.set_title(f"{style.day_label(day)}, across at z = {cut.z:.3g} mm")
    enlarged.set_title("enlarged")
    sideways.set_title("along the vessel, at the middle of the frame")
    return found


def draw(folder, path):
    entries = results.spread(results.frames(folder, "tissue"), 2)
    tissues = [Tissue(file) for _, file in entries]
    cut = Cut(tissues[-1])
    box = enlarged_box(tissues, cut)
    style.apply()
    figure, grid = plt.subplots(
        len(entries),
        3,
        figsize=((1 + 2 * WIDE) * PANEL + 0.5, len(entries) * (PANEL + 0.3) + 0.6),
        squeeze=False,
        gridspec_kw={"width_ratios": (1, WIDE, WIDE)},
    )
    figure.get_layout_engine().set(rect=(0, 0.1, 1, 0.9))
    found = set()
    for axes, (day, _), tissue in zip(grid, entries, tissues):
        found |= draw_day(axes, day, tissue, cut, box)
    style.letter_panels(grid.ravel())
    legend(figure, found, any(tissue.line is not None for tissue in tissues))
    style.save(figure, path, vector=True)
    plt.close(figure)
