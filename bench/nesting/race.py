#!/usr/bin/env python3
"""Nests instances with Selvage and with spyrrow by equal processor time, judges every layout, and writes a table.

usage: race.py --selvage PROGRAM --kept FOLDER --page PAGE --instances FILE... [--seconds S...] [--seeds K...]
               [--programs selvage spyrrow]

Instances are files in the form of jagua-rs; solutions in them are left out.  Both programs use one thread, and a clock
that is the processor time of the process (processor_clock.c).  Every result is kept in FOLDER and not computed again, so
that the race can be interrupted and continued.  The table replaces what is between `<!-- table: race -->` and
`<!-- end -->` in PAGE; a column holds the mean of the seeds that are there.

Densities are those of the judged length: the pieces' area divided by width times length.  A layout of spyrrow's that
overlaps by rounding is counted as it comes, and marked with an asterisk.
"""
import argparse
import json
import pathlib
import statistics
import subprocess
import sys
import venv

HERE = pathlib.Path(__file__).resolve().parent
JUDGE = HERE.parents[1] / "tests" / "judge" / "judge_layout.py"
SPYRROW = "spyrrow==0.9.0"
PROGRAMS = ("spyrrow", "selvage")


def clock_of(kept):
    """The library that is preloaded."""
    library = kept / "processor_clock.so"
    if not library.exists():
        subprocess.run(["cc", "-shared", "-fPIC", "-O2", "-o", library, HERE / "processor_clock.c"], check=True)
    return library


def python_with_spyrrow(kept):
    python = kept / "environment" / "bin" / "python"
    if not python.exists():
        venv.create(kept / "environment", with_pip=True)
        subprocess.run([python, "-m", "pip", "install", "--quiet", SPYRROW], check=True)
    return python


def instance_without_solution(path, kept):
    out = kept / "instances" / path.name
    if not out.exists():
        instance = json.loads(path.read_text("utf-8"))
        instance.pop("solution", None)
        out.parent.mkdir(parents=True, exist_ok=True)
        out.write_text(json.dumps(instance), "utf-8")
    return out


def nest(arguments, program, instance, seconds, seed, out):
    if program == "selvage":
        command = [arguments.selvage, "nest", instance, "--time", str(seconds), "--threads", "1", "--seed", str(seed), "-o", out]
    else:
        command = [python_with_spyrrow(arguments.kept), HERE / "run_spyrrow.py", instance, str(seconds), str(seed), out]
    done = subprocess.run(command, env={"LD_PRELOAD": str(clock_of(arguments.kept)), "PATH": "/usr/bin:/bin"},
                          capture_output=True, text=True)
    if not out.exists():
        raise SystemExit(f"{program} on {instance.name}: {done.stderr.strip() or done.stdout.strip()}")


def judged(arguments, layout):
    """The density of a layout in per cent, and whether it is valid, decided by the judge from the outlines alone."""
    outlines = layout.with_suffix(".outlines.json")
    subprocess.run([arguments.selvage, "convert", layout, "-o", outlines, "--format", "outlines"], check=True,
                   capture_output=True)
    valid = subprocess.run([sys.executable, JUDGE, outlines], capture_output=True).returncode == 0
    placed = json.loads(outlines.read_text("utf-8"))
    outlines.unlink()
    area = sum(abs(sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(outline, outline[1:] + outline[:1]))) / 2
               for outline in (piece["outline"] for piece in placed["pieces"]))
    return 100 * area / (placed["strip_height"] * placed["strip_length"]), valid


def result(arguments, program, path, seconds, seed):
    """The stored result, computed if there is none."""
    kept = arguments.kept / "results" / f"{path.stem}-{program}-{seconds}s-{seed}.json"
    if not kept.exists():
        kept.parent.mkdir(parents=True, exist_ok=True)
        layout = arguments.kept / "layout.json"
        layout.unlink(missing_ok=True)
        nest(arguments, program, instance_without_solution(path, arguments.kept), seconds, seed, layout)
        density, valid = judged(arguments, layout)
        kept.write_text(json.dumps({"density": density, "valid": valid}), "utf-8")
        print(f"{path.stem} {program} {seconds} s, seed {seed}: {density:.2f}{'' if valid else ' not valid'}", flush=True)
    return json.loads(kept.read_text("utf-8"))


def cell(results):
    if not results:
        return "-"
    mark = "" if all(one["valid"] for one in results) else "*"
    return f"{statistics.mean(one['density'] for one in results):.2f}{mark}"


def table(arguments):
    columns = [(program, seconds) for seconds in arguments.seconds for program in PROGRAMS]
    lines = ["| density % | " + " | ".join(f"{program}, {seconds} s" for program, seconds in columns) + " |",
             "|---|" + "---|" * len(columns)]
    for path in arguments.instances:
        cells = []
        for program, seconds in columns:
            kept = (arguments.kept / "results" / f"{path.stem}-{program}-{seconds}s-{seed}.json"
                    for seed in arguments.seeds)
            cells.append(cell([json.loads(file.read_text("utf-8")) for file in kept if file.exists()]))
        lines.append(f"| {path.stem} | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def write_page(arguments):
    begin, end = "<!-- table: race -->\n", "<!-- end -->"
    before, found, rest = arguments.page.read_text("utf-8").partition(begin)
    if not found:
        raise SystemExit(f"{arguments.page} has no place for the table")
    arguments.page.write_text(before + begin + "\n" + table(arguments) + "\n\n" + end + rest.partition(end)[2], "utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--selvage", type=pathlib.Path, required=True)
    parser.add_argument("--kept", type=pathlib.Path, required=True)
    parser.add_argument("--page", type=pathlib.Path, required=True)
    parser.add_argument("--instances", type=pathlib.Path, nargs="+", required=True)
    parser.add_argument("--seconds", type=int, nargs="*")
    parser.add_argument("--seeds", type=int, nargs="+", default=[1, 2, 3, 4, 5])
    parser.add_argument("--programs", nargs="+", choices=PROGRAMS, default=PROGRAMS)
    arguments = parser.parse_args()
    arguments.kept = arguments.kept.resolve()
    arguments.kept.mkdir(parents=True, exist_ok=True)
    arguments.seconds = arguments.seconds or [10, 60]
    for seed in arguments.seeds:
        for seconds in arguments.seconds:
            for path in arguments.instances:
                for program in arguments.programs:
                    result(arguments, program, path, seconds, seed)
            write_page(arguments)


if __name__ == "__main__":
    main()
