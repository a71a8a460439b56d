#!/usr/bin/env python3
"""Libraries of markers, and orders remade from them.  usage: library_test.py SELVAGE"""
import json
import os
import re
import unittest

from command import BAD_INPUT, BAD_USAGE, CliTest, FILE, MARKERS, OK, run, squares


def scaled(document, factor):
    """The same order with every shape larger, and not laid out."""
    order = json.loads(json.dumps(document))
    for item in order["items"]:
        item["shape"]["data"] = [[round(factor * x, 2), round(factor * y, 2)] for x, y in item["shape"]["data"]]
    del order["solution"]
    return order


class Library(CliTest):
    def library(self, *names):
        ran = run("library", "add", self.path("lib"), *[MARKERS / f"{name}.json" for name in names])
        self.assertEqual(ran.returncode, OK, ran.stderr)
        return self.path("lib")

    def test_adds_and_lists_markers(self):
        library = self.library("jeans_02g", "charlie_04g")
        listed = run("library", "list", library)
        self.assertEqual(listed.returncode, OK, listed.stderr)
        lines = listed.stdout.splitlines()
        self.assertEqual([line.split()[-1] for line in lines], ["charlie_04g", "jeans_02g"])
        self.assertIn("40 pieces", lines[1])
        self.assertIn("81.11 %", lines[1])

    def test_adding_the_same_marker_again_changes_nothing(self):
        self.library("jeans_02g")
        before = (self.path("lib") / "jeans_02g.json").stat().st_mtime_ns
        self.library("jeans_02g")
        self.assertEqual((self.path("lib") / "jeans_02g.json").stat().st_mtime_ns, before)

    def test_refuses_another_marker_of_the_same_name(self):
        self.library("jeans_02g")
        other = self.write(squares((0, 0)), "jeans_02g.json")
        ran = run("library", "add", self.path("lib"), other)
        self.assertEqual(ran.returncode, FILE)
        self.assertIn("another name", ran.stderr)

    def test_refuses_markers_that_are_not_made(self):
        ran = run("library", "add", self.path("lib"), self.write(squares((0, 0), (10, 0))))
        self.assertEqual(ran.returncode, BAD_INPUT)
        self.assertIn("not valid", ran.stderr)
        document = squares((0, 0))
        document["unplaced"] = [{"id": "new", "shape": "square"}]
        ran = run("library", "add", self.path("lib"), self.write(document))
        self.assertEqual(ran.returncode, BAD_INPUT)
        self.assertIn("nest it first", ran.stderr)

    def test_ignores_files_that_are_not_markers(self):
        library = self.library("jeans_02g")
        (library / "notes.txt").write_text("not a marker")
        listed = run("library", "list", library)
        self.assertEqual(listed.returncode, OK)
        self.assertEqual(len(listed.stdout.splitlines()), 1)
        self.assertIn("notes.txt is skipped", listed.stderr)
        self.assertIn("notes.txt is skipped", run("library", "list", library).stderr)

    def test_reads_only_files_that_have_changed(self):
        library = self.library("jeans_02g")
        marker = library / "jeans_02g.json"
        long_ago = 1_600_000_000_000_000_000
        os.utime(marker, ns=(long_ago, long_ago))
        listed = run("library", "list", library).stdout
        text = marker.read_text()
        marker.write_text("x" * len(text))  # not noticed, because size and time agree with the index
        os.utime(marker, ns=(long_ago, long_ago))
        self.assertEqual(run("library", "list", library).stdout, listed)
        os.utime(marker)
        self.assertEqual(run("library", "list", library).stdout, "")
        marker.write_text(text)
        self.assertEqual(run("library", "list", library).stdout, listed)

    def test_does_not_trust_a_file_that_is_as_new_as_its_index(self):
        library = self.library("jeans_02g")
        marker, index = library / "jeans_02g.json", library / ".selvage-index"
        run("library", "list", library)
        text = marker.read_text()
        marker.write_text("x" * len(text))
        changed = marker.stat().st_mtime_ns
        index.write_text(re.sub(r'"changed":"\d+"', f'"changed":"{changed}"', index.read_text()))
        os.utime(index, ns=(changed, changed))
        self.assertIn("skipped", run("library", "list", library).stderr)

    def test_rebuilds_the_index_when_it_is_missing_or_damaged(self):
        library = self.library("jeans_02g", "charlie_04g")
        listed = run("library", "list", library).stdout
        index = library / ".selvage-index"
        kept = index.read_text()
        for spoiled in ("", "no index", kept.splitlines()[0] + "\n{}\n[]\nnull\nx\n", kept[:-200], kept.replace("spread", "spr")):
            index.write_text(spoiled)
            self.assertEqual(run("library", "list", library).stdout, listed)
        index.unlink()
        self.assertEqual(run("library", "list", library).stdout, listed)
        (library / "charlie_04g.json").unlink()
        self.assertEqual(run("library", "list", library).stdout, listed.splitlines()[1] + "\n")
        self.assertEqual(len(index.read_text().splitlines()), 2)

    def test_works_without_an_index_if_it_cannot_write_one(self):
        library = self.library("jeans_02g")
        (library / ".selvage-index").unlink(missing_ok=True)
        (library / ".selvage-index").mkdir()
        listed = run("library", "list", library)
        self.assertEqual(listed.returncode, OK, listed.stderr)
        self.assertIn("40 pieces", listed.stdout)
        self.assertEqual([path.name for path in library.iterdir() if path.name.startswith(".selvage-index.")], [])

    def test_searches_for_an_order(self):
        library = self.library("jeans_02g", "jeans_06g")
        found = run("library", "search", library, MARKERS / "jeans_02g.json")
        self.assertEqual(found.returncode, OK, found.stderr)
        self.assertIn("differs by   0.0 %, predicted  81.11 %  jeans_02g", found.stdout)

    def test_names_missing_arguments(self):
        self.assertEqual(run("library", "add", self.path("lib")).returncode, BAD_USAGE)
        self.assertEqual(run("library", "search", self.path("lib")).returncode, BAD_USAGE)
        self.assertEqual(run("library", "bake", self.path("lib")).returncode, BAD_USAGE)
        self.assertEqual(run("library", "list", self.path("none")).returncode, FILE)


