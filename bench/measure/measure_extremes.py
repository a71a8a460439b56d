#!/usr/bin/env python3
"""Writes docs/measurements/extremes.md: the text of bench/measure/extremes_page.md.in with the figures of a run of extremes_test.

usage: measure_extremes.py --programs build/release/bin --out docs/measurements --kept FOLDER

A placeholder in the text names a test and one of the figures that it prints (tests/extremes/reached.h):
    [[TEST: FIGURE]]   or, with a format,   [[TEST: FIGURE %.2f]]
{NAME} stands for the rest of a table row: for a piece, a kind of linear program, or a number of teeth.  It is an error if
the text and the run do not have the same figures.  Figures kept from an earlier run are used again.
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

import matplotlib

matplotlib.use("Agg")
matplotlib.rcParams["svg.hashsalt"] = "selvage"
from matplotlib import pyplot  # noqa: E402

HERE = pathlib.Path(__file__).parent
JUDGE = HERE.parent / "tests" / "judge" / "judge_layout.py"
TEETH = [25, 50, 100, 200]
TOOTHED = ["saws/upside_down", "saws/alike", "combs/upside_down", "combs/alike"]
LACKS = ["row broken by", "price beyond its bound", "duality gap", "simplex and interior point apart"]


def processor_seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def run(programs):
    """{"TEST: FIGURE": value} from the test, from judging its layouts, and from the benchmark of toothed pieces."""
    figures = {}
    with tempfile.TemporaryDirectory() as folder:
        began = processor_seconds()
        test = subprocess.run([programs / "extremes_test"], env={**os.environ, "SELVAGE_OUTLINES": folder}, check=True,
                              capture_output=True, text=True)
        figures["run: processor seconds"] = processor_seconds() - began
        layouts = sorted(pathlib.Path(folder).glob("*.json"))
        began = processor_seconds()
        subprocess.run([sys.executable, JUDGE, *layouts], check=True, capture_output=True)
        figures["run: seconds of judging"] = processor_seconds() - began
        figures["run: layouts"] = len(layouts)
    for name, what, value in re.findall(r"^\| [^|]*?\.([^|]+) \| ([^|]+) \| ([^|]+) \|$", test.stdout, re.MULTILINE):
        key = what if "/" in name else f"{name}: {what}"  # the figures of a piece start with its name
        assert key not in figures, f"figure printed twice: {key}"
        figures[key] = value
    sums = subprocess.run([programs / "toothed_benchmark", "--benchmark_format=json",
                           f"--benchmark_filter=/({'|'.join(map(str, TEETH))})$"], check=True, capture_output=True, text=True)
    for made in json.loads(sums.stdout)["benchmarks"]:
        if made["run_type"] == "iteration":
            figures[f"{made['name']}: ms"] = made["cpu_time"]
    return figures


class Page:
    """Fills figures into a text and records which ones were used."""

    def __init__(self, figures):
        self.figures = figures
        self.used = set()

    def figure(self, key, form=""):
        self.used.add(key)
        value = self.figures[key]
        text = format(float(value), form) if form and float(value) else str(value)
        return re.sub(r"(?<=\d)e([+-])0*(?=\d)", lambda at: "e" + at[1].strip("+"), text)

    def row(self, name):
        if f"{name}: star parts" in self.figures:
            sums = [f"{name}: units off along the boundary of its sum with {other}" for other in ("itself", "a triangle")]
            cells = [self.figure(f"{name}: star parts")]
            cells += [self.figure(key, ".1e") if key in self.figures else "-" for key in sums]
            cells += [self.figure(f"{name}: after / before", ".6f"), self.figure(f"{name}: rounds")]
        elif name.endswith(" teeth"):
            keys = [f"{pair}/{name.removesuffix(' teeth')}: ms" for pair in TOOTHED]
            cells = [self.figure(key, ",.0f" if self.figures[key] > 100 else ".2g") for key in keys]
        else:
            cells = [self.figure(f"{name}: {lack}", ".1e") for lack in LACKS]
        return " | ".join(cells)

    def filled(self, text):
        text = re.sub(r"\[\[([^\]]+?)(?: %([^\]]+))?\]\]", lambda at: self.figure(at[1], at[2] or ""), text)
        return re.sub(r"\{([^}]+)\}", lambda at: self.row(at[1]), text)


def picture(figures, path):
    figure, (exact, slow) = pyplot.subplots(1, 2, figsize=(12, 4.6))
    programs = [key.split(":")[0] for key in figures if key.endswith(": duality gap")]
    names = [re.sub(r"(?<!^)(?=[A-Z])", " ", program).lower() for program in programs]
    least = 1e-17  # zeros are drawn here
    for lack, mark in zip(LACKS, "o^sx"):
        exact.plot([max(float(figures[f"{p}: {lack}"]), least) for p in programs], names, mark, label=lack)
    exact.set(xscale="log", title="linear programs: errors (1e-17 stands for 0)")
    exact.legend(fontsize=7, loc="lower right")
    for pair in TOOTHED:
        slow.plot(TEETH, [figures[f"{pair}/{n}: ms"] for n in TEETH], "o-", label=pair.replace("/", ", ").replace("_", " "))
    slow.set(xscale="log", yscale="log", xlabel="teeth", ylabel="ms", title="sums of two pieces with many star-shaped parts")
    slow.set_xticks(TEETH, TEETH)
    slow.minorticks_off()
    slow.legend(fontsize=7)
    figure.tight_layout()
    figure.savefig(path, metadata={"Date": None})


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in ("--programs", "--out", "--kept"):
        parser.add_argument(name, type=pathlib.Path, required=True)
    arguments = parser.parse_args()
    kept = arguments.kept / "extremes.json"
    if not kept.exists():
        arguments.kept.mkdir(parents=True, exist_ok=True)
        kept.write_text(json.dumps(run(arguments.programs.resolve()), indent=1))
    page = Page(json.loads(kept.read_text()))
    filled = page.filled((HERE / "extremes_page.md.in").read_text())
    unused = sorted(page.figures.keys() - page.used)
    assert not unused, f"figures that the page does not use: {unused}"
    (arguments.out / "extremes.md").write_text(filled)
    picture(page.figures, arguments.out / "pictures" / "extremes.svg")
    print(filled)


if __name__ == "__main__":
    main()
