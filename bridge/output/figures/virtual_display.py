"""VTK renders through X: through a virtual display where one can be made, else through the user's."""

import contextlib
import os
import shutil
import subprocess

# Settings for the user's own display, of which a virtual one knows nothing
FOR_OTHER_DISPLAYS = ("LIBGL_", "MESA_", "GALLIUM_", "__GLX_", "__EGL_", "__NV_", "VTK_", "QT_", "XAUTHORITY")


def environments():
    """The environments that a process may draw in, the most reliable first, each as a context; None for one that there
    is not after all."""
    if shutil.which("Xvfb"):
        yield virtual()
        yield virtual()  # another server that ended at the same time may have taken the first one's place away
    if os.environ.get("DISPLAY"):
        yield contextlib.nullcontext(dict(os.environ))


@contextlib.contextmanager
def virtual():
    """Yields the environment of a process that draws on a display that ends with the block."""
    # The server chooses its number itself: runs that end at the same time do not take each other's
    reading, writing = os.pipe()
    command = ["Xvfb", "-displayfd", str(writing), "-screen", "0", "1280x1024x24", "-nolisten", "tcp"]
    server = subprocess.Popen(command, pass_fds=[writing], stderr=subprocess.DEVNULL)
    os.close(writing)
    try:
        with os.fdopen(reading) as pipe:
            number = pipe.readline().strip()
        variables = {key: value for key, value in os.environ.items() if not key.startswith(FOR_OTHER_DISPLAYS)}
        yield {**variables, "DISPLAY": f":{number}"} if number else None
    finally:
        server.terminate()
        server.wait()
