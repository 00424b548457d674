"""Draws the pictures of a results folder of restenosisFoam.

    /usr/bin/python3 bridge/output/figures RESULTS

Writes growth.png, lumen.png, section.png and lumen3d.png, of a lumen from a file only the last, beside what they are drawn from, and report.html, one page with
all of it; in the folder of a comparison, compareMaps.png and compareScatter.png; in that of a sweep, tradeoff.png. Needs Debian's
python3-matplotlib and python3-vtk9, and xvfb where there is no display. Exit status 0 when every picture that the
results allow was drawn; otherwise the last line printed says what is missing.
"""

import subprocess
import sys
from pathlib import Path

PACKAGES = {"numpy": "python3-numpy", "matplotlib": "python3-matplotlib", "vtkmodules": "python3-vtk9"}


def missing_package():
    """The Debian package of the first module that cannot be imported, and the interpreter's own words."""
    for module, package in PACKAGES.items():
        try:
            __import__(module)
        except ImportError as error:
            return package, error
    return None


def draw(folder):
    """Draws every picture; returns what went wrong, one line for each picture that was not drawn."""
    import matplotlib

    matplotlib.use("Agg")
    import compare
    import growth
    import lumen
    import report
    import results
    import section
    import tradeoff

    problems = []
    drawn = []
    for name, picture in (
        ("growth.png", growth.draw),
        ("lumen.png", lumen.draw),
        ("section.png", section.draw),
        ("compareMaps.png", compare.draw_maps),
        ("compareScatter.png", compare.draw_scatter),
        ("tradeoff.png", tradeoff.draw),
    ):
        try:
            picture(folder, folder / name)
            drawn.append(name)
        except results.NothingToDraw as reason:
            print(f"{name}: {reason}")
    if (folder / "lumen.pvd").exists():
        if problem := draw_in_space(folder):
            problems.append(f"lumen3d.png: {problem}")
        else:
            drawn.append("lumen3d.png")
    try:
        report.write(folder, folder / "report.html")
    except results.NothingToDraw as reason:
        print(f"report.html: {reason}")
    if not drawn:
        problems.append(f"{folder} holds no results to draw")
    return problems


def draw_in_space(folder):
    """Draws lumen3d.png in a process of its own: where graphics are broken, rendering can end its process."""
    import virtual_display

    script = Path(__file__).parent / "lumen3d.py"
    try:
        with virtual_display.environment() as environment:
            command = [sys.executable, "-B", str(script), str(folder)]
            status = subprocess.run(command, check=False, env=environment).returncode
    except virtual_display.NoDisplay as reason:
        return str(reason)
    return f"the rendering process ended with status {status}" if status != 0 else None


def main():
    if len(sys.argv) != 2:
        print("usage: figures RESULTS", file=sys.stderr)
        return 2
    missing = missing_package()
    if missing:
        print(f"install the package {missing[0]} ({missing[1]})", file=sys.stderr)
        return 1
    problems = draw(Path(sys.argv[1]))
    if problems:
        print("; ".join(problems), file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
