#!/usr/bin/env python3
"""Files of the trade, from pattern to cutter: each is read, compacted and written in every format.

usage: trade_table.py --selvage PROGRAM [--kept DIR] FILE...

Prints a table in Markdown: pieces, shapes, notes, and processor seconds of reading, of compacting and of writing.  A rule
table of the same name (.rul) next to a DXF makes its sizes.  --kept keeps what was written.
"""
import argparse
import json
import os
import pathlib
import resource
import subprocess
import sys
import tempfile

OUTPUTS = ("dxf", "cut", "plt", "pdf", "svg", "xml")


def run(*command):
    """Processor seconds, and what the command wrote to stderr; None for the seconds when it failed."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    ran = subprocess.run(command, capture_output=True, text=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return (seconds if ran.returncode == 0 else None), ran


def notes_in(text):
    shown = sum(line.startswith("note: ") and not line.startswith("note: and ") for line in text.splitlines())
    more = [line for line in text.splitlines() if line.startswith("note: and ")]
    return shown + (int(more[0].split()[2]) if more else 0)


def row(selvage, path, kept):
    native, better = kept / (path.stem + ".json"), kept / (path.stem + ".compacted.json")
    command = [selvage, "convert", str(path), str(native)]
    rules = path.with_suffix(".rul")
    if path.suffix == ".dxf" and rules.exists():
        command += ["--rules", str(rules)]
    read, ran = run(*command)
    if read is None:
        return f"| {path.name} | refused: {ran.stderr.strip().splitlines()[-1]} | | | | | |"
    marker = json.loads(native.read_text())
    compacted, done = run(selvage, "compact", str(native), "-o", str(better), "--json")
    source, figures = better, "-"
    if compacted is None:
        source = native  # such as a production marker, whose pieces overlap on purpose
    else:
        result = json.loads(done.stdout.splitlines()[-1])
        figures = f"{result['length_before']:.1f} to {result['length_after']:.1f}"
    written = 0.0
    for suffix in OUTPUTS:
        seconds, ran_out = run(selvage, "convert", str(source), str(kept / f"{path.stem}.{suffix}"))
        if seconds is None:
            sys.exit(f"{path.name}: {suffix}: {ran_out.stderr}")
        written += seconds
    how = f"{compacted:.2f}" if compacted is not None else "refused: pieces overlap"
    return (f"| {path.name} | {len(marker['pieces'])} | {len(marker['shapes'])} | {notes_in(ran.stderr)} | {read:.3f} | {figures} | "
            f"{how} | {written:.2f} |")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--selvage", required=True)
    parser.add_argument("--kept")
    parser.add_argument("files", nargs="+")
    asked = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        kept = pathlib.Path(asked.kept or temporary)
        os.makedirs(kept, exist_ok=True)
        print("| file | pieces | shapes | notes | read, s | length, mm | compact, s | six formats written, s |")
        print("|---|---|---|---|---|---|---|---|")
        for name in asked.files:
            print(row(asked.selvage, pathlib.Path(name), kept), flush=True)


if __name__ == "__main__":
    main()
