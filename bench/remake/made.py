"""Makes the markers that the measurement of remaking needs, once, and stores them.

Stored markers: garments nested from nothing for a minute of processor time, like the orders that another nester gets, or the
jeans that sparrow laid out in 260 seconds; then accuracy `fine`.  With a limit on time the nester compares more starts than with
one on moves, and a marker that is made anew may differ.  For orders of other size mixes there are five of them, each of a mix of its own; and so are those of orders that differ by
their stored marker alone.
"""
import json
import os
import pathlib
import resource
import subprocess
import sys
import types

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLES = ROOT / "examples" / "markers"
sys.path.insert(0, str(ROOT / "bench" / "nesting"))
import race as nesters  # noqa: E402

# Of a stored marker, and of an order to compare with.  The many markers of other mixes whose pieces are then made larger have a
# tenth of that.
SECONDS, FEW_SECONDS = 60, 6
MOVES_ON = 60_000  # by which the best known marker is nested on
MIXES = range(1001, 1006)  # the seeds of the stored mixes; the seeds of orders are smaller
SPREAD_MIXES = range(2001, 2015)  # of each garment
# Garments of the table, and instances of the literature, on which remaking was never tuned.
RACES = (*((garment, seed) for seed in (1, 2, 3) for garment in ("jeans_06g", "simon_06g", "charlie_04g")),
         ("trousers", 1), ("shirts", 1), ("dagli", 1), ("albano", 1))


def run(*words):
    return subprocess.run([str(word) for word in words], check=True, capture_output=True, text=True).stdout


def source_of(options, garment):
    """The file with a garment's pieces: an example, or a file of the data."""
    for folder in (EXAMPLES, options.data / "garments", options.data / "strip" / "records"):
        if (folder / f"{garment}.json").exists():
            return folder / f"{garment}.json"
    raise FileNotFoundError(garment)


def nest(options, order, seconds, out):
    """Nests the order from nothing, by the clock of the processor, and returns what the command prints."""
    command = [options.programs / "selvage", "nest", order, "--from-scratch", "--time", seconds, "--threads", 1, "--seed", 1, "--json",
               "-o", out, "--format", "native"]
    environment = {**os.environ, "LD_PRELOAD": str(nesters.clock_of(options.kept))}
    return subprocess.run([str(word) for word in command], check=True, capture_output=True, text=True, env=environment).stdout


def nested(options, order, name, seconds=SECONDS):
    """The order nested from nothing and refined."""
    path = options.kept / "stored" / f"{name}.json"
    if not path.exists():
        path.parent.mkdir(parents=True, exist_ok=True)
        start = options.kept / "start.json"
        nest(options, order, seconds, start)
        run(options.programs / "selvage", "compact", start, "--accuracy", "fine", "--format", "native", "-o", path)
    return path


def stored_marker(options, garment):
    path = options.kept / "stored" / f"{garment}.json"
    if garment != "jeans_06g":
        return nested(options, source_of(options, garment), garment)
    if not path.exists():
        path.parent.mkdir(parents=True, exist_ok=True)
        run(options.programs / "selvage", "compact", options.data / "garments" / "jeans_06g_tight.json", "--accuracy", "fine",
            "--format", "native", "-o", path)
    return path


def raced_order(options, garment, seed):
    """An order of sizes 4 % apart, remade from the stored marker; None when it is neither kept nor asked for."""
    kept = options.kept / "raced" / f"{garment}-{seed}.json"
    if not kept.exists():
        if not options.race:
            return None
        kept.parent.mkdir(exist_ok=True)
        kept.write_text(run(options.programs / "remake_orders", "--change", "graded", "--part", 0.04, "--first", seed,
                            stored_marker(options, garment)), "utf-8")
    return json.loads(kept.read_text("utf-8"))


def order_file(options, garment, change, part, seed):
    """An order in the format of jagua-rs."""
    path = options.kept / "order_files" / f"{garment}-{change}-{part}-{seed}.json"
    if not path.exists():
        path.parent.mkdir(parents=True, exist_ok=True)
        source = source_of(options, garment) if change == "mixed" else stored_marker(options, garment)
        run(options.programs / "remake_orders", "--change", change, "--part", part, "--first", seed, "--write", path, source)
    return path


def order_source(options, garment, change):
    """The arguments of remake_orders: the garment, and the stored markers if they are not the garment's own."""
    if "-mix-" in garment:
        garment, seed = garment.split("-mix-")
        seconds = FEW_SECONDS if int(seed) in SPREAD_MIXES else SECONDS
        return [nested(options, order_file(options, garment, "mixed", 0, seed), f"{garment}-mix-{seed}", seconds)]
    if change != "mixed":
        return [stored_marker(options, garment)]
    stored = [nested(options, order_file(options, garment, change, 0, seed), f"{garment}-mix-{seed}") for seed in MIXES]
    return [source_of(options, garment), *stored]


def best_known(options):
    """The best known marker of the order whose steps are shown: remade, improved by nesting from there, and refined."""
    path = options.kept / "best_known.json"
    if not path.exists():
        selvage, order = options.programs / "selvage", order_file(options, "jeans_02g", "graded", 0.04, 1)
        library, start = options.kept / "library", options.kept / "start.json"
        run(selvage, "library", "add", library, stored_marker(options, "jeans_02g"))
        run(selvage, "remake", order, "--library", library, "--fine", "--format", "native", "-o", start)
        run(selvage, "nest", start, "--moves", MOVES_ON, "--format", "native", "-o", start)
        run(selvage, "compact", start, "--accuracy", "fine", "--format", "native", "-o", path)
    return path


def mix_from_nothing(options, seed):
    """The utilisation of an order of another size mix that is nested from nothing, and its processor time; None when it is
    neither kept nor asked for."""
    kept = options.kept / "mixes" / f"charlie_04g-{seed}.json"
    if not kept.exists():
        if seed > options.mixes:
            return None
        kept.parent.mkdir(exist_ok=True)
        order, out = order_file(options, "charlie_04g", "mixed", 0, seed), options.kept / "mix.json"
        begin = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        output = nest(options, order, SECONDS, out)
        seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - begin
        kept.write_text(json.dumps({"utilisation": json.loads(output)["utilisation_after"], "seconds": seconds}), "utf-8")
    return json.loads(kept.read_text("utf-8"))


def nested_elsewhere(options, garment, seed, seconds=60):
    """The density of the order nested by spyrrow, according to the judge; None if it is neither stored nor requested."""
    path = order_file(options, garment, "graded", 0.04, seed)
    kept = options.kept / "nesters"
    if not options.race and not (kept / "results" / f"{path.stem}-spyrrow-{seconds}s-1.json").exists():
        return None
    kept.mkdir(exist_ok=True)
    arguments = types.SimpleNamespace(selvage=options.programs / "selvage", kept=kept)
    return nesters.result(arguments, "spyrrow", path, seconds, 1)
