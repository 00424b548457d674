"""Values on the lumen's triangles as a map over the angle and the place along the vessel."""

import numpy as np

AXIAL, AROUND = 160, 180


def unrolled(lumen, values, length):
    """Mean of the triangles' values on a grid over (theta, z); NaN where no triangle lies."""
    return Unrolling(lumen, length).of(values)


class Unrolling:
    """A grid over (theta, z), and the place of each triangle of a lumen in it; `bins`: around and along."""

    def __init__(self, lumen, length, bins=(AROUND, AXIAL)):
        self.bins = bins
        centres = lumen["vertices"][lumen["triangles"]].mean(axis=1)
        around = (np.arctan2(centres[:, 1], centres[:, 0]) + np.pi) / (2 * np.pi)
        rows, columns = (
            np.clip((share * count).astype(int), 0, count - 1)
            for share, count in zip((around, centres[:, 2] / length), bins)
        )
        self.place = rows * bins[1] + columns
        self.radius = np.hypot(centres[:, 0], centres[:, 1])

    def of(self, values):
        """Mean of the triangles' values."""
        known = np.isfinite(values)
        place, size = self.place[known], self.bins[0] * self.bins[1]
        sums = np.bincount(place, weights=values[known], minlength=size)
        counts = np.bincount(place, minlength=size)
        return fill(np.where(counts > 0, sums / np.maximum(counts, 1), np.nan).reshape(self.bins))


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
