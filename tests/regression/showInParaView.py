"""Loads view.pvsm of a results folder in ParaView's Python and draws what it shows, whole and without each of its parts.

    pvpython tests/regression/showInParaView.py RESULTS PICTURES

Writes all.png, and for what is drawn of Cells, Struts and Lumen <name>.png, in which that is hidden; first.png is the
first day. Exit status 0 when the state has a layout, opens on the last day and goes through the days.
"""

import os
import sys
from pathlib import Path

from paraview import simple

PARTS = {"Cells": ("Cells",), "Struts": ("Struts", "Faces of struts"), "Lumen": ("Lumen",)}
SIZE = [800, 600]


def picture(view, path):
    simple.SaveScreenshot(str(path), view, ImageResolution=SIZE)


def main():
    if len(sys.argv) != 3:
        print(__doc__)
        return 2
    pictures = Path(sys.argv[2]).resolve()
    os.chdir(sys.argv[1])  # the state names files without a folder
    simple.LoadState("view.pvsm")
    view = simple.GetActiveViewOrCreate("RenderView")
    scene = simple.GetAnimationScene()
    steps = list(scene.TimeKeeper.TimestepValues)
    sources = {name: source for (name, _), source in simple.GetSources().items()}
    good = len(simple.GetLayouts()) == 1 and view.ViewTime == steps[-1] == scene.AnimationTime
    good = good and scene.PlayMode == "Snap To TimeSteps" and scene.StartTime == steps[0] and scene.EndTime == steps[-1]
    print(f"{len(steps)} days, opens on day {view.ViewTime}, {scene.PlayMode}, {len(simple.GetLayouts())} layout")
    picture(view, pictures / "all.png")
    for name, members in PARTS.items():
        found = [sources[member] for member in members if member in sources]
        for member in found:
            simple.Hide(member, view)
        if found:
            picture(view, pictures / f"{name}.png")
        for member in found:
            simple.Show(member, view)
    scene.GoToFirst()
    picture(view, pictures / "first.png")
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
