"""Compacts a marker on a running selvaged.  usage: compact.py ADDRESS MARKER.json"""
import json
import pathlib
import sys

import selvage_client

with selvage_client.Client(sys.argv[1]) as client, client.open(json.loads(pathlib.Path(sys.argv[2]).read_text())) as marker:
    moved = marker.compact()
    print(f"length {moved.length_before} -> {moved.length_after}, {moved.stop}, valid: {moved.valid}")
