#!/usr/bin/env python3
"""Where the inner elastic lamina ends up, by contact law and number of steps (thesis, Figure 6.3).

    /usr/bin/python3 bench/figure6_3.py RESULTS

Runs scenes/deployment.toml with both contact laws: with a fixed, small effort in each step of the deployment by either
minimiser, and relaxed to equilibrium in each. Runs that RESULTS holds already are not repeated. Draws
docs/pictures/figure6_3.png and prints the table of docs/results/wall.md.
"""
import json
import subprocess
import sys
from pathlib import Path

import numpy as np
from matplotlib import pyplot

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "bridge/output/figures"))
import results  # noqa: E402
import style  # noqa: E402

LAWS = {"hertzNeoHookean": "neo-Hookean", "hertz": "Hertz"}
STEPS = {"fixed effort": {"hertzNeoHookean": (10, 100, 1000), "hertz": (10, 100, 1000)},
         "overdamped, fixed effort": {"hertzNeoHookean": (30, 100, 1000), "hertz": (30, 100, 1000)},
         "relaxed": {"hertzNeoHookean": (100,), "hertz": (100,)}}
SETTINGS = {"fixed effort": {},
            "overdamped, fixed effort": {"relaxation.minimiser": "overdamped"},
            "relaxed": {"relaxation.stopAtMaximum": "false", "relaxation.maximumIterations": "20000"}}
TITLES = {"fixed effort": "11 force evaluations in each step",
          "overdamped, fixed effort": "the same, moved as the thesis does",
          "relaxed": "each step relaxed"}
COLOURS = {10: style.YELLOW, 30: style.VERMILION, 100: style.ORANGE, 1000: style.BLUE, 10000: style.PURPLE}
MIDDLE, HALF_STRUT, BESIDE = 0.3, 0.0225, (0.075, 0.13)  # mm from the inlet, and from the strut's middle


def run(folder, law, steps, regime):
    if (folder / "summary.json").exists():
        return
    command = [ROOT / "build/release/restenosisFoam", "run", ROOT / "scenes/deployment.toml", "-o", folder,
               "--set", f"mechanics.contactLaw={law}", "--set", f"stent.deploymentSteps={steps}",
               "--set", "output.pictures=false"]
    for key, value in SETTINGS[regime].items():
        command += ["--set", f"{key}={value}"]
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(done.stderr)


def lamina(folder):
    """z and radius of the agents of the IEL, in mm and um."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(results.frames(folder, "tissue")[-1][1]))
    reader.Update()
    data = reader.GetOutput()
    points = vtk_to_numpy(data.GetPoints().GetData())
    points = points[vtk_to_numpy(data.GetPointData().GetArray("kind")) == results.KINDS["iel"]]
    return points[:, 2] * 1e3, np.hypot(points[:, 0], points[:, 1]) * 1e6


def median(z, radius, low, high):
    distance = np.abs(z - MIDDLE)
    return np.median(radius[(distance >= low) & (distance <= high)])


def seconds(folder):
    parts = json.loads((folder / "summary.json").read_text())["parts"]
    return parts["deploy"]["seconds"]


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    style.apply()
    figure, axes = pyplot.subplots(1, len(STEPS), figsize=(14, 4), sharey=True)
    edges = np.linspace(0, 2 * MIDDLE, 25)
    print("| each step | law | steps | IEL under the strut | beside it | deployment |\n|---|---|---|---|---|---|")
    for axis, (regime, laws) in zip(axes, STEPS.items()):
        axis.set_title(TITLES[regime])
        axis.set_xlabel("distance from the inlet [mm]")
        for law, counts in laws.items():
            for steps in counts:
                folder = Path(sys.argv[1]) / f"{regime.split(',')[0].split()[0]}-{law}-{steps}"
                run(folder, law, steps, regime)
                z, radius = lamina(folder)
                profile = [np.median(radius[(z >= a) & (z < b)]) for a, b in zip(edges, edges[1:])]
                axis.plot((edges[:-1] + edges[1:]) / 2, profile, color=COLOURS[steps],
                          linestyle="-" if law == "hertzNeoHookean" else "--", label=f"{LAWS[law]}, {steps} steps")
                print(f"| {regime} | {LAWS[law]} | {steps} | {median(z, radius, 0, HALF_STRUT):.1f} um "
                      f"| {median(z, radius, *BESIDE):.1f} um | {seconds(folder):.1f} s |", flush=True)
        axis.axhline(1010, color=style.GREY, linewidth=0.8)
        axis.legend(loc="upper left", bbox_to_anchor=(0, 0.88), fontsize=7, handlelength=1.6)
    axes[0].set_ylabel("radius of the inner elastic lamina [µm]")
    axes[0].text(0.005, 1011, "the strut's outer face", color=style.GREY, fontsize=8, va="bottom")
    style.save(figure, ROOT / "docs/pictures/figure6_3.png")


if __name__ == "__main__":
    main()
