#!/usr/bin/env python3
"""Each method of the Python client, and its behaviour when something fails.  usage: python_methods_test.py SELVAGED"""
import asyncio
import dataclasses
import json
import pathlib
import re
import ssl
import subprocess
import sys
import threading
import unittest

from live_daemon import SQUARES, LiveDaemon, LossyProxy

import selvage_client
from selvage_client import errors, ops
from selvage_client.messages import conversion
from selvage_client.wire.link import may_repeat

SELVAGED = sys.argv.pop(1) if len(sys.argv) > 1 else "selvaged"
ROOT = pathlib.Path(__file__).resolve().parents[2]
GOLDEN = ROOT / "tests" / "golden" / "rpc"

# Methods that have a different name in Python.
OTHERWISE = {"motion.float": "float_apart", "marker.unwatch": "watch", "plan.cut": "plan_cut"}
OF_CLIENT = {"engine.info": "info", "marker.open": "open", "marker.list": "list", "rpc.discover": "call"}
OF_LIBRARY = ("add", "get", "list", "remove", "search")
OF_DRAG = {"drag.begin": "begin", "drag.move": "move", "drag.end": "end"}


def python_name(method):
    return OTHERWISE.get(method) or conversion.snake(method.split(".")[1])


def differences(expected, actual, where=""):
    """The paths at which a typed result differs from the expected JSON.  Fields that are not expected must be None or empty."""
    if expected == "$any":
        return []
    if dataclasses.is_dataclass(actual):
        fields = {conversion.camel(field.name): getattr(actual, field.name) for field in dataclasses.fields(actual)}
        missing = [f"{where}/{name}" for name in expected if name not in fields]
        extra = [f"{where}/{name}" for name, value in fields.items() if value and name not in expected]
        return missing + extra + [
            fault for name in expected if name in fields for fault in differences(expected[name], fields[name], f"{where}/{name}")
        ]
    if isinstance(expected, list):
        if len(expected) != len(actual):
            return [where]
        return [f for i, pair in enumerate(zip(expected, actual)) for f in differences(*pair, f"{where}/{i}")]
    return [] if expected == actual else [where]


class Typed(unittest.TestCase):
    def test_every_method_of_the_daemon_has_a_python_method(self):
        with LiveDaemon(SELVAGED) as daemon, selvage_client.Client(daemon.address) as client:
            for method in client.info().methods:
                if method in OF_CLIENT:
                    kinds, name = (selvage_client.Client, selvage_client.AsyncClient), OF_CLIENT[method]
                elif method in OF_DRAG:
                    kinds, name = (selvage_client.Drag, selvage_client.AsyncDrag), OF_DRAG[method]
                elif method.startswith("library."):
                    self.assertIn(method.partition(".")[2], OF_LIBRARY)
                    kinds, name = (selvage_client.Library, selvage_client.AsyncLibrary), method.partition(".")[2]
                elif method.startswith(("$", "admin.")):
                    continue
                else:
                    kinds, name = (selvage_client.Marker, selvage_client.AsyncMarker), python_name(method)
                for kind in kinds:
                    self.assertTrue(callable(getattr(kind, name, None)), f"{kind.__name__}.{name} for {method}")

    def test_golden_exchanges_through_the_typed_methods(self):
        played = 0
        for name in ("motions", "places_and_tilts", "changes", "life_of_a_marker", "nesting", "remaking"):
            with LiveDaemon(SELVAGED) as daemon, selvage_client.Client(daemon.address) as client:
                for exchange in json.loads((GOLDEN / f"{name}.json").read_text("utf-8")):
                    played += self.play(client, exchange["request"], exchange["response"])
        self.assertGreater(played, 40)

    def play(self, client, request, response):
        """1 if the call can be expressed with the parameters of the Python method."""
        method, params = request["method"], dict(request.get("params", {}))
        if OF_CLIENT.get(method) == "call":
            return 0  # it has no method of its own
        if method in OF_CLIENT:
            call = getattr(client, OF_CLIENT[method])
        elif method.startswith("library."):
            call = getattr(client.library, method.partition(".")[2])
        else:
            call = getattr(client.marker(params.pop("markerId")), python_name(method))
        options = {conversion.snake(name): value for name, value in params.items()}
        if "forces" in options:
            options["forces"] = {force["piece"]: force["force"] for force in options["forces"]}
        if "values" in options:
            options["values"] = {value["piece"]: value["value"] for value in options["values"]}
        try:
            answer = call(**options)
        except TypeError:  # a required parameter is missing, which Python reports itself
            self.assertEqual(response["error"]["data"]["name"], "input.missing_field")
            return 0
        except selvage_client.CallError as refused:
            error = response.get("error")
            self.assertIsNotNone(error, f"{request}: {refused}")
            self.assertIs(type(refused), errors.CallError.by_code[error["code"]])
            self.assertEqual(refused.data, error.get("data", {}))
            if error["message"] != "$any":
                self.assertEqual(str(refused), error["message"])
            return 1
        expected = response["result"]
        if method == "marker.open":
            answer = answer.opened
        elif method == "marker.list":
            expected = expected["markers"]
        elif method == "library.search":
            expected = expected["near"]
        elif method == "library.remove":
            return 1
        self.assertEqual(differences(expected, answer), [], request)
        return 1

    def test_every_error_code_has_an_exception_class(self):
        text = (ROOT / "protocol" / "README.md").read_text("utf-8")
        codes = {int(code) for code in re.findall(r"^\| (-32\d{3}) \|", text, re.MULTILINE)}
        self.assertGreater(len(codes), 10)
        self.assertEqual(codes, {code for code in errors.CallError.by_code if code})


