"""Checks view.pvsm of a results folder, the state that ParaView opens.

    /usr/bin/python3 -B tests/regression/checkView.py RESULTS [PICTURES PVPYTHON]

Reads it as XML: a layout with a view, files that are there and have no folder, spheres of their own radius, named
colours. With the other two also draws it by ParaView's Python into the folder PICTURES, and looks at the pixels. Exit
status 0 when all is well; each fault is printed.
"""

import re
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "bridge/output/figures"))

import matplotlib.image  # noqa: E402
import numpy as np  # noqa: E402
import results  # noqa: E402
import view  # noqa: E402
import virtual_display  # noqa: E402

LARGEST = 300_000  # bytes
FEW = 15  # pixels
faults = []


def check(condition, message):
    if not condition:
        faults.append(message)


def values(proxy, name):
    """What a property is set to; None where it is not set."""
    found = proxy.find(f"Property[@name='{name}']")
    return None if found is None else [element.get("value") for element in found if element.tag in ("Element", "Proxy")]


def check_references(manager):
    """That every proxy named is there, and made before those that need it."""
    known = set()
    for proxy in manager.findall("Proxy"):
        for reference in proxy.iter("Proxy"):
            if reference is not proxy:
                check(reference.get("value") in known, f"proxy {reference.get('value')} is used before it is made")
        known.add(proxy.get("id"))
    for item in manager.iter("Item"):
        number = item.get("id") or item.get("view")
        check(number in known, f"a collection or layout names {number}, which is not there")


