#!/usr/bin/env python3
"""GET /metrics as Prometheus reads it: python3 metrics_test.py SELVAGED.

The text must be read by Prometheus' own library, and its names must follow the conventions of
https://prometheus.io/docs/practices/naming.
"""
import json
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import urllib.request

from prometheus_client.parser import text_string_to_metric_families

NOT_BASE_UNITS = ("_milliseconds", "_ms", "_minutes", "_kilobytes", "_kib", "_mb", "_percent")
REQUIRED = {
    "process_cpu_seconds": "counter",
    "process_resident_memory_bytes": "gauge",
    "process_virtual_memory_bytes": "gauge",
    "process_start_time_seconds": "gauge",
    "process_open_fds": "gauge",
    "process_max_fds": "gauge",
    "selvage_build_info": "gauge",
    "selvage_calls": "counter",
    "selvage_call_duration_seconds": "histogram",
    "selvage_open_connections": "gauge",
    "selvage_connections": "counter",
    "selvage_refused": "counter",
    "selvage_log_lines_dropped": "counter",
    "selvage_store_writes": "counter",
    "selvage_store_write_seconds": "counter",
    "selvage_store_writable": "gauge",
}


def text_after_calls(selvaged):
    """The metrics of a daemon that has answered three calls, and the time of the request."""
    with tempfile.TemporaryDirectory() as folder:
        ports = pathlib.Path(folder) / "ports"
        store = pathlib.Path(folder) / "store"
        daemon = subprocess.Popen([selvaged, "--listen", "127.0.0.1:0", "--port-file", ports, "--store", store, "--log-level", "off"])
        try:
            while not ports.exists():
                assert daemon.poll() is None, "selvaged has ended"
                time.sleep(0.01)
            url = f"http://127.0.0.1:{ports.read_text().split()[0]}"
            for method in ("engine.info", "engine.info", "no.such.method"):
                call = json.dumps({"jsonrpc": "2.0", "id": 1, "method": method, "params": {}}).encode()
                urllib.request.urlopen(url + "/rpc", data=call).read()
            return urllib.request.urlopen(url + "/metrics").read().decode()
        finally:
            daemon.send_signal(signal.SIGTERM)
            daemon.wait()


def faults(text):
    families = {}
    for family in text_string_to_metric_families(text):
        if family.name in families:
            yield f"{family.name} is there twice"
        families[family.name] = family
    # The library drops `_total` from the names of counters; the text itself must have it.
    for line in text.splitlines():
        if line.startswith("# TYPE "):
            _, _, name, kind = line.split()
            if (kind == "counter") != name.endswith("_total"):
                yield f"{name} is a {kind}"
    for name, family in families.items():
        if not family.documentation:
            yield f"{name} has no HELP"
        if family.type == "unknown":
            yield f"{name} has no TYPE"
        if name.endswith(NOT_BASE_UNITS):
            yield f"{name} is not in a base unit"
        if not name.startswith(("selvage_", "process_")):
            yield f"{name} has no prefix"
    for name, kind in REQUIRED.items():
        if name not in families:
            yield f"{name} is missing"
        elif families[name].type != kind:
            yield f"{name} is a {families[name].type}, not a {kind}"
    yield from faulty_values(families)


def faulty_values(families):
    values = {(s.name, tuple(sorted(s.labels.items()))): s.value for f in families.values() for s in f.samples}
    if values.get(("selvage_calls_total", (("code", "0"), ("method", "engine.info")))) != 2:
        yield "engine.info was called twice"
    if values.get(("selvage_call_duration_seconds_count", (("method", "unknown"),))) != 1:
        yield "an unknown method was called once"
    if not 0 <= time.time() - values[("process_start_time_seconds", ())] < 3600:
        yield "the process was started within the hour"
    if not 1 << 20 < values[("process_resident_memory_bytes", ())] < 1 << 32:
        yield "the process has some memory"
    if any(s.value != 1 or not s.labels["version"] for s in families["selvage_build_info"].samples):
        yield "selvage_build_info has a version and is 1"
    infinite = [s for s in families["selvage_call_duration_seconds"].samples if s.labels.get("le") == "+Inf"]
    if len(infinite) != 2:
        yield "every histogram ends with a bucket without bound"


def main():
    text = text_after_calls(sys.argv[1])
    found = list(faults(text))
    for fault in found:
        print(fault)
    if found:
        print(text)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