class Losses(unittest.TestCase):
    def test_a_change_whose_answer_was_lost_is_sent_again_and_applied_once(self):
        with LiveDaemon(SELVAGED) as daemon:
            proxy = LossyProxy(daemon, ["marker.open", "marker.apply"])
            self.addCleanup(proxy.close)
            with selvage_client.Client(proxy.address) as client:
                marker = client.open(SQUARES)
                edited = marker.apply([ops.move("right", by=(7, 0))])
                self.assertEqual((marker.id, edited.revision, edited.length), ("m1", 2, 97))
                self.assertEqual([each.revision for each in client.list()], [2])
        for method in ("marker.open", "marker.apply"):
            sent = [call["params"]["opId"] for call in proxy.calls if call["method"] == method]
            self.assertEqual(len(sent), 2, method)
            self.assertEqual(sent[0], sent[1], method)

    def test_calls_tied_to_a_connection_are_not_sent_again(self):
        with LiveDaemon(SELVAGED) as daemon:
            proxy = LossyProxy(daemon, ["drag.move"])
            self.addCleanup(proxy.close)
            with selvage_client.Client(proxy.address) as client:
                marker = client.open(SQUARES)
                with self.assertRaises(selvage_client.ConnectionLost), marker.drag("right") as drag:
                    drag.move((60, 10))
                self.assertEqual(marker.check().revision, 1)
        self.assertFalse(may_repeat("drag.move", {}))
        self.assertFalse(may_repeat("motion.compact", {}))
        self.assertTrue(may_repeat("motion.compact", {"commit": False}))

    def test_a_watcher_receives_missed_changes_after_a_restart(self):
        with LiveDaemon(SELVAGED) as daemon, selvage_client.Client(daemon.address) as client:
            marker = client.open(SQUARES)
            with marker.watch() as changes:
                daemon.kill()
                daemon.start()
                with selvage_client.Client(daemon.address) as other:
                    other.marker(marker.id).compact()
                heard = next(changes)
                self.assertEqual((heard.marker_id, heard.revision), (marker.id, 2))
                marker.close()
                self.assertEqual(list(changes), [])

    def test_reports_a_missing_daemon_within_the_time_limit(self):
        with selvage_client.Client("unix:/nowhere/socket", patience=0.1) as client, self.assertRaises(selvage_client.ConnectionLost):
            client.info()

    def test_closing_ends_pending_waits(self):
        with LiveDaemon(SELVAGED) as daemon:
            client, raised = selvage_client.Client(daemon.address), []
            watch = client.open(SQUARES).watch()
            watch.__enter__()

            def wait():
                try:
                    next(watch)
                except selvage_client.ConnectionLost as lost:
                    raised.append(lost)

            waiting = threading.Thread(target=wait, daemon=True)
            waiting.start()
            client.close()
            client.close()
            waiting.join(30)
            self.assertEqual(len(raised), 1)
            with self.assertRaises(selvage_client.ConnectionLost):
                client.info()


class Ends(unittest.TestCase):
    def test_an_exception_in_a_progress_handler_cancels_the_call(self):
        with LiveDaemon(SELVAGED) as daemon, selvage_client.Client(daemon.address) as client:
            marker = client.open(ROOT / "examples" / "markers" / "jeans_06g.json")

            def stop(round):
                self.assertIs(threading.current_thread(), threading.main_thread())
                raise ZeroDivisionError(round.round)

            with self.assertRaises(ZeroDivisionError):
                marker.compact(accuracy="fine", progress=stop)
            self.assertTrue(marker.bump(marker.outlines().pieces[0].id, (-1, 0), commit=False).valid)

    def test_a_cancelled_task_changes_nothing(self):
        async def play(address):
            async with selvage_client.AsyncClient(address) as client:
                marker = await client.open(ROOT / "examples" / "markers" / "jeans_22g.json")
                begun = asyncio.Event()
                motion = asyncio.create_task(marker.compact(accuracy="fine", progress=lambda _: begun.set()))
                await begun.wait()
                motion.cancel()
                with self.assertRaises(asyncio.CancelledError):
                    await motion
                return (await marker.apply([ops.lock(marker_piece(await marker.get()))])).revision

        def marker_piece(got):
            return got.marker["pieces"][0]["id"]

        with LiveDaemon(SELVAGED) as daemon:
            self.assertEqual(asyncio.run(play(daemon.address)), 2)

    def test_a_marker_has_the_revision_that_the_drag_committed(self):
        with LiveDaemon(SELVAGED) as daemon, selvage_client.Client(daemon.address) as client:
            marker = client.open(SQUARES)
            with marker.drag("right") as drag:
                drag.move((60, 10))
            self.assertEqual((marker.revision, drag.ended.revision), (2, 2))
            self.assertEqual(marker.apply([ops.move("right", by=(7, 0))], base_rev=marker.revision).revision, 3)

    def test_a_dragged_piece_stays_when_the_drag_fails(self):
        with LiveDaemon(SELVAGED) as daemon, selvage_client.Client(daemon.address) as client:
            marker = client.open(SQUARES)
            with self.assertRaises(KeyError), marker.drag("right") as drag:
                drag.move((60, 10))
                raise KeyError
            self.assertEqual((marker.revision, marker.check().revision), (1, 1))


