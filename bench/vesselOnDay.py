#!/usr/bin/python3
"""Draws the vessel cut open, as vessel.png of a run, on another day than the last.

    xvfb-run -a bench/vesselOnDay.py RESULTS DAY PICTURE
"""
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "bridge/output/figures"))
import results
import style
import vessel

folder, day, path = Path(sys.argv[1]), float(sys.argv[2]), Path(sys.argv[3])
found, file = min(results.frames(folder, "tissue"), key=lambda frame: abs(frame[0] - day))
spheres = vessel.visible(file)
style.apply()
style.save(vessel.picture(vessel.view_of(*spheres), spheres, found, results.flows(folder), spheres[2]), path)
