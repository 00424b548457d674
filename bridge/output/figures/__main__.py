"""Draws the pictures of a results folder of restenosisFoam.

    /usr/bin/python3 -I -B bridge/output/figures RESULTS [PICTURE]
    /usr/bin/python3 -I -B bridge/output/figures --page PAGE RESULTS...
    /usr/bin/python3 -I -B bridge/output/figures --animation RESULTS

Writes vessel.png, growth.png, section.png, lumen.png and lumen3d.png, of a lumen from a file without tissue only the
last, beats.png where the flow beats, crossCheck.png where the flow was cross-checked, beside what they are drawn from, and report.html, one page with
all of it; growth, section and lumen as PDF too; view.pvsm is the same for ParaView. In the folder of a comparison it writes compareMaps.png and
compareScatter.png; in that of a sweep, tradeoff.png. With a PICTURE only that; with --page the page alone, of one run or of
several runs and studies side by side; with --animation vessel.png day by day, animation.gif. Needs Debian's python3-matplotlib and
python3-vtk9, and xvfb where there is no display. The page is written without the pictures that cannot be drawn. Exit
status 0 when every picture that the results allow was drawn; otherwise the last line printed says what is missing.

-I (isolated) keeps out what a user has set or installed for other programs: PYTHONPATH, PYTHONHOME, packages of their
own.
"""

import importlib
import subprocess
import sys
import traceback
from pathlib import Path

import report
from nothing_to_draw import NothingToDraw

PACKAGES = {"numpy": "python3-numpy", "matplotlib": "python3-matplotlib", "vtkmodules": "python3-vtk9"}
PICTURES = {
    "growth.png": ("growth", "draw"),
    "lumen.png": ("lumen", "draw"),
    "section.png": ("section", "draw"),
    "beats.png": ("beats", "draw"),
    "crossCheck.png": ("cross_check", "draw"),
    "compareMaps.png": ("compare", "draw_maps"),
    "compareScatter.png": ("compare", "draw_scatter"),
    "tradeoff.png": ("tradeoff", "draw"),
    "vessel.png": ("vessel", "draw"),
    "view.pvsm": ("view", "write"),
    "lumen3d.png": ("lumen3d", "draw"),
}
ON_REQUEST = {"animation.gif": ("vessel", "animate")}
VECTORS = ("growth.pdf", "lumen.pdf", "section.pdf")  # beside the pictures of these names
IN_SPACE = {"vessel.png": "tissue.pvd", "lumen3d.png": "lumen.pvd"}  # and what they are drawn from
DEBIANS_PYTHON = "/usr/bin/python3"


def obstacle():
    """What keeps every picture from being drawn: the first module that is missing, or that cannot be imported."""
    for module, package in PACKAGES.items():
        try:
            importlib.import_module(module)
        except ModuleNotFoundError as error:
            if error.name != module:
                return f"{module} cannot be imported ({error})"
            if Path(sys.executable).resolve() != Path(DEBIANS_PYTHON).resolve():
                return f"{sys.executable} has no module {module}"
            return f"install the package {package} ({error})"
        except Exception as error:  # of another version, or not whole
            return f"{module} cannot be imported ({error})"
    return None


def draw(folder, name):
    """Draws a picture of the folder."""
    import matplotlib

    matplotlib.use("Agg")
    matplotlib.rcdefaults()  # whatever the user has set for other figures
    matplotlib.rcParams["text.parse_math"] = False  # names are text, whatever is in them
    module, function = {**PICTURES, **ON_REQUEST}[name]
    getattr(importlib.import_module(module), function)(folder, folder / name)


def draw_in_space(folder, name):
    """Draws a picture in space in a process of its own: where graphics are broken, rendering can end its process."""
    import virtual_display

    command = [sys.executable, "-I", "-B", "-X", "utf8", str(Path(__file__).parent), str(folder), name]
    problem = "there is no display; install the package xvfb"
    for environment in virtual_display.environments():
        with environment as variables:
            if variables is None:
                problem = "the virtual display of the package xvfb does not start"
                continue
            status = subprocess.run(command, check=False, env=variables).returncode
        if status == 0:
            return None
        problem = f"the rendering process ended with status {status}"
    return problem


def draw_all(folder):
    """Draws every picture; returns what went wrong, one line for each picture that was not drawn."""
    problems = []
    drawn = []
    for name in PICTURES:
        if name in IN_SPACE and not (folder / IN_SPACE[name]).exists():
            continue
        try:
            problem = (draw_in_space if name in IN_SPACE else draw)(folder, name)
        except NothingToDraw as reason:
            print(f"{name}: {reason}")
            continue
        except Exception as error:
            traceback.print_exc()
            problem = f"{type(error).__name__}: {error}"
        if problem:
            problems.append(f"{name}: {problem}")
        else:
            drawn.append(name)
    if not drawn and not problems:
        problems.append(f"{folder} holds no results to draw")
    return problems


def write_page(folder):
    """Writes report.html, where there is a run to write of; returns what went wrong."""
    try:
        report.write(folder, folder / "report.html")
    except NothingToDraw as reason:
        print(f"report.html: {reason}")
    except Exception as error:
        traceback.print_exc()
        return [f"report.html: {type(error).__name__}: {error}"]
    return []


def write_animation(folder):
    """Writes animation.gif; returns the exit status."""
    problem = obstacle() or draw_in_space(folder, "animation.gif")
    if problem:
        print(f"animation.gif: {problem}", file=sys.stderr)
    return 1 if problem else 0


def write_page_of(folders, path):
    """Writes a page of one run, or of several and of studies; returns the exit status."""
    try:
        if len(folders) == 1 and not report.is_study(folders[0]):
            report.write(folders[0], path)
        else:
            report.write_comparison(folders, path)
    except NothingToDraw as reason:
        print(reason, file=sys.stderr)
        return 1
    return 0


def main():
    if len(sys.argv) > 3 and sys.argv[1] == "--page":
        return write_page_of([Path(folder) for folder in sys.argv[3:]], Path(sys.argv[2]))
    if len(sys.argv) == 3 and sys.argv[1] == "--animation":
        return write_animation(Path(sys.argv[2]))
    if len(sys.argv) not in (2, 3):
        print("usage: figures RESULTS [PICTURE]", file=sys.stderr)
        return 2
    folder = Path(sys.argv[1])
    if len(sys.argv) == 3:
        draw(folder, sys.argv[2])
        return 0
    for name in (*PICTURES, *VECTORS):
        (folder / name).unlink(missing_ok=True)  # of an earlier state
    missing = obstacle()
    problems = [missing] if missing else draw_all(folder)
    problems += write_page(folder)
    if problems:
        sys.stdout.flush()  # so that in a log of both this is the last line
        print("; ".join(problems).replace("\n", " "), file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
