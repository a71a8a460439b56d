#!/usr/bin/env python3
"""Output for people: progress and colour on a terminal, rounded numbers, errors with their location.  usage: terminal_test.py SELVAGE"""
import json
import os
import pty
import re
import subprocess
import unittest

from command import BAD_INPUT, BAD_USAGE, CliTest, FILE, MARKERS, OK, REFUSED, SELVAGE, run, squares

JEANS = MARKERS / "jeans_02g.json"


def on_terminal(*arguments, **environment):
    """All that the command prints on a terminal."""
    controller, terminal = pty.openpty()
    process = subprocess.Popen([SELVAGE, *map(str, arguments)], stdin=subprocess.DEVNULL, stdout=terminal, stderr=terminal,
                               env=os.environ | {"TERM": "xterm"} | environment)
    os.close(terminal)
    shown = b""
    try:
        while chunk := os.read(controller, 1 << 16):
            shown += chunk
    except OSError:  # the other end is closed
        pass
    os.close(controller)
    return process.wait(), shown.decode()


class OnATerminal(CliTest):
    def test_long_work_shows_a_bar_with_the_best_length(self):
        code, shown = on_terminal("nest", JEANS, "--from-scratch", "--time", "2.5")
        self.assertEqual(code, OK)
        bars = re.findall(r"\r\033\[K\[([#.]{24})\] (\d+) %", shown)
        self.assertGreater(len(bars), 1)
        parts = [int(part) for _, part in bars]
        self.assertEqual(parts, sorted(parts))
        for bar, part in bars:
            self.assertAlmostEqual(bar.count("#"), 24 * int(part) / 100, delta=1.2)
        self.assertRegex(shown, r"round \d+  \d+(\.\d+)? mm")

    def test_short_work_shows_no_bar(self):
        _, shown = on_terminal("compact", self.write(squares((0, 0), (50, 0))))
        self.assertNotIn("\r\033[K", shown)

    def test_colour_is_used_only_on_terminals_that_allow_it(self):
        marker = self.write(squares((0, 0), (50, 0)))
        self.assertIn("\033[32mvalid\033[0m", on_terminal("compact", marker)[1])
        self.assertIn("\033[1;31mselvage:\033[0m", on_terminal("check", "nowhere.json")[1])
        for shown in (on_terminal("compact", marker, NO_COLOR="1")[1], on_terminal("compact", marker, TERM="dumb")[1],
                      run("compact", marker).stdout):
            self.assertIn("valid", shown)
            self.assertNotIn("\033[", shown)


    def test_a_drawing_is_not_shown_as_text(self):
        code, shown = on_terminal("show", JEANS)
        self.assertEqual(code, BAD_USAGE)
        self.assertIn("name one file to write", shown)
        self.assertTrue(run("show", JEANS).stdout.startswith("<svg"))


class Numbers(CliTest):
    def test_numbers_are_rounded_for_people_and_complete_in_json(self):
        compacted = self.path("out.json")
        summary = run("compact", JEANS, "-o", compacted).stdout
        length = json.loads(run("compact", JEANS, "--json").stdout)["length_after"]
        self.assertGreater(len(repr(length)), 9)
        self.assertRegex(summary, rf"-> {length:.3f}".rstrip("0").replace(".", r"\."))
        self.assertRegex(summary, r"utilisation  \d\d\.\d\d % -> \d\d\.\d\d %")

    def test_angles_are_printed_without_rounding_noise(self):
        tilted = json.loads(run("tilt", JEANS, "--limit", "3", "--accuracy", "draft", "--json").stdout)
        self.assertEqual(tilted["farthest_tilt"], round(tilted["farthest_tilt"], 9))


