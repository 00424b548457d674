"""Colours, type, letters and scale bars of all pictures.

Colours: Okabe and Ito's palette and perceptually uniform maps, which people with any colour vision can tell apart.
"""

import matplotlib as mpl

BLACK, ORANGE, SKY, GREEN = "#000000", "#E69F00", "#56B4E9", "#009E73"
YELLOW, BLUE, VERMILION, PURPLE = "#F0E442", "#0072B2", "#D55E00", "#CC79A7"
GREY, LIGHT = "#7F7F7F", "#D9D9D9"
MEDIA, STEEL = "#D3DEE8", "#5B646C"

WSS_MAP = "viridis"
THICKNESS_MAP = "magma_r"
ROUND_LENGTHS = (0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50)  # of scale bars [mm]


def apply():
    mpl.rcParams.update(
        {
            "font.family": "DejaVu Sans",
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
            "savefig.dpi": 200,
            "pdf.fonttype": 42,
            "figure.constrained_layout.use": True,
        }
    )


def day_label(day):
    return f"day {day:.4g}"


def letter_panels(axes):
    """A bold letter before the title of each panel, in order; nothing for a single one."""
    axes = list(axes)
    if len(axes) < 2:
        return
    for number, axis in enumerate(axes):
        title = axis.get_title(loc="left")
        axis.set_title(f"  {title}" if title else "")
        axis.annotate(
            chr(ord("A") + number),
            (0, 1),
            xytext=(-12, 6),
            xycoords="axes fraction",
            textcoords="offset points",
            fontsize=12,
            fontweight="bold",
        )


def round_length(limit):
    """The largest length of ROUND_LENGTHS up to a limit [mm]."""
    return max((length for length in ROUND_LENGTHS if length <= limit), default=ROUND_LENGTHS[0])


def length_label(length):
    """A length [mm] in the unit that reads best."""
    return f"{length:g} mm" if length >= 0.5 else f"{1e3 * length:g} µm"


def within(limits, share):
    """The place at a share of the way between an axis's limits."""
    return limits[0] + share * (limits[1] - limits[0])


def scale_bar(axis, longest, centre=(0.5, 0.06)):
    """A bar with its length, up to `longest` in the axis's units [mm], about a place given in shares of the axis."""
    length = round_length(longest)
    x, y = within(axis.get_xlim(), centre[0]), within(axis.get_ylim(), centre[1])
    axis.plot([x - length / 2, x + length / 2], [y, y], color=BLACK, linewidth=3, solid_capstyle="butt", marker="")
    axis.annotate(length_label(length), (x, y), xytext=(0, 4), textcoords="offset points", ha="center", fontsize=8)


def flow_arrow(axis, start, length=0.25):
    """An arrow of the blood's way along the x axis, named on its left; places in shares of the axis."""
    axis.annotate(
        "flow",
        (start[0] + length, start[1]),
        start,
        xycoords="axes fraction",
        textcoords="axes fraction",
        va="center",
        ha="right",
        fontsize=8,
        annotation_clip=False,
        arrowprops={"arrowstyle": "-|>", "color": BLACK, "linewidth": 1.2},
    )


def save(figure, path, vector=False):
    """Replaces the picture only when the new one is complete; `vector`: and the PDF beside it."""
    for kind in (".png", ".pdf") if vector else (".png",):
        partial = path.with_name(path.stem + ".partial" + kind)
        figure.savefig(partial, metadata={"CreationDate": None} if kind == ".pdf" else None)
        partial.replace(path.with_suffix(kind))
