#!/usr/bin/env python3
"""The Python client with a live daemon.  usage: python_test.py SELVAGED"""
import asyncio
import json
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest

import selvage_client
from selvage_client import drawing, ops

SELVAGED = sys.argv.pop(1)
ROOT = pathlib.Path(__file__).parents[2]
GOLDEN = ROOT / "tests" / "golden" / "rpc"
SQUARES = json.loads((GOLDEN / "motions.json").read_text())[0]["request"]["params"]["marker"]


def alike(expected, actual):
    if expected == "$any":
        return True
    if not isinstance(expected, dict):
        return expected == actual
    return expected.keys() == actual.keys() and all(alike(expected[key], actual[key]) for key in expected)


class LiveTest(unittest.TestCase):
    durable = True

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.socket = pathlib.Path(folder.name) / "s"
        self.address = f"unix:{self.socket}"
        self.store = pathlib.Path(folder.name) / "store"
        self.start()
        self.addCleanup(lambda: self.stop())

    def start(self):
        store = ["--store", self.store] if self.durable else []
        self.daemon = subprocess.Popen([SELVAGED, "--listen", "127.0.0.1:0", "--listen-unix", self.socket, *store,
                                        "--log-level", "off"])
        end = time.monotonic() + 30
        while not self.socket.exists() and time.monotonic() < end:
            time.sleep(0.01)

    def stop(self):
        self.daemon.kill()
        self.daemon.wait()

    def client(self):
        client = selvage_client.Client(self.address)
        self.addCleanup(client.close)
        return client


class Golden(LiveTest):
    def test_golden_exchanges_give_the_recorded_answers(self):
        for path in sorted(GOLDEN.glob("*.json")):
            self.stop()
            for file in self.store.parent.glob("store*"):  # the database and its log
                file.unlink()
            self.socket.unlink(missing_ok=True)
            self.start()
            client = self.client()
            for exchange in json.loads(path.read_text()):
                request, response = exchange["request"], exchange["response"]
                if not isinstance(request, dict) or not isinstance(request.get("params", {}), dict) \
                        or not isinstance(request.get("method"), str) or request.get("jsonrpc") != "2.0" \
                        or not isinstance(request.get("id"), int | str):
                    continue  # a client cannot send this
                try:
                    result = client.call(request["method"], request.get("params"))
                    self.assertTrue(alike(response.get("result"), result), (path.name, request, result))
                except selvage_client.CallError as error:
                    self.assertEqual(response.get("error", {}).get("code"), error.code, (path.name, request, error))


