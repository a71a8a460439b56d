#!/usr/bin/env python3
"""Checks that protocol/marker.schema.json and the reader accept the same documents.  usage: schema_test.py SELVAGE

Both must accept the examples in native format and the golden markers, and reject each of the changes listed below.
"""
import copy
import json
import pathlib
import subprocess
import sys

try:
    import jsonschema
except ImportError:
    print("skipped: Debian's python3-jsonschema is not installed")
    sys.exit(77)

SELVAGE = sys.argv[1]
ROOT = pathlib.Path(__file__).parents[2]
SCHEMA = json.loads((ROOT / "protocol" / "marker.schema.json").read_text())
BAD_INPUT = 3


def reader_accepts(document):
    return subprocess.run([SELVAGE, "check", "-"], input=json.dumps(document), capture_output=True,
                          text=True).returncode != BAD_INPUT


def schema_accepts(document):
    return jsonschema.Draft7Validator(SCHEMA).is_valid(document)


def native(path):
    ran = subprocess.run([SELVAGE, "convert", path, "-o", "-", "--format", "native"], capture_output=True, text=True)
    return json.loads(ran.stdout)


def rich():
    return {"format": "selvage-marker", "version": 1, "name": "rich", "unit": "in", "resolution": 1e-6,
            "strip": {"width": 100, "longest": 500, "margin": 0.5, "below": 1, "above": 2,
                      "repeat": {"along": 7, "across": 2.5, "phase": [1, -2]}}, "spacing": 0.5,
            "overlap": 0.25, "shade": 400, "attributes": {"any": ["thing"]},
            "shapes": [{"id": 1, "outline": [[0, 0], [40, 0], [40, 40], [0, 40], [0, 0]], "rotations": "any",
                        "flip": True, "tilt_limit": 3, "holes": [[[1, 1], [2, 1], [2, 2]]], "attributes": {}}],
            "pieces": [{"id": "a", "shape": 1, "at": [0, 40], "rotation": 90, "flip": True, "tilt": -1,
                        "locked": True, "attributes": {"x": None}},
                       {"id": "b", "shape": 1, "at": [100, 50], "locked": ["x", "tilt"], "group": 7, "buffer": 0.5,
                        "overlap": 0, "rules": {"below": 3, "above": 4, "from": 0, "to": 300, "match": [8, -2.5], "nap": "up", "shade": "A"}}],
            "unplaced": [{"id": "c", "shape": 1, "rotation": 90, "flip": True, "tilt": 1, "locked": False,
                          "group": "g", "buffer": 1, "overlap": 0.125, "rules": {"shade": "A"}, "attributes": {}}]}


def without(*path):
    def change(document):
        for key in path[:-1]:
            document = document[key]
        del document[path[-1]]
    return change


def put(value, *path):
    def change(document):
        for key in path[:-1]:
            document = document[key]
        document[path[-1]] = value
    return change


MISTAKES = [
    without("format"), without("version"), without("strip"), without("strip", "width"), without("shapes"),
    without("pieces"), without("shapes", 0, "id"), without("shapes", 0, "outline"), without("pieces", 0, "id"),
    without("pieces", 0, "shape"), without("pieces", 0, "at"),
    put("other", "format"), put(2, "version"), put(1, "name"), put(3, "unit"), put(0, "strip", "width"),
    put(-1, "spacing"), put(1, "colour"), put(1, "strip", "height"), put(1, "shapes", 0, "demand"),
    put(1, "pieces", 0, "x"), lambda document: document.update(pieces=[], unplaced=[]),
    put([[0, 0], [1, 1]], "shapes", 0, "outline"),
    put([0, 0, 0], "shapes", 0, "outline", 1), put(["a", 0], "shapes", 0, "outline", 1),
    put("some", "shapes", 0, "rotations"), put([], "shapes", 0, "rotations"), put([400], "shapes", 0, "rotations"),
    put(1, "shapes", 0, "flip"), put(50, "shapes", 0, "tilt_limit"), put(True, "shapes", 0, "id"),
    put(1.5, "pieces", 0, "id"), put([0], "pieces", 0, "at"), put(400, "pieces", 0, "rotation"),
    put(-1, "strip", "margin"), put(-1, "strip", "below"), put("1", "strip", "above"), put(-1, "overlap"),
    put(0, "shade"), put(["z"], "pieces", 1, "locked"), put(-1, "pieces", 1, "buffer"), put(-1, "pieces", 1, "overlap"),
    put(1.5, "pieces", 1, "group"), put(1, "pieces", 1, "rules"), put(-1, "pieces", 1, "rules", "below"),
    put("x", "pieces", 1, "rules", "from"), put(1, "pieces", 1, "rules", "fold"), put(2, "pieces", 1, "rules", "shade"),
    put("yes", "pieces", 1, "rules", "zone"), put("left", "pieces", 1, "rules", "nap"),
    put(-1, "strip", "repeat", "along"), put(1, "strip", "repeat", "every"), put(3, "strip", "repeat", "phase"),
    put([1], "pieces", 1, "rules", "match"), put(1, "pieces", 1, "rules", "within"), put({}, "unplaced"), put([0, 0], "unplaced", 0, "at"),
    without("unplaced", 0, "shape"), put(400, "unplaced", 0, "rotation"),
    put(-50, "pieces", 0, "tilt"), put("no", "pieces", 0, "locked"), put([], "pieces", 0, "attributes"),
]


def main():
    jsonschema.Draft7Validator.check_schema(SCHEMA)
    faults = []
    examples = sorted((ROOT / "examples" / "markers").glob("*.json"))
    for name, document in [("rich", rich())] + [(p.name, native(p)) for p in examples]:
        if not schema_accepts(document) or not reader_accepts(document):
            faults.append(f"{name}: schema {schema_accepts(document)}, reader {reader_accepts(document)}")
    for number, change in enumerate(MISTAKES):
        document = copy.deepcopy(rich())
        change(document)
        if schema_accepts(document) or reader_accepts(document):
            faults.append(f"mistake {number}: schema accepts {schema_accepts(document)}, "
                          f"reader accepts {reader_accepts(document)}")
    print("\n".join(faults) or f"{len(examples) + 1} documents accepted, {len(MISTAKES)} mistakes refused by both")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
