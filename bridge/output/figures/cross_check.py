"""crossCheck.png: how the wall shear stress by another method differs from the run's own, over the days."""

import matplotlib.pyplot as plt
import numpy as np
import results
import style

PARTS = {"Smooth": "smooth wall", "NearStruts": "near struts", "Struts": "struts"}
COLOURS = (style.BLUE, style.GREEN, style.VERMILION)


def draw(folder, path):
    series = results.time_series(folder)
    checked = {name: values for name, values in series.items() if name.startswith("crossCheck")}
    if not any(np.isfinite(values).any() for values in checked.values()):
        raise results.NothingToDraw("no flow was cross-checked")
    style.apply()
    figure, (means, squares, decided) = plt.subplots(1, 3, figsize=(9.5, 3.2))

    def curve(axis, values, **how):
        known = np.isfinite(values)
        axis.plot(series["day"][known], 100 * values[known], marker="o", markersize=3.5, **how)

    for (part, label), colour in zip(PARTS.items(), COLOURS):
        curve(means, series[f"crossCheck{part}Mean"], color=colour, label=label)
        curve(squares, series[f"crossCheck{part}L2"], color=colour)
    curve(decided, series["crossCheckDecidedOtherwise"], color=style.PURPLE)
    means.axhline(0, color=style.GREY, linewidth=0.8)
    means.set_title("Mean stress: difference")
    means.set_ylabel("of the run's own [%]")
    squares.set_title("L2 difference")
    decided.set_title("Decided otherwise")
    decided.set_ylabel("of the covered cells [%]")
    for axis in (squares, decided):
        axis.set_ylim(bottom=0)
    for axis in (means, squares, decided):
        axis.set_xlabel("day after deployment")
    means.legend(fontsize=8)
    style.letter_panels((means, squares, decided))
    style.save(figure, path)
    plt.close(figure)
