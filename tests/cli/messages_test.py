#!/usr/bin/env python3
"""Tests of messages about files: each names the field as its own format does, the value as it was written, and what is
allowed.  usage: messages_test.py SELVAGE"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

SELVAGE = sys.argv.pop(1)
OK, BAD_INPUT = 0, 3


def native():
    return {"format": "selvage-marker", "version": 1, "strip": {"width": 100},
            "shapes": [{"id": "s", "outline": [[0, 0], [40, 0], [40, 40], [0, 40]]}],
            "pieces": [{"id": "p", "shape": "s", "at": [0, 0]}]}


def sparrow():
    return {"name": "one", "strip_height": 100,
            "items": [{"id": 7, "demand": 1, "allowed_orientations": [0],
                       "shape": {"type": "simple_polygon", "data": [[0, 0], [40, 0], [40, 40], [0, 40]]}}],
            "solution": {"strip_width": 90, "layout": {"placed_items": [
                {"item_id": 7, "transformation": {"rotation": 0, "translation": [0, 0]}}]}}}


class MessagesTest(unittest.TestCase):
    def check(self, text, *options):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "in.json"
            path.write_text(text if isinstance(text, str) else json.dumps(text))
            return subprocess.run([SELVAGE, "check", path, *options], capture_output=True, text=True, timeout=60)

    def message(self, document):
        ran = self.check(document)
        self.assertEqual(ran.returncode, BAD_INPUT, ran.stderr)
        return ran.stderr

    def test_a_group_is_among_the_fields_of_a_piece(self):
        document = native()
        document["pieces"][0]["grupe"] = "a"
        self.assertRegex(self.message(document), r"\bgroup\b")

    def test_version_1_0_is_version_1(self):
        self.assertEqual(self.check(json.dumps(native()).replace('"version": 1', '"version": 1.0')).returncode, OK)
        self.assertIn("/version", self.message(json.dumps(native()).replace('"version": 1', '"version": 1.5')))

    def test_a_small_rotation_is_printed_in_full(self):
        document = native()
        document["shapes"][0]["rotations"] = [0]
        document["pieces"][0]["rotation"] = 1e-9
        message = self.message(document)
        self.assertRegex(message, r"rotation (1e-09|0\.000000001)\b")
        self.assertNotIn("0.000000,", message)

    def test_errors_in_a_file_in_sparrows_format_name_its_fields(self):
        for change, field in [
                (lambda d: d.update(strip_height=-1), "/strip_height"),
                (lambda d: d["items"][0].update(allowed_orientations=[0, "x"]), "/items/0/allowed_orientations/1"),
                (lambda d: d["items"][0]["shape"].update(data=[[0, 0], [9, 9], [9, 0], [0, 9]]), "/items/0/shape/data"),
                (lambda d: d["solution"]["layout"]["placed_items"][0]["transformation"].update(rotation=45),
                 "/solution/layout/placed_items/0/transformation/rotation")]:
            document = sparrow()
            change(document)
            with self.subTest(field):
                message = self.message(document)
                self.assertIn(field, message)
                self.assertNotIn("/shapes/", message)
                self.assertNotIn("/pieces/", message)

    def test_a_spacing_has_one_range(self):
        ranges = set()
        for spacing in (-1, 101, 1e300):
            message = self.message(native() | {"spacing": spacing})
            self.assertIn("/spacing", message)
            ranges.add(message[message.index("0 to"):].split()[2])
        self.assertEqual(ranges, {"100"})

    def test_a_self_intersection_names_vertices_as_they_were_written(self):
        document = native()
        document["shapes"][0]["outline"] = [[0, 0], [9.5, 9.5], [9.5, 0], [0, 9.5]]
        message = self.message(document)
        self.assertIn("counted from 0", message)
        self.assertNotRegex(message, r"\d{5}")  # lattice units

    def test_an_empty_server_is_refused(self):
        ran = self.check(native(), "--server", "")
        self.assertNotEqual(ran.returncode, OK)
        self.assertIn("server", ran.stderr)


if __name__ == "__main__":
    unittest.main()
