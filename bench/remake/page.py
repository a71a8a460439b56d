#!/usr/bin/env python3
"""Measures remaking, and writes the tables and pictures of the pages about it.

usage: page.py --programs BUILD/bin --kept FOLDER --page PAGE... --data SELVAGE_DATA [--seconds S]

What takes long is kept in the folder, so that the measurement can be interrupted and continued: the stored markers (made.py),
a line for every order that was remade, and the layouts of the other nester.  A run uses S seconds of processor time, for one
row of the table after the other; the orders are the same on every run.  Results of an older program must be deleted by hand.
"""
import argparse
import json
import pathlib
import re
import resource
import statistics
import subprocess

import made

ORDERS, BATCH = 50, 3  # of a row; of a batch
REFINED, REFINED_MIXES = 3, 12  # how many of each garment's orders are also refined, and of those of other size mixes
GARMENTS = ("jeans_06g", "simon_06g", "charlie_04g")
SPREAD = ("jeans_06g", "simon_06g", "charlie_04g", "jeans_02g", *(f"charlie_04g-mix-{seed}" for seed in made.MIXES),
          *(f"{garment}-mix-{seed}" for seed in made.SPREAD_MIXES for garment in GARMENTS))
# What is changed, by which part, in which stored markers, and how many arrangements are tried.
ROWS = (("graded", 0.02, GARMENTS, 1), ("graded", 0.04, GARMENTS, 1), ("graded", 0.08, GARMENTS, 1),
        ("reshaped", 0.01, GARMENTS, 1), ("reshaped", 0.03, GARMENTS, 1), ("counts", 0.1, GARMENTS, 1),
        ("mixed", 0, ("charlie_04g",), 5), ("mixed", 2, ("charlie_04g",), 5), ("larger", 0.02, SPREAD, 1))


