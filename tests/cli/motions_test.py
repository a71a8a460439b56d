#!/usr/bin/env python3
"""The motions: what they print, write and return.  usage: motions_test.py SELVAGE"""
import json
import re
import signal
import subprocess
import unittest
from decimal import Decimal

from command import BAD_INPUT, BAD_USAGE, CANCELLED, CliTest, MARKERS, NOT_VALID, OK, REFUSED, SELVAGE, run, squares


class Compact(CliTest):
    def test_shortens_a_marker_and_reports_it_in_one_line(self):
        ran = run("compact", MARKERS / "jeans_02g.json", "-o", self.path("out.json"), "--json")
        self.assertEqual(ran.returncode, OK, ran.stderr)
        self.assertEqual(ran.stdout.count("\n"), 1)
        line = json.loads(ran.stdout)
        self.assertEqual(set(line), {"name", "pieces", "length_before", "length_after", "utilisation_before",
                                     "utilisation_after", "rounds", "stop", "valid", "healed", "ms", "cache"})
        self.assertEqual(set(line["ms"]), {"decomposition", "sums", "rows", "solve", "verify", "total"})
        self.assertEqual(set(line["cache"]), {"hits", "misses", "entries", "bytes"})
        self.assertEqual((line["name"], line["pieces"], line["stop"]), ("jeans_02g", 40, "converged"))
        self.assertEqual(line["length_before"], 2460.35)
        self.assertLess(line["length_after"], line["length_before"])
        self.assertGreater(line["utilisation_after"], line["utilisation_before"])
        self.assertIs(line["valid"], True)
        self.assertEqual(run("check", self.path("out.json")).returncode, OK)

    def test_a_motion_ends_when_its_time_is_up(self):
        ran = run("compact", MARKERS / "jeans_06g.json", "-o", self.path("out.json"), "--json", "--accuracy", "fine",
                  "--time", "0.05")
        self.assertEqual(ran.returncode, OK)
        self.assertEqual(json.loads(ran.stdout)["stop"], "deadline")
        self.assertEqual(run("check", self.path("out.json")).returncode, OK)
        self.assertEqual(run("compact", MARKERS / "jeans_06g.json", "--time", "0").returncode, BAD_USAGE)

    # The arguments that each motion needs in addition to the marker.
    ARGUMENTS = {
        "push": ("--forces", '[{"piece":"p0","force":[1,0]}]'), "gravity": ("--force", "-1,-1"),
        "bump": ("--piece", "p0", "--direction=-1,0"), "place": ("--piece", "p0", "--to", "30,30"),
        "align": ("--pieces", '["p0","p1"]', "--side", "left"), "relax": ("--piece", "p0"),
        "open-gap": ("--point", "500,500"), "tilt": ("--limit", "2"), "float": ("--distance", "5"),
        "contain": ("--pieces", '["p0"]', "--room", "[[0,0],[3000,500]]"),
    }

    def test_a_file_may_come_between_numbers_and_other_options(self):
        ran = run("gravity", "--force", "-1,0", MARKERS / "jeans_02g.json", "--json")
        self.assertEqual(ran.returncode, OK, ran.stderr)

    def test_every_motion_ends_when_its_time_is_up(self):
        document = squares(*((x * 111, y * 97) for x in range(20) for y in range(10)))
        document["strip"]["width"] = 1000
        marker = self.write(document)
        description = json.loads((MARKERS.parents[1] / "protocol" / "openrpc.json").read_text())
        motions = [m["name"] for m in description["methods"] if m["name"].startswith("motion.")]
        self.assertGreaterEqual(len(motions), 15)
        stops = []
        for name in motions:
            command = re.sub("[A-Z]", lambda capital: "-" + capital[0].lower(), name.removeprefix("motion."))
            with self.subTest(command):
                ran = run(command, marker, *self.ARGUMENTS.get(command, ()), "--time", "0.001", "--json")
                self.assertIn(ran.returncode, (OK, REFUSED), ran.stderr)
                if ran.returncode == OK:
                    line = json.loads(ran.stdout)
                    self.assertIs(line["valid"], True)
                    stops.append(line.get("stop"))
        # A motion of a single step, or on a machine that wakes the clock late, may end before its deadline; not all do.
        self.assertLessEqual({*stops}, {"deadline", "converged", None})
        self.assertIn("deadline", stops)

    def test_an_empty_server_is_not_this_process(self):
        self.assertNotEqual(run("compact", MARKERS / "jeans_06g.json", "--server", "").returncode, OK)

    def test_the_number_of_threads_does_not_affect_the_result(self):
        results = []
        for threads in ("1", "2", "5"):
            ran = run("compact", MARKERS / "jeans_06g.json", "-o", self.path("out.json"), "--json", "--threads", threads)
            self.assertEqual(ran.returncode, OK, ran.stderr)
            line = json.loads(ran.stdout)
            del line["ms"]
            results.append((line, self.path("out.json").read_text()))
        self.assertEqual(results[1:], results[:1] * 2)
        for wrong in ("0", "257", "many"):
            self.assertEqual(run("compact", MARKERS / "jeans_06g.json", "--threads", wrong).returncode, BAD_USAGE)

    def test_names_an_unknown_subcommand(self):
        ran = run("compakt", MARKERS / "jeans_06g.json")
        self.assertEqual(ran.returncode, BAD_USAGE)
        self.assertIn("compakt is not a subcommand; did you mean compact?", ran.stderr)

    def test_keeps_the_format_of_the_input_by_default(self):
        run("compact", MARKERS / "jeans_02g.json", "-o", self.path("same.json"))
        same = json.loads(self.path("same.json").read_text())
        self.assertEqual(same["items"][0]["name"], "charlie.front_38_L")
        run("compact", MARKERS / "jeans_02g.json", "-o", self.path("native.json"), "--format", "native")
        self.assertEqual(json.loads(self.path("native.json").read_text())["format"], "selvage-marker")
        back = run("convert", self.path("native.json"), "-o", "-", "--format", "sparrow")
        self.assertEqual(json.loads(back.stdout), same)

    def test_writes_outlines_and_a_drawing(self):
        ran = run("compact", MARKERS / "jeans_02g.json", "--json", "--outlines", self.path("o.json"),
                  "--svg", self.path("o.svg"))
        line = json.loads(ran.stdout, parse_float=Decimal)
        outlines = json.loads(self.path("o.json").read_text(), parse_float=Decimal, parse_int=Decimal)
        self.assertEqual(len(outlines["pieces"]), 40)
        self.assertEqual(outlines["strip_height"], 1500)
        self.assertEqual(outlines["strip_length"], line["length_after"])
        self.assertEqual(max(x for p in outlines["pieces"] for x, _ in p["outline"]), line["length_after"])
        svg = self.path("o.svg").read_text()
        self.assertIn('class="before"', svg)
        self.assertEqual(svg.count("<path"), 40)

    def test_reads_standard_input_and_writes_standard_output(self):
        ran = run("compact", "-", "-o", "-", text=json.dumps(squares((0, 0), (50, 0))))
        self.assertEqual(ran.returncode, OK, ran.stderr)
        out = json.loads(ran.stdout)
        self.assertEqual([p["at"][0] for p in out["pieces"]], [0, 40])
        self.assertIn("length", ran.stderr)

    def test_uses_the_overlap_allowance(self):
        ran = run("compact", "-", "-o", "-", "--overlap", "1.5", text=json.dumps(squares((0, 0), (50, 0))))
        out = json.loads(ran.stdout)
        self.assertEqual(out["overlap"], 1.5)
        self.assertEqual(out["pieces"][1]["at"][0], 38.5)
        self.assertEqual(run("check", "-", text=ran.stdout).returncode, OK)
        self.assertEqual(run("check", "-", "--overlap", "1.4", text=ran.stdout).returncode, NOT_VALID)

    def test_keeps_the_spacing(self):
        ran = run("compact", "-", "-o", "-", "--spacing", "2.5", text=json.dumps(squares((0, 0), (50, 0))))
        out = json.loads(ran.stdout)
        self.assertEqual(out["spacing"], 2.5)
        self.assertEqual(out["pieces"][1]["at"][0], 42.5)

    def test_does_not_move_locked_pieces(self):
        document = squares((10, 0), (60, 0))
        document["pieces"][0]["locked"] = True
        out = json.loads(run("compact", "-", "-o", "-", text=json.dumps(document)).stdout)
        self.assertEqual([p["at"][0] for p in out["pieces"]], [10, 50])

    def test_stops_after_the_maximum_number_of_rounds(self):
        ran = run("compact", MARKERS / "jeans_06g.json", "--json", "--rounds", "1")
        line = json.loads(ran.stdout)
        self.assertEqual((line["rounds"], line["stop"]), (1, "work_limit"))

    def test_simplified_outlines_use_other_minkowski_sums(self):
        marker = MARKERS / "jeans_02g.json"
        own, simplified = (json.loads(run("compact", marker, "--json", "--simplification", part).stdout)
                           for part in ("0", "0.001"))
        self.assertTrue(simplified["valid"])
        self.assertLess(simplified["length_after"], simplified["length_before"])
        self.assertNotEqual(own["cache"]["entries"], simplified["cache"]["entries"])

    def test_the_same_request_gives_the_same_bytes(self):
        results = set()
        for _ in range(3):
            results.add(run("compact", MARKERS / "jeans_02g.json", "-o", "-").stdout)
        self.assertEqual(len(results), 1)

    def test_refuses_deep_overlaps_and_writes_no_file(self):
        ran = run("compact", self.write(squares((0, 0), (20, 0))), "-o", self.path("out.json"))
        self.assertEqual(ran.returncode, REFUSED)
        self.assertIn("marker.overlaps", ran.stderr)
        self.assertFalse(self.path("out.json").exists())

    def test_writes_the_best_marker_so_far_when_interrupted(self):
        started = subprocess.Popen([SELVAGE, "compact", str(self.long_marker()), "-o", str(self.path("out.json"))],
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.wait_until_sigint_is_handled(started.pid)
        started.send_signal(signal.SIGINT)
        started.communicate(timeout=300)
        self.assertEqual(started.returncode, CANCELLED)
        self.assertEqual(run("check", self.path("out.json")).returncode, OK)

    def long_marker(self, copies=8):
        """Several copies of the largest example in a row: seconds of work."""
        document = json.loads((MARKERS / "jeans_22g.json").read_text())
        placed = document["solution"]["layout"]["placed_items"]
        document["solution"]["layout"]["placed_items"] = [
            {"item_id": p["item_id"], "transformation": {
                "rotation": p["transformation"]["rotation"],
                "translation": [p["transformation"]["translation"][0] + 26663 * k,
                                p["transformation"]["translation"][1]]}}
            for k in range(copies) for p in placed]
        return self.write(document)


class Bump(CliTest):
    def test_moves_one_piece_and_reports_its_position(self):
        ran = run("bump", self.write(squares((0, 0), (50, 10), (60, 60))), "--piece", "p1", "--direction", "-1,0",
                  "-o", self.path("out.json"))
        self.assertEqual(ran.returncode, OK, ran.stderr)
        self.assertIn("position     40, 10 mm, stopped by p0", ran.stdout)
        out = json.loads(self.path("out.json").read_text())
        self.assertEqual([p["at"] for p in out["pieces"]], [[0, 0], [40, 10], [60, 60]])

    def test_json_is_one_line_with_the_same_figures(self):
        marker = self.write(squares((0, 0), (50, 10)))
        ran = run("bump", marker, "--piece", "p1", "--direction", "-2,0", "--json",
                  "--svg", self.path("o.svg"), "--outlines", self.path("o.json"))
        self.assertEqual(ran.stdout.count("\n"), 1)
        line = json.loads(ran.stdout)
        self.assertEqual(set(line), {"name", "pieces", "length_before", "length_after", "utilisation_before",
                                     "utilisation_after", "at", "gain", "touching", "moved", "stop", "valid", "healed",
                                     "ms", "cache"})
        self.assertEqual((line["at"], line["gain"], line["touching"], line["moved"]), ([40, 10], 10, ["p0"], True))
        self.assertIn('class="before"', self.path("o.svg").read_text())
        self.assertEqual(json.loads(self.path("o.json").read_text())["strip_length"], 80)

    def test_names_invalid_input_and_writes_no_file(self):
        marker = self.write(squares((0, 0), (50, 10)))
        for piece, direction, said in (("p9", "1,0", '/piece: "p9" is not a piece of this marker'),
                                       ("p1", "0,0", "/direction: [0,0] has no direction"),
                                       ("p1", "nan,1", "/direction/0: nan is out of range"),
                                       ("p1", "1,-inf", "/direction/1: -inf is out of range")):
            with self.subTest(direction):
                ran = run("bump", marker, "--piece", piece, "--direction", direction, "-o", self.path("out.json"))
                self.assertEqual((ran.returncode, ran.stdout), (BAD_INPUT, ""))
                self.assertIn(said, ran.stderr)
                self.assertFalse(self.path("out.json").exists())

    def test_names_the_pieces_that_overlap_too_deeply(self):
        ran = run("bump", self.write(squares((0, 0), (20, 0))), "--piece", "p0", "--direction", "1,0")
        self.assertEqual(ran.returncode, REFUSED)
        self.assertIn('"p0" and "p1"', ran.stderr)


class Separate(CliTest):
    def test_removes_deep_overlaps_without_growth_if_possible(self):
        ran = run("separate", self.write(squares((0, 0), (30, 0))), "-o", self.path("out.json"), "--json")
        self.assertEqual(ran.returncode, OK, ran.stderr)
        line = json.loads(ran.stdout)
        self.assertEqual((line["apart"], line["length_after"], line["moved"]), (True, 70, 40))
        self.assertEqual(run("check", self.path("out.json")).returncode, OK)

    def test_grows_only_with_grow(self):
        three = squares((0, 0), (0, 60), (30, 30))
        held = run("separate", self.write(three), "--json", "-o", self.path("out.json"))
        self.assertEqual(held.returncode, NOT_VALID)
        self.assertFalse(self.path("out.json").exists())
        self.assertTrue(json.loads(held.stdout)["remaining"])
        grown = run("separate", self.write(three), "--json", "--grow", 20)
        self.assertEqual((grown.returncode, json.loads(grown.stdout)["length_after"]), (OK, 80))

    def test_partial_writes_the_result_and_reports_that_it_is_not_valid(self):
        crowd = self.write(squares((0, 0), (0, 30), (0, 60), (0, 10)))
        ran = run("separate", crowd, "-o", self.path("out.json"))
        self.assertEqual(ran.returncode, NOT_VALID)
        self.assertIn("the marker is not valid, so nothing was written; --partial writes it nevertheless", ran.stderr)
        self.assertFalse(self.path("out.json").exists())
        self.assertNotIn("nothing was written", run("separate", crowd).stderr)
        ran = run("separate", crowd, "--partial", "--json", "-o", self.path("out.json"))
        self.assertEqual(ran.returncode, NOT_VALID)
        self.assertEqual(run("check", self.path("out.json")).returncode, NOT_VALID)

    def test_the_summary_names_at_most_twenty_pairs(self):
        ran = run("separate", self.write(squares(*((k, k) for k in range(8)))), "--rounds", 1)
        self.assertEqual(ran.returncode, NOT_VALID)
        lines = [line for line in ran.stdout.splitlines() if line.startswith("  overlapping  ")]
        self.assertEqual(len(lines), 21)
        self.assertRegex(lines[0], r"p\d and p\d by [\d.]+ mm")
        self.assertRegex(lines[-1], r"^  overlapping  \d more pairs?$")

    def test_a_depth_that_was_not_measured_is_not_printed(self):
        marker = self.write(squares(*((x * 1.11, x * 0.17) for x in range(300))))
        self.assertNotIn("by 0 mm", run("separate", marker, "--time", "0.001").stdout)

    def test_rules_that_leave_no_room_are_named(self):
        document = squares(*((38 * k, 0) for k in range(6)))
        document["shade"] = 50
        for piece in document["pieces"]:
            piece["rules"] = {"shade": "A"}
        ran = run("separate", self.write(document))
        self.assertEqual(ran.returncode, NOT_VALID)
        self.assertIn("solver failed", ran.stdout)
        self.assertIn("shades, match sets, bands or locked pieces may leave no room where the pieces lie", ran.stderr)

    def test_pops_out_pieces_that_block_the_separation(self):
        ran = run("separate", self.write(squares((0, 0), (0, 30), (0, 60))), "--pop-out", "--json", "-o",
                  self.path("out.json"))
        self.assertEqual(ran.returncode, OK, ran.stderr)
        self.assertEqual(len(json.loads(ran.stdout)["popped"]), 1)
        self.assertEqual(len(json.loads(self.path("out.json").read_text())["pieces"]), 2)


class Float(CliTest):
    def test_distributes_free_space_without_adding_length(self):
        ran = run("float", self.write(squares((0, 0), (0, 40), (60, 0))), "--distance", 20, "--json", "-o",
                  self.path("out.json"))
        self.assertEqual(ran.returncode, OK, ran.stderr)
        line = json.loads(ran.stdout)
        self.assertEqual((line["least_before"], line["least_after"], line["reached"]), (0, 20, True))
        self.assertEqual(line["length_after"], 100)


class Tilt(CliTest):
    def test_keeps_within_the_limit_and_reports_the_tilt(self):
        tilted = run("tilt", MARKERS / "jeans_02g.json", "--limit", 1, "--json", "-o", self.path("out.json"))
        self.assertEqual(tilted.returncode, OK, tilted.stderr)
        line = json.loads(tilted.stdout)
        self.assertLessEqual(line["length_after"], line["length_compacted"])
        self.assertLessEqual(line["farthest_tilt"], 1)
        self.assertEqual(run("check", self.path("out.json")).returncode, OK)


class EveryMotion(CliTest):
    """Motions without a test class of their own; their options are generated from the descriptors of the methods."""

    def test_every_motion_of_the_daemon_is_a_command(self):
        listed = run("--help").stdout
        for command in ("nest", "pack", "contain", "fill", "compact-exactly", "compact", "push", "gravity", "bump", "place", "separate", "float", "open-gap", "tilt", "relax",
                        "one-at-a-time", "velocity"):
            self.assertIn(f"\n  {command} ", listed)
            shown = run(command, "--help")
            self.assertEqual(shown.returncode, OK)
            self.assertIn("IN (required)", shown.stdout)

    def test_gives_the_same_result_as_call(self):
        marker = self.write(squares((0, 0), (50, 10), (60, 60)))
        for command, options, method, params in (
                ("gravity", ["--force", "0,1"], "motion.gravity", {"force": [0, 1]}),
                ("place", ["--piece", "p1", "--to", "45,0"], "motion.place", {"piece": "p1", "to": [45, 0]}),
                ("relax", ["--piece", "p1", "--tilts", "0"], "motion.relax", {"piece": "p1"}),
                ("open-gap", ["--point", "45,5"], "motion.openGap", {"point": [45, 5]}),
                ("push", ["--forces", '[{"piece": "p0", "force": [1, 0]}]'], "motion.push",
                 {"forces": [{"piece": "p0", "force": [1, 0]}]})):
            with self.subTest(command):
                short = run(command, marker, *options, "-o", self.path("short.json"))
                self.assertEqual(short.returncode, OK, short.stderr)
                called = run("call", method, "--marker", marker, "--params", "-", "-o", self.path("called.json"),
                             text=json.dumps(params))
                self.assertEqual(called.returncode, OK, called.stderr)
                self.assertEqual(self.path("short.json").read_text(), self.path("called.json").read_text())

    def test_json_options_are_checked(self):
        marker = self.write(squares((0, 0), (50, 10)))
        for forces, message in (("[", "input.syntax"), ("[]", "/forces")):
            ran = run("push", marker, "--forces", forces)
            self.assertEqual((ran.returncode, ran.stdout), (BAD_INPUT, ""))
            self.assertIn(message, ran.stderr)


if __name__ == "__main__":
    unittest.main()
