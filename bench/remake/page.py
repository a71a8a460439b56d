#!/usr/bin/env python3
"""Measures remaking, and writes the tables and pictures of docs/from-the-library.md.

usage: page.py --programs BUILD/bin --kept FOLDER --page docs/from-the-library.md --data SELVAGE_DATA [--seconds S]

What takes long is kept in the folder, so that the measurement can be interrupted and continued: the stored markers (made.py),
a line for every order that was remade, and the layouts of the other nester.  A run uses S seconds of processor time for orders,
always for the row of the table that has had least; the orders are the same on every run.  Results of an older program must be
deleted by hand.
"""
import argparse
import json
import pathlib
import re
import resource
import statistics
import subprocess

import made

ORDERS, BATCH, REFINED = 50, 5, 5  # orders of a row; of a batch; how many of them are also refined
CHANGES = (("graded", 0.02), ("graded", 0.04), ("graded", 0.08), ("larger", 0.02), ("reshaped", 0.01), ("reshaped", 0.03),
           ("counts", 0.1))


def rows():
    for garment in ("jeans_06g", "jeans_02g"):
        for change, part in CHANGES:
            yield garment, change, part
    yield "simon_06g", "graded", 0.04
    yield "charlie_04g", "mixed", 0


def name_of(row):
    garment, change, part = row
    return f"{garment}-{change}" + (f"-{part}" if part else "")


class Results:
    """What is known of the orders of one row."""

    def __init__(self, options, row):
        self.options, self.row = options, row
        self.path = options.kept / "orders" / f"{name_of(row)}.jsonl"
        lines = self.path.read_text("utf-8").splitlines() if self.path.exists() else []
        self.orders = [json.loads(line) for line in lines]

    def wanted(self):
        # The pieces of `larger` are the same in every order.
        return BATCH if self.row[1] == "larger" else ORDERS

    def add_batch(self):
        garment, change, part = self.row
        options, first = self.options, len(self.orders) + 1
        words = [options.programs / "remake_orders", "--change", change, "--part", part, "--first", first, "--count", BATCH]
        if first <= REFINED:
            words.append("--fine")
        added = made.run(*words, *made.order_source(options, garment, change))
        self.path.parent.mkdir(parents=True, exist_ok=True)
        with self.path.open("a", encoding="utf-8") as file:
            file.write(added)
        self.orders += [json.loads(line) for line in added.splitlines()]

    def seconds(self):
        return sum(order["seconds"] + order.get("fine_seconds", 0) for order in self.orders)

    def cells(self):
        garment, change, part = self.row
        apart = [order for order in self.orders if order["made"]]
        lost = sorted(100 * (order["stored"] - order["utilisation"]) for order in apart)
        fine = [100 * (order["stored"] - order["fine"]) for order in apart if "fine" in order]
        by = [sum(order["removed_by"] == way for order in apart) for way in ("separated", "popped", "searched")]
        return (garment, f"{change} {100 * part:g} %" if part else change, len(self.orders),
                f"{100 * len(apart) / len(self.orders):.0f} %",
                f"{statistics.median(lost):.2f}" if lost else "-",
                f"{statistics.median(fine):.2f} ({len(fine)})" if fine else "-",
                f"{statistics.median(order['seconds'] for order in self.orders):.2f}", ", ".join(map(str, by)),
                "yes" if all(order["valid"] for order in apart) else "NO")


def processor_seconds():
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime


def measure(options):
    results = [Results(options, row) for row in rows()]
    for row in results:
        made.order_source(options, row.row[0], row.row[1])  # making stored markers does not count
    begin = processor_seconds()
    while processor_seconds() - begin < options.seconds:
        open_rows = [row for row in results if len(row.orders) < row.wanted()]
        if not open_rows:
            break
        min(open_rows, key=Results.seconds).add_batch()
    return results


def table(headings, lines):
    text = [headings, ["---"] * len(headings), *lines]
    return "".join("| " + " | ".join(str(cell) for cell in line) + " |\n" for line in text)


def figures(results):
    headings = ("stored", "order", "orders", "came apart", "median loss", "after `fine` (orders)", "s",
                "separated, popped, searched", "valid")
    return table(headings, [row.cells() for row in results if row.orders])


def replaced(page, name, text):
    begin, end = f"<!-- {name}: written by bench/remake/page.py -->\n", f"<!-- end of {name} -->"
    return re.sub(re.escape(begin) + ".*?" + re.escape(end), lambda _: begin + text + end, page, flags=re.DOTALL)


def race(options):
    """Orders of markers that were made with care, beside a nester that begins with nothing and has sixty times as long."""
    lines = []
    for garment, seed in made.RACES:
        nested = made.nested_elsewhere(options, garment, seed)
        kept = Results(options, (garment, "graded", 0.04)).orders
        remade = next((order for order in kept if order["seed"] == seed and order["made"]), None)
        if nested and remade:
            lines.append((garment, seed, f"{100 * remade['utilisation']:.2f} %", f"{remade['seconds']:.2f}",
                          f"{nested['density']:.2f} %" + ("" if nested["valid"] else " (overlaps)")))
    return table(("stored", "order", "remade", "s", "spyrrow, 60 s"), lines) if lines else ""


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--programs", type=pathlib.Path, required=True)
    parser.add_argument("--kept", type=pathlib.Path, required=True)
    parser.add_argument("--page", type=pathlib.Path, required=True)
    parser.add_argument("--data", type=pathlib.Path, required=True)
    parser.add_argument("--seconds", type=float, default=600)
    parser.add_argument("--race", action="store_true", help="also run the other nester where its layouts are not kept")
    options = parser.parse_args()
    options.kept = options.kept.resolve()
    options.kept.mkdir(parents=True, exist_ok=True)
    results = measure(options)
    stored = made.stored_marker(options, "jeans_02g")
    pictures = options.page.parent / "pictures" / "library"
    steps = made.run(options.programs / "remake_steps", pictures, 1, stored, made.best_known(options))
    examples = made.EXAMPLES
    matching = made.run(options.programs / "matching_table", examples / "jeans_06g.json", examples / "jeans_22g.json")
    page = options.page.read_text("utf-8")
    for name, text in (("steps", steps), ("figures", figures(results)), ("matching", matching), ("race", race(options))):
        page = replaced(page, name, text)
    options.page.write_text(page, "utf-8")


if __name__ == "__main__":
    main()
