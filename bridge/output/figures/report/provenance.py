"""Where a run comes from: [(what, value)]."""

import itertools
import re

LOG_HEAD = 4000  # bytes of a log in which OpenFOAM names its version


def open_foam(folder):
    """The version in a log of the run's OpenFOAM cases; None where there is none."""
    for log in itertools.islice((folder / "flow").glob("*/log.*"), 20):
        with open(log, "rb") as file:
            head = file.read(LOG_HEAD).decode("utf-8", "replace")
        build = re.search(r"^Build\s*:\s*(.+?)\s*$", head, re.MULTILINE)
        if build:
            return build[1]
    return None


def of(run):
    summary, made = run.summary, run.summary.get("provenance") or {}
    flow = summary.get("flow", {})
    threads, ranks = summary.get("threads"), summary.get("ranks")
    lines = [
        ("command", made.get("command")),
        ("folder", made.get("workingFolder")),
        ("program", f"restenosisFoam {summary['version']}" if "version" in summary else None),
        ("host", made.get("host")),
        ("started", made.get("started")),
        ("ended", made.get("ended")),
        ("threads", f"{threads}, and {ranks} process{'es' * (ranks != 1)} for the flow" if threads and ranks else threads),
        ("flow", flow.get("backend")),
        ("OpenFOAM", open_foam(run.folder)),
        ("seed", summary.get("seed")),
        ("scene fingerprint", summary.get("sceneFingerprint")),
        ("state digest", summary.get("stateDigest")),
    ]
    return [(what, value) for what, value in lines if value not in (None, "")]
