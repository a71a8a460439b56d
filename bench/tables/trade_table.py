#!/usr/bin/env python3
"""Files of the trade, from pattern to cutter: each is read, compacted and written in every format.

usage: trade_table.py --selvage PROGRAM [--kept DIR] FILE...

Prints two tables in Markdown.  For every file: who wrote it, pieces, shapes, notes, and processor seconds of reading, of
compacting and of writing.  A rule table of the same name (.rul) next to a DXF makes its sizes.  Cut files may overlap by
1.4 mm; other files with overlaps are separated first.  Then, for drawings with curves: vertices, time and length against
the tolerance of flattening.  --kept keeps what was written.
"""
import argparse
import json
import os
import pathlib
import re
import resource
import subprocess
import sys
import tempfile

OUTPUTS = ("dxf", "cut", "plt", "pdf", "svg", "xml")
TOLERANCES = (0.1, 0.05, 0.02, 0.01, 0.005, 0.002, 0.001)  # mm


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


def writer_of(path):
    named = re.search(r"^Author: *(\S.*?)\s*$", path.read_bytes().decode("latin-1"), re.MULTILINE | re.IGNORECASE)
    return named.group(1) if named else ""


def compacted(selvage, native, better, cut):
    """The source of what is written, how it was made, and the cells of the table."""
    treatments = [("", [])] + ([("with an allowance of 1.4 mm", ["--overlap", "1.4"])] if cut else [])
    for how, options in treatments:
        seconds, ran = run(selvage, "compact", str(native), "-o", str(better), "--json", *options)
        if seconds is not None:
            return better, json.loads(ran.stdout.splitlines()[-1]), seconds, how
    apart, ran = run(selvage, "separate", str(native), "-o", str(better), "--grow", "0.02", "--json")
    if apart is None:
        return native, None, 0, "refused: " + ran.stderr.strip().splitlines()[-1]
    seconds, ran = run(selvage, "compact", str(better), "-o", str(better), "--json")
    return better, json.loads(ran.stdout.splitlines()[-1]), apart + seconds, "separated first"


def row(selvage, path, kept):
    native, better = kept / (path.stem + ".json"), kept / (path.stem + ".compacted.json")
    command = [selvage, "convert", str(path), str(native)]
    rules = path.with_suffix(".rul")
    if path.suffix == ".dxf" and rules.exists():
        command += ["--rules", str(rules)]
    read, ran = run(*command)
    if read is None:
        return f"| {path.name} | {writer_of(path)} | refused: {ran.stderr.strip().splitlines()[-1]} | | | | | | |"
    marker = json.loads(native.read_text())
    source, result, seconds, how = compacted(selvage, native, better, path.suffix == ".cut")
    lengths = f"{result['length_before']:.1f} to {result['length_after']:.1f}" if result else ""
    written = 0.0
    for suffix in OUTPUTS:
        took, ran_out = run(selvage, "convert", str(source), str(kept / f"{path.stem}.{suffix}"))
        if took is None:
            sys.exit(f"{path.name}: {suffix}: {ran_out.stderr}")
        written += took
    return (f"| {path.name} | {writer_of(path)} | {len(marker['pieces'])} | {len(marker['shapes'])} | {notes_in(ran.stderr)} | {read:.3f} | "
            f"{', '.join(filter(None, (lengths, how)))} | {seconds:.2f} | {written:.2f} |")


def curve(selvage, path, kept):
    """Rows of the second table: what a tolerance costs in vertices and time, and brings in length."""
    for tolerance in TOLERANCES:
        native = kept / f"{path.stem}.{tolerance}.json"
        read, _ = run(selvage, "convert", str(path), str(native), "--tolerance", str(tolerance))
        seconds, ran = run(selvage, "compact", str(native), "--json")
        if read is None or seconds is None:
            continue
        vertices = sum(len(shape["outline"]) for shape in json.loads(native.read_text())["shapes"])
        result = json.loads(ran.stdout.splitlines()[-1])
        yield f"| {path.name} | {tolerance} | {vertices} | {read:.3f} | {seconds:.3f} | {100 * result['utilisation_after']:.3f} |"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--selvage", required=True)
    parser.add_argument("--kept")
    parser.add_argument("files", nargs="+")
    asked = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        kept = pathlib.Path(asked.kept or temporary)
        os.makedirs(kept, exist_ok=True)
        paths = [pathlib.Path(name) for name in asked.files]
        print("| file | writer | pieces | shapes | notes | read, s | length, mm | compact, s | six formats written, s |")
        print("|---|---|---|---|---|---|---|---|---|")
        for path in paths:
            print(row(asked.selvage, path, kept), flush=True)
        print("\n| drawing | tolerance, mm | vertices | read, s | compact, s | utilisation after, % |\n|---|---|---|---|---|---|")
        for path in (path for path in paths if path.suffix == ".svg"):
            for line in curve(asked.selvage, path, kept):
                print(line, flush=True)


if __name__ == "__main__":
    main()
