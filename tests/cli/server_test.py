#!/usr/bin/env python3
"""`selvage --server` gives the same results as `selvage` alone, and `selvage watch` follows a marker.

usage: server_test.py SELVAGE SELVAGED"""
import json
import pathlib
import re
import signal
import socket
import subprocess
import sys
import tempfile
import unittest

SELVAGED = str(pathlib.Path(sys.argv.pop(2)).resolve())
SELVAGE = str(pathlib.Path(sys.argv.pop(1)).resolve())
MARKERS = pathlib.Path(__file__).parents[2] / "examples" / "markers"
OK, BAD_USAGE, BAD_INPUT, FILE, SERVER = 0, 2, 3, 4, 6

SQUARE = {"id": "square", "outline": [[0, 0], [40, 0], [40, 40], [0, 40]]}


def squares(*places):
    pieces = [{"id": f"p{i}", "shape": "square", "at": list(at)} for i, at in enumerate(places)]
    return {"format": "selvage-marker", "version": 1, "name": "squares", "strip": {"width": 100},
            "shapes": [dict(SQUARE)], "pieces": pieces, "attributes": {"order": 7}}


def timeless(text):
    """The output of a command without the parts that vary from run to run."""
    text = re.sub(r"[0-9.]+ ms;", "TIME ms;", text)
    text = re.sub(r'"markerId":"m[0-9]+"', '"markerId":"m"', text)
    return re.sub(r'"(ms|cache)":\{[^}]*\}', r'"\1":{}', text)


