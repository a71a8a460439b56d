#!/usr/bin/env python3
"""Nests an instance with spyrrow, on one thread, and writes the solution in the format of the input.

usage: run_spyrrow.py INSTANCE SECONDS SEED OUT

Run it with the interpreter of an environment that has spyrrow, and with the clock of processor_clock.c.
"""
import json
import sys

import spyrrow


def main():
    path, seconds, seed, out = sys.argv[1:]
    with open(path, encoding="utf-8") as file:
        instance = json.load(file)
    items = [spyrrow.Item(str(item["id"]), [tuple(point) for point in item["shape"]["data"]], item["demand"],
                          [float(angle) for angle in item["allowed_orientations"]]) for item in instance["items"]]
    strip = spyrrow.StripPackingInstance(instance["name"], float(instance["strip_height"]), items)
    config = spyrrow.StripPackingConfig(early_termination=False, total_computation_time=int(seconds), num_workers=1,
                                        seed=int(seed))
    solution = strip.solve(config)
    placed = [{"item_id": int(item.id),
               "transformation": {"rotation": item.rotation, "translation": list(item.translation)}}
              for item in solution.placed_items]
    instance["solution"] = {"strip_width": solution.width, "density": solution.density, "run_time_sec": int(seconds),
                            "layout": {"container_id": 0, "placed_items": placed, "density": solution.density}}
    with open(out, "w", encoding="utf-8") as file:
        json.dump(instance, file)


if __name__ == "__main__":
    main()
