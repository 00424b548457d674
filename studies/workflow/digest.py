#!/usr/bin/python3
"""Prints the digest of a run's final state. Usage: digest.py FOLDER"""
import json
import sys
from pathlib import Path

from study import ENDED

summary = json.loads((Path(sys.argv[1]) / "summary.json").read_text())
if summary["status"] not in ENDED:
    sys.exit(f"{sys.argv[1]}: the run has not ended: {summary['status']}")
print(summary["stateDigest"])
