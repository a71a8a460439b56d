#!/usr/bin/env python3
"""Writes the tables and pictures of docs/from-the-library.md.

usage: page.py --programs BUILD/bin --kept FOLDER --page docs/from-the-library.md --data SELVAGE_DATA [--seconds S]

The stored markers are made first, and kept in the folder: garments nested from nothing with 60,000 moves, and the jeans of
SELVAGE_DATA/garments/jeans_06g_tight.json as they are; then accuracy fine.  Each line of the table may use S seconds of
processor time for its orders.  The orders are the same on every run, only their number and the times vary.
"""
import argparse
import pathlib
import re
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
NESTED = ("jeans_02g", "charlie_04g")
TIGHT = "jeans_06g"


def run(*words):
    return subprocess.run([str(word) for word in words], check=True, capture_output=True, text=True).stdout


def stored_markers(options):
    made = []
    selvage = options.programs / "selvage"
    for name in (TIGHT, *NESTED):
        path = options.kept / f"{name}.json"
        made.append(path)
        if path.exists():
            continue
        start = options.data / "garments" / f"{name}_tight.json"
        if name in NESTED:
            start = options.kept / f"{name}-nested.json"
            run(selvage, "nest", ROOT / "examples" / "markers" / f"{name}.json", "--from-scratch", "--moves", 60000,
                "--format", "native", "-o", start)
        run(selvage, "compact", start, "--accuracy", "fine", "--format", "native", "-o", path)
    return made


def replaced(page, name, text):
    begin, end = f"<!-- {name}: written by bench/remake/page.py -->\n", f"<!-- end of {name} -->"
    return re.sub(re.escape(begin) + ".*?" + re.escape(end), lambda _: begin + text + end, page, flags=re.DOTALL)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--programs", type=pathlib.Path, required=True)
    parser.add_argument("--kept", type=pathlib.Path, required=True)
    parser.add_argument("--page", type=pathlib.Path, required=True)
    parser.add_argument("--data", type=pathlib.Path, required=True)
    parser.add_argument("--seconds", type=float, default=20)
    options = parser.parse_args()
    options.kept.mkdir(parents=True, exist_ok=True)
    table = options.programs / "remake_table"
    stored = stored_markers(options)
    pictures = options.page.parent / "pictures" / "library"
    steps = run(table, "--steps", pictures, "--seed", 1, options.kept / "jeans_02g.json")
    figures = run(table, "--orders", 50, "--seconds", options.seconds, *stored)
    examples = ROOT / "examples" / "markers"
    matching = run(options.programs / "matching_table", examples / f"{TIGHT}.json", examples / "jeans_22g.json")
    page = options.page.read_text("utf-8")
    page = replaced(page, "steps", steps)
    page = replaced(page, "figures", figures)
    page = replaced(page, "matching", matching)
    options.page.write_text(page, "utf-8")


if __name__ == "__main__":
    main()
