"""One self-contained page of a run: final values, pictures, cost and scene."""

import base64
import html
import json

from nothing_to_draw import NothingToDraw

PICTURES = {
    "vessel.png": "The vessel cut open along its axis on the last day: stent, new tissue, laminae and media. "
    "The scale bar lies along the vessel.",
    "section.png": "The wall where new tissue is thickest, on the first and the last day in the same frame: across (A), "
    "enlarged (B) and along the vessel (C). The line is that of the inner elastic lamina, which goes on where it is "
    "injured.",
    "growth.png": "Neointima, lumen, coverage, cells in cycle and wall shear stress over the days. "
    "A tick marks a recorded state before which the flow was solved anew; "
    "flowSolves in timeSeries.csv counts all solves.",
    "lumen.png": "The lumen unrolled on several days: narrowing and wall shear stress, with the struts and the line of "
    "the stress that puts a covered cell to rest.",
    "lumen3d.png": "The lumen in space.",
    "crossCheck.png": "Wall shear stress by another method against the run's own, and what it would have decided.",
}
STYLE = """
body { font-family: sans-serif; max-width: 60em; margin: 2em auto; padding: 0 1em; color: #222; }
img { max-width: 100%; } figure { margin: 2em 0; } figcaption { color: #555; }
table { border-collapse: collapse; } th { text-align: left; } td, th { padding: 0.15em 1.2em 0.15em 0; }
td.number { text-align: right; font-variant-numeric: tabular-nums; }
pre { background: #f5f5f5; padding: 1em; overflow-x: auto; }
"""


def number(value):
    if value is None:
        return "unknown"
    return f"{value:,}" if isinstance(value, int) else f"{value:,.4g}"


def table(head, rows):
    """An HTML table; the first cell of a row is text, the others are numbers."""
    lines = ["<table>", "<tr>" + "".join(f"<th>{html.escape(name)}</th>" for name in head) + "</tr>"]
    for first, *others in rows:
        cells = "".join(f'<td class="number">{number(value)}</td>' for value in others)
        lines.append(f"<tr><td>{html.escape(str(first))}</td>{cells}</tr>")
    return "\n".join(lines + ["</table>"])


def picture(path, caption):
    data = base64.b64encode(path.read_bytes()).decode("ascii")
    caption = html.escape(caption)
    return (
        f'<figure><img src="data:image/png;base64,{data}" alt="{caption}">\n<figcaption>{caption}</figcaption></figure>'
    )


def write(folder, path):
    """Writes the page of a results folder."""
    source = folder / "summary.json"
    if not source.exists():
        raise NothingToDraw(f"there is no {source}")
    summary = json.loads(source.read_text(encoding="utf-8"))
    title = html.escape(summary["title"] or summary["scene"])
    flow = summary["flow"]
    parts = [
        f"<h1>{title}</h1>",
        f"<p>{html.escape(summary['scene'])}: {html.escape(summary['status'])}; seed {summary['seed']}, "
        f"{number(summary['agents'])} agents, {flow['solvesDone']} flow solves by "
        f"{html.escape(flow['backend'] or 'no method')}; restenosisFoam {html.escape(summary['version'])}, "
        f"state {html.escape(summary['stateDigest'])}.</p>",
    ]
    if summary["remarks"]:
        parts.append("<h2>Remarks</h2>\n<ul>")
        parts += [f"<li>{html.escape(remark)}</li>" for remark in summary["remarks"]]
        parts.append("</ul>")
    parts += [picture(folder / name, caption) for name, caption in PICTURES.items() if (folder / name).exists()]
    parts += ["<h2>Final values</h2>", table(("", ""), summary["final"].items())]
    cost = [(name, part["seconds"], part["peakMemory_MiB"]) for name, part in summary["parts"].items()]
    cost.append(("all", summary["totalSeconds"], max((row[2] for row in cost), default=0.0)))
    parts += ["<h2>Cost</h2>", table(("part", "seconds", "peak memory [MiB]"), cost)]
    scene = folder / "scene.toml"
    if scene.exists():
        parts += ["<h2>Scene</h2>", f"<pre>{html.escape(scene.read_text(encoding='utf-8'))}</pre>"]
    page = "\n".join(parts)
    path.write_text(
        f'<!DOCTYPE html>\n<html lang="en">\n<head><meta charset="utf-8"><title>{title}</title>\n'
        f"<style>{STYLE}</style></head>\n<body>\n{page}\n</body>\n</html>\n",
        encoding="utf-8",
    )
