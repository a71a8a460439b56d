#!/usr/bin/env python3
"""Compacts marker files with the command line client and prints a Markdown table of the gains.

usage: compaction_table.py --selvage BINARY [--accuracy WORD] [--judge CHECKER] FILE...

--judge: a program that is given the outlines file of each result and exits with 0 when the layout is valid
(tests/judge/judge_layout.py); a result counts as valid when both the program and Selvage find it valid.
Exit status 1 when a marker could not be compacted, became longer, or is not valid.
"""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile


def compacted(options, path, folder):
    outlines = pathlib.Path(folder) / "outlines.json"
    run = subprocess.run(
        [options.selvage, "compact", path, "-o", str(pathlib.Path(folder) / "out.json"), "--outlines", str(outlines),
         "--accuracy", options.accuracy, "--json"], capture_output=True, text=True, check=False)
    if run.returncode != 0:
        return None, (run.stderr or run.stdout).strip()
    result = json.loads(run.stdout)
    if options.judge:
        judged = subprocess.run([sys.executable, options.judge, str(outlines)], capture_output=True, text=True, check=False)
        if judged.returncode != 0:
            print(judged.stdout + judged.stderr, file=sys.stderr)
            result["valid"] = False
    return result, None


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--selvage", required=True)
    parser.add_argument("--accuracy", default="standard")
    parser.add_argument("--judge")
    parser.add_argument("files", nargs="+")
    options = parser.parse_args()
    print("| marker | pieces | length before | after | after / before | utilisation before | after | repaired pairs | rounds | ms | valid |")
    print("|---|---|---|---|---|---|---|---|---|---|---|")
    good = True
    with tempfile.TemporaryDirectory() as folder:
        for path in options.files:
            name = pathlib.Path(path).name.removesuffix(".json")
            result, fault = compacted(options, path, folder)
            if result is None:
                print(f"| {name} | {fault} |")
                good = False
                continue
            ratio = result["length_after"] / result["length_before"]
            good = good and result["valid"] and ratio <= 1
            print(f"| {name} | {result['pieces']} | {result['length_before']:.6g} | {result['length_after']:.6g} | {ratio:.6f} "
                  f"| {100 * result['utilisation_before']:.3f} % | {100 * result['utilisation_after']:.3f} % "
                  f"| {result['healed']['pairs']} | {result['rounds']} | {result['ms']['total']:.1f} "
                  f"| {'yes' if result['valid'] else 'NO'} |")
    sys.exit(0 if good else 1)


if __name__ == "__main__":
    main()
