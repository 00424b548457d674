"""How much two solutions of the flow in a ring's vessel differ on its wall, and how far two lumens are from each other."""
import numpy as np

from lumenTriangles import triangles

INSIDE = (0.2e-3, 1.0e-3)  # along the vessel [m]: without its ends
PATCH = 30e-6  # as wide as a cell: a cell takes the mean stress of the faces that are nearest to it
LUMEN_RADIUS = 0.9e-3
WALL = 0  # of the array `region`


def patches(file, field):
    """Means of a field over the wall between the struts, and areas [m^2], by patch along and around the vessel."""
    centres, area, values, region = triangles(file, field, "region")
    x, y, z = centres.T
    known = (z > INSIDE[0]) & (z < INSIDE[1]) & np.isfinite(values) & (region == WALL)
    around = int(2 * np.pi * LUMEN_RADIUS / PATCH)
    patch = (z // PATCH).astype(int) * around + ((np.arctan2(y, x) / (2 * np.pi) + 0.5) * around).astype(int) % around
    most = int(INSIDE[1] / PATCH + 1) * around
    areas = np.bincount(patch[known], area[known], most)
    sums = np.bincount(patch[known], area[known] * values[known], most)
    return sums / np.where(areas > 0, areas, np.nan), areas


def paired(a, b, field):
    """Areas of the patches that both files have, and the field on them in either."""
    of_a, area = patches(a, field)
    of_b, _ = patches(b, field)
    known = np.isfinite(of_a) & np.isfinite(of_b)
    return area[known], of_a[known], of_b[known]


def difference(a, b):
    """L2 of the difference of the stress, and the difference of its mean, of the stress [%]."""
    area, of_a, of_b = paired(a, b, "WSS")
    norm, mean = np.sqrt(np.average(of_a**2, weights=area)), np.average(of_a, weights=area)
    return (round(100 * np.sqrt(np.average((of_b - of_a) ** 2, weights=area)) / norm, 2),
            round(100 * (np.average(of_b, weights=area) / mean - 1), 2))


def moved(a, b):
    """Beyond how far a hundredth of the wall has moved [um], as `coupling.lumenTolerance` has it."""
    area, of_a, of_b = paired(a, b, "neointimaThickness")
    far = np.abs(of_b - of_a)
    order = np.argsort(far)
    return round(1e6 * far[order][np.searchsorted(np.cumsum(area[order]), 0.99 * area.sum())], 1)
