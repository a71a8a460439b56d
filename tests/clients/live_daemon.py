"""Runs selvaged for a test, optionally behind a proxy that drops connections at chosen calls."""
import contextlib
import json
import pathlib
import socket
import subprocess
import tempfile
import threading

SQUARES = {
    "format": "selvage-marker", "version": 1, "name": "two squares", "strip": {"width": 100},
    "shapes": [{"id": "square", "outline": [[0, 0], [40, 0], [40, 40], [0, 40]]}],
    "pieces": [{"id": "left", "shape": "square", "at": [0, 0]}, {"id": "right", "shape": "square", "at": [50, 10]}],
}


class LiveDaemon:
    """A daemon that runs as long as its `with` block; `address` is its Unix socket, `port` its TCP port."""

    def __init__(self, program, *options):
        self._program, self._options = program, options
        self._folder = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self._folder.name)
        self.path = str(self.folder / "socket")
        self.address = "unix:" + self.path

    def start(self):
        ports = self.folder / "ports"
        ports.unlink(missing_ok=True)
        words = [self._program, "--listen", "127.0.0.1:0", "--listen-unix", self.path, "--port-file", ports,
                 "--store", self.folder / "store", "--log-level", "off", *self._options]
        self._process = subprocess.Popen(words, stdout=subprocess.PIPE, text=True)
        while "socket" not in (line := self._process.stdout.readline()):
            if not line:
                raise RuntimeError("selvaged ended before it listened")
        self.port = int(ports.read_text().split()[0])

    @contextlib.contextmanager
    def raw(self):
        """A line connection as a file of bytes."""
        with socket.socket(socket.AF_UNIX) as end:
            end.connect(self.path)
            with end.makefile("rwb") as file:
                yield file

    def kill(self):
        self._process.kill()
        self._process.wait()
        self._process.stdout.close()

    def __enter__(self):
        self.start()
        return self

    def __exit__(self, *_):
        self.kill()
        self._folder.cleanup()


class LossyProxy:
    """Forwards lines to a daemon and back, but drops the connection instead of the first answer to each method in `losing`.

    By then the daemon has carried out the call, so a client must not repeat it unprotected.  `calls` are all calls received.
    """

    def __init__(self, daemon, losing):
        self._daemon, self._losing, self.calls = daemon, set(losing), []
        self.path = str(daemon.folder / "proxy")
        self.address = "unix:" + self.path
        self._listener = socket.socket(socket.AF_UNIX)
        self._listener.bind(self.path)
        self._listener.listen()
        threading.Thread(target=self._serve, daemon=True).start()

    def _serve(self):
        while True:
            try:
                client, _ = self._listener.accept()
            except OSError:
                return
            self._forward(client)

    def _forward(self, client):
        with client, socket.socket(socket.AF_UNIX) as inner:
            inner.connect(self._daemon.path)
            with client.makefile("rb") as calls, inner.makefile("rb") as answers:
                for line in calls:
                    call = json.loads(line)
                    self.calls.append(call)
                    inner.sendall(line)
                    if "id" not in call:
                        continue
                    answer = answers.readline()
                    if call["method"] in self._losing:
                        self._losing.remove(call["method"])
                        return
                    client.sendall(answer)

    def close(self):
        self._listener.shutdown(socket.SHUT_RDWR)
        self._listener.close()
