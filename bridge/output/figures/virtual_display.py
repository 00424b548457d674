"""VTK renders through X; without a display it gets a virtual one."""

import contextlib
import os
import shutil
import subprocess


class NoDisplay(Exception):
    """There is no display, and none can be made."""


@contextlib.contextmanager
def environment():
    """Yields the environment of a process that draws; a display made for it ends with the block."""
    if os.environ.get("DISPLAY"):
        yield dict(os.environ)
        return
    if shutil.which("Xvfb") is None:
        raise NoDisplay("there is no display; install the package xvfb")
    # The server chooses its number itself: runs that end at the same time do not take each other's
    reading, writing = os.pipe()
    command = ["Xvfb", "-displayfd", str(writing), "-screen", "0", "1280x1024x24", "-nolisten", "tcp"]
    server = subprocess.Popen(command, pass_fds=[writing], stderr=subprocess.DEVNULL)
    os.close(writing)
    try:
        with os.fdopen(reading) as pipe:
            number = pipe.readline().strip()
        if not number:
            raise NoDisplay("the virtual display of the package xvfb does not start")
        yield {**os.environ, "DISPLAY": f":{number}"}
    finally:
        server.terminate()
        server.wait()
