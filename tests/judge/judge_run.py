#!/usr/bin/env python3
"""Runs a test program that saves its layouts, and checks every one of them (judge_layout.py).

usage: judge_run.py PROGRAM [ARGUMENT...]

The program saves layouts as placed outlines in the folder given by the environment variable SELVAGE_OUTLINES.
Exit status 1 when the program fails, saves no layout, or saves one that is not valid.
"""
import os
import pathlib
import subprocess
import sys
import tempfile

from judge_layout import violations, read


def main():
    with tempfile.TemporaryDirectory() as folder:
        run = subprocess.run(sys.argv[1:], env={**os.environ, "SELVAGE_OUTLINES": folder}, check=False)
        layouts = sorted(pathlib.Path(folder).glob("*.json"))
        invalid = 0
        for path in layouts:
            found = list(violations(read(path)))
            invalid += bool(found)
            for violation in found:
                print(f"{path.stem}: {violation}")
        print(f"{len(layouts)} layouts checked, {invalid} not valid; the program's exit status is {run.returncode}")
    sys.exit(0 if layouts and invalid == 0 and run.returncode == 0 else 1)


if __name__ == "__main__":
    main()
