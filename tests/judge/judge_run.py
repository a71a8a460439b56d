#!/usr/bin/env python3
"""Runs a test program that keeps its layouts, and judges every one of them (judge_layout.py).

usage: judge_run.py PROGRAM [ARGUMENT...]

The program finds the folder to keep them in, as placed outlines, in SELVAGE_OUTLINES.
Exit status 1 when it fails, keeps nothing, or keeps a layout that is not valid.
"""
import os
import pathlib
import subprocess
import sys
import tempfile

from judge_layout import offences, read


def main():
    with tempfile.TemporaryDirectory() as folder:
        run = subprocess.run(sys.argv[1:], env={**os.environ, "SELVAGE_OUTLINES": folder}, stdout=subprocess.DEVNULL, check=False)
        layouts = sorted(pathlib.Path(folder).glob("*.json"))
        guilty = 0
        for path in layouts:
            found = list(offences(read(path)))
            guilty += bool(found)
            for offence in found:
                print(f"{path.stem}: {offence}")
        print(f"{len(layouts)} layouts judged, {guilty} not valid; the program ended with {run.returncode}")
    sys.exit(0 if layouts and guilty == 0 and run.returncode == 0 else 1)


if __name__ == "__main__":
    main()
