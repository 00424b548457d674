#!/usr/bin/python3
"""Reads the results of runs with pandas and VTK, and draws the figures of the thesis from them.

    examples/notebook.py results/quick [results/...]

Writes examples.png into the first folder: neointimal thickness over the days, a line a run, and the section of the first
run where the new tissue is thickest. Lines that begin with `# %%` are cells in Jupyter (jupytext) and in editors.
Needs python3-pandas, python3-matplotlib and python3-vtk9.
"""
# %% What is read
import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
from matplotlib.collections import EllipseCollection
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

RUNS = [Path(name) for name in sys.argv[1:]] or [Path("results/quick")]


def read(file):
    """Points [m] of a .vtp, its point data and its cell data, as arrays by name."""
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(file))
    reader.Update()
    data = reader.GetOutput()

    def arrays(attributes):
        return {attributes.GetArrayName(n): vtk_to_numpy(attributes.GetArray(n))
                for n in range(attributes.GetNumberOfArrays())}

    return vtk_to_numpy(data.GetPoints().GetData()), arrays(data.GetPointData()), arrays(data.GetCellData())


# %% Numbers over time: a table a run
series = {run.name: pd.read_csv(run / "timeSeries.csv") for run in RUNS}
for name, table in series.items():
    print(name)
    print(table[["day", "smc", "neointimaThickness_um", "minLumenArea_mm2", "wssMean_Pa"]].tail(3).to_string(index=False))

# %% The agents of the last recorded step
run = RUNS[0]
points, agents, _ = read(sorted((run / "tissue").glob("*.vtp"))[-1])
kinds = pd.Series(agents["kind"]).map({0: "muscle cell", 1: "inner lamina", 2: "outer lamina", 3: "strut"})
print(kinds.value_counts().to_string())

# %% The lumen of the last recorded step: its wall shear stress
_, _, faces = read(sorted((run / "lumen").glob("*.vtp"))[-1])
if "WSS" in faces:
    stress = faces["WSS"][faces["region"] == 0]
    print(f"wall shear stress: median {np.nanmedian(stress):.3g} Pa")

# %% Figures: thickness over the days, and a section
profile = pd.read_csv(run / "profile.csv")
place = profile.z_mm[profile.neointimaThickness_um.idxmax()]
figure, (left, right) = plt.subplots(1, 2, figsize=(11, 5), layout="constrained")
for name, table in series.items():
    left.plot(table.day, table.neointimaThickness_um, label=name)
left.set(xlabel="day", ylabel="neointimal thickness [um]")
left.legend()

# Spheres that the plane cuts, as the circles in which it cuts them
height = 1e3 * points[:, 2] - place
radius = 1e3 * agents["radius"]
cut = np.abs(height) < radius
across = 2 * np.sqrt(radius[cut] ** 2 - height[cut] ** 2)
colours = kinds[cut].map({"muscle cell": "tab:blue", "inner lamina": "tab:red", "outer lamina": "tab:purple",
                          "strut": "0.3"}).to_numpy(dtype=object)
colours[agents["daughter"][cut] == 1] = "tab:orange"
right.add_collection(EllipseCollection(across, across, np.zeros_like(across), units="xy", facecolors=colours,
                                       offsets=1e3 * points[cut, :2], transOffset=right.transData))
right.set(aspect="equal", xlabel="x [mm]", ylabel="y [mm]",
          title=f"{run.name}, z = {place:.3g} mm: new cells orange, struts grey")
right.autoscale_view()
figure.savefig(run / "examples.png", dpi=150)
print(f"{run / 'examples.png'}")