class Outlines(unittest.TestCase):
    def test_converts_to_arrays_and_polygons(self):
        try:
            import numpy
            import shapely.geometry  # noqa: F401
        except ImportError as missing:
            self.skipTest(str(missing))
        with LiveDaemon(SELVAGED) as daemon, selvage_client.Client(daemon.address) as client:
            outlines = client.open(SQUARES).outlines()
        self.assertEqual((outlines.strip_height, outlines.strip_length), (100, 90))
        self.assertEqual(outlines.arrays()["right"].max(axis=0).tolist(), [90, 50])
        self.assertEqual(numpy.asarray(outlines.pieces[0]).shape, (4, 2))
        areas = {name: polygon.area for name, polygon in outlines.polygons().items()}
        self.assertEqual(areas, {"left": 1600, "right": 1600})


class Access(unittest.TestCase):
    def test_sends_its_token(self):
        token = LiveDaemon(SELVAGED)
        (token.folder / "token").write_text("0123456789abcdef\n")
        token._options = ("--token-file", token.folder / "token")
        with token as daemon:
            address = f"127.0.0.1:{daemon.port}"
            with selvage_client.Client(address, token="0123456789abcdef") as client:
                self.assertEqual(client.info().name, "selvage")
            for wrong in ("0123456789abcdeg", None):
                with selvage_client.Client(address, token=wrong, patience=0.1) as client:
                    with self.assertRaises((errors.Unauthorised, selvage_client.ConnectionLost)):
                        client.info()

    def test_tls_needs_a_trusted_certificate(self):
        encrypted = LiveDaemon(SELVAGED)
        certificate, key = encrypted.folder / "certificate.pem", encrypted.folder / "key.pem"
        subprocess.run(["openssl", "req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:prime256v1", "-nodes",
                        "-subj", "/CN=localhost", "-addext", "subjectAltName=IP:127.0.0.1", "-out", certificate,
                        "-keyout", key], check=True, capture_output=True)
        encrypted._options = ("--tls-cert", certificate, "--tls-key", key)
        with encrypted as daemon:
            address = f"tls://127.0.0.1:{daemon.port}"
            with selvage_client.Client(address, tls=ssl.create_default_context(cafile=certificate)) as client:
                self.assertEqual(client.open(SQUARES).compact().length_after, 80)
            self.assert_not_tried_again(address)

    def test_reports_a_daemon_without_tls(self):
        with LiveDaemon(SELVAGED) as daemon:
            self.assert_not_tried_again(f"tls://127.0.0.1:{daemon.port}")

    def assert_not_tried_again(self, address):
        with selvage_client.Client(address, patience=1e9) as client, self.assertRaises(selvage_client.HandshakeFailed):
            client.info()

    def test_a_busy_daemon_is_retried_until_the_time_limit(self):
        with LiveDaemon(SELVAGED, "--max-connections", "1") as daemon, selvage_client.Client(daemon.address) as client:
            client.info()
            with selvage_client.Client(daemon.address, patience=0.1) as other, self.assertRaises(selvage_client.ConnectionLost):
                other.info()
            client.close()
            with selvage_client.Client(daemon.address) as next_one:
                self.assertEqual(next_one.info().name, "selvage")

    def test_reports_a_call_that_is_too_long(self):
        async def play(address):
            async with selvage_client.AsyncClient(address) as client:
                others = [asyncio.create_task(client.list()) for _ in range(3)]
                with self.assertRaises(errors.TooLarge):
                    await client.open(SQUARES | {"name": "x" * (1 << 20)})
                self.assertEqual(await asyncio.gather(*others), [(), (), ()])
        with LiveDaemon(SELVAGED, "--max-body-mb", "1") as daemon:
            asyncio.run(play(daemon.address))

    def test_rejects_invalid_addresses(self):
        for text in ("localhost", "http://localhost:1", "localhost:99999", ":80", "localhost:x"):
            with self.assertRaises(ValueError, msg=text):
                selvage_client.Client(text)


if __name__ == "__main__":
    unittest.main()
