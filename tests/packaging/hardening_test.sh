#!/usr/bin/env bash
# usage: hardening_test.sh SOURCE_DIRECTORY BUILD_DIRECTORY PROGRAM... Checks that the programs are compiled and linked
# with options that make bugs harder to exploit.
set -euo pipefail
export LC_ALL=C
source=$1
build=$2
shift 2
fail() {
  echo "failed: $*" >&2
  exit 1
}

for program; do
  segments=$(readelf --wide --segments "$program")
  dynamic=$(readelf --wide --dynamic "$program")
  symbols=$(readelf --wide --dyn-syms "$program")
  grep -q '^Elf file type is DYN' <<< "$segments" || fail "$program is not position-independent (PIE)"
  ! grep -q 'TEXTREL' <<< "$dynamic" || fail "$program has code that is changed when it is loaded"
  grep -q 'GNU_RELRO' <<< "$segments" || fail "$program has no read-only relocations (RELRO)"
  grep -Eq '\(FLAGS\).*BIND_NOW|\(FLAGS_1\).*NOW' <<< "$dynamic" || fail "$program binds its symbols late (BIND_NOW)"
  ! grep -q 'GNU_STACK.*RWE' <<< "$segments" || fail "$program has an executable stack"
  grep -Eq ' __[a-z]+_chk(@|$)' <<< "$symbols" || fail "$program calls no function that checks sizes (_FORTIFY_SOURCE)"
done

# Every source of what is installed, not only one that happens to call a function that checks.
python3 - "$source" "$build" <<'EOF' || fail "compiled without _FORTIFY_SOURCE"
import json
import pathlib
import sys

source, build = sys.argv[1:]
parts = ("core", "protocol", "server", "clients")
folders = tuple(f"{root}/{part}/" for root in (source, build) for part in parts)


def compiled(file):
    """How many sources a command compiles: a file that CMake wrote into the build directory includes several."""
    if not file.startswith(build):
        return 1
    return pathlib.Path(file).read_text().count("#include")


commands = json.loads((pathlib.Path(build) / "compile_commands.json").read_text())
installed = [command for command in commands if command["file"].startswith(folders)]
sources = sum(compiled(command["file"]) for command in installed)
bare = [c["file"] for c in installed if "-D_FORTIFY_SOURCE=2" not in c["command"] or " -O" not in c["command"]]
print(f"{sources} sources; compiled without _FORTIFY_SOURCE: {len(bare)}", *bare[:10], sep="\n")
sys.exit(1 if bare or sources < 300 else 0)
EOF
