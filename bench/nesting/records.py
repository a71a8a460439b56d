#!/usr/bin/env python3
"""Searches for layouts that are shorter than the published ones, in several sessions that continue each other.

usage: records.py --selvage PROGRAM --kept FOLDER --out FOLDER --instances FILE... [--minutes M] [--seconds S]

Instances are files in the form of jagua-rs that hold the best published layout.  Each has two searches: one from
nothing, which takes turns between a fresh start and the best layout so far, and one from the published layout after
compaction.  A sitting is S seconds of one search, by the processor time of one thread; the search that has had the
least time has the next one, until M minutes have passed.  What a sitting finds is judged by tests/judge and, when it is
valid and denser than before, kept in OUT/NAME.json: the placements, without any shape, with the hash of the instance
that they belong to.  The next sitting starts from there, on whatever machine that is.  The table of OUT/README.md
follows from these files.
"""
import argparse
import hashlib
import json
import pathlib
import subprocess
import time

import race

STARTS = ("nothing", "published")


def instance_of(file):
    return {key: file[key] for key in ("name", "items", "strip_height")}


def hash_of(file):
    """Of the instance alone, whatever layout the file holds."""
    return hashlib.sha256(json.dumps(instance_of(file), sort_keys=True).encode()).hexdigest()


def run(arguments, *command):
    environment = {"LD_PRELOAD": str(race.clock_of(arguments.kept)), "PATH": "/usr/bin:/bin"}
    subprocess.run([arguments.selvage, *map(str, command)], env=environment, check=True, capture_output=True)


def judged(arguments, layout):
    """The part of a layout that is kept, without the shapes."""
    density, valid = race.judged(arguments, layout)
    solution = json.loads(layout.read_text("utf-8"))["solution"]
    return {"density": density, "length": solution["strip_width"], "valid": valid,
            "placements": solution["layout"]["placed_items"]}


def without_placements(found):
    return {key: value for key, value in found.items() if key != "placements"}


class Record:
    """What is known about one instance."""

    def __init__(self, arguments, path):
        self.arguments = arguments
        self.path = path
        self.file = json.loads(path.read_text("utf-8"))
        self.out = arguments.out / path.name
        self.known = json.loads(self.out.read_text("utf-8")) if self.out.exists() else {}
        if self.known.get("sha256") != hash_of(self.file):
            self.known = self.first()
            self.keep()

    def first(self):
        layout = self.arguments.kept / "compacted.json"
        run(self.arguments, "compact", self.path, "--accuracy", "fine", "-o", layout)
        compacted = judged(self.arguments, layout)
        return {"instance": self.file["name"], "sha256": hash_of(self.file),
                "published": without_placements(judged(self.arguments, self.path)),
                "compacted": without_placements(compacted),
                "nothing": {"sittings": 0, "seconds": 0, "best": None},
                "published start": {"sittings": 0, "seconds": 0, "best": compacted}}

    def keep(self):
        self.out.write_text(json.dumps(self.known) + "\n", "utf-8")

    def search(self, start):
        return self.known["nothing" if start == "nothing" else "published start"]

    def starting_layout(self, start):
        """The file from which a session starts."""
        search = self.search(start)
        file = instance_of(self.file)
        fresh = start == "nothing" and search["sittings"] % 2 == 0
        if search["best"] and not fresh:
            file["solution"] = {"strip_width": search["best"]["length"], "density": search["best"]["density"] / 100,
                                "layout": {"container_id": 0, "placed_items": search["best"]["placements"],
                                           "density": search["best"]["density"] / 100}}
        begin = self.arguments.kept / "begin.json"
        begin.write_text(json.dumps(file), "utf-8")
        return begin

    def sit(self, start):
        search = self.search(start)
        layout = self.arguments.kept / "found.json"
        run(self.arguments, "nest", self.starting_layout(start), "--time", self.arguments.seconds, "--threads", 1,
            "--seed", search["sittings"] + 1, "-o", layout)
        found = judged(self.arguments, layout)
        search["sittings"] += 1
        search["seconds"] += self.arguments.seconds
        if found["valid"] and (not search["best"] or found["density"] > search["best"]["density"]):
            search["best"] = found
        self.keep()
        print(f"{self.path.stem} from {start}, {search['seconds']} s: {found['density']:.3f}, "
              f"best {search['best']['density']:.3f}", flush=True)

    def row(self):
        cells = [self.path.stem, f"{self.known['published']['density']:.3f}",
                 f"{self.known['compacted']['density']:.3f}"]
        for start in STARTS[::-1]:
            search = self.search(start)
            if not search["best"]:
                cells += ["-", "0"]
                continue
            density = f"{search['best']['density']:.3f}"
            beats = search["best"]["density"] > self.known["compacted"]["density"] + 0.0005
            cells += [f"**{density}**" if beats else density, str(search["seconds"])]
        return "| " + " | ".join(cells) + " |"


def write_page(arguments, records):
    page = arguments.out / "README.md"
    begin, end = "<!-- table: records -->\n", "<!-- end -->"
    before, found, rest = page.read_text("utf-8").partition(begin)
    if not found:
        raise SystemExit(f"{page} has no place for the table")
    rows = ["| density % | published | compacted | from the published layout | s | from nothing | s |", "|---|" + "---|" * 6]
    rows += [record.row() for record in records]
    page.write_text(before + begin + "\n" + "\n".join(rows) + "\n\n" + end + rest.partition(end)[2], "utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--selvage", type=pathlib.Path, required=True)
    parser.add_argument("--kept", type=pathlib.Path, required=True)
    parser.add_argument("--out", type=pathlib.Path, required=True)
    parser.add_argument("--instances", type=pathlib.Path, nargs="+", required=True)
    parser.add_argument("--minutes", type=float, default=60)
    parser.add_argument("--seconds", type=int, default=60)
    arguments = parser.parse_args()
    arguments.kept = arguments.kept.resolve()
    arguments.kept.mkdir(parents=True, exist_ok=True)
    end = time.monotonic() + 60 * arguments.minutes
    records = [Record(arguments, path) for path in arguments.instances]
    write_page(arguments, records)
    while time.monotonic() < end:
        record, start = min(((record, start) for start in STARTS for record in records),
                            key=lambda one: one[0].search(one[1])["seconds"])
        record.sit(start)
        write_page(arguments, records)


if __name__ == "__main__":
    main()
