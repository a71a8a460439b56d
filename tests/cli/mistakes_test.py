#!/usr/bin/env python3
"""Invalid input and how it is refused.  usage: mistakes_test.py SELVAGE"""
import os
import unittest

from command import BAD_INPUT, BAD_USAGE, CliTest, FILE, MARKERS, OK, run, squares


class BadUsage(CliTest):
    def test_bad_usage_has_its_own_exit_code(self):
        marker = str(MARKERS / "jeans_02g.json")
        for arguments in ([], ["fold"], ["compact"], ["compact", marker, "--accuracy", "perfect"],
                          ["compact", marker, "--rounds", "-1"], ["compact", marker, "--rounds", "many"],
                          ["compact", marker, "--simplification", "2"],
                          ["compact", marker, "--format", "docx"], ["show", marker, "a.svg", "--svg", "b.svg"], ["check", marker, "--fast"],
                          ["compact", marker, "-o", "-", "--svg", "-"], ["bump", marker, "--piece", "0"],
                          ["bump", marker, "--piece", "0", "--direction", "1"],
                          ["bump", marker, "--piece", "0", "--direction", "1,2,3"],
                          ["call", "motion.fly", "--marker", marker], ["call", "marker.open", "--marker", marker],
                          ["call", "motion.compact"], ["call", "marker.check", "--marker", "-", "--params", "-"]):
            with self.subTest(arguments):
                ran = run(*arguments)
                self.assertEqual(ran.returncode, BAD_USAGE)
                self.assertNotEqual(ran.stderr, "")

    def test_a_number_out_of_range_is_refused_with_the_range(self):
        for option, value, message in (("--rounds", "-1", "--rounds: -1 is out of range; 0 to 100000 is allowed"),
                                       ("--rounds", "many", "--rounds: many is not a number; 0 to 100000 is allowed"),
                                       ("--simplification", "nan", "--simplification: nan is out of range; 0 to 1 is allowed")):
            with self.subTest(value):
                ran = run("compact", MARKERS / "jeans_02g.json", option, value)
                self.assertEqual(ran.returncode, BAD_USAGE)
                self.assertIn(message, ran.stderr)

    def test_json_that_cannot_be_read_is_refused_with_its_option(self):
        ran = run("push", MARKERS / "jeans_02g.json", "--forces", "{")
        self.assertEqual(ran.returncode, BAD_INPUT)
        self.assertIn("/forces: not JSON", ran.stderr)

    def test_help_lists_the_exit_codes(self):
        ran = run("compact", "--help")
        self.assertEqual(ran.returncode, OK)
        self.assertIn("Exit codes", ran.stdout)

    def test_help_says_what_giving_a_flag_does(self):
        text = " ".join(run("remake", "--help").stdout.split())
        self.assertIn("--fine The result is refined", text)
        self.assertIn("search for a shorter marker in each --keep-trims", text)
        self.assertIn("--edges Gaps to", " ".join(run("float", "--help").stdout.split()))


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

    def test_two_inputs_cannot_be_standard_input(self):
        for arguments, said in ((["convert", "-", self.path("o.json"), "--order", "-"], "IN and --order"),
                                (["plan", "-", "--style", "-"], "ORDER and --style"),
                                (["plan", self.path("o.csv"), "--style", "-", "--rules", "-"], "--style and --rules")):
            ran = run(*arguments, text="")
            self.assertEqual(ran.returncode, BAD_USAGE)
            self.assertIn(f"only one of {said} can be standard input", ran.stderr)

    def test_empty_files(self):
        empty = self.write("", "empty.json")
        self.assertIn(f"{empty}: the file is empty [input.syntax]", run("compact", empty).stderr)
        self.assertIn(f"{empty}: the text is empty, so it is not JSON [input.syntax]",
                      run("call", "motion.compact", empty, "--marker", MARKERS / "jeans_02g.json").stderr)
        style = MARKERS.parent / "trade" / "polypattern_like.dxf"
        self.assertIn("/rules: the rule table is empty [input.unknown_format]",
                      run("convert", style, self.path("o.json"), "--rules", empty).stderr)
        self.assertIn(f"{empty}: the order is empty [input.missing_field]",
                      run("plan", empty, "--style", MARKERS / "jeans_02g.json").stderr)

    def test_a_place_beyond_the_lattice_is_told_what_its_limit_is(self):
        ran = run("place", self.write(squares((0, 0))), "--piece", "p0", "--to", "1e9,0")
        self.assertEqual(ran.returncode, BAD_INPUT)
        self.assertIn("in either direction is allowed, as far as the marker's lattice reaches", ran.stderr)
        ran = run("float", self.write(squares((0, 0))), "--distance", "1e9")
        self.assertIn("1000000000 is beyond the marker's lattice; up to 109951.1627775 is allowed", ran.stderr)

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
