"""The lumen in space on several days, small enough for a page.

A lumen along the z axis is its distance from that axis on a grid over angle and place along the vessel; what an
overhanging strut hides from the axis is not seen. A lumen from a file without tissue lies as it likes: it is a surface
of fewer triangles. Needs numpy and VTK.
"""

import base64
import zlib

import numpy as np
import results
import unrolling
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkCellDataToPointData, vtkCleanPolyData, vtkDecimatePro

AROUND = 160
SPACING = 18e-6  # along the vessel [m]
ALONG = (48, 200)  # least and most
MOST_VALUES = 330_000  # of a quantity, over all days
MOST_TRIANGLES = 24_000
LEVELS = 250  # of a stress; what is above is unknown
UNKNOWN = 255


def of(folder):
    """What the page draws the lumen from; None where the run has none."""
    if not (folder / "lumen.pvd").exists():
        return None
    frames = results.frames(folder, "lumen")
    return _surface(frames[-1]) if results.only_flow_from_file(folder) else _grid(frames, folder)


def packed(array):
    """Bytes that JavaScript unpacks."""
    return base64.b64encode(zlib.compress(np.ascontiguousarray(array).tobytes(), 9)).decode("ascii")


def planes(values):
    """Whole numbers of 16 bits, each frame less the one before, low bytes before high ones: these compress well."""
    steps = np.diff(values.astype(np.int32), axis=0, prepend=0).astype(np.uint16)
    return np.stack([steps & 0xFF, steps >> 8]).astype(np.uint8)


def levels(stress, top):
    """A stress in whole numbers up to LEVELS, which stands for `top`."""
    known = np.isfinite(stress)
    return np.where(known, np.clip(np.nan_to_num(stress) / top * LEVELS, 0, LEVELS).round(), UNKNOWN).astype(np.uint8)


def _stress(stress):
    """A stress for the page; None where none is known. What is above its top has the colour of the top."""
    known = stress[np.isfinite(stress)]
    if not known.size:
        return None
    top = float(max(np.percentile(known, 99), 1e-9))
    return {"top_Pa": top, "more": bool(known.max() > 1.01 * top), "data": packed(levels(stress, top))}


def _grid(frames, folder):
    first = results.lumen(frames[0][1])
    length = first["vertices"][:, 2].max()
    along = int(np.clip(round(length / SPACING), *ALONG))
    chosen = results.spread(frames, max(2, MOST_VALUES // (along * AROUND)) if results.has_tissue(folder) else 1)
    radius, stress, struts = (
        np.stack(maps) for maps in zip(*(_maps(results.lumen(path), length, (AROUND, along)) for _, path in chosen))
    )
    radius = np.where(np.isfinite(radius), radius, np.nanmean(radius))
    low, high = radius.min(), max(radius.max(), radius.min() + 1e-9)
    return {
        "kind": "grid",
        "around": AROUND,
        "along": along,
        "length_mm": 1e3 * length,
        "days": [float(f"{day:.6g}") for day, _ in chosen],
        "radius": {
            "low_mm": 1e3 * low,
            "high_mm": 1e3 * high,
            "data": packed(planes(np.round((radius - low) / (high - low) * 65535))),
        },
        "stress": _stress(stress),
        "struts": packed(np.packbits(struts)) if struts.any() else None,
        "grows": bool(results.has_tissue(folder) and np.ptp(radius, axis=0).max() > 1e-6),
        "resting_Pa": results.arresting_stress(folder),
    }


def _maps(lumen, length, bins):
    """Radius, stress, and whether it is a strut, of one lumen."""
    grid = unrolling.Unrolling(lumen, length, bins)
    struts = np.nan_to_num(grid.of(lumen["region"].astype(float))) > 0.5
    return grid.of(grid.radius), grid.of(lumen["WSS"]), struts


def _surface(frame):
    day, path = frame
    data = results.poly_data(path)
    onPoints = vtkCellDataToPointData()
    onPoints.SetInputData(data)
    joined = vtkCleanPolyData()
    joined.SetInputConnection(onPoints.GetOutputPort())
    fewer = vtkDecimatePro()
    fewer.SetInputConnection(joined.GetOutputPort())
    fewer.SetTargetReduction(max(0.0, 1 - MOST_TRIANGLES / max(1, data.GetNumberOfPolys())))
    fewer.PreserveTopologyOn()
    fewer.Update()
    surface = fewer.GetOutput()
    points = 1e3 * vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    stress = vtk_to_numpy(surface.GetPointData().GetArray("WSS")).astype(float)[None]
    low, high = points.min(axis=0), points.max(axis=0)
    reach = np.maximum(high - low, 1e-9)
    ends = [data.GetFieldData().GetArray(name) for name in ("inletCentre", "outletCentre")]
    return {
        "kind": "surface",
        "days": [float(f"{day:.6g}")],
        "low_mm": low.tolist(),
        "high_mm": high.tolist(),
        "points": packed(planes(np.round((points - low) / reach * 65535).T)),
        "triangles": packed(vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).astype("<u4")),
        "stress": _stress(stress),
        "ends_mm": [[1e3 * x for x in end.GetTuple(0)] for end in ends] if all(ends) else None,
        "struts": None,
        "grows": False,
        "resting_Pa": None,
    }
