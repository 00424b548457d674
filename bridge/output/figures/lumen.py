"""lumen.png: the lumen unrolled, its narrowing and its wall shear stress on several days."""

import matplotlib.pyplot as plt
import numpy as np
import results
import style

COLUMNS = 5
AXIAL, AROUND = 120, 180


def unrolled(lumen, values, length):
    """Mean of the triangles' values on a grid over (theta, z); NaN where no triangle lies."""
    centres = lumen["vertices"][lumen["triangles"]].mean(axis=1)
    theta = np.arctan2(centres[:, 1], centres[:, 0])
    known = np.isfinite(values)
    box = [[-np.pi, np.pi], [0, length]]
    place = (theta[known], centres[known, 2])
    sums = np.histogram2d(*place, bins=(AROUND, AXIAL), range=box, weights=values[known])[0]
    counts = np.histogram2d(*place, bins=(AROUND, AXIAL), range=box)[0]
    return fill(np.where(counts > 0, sums / np.maximum(counts, 1), np.nan))


def fill(grid):
    """Takes empty places from their neighbours, a few times over: triangles are larger than places here and there."""
    for _ in range(4):
        empty = np.isnan(grid)
        if not empty.any() or empty.all():
            break
        padded = np.pad(grid, ((1, 1), (0, 0)), mode="wrap")
        padded = np.pad(padded, ((0, 0), (1, 1)), constant_values=np.nan)
        around = np.stack([padded[:-2, 1:-1], padded[2:, 1:-1], padded[1:-1, :-2], padded[1:-1, 2:]])
        count = np.isfinite(around).sum(axis=0)
        mean = np.nansum(around, axis=0) / np.maximum(count, 1)
        grid = np.where(empty & (count > 0), mean, grid)
    return grid


def radius_of_triangles(lumen):
    centres = lumen["vertices"][lumen["triangles"]].mean(axis=1)
    return np.hypot(centres[:, 0], centres[:, 1])


def limits(maps, low=0.2, high=99.8):
    """Percentiles over all maps, so that a few odd faces do not wash the colours out; (0, 1) where all are empty."""
    values = np.concatenate([grid[np.isfinite(grid)] for grid in maps])
    if values.size == 0:
        return 0.0, 1.0
    bottom, top = np.percentile(values, [low, high])
    return bottom, top if top > bottom else bottom + 1e-12


def row_of_maps(figure, axes, maps, days, length, colours, label, ends):
    low, high = ends
    for axis, grid, day in zip(axes, maps, days):
        axis.set_facecolor(style.LIGHT)
        axis.grid(False)
        image = axis.imshow(
            grid, origin="lower", aspect="auto", cmap=colours, vmin=low, vmax=high, extent=(0, length * 1e3, -180, 180)
        )
        axis.set_yticks([-180, -90, 0, 90, 180])
        axis.set_title(style.day_label(day))
        if not np.isfinite(grid).any():
            axis.text(0.5, 0.5, "not solved yet", transform=axis.transAxes, ha="center", color=style.BLACK)
    figure.colorbar(image, ax=axes, label=label, extend="both", pad=0.01)


def draw(folder, path):
    if results.only_flow_from_file(folder):
        raise results.NothingToDraw("a lumen from a file has no axis to unroll it about")
    style.apply()
    entries = results.spread(results.frames(folder, "lumen"), COLUMNS)
    days = [day for day, _ in entries]
    lumens = [results.lumen(file) for _, file in entries]
    length = max(lumen["vertices"][:, 2].max() for lumen in lumens)
    radii = [unrolled(lumen, 1e6 * radius_of_triangles(lumen), length) for lumen in lumens]
    narrowing = [radii[0] - radius for radius in radii]
    shear = [unrolled(lumen, lumen["WSS"], length) for lumen in lumens]

    figure, grid = plt.subplots(
        2, len(entries), figsize=(2.1 * len(entries) + 1.5, 5.6), sharex=True, sharey=True, squeeze=False
    )
    bottom, top = limits(narrowing)
    row_of_maps(
        figure,
        grid[0],
        narrowing,
        days,
        length,
        style.THICKNESS_MAP,
        f"decrease of lumen radius\nsince {style.day_label(days[0])} [µm]",
        (min(bottom, 0), max(top, 1)),
    )
    row_of_maps(figure, grid[1], shear, days, length, style.WSS_MAP, "wall shear stress [Pa]", (0, limits(shear)[1]))
    for axis in grid[1]:
        axis.set_xlabel("z [mm]")
    for axis in grid[:, 0]:
        axis.set_ylabel("angle θ [°]")
    style.save(figure, path)
    plt.close(figure)
