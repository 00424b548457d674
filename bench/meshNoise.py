"""How much two solutions of the flow in a ring's vessel differ on its wall, and how far two lumens are from each other."""
import numpy as np
from scipy.spatial import cKDTree

from stressQuartiles import triangles

INSIDE = (0.2e-3, 1.0e-3)  # along the vessel [m]: without its ends


def paired(a, b, field):
    """Areas of the triangles of one lumen file, and a field on them and on the nearest places of the other."""
    places, area, of_a = triangles(a, field)
    others, _, of_b = triangles(b, field)
    of_b = of_b[cKDTree(others).query(places)[1]]
    known = (places[:, 0] > INSIDE[0]) & (places[:, 0] < INSIDE[1]) & np.isfinite(of_a) & np.isfinite(of_b)
    return area[known], of_a[known], of_b[known]


def difference(a, b):
    """L2 of the difference of the stress, of the stress [%]."""
    area, of_a, of_b = paired(a, b, "WSS")
    return round(100 * np.sqrt(np.average((of_b - of_a) ** 2, weights=area) / np.average(of_a**2, weights=area)), 2)


def moved(a, b):
    """Beyond how far a hundredth of the wall has moved [um], as `coupling.lumenTolerance` has it."""
    area, of_a, of_b = paired(a, b, "neointimaThickness")
    far = np.abs(of_b - of_a)
    order = np.argsort(far)
    return round(1e6 * far[order][np.searchsorted(np.cumsum(area[order]), 0.99 * area.sum())], 1)