class Daemon:
    def __init__(self, folder, *options):
        self.socket = str(pathlib.Path(folder) / "socket")
        self.process = subprocess.Popen([SELVAGED, "--listen", "127.0.0.1:0", "--listen-unix", self.socket, *options],
                                        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.said = ""
        while self.socket + "\n" not in self.said:
            line = self.process.stdout.readline()
            if not line:
                raise RuntimeError("selvaged did not start: " + self.said)
            self.said += line
        self.tcp = re.search(r"listening on (127\.0\.0\.1:\d+)", self.said).group(1)

    def stop(self):
        self.process.terminate()
        self.process.communicate(timeout=60)

    def call(self, method, **params):
        with socket.socket(socket.AF_UNIX) as connection:
            connection.connect(self.socket)
            asked = {"jsonrpc": "2.0", "id": 1, "method": method, "params": params}
            connection.sendall(json.dumps(asked).encode() + b"\n")
            return json.loads(connection.makefile().readline())["result"]


class ServerTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def start(self, *options):
        daemon = Daemon(self.folder, *options)
        self.addCleanup(daemon.stop)
        return daemon

    def write(self, document, name="in.json"):
        path = self.folder / name
        path.write_text(document if isinstance(document, str) else json.dumps(document))
        return str(path)


class SameHereAndOnADaemon(ServerTest):
    def run_in(self, name, arguments):
        """Runs the command in a folder of its own; returns the exit code, the output and the files written."""
        folder = self.folder / name
        folder.mkdir()
        ran = subprocess.run([SELVAGE, *map(str, arguments)], capture_output=True, text=True, timeout=300, cwd=folder)
        written = {path.name: path.read_text() for path in folder.iterdir()}
        for path in folder.iterdir():
            path.unlink()
        folder.rmdir()
        return ran.returncode, timeless(ran.stdout), timeless(ran.stderr), written

    def assert_same(self, daemon, *arguments):
        with self.subTest(arguments):
            here = self.run_in("here", arguments)
            there = self.run_in("there", [*arguments, "--server", daemon])
            self.assertEqual(here, there)
            return here

    def test_every_command_gives_the_same_result(self):
        daemon = self.start()
        jeans = MARKERS / "jeans_02g.json"
        loose = self.write(squares((0, 0), (50, 10), (60, 60)))
        deep = self.write(squares((0, 0), (20, 0)), "deep.json")
        three = self.write(squares((0, 0), (0, 30), (0, 60)), "three.json")
        params = self.write({"force": [0, 1], "timing": True}, "params.json")
        dry = self.write({"commit": False}, "dry.json")
        wrong = self.write({"piece": "p9", "direction": [1, 0]}, "wrong.json")
        edits = self.write({"ops": [
            {"op": "remove", "piece": "p0"}, {"op": "setStrip", "width": 90},
            {"op": "add", "piece": {"id": "new", "shape": "square", "at": [0, 41], "attributes": {"size": "L"}}},
            {"op": "move", "piece": "p1", "at": [10.5, 0]}]}, "edits.json")
        stranger = self.write({"ops": [{"op": "lock", "piece": "p9"}]}, "stranger.json")
        nothing = self.write({"ops": [{"op": "move", "piece": "p1", "by": [0, 0]}]}, "nothing.json")
        every_file = ["-o", "o.json", "--svg", "o.svg", "--arrows", "--chain", "--outlines", "p.json"]
        commands = [
            ["compact", jeans, *every_file],
            ["compact", jeans, "--json", "--accuracy", "draft", "-o", "o.json", "--format", "native"],
            ["compact", loose, "-o", "-", "--spacing", "2.5"],
            ["compact", deep, "-o", "o.json"],
            ["bump", loose, "--piece", "p1", "--direction", "-1,0", *every_file],
            ["bump", loose, "--piece", "p9", "--direction", "-1,0"],
            ["bump", loose, "--piece", "p1", "--direction", "0,0"],
            ["separate", three, "--pop-out", "--json", "-o", "o.json"],
            ["separate", three, "--json", "-o", "o.json"],
            ["separate", three, "--partial", "-o", "o.json"],
            ["float", loose, "--distance", "20", "--json", "-o", "o.json"],
            ["tilt", jeans, "--limit", "1", "--accuracy", "draft", "-o", "o.json"],
            ["check", jeans],
            ["check", deep],
            ["check", "--json", deep, "--spacing", "1"],
            ["check", self.write("{", "none.json")],
            ["check", self.folder / "nowhere.json"],
            ["show", jeans, "--svg", "-"],
            ["convert", jeans, "-o", "o.json", "--format", "native"],
            ["convert", loose, "-o", "o.json", "--format", "outlines"],
            ["convert", loose, "-o", "/no/such/folder/o.json", "--format", "sparrow"],
            ["call", "motion.gravity", "--marker", loose, "--params", params, "-o", "o.json"],
            ["call", "motion.compact", "--marker", loose, "--params", dry, "-o", "o.json"],
            ["call", "motion.bump", "--marker", loose, "--params", wrong],
            ["call", "marker.get", "--marker", loose],
            ["call", "marker.check", "--marker", deep],
            ["call", "motion.compact", "--marker", loose],
            ["call", "marker.apply", "--marker", loose, "--params", edits, *every_file],
            ["call", "marker.apply", "--marker", loose, "--params", stranger],
            ["call", "marker.apply", "--marker", loose, "--params", nothing, "-o", "o.json"],
        ]
        codes = {self.assert_same(daemon.tcp, *command)[0] for command in commands}
        self.assertEqual(codes, {0, 1, 3, 4, 5})
        self.assertEqual(daemon.call("marker.list")["markers"], [])

    def test_the_option_may_come_first_and_be_a_socket(self):
        daemon = self.start()
        ran = subprocess.run([SELVAGE, "--server", daemon.socket, "check", MARKERS / "jeans_02g.json"],
                             capture_output=True, text=True, timeout=60)
        self.assertEqual(ran.returncode, OK, ran.stderr)
        self.assertIn("valid", ran.stdout)

    def test_an_unreachable_daemon_has_an_exit_code_of_its_own(self):
        marker = str(MARKERS / "jeans_02g.json")
        for server, code in ((str(self.folder / "nobody"), SERVER), ("nonsense", BAD_USAGE), ("http://127.0.0.1:1", BAD_USAGE)):
            ran = subprocess.run([SELVAGE, "compact", marker, "--server", server, "-o", self.folder / "o.json"],
                                 capture_output=True, text=True, timeout=60)
            self.assertEqual((ran.returncode, ran.stdout), (code, ""))
            self.assertFalse((self.folder / "o.json").exists())

    def test_sends_the_token(self):
        token = self.write("a token of some length\n", "token")
        other = self.write("another token of length\n", "other")
        daemon = self.start("--token-file", token)
        command = [SELVAGE, "check", MARKERS / "jeans_02g.json", "--server", daemon.tcp]
        for more, code in (([], SERVER), (["--token-file", other], SERVER), (["--token-file", token], OK),
                           (["--token-file", self.folder / "none"], FILE)):
            ran = subprocess.run([*command, *more], capture_output=True, text=True, timeout=60)
            self.assertEqual(ran.returncode, code, ran.stderr)


    def test_uses_tls_with_a_trusted_daemon(self):
        certificate, key = self.folder / "certificate.pem", self.folder / "key.pem"
        subprocess.run(["openssl", "req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:prime256v1", "-nodes",
                        "-subj", "/CN=marker.example", "-addext", "subjectAltName=IP:127.0.0.1", "-out", certificate,
                        "-keyout", key], check=True, capture_output=True)
        daemon = self.start("--tls-cert", certificate, "--tls-key", key)
        jeans = MARKERS / "jeans_02g.json"
        port = daemon.tcp.split(":")[1]
        for server, more, code in ((f"tls://127.0.0.1:{port}", ["--trust", certificate], OK),
                                   (f"tls://127.0.0.1:{port}", [], SERVER),
                                   (f"tls://127.0.0.1:{port}", ["--trust", self.folder / "none"], SERVER),
                                   (f"tls://localhost:{port}", ["--trust", certificate], SERVER)):
            with self.subTest(server=server, more=more):
                ran = subprocess.run([SELVAGE, "compact", jeans, "--server", server, *more, "-o", self.folder / "o.json"],
                                     capture_output=True, text=True, timeout=60)
                self.assertEqual(ran.returncode, code, ran.stderr)
                self.assertEqual("TLS" in ran.stderr, code != OK, ran.stderr)


class Watch(ServerTest):
    def watch(self, daemon, marker, *more):
        watching = subprocess.Popen([SELVAGE, "watch", "--server", daemon.tcp, marker, *more], text=True,
                                    stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.addCleanup(watching.communicate)
        self.addCleanup(watching.kill)
        return watching

    def test_prints_a_line_per_change_until_the_marker_is_closed(self):
        daemon = self.start()
        marker = daemon.call("marker.open", marker=squares((0, 0), (50, 10)))["markerId"]
        watching = self.watch(daemon, marker)
        self.assertEqual(watching.stdout.readline(), "revision 1: length 90, utilisation 35.56 %, valid\n")
        daemon.call("motion.compact", markerId=marker)
        self.assertEqual(watching.stdout.readline(),
                         "revision 2: length 80, utilisation 40.00 %, valid; motion.compact\n")
        daemon.call("marker.apply", markerId=marker, ops=[{"op": "move", "piece": "p1", "at": [20, 0]}])
        self.assertEqual(watching.stdout.readline(),
                         "revision 3: length 60, utilisation 53.33 %, NOT valid; marker.apply\n")
        daemon.call("marker.close", markerId=marker)
        self.assertEqual(watching.stdout.read(), "")
        self.assertEqual(watching.wait(timeout=60), OK)

    def test_prints_json_and_stops_on_an_interrupt(self):
        daemon = self.start()
        marker = daemon.call("marker.open", marker=squares((0, 0), (50, 10)))["markerId"]
        watching = self.watch(daemon, marker, "--json")
        self.assertEqual(json.loads(watching.stdout.readline())["revision"], 1)
        daemon.call("motion.compact", markerId=marker)
        line = json.loads(watching.stdout.readline())
        self.assertEqual((line["revision"], line["by"], line["length"]), (2, "motion.compact", 80))
        watching.send_signal(signal.SIGINT)
        self.assertEqual(watching.wait(timeout=60), OK)

    def test_continues_after_a_restart_and_reports_missed_changes(self):
        store = str(self.folder / "store")
        daemon = self.start("--store", store)
        marker = daemon.call("marker.open", marker=squares((0, 0), (50, 10)))["markerId"]
        watching = subprocess.Popen([SELVAGE, "watch", "--server", daemon.socket, marker], text=True,
                                    stdout=subprocess.PIPE)
        self.addCleanup(watching.communicate)
        self.addCleanup(watching.kill)
        self.assertIn("revision 1", watching.stdout.readline())
        daemon.stop()
        again = self.start("--store", store)
        again.call("motion.compact", markerId=marker)
        self.assertTrue(watching.stdout.readline().startswith("revision 2: length 80"))

    def test_needs_a_server_and_a_marker_that_is_open_there(self):
        ran = subprocess.run([SELVAGE, "watch", "m1"], capture_output=True, text=True, timeout=60)
        self.assertEqual(ran.returncode, BAD_USAGE)
        watching = self.watch(self.start(), "m1")
        self.assertEqual(watching.wait(timeout=60), BAD_INPUT)
        self.assertIn("'m1'", watching.stderr.read())


if __name__ == "__main__":
    unittest.main()
