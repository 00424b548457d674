"""Values on the lumen's triangles as a map over the angle and the place along the vessel."""

import numpy as np

AXIAL, AROUND = 160, 180


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
