#!/usr/bin/env python3
"""Writes tables and pictures of the figures that the measuring program (bench/measure/measure.cpp) prints.

usage: measure.py --program build/release/bin/measure --out docs/measurements --kept FOLDER [--records RECORD...] --garments MARKER...

Inserts the tables into the pages that have a place for them (PAGES), between `<!-- table: NAME -->` and `<!-- end -->`, and
writes the pictures next to the pages.  The program's output is kept in FOLDER; output of an earlier run is used again.
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


PAGES = ["trade.md", "growth.md"]


def output_of(arguments, what, markers, name=None):
    """The output of the program, taken from an earlier run if there is one; otherwise kept for the next."""
    kept = arguments.kept / (name or f"{what}.csv")
    if not kept.exists():
        done = subprocess.run([arguments.program, what, *markers], check=True, capture_output=True, text=True)
        kept.write_text(done.stdout)
    return kept.read_text()


def rows_of(arguments, what, markers, name=None):
    rows = list(csv.DictReader(io.StringIO(output_of(arguments, what, markers, name))))
    assert all(row.get("valid", "valid") == "valid" for row in rows)
    return rows


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows]) + "\n"


def put(arguments, name, text):
    """Inserts a table into the page that has a placeholder for it."""
    begin, end = f"<!-- table: {name} -->\n", "<!-- end -->"
    for page in (arguments.out / p for p in PAGES):
        before, found, rest = page.read_text().partition(begin)
        if found:
            page.write_text(before + begin + "\n" + text + "\n" + end + rest.partition(end)[2])
            return
    raise SystemExit(f"no page has a place for the table '{name}'")


def save(figure, path):
    figure.tight_layout()
    figure.savefig(path, metadata={"Date": None})
    pyplot.close(figure)


PRESETS = ["draft", "standard", "fine without tilts", "fine"]
TIME_NOISE, LENGTH_NOISE = 0.1, 1e-5  # relative differences below these count as noise
TILTING = {"tilt step", "tilts"}
MEAN = "all"


def compared_with_standard(rows):
    """For every setting, (time, length) divided by those of `standard`: by marker, and the geometric mean of all markers."""
    standard = {r["marker"]: r for r in rows if (r["setting"], r["value"]) == ("accuracy", "standard")}
    points = {}
    for row in rows:
        base = standard[row["marker"]]
        pair = (float(row["ms"]) / float(base["ms"]), float(row["ratio"]) / float(base["ratio"]))
        points.setdefault((row["setting"], row["value"]), {})[row["marker"]] = pair
    for of_marker in points.values():
        # A setting without results for some markers has no comparable mean.
        if len(of_marker) == len(standard):
            of_marker[MEAN] = tuple(map(statistics.geometric_mean, zip(*of_marker.values())))
    return points


def better(one, other):
    """True when, beyond noise, one setting is faster and not longer than the other, or shorter and not slower."""
    faster = one[0] < other[0] * (1 - TIME_NOISE) and one[1] <= other[1] + LENGTH_NOISE / 10
    shorter = one[1] < other[1] - LENGTH_NOISE and one[0] <= other[0]
    return faster or shorter


def rivals(points, preset, marker):
    """The settings that are better than a preset, the fastest first.  Settings that tilt count only if the preset tilts."""
    own = points["accuracy", preset][marker]
    found = [(p[marker][0], f"{k} {v}") for (k, v), p in points.items()
             if k != "accuracy" and marker in p and better(p[marker], own)
             and (preset == "fine" or k not in TILTING)]
    return [name for _, name in sorted(found)]


def fronts(arguments, sets):
    """Which presets are on the Pareto front of all settings: for the mean of each set, and for the longest marker."""
    columns = [(f"{name}, mean", points, MEAN) for name, points in sets.items()]
    longest = "jeans_22g"
    columns += [(longest, points, longest) for points in sets.values() if longest in points["accuracy", "standard"]]
    body = []
    for preset in PRESETS:
        found = [rivals(points, preset, marker) for _, points, marker in columns]
        body.append([preset] + ["on the front" if not f else "behind " + ", ".join(f[:3]) for f in found])
    put(arguments, "fronts", table(["preset", *(name for name, _, _ in columns)], body))


def in_order(settings):
    """The settings grouped by name, with numeric values in ascending order."""
    values = {}
    for name, value in settings:
        values.setdefault(name, {})[value] = None
    for name, own in values.items():
        try:
            values[name] = sorted(own, key=float)
        except ValueError:
            pass
    return [(name, value) for name, own in values.items() for value in own]


def percent(length):
    return f"{100 * (length - 1):+.4f} %"


def settings_tables(arguments, sets):
    """For every value of a setting: time and length compared with `standard`, the geometric mean of each set of markers."""
    of_set = {name: compared_with_standard(rows) for name, rows in sets.items()}
    settings = in_order(key for points in of_set.values() for key in points)
    head = ["setting", "value"]
    for name in sets:
        head += [f"{name}: time / standard", "length compared with standard", "worst marker"]
    body = []
    for key in settings:
        cells = []
        for points in of_set.values():
            own = points.get(key, {})
            if MEAN in own:
                time, length = own[MEAN]
                cells += [f"{time:.2f}", percent(length), percent(max(p[1] for p in own.values()))]
            else:
                cells += ["", "", ""]
        body.append([*key, *cells])
    put(arguments, "settings", table(head, body))
    names = [k for k in dict.fromkeys(k for k, _ in settings) if k != "accuracy"]
    figure, axes = pyplot.subplots(3, math.ceil(len(names) / 3), figsize=(16, 10))
    for axis, setting in zip(axes.flat, names):
        for (name, points), line in zip(of_set.items(), ("o-", "s--")):
            own = [(v, points[k, v][MEAN]) for k, v in settings if k == setting and MEAN in points.get((k, v), {})]
            if not own:
                continue
            axis.plot([p[0] for _, p in own], [100 * (p[1] - 1) for _, p in own], line, linewidth=0.7, label=name)
            for value, (time, length) in own:
                axis.annotate(value, (time, 100 * (length - 1)), fontsize=7)
        axis.set(title=setting, xscale="log", xlabel="time / standard", ylabel="length compared with standard, %")
        axis.legend(fontsize=7)
    for axis in axes.flat[len(names):]:
        axis.remove()
    save(figure, arguments.out / "pictures" / "trade-settings.svg")
    front_picture(arguments, of_set)
    fronts(arguments, of_set)
    body = []
    for rows in sets.values():
        at = {(r["marker"], r["value"]): r for r in rows if r["setting"] == "accuracy"}
        for m in dict.fromkeys(r["marker"] for r in rows):
            body.append([m] + [f"{float(at[m, p]['ms']):.1f} ms, {float(at[m, p]['ratio']):.6f}" for p in PRESETS]
                        + [f"{100 * (float(at[m, p]['ratio']) / float(at[m, 'standard']['ratio']) - 1):+.3f} %"
                           for p in ("draft", "fine")])
    put(arguments, "presets", table(["marker", *PRESETS, "draft compared with standard", "fine compared with standard"], body))


def front_picture(arguments, of_set):
    """Draws all settings that were measured, and marks the presets among them."""
    figure, axes = pyplot.subplots(1, len(of_set), figsize=(6.5 * len(of_set), 4.8), squeeze=False)
    for axis, (name, points) in zip(axes.flat, of_set.items()):
        mean = {key: p[MEAN] for key, p in points.items() if MEAN in p}
        for marks, chosen in (("o", False), ("*", True)):
            own = [(v, p) for (k, v), p in mean.items() if (k == "accuracy") == chosen]
            axis.plot([p[0] for _, p in own], [100 * (p[1] - 1) for _, p in own], marks, markersize=10 if chosen else 3)
            for value, (time, length) in own if chosen else []:
                axis.annotate(value, (time, 100 * (length - 1)))
        axis.set(title=name, xscale="log", xlabel="time / standard", ylabel="length compared with standard, %")
    save(figure, arguments.out / "pictures" / "trade-front.svg")


def digitised(arguments, rows):
    """The effect of simplification on pieces with many vertices, compared with no simplification."""
    body = []
    for row in rows:
        base = next(r for r in rows if (r["marker"], r["pitch"], r["simplification"]) == (row["marker"], row["pitch"], "0"))
        part = lambda key: f"{float(row[key]):.1f} ms ({float(row[key]) / float(base[key]):.2f})"
        body.append([row["marker"], row["vertices"], row["simplification"], part("cold"), part("warm"), row["sums"],
                     percent(float(row["ratio"]) / float(base["ratio"]))])
    put(arguments, "digitised",
        table(["marker", "vertices per shape", "simplification", "cold", "warm", "sums", "length compared with none"], body))


def anytime(arguments, rows):
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
    put(arguments, "anytime", table(["deadline, ms", "standard", "fine"], body))


def searched(arguments, rows):
    ratio = {(r["marker"], r["accuracy"], r["deadline"]): float(r["ratio"]) for r in rows}
    markers = dict.fromkeys(m for m, _, _ in ratio)
    deadlines = list(dict.fromkeys(d for _, a, d in ratio if a == "fine"))
    standard = {m: next(v for (n, a, _), v in ratio.items() if (n, a) == (m, "standard")) for m in markers}
    shorter = lambda m, d: f"{100 * (1 - ratio[m, 'fine', d] / standard[m]):.2f} %"
    head = ["marker", *(f"{int(d) // 1000} s" for d in deadlines)]
    put(arguments, "searched", table(head, [[m, *(shorter(m, d) for d in deadlines)] for m in markers]))


def exponent(rows, key):
    """The slope of the least squares line through (log of pieces, log of time)."""
    points = [(math.log(float(r["pieces"])), math.log(max(float(r[key]), 1e-3))) for r in rows]
    return statistics.linear_regression(*zip(*points)).slope if hasattr(statistics, "linear_regression") else None


def growth(arguments, rows):
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
        for label, part in (("exponent", own), ("from 1,600 on", [r for r in own if int(r["pieces"]) >= 1600])):
            body.append([tile, label, *(f"{exponent(part, s):.2f}" for s in stages), "", "", ""])
    save(figure, arguments.out / "pictures" / "growth.svg")
    head = ["tile", "pieces", "all, ms", "sums", "rows", "solve", "verify", "programs", "after / before", "MB"]
    put(arguments, "growth", table(head, body))


def scene(arguments, rows):
    head = ["motion", "pieces", "ms, cold", "programs", "variables", "rows", "nonzeros", "sums requested"]
    body = [[r["motion"], r["pieces"], f"{float(r['ms']):.2f}", r["programs"], r["variables"], r["rows"], r["nonzeros"],
             r["sums"]] for r in sorted(rows, key=lambda r: (r["motion"], int(r["pieces"])))]
    put(arguments, "scene", table(head, body))
    naive(arguments, rows)


def naive(arguments, rows):
    """The time of the naive model divided by that of ours."""
    time = {(r["motion"], r["pieces"]): float(r["ms"]) for r in rows}
    whole = ", whole"
    motions = dict.fromkeys(m.removesuffix(whole) for m, _ in time if m.endswith(whole))
    sizes = [p for p in dict.fromkeys(p for _, p in time) if (next(iter(motions)) + whole, p) in time]
    body = [[m, *(f"{time[m + whole, p] / time[m, p]:.1f}" for p in sizes)] for m in motions]
    put(arguments, "naive", table(["motion", *(f"{p} pieces" for p in sizes)], body))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True)
    parser.add_argument("--out", type=pathlib.Path, required=True)
    parser.add_argument("--kept", type=pathlib.Path, required=True)
    parser.add_argument("--garments", nargs="+", required=True)
    parser.add_argument("--records", nargs="*", default=[])
    arguments = parser.parse_args()
    arguments.kept.mkdir(parents=True, exist_ok=True)
    named = {pathlib.Path(m).stem: m for m in arguments.garments}
    sets = {"garments": rows_of(arguments, "settings", arguments.garments)}
    if arguments.records:
        sets["records"] = rows_of(arguments, "settings", arguments.records, "settings-records.csv")
    settings_tables(arguments, sets)
    digitised(arguments, rows_of(arguments, "digitised", [named["jeans_06g"], named["simon_06g"]]))
    anytime(arguments, rows_of(arguments, "anytime", [named["jeans_22g"]]))
    searched(arguments, rows_of(arguments, "searched", arguments.garments))
    scene(arguments, rows_of(arguments, "scene", [named["jeans_06g"]]))
    # Each tile is measured in a separate process, because the reported memory is the peak of the process.
    tiles = ["jeans_02g", "jeans_06g"]
    growth(arguments, [row for t in tiles for row in rows_of(arguments, "growth", [named[t]], f"growth-{t}.csv")])
    put(arguments, "cores", output_of(arguments, "cores", [named["jeans_06g"], named["jeans_22g"]], "cores.md"))


if __name__ == "__main__":
    main()
