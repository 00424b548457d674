"""Draws the pictures of a results folder of restenosisFoam.

    /usr/bin/python3 bridge/output/figures RESULTS

Writes growth.png, lumen.png, section.png and lumen3d.png beside what they are drawn from. Needs Debian's
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
    import growth
    import lumen
    import section
    import virtual_display

    problems = []
    for name, picture in (("growth.png", growth), ("lumen.png", lumen), ("section.png", section)):
        try:
            picture.draw(folder, folder / name)
            print(f"drawn: {name}")
        except FileNotFoundError as error:
            problems.append(f"{name}: {error}")
    # Rendering can end its process where graphics are broken, so it has one of its own.
    script = Path(__file__).parent / "lumen3d.py"
    command = virtual_display.wrap([sys.executable, "-B", str(script), str(folder)])
    if command is None:
        problems.append("lumen3d.png: no display and no xvfb-run; install the package xvfb")
    elif (status := subprocess.run(command, check=False).returncode) != 0:
        problems.append(f"lumen3d.png: the rendering process ended with status {status}")
    else:
        print("drawn: lumen3d.png")
    return problems


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
