#!/usr/bin/env python3
"""Solves the programs that coverings_table writes with HiGHS, on one thread, and prints a row of a table for each.

usage: run_highs.py [--seconds S] PROGRAM.lp...

Run it with the interpreter of an environment that has highspy.  Times are seconds of processor time, after S (default:
20) of which HiGHS is stopped.  Lengths are in widths of the room.
"""
import argparse
import pathlib
import time

import highspy


def solved(path, seconds):
    highs = highspy.Highs()
    highs.setOptionValue("output_flag", False)
    highs.setOptionValue("threads", 1)
    highs.readModel(str(path))
    begun = time.process_time()

    def stop_in_time(event):
        if time.process_time() - begun > seconds:
            event.interrupt()

    highs.cbMipInterrupt += stop_in_time
    highs.run()
    spent = time.process_time() - begun
    proved = highs.getModelStatus() == highspy.HighsModelStatus.kOptimal
    return highs.getInfo(), proved, spent


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--seconds", type=float, default=20)
    parser.add_argument("programs", nargs="+", type=pathlib.Path)
    arguments = parser.parse_args()
    print("| program | | length | bound | nodes | seconds |\n|---|---|---|---|---|---|")
    for path in arguments.programs:
        info, proved, spent = solved(path, arguments.seconds)
        print(f"| {path.stem} | {'proved' if proved else 'open'} | {info.objective_function_value:.6g} | "
              f"{info.mip_dual_bound:.6g} | {info.mip_node_count} | {spent:.2f} |", flush=True)


if __name__ == "__main__":
    main()
