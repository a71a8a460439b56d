"""Nests every instance of a folder on a running selvaged, and writes the markers into another folder.

usage: nest_folder.py ADDRESS FOLDER OUT [SECONDS]

Instances are .json files in the format of jagua-rs, or native markers with unplaced pieces.
"""
import json
import pathlib
import sys

import selvage_client

address, source, out, *budget = sys.argv[1:]
target = pathlib.Path(out)
target.mkdir(parents=True, exist_ok=True)
with selvage_client.Client(address) as client:
    for path in sorted(pathlib.Path(source).glob("*.json")):
        with client.open(path) as marker:
            nested = marker.nest(seconds=float(budget[0]) if budget else 20.0, seed=1)
            (target / path.name).write_text(json.dumps(marker.get().marker), "utf-8")
            (target / path.name).with_suffix(".svg").write_text(marker.svg(), "utf-8")
            print(f"{path.name}: {nested.placed} pieces on {nested.length_after:g}, {nested.unplaced} left over")
