#!/usr/bin/env python3
"""Two flow methods in one lumen, refined together: where do their stresses go?

    /usr/bin/python3 docs/results/compareRefined.py PICTURE COMPARISON [COMPARISON ...]

Reads compare.json of comparisons of one lumen at several fidelities. Prints, by part, the mean stress of both methods,
their difference, and where a straight line through the two finest lattices meets the spacing 0; draws the means against
the lattice spacing into PICTURE.
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
    figure, axes = pyplot.subplots(1, len(PARTS), figsize=(10, 3.4), constrained_layout=True)
    for axis, (part, title) in zip(axes, PARTS.items()):
        means = {method: [case["wss"][part][f"{method}Mean_Pa"] for case in cases] for method in NAMES}
        slope = (means["lbm"][-2] - means["lbm"][-1]) / (spacing[-2] - spacing[-1])
        limit = means["lbm"][-1] - slope * spacing[-1]
        print(part)
        for n, case in enumerate(cases):
            difference = case["wss"][part]
            print(
                f"  {case['fidelity']:<10} {spacing[n]:4.0f} um  OpenFOAM {means['foam'][n]:.4f} Pa  "
                f"lattice {means['lbm'][n]:.4f} Pa  {100 * difference['meanDifference']:+.1f} %  "
                f"L2 {100 * difference['relativeL2']:.1f} %"
            )
        finest = means["foam"][-1]
        print(f"  lattice at 0 um: {limit:.4f} Pa, {100 * (limit / finest - 1):+.1f} % of the finest OpenFOAM")
        for method, name in NAMES.items():
            axis.plot(spacing, means[method], "o-", color=COLOURS[method], label=name)
        axis.plot([spacing[-1], 0], [means["lbm"][-1], limit], ":", color=COLOURS["lbm"])
        axis.set_xlim(left=0)
        axis.set_title(title, fontsize="medium")
        axis.set_xlabel("lattice spacing [um]")
    axes[0].set_ylabel("mean wall shear stress [Pa]")
    axes[0].legend(frameon=False)
    figure.savefig(picture, dpi=150)


if __name__ == "__main__":
    main()
