#!/usr/bin/env python3
"""Tables and pictures of what the measuring program (bench/measure.cpp) counts.

usage: measure.py --program build/release/bin/measure --out docs [--kept FOLDER] MARKER...

Writes the tables into FOLDER as Markdown (knobs.md, anytime.md, scene.md, growth.md) beside the lines they come from, and
the pictures into docs/pictures.  With lines kept from an earlier run, measures only what is missing.
"""
import argparse
import csv
import io
import math
import pathlib
import statistics
import subprocess

import matplotlib

matplotlib.use("Agg")
matplotlib.rcParams["svg.hashsalt"] = "selvage"
from matplotlib import pyplot  # noqa: E402


def lines_of(arguments, what, markers):
    kept = arguments.kept / f"{what}.csv"
    if not kept.exists():
        done = subprocess.run([arguments.program, what, *markers], check=True, capture_output=True, text=True)
        kept.write_text(done.stdout)
    return list(csv.DictReader(io.StringIO(kept.read_text())))


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows]) + "\n"


def save(figure, path):
    figure.tight_layout()
    figure.savefig(path, metadata={"Date": None})
    pyplot.close(figure)


def knobs(arguments, rows):
    """Of every knob's value: time and length beside standard's, the geometric mean over the markers."""
    assert all(row["valid"] == "valid" for row in rows)
    standard = {r["marker"]: r for r in rows if (r["knob"], r["value"]) == ("accuracy", "standard")}
    points = {}
    for row in rows:
        base = standard[row["marker"]]
        pair = (float(row["ms"]) / float(base["ms"]), float(row["ratio"]) / float(base["ratio"]))
        points.setdefault(row["knob"], {}).setdefault(row["value"], []).append(pair)
    mean = {k: {v: [statistics.geometric_mean(axis) for axis in zip(*pairs)] for v, pairs in values.items()}
            for k, values in points.items()}
    body = [[k, v, f"{time:.2f}", f"{100 * (length - 1):+.4f} %", f"{100 * (max(p[1] for p in points[k][v]) - 1):+.4f} %"]
            for k, values in mean.items() for v, (time, length) in values.items()]
    (arguments.kept / "knobs.md").write_text(
        table(["knob", "value", "time / standard", "length beside standard", "worst marker"], body))
    names = [k for k in mean if k != "accuracy"]
    figure, axes = pyplot.subplots(2, math.ceil(len(names) / 2), figsize=(12, 7))
    for axis, knob in zip(axes.flat, names):
        times, lengths = zip(*mean[knob].values())
        axis.plot(times, [100 * (x - 1) for x in lengths], "o-", linewidth=0.7)
        for value, (time, length) in mean[knob].items():
            axis.annotate(value, (time, 100 * (length - 1)), fontsize=8)
        axis.set(title=knob, xscale="log", xlabel="time / standard", ylabel="length beside standard, %")
    save(figure, arguments.out / "pictures" / "trade-knobs.svg")
    presets = ["draft", "standard", "fine without tilts", "fine"]
    markers = list(standard)
    at = {(r["marker"], r["value"]): r for r in rows if r["knob"] == "accuracy"}
    body = [[m] + [f"{float(at[m, p]['ms']):.1f} ms, {float(at[m, p]['ratio']):.6f}" for p in presets]
            + [f"{100 * (float(at[m, 'draft']['ratio']) / float(at[m, 'standard']['ratio']) - 1):+.3f} %",
               f"{100 * (float(at[m, 'fine']['ratio']) / float(at[m, 'standard']['ratio']) - 1):+.3f} %"]
            for m in markers]
    (arguments.kept / "presets.md").write_text(
        table(["marker", *presets, "draft beside standard", "fine beside standard"], body))


