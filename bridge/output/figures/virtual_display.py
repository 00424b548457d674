"""VTK renders through X; without a display it gets a virtual one."""

import os
import shutil


def wrap(command):
    """The command with a display around it; None when there is neither a display nor xvfb-run."""
    if os.environ.get("DISPLAY"):
        return command
    if shutil.which("xvfb-run") is None:
        return None
    return ["xvfb-run", "-a", "-s", "-screen 0 1280x1024x24", *command]