class Sync(LiveTest):
    def test_motions_edits_and_drags(self):
        with self.client().open(SQUARES) as marker:
            rounds = []
            moved = marker.compact(progress=rounds.append)
            self.assertEqual((moved.length_before, moved.length_after, moved.revision), (90, 80, 2))
            self.assertTrue(rounds)
            self.assertEqual(marker.undo().length, 90)
            self.assertEqual(marker.apply([ops.move("right", by=(10, 0))]).length, 100)
            with marker.drag("right") as drag:
                self.assertEqual(drag.move((45, 0)).at, (45, 0))
            self.assertEqual(marker.check().revision, 5)
            self.assertTrue(marker.check().valid)

    def test_continues_after_a_restart_of_the_daemon(self):
        marker = self.client().open(SQUARES)
        self.stop()
        self.start()
        self.assertEqual(marker.compact().length_after, 80)

    def test_each_error_has_its_own_class(self):
        with self.assertRaises(selvage_client.CallError) as caught:
            self.client().marker("m9").check()
        self.assertEqual(caught.exception.code, -32012)
        self.assertIsNot(type(caught.exception), selvage_client.CallError)

    def test_tcp_and_dry_runs(self):
        ports = pathlib.Path(self.socket.parent / "ports")
        other = subprocess.Popen([SELVAGED, "--listen", "127.0.0.1:0", "--port-file", ports, "--log-level", "off"])
        self.addCleanup(other.wait)
        self.addCleanup(other.kill)
        end = time.monotonic() + 30
        while not (ports.exists() and ports.read_text().strip()) and time.monotonic() < end:
            time.sleep(0.01)
        with selvage_client.Client(f"127.0.0.1:{ports.read_text().split()[0]}") as client:
            marker = client.open(SQUARES)
            self.assertEqual(marker.bump("right", (-1, 0), commit=False).at, (40, 10))
            self.assertEqual(marker.check().revision, 1)

    def test_opens_patterns_from_paths_and_texts_with_all_options(self):
        client, trade = self.client(), ROOT / "examples" / "trade"
        path = trade / "polypattern_like.dxf"
        rules = (trade / "polypattern_like.rul").read_text()
        for source in (path, str(path), path.read_text()):
            with client.open(source) as marker:
                self.assertEqual(marker.opened.pieces, 5)
        with client.open(path, rules=rules, order='{"ratio": {"S": 1, "M": 1}}', width=1400, margin_below=10) as marker:
            document = marker.get().marker
            self.assertEqual(marker.opened.pieces, 10)
            self.assertEqual((document["strip"]["width"], document["strip"]["below"]), (1400, 10))
        for source in (json.dumps(SQUARES), json.dumps(SQUARES, indent=1)):
            with client.open(source, shade=500) as marker:
                self.assertEqual(marker.get().marker["shade"], 500)
        utf16 = self.store.parent / "utf16.dxf"
        utf16.write_text(path.read_text(), "utf-16")
        with client.open(utf16) as marker:
            self.assertEqual(marker.opened.pieces, 5)
        with self.assertRaisesRegex(selvage_client.CallError, "colour: the field is not known"):
            client.open(SQUARES, colour="red")
        with self.assertRaises(FileNotFoundError):
            client.open("nowhere.json")

    def test_outlines_and_a_drawing(self):
        outlines = self.client().open(SQUARES).outlines()
        self.assertEqual([piece.id for piece in outlines.pieces], ["left", "right"])
        try:
            import matplotlib
        except ImportError:
            self.skipTest("needs python3-matplotlib")
        matplotlib.use("agg")
        self.assertEqual(outlines.arrays()["right"].shape, (4, 2))
        self.assertEqual(len(drawing.draw(outlines, labels=True).patches), 3)

    def test_the_example_runs(self):
        ran = subprocess.run([sys.executable, ROOT / "examples/python/compact.py", self.address,
                              ROOT / "examples/markers/jeans_02g.json"], capture_output=True, text=True)
        self.assertEqual(ran.returncode, 0, ran.stderr)
        self.assertIn("valid: True", ran.stdout)


class Async(LiveTest):
    def test_a_watcher_receives_changes(self):
        async def play():
            async with selvage_client.AsyncClient(self.address) as client:
                marker = await client.open(SQUARES)
                async with marker.watch() as changes:
                    await marker.compact()
                    return await anext(changes)
        change = asyncio.run(play())
        self.assertEqual((change.by, change.revision, change.length), ("motion.compact", 2, 80))


class WithoutStore(LiveTest):
    durable = False

    def restart(self):
        self.stop()
        self.socket.unlink(missing_ok=True)
        self.start()

    def test_another_marker_with_the_same_id_is_not_taken_for_the_lost_one(self):
        client = self.client()
        lost = client.open(SQUARES)
        known = client.marker(lost.id)
        instance = client.info().instance
        self.restart()
        other = self.client().open(SQUARES)
        self.assertEqual(other.id, lost.id)
        for call in (lost.compact, lost.check, known.check, lost.undo, lost.watch().__enter__, lost.drag("left").__enter__,
                     lost.close):
            with self.assertRaises(selvage_client.errors.UnknownMarker):
                call()
        self.assertEqual(other.check().revision, 1)
        self.assertNotEqual(client.info().instance, instance)
        self.assertEqual(client.marker(other.id).check().revision, 1)
        self.assertEqual(client.open(SQUARES).compact().length_after, 80)

    def test_a_watcher_learns_that_its_marker_was_lost(self):
        async def play():
            async with selvage_client.AsyncClient(self.address) as client:
                marker = await client.open(SQUARES)
                async with marker.watch() as changes:
                    self.restart()
                    async with selvage_client.AsyncClient(self.address) as other:
                        await other.open(SQUARES)
                        await (await other.open(SQUARES)).compact()
                        await other.marker(marker.id).compact()
                        with self.assertRaises(selvage_client.errors.UnknownMarker):
                            await anext(changes)
        asyncio.run(play())


if __name__ == "__main__":
    unittest.main()
