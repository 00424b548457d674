"""Loads view.pvsm of a results folder in ParaView's Python and draws what it shows, whole and without each of its parts.

    pvpython tests/regression/showInParaView.py RESULTS PICTURES

Writes last.png and first.png, the last and the first day, and of what there is lastCells.png, lastLumen.png and
firstStruts.png, in which that is hidden; all without legends, whose colours are those of the cells. Exit status 0 when
the state has a layout and legends, opens on the last day and goes through the days.
"""

import os
import sys
from pathlib import Path

from paraview import simple

PARTS = {"lastCells": ("Cells",), "lastLumen": ("Lumen",), "firstStruts": ("Struts", "Faces of struts")}
SIZE = [800, 600]


def picture(view, path):
    simple.SaveScreenshot(str(path), view, ImageResolution=SIZE)


def hide_each(view, sources, pictures, day):
    for name, members in PARTS.items():
        found = [sources[member] for member in members if member in sources and name.startswith(day)]
        for member in found:
            simple.Hide(member, view)
        if found:
            picture(view, pictures / f"{name}.png")
        for member in found:
            simple.Show(member, view)


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
    legends = [shown for shown in view.Representations if shown.GetXMLName() == "ScalarBarWidgetRepresentation"]
    good = good and legends and all(legend.Visibility for legend in legends)
    for legend in legends:
        legend.Visibility = 0
    picture(view, pictures / "last.png")
    hide_each(view, sources, pictures, "last")
    scene.GoToFirst()
    picture(view, pictures / "first.png")
    hide_each(view, sources, pictures, "first")
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