class Mistakes(CliTest):
    def test_a_file_that_cannot_be_written_is_refused_before_the_work(self):
        for option in ("-o", "--svg", "--outlines"):
            for path in (self.path("no such folder") / "out.json", self.folder.name):
                # The input does not exist either; if it were read first, the error would name it.
                ran = run("compact", "nowhere.json", option, path)
                self.assertEqual(ran.returncode, FILE, option)
                self.assertIn(f"{path} cannot be written", ran.stderr)
        self.assertFalse(self.path("out.json").exists())

    def test_a_plan_is_not_made_when_it_cannot_be_written(self):
        for option in ("-o", "--html"):
            ran = run("plan", "nowhere.json", "--style", "nowhere.dxf", option, self.folder.name)
            self.assertEqual(ran.returncode, FILE)
            self.assertIn(f"{self.folder.name} cannot be written", ran.stderr)

    def test_parameters_that_are_not_json_are_named(self):
        ran = run("call", "motion.compact", '{"rounds": 1', "--marker", JEANS)
        self.assertEqual(ran.returncode, BAD_INPUT)
        self.assertIn("PARAMS: not JSON", ran.stderr)

    def test_an_error_names_its_file(self):
        bad = self.write("{", "bad.json")
        self.assertIn("bad.json: ", run("check", bad).stderr)
        ran = run("call", "motion.compact", bad, "--marker", JEANS)
        self.assertEqual(ran.returncode, BAD_INPUT)
        self.assertIn("bad.json: ", ran.stderr)
        ran = run("plan", bad, "--style", JEANS)
        self.assertEqual(ran.returncode, BAD_INPUT)
        self.assertIn("bad.json: ", ran.stderr)
        crossed = squares((0, 0))
        crossed["shapes"][0]["outline"] = [[0, 0], [40, 40], [40, 0], [0, 40]]
        ran = run("check", self.write(crossed, "crossed.json"))
        self.assertIn("crossed.json: ", ran.stderr)
        self.assertIn("edge", ran.stderr)

    def test_an_overlap_error_suggests_a_remedy(self):
        ran = run("compact", self.write(squares((0, 0), (9, 0))))
        self.assertEqual(ran.returncode, REFUSED)
        self.assertIn("selvage separate", ran.stderr)


class Defaults(CliTest):
    def test_floating_needs_no_distance(self):
        marker = self.write(squares((0, 0), (50, 0)))
        floated = run("float", marker, "--json")
        self.assertEqual(floated.returncode, OK, floated.stderr)
        hundredth = run("float", marker, "--distance", "1", "--json")  # of the width
        drop = ("ms", "cache")
        self.assertEqual(*({k: v for k, v in json.loads(ran.stdout).items() if k not in drop} for ran in (floated, hundredth)))


class Call(CliTest):
    def test_accepts_parameters_on_the_command_line(self):
        marker = self.write(squares((0, 0), (50, 0)))
        written_out = run("call", "motion.gravity", '{"force": [-1, 0]}', "--marker", marker)
        self.assertEqual(written_out.returncode, OK, written_out.stderr)
        params = self.write({"force": [-1, 0]}, "params.json")
        for others in (["--params", '{"force": [-1, 0]}'], [params], ["--params", params]):
            self.assertEqual(run("call", "motion.gravity", *others, "--marker", marker).stdout, written_out.stdout)

    def test_runs_methods_without_a_marker(self):
        info = json.loads(run("call", "engine.info").stdout)
        self.assertEqual(info["name"], "selvage")
        self.assertIn("motion.compact", info["methods"])
        methods = json.loads(run("call", "rpc.discover").stdout)["methods"]
        self.assertIn("marker.watch", [method["name"] for method in methods])
        opened = run("call", "marker.open", json.dumps({"marker": squares((0, 0))}))
        self.assertEqual(json.loads(opened.stdout)["pieces"], 1)

    def test_names_missing_arguments(self):
        for arguments, said in ((["marker.watch", '{"markerId": "m1"}'], "--server"), (["motion.compact"], "--marker"),
                                (["engine.info", "--marker", JEANS], "leave out --marker"),
                                (["motion.compact", "{}", "--params", "{}", "--marker", JEANS], "once")):
            ran = run("call", *arguments)
            self.assertEqual(ran.returncode, BAD_USAGE, ran.stderr)
            self.assertIn(said, ran.stderr)


if __name__ == "__main__":
    unittest.main()
