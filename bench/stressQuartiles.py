"""Neointimal thickness by the wall shear stress after stenting, as Sanmartin et al. (2006) have it."""
import numpy as np
from scipy.spatial import cKDTree

from lumenTriangles import triangles


def unrolled(centres):
    """Places along [m] and around the vessel, the latter as at a radius of 1 mm."""
    x, y, z = centres.T
    return np.column_stack((z, 1e-3 * np.arctan2(y, x)))


def quartiles(stressed, grown, low, high):
    """Mean stress [Pa] in one lumen file and thickness [um] in another, in each quarter of the area between two places
    [mm] along the vessel, by the stress; and the correlation of both."""
    centres, area, stress = triangles(stressed, "WSS")
    grownCentres, _, thickness = triangles(grown, "neointimaThickness")
    places = unrolled(centres)
    thickness = 1e6 * thickness[cKDTree(unrolled(grownCentres)).query(places)[1]]
    inside = (places[:, 0] > 1e-3 * low) & (places[:, 0] < 1e-3 * high) & np.isfinite(stress) & np.isfinite(thickness)
    area, stress, thickness = area[inside], stress[inside], thickness[inside]

    order = np.argsort(stress)
    quarter = np.empty(len(order), dtype=int)
    quarter[order] = np.minimum(4 * np.cumsum(area[order]) / area.sum(), 3).astype(int)
    of_quarters = [(np.average(stress[quarter == n], weights=area[quarter == n]),
                    np.average(thickness[quarter == n], weights=area[quarter == n])) for n in range(4)]
    return of_quarters, np.corrcoef(stress, thickness)[0, 1]
