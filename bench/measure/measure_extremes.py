#!/usr/bin/env python3
"""Writes docs/measurements-extremes.md anew: the words of bench/measure/extremes_page.md, the figures of a run of extremes_test.

usage: measure_extremes.py --programs build/release/bin --out docs --kept FOLDER

Every figure is one line of the test's (tests/extremes/reached.h), by the names of test and figure:
    [[TEST: FIGURE]]   or with a format   [[TEST: FIGURE %.2f]]
and {NAME} is the rest of a table's row: of a piece, of a kind of linear program, of so many teeth.  A figure that the page
wants and the run has not, or the other way round, is an error.  With lines kept from an earlier run, none is made.
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
    """{"TEST: FIGURE": value}, of the test, of its layouts before the judge, and of the benchmark of toothed pieces."""
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
        key = what if "/" in name else f"{name}: {what}"  # a piece's figures begin with its own name
        assert key not in figures, f"reached twice: {key}"
        figures[key] = value
    sums = subprocess.run([programs / "toothed_benchmark", "--benchmark_format=json",
                           f"--benchmark_filter=/({'|'.join(map(str, TEETH))})$"], check=True, capture_output=True, text=True)
    for made in json.loads(sums.stdout)["benchmarks"]:
        if made["run_type"] == "iteration":
            figures[f"{made['name']}: ms"] = made["cpu_time"]
    return figures


class Page:
    """Fills figures into words, and remembers which."""

    def __init__(self, figures):
        self.figures = figures
        self.told = set()

    def figure(self, key, form=""):
        self.told.add(key)
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

    def filled(self, words):
        words = re.sub(r"\[\[([^\]]+?)(?: %([^\]]+))?\]\]", lambda at: self.figure(at[1], at[2] or ""), words)
        return re.sub(r"\{([^}]+)\}", lambda at: self.row(at[1]), words)


def picture(figures, path):
    figure, (exact, slow) = pyplot.subplots(1, 2, figsize=(12, 4.6))
    programs = [key.split(":")[0] for key in figures if key.endswith(": duality gap")]
    names = [re.sub(r"(?<!^)(?=[A-Z])", " ", program).lower() for program in programs]
    least = 1e-17  # what is zero is drawn there
    for lack, mark in zip(LACKS, "o^sx"):
        exact.plot([max(float(figures[f"{p}: {lack}"]), least) for p in programs], names, mark, label=lack)
    exact.set(xscale="log", title="linear programs: off by (1e-17: 0)")
    exact.legend(fontsize=7, loc="lower right")
    for pair in TOOTHED:
        slow.plot(TEETH, [figures[f"{pair}/{n}: ms"] for n in TEETH], "o-", label=pair.replace("/", ", ").replace("_", " "))
    slow.set(xscale="log", yscale="log", xlabel="teeth", ylabel="ms", title="sums of two pieces of many star parts")
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
    filled = page.filled((HERE / "extremes_page.md").read_text())
    untold = sorted(page.figures.keys() - page.told)
    assert not untold, f"reached, and not on the page: {untold}"
    (arguments.out / "measurements-extremes.md").write_text(filled)
    picture(page.figures, arguments.out / "pictures" / "extremes.svg")
    print(filled)


if __name__ == "__main__":
    main()