class Remake(Library):
    def order(self, factor=0.99):
        return self.write(scaled(json.loads((MARKERS / "jeans_02g.json").read_text()), factor), "order.json")

    def test_lays_an_order_out_like_a_stored_marker(self):
        library = self.library("jeans_02g", "jeans_06g")
        ran = run("remake", self.order(), "--library", library, "-o", self.path("out.json"), "--json")
        self.assertEqual(ran.returncode, OK, ran.stderr)
        line = json.loads(ran.stdout)
        self.assertEqual((line["outcome"], line["chosen"], line["valid"]), ("remade", 0, True))
        self.assertGreater(line["utilisation_after"], 0.80)
        self.assertEqual(line["attempts"][0]["steps"][0]["step"], "substituted")
        self.assertTrue(line["attempts"][0]["steps"][-1]["valid"])
        checked = run("check", self.path("out.json"))
        self.assertEqual(checked.returncode, OK, checked.stdout)
        self.assertIn("40 pieces", checked.stdout)

    def test_names_decide_between_equal_shapes(self):
        square = [[0, 0], [10, 0], [10, 10], [0, 10]]

        def named(*names):
            return {"format": "selvage-marker", "version": 1, "name": "names", "strip": {"width": 10}, "pieces": [],
                    "shapes": [{"id": str(k), "outline": square, "attributes": {"name": name}} for k, name in enumerate(names)]}

        stored = named("front", "back")
        stored["pieces"] = [{"id": "a", "shape": "0", "at": [0, 0]}, {"id": "b", "shape": "1", "at": [10, 0]}]
        order = named("back", "front")
        order["unplaced"] = [{"id": "back", "shape": "0"}, {"id": "front", "shape": "1"}]
        self.assertEqual(run("library", "add", self.path("lib"), self.write(stored, "stored.json")).returncode, OK)
        for options, leftmost in (((), "front"), (("--shapes-only",), "back")):
            ran = run("remake", self.write(order, "order.json"), "--library", self.path("lib"), *options,
                      "-o", self.path("out.json"))
            self.assertEqual(ran.returncode, OK, ran.stderr)
            made = json.loads(self.path("out.json").read_text())
            self.assertEqual([piece["id"] for piece in made["pieces"] if piece["at"] == [0, 0]], [leftmost])

    def test_reports_the_steps_of_every_attempt(self):
        library = self.library("jeans_02g")
        ran = run("remake", self.order(), "--library", library, "--tries", 1)
        self.assertEqual(ran.returncode, OK, ran.stderr)
        self.assertRegex(ran.stdout, r"attempt 1 +pieces differ by \d+\.\d %, substituted [\d.]+ %, .*compacted .*; chosen")

    def test_the_number_of_threads_does_not_affect_the_result(self):
        library = self.library("jeans_02g")
        results = []
        for threads in (1, 3):
            ran = run("remake", self.order(), "--library", library, "--threads", threads, "-o", self.path("out.json"))
            self.assertEqual(ran.returncode, OK, ran.stderr)
            results.append(self.path("out.json").read_text())
        self.assertEqual(results[0], results[1])

    def test_reports_when_no_marker_is_similar(self):
        library = self.library("jeans_22g")
        ran = run("remake", self.order(), "--library", library, "-o", self.path("out.json"), "--json")
        self.assertEqual(json.loads(ran.stdout)["outcome"], "none_near")
        nested = run("remake", self.order(), "--library", library, "--nest", "--nest-moves", 100,
                     "-o", self.path("out.json"), "--json")
        self.assertEqual(nested.returncode, OK, nested.stderr)
        self.assertEqual(json.loads(nested.stdout)["outcome"], "nested")
        self.assertEqual(run("check", self.path("out.json")).returncode, OK)

    def test_needs_a_library_with_markers(self):
        self.assertEqual(run("remake", self.order(), "--library", self.path("none")).returncode, FILE)
        self.path("empty").mkdir()
        ran = run("remake", self.order(), "--library", self.path("empty"))
        self.assertEqual(ran.returncode, FILE)
        self.assertIn("no markers", ran.stderr)


if __name__ == "__main__":
    unittest.main()
