"""compareMaps.png and compareScatter.png: the wall shear stress of two flow backends in one lumen."""

import json

import matplotlib.pyplot as plt
import numpy as np
import results
import style
from unrolling import unrolled
from vtkmodules.util.numpy_support import vtk_to_numpy

PARTS = (
    ("smoothWall", "smooth wall", style.BLUE),
    ("betweenStruts", "near struts", style.ORANGE),
    ("strut", "struts", style.VERMILION),
    ("ends", "ends", style.GREY),
)
MOST_POINTS = 20000
DIFFERENCE_MAP = "RdBu_r"


def read(folder):
    path = folder / "compare.vtp"
    if not path.exists():
        raise results.NothingToDraw(f"there is no {path}")
    with open(folder / "compare.json", encoding="utf-8") as file:
        numbers = json.load(file)
    data = results.poly_data(path)
    cells = data.GetCellData()
    motion = numbers["alongZ"]
    vertices = vtk_to_numpy(data.GetPoints().GetData()).astype(float) @ np.transpose(motion["rotation"])
    vertices += 1e-3 * np.array(motion["translation_mm"])
    surface = {
        "vertices": vertices,
        "triangles": vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3),
        "part": vtk_to_numpy(cells.GetArray("part")),
    }
    names = [numbers["reference"]] + [name for name in ("foam", "lbm") if name != numbers["reference"]]
    for name in names:
        surface[name] = vtk_to_numpy(cells.GetArray(f"WSS_{name}")).astype(float)
    return numbers, names, surface


def draw_maps(folder, path):
    """The lumen unrolled: either backend's stress, and the difference over the reference's mean on the wall."""
    numbers, (first, second), surface = read(folder)
    if numbers["bent"]:
        raise results.NothingToDraw("a bent lumen is not unrolled")
    style.apply()
    used = surface["vertices"][np.unique(surface["triangles"])]
    start, length = used[:, 2].min(), np.ptp(used[:, 2])
    moved = dict(surface, vertices=surface["vertices"] - [0, 0, start])
    maps = [unrolled(moved, surface[name], length) for name in (first, second)]
    figure, axes = plt.subplots(3, 1, figsize=(7.5, 8), sharex=True)
    top = np.nanpercentile(np.concatenate([m.ravel() for m in maps]), 99.5)
    extent = (1e3 * start, 1e3 * (start + length), -180, 180)
    for axis, values, name in zip(axes, maps, (first, second)):
        image = axis.imshow(
            values, origin="lower", aspect="auto", cmap=style.WSS_MAP, vmin=0, vmax=top, extent=extent
        )
        axis.set_title(f"{name}, {style.day_label(numbers['day'])}")
    figure.colorbar(image, ax=axes[:2], label="wall shear stress [Pa]", extend="max", pad=0.01)
    scale = numbers["wss"]["wall"].get(f"{first}Mean_Pa") or np.nanmean(maps[0])
    difference = 100 * (maps[1] - maps[0]) / scale
    reach = max(np.nanpercentile(np.abs(difference), 98), 1e-3)
    image = axes[2].imshow(
        difference, origin="lower", aspect="auto", cmap=DIFFERENCE_MAP, vmin=-reach, vmax=reach, extent=extent
    )
    axes[2].set_title(f"{second} − {first}")
    figure.colorbar(image, ax=axes[2], label=f"difference\n[% of {first}'s mean on the wall]", extend="both", pad=0.01)
    axes[2].set_xlabel("z [mm]")
    for axis in axes:
        axis.grid(False)
        axis.set_ylabel("angle θ [°]")
        axis.set_yticks([-180, -90, 0, 90, 180])
    style.letter_panels(axes)
    style.save(figure, path)
    plt.close(figure)


def draw_scatter(folder, path):
    """Stress against stress, and Bland and Altman's picture: difference against mean, with the limits of agreement."""
    numbers, (first, second), surface = read(folder)
    style.apply()
    a, b = surface[first], surface[second]
    known = np.isfinite(a) & np.isfinite(b)
    step = max(1, known.sum() // MOST_POINTS)
    figure, (left, right) = plt.subplots(1, 2, figsize=(9.5, 4.4))
    for number, (key, label, colour) in enumerate(PARTS):
        chosen = np.flatnonzero(known & (surface["part"] == number))[::step]
        if chosen.size == 0:
            continue
        look = {"s": 4, "color": colour, "alpha": 0.4, "linewidths": 0, "label": label, "rasterized": True}
        left.scatter(a[chosen], b[chosen], **look)
        right.scatter((a[chosen] + b[chosen]) / 2, b[chosen] - a[chosen], **look)
    top = np.percentile(np.concatenate([a[known], b[known]]), 99.8) * 1.05
    left.plot([0, top], [0, top], color=style.BLACK, linewidth=0.8)
    left.set(
        xlim=(0, top), ylim=(0, top), xlabel=f"{first}: wall shear stress [Pa]", ylabel=f"{second}: wall shear stress [Pa]"
    )
    left.set_aspect("equal")
    legend = left.legend(markerscale=3, loc="upper left")
    for handle in legend.legend_handles if hasattr(legend, "legend_handles") else legend.legendHandles:
        handle.set_alpha(1)
    wall = numbers["wss"]["wall"]
    if wall.get("count"):
        low, high = wall["limitsOfAgreement_Pa"]
        for value, text in ((wall["bias_Pa"], "bias"), (low, "−1.96 s"), (high, "+1.96 s")):
            right.axhline(value, color=style.BLACK, linewidth=0.8, linestyle="-" if text == "bias" else "--")
            right.annotate(f"{text}: {value:.3g} Pa", (0.01, value), xycoords=("axes fraction", "data"), va="bottom")
    spread = np.percentile(np.abs((b - a)[known]), 99.5)
    right.set(xlim=(0, top), ylim=(-1.3 * spread, 1.3 * spread))
    right.set(xlabel="mean of both [Pa]", ylabel=f"{second} − {first} [Pa]", title="lines: wall, ends left out")
    style.letter_panels((left, right))
    style.save(figure, path)
    plt.close(figure)
