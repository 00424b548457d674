#!/usr/bin/python3
"""Prints the page of a study: figure, table, and its runs. Usage, in the folder of its results: page.py STUDY.toml"""
import base64
import csv
import sys
from html import escape
from pathlib import Path

from kept import Kept
from study import Study

STYLE = """body { font: 16px/1.5 sans-serif; max-width: 70em; margin: 2em auto; padding: 0 1em }
img { max-width: 100% } table { border-collapse: collapse; display: block; overflow-x: auto }
th, td { border-bottom: 1px solid #ccc; padding: 0.2em 0.8em; text-align: right }
th:first-child, td:first-child { text-align: left }"""


def table(lines):
    head, *rest = lines
    cells = ["<tr>" + "".join(f"<th>{escape(str(cell))}</th>" for cell in head) + "</tr>"]
    # A cell that is a pair is a link
    for line in rest:
        cells.append("<tr>" + "".join(
            f'<td><a href="{escape(cell[1])}">{escape(cell[0])}</a></td>' if isinstance(cell, tuple) else
            f"<td>{escape(str(cell))}</td>" for cell in line) + "</tr>")
    return "<table>\n" + "\n".join(cells) + "\n</table>"


study = Study(sys.argv[1])
kept = Kept(study)
with open("table.csv", newline="") as file:
    results = list(csv.reader(file))
runs = [["run", "status", "version", "hours", "peak memory [MiB]", "digest"]]
for name, run in study.runs.items():
    folder = Path("runs") / name
    line = kept.line(run, folder)
    page = folder / "report.html"
    runs.append([(name, str(page)) if page.exists() else name, line["status"], line["version"],
                 f"{float(line['seconds']) / 3600:.2f}", line["peak_MiB"], line["digest"]])
picture = base64.b64encode(Path("figure.png").read_bytes()).decode()
title = escape(study.title or study.file.parent.name)
over = f"{len(study.runs)} points" if study.points else f"{len(study.seeds)} seed{'s' if len(study.seeds) > 1 else ''}"
print(f"""<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width">
<title>{title}</title><style>{STYLE}</style></head><body>
<h1>{title}</h1>
<p><img alt="Curves of the study" src="data:image/png;base64,{picture}"></p>
<p>A line is a mean over {over}, a band reaches from the least to the most.</p>
<h2>On the days asked for</h2>
{table(results)}
<h2>Runs</h2>
{table(runs)}
<h2>Study</h2>
<pre>{escape(study.file.read_text())}</pre>
</body></html>""")
