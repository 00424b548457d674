"""Colours and type of all pictures. Colours: Okabe and Ito's palette and perceptually uniform maps, which people
with any colour vision can tell apart."""

import matplotlib as mpl

BLACK, ORANGE, SKY, GREEN = "#000000", "#E69F00", "#56B4E9", "#009E73"
YELLOW, BLUE, VERMILION, PURPLE = "#F0E442", "#0072B2", "#D55E00", "#CC79A7"
GREY, LIGHT = "#7F7F7F", "#D9D9D9"

WSS_MAP = "viridis"
THICKNESS_MAP = "magma_r"


def apply():
    mpl.rcParams.update(
        {
            "font.size": 9,
            "axes.titlesize": 10,
            "axes.titlelocation": "left",
            "axes.spines.top": False,
            "axes.spines.right": False,
            "axes.grid": True,
            "grid.color": "#E6E6E6",
            "grid.linewidth": 0.7,
            "axes.axisbelow": True,
            "lines.linewidth": 1.8,
            "legend.frameon": False,
            "figure.dpi": 100,
            "savefig.dpi": 150,
            "figure.constrained_layout.use": True,
        }
    )


def day_label(day):
    return f"day {day:.4g}"


def save(figure, path):
    """Replaces the picture only when the new one is complete."""
    partial = path.with_name(path.stem + ".partial.png")
    figure.savefig(partial)
    partial.replace(path)