class Results:
    """What is known of the orders of one row, by stored marker."""

    def __init__(self, options, change, part, garments, tries):
        self.options, self.change, self.part, self.garments, self.tries = options, change, part, garments, tries
        self.orders = {garment: self.kept_of(garment) for garment in garments}

    def path(self, garment):
        return self.options.kept / "orders" / f"{garment}-{self.change}-{self.part}.jsonl"

    def kept_of(self, garment):
        path = self.path(garment)
        return [json.loads(line) for line in path.read_text("utf-8").splitlines()] if path.exists() else []

    def all(self):
        return [order for orders in self.orders.values() for order in orders]

    def missing(self):
        """The marker that has the fewest orders; None when the row is complete.  The orders of `larger` are all alike."""
        garment = min(self.garments, key=lambda one: len(self.orders[one]))
        wanted = 1 if self.change == "larger" else -(-ORDERS // len(self.garments))
        return garment if len(self.orders[garment]) < wanted else None

    def add_batch(self):
        garment = self.missing()
        options, first = self.options, len(self.orders[garment]) + 1
        words = [options.programs / "remake_orders", "--change", self.change, "--part", self.part, "--first", first,
                 "--tries", self.tries, "--count", 1 if self.change == "larger" else BATCH]
        if first <= (REFINED_MIXES if self.change == "mixed" else REFINED):
            words.append("--fine")
        added = made.run(*words, *made.order_source(options, garment, self.change))
        self.path(garment).parent.mkdir(parents=True, exist_ok=True)
        with self.path(garment).open("a", encoding="utf-8") as file:
            file.write(added)
        self.orders[garment] += [json.loads(line) for line in added.splitlines()]

    def cells(self):
        orders = self.all()
        apart = [order for order in orders if order["made"]]
        fine = [100 * (order["stored"] - order["fine"]) for order in apart if "fine" in order]
        quick = [order["seconds"] for order in apart if is_quick(order)]
        by = [sum(way in order["steps"] for order in apart) for way in ("separated", "popped", "searched")]
        return (named(self.change, self.part), len(orders), f"{100 * len(apart) / len(orders):.0f} %",
                median(lost(apart)), median(fine) + (f" ({len(fine)})" if fine else ""),
                median([order["seconds"] for order in orders]), f"{len(quick)}, {median(quick)}",
                ", ".join(map(str, by)), "yes" if all(order["valid"] and order.get("fine_valid", True) for order in apart) else "NO")

    def losses(self):
        """The median loss of each garment."""
        return [median(lost([order for one, orders in self.orders.items() for order in orders
                             if order["made"] and one.startswith(garment)])) for garment in GARMENTS]


def named(change, part):
    if change == "mixed":
        return "other size mixes" + (f", {part} times the bundles" if part else "")
    return f"{change} {100 * part:g} %"


def is_quick(order):
    """Whether the first try was near enough, so that neither another one nor a search followed."""
    return order["tries"] == 1 and not {"searched", "rearranged", "trims_moved"} & set(order["steps"])


def lost(orders):
    return [100 * (order["stored"] - order["utilisation"]) for order in orders]


def median(values):
    return f"{statistics.median(values):.2f}" if values else "-"


def processor_seconds():
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime


def measure(options):
    results = [Results(options, *row) for row in ROWS]
    begin = processor_seconds()
    for row in results:
        while processor_seconds() - begin < options.seconds and row.missing():
            row.add_batch()
    return results


def table(headings, lines):
    text = [headings, ["---"] * len(headings), *lines]
    return "".join("| " + " | ".join(str(cell) for cell in line) + " |\n" for line in text)


def figures(results):
    headings = ("order", "orders", "came apart", "median loss", "after `fine` (orders)", "s", "first try near enough, s",
                "separated, popped, searched", "valid")
    return table(headings, [row.cells() for row in results if row.all()])


def losses(results):
    headings = ("median loss", *GARMENTS)
    return table(headings, [(named(row.change, row.part), *row.losses()) for row in results if row.all()])


def replaced(page, name, text):
    begin, end = f"<!-- {name}: written by bench/remake/page.py -->\n", f"<!-- end of {name} -->"
    return re.sub(re.escape(begin) + ".*?" + re.escape(end), lambda _: begin + text + end, page, flags=re.DOTALL)


def race(options):
    """Orders of sizes 4 % apart, beside a nester that begins with nothing and has 60 s."""
    lines = []
    for garment, seed in made.RACES:
        nested, order = made.nested_elsewhere(options, garment, seed), made.raced_order(options, garment, seed)
        if not nested or not order or not order["made"]:
            continue
        lines.append((garment, seed, f"{100 * order['stored']:.2f} %", f"{100 * order['utilisation']:.2f} %", f"{order['seconds']:.2f}",
                      f"{nested['density']:.2f} %" + ("" if nested["valid"] else " (overlaps)")))
    return table(("order of", "seed", "stored marker", "remade", "s", "spyrrow, 60 s"), lines) if lines else ""


def mixes(options):
    """Orders of other size mixes, beside the same orders nested from nothing."""
    kept = Results(options, "mixed", 0, ("charlie_04g",), 5).all()
    lines, behind = [], []
    for order in kept:
        nested = made.mix_from_nothing(options, order["seed"])
        if not nested or "fine" not in order:
            continue
        behind.append([100 * (nested["utilisation"] - order[when]) for when in ("utilisation", "fine")])
        lines.append((order["seed"], f"{100 * order['utilisation']:.2f} %", f"{order['seconds']:.2f}", f"{100 * order['fine']:.2f} %",
                      f"{order['fine_seconds']:.2f}", f"{100 * nested['utilisation']:.2f} %", f"{nested['seconds']:.1f}"))
    if not lines:
        return ""
    medians = [statistics.median(points) for points in zip(*behind)]
    near = [sum(point <= 1 for point in points) for points in zip(*behind)]
    summary = (f"\nRemade less nested, median: {-medians[0]:.2f} points, after `fine` {-medians[1]:.2f}; within a point or better: "
               f"{near[0]} and {near[1]} of {len(behind)}.\n")
    return table(("order", "remade", "s", "after `fine`", "s", "nested from nothing", "s"), lines) + summary


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--programs", type=pathlib.Path, required=True)
    parser.add_argument("--kept", type=pathlib.Path, required=True)
    parser.add_argument("--page", type=pathlib.Path, nargs="+", required=True, help="the first one has the pictures")
    parser.add_argument("--data", type=pathlib.Path, required=True)
    parser.add_argument("--seconds", type=float, default=600)
    parser.add_argument("--race", action="store_true", help="also run the other nester where its layouts are not kept")
    parser.add_argument("--mixes", type=int, default=0, help="nest this many orders of other size mixes from nothing, too")
    options = parser.parse_args()
    options.kept = options.kept.resolve()
    options.kept.mkdir(parents=True, exist_ok=True)
    results = measure(options)
    stored = made.stored_marker(options, "jeans_02g")
    pictures = options.page[0].parent / "pictures" / "library"
    steps = made.run(options.programs / "remake_steps", pictures, 1, stored, made.best_known(options))
    examples = made.EXAMPLES
    matching = made.run(options.programs / "matching_table", examples / "jeans_06g.json", examples / "jeans_22g.json")
    parts = (("steps", steps), ("figures", figures(results)), ("losses", losses(results)), ("mixes", mixes(options)),
             ("matching", matching), ("race", race(options)))
    for path in options.page:
        page = path.read_text("utf-8")
        for name, text in parts:
            page = replaced(page, name, text)
        path.write_text(page, "utf-8")


if __name__ == "__main__":
    main()