def anytime(arguments, rows):
    assert all(row["valid"] == "valid" for row in rows)
    figure, axis = pyplot.subplots(figsize=(7, 4.5))
    for accuracy in ("standard", "fine"):
        own = [r for r in rows if r["accuracy"] == accuracy]
        axis.plot([float(r["ms"]) for r in own], [float(r["ratio"]) for r in own], "o-", label=accuracy)
    axis.set(xscale="log", xlabel="processor time, ms", ylabel="length after / before", title=rows[0]["marker"])
    axis.legend()
    save(figure, arguments.out / "pictures" / "trade-anytime.svg")
    at = {(r["accuracy"], r["deadline"]): r for r in rows}
    cell = lambda r: f"{float(r['ratio']):.6f} ({float(r['ms']):.0f} ms)"
    body = [[d, cell(at["standard", d]), cell(at["fine", d])] for d in dict.fromkeys(r["deadline"] for r in rows)]
    (arguments.kept / "anytime.md").write_text(table(["deadline, ms", "standard", "fine"], body))


def exponent(rows, key):
    """The slope of the least squares line through log time over log pieces."""
    points = [(math.log(float(r["pieces"])), math.log(max(float(r[key]), 1e-3))) for r in rows]
    return statistics.linear_regression(*zip(*points)).slope if hasattr(statistics, "linear_regression") else None


def growth(arguments, rows):
    assert all(row["valid"] == "valid" for row in rows)
    stages = ["ms", "sums", "rows", "solve", "verify"]
    figure, axes = pyplot.subplots(1, 2, figsize=(11, 4.5), squeeze=False)
    body = []
    for axis, tile in zip(axes.flat, dict.fromkeys(r["tile"] for r in rows)):
        own = [r for r in rows if r["tile"] == tile]
        for stage in stages:
            slope = exponent(own, stage)
            label = ("all" if stage == "ms" else stage) + f": {slope:.2f}"
            axis.plot([int(r["pieces"]) for r in own], [float(r[stage]) for r in own], "o-", label=label)
        axis.set(title=tile, xscale="log", yscale="log", xlabel="pieces", ylabel="ms")
        axis.legend(title="growth exponent")
        body += [[tile, r["pieces"], *(f"{float(r[s]):.1f}" for s in stages), r["programs"], f"{float(r['ratio']):.5f}",
                  r["megabytes"]] for r in own]
        body.append([tile, "exponent", *(f"{exponent(own, s):.2f}" for s in stages), "", "", ""])
    save(figure, arguments.out / "pictures" / "growth.svg")
    head = ["tile", "pieces", "all, ms", "sums", "rows", "solve", "verify", "programs", "after / before", "MB"]
    (arguments.kept / "growth.md").write_text(table(head, body))


def scene(arguments, rows):
    head = ["motion", "pieces", "ms, cold", "programs", "variables", "rows", "nonzeros", "sums asked for"]
    body = [[r["motion"], r["pieces"], f"{float(r['ms']):.2f}", r["programs"], r["variables"], r["rows"], r["nonzeros"],
             r["sums"]] for r in sorted(rows, key=lambda r: (r["motion"], int(r["pieces"])))]
    (arguments.kept / "scene.md").write_text(table(head, body))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True)
    parser.add_argument("--out", type=pathlib.Path, required=True)
    parser.add_argument("--kept", type=pathlib.Path, required=True)
    parser.add_argument("markers", nargs="+")
    arguments = parser.parse_args()
    arguments.kept.mkdir(parents=True, exist_ok=True)
    named = {pathlib.Path(m).stem: m for m in arguments.markers}
    knobs(arguments, lines_of(arguments, "knobs", arguments.markers))
    anytime(arguments, lines_of(arguments, "anytime", [named["jeans_22g"]]))
    scene(arguments, lines_of(arguments, "scene", [named["jeans_06g"]]))
    growth(arguments, lines_of(arguments, "growth", [named["jeans_02g"], named["jeans_06g"]]))
    for name in ("presets", "knobs", "anytime", "scene", "growth"):
        print((arguments.kept / f"{name}.md").read_text())


if __name__ == "__main__":
    main()
