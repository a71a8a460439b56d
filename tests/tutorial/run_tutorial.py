#!/usr/bin/env python3
"""Runs every block of docs/tutorial.md with a new daemon.

usage: run_tutorial.py SELVAGED SELVAGE

The Python blocks share one interpreter, the shell blocks one shell; where the page names the address of a daemon, the
test's own takes its place.
"""
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
ADDRESS = "127.0.0.1:7171"


def blocks(page, language):
    return re.findall(rf"^```{language}\n(.*?)^```$", page, re.MULTILINE | re.DOTALL)


def start(selvaged, folder):
    ports = folder / "ports"
    daemon = subprocess.Popen([selvaged, "--listen", "127.0.0.1:0", "--port-file", ports, "--log-level", "off"],
                              stdout=subprocess.DEVNULL)
    while not ports.exists() or not ports.read_text():
        if daemon.poll() is not None:
            raise SystemExit("selvaged ended before it listened")
        time.sleep(0.01)
    return daemon, ports.read_text().split()[0]


def main():
    selvaged, selvage = (str(pathlib.Path(program).resolve()) for program in sys.argv[1:])
    page = (ROOT / "docs" / "tutorial.md").read_text("utf-8")
    python, shell = blocks(page, "python"), blocks(page, "sh")
    if len(python) < 9 or len(shell) < 3:
        raise SystemExit(f"the tutorial has only {len(python)} Python and {len(shell)} shell blocks")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "examples").symlink_to(ROOT / "examples")  # the shell blocks run in the folder of the repository
        daemon, port = start(selvaged, folder)
        try:
            own = f"127.0.0.1:{port}"
            names = {}
            for block in python:
                block = block.replace(ADDRESS, own).replace("    width=100,\n", f'    width=100,\n    address="{own}",\n')
                exec(compile(block, "docs/tutorial.md", "exec"), names)
            script = "set -euo pipefail\n" + "\n".join(shell).replace("localhost:7171", own)
            done = subprocess.run(["bash", "-c", script], cwd=folder, capture_output=True, text=True,
                                  env={**os.environ, "PATH": f"{pathlib.Path(selvage).parent}:{os.environ['PATH']}"})
            print(done.stdout[:4000])
            if done.returncode != 0:
                raise SystemExit(f"a shell block failed:\n{done.stderr}")
            drawing = json.loads((folder / "answer.json").read_text())["result"]["marker"]
            assert drawing.startswith("<svg"), drawing[:80]
            assert '"field":"/markerId"' in done.stdout or "required" in done.stdout, "the error names no field"
        finally:
            daemon.terminate()
            daemon.wait()


if __name__ == "__main__":
    main()
