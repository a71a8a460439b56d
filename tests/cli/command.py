"""Runs the command for the tests of this folder: the program is the first argument of each."""
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from decimal import Decimal

SELVAGE = sys.argv.pop(1)
MARKERS = pathlib.Path(__file__).parents[2] / "examples" / "markers"
PACKING = MARKERS.parent / "packing"
HIDES = MARKERS.parent / "hides"
PICTURES = MARKERS.parents[1] / "docs" / "pictures" / "packing"
OK, NOT_VALID, BAD_USAGE, BAD_INPUT, FILE, REFUSED, CANCELLED = 0, 1, 2, 3, 4, 5, 130

SQUARE = {"id": "square", "outline": [[0, 0], [40, 0], [40, 40], [0, 40]]}


def squares(*places):
    pieces = [{"id": f"p{i}", "shape": "square", "at": list(at)} for i, at in enumerate(places)]
    return {"format": "selvage-marker", "version": 1, "name": "squares", "strip": {"width": 100},
            "shapes": [dict(SQUARE)], "pieces": pieces}


def run(*arguments, text=None):
    return subprocess.run([SELVAGE, *map(str, arguments)], input=text, capture_output=True, text=True, timeout=300)


class CliTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def path(self, name):
        return pathlib.Path(self.folder.name) / name

    def write(self, document, name="in.json"):
        self.path(name).write_text(document if isinstance(document, str) else json.dumps(document))
        return self.path(name)

    def wait_until_sigint_is_handled(self, pid):
        bit = 1 << (signal.SIGINT - 1)
        while True:
            status = pathlib.Path(f"/proc/{pid}/status").read_text()
            blocked = int(next(s for s in status.splitlines() if s.startswith("SigBlk")).split()[1], 16)
            if blocked & bit:
                return
            time.sleep(0.001)
