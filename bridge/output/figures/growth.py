"""growth.png: how neointima, lumen, endothelium, cells and wall shear stress go over the days, a panel for each."""

import matplotlib.pyplot as plt
import numpy as np
import results
import style

FEW = 20  # rows up to which each is marked by a dot
COLUMNS = 3
PANEL = (3.3, 2.7)  # [in]


def known(series, name):
    return name in series and np.isfinite(series[name]).any()


def thickness(axis, series):
    axis.set_title("Neointima")
    axis.set_ylabel("thickness [µm]")
    day = series["day"]
    axis.plot(day, series["neointimaThickness_um"], color=style.ORANGE, label="mean")
    if known(series, "neointimaThicknessMax_um"):
        most = series["neointimaThicknessMax_um"]
        axis.plot(day, most, linestyle="--", color=style.ORANGE, label="largest along z")


def narrowing(axis, series):
    axis.set_title("Lumen lost to it")
    axis.set_ylabel("neointimal area fraction [%]")
    axis.plot(series["day"], 100 * series["neointimaAreaFraction"], color=style.ORANGE)


def lumen(axis, series):
    axis.set_title("Smallest lumen")
    axis.set_ylabel("area [mm²]")
    axis.plot(series["day"], series["minLumenArea_mm2"], color=style.BLACK)


def endothelium(axis, series):
    axis.set_title("Endothelium")
    axis.set_ylabel("cells at the lumen covered [%]")
    axis.plot(series["day"], 100 * series["coverage"], color=style.GREEN)
    axis.set_ylim(0, 100)


def dividing(axis, series):
    axis.set_title("Cells in cycle")
    axis.set_ylabel("number")
    axis.plot(series["day"], series["g1"] + series["sg2m"], color=style.VERMILION)


def shear(axis, series):
    axis.set_title("Flow")
    axis.set_ylabel("wall shear stress [Pa]")
    day = series["day"]
    if known(series, "wssP5_Pa"):
        band = {"color": style.SKY, "alpha": 0.35, "linewidth": 0, "label": "5 to 95 %"}
        axis.fill_between(day, series["wssP5_Pa"], series["wssP95_Pa"], **band)
    axis.plot(day, series["wssMean_Pa"], color=style.BLUE, label="mean")
    mark_solves(axis, series)


def mark_solves(axis, series):
    """A tick on the lower edge at each recorded state before which the flow was solved."""
    solved = series["day"][series["flowSolved"] > 0]
    look = {"color": style.BLACK, "linewidth": 1.0, "marker": ""}
    for day in solved:
        axis.axvline(day, ymax=0.04, **look)
    if solved.size:
        axis.plot([], [], "|", color=style.BLACK, markersize=6, markeredgewidth=1.5, label="flow solved")


PANELS = {
    "neointimaThickness_um": thickness,
    "neointimaAreaFraction": narrowing,
    "minLumenArea_mm2": lumen,
    "coverage": endothelium,
    "g1": dividing,
    "wssMean_Pa": shear,
}


def finish(axis, days):
    """All panels have the same days; a scale begins at 0, or lower where a value does, and leaves room for a legend."""
    names = axis.get_legend_handles_labels()[0]
    low, high = axis.get_ylim()
    low = min(0, low)
    axis.set_ylim(low, low + (1.25 if names else 1.08) * (high - low))
    if names:
        axis.legend(loc="upper right", ncol=3, fontsize=8, columnspacing=1, handlelength=1.4, borderaxespad=0)
    margin = 0.04 * max(np.ptp(days), 1)
    axis.set_xlim(days.min() - margin, days.max() + margin)
    axis.set_xlabel("day after deployment")


def draw(folder, path):
    if not results.has_tissue(folder):
        raise results.NothingToDraw("a lumen without tissue does not grow")
    series = results.time_series(folder)
    if len(series["day"]) < 2:
        raise results.NothingToDraw("one recorded day makes no curve")
    panels = [draw_panel for name, draw_panel in PANELS.items() if known(series, name)]
    style.apply()
    if len(series["day"]) < FEW:
        plt.rcParams.update({"lines.marker": "o", "lines.markersize": 3.5})
    rows = -(-len(panels) // COLUMNS)
    columns = -(-len(panels) // rows)
    figure, grid = plt.subplots(rows, columns, figsize=(PANEL[0] * columns, PANEL[1] * rows), squeeze=False)
    axes = grid.ravel()
    for axis, draw_panel in zip(axes, panels):
        draw_panel(axis, series)
        finish(axis, series["day"])
    for axis in axes[len(panels) :]:
        axis.remove()
    style.letter_panels(axes[: len(panels)])
    style.save(figure, path, vector=True)
    plt.close(figure)
