"""lumen.png: the lumen unrolled, its narrowing and its wall shear stress on several days that have a flow."""

import matplotlib.pyplot as plt
import numpy as np
import results
import style
from matplotlib.lines import Line2D
from unrolling import limits, radius_of_triangles, unrolled

COLUMNS = 5
PANEL = (2.1, 2.7)  # [in]
NOTHING = 0.5  # narrowing below this is none [um]
AT_REST = style.VERMILION


class Row:
    """A row of maps, one for each day, in one scale of colours, with lines drawn in each."""

    def __init__(self, maps, label, colours, ends, struts):
        self.maps, self.label, self.colours, self.ends, self.struts = maps, label, colours, ends, struts

    def draw(self, figure, axes, days, extent):
        """Draws the maps and their scale of colours."""
        low, high = self.ends
        for axis, grid, day in zip(axes, self.maps, days):
            axis.set_facecolor(style.LIGHT)
            axis.grid(False)
            look = {"cmap": self.colours, "vmin": low, "vmax": high, "extent": extent}
            image = axis.imshow(grid, origin="lower", aspect="auto", **look)
            axis.set_yticks([-180, -90, 0, 90, 180])
            axis.set_title(style.day_label(day))
        axes[0].set_ylabel("angle θ [°]")
        figure.colorbar(image, ax=list(axes), label=self.label, extend="both", pad=0.01)


def narrowing_row(lumens, first, length):
    """The decrease of the radius since the first day; None where there is none."""
    before = unrolled(first, 1e6 * radius_of_triangles(first), length)
    maps = [before - unrolled(lumen, 1e6 * radius_of_triangles(lumen), length) for lumen in lumens]
    bottom, top = limits(maps)
    if max(-bottom, top) < NOTHING:
        return None
    return Row(maps, "decrease of lumen radius [µm]", style.THICKNESS_MAP, (min(bottom, 0), max(top, 1)), style.BLACK)


def shear_row(lumens, length):
    """The wall shear stress; None where no flow was solved."""
    maps = [unrolled(lumen, lumen["WSS"], length) for lumen in lumens]
    if not any(np.isfinite(grid).any() for grid in maps):
        return None
    return Row(maps, "wall shear stress [Pa]", style.WSS_MAP, (0, limits(maps)[1]), "white")


def outline(axis, grid, level, extent, colour):
    """The line along which a map has a value; returns whether it has one."""
    known = grid[np.isfinite(grid)]
    if known.size == 0 or not known.min() < level < known.max():
        return False
    axis.contour(grid, levels=[level], origin="lower", extent=extent, colors=colour, linewidths=0.9)
    return True


def mark_struts(rows, grid, struts, extent):
    """Outlines the struts in every map; returns the line's name for the legend."""
    found = [outline(axis, struts, 0.5, extent, row.struts) for row, axes in zip(rows, grid) for axis in axes]
    return {"struts (white below)": style.BLACK} if any(found) and len(rows) > 1 else {}


def mark_stress(axes, row, stress, extent):
    """Draws the line of the stress that decides in every map; returns its name for the legend."""
    found = [outline(axis, grid, stress, extent, AT_REST) for axis, grid in zip(axes, row.maps)]
    return {f"{stress:.3g} Pa: above it, cells beneath endothelium rest": AT_REST} if any(found) else {}


def legend(figure, lines):
    """Names the lines, below the panels."""
    handles = [Line2D([], [], color=colour, linewidth=1.4, label=name) for name, colour in lines.items()]
    if handles:
        figure.get_layout_engine().set(rect=(0, 0.06, 1, 0.94))
        figure.legend(handles=handles, loc="lower center", ncol=len(handles))


def draw(folder, path):
    if results.only_flow_from_file(folder):
        raise results.NothingToDraw("a lumen from a file has no axis to unroll it about")
    frames = results.frames(folder, "lumen")
    shown = results.frames_with_flow(frames) or frames[1:] or frames
    chosen = results.spread(shown, COLUMNS if results.has_tissue(folder) else 1)
    days, lumens = [day for day, _ in chosen], [results.lumen(file) for _, file in chosen]
    first = results.lumen(frames[0][1])
    length = max(lumen["vertices"][:, 2].max() for lumen in lumens)
    shear = shear_row(lumens, length)
    rows = [row for row in (narrowing_row(lumens, first, length), shear) if row]
    if not rows:
        raise results.NothingToDraw("the lumen has not changed, and no flow was solved")

    style.apply()
    size = (PANEL[0] * len(days) + 1.5, PANEL[1] * len(rows) + 0.4)
    figure, grid = plt.subplots(len(rows), len(days), figsize=size, sharex=True, sharey=True, squeeze=False)
    extent = (0, length * 1e3, -180, 180)
    for row, axes in zip(rows, grid):
        row.draw(figure, axes, days, extent)
    lines = mark_struts(rows, grid, unrolled(first, first["region"], length), extent)
    stress = results.arresting_stress(folder)
    if shear and stress is not None:
        lines.update(mark_stress(grid[-1], shear, stress, extent))
    for axis in grid[-1]:
        axis.set_xlabel("z [mm]")
    style.letter_panels(grid.ravel())
    if shear:
        style.flow_arrow(grid[0, -1], (0.66, 1.045), 0.34)
    legend(figure, lines)
    style.save(figure, path, vector=True)
    plt.close(figure)
