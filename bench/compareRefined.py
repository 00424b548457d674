#!/usr/bin/env python3
"""Two flow methods in one lumen, refined together: where do their stresses go?

    /usr/bin/python3 bench/compareRefined.py PICTURE COMPARISON [COMPARISON ...]

Reads compare.json of comparisons of one lumen at several fidelities. Prints, by part, the mean stress of both methods and
their difference, in the mean and in L2 over the faces; draws them against the lattice spacing into PICTURE.
"""

import json
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

PARTS = {"smoothWall": "wall away from struts", "betweenStruts": "wall near struts", "strut": "struts"}
COLOURS = {"foam": "tab:blue", "lbm": "tab:orange"}
NAMES = {"foam": "OpenFOAM", "lbm": "lattice"}


def main():
    picture, folders = sys.argv[1], sys.argv[2:]
    cases = [json.loads((Path(folder) / "compare.json").read_text()) for folder in folders]
    cases.sort(key=lambda case: -case["latticeSpacing_um"])
    spacing = [case["latticeSpacing_um"] for case in cases]
    figure, axes = pyplot.subplots(2, len(PARTS), figsize=(10, 6), sharex=True, constrained_layout=True)
    for axis, below, (part, title) in zip(axes[0], axes[1], PARTS.items()):
        means = {method: [case["wss"][part][f"{method}Mean_Pa"] for case in cases] for method in NAMES}
        print(part)
        for n, case in enumerate(cases):
            difference = case["wss"][part]
            print(
                f"  {case['fidelity']:<10} {spacing[n]:4.0f} um  OpenFOAM {means['foam'][n]:.4f} Pa  "
                f"lattice {means['lbm'][n]:.4f} Pa  {100 * difference['meanDifference']:+.1f} %  "
                f"L2 {100 * difference['relativeL2']:.1f} %"
            )
        for method, name in NAMES.items():
            axis.plot(spacing, means[method], "o-", color=COLOURS[method], label=name)
        axis.set_ylim(0.5 * min(means["foam"]), 1.2 * max(means["foam"]))
        axis.set_title(title, fontsize="medium")
        scatter = [100 * case["wss"][part]["relativeL2"] for case in cases]
        below.plot(spacing, scatter, "o-", color="black")
        below.set_xlim(left=0)
        below.set_ylim(0, 1.1 * max(scatter))
        below.set_xlabel("lattice spacing [um]")
    axes[0][0].set_ylabel("mean wall shear stress [Pa]")
    axes[0][0].legend(frameon=False)
    axes[1][0].set_ylabel("difference, L2 over the faces [%]")
    figure.savefig(picture, dpi=150)


if __name__ == "__main__":
    main()
