"""tradeoff.png: cost against error of every setting that was swept, with the front of those that nothing beats."""

import csv

import matplotlib.pyplot as plt
import results
import style

COLOURS = (style.BLUE, style.VERMILION, style.GREEN, style.ORANGE, style.PURPLE, style.SKY, style.BLACK)
MARKERS = "osD^vP*"
SEEDS = "scene.seed"
STRESS = "wall shear stress"
WIDE = 5  # a span of more than this factor has a logarithmic axis


def read(folder):
    path = folder / "tradeoff.csv"
    if not path.exists():
        raise results.NothingToDraw(f"there is no {path}")
    with open(path, encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    return [dict(row, seconds=float(row["seconds"]), error=100 * float(row["error"])) for row in rows]


def front(rows):
    """The rows, all measured against one reference, that are nowhere beaten in both cost and error, by rising cost.

    A reference among them has no error, so the front ends there."""
    best = []
    for row in sorted(rows, key=lambda row: (row["seconds"], row["error"])):
        if not best or row["error"] < best[-1]["error"]:
            best.append(row)
    return best


def fronts(rows):
    """A front for each reference: errors against different ones say nothing about each other."""
    meanings = dict.fromkeys(row["meaning"] for row in rows)
    return [front([row for row in rows if row["meaning"] == meaning]) for meaning in meanings]


def draw_panel(axis, rows, title, seeds):
    """Rows without an error, references among them, stand on the axis of cost."""
    for number, setting in enumerate(dict.fromkeys(row["setting"] for row in rows)):
        chosen = [row for row in rows if row["setting"] == setting]
        look = {"color": COLOURS[number % len(COLOURS)], "marker": MARKERS[number % len(MARKERS)]}
        axis.plot(
            [row["seconds"] for row in chosen],
            [row["error"] for row in chosen],
            linestyle="",
            label=setting,
            clip_on=False,
            zorder=3,
            **look,
        )
        for row in chosen:
            axis.annotate(
                row["value"], (row["seconds"], row["error"]), xytext=(5, 4), textcoords="offset points", fontsize=8
            )
    label = "nothing is both cheaper and nearer"
    for best in fronts(rows):
        axis.plot(
            [row["seconds"] for row in best],
            [row["error"] for row in best],
            color=style.GREY,
            linewidth=1,
            drawstyle="steps-post",
            label=label,
            zorder=1,
        )
        label = None
    if seeds:
        axis.axhspan(0, max(seeds), color=style.LIGHT, alpha=0.6, zorder=0, label="within it: as other seeds differ")
    costs = [row["seconds"] for row in rows]
    errors = [row["error"] for row in rows if row["error"] > 0]
    axis.margins(x=0.15, y=0.15)
    if max(costs) > WIDE * min(costs):
        axis.set_xscale("log")
    if max(errors) > WIDE * min(errors):
        # Logarithmic, with a 0 at its end where there are references
        if len(errors) < len(rows):
            axis.set_yscale("symlog", linthresh=min(errors), linscale=0.3)
        else:
            axis.set_yscale("log")
    if axis.get_yscale() != "log":
        axis.set_ylim(bottom=0)
    axis.set(title=title, xlabel="seconds", ylabel="error [%]")
    axis.legend(loc="upper center", bbox_to_anchor=(0.5, -0.12), ncol=2)


def draw(folder, path):
    rows = read(folder)
    flow = [row for row in rows if row["meaning"].startswith(STRESS)]
    runs = [row for row in rows if row not in flow and row["setting"] != SEEDS]
    seeds = [row["error"] for row in rows if row["setting"] == SEEDS and row["error"] > 0]
    panels = []
    if any(row["error"] > 0 for row in flow):
        panels.append((flow, f"{flow[0]['meaning']}", []))
    if any(row["error"] > 0 for row in runs):
        panels.append((runs, f"{runs[0]['meaning'].split(' against ')[0]}, against each setting's first value", seeds))
    if not panels:
        raise results.NothingToDraw("no setting has an error")
    style.apply()
    figure, axes = plt.subplots(1, len(panels), figsize=(6.2 * len(panels), 4.6), squeeze=False)
    for axis, (chosen, title, within) in zip(axes[0], panels):
        draw_panel(axis, chosen, title, within)
    style.letter_panels(axes[0])
    style.save(figure, path)
    plt.close(figure)
