#!/usr/bin/env python3
"""The engine in the process, as the wheel selvage-engine installs it.  usage: python_engine_test.py SELVAGED

The interpreter has both distributions; the daemon is there to compare with.
"""
import json
import pathlib
import sys
import threading
import time
import unittest

from live_daemon import LiveDaemon

import selvage_client
import selvage_engine
from selvage_client import spyrrow

SELVAGED = sys.argv.pop(1)
ROOT = pathlib.Path(__file__).resolve().parents[2]
JEANS = ROOT / "examples" / "markers" / "jeans_02g.json"
BARS = ROOT / "examples" / "packing" / "bars.json"


class InProcess(unittest.TestCase):
    def test_every_motion_is_a_function(self):
        for name in selvage_engine.motions.__all__:
            self.assertTrue(callable(getattr(selvage_engine, name)), name)
            self.assertTrue(callable(getattr(selvage_client.Marker, name)), name)

    def test_one_call_compacts_a_file(self):
        after = selvage_engine.compact(JEANS)
        self.assertTrue(after.result.valid)
        self.assertLess(after.result.length_after, after.result.length_before)
        self.assertEqual(after.document["format"], "selvage-marker")
        self.assertTrue(after._repr_svg_().startswith("<svg"))
        with selvage_client.Client("engine:") as client, client.open(after.document) as marker:
            self.assertTrue(marker.check().valid)

    def test_a_daemon_answers_the_same_bytes(self):
        """Compares the text of the engine's answer with the line that the daemon sends."""
        requests = [("marker.open", {"marker": json.loads(JEANS.read_text("utf-8"))}),
                    ("motion.compact", {"markerId": "m1"}), ("motion.float", {"markerId": "m1"}),
                    ("marker.get", {"markerId": "m1"}), ("marker.undo", {"markerId": "m1"}),
                    ("marker.hold", {"markerId": "m1"}), ("motion.bump", {"markerId": "m1", "piece": "none", "direction": [1, 0]})]
        engine = selvage_engine.Engine(2)
        with LiveDaemon(SELVAGED) as daemon, daemon.raw() as wire:
            for number, (method, params) in enumerate(requests):
                line = json.dumps({"jsonrpc": "2.0", "id": number, "method": method, "params": params})
                wire.write(line.encode() + b"\n")
                wire.flush()
                self.assertEqual(engine.answer(line, selvage_engine.Stop()).encode() + b"\n", wire.readline(), method)

    def test_other_threads_run_meanwhile(self):
        counted, over = [0], threading.Event()

        def count():
            while not over.is_set():
                counted[0] += 1
                time.sleep(0.001)

        thread = threading.Thread(target=count)
        thread.start()
        selvage_engine.nest(JEANS, from_scratch=True, seconds=1)
        over.set()
        thread.join()
        self.assertGreater(counted[0], 50)

    def test_progress_is_reported_and_an_exception_in_it_cancels(self):
        steps = []
        selvage_engine.compact(JEANS, progress=steps.append)
        self.assertEqual([step.round for step in steps], list(range(1, len(steps) + 1)))
        self.assertGreater(len(steps), 0)
        self.assertTrue(all(step.bound is None and step.nodes is None for step in steps))
        searched = []
        selvage_engine.pack(BARS, progress=searched.append)
        self.assertTrue(all(step.bound <= step.length and step.nodes > 0 for step in searched))
        self.assertGreater(len(searched), 0)

        class Enough(Exception):
            pass

        def stop(_):
            raise Enough

        with selvage_client.Client("engine:") as client, client.open(JEANS) as marker:
            with self.assertRaises(Enough):
                marker.nest(from_scratch=True, seconds=60, progress=stop)
            begin = time.monotonic()
            self.assertEqual(marker.check().revision, 1)  # nothing was committed
            self.assertLess(time.monotonic() - begin, 20)

    def test_a_time_limit_ends_a_search_with_its_best(self):
        after = selvage_engine.nest(JEANS, from_scratch=True, deadline_ms=1500)
        self.assertIn(after.result.stop, ("deadline", "converged", "work_limit"))
        self.assertTrue(after.result.valid)

    def test_undo_and_errors_are_those_of_a_daemon(self):
        with selvage_client.Client("engine:") as client, client.open(JEANS) as marker:
            marker.compact()
            self.assertEqual(marker.revision, 2)
            marker.undo()
            self.assertEqual(marker.revision, 3)
            with self.assertRaises(selvage_client.errors.InvalidParams) as refused:
                marker.bump("no such piece", (1, 0))
            self.assertEqual(refused.exception.field, "/piece")
            with self.assertRaises(selvage_client.errors.MethodNotFound), marker.watch():
                pass
        self.assertEqual(repr(client), "<Client of engine:>")

    def test_nesting_and_spyrrow_need_no_daemon(self):
        square = [(0, 0), (20, 0), (20, 20), (0, 20)]
        found = selvage_client.nest([selvage_client.Pattern(outline=square, quantity=6)], 60, moves=200, address="engine:")
        self.assertEqual((found.length, found.utilisation), (40, 1))
        instance = spyrrow.StripPackingInstance("squares", 60, [spyrrow.Item("square", square, 4, [0])])
        loose = spyrrow.StripPackingSolution(
            100, 0.3, [spyrrow.PlacedItem("square", (30 * (k % 2), 30.0 * (k // 2)), 0) for k in range(4)])
        shorter = spyrrow.solution(selvage_engine.compact(spyrrow.marker(instance, loose)).document)
        self.assertEqual(shorter.width, 40)
        self.assertAlmostEqual(shorter.density, 1600 / 2400)


if __name__ == "__main__":
    unittest.main()
