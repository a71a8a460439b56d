#!/usr/bin/env python3
"""Tests of the selvage command: its output, the files it writes and its exit codes.  usage: cli_test.py SELVAGE"""
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from decimal import Decimal

SELVAGE = sys.argv.pop(1)
MARKERS = pathlib.Path(__file__).parents[2] / "examples" / "markers"
PACKING = MARKERS.parent / "packing"
OK, NOT_VALID, BAD_USAGE, BAD_INPUT, FILE, REFUSED, CANCELLED = 0, 1, 2, 3, 4, 5, 130

SQUARE = {"id": "square", "outline": [[0, 0], [40, 0], [40, 40], [0, 40]]}


def squares(*places):
    pieces = [{"id": f"p{i}", "shape": "square", "at": list(at)} for i, at in enumerate(places)]
    return {"format": "selvage-marker", "version": 1, "name": "squares", "strip": {"width": 100},
            "shapes": [dict(SQUARE)], "pieces": pieces}


def run(*arguments, text=None):
    return subprocess.run([SELVAGE, *map(str, arguments)], input=text, capture_output=True, text=True, timeout=300)


class CliTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def path(self, name):
        return pathlib.Path(self.folder.name) / name

    def write(self, document, name="in.json"):
        self.path(name).write_text(document if isinstance(document, str) else json.dumps(document))
        return self.path(name)

    def wait_until_sigint_is_handled(self, pid):
        bit = 1 << (signal.SIGINT - 1)
        while True:
            status = pathlib.Path(f"/proc/{pid}/status").read_text()
            blocked = int(next(s for s in status.splitlines() if s.startswith("SigBlk")).split()[1], 16)
            if blocked & bit:
                return
            time.sleep(0.001)


