"""growth.png: how neointima, lumen, coverage and wall shear stress go over the days."""

import matplotlib.pyplot as plt
import numpy as np
import results
import style


FEW = 20  # rows up to which each is marked by a dot


def known(series, name):
    return name in series and np.isfinite(series[name]).any()


def mark_solves(axes, series):
    """A tick on the lower edge at each recorded state before which the flow was solved anew."""
    solved = series["day"][series["flowSolved"] > 0]
    for axis in axes:
        for day in solved:
            axis.axvline(day, ymax=0.03, color=style.VERMILION, linewidth=1.2, marker="")
        if axis is axes[-1] and solved.size:
            axis.plot([], [], "|", color=style.VERMILION, markersize=6, markeredgewidth=1.5, label="flow solved")


def thickness(axis, series):
    axis.set_ylabel("neointimal thickness [µm]")
    axis.set_title("Neointima")
    day = series["day"]
    axis.plot(day, series["neointimaThickness_um"], color=style.BLUE, label="mean")
    if known(series, "neointimaThicknessMax_um"):
        axis.plot(day, series["neointimaThicknessMax_um"], "--", color=style.BLUE, label="largest along z")


def narrowing(axis, series):
    axis.set_title("Lumen")
    axis.set_ylabel("neointimal area fraction [%]")
    axis.plot(series["day"], 100 * series["neointimaAreaFraction"], color=style.VERMILION, label="area fraction")
    if known(series, "minLumenArea_mm2"):
        right = axis.twinx()
        right.grid(False)
        right.spines["right"].set_visible(True)
        right.plot(series["day"], series["minLumenArea_mm2"], ":", color=style.BLACK)
        axis.plot([], [], ":", color=style.BLACK, label="smallest lumen (right)")
        right.set_ylabel("smallest lumen area [mm²]")
        right.set_ylim(0, 1.05 * np.nanmax(series["minLumenArea_mm2"]))


def cells(axis, series):
    axis.set_title("Cells")
    day = series["day"]
    if known(series, "coverage"):
        axis.plot(day, 100 * series["coverage"], color=style.GREEN, label="endothelial coverage")
    axis.set_ylabel("endothelial coverage [%]")
    axis.set_ylim(-3, 103)
    if known(series, "g1"):
        right = axis.twinx()
        right.grid(False)
        right.spines["right"].set_visible(True)
        right.plot(day, series["g1"] + series["sg2m"], color=style.PURPLE)
        right.set_ylabel("cells in cycle")
        right.set_ylim(bottom=0)
        axis.plot([], [], color=style.PURPLE, label="cells in cycle (right)")


def shear(axis, series):
    axis.set_title("Flow")
    axis.set_ylabel("wall shear stress [Pa]")
    day = series["day"]
    if not known(series, "wssMean_Pa"):
        axis.text(0.5, 0.5, "no flow was solved", transform=axis.transAxes, ha="center", color=style.GREY)
        return
    if known(series, "wssP5_Pa"):
        axis.fill_between(
            day, series["wssP5_Pa"], series["wssP95_Pa"], color=style.SKY, alpha=0.35, linewidth=0, label="5 to 95 %"
        )
    axis.plot(day, series["wssMean_Pa"], color=style.BLUE, label="mean")
    axis.set_ylim(bottom=0)


def draw(folder, path):
    if results.only_flow_from_file(folder):
        raise results.NothingToDraw("a lumen from a file without tissue does not grow")
    style.apply()
    series = results.time_series(folder)
    if len(series["day"]) < FEW:
        plt.rcParams["lines.marker"] = "o"
        plt.rcParams["lines.markersize"] = 3.5
    figure, grid = plt.subplots(2, 2, figsize=(9.5, 6.2), sharex=True)
    axes = grid.ravel()
    for axis, part in zip(axes, (thickness, narrowing, cells, shear)):
        part(axis, series)
    mark_solves(axes, series)
    for axis in axes:
        if axis.get_legend_handles_labels()[0]:
            axis.legend(loc="lower right", bbox_to_anchor=(1.0, 0.985), ncol=3, fontsize=8, columnspacing=1.2)
    for axis in axes[:2]:
        axis.set_ylim(bottom=min(0, axis.get_ylim()[0]))
    for axis in grid[1]:
        axis.set_xlabel("day after deployment")
    style.save(figure, path)
    plt.close(figure)
