"""section.png: the wall cut open on the first and on the last day, agents as they are cut."""

import matplotlib.pyplot as plt
import numpy as np
import results
import style
from matplotlib.collections import EllipseCollection
from matplotlib.lines import Line2D

# Later entries win where an agent is several things.
CLASSES = (
    ("SMC, at rest", "#C9D7E3"),
    ("SMC, synthetic", style.SKY),
    ("SMC, in cycle", style.VERMILION),
    ("neointima, at rest", style.ORANGE),
    ("IEL", style.BLUE),
    ("EEL", style.GREEN),
    ("strut", "#303030"),
)


def classes(agents):
    """The index into CLASSES of each agent."""
    kind = agents["kind"]
    found = np.zeros(len(kind), dtype=int)
    smc = kind == results.KINDS["smc"]
    found[smc & (agents["synthetic"] > 0)] = 1
    found[smc & (agents["daughter"] > 0)] = 3
    found[smc & (agents["state"] > 0)] = 2
    for k, name in ((4, "iel"), (5, "eel"), (6, "strut")):
        found[kind == results.KINDS[name]] = k
    return found


def circles(axis, across, along, depth, radius, colour_class):
    """Draws the discs in which a plane at `depth` = 0 cuts spheres; lengths in m, drawn in mm."""
    cut = np.abs(depth) < radius
    disc = np.sqrt(radius[cut] ** 2 - depth[cut] ** 2)
    order = np.argsort(disc)
    diameters = 2e3 * disc[order]
    colours = np.array([colour for _, colour in CLASSES])[colour_class[cut][order]]
    axis.add_collection(
        EllipseCollection(
            diameters,
            diameters,
            np.zeros_like(diameters),
            units="xy",
            offsets=1e3 * np.column_stack([across[cut], along[cut]])[order],
            transOffset=axis.transData,
            facecolors=colours,
            edgecolors="white",
            linewidths=0.15,
        )
    )


def strut_plane(agents):
    """z of a cross-section through a strut: of the strut agents nearest to the middle of the vessel [m]."""
    z = agents["position"][:, 2]
    middle = 0.5 * (z.min() + z.max())
    struts = z[agents["kind"] == results.KINDS["strut"]]
    return struts[np.argmin(np.abs(struts - middle))] if struts.size else middle


def longitudinal(axis, agents, title):
    x, y, z = agents["position"].T
    near = x > 0
    circles(axis, z[near], x[near], y[near], agents["radius"][near], classes(agents)[near])
    axis.set_xlim(0, 1e3 * z.max())
    axis.set_title(title)
    axis.set_ylabel("distance from axis [mm]")
    axis.set_xlabel("z [mm]")


def across(axis, agents, plane, title):
    x, y, z = agents["position"].T
    circles(axis, x, y, z - plane, agents["radius"], classes(agents))
    axis.set_title(title)
    axis.set_xlabel("x [mm]")
    axis.set_ylabel("y [mm]")


def legend(figure, axes):
    """Names the colours in the row of axes set aside for it."""
    for axis in axes[1:]:
        axis.remove()
    whole = figure.add_subplot(axes[0].get_gridspec()[2, :])
    axes[0].remove()
    whole.set_axis_off()
    handles = [Line2D([], [], marker="o", linestyle="", color=colour, label=name) for name, colour in CLASSES]
    whole.legend(handles=handles, loc="center", ncol=len(handles), handletextpad=0.2)


def draw(folder, path):
    style.apply()
    entries = results.spread(results.frames(folder, "tissue"), 2)
    tissues = [(day, results.agents(file)) for day, file in entries]
    plane = strut_plane(tissues[0][1])
    reach = [np.hypot(a["position"][:, 0], a["position"][:, 1]) for _, a in tissues]
    inner, outer = 1e3 * min(r.min() for r in reach), 1e3 * max(r.max() for r in reach)

    width = 11.0
    along = (outer - inner + 0.1) / (1e3 * tissues[0][1]["position"][:, 2].max()) * 0.5 * width
    columns = len(tissues)
    figure, grid = plt.subplots(
        3,
        columns,
        figsize=(0.5 * width * columns, along + 0.5 * width + 0.9),
        squeeze=False,
        gridspec_kw={"height_ratios": (along, 0.45 * width, 0.25)},
    )
    for (day, agents), (top, bottom) in zip(tissues, grid[:2].T):
        longitudinal(top, agents, f"{style.day_label(day)}, along the vessel at θ = 0")
        top.set_ylim(max(0, inner - 0.06), outer + 0.04)
        across(bottom, agents, plane, f"{style.day_label(day)}, across at z = {1e3 * plane:.3g} mm")
        bottom.set_xlim(-outer - 0.04, outer + 0.04)
        bottom.set_ylim(-outer - 0.04, outer + 0.04)
        for axis in (top, bottom):
            axis.set_aspect("equal")
            axis.grid(False)
    legend(figure, grid[2])
    style.save(figure, path)
    plt.close(figure)