class Compact(CliTest):
    def test_shortens_a_marker_and_reports_it_in_one_line(self):
        ran = run("compact", MARKERS / "jeans_02g.json", "-o", self.path("out.json"), "--json")
        self.assertEqual(ran.returncode, OK, ran.stderr)
        self.assertEqual(ran.stdout.count("\n"), 1)
        line = json.loads(ran.stdout)
        self.assertEqual(set(line), {"name", "pieces", "length_before", "length_after", "utilisation_before",
                                     "utilisation_after", "rounds", "stop", "valid", "healed", "ms", "cache"})
        self.assertEqual(set(line["ms"]), {"sums", "rows", "solve", "verify", "total"})
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
        for piece, direction, said in (("p9", "1,0", '/piece: "p9" is no piece of this marker'),
                                       ("p1", "0,0", "/direction: [0,0] leads nowhere"),
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
        ran = run("separate", crowd, "--partial", "--json", "-o", self.path("out.json"))
        self.assertEqual(ran.returncode, NOT_VALID)
        self.assertEqual(run("check", self.path("out.json")).returncode, NOT_VALID)

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


class Nest(CliTest):
    def instance(self):
        document = json.loads((MARKERS / "jeans_02g.json").read_text())
        del document["solution"]
        return document

    def test_makes_a_marker_of_an_instance_without_a_solution(self):
        ran = run("nest", self.write(self.instance()), "--moves", 500, "-o", self.path("out.json"), "--json")
        self.assertEqual(ran.returncode, OK, ran.stderr)
        line = json.loads(ran.stdout)
        self.assertEqual((line["placed"], line["unplaced"], line["stop"]), (40, 0, "work_limit"))
        self.assertGreater(line["utilisation_after"], 0.7)
        checked = run("check", self.path("out.json"))
        self.assertEqual(checked.returncode, OK)
        self.assertIn("40 pieces, length", checked.stdout)

    def test_the_number_of_threads_does_not_affect_the_result(self):
        results = []
        for threads in (1, 2, 4):
            ran = run("nest", self.write(self.instance()), "--moves", 60, "--searches", 3, "--threads", threads,
                      "-o", self.path("out.json"))
            self.assertEqual(ran.returncode, OK, ran.stderr)
            results.append(self.path("out.json").read_text())
        self.assertEqual(results[1:], results[:1] * 2)

    def test_without_time_places_all_pieces(self):
        ran = run("nest", self.write(self.instance()), "--time", 0, "--json")
        self.assertEqual(ran.returncode, OK, ran.stderr)
        self.assertEqual(json.loads(ran.stdout)["placed"], 40)

    def test_ctrl_c_keeps_the_best(self):
        process = subprocess.Popen([SELVAGE, "nest", self.write(self.instance()), "--moves", "1000000000000",
                                    "-o", self.path("out.json")], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.wait_until_sigint_is_handled(process.pid)
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=120)
        self.assertEqual(process.returncode, CANCELLED)
        self.assertEqual(run("check", self.path("out.json")).returncode, OK)

    def test_keeps_placed_pieces_if_asked_to(self):
        document = squares((30, 50))
        document["unplaced"] = [{"id": "new", "shape": "square"}]
        for options, length in ((["--keep-placed"], 40), ([], 40)):
            ran = run("nest", self.write(document), "--moves", 50, *options, "-o", self.path("out.json"))
            self.assertEqual(ran.returncode, OK, ran.stderr)
            written = json.loads(self.path("out.json").read_text())
            self.assertEqual([piece["id"] for piece in written["pieces"]], ["p0", "new"])
            self.assertNotIn("unplaced", written)
            self.assertLessEqual(max(piece["at"][0] for piece in written["pieces"]) + 40, 30 + length)

    def test_says_what_the_cloth_has_no_room_for(self):
        document = squares()
        document["strip"]["longest"] = 50
        document["unplaced"] = [{"id": name, "shape": "square"} for name in "abc"]
        ran = run("nest", self.write(document), "--moves", 50, "-o", self.path("out.json"))
        self.assertEqual(ran.returncode, OK, ran.stderr)
        self.assertIn("left over    1 piece", ran.stdout)
        written = json.loads(self.path("out.json").read_text())
        self.assertEqual((len(written["pieces"]), len(written["unplaced"])), (2, 1))

    def test_names_the_piece_that_fits_in_no_orientation(self):
        document = squares((0, 0))
        document["shapes"].append({"id": "board", "outline": [[0, 0], [150, 0], [150, 120], [0, 120]], "rotations": [0, 90]})
        document["unplaced"] = [{"id": "a", "shape": "board"}]
        ran = run("nest", self.write(document))
        self.assertNotEqual(ran.returncode, OK)
        self.assertIn("board", ran.stderr)
        self.assertIn("marker.piece_too_wide", ran.stderr)


class Pack(CliTest):
    def test_proves_the_shortest_marker(self):
        for name, pieces, length in (("partition", 5, 100), ("no_partition", 4, 120), ("bars", 6, 90)):
            with self.subTest(name):
                ran = run("pack", PACKING / f"{name}.json", "-o", self.path("out.json"), "--json")
                self.assertEqual(ran.returncode, OK, ran.stderr)
                line = json.loads(ran.stdout)
                self.assertEqual((line["found"], line["proved"], line["unplaced"]), (True, True, 0))
                self.assertAlmostEqual(line["length_after"], length, places=4)
                self.assertAlmostEqual(line["bound"], length, places=3)
                self.assertEqual(line["placed"], pieces)
                self.assertEqual(run("check", self.path("out.json")).returncode, OK)

    def test_takes_an_instance_without_a_solution_and_a_limit_of_nodes(self):
        document = json.loads((MARKERS / "jeans_02g.json").read_text())
        del document["solution"]
        ran = run("pack", self.write(document), "--nodes", 50, "-o", self.path("out.json"), "--json")
        self.assertEqual(ran.returncode, OK, ran.stderr)
        line = json.loads(ran.stdout)
        self.assertEqual((line["found"], line["proved"], line["stop"]), (True, False, "work_limit"))
        self.assertLess(line["bound"], line["length_after"])
        self.assertEqual(run("check", self.path("out.json")).returncode, OK)

    def test_the_summary_says_what_is_proved(self):
        ran = run("pack", PACKING / "partition.json")
        self.assertIn("the shortest, proved", ran.stdout)
        ran = run("contain", PACKING / "slot.json")
        self.assertIn("pieces       found", ran.stdout)

    def test_refuses_more_pieces_than_a_search_takes(self):
        ran = run("pack", MARKERS / "jeans_06g.json")
        self.assertEqual(ran.returncode, REFUSED)
        self.assertIn("120 pieces are not locked; an exact search takes at most 64", ran.stderr)

    def test_contain_places_what_fits_and_proves_what_does_not(self):
        ran = run("contain", PACKING / "slot.json", "-o", self.path("out.json"), "--json")
        self.assertEqual(ran.returncode, OK, ran.stderr)
        line = json.loads(ran.stdout)
        self.assertEqual((line["verdict"], line["pieces"], line["length_after"]), ("found", 3, 30))
        self.assertEqual(run("check", self.path("out.json")).returncode, OK)
        ran = run("contain", PACKING / "slot.json", "--room", "[[0,0],[29,30]]", "-o", self.path("none.json"), "--json")
        self.assertEqual(ran.returncode, OK, ran.stderr)
        self.assertEqual(json.loads(ran.stdout)["verdict"], "impossible")
        ran = run("contain", PACKING / "slot.json", "--room", "[[30,0],[30,30]]")
        self.assertEqual(ran.returncode, BAD_INPUT)
        self.assertIn("/room", ran.stderr)


class Fill(CliTest):
    def test_is_shorter_than_standard_compaction(self):
        compacted = run("compact", MARKERS / "jeans_02g.json", "--json")
        ran = run("fill", MARKERS / "jeans_02g.json", "--trials", 60, "-o", self.path("out.json"), "--json")
        self.assertEqual(ran.returncode, OK, ran.stderr)
        line = json.loads(ran.stdout)
        self.assertLess(line["length_after"], json.loads(compacted.stdout)["length_after"])
        self.assertEqual((line["rounds"], line["stop"]), (60, "work_limit"))
        self.assertGreater(line["kept"], 0)
        self.assertEqual(run("check", self.path("out.json")).returncode, OK)

    def test_places_unplaced_pieces_in_gaps(self):
        document = squares((0, 0), (50, 0))
        document["shapes"].append({"id": "strip", "outline": [[0, 0], [90, 0], [90, 20], [0, 20]]})
        document["unplaced"] = [{"id": "long", "shape": "strip"}, {"id": "third", "shape": "square"}]
        document["unplaced"].append({"id": "fourth", "shape": "square"})
        ran = run("fill", self.write(document), "--trials", 0, "-o", self.path("out.json"), "--json")
        self.assertEqual(ran.returncode, OK, ran.stderr)
        line = json.loads(ran.stdout)
        # Compacted, the squares leave 80 x 60: room for two more of them, and for no strip of 90.
        self.assertEqual((line["placed"], line["unplaced"], line["length_after"]), (2, 1, 80))
        self.assertEqual([piece["id"] for piece in json.loads(self.path("out.json").read_text())["unplaced"]], ["long"])

    def test_the_number_of_threads_does_not_affect_the_result(self):
        for command, options in (("fill", ["--trials", 30]), ("compact-exactly", ["--windows", 6, "--nodes", 40])):
            results = []
            for threads in (1, 2, 4):
                ran = run(command, MARKERS / "jeans_02g.json", *options, "--threads", threads, "-o", self.path("out.json"))
                self.assertEqual(ran.returncode, OK, ran.stderr)
                results.append(self.path("out.json").read_text())
            self.assertEqual(results[1:], results[:1] * 2, command)


class EveryMotion(CliTest):
    """Motions without a section of their own: their options follow from the descriptors of the methods."""

    def test_every_motion_of_the_daemon_is_a_command(self):
        listed = run("--help").stdout
        for command in ("nest", "pack", "contain", "fill", "compact-exactly", "compact", "push", "gravity", "bump", "place", "separate", "float", "open-gap", "tilt", "relax",
                        "one-at-a-time", "velocity"):
            self.assertIn(f"\n  {command} ", listed)
            shown = run(command, "--help")
            self.assertEqual(shown.returncode, OK)
            self.assertIn("IN TEXT REQUIRED", shown.stdout)

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


class Drawing(CliTest):
    def test_draws_displacements_and_the_critical_path_on_request(self):
        marker = self.write(squares((10, 0), (55, 20)))
        for flags, shown, hidden in (([], [], ["moved-head", "chain"]), (["--arrows"], ["moved-head"], ["chain"]),
                                     (["--arrows", "--chain"], ["moved-head", "chain"], [])):
            ran = run("compact", marker, "--svg", self.path("out.svg"), *flags)
            self.assertEqual(ran.returncode, OK, ran.stderr)
            body = self.path("out.svg").read_text().split("</style>")[1]
            for word in shown:
                self.assertIn(f'class="{word}"', body)
            for word in hidden:
                self.assertNotIn(f'class="{word}"', body)

    def test_draws_forces(self):
        params = self.write({"force": [0, 1]}, "params.json")
        run("call", "motion.gravity", "--marker", self.write(squares((10, 0))), "--params", params, "--svg",
            self.path("out.svg"), "--arrows")
        self.assertIn('class="force-head"', self.path("out.svg").read_text())


class Call(CliTest):
    def call(self, method, params, *more, marker=None):
        return run("call", method, "--marker", marker or self.marker, "--params", "-", *more,
                   text=params if isinstance(params, str) else json.dumps(params))

    def setUp(self):
        super().setUp()
        self.marker = self.write(squares((0, 0), (50, 10)))

    def test_returns_the_same_results_as_the_daemon(self):
        """Replays the golden exchanges that do not change the marker, on the marker that the first of them opens."""
        exchanges = json.loads((MARKERS.parents[1] / "tests/golden/rpc/motions.json").read_text())
        marker = self.write(exchanges[0]["request"]["params"]["marker"], "golden.json")
        played = 0
        for exchange in exchanges:
            params, answer = exchange["request"]["params"], exchange["response"]
            if params.get("commit") is not False:
                continue
            played += 1
            with self.subTest(exchange["request"]):
                ran = self.call(exchange["request"]["method"], params, marker=marker)
                if "error" in answer:
                    self.assertEqual((ran.returncode, ran.stdout), (BAD_INPUT, ""))
                    self.assertIn(answer["error"]["message"], ran.stderr)
                    continue
                self.assertEqual(ran.returncode, OK, ran.stderr)
                result = json.loads(ran.stdout)
                expected = {k: result.get(k) if v == "$any" else v for k, v in answer["result"].items()}
                self.assertEqual(result, expected)
        self.assertGreaterEqual(played, 7)

    def test_writes_the_moved_pieces(self):
        ran = self.call("motion.gravity", {"force": [0, 1]}, "-o", self.path("out.json"))
        result = json.loads(ran.stdout)
        self.assertEqual((result["markerId"], result["revision"], result["gain"]), ("m1", 2, 110))
        out = json.loads(self.path("out.json").read_text())
        self.assertEqual([p["at"] for p in out["pieces"]], [p["at"] for p in result["placements"]])
        self.assertEqual([p["at"][1] for p in out["pieces"]], [60, 60])

    def test_applies_edits(self):
        ops = [{"op": "add", "piece": {"id": "new", "shape": "square", "at": [0, 50], "attributes": {"size": "L"}}},
               {"op": "remove", "piece": "p1"}]
        result = json.loads(self.call("marker.apply", {"ops": ops}, "-o", self.path("out.json")).stdout)
        self.assertEqual((result["revision"], result["removed"], result["length"]), (2, ["p1"], 40))
        pieces = json.loads(self.path("out.json").read_text())["pieces"]
        self.assertEqual([(p["id"], p.get("attributes")) for p in pieces], [("p0", None), ("new", {"size": "L"})])
        overlapping = self.call("marker.apply", {"ops": [{"op": "move", "piece": "p1", "at": [9, 0]}]}, "-o",
                                self.path("out.json"))
        self.assertEqual(overlapping.returncode, NOT_VALID)
        self.assertEqual(json.loads(self.path("out.json").read_text())["pieces"][1]["at"], [9, 0])

    def test_a_dry_run_writes_the_marker_unchanged(self):
        ran = self.call("motion.compact", {"commit": False, "rounds": 3}, "-o", self.path("out.json"))
        self.assertEqual(json.loads(ran.stdout)["lengthAfter"], 80)
        self.assertEqual(json.loads(self.path("out.json").read_text())["pieces"][1]["at"], [50, 10])

    def test_parameters_may_be_omitted_if_the_method_requires_none(self):
        ran = run("call", "marker.check", "--marker", self.marker)
        self.assertEqual(json.loads(ran.stdout), {"markerId": "m1", "revision": 1, "valid": True, "overlaps": [],
                                                  "protrusions": []})
        compacted = json.loads(run("call", "motion.compact", "--marker", self.marker).stdout)
        self.assertEqual(compacted["lengthAfter"], 80)

    def test_runs_methods_that_only_read(self):
        got = json.loads(self.call("marker.get", {"format": "outlines"}).stdout)
        self.assertEqual(got["marker"]["strip_length"], 90)
        overlapping = self.write(squares((0, 0), (20, 0)), "overlapping.json")
        ran = run("call", "marker.check", "--marker", overlapping)
        self.assertEqual(ran.returncode, NOT_VALID)
        self.assertEqual(len(json.loads(ran.stdout)["overlaps"]), 1)

    def test_reports_times_only_on_request(self):
        timed = json.loads(self.call("motion.compact", {"timing": True}).stdout)
        self.assertEqual(set(timed["ms"]), {"sums", "rows", "solve", "verify", "total"})
        runs = {self.call("motion.push", {"forces": [{"piece": "p0", "force": [1, 1]}]}).stdout for _ in range(3)}
        self.assertEqual(len(runs), 1)
        self.assertNotIn("ms", json.loads(runs.pop()))

    def test_names_mistakes_in_parameters(self):
        for method, params, said in (("motion.compact", "{", "input.syntax"),
                                     ("motion.compact", [], "[] where an object is required"),
                                     ("motion.compact", {"speed": 1}, "/speed: the field is not known"),
                                     ("motion.compact", {"baseRev": 2}, "/baseRev: 2 is not the marker's revision"),
                                     ("motion.bump", {"piece": "p0"}, "/direction: the field is missing")):
            with self.subTest(params):
                ran = self.call(method, params)
                self.assertEqual((ran.returncode, ran.stdout), (BAD_INPUT, ""))
                self.assertIn(said, ran.stderr)
        self.assertEqual(run("call", "motion.compact", "--marker", self.marker, "--params", "nowhere").returncode, FILE)
        self.assertEqual(self.call("motion.compact", {}, marker=self.write(squares((0, 0), (9, 0)))).returncode, REFUSED)


class Check(CliTest):
    def test_a_valid_marker(self):
        ran = run("check", MARKERS / "jeans_06g.json")
        self.assertEqual(ran.returncode, OK)
        self.assertIn("120 pieces, length 7238 mm", ran.stdout)

    def test_lists_overlaps_and_protrusions(self):
        ran = run("check", self.write(squares((0, 0), (30, 0), (0, 70))))
        self.assertEqual(ran.returncode, NOT_VALID)
        self.assertIn("pieces p0 and p1 overlap by 10 mm", ran.stdout)
        self.assertIn("piece p2 leaves the strip by 10 mm", ran.stdout)

    def test_json_gives_the_same_result(self):
        ran = run("check", "--json", self.write(squares((0, 0), (30, 0))))
        self.assertEqual(ran.returncode, NOT_VALID)
        answer = json.loads(ran.stdout)
        self.assertFalse(answer["valid"])
        self.assertEqual([(o["first"], o["second"], o["depth"]) for o in answer["overlaps"]], [("p0", "p1", 10)])
        x, y = answer["overlaps"][0]["witness"]
        self.assertTrue(30 < x < 40 and 0 < y < 40, (x, y))

    def test_checks_the_spacing(self):
        touching = self.write(squares((0, 0), (40, 0)))
        self.assertEqual(run("check", touching).returncode, OK)
        self.assertEqual(run("check", touching, "--spacing", "0.001").returncode, NOT_VALID)


class ShowAndConvert(CliTest):
    def test_draws(self):
        ran = run("show", MARKERS / "jeans_02g.json", "--svg", "-")
        self.assertEqual(ran.returncode, OK, ran.stderr)
        self.assertTrue(ran.stdout.startswith("<svg ") and ran.stdout.endswith("</svg>\n"))

    def test_converting_to_another_format_and_back_keeps_the_marker(self):
        native, sparrow, again = self.path("n.json"), self.path("s.json"), self.path("n2.json")
        self.assertEqual(run("convert", MARKERS / "simon_06g.json", "-o", native, "--format", "native").returncode, OK)
        self.assertEqual(run("convert", native, "-o", sparrow, "--format", "sparrow").returncode, OK)
        self.assertEqual(run("convert", sparrow, "-o", again, "--format", "native").returncode, OK)
        self.assertEqual(native.read_text(), again.read_text())


class BadUsage(CliTest):
    def test_has_an_exit_code_of_its_own(self):
        marker = str(MARKERS / "jeans_02g.json")
        for arguments in ([], ["fold"], ["compact"], ["compact", marker, "--accuracy", "perfect"],
                          ["compact", marker, "--rounds", "-1"], ["compact", marker, "--rounds", "many"],
                          ["compact", marker, "--simplification", "2"],
                          ["compact", marker, "--format", "docx"], ["show", marker], ["check", marker, "--fast"],
                          ["compact", marker, "-o", "-", "--svg", "-"], ["bump", marker, "--piece", "0"],
                          ["bump", marker, "--piece", "0", "--direction", "1"],
                          ["bump", marker, "--piece", "0", "--direction", "1,2,3"],
                          ["call", "motion.fly", "--marker", marker], ["call", "marker.open", "--marker", marker],
                          ["call", "motion.compact"], ["call", "marker.check", "--marker", "-", "--params", "-"]):
            with self.subTest(arguments):
                ran = run(*arguments)
                self.assertEqual(ran.returncode, BAD_USAGE)
                self.assertNotEqual(ran.stderr, "")

    def test_help_lists_the_exit_codes(self):
        ran = run("compact", "--help")
        self.assertEqual(ran.returncode, OK)
        self.assertIn("Exit codes", ran.stdout)


class BadInput(CliTest):
    def refused(self, document, code, *said):
        for command in (["check"], ["compact", "-o", self.path("out.json")]):
            ran = run(command[0], self.write(document), *command[1:])
            self.assertEqual(ran.returncode, code, ran.stderr)
            self.assertEqual(ran.stdout, "")
            for message in said:
                self.assertIn(message, ran.stderr)
            self.assertFalse(self.path("out.json").exists())

    def test_text_that_is_not_json(self):
        self.refused('{"format": NaN}', BAD_INPUT, "line 1, column", "input.syntax")
        self.refused("", BAD_INPUT, "input.syntax")
        self.refused("[" * 100000, BAD_INPUT, "input.depth")
        self.refused("[1e999]", BAD_INPUT, "input.out_of_range")

    def test_a_wrong_field(self):
        document = squares((0, 0))
        document["strip"]["width"] = "wide"
        self.refused(document, BAD_INPUT, '/strip/width: "wide" where a number is required')
        document["strip"]["width"] = 1e308
        self.refused(document, BAD_INPUT, "/strip/width: 1e+308 is out of range")

    def test_an_invalid_outline(self):
        document = squares((0, 0))
        document["shapes"][0]["outline"] = [[i % 1000, i % 7] for i in range(100_000)]
        self.refused(document, BAD_INPUT, "/shapes/0/outline", "100000 vertices", "2000", "shape.too_many_vertices")
        document["shapes"][0]["outline"] = [[0, 0], [9, 9], [9, 0], [0, 9]]
        self.refused(document, BAD_INPUT, "/shapes/0/outline", "shape.self_intersecting")

    def test_a_spacing_that_is_not_a_valid_number(self):
        for spacing in ("nan", "inf", "-1", "1e308"):
            ran = run("compact", MARKERS / "jeans_02g.json", "--spacing=" + spacing)
            self.assertIn(ran.returncode, (BAD_USAGE, BAD_INPUT), spacing)

    def test_missing_files(self):
        self.assertEqual(run("check", self.path("nowhere.json")).returncode, FILE)
        self.assertEqual(run("check", self.folder.name).returncode, FILE)
        ran = run("convert", MARKERS / "jeans_02g.json", "-o", self.path("no/such/folder.json"), "--format", "native")
        self.assertEqual(ran.returncode, FILE)
        self.assertIn("No such file or directory", ran.stderr)

    @unittest.skipUnless(os.path.exists("/dev/full"), "no /dev/full here")
    def test_a_full_disk(self):
        ran = run("convert", MARKERS / "jeans_02g.json", "-o", "/dev/full", "--format", "native")
        self.assertEqual(ran.returncode, FILE)


if __name__ == "__main__":
    unittest.main()
