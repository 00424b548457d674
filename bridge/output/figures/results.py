"""Reads a results folder into numpy arrays."""

import bisect
import csv
import tomllib
import xml.etree.ElementTree as ElementTree

import numpy as np
from nothing_to_draw import NothingToDraw
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

KINDS = {"smc": 0, "iel": 1, "eel": 2, "strut": 3}


def only_flow_from_file(folder):
    """Whether the run is of a lumen from a file without tissue: it does not grow, and lies as it likes."""
    path = folder / "scene.toml"
    if not path.exists():
        return False
    scene = tomllib.loads(path.read_text(encoding="utf-8"))
    return bool(scene.get("vessel", {}).get("lumenSurface")) and "mechanics" not in scene


def has_tissue(folder):
    """Whether the run has agents: without, a lumen does not change."""
    return (folder / "tissue.pvd").exists()


def time_series(folder):
    """The columns of timeSeries.csv by name; an empty field is NaN."""
    path = folder / "timeSeries.csv"
    if not path.exists():
        raise NothingToDraw(f"there is no {path}")
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    if not rows:
        raise NothingToDraw(f"{path} has no rows yet")
    return {name: np.array([float(row[name] or "nan") for row in rows]) for name in rows[0]}


def frames(folder, series):
    """[(day, data file)] of tissue.pvd or lumen.pvd."""
    path = folder / f"{series}.pvd"
    if not path.exists():
        raise NothingToDraw(f"there is no {path}")
    entries = ElementTree.parse(path).getroot().iter("DataSet")
    found = [(float(entry.get("timestep")), folder / entry.get("file")) for entry in entries]
    if not found:
        raise NothingToDraw(f"{path} has no entries yet")
    return found


def has_flow(path):
    """Whether the triangles of a lumen file carry a stress."""
    return bool(np.isfinite(vtk_to_numpy(poly_data(path).GetCellData().GetArray("WSS"))).any())


def flows(folder):
    """Whether the run has come to a flow."""
    series = frames(folder, "lumen") if (folder / "lumen.pvd").exists() else []
    return bool(series) and has_flow(series[-1][1])


def arresting_stress(folder):
    """The least wall shear stress [Pa] that puts a covered cell to rest; None where endothelium is not modelled.

    As NitricOxide::wssForNitricOxide() has it, with the numbers of the resolved scene.
    """
    path = folder / "scene.toml"
    scene = tomllib.loads(path.read_text(encoding="utf-8")) if path.exists() else {}
    if "endothelium" not in scene:
        return None
    keys = ("Threshold", "Slope", "Transition", "Constant", "First", "Second")
    least, slope, transition, constant, first, second = (
        float(scene["endothelium"][f"nitricOxide{key}"].split()[0]) for key in keys
    )
    if least <= slope * transition:
        return max(least, 0.0) / slope
    root = (-first + np.sqrt(max(0.0, first**2 - 4 * second * (constant - least)))) / (2 * second)
    return max(root, transition)


def frames_with_flow(entries):
    """Those of a lumen's frames that carry a stress: from the first solve on all do, the last one perhaps not."""
    *before, last = entries
    first = bisect.bisect_left(before, True, key=lambda entry: has_flow(entry[1]))
    return before[first:] + [last] * has_flow(last[1])


def spread(items, count):
    """At most `count` of the items, evenly spread, the first and the last among them; the last where it is one."""
    if len(items) <= count:
        return items
    if count == 1:
        return items[-1:]
    return [items[round(k * (len(items) - 1) / (count - 1))] for k in range(count)]


def poly_data(path):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def straight_positions(data):
    """Where the points (n, 3) [m] are in the straight vessel: of a bent one their array says so."""
    straight = data.GetPointData().GetArray("straightPosition")
    return vtk_to_numpy(straight or data.GetPoints().GetData()).astype(float)


def agents(path):
    """Arrays of a tissue file by name, `position` (n, 3) [m] about the axis, and `in_space`, that of the bent vessel."""
    data = poly_data(path)
    points = data.GetPointData()
    arrays = {points.GetArrayName(k): vtk_to_numpy(points.GetArray(k)) for k in range(points.GetNumberOfArrays())}
    arrays["position"] = straight_positions(data)
    arrays["in_space"] = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
    return arrays


def lumen(path):
    """Of a lumen file: vertices (n, 3) [m] about the axis and `in_space`, triangles (m, 3), WSS [Pa] and region of each.

    Of a flow that beats also TAWSS, OSI, RRT and transWSS.
    """
    data = poly_data(path)
    cells = data.GetCellData()
    beats = [name for name in ("TAWSS", "OSI", "RRT", "transWSS") if cells.HasArray(name)]
    return {
        **{name: vtk_to_numpy(cells.GetArray(name)).astype(float) for name in beats},
        "vertices": straight_positions(data),
        "in_space": vtk_to_numpy(data.GetPoints().GetData()).astype(float),
        "triangles": vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3),
        "WSS": vtk_to_numpy(cells.GetArray("WSS")).astype(float),
        "region": vtk_to_numpy(cells.GetArray("region")),
    }