def check_text(folder):
    path = folder / "view.pvsm"
    check(path.stat().st_size < LARGEST, f"{path} is large: {path.stat().st_size} bytes")
    manager = ElementTree.parse(path).getroot().find("ServerManagerState")
    check_references(manager)
    kinds = {}
    for proxy in manager.findall("Proxy"):
        kinds.setdefault(proxy.get("type"), []).append(proxy)
    views = [view_.get("id") for view_ in kinds["RenderView"]]
    check([item.get("view") for item in manager.findall("Proxy[@type='ViewLayout']/Layout/Item")] == views, "no layout")
    files = sorted(values(reader, "FileName")[0] for reader in kinds["PVDReader"])
    there = sorted(name for name in ("lumen.pvd", "tissue.pvd") if (folder / name).exists())
    check(files == there, f"{files} are named, {there} are there")
    solid = [values(reader, "FileName")[0] for reader in kinds.get("XMLPolyDataReader", [])]
    check(solid == ["struts.vtp"] * (folder / "struts.vtp").exists(), f"struts from {solid}")
    days = {day for name in there for day, _ in results.frames(folder, Path(name).stem)}
    for proxy, name, day in (("AnimationScene", "AnimationTime", max(days)), ("AnimationScene", "StartTime", min(days))):
        check(abs(float(values(kinds[proxy][0], name)[0]) - day) < 1e-6, f"{name} is not {day}")
    tables = {values(table, "IndexedLookup") == ["1"]: table for table in kinds["PVLookupTable"]}
    if "lumen.pvd" in there:
        titles = [values(legend, "Title")[0] for legend in kinds["ScalarBarWidgetRepresentation"]]
        check("Wall shear stress [Pa]" in titles, f"no unit in the legends {titles}")
        check(values(tables[False], "NanColor") is not None, "no colour for stress that is not known")
    if "tissue.pvd" in there:
        check_cut(folder, kinds["Plane"])
        check_spheres(kinds["UnstructuredGridRepresentation"])
        names = values(tables[True], "Annotations")
        check(names[1::2] == [name for name, _ in view.CLASSES][: len(names) // 2], f"names are {names}")
    print(f"view.pvsm: {path.stat().st_size} bytes, {len(views)} view, files {', '.join(files)}")


def check_cut(folder, planes):
    """That the vessel is cut along its axis, in the plane in which that bends: what lies on one side of the plane is what
    lies on the other."""
    agents = results.agents(results.frames(folder, "tissue")[-1][1])
    for plane in planes:
        origin, normal = (np.array(values(plane, name), dtype=float) for name in ("Origin", "Normal"))
        side = (agents["in_space"] - origin) @ normal
        check(abs(side.mean()) < 0.05 * side.max(), f"the cut is {side.mean()} m off")
        # Bent in the plane, no point leaves the distance from it that it had in the straight vessel
        about = np.column_stack([np.ones(len(side)), agents["position"][:, :2]])
        left = side - about @ np.linalg.lstsq(about, side, rcond=None)[0]
        check(np.abs(left).max() < 0.01 * side.max(), f"the vessel bends out of the plane of the cut by {np.abs(left).max()} m")


def check_spheres(shown):
    """A sphere of a metre in place of each cell stops ParaView: the scale must be the cells' radius from the start."""
    spheres = [one for one in shown if values(one, "Representation") == ["Point Gaussian"]]
    check(spheres, "no spheres")
    for one in spheres:
        check(values(one, "GaussianRadius") == ["1"], f"Gaussian radius {values(one, 'GaussianRadius')}")
        check(values(one, "ScaleByArray") == ["1"], "spheres are not scaled by an array")
        check(values(one, "SetScaleArray") == ["", "", "", "0", "radius"], f"scaled by {values(one, 'SetScaleArray')}")
        check(values(one, "UseScaleFunction") == ["0"], "the radius goes through a function")


def drawn(folder, pictures, pvpython):
    """Whether ParaView has drawn the state, on the first display that it can draw on."""
    command = [pvpython, str(HERE / "showInParaView.py"), str(folder), str(pictures)]
    for environment in virtual_display.environments():
        with environment as variables:
            if variables is not None and subprocess.run(command, check=False, env=variables).returncode == 0:
                return True
    return False


def read(path):
    return matplotlib.image.imread(path)[..., :3].astype(float)


def hue(pixels):
    """Colours without their brightness, of which light takes some."""
    return pixels / np.maximum(pixels.max(axis=-1, keepdims=True), 1e-6)


def count(pixels, colour, tolerance=0.09):
    return int((np.abs(hue(pixels) - hue(np.array(view.rgb(colour)))).max(axis=-1) < tolerance).sum())


def check_pixels(folder, pictures):
    days = {day: read(pictures / f"{day}.png") for day in ("first", "last")}
    check((np.abs(days["last"] - 1).max(axis=2) > 0.1).mean() > 0.1, "the picture is nearly blank")
    check(np.abs(days["first"] - days["last"]).max() > 0.1, "the first day looks as the last")
    seen = {}
    for path in sorted(pictures.glob("*[A-Z]*.png")):
        day, part = re.fullmatch("([a-z]+)([A-Z][a-z]+)", path.stem).groups()
        seen[part] = days[day][np.abs(read(path) - days[day]).max(axis=2) > 0.02]
        check(len(seen[part]) > FEW, f"{part} cover {len(seen[part])} pixels")
    if "Cells" in seen:
        agents = results.agents(results.frames(folder, "tissue")[-1][1])
        for k, (name, colour) in enumerate(view.CLASSES[: view.STRUT]):
            if k in common_classes(agents):
                check(count(seen["Cells"], colour) > FEW, f"'{name}' cover {count(seen['Cells'], colour)} pixels")
    if "Struts" in seen:
        check(np.ptp(hue(seen["Struts"]), axis=1).mean() < 0.15, "struts are not grey")
    if "Lumen" in seen:
        check_map(hue(seen["Lumen"]))
    print(", ".join(f"{name} cover {len(pixels)} pixels" for name, pixels in seen.items()))


def common_classes(agents):
    """The classes of at least a hundredth of the cells: some of them lie open."""
    classes = np.where(agents["synthetic"] > 0, 1, 0)
    classes[agents["daughter"] > 0] = 2
    for array, value, number in (("state", 1, 3), ("state", 2, 4), ("kind", 1, 5), ("kind", 2, 6), ("kind", 3, 7)):
        classes[agents[array] == value] = number
    shares = np.bincount(classes, minlength=len(view.CLASSES)) / len(classes)
    return np.flatnonzero(shares > 0.01)


def check_map(pixels):
    """That the colours are those of the map of stress, and several of them."""
    colours = hue(matplotlib.colormaps[view.style.WSS_MAP](np.linspace(0, 1, 64))[:, :3])
    distances = np.abs(pixels[:, None, :] - colours[None]).max(axis=2)
    near = distances.min(axis=1) < 0.1
    check(near.mean() > 0.6, f"{near.mean():.0%} of the lumen have a colour of the map")
    check(len(set(distances[near].argmin(axis=1))) > 5, "the lumen has one colour")


def main():
    if len(sys.argv) not in (2, 4):
        print(__doc__)
        return 2
    folder = Path(sys.argv[1]).resolve()
    check_text(folder)
    if len(sys.argv) == 4:
        pictures = Path(sys.argv[2]).resolve()
        if drawn(folder, pictures, sys.argv[3]):
            check_pixels(folder, pictures)
        else:
            faults.append("ParaView has not drawn the state, or it opens otherwise than it should")
    for fault in faults:
        print(f"FAULT: {fault}")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
